// The program in the address: "#snippet=lift" is one of the snippets, "#code=…" any program,
// deflated and written in base64 with the letters that an address may have.

const MOST = 200000; // letters of a program that comes with an address

const pour = (bytes, through) => new Blob([bytes]).stream().pipeThrough(through);

export async function pack(code) {
  const stream = pour(new TextEncoder().encode(code), new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

// Errors: what cannot be read, or a program that is too long.
export async function unpack(text) {
  const letters = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  const reader = pour(bytes, new DecompressionStream("deflate-raw")).getReader();
  const decoder = new TextDecoder("utf-8", { fatal: true });
  let code = "";
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return code + decoder.decode();
    code += decoder.decode(value, { stream: true });
    if (code.length > MOST) throw new Error("the program is too long");
  }
}
