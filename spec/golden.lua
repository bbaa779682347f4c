--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "40737915715275",
  games5000001 = "328919440",
  games5000004 = "1148620823",
  games5000009 = "96027870",
  wild = "1552022577",
}
