--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "11316448157785",
  games5000001 = "1086589884",
  games5000004 = "610788816",
  games5000009 = "2023217750",
  wild = "1081730282",
}
