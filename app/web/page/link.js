// SPDX-License-Identifier: MIT
// Links, as model/io/exchange/entry_link reads and writes them: the text of an entry, deflated without a header, in Base64
// for URLs, behind the “#” of an address.

const longestText = 1e6; // bytes, unpacked
const piece = 512; // bytes that are unpacked at once: at most a thousand times as many come out

/** The part of a link behind its mark, "" where the text is none. @param {string} text */
export function linkData(text) {
  return text.replace(/[\r\n]/g, "").match(/^\s*(?:barycage:#?|[a-z][a-z0-9+.-]*:\/\/[^\s{"#]*#)([\w-]+)\s*$/i)?.[1] ?? "";
}

/** @param {string} text @returns {Promise<string | null>} null where it is too long */
export async function packed(text) {
  const bytes = new TextEncoder().encode(text);
  if (bytes.length > longestText) return null;
  const stream = new Response(bytes).body?.pipeThrough(new CompressionStream("deflate-raw"));
  const deflated = new Uint8Array(await new Response(stream).arrayBuffer());
  let binary = "";
  for (const byte of deflated) binary += String.fromCharCode(byte);
  return btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}

/** Unpacks no more than the limit. @param {string} data @returns {Promise<{text: string} | {flaw: LinkFlaw}>} */
export async function unpacked(data) {
  if (data.length > 2 * longestText) return { flaw: "linkTooLarge" };
  if (!/^[\w-]+$/.test(data)) return { flaw: "linkDamaged" };
  const whole = data.length % 4 === 1 ? data.slice(0, -1) : data;
  const bytes = Uint8Array.from(atob(whole.replace(/-/g, "+").replace(/_/g, "/")), (c) => c.charCodeAt(0));
  const { readable, writable } = new DecompressionStream("deflate-raw");
  const decoder = new TextDecoder();
  let size = 0, text = "";
  const reader = readable.getReader();
  const reading = (async () => {
    for (let next = await reader.read(); !next.done && size <= longestText; next = await reader.read()) {
      size += next.value.length;
      text += decoder.decode(next.value, { stream: true });
    }
    if (size > longestText) await reader.cancel();
  })().catch(() => {});
  let flaw = /** @type {LinkFlaw} */ ("linkDamaged");
  const writer = writable.getWriter();
  writer.closed.catch(() => {});
  try {
    for (let at = 0; at < bytes.length && size <= longestText; at += piece) await writer.write(bytes.slice(at, at + piece));
    flaw = "linkCut"; // all that is there could be unpacked
    if (size <= longestText) await writer.close();
    await reading;
  } catch {
    if (size <= longestText) return { flaw };
  }
  if (size > longestText) return { flaw: "linkTooLarge" };
  return { text: text + decoder.decode() };
}
