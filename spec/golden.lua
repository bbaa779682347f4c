--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "68172506741472",
  games5000001 = "670331882",
  games5000004 = "776199639",
  games5000009 = "650965139",
  wild = "2125000656",
}
