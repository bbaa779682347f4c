--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "68172506741472",
  games5000001 = "1361835536",
  games5000004 = "970544283",
  games5000009 = "2063526867",
  wild = "1813533943",
}
