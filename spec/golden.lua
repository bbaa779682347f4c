--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "36103339376012",
  games5000001 = "1977457526",
  games5000004 = "866679487",
  games5000009 = "918239220",
  wild = "1552022577",
}
