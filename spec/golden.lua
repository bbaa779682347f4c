--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "43572523034037",
  games5000001 = "1962119043",
  games5000004 = "44067614",
  games5000009 = "1164247699",
  snap = "14057959718007",
  wild = "670892159",
}
