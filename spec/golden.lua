--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "42401599680043",
  games5000001 = "717774489",
  games5000004 = "1097106179",
  games5000009 = "76093842",
  snap = "36365567546471",
  wild = "1391583773",
}
