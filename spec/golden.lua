--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "87544872611561",
  games5000001 = "577100062",
  games5000004 = "88631378",
  games5000009 = "1546186774",
  snap = "64356193480310",
  wild = "1391583773",
}
