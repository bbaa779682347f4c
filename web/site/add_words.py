"""Adds what readers search, and no section calls so (WORDS in stage.py), to the index of the search:
python3 web/site/add_words.py build/site-source/words.json build/site/search/search_index.json"""

import json
import sys
from pathlib import Path

words, path = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2])
index = json.loads(path.read_text(encoding="utf-8"))
index["docs"] += [{"location": place, "title": title, "text": ""} for place, title in words]
path.write_text(json.dumps(index, ensure_ascii=False), encoding="utf-8")
