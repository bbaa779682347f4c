--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "85066976846144",
  games5000001 = "39240899",
  games5000004 = "288241106",
  games5000009 = "1097258556",
  wild = "1552022577",
}
