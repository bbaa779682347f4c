--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "75623683477313",
  games5000001 = "763636046",
  games5000004 = "684212385",
  games5000009 = "2110027127",
  snap = "30885410404304",
  wild = "874131342",
}
