--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "62129976088147",
  games5000001 = "259720213",
  games5000004 = "1737201844",
  games5000009 = "842065623",
  snap = "60952533062966",
  wild = "1081730282",
}
