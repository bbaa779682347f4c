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
from urllib.parse import quote

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

# The menu: pages, and sections of pages. A page that does not exist is left out. A page of docs/ that is
# not named here stands at the end of the last section. `guide/*` are all pages of the folder that are not
# named, in the order in which its index.md names them.
MENU = [
    ("Start", ["index.md"]),
    ("Guide", [
        "guide/index.md",
        ("Learn", ["recipes.md", "platformers.md", "topdown.md", "kit.md", "online.md"]),
        ("Ideas", ["guide/*", "events.md", "state.md"]),
        ("Around it", ["maps.md", "guide/files.md", "guide/sprites.md", "guide/input.md", "guide/debugging.md"]),
    ]),
    ("Examples", ["examples/index.md", "examples/*"]),
    ("Playground", ["playground.md"]),
    ("Reference", [
        "api.md", "api/fields.md", "api/settings.md", "api/world.md", "api/queries.md", "api/maps.md", "api/types.md",
    ]),
    ("More", [
        "compare.md", "faq.md", "where-it-runs.md", "coming-from.md", "performance.md", "reliability.md", "size.md",
        ("For developers", ["architecture.md", "contributing.md", "testing.md", "benchmark.md", "changelog.md"]),
    ]),
]
DEVELOPERS = MENU[-1][1][-1][1]

# What readers search, and the section does not call so. Each is a result of the search of its own. A section
# is the first one with an anchor that begins so; the words of a page without "#" are those of all of it.
WORDS = {
    "faq.md": ["Ragdoll", "Joint", "Hinge", "Rope", "Chain"],
    "faq.md#why-does-my-player-stick-to-walls": ["Stuck", "Stick", "Cling"],
    "guide/contacts.md#bouncing": ["Bounce", "Bouncy", "Elastic"],
    "guide/contacts.md#touching": ["isGrounded", "is_on_floor", "isOnGround", "IsTouching", "isColliding"],
    "guide/filters.md#one-way-objects": ["One way platform", "Jump through", "Semisolid"],
    "guide/motion.md#zones": ["Swim", "Swimming", "Buoyancy", "Underwater"],
    "guide/objects.md#adding-and-removing": ["Object pooling", "Object pool"],
    "guide/sprites.md": ["Particles", "Particle system"],
    "guide/steps.md": ["Delta time", "deltaTime"],
    "index.md#install": ["License", "Licence"],
    "platformers.md#slopes": ["Steep slope", "Max slope angle", "floor_max_angle"],
    "platformers.md#step-5": ["Buffered jump"],
    "recipes.md#camera": ["Screen shake"],
    "recipes.md#knock-back": ["Knockback", "Hitstun", "Stun"],
    "recipes.md#pause-and-slow-motion": ["Slow motion", "Bullet time", "Time scale"],
    "recipes.md#portals": ["Wrap", "Screen wrap", "Wrap around"],
    "recipes.md#scale-and-resolution": ["Scaling", "Fullscreen", "Pixel perfect"],
    "recipes.md#sokoban": ["Grid movement", "Tile based movement", "Turn based"],
    "recipes.md#sword": ["Attack", "Melee"],
    "where-it-runs.md": ["Mobile", "Android", "iOS", "Web", "Browser", "HTML5", "Console", "Steam Deck"],
}

EXAMPLE = """\
# {title}

{text}

<div class="example" data-example="{name}" data-keys="{keys}">
<button type="button"><img src="../../pictures/{name}.png" alt="{title}"><span>▶ Play</span></button>
</div>
<p class="try-links"><a href="../../play/?example={name}&amp;keys={quoted}" target="_blank">Open it in a window of its own</a></p>

{comment}

## Source {{ data-search-exclude }}

`examples/{name}.lua`. It needs beside it, from the folder {folder}: {beside}.

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

To start a game of your own, copy a step of [Platformers](../platformers.md) or [Top-down games](../topdown.md): each is a
whole program. An example needs the files that its page names with its source.

<div class="gallery">
{cards}
</div>
"""

# What a page is about, where its first sentences do not say so.
DESCRIPTIONS = {
    "index.md": "2D physics for LÖVE games made of boxes, slopes and balls: pure Lua, one file, and your own tables are the objects.",
    "api/maps.md": "Reference: loadTiled, loadLDtk, addTiles, and the tiles and levels that they return.",
    "api/queries.md": "Reference: rectangles, circles, rays, sweeps, nearest, ground and the other queries of a world.",
    "api/settings.md": "Reference: gravity, push, masks, soft groups, time steps and the other settings of a world.",
    "api/types.md": "Reference: the types that editors with LuaLS or EmmyLua annotations show.",
    "api/world.md": "Reference: make a world, add and remove objects, update, save, restore, draw.",
    "coming-from.md": "For games that use bump.lua, love.physics or windfield: what each call is called here.",
    "faq.md": "Why does it not move, stick, jitter, fall through the floor? And where is what you look for?",
    "examples/index.md": "Games and toys that run in your browser, with their sources.",
    "guide/index.md": "The ten ideas of physics.lua, and where each is explained.",
    "performance.md": "What a step costs, beside love.physics and bump.lua, and how to measure your game.",
    "size.md": "How large the library is, how long it loads and what an object takes, beside bump.lua.",
    "where-it-runs.md": "Phones, browsers, Windows, macOS, Linux, Steam Deck and consoles: what was tried, what is known.",
}

# How early the search shows a page; 1 is usual. Pages for developers come last.
BOOSTS = {"api.md": 2, "api/fields.md": 4, "api/world.md": 4, "faq.md": 3, "state.md": 5}
BOOSTS.update(dict.fromkeys(DEVELOPERS, 1e-6))

# The front page begins with an example over its whole width, and four buttons.
HERO = """\
<div class="hero example" data-example="hills" data-keys="{keys}">
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
# Playground

Write a program for LÖVE on the left and see it run on the right, in your browser.
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


def slug(heading):
    return re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")


def add_words(markdown, page):
    """Marks the sections of WORDS. Returns the page, and for each word its place and how the search shows it."""
    wanted = {place.partition("#")[2]: words for place, words in WORDS.items() if place.partition("#")[0] == page}
    lines, found = [], []
    for line, is_code in split_code(markdown):
        heading = not is_code and re.match(r"(#+ )(.*)", line)
        title = slug(heading[2]) if heading and heading[1] != "# " else ""
        place = next((place for place in wanted if heading and (title.startswith(place) if place else not title)), None)
        for word in wanted.pop(place, []):
            anchor = f"search-{slug(word)}"
            line = line.replace(heading[1], f'{heading[1]}<a id="{anchor}"></a>', 1)
            found.append((f"{re.sub('(^|/)index$', '', page[:-3]) + '/'}#{anchor}".lstrip("/"), word))
        lines.append(line)
    for anchor in wanted:
        fail(f"{page} has no section {anchor}, for which WORDS has words")
    return "\n".join(lines), found


CARDS = {"fields": "name | value | default | meaning", "engines": "scene | counts | physics.lua"}


def mark_tables(markdown):
    """Marks the tables that a phone is too narrow for: their rows become cards there."""
    for name, titles in CARDS.items():
        table = re.compile(rf"^\| {re.escape(titles)} \|.*\n(?:\|.*\n)+", re.MULTILINE)
        markdown = table.sub(lambda found: f'<div class="cards {name}" markdown>\n\n{found[0]}\n</div>\n', markdown)
    return markdown


def describe(markdown):
    """The first sentences of a page, for those who see its address elsewhere."""
    prose = "\n".join("" if is_code else line for line, is_code in split_code(markdown))
    found = ""
    for paragraph in re.split(r"\n\s*\n", prose):
        if found and paragraph.startswith("#"):
            break
        if " · " in paragraph or not re.match(r"""(?!\d+\.)(\w|[`"\[]|\*\*)""", paragraph):
            continue  # links, a list, a table, a picture and the words below it
        text = re.sub(r"\[([^\]]*)\]\([^)]*\)|<[^>]*>", r"\1", paragraph.replace("\n", " "))
        for sentence in re.findall(r".+?(?:[.!?](?= |$)|:$)", re.sub("[`*]", "", text).replace('"', "'")):
            if found and len(found) + len(sentence) > 170:
                return found
            found = f"{found} {re.sub(':$', '.', sentence.strip())}".strip()
    return found


def head(page, text):
    """What stands before the text of a page: how it is shown and found."""
    about = text.partition("</div>")[2] if page in example_pages() else text
    values = {"description": DESCRIPTIONS.get(page) or describe(about) or fail(f"{page} needs a line in DESCRIPTIONS")}
    if page in BOOSTS:
        values["search"] = {"boost": BOOSTS[page]}
    if page == "index.md":
        values["hide"] = ["navigation", "toc"]
    elif page == "playground.md":
        values.update(template="playground.html", hide=["navigation", "toc", "footer"])
    elif page.startswith("examples/"):
        values["hide"] = ["toc"]
    # What is JSON is YAML.
    return f"---\n{json.dumps(values, ensure_ascii=False)}\n---\n"


def add_hero(markdown):
    """Puts the example and the buttons into the place of the picture and the links of the README."""
    picture = markdown.index("<video")
    video = markdown[picture : markdown.index("</video>") + len("</video>")]
    end = markdown.index("```lua")
    words = re.search(r"^\*(.+)\*$", markdown[picture:end], re.MULTILINE)[1]
    hero = HERO.format(video=video, words=words, keys=keys_of("hills"))
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


LESSONS = re.findall(r'^  "(\w+)",$', read("examples/tutorial.lua"), re.MULTILINE)


def keys_of(name):
    """The keys of an example, for which a screen that is touched shows buttons: "left,right,space=jump".
    A hint of an example is its keys and what they do; the tutorial has hints of its pages, too."""
    sources = [name, *(f"lessons/{lesson}" for lesson in LESSONS if name == "tutorial")]
    text = "".join(read(f"examples/{source}.lua") for source in sources)
    arrows, others = [], {}
    for hints in re.findall(r"\bkeys = \{(\s*\{.*?\})\s*,?\s*\}", text, re.DOTALL):
        for hint in re.findall(r"\{([^{}]*)\}", hints):
            *keys, does = re.findall(r'"([^"]*)"', hint)
            for key in keys:
                if key in ("left", "right", "up", "down"):
                    arrows.append(key)
                elif key == "space" or re.fullmatch("[a-z0-9]", key):
                    is_named = len(keys) == 1 and key not in others
                    others[key] = f"{key}={does.split(',')[0]}" if is_named else key
    return ",".join([*arrows, *others.values()]) or fail(f"examples/{name}.lua has no keys")


def beside(name):
    """The files that an example needs, as examples/README.md names them."""
    row = re.search(rf"^\| \[{name}\.lua\].*\| (.*) \|$", read("examples/README.md"), re.MULTILINE)
    return row[1] if row else fail(f"examples/README.md has no row of {name}.lua")


def lessons():
    """The pages of the tutorial, to be read below it: on a phone its letters are small."""
    text = ["", "## The ten pages"]
    for number, lesson in enumerate(LESSONS, 1):
        source = read(f"examples/lessons/{lesson}.lua")
        title = re.search(r'title = "([^"]*)"', source)[1]
        words, code = (re.search(rf"\b{part} = \[\[\n(.*?)\]\]", source, re.DOTALL) for part in ("text", "code"))
        text.append(f"### {number}. {title}\n\n{space_lists(words[1])}")
        if code:
            text.append(f"```lua\n{code[1]}\n```")
    return "\n\n".join(text)


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
        values = {"name": name, "title": title, "text": text, "keys": keys_of(name), "quoted": quote(keys_of(name)), "beside": beside(name), "folder": folder}
        comment = head_comment(source) + (lessons() if name == "tutorial" else "")
        write(f"examples/{name}.md", EXAMPLE.format(**values, comment=comment, source=source))
        cards.append(CARD.format(**values))
    write("examples/index.md", GALLERY.format(cards="\n".join(cards)))


# Menu --------------------------------------------------------------------------------------------


def order_guide(pages):
    """The pages of the guide in the order in which its index.md names them."""
    text = read("docs/guide/index.md")

    def place(page):
        at = text.find("(" + posixpath.basename(page))
        return (at < 0, at, page)

    return sorted(pages, key=place)


def example_pages():
    return [f"examples/{name}.md" for name, _, _ in examples()]


def named(entries):
    """All pages that a part of MENU names."""
    return [page for entry in entries for page in (named(entry[1]) if isinstance(entry, tuple) else [entry])]


def make_menu(pages):
    """Every page stands in the menu, once."""
    free = [page for page in pages if page not in named(MENU)]

    def expand(entries):
        found = []
        for entry in entries:
            if isinstance(entry, tuple):
                inner = expand(entry[1])
                found += [{entry[0]: inner[0] if len(inner) == 1 else inner}] if inner else []
            elif entry in pages:
                found.append(entry)
            elif entry.endswith("/*"):
                inner = [page for page in free if page.startswith(entry[:-1])]
                inner = order_guide(inner) if entry == "guide/*" else example_pages()
                free[:] = [page for page in free if page not in inner]
                found += inner
        return found

    menu = expand(MENU)
    *_, last = menu[-1].values()
    last[-1:-1] = sorted(free)
    return menu


def main():
    target = Path(sys.argv[1])
    pages, words = [], []

    def write(name, text):
        pages.append(name)
        (target / "docs" / name).parent.mkdir(parents=True, exist_ok=True)
        text, found = add_words(mark_tables(text), name)
        words.extend(found)
        (target / "docs" / name).write_text(head(name, text) + text, encoding="utf-8")

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
    (target / "words.json").write_text(json.dumps(words), encoding="utf-8")
    menu = json.dumps(make_menu(pages), ensure_ascii=False, indent=2)
    owner, name = REPOSITORY.split("/")[-2:] if REPOSITORY else ("", "")
    site = f"https://{owner.lower()}.github.io/{name}/"
    addresses = f"repo_url: {REPOSITORY}\nsite_url: {site}\n" if REPOSITORY else ""
    text = f"{read('web/site/mkdocs.yml')}\n{addresses}nav: {menu}\n"
    (target / "mkdocs.yml").write_text(text, encoding="utf-8")


main()
