struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_11 {
member: array<f32>,
}
struct type_14 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_15 {
member: u32,
member_1: u32,
}
struct type_16 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_17 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_18 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_19 {
member: type_5,
member_1: type_5,
}
struct type_20 {
member: type_7,
member_1: u32,
}
struct type_21 {
member: type_2,
member_1: u32,
member_2: type_14,
member_3: type_15,
member_4: u32,
member_5: type_16,
member_6: type_17,
member_7: type_17,
member_8: type_18,
member_9: type_19,
member_10: f32,
member_11: type_16,
member_12: type_4,
member_13: type_9,
member_14: type_20,
member_15: type_20,
member_16: type_20,
member_17: type_20,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_22 {
member: type_21,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_11;
@group(0) @binding(2)
var<storage> global_3: type_11;
@group(0) @binding(3)
var<storage, read_write> global_4: type_11;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var phi_224_: u32;
var phi_1024_: i32;
var phi_1032_: i32;
var phi_1038_: i32;
var phi_1046_: i32;
var phi_1087_: u32;
var phi_1257_: u32;
var phi_1441_: u32;
var phi_1611_: u32;
var phi_1820_: vec3<f32>;
var phi_2422_: i32;
var phi_2425_: i32;
var phi_2427_: i32;
var phi_2429_: i32;
var phi_2444_: i32;
var phi_2450_: i32;
var phi_2423_: i32;
var phi_2426_: i32;
var phi_2428_: i32;
var phi_2430_: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_2525_: i32;
var local_15: i32;
var local_16: i32;
var phi_2531_: i32;
var local_17: i32;
var phi_2538_: i32;
var local_18: i32;
var local_19: i32;
var phi_2544_: i32;
var local_20: i32;
var local_21: i32;
var phi_2555_: i32;
var local_22: i32;
var local_23: i32;
var phi_2567_: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var phi_2803_: i32;
var phi_2806_: i32;
var phi_2808_: i32;
var phi_2810_: i32;
var phi_2825_: i32;
var phi_2831_: i32;
var phi_2804_: i32;
var phi_2807_: i32;
var phi_2809_: i32;
var phi_2811_: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var phi_2906_: i32;
var local_31: i32;
var local_32: i32;
var phi_2912_: i32;
var local_33: i32;
var phi_2919_: i32;
var local_34: i32;
var local_35: i32;
var phi_2925_: i32;
var local_36: i32;
var local_37: i32;
var phi_2936_: i32;
var local_38: i32;
var local_39: i32;
var phi_2948_: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var phi_3203_: vec3<f32>;
var phi_3204_: vec3<f32>;
var phi_3205_: vec3<f32>;
let _e96 = global;
let _e105 = global_1.member.member_2;
let _e108 = global_1.member.member;
let _e116 = (_e96.x + _e105.member);
let _e118 = (_e96.y + _e105.member_1);
if (_e116 < _e105.member_2) {
if (_e118 < _e105.member_3) {
let _e121 = (_e108.member * _e108.member_1);
let _e123 = ((_e118 * _e108.member) + _e116);
let _e127 = global_1.member.member_3.member;
let _e131 = global_1.member.member_3.member_1;
let _e132 = (_e116 % 16u);
let _e133 = (_e118 % 4u);
if ((_e116 < (_e127 - (_e127 % 16u))) && (_e118 < (_e131 - (_e131 % 4u)))) {
phi_224_ = ((((_e118 - _e133) + (_e132 / 4u)) * _e127) + (((_e116 - _e132) + (_e133 * 4u)) + (_e132 % 4u)));
} else {
phi_224_ = ((_e118 * _e127) + _e116);
}
let _e154 = phi_224_;
local_10 = bitcast<i32>(_e154);
let _e157 = bitcast<i32>((_e127 * _e131));
local_11 = _e157;
let _e158 = local_11;
let _e160 = local_10;
let _e161 = ((7i * _e158) + _e160);
let _e163 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e165 = select(_e163, _e161, (_e161 < _e163));
let _e170 = global_2.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e171 = local_11;
let _e173 = local_10;
let _e174 = ((9i * _e171) + _e173);
let _e176 = select(_e163, _e174, (_e174 < _e163));
let _e181 = global_2.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e182 = local_11;
let _e184 = local_10;
let _e185 = ((10i * _e182) + _e184);
let _e187 = select(_e163, _e185, (_e185 < _e163));
let _e192 = global_2.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e193 = local_11;
let _e195 = local_10;
let _e196 = ((11i * _e193) + _e195);
let _e198 = select(_e163, _e196, (_e196 < _e163));
let _e203 = global_2.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e204 = local_11;
let _e206 = local_10;
let _e207 = ((12i * _e204) + _e206);
let _e209 = select(_e163, _e207, (_e207 < _e163));
let _e214 = global_2.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e215 = local_11;
let _e217 = local_10;
let _e218 = ((8i * _e215) + _e217);
let _e220 = select(_e163, _e218, (_e218 < _e163));
let _e225 = global_2.member[bitcast<u32>(select(0i, _e220, (_e220 > 0i)))];
let _e226 = local_11;
let _e228 = local_10;
let _e229 = ((13i * _e226) + _e228);
let _e231 = select(_e163, _e229, (_e229 < _e163));
let _e236 = global_2.member[bitcast<u32>(select(0i, _e231, (_e231 > 0i)))];
let _e237 = local_11;
let _e239 = local_10;
let _e240 = ((14i * _e237) + _e239);
let _e242 = select(_e163, _e240, (_e240 < _e163));
let _e247 = global_2.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e248 = local_11;
let _e250 = local_10;
let _e251 = ((15i * _e248) + _e250);
let _e253 = select(_e163, _e251, (_e251 < _e163));
let _e258 = global_2.member[bitcast<u32>(select(0i, _e253, (_e253 > 0i)))];
let _e259 = local_11;
let _e261 = local_10;
let _e262 = ((3i * _e259) + _e261);
let _e264 = select(_e163, _e262, (_e262 < _e163));
let _e269 = global_2.member[bitcast<u32>(select(0i, _e264, (_e264 > 0i)))];
let _e270 = local_11;
let _e272 = local_10;
let _e273 = ((4i * _e270) + _e272);
let _e275 = select(_e163, _e273, (_e273 < _e163));
let _e280 = global_2.member[bitcast<u32>(select(0i, _e275, (_e275 > 0i)))];
let _e281 = local_11;
let _e283 = local_10;
let _e284 = ((5i * _e281) + _e283);
let _e286 = select(_e163, _e284, (_e284 < _e163));
let _e291 = global_2.member[bitcast<u32>(select(0i, _e286, (_e286 > 0i)))];
let _e296 = (((_e269 * _e269) + (_e280 * _e280)) + (_e291 * _e291));
let _e299 = sqrt(select(0f, _e296, (_e296 > 0f)));
let _e302 = (1f / select(1e-20f, _e299, (_e299 > 1e-20f)));
let _e303 = (_e269 * _e302);
let _e304 = (_e280 * _e302);
let _e305 = (_e291 * _e302);
let _e306 = (_e170 == 0f);
let _e307 = local_10;
let _e309 = select(_e163, _e307, (_e307 < _e163));
let _e314 = global_2.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e315 = local_11;
let _e316 = local_10;
let _e317 = (_e315 + _e316);
let _e319 = select(_e163, _e317, (_e317 < _e163));
let _e324 = global_2.member[bitcast<u32>(select(0i, _e319, (_e319 > 0i)))];
let _e325 = local_11;
let _e327 = local_10;
let _e328 = ((2i * _e325) + _e327);
let _e330 = select(_e163, _e328, (_e328 < _e163));
let _e335 = global_2.member[bitcast<u32>(select(0i, _e330, (_e330 > 0i)))];
let _e339 = global_1.member.member_5.member_1;
let _e342 = select(0f, ((_e339 - _e335) / _e291), _e306);
let _e346 = (_e314 + (_e269 * _e342));
let _e347 = (_e324 + (_e280 * _e342));
let _e348 = (_e335 + (_e291 * _e342));
let _e353 = global_1.member.member_13.member.member;
let _e364 = ((((_e353.member.member * _e346) + (_e353.member.member_1 * _e347)) + (_e353.member.member_2 * _e348)) + _e353.member_1);
let _e370 = -((((_e353.member.member * _e303) + (_e353.member.member_1 * _e304)) + (_e353.member.member_2 * _e305)));
let _e372 = (_e370 > 1e-9f);
let _e376 = ((_e364 / select(1e-9f, _e370, _e372)) - 0f);
let _e379 = select(1e30f, select(0f, _e376, (_e376 > 0f)), ((_e364 > 0f) && _e372));
let _e384 = global_1.member.member_13.member_1.member;
let _e395 = ((((_e384.member.member * _e346) + (_e384.member.member_1 * _e347)) + (_e384.member.member_2 * _e348)) + _e384.member_1);
let _e401 = -((((_e384.member.member * _e303) + (_e384.member.member_1 * _e304)) + (_e384.member.member_2 * _e305)));
let _e403 = (_e401 > 1e-9f);
let _e407 = ((_e395 / select(1e-9f, _e401, _e403)) - 0f);
let _e410 = select(1e30f, select(0f, _e407, (_e407 > 0f)), ((_e395 > 0f) && _e403));
let _e414 = (_e410 < _e379);
let _e416 = select(select(-2i, -3i, _e414), -1i, ((_e379 >= 1e30f) && (_e410 >= 1e30f)));
let _e418 = (_e416 == -3i);
let _e424 = global_1.member.member_13.member_1.member.member;
let _e429 = global_1.member.member_13.member_1.member_1;
let _e435 = global_1.member.member_13.member.member.member;
let _e440 = global_1.member.member_13.member.member_1;
let _e462 = global_1.member.member_9.member_1;
let _e469 = global_1.member.member_9.member;
let _e477 = (((_e469.member * _e469.member) + (_e469.member_1 * _e469.member_1)) + (_e469.member_2 * _e469.member_2));
let _e480 = sqrt(select(0f, _e477, (_e477 > 0f)));
let _e483 = global_1.member.member_1;
let _e486 = (1e-6f * _e480);
let _e490 = select((_e480 / select(_e486, _e469.member_2, (_e469.member_2 > _e486))), 1f, ((_e483 & 8u) != 0u));
let _e496 = global_1.member.member_18;
let _e508 = (-((((select(_e435.member, _e424.member, _e418) * _e469.member) + (select(_e435.member_1, _e424.member_1, _e418) * _e469.member_1)) + (select(_e435.member_2, _e424.member_2, _e418) * _e469.member_2))) / select(1e-20f, _e480, (_e480 > 1e-20f)));
let _e513 = bitcast<f32>((bitcast<u32>(select(0f, _e508, (_e508 > 0f))) & 2147483647u));
let _e526 = select(0f, (1f - _e214), (_e306 && (_e416 != -1i)));
let _e536 = (_e214 + _e526);
let _e541 = (1f - _e536);
let _e542 = local_10;
local_8 = _e542;
local_9 = _e157;
let _e543 = local_9;
let _e545 = local_8;
let _e546 = ((3i * _e543) + _e545);
let _e548 = select(_e163, _e546, (_e546 < _e163));
let _e553 = global_2.member[bitcast<u32>(select(0i, _e548, (_e548 > 0i)))];
let _e554 = local_9;
let _e556 = local_8;
let _e557 = ((4i * _e554) + _e556);
let _e559 = select(_e163, _e557, (_e557 < _e163));
let _e564 = global_2.member[bitcast<u32>(select(0i, _e559, (_e559 > 0i)))];
let _e565 = local_9;
let _e567 = local_8;
let _e568 = ((5i * _e565) + _e567);
let _e570 = select(_e163, _e568, (_e568 < _e163));
let _e575 = global_2.member[bitcast<u32>(select(0i, _e570, (_e570 > 0i)))];
let _e580 = (((_e553 * _e553) + (_e564 * _e564)) + (_e575 * _e575));
let _e583 = sqrt(select(0f, _e580, (_e580 > 0f)));
let _e586 = (1f / select(1e-20f, _e583, (_e583 > 1e-20f)));
let _e587 = (_e553 * _e586);
let _e588 = (_e564 * _e586);
let _e589 = (_e575 * _e586);
let _e593 = global_1.member.member_21.member_4;
let _e601 = (((_e593.member * _e587) + (_e593.member_1 * _e588)) + (_e593.member_2 * _e589));
let _e605 = global_1.member.member_21.member_5;
let _e613 = (((_e605.member * _e587) + (_e605.member_1 * _e588)) + (_e605.member_2 * _e589));
let _e617 = global_1.member.member_21.member_6;
let _e625 = (((_e617.member * _e587) + (_e617.member_1 * _e588)) + (_e617.member_2 * _e589));
let _e626 = bitcast<i32>(_e116);
let _e627 = bitcast<i32>(_e118);
if (_e626 > 0i) {
phi_1024_ = (_e626 - 1i);
} else {
phi_1024_ = 0i;
}
let _e633 = phi_1024_;
let _e634 = (bitcast<i32>(_e127) - 1i);
if (_e626 < _e634) {
phi_1032_ = (_e626 + 1i);
} else {
phi_1032_ = _e634;
}
let _e638 = phi_1032_;
if (_e627 > 0i) {
phi_1038_ = (_e627 - 1i);
} else {
phi_1038_ = 0i;
}
let _e642 = phi_1038_;
let _e643 = (bitcast<i32>(_e131) - 1i);
if (_e627 < _e643) {
phi_1046_ = (_e627 + 1i);
} else {
phi_1046_ = _e643;
}
let _e647 = phi_1046_;
let _e650 = global_1.member.member_3.member;
let _e653 = global_1.member.member_3.member_1;
let _e654 = bitcast<u32>(_e638);
let _e655 = bitcast<u32>(_e627);
let _e656 = (_e654 % 16u);
let _e657 = (_e655 % 4u);
let _e659 = (_e650 - (_e650 % 16u));
let _e662 = (_e653 - (_e653 % 4u));
let _e663 = (_e655 < _e662);
if ((_e654 < _e659) && _e663) {
phi_1087_ = ((((_e655 - _e657) + (_e656 / 4u)) * _e650) + (((_e654 - _e656) + (_e657 * 4u)) + (_e656 % 4u)));
} else {
phi_1087_ = ((_e655 * _e650) + _e654);
}
let _e678 = phi_1087_;
local_6 = bitcast<i32>(_e678);
let _e681 = bitcast<i32>((_e650 * _e653));
local_7 = _e681;
let _e682 = local_7;
let _e684 = local_6;
let _e685 = ((3i * _e682) + _e684);
let _e687 = select(_e163, _e685, (_e685 < _e163));
let _e692 = global_2.member[bitcast<u32>(select(0i, _e687, (_e687 > 0i)))];
let _e693 = local_7;
let _e695 = local_6;
let _e696 = ((4i * _e693) + _e695);
let _e698 = select(_e163, _e696, (_e696 < _e163));
let _e703 = global_2.member[bitcast<u32>(select(0i, _e698, (_e698 > 0i)))];
let _e704 = local_7;
let _e706 = local_6;
let _e707 = ((5i * _e704) + _e706);
let _e709 = select(_e163, _e707, (_e707 < _e163));
let _e714 = global_2.member[bitcast<u32>(select(0i, _e709, (_e709 > 0i)))];
let _e719 = (((_e692 * _e692) + (_e703 * _e703)) + (_e714 * _e714));
let _e722 = sqrt(select(0f, _e719, (_e719 > 0f)));
let _e725 = (1f / select(1e-20f, _e722, (_e722 > 1e-20f)));
let _e726 = (_e692 * _e725);
let _e727 = (_e703 * _e725);
let _e728 = (_e714 * _e725);
let _e731 = global_1.member.member_21.member_4;
let _e742 = global_1.member.member_21.member_5;
let _e753 = global_1.member.member_21.member_6;
let _e762 = bitcast<u32>(_e633);
let _e763 = (_e762 % 16u);
if ((_e762 < _e659) && _e663) {
phi_1257_ = ((((_e655 - _e657) + (_e763 / 4u)) * _e650) + (((_e762 - _e763) + (_e657 * 4u)) + (_e763 % 4u)));
} else {
phi_1257_ = ((_e655 * _e650) + _e762);
}
let _e779 = phi_1257_;
local_4 = bitcast<i32>(_e779);
local_5 = _e681;
let _e781 = local_5;
let _e783 = local_4;
let _e784 = ((3i * _e781) + _e783);
let _e786 = select(_e163, _e784, (_e784 < _e163));
let _e791 = global_2.member[bitcast<u32>(select(0i, _e786, (_e786 > 0i)))];
let _e792 = local_5;
let _e794 = local_4;
let _e795 = ((4i * _e792) + _e794);
let _e797 = select(_e163, _e795, (_e795 < _e163));
let _e802 = global_2.member[bitcast<u32>(select(0i, _e797, (_e797 > 0i)))];
let _e803 = local_5;
let _e805 = local_4;
let _e806 = ((5i * _e803) + _e805);
let _e808 = select(_e163, _e806, (_e806 < _e163));
let _e813 = global_2.member[bitcast<u32>(select(0i, _e808, (_e808 > 0i)))];
let _e818 = (((_e791 * _e791) + (_e802 * _e802)) + (_e813 * _e813));
let _e821 = sqrt(select(0f, _e818, (_e818 > 0f)));
let _e824 = (1f / select(1e-20f, _e821, (_e821 > 1e-20f)));
let _e825 = (_e791 * _e824);
let _e826 = (_e802 * _e824);
let _e827 = (_e813 * _e824);
let _e843 = ((((_e731.member * _e726) + (_e731.member_1 * _e727)) + (_e731.member_2 * _e728)) - (((_e731.member * _e825) + (_e731.member_1 * _e826)) + (_e731.member_2 * _e827)));
let _e844 = ((((_e742.member * _e726) + (_e742.member_1 * _e727)) + (_e742.member_2 * _e728)) - (((_e742.member * _e825) + (_e742.member_1 * _e826)) + (_e742.member_2 * _e827)));
let _e845 = ((((_e753.member * _e726) + (_e753.member_1 * _e727)) + (_e753.member_2 * _e728)) - (((_e753.member * _e825) + (_e753.member_1 * _e826)) + (_e753.member_2 * _e827)));
let _e850 = (((_e843 * _e843) + (_e844 * _e844)) + (_e845 * _e845));
let _e854 = bitcast<u32>(_e626);
let _e855 = bitcast<u32>(_e647);
let _e856 = (_e854 % 16u);
let _e857 = (_e855 % 4u);
let _e858 = (_e854 < _e659);
if (_e858 && (_e855 < _e662)) {
phi_1441_ = ((((_e855 - _e857) + (_e856 / 4u)) * _e650) + (((_e854 - _e856) + (_e857 * 4u)) + (_e856 % 4u)));
} else {
phi_1441_ = ((_e855 * _e650) + _e854);
}
let _e874 = phi_1441_;
local_2 = bitcast<i32>(_e874);
local_3 = _e681;
let _e876 = local_3;
let _e878 = local_2;
let _e879 = ((3i * _e876) + _e878);
let _e881 = select(_e163, _e879, (_e879 < _e163));
let _e886 = global_2.member[bitcast<u32>(select(0i, _e881, (_e881 > 0i)))];
let _e887 = local_3;
let _e889 = local_2;
let _e890 = ((4i * _e887) + _e889);
let _e892 = select(_e163, _e890, (_e890 < _e163));
let _e897 = global_2.member[bitcast<u32>(select(0i, _e892, (_e892 > 0i)))];
let _e898 = local_3;
let _e900 = local_2;
let _e901 = ((5i * _e898) + _e900);
let _e903 = select(_e163, _e901, (_e901 < _e163));
let _e908 = global_2.member[bitcast<u32>(select(0i, _e903, (_e903 > 0i)))];
let _e913 = (((_e886 * _e886) + (_e897 * _e897)) + (_e908 * _e908));
let _e916 = sqrt(select(0f, _e913, (_e913 > 0f)));
let _e919 = (1f / select(1e-20f, _e916, (_e916 > 1e-20f)));
let _e920 = (_e886 * _e919);
let _e921 = (_e897 * _e919);
let _e922 = (_e908 * _e919);
let _e938 = bitcast<u32>(_e642);
let _e939 = (_e938 % 4u);
if (_e858 && (_e938 < _e662)) {
phi_1611_ = ((((_e938 - _e939) + (_e856 / 4u)) * _e650) + (((_e854 - _e856) + (_e939 * 4u)) + (_e856 % 4u)));
} else {
phi_1611_ = ((_e938 * _e650) + _e854);
}
let _e955 = phi_1611_;
local = bitcast<i32>(_e955);
local_1 = _e681;
let _e957 = local_1;
let _e959 = local;
let _e960 = ((3i * _e957) + _e959);
let _e962 = select(_e163, _e960, (_e960 < _e163));
let _e967 = global_2.member[bitcast<u32>(select(0i, _e962, (_e962 > 0i)))];
let _e968 = local_1;
let _e970 = local;
let _e971 = ((4i * _e968) + _e970);
let _e973 = select(_e163, _e971, (_e971 < _e163));
let _e978 = global_2.member[bitcast<u32>(select(0i, _e973, (_e973 > 0i)))];
let _e979 = local_1;
let _e981 = local;
let _e982 = ((5i * _e979) + _e981);
let _e984 = select(_e163, _e982, (_e982 < _e163));
let _e989 = global_2.member[bitcast<u32>(select(0i, _e984, (_e984 > 0i)))];
let _e994 = (((_e967 * _e967) + (_e978 * _e978)) + (_e989 * _e989));
let _e997 = sqrt(select(0f, _e994, (_e994 > 0f)));
let _e1000 = (1f / select(1e-20f, _e997, (_e997 > 1e-20f)));
let _e1001 = (_e967 * _e1000);
let _e1002 = (_e978 * _e1000);
let _e1003 = (_e989 * _e1000);
let _e1019 = ((((_e731.member * _e920) + (_e731.member_1 * _e921)) + (_e731.member_2 * _e922)) - (((_e731.member * _e1001) + (_e731.member_1 * _e1002)) + (_e731.member_2 * _e1003)));
let _e1020 = ((((_e742.member * _e920) + (_e742.member_1 * _e921)) + (_e742.member_2 * _e922)) - (((_e742.member * _e1001) + (_e742.member_1 * _e1002)) + (_e742.member_2 * _e1003)));
let _e1021 = ((((_e753.member * _e920) + (_e753.member_1 * _e921)) + (_e753.member_2 * _e922)) - (((_e753.member * _e1001) + (_e753.member_1 * _e1002)) + (_e753.member_2 * _e1003)));
let _e1026 = (((_e1019 * _e1019) + (_e1020 * _e1020)) + (_e1021 * _e1021));
let _e1031 = f32((_e638 - _e633));
let _e1034 = (sqrt(select(0f, _e850, (_e850 > 0f))) / select(1f, _e1031, (_e1031 > 1f)));
let _e1036 = f32((_e647 - _e642));
let _e1039 = (sqrt(select(0f, _e1026, (_e1026 > 0f))) / select(1f, _e1036, (_e1036 > 1f)));
let _e1041 = select(_e1039, _e1034, (_e1034 > _e1039));
let _e1045 = global_1.member.member_21.member;
let _e1049 = global_1.member.member_21.member_7;
let _e1053 = vec3<f32>(_e1049.member, _e1049.member_1, _e1049.member_2);
let _e1057 = global_1.member.member_21.member_8;
if (_e1045 == 0u) {
phi_3205_ = _e1053;
} else {
if (_e1045 == 1u) {
let _e1064 = select(-1f, _e625, (_e625 > -1f));
let _e1066 = select(1f, _e1064, (_e1064 < 1f));
if (_e1066 > 0f) {
phi_1820_ = _e1053;
} else {
let _e1071 = global_1.member.member_21.member_9;
phi_1820_ = vec3<f32>(_e1071.member, _e1071.member_1, _e1071.member_2);
}
let _e1077 = phi_1820_;
let _e1086 = bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u));
let _e1089 = sqrt(select(0f, _e1086, (_e1086 > 0f)));
phi_3204_ = vec3<f32>((_e1057.member + ((_e1077.x - _e1057.member) * _e1089)), (_e1057.member_1 + ((_e1077.y - _e1057.member_1) * _e1089)), (_e1057.member_2 + ((_e1077.z - _e1057.member_2) * _e1089)));
} else {
if (_e1045 == 2u) {
let _e1101 = global_1.member.member_21.member_10;
let _e1102 = (_e1041 / _e1101);
let _e1104 = select(1e-4f, _e1102, (_e1102 > 1e-4f));
let _e1107 = bitcast<f32>((bitcast<u32>(_e601) & 2147483647u));
let _e1110 = bitcast<f32>((bitcast<u32>(_e613) & 2147483647u));
let _e1114 = select(_e1110, _e1107, (_e1107 > _e1110));
let _e1117 = (select(_e1110, _e1107, (_e1107 < _e1110)) / select(1.1754944e-38f, _e1114, (_e1114 > 1.1754944e-38f)));
let _e1118 = (_e1117 > 0.41421357f);
let _e1122 = select(_e1117, ((_e1117 - 1f) / (_e1117 + 1f)), _e1118);
let _e1123 = (_e1122 * _e1122);
let _e1138 = (select(0f, 0.7853982f, _e1118) + (_e1122 + ((_e1122 * _e1123) * (-0.33333334f + (_e1123 * (0.2f + (_e1123 * (-0.14285713f + (_e1123 * (0.11111111f + (_e1123 * (-0.09090909f + (_e1123 * 0.0585f)))))))))))));
let _e1141 = select(_e1138, (1.5707964f - _e1138), (_e1110 > _e1107));
let _e1144 = select(_e1141, (3.1415927f - _e1141), (_e601 < 0f));
let _e1150 = (1f - (_e625 * _e625));
let _e1153 = sqrt(select(0f, _e1150, (_e1150 > 0f)));
let _e1156 = (_e1104 / select(1e-3f, _e1153, (_e1153 > 1e-3f)));
let _e1157 = ((select(_e1144, -(_e1144), (_e613 < 0f)) / _e1101) * 0.5f);
let _e1159 = select(-8e6f, _e1157, (_e1157 > -8e6f));
let _e1161 = select(8e6f, _e1159, (_e1159 < 8e6f));
let _e1168 = select(0i, select(select(i32(_e1161), i32(-2147483648), (_e1161 < -2147483600f)), 2147483647i, (_e1161 > 2147483500f)), (_e1161 == _e1161));
let _e1175 = ((_e1157 - f32((_e1168 - select(0i, 1i, (_e1161 < f32(_e1168)))))) * 2f);
let _e1183 = ((select(select((_e1175 - 2f), (1f - _e1175), (_e1175 < 1.5f)), _e1175, (_e1175 < 0.5f)) * 2f) / _e1156);
let _e1185 = select(-1f, _e1183, (_e1183 > -1f));
let _e1188 = (2f - _e1156);
let _e1190 = select(0f, _e1188, (_e1188 > 0f));
let _e1195 = select(-1f, _e625, (_e625 > -1f));
let _e1197 = select(1f, _e1195, (_e1195 < 1f));
let _e1200 = ((1f - _e1197) * (1f + _e1197));
let _e1203 = sqrt(select(0f, _e1200, (_e1200 > 0f)));
let _e1206 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
let _e1209 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
let _e1213 = select(_e1209, _e1206, (_e1206 > _e1209));
let _e1216 = (select(_e1209, _e1206, (_e1206 < _e1209)) / select(1.1754944e-38f, _e1213, (_e1213 > 1.1754944e-38f)));
let _e1217 = (_e1216 > 0.41421357f);
let _e1221 = select(_e1216, ((_e1216 - 1f) / (_e1216 + 1f)), _e1217);
let _e1222 = (_e1221 * _e1221);
let _e1237 = (select(0f, 0.7853982f, _e1217) + (_e1221 + ((_e1221 * _e1222) * (-0.33333334f + (_e1222 * (0.2f + (_e1222 * (-0.14285713f + (_e1222 * (0.11111111f + (_e1222 * (-0.09090909f + (_e1222 * 0.0585f)))))))))))));
let _e1240 = select(_e1237, (1.5707964f - _e1237), (_e1209 > _e1206));
let _e1243 = select(_e1240, (3.1415927f - _e1240), (_e1203 < 0f));
let _e1248 = ((select(_e1243, -(_e1243), (_e1197 < 0f)) / _e1101) * 0.5f);
let _e1250 = select(-8e6f, _e1248, (_e1248 > -8e6f));
let _e1252 = select(8e6f, _e1250, (_e1250 < 8e6f));
let _e1259 = select(0i, select(select(i32(_e1252), i32(-2147483648), (_e1252 < -2147483600f)), 2147483647i, (_e1252 > 2147483500f)), (_e1252 == _e1252));
let _e1266 = ((_e1248 - f32((_e1259 - select(0i, 1i, (_e1252 < f32(_e1259)))))) * 2f);
let _e1274 = ((select(select((_e1266 - 2f), (1f - _e1266), (_e1266 < 1.5f)), _e1266, (_e1266 < 0.5f)) * 2f) / _e1104);
let _e1276 = select(-1f, _e1274, (_e1274 > -1f));
let _e1279 = (2f - _e1104);
let _e1281 = select(0f, _e1279, (_e1279 > 0f));
let _e1287 = (0.5f + ((0.5f * (select(1f, _e1185, (_e1185 < 1f)) * select(1f, _e1190, (_e1190 < 1f)))) * (select(1f, _e1276, (_e1276 < 1f)) * select(1f, _e1281, (_e1281 < 1f)))));
phi_3203_ = vec3<f32>((_e1049.member + ((_e1057.member - _e1049.member) * _e1287)), (_e1049.member_1 + ((_e1057.member_1 - _e1049.member_1) * _e1287)), (_e1049.member_2 + ((_e1057.member_2 - _e1049.member_2) * _e1287)));
} else {
let _e1301 = global_1.member.member_21.member_1;
let _e1302 = bitcast<i32>(_e1301);
let _e1307 = global_1.member.member_21.member_3;
let _e1309 = f32(bitcast<i32>(_e1307));
let _e1311 = (2f * 3.1415927f);
let _e1312 = ((_e1041 * f32(_e1302)) / _e1311);
let _e1314 = select(1e-6f, _e1312, (_e1312 > 1e-6f));
let _e1317 = bitcast<u32>(select(1.1754944e-38f, _e1314, (_e1314 > 1.1754944e-38f)));
let _e1318 = (_e1317 & 8388607u);
let _e1320 = select(0u, 1u, (_e1318 > 3474675u));
let _e1331 = bitcast<f32>((_e1318 | ((127u - _e1320) << bitcast<u32>(23i))));
let _e1334 = ((_e1331 - 1f) / (_e1331 + 1f));
let _e1335 = (_e1334 * _e1334);
let _e1350 = (f32(((bitcast<i32>((_e1317 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1320))) + (((2f * _e1334) + ((_e1334 * _e1335) * (0.6666667f + (_e1335 * (0.4f + (_e1335 * (0.2857143f + (_e1335 * (0.22222222f + (_e1335 * 0.18181819f)))))))))) * 1.442695f));
let _e1351 = (_e1309 - 1f);
let _e1353 = select(0f, _e1350, (_e1350 > 0f));
let _e1355 = select(_e1351, _e1353, (_e1353 < _e1351));
let _e1356 = (_e1309 - 2f);
let _e1358 = select(0f, _e1356, (_e1356 > 0f));
let _e1360 = select(0f, _e1355, (_e1355 > 0f));
let _e1362 = select(_e1358, _e1360, (_e1360 < _e1358));
let _e1369 = select(0i, select(select(i32(_e1362), i32(-2147483648), (_e1362 < -2147483600f)), 2147483647i, (_e1362 > 2147483500f)), (_e1362 == _e1362));
let _e1373 = (_e1369 - select(0i, 1i, (_e1362 < f32(_e1369))));
let _e1376 = bitcast<f32>((bitcast<u32>(_e613) & 2147483647u));
let _e1379 = bitcast<f32>((bitcast<u32>(_e601) & 2147483647u));
let _e1383 = select(_e1379, _e1376, (_e1376 > _e1379));
let _e1386 = (select(_e1379, _e1376, (_e1376 < _e1379)) / select(1.1754944e-38f, _e1383, (_e1383 > 1.1754944e-38f)));
let _e1387 = (_e1386 > 0.41421357f);
let _e1391 = select(_e1386, ((_e1386 - 1f) / (_e1386 + 1f)), _e1387);
let _e1392 = (_e1391 * _e1391);
let _e1407 = (select(0f, 0.7853982f, _e1387) + (_e1391 + ((_e1391 * _e1392) * (-0.33333334f + (_e1392 * (0.2f + (_e1392 * (-0.14285713f + (_e1392 * (0.11111111f + (_e1392 * (-0.09090909f + (_e1392 * 0.0585f)))))))))))));
let _e1410 = select(_e1407, (1.5707964f - _e1407), (_e1379 > _e1376));
let _e1413 = select(_e1410, (3.1415927f - _e1410), (_e613 < 0f));
let _e1418 = (0.5f - (select(_e1413, -(_e1413), (_e601 < 0f)) / _e1311));
let _e1420 = select(-1f, _e625, (_e625 > -1f));
let _e1422 = select(1f, _e1420, (_e1420 < 1f));
let _e1425 = ((1f - _e1422) * (1f + _e1422));
let _e1428 = sqrt(select(0f, _e1425, (_e1425 > 0f)));
let _e1431 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
let _e1434 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
let _e1438 = select(_e1434, _e1431, (_e1431 > _e1434));
let _e1441 = (select(_e1434, _e1431, (_e1431 < _e1434)) / select(1.1754944e-38f, _e1438, (_e1438 > 1.1754944e-38f)));
let _e1442 = (_e1441 > 0.41421357f);
let _e1446 = select(_e1441, ((_e1441 - 1f) / (_e1441 + 1f)), _e1442);
let _e1447 = (_e1446 * _e1446);
let _e1462 = (select(0f, 0.7853982f, _e1442) + (_e1446 + ((_e1446 * _e1447) * (-0.33333334f + (_e1447 * (0.2f + (_e1447 * (-0.14285713f + (_e1447 * (0.11111111f + (_e1447 * (-0.09090909f + (_e1447 * 0.0585f)))))))))))));
let _e1465 = select(_e1462, (1.5707964f - _e1462), (_e1434 > _e1431));
let _e1468 = select(_e1465, (3.1415927f - _e1465), (_e1428 < 0f));
let _e1473 = (0.5f - (select(_e1468, -(_e1468), (_e1422 < 0f)) / 3.1415927f));
let _e1477 = global_1.member.member_21.member_2;
let _e1478 = bitcast<i32>(_e1477);
phi_2422_ = 0i;
phi_2425_ = 0i;
phi_2427_ = _e1478;
phi_2429_ = _e1302;
loop {
let _e1480 = phi_2422_;
let _e1482 = phi_2425_;
let _e1484 = phi_2427_;
let _e1486 = phi_2429_;
local_12 = _e1486;
local_13 = _e1484;
local_14 = _e1486;
local_15 = _e1486;
local_16 = _e1486;
local_17 = _e1486;
local_18 = _e1486;
local_19 = _e1486;
local_20 = _e1484;
local_21 = _e1484;
local_22 = _e1484;
local_23 = _e1484;
local_24 = _e1486;
local_25 = _e1482;
local_26 = _e1486;
local_27 = _e1482;
let _e1487 = (_e1480 < _e1373);
if _e1487 {
if (_e1486 > 1i) {
phi_2444_ = (_e1486 >> bitcast<u32>(1i));
} else {
phi_2444_ = 1i;
}
let _e1494 = phi_2444_;
if (_e1484 > 1i) {
phi_2450_ = (_e1484 >> bitcast<u32>(1i));
} else {
phi_2450_ = 1i;
}
let _e1499 = phi_2450_;
phi_2423_ = (_e1480 + 1i);
phi_2426_ = (_e1482 + (_e1486 * _e1484));
phi_2428_ = _e1499;
phi_2430_ = _e1494;
} else {
phi_2423_ = i32();
phi_2426_ = i32();
phi_2428_ = i32();
phi_2430_ = i32();
}
let _e1502 = phi_2423_;
let _e1504 = phi_2426_;
let _e1506 = phi_2428_;
let _e1508 = phi_2430_;
continue;
continuing {
phi_2422_ = _e1502;
phi_2425_ = _e1504;
phi_2427_ = _e1506;
phi_2429_ = _e1508;
break if !(_e1487);
}
}
let _e1511 = local_12;
let _e1512 = f32(_e1511);
let _e1514 = ((_e1418 * _e1512) - 0.5f);
let _e1516 = local_13;
let _e1517 = f32(_e1516);
let _e1519 = ((_e1473 * _e1517) - 0.5f);
let _e1521 = select(-1f, _e1514, (_e1514 > -1f));
let _e1523 = select(_e1512, _e1521, (_e1521 < _e1512));
let _e1530 = select(0i, select(select(i32(_e1523), i32(-2147483648), (_e1523 < -2147483600f)), 2147483647i, (_e1523 > 2147483500f)), (_e1523 == _e1523));
let _e1534 = (_e1530 - select(0i, 1i, (_e1523 < f32(_e1530))));
let _e1536 = select(-1f, _e1519, (_e1519 > -1f));
let _e1538 = select(_e1517, _e1536, (_e1536 < _e1517));
let _e1545 = select(0i, select(select(i32(_e1538), i32(-2147483648), (_e1538 < -2147483600f)), 2147483647i, (_e1538 > 2147483500f)), (_e1538 == _e1538));
let _e1549 = (_e1545 - select(0i, 1i, (_e1538 < f32(_e1545))));
let _e1551 = (_e1514 - f32(_e1534));
let _e1553 = (_e1519 - f32(_e1549));
let _e1555 = select(0f, _e1553, (_e1553 > 0f));
let _e1557 = select(1f, _e1555, (_e1555 < 1f));
if (_e1534 < 0i) {
let _e1560 = local_14;
phi_2525_ = (_e1534 + _e1560);
} else {
phi_2525_ = _e1534;
}
let _e1563 = phi_2525_;
let _e1565 = local_15;
if (_e1563 >= _e1565) {
let _e1568 = local_16;
phi_2531_ = (_e1563 - _e1568);
} else {
phi_2531_ = _e1563;
}
let _e1571 = phi_2531_;
let _e1572 = (_e1534 + 1i);
if (_e1572 < 0i) {
let _e1575 = local_17;
phi_2538_ = (_e1572 + _e1575);
} else {
phi_2538_ = _e1572;
}
let _e1578 = phi_2538_;
let _e1580 = local_18;
if (_e1578 >= _e1580) {
let _e1583 = local_19;
phi_2544_ = (_e1578 - _e1583);
} else {
phi_2544_ = _e1578;
}
let _e1586 = phi_2544_;
let _e1588 = select(_e1549, 0i, (_e1549 < 0i));
let _e1590 = local_20;
if (_e1588 >= _e1590) {
let _e1593 = local_21;
phi_2555_ = (_e1593 - 1i);
} else {
phi_2555_ = _e1588;
}
let _e1596 = phi_2555_;
let _e1597 = (_e1549 + 1i);
let _e1599 = select(_e1597, 0i, (_e1597 < 0i));
let _e1601 = local_22;
if (_e1599 >= _e1601) {
let _e1604 = local_23;
phi_2567_ = (_e1604 - 1i);
} else {
phi_2567_ = _e1599;
}
let _e1607 = phi_2567_;
let _e1609 = local_24;
let _e1612 = local_25;
let _e1613 = (_e1612 + (_e1596 * _e1609));
let _e1615 = local_26;
let _e1618 = local_27;
let _e1619 = (_e1618 + (_e1607 * _e1615));
let _e1621 = (3i * (_e1613 + _e1571));
let _e1623 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1625 = select(_e1623, _e1621, (_e1621 < _e1623));
let _e1631 = global_3.member[bitcast<u32>(select(0i, _e1625, (_e1625 > 0i)))];
let _e1632 = (_e1621 + 1i);
let _e1634 = select(_e1623, _e1632, (_e1632 < _e1623));
let _e1640 = global_3.member[bitcast<u32>(select(0i, _e1634, (_e1634 > 0i)))];
let _e1641 = (_e1621 + 2i);
let _e1643 = select(_e1623, _e1641, (_e1641 < _e1623));
let _e1649 = global_3.member[bitcast<u32>(select(0i, _e1643, (_e1643 > 0i)))];
let _e1651 = (3i * (_e1613 + _e1586));
let _e1653 = select(_e1623, _e1651, (_e1651 < _e1623));
let _e1659 = global_3.member[bitcast<u32>(select(0i, _e1653, (_e1653 > 0i)))];
let _e1660 = (_e1651 + 1i);
let _e1662 = select(_e1623, _e1660, (_e1660 < _e1623));
let _e1668 = global_3.member[bitcast<u32>(select(0i, _e1662, (_e1662 > 0i)))];
let _e1669 = (_e1651 + 2i);
let _e1671 = select(_e1623, _e1669, (_e1669 < _e1623));
let _e1677 = global_3.member[bitcast<u32>(select(0i, _e1671, (_e1671 > 0i)))];
let _e1679 = (3i * (_e1619 + _e1571));
let _e1681 = select(_e1623, _e1679, (_e1679 < _e1623));
let _e1687 = global_3.member[bitcast<u32>(select(0i, _e1681, (_e1681 > 0i)))];
let _e1688 = (_e1679 + 1i);
let _e1690 = select(_e1623, _e1688, (_e1688 < _e1623));
let _e1696 = global_3.member[bitcast<u32>(select(0i, _e1690, (_e1690 > 0i)))];
let _e1697 = (_e1679 + 2i);
let _e1699 = select(_e1623, _e1697, (_e1697 < _e1623));
let _e1705 = global_3.member[bitcast<u32>(select(0i, _e1699, (_e1699 > 0i)))];
let _e1707 = (3i * (_e1619 + _e1586));
let _e1709 = select(_e1623, _e1707, (_e1707 < _e1623));
let _e1715 = global_3.member[bitcast<u32>(select(0i, _e1709, (_e1709 > 0i)))];
let _e1716 = (_e1707 + 1i);
let _e1718 = select(_e1623, _e1716, (_e1716 < _e1623));
let _e1724 = global_3.member[bitcast<u32>(select(0i, _e1718, (_e1718 > 0i)))];
let _e1725 = (_e1707 + 2i);
let _e1727 = select(_e1623, _e1725, (_e1725 < _e1623));
let _e1733 = global_3.member[bitcast<u32>(select(0i, _e1727, (_e1727 > 0i)))];
let _e1740 = (_e1631 + ((_e1659 - _e1631) * _e1551));
let _e1741 = (_e1640 + ((_e1668 - _e1640) * _e1551));
let _e1742 = (_e1649 + ((_e1677 - _e1649) * _e1551));
let _e1758 = (_e1740 + (((_e1687 + ((_e1715 - _e1687) * _e1551)) - _e1740) * _e1557));
let _e1759 = (_e1741 + (((_e1696 + ((_e1724 - _e1696) * _e1551)) - _e1741) * _e1557));
let _e1760 = (_e1742 + (((_e1705 + ((_e1733 - _e1705) * _e1551)) - _e1742) * _e1557));
phi_2803_ = 0i;
phi_2806_ = 0i;
phi_2808_ = _e1478;
phi_2810_ = _e1302;
loop {
let _e1763 = phi_2803_;
let _e1765 = phi_2806_;
let _e1767 = phi_2808_;
let _e1769 = phi_2810_;
local_28 = _e1769;
local_29 = _e1767;
local_30 = _e1769;
local_31 = _e1769;
local_32 = _e1769;
local_33 = _e1769;
local_34 = _e1769;
local_35 = _e1769;
local_36 = _e1767;
local_37 = _e1767;
local_38 = _e1767;
local_39 = _e1767;
local_40 = _e1769;
local_41 = _e1765;
local_42 = _e1769;
local_43 = _e1765;
let _e1770 = (_e1763 < (_e1373 + 1i));
if _e1770 {
if (_e1769 > 1i) {
phi_2825_ = (_e1769 >> bitcast<u32>(1i));
} else {
phi_2825_ = 1i;
}
let _e1777 = phi_2825_;
if (_e1767 > 1i) {
phi_2831_ = (_e1767 >> bitcast<u32>(1i));
} else {
phi_2831_ = 1i;
}
let _e1782 = phi_2831_;
phi_2804_ = (_e1763 + 1i);
phi_2807_ = (_e1765 + (_e1769 * _e1767));
phi_2809_ = _e1782;
phi_2811_ = _e1777;
} else {
phi_2804_ = i32();
phi_2807_ = i32();
phi_2809_ = i32();
phi_2811_ = i32();
}
let _e1785 = phi_2804_;
let _e1787 = phi_2807_;
let _e1789 = phi_2809_;
let _e1791 = phi_2811_;
continue;
continuing {
phi_2803_ = _e1785;
phi_2806_ = _e1787;
phi_2808_ = _e1789;
phi_2810_ = _e1791;
break if !(_e1770);
}
}
let _e1794 = local_28;
let _e1795 = f32(_e1794);
let _e1797 = ((_e1418 * _e1795) - 0.5f);
let _e1799 = local_29;
let _e1800 = f32(_e1799);
let _e1802 = ((_e1473 * _e1800) - 0.5f);
let _e1804 = select(-1f, _e1797, (_e1797 > -1f));
let _e1806 = select(_e1795, _e1804, (_e1804 < _e1795));
let _e1813 = select(0i, select(select(i32(_e1806), i32(-2147483648), (_e1806 < -2147483600f)), 2147483647i, (_e1806 > 2147483500f)), (_e1806 == _e1806));
let _e1817 = (_e1813 - select(0i, 1i, (_e1806 < f32(_e1813))));
let _e1819 = select(-1f, _e1802, (_e1802 > -1f));
let _e1821 = select(_e1800, _e1819, (_e1819 < _e1800));
let _e1828 = select(0i, select(select(i32(_e1821), i32(-2147483648), (_e1821 < -2147483600f)), 2147483647i, (_e1821 > 2147483500f)), (_e1821 == _e1821));
let _e1832 = (_e1828 - select(0i, 1i, (_e1821 < f32(_e1828))));
let _e1834 = (_e1797 - f32(_e1817));
let _e1836 = (_e1802 - f32(_e1832));
let _e1838 = select(0f, _e1836, (_e1836 > 0f));
let _e1840 = select(1f, _e1838, (_e1838 < 1f));
if (_e1817 < 0i) {
let _e1843 = local_30;
phi_2906_ = (_e1817 + _e1843);
} else {
phi_2906_ = _e1817;
}
let _e1846 = phi_2906_;
let _e1848 = local_31;
if (_e1846 >= _e1848) {
let _e1851 = local_32;
phi_2912_ = (_e1846 - _e1851);
} else {
phi_2912_ = _e1846;
}
let _e1854 = phi_2912_;
let _e1855 = (_e1817 + 1i);
if (_e1855 < 0i) {
let _e1858 = local_33;
phi_2919_ = (_e1855 + _e1858);
} else {
phi_2919_ = _e1855;
}
let _e1861 = phi_2919_;
let _e1863 = local_34;
if (_e1861 >= _e1863) {
let _e1866 = local_35;
phi_2925_ = (_e1861 - _e1866);
} else {
phi_2925_ = _e1861;
}
let _e1869 = phi_2925_;
let _e1871 = select(_e1832, 0i, (_e1832 < 0i));
let _e1873 = local_36;
if (_e1871 >= _e1873) {
let _e1876 = local_37;
phi_2936_ = (_e1876 - 1i);
} else {
phi_2936_ = _e1871;
}
let _e1879 = phi_2936_;
let _e1880 = (_e1832 + 1i);
let _e1882 = select(_e1880, 0i, (_e1880 < 0i));
let _e1884 = local_38;
if (_e1882 >= _e1884) {
let _e1887 = local_39;
phi_2948_ = (_e1887 - 1i);
} else {
phi_2948_ = _e1882;
}
let _e1890 = phi_2948_;
let _e1892 = local_40;
let _e1895 = local_41;
let _e1896 = (_e1895 + (_e1879 * _e1892));
let _e1898 = local_42;
let _e1901 = local_43;
let _e1902 = (_e1901 + (_e1890 * _e1898));
let _e1904 = (3i * (_e1896 + _e1854));
let _e1906 = select(_e1623, _e1904, (_e1904 < _e1623));
let _e1912 = global_3.member[bitcast<u32>(select(0i, _e1906, (_e1906 > 0i)))];
let _e1913 = (_e1904 + 1i);
let _e1915 = select(_e1623, _e1913, (_e1913 < _e1623));
let _e1921 = global_3.member[bitcast<u32>(select(0i, _e1915, (_e1915 > 0i)))];
let _e1922 = (_e1904 + 2i);
let _e1924 = select(_e1623, _e1922, (_e1922 < _e1623));
let _e1930 = global_3.member[bitcast<u32>(select(0i, _e1924, (_e1924 > 0i)))];
let _e1932 = (3i * (_e1896 + _e1869));
let _e1934 = select(_e1623, _e1932, (_e1932 < _e1623));
let _e1940 = global_3.member[bitcast<u32>(select(0i, _e1934, (_e1934 > 0i)))];
let _e1941 = (_e1932 + 1i);
let _e1943 = select(_e1623, _e1941, (_e1941 < _e1623));
let _e1949 = global_3.member[bitcast<u32>(select(0i, _e1943, (_e1943 > 0i)))];
let _e1950 = (_e1932 + 2i);
let _e1952 = select(_e1623, _e1950, (_e1950 < _e1623));
let _e1958 = global_3.member[bitcast<u32>(select(0i, _e1952, (_e1952 > 0i)))];
let _e1960 = (3i * (_e1902 + _e1854));
let _e1962 = select(_e1623, _e1960, (_e1960 < _e1623));
let _e1968 = global_3.member[bitcast<u32>(select(0i, _e1962, (_e1962 > 0i)))];
let _e1969 = (_e1960 + 1i);
let _e1971 = select(_e1623, _e1969, (_e1969 < _e1623));
let _e1977 = global_3.member[bitcast<u32>(select(0i, _e1971, (_e1971 > 0i)))];
let _e1978 = (_e1960 + 2i);
let _e1980 = select(_e1623, _e1978, (_e1978 < _e1623));
let _e1986 = global_3.member[bitcast<u32>(select(0i, _e1980, (_e1980 > 0i)))];
let _e1988 = (3i * (_e1902 + _e1869));
let _e1990 = select(_e1623, _e1988, (_e1988 < _e1623));
let _e1996 = global_3.member[bitcast<u32>(select(0i, _e1990, (_e1990 > 0i)))];
let _e1997 = (_e1988 + 1i);
let _e1999 = select(_e1623, _e1997, (_e1997 < _e1623));
let _e2005 = global_3.member[bitcast<u32>(select(0i, _e1999, (_e1999 > 0i)))];
let _e2006 = (_e1988 + 2i);
let _e2008 = select(_e1623, _e2006, (_e2006 < _e1623));
let _e2014 = global_3.member[bitcast<u32>(select(0i, _e2008, (_e2008 > 0i)))];
let _e2021 = (_e1912 + ((_e1940 - _e1912) * _e1834));
let _e2022 = (_e1921 + ((_e1949 - _e1921) * _e1834));
let _e2023 = (_e1930 + ((_e1958 - _e1930) * _e1834));
let _e2046 = (_e1355 - f32(_e1373));
let _e2048 = select(0f, _e2046, (_e2046 > 0f));
let _e2050 = select(1f, _e2048, (_e2048 < 1f));
let _e2060 = global_1.member.member_21.member_11;
phi_3203_ = vec3<f32>(((_e1758 + (((_e2021 + (((_e1968 + ((_e1996 - _e1968) * _e1834)) - _e2021) * _e1840)) - _e1758) * _e2050)) * _e2060), ((_e1759 + (((_e2022 + (((_e1977 + ((_e2005 - _e1977) * _e1834)) - _e2022) * _e1840)) - _e1759) * _e2050)) * _e2060), ((_e1760 + (((_e2023 + (((_e1986 + ((_e2014 - _e1986) * _e1834)) - _e2023) * _e1840)) - _e1760) * _e2050)) * _e2060));
}
let _e2066 = phi_3203_;
phi_3204_ = _e2066;
}
let _e2068 = phi_3204_;
phi_3205_ = _e2068;
}
let _e2070 = phi_3205_;
let _e2074 = global_1.member.member_21.member_12;
let _e2081 = (_e541 * _e2074);
let _e2093 = (1f - ((_e541 * ((_e236 + _e247) + _e258)) * (1f / 3f)));
global_4.member[_e123] = ((_e181 + ((_e236 * (select(_e440.member, _e429.member, _e418) * (((_e462.member * _e490) * _e513) + _e496.member))) * _e526)) + ((_e236 * _e2070.x) * _e2081));
global_4.member[(_e121 + _e123)] = ((_e192 + ((_e247 * (select(_e440.member_1, _e429.member_1, _e418) * (((_e462.member_1 * _e490) * _e513) + _e496.member_1))) * _e526)) + ((_e247 * _e2070.y) * _e2081));
global_4.member[((2u * _e121) + _e123)] = ((_e203 + ((_e258 * (select(_e440.member_2, _e429.member_2, _e418) * (((_e462.member_2 * _e490) * _e513) + _e496.member_2))) * _e526)) + ((_e258 * _e2070.z) * _e2081));
global_4.member[((3u * _e121) + _e123)] = (_e2093 + ((1f - _e2093) * _e2074));
global_4.member[((4u * _e121) + _e123)] = _e536;
global_4.member[((5u * _e121) + _e123)] = _e236;
global_4.member[((6u * _e121) + _e123)] = _e247;
global_4.member[((7u * _e121) + _e123)] = _e258;
global_4.member[((8u * _e121) + _e123)] = ((_e225 + (_e526 * (_e348 + (_e305 * select(_e379, _e410, _e414))))) / select(1e-12f, _e536, (_e536 > 1e-12f)));
global_4.member[((9u * _e121) + _e123)] = _e303;
global_4.member[((10u * _e121) + _e123)] = _e304;
global_4.member[((11u * _e121) + _e123)] = -(_e305);
global_4.member[((12u * _e121) + _e123)] = _e346;
global_4.member[((13u * _e121) + _e123)] = _e347;
global_4.member[((14u * _e121) + _e123)] = -(_e348);
global_4.member[((15u * _e121) + _e123)] = select(2f, _e170, (_e170 < 2f));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
