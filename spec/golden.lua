--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "73111303469249",
  games5000001 = "1610155392",
  games5000004 = "1295084345",
  games5000009 = "62697866",
  wild = "1892354767",
}
