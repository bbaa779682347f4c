--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "30175189452983",
  games5000001 = "2010116038",
  games5000004 = "1249077882",
  games5000009 = "1004085786",
  snap = "14057959718007",
  wild = "1435969206",
}
