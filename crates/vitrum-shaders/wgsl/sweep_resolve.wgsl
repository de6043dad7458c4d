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
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_19 {
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
struct type_20 {
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
struct type_21 {
member: type_5,
member_1: type_5,
}
struct type_22 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_23 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_24 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_14,
member_18: type_22,
member_19: type_5,
member_20: type_23,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_14,
member_4: type_14,
member_5: u32,
member_6: u32,
member_7: type_18,
member_8: type_19,
member_9: type_19,
member_10: type_20,
member_11: type_21,
member_12: type_24,
member_13: type_18,
member_14: type_4,
member_15: type_9,
member_16: type_25,
member_17: type_25,
member_18: type_25,
member_19: type_25,
member_20: type_5,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_27 {
member: type_26,
}
struct type_28 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_11;
@group(0) @binding(0)
var<storage> global_2: type_27;
@group(0) @binding(1)
var<storage> global_3: type_11;
@group(0) @binding(2)
var<storage> global_4: type_11;
@group(0) @binding(3)
var<storage> global_5: type_16;
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
var phi_248_: u32;
var phi_1178_: u32;
var phi_1515_: f32;
var phi_1571_: f32;
var phi_1576_: vec3<f32>;
var phi_1679_: f32;
var phi_1763_: f32;
var phi_1835_: type_28;
var phi_1836_: type_28;
var phi_2121_: i32;
var phi_2141_: i32;
var phi_2147_: i32;
var phi_2157_: i32;
var phi_2177_: i32;
var phi_2183_: i32;
var phi_2224_: u32;
var phi_2394_: u32;
var phi_2578_: u32;
var phi_2748_: u32;
var phi_2957_: vec3<f32>;
var phi_3559_: i32;
var phi_3562_: i32;
var phi_3564_: i32;
var phi_3566_: i32;
var phi_3581_: i32;
var phi_3587_: i32;
var phi_3560_: i32;
var phi_3563_: i32;
var phi_3565_: i32;
var phi_3567_: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_3662_: i32;
var local_15: i32;
var local_16: i32;
var phi_3668_: i32;
var local_17: i32;
var phi_3675_: i32;
var local_18: i32;
var local_19: i32;
var phi_3681_: i32;
var local_20: i32;
var local_21: i32;
var phi_3692_: i32;
var local_22: i32;
var local_23: i32;
var phi_3704_: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var phi_3940_: i32;
var phi_3943_: i32;
var phi_3945_: i32;
var phi_3947_: i32;
var phi_3962_: i32;
var phi_3968_: i32;
var phi_3941_: i32;
var phi_3944_: i32;
var phi_3946_: i32;
var phi_3948_: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var phi_4043_: i32;
var local_31: i32;
var local_32: i32;
var phi_4049_: i32;
var local_33: i32;
var phi_4056_: i32;
var local_34: i32;
var local_35: i32;
var phi_4062_: i32;
var local_36: i32;
var local_37: i32;
var phi_4073_: i32;
var local_38: i32;
var local_39: i32;
var phi_4085_: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var phi_4340_: vec3<f32>;
var phi_4341_: vec3<f32>;
var phi_4342_: vec3<f32>;
switch bitcast<i32>(0u) {
default: {
let _e100 = global;
let _e111 = global_2.member.member_2;
let _e114 = global_2.member.member;
let _e122 = (_e100.x + _e111.member);
let _e124 = (_e100.y + _e111.member_1);
if (_e122 < _e111.member_2) {
if (_e124 < _e111.member_3) {
let _e127 = (_e114.member * _e114.member_1);
let _e129 = ((_e124 * _e114.member) + _e122);
let _e133 = global_2.member.member_3.member;
let _e137 = global_2.member.member_3.member_1;
let _e138 = (_e122 % 16u);
let _e139 = (_e124 % 4u);
if ((_e122 < (_e133 - (_e133 % 16u))) && (_e124 < (_e137 - (_e137 % 4u)))) {
phi_248_ = ((((_e124 - _e139) + (_e138 / 4u)) * _e133) + (((_e122 - _e138) + (_e139 * 4u)) + (_e138 % 4u)));
} else {
phi_248_ = ((_e124 * _e133) + _e122);
}
let _e160 = phi_248_;
local_10 = bitcast<i32>(_e160);
let _e163 = bitcast<i32>((_e133 * _e137));
local_11 = _e163;
let _e164 = local_11;
let _e166 = local_10;
let _e167 = ((7i * _e164) + _e166);
let _e169 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e171 = select(_e169, _e167, (_e167 < _e169));
let _e176 = global_3.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e177 = local_11;
let _e179 = local_10;
let _e180 = ((9i * _e177) + _e179);
let _e182 = select(_e169, _e180, (_e180 < _e169));
let _e187 = global_3.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e188 = local_11;
let _e190 = local_10;
let _e191 = ((10i * _e188) + _e190);
let _e193 = select(_e169, _e191, (_e191 < _e169));
let _e198 = global_3.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e199 = local_11;
let _e201 = local_10;
let _e202 = ((11i * _e199) + _e201);
let _e204 = select(_e169, _e202, (_e202 < _e169));
let _e209 = global_3.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e210 = local_11;
let _e212 = local_10;
let _e213 = ((12i * _e210) + _e212);
let _e215 = select(_e169, _e213, (_e213 < _e169));
let _e220 = global_3.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e221 = local_11;
let _e223 = local_10;
let _e224 = ((8i * _e221) + _e223);
let _e226 = select(_e169, _e224, (_e224 < _e169));
let _e231 = global_3.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e232 = local_11;
let _e234 = local_10;
let _e235 = ((13i * _e232) + _e234);
let _e237 = select(_e169, _e235, (_e235 < _e169));
let _e242 = global_3.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e243 = local_11;
let _e245 = local_10;
let _e246 = ((14i * _e243) + _e245);
let _e248 = select(_e169, _e246, (_e246 < _e169));
let _e253 = global_3.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e254 = local_11;
let _e256 = local_10;
let _e257 = ((15i * _e254) + _e256);
let _e259 = select(_e169, _e257, (_e257 < _e169));
let _e264 = global_3.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e265 = local_11;
let _e267 = local_10;
let _e268 = ((3i * _e265) + _e267);
let _e270 = select(_e169, _e268, (_e268 < _e169));
let _e275 = global_3.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e276 = local_11;
let _e278 = local_10;
let _e279 = ((4i * _e276) + _e278);
let _e281 = select(_e169, _e279, (_e279 < _e169));
let _e286 = global_3.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e287 = local_11;
let _e289 = local_10;
let _e290 = ((5i * _e287) + _e289);
let _e292 = select(_e169, _e290, (_e290 < _e169));
let _e297 = global_3.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e302 = (((_e275 * _e275) + (_e286 * _e286)) + (_e297 * _e297));
let _e305 = sqrt(select(0f, _e302, (_e302 > 0f)));
let _e308 = (1f / select(1e-20f, _e305, (_e305 > 1e-20f)));
let _e309 = (_e275 * _e308);
let _e310 = (_e286 * _e308);
let _e311 = (_e297 * _e308);
let _e312 = (_e176 == 0f);
let _e313 = local_10;
let _e315 = select(_e169, _e313, (_e313 < _e169));
let _e320 = global_3.member[bitcast<u32>(select(0i, _e315, (_e315 > 0i)))];
let _e321 = local_11;
let _e322 = local_10;
let _e323 = (_e321 + _e322);
let _e325 = select(_e169, _e323, (_e323 < _e169));
let _e330 = global_3.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e331 = local_11;
let _e333 = local_10;
let _e334 = ((2i * _e331) + _e333);
let _e336 = select(_e169, _e334, (_e334 < _e169));
let _e341 = global_3.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e345 = global_2.member.member_7.member_1;
let _e348 = select(0f, ((_e345 - _e341) / _e297), _e312);
let _e352 = (_e320 + (_e275 * _e348));
let _e353 = (_e330 + (_e286 * _e348));
let _e354 = (_e341 + (_e297 * _e348));
let _e359 = global_2.member.member_15.member.member;
let _e370 = ((((_e359.member.member * _e352) + (_e359.member.member_1 * _e353)) + (_e359.member.member_2 * _e354)) + _e359.member_1);
let _e376 = -((((_e359.member.member * _e309) + (_e359.member.member_1 * _e310)) + (_e359.member.member_2 * _e311)));
let _e378 = (_e376 > 1e-9f);
let _e382 = ((_e370 / select(1e-9f, _e376, _e378)) - 0f);
let _e385 = select(1e30f, select(0f, _e382, (_e382 > 0f)), ((_e370 > 0f) && _e378));
let _e390 = global_2.member.member_15.member_1.member;
let _e401 = ((((_e390.member.member * _e352) + (_e390.member.member_1 * _e353)) + (_e390.member.member_2 * _e354)) + _e390.member_1);
let _e407 = -((((_e390.member.member * _e309) + (_e390.member.member_1 * _e310)) + (_e390.member.member_2 * _e311)));
let _e409 = (_e407 > 1e-9f);
let _e413 = ((_e401 / select(1e-9f, _e407, _e409)) - 0f);
let _e416 = select(1e30f, select(0f, _e413, (_e413 > 0f)), ((_e401 > 0f) && _e409));
let _e420 = (_e416 < _e385);
let _e422 = select(select(-2i, -3i, _e420), -1i, ((_e385 >= 1e30f) && (_e416 >= 1e30f)));
let _e423 = select(_e385, _e416, _e420);
let _e424 = (_e422 == -3i);
let _e430 = global_2.member.member_15.member_1.member.member;
let _e435 = global_2.member.member_15.member_1.member_1;
let _e441 = global_2.member.member_15.member.member.member;
let _e446 = global_2.member.member_15.member.member_1;
let _e466 = select(_e423, 0f, (_e422 == -1i));
let _e470 = (_e352 + (_e309 * _e466));
let _e471 = (_e353 + (_e310 * _e466));
let _e472 = (_e354 + (_e311 * _e466));
let _e476 = global_2.member.member_12.member;
let _e487 = ((((_e476.member.member * _e470) + (_e476.member.member_1 * _e471)) + (_e476.member.member_2 * _e472)) + _e476.member_1);
let _e491 = global_2.member.member_12.member_1;
let _e502 = ((((_e491.member.member * _e470) + (_e491.member.member_1 * _e471)) + (_e491.member.member_2 * _e472)) + _e491.member_1);
let _e506 = global_2.member.member_12.member_2;
let _e517 = ((((_e506.member.member * _e470) + (_e506.member.member_1 * _e471)) + (_e506.member.member_2 * _e472)) + _e506.member_1);
let _e521 = global_2.member.member_12.member_3;
let _e522 = (_e521 != 0u);
let _e526 = global_2.member.member_12.member_19;
let _e530 = (_e487 - _e526.member);
let _e531 = (_e502 - _e526.member_1);
let _e532 = (_e517 - _e526.member_2);
let _e537 = (((_e530 * _e530) + (_e531 * _e531)) + (_e532 * _e532));
let _e540 = sqrt(select(0f, _e537, (_e537 > 0f)));
let _e543 = (1f / select(1e-20f, _e540, (_e540 > 1e-20f)));
let _e547 = select(0f, (_e530 * _e543), _e522);
let _e548 = select(0f, (_e531 * _e543), _e522);
let _e549 = select(1f, (_e532 * _e543), _e522);
let _e554 = global_2.member.member_12.member.member;
let _e565 = global_2.member.member_12.member_1.member;
let _e579 = global_2.member.member_12.member_2.member;
let _e588 = (vec3<f32>(((_e554.member * _e547) + (_e565.member * _e548)), ((_e554.member_1 * _e547) + (_e565.member_1 * _e548)), ((_e554.member_2 * _e547) + (_e565.member_2 * _e548))) + vec3<f32>((_e579.member * _e549), (_e579.member_1 * _e549), (_e579.member_2 * _e549)));
let _e591 = global_2.member.member_1;
if ((_e591 & 256u) != 0u) {
let _e599 = global_2.member.member_12.member_18.member.member;
let _e600 = bitcast<i32>(_e599);
let _e606 = global_2.member.member_12.member_18.member.member_1;
let _e607 = bitcast<i32>(_e606);
let _e612 = global_2.member.member_12.member_19.member_2;
let _e614 = select(1f, (_e517 - _e612), _e522);
let _e617 = (1f / select(1e-12f, _e614, (_e614 > 1e-12f)));
let _e622 = global_2.member.member_12.member_5;
let _e627 = global_2.member.member_12.member_8;
let _e628 = (((_e487 * _e617) - _e622) * _e627);
let _e633 = global_2.member.member_12.member_6;
let _e635 = (((_e502 * _e617) - _e633) * _e627);
let _e640 = global_2.member.member_12.member_4.member;
let _e642 = f32(bitcast<i32>(_e640));
let _e644 = select(0f, _e628, (_e628 > 0f));
let _e651 = global_2.member.member_12.member_18.member_1;
let _e654 = ((_e628 - _e642) * _e651);
let _e659 = global_2.member.member_12.member_18.member_2;
let _e661 = select(0f, _e654, (_e654 > 0f));
let _e663 = (_e659 + _e661);
let _e668 = (-(_e628) * _e651);
let _e670 = select(0f, _e668, (_e668 > 0f));
let _e672 = (_e659 + _e670);
let _e679 = (((_e659 + (select(_e642, _e644, (_e644 < _e642)) * _e651)) + (((_e661 * _e659) / select(1e-12f, _e663, (_e663 > 1e-12f))) - ((_e670 * _e659) / select(1e-12f, _e672, (_e672 > 1e-12f))))) - 0.5f);
let _e684 = global_2.member.member_12.member_4.member_1;
let _e686 = f32(bitcast<i32>(_e684));
let _e688 = select(0f, _e635, (_e635 > 0f));
let _e693 = ((_e635 - _e686) * _e651);
let _e695 = select(0f, _e693, (_e693 > 0f));
let _e697 = (_e659 + _e695);
let _e702 = (-(_e635) * _e651);
let _e704 = select(0f, _e702, (_e702 > 0f));
let _e706 = (_e659 + _e704);
let _e713 = (((_e659 + (select(_e686, _e688, (_e688 < _e686)) * _e651)) + (((_e695 * _e659) / select(1e-12f, _e697, (_e697 > 1e-12f))) - ((_e704 * _e659) / select(1e-12f, _e706, (_e706 > 1e-12f))))) - 0.5f);
let _e715 = f32((_e600 - 2i));
let _e717 = select(0f, _e679, (_e679 > 0f));
let _e719 = select(_e715, _e717, (_e717 < _e715));
let _e726 = select(0i, select(select(i32(_e719), i32(-2147483648), (_e719 < -2147483600f)), 2147483647i, (_e719 > 2147483500f)), (_e719 == _e719));
let _e730 = (_e726 - select(0i, 1i, (_e719 < f32(_e726))));
let _e732 = f32((_e607 - 2i));
let _e734 = select(0f, _e713, (_e713 > 0f));
let _e736 = select(_e732, _e734, (_e734 < _e732));
let _e743 = select(0i, select(select(i32(_e736), i32(-2147483648), (_e736 < -2147483600f)), 2147483647i, (_e736 > 2147483500f)), (_e736 == _e736));
let _e747 = (_e743 - select(0i, 1i, (_e736 < f32(_e743))));
let _e749 = (_e679 - f32(_e730));
let _e751 = select(0f, _e749, (_e749 > 0f));
let _e753 = select(1f, _e751, (_e751 < 1f));
let _e755 = (_e713 - f32(_e747));
let _e757 = select(0f, _e755, (_e755 > 0f));
let _e759 = select(1f, _e757, (_e757 < 1f));
if _e424 {
let _e764 = global_2.member.member_12.member_18.member_4;
phi_1178_ = _e764;
} else {
let _e769 = global_2.member.member_12.member_18.member_3;
phi_1178_ = _e769;
}
let _e771 = phi_1178_;
let _e775 = ((bitcast<i32>(_e771) + (_e747 * _e600)) + _e730);
let _e776 = (_e600 * _e607);
let _e778 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e780 = select(_e778, _e775, (_e775 < _e778));
let _e786 = global_5.member[bitcast<u32>(select(0i, _e780, (_e780 > 0i)))];
let _e787 = bitcast<f32>(_e786);
let _e788 = (_e775 + 1i);
let _e790 = select(_e778, _e788, (_e788 < _e778));
let _e796 = global_5.member[bitcast<u32>(select(0i, _e790, (_e790 > 0i)))];
let _e800 = (_e787 + ((bitcast<f32>(_e796) - _e787) * _e753));
let _e801 = (_e775 + _e600);
let _e803 = select(_e778, _e801, (_e801 < _e778));
let _e809 = global_5.member[bitcast<u32>(select(0i, _e803, (_e803 > 0i)))];
let _e810 = bitcast<f32>(_e809);
let _e811 = (_e801 + 1i);
let _e813 = select(_e778, _e811, (_e811 < _e778));
let _e819 = global_5.member[bitcast<u32>(select(0i, _e813, (_e813 > 0i)))];
let _e826 = (_e800 + (((_e810 + ((bitcast<f32>(_e819) - _e810) * _e753)) - _e800) * _e759));
let _e827 = (_e775 + _e776);
let _e829 = select(_e778, _e827, (_e827 < _e778));
let _e835 = global_5.member[bitcast<u32>(select(0i, _e829, (_e829 > 0i)))];
let _e836 = bitcast<f32>(_e835);
let _e837 = (_e827 + 1i);
let _e839 = select(_e778, _e837, (_e837 < _e778));
let _e845 = global_5.member[bitcast<u32>(select(0i, _e839, (_e839 > 0i)))];
let _e849 = (_e836 + ((bitcast<f32>(_e845) - _e836) * _e753));
let _e850 = (_e827 + _e600);
let _e852 = select(_e778, _e850, (_e850 < _e778));
let _e858 = global_5.member[bitcast<u32>(select(0i, _e852, (_e852 > 0i)))];
let _e859 = bitcast<f32>(_e858);
let _e860 = (_e850 + 1i);
let _e862 = select(_e778, _e860, (_e860 < _e778));
let _e868 = global_5.member[bitcast<u32>(select(0i, _e862, (_e862 > 0i)))];
let _e875 = (_e849 + (((_e859 + ((bitcast<f32>(_e868) - _e859) * _e753)) - _e849) * _e759));
let _e877 = (_e775 + (2i * _e776));
let _e879 = select(_e778, _e877, (_e877 < _e778));
let _e885 = global_5.member[bitcast<u32>(select(0i, _e879, (_e879 > 0i)))];
let _e886 = bitcast<f32>(_e885);
let _e887 = (_e877 + 1i);
let _e889 = select(_e778, _e887, (_e887 < _e778));
let _e895 = global_5.member[bitcast<u32>(select(0i, _e889, (_e889 > 0i)))];
let _e899 = (_e886 + ((bitcast<f32>(_e895) - _e886) * _e753));
let _e900 = (_e877 + _e600);
let _e902 = select(_e778, _e900, (_e900 < _e778));
let _e908 = global_5.member[bitcast<u32>(select(0i, _e902, (_e902 > 0i)))];
let _e909 = bitcast<f32>(_e908);
let _e910 = (_e900 + 1i);
let _e912 = select(_e778, _e910, (_e910 < _e778));
let _e918 = global_5.member[bitcast<u32>(select(0i, _e912, (_e912 > 0i)))];
let _e925 = (_e899 + (((_e909 + ((bitcast<f32>(_e918) - _e909) * _e753)) - _e899) * _e759));
let _e927 = (_e521 == 0u);
if _e927 {
phi_1576_ = vec3<f32>(_e826, _e875, _e925);
} else {
if _e927 {
phi_1515_ = 1f;
} else {
let _e932 = global_2.member.member_12.member_20.member;
let _e940 = (((_e932.member * _e530) + (_e932.member_1 * _e531)) + (_e932.member_2 * _e532));
let _e944 = (_e530 - (_e932.member * _e940));
let _e945 = (_e531 - (_e932.member_1 * _e940));
let _e946 = (_e532 - (_e932.member_2 * _e940));
let _e951 = (((_e944 * _e944) + (_e945 * _e945)) + (_e946 * _e946));
let _e962 = global_2.member.member_12.member_20.member_1;
let _e968 = global_2.member.member_12.member_20.member_2;
let _e969 = ((_e962 - (sqrt(select(0f, _e951, (_e951 > 0f))) / select(1e-20f, _e940, (_e940 > 1e-20f)))) * _e968);
let _e971 = select(0f, _e969, (_e969 > 0f));
let _e973 = select(1f, _e971, (_e971 < 1f));
phi_1515_ = select(1f, select(0f, ((_e973 * _e973) * (3f - (2f * _e973))), (_e940 > 0f)), (_e968 > 0f));
}
let _e983 = phi_1515_;
let _e985 = select(0f, 1f, (_e532 > 0f));
let _e989 = ((_e826 * _e985) + _e983);
let _e990 = ((_e875 * _e985) + _e983);
let _e991 = ((_e925 * _e985) + _e983);
if _e927 {
phi_1571_ = 1f;
} else {
phi_1571_ = (1f / select(1e-12f, _e537, (_e537 > 1e-12f)));
}
let _e1002 = phi_1571_;
phi_1576_ = vec3<f32>((select(0f, _e989, (_e989 > 0f)) * _e1002), (select(0f, _e990, (_e990 > 0f)) * _e1002), (select(0f, _e991, (_e991 > 0f)) * _e1002));
}
let _e1008 = phi_1576_;
let _e1012 = global_2.member.member_11.member_1;
phi_1836_ = type_28((vec3<f32>(_e1012.member, _e1012.member_1, _e1012.member_2) * _e1008), _e588);
} else {
let _e1019 = (_e521 == 0u);
if _e1019 {
let _e1023 = global_2.member.member_11.member_1;
let _e1031 = global_2.member.member_11.member;
phi_1835_ = type_28(vec3<f32>(_e1023.member, _e1023.member_1, _e1023.member_2), vec3<f32>(_e1031.member, _e1031.member_1, _e1031.member_2));
} else {
let _e1040 = global_2.member.member_11.member_1;
if _e1019 {
phi_1679_ = 1f;
} else {
phi_1679_ = (1f / select(1e-12f, _e537, (_e537 > 1e-12f)));
}
let _e1048 = phi_1679_;
if _e1019 {
phi_1763_ = 1f;
} else {
let _e1053 = global_2.member.member_12.member_20.member;
let _e1061 = (((_e1053.member * _e530) + (_e1053.member_1 * _e531)) + (_e1053.member_2 * _e532));
let _e1065 = (_e530 - (_e1053.member * _e1061));
let _e1066 = (_e531 - (_e1053.member_1 * _e1061));
let _e1067 = (_e532 - (_e1053.member_2 * _e1061));
let _e1072 = (((_e1065 * _e1065) + (_e1066 * _e1066)) + (_e1067 * _e1067));
let _e1083 = global_2.member.member_12.member_20.member_1;
let _e1089 = global_2.member.member_12.member_20.member_2;
let _e1090 = ((_e1083 - (sqrt(select(0f, _e1072, (_e1072 > 0f))) / select(1e-20f, _e1061, (_e1061 > 1e-20f)))) * _e1089);
let _e1092 = select(0f, _e1090, (_e1090 > 0f));
let _e1094 = select(1f, _e1092, (_e1092 < 1f));
phi_1763_ = select(1f, select(0f, ((_e1094 * _e1094) * (3f - (2f * _e1094))), (_e1061 > 0f)), (_e1089 > 0f));
}
let _e1104 = phi_1763_;
let _e1105 = (_e1048 * _e1104);
phi_1835_ = type_28(vec3<f32>((_e1040.member * _e1105), (_e1040.member_1 * _e1105), (_e1040.member_2 * _e1105)), _e588);
}
let _e1112 = phi_1835_;
phi_1836_ = _e1112;
}
let _e1114 = phi_1836_;
let _e1123 = (((_e1114.member_1.x * _e1114.member_1.x) + (_e1114.member_1.y * _e1114.member_1.y)) + (_e1114.member_1.z * _e1114.member_1.z));
let _e1126 = sqrt(select(0f, _e1123, (_e1123 > 0f)));
let _e1132 = (1e-6f * _e1126);
let _e1136 = select((_e1126 / select(_e1132, _e1114.member_1.z, (_e1114.member_1.z > _e1132))), 1f, ((_e591 & 8u) != 0u));
let _e1145 = global_2.member.member_20;
let _e1157 = (-((((select(_e441.member, _e430.member, _e424) * _e1114.member_1.x) + (select(_e441.member_1, _e430.member_1, _e424) * _e1114.member_1.y)) + (select(_e441.member_2, _e430.member_2, _e424) * _e1114.member_1.z))) / select(1e-20f, _e1126, (_e1126 > 1e-20f)));
let _e1162 = bitcast<f32>((bitcast<u32>(select(0f, _e1157, (_e1157 > 0f))) & 2147483647u));
let _e1175 = ((_e312 || (_e176 == 3f)) && (_e422 != -1i));
let _e1180 = select(0f, (1f - _e220), _e1175);
let _e1190 = (_e220 + _e1180);
let _e1195 = (1f - _e1190);
let _e1196 = local_10;
local_8 = _e1196;
local_9 = _e163;
let _e1197 = local_9;
let _e1199 = local_8;
let _e1200 = ((3i * _e1197) + _e1199);
let _e1202 = select(_e169, _e1200, (_e1200 < _e169));
let _e1207 = global_3.member[bitcast<u32>(select(0i, _e1202, (_e1202 > 0i)))];
let _e1208 = local_9;
let _e1210 = local_8;
let _e1211 = ((4i * _e1208) + _e1210);
let _e1213 = select(_e169, _e1211, (_e1211 < _e169));
let _e1218 = global_3.member[bitcast<u32>(select(0i, _e1213, (_e1213 > 0i)))];
let _e1219 = local_9;
let _e1221 = local_8;
let _e1222 = ((5i * _e1219) + _e1221);
let _e1224 = select(_e169, _e1222, (_e1222 < _e169));
let _e1229 = global_3.member[bitcast<u32>(select(0i, _e1224, (_e1224 > 0i)))];
let _e1234 = (((_e1207 * _e1207) + (_e1218 * _e1218)) + (_e1229 * _e1229));
let _e1237 = sqrt(select(0f, _e1234, (_e1234 > 0f)));
let _e1240 = (1f / select(1e-20f, _e1237, (_e1237 > 1e-20f)));
let _e1241 = (_e1207 * _e1240);
let _e1242 = (_e1218 * _e1240);
let _e1243 = (_e1229 * _e1240);
let _e1247 = global_2.member.member_23.member_4;
let _e1255 = (((_e1247.member * _e1241) + (_e1247.member_1 * _e1242)) + (_e1247.member_2 * _e1243));
let _e1259 = global_2.member.member_23.member_5;
let _e1267 = (((_e1259.member * _e1241) + (_e1259.member_1 * _e1242)) + (_e1259.member_2 * _e1243));
let _e1271 = global_2.member.member_23.member_6;
let _e1279 = (((_e1271.member * _e1241) + (_e1271.member_1 * _e1242)) + (_e1271.member_2 * _e1243));
let _e1280 = bitcast<i32>(_e122);
let _e1281 = bitcast<i32>(_e124);
let _e1286 = global_2.member.member_5;
let _e1287 = (_e1286 == 0u);
if _e1287 {
phi_2121_ = bitcast<i32>(_e133);
} else {
phi_2121_ = bitcast<i32>(_e1286);
}
let _e1290 = phi_2121_;
if (_e1290 == 0i) {
break;
}
if ((_e1290 == -1i) && (_e1280 == i32(-2147483648))) {
break;
}
let _e1296 = (_e1280 - (_e1280 % _e1290));
let _e1298 = ((_e1296 + _e1290) - 1i);
if (_e1280 > _e1296) {
phi_2141_ = (_e1280 - 1i);
} else {
phi_2141_ = _e1296;
}
let _e1302 = phi_2141_;
if (_e1280 < _e1298) {
phi_2147_ = (_e1280 + 1i);
} else {
phi_2147_ = _e1298;
}
let _e1306 = phi_2147_;
if _e1287 {
phi_2157_ = bitcast<i32>(_e137);
} else {
phi_2157_ = bitcast<i32>(_e1286);
}
let _e1309 = phi_2157_;
if (_e1309 == 0i) {
break;
}
if ((_e1309 == -1i) && (_e1281 == i32(-2147483648))) {
break;
}
let _e1315 = (_e1281 - (_e1281 % _e1309));
let _e1317 = ((_e1315 + _e1309) - 1i);
if (_e1281 > _e1315) {
phi_2177_ = (_e1281 - 1i);
} else {
phi_2177_ = _e1315;
}
let _e1321 = phi_2177_;
if (_e1281 < _e1317) {
phi_2183_ = (_e1281 + 1i);
} else {
phi_2183_ = _e1317;
}
let _e1325 = phi_2183_;
let _e1328 = global_2.member.member_3.member;
let _e1331 = global_2.member.member_3.member_1;
let _e1332 = bitcast<u32>(_e1306);
let _e1333 = bitcast<u32>(_e1281);
let _e1334 = (_e1332 % 16u);
let _e1335 = (_e1333 % 4u);
let _e1337 = (_e1328 - (_e1328 % 16u));
let _e1340 = (_e1331 - (_e1331 % 4u));
let _e1341 = (_e1333 < _e1340);
if ((_e1332 < _e1337) && _e1341) {
phi_2224_ = ((((_e1333 - _e1335) + (_e1334 / 4u)) * _e1328) + (((_e1332 - _e1334) + (_e1335 * 4u)) + (_e1334 % 4u)));
} else {
phi_2224_ = ((_e1333 * _e1328) + _e1332);
}
let _e1356 = phi_2224_;
local_6 = bitcast<i32>(_e1356);
let _e1359 = bitcast<i32>((_e1328 * _e1331));
local_7 = _e1359;
let _e1360 = local_7;
let _e1362 = local_6;
let _e1363 = ((3i * _e1360) + _e1362);
let _e1365 = select(_e169, _e1363, (_e1363 < _e169));
let _e1370 = global_3.member[bitcast<u32>(select(0i, _e1365, (_e1365 > 0i)))];
let _e1371 = local_7;
let _e1373 = local_6;
let _e1374 = ((4i * _e1371) + _e1373);
let _e1376 = select(_e169, _e1374, (_e1374 < _e169));
let _e1381 = global_3.member[bitcast<u32>(select(0i, _e1376, (_e1376 > 0i)))];
let _e1382 = local_7;
let _e1384 = local_6;
let _e1385 = ((5i * _e1382) + _e1384);
let _e1387 = select(_e169, _e1385, (_e1385 < _e169));
let _e1392 = global_3.member[bitcast<u32>(select(0i, _e1387, (_e1387 > 0i)))];
let _e1397 = (((_e1370 * _e1370) + (_e1381 * _e1381)) + (_e1392 * _e1392));
let _e1400 = sqrt(select(0f, _e1397, (_e1397 > 0f)));
let _e1403 = (1f / select(1e-20f, _e1400, (_e1400 > 1e-20f)));
let _e1404 = (_e1370 * _e1403);
let _e1405 = (_e1381 * _e1403);
let _e1406 = (_e1392 * _e1403);
let _e1409 = global_2.member.member_23.member_4;
let _e1420 = global_2.member.member_23.member_5;
let _e1431 = global_2.member.member_23.member_6;
let _e1440 = bitcast<u32>(_e1302);
let _e1441 = (_e1440 % 16u);
if ((_e1440 < _e1337) && _e1341) {
phi_2394_ = ((((_e1333 - _e1335) + (_e1441 / 4u)) * _e1328) + (((_e1440 - _e1441) + (_e1335 * 4u)) + (_e1441 % 4u)));
} else {
phi_2394_ = ((_e1333 * _e1328) + _e1440);
}
let _e1457 = phi_2394_;
local_4 = bitcast<i32>(_e1457);
local_5 = _e1359;
let _e1459 = local_5;
let _e1461 = local_4;
let _e1462 = ((3i * _e1459) + _e1461);
let _e1464 = select(_e169, _e1462, (_e1462 < _e169));
let _e1469 = global_3.member[bitcast<u32>(select(0i, _e1464, (_e1464 > 0i)))];
let _e1470 = local_5;
let _e1472 = local_4;
let _e1473 = ((4i * _e1470) + _e1472);
let _e1475 = select(_e169, _e1473, (_e1473 < _e169));
let _e1480 = global_3.member[bitcast<u32>(select(0i, _e1475, (_e1475 > 0i)))];
let _e1481 = local_5;
let _e1483 = local_4;
let _e1484 = ((5i * _e1481) + _e1483);
let _e1486 = select(_e169, _e1484, (_e1484 < _e169));
let _e1491 = global_3.member[bitcast<u32>(select(0i, _e1486, (_e1486 > 0i)))];
let _e1496 = (((_e1469 * _e1469) + (_e1480 * _e1480)) + (_e1491 * _e1491));
let _e1499 = sqrt(select(0f, _e1496, (_e1496 > 0f)));
let _e1502 = (1f / select(1e-20f, _e1499, (_e1499 > 1e-20f)));
let _e1503 = (_e1469 * _e1502);
let _e1504 = (_e1480 * _e1502);
let _e1505 = (_e1491 * _e1502);
let _e1521 = ((((_e1409.member * _e1404) + (_e1409.member_1 * _e1405)) + (_e1409.member_2 * _e1406)) - (((_e1409.member * _e1503) + (_e1409.member_1 * _e1504)) + (_e1409.member_2 * _e1505)));
let _e1522 = ((((_e1420.member * _e1404) + (_e1420.member_1 * _e1405)) + (_e1420.member_2 * _e1406)) - (((_e1420.member * _e1503) + (_e1420.member_1 * _e1504)) + (_e1420.member_2 * _e1505)));
let _e1523 = ((((_e1431.member * _e1404) + (_e1431.member_1 * _e1405)) + (_e1431.member_2 * _e1406)) - (((_e1431.member * _e1503) + (_e1431.member_1 * _e1504)) + (_e1431.member_2 * _e1505)));
let _e1528 = (((_e1521 * _e1521) + (_e1522 * _e1522)) + (_e1523 * _e1523));
let _e1532 = bitcast<u32>(_e1280);
let _e1533 = bitcast<u32>(_e1325);
let _e1534 = (_e1532 % 16u);
let _e1535 = (_e1533 % 4u);
let _e1536 = (_e1532 < _e1337);
if (_e1536 && (_e1533 < _e1340)) {
phi_2578_ = ((((_e1533 - _e1535) + (_e1534 / 4u)) * _e1328) + (((_e1532 - _e1534) + (_e1535 * 4u)) + (_e1534 % 4u)));
} else {
phi_2578_ = ((_e1533 * _e1328) + _e1532);
}
let _e1552 = phi_2578_;
local_2 = bitcast<i32>(_e1552);
local_3 = _e1359;
let _e1554 = local_3;
let _e1556 = local_2;
let _e1557 = ((3i * _e1554) + _e1556);
let _e1559 = select(_e169, _e1557, (_e1557 < _e169));
let _e1564 = global_3.member[bitcast<u32>(select(0i, _e1559, (_e1559 > 0i)))];
let _e1565 = local_3;
let _e1567 = local_2;
let _e1568 = ((4i * _e1565) + _e1567);
let _e1570 = select(_e169, _e1568, (_e1568 < _e169));
let _e1575 = global_3.member[bitcast<u32>(select(0i, _e1570, (_e1570 > 0i)))];
let _e1576 = local_3;
let _e1578 = local_2;
let _e1579 = ((5i * _e1576) + _e1578);
let _e1581 = select(_e169, _e1579, (_e1579 < _e169));
let _e1586 = global_3.member[bitcast<u32>(select(0i, _e1581, (_e1581 > 0i)))];
let _e1591 = (((_e1564 * _e1564) + (_e1575 * _e1575)) + (_e1586 * _e1586));
let _e1594 = sqrt(select(0f, _e1591, (_e1591 > 0f)));
let _e1597 = (1f / select(1e-20f, _e1594, (_e1594 > 1e-20f)));
let _e1598 = (_e1564 * _e1597);
let _e1599 = (_e1575 * _e1597);
let _e1600 = (_e1586 * _e1597);
let _e1616 = bitcast<u32>(_e1321);
let _e1617 = (_e1616 % 4u);
if (_e1536 && (_e1616 < _e1340)) {
phi_2748_ = ((((_e1616 - _e1617) + (_e1534 / 4u)) * _e1328) + (((_e1532 - _e1534) + (_e1617 * 4u)) + (_e1534 % 4u)));
} else {
phi_2748_ = ((_e1616 * _e1328) + _e1532);
}
let _e1633 = phi_2748_;
local = bitcast<i32>(_e1633);
local_1 = _e1359;
let _e1635 = local_1;
let _e1637 = local;
let _e1638 = ((3i * _e1635) + _e1637);
let _e1640 = select(_e169, _e1638, (_e1638 < _e169));
let _e1645 = global_3.member[bitcast<u32>(select(0i, _e1640, (_e1640 > 0i)))];
let _e1646 = local_1;
let _e1648 = local;
let _e1649 = ((4i * _e1646) + _e1648);
let _e1651 = select(_e169, _e1649, (_e1649 < _e169));
let _e1656 = global_3.member[bitcast<u32>(select(0i, _e1651, (_e1651 > 0i)))];
let _e1657 = local_1;
let _e1659 = local;
let _e1660 = ((5i * _e1657) + _e1659);
let _e1662 = select(_e169, _e1660, (_e1660 < _e169));
let _e1667 = global_3.member[bitcast<u32>(select(0i, _e1662, (_e1662 > 0i)))];
let _e1672 = (((_e1645 * _e1645) + (_e1656 * _e1656)) + (_e1667 * _e1667));
let _e1675 = sqrt(select(0f, _e1672, (_e1672 > 0f)));
let _e1678 = (1f / select(1e-20f, _e1675, (_e1675 > 1e-20f)));
let _e1679 = (_e1645 * _e1678);
let _e1680 = (_e1656 * _e1678);
let _e1681 = (_e1667 * _e1678);
let _e1697 = ((((_e1409.member * _e1598) + (_e1409.member_1 * _e1599)) + (_e1409.member_2 * _e1600)) - (((_e1409.member * _e1679) + (_e1409.member_1 * _e1680)) + (_e1409.member_2 * _e1681)));
let _e1698 = ((((_e1420.member * _e1598) + (_e1420.member_1 * _e1599)) + (_e1420.member_2 * _e1600)) - (((_e1420.member * _e1679) + (_e1420.member_1 * _e1680)) + (_e1420.member_2 * _e1681)));
let _e1699 = ((((_e1431.member * _e1598) + (_e1431.member_1 * _e1599)) + (_e1431.member_2 * _e1600)) - (((_e1431.member * _e1679) + (_e1431.member_1 * _e1680)) + (_e1431.member_2 * _e1681)));
let _e1704 = (((_e1697 * _e1697) + (_e1698 * _e1698)) + (_e1699 * _e1699));
let _e1709 = f32((_e1306 - _e1302));
let _e1712 = (sqrt(select(0f, _e1528, (_e1528 > 0f))) / select(1f, _e1709, (_e1709 > 1f)));
let _e1714 = f32((_e1325 - _e1321));
let _e1717 = (sqrt(select(0f, _e1704, (_e1704 > 0f))) / select(1f, _e1714, (_e1714 > 1f)));
let _e1719 = select(_e1717, _e1712, (_e1712 > _e1717));
let _e1723 = global_2.member.member_23.member;
let _e1727 = global_2.member.member_23.member_7;
let _e1731 = vec3<f32>(_e1727.member, _e1727.member_1, _e1727.member_2);
let _e1735 = global_2.member.member_23.member_8;
if (_e1723 == 0u) {
phi_4342_ = _e1731;
} else {
if (_e1723 == 1u) {
let _e1742 = select(-1f, _e1279, (_e1279 > -1f));
let _e1744 = select(1f, _e1742, (_e1742 < 1f));
if (_e1744 > 0f) {
phi_2957_ = _e1731;
} else {
let _e1749 = global_2.member.member_23.member_9;
phi_2957_ = vec3<f32>(_e1749.member, _e1749.member_1, _e1749.member_2);
}
let _e1755 = phi_2957_;
let _e1764 = bitcast<f32>((bitcast<u32>(_e1744) & 2147483647u));
let _e1767 = sqrt(select(0f, _e1764, (_e1764 > 0f)));
phi_4341_ = vec3<f32>((_e1735.member + ((_e1755.x - _e1735.member) * _e1767)), (_e1735.member_1 + ((_e1755.y - _e1735.member_1) * _e1767)), (_e1735.member_2 + ((_e1755.z - _e1735.member_2) * _e1767)));
} else {
if (_e1723 == 2u) {
let _e1779 = global_2.member.member_23.member_10;
let _e1780 = (_e1719 / _e1779);
let _e1782 = select(1e-4f, _e1780, (_e1780 > 1e-4f));
let _e1785 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
let _e1788 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
let _e1792 = select(_e1788, _e1785, (_e1785 > _e1788));
let _e1795 = (select(_e1788, _e1785, (_e1785 < _e1788)) / select(1.1754944e-38f, _e1792, (_e1792 > 1.1754944e-38f)));
let _e1796 = (_e1795 > 0.41421357f);
let _e1800 = select(_e1795, ((_e1795 - 1f) / (_e1795 + 1f)), _e1796);
let _e1801 = (_e1800 * _e1800);
let _e1816 = (select(0f, 0.7853982f, _e1796) + (_e1800 + ((_e1800 * _e1801) * (-0.33333334f + (_e1801 * (0.2f + (_e1801 * (-0.14285713f + (_e1801 * (0.11111111f + (_e1801 * (-0.09090909f + (_e1801 * 0.0585f)))))))))))));
let _e1819 = select(_e1816, (1.5707964f - _e1816), (_e1788 > _e1785));
let _e1822 = select(_e1819, (3.1415927f - _e1819), (_e1255 < 0f));
let _e1828 = (1f - (_e1279 * _e1279));
let _e1831 = sqrt(select(0f, _e1828, (_e1828 > 0f)));
let _e1834 = (_e1782 / select(1e-3f, _e1831, (_e1831 > 1e-3f)));
let _e1835 = ((select(_e1822, -(_e1822), (_e1267 < 0f)) / _e1779) * 0.5f);
let _e1837 = select(-8e6f, _e1835, (_e1835 > -8e6f));
let _e1839 = select(8e6f, _e1837, (_e1837 < 8e6f));
let _e1846 = select(0i, select(select(i32(_e1839), i32(-2147483648), (_e1839 < -2147483600f)), 2147483647i, (_e1839 > 2147483500f)), (_e1839 == _e1839));
let _e1853 = ((_e1835 - f32((_e1846 - select(0i, 1i, (_e1839 < f32(_e1846)))))) * 2f);
let _e1861 = ((select(select((_e1853 - 2f), (1f - _e1853), (_e1853 < 1.5f)), _e1853, (_e1853 < 0.5f)) * 2f) / _e1834);
let _e1863 = select(-1f, _e1861, (_e1861 > -1f));
let _e1866 = (2f - _e1834);
let _e1868 = select(0f, _e1866, (_e1866 > 0f));
let _e1873 = select(-1f, _e1279, (_e1279 > -1f));
let _e1875 = select(1f, _e1873, (_e1873 < 1f));
let _e1878 = ((1f - _e1875) * (1f + _e1875));
let _e1881 = sqrt(select(0f, _e1878, (_e1878 > 0f)));
let _e1884 = bitcast<f32>((bitcast<u32>(_e1881) & 2147483647u));
let _e1887 = bitcast<f32>((bitcast<u32>(_e1875) & 2147483647u));
let _e1891 = select(_e1887, _e1884, (_e1884 > _e1887));
let _e1894 = (select(_e1887, _e1884, (_e1884 < _e1887)) / select(1.1754944e-38f, _e1891, (_e1891 > 1.1754944e-38f)));
let _e1895 = (_e1894 > 0.41421357f);
let _e1899 = select(_e1894, ((_e1894 - 1f) / (_e1894 + 1f)), _e1895);
let _e1900 = (_e1899 * _e1899);
let _e1915 = (select(0f, 0.7853982f, _e1895) + (_e1899 + ((_e1899 * _e1900) * (-0.33333334f + (_e1900 * (0.2f + (_e1900 * (-0.14285713f + (_e1900 * (0.11111111f + (_e1900 * (-0.09090909f + (_e1900 * 0.0585f)))))))))))));
let _e1918 = select(_e1915, (1.5707964f - _e1915), (_e1887 > _e1884));
let _e1921 = select(_e1918, (3.1415927f - _e1918), (_e1881 < 0f));
let _e1926 = ((select(_e1921, -(_e1921), (_e1875 < 0f)) / _e1779) * 0.5f);
let _e1928 = select(-8e6f, _e1926, (_e1926 > -8e6f));
let _e1930 = select(8e6f, _e1928, (_e1928 < 8e6f));
let _e1937 = select(0i, select(select(i32(_e1930), i32(-2147483648), (_e1930 < -2147483600f)), 2147483647i, (_e1930 > 2147483500f)), (_e1930 == _e1930));
let _e1944 = ((_e1926 - f32((_e1937 - select(0i, 1i, (_e1930 < f32(_e1937)))))) * 2f);
let _e1952 = ((select(select((_e1944 - 2f), (1f - _e1944), (_e1944 < 1.5f)), _e1944, (_e1944 < 0.5f)) * 2f) / _e1782);
let _e1954 = select(-1f, _e1952, (_e1952 > -1f));
let _e1957 = (2f - _e1782);
let _e1959 = select(0f, _e1957, (_e1957 > 0f));
let _e1965 = (0.5f + ((0.5f * (select(1f, _e1863, (_e1863 < 1f)) * select(1f, _e1868, (_e1868 < 1f)))) * (select(1f, _e1954, (_e1954 < 1f)) * select(1f, _e1959, (_e1959 < 1f)))));
phi_4340_ = vec3<f32>((_e1727.member + ((_e1735.member - _e1727.member) * _e1965)), (_e1727.member_1 + ((_e1735.member_1 - _e1727.member_1) * _e1965)), (_e1727.member_2 + ((_e1735.member_2 - _e1727.member_2) * _e1965)));
} else {
let _e1979 = global_2.member.member_23.member_1;
let _e1980 = bitcast<i32>(_e1979);
let _e1985 = global_2.member.member_23.member_3;
let _e1987 = f32(bitcast<i32>(_e1985));
let _e1989 = (2f * 3.1415927f);
let _e1990 = ((_e1719 * f32(_e1980)) / _e1989);
let _e1992 = select(1e-6f, _e1990, (_e1990 > 1e-6f));
let _e1995 = bitcast<u32>(select(1.1754944e-38f, _e1992, (_e1992 > 1.1754944e-38f)));
let _e1996 = (_e1995 & 8388607u);
let _e1998 = select(0u, 1u, (_e1996 > 3474675u));
let _e2009 = bitcast<f32>((_e1996 | ((127u - _e1998) << bitcast<u32>(23i))));
let _e2012 = ((_e2009 - 1f) / (_e2009 + 1f));
let _e2013 = (_e2012 * _e2012);
let _e2028 = (f32(((bitcast<i32>((_e1995 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1998))) + (((2f * _e2012) + ((_e2012 * _e2013) * (0.6666667f + (_e2013 * (0.4f + (_e2013 * (0.2857143f + (_e2013 * (0.22222222f + (_e2013 * 0.18181819f)))))))))) * 1.442695f));
let _e2029 = (_e1987 - 1f);
let _e2031 = select(0f, _e2028, (_e2028 > 0f));
let _e2033 = select(_e2029, _e2031, (_e2031 < _e2029));
let _e2034 = (_e1987 - 2f);
let _e2036 = select(0f, _e2034, (_e2034 > 0f));
let _e2038 = select(0f, _e2033, (_e2033 > 0f));
let _e2040 = select(_e2036, _e2038, (_e2038 < _e2036));
let _e2047 = select(0i, select(select(i32(_e2040), i32(-2147483648), (_e2040 < -2147483600f)), 2147483647i, (_e2040 > 2147483500f)), (_e2040 == _e2040));
let _e2051 = (_e2047 - select(0i, 1i, (_e2040 < f32(_e2047))));
let _e2054 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
let _e2057 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
let _e2061 = select(_e2057, _e2054, (_e2054 > _e2057));
let _e2064 = (select(_e2057, _e2054, (_e2054 < _e2057)) / select(1.1754944e-38f, _e2061, (_e2061 > 1.1754944e-38f)));
let _e2065 = (_e2064 > 0.41421357f);
let _e2069 = select(_e2064, ((_e2064 - 1f) / (_e2064 + 1f)), _e2065);
let _e2070 = (_e2069 * _e2069);
let _e2085 = (select(0f, 0.7853982f, _e2065) + (_e2069 + ((_e2069 * _e2070) * (-0.33333334f + (_e2070 * (0.2f + (_e2070 * (-0.14285713f + (_e2070 * (0.11111111f + (_e2070 * (-0.09090909f + (_e2070 * 0.0585f)))))))))))));
let _e2088 = select(_e2085, (1.5707964f - _e2085), (_e2057 > _e2054));
let _e2091 = select(_e2088, (3.1415927f - _e2088), (_e1267 < 0f));
let _e2096 = (0.5f - (select(_e2091, -(_e2091), (_e1255 < 0f)) / _e1989));
let _e2098 = select(-1f, _e1279, (_e1279 > -1f));
let _e2100 = select(1f, _e2098, (_e2098 < 1f));
let _e2103 = ((1f - _e2100) * (1f + _e2100));
let _e2106 = sqrt(select(0f, _e2103, (_e2103 > 0f)));
let _e2109 = bitcast<f32>((bitcast<u32>(_e2106) & 2147483647u));
let _e2112 = bitcast<f32>((bitcast<u32>(_e2100) & 2147483647u));
let _e2116 = select(_e2112, _e2109, (_e2109 > _e2112));
let _e2119 = (select(_e2112, _e2109, (_e2109 < _e2112)) / select(1.1754944e-38f, _e2116, (_e2116 > 1.1754944e-38f)));
let _e2120 = (_e2119 > 0.41421357f);
let _e2124 = select(_e2119, ((_e2119 - 1f) / (_e2119 + 1f)), _e2120);
let _e2125 = (_e2124 * _e2124);
let _e2140 = (select(0f, 0.7853982f, _e2120) + (_e2124 + ((_e2124 * _e2125) * (-0.33333334f + (_e2125 * (0.2f + (_e2125 * (-0.14285713f + (_e2125 * (0.11111111f + (_e2125 * (-0.09090909f + (_e2125 * 0.0585f)))))))))))));
let _e2143 = select(_e2140, (1.5707964f - _e2140), (_e2112 > _e2109));
let _e2146 = select(_e2143, (3.1415927f - _e2143), (_e2106 < 0f));
let _e2151 = (0.5f - (select(_e2146, -(_e2146), (_e2100 < 0f)) / 3.1415927f));
let _e2155 = global_2.member.member_23.member_2;
let _e2156 = bitcast<i32>(_e2155);
phi_3559_ = 0i;
phi_3562_ = 0i;
phi_3564_ = _e2156;
phi_3566_ = _e1980;
loop {
let _e2158 = phi_3559_;
let _e2160 = phi_3562_;
let _e2162 = phi_3564_;
let _e2164 = phi_3566_;
local_12 = _e2164;
local_13 = _e2162;
local_14 = _e2164;
local_15 = _e2164;
local_16 = _e2164;
local_17 = _e2164;
local_18 = _e2164;
local_19 = _e2164;
local_20 = _e2162;
local_21 = _e2162;
local_22 = _e2162;
local_23 = _e2162;
local_24 = _e2164;
local_25 = _e2160;
local_26 = _e2164;
local_27 = _e2160;
let _e2165 = (_e2158 < _e2051);
if _e2165 {
if (_e2164 > 1i) {
phi_3581_ = (_e2164 >> bitcast<u32>(1i));
} else {
phi_3581_ = 1i;
}
let _e2172 = phi_3581_;
if (_e2162 > 1i) {
phi_3587_ = (_e2162 >> bitcast<u32>(1i));
} else {
phi_3587_ = 1i;
}
let _e2177 = phi_3587_;
phi_3560_ = (_e2158 + 1i);
phi_3563_ = (_e2160 + (_e2164 * _e2162));
phi_3565_ = _e2177;
phi_3567_ = _e2172;
} else {
phi_3560_ = i32();
phi_3563_ = i32();
phi_3565_ = i32();
phi_3567_ = i32();
}
let _e2180 = phi_3560_;
let _e2182 = phi_3563_;
let _e2184 = phi_3565_;
let _e2186 = phi_3567_;
continue;
continuing {
phi_3559_ = _e2180;
phi_3562_ = _e2182;
phi_3564_ = _e2184;
phi_3566_ = _e2186;
break if !(_e2165);
}
}
let _e2189 = local_12;
let _e2190 = f32(_e2189);
let _e2192 = ((_e2096 * _e2190) - 0.5f);
let _e2194 = local_13;
let _e2195 = f32(_e2194);
let _e2197 = ((_e2151 * _e2195) - 0.5f);
let _e2199 = select(-1f, _e2192, (_e2192 > -1f));
let _e2201 = select(_e2190, _e2199, (_e2199 < _e2190));
let _e2208 = select(0i, select(select(i32(_e2201), i32(-2147483648), (_e2201 < -2147483600f)), 2147483647i, (_e2201 > 2147483500f)), (_e2201 == _e2201));
let _e2212 = (_e2208 - select(0i, 1i, (_e2201 < f32(_e2208))));
let _e2214 = select(-1f, _e2197, (_e2197 > -1f));
let _e2216 = select(_e2195, _e2214, (_e2214 < _e2195));
let _e2223 = select(0i, select(select(i32(_e2216), i32(-2147483648), (_e2216 < -2147483600f)), 2147483647i, (_e2216 > 2147483500f)), (_e2216 == _e2216));
let _e2227 = (_e2223 - select(0i, 1i, (_e2216 < f32(_e2223))));
let _e2229 = (_e2192 - f32(_e2212));
let _e2231 = (_e2197 - f32(_e2227));
let _e2233 = select(0f, _e2231, (_e2231 > 0f));
let _e2235 = select(1f, _e2233, (_e2233 < 1f));
if (_e2212 < 0i) {
let _e2238 = local_14;
phi_3662_ = (_e2212 + _e2238);
} else {
phi_3662_ = _e2212;
}
let _e2241 = phi_3662_;
let _e2243 = local_15;
if (_e2241 >= _e2243) {
let _e2246 = local_16;
phi_3668_ = (_e2241 - _e2246);
} else {
phi_3668_ = _e2241;
}
let _e2249 = phi_3668_;
let _e2250 = (_e2212 + 1i);
if (_e2250 < 0i) {
let _e2253 = local_17;
phi_3675_ = (_e2250 + _e2253);
} else {
phi_3675_ = _e2250;
}
let _e2256 = phi_3675_;
let _e2258 = local_18;
if (_e2256 >= _e2258) {
let _e2261 = local_19;
phi_3681_ = (_e2256 - _e2261);
} else {
phi_3681_ = _e2256;
}
let _e2264 = phi_3681_;
let _e2266 = select(_e2227, 0i, (_e2227 < 0i));
let _e2268 = local_20;
if (_e2266 >= _e2268) {
let _e2271 = local_21;
phi_3692_ = (_e2271 - 1i);
} else {
phi_3692_ = _e2266;
}
let _e2274 = phi_3692_;
let _e2275 = (_e2227 + 1i);
let _e2277 = select(_e2275, 0i, (_e2275 < 0i));
let _e2279 = local_22;
if (_e2277 >= _e2279) {
let _e2282 = local_23;
phi_3704_ = (_e2282 - 1i);
} else {
phi_3704_ = _e2277;
}
let _e2285 = phi_3704_;
let _e2287 = local_24;
let _e2290 = local_25;
let _e2291 = (_e2290 + (_e2274 * _e2287));
let _e2293 = local_26;
let _e2296 = local_27;
let _e2297 = (_e2296 + (_e2285 * _e2293));
let _e2299 = (3i * (_e2291 + _e2249));
let _e2301 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e2303 = select(_e2301, _e2299, (_e2299 < _e2301));
let _e2309 = global_4.member[bitcast<u32>(select(0i, _e2303, (_e2303 > 0i)))];
let _e2310 = (_e2299 + 1i);
let _e2312 = select(_e2301, _e2310, (_e2310 < _e2301));
let _e2318 = global_4.member[bitcast<u32>(select(0i, _e2312, (_e2312 > 0i)))];
let _e2319 = (_e2299 + 2i);
let _e2321 = select(_e2301, _e2319, (_e2319 < _e2301));
let _e2327 = global_4.member[bitcast<u32>(select(0i, _e2321, (_e2321 > 0i)))];
let _e2329 = (3i * (_e2291 + _e2264));
let _e2331 = select(_e2301, _e2329, (_e2329 < _e2301));
let _e2337 = global_4.member[bitcast<u32>(select(0i, _e2331, (_e2331 > 0i)))];
let _e2338 = (_e2329 + 1i);
let _e2340 = select(_e2301, _e2338, (_e2338 < _e2301));
let _e2346 = global_4.member[bitcast<u32>(select(0i, _e2340, (_e2340 > 0i)))];
let _e2347 = (_e2329 + 2i);
let _e2349 = select(_e2301, _e2347, (_e2347 < _e2301));
let _e2355 = global_4.member[bitcast<u32>(select(0i, _e2349, (_e2349 > 0i)))];
let _e2357 = (3i * (_e2297 + _e2249));
let _e2359 = select(_e2301, _e2357, (_e2357 < _e2301));
let _e2365 = global_4.member[bitcast<u32>(select(0i, _e2359, (_e2359 > 0i)))];
let _e2366 = (_e2357 + 1i);
let _e2368 = select(_e2301, _e2366, (_e2366 < _e2301));
let _e2374 = global_4.member[bitcast<u32>(select(0i, _e2368, (_e2368 > 0i)))];
let _e2375 = (_e2357 + 2i);
let _e2377 = select(_e2301, _e2375, (_e2375 < _e2301));
let _e2383 = global_4.member[bitcast<u32>(select(0i, _e2377, (_e2377 > 0i)))];
let _e2385 = (3i * (_e2297 + _e2264));
let _e2387 = select(_e2301, _e2385, (_e2385 < _e2301));
let _e2393 = global_4.member[bitcast<u32>(select(0i, _e2387, (_e2387 > 0i)))];
let _e2394 = (_e2385 + 1i);
let _e2396 = select(_e2301, _e2394, (_e2394 < _e2301));
let _e2402 = global_4.member[bitcast<u32>(select(0i, _e2396, (_e2396 > 0i)))];
let _e2403 = (_e2385 + 2i);
let _e2405 = select(_e2301, _e2403, (_e2403 < _e2301));
let _e2411 = global_4.member[bitcast<u32>(select(0i, _e2405, (_e2405 > 0i)))];
let _e2418 = (_e2309 + ((_e2337 - _e2309) * _e2229));
let _e2419 = (_e2318 + ((_e2346 - _e2318) * _e2229));
let _e2420 = (_e2327 + ((_e2355 - _e2327) * _e2229));
let _e2436 = (_e2418 + (((_e2365 + ((_e2393 - _e2365) * _e2229)) - _e2418) * _e2235));
let _e2437 = (_e2419 + (((_e2374 + ((_e2402 - _e2374) * _e2229)) - _e2419) * _e2235));
let _e2438 = (_e2420 + (((_e2383 + ((_e2411 - _e2383) * _e2229)) - _e2420) * _e2235));
phi_3940_ = 0i;
phi_3943_ = 0i;
phi_3945_ = _e2156;
phi_3947_ = _e1980;
loop {
let _e2441 = phi_3940_;
let _e2443 = phi_3943_;
let _e2445 = phi_3945_;
let _e2447 = phi_3947_;
local_28 = _e2447;
local_29 = _e2445;
local_30 = _e2447;
local_31 = _e2447;
local_32 = _e2447;
local_33 = _e2447;
local_34 = _e2447;
local_35 = _e2447;
local_36 = _e2445;
local_37 = _e2445;
local_38 = _e2445;
local_39 = _e2445;
local_40 = _e2447;
local_41 = _e2443;
local_42 = _e2447;
local_43 = _e2443;
let _e2448 = (_e2441 < (_e2051 + 1i));
if _e2448 {
if (_e2447 > 1i) {
phi_3962_ = (_e2447 >> bitcast<u32>(1i));
} else {
phi_3962_ = 1i;
}
let _e2455 = phi_3962_;
if (_e2445 > 1i) {
phi_3968_ = (_e2445 >> bitcast<u32>(1i));
} else {
phi_3968_ = 1i;
}
let _e2460 = phi_3968_;
phi_3941_ = (_e2441 + 1i);
phi_3944_ = (_e2443 + (_e2447 * _e2445));
phi_3946_ = _e2460;
phi_3948_ = _e2455;
} else {
phi_3941_ = i32();
phi_3944_ = i32();
phi_3946_ = i32();
phi_3948_ = i32();
}
let _e2463 = phi_3941_;
let _e2465 = phi_3944_;
let _e2467 = phi_3946_;
let _e2469 = phi_3948_;
continue;
continuing {
phi_3940_ = _e2463;
phi_3943_ = _e2465;
phi_3945_ = _e2467;
phi_3947_ = _e2469;
break if !(_e2448);
}
}
let _e2472 = local_28;
let _e2473 = f32(_e2472);
let _e2475 = ((_e2096 * _e2473) - 0.5f);
let _e2477 = local_29;
let _e2478 = f32(_e2477);
let _e2480 = ((_e2151 * _e2478) - 0.5f);
let _e2482 = select(-1f, _e2475, (_e2475 > -1f));
let _e2484 = select(_e2473, _e2482, (_e2482 < _e2473));
let _e2491 = select(0i, select(select(i32(_e2484), i32(-2147483648), (_e2484 < -2147483600f)), 2147483647i, (_e2484 > 2147483500f)), (_e2484 == _e2484));
let _e2495 = (_e2491 - select(0i, 1i, (_e2484 < f32(_e2491))));
let _e2497 = select(-1f, _e2480, (_e2480 > -1f));
let _e2499 = select(_e2478, _e2497, (_e2497 < _e2478));
let _e2506 = select(0i, select(select(i32(_e2499), i32(-2147483648), (_e2499 < -2147483600f)), 2147483647i, (_e2499 > 2147483500f)), (_e2499 == _e2499));
let _e2510 = (_e2506 - select(0i, 1i, (_e2499 < f32(_e2506))));
let _e2512 = (_e2475 - f32(_e2495));
let _e2514 = (_e2480 - f32(_e2510));
let _e2516 = select(0f, _e2514, (_e2514 > 0f));
let _e2518 = select(1f, _e2516, (_e2516 < 1f));
if (_e2495 < 0i) {
let _e2521 = local_30;
phi_4043_ = (_e2495 + _e2521);
} else {
phi_4043_ = _e2495;
}
let _e2524 = phi_4043_;
let _e2526 = local_31;
if (_e2524 >= _e2526) {
let _e2529 = local_32;
phi_4049_ = (_e2524 - _e2529);
} else {
phi_4049_ = _e2524;
}
let _e2532 = phi_4049_;
let _e2533 = (_e2495 + 1i);
if (_e2533 < 0i) {
let _e2536 = local_33;
phi_4056_ = (_e2533 + _e2536);
} else {
phi_4056_ = _e2533;
}
let _e2539 = phi_4056_;
let _e2541 = local_34;
if (_e2539 >= _e2541) {
let _e2544 = local_35;
phi_4062_ = (_e2539 - _e2544);
} else {
phi_4062_ = _e2539;
}
let _e2547 = phi_4062_;
let _e2549 = select(_e2510, 0i, (_e2510 < 0i));
let _e2551 = local_36;
if (_e2549 >= _e2551) {
let _e2554 = local_37;
phi_4073_ = (_e2554 - 1i);
} else {
phi_4073_ = _e2549;
}
let _e2557 = phi_4073_;
let _e2558 = (_e2510 + 1i);
let _e2560 = select(_e2558, 0i, (_e2558 < 0i));
let _e2562 = local_38;
if (_e2560 >= _e2562) {
let _e2565 = local_39;
phi_4085_ = (_e2565 - 1i);
} else {
phi_4085_ = _e2560;
}
let _e2568 = phi_4085_;
let _e2570 = local_40;
let _e2573 = local_41;
let _e2574 = (_e2573 + (_e2557 * _e2570));
let _e2576 = local_42;
let _e2579 = local_43;
let _e2580 = (_e2579 + (_e2568 * _e2576));
let _e2582 = (3i * (_e2574 + _e2532));
let _e2584 = select(_e2301, _e2582, (_e2582 < _e2301));
let _e2590 = global_4.member[bitcast<u32>(select(0i, _e2584, (_e2584 > 0i)))];
let _e2591 = (_e2582 + 1i);
let _e2593 = select(_e2301, _e2591, (_e2591 < _e2301));
let _e2599 = global_4.member[bitcast<u32>(select(0i, _e2593, (_e2593 > 0i)))];
let _e2600 = (_e2582 + 2i);
let _e2602 = select(_e2301, _e2600, (_e2600 < _e2301));
let _e2608 = global_4.member[bitcast<u32>(select(0i, _e2602, (_e2602 > 0i)))];
let _e2610 = (3i * (_e2574 + _e2547));
let _e2612 = select(_e2301, _e2610, (_e2610 < _e2301));
let _e2618 = global_4.member[bitcast<u32>(select(0i, _e2612, (_e2612 > 0i)))];
let _e2619 = (_e2610 + 1i);
let _e2621 = select(_e2301, _e2619, (_e2619 < _e2301));
let _e2627 = global_4.member[bitcast<u32>(select(0i, _e2621, (_e2621 > 0i)))];
let _e2628 = (_e2610 + 2i);
let _e2630 = select(_e2301, _e2628, (_e2628 < _e2301));
let _e2636 = global_4.member[bitcast<u32>(select(0i, _e2630, (_e2630 > 0i)))];
let _e2638 = (3i * (_e2580 + _e2532));
let _e2640 = select(_e2301, _e2638, (_e2638 < _e2301));
let _e2646 = global_4.member[bitcast<u32>(select(0i, _e2640, (_e2640 > 0i)))];
let _e2647 = (_e2638 + 1i);
let _e2649 = select(_e2301, _e2647, (_e2647 < _e2301));
let _e2655 = global_4.member[bitcast<u32>(select(0i, _e2649, (_e2649 > 0i)))];
let _e2656 = (_e2638 + 2i);
let _e2658 = select(_e2301, _e2656, (_e2656 < _e2301));
let _e2664 = global_4.member[bitcast<u32>(select(0i, _e2658, (_e2658 > 0i)))];
let _e2666 = (3i * (_e2580 + _e2547));
let _e2668 = select(_e2301, _e2666, (_e2666 < _e2301));
let _e2674 = global_4.member[bitcast<u32>(select(0i, _e2668, (_e2668 > 0i)))];
let _e2675 = (_e2666 + 1i);
let _e2677 = select(_e2301, _e2675, (_e2675 < _e2301));
let _e2683 = global_4.member[bitcast<u32>(select(0i, _e2677, (_e2677 > 0i)))];
let _e2684 = (_e2666 + 2i);
let _e2686 = select(_e2301, _e2684, (_e2684 < _e2301));
let _e2692 = global_4.member[bitcast<u32>(select(0i, _e2686, (_e2686 > 0i)))];
let _e2699 = (_e2590 + ((_e2618 - _e2590) * _e2512));
let _e2700 = (_e2599 + ((_e2627 - _e2599) * _e2512));
let _e2701 = (_e2608 + ((_e2636 - _e2608) * _e2512));
let _e2724 = (_e2033 - f32(_e2051));
let _e2726 = select(0f, _e2724, (_e2724 > 0f));
let _e2728 = select(1f, _e2726, (_e2726 < 1f));
let _e2738 = global_2.member.member_23.member_11;
phi_4340_ = vec3<f32>(((_e2436 + (((_e2699 + (((_e2646 + ((_e2674 - _e2646) * _e2512)) - _e2699) * _e2518)) - _e2436) * _e2728)) * _e2738), ((_e2437 + (((_e2700 + (((_e2655 + ((_e2683 - _e2655) * _e2512)) - _e2700) * _e2518)) - _e2437) * _e2728)) * _e2738), ((_e2438 + (((_e2701 + (((_e2664 + ((_e2692 - _e2664) * _e2512)) - _e2701) * _e2518)) - _e2438) * _e2728)) * _e2738));
}
let _e2744 = phi_4340_;
phi_4341_ = _e2744;
}
let _e2746 = phi_4341_;
phi_4342_ = _e2746;
}
let _e2748 = phi_4342_;
let _e2752 = global_2.member.member_23.member_12;
let _e2759 = (_e1195 * _e2752);
let _e2771 = (1f - ((_e1195 * ((_e242 + _e253) + _e264)) * (1f / 3f)));
global_1.member[_e129] = ((_e187 + ((_e242 * (select(_e446.member, _e435.member, _e424) * (((_e1114.member.x * _e1136) * _e1162) + _e1145.member))) * _e1180)) + ((_e242 * _e2748.x) * _e2759));
global_1.member[(_e127 + _e129)] = ((_e198 + ((_e253 * (select(_e446.member_1, _e435.member_1, _e424) * (((_e1114.member.y * _e1136) * _e1162) + _e1145.member_1))) * _e1180)) + ((_e253 * _e2748.y) * _e2759));
global_1.member[((2u * _e127) + _e129)] = ((_e209 + ((_e264 * (select(_e446.member_2, _e435.member_2, _e424) * (((_e1114.member.z * _e1136) * _e1162) + _e1145.member_2))) * _e1180)) + ((_e264 * _e2748.z) * _e2759));
global_1.member[((3u * _e127) + _e129)] = (_e2771 + ((1f - _e2771) * _e2752));
global_1.member[((4u * _e127) + _e129)] = _e1190;
global_1.member[((5u * _e127) + _e129)] = _e242;
global_1.member[((6u * _e127) + _e129)] = _e253;
global_1.member[((7u * _e127) + _e129)] = _e264;
global_1.member[((8u * _e127) + _e129)] = ((_e231 + (_e1180 * (_e354 + (_e311 * _e423)))) / select(1e-12f, _e1190, (_e1190 > 1e-12f)));
global_1.member[((9u * _e127) + _e129)] = _e309;
global_1.member[((10u * _e127) + _e129)] = _e310;
global_1.member[((11u * _e127) + _e129)] = -(_e311);
global_1.member[((12u * _e127) + _e129)] = select(_e352, _e470, _e1175);
global_1.member[((13u * _e127) + _e129)] = select(_e353, _e471, _e1175);
global_1.member[((14u * _e127) + _e129)] = -(select(_e354, _e472, _e1175));
global_1.member[((15u * _e127) + _e129)] = select(select(_e176, 2f, (_e176 == 4f)), 1f, _e1175);
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
