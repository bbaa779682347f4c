--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "47494757682006",
  games5000001 = "701400723",
  games5000004 = "1521529531",
  games5000009 = "1381449390",
  wild = "1552022577",
}
