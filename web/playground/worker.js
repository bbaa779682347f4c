// Runs the program beside the page: the editor never waits for it, and a program without an end
// can be ended. Messages come from playground.js, each is a call of one function of `orders`.

import { Breakdown, ProgramError, newFactory } from "./machine.js";
import { Painter } from "./paint.js";

const STEP = 1 / 60; // s
const SAME = 0.0015; // s: a frame that differs from a step by less is one step
const MOST = 3; // steps in a frame; a slower machine plays slower
const FIRST = 60; // steps that are watched for loops without an end
const PERIOD = 200; // ms between two reports

let painter, newMachine;
let machine = null; // null: nothing runs
let isPaused = false;
let steps = 0;
let left = 0; // s, not yet played
let before = null; // ms, when the last frame was
let spent = 0; // ms, the mean of what a frame costs
let reported = 0;

const tell = (kind, values = {}) => postMessage({ kind, ...values });

function tellPrinted() {
  const text = machine.ask("printed");
  if (text) tell("print", { lines: text.split("\n") });
}

function end() {
  machine?.close();
  machine = null;
}

// After a breakdown the page makes another worker.
function fail(problem) {
  if (!(problem instanceof ProgramError)) {
    machine = null;
    throw problem;
  }
  const isBroken = problem instanceof Breakdown;
  if (isBroken) {
    machine = null;
  } else {
    tellPrinted();
    end();
  }
  tell("error", { message: problem.message, line: problem.line, isBroken });
}

// Runs a part of the program; an error ends it.
function guard(run) {
  if (!machine) return;
  try {
    run();
    if (machine.ask("isOver")) {
      tellPrinted();
      end();
      tell("over", { steps });
    }
  } catch (problem) {
    fail(problem);
  }
}

function report() {
  reported = performance.now();
  tellPrinted();
  const objects = Number(machine.ask("objects"));
  const hash = isPaused ? machine.ask("hash") : null;
  tell("status", { steps, objects, hash, spent });
}

const draw = () => painter.paint(machine.call("draw"));

function step() {
  machine.call("step");
  steps += 1;
  if (steps === FIRST) machine.watch(false);
}

function countSteps(seconds) {
  if (Math.abs(seconds - STEP) < SAME) {
    left = 0;
    return 1;
  }
  left += seconds;
  const count = Math.floor(left / STEP);
  left = count > MOST ? 0 : left - count * STEP;
  return Math.min(count, MOST);
}

function frame(time) {
  requestAnimationFrame(frame);
  const seconds = before === null ? STEP : (time - before) / 1000;
  before = time;
  if (!machine || isPaused) return;
  guard(() => {
    const start = performance.now();
    for (let i = countSteps(seconds); i > 0; i--) step();
    draw();
    spent += (performance.now() - start - spent) / 20;
    if (performance.now() - reported > PERIOD) report();
  });
}

async function start(code) {
  end();
  machine = await newMachine((text, size) => painter.measure(text, size));
  steps = 0;
  left = 0;
  spent = 0;
  machine.watch(true);
  guard(() => {
    machine.call("start", code);
    draw();
    tell("started");
    report();
  });
}

const orders = {
  async open({ canvas, width, wasm, library }) {
    painter = new Painter(canvas);
    painter.resize(width);
    const answer = await fetch(library);
    newMachine = await newFactory(wasm, await answer.text());
    requestAnimationFrame(frame);
    tell("ready");
  },
  resize({ width }) {
    painter.resize(width);
    guard(draw);
  },
  async run(order) {
    ({ isPaused } = order);
    await start(order.code);
  },
  pause(order) {
    ({ isPaused } = order);
    guard(() => report());
  },
  step() {
    guard(() => {
      step();
      draw();
      report();
    });
  },
  key: ({ name, isDown }) => guard(() => machine.call("key", name, isDown)),
  move: ({ x, y }) => guard(() => machine.call("moveMouse", x, y)),
  button: ({ number, isDown }) => guard(() => machine.call("button", number, isDown)),
  // Plays steps with keys that are written down (stage.lua), as fast as it can.
  async play({ steps: count, keys }) {
    guard(() => machine.call("follow", keys));
    for (let i = 0; i < count && machine; i++) {
      guard(() => {
        step();
        draw();
      });
      if (i % 10 === 0) await new Promise((done) => setTimeout(done)); // for a ping
    }
    guard(() => {
      report();
      tell("played", { hash: machine.ask("hash") });
    });
  },
  ping: () => tell("pong"),
};

// What is wrong with the playground itself, and with no program: the page hears of it (onerror).
function fault(problem) {
  setTimeout(() => {
    throw problem;
  });
}

// One after the other: `run` waits for a new machine.
let last = Promise.resolve();
onmessage = ({ data }) => {
  if (data.order === "ping") orders.ping();
  else last = last.then(() => orders[data.order](data)).catch(fault);
};
