struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_11 {
member: array<u32>,
}
struct type_13 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_14 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_13,
member_6: type_13,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: type_4,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: type_4,
member_25: vec4<u32>,
member_26: type_4,
member_27: type_4,
member_28: type_4,
member_29: type_4,
member_30: type_4,
member_31: type_4,
}
struct type_15 {
member: type_14,
}
struct type_18 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_19 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_20 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_15;
@group(0) @binding(1)
var<storage> global_2: type_11;
@group(0) @binding(3)
var<storage> global_3: type_11;
@group(0) @binding(4)
var<storage> global_4: type_11;
@group(0) @binding(5)
var<storage> global_5: type_6;
@group(0) @binding(6)
var<storage, read_write> global_6: type_6;
@group(0) @binding(2)
var<storage> global_7: type_11;
fn function_() {
var local: type_18;
var local_1: vec3<f32>;
var local_2: type_18;
var local_3: vec3<f32>;
var local_4: type_18;
var local_5: vec3<f32>;
var local_6: type_18;
var local_7: vec3<f32>;
var phi_9856_: type_19;
var phi_11176_: type_20;
var phi_12697_: type_21;
var phi_13721_: f32;
var phi_13722_: f32;
var phi_13723_: f32;
var phi_13724_: bool;
switch bitcast<i32>(0u) {
default: {
let _e90 = global;
let _e93 = arrayLength((&global_2.member));
let _e100 = arrayLength((&global_4.member));
let _e107 = global_1.member.member_1;
let _e110 = (_e90.x + _e107.x);
let _e113 = (_e90.y + _e107.y);
if (_e110 < _e107.z) {
if (_e113 < _e107.w) {
let _e121 = global_1.member.member[0u];
let _e125 = global_1.member.member[1u];
let _e126 = (_e121 * _e125);
let _e128 = ((_e113 * _e121) + _e110);
let _e129 = bitcast<i32>(_e128);
let _e131 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e133 = select(_e131, _e129, (_e129 < _e131));
let _e139 = global_6.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e140 = (_e126 + _e128);
let _e141 = bitcast<i32>(_e140);
let _e143 = select(_e131, _e141, (_e141 < _e131));
let _e149 = global_6.member[bitcast<u32>(select(0i, _e143, (_e143 > 0i)))];
let _e151 = ((2u * _e126) + _e128);
let _e152 = bitcast<i32>(_e151);
let _e154 = select(_e131, _e152, (_e152 < _e131));
let _e160 = global_6.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e162 = ((3u * _e126) + _e128);
let _e163 = bitcast<i32>(_e162);
let _e165 = select(_e131, _e163, (_e163 < _e131));
let _e171 = global_6.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e173 = ((4u * _e126) + _e128);
let _e174 = bitcast<i32>(_e173);
let _e176 = select(_e131, _e174, (_e174 < _e131));
let _e182 = global_6.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e184 = ((5u * _e126) + _e128);
let _e185 = bitcast<i32>(_e184);
let _e187 = select(_e131, _e185, (_e185 < _e131));
let _e193 = global_6.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e195 = ((6u * _e126) + _e128);
let _e196 = bitcast<i32>(_e195);
let _e198 = select(_e131, _e196, (_e196 < _e131));
let _e204 = global_6.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e206 = ((7u * _e126) + _e128);
let _e207 = bitcast<i32>(_e206);
let _e209 = select(_e131, _e207, (_e207 < _e131));
let _e215 = global_6.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e217 = ((8u * _e126) + _e128);
let _e218 = bitcast<i32>(_e217);
let _e220 = select(_e131, _e218, (_e218 < _e131));
let _e226 = global_6.member[bitcast<u32>(select(0i, _e220, (_e220 > 0i)))];
let _e228 = ((9u * _e126) + _e128);
let _e229 = bitcast<i32>(_e228);
let _e231 = select(_e131, _e229, (_e229 < _e131));
let _e237 = global_6.member[bitcast<u32>(select(0i, _e231, (_e231 > 0i)))];
let _e239 = ((10u * _e126) + _e128);
let _e240 = bitcast<i32>(_e239);
let _e242 = select(_e131, _e240, (_e240 < _e131));
let _e248 = global_6.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e252 = global_1.member.member_4.member_2;
let _e255 = (1f / select(1e-6f, _e204, (_e204 > 1e-6f)));
let _e259 = global_1.member.member_7.member_3;
let _e260 = (_e252 * _e259);
let _e265 = global_1.member.member_8.member;
let _e267 = (((_e182 * _e255) - _e265) * _e260);
let _e272 = global_1.member.member_8.member_1;
let _e274 = (((_e193 * _e255) - _e272) * _e260);
let _e278 = ((f32(bitcast<i32>(_e110)) - 0.5f) + _e139);
let _e282 = global_1.member.member_2[3u];
let _e283 = (_e282 + 1u);
let _e285 = select(1u, _e283, (_e283 > 0u));
let _e286 = (_e285 == 0u);
if _e286 {
break;
}
let _e291 = ((f32(bitcast<i32>((_e113 % _e285))) - 0.5f) + _e149);
let _e295 = global_1.member.member_4.member;
let _e299 = global_1.member.member_8.member_2;
let _e300 = (_e295 - _e299);
let _e304 = global_1.member.member_7.member;
let _e311 = global_1.member.member_7.member_2;
let _e313 = ((_e304 + (_e265 * _e300)) + ((_e278 + 0.5f) * _e311));
let _e317 = global_1.member.member_7.member_1;
let _e322 = ((_e317 + (_e272 * _e300)) + ((_e291 + 0.5f) * _e311));
let _e328 = global_1.member.member_4.member_1;
let _e329 = (_e328 - _e299);
let _e334 = ((_e304 + (_e265 * _e329)) + (((_e278 + _e267) + 0.5f) * _e311));
let _e339 = ((_e317 + (_e272 * _e329)) + (((_e291 + _e274) + 0.5f) * _e311));
if _e286 {
break;
}
let _e342 = bitcast<i32>(((_e113 / _e285) * 3u));
let _e344 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e346 = select(_e344, _e342, (_e342 < _e344));
let _e352 = global_5.member[bitcast<u32>(select(0i, _e346, (_e346 > 0i)))];
let _e353 = (_e342 + 1i);
let _e355 = select(_e344, _e353, (_e353 < _e344));
let _e361 = global_5.member[bitcast<u32>(select(0i, _e355, (_e355 > 0i)))];
let _e362 = (_e342 + 2i);
let _e364 = select(_e344, _e362, (_e362 < _e344));
let _e370 = global_5.member[bitcast<u32>(select(0i, _e364, (_e364 > 0i)))];
let _e373 = (1f / select(1e-6f, _e370, (_e370 > 1e-6f)));
let _e376 = (((_e352 * _e373) - _e265) * _e260);
let _e379 = (((_e361 * _e373) - _e272) * _e260);
let _e391 = global_1.member.member_5.member;
let _e404 = global_1.member.member_5.member.member_3;
let _e405 = ((((_e391.member * _e313) + (_e391.member_1 * _e322)) + (_e391.member_2 * _e295)) + _e404);
let _e409 = global_1.member.member_5.member_1;
let _e422 = global_1.member.member_5.member_1.member_3;
let _e423 = ((((_e409.member * _e313) + (_e409.member_1 * _e322)) + (_e409.member_2 * _e295)) + _e422);
let _e427 = global_1.member.member_5.member_2;
let _e440 = global_1.member.member_5.member_2.member_3;
let _e441 = ((((_e427.member * _e313) + (_e427.member_1 * _e322)) + (_e427.member_2 * _e295)) + _e440);
let _e447 = ((((_e391.member * _e334) + (_e391.member_1 * _e339)) + (_e391.member_2 * _e328)) + _e404);
let _e453 = ((((_e409.member * _e334) + (_e409.member_1 * _e339)) + (_e409.member_2 * _e328)) + _e422);
let _e459 = ((((_e427.member * _e334) + (_e427.member_1 * _e339)) + (_e427.member_2 * _e328)) + _e440);
let _e464 = global_1.member.member_5.member_3.member_3;
let _e469 = global_1.member.member_5.member_3.member;
let _e470 = (_e469 - 0.5f);
let _e472 = select(-0.5f, _e447, (_e447 > -0.5f));
let _e474 = select(_e470, _e472, (_e472 < _e470));
let _e479 = global_1.member.member_5.member_3.member_1;
let _e480 = (_e479 - 0.5f);
let _e482 = select(-0.5f, _e453, (_e453 > -0.5f));
let _e484 = select(_e480, _e482, (_e482 < _e480));
let _e489 = global_1.member.member_5.member_3.member_2;
let _e490 = (_e489 - 0.5f);
let _e492 = select(-0.5f, _e459, (_e459 > -0.5f));
let _e494 = select(_e490, _e492, (_e492 < _e490));
let _e495 = (_e447 - _e405);
let _e496 = (_e453 - _e423);
let _e497 = (_e459 - _e441);
let _e500 = bitcast<f32>((bitcast<u32>(_e495) & 2147483647u));
let _e503 = bitcast<f32>((bitcast<u32>(_e496) & 2147483647u));
let _e505 = select(_e503, _e500, (_e500 > _e503));
let _e508 = bitcast<f32>((bitcast<u32>(_e497) & 2147483647u));
let _e517 = bitcast<f32>((bitcast<u32>((_e447 - _e474)) & 2147483647u));
let _e520 = bitcast<f32>((bitcast<u32>((_e453 - _e484)) & 2147483647u));
let _e522 = select(_e520, _e517, (_e517 > _e520));
let _e525 = bitcast<f32>((bitcast<u32>((_e459 - _e494)) & 2147483647u));
let _e529 = (_e474 + 0.5f);
let _e530 = (_e469 - 1f);
let _e532 = select(0f, _e529, (_e529 > 0f));
let _e534 = select(_e530, _e532, (_e532 < _e530));
let _e541 = select(0i, select(select(i32(_e534), i32(-2147483648), (_e534 < -2147483600f)), 2147483647i, (_e534 > 2147483500f)), (_e534 == _e534));
let _e550 = global_1.member.member_5.member_7[3u];
let _e551 = (_e550 & 31i);
let _e554 = (_e484 + 0.5f);
let _e555 = (_e479 - 1f);
let _e557 = select(0f, _e554, (_e554 > 0f));
let _e559 = select(_e555, _e557, (_e557 < _e555));
let _e566 = select(0i, select(select(i32(_e559), i32(-2147483648), (_e559 < -2147483600f)), 2147483647i, (_e559 > 2147483500f)), (_e559 == _e559));
let _e573 = (_e494 + 0.5f);
let _e574 = (_e489 - 1f);
let _e576 = select(0f, _e573, (_e573 > 0f));
let _e578 = select(_e574, _e576, (_e576 < _e574));
let _e585 = select(0i, select(select(i32(_e578), i32(-2147483648), (_e578 < -2147483600f)), 2147483647i, (_e578 > 2147483500f)), (_e578 == _e578));
let _e596 = global_1.member.member_5.member_6[3u];
let _e602 = global_1.member.member_5.member_6[0u];
let _e607 = global_1.member.member_5.member_6[1u];
let _e611 = ((_e596 + ((_e541 - select(0i, 1i, (_e534 < f32(_e541)))) >> bitcast<u32>(_e551))) + (_e602 * (((_e566 - select(0i, 1i, (_e559 < f32(_e566)))) >> bitcast<u32>(_e551)) + (_e607 * ((_e585 - select(0i, 1i, (_e578 < f32(_e585)))) >> bitcast<u32>(_e551))))));
let _e613 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e615 = select(_e613, _e611, (_e611 < _e613));
let _e621 = global_3.member[bitcast<u32>(select(0i, _e615, (_e615 > 0i)))];
let _e628 = global_1.member.member_6.member;
let _e641 = global_1.member.member_6.member.member_3;
let _e646 = global_1.member.member_6.member_1;
let _e659 = global_1.member.member_6.member_1.member_3;
let _e664 = global_1.member.member_6.member_2;
let _e677 = global_1.member.member_6.member_2.member_3;
let _e684 = ((((_e628.member * _e334) + (_e628.member_1 * _e339)) + (_e628.member_2 * _e328)) + _e641);
let _e690 = ((((_e646.member * _e334) + (_e646.member_1 * _e339)) + (_e646.member_2 * _e328)) + _e659);
let _e696 = ((((_e664.member * _e334) + (_e664.member_1 * _e339)) + (_e664.member_2 * _e328)) + _e677);
let _e701 = global_1.member.member_6.member_3.member_3;
let _e706 = global_1.member.member_6.member_3.member;
let _e707 = (_e706 - 0.5f);
let _e709 = select(-0.5f, _e684, (_e684 > -0.5f));
let _e711 = select(_e707, _e709, (_e709 < _e707));
let _e716 = global_1.member.member_6.member_3.member_1;
let _e717 = (_e716 - 0.5f);
let _e719 = select(-0.5f, _e690, (_e690 > -0.5f));
let _e721 = select(_e717, _e719, (_e719 < _e717));
let _e726 = global_1.member.member_6.member_3.member_2;
let _e727 = (_e726 - 0.5f);
let _e729 = select(-0.5f, _e696, (_e696 > -0.5f));
let _e731 = select(_e727, _e729, (_e729 < _e727));
let _e737 = bitcast<f32>((bitcast<u32>((_e684 - ((((_e628.member * _e313) + (_e628.member_1 * _e322)) + (_e628.member_2 * _e295)) + _e641))) & 2147483647u));
let _e740 = bitcast<f32>((bitcast<u32>((_e690 - ((((_e646.member * _e313) + (_e646.member_1 * _e322)) + (_e646.member_2 * _e295)) + _e659))) & 2147483647u));
let _e742 = select(_e740, _e737, (_e737 > _e740));
let _e745 = bitcast<f32>((bitcast<u32>((_e696 - ((((_e664.member * _e313) + (_e664.member_1 * _e322)) + (_e664.member_2 * _e295)) + _e677))) & 2147483647u));
let _e754 = bitcast<f32>((bitcast<u32>((_e684 - _e711)) & 2147483647u));
let _e757 = bitcast<f32>((bitcast<u32>((_e690 - _e721)) & 2147483647u));
let _e759 = select(_e757, _e754, (_e754 > _e757));
let _e762 = bitcast<f32>((bitcast<u32>((_e696 - _e731)) & 2147483647u));
let _e766 = (_e711 + 0.5f);
let _e767 = (_e706 - 1f);
let _e769 = select(0f, _e766, (_e766 > 0f));
let _e771 = select(_e767, _e769, (_e769 < _e767));
let _e778 = select(0i, select(select(i32(_e771), i32(-2147483648), (_e771 < -2147483600f)), 2147483647i, (_e771 > 2147483500f)), (_e771 == _e771));
let _e787 = global_1.member.member_6.member_7[3u];
let _e788 = (_e787 & 31i);
let _e791 = (_e721 + 0.5f);
let _e792 = (_e716 - 1f);
let _e794 = select(0f, _e791, (_e791 > 0f));
let _e796 = select(_e792, _e794, (_e794 < _e792));
let _e803 = select(0i, select(select(i32(_e796), i32(-2147483648), (_e796 < -2147483600f)), 2147483647i, (_e796 > 2147483500f)), (_e796 == _e796));
let _e810 = (_e731 + 0.5f);
let _e811 = (_e726 - 1f);
let _e813 = select(0f, _e810, (_e810 > 0f));
let _e815 = select(_e811, _e813, (_e813 < _e811));
let _e822 = select(0i, select(select(i32(_e815), i32(-2147483648), (_e815 < -2147483600f)), 2147483647i, (_e815 > 2147483500f)), (_e815 == _e815));
let _e833 = global_1.member.member_6.member_6[3u];
let _e839 = global_1.member.member_6.member_6[0u];
let _e844 = global_1.member.member_6.member_6[1u];
let _e848 = ((_e833 + ((_e778 - select(0i, 1i, (_e771 < f32(_e778)))) >> bitcast<u32>(_e788))) + (_e839 * (((_e803 - select(0i, 1i, (_e796 < f32(_e803)))) >> bitcast<u32>(_e788)) + (_e844 * ((_e822 - select(0i, 1i, (_e815 < f32(_e822)))) >> bitcast<u32>(_e788))))));
let _e850 = select(_e613, _e848, (_e848 < _e613));
let _e856 = global_3.member[bitcast<u32>(select(0i, _e850, (_e850 > 0i)))];
let _e863 = global_1.member.member[3u];
let _e870 = (((_e863 & 64u) != 0u) || ((((select(_e508, _e505, (_e505 > _e508)) <= _e464) && ((select(_e525, _e522, (_e522 > _e525)) > _e464) || (_e621 != 0u))) && ((select(_e745, _e742, (_e742 > _e745)) <= _e701) && ((select(_e762, _e759, (_e759 > _e762)) > _e701) || (_e856 != 0u)))) && ((_e863 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e267 == 0f) && (_e274 == 0f)) && (_e376 == 0f)) && (_e379 == 0f))), _e870), (_e248 == 0f)) > 1u) {
let _e878 = global_1.member.member[2u];
if _e286 {
break;
}
if _e286 {
break;
}
let _e880 = (_e878 == 2u);
let _e883 = (((_e878 == 1u) || _e880) || (_e878 == 5u));
if _e883 {
let _e1134 = select(-1f, _e474, (_e474 > -1f));
let _e1136 = select(_e469, _e1134, (_e1134 < _e469));
let _e1143 = select(0i, select(select(i32(_e1136), i32(-2147483648), (_e1136 < -2147483600f)), 2147483647i, (_e1136 > 2147483500f)), (_e1136 == _e1136));
let _e1147 = (_e1143 - select(0i, 1i, (_e1136 < f32(_e1143))));
let _e1149 = select(-1f, _e484, (_e484 > -1f));
let _e1151 = select(_e479, _e1149, (_e1149 < _e479));
let _e1158 = select(0i, select(select(i32(_e1151), i32(-2147483648), (_e1151 < -2147483600f)), 2147483647i, (_e1151 > 2147483500f)), (_e1151 == _e1151));
let _e1162 = (_e1158 - select(0i, 1i, (_e1151 < f32(_e1158))));
let _e1164 = select(-1f, _e494, (_e494 > -1f));
let _e1166 = select(_e489, _e1164, (_e1164 < _e489));
let _e1173 = select(0i, select(select(i32(_e1166), i32(-2147483648), (_e1166 < -2147483600f)), 2147483647i, (_e1166 > 2147483500f)), (_e1166 == _e1166));
let _e1177 = (_e1173 - select(0i, 1i, (_e1166 < f32(_e1173))));
let _e1182 = global_1.member.member_5.member_5[0u];
let _e1187 = global_1.member.member_5.member_5[1u];
let _e1188 = (_e1147 + 1i);
let _e1189 = (_e1162 + 1i);
let _e1190 = (_e1177 + 1i);
let _e1197 = global_1.member.member_5.member_7[0u];
let _e1204 = global_1.member.member_5.member_7[1u];
let _e1210 = ((_e1188 >> bitcast<u32>(4i)) + (_e1197 * ((_e1189 >> bitcast<u32>(4i)) + (_e1204 * (_e1190 >> bitcast<u32>(4i))))));
let _e1212 = (bitcast<i32>(_e93) - 1i);
let _e1214 = select(_e1212, _e1210, (_e1210 < _e1212));
let _e1220 = global_2.member[bitcast<u32>(select(0i, _e1214, (_e1214 > 0i)))];
let _e1222 = (_e1188 & 15i);
let _e1225 = ((_e1189 & 15i) * _e1182);
let _e1227 = (bitcast<i32>(_e1220) + ((_e1190 & 15i) * _e1187));
let _e1231 = (_e1225 + _e1182);
let _e1233 = (_e1225 + (2i * _e1182));
let _e1234 = (_e1227 + _e1187);
let _e1236 = (_e1227 + (2i * _e1187));
local_6 = type_18(array<i32, 4>(_e1222, (_e1222 + 1i), (_e1222 + 2i), (_e1222 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = vec3<f32>((_e474 - f32(_e1147)), (_e484 - f32(_e1162)), (_e494 - f32(_e1177)));
let _e1247 = (_e1234 + _e1231);
let _e1250 = local_6.member[1u];
let _e1251 = (_e1247 + _e1250);
let _e1253 = select(_e1212, _e1251, (_e1251 < _e1212));
let _e1258 = global_2.member[bitcast<u32>(select(0i, _e1253, (_e1253 > 0i)))];
let _e1259 = bitcast<f32>(_e1258);
let _e1262 = local_6.member[2u];
let _e1263 = (_e1247 + _e1262);
let _e1265 = select(_e1212, _e1263, (_e1263 < _e1212));
let _e1270 = global_2.member[bitcast<u32>(select(0i, _e1265, (_e1265 > 0i)))];
let _e1272 = local_7[0u];
let _e1275 = (_e1259 + ((bitcast<f32>(_e1270) - _e1259) * _e1272));
let _e1276 = (_e1234 + _e1233);
let _e1277 = local_6.member[1u];
let _e1278 = (_e1276 + _e1277);
let _e1280 = select(_e1212, _e1278, (_e1278 < _e1212));
let _e1285 = global_2.member[bitcast<u32>(select(0i, _e1280, (_e1280 > 0i)))];
let _e1286 = bitcast<f32>(_e1285);
let _e1287 = local_6.member[2u];
let _e1288 = (_e1276 + _e1287);
let _e1290 = select(_e1212, _e1288, (_e1288 < _e1212));
let _e1295 = global_2.member[bitcast<u32>(select(0i, _e1290, (_e1290 > 0i)))];
let _e1297 = local_7[0u];
let _e1301 = (_e1236 + _e1231);
let _e1302 = local_6.member[1u];
let _e1303 = (_e1301 + _e1302);
let _e1305 = select(_e1212, _e1303, (_e1303 < _e1212));
let _e1310 = global_2.member[bitcast<u32>(select(0i, _e1305, (_e1305 > 0i)))];
let _e1311 = bitcast<f32>(_e1310);
let _e1312 = local_6.member[2u];
let _e1313 = (_e1301 + _e1312);
let _e1315 = select(_e1212, _e1313, (_e1313 < _e1212));
let _e1320 = global_2.member[bitcast<u32>(select(0i, _e1315, (_e1315 > 0i)))];
let _e1322 = local_7[0u];
let _e1325 = (_e1311 + ((bitcast<f32>(_e1320) - _e1311) * _e1322));
let _e1326 = (_e1236 + _e1233);
let _e1327 = local_6.member[1u];
let _e1328 = (_e1326 + _e1327);
let _e1330 = select(_e1212, _e1328, (_e1328 < _e1212));
let _e1335 = global_2.member[bitcast<u32>(select(0i, _e1330, (_e1330 > 0i)))];
let _e1336 = bitcast<f32>(_e1335);
let _e1337 = local_6.member[2u];
let _e1338 = (_e1326 + _e1337);
let _e1340 = select(_e1212, _e1338, (_e1338 < _e1212));
let _e1345 = global_2.member[bitcast<u32>(select(0i, _e1340, (_e1340 > 0i)))];
let _e1347 = local_7[0u];
let _e1352 = local_7[1u];
let _e1355 = (_e1275 + (((_e1286 + ((bitcast<f32>(_e1295) - _e1286) * _e1297)) - _e1275) * _e1352));
let _e1356 = local_7[1u];
let _e1361 = local_7[2u];
let _e1369 = global_1.member.member_5.member_4.member;
let _e1375 = global_1.member.member_5.member_4.member_1;
let _e1376 = (((_e1355 + (((_e1325 + (((_e1336 + ((bitcast<f32>(_e1345) - _e1336) * _e1347)) - _e1325) * _e1356)) - _e1355) * _e1361)) * _e1369) + _e1375);
let _e1378 = select(0f, _e1376, (_e1376 > 0f));
let _e1382 = select(-1f, _e711, (_e711 > -1f));
let _e1384 = select(_e706, _e1382, (_e1382 < _e706));
let _e1391 = select(0i, select(select(i32(_e1384), i32(-2147483648), (_e1384 < -2147483600f)), 2147483647i, (_e1384 > 2147483500f)), (_e1384 == _e1384));
let _e1395 = (_e1391 - select(0i, 1i, (_e1384 < f32(_e1391))));
let _e1397 = select(-1f, _e721, (_e721 > -1f));
let _e1399 = select(_e716, _e1397, (_e1397 < _e716));
let _e1406 = select(0i, select(select(i32(_e1399), i32(-2147483648), (_e1399 < -2147483600f)), 2147483647i, (_e1399 > 2147483500f)), (_e1399 == _e1399));
let _e1410 = (_e1406 - select(0i, 1i, (_e1399 < f32(_e1406))));
let _e1412 = select(-1f, _e731, (_e731 > -1f));
let _e1414 = select(_e726, _e1412, (_e1412 < _e726));
let _e1421 = select(0i, select(select(i32(_e1414), i32(-2147483648), (_e1414 < -2147483600f)), 2147483647i, (_e1414 > 2147483500f)), (_e1414 == _e1414));
let _e1425 = (_e1421 - select(0i, 1i, (_e1414 < f32(_e1421))));
let _e1430 = global_1.member.member_6.member_5[0u];
let _e1435 = global_1.member.member_6.member_5[1u];
let _e1436 = (_e1395 + 1i);
let _e1437 = (_e1410 + 1i);
let _e1438 = (_e1425 + 1i);
let _e1445 = global_1.member.member_6.member_7[0u];
let _e1452 = global_1.member.member_6.member_7[1u];
let _e1458 = ((_e1436 >> bitcast<u32>(4i)) + (_e1445 * ((_e1437 >> bitcast<u32>(4i)) + (_e1452 * (_e1438 >> bitcast<u32>(4i))))));
let _e1460 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1462 = select(_e1460, _e1458, (_e1458 < _e1460));
let _e1468 = global_7.member[bitcast<u32>(select(0i, _e1462, (_e1462 > 0i)))];
let _e1470 = (_e1436 & 15i);
let _e1473 = ((_e1437 & 15i) * _e1430);
let _e1475 = (bitcast<i32>(_e1468) + ((_e1438 & 15i) * _e1435));
let _e1479 = (_e1473 + _e1430);
let _e1481 = (_e1473 + (2i * _e1430));
let _e1483 = (_e1473 + (3i * _e1430));
let _e1484 = (_e1475 + _e1435);
let _e1486 = (_e1475 + (2i * _e1435));
let _e1488 = (_e1475 + (3i * _e1435));
local_4 = type_18(array<i32, 4>(_e1470, (_e1470 + 1i), (_e1470 + 2i), (_e1470 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e711 - f32(_e1395)), (_e721 - f32(_e1410)), (_e731 - f32(_e1425)));
let _e1499 = (_e1484 + _e1479);
let _e1502 = local_4.member[0u];
let _e1503 = (_e1499 + _e1502);
let _e1505 = select(_e1460, _e1503, (_e1503 < _e1460));
let _e1510 = global_7.member[bitcast<u32>(select(0i, _e1505, (_e1505 > 0i)))];
let _e1511 = bitcast<f32>(_e1510);
let _e1514 = local_4.member[1u];
let _e1515 = (_e1499 + _e1514);
let _e1517 = select(_e1460, _e1515, (_e1515 < _e1460));
let _e1522 = global_7.member[bitcast<u32>(select(0i, _e1517, (_e1517 > 0i)))];
let _e1523 = bitcast<f32>(_e1522);
let _e1526 = local_4.member[2u];
let _e1527 = (_e1499 + _e1526);
let _e1529 = select(_e1460, _e1527, (_e1527 < _e1460));
let _e1534 = global_7.member[bitcast<u32>(select(0i, _e1529, (_e1529 > 0i)))];
let _e1535 = bitcast<f32>(_e1534);
let _e1538 = local_4.member[3u];
let _e1539 = (_e1499 + _e1538);
let _e1541 = select(_e1460, _e1539, (_e1539 < _e1460));
let _e1546 = global_7.member[bitcast<u32>(select(0i, _e1541, (_e1541 > 0i)))];
let _e1548 = local_5[0u];
let _e1551 = (_e1511 + ((_e1523 - _e1511) * _e1548));
let _e1552 = local_5[0u];
let _e1555 = (_e1523 + ((_e1535 - _e1523) * _e1552));
let _e1556 = local_5[0u];
let _e1559 = (_e1535 + ((bitcast<f32>(_e1546) - _e1535) * _e1556));
let _e1560 = (_e1484 + _e1481);
let _e1561 = local_4.member[0u];
let _e1562 = (_e1560 + _e1561);
let _e1564 = select(_e1460, _e1562, (_e1562 < _e1460));
let _e1569 = global_7.member[bitcast<u32>(select(0i, _e1564, (_e1564 > 0i)))];
let _e1570 = bitcast<f32>(_e1569);
let _e1571 = local_4.member[1u];
let _e1572 = (_e1560 + _e1571);
let _e1574 = select(_e1460, _e1572, (_e1572 < _e1460));
let _e1579 = global_7.member[bitcast<u32>(select(0i, _e1574, (_e1574 > 0i)))];
let _e1580 = bitcast<f32>(_e1579);
let _e1581 = local_4.member[2u];
let _e1582 = (_e1560 + _e1581);
let _e1584 = select(_e1460, _e1582, (_e1582 < _e1460));
let _e1589 = global_7.member[bitcast<u32>(select(0i, _e1584, (_e1584 > 0i)))];
let _e1590 = bitcast<f32>(_e1589);
let _e1591 = local_4.member[3u];
let _e1592 = (_e1560 + _e1591);
let _e1594 = select(_e1460, _e1592, (_e1592 < _e1460));
let _e1599 = global_7.member[bitcast<u32>(select(0i, _e1594, (_e1594 > 0i)))];
let _e1601 = local_5[0u];
let _e1605 = local_5[0u];
let _e1608 = (_e1580 + ((_e1590 - _e1580) * _e1605));
let _e1609 = local_5[0u];
let _e1613 = (_e1486 + _e1479);
let _e1614 = local_4.member[0u];
let _e1615 = (_e1613 + _e1614);
let _e1617 = select(_e1460, _e1615, (_e1615 < _e1460));
let _e1622 = global_7.member[bitcast<u32>(select(0i, _e1617, (_e1617 > 0i)))];
let _e1623 = bitcast<f32>(_e1622);
let _e1624 = local_4.member[1u];
let _e1625 = (_e1613 + _e1624);
let _e1627 = select(_e1460, _e1625, (_e1625 < _e1460));
let _e1632 = global_7.member[bitcast<u32>(select(0i, _e1627, (_e1627 > 0i)))];
let _e1633 = bitcast<f32>(_e1632);
let _e1634 = local_4.member[2u];
let _e1635 = (_e1613 + _e1634);
let _e1637 = select(_e1460, _e1635, (_e1635 < _e1460));
let _e1642 = global_7.member[bitcast<u32>(select(0i, _e1637, (_e1637 > 0i)))];
let _e1643 = bitcast<f32>(_e1642);
let _e1644 = local_4.member[3u];
let _e1645 = (_e1613 + _e1644);
let _e1647 = select(_e1460, _e1645, (_e1645 < _e1460));
let _e1652 = global_7.member[bitcast<u32>(select(0i, _e1647, (_e1647 > 0i)))];
let _e1654 = local_5[0u];
let _e1657 = (_e1623 + ((_e1633 - _e1623) * _e1654));
let _e1658 = local_5[0u];
let _e1661 = (_e1633 + ((_e1643 - _e1633) * _e1658));
let _e1662 = local_5[0u];
let _e1665 = (_e1643 + ((bitcast<f32>(_e1652) - _e1643) * _e1662));
let _e1666 = (_e1486 + _e1481);
let _e1667 = local_4.member[0u];
let _e1668 = (_e1666 + _e1667);
let _e1670 = select(_e1460, _e1668, (_e1668 < _e1460));
let _e1675 = global_7.member[bitcast<u32>(select(0i, _e1670, (_e1670 > 0i)))];
let _e1676 = bitcast<f32>(_e1675);
let _e1677 = local_4.member[1u];
let _e1678 = (_e1666 + _e1677);
let _e1680 = select(_e1460, _e1678, (_e1678 < _e1460));
let _e1685 = global_7.member[bitcast<u32>(select(0i, _e1680, (_e1680 > 0i)))];
let _e1686 = bitcast<f32>(_e1685);
let _e1687 = local_4.member[2u];
let _e1688 = (_e1666 + _e1687);
let _e1690 = select(_e1460, _e1688, (_e1688 < _e1460));
let _e1695 = global_7.member[bitcast<u32>(select(0i, _e1690, (_e1690 > 0i)))];
let _e1696 = bitcast<f32>(_e1695);
let _e1697 = local_4.member[3u];
let _e1698 = (_e1666 + _e1697);
let _e1700 = select(_e1460, _e1698, (_e1698 < _e1460));
let _e1705 = global_7.member[bitcast<u32>(select(0i, _e1700, (_e1700 > 0i)))];
let _e1707 = local_5[0u];
let _e1711 = local_5[0u];
let _e1714 = (_e1686 + ((_e1696 - _e1686) * _e1711));
let _e1715 = local_5[0u];
let _e1719 = (_e1484 + _e1473);
let _e1720 = local_4.member[1u];
let _e1721 = (_e1719 + _e1720);
let _e1723 = select(_e1460, _e1721, (_e1721 < _e1460));
let _e1728 = global_7.member[bitcast<u32>(select(0i, _e1723, (_e1723 > 0i)))];
let _e1729 = bitcast<f32>(_e1728);
let _e1730 = local_4.member[2u];
let _e1731 = (_e1719 + _e1730);
let _e1733 = select(_e1460, _e1731, (_e1731 < _e1460));
let _e1738 = global_7.member[bitcast<u32>(select(0i, _e1733, (_e1733 > 0i)))];
let _e1740 = local_5[0u];
let _e1743 = (_e1729 + ((bitcast<f32>(_e1738) - _e1729) * _e1740));
let _e1744 = (_e1484 + _e1483);
let _e1745 = local_4.member[1u];
let _e1746 = (_e1744 + _e1745);
let _e1748 = select(_e1460, _e1746, (_e1746 < _e1460));
let _e1753 = global_7.member[bitcast<u32>(select(0i, _e1748, (_e1748 > 0i)))];
let _e1754 = bitcast<f32>(_e1753);
let _e1755 = local_4.member[2u];
let _e1756 = (_e1744 + _e1755);
let _e1758 = select(_e1460, _e1756, (_e1756 < _e1460));
let _e1763 = global_7.member[bitcast<u32>(select(0i, _e1758, (_e1758 > 0i)))];
let _e1765 = local_5[0u];
let _e1769 = (_e1486 + _e1473);
let _e1770 = local_4.member[1u];
let _e1771 = (_e1769 + _e1770);
let _e1773 = select(_e1460, _e1771, (_e1771 < _e1460));
let _e1778 = global_7.member[bitcast<u32>(select(0i, _e1773, (_e1773 > 0i)))];
let _e1779 = bitcast<f32>(_e1778);
let _e1780 = local_4.member[2u];
let _e1781 = (_e1769 + _e1780);
let _e1783 = select(_e1460, _e1781, (_e1781 < _e1460));
let _e1788 = global_7.member[bitcast<u32>(select(0i, _e1783, (_e1783 > 0i)))];
let _e1790 = local_5[0u];
let _e1793 = (_e1779 + ((bitcast<f32>(_e1788) - _e1779) * _e1790));
let _e1794 = (_e1486 + _e1483);
let _e1795 = local_4.member[1u];
let _e1796 = (_e1794 + _e1795);
let _e1798 = select(_e1460, _e1796, (_e1796 < _e1460));
let _e1803 = global_7.member[bitcast<u32>(select(0i, _e1798, (_e1798 > 0i)))];
let _e1804 = bitcast<f32>(_e1803);
let _e1805 = local_4.member[2u];
let _e1806 = (_e1794 + _e1805);
let _e1808 = select(_e1460, _e1806, (_e1806 < _e1460));
let _e1813 = global_7.member[bitcast<u32>(select(0i, _e1808, (_e1808 > 0i)))];
let _e1815 = local_5[0u];
let _e1819 = (_e1475 + _e1479);
let _e1820 = local_4.member[1u];
let _e1821 = (_e1819 + _e1820);
let _e1823 = select(_e1460, _e1821, (_e1821 < _e1460));
let _e1828 = global_7.member[bitcast<u32>(select(0i, _e1823, (_e1823 > 0i)))];
let _e1829 = bitcast<f32>(_e1828);
let _e1830 = local_4.member[2u];
let _e1831 = (_e1819 + _e1830);
let _e1833 = select(_e1460, _e1831, (_e1831 < _e1460));
let _e1838 = global_7.member[bitcast<u32>(select(0i, _e1833, (_e1833 > 0i)))];
let _e1840 = local_5[0u];
let _e1843 = (_e1829 + ((bitcast<f32>(_e1838) - _e1829) * _e1840));
let _e1844 = (_e1488 + _e1479);
let _e1845 = local_4.member[1u];
let _e1846 = (_e1844 + _e1845);
let _e1848 = select(_e1460, _e1846, (_e1846 < _e1460));
let _e1853 = global_7.member[bitcast<u32>(select(0i, _e1848, (_e1848 > 0i)))];
let _e1854 = bitcast<f32>(_e1853);
let _e1855 = local_4.member[2u];
let _e1856 = (_e1844 + _e1855);
let _e1858 = select(_e1460, _e1856, (_e1856 < _e1460));
let _e1863 = global_7.member[bitcast<u32>(select(0i, _e1858, (_e1858 > 0i)))];
let _e1865 = local_5[0u];
let _e1868 = (_e1854 + ((bitcast<f32>(_e1863) - _e1854) * _e1865));
let _e1869 = (_e1475 + _e1481);
let _e1870 = local_4.member[1u];
let _e1871 = (_e1869 + _e1870);
let _e1873 = select(_e1460, _e1871, (_e1871 < _e1460));
let _e1878 = global_7.member[bitcast<u32>(select(0i, _e1873, (_e1873 > 0i)))];
let _e1879 = bitcast<f32>(_e1878);
let _e1880 = local_4.member[2u];
let _e1881 = (_e1869 + _e1880);
let _e1883 = select(_e1460, _e1881, (_e1881 < _e1460));
let _e1888 = global_7.member[bitcast<u32>(select(0i, _e1883, (_e1883 > 0i)))];
let _e1890 = local_5[0u];
let _e1894 = (_e1488 + _e1481);
let _e1895 = local_4.member[1u];
let _e1896 = (_e1894 + _e1895);
let _e1898 = select(_e1460, _e1896, (_e1896 < _e1460));
let _e1903 = global_7.member[bitcast<u32>(select(0i, _e1898, (_e1898 > 0i)))];
let _e1904 = bitcast<f32>(_e1903);
let _e1905 = local_4.member[2u];
let _e1906 = (_e1894 + _e1905);
let _e1908 = select(_e1460, _e1906, (_e1906 < _e1460));
let _e1913 = global_7.member[bitcast<u32>(select(0i, _e1908, (_e1908 > 0i)))];
let _e1915 = local_5[0u];
let _e1920 = local_5[1u];
let _e1923 = (_e1555 + ((_e1608 - _e1555) * _e1920));
let _e1924 = local_5[1u];
let _e1927 = (_e1661 + ((_e1714 - _e1661) * _e1924));
let _e1928 = local_5[1u];
let _e1931 = (_e1551 + (((_e1570 + ((_e1580 - _e1570) * _e1601)) - _e1551) * _e1928));
let _e1932 = local_5[1u];
let _e1937 = local_5[2u];
let _e1941 = local_5[1u];
let _e1944 = (_e1559 + (((_e1590 + ((bitcast<f32>(_e1599) - _e1590) * _e1609)) - _e1559) * _e1941));
let _e1945 = local_5[1u];
let _e1949 = local_5[2u];
let _e1953 = local_5[1u];
let _e1956 = (_e1743 + ((_e1555 - _e1743) * _e1953));
let _e1957 = local_5[1u];
let _e1961 = local_5[2u];
let _e1965 = local_5[1u];
let _e1968 = (_e1608 + (((_e1754 + ((bitcast<f32>(_e1763) - _e1754) * _e1765)) - _e1608) * _e1965));
let _e1969 = local_5[1u];
let _e1973 = local_5[2u];
let _e1977 = local_5[1u];
let _e1980 = (_e1843 + (((_e1879 + ((bitcast<f32>(_e1888) - _e1879) * _e1890)) - _e1843) * _e1977));
let _e1981 = local_5[2u];
let _e1985 = local_5[1u];
let _e1989 = local_5[2u];
let _e1993 = local_5[2u];
let _e2001 = global_1.member.member_6.member_4.member;
let _e2007 = global_1.member.member_6.member_4.member_1;
let _e2008 = (((_e1923 + ((_e1927 - _e1923) * _e1993)) * _e2001) + _e2007);
let _e2010 = select(0f, _e2008, (_e2008 > 0f));
let _e2014 = (((_e1931 + (((_e1657 + (((_e1676 + ((_e1686 - _e1676) * _e1707)) - _e1657) * _e1932)) - _e1931) * _e1937)) * _e2001) + _e2007);
let _e2016 = select(0f, _e2014, (_e2014 > 0f));
let _e2018 = select(1f, _e2016, (_e2016 < 1f));
let _e2020 = (((_e1944 + (((_e1665 + (((_e1696 + ((bitcast<f32>(_e1705) - _e1696) * _e1715)) - _e1665) * _e1945)) - _e1944) * _e1949)) * _e2001) + _e2007);
let _e2022 = select(0f, _e2020, (_e2020 > 0f));
let _e2024 = select(1f, _e2022, (_e2022 < 1f));
let _e2026 = (((_e1956 + (((_e1793 + ((_e1661 - _e1793) * _e1957)) - _e1956) * _e1961)) * _e2001) + _e2007);
let _e2028 = select(0f, _e2026, (_e2026 > 0f));
let _e2030 = select(1f, _e2028, (_e2028 < 1f));
let _e2032 = (((_e1968 + (((_e1714 + (((_e1804 + ((bitcast<f32>(_e1813) - _e1804) * _e1815)) - _e1714) * _e1969)) - _e1968) * _e1973)) * _e2001) + _e2007);
let _e2034 = select(0f, _e2032, (_e2032 > 0f));
let _e2036 = select(1f, _e2034, (_e2034 < 1f));
let _e2038 = (((_e1980 + ((_e1923 - _e1980) * _e1981)) * _e2001) + _e2007);
let _e2040 = select(0f, _e2038, (_e2038 > 0f));
let _e2042 = select(1f, _e2040, (_e2040 < 1f));
let _e2044 = (((_e1927 + (((_e1868 + (((_e1904 + ((bitcast<f32>(_e1913) - _e1904) * _e1915)) - _e1868) * _e1985)) - _e1927) * _e1989)) * _e2001) + _e2007);
let _e2046 = select(0f, _e2044, (_e2044 > 0f));
let _e2048 = select(1f, _e2046, (_e2046 < 1f));
let _e2049 = (select(1f, _e2010, (_e2010 < 1f)) * 1024f);
let _e2050 = (1024f - 1f);
let _e2052 = select(0f, _e2049, (_e2049 > 0f));
let _e2054 = select(_e2050, _e2052, (_e2052 < _e2050));
let _e2061 = select(0i, select(select(i32(_e2054), i32(-2147483648), (_e2054 < -2147483600f)), 2147483647i, (_e2054 > 2147483500f)), (_e2054 == _e2054));
let _e2065 = (_e2061 - select(0i, 1i, (_e2054 < f32(_e2061))));
let _e2066 = (262147i + _e2065);
let _e2068 = (bitcast<i32>(_e100) - 1i);
let _e2070 = select(_e2068, _e2066, (_e2066 < _e2068));
let _e2076 = global_4.member[bitcast<u32>(select(0i, _e2070, (_e2070 > 0i)))];
let _e2086 = select(_e2068, 262146i, (262146i < _e2068));
let _e2092 = global_4.member[bitcast<u32>(select(0i, _e2086, (_e2086 > 0i)))];
let _e2093 = bitcast<f32>(_e2092);
let _e2094 = (f32((bitcast<i32>((_e2076 & 4095u)) - 2048i)) * _e2093);
let _e2096 = select(_e2068, 262144i, (262144i < _e2068));
let _e2102 = global_4.member[bitcast<u32>(select(0i, _e2096, (_e2096 > 0i)))];
let _e2103 = bitcast<f32>(_e2102);
let _e2105 = select(_e2068, 262145i, (262145i < _e2068));
let _e2111 = global_4.member[bitcast<u32>(select(0i, _e2105, (_e2105 > 0i)))];
let _e2112 = bitcast<f32>(_e2111);
let _e2118 = ((_e2103 + (f32(bitcast<i32>((_e2076 >> bitcast<u32>(12u)))) * _e2112)) + (_e2094 * (_e2049 - f32(_e2065))));
let _e2119 = (_e2094 * 1024f);
if _e880 {
let _e2384 = ((0.5f * (_e2024 - _e2018)) * _e2119);
let _e2385 = ((0.5f * (_e2036 - _e2030)) * _e2119);
let _e2386 = ((0.5f * (_e2048 - _e2042)) * _e2119);
phi_9856_ = type_19(_e2118, vec3<f32>(_e2384, _e2385, _e2386), vec3<f32>((_e2384 * _e2118), (_e2385 * _e2118), (_e2386 * _e2118)));
} else {
let _e2120 = (_e2018 * 1024f);
let _e2122 = select(0f, _e2120, (_e2120 > 0f));
let _e2124 = select(_e2050, _e2122, (_e2122 < _e2050));
let _e2131 = select(0i, select(select(i32(_e2124), i32(-2147483648), (_e2124 < -2147483600f)), 2147483647i, (_e2124 > 2147483500f)), (_e2124 == _e2124));
let _e2135 = (_e2131 - select(0i, 1i, (_e2124 < f32(_e2131))));
let _e2136 = (262147i + _e2135);
let _e2138 = select(_e2068, _e2136, (_e2136 < _e2068));
let _e2144 = global_4.member[bitcast<u32>(select(0i, _e2138, (_e2138 > 0i)))];
let _e2159 = ((_e2103 + (f32(bitcast<i32>((_e2144 >> bitcast<u32>(12u)))) * _e2112)) + ((f32((bitcast<i32>((_e2144 & 4095u)) - 2048i)) * _e2093) * (_e2120 - f32(_e2135))));
let _e2160 = (_e2024 * 1024f);
let _e2162 = select(0f, _e2160, (_e2160 > 0f));
let _e2164 = select(_e2050, _e2162, (_e2162 < _e2050));
let _e2171 = select(0i, select(select(i32(_e2164), i32(-2147483648), (_e2164 < -2147483600f)), 2147483647i, (_e2164 > 2147483500f)), (_e2164 == _e2164));
let _e2175 = (_e2171 - select(0i, 1i, (_e2164 < f32(_e2171))));
let _e2176 = (262147i + _e2175);
let _e2178 = select(_e2068, _e2176, (_e2176 < _e2068));
let _e2184 = global_4.member[bitcast<u32>(select(0i, _e2178, (_e2178 > 0i)))];
let _e2199 = ((_e2103 + (f32(bitcast<i32>((_e2184 >> bitcast<u32>(12u)))) * _e2112)) + ((f32((bitcast<i32>((_e2184 & 4095u)) - 2048i)) * _e2093) * (_e2160 - f32(_e2175))));
let _e2200 = (_e2030 * 1024f);
let _e2202 = select(0f, _e2200, (_e2200 > 0f));
let _e2204 = select(_e2050, _e2202, (_e2202 < _e2050));
let _e2211 = select(0i, select(select(i32(_e2204), i32(-2147483648), (_e2204 < -2147483600f)), 2147483647i, (_e2204 > 2147483500f)), (_e2204 == _e2204));
let _e2215 = (_e2211 - select(0i, 1i, (_e2204 < f32(_e2211))));
let _e2216 = (262147i + _e2215);
let _e2218 = select(_e2068, _e2216, (_e2216 < _e2068));
let _e2224 = global_4.member[bitcast<u32>(select(0i, _e2218, (_e2218 > 0i)))];
let _e2239 = ((_e2103 + (f32(bitcast<i32>((_e2224 >> bitcast<u32>(12u)))) * _e2112)) + ((f32((bitcast<i32>((_e2224 & 4095u)) - 2048i)) * _e2093) * (_e2200 - f32(_e2215))));
let _e2240 = (_e2036 * 1024f);
let _e2242 = select(0f, _e2240, (_e2240 > 0f));
let _e2244 = select(_e2050, _e2242, (_e2242 < _e2050));
let _e2251 = select(0i, select(select(i32(_e2244), i32(-2147483648), (_e2244 < -2147483600f)), 2147483647i, (_e2244 > 2147483500f)), (_e2244 == _e2244));
let _e2255 = (_e2251 - select(0i, 1i, (_e2244 < f32(_e2251))));
let _e2256 = (262147i + _e2255);
let _e2258 = select(_e2068, _e2256, (_e2256 < _e2068));
let _e2264 = global_4.member[bitcast<u32>(select(0i, _e2258, (_e2258 > 0i)))];
let _e2279 = ((_e2103 + (f32(bitcast<i32>((_e2264 >> bitcast<u32>(12u)))) * _e2112)) + ((f32((bitcast<i32>((_e2264 & 4095u)) - 2048i)) * _e2093) * (_e2240 - f32(_e2255))));
let _e2280 = (_e2042 * 1024f);
let _e2282 = select(0f, _e2280, (_e2280 > 0f));
let _e2284 = select(_e2050, _e2282, (_e2282 < _e2050));
let _e2291 = select(0i, select(select(i32(_e2284), i32(-2147483648), (_e2284 < -2147483600f)), 2147483647i, (_e2284 > 2147483500f)), (_e2284 == _e2284));
let _e2295 = (_e2291 - select(0i, 1i, (_e2284 < f32(_e2291))));
let _e2296 = (262147i + _e2295);
let _e2298 = select(_e2068, _e2296, (_e2296 < _e2068));
let _e2304 = global_4.member[bitcast<u32>(select(0i, _e2298, (_e2298 > 0i)))];
let _e2319 = ((_e2103 + (f32(bitcast<i32>((_e2304 >> bitcast<u32>(12u)))) * _e2112)) + ((f32((bitcast<i32>((_e2304 & 4095u)) - 2048i)) * _e2093) * (_e2280 - f32(_e2295))));
let _e2320 = (_e2048 * 1024f);
let _e2322 = select(0f, _e2320, (_e2320 > 0f));
let _e2324 = select(_e2050, _e2322, (_e2322 < _e2050));
let _e2331 = select(0i, select(select(i32(_e2324), i32(-2147483648), (_e2324 < -2147483600f)), 2147483647i, (_e2324 > 2147483500f)), (_e2324 == _e2324));
let _e2335 = (_e2331 - select(0i, 1i, (_e2324 < f32(_e2331))));
let _e2336 = (262147i + _e2335);
let _e2338 = select(_e2068, _e2336, (_e2336 < _e2068));
let _e2344 = global_4.member[bitcast<u32>(select(0i, _e2338, (_e2338 > 0i)))];
let _e2359 = ((_e2103 + (f32(bitcast<i32>((_e2344 >> bitcast<u32>(12u)))) * _e2112)) + ((f32((bitcast<i32>((_e2344 & 4095u)) - 2048i)) * _e2093) * (_e2320 - f32(_e2335))));
let _e2360 = (_e2199 - _e2159);
let _e2362 = (_e2279 - _e2239);
let _e2364 = (_e2359 - _e2319);
phi_9856_ = type_19(_e2118, vec3<f32>((0.5f * _e2360), (0.5f * _e2362), (0.5f * _e2364)), vec3<f32>((0.25f * (_e2360 * (_e2199 + _e2159))), (0.25f * (_e2362 * (_e2279 + _e2239))), (0.25f * (_e2364 * (_e2359 + _e2319)))));
}
let _e2394 = phi_9856_;
let _e2409 = select(0f, 1f, ((((((_e684 >= -0.5f) && (_e684 <= _e707)) && (_e690 >= -0.5f)) && (_e690 <= _e717)) && (_e696 >= -0.5f)) && (_e696 <= _e727)));
let _e2411 = (0.5f * (_e2024 - _e2018));
let _e2413 = (0.5f * (_e2036 - _e2030));
let _e2415 = (0.5f * (_e2048 - _e2042));
let _e2420 = global_1.member.member_6.member.member;
let _e2426 = global_1.member.member_6.member_1.member;
let _e2433 = global_1.member.member_6.member_2.member;
let _e2440 = global_1.member.member_6.member.member_1;
let _e2446 = global_1.member.member_6.member_1.member_1;
let _e2453 = global_1.member.member_6.member_2.member_1;
let _e2460 = global_1.member.member_6.member.member_2;
let _e2466 = global_1.member.member_6.member_1.member_2;
let _e2473 = global_1.member.member_6.member_2.member_2;
phi_11176_ = type_20(select(1f, _e1378, (_e1378 < 1f)), vec3<f32>(((((_e2420 * _e2411) + (_e2426 * _e2413)) + (_e2433 * _e2415)) * _e2409), ((((_e2440 * _e2411) + (_e2446 * _e2413)) + (_e2453 * _e2415)) * _e2409), ((((_e2460 * _e2411) + (_e2466 * _e2413)) + (_e2473 * _e2415)) * _e2409)), _e2394.member, vec3<f32>(((((_e2420 * _e2394.member_2.x) + (_e2426 * _e2394.member_2.y)) + (_e2433 * _e2394.member_2.z)) * _e2409), ((((_e2440 * _e2394.member_2.x) + (_e2446 * _e2394.member_2.y)) + (_e2453 * _e2394.member_2.z)) * _e2409), ((((_e2460 * _e2394.member_2.x) + (_e2466 * _e2394.member_2.y)) + (_e2473 * _e2394.member_2.z)) * _e2409)), vec3<f32>(((((_e2420 * _e2394.member_1.x) + (_e2426 * _e2394.member_1.y)) + (_e2433 * _e2394.member_1.z)) * _e2409), ((((_e2440 * _e2394.member_1.x) + (_e2446 * _e2394.member_1.y)) + (_e2453 * _e2394.member_1.z)) * _e2409), ((((_e2460 * _e2394.member_1.x) + (_e2466 * _e2394.member_1.y)) + (_e2473 * _e2394.member_1.z)) * _e2409)));
} else {
let _e885 = select(-1f, _e474, (_e474 > -1f));
let _e887 = select(_e469, _e885, (_e885 < _e469));
let _e894 = select(0i, select(select(i32(_e887), i32(-2147483648), (_e887 < -2147483600f)), 2147483647i, (_e887 > 2147483500f)), (_e887 == _e887));
let _e898 = (_e894 - select(0i, 1i, (_e887 < f32(_e894))));
let _e900 = select(-1f, _e484, (_e484 > -1f));
let _e902 = select(_e479, _e900, (_e900 < _e479));
let _e909 = select(0i, select(select(i32(_e902), i32(-2147483648), (_e902 < -2147483600f)), 2147483647i, (_e902 > 2147483500f)), (_e902 == _e902));
let _e913 = (_e909 - select(0i, 1i, (_e902 < f32(_e909))));
let _e915 = select(-1f, _e494, (_e494 > -1f));
let _e917 = select(_e489, _e915, (_e915 < _e489));
let _e924 = select(0i, select(select(i32(_e917), i32(-2147483648), (_e917 < -2147483600f)), 2147483647i, (_e917 > 2147483500f)), (_e917 == _e917));
let _e928 = (_e924 - select(0i, 1i, (_e917 < f32(_e924))));
let _e933 = global_1.member.member_5.member_5[0u];
let _e938 = global_1.member.member_5.member_5[1u];
let _e939 = (_e898 + 1i);
let _e940 = (_e913 + 1i);
let _e941 = (_e928 + 1i);
let _e948 = global_1.member.member_5.member_7[0u];
let _e955 = global_1.member.member_5.member_7[1u];
let _e961 = ((_e939 >> bitcast<u32>(4i)) + (_e948 * ((_e940 >> bitcast<u32>(4i)) + (_e955 * (_e941 >> bitcast<u32>(4i))))));
let _e963 = (bitcast<i32>(_e93) - 1i);
let _e965 = select(_e963, _e961, (_e961 < _e963));
let _e971 = global_2.member[bitcast<u32>(select(0i, _e965, (_e965 > 0i)))];
let _e973 = (_e939 & 15i);
let _e976 = ((_e940 & 15i) * _e933);
let _e978 = (bitcast<i32>(_e971) + ((_e941 & 15i) * _e938));
let _e982 = (_e976 + _e933);
let _e984 = (_e976 + (2i * _e933));
let _e985 = (_e978 + _e938);
let _e987 = (_e978 + (2i * _e938));
local_2 = type_18(array<i32, 4>(_e973, (_e973 + 1i), (_e973 + 2i), (_e973 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e474 - f32(_e898)), (_e484 - f32(_e913)), (_e494 - f32(_e928)));
let _e998 = (_e985 + _e982);
let _e1001 = local_2.member[1u];
let _e1002 = (_e998 + _e1001);
let _e1004 = select(_e963, _e1002, (_e1002 < _e963));
let _e1009 = global_2.member[bitcast<u32>(select(0i, _e1004, (_e1004 > 0i)))];
let _e1010 = bitcast<f32>(_e1009);
let _e1013 = local_2.member[2u];
let _e1014 = (_e998 + _e1013);
let _e1016 = select(_e963, _e1014, (_e1014 < _e963));
let _e1021 = global_2.member[bitcast<u32>(select(0i, _e1016, (_e1016 > 0i)))];
let _e1023 = local_3[0u];
let _e1026 = (_e1010 + ((bitcast<f32>(_e1021) - _e1010) * _e1023));
let _e1027 = (_e985 + _e984);
let _e1028 = local_2.member[1u];
let _e1029 = (_e1027 + _e1028);
let _e1031 = select(_e963, _e1029, (_e1029 < _e963));
let _e1036 = global_2.member[bitcast<u32>(select(0i, _e1031, (_e1031 > 0i)))];
let _e1037 = bitcast<f32>(_e1036);
let _e1038 = local_2.member[2u];
let _e1039 = (_e1027 + _e1038);
let _e1041 = select(_e963, _e1039, (_e1039 < _e963));
let _e1046 = global_2.member[bitcast<u32>(select(0i, _e1041, (_e1041 > 0i)))];
let _e1048 = local_3[0u];
let _e1053 = local_3[1u];
let _e1056 = (_e1026 + (((_e1037 + ((bitcast<f32>(_e1046) - _e1037) * _e1048)) - _e1026) * _e1053));
let _e1057 = (_e987 + _e982);
let _e1058 = local_2.member[1u];
let _e1059 = (_e1057 + _e1058);
let _e1061 = select(_e963, _e1059, (_e1059 < _e963));
let _e1066 = global_2.member[bitcast<u32>(select(0i, _e1061, (_e1061 > 0i)))];
let _e1067 = bitcast<f32>(_e1066);
let _e1068 = local_2.member[2u];
let _e1069 = (_e1057 + _e1068);
let _e1071 = select(_e963, _e1069, (_e1069 < _e963));
let _e1076 = global_2.member[bitcast<u32>(select(0i, _e1071, (_e1071 > 0i)))];
let _e1078 = local_3[0u];
let _e1081 = (_e1067 + ((bitcast<f32>(_e1076) - _e1067) * _e1078));
let _e1082 = (_e987 + _e984);
let _e1083 = local_2.member[1u];
let _e1084 = (_e1082 + _e1083);
let _e1086 = select(_e963, _e1084, (_e1084 < _e963));
let _e1091 = global_2.member[bitcast<u32>(select(0i, _e1086, (_e1086 > 0i)))];
let _e1092 = bitcast<f32>(_e1091);
let _e1093 = local_2.member[2u];
let _e1094 = (_e1082 + _e1093);
let _e1096 = select(_e963, _e1094, (_e1094 < _e963));
let _e1101 = global_2.member[bitcast<u32>(select(0i, _e1096, (_e1096 > 0i)))];
let _e1103 = local_3[0u];
let _e1107 = local_3[1u];
let _e1112 = local_3[2u];
let _e1120 = global_1.member.member_5.member_4.member;
let _e1126 = global_1.member.member_5.member_4.member_1;
let _e1127 = (((_e1056 + (((_e1081 + (((_e1092 + ((bitcast<f32>(_e1101) - _e1092) * _e1103)) - _e1081) * _e1107)) - _e1056) * _e1112)) * _e1120) + _e1126);
let _e1129 = select(0f, _e1127, (_e1127 > 0f));
phi_11176_ = type_20(select(1f, _e1129, (_e1129 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2526 = phi_11176_;
let _e2528 = select(-0.5f, _e405, (_e405 > -0.5f));
let _e2530 = select(_e470, _e2528, (_e2528 < _e470));
let _e2532 = select(-0.5f, _e423, (_e423 > -0.5f));
let _e2534 = select(_e480, _e2532, (_e2532 < _e480));
let _e2536 = select(-0.5f, _e441, (_e441 > -0.5f));
let _e2538 = select(_e490, _e2536, (_e2536 < _e490));
let _e2540 = select(-1f, _e2530, (_e2530 > -1f));
let _e2542 = select(_e469, _e2540, (_e2540 < _e469));
let _e2549 = select(0i, select(select(i32(_e2542), i32(-2147483648), (_e2542 < -2147483600f)), 2147483647i, (_e2542 > 2147483500f)), (_e2542 == _e2542));
let _e2553 = (_e2549 - select(0i, 1i, (_e2542 < f32(_e2549))));
let _e2555 = select(-1f, _e2534, (_e2534 > -1f));
let _e2557 = select(_e479, _e2555, (_e2555 < _e479));
let _e2564 = select(0i, select(select(i32(_e2557), i32(-2147483648), (_e2557 < -2147483600f)), 2147483647i, (_e2557 > 2147483500f)), (_e2557 == _e2557));
let _e2568 = (_e2564 - select(0i, 1i, (_e2557 < f32(_e2564))));
let _e2570 = select(-1f, _e2538, (_e2538 > -1f));
let _e2572 = select(_e489, _e2570, (_e2570 < _e489));
let _e2579 = select(0i, select(select(i32(_e2572), i32(-2147483648), (_e2572 < -2147483600f)), 2147483647i, (_e2572 > 2147483500f)), (_e2572 == _e2572));
let _e2583 = (_e2579 - select(0i, 1i, (_e2572 < f32(_e2579))));
let _e2588 = global_1.member.member_5.member_5[0u];
let _e2593 = global_1.member.member_5.member_5[1u];
let _e2594 = (_e2553 + 1i);
let _e2595 = (_e2568 + 1i);
let _e2596 = (_e2583 + 1i);
let _e2603 = global_1.member.member_5.member_7[0u];
let _e2610 = global_1.member.member_5.member_7[1u];
let _e2616 = ((_e2594 >> bitcast<u32>(4i)) + (_e2603 * ((_e2595 >> bitcast<u32>(4i)) + (_e2610 * (_e2596 >> bitcast<u32>(4i))))));
let _e2618 = (bitcast<i32>(_e93) - 1i);
let _e2620 = select(_e2618, _e2616, (_e2616 < _e2618));
let _e2626 = global_2.member[bitcast<u32>(select(0i, _e2620, (_e2620 > 0i)))];
let _e2628 = (_e2594 & 15i);
let _e2631 = ((_e2595 & 15i) * _e2588);
let _e2633 = (bitcast<i32>(_e2626) + ((_e2596 & 15i) * _e2593));
let _e2637 = (_e2631 + _e2588);
let _e2639 = (_e2631 + (2i * _e2588));
let _e2640 = (_e2633 + _e2593);
let _e2642 = (_e2633 + (2i * _e2593));
local = type_18(array<i32, 4>(_e2628, (_e2628 + 1i), (_e2628 + 2i), (_e2628 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2530 - f32(_e2553)), (_e2534 - f32(_e2568)), (_e2538 - f32(_e2583)));
let _e2653 = (_e2640 + _e2637);
let _e2656 = local.member[1u];
let _e2657 = (_e2653 + _e2656);
let _e2659 = select(_e2618, _e2657, (_e2657 < _e2618));
let _e2664 = global_2.member[bitcast<u32>(select(0i, _e2659, (_e2659 > 0i)))];
let _e2665 = bitcast<f32>(_e2664);
let _e2668 = local.member[2u];
let _e2669 = (_e2653 + _e2668);
let _e2671 = select(_e2618, _e2669, (_e2669 < _e2618));
let _e2676 = global_2.member[bitcast<u32>(select(0i, _e2671, (_e2671 > 0i)))];
let _e2678 = local_1[0u];
let _e2681 = (_e2665 + ((bitcast<f32>(_e2676) - _e2665) * _e2678));
let _e2682 = (_e2640 + _e2639);
let _e2683 = local.member[1u];
let _e2684 = (_e2682 + _e2683);
let _e2686 = select(_e2618, _e2684, (_e2684 < _e2618));
let _e2691 = global_2.member[bitcast<u32>(select(0i, _e2686, (_e2686 > 0i)))];
let _e2692 = bitcast<f32>(_e2691);
let _e2693 = local.member[2u];
let _e2694 = (_e2682 + _e2693);
let _e2696 = select(_e2618, _e2694, (_e2694 < _e2618));
let _e2701 = global_2.member[bitcast<u32>(select(0i, _e2696, (_e2696 > 0i)))];
let _e2703 = local_1[0u];
let _e2708 = local_1[1u];
let _e2711 = (_e2681 + (((_e2692 + ((bitcast<f32>(_e2701) - _e2692) * _e2703)) - _e2681) * _e2708));
let _e2712 = (_e2642 + _e2637);
let _e2713 = local.member[1u];
let _e2714 = (_e2712 + _e2713);
let _e2716 = select(_e2618, _e2714, (_e2714 < _e2618));
let _e2721 = global_2.member[bitcast<u32>(select(0i, _e2716, (_e2716 > 0i)))];
let _e2722 = bitcast<f32>(_e2721);
let _e2723 = local.member[2u];
let _e2724 = (_e2712 + _e2723);
let _e2726 = select(_e2618, _e2724, (_e2724 < _e2618));
let _e2731 = global_2.member[bitcast<u32>(select(0i, _e2726, (_e2726 > 0i)))];
let _e2733 = local_1[0u];
let _e2736 = (_e2722 + ((bitcast<f32>(_e2731) - _e2722) * _e2733));
let _e2737 = (_e2642 + _e2639);
let _e2738 = local.member[1u];
let _e2739 = (_e2737 + _e2738);
let _e2741 = select(_e2618, _e2739, (_e2739 < _e2618));
let _e2746 = global_2.member[bitcast<u32>(select(0i, _e2741, (_e2741 > 0i)))];
let _e2747 = bitcast<f32>(_e2746);
let _e2748 = local.member[2u];
let _e2749 = (_e2737 + _e2748);
let _e2751 = select(_e2618, _e2749, (_e2749 < _e2618));
let _e2756 = global_2.member[bitcast<u32>(select(0i, _e2751, (_e2751 > 0i)))];
let _e2758 = local_1[0u];
let _e2762 = local_1[1u];
let _e2767 = local_1[2u];
let _e2775 = global_1.member.member_5.member_4.member;
let _e2781 = global_1.member.member_5.member_4.member_1;
let _e2782 = (((_e2711 + (((_e2736 + (((_e2747 + ((bitcast<f32>(_e2756) - _e2747) * _e2758)) - _e2736) * _e2762)) - _e2711) * _e2767)) * _e2775) + _e2781);
let _e2784 = select(0f, _e2782, (_e2782 > 0f));
if ((_e863 & 16u) == 0u) {
phi_12697_ = type_21(1f, 1f, 1f);
} else {
let _e2791 = global_1.member.member_18;
let _e2795 = global_1.member.member_22.member;
let _e2805 = ((((_e2791.member * _e313) + (_e2791.member_1 * _e322)) + (_e2791.member_2 * _e295)) + _e2791.member_3);
let _e2811 = ((((_e2791.member * _e334) + (_e2791.member_1 * _e339)) + (_e2791.member_2 * _e328)) + _e2791.member_3);
let _e2813 = select(_e2811, _e2805, (_e2805 < _e2811));
let _e2815 = select(_e2811, _e2805, (_e2805 > _e2811));
let _e2817 = (_e2815 - _e2813);
let _e2820 = (-(_e2813) / select(1e-30f, _e2817, (_e2817 > 1e-30f)));
let _e2822 = select(0f, _e2820, (_e2820 > 0f));
let _e2828 = select(select(select(1f, _e2822, (_e2822 < 1f)), 1f, (_e2815 <= 0f)), 0f, (_e2813 > 0f));
let _e2830 = (_e2795 > 0.5f);
let _e2839 = global_1.member.member_19;
let _e2843 = global_1.member.member_22.member_1;
let _e2853 = ((((_e2839.member * _e313) + (_e2839.member_1 * _e322)) + (_e2839.member_2 * _e295)) + _e2839.member_3);
let _e2859 = ((((_e2839.member * _e334) + (_e2839.member_1 * _e339)) + (_e2839.member_2 * _e328)) + _e2839.member_3);
let _e2861 = select(_e2859, _e2853, (_e2853 < _e2859));
let _e2863 = select(_e2859, _e2853, (_e2853 > _e2859));
let _e2865 = (_e2863 - _e2861);
let _e2868 = (-(_e2861) / select(1e-30f, _e2865, (_e2865 > 1e-30f)));
let _e2870 = select(0f, _e2868, (_e2868 > 0f));
let _e2876 = select(select(select(1f, _e2870, (_e2870 < 1f)), 1f, (_e2863 <= 0f)), 0f, (_e2861 > 0f));
let _e2878 = (_e2843 > 0.5f);
let _e2887 = global_1.member.member_20;
let _e2891 = global_1.member.member_22.member_2;
let _e2901 = ((((_e2887.member * _e313) + (_e2887.member_1 * _e322)) + (_e2887.member_2 * _e295)) + _e2887.member_3);
let _e2907 = ((((_e2887.member * _e334) + (_e2887.member_1 * _e339)) + (_e2887.member_2 * _e328)) + _e2887.member_3);
let _e2909 = select(_e2907, _e2901, (_e2901 < _e2907));
let _e2911 = select(_e2907, _e2901, (_e2901 > _e2907));
let _e2913 = (_e2911 - _e2909);
let _e2916 = (-(_e2909) / select(1e-30f, _e2913, (_e2913 > 1e-30f)));
let _e2918 = select(0f, _e2916, (_e2916 > 0f));
let _e2924 = select(select(select(1f, _e2918, (_e2918 < 1f)), 1f, (_e2911 <= 0f)), 0f, (_e2909 > 0f));
let _e2926 = (_e2891 > 0.5f);
let _e2935 = global_1.member.member_21;
let _e2939 = global_1.member.member_22.member_3;
let _e2949 = ((((_e2935.member * _e313) + (_e2935.member_1 * _e322)) + (_e2935.member_2 * _e295)) + _e2935.member_3);
let _e2955 = ((((_e2935.member * _e334) + (_e2935.member_1 * _e339)) + (_e2935.member_2 * _e328)) + _e2935.member_3);
let _e2957 = select(_e2955, _e2949, (_e2949 < _e2955));
let _e2959 = select(_e2955, _e2949, (_e2949 > _e2955));
let _e2961 = (_e2959 - _e2957);
let _e2964 = (-(_e2957) / select(1e-30f, _e2961, (_e2961 > 1e-30f)));
let _e2966 = select(0f, _e2964, (_e2964 > 0f));
let _e2972 = select(select(select(1f, _e2966, (_e2966 < 1f)), 1f, (_e2959 <= 0f)), 0f, (_e2957 > 0f));
let _e2974 = (_e2939 > 0.5f);
phi_12697_ = type_21(((((1f * _e2828) * _e2876) * _e2924) * _e2972), ((((1f * select(1f, _e2828, _e2830)) * select(1f, _e2876, _e2878)) * select(1f, _e2924, _e2926)) * select(1f, _e2972, _e2974)), ((((1f * select(1f, 0f, (_e2830 && (_e2811 > 0f)))) * select(1f, 0f, (_e2878 && (_e2859 > 0f)))) * select(1f, 0f, (_e2926 && (_e2907 > 0f)))) * select(1f, 0f, (_e2974 && (_e2955 > 0f)))));
}
let _e2983 = phi_12697_;
let _e2984 = (_e334 - _e313);
let _e2985 = (_e339 - _e322);
let _e2986 = (_e328 - _e295);
let _e2991 = (((_e2984 * _e2984) + (_e2985 * _e2985)) + (_e2986 * _e2986));
let _e2995 = (_e500 < 1e-12f);
let _e2997 = (1f / select(_e495, 1f, _e2995));
let _e2999 = ((-0.5f - _e405) * _e2997);
let _e3001 = ((_e470 - _e405) * _e2997);
let _e3007 = select(_e3001, _e2999, (_e2999 < _e3001));
let _e3009 = select(0f, _e3007, (_e3007 > 0f));
let _e3012 = select(select(1f, _e3009, (_e3009 < 1f)), select(2f, 0f, ((_e405 >= -0.5f) && (_e405 <= _e470))), _e2995);
let _e3014 = select(_e3001, _e2999, (_e2999 > _e3001));
let _e3016 = select(0f, _e3014, (_e3014 > 0f));
let _e3019 = select(select(1f, _e3016, (_e3016 < 1f)), 1f, _e2995);
let _e3020 = (_e503 < 1e-12f);
let _e3022 = (1f / select(_e496, 1f, _e3020));
let _e3024 = ((-0.5f - _e423) * _e3022);
let _e3026 = ((_e480 - _e423) * _e3022);
let _e3032 = select(_e3026, _e3024, (_e3024 < _e3026));
let _e3034 = select(0f, _e3032, (_e3032 > 0f));
let _e3037 = select(select(1f, _e3034, (_e3034 < 1f)), select(2f, 0f, ((_e423 >= -0.5f) && (_e423 <= _e480))), _e3020);
let _e3039 = select(_e3026, _e3024, (_e3024 > _e3026));
let _e3041 = select(0f, _e3039, (_e3039 > 0f));
let _e3044 = select(select(1f, _e3041, (_e3041 < 1f)), 1f, _e3020);
let _e3045 = (_e508 < 1e-12f);
let _e3047 = (1f / select(_e497, 1f, _e3045));
let _e3049 = ((-0.5f - _e441) * _e3047);
let _e3051 = ((_e490 - _e441) * _e3047);
let _e3057 = select(_e3051, _e3049, (_e3049 < _e3051));
let _e3059 = select(0f, _e3057, (_e3057 > 0f));
let _e3062 = select(select(1f, _e3059, (_e3059 < 1f)), select(2f, 0f, ((_e441 >= -0.5f) && (_e441 <= _e490))), _e3045);
let _e3064 = select(_e3051, _e3049, (_e3049 > _e3051));
let _e3066 = select(0f, _e3064, (_e3064 > 0f));
let _e3069 = select(select(1f, _e3066, (_e3066 < 1f)), 1f, _e3045);
let _e3071 = select(_e3044, _e3019, (_e3019 < _e3044));
let _e3075 = select(_e3037, _e3012, (_e3012 > _e3037));
let _e3078 = (select(_e3069, _e3071, (_e3071 < _e3069)) - select(_e3062, _e3075, (_e3075 > _e3062)));
let _e3085 = global_1.member.member_4.member_3;
let _e3086 = ((sqrt(select(0f, _e2991, (_e2991 > 0f))) * select(0f, _e3078, (_e3078 > 0f))) * _e3085);
let _e3088 = (select(1f, _e2784, (_e2784 < 1f)) * 255f);
let _e3089 = (_e2526.member * 255f);
let _e3090 = (255f - 1f);
let _e3092 = select(0f, _e3088, (_e3088 > 0f));
let _e3094 = select(_e3090, _e3092, (_e3092 < _e3090));
let _e3101 = select(0i, select(select(i32(_e3094), i32(-2147483648), (_e3094 < -2147483600f)), 2147483647i, (_e3094 > 2147483500f)), (_e3094 == _e3094));
let _e3105 = (_e3101 - select(0i, 1i, (_e3094 < f32(_e3101))));
let _e3107 = select(0f, _e3089, (_e3089 > 0f));
let _e3109 = select(_e3090, _e3107, (_e3107 < _e3090));
let _e3116 = select(0i, select(select(i32(_e3109), i32(-2147483648), (_e3109 < -2147483600f)), 2147483647i, (_e3109 > 2147483500f)), (_e3109 == _e3109));
let _e3120 = (_e3116 - select(0i, 1i, (_e3109 < f32(_e3116))));
let _e3123 = (((_e3105 * 256i) + _e3120) * 4i);
let _e3125 = (_e3088 - f32(_e3105));
let _e3127 = (_e3089 - f32(_e3120));
let _e3129 = (bitcast<i32>(_e100) - 1i);
let _e3131 = select(_e3129, _e3123, (_e3123 < _e3129));
let _e3137 = global_4.member[bitcast<u32>(select(0i, _e3131, (_e3131 > 0i)))];
let _e3138 = (_e3123 + 4i);
let _e3140 = select(_e3129, _e3138, (_e3138 < _e3129));
let _e3146 = global_4.member[bitcast<u32>(select(0i, _e3140, (_e3140 > 0i)))];
let _e3147 = (_e3123 + 1024i);
let _e3149 = select(_e3129, _e3147, (_e3147 < _e3129));
let _e3155 = global_4.member[bitcast<u32>(select(0i, _e3149, (_e3149 > 0i)))];
let _e3156 = (_e3123 + 1028i);
let _e3158 = select(_e3129, _e3156, (_e3156 < _e3129));
let _e3164 = global_4.member[bitcast<u32>(select(0i, _e3158, (_e3158 > 0i)))];
let _e3169 = (bitcast<f32>(((_e3137 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3177 = (_e3169 + (((bitcast<f32>(((_e3146 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3169) * _e3127));
let _e3182 = (bitcast<f32>(((_e3155 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3206 = (bitcast<f32>((((_e3137 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3214 = (_e3206 + (((bitcast<f32>((((_e3146 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3206) * _e3127));
let _e3219 = (bitcast<f32>((((_e3155 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3231 = (_e3123 + 1i);
let _e3233 = select(_e3129, _e3231, (_e3231 < _e3129));
let _e3239 = global_4.member[bitcast<u32>(select(0i, _e3233, (_e3233 > 0i)))];
let _e3240 = (_e3123 + 5i);
let _e3242 = select(_e3129, _e3240, (_e3240 < _e3129));
let _e3248 = global_4.member[bitcast<u32>(select(0i, _e3242, (_e3242 > 0i)))];
let _e3249 = (_e3123 + 1025i);
let _e3251 = select(_e3129, _e3249, (_e3249 < _e3129));
let _e3257 = global_4.member[bitcast<u32>(select(0i, _e3251, (_e3251 > 0i)))];
let _e3258 = (_e3123 + 1029i);
let _e3260 = select(_e3129, _e3258, (_e3258 < _e3129));
let _e3266 = global_4.member[bitcast<u32>(select(0i, _e3260, (_e3260 > 0i)))];
let _e3271 = (bitcast<f32>(((_e3239 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3279 = (_e3271 + (((bitcast<f32>(((_e3248 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3271) * _e3127));
let _e3284 = (bitcast<f32>(((_e3257 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3308 = (bitcast<f32>((((_e3239 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3316 = (_e3308 + (((bitcast<f32>((((_e3248 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3308) * _e3127));
let _e3321 = (bitcast<f32>((((_e3257 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3336 = (_e3086 * _e2983.member_1);
let _e3338 = -(((_e3214 + (((_e3219 + (((bitcast<f32>((((_e3164 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3219) * _e3127)) - _e3214) * _e3125)) * _e3336));
let _e3340 = select(-87f, _e3338, (_e3338 > -87f));
let _e3342 = select(88f, _e3340, (_e3340 < 88f));
let _e3344 = ((_e3342 * 1.442695f) + 0.5f);
let _e3346 = select(-127f, _e3344, (_e3344 > -127f));
let _e3348 = select(128f, _e3346, (_e3346 < 128f));
let _e3355 = select(0i, select(select(i32(_e3348), i32(-2147483648), (_e3348 < -2147483600f)), 2147483647i, (_e3348 > 2147483500f)), (_e3348 == _e3348));
let _e3359 = (_e3355 - select(0i, 1i, (_e3348 < f32(_e3355))));
let _e3360 = f32(_e3359);
let _e3364 = ((_e3342 - (_e3360 * 0.6933594f)) - (_e3360 * -2.1219444e-4f));
let _e3386 = -(((_e3279 + (((_e3284 + (((bitcast<f32>(((_e3266 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3284) * _e3127)) - _e3279) * _e3125)) * _e3336));
let _e3388 = select(-87f, _e3386, (_e3386 > -87f));
let _e3390 = select(88f, _e3388, (_e3388 < 88f));
let _e3392 = ((_e3390 * 1.442695f) + 0.5f);
let _e3394 = select(-127f, _e3392, (_e3392 > -127f));
let _e3396 = select(128f, _e3394, (_e3394 < 128f));
let _e3403 = select(0i, select(select(i32(_e3396), i32(-2147483648), (_e3396 < -2147483600f)), 2147483647i, (_e3396 > 2147483500f)), (_e3396 == _e3396));
let _e3407 = (_e3403 - select(0i, 1i, (_e3396 < f32(_e3403))));
let _e3408 = f32(_e3407);
let _e3412 = ((_e3390 - (_e3408 * 0.6933594f)) - (_e3408 * -2.1219444e-4f));
let _e3434 = -(((_e3316 + (((_e3321 + (((bitcast<f32>((((_e3266 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3321) * _e3127)) - _e3316) * _e3125)) * _e3336));
let _e3436 = select(-87f, _e3434, (_e3434 > -87f));
let _e3438 = select(88f, _e3436, (_e3436 < 88f));
let _e3440 = ((_e3438 * 1.442695f) + 0.5f);
let _e3442 = select(-127f, _e3440, (_e3440 > -127f));
let _e3444 = select(128f, _e3442, (_e3442 < 128f));
let _e3451 = select(0i, select(select(i32(_e3444), i32(-2147483648), (_e3444 < -2147483600f)), 2147483647i, (_e3444 > 2147483500f)), (_e3444 == _e3444));
let _e3455 = (_e3451 - select(0i, 1i, (_e3444 < f32(_e3451))));
let _e3456 = f32(_e3455);
let _e3460 = ((_e3438 - (_e3456 * 0.6933594f)) - (_e3456 * -2.1219444e-4f));
let _e3482 = -(((_e3177 + (((_e3182 + (((bitcast<f32>(((_e3164 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3182) * _e3127)) - _e3177) * _e3125)) * (_e3086 * _e2983.member)));
let _e3484 = select(-87f, _e3482, (_e3482 > -87f));
let _e3486 = select(88f, _e3484, (_e3484 < 88f));
let _e3488 = ((_e3486 * 1.442695f) + 0.5f);
let _e3490 = select(-127f, _e3488, (_e3488 > -127f));
let _e3492 = select(128f, _e3490, (_e3490 < 128f));
let _e3499 = select(0i, select(select(i32(_e3492), i32(-2147483648), (_e3492 < -2147483600f)), 2147483647i, (_e3492 > 2147483500f)), (_e3492 == _e3492));
let _e3503 = (_e3499 - select(0i, 1i, (_e3492 < f32(_e3499))));
let _e3504 = f32(_e3503);
let _e3508 = ((_e3486 - (_e3504 * 0.6933594f)) - (_e3504 * -2.1219444e-4f));
let _e3528 = ((1f + (_e3508 * (1f + (_e3508 * (0.5f + (_e3508 * (0.16666667f + (_e3508 * (0.041666668f + (_e3508 * (0.008333334f + (_e3508 * (0.001388889f + (_e3508 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3503 + 127i)) << bitcast<u32>(23i))));
if _e883 {
let _e3543 = global_1.member.member_24.member_2;
let _e3546 = (_e2526.member_3.x * _e2983.member_2);
let _e3548 = (_e2526.member_3.y * _e2983.member_2);
let _e3550 = (_e2526.member_3.z * _e2983.member_2);
let _e3551 = (0.5f * (_e252 / _e204));
let _e3555 = (_e182 + (_e3546 * _e3551));
let _e3556 = (_e193 + (_e3548 * _e3551));
let _e3557 = (_e204 + (_e3550 * _e3551));
let _e3559 = (2f * _e252);
let _e3561 = ((_e3557 * _e3557) + (_e3559 * _e3550));
let _e3565 = (_e3557 + sqrt(select(0f, _e3561, (_e3561 > 0f))));
let _e3569 = (0.5f * (_e3559 / select(1e-6f, _e3565, (_e3565 > 1e-6f))));
let _e3573 = (_e3555 + (_e3546 * _e3569));
let _e3574 = (_e3556 + (_e3548 * _e3569));
let _e3575 = (_e3557 + (_e3550 * _e3569));
let _e3579 = (_e3543 * _e3543);
let _e3581 = (_e3575 * _e3575);
let _e3589 = (((_e3557 <= 0f) || (_e3561 <= 0f)) || ((_e3575 <= 0f) || (_e3581 <= (_e3579 * (((_e3573 * _e3573) + (_e3574 * _e3574)) + _e3581)))));
let _e3603 = (_e182 + ((_e2526.member_4.x * _e2983.member_2) * _e252));
let _e3604 = (_e193 + ((_e2526.member_4.y * _e2983.member_2) * _e252));
let _e3605 = (_e204 + ((_e2526.member_4.z * _e2983.member_2) * _e252));
let _e3607 = (_e3605 * _e3605);
let _e3616 = ((_e863 & 1u) != 0u);
phi_13721_ = select(select(select(_e3575, _e3557, _e3589), _e3605, _e3616), _e204, _e870);
phi_13722_ = select(select(select(_e3574, _e3556, _e3589), _e3604, _e3616), _e193, _e870);
phi_13723_ = select(select(select(_e3573, _e3555, _e3589), _e3603, _e3616), _e182, _e870);
phi_13724_ = (select(_e3589, ((_e3605 <= 0f) || (_e3607 <= (_e3579 * (((_e3603 * _e3603) + (_e3604 * _e3604)) + _e3607)))), _e3616) && !(_e870));
} else {
phi_13721_ = _e204;
phi_13722_ = _e193;
phi_13723_ = _e182;
phi_13724_ = false;
}
let _e3627 = phi_13721_;
let _e3629 = phi_13722_;
let _e3631 = phi_13723_;
let _e3633 = phi_13724_;
global_6.member[_e128] = (_e139 + _e267);
global_6.member[_e140] = (_e149 + _e274);
global_6.member[_e151] = (_e160 + _e376);
global_6.member[_e162] = (_e171 + _e379);
global_6.member[_e173] = _e3631;
global_6.member[_e184] = _e3629;
global_6.member[_e195] = _e3627;
global_6.member[_e206] = select((_e215 * (((1f + (_e3364 * (1f + (_e3364 * (0.5f + (_e3364 * (0.16666667f + (_e3364 * (0.041666668f + (_e3364 * (0.008333334f + (_e3364 * (0.001388889f + (_e3364 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3359 + 127i)) << bitcast<u32>(23i)))) * _e3528)), _e215, _e870);
global_6.member[_e217] = select((_e226 * (((1f + (_e3412 * (1f + (_e3412 * (0.5f + (_e3412 * (0.16666667f + (_e3412 * (0.041666668f + (_e3412 * (0.008333334f + (_e3412 * (0.001388889f + (_e3412 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3407 + 127i)) << bitcast<u32>(23i)))) * _e3528)), _e226, _e870);
global_6.member[_e228] = select((_e237 * (((1f + (_e3460 * (1f + (_e3460 * (0.5f + (_e3460 * (0.16666667f + (_e3460 * (0.041666668f + (_e3460 * (0.008333334f + (_e3460 * (0.001388889f + (_e3460 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3455 + 127i)) << bitcast<u32>(23i)))) * _e3528)), _e237, _e870);
global_6.member[_e239] = select(_e248, 1f, _e3633);
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
