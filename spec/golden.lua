--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "17540646036941",
  games5000001 = "1225979055",
  games5000004 = "162526247",
  games5000009 = "197846852",
  wild = "1446929157",
}
