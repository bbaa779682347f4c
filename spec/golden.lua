--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "15451239592615",
  games5000001 = "1086589884",
  games5000004 = "1497705753",
  games5000009 = "1272657291",
  wild = "1081730282",
}
