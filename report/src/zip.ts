// A ZIP archive of files that are compressed already: entries are stored as they are (PKWARE APPNOTE 6.3, methods 0).

const crc_table = Uint32Array.from({ length: 256 }, (_unused, n) => {
  let c = n;
  for (let k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

function checksum(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = crc_table[(crc ^ byte) & 255]! ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

/** Writes little-endian numbers, each of 2 or 4 bytes. */
function pack(...numbers: [value: number, bytes: 2 | 4][]): Uint8Array<ArrayBuffer> {
  const view = new DataView(new ArrayBuffer(numbers.reduce((sum, [, bytes]) => sum + bytes, 0)));
  let at = 0;
  for (const [value, bytes] of numbers) {
    if (bytes === 2) view.setUint16(at, value, true);
    else view.setUint32(at, value, true);
    at += bytes;
  }
  return new Uint8Array(view.buffer);
}

export interface ZipEntry {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

const version = 20;
const first_of_1980 = 33; // the format's date without one: day 1, month 1

/** Makes an archive of files with names in ASCII. */
export function make_zip(entries: ZipEntry[]): Blob {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const directory: Uint8Array<ArrayBuffer>[] = [];
  let offset = 0;
  for (const { name, bytes } of entries) {
    const text = new TextEncoder().encode(name);
    const crc = checksum(bytes);
    const common: [number, 2 | 4][] = [[version, 2], [0, 2], [0, 2], [0, 2], [first_of_1980, 2], [crc, 4], [bytes.length, 4], [bytes.length, 4], [text.length, 2], [0, 2]];
    const head = pack([0x04034b50, 4], ...common);
    parts.push(head, text, bytes);
    directory.push(pack([0x02014b50, 4], [version, 2], ...common, [0, 2], [0, 2], [0, 2], [0, 4], [offset, 4]), text);
    offset += head.length + text.length + bytes.length;
  }
  const size = directory.reduce((sum, part) => sum + part.length, 0);
  const end = pack([0x06054b50, 4], [0, 2], [0, 2], [entries.length, 2], [entries.length, 2], [size, 4], [offset, 4], [0, 2]);
  return new Blob([...parts, ...directory, end], { type: "application/zip" });
}
