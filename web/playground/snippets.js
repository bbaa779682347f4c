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

import platformer1 from "../../docs/steps/platformer1.lua";
import platformer2 from "../../docs/steps/platformer2.lua";
import platformer3 from "../../docs/steps/platformer3.lua";
import platformer4 from "../../docs/steps/platformer4.lua";
import platformer5 from "../../docs/steps/platformer5.lua";
import platformer6 from "../../docs/steps/platformer6.lua";
import platformer7 from "../../docs/steps/platformer7.lua";
import topdown1 from "../../docs/steps/topdown1.lua";
import topdown2 from "../../docs/steps/topdown2.lua";
import topdown3 from "../../docs/steps/topdown3.lua";
import topdown4 from "../../docs/steps/topdown4.lua";
import topdown5 from "../../docs/steps/topdown5.lua";
import topdown6 from "../../docs/steps/topdown6.lua";
import topdown7 from "../../docs/steps/topdown7.lua";

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

const PLATFORMER = [platformer1, platformer2, platformer3, platformer4, platformer5, platformer6, platformer7];
const TOPDOWN = [topdown1, topdown2, topdown3, topdown4, topdown5, topdown6, topdown7];

const listSteps = (kind, codes) => codes.map((code, i) => {
  return { name: `${kind}${i + 1}`, code, title: `${kind} ${code.match(/^-- Step ([^\n]+)/)[1]}` };
});

// The programs of the pages Platformers and Top-down games.
export const steps = [...listSteps("platformer", PLATFORMER), ...listSteps("topdown", TOPDOWN)];
