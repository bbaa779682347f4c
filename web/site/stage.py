"""Lays out the pages of the site for the generator: python3 web/site/stage.py build/site-source

What the repository has for its readers is Markdown for GitHub: README.md and docs/. This copies it
into one folder, adds the pages of the examples and of the playground, turns links into links of the
site, and writes mkdocs.yml with the menu. A link to a file that does not exist ends it.
"""

import json
import posixpath
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# The address of the repository, or "": what needs it is left out then (scripts/publish.lua).
REPOSITORY = subprocess.run(
    ["luajit", "scripts/publish.lua", "address"], cwd=ROOT, check=True, capture_output=True, text=True
).stdout.strip()

# Files of the repository that are pages, too, and the places of these in the site.
PAGES = {
    "README.md": "index.md",
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    "ARCHITECTURE.md": "architecture.md",
    "spec/TESTING.md": "testing.md",
    "bench/README.md": "benchmark.md",
}

# The menu. A page that does not exist is left out. A page of docs/ that is not named here stands at
# the end of the last section. `guide/*` are all pages of the folder, in the order in which its
# index.md names them.
MENU = [
    ("Start", ["index.md"]),
    ("Guide", ["guide/*", "platformers.md", "topdown.md", "maps.md", "events.md", "state.md", "recipes.md"]),
    ("Examples", ["examples/*"]),
    ("Playground", ["playground.md"]),
    ("Reference", [
        "api.md", "api/fields.md", "api/settings.md", "api/world.md", "api/queries.md", "api/maps.md", "api/types.md",
    ]),
    ("More", [
        "compare.md", "faq.md", "coming-from.md", "glossary.md", "performance.md", "reliability.md", "size.md",
        "architecture.md", "contributing.md", "testing.md", "benchmark.md", "changelog.md",
    ]),
]

EXAMPLE = """\
# {title}

{text}

<div class="example" data-example="{name}">
<button type="button"><img src="../../pictures/{name}.png" alt="{title}"><span>▶ Play</span></button>
</div>
{comment}

<a href="../../play/?example={name}" target="_blank">Open it in a window of its own</a>

## Source {{ data-search-exclude }}

`examples/{name}.lua`. The files that it requires are in the folder {folder}.

<div data-no-try markdown>

```lua
{source}
```

</div>
"""

CARD = """\
<a href="{name}/"><img src="../pictures/{name}.png" alt="" loading="lazy"><strong>{title}</strong>\
<span>{text}</span></a>"""

GALLERY = """\
# Examples

Each one runs in its page, in your browser. `make demo` opens them in LÖVE.

<div class="gallery">
{cards}
</div>
"""

# What stands before the text of a page: how it is shown and found.
HEADS = {
    "index.md": "---\nhide: [navigation, toc]\n---\n",
    "api.md": "---\nsearch: { boost: 2 }\n---\n",
    "api/fields.md": "---\nsearch: { boost: 4 }\n---\n",
    "api/world.md": "---\nsearch: { boost: 4 }\n---\n",
    "faq.md": "---\nsearch: { boost: 3 }\n---\n",
    "state.md": "---\nsearch: { boost: 5 }\n---\n",
}

# The front page begins with an example over its whole width, and four buttons.
HERO = """\
<div class="hero example" data-example="hills">
<button type="button">{video}<span>▶ Play</span></button>
</div>
<p class="hero-words">{words}</p>
<p class="hero-links">
<a href="playground/physics.lua" download>Download one file</a>
<a href="examples/">Play the examples</a>
<a href="playground/">Playground</a>
<a href="guide/">Manual</a>
</p>
"""

PLAYGROUND = """\
---
template: playground.html
hide: [navigation, toc, footer]
---
# Playground

A program on the left, its picture on the right.
"""


def fail(message):
    sys.exit(f"stage.py: {message}")


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


# Markdown of GitHub, for the generator -----------------------------------------------------------


def split_code(markdown):
    """Yields each line, and whether it belongs to a block of code."""
    fence = None
    for line in markdown.split("\n"):
        mark = re.match(r"\s*(`{3,}|~{3,})", line)
        if fence is None:
            fence = mark and mark[1]
            yield line, bool(mark)
        else:
            if mark and mark[1].startswith(fence) and line.strip() == mark[1]:
                fence = None
            yield line, True


def space_lists(markdown):
    """Lists of GitHub need no empty line before them, and inner items stand two spaces in. Python's
    Markdown wants an empty line, and four spaces."""
    lines = []
    before = ""
    is_in_list = False
    for line, is_code in split_code(markdown):
        item = not is_code and re.match(r"( *)([-*+]|\d+\.) ", line)
        if item and is_in_list:
            if len(item[1]) in (2, 3):
                line = "    " + line.lstrip()
        elif item:
            if before.strip():
                lines.append("")
            is_in_list = True
        elif line.strip() and not line.startswith(" ") and (is_code or not before.strip()):
            is_in_list = False
        lines.append(line)
        before = line
    return "\n".join(lines)


def lead(target, source):
    """Where a link of a file of the repository leads in the site. Without an address of the
    repository some lead to NOWHERE; translate takes these away."""
    path, mark, anchor = target.partition("#")
    place = posixpath.normpath(posixpath.join(posixpath.dirname(source), path))
    page = PAGES.get(source, source.removeprefix("docs/"))
    if place in PAGES:
        inside = PAGES[place]
    elif place.startswith("..") or not (ROOT / place).exists():
        fail(f"{source}: the link to {target} leads nowhere")
    elif place.startswith("docs/") and (ROOT / place).is_file():
        inside = place.removeprefix("docs/")
    else:
        kind = "tree" if (ROOT / place).is_dir() else "blob"
        return f"{REPOSITORY}/{kind}/HEAD/{place}{mark}{anchor}" if REPOSITORY else "NOWHERE"
    return posixpath.relpath(inside, posixpath.dirname(page) or ".") + mark + anchor


# A program of a page, which the playground runs.
STEP = re.compile(r"\[The whole program\]\(steps/(\w+)\.lua\)")


def add_hero(markdown):
    """Puts the example and the buttons into the place of the picture and the links of the README."""
    picture = markdown.index("<video")
    video = markdown[picture : markdown.index("</video>") + len("</video>")]
    end = markdown.index("```lua")
    words = re.search(r"^\*(.+)\*$", markdown[picture:end], re.MULTILINE)[1]
    hero = HERO.format(video=video, words=words)
    return markdown[:picture] + hero + "\n" + markdown[end:]


ANIMATION = re.compile(r"!\[([^\]]*)\]\(([^)\s]+)\.(?:webp|gif)\)(?:\{ loading=lazy \})?")
CLIPS = re.compile(r"^\| (<video.*) \|\n\|[-|]+\|\n\| (.*) \|$", re.MULTILINE)


def add_videos(markdown, page):
    """Puts videos, which are a fourth as large, into the places of animations; site.js plays those that
    are seen. A table with videos in its head becomes cards, which fit a phone."""

    def video(found):
        place = posixpath.normpath(posixpath.join(posixpath.dirname(page), found[2]))
        if not (ROOT / f"docs/{place}.mp4").exists():
            fail(f"docs/{place}.mp4 is not there: make pictures makes it")
        depth = page.count("/") + (posixpath.basename(page) != "index.md")
        source = "../" * depth + place
        poster = f' poster="{source}.png"' if (ROOT / f"docs/{place}.png").exists() else ""
        return (
            f'<video class="clip" src="{source}.mp4"{poster} aria-label="{found[1]}" role="img" '
            "muted loop playsinline preload=none></video>"
        )

    def cards(found):
        pairs = zip(found[1].split(" | "), found[2].split(" | "))
        inner = "\n\n".join(f"<div markdown>\n\n{clip}\n\n{text}\n\n</div>" for clip, text in pairs)
        return f'<div class="clips" markdown>\n\n{inner}\n\n</div>'

    return CLIPS.sub(cards, ANIMATION.sub(video, markdown))


LINK = re.compile(r'(\]\()([^)\s#:][^)\s:]*)(?=\)|\s+"[^"]*"\))')
LINK_TO_NOWHERE = re.compile(r'\[([^\[\]]*)\]\(NOWHERE\)')
CODE = re.compile(r"(`+[^`]*`+)")


def translate(markdown, source):
    lines = []
    for line, is_code in split_code(space_lists(markdown)):
        if not is_code:
            line = STEP.sub(r'<a class="try" href="../playground/#snippet=\1">Run this step in the playground</a>', line)
            parts = CODE.split(line)
            for i in range(0, len(parts), 2):
                parts[i] = LINK.sub(lambda link: link[1] + lead(link[2], source), parts[i])
            if line.startswith("![") and len(parts) == 1:
                parts[0] += "{ loading=lazy }"
            if line.startswith("|"):
                # In a table GitHub wants "\\|" also inside of code, Python's Markdown shows it.
                for i in range(1, len(parts), 2):
                    parts[i] = parts[i].replace("\\|", "|")
            line = LINK_TO_NOWHERE.sub(r"\1", "".join(parts))
        lines.append(line)
    return "\n".join(lines)


# Examples ----------------------------------------------------------------------------------------


def examples():
    """The entries of the menu of the examples: name, title, text."""
    entry = r'\{ name = "([^"]*)", title = "([^"]*)", text = "([^"]*)" \}'
    return re.findall(entry, read("examples/menu.lua")) or fail("examples/menu.lua has no entries")


def head_comment(source):
    """The comment at the beginning of a source, as Markdown."""
    lines = []
    for line in source.split("\n"):
        if not line.startswith("--"):
            break
        lines.append(line.lstrip("-").strip())
    return "\n".join(lines)


def write_examples(write):
    cards = []
    for name, title, text in examples():
        if not (ROOT / f"docs/pictures/{name}.png").exists():
            fail(f"docs/pictures/{name}.png is not there: make pictures makes it")
        source = read(f"examples/{name}.lua").rstrip()
        folder = translate("[examples](examples)", "README.md")
        values = {"name": name, "title": title, "text": text, "folder": folder}
        comment = head_comment(source)
        write(f"examples/{name}.md", EXAMPLE.format(**values, comment=comment, source=source))
        cards.append(CARD.format(**values))
    write("examples/index.md", GALLERY.format(cards="\n".join(cards)))


# Menu --------------------------------------------------------------------------------------------


def order_guide(pages):
    """The pages of the guide in the order in which its index.md names them."""
    text = read("docs/guide/index.md") if "guide/index.md" in pages else ""

    def place(page):
        at = text.find("(" + posixpath.basename(page))
        return (page != "guide/index.md", at < 0, at, page)

    return sorted(pages, key=place)


def order_examples(pages):
    return ["examples/index.md", *(f"examples/{name}.md" for name, _, _ in examples())]


def make_menu(pages):
    """Every page stands in the menu, once."""
    left = set(pages)
    menu = []
    for title, names in MENU:
        entries = []
        for name in names:
            if name in left:
                entries.append(name)
            elif name.endswith("/*"):
                order = order_guide if name == "guide/*" else order_examples
                entries += order([page for page in pages if page.startswith(name[:-1])])
        left -= set(entries)
        menu.append((title, entries))
    menu[-1][1].extend(sorted(left))
    return [
        {title: entries[0] if len(entries) == 1 else entries} for title, entries in menu if entries
    ]


def main():
    target = Path(sys.argv[1])
    pages = []

    def write(name, text):
        pages.append(name)
        (target / "docs" / name).parent.mkdir(parents=True, exist_ok=True)
        (target / "docs" / name).write_text(HEADS.get(name, "") + text, encoding="utf-8")

    only_github = shutil.ignore_patterns("*.webp", "*.gif")
    shutil.copytree(ROOT / "docs", target / "docs", dirs_exist_ok=True, ignore=only_github)
    for path in sorted((ROOT / "docs").rglob("*.md")):
        source = path.relative_to(ROOT).as_posix()
        name = source.removeprefix("docs/")
        write(name, add_videos(translate(read(source), source), name))
    for source, name in PAGES.items():
        if (ROOT / source).exists():
            text = add_videos(translate(read(source), source), name)
            write(name, add_hero(text) if name == "index.md" else text)
    write_examples(write)
    write("playground.md", PLAYGROUND)
    # What is JSON is YAML.
    menu = json.dumps(make_menu(pages), ensure_ascii=False, indent=2)
    owner, name = REPOSITORY.split("/")[-2:] if REPOSITORY else ("", "")
    site = f"https://{owner.lower()}.github.io/{name}/"
    addresses = f"repo_url: {REPOSITORY}\nsite_url: {site}\n" if REPOSITORY else ""
    text = f"{read('web/site/mkdocs.yml')}\n{addresses}nav: {menu}\n"
    (target / "mkdocs.yml").write_text(text, encoding="utf-8")


main()
