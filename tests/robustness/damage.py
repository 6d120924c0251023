"""Damages texts and bytes in the ways that disks, editors, mail programs and people do."""
NASTY_BYTES = [b"\0", b"\r", b"\xff", b"\xc3", b"\x1b[31m", b"\xef\xbb\xbf", b"\n\n", b"\"", b"'''", b"[", b"]", b"{", b"}", b"=", b"#", b".", b",",
               b";", b"\t", "−".encode(), "\u00a0".encode(), "\U0001f9f5".encode()]
NASTY_NUMBERS = ["nan", "inf", "-inf", "1e999", "-1e999", "1e-999", "0", "-0.0", "-1", "1e300", "1e-300", "9223372036854775807",
                 "-9223372036854775808", "99999999999999999999", "4294967296", "0x7fffffff", "1_000", "0.1e", ".5", "5.", "1,5", "1;5", "true"]


def flip_bit(data, chance):
    if not data:
        return data
    data = bytearray(data)
    for _ in range(chance.choice([1, 1, 1, 2, 8])):
        data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    return bytes(data)


def cut_end(data, chance):
    return data[:chance.randrange(len(data) + 1)]


def drop_span(data, chance):
    begin = chance.randrange(len(data) + 1)
    return data[:begin] + data[begin + chance.choice([1, 2, 7, 64, 1000]):]


def repeat_span(data, chance):
    begin = chance.randrange(len(data) + 1)
    end = begin + chance.choice([1, 5, 50, 500])
    return data[:end] + data[begin:end] * chance.choice([1, 2, 30]) + data[end:]


def insert_bytes(data, chance):
    at = chance.randrange(len(data) + 1)
    return data[:at] + chance.choice(NASTY_BYTES) * chance.choice([1, 1, 1, 3, 200]) + data[at:]


def blank_span(data, chance):
    begin = chance.randrange(len(data) + 1)
    length = min(chance.choice([1, 4, 8, 512]), len(data) - begin)
    return data[:begin] + chance.choice([b"\0", b" ", b"\xff"]) * length + data[begin + length:]


def swap_lines(data, chance):
    lines = data.split(b"\n")
    i, j = chance.randrange(len(lines)), chance.randrange(len(lines))
    lines[i], lines[j] = lines[j], lines[i]
    return b"\n".join(lines)


def drop_line(data, chance):
    lines = data.split(b"\n")
    del lines[chance.randrange(len(lines))]
    return b"\n".join(lines)


def repeat_line(data, chance):
    lines = data.split(b"\n")
    i = chance.randrange(len(lines))
    lines.insert(chance.randrange(len(lines) + 1), lines[i])
    return b"\n".join(lines)


def change_number(data, chance):
    words = data.split(b" ")
    numbers = [i for i, word in enumerate(words) if word.strip(b"\n\r\",;[]").replace(b".", b"").replace(b"-", b"").isdigit()]
    if not numbers:
        return insert_bytes(data, chance)
    words[chance.choice(numbers)] = chance.choice(NASTY_NUMBERS).encode()
    return b" ".join(words)


def change_line_ends(data, chance):
    return data.replace(b"\n", chance.choice([b"\r\n", b"\r", b"\n\r", b"\n\n"]))


OF_BYTES = [flip_bit, cut_end, drop_span, repeat_span, insert_bytes, blank_span]
OF_LINES = [swap_lines, drop_line, repeat_line, change_number, change_number, change_line_ends]


def damaged(data, chance, kinds):
    """Applies one to three kinds of damage, one mostly."""
    for _ in range(chance.choice([1, 1, 1, 2, 3])):
        data = chance.choice(kinds)(data, chance)
    return data
