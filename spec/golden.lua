--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "14552558984513",
  games5000001 = "29297689",
  games5000004 = "1222664863",
  games5000009 = "1679719914",
}
