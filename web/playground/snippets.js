// The programs to start from, in the order of the list. Their files are plain Lua, so that
// native.lua can run them; the first line of each is "-- Title: what it shows".

import breakout from "./snippets/breakout.lua";
import crowd from "./snippets/crowd.lua";
import explain from "./snippets/explain.lua";
import fallingBox from "./snippets/falling_box.lua";
import lift from "./snippets/lift.lua";
import oneWay from "./snippets/one_way.lua";
import platformer from "./snippets/platformer.lua";
import rollback from "./snippets/rollback.lua";
import slopes from "./snippets/slopes.lua";
import tiledMap from "./snippets/tiled_map.lua";

const CODES = {
  falling_box: fallingBox,
  platformer,
  lift,
  one_way: oneWay,
  crowd,
  breakout,
  tiled_map: tiledMap,
  rollback,
  slopes,
  explain,
};

export const snippets = Object.entries(CODES).map(([name, code]) => {
  return { name, code, title: code.match(/^-- ([^:]+):/)[1] };
});
