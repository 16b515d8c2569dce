"""A small, safe Markdown: headings, paragraphs, lists, tables, code, bold, italic, links.

Everything else is escaped. Only links to the web stay links: others lead out of the report folder.
"""

import html
import re

INLINE = re.compile(r"`([^`]+)`|\*\*(.+?)\*\*|(?<![\w*])[*_](?=\S)(.+?)(?<=\S)[*_](?![\w*])"
                    r"|\[([^\]]+)\]\(([^)\s]+)\)")
ITEM = re.compile(r"(?:[-*+]|\d+[.)])\s+(.*)")
HEADING = re.compile(r"(#{1,6})\s+(.*?)\s*#*$")


def _span(match):
    code, bold, italic, label, address = match.groups()
    if code is not None:
        return f"<code>{html.escape(code)}</code>"
    if bold is not None:
        return f"<strong>{inline(bold)}</strong>"
    if italic is not None:
        return f"<em>{inline(italic)}</em>"
    if re.match(r"https?://", address):
        return f'<a href="{html.escape(address)}">{inline(label)}</a>'
    return inline(label)


def inline(text):
    done, parts = 0, []
    for match in INLINE.finditer(text):
        parts += [html.escape(text[done:match.start()]), _span(match)]
        done = match.end()
    return "".join(parts) + html.escape(text[done:])


def _code(lines):
    body = []
    for line in lines:
        if line.startswith("```"):
            break
        body.append(line)
    return f"<pre><code>{html.escape(chr(10).join(body))}</code></pre>"


def _list(block):
    tag = "ol" if block[0][0].isdigit() else "ul"
    items = []
    for line in block:
        match = ITEM.match(line.strip())
        if match:
            items.append(match[1])
        else:
            items[-1] += " " + line.strip()
    return f"<{tag}>" + "".join(f"<li>{inline(item)}</li>" for item in items) + f"</{tag}>"


def _table(block):
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in block]
    head, body = rows[0], rows[2:]
    cells = "".join(f"<th>{inline(cell)}</th>" for cell in head)
    lines = "".join("<tr>" + "".join(f"<td>{inline(cell)}</td>" for cell in row) + "</tr>" for row in body)
    return f'<div class="wide"><table><thead><tr>{cells}</tr></thead><tbody>{lines}</tbody></table></div>'


def _block(block, first_heading):
    heading = HEADING.match(block[0])
    if heading:
        level = min(6, len(heading[1]) + first_heading - 1)
        rest = _block(block[1:], first_heading) if block[1:] else ""
        return f"<h{level}>{inline(heading[2])}</h{level}>{rest}"
    if ITEM.match(block[0]):
        return _list(block)
    if len(block) > 1 and re.fullmatch(r"[\s|:-]*-[\s|:-]*", block[1]) and "|" in block[0]:
        return _table(block)
    starts = [i for i, line in enumerate(block) if i and (HEADING.match(line) or ITEM.match(line))]
    start = starts[0] if starts else len(block)
    rest = _block(block[start:], first_heading) if start < len(block) else ""
    return f"<p>{inline(' '.join(line.strip() for line in block[:start]))}</p>{rest}"


def render(text, first_heading=3):
    """HTML of this Markdown; its top heading becomes <h{first_heading}>."""
    parts, block, lines = [], [], iter(text.splitlines() + [""])
    for line in lines:
        fence = line.startswith("```")
        if block and (fence or not line.strip()):
            parts.append(_block(block, first_heading))
            block = []
        if fence:
            parts.append(_code(lines))
        elif line.strip():
            block.append(line)
    return "\n".join(parts)
