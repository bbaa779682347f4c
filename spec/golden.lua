--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "37655159836966",
  games5000001 = "2139406811",
  games5000004 = "604958486",
  games5000009 = "1383478433",
  wild = "816262419",
}
