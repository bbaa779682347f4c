--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "88275635327181",
  games5000001 = "328745597",
  games5000004 = "509483866",
  games5000009 = "1651217118",
}
