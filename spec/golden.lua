--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "73354160822881",
  games5000001 = "1949945127",
  games5000004 = "1725729995",
  games5000009 = "519900133",
  snap = "25311789254292",
  wild = "1435969206",
}
