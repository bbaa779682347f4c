--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "25271037772790",
  games5000001 = "1793423152",
  games5000004 = "1224682083",
  games5000009 = "779223563",
  snap = "60952533062966",
  wild = "1081730282",
}
