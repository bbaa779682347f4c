// The name that LÖVE has for the key of an event, or null.

const NAMES = {
  ArrowLeft: "left",
  ArrowRight: "right",
  ArrowUp: "up",
  ArrowDown: "down",
  " ": "space",
  Enter: "return",
  Escape: "escape",
  Backspace: "backspace",
  Delete: "delete",
  Tab: "tab",
  Home: "home",
  End: "end",
  PageUp: "pageup",
  PageDown: "pagedown",
};
const CODES = {
  ShiftLeft: "lshift",
  ShiftRight: "rshift",
  ControlLeft: "lctrl",
  ControlRight: "rctrl",
  AltLeft: "lalt",
  AltRight: "ralt",
};

export function nameOf({ key, code }) {
  if (CODES[code]) return CODES[code];
  if (NAMES[key]) return NAMES[key];
  if (/^F\d+$/.test(key)) return key.toLowerCase();
  return key.length === 1 ? key.toLowerCase() : null;
}
