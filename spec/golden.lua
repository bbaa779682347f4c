--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "51169984375138",
  games5000001 = "2061182504",
  games5000004 = "474090316",
  games5000009 = "1557995268",
  snap = "38396779918491",
  wild = "874131342",
}
