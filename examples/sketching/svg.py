# SPDX-License-Identifier: Apache-2.0
"""Writes a sheet as SVG: one <path> per stroke, one <g> per group."""

from sketching.sheet import INK, TEAL

HEAD = """<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="800" viewBox="0 0 1000 800">
  <title>{title}</title>
  <g fill="none" stroke="{ink}" stroke-width="2.4" stroke-linecap="round" stroke-linejoin="round">
"""


def number(value):
    """One decimal, without a useless zero."""
    text = f"{value:.1f}"
    text = text[:-2] if text.endswith(".0") else text
    return "0" if text == "-0" else text


def pair(x, y):
    return f"{number(x)},{number(y)}"


def path_data(points):
    """A smooth path through the points: uniform Catmull-Rom, written as cubics."""
    if len(points) < 4:
        return "M" + pair(*points[0]) + " L" + " ".join(pair(*p) for p in points[1:])
    padded = [points[0]] + points + [points[-1]]
    cubics = []
    for before, a, b, after in zip(padded, padded[1:], padded[2:], padded[3:]):
        first = pair(a[0] + (b[0] - before[0]) / 6, a[1] + (b[1] - before[1]) / 6)
        second = pair(b[0] - (after[0] - a[0]) / 6, b[1] - (after[1] - a[1]) / 6)
        cubics.append(f"{first} {second} {pair(*b)}")
    return "M" + pair(*points[0]) + " C" + " ".join(cubics)


def path(mark):
    if mark.is_help:
        return f'<path class="help" stroke="{TEAL}" stroke-dasharray="9 7" d="{path_data(mark.points)}"/>'
    colour = "" if mark.colour == INK else f' stroke="{mark.colour}"'
    return f'<path{colour} stroke-width="{number(mark.width)}" d="{path_data(mark.points)}"/>'


def opening(group):
    """The tag that starts a group."""
    fill = f' data-fill="{group.fill}"' if group.fill else ""
    thickness = f' data-thickness="{number(group.thickness)}"' if group.thickness else ""
    return f'<g id="{group.name}"{fill}{thickness}>'


def document(sheet):
    """The whole file as text."""
    lines = [HEAD.format(title=sheet.title, ink=INK)]
    for group in sheet.groups:
        lines.append(f"    {opening(group)}\n")
        lines += [f"      {path(mark)}\n" for mark in group.marks]
        if group.copies:
            lines.append(f'      <use href="#{group.copies}" transform="{group.transform}"/>\n')
        lines.append("    </g>\n")
    lines.append("  </g>\n</svg>\n")
    return "".join(lines)
