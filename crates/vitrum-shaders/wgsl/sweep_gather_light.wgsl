struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_10 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_11 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_10,
member_6: type_10,
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
struct type_12 {
member: type_11,
}
struct type_13 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_12;
@group(0) @binding(3)
var<storage, read_write> global_2: type_6;
@group(0) @binding(1)
var<storage> global_3: type_6;
@group(0) @binding(2)
var<storage> global_4: type_6;
fn function_() {
var local: type_13;
var phi_235_: i32;
var phi_278_: i32;
var phi_471_: i32;
var phi_514_: i32;
var phi_704_: i32;
var phi_747_: i32;
var phi_882_: f32;
var phi_883_: f32;
var phi_942_: i32;
var phi_985_: i32;
var phi_1178_: i32;
var phi_1221_: i32;
var phi_1414_: i32;
var phi_1457_: i32;
var phi_1647_: i32;
var phi_1690_: i32;
var phi_1880_: i32;
var phi_1923_: i32;
var phi_2113_: i32;
var phi_2156_: i32;
let _e39 = global;
let _e48 = global_1.member.member_1;
let _e51 = (_e39.x + _e48.x);
let _e54 = (_e39.y + _e48.y);
if (_e51 < _e48.z) {
if (_e54 < _e48.w) {
let _e62 = global_1.member.member[0u];
let _e66 = global_1.member.member[1u];
let _e67 = (_e62 * _e66);
let _e69 = ((_e54 * _e62) + _e51);
let _e73 = global_1.member.member[2u];
let _e77 = global_1.member.member_2[2u];
let _e79 = bitcast<i32>((_e54 * _e77));
let _e83 = global_1.member.member_2[3u];
let _e85 = bitcast<i32>((_e77 * _e83));
let _e86 = bitcast<i32>(_e51);
let _e87 = (_e79 + _e86);
let _e89 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e91 = select(_e89, _e87, (_e87 < _e89));
let _e97 = global_4.member[bitcast<u32>(select(0i, _e91, (_e91 > 0i)))];
let _e99 = ((_e85 + _e79) + _e86);
let _e101 = select(_e89, _e99, (_e99 < _e89));
let _e107 = global_4.member[bitcast<u32>(select(0i, _e101, (_e101 > 0i)))];
let _e108 = -(_e97);
let _e109 = -(_e107);
local.member = _e51;
local.member_1 = _e54;
local.member_2 = _e108;
local.member_3 = _e109;
let _e117 = global_1.member.member_2[2u];
let _e118 = bitcast<i32>(_e117);
let _e121 = local.member_1;
let _e123 = (bitcast<i32>(_e121) * _e118);
let _e124 = local.member_2;
let _e125 = -(32768f);
let _e127 = select(_e125, _e124, (_e124 > _e125));
let _e129 = select(32768f, _e127, (_e127 < 32768f));
let _e136 = select(0i, select(select(i32(_e129), i32(-2147483648), (_e129 < -2147483600f)), 2147483647i, (_e129 > 2147483500f)), (_e129 == _e129));
let _e140 = (_e136 - select(0i, 1i, (_e129 < f32(_e136))));
let _e142 = (_e124 - f32(_e140));
let _e143 = (_e140 < 0i);
if _e143 {
phi_235_ = (_e140 + 1i);
} else {
phi_235_ = _e140;
}
let _e146 = phi_235_;
let _e147 = select(1i, -1i, _e143);
let _e149 = select(_e142, (1f - _e142), _e143);
let _e150 = local.member_3;
let _e152 = select(_e125, _e150, (_e150 > _e125));
let _e154 = select(32768f, _e152, (_e152 < 32768f));
let _e161 = select(0i, select(select(i32(_e154), i32(-2147483648), (_e154 < -2147483600f)), 2147483647i, (_e154 > 2147483500f)), (_e154 == _e154));
let _e165 = (_e161 - select(0i, 1i, (_e154 < f32(_e161))));
let _e167 = (_e150 - f32(_e165));
let _e168 = (_e165 < 0i);
if _e168 {
phi_278_ = (_e165 + 1i);
} else {
phi_278_ = _e165;
}
let _e171 = phi_278_;
let _e177 = local.member;
let _e180 = (((_e123 + (_e171 * _e118)) + bitcast<i32>(_e177)) + _e146);
let _e182 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e184 = select(_e182, _e180, (_e180 < _e182));
let _e189 = global_3.member[bitcast<u32>(select(0i, _e184, (_e184 > 0i)))];
let _e190 = (_e180 + _e147);
let _e192 = select(_e182, _e190, (_e190 < _e182));
let _e197 = global_3.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = (_e189 + ((_e197 - _e189) * _e149));
let _e204 = local.member;
let _e207 = (((_e123 + ((_e171 + select(1i, -1i, _e168)) * _e118)) + bitcast<i32>(_e204)) + _e146);
let _e209 = select(_e182, _e207, (_e207 < _e182));
let _e214 = global_3.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e215 = (_e207 + _e147);
let _e217 = select(_e182, _e215, (_e215 < _e182));
let _e222 = global_3.member[bitcast<u32>(select(0i, _e217, (_e217 > 0i)))];
let _e226 = local.member;
let _e229 = local.member_2;
let _e230 = (f32(bitcast<i32>(_e226)) + _e229);
let _e231 = local.member_1;
let _e234 = local.member_3;
let _e235 = (f32(bitcast<i32>(_e231)) + _e234);
let _e237 = (f32(_e118) - 1f);
let _e238 = global_1.member.member_2[3u];
let _e241 = (f32(bitcast<i32>(_e238)) - 1f);
let _e252 = select(1f, (_e200 + (((_e214 + ((_e222 - _e214) * _e149)) - _e200) * select(_e167, (1f - _e167), _e168))), ((((_e230 >= 0f) && (_e230 <= _e237)) && (_e235 >= 0f)) && (_e235 <= _e241)));
if (_e73 >= 3u) {
phi_882_ = _e252;
phi_883_ = _e252;
} else {
let _e254 = bitcast<i32>((_e117 * _e238));
let _e255 = local.member_1;
let _e258 = (_e254 + (bitcast<i32>(_e255) * _e118));
let _e259 = local.member_2;
let _e261 = select(_e125, _e259, (_e259 > _e125));
let _e263 = select(32768f, _e261, (_e261 < 32768f));
let _e270 = select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < -2147483600f)), 2147483647i, (_e263 > 2147483500f)), (_e263 == _e263));
let _e274 = (_e270 - select(0i, 1i, (_e263 < f32(_e270))));
let _e276 = (_e259 - f32(_e274));
let _e277 = (_e274 < 0i);
if _e277 {
phi_471_ = (_e274 + 1i);
} else {
phi_471_ = _e274;
}
let _e280 = phi_471_;
let _e281 = select(1i, -1i, _e277);
let _e283 = select(_e276, (1f - _e276), _e277);
let _e284 = local.member_3;
let _e286 = select(_e125, _e284, (_e284 > _e125));
let _e288 = select(32768f, _e286, (_e286 < 32768f));
let _e295 = select(0i, select(select(i32(_e288), i32(-2147483648), (_e288 < -2147483600f)), 2147483647i, (_e288 > 2147483500f)), (_e288 == _e288));
let _e299 = (_e295 - select(0i, 1i, (_e288 < f32(_e295))));
let _e301 = (_e284 - f32(_e299));
let _e302 = (_e299 < 0i);
if _e302 {
phi_514_ = (_e299 + 1i);
} else {
phi_514_ = _e299;
}
let _e305 = phi_514_;
let _e311 = local.member;
let _e314 = (((_e258 + (_e305 * _e118)) + bitcast<i32>(_e311)) + _e280);
let _e316 = select(_e182, _e314, (_e314 < _e182));
let _e321 = global_3.member[bitcast<u32>(select(0i, _e316, (_e316 > 0i)))];
let _e322 = (_e314 + _e281);
let _e324 = select(_e182, _e322, (_e322 < _e182));
let _e329 = global_3.member[bitcast<u32>(select(0i, _e324, (_e324 > 0i)))];
let _e332 = (_e321 + ((_e329 - _e321) * _e283));
let _e336 = local.member;
let _e339 = (((_e258 + ((_e305 + select(1i, -1i, _e302)) * _e118)) + bitcast<i32>(_e336)) + _e280);
let _e341 = select(_e182, _e339, (_e339 < _e182));
let _e346 = global_3.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e347 = (_e339 + _e281);
let _e349 = select(_e182, _e347, (_e347 < _e182));
let _e354 = global_3.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e358 = local.member;
let _e361 = local.member_2;
let _e362 = (f32(bitcast<i32>(_e358)) + _e361);
let _e363 = local.member_1;
let _e366 = local.member_3;
let _e367 = (f32(bitcast<i32>(_e363)) + _e366);
let _e380 = local.member_1;
let _e383 = ((2i * _e254) + (bitcast<i32>(_e380) * _e118));
let _e384 = local.member_2;
let _e386 = select(_e125, _e384, (_e384 > _e125));
let _e388 = select(32768f, _e386, (_e386 < 32768f));
let _e395 = select(0i, select(select(i32(_e388), i32(-2147483648), (_e388 < -2147483600f)), 2147483647i, (_e388 > 2147483500f)), (_e388 == _e388));
let _e399 = (_e395 - select(0i, 1i, (_e388 < f32(_e395))));
let _e401 = (_e384 - f32(_e399));
let _e402 = (_e399 < 0i);
if _e402 {
phi_704_ = (_e399 + 1i);
} else {
phi_704_ = _e399;
}
let _e405 = phi_704_;
let _e406 = select(1i, -1i, _e402);
let _e408 = select(_e401, (1f - _e401), _e402);
let _e409 = local.member_3;
let _e411 = select(_e125, _e409, (_e409 > _e125));
let _e413 = select(32768f, _e411, (_e411 < 32768f));
let _e420 = select(0i, select(select(i32(_e413), i32(-2147483648), (_e413 < -2147483600f)), 2147483647i, (_e413 > 2147483500f)), (_e413 == _e413));
let _e424 = (_e420 - select(0i, 1i, (_e413 < f32(_e420))));
let _e426 = (_e409 - f32(_e424));
let _e427 = (_e424 < 0i);
if _e427 {
phi_747_ = (_e424 + 1i);
} else {
phi_747_ = _e424;
}
let _e430 = phi_747_;
let _e436 = local.member;
let _e439 = (((_e383 + (_e430 * _e118)) + bitcast<i32>(_e436)) + _e405);
let _e441 = select(_e182, _e439, (_e439 < _e182));
let _e446 = global_3.member[bitcast<u32>(select(0i, _e441, (_e441 > 0i)))];
let _e447 = (_e439 + _e406);
let _e449 = select(_e182, _e447, (_e447 < _e182));
let _e454 = global_3.member[bitcast<u32>(select(0i, _e449, (_e449 > 0i)))];
let _e457 = (_e446 + ((_e454 - _e446) * _e408));
let _e461 = local.member;
let _e464 = (((_e383 + ((_e430 + select(1i, -1i, _e427)) * _e118)) + bitcast<i32>(_e461)) + _e405);
let _e466 = select(_e182, _e464, (_e464 < _e182));
let _e471 = global_3.member[bitcast<u32>(select(0i, _e466, (_e466 > 0i)))];
let _e472 = (_e464 + _e406);
let _e474 = select(_e182, _e472, (_e472 < _e182));
let _e479 = global_3.member[bitcast<u32>(select(0i, _e474, (_e474 > 0i)))];
let _e483 = local.member;
let _e486 = local.member_2;
let _e487 = (f32(bitcast<i32>(_e483)) + _e486);
let _e488 = local.member_1;
let _e491 = local.member_3;
let _e492 = (f32(bitcast<i32>(_e488)) + _e491);
phi_882_ = select(1f, (_e457 + (((_e471 + ((_e479 - _e471) * _e408)) - _e457) * select(_e426, (1f - _e426), _e427))), ((((_e487 >= 0f) && (_e487 <= _e237)) && (_e492 >= 0f)) && (_e492 <= _e241)));
phi_883_ = select(1f, (_e332 + (((_e346 + ((_e354 - _e346) * _e283)) - _e332) * select(_e301, (1f - _e301), _e302))), ((((_e362 >= 0f) && (_e362 <= _e237)) && (_e367 >= 0f)) && (_e367 <= _e241)));
}
let _e505 = phi_882_;
let _e507 = phi_883_;
let _e513 = global_1.member.member_10.member;
let _e515 = bitcast<i32>((_e117 * _e238));
let _e517 = local.member_1;
let _e520 = ((3i * _e515) + (bitcast<i32>(_e517) * _e118));
let _e521 = local.member_2;
let _e523 = select(_e125, _e521, (_e521 > _e125));
let _e525 = select(32768f, _e523, (_e523 < 32768f));
let _e532 = select(0i, select(select(i32(_e525), i32(-2147483648), (_e525 < -2147483600f)), 2147483647i, (_e525 > 2147483500f)), (_e525 == _e525));
let _e536 = (_e532 - select(0i, 1i, (_e525 < f32(_e532))));
let _e538 = (_e521 - f32(_e536));
let _e539 = (_e536 < 0i);
if _e539 {
phi_942_ = (_e536 + 1i);
} else {
phi_942_ = _e536;
}
let _e542 = phi_942_;
let _e543 = select(1i, -1i, _e539);
let _e545 = select(_e538, (1f - _e538), _e539);
let _e546 = local.member_3;
let _e548 = select(_e125, _e546, (_e546 > _e125));
let _e550 = select(32768f, _e548, (_e548 < 32768f));
let _e557 = select(0i, select(select(i32(_e550), i32(-2147483648), (_e550 < -2147483600f)), 2147483647i, (_e550 > 2147483500f)), (_e550 == _e550));
let _e561 = (_e557 - select(0i, 1i, (_e550 < f32(_e557))));
let _e563 = (_e546 - f32(_e561));
let _e564 = (_e561 < 0i);
if _e564 {
phi_985_ = (_e561 + 1i);
} else {
phi_985_ = _e561;
}
let _e567 = phi_985_;
let _e573 = local.member;
let _e576 = (((_e520 + (_e567 * _e118)) + bitcast<i32>(_e573)) + _e542);
let _e578 = select(_e182, _e576, (_e576 < _e182));
let _e583 = global_3.member[bitcast<u32>(select(0i, _e578, (_e578 > 0i)))];
let _e584 = (_e576 + _e543);
let _e586 = select(_e182, _e584, (_e584 < _e182));
let _e591 = global_3.member[bitcast<u32>(select(0i, _e586, (_e586 > 0i)))];
let _e594 = (_e583 + ((_e591 - _e583) * _e545));
let _e598 = local.member;
let _e601 = (((_e520 + ((_e567 + select(1i, -1i, _e564)) * _e118)) + bitcast<i32>(_e598)) + _e542);
let _e603 = select(_e182, _e601, (_e601 < _e182));
let _e608 = global_3.member[bitcast<u32>(select(0i, _e603, (_e603 > 0i)))];
let _e609 = (_e601 + _e543);
let _e611 = select(_e182, _e609, (_e609 < _e182));
let _e616 = global_3.member[bitcast<u32>(select(0i, _e611, (_e611 > 0i)))];
let _e620 = local.member;
let _e623 = local.member_2;
let _e624 = (f32(bitcast<i32>(_e620)) + _e623);
let _e625 = local.member_1;
let _e628 = local.member_3;
let _e629 = (f32(bitcast<i32>(_e625)) + _e628);
let _e644 = global_1.member.member_10.member_1;
let _e646 = local.member_1;
let _e649 = ((4i * _e515) + (bitcast<i32>(_e646) * _e118));
let _e650 = local.member_2;
let _e652 = select(_e125, _e650, (_e650 > _e125));
let _e654 = select(32768f, _e652, (_e652 < 32768f));
let _e661 = select(0i, select(select(i32(_e654), i32(-2147483648), (_e654 < -2147483600f)), 2147483647i, (_e654 > 2147483500f)), (_e654 == _e654));
let _e665 = (_e661 - select(0i, 1i, (_e654 < f32(_e661))));
let _e667 = (_e650 - f32(_e665));
let _e668 = (_e665 < 0i);
if _e668 {
phi_1178_ = (_e665 + 1i);
} else {
phi_1178_ = _e665;
}
let _e671 = phi_1178_;
let _e672 = select(1i, -1i, _e668);
let _e674 = select(_e667, (1f - _e667), _e668);
let _e675 = local.member_3;
let _e677 = select(_e125, _e675, (_e675 > _e125));
let _e679 = select(32768f, _e677, (_e677 < 32768f));
let _e686 = select(0i, select(select(i32(_e679), i32(-2147483648), (_e679 < -2147483600f)), 2147483647i, (_e679 > 2147483500f)), (_e679 == _e679));
let _e690 = (_e686 - select(0i, 1i, (_e679 < f32(_e686))));
let _e692 = (_e675 - f32(_e690));
let _e693 = (_e690 < 0i);
if _e693 {
phi_1221_ = (_e690 + 1i);
} else {
phi_1221_ = _e690;
}
let _e696 = phi_1221_;
let _e702 = local.member;
let _e705 = (((_e649 + (_e696 * _e118)) + bitcast<i32>(_e702)) + _e671);
let _e707 = select(_e182, _e705, (_e705 < _e182));
let _e712 = global_3.member[bitcast<u32>(select(0i, _e707, (_e707 > 0i)))];
let _e713 = (_e705 + _e672);
let _e715 = select(_e182, _e713, (_e713 < _e182));
let _e720 = global_3.member[bitcast<u32>(select(0i, _e715, (_e715 > 0i)))];
let _e723 = (_e712 + ((_e720 - _e712) * _e674));
let _e727 = local.member;
let _e730 = (((_e649 + ((_e696 + select(1i, -1i, _e693)) * _e118)) + bitcast<i32>(_e727)) + _e671);
let _e732 = select(_e182, _e730, (_e730 < _e182));
let _e737 = global_3.member[bitcast<u32>(select(0i, _e732, (_e732 > 0i)))];
let _e738 = (_e730 + _e672);
let _e740 = select(_e182, _e738, (_e738 < _e182));
let _e745 = global_3.member[bitcast<u32>(select(0i, _e740, (_e740 > 0i)))];
let _e749 = local.member;
let _e752 = local.member_2;
let _e753 = (f32(bitcast<i32>(_e749)) + _e752);
let _e754 = local.member_1;
let _e757 = local.member_3;
let _e758 = (f32(bitcast<i32>(_e754)) + _e757);
let _e773 = global_1.member.member_10.member_2;
let _e775 = local.member_1;
let _e778 = ((5i * _e515) + (bitcast<i32>(_e775) * _e118));
let _e779 = local.member_2;
let _e781 = select(_e125, _e779, (_e779 > _e125));
let _e783 = select(32768f, _e781, (_e781 < 32768f));
let _e790 = select(0i, select(select(i32(_e783), i32(-2147483648), (_e783 < -2147483600f)), 2147483647i, (_e783 > 2147483500f)), (_e783 == _e783));
let _e794 = (_e790 - select(0i, 1i, (_e783 < f32(_e790))));
let _e796 = (_e779 - f32(_e794));
let _e797 = (_e794 < 0i);
if _e797 {
phi_1414_ = (_e794 + 1i);
} else {
phi_1414_ = _e794;
}
let _e800 = phi_1414_;
let _e801 = select(1i, -1i, _e797);
let _e803 = select(_e796, (1f - _e796), _e797);
let _e804 = local.member_3;
let _e806 = select(_e125, _e804, (_e804 > _e125));
let _e808 = select(32768f, _e806, (_e806 < 32768f));
let _e815 = select(0i, select(select(i32(_e808), i32(-2147483648), (_e808 < -2147483600f)), 2147483647i, (_e808 > 2147483500f)), (_e808 == _e808));
let _e819 = (_e815 - select(0i, 1i, (_e808 < f32(_e815))));
let _e821 = (_e804 - f32(_e819));
let _e822 = (_e819 < 0i);
if _e822 {
phi_1457_ = (_e819 + 1i);
} else {
phi_1457_ = _e819;
}
let _e825 = phi_1457_;
let _e831 = local.member;
let _e834 = (((_e778 + (_e825 * _e118)) + bitcast<i32>(_e831)) + _e800);
let _e836 = select(_e182, _e834, (_e834 < _e182));
let _e841 = global_3.member[bitcast<u32>(select(0i, _e836, (_e836 > 0i)))];
let _e842 = (_e834 + _e801);
let _e844 = select(_e182, _e842, (_e842 < _e182));
let _e849 = global_3.member[bitcast<u32>(select(0i, _e844, (_e844 > 0i)))];
let _e852 = (_e841 + ((_e849 - _e841) * _e803));
let _e856 = local.member;
let _e859 = (((_e778 + ((_e825 + select(1i, -1i, _e822)) * _e118)) + bitcast<i32>(_e856)) + _e800);
let _e861 = select(_e182, _e859, (_e859 < _e182));
let _e866 = global_3.member[bitcast<u32>(select(0i, _e861, (_e861 > 0i)))];
let _e867 = (_e859 + _e801);
let _e869 = select(_e182, _e867, (_e867 < _e182));
let _e874 = global_3.member[bitcast<u32>(select(0i, _e869, (_e869 > 0i)))];
let _e878 = local.member;
let _e881 = local.member_2;
let _e882 = (f32(bitcast<i32>(_e878)) + _e881);
let _e883 = local.member_1;
let _e886 = local.member_3;
let _e887 = (f32(bitcast<i32>(_e883)) + _e886);
let _e900 = local.member_1;
let _e903 = ((6i * _e515) + (bitcast<i32>(_e900) * _e118));
let _e904 = local.member_2;
let _e906 = select(_e125, _e904, (_e904 > _e125));
let _e908 = select(32768f, _e906, (_e906 < 32768f));
let _e915 = select(0i, select(select(i32(_e908), i32(-2147483648), (_e908 < -2147483600f)), 2147483647i, (_e908 > 2147483500f)), (_e908 == _e908));
let _e919 = (_e915 - select(0i, 1i, (_e908 < f32(_e915))));
let _e921 = (_e904 - f32(_e919));
let _e922 = (_e919 < 0i);
if _e922 {
phi_1647_ = (_e919 + 1i);
} else {
phi_1647_ = _e919;
}
let _e925 = phi_1647_;
let _e926 = select(1i, -1i, _e922);
let _e928 = select(_e921, (1f - _e921), _e922);
let _e929 = local.member_3;
let _e931 = select(_e125, _e929, (_e929 > _e125));
let _e933 = select(32768f, _e931, (_e931 < 32768f));
let _e940 = select(0i, select(select(i32(_e933), i32(-2147483648), (_e933 < -2147483600f)), 2147483647i, (_e933 > 2147483500f)), (_e933 == _e933));
let _e944 = (_e940 - select(0i, 1i, (_e933 < f32(_e940))));
let _e946 = (_e929 - f32(_e944));
let _e947 = (_e944 < 0i);
if _e947 {
phi_1690_ = (_e944 + 1i);
} else {
phi_1690_ = _e944;
}
let _e950 = phi_1690_;
let _e956 = local.member;
let _e959 = (((_e903 + (_e950 * _e118)) + bitcast<i32>(_e956)) + _e925);
let _e961 = select(_e182, _e959, (_e959 < _e182));
let _e966 = global_3.member[bitcast<u32>(select(0i, _e961, (_e961 > 0i)))];
let _e967 = (_e959 + _e926);
let _e969 = select(_e182, _e967, (_e967 < _e182));
let _e974 = global_3.member[bitcast<u32>(select(0i, _e969, (_e969 > 0i)))];
let _e977 = (_e966 + ((_e974 - _e966) * _e928));
let _e981 = local.member;
let _e984 = (((_e903 + ((_e950 + select(1i, -1i, _e947)) * _e118)) + bitcast<i32>(_e981)) + _e925);
let _e986 = select(_e182, _e984, (_e984 < _e182));
let _e991 = global_3.member[bitcast<u32>(select(0i, _e986, (_e986 > 0i)))];
let _e992 = (_e984 + _e926);
let _e994 = select(_e182, _e992, (_e992 < _e182));
let _e999 = global_3.member[bitcast<u32>(select(0i, _e994, (_e994 > 0i)))];
let _e1003 = local.member;
let _e1006 = local.member_2;
let _e1007 = (f32(bitcast<i32>(_e1003)) + _e1006);
let _e1008 = local.member_1;
let _e1011 = local.member_3;
let _e1012 = (f32(bitcast<i32>(_e1008)) + _e1011);
let _e1025 = local.member_1;
let _e1028 = ((7i * _e515) + (bitcast<i32>(_e1025) * _e118));
let _e1029 = local.member_2;
let _e1031 = select(_e125, _e1029, (_e1029 > _e125));
let _e1033 = select(32768f, _e1031, (_e1031 < 32768f));
let _e1040 = select(0i, select(select(i32(_e1033), i32(-2147483648), (_e1033 < -2147483600f)), 2147483647i, (_e1033 > 2147483500f)), (_e1033 == _e1033));
let _e1044 = (_e1040 - select(0i, 1i, (_e1033 < f32(_e1040))));
let _e1046 = (_e1029 - f32(_e1044));
let _e1047 = (_e1044 < 0i);
if _e1047 {
phi_1880_ = (_e1044 + 1i);
} else {
phi_1880_ = _e1044;
}
let _e1050 = phi_1880_;
let _e1051 = select(1i, -1i, _e1047);
let _e1053 = select(_e1046, (1f - _e1046), _e1047);
let _e1054 = local.member_3;
let _e1056 = select(_e125, _e1054, (_e1054 > _e125));
let _e1058 = select(32768f, _e1056, (_e1056 < 32768f));
let _e1065 = select(0i, select(select(i32(_e1058), i32(-2147483648), (_e1058 < -2147483600f)), 2147483647i, (_e1058 > 2147483500f)), (_e1058 == _e1058));
let _e1069 = (_e1065 - select(0i, 1i, (_e1058 < f32(_e1065))));
let _e1071 = (_e1054 - f32(_e1069));
let _e1072 = (_e1069 < 0i);
if _e1072 {
phi_1923_ = (_e1069 + 1i);
} else {
phi_1923_ = _e1069;
}
let _e1075 = phi_1923_;
let _e1081 = local.member;
let _e1084 = (((_e1028 + (_e1075 * _e118)) + bitcast<i32>(_e1081)) + _e1050);
let _e1086 = select(_e182, _e1084, (_e1084 < _e182));
let _e1091 = global_3.member[bitcast<u32>(select(0i, _e1086, (_e1086 > 0i)))];
let _e1092 = (_e1084 + _e1051);
let _e1094 = select(_e182, _e1092, (_e1092 < _e182));
let _e1099 = global_3.member[bitcast<u32>(select(0i, _e1094, (_e1094 > 0i)))];
let _e1102 = (_e1091 + ((_e1099 - _e1091) * _e1053));
let _e1106 = local.member;
let _e1109 = (((_e1028 + ((_e1075 + select(1i, -1i, _e1072)) * _e118)) + bitcast<i32>(_e1106)) + _e1050);
let _e1111 = select(_e182, _e1109, (_e1109 < _e182));
let _e1116 = global_3.member[bitcast<u32>(select(0i, _e1111, (_e1111 > 0i)))];
let _e1117 = (_e1109 + _e1051);
let _e1119 = select(_e182, _e1117, (_e1117 < _e182));
let _e1124 = global_3.member[bitcast<u32>(select(0i, _e1119, (_e1119 > 0i)))];
let _e1128 = local.member;
let _e1131 = local.member_2;
let _e1132 = (f32(bitcast<i32>(_e1128)) + _e1131);
let _e1133 = local.member_1;
let _e1136 = local.member_3;
let _e1137 = (f32(bitcast<i32>(_e1133)) + _e1136);
let _e1150 = local.member_1;
let _e1153 = ((8i * _e515) + (bitcast<i32>(_e1150) * _e118));
let _e1154 = local.member_2;
let _e1156 = select(_e125, _e1154, (_e1154 > _e125));
let _e1158 = select(32768f, _e1156, (_e1156 < 32768f));
let _e1165 = select(0i, select(select(i32(_e1158), i32(-2147483648), (_e1158 < -2147483600f)), 2147483647i, (_e1158 > 2147483500f)), (_e1158 == _e1158));
let _e1169 = (_e1165 - select(0i, 1i, (_e1158 < f32(_e1165))));
let _e1171 = (_e1154 - f32(_e1169));
let _e1172 = (_e1169 < 0i);
if _e1172 {
phi_2113_ = (_e1169 + 1i);
} else {
phi_2113_ = _e1169;
}
let _e1175 = phi_2113_;
let _e1176 = select(1i, -1i, _e1172);
let _e1178 = select(_e1171, (1f - _e1171), _e1172);
let _e1179 = local.member_3;
let _e1181 = select(_e125, _e1179, (_e1179 > _e125));
let _e1183 = select(32768f, _e1181, (_e1181 < 32768f));
let _e1190 = select(0i, select(select(i32(_e1183), i32(-2147483648), (_e1183 < -2147483600f)), 2147483647i, (_e1183 > 2147483500f)), (_e1183 == _e1183));
let _e1194 = (_e1190 - select(0i, 1i, (_e1183 < f32(_e1190))));
let _e1196 = (_e1179 - f32(_e1194));
let _e1197 = (_e1194 < 0i);
if _e1197 {
phi_2156_ = (_e1194 + 1i);
} else {
phi_2156_ = _e1194;
}
let _e1200 = phi_2156_;
let _e1206 = local.member;
let _e1209 = (((_e1153 + (_e1200 * _e118)) + bitcast<i32>(_e1206)) + _e1175);
let _e1211 = select(_e182, _e1209, (_e1209 < _e182));
let _e1216 = global_3.member[bitcast<u32>(select(0i, _e1211, (_e1211 > 0i)))];
let _e1217 = (_e1209 + _e1176);
let _e1219 = select(_e182, _e1217, (_e1217 < _e182));
let _e1224 = global_3.member[bitcast<u32>(select(0i, _e1219, (_e1219 > 0i)))];
let _e1227 = (_e1216 + ((_e1224 - _e1216) * _e1178));
let _e1231 = local.member;
let _e1234 = (((_e1153 + ((_e1200 + select(1i, -1i, _e1197)) * _e118)) + bitcast<i32>(_e1231)) + _e1175);
let _e1236 = select(_e182, _e1234, (_e1234 < _e182));
let _e1241 = global_3.member[bitcast<u32>(select(0i, _e1236, (_e1236 > 0i)))];
let _e1242 = (_e1234 + _e1176);
let _e1244 = select(_e182, _e1242, (_e1242 < _e182));
let _e1249 = global_3.member[bitcast<u32>(select(0i, _e1244, (_e1244 > 0i)))];
let _e1253 = local.member;
let _e1256 = local.member_2;
let _e1257 = (f32(bitcast<i32>(_e1253)) + _e1256);
let _e1258 = local.member_1;
let _e1261 = local.member_3;
let _e1262 = (f32(bitcast<i32>(_e1258)) + _e1261);
let _e1273 = select(1f, (_e1227 + (((_e1241 + ((_e1249 - _e1241) * _e1178)) - _e1227) * select(_e1196, (1f - _e1196), _e1197))), ((((_e1257 >= 0f) && (_e1257 <= _e237)) && (_e1262 >= 0f)) && (_e1262 <= _e241)));
let _e1274 = global_1.member.member_10;
let _e1281 = global_1.member.member_4.member_2;
let _e1284 = (1f / select(1e-6f, _e1274.member_2, (_e1274.member_2 > 1e-6f)));
let _e1288 = global_1.member.member_7.member_3;
let _e1289 = (_e1281 * _e1288);
let _e1294 = global_1.member.member_8.member;
let _e1301 = global_1.member.member_8.member_1;
let _e1308 = bitcast<i32>(_e54);
let _e1309 = bitcast<i32>(_e77);
let _e1310 = (_e1308 * _e1309);
let _e1311 = (_e1310 + _e86);
let _e1313 = select(_e89, _e1311, (_e1311 < _e89));
let _e1319 = global_4.member[bitcast<u32>(select(0i, _e1313, (_e1313 > 0i)))];
let _e1321 = ((_e1310 + _e85) + _e86);
let _e1323 = select(_e89, _e1321, (_e1321 < _e89));
let _e1329 = global_4.member[bitcast<u32>(select(0i, _e1323, (_e1323 > 0i)))];
let _e1330 = (_e1310 + -1i);
let _e1331 = (_e1330 + _e86);
let _e1333 = select(_e89, _e1331, (_e1331 < _e89));
let _e1339 = global_4.member[bitcast<u32>(select(0i, _e1333, (_e1333 > 0i)))];
let _e1341 = ((_e1330 + _e85) + _e86);
let _e1343 = select(_e89, _e1341, (_e1341 < _e89));
let _e1349 = global_4.member[bitcast<u32>(select(0i, _e1343, (_e1343 > 0i)))];
let _e1350 = (_e1310 + 1i);
let _e1351 = (_e1350 + _e86);
let _e1353 = select(_e89, _e1351, (_e1351 < _e89));
let _e1359 = global_4.member[bitcast<u32>(select(0i, _e1353, (_e1353 > 0i)))];
let _e1361 = ((_e1350 + _e85) + _e86);
let _e1363 = select(_e89, _e1361, (_e1361 < _e89));
let _e1369 = global_4.member[bitcast<u32>(select(0i, _e1363, (_e1363 > 0i)))];
let _e1371 = ((_e1308 - 1i) * _e1309);
let _e1372 = (_e1371 + _e86);
let _e1374 = select(_e89, _e1372, (_e1372 < _e89));
let _e1380 = global_4.member[bitcast<u32>(select(0i, _e1374, (_e1374 > 0i)))];
let _e1382 = ((_e1371 + _e85) + _e86);
let _e1384 = select(_e89, _e1382, (_e1382 < _e89));
let _e1390 = global_4.member[bitcast<u32>(select(0i, _e1384, (_e1384 > 0i)))];
let _e1392 = ((_e1308 + 1i) * _e1309);
let _e1393 = (_e1392 + _e86);
let _e1395 = select(_e89, _e1393, (_e1393 < _e89));
let _e1401 = global_4.member[bitcast<u32>(select(0i, _e1395, (_e1395 > 0i)))];
let _e1403 = ((_e1392 + _e85) + _e86);
let _e1405 = select(_e89, _e1403, (_e1403 < _e89));
let _e1411 = global_4.member[bitcast<u32>(select(0i, _e1405, (_e1405 > 0i)))];
let _e1413 = select(0f, -1f, (_e86 > 0i));
let _e1416 = select(0f, -1f, (_e86 < (_e1309 - 1i)));
let _e1419 = select(0f, -1f, (false || (_e1308 > 0i)));
let _e1424 = select(0f, -1f, (false || (_e1308 < (bitcast<i32>(_e83) - 1i))));
let _e1426 = ((_e1319 - _e1339) * _e1413);
let _e1428 = ((_e1359 - _e1319) * _e1416);
let _e1430 = (0.5f * (_e1426 + _e1428));
let _e1434 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
let _e1437 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
let _e1440 = (2f * select(_e1437, _e1434, (_e1434 < _e1437)));
let _e1443 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
let _e1445 = select(_e1440, _e1443, (_e1443 < _e1440));
let _e1453 = (1f + select(_e1430, select(0f, select(_e1445, -(_e1445), (_e1430 < 0f)), ((_e1426 * _e1428) > 0f)), (_e1430 > 0f)));
let _e1455 = ((_e1329 - _e1349) * _e1413);
let _e1457 = ((_e1369 - _e1329) * _e1416);
let _e1459 = (0.5f * (_e1455 + _e1457));
let _e1462 = bitcast<f32>((bitcast<u32>(_e1455) & 2147483647u));
let _e1465 = bitcast<f32>((bitcast<u32>(_e1457) & 2147483647u));
let _e1468 = (2f * select(_e1465, _e1462, (_e1462 < _e1465)));
let _e1471 = bitcast<f32>((bitcast<u32>(_e1459) & 2147483647u));
let _e1473 = select(_e1468, _e1471, (_e1471 < _e1468));
let _e1479 = select(0f, select(_e1473, -(_e1473), (_e1459 < 0f)), ((_e1455 * _e1457) > 0f));
let _e1481 = ((_e1319 - _e1380) * _e1419);
let _e1483 = ((_e1401 - _e1319) * _e1424);
let _e1485 = (0.5f * (_e1481 + _e1483));
let _e1488 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
let _e1491 = bitcast<f32>((bitcast<u32>(_e1483) & 2147483647u));
let _e1494 = (2f * select(_e1491, _e1488, (_e1488 < _e1491)));
let _e1497 = bitcast<f32>((bitcast<u32>(_e1485) & 2147483647u));
let _e1499 = select(_e1494, _e1497, (_e1497 < _e1494));
let _e1505 = select(0f, select(_e1499, -(_e1499), (_e1485 < 0f)), ((_e1481 * _e1483) > 0f));
let _e1507 = ((_e1329 - _e1390) * _e1419);
let _e1509 = ((_e1411 - _e1329) * _e1424);
let _e1511 = (0.5f * (_e1507 + _e1509));
let _e1515 = bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u));
let _e1518 = bitcast<f32>((bitcast<u32>(_e1509) & 2147483647u));
let _e1521 = (2f * select(_e1518, _e1515, (_e1515 < _e1518)));
let _e1524 = bitcast<f32>((bitcast<u32>(_e1511) & 2147483647u));
let _e1526 = select(_e1521, _e1524, (_e1524 < _e1521));
let _e1534 = (1f + select(_e1511, select(0f, select(_e1526, -(_e1526), (_e1511 < 0f)), ((_e1507 * _e1509) > 0f)), (_e1511 > 0f)));
let _e1538 = global_1.member.member[3u];
let _e1543 = ((_e1453 * _e1453) + (_e1479 * _e1479));
let _e1546 = ((_e1505 * _e1505) + (_e1534 * _e1534));
let _e1563 = select(select(bitcast<f32>((bitcast<u32>(((_e1453 * _e1534) - (_e1479 * _e1505))) & 2147483647u)), (sqrt(select(0f, _e1543, (_e1543 > 0f))) * sqrt(select(0f, _e1546, (_e1546 > 0f)))), ((_e1538 & 2u) != 0u)), 1f, ((_e1538 & 4u) != 0u));
let _e1566 = (1e6f / select(1f, _e1273, (_e1273 > 1f)));
let _e1568 = select(_e1566, _e1563, (_e1563 < _e1566));
global_2.member[_e69] = (_e252 * _e1568);
global_2.member[(_e67 + _e69)] = (_e507 * _e1568);
global_2.member[((2u * _e67) + _e69)] = (_e505 * _e1568);
global_2.member[((3u * _e67) + _e69)] = select(_e513, (_e594 + (((_e608 + ((_e616 - _e608) * _e545)) - _e594) * select(_e563, (1f - _e563), _e564))), ((((_e624 >= 0f) && (_e624 <= _e237)) && (_e629 >= 0f)) && (_e629 <= _e241)));
global_2.member[((4u * _e67) + _e69)] = select(_e644, (_e723 + (((_e737 + ((_e745 - _e737) * _e674)) - _e723) * select(_e692, (1f - _e692), _e693))), ((((_e753 >= 0f) && (_e753 <= _e237)) && (_e758 >= 0f)) && (_e758 <= _e241)));
global_2.member[((5u * _e67) + _e69)] = select(_e773, (_e852 + (((_e866 + ((_e874 - _e866) * _e803)) - _e852) * select(_e821, (1f - _e821), _e822))), ((((_e882 >= 0f) && (_e882 <= _e237)) && (_e887 >= 0f)) && (_e887 <= _e241)));
global_2.member[((6u * _e67) + _e69)] = (select(0f, (_e977 + (((_e991 + ((_e999 - _e991) * _e928)) - _e977) * select(_e946, (1f - _e946), _e947))), ((((_e1007 >= 0f) && (_e1007 <= _e237)) && (_e1012 >= 0f)) && (_e1012 <= _e241))) + (_e108 + (((_e1274.member * _e1284) - _e1294) * _e1289)));
global_2.member[((7u * _e67) + _e69)] = (select(0f, (_e1102 + (((_e1116 + ((_e1124 - _e1116) * _e1053)) - _e1102) * select(_e1071, (1f - _e1071), _e1072))), ((((_e1132 >= 0f) && (_e1132 <= _e237)) && (_e1137 >= 0f)) && (_e1137 <= _e241))) + (_e109 + (((_e1274.member_1 * _e1284) - _e1301) * _e1289)));
global_2.member[((8u * _e67) + _e69)] = (_e1273 * _e1568);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
