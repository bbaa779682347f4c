// Draws the paint commands of stage.lua on a canvas. The numbers are the same as there.

const [CLEAR, COLOR, FILL, OUTLINE, ROUND, ELLIPSE, POLYGON, LINE, TEXT] = [1, 2, 3, 4, 5, 6, 7, 8, 9];
const [PUSH, POP, ORIGIN, TRANSLATE, SCALE, ROTATE, LINE_WIDTH] = [10, 11, 12, 13, 14, 15, 16];

export const WIDTH = 800; // px of the program
export const HEIGHT = 600;
const FAMILY = "system-ui, sans-serif";
const LINE_HEIGHT = 1.2; // of the font's size

const decoder = new TextDecoder();

// Reads numbers and texts, one after the other.
class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = 0;
  }
  get isAtEnd() {
    return this.at >= this.bytes.length;
  }
  byte() {
    return this.bytes[this.at++];
  }
  float() {
    this.at += 4;
    return this.view.getFloat32(this.at - 4, true);
  }
  text() {
    const start = this.at + 4;
    this.at = start + this.view.getUint32(this.at, true);
    return decoder.decode(this.bytes.subarray(start, this.at));
  }
  points() {
    this.at += 4;
    const count = this.view.getUint32(this.at - 4, true);
    return Array.from({ length: count }, () => this.float());
  }
}

function css(red, green, blue, alpha) {
  const part = (share) => Math.round(Math.min(1, Math.max(0, share)) * 255);
  return `rgba(${part(red)}, ${part(green)}, ${part(blue)}, ${Math.min(1, Math.max(0, alpha))})`;
}

export class Painter {
  constructor(canvas) {
    this.canvas = canvas;
    this.sheet = canvas.getContext("2d", { alpha: false });
  }

  // The size of the canvas in px of the screen; the picture keeps its shape.
  resize(width) {
    this.canvas.width = Math.max(1, Math.round(width));
    this.canvas.height = Math.max(1, Math.round((width * HEIGHT) / WIDTH));
  }

  measure(text, size) {
    this.sheet.font = `${size}px ${FAMILY}`;
    return this.sheet.measureText(text).width;
  }

  paint(bytes) {
    const { sheet } = this;
    const scale = this.canvas.width / WIDTH;
    const stack = [];
    const origin = () => sheet.setTransform(scale, 0, 0, scale, 0, 0);
    const finish = (isFilled) => (isFilled ? sheet.fill() : sheet.stroke());
    const trace = (points) => {
      sheet.beginPath();
      for (let i = 0; i + 1 < points.length; i += 2) sheet.lineTo(points[i], points[i + 1]);
    };
    origin();
    sheet.textBaseline = "top";
    sheet.textAlign = "left";
    const read = new Reader(bytes);
    while (!read.isAtEnd) {
      const command = read.byte();
      if (command === FILL) {
        sheet.fillRect(read.float(), read.float(), read.float(), read.float());
      } else if (command === COLOR) {
        const color = css(read.float(), read.float(), read.float(), read.float());
        sheet.fillStyle = color;
        sheet.strokeStyle = color;
      } else if (command === OUTLINE) {
        sheet.strokeRect(read.float(), read.float(), read.float(), read.float());
      } else if (command === ROUND) {
        const isFilled = read.byte();
        sheet.beginPath();
        sheet.roundRect(read.float(), read.float(), read.float(), read.float(), Math.abs(read.float()));
        finish(isFilled);
      } else if (command === ELLIPSE) {
        const isFilled = read.byte();
        sheet.beginPath();
        const [x, y, radiusX, radiusY] = [read.float(), read.float(), read.float(), read.float()];
        sheet.ellipse(x, y, Math.abs(radiusX), Math.abs(radiusY), 0, 0, 2 * Math.PI);
        finish(isFilled);
      } else if (command === POLYGON) {
        const isFilled = read.byte();
        trace(read.points());
        sheet.closePath();
        finish(isFilled);
      } else if (command === LINE) {
        read.byte();
        trace(read.points());
        sheet.stroke();
      } else if (command === TEXT) {
        this.#write(read);
      } else if (command === PUSH) {
        stack.push(sheet.getTransform());
      } else if (command === POP) {
        sheet.setTransform(stack.pop());
      } else if (command === ORIGIN) {
        origin();
      } else if (command === TRANSLATE) {
        sheet.translate(read.float(), read.float());
      } else if (command === SCALE) {
        sheet.scale(read.float(), read.float());
      } else if (command === ROTATE) {
        sheet.rotate(read.float());
      } else if (command === LINE_WIDTH) {
        sheet.lineWidth = read.float();
      } else if (command === CLEAR) {
        sheet.fillStyle = css(read.float(), read.float(), read.float(), 1);
        sheet.fillRect(0, 0, WIDTH, HEIGHT);
      } else {
        throw new Error(`there is no paint command ${command}`);
      }
    }
  }

  #write(read) {
    const { sheet } = this;
    const align = read.byte();
    const [x, y, size, limit] = [read.float(), read.float(), read.float(), read.float()];
    sheet.font = `${size}px ${FAMILY}`;
    const lines = this.#break(read.text(), limit);
    for (const [i, line] of lines.entries()) {
      const room = limit > 0 ? limit - sheet.measureText(line).width : 0;
      sheet.fillText(line, x + (room * align) / 2, y + i * size * LINE_HEIGHT);
    }
  }

  // The lines of a text of which none is wider than the limit, unless a single word is.
  #break(text, limit) {
    if (limit <= 0) return text.split("\n");
    return text.split("\n").flatMap((line) => {
      const lines = [];
      let current = "";
      for (const word of line.split(" ")) {
        const longer = current === "" ? word : `${current} ${word}`;
        if (current !== "" && this.sheet.measureText(longer).width > limit) {
          lines.push(current);
          current = word;
        } else {
          current = longer;
        }
      }
      return [...lines, current];
    });
  }
}
