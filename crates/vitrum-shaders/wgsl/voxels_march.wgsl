struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_5 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: type_4,
member_4: type_4,
member_5: type_4,
member_6: type_4,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: vec4<u32>,
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
member_24: vec4<u32>,
member_25: type_4,
member_26: type_4,
member_27: type_4,
member_28: type_4,
}
struct type_6 {
member: type_5,
}
struct type_8 {
member: array<f32>,
}
struct type_12 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: i32,
member_13: i32,
member_14: f32,
}
struct type_14 {
member: array<u32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_6;
@group(0) @binding(3)
var<storage> global_2: type_8;
@group(0) @binding(4)
var<storage, read_write> global_3: type_8;
@group(0) @binding(1)
var<storage> global_4: type_14;
@group(0) @binding(2)
var<storage> global_5: type_14;
fn function_() {
var local: i32;
var local_1: vec3<f32>;
var phi_644_: u32;
var phi_857_: i32;
var phi_860_: i32;
var phi_858_: i32;
var phi_861_: i32;
var local_2: i32;
var phi_1200_: type_12;
var phi_1202_: type_12;
var phi_1205_: i32;
var phi_1541_: f32;
var phi_1580_: i32;
var phi_1583_: i32;
var phi_1581_: i32;
var phi_1584_: i32;
var local_3: i32;
var phi_1927_: i32;
var phi_1930_: f32;
var phi_1932_: f32;
var phi_1962_: i32;
var phi_1965_: i32;
var phi_1963_: i32;
var phi_1966_: i32;
var local_4: i32;
var phi_1928_: i32;
var phi_1931_: f32;
var phi_1933_: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var phi_2333_: i32;
var phi_2336_: i32;
var phi_2334_: i32;
var phi_2337_: i32;
var local_8: i32;
var local_9: i32;
var local_10: f32;
var local_11: i32;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var phi_5033_: type_12;
var local_17: i32;
var local_18: i32;
var phi_5244_: type_12;
var phi_5297_: type_12;
var phi_5311_: type_12;
var local_19: i32;
var phi_5750_: type_12;
var phi_5751_: type_12;
var phi_5730_: type_12;
var phi_5752_: type_12;
var local_20: i32;
var phi_5761_: type_12;
var phi_5762_: type_12;
var phi_5763_: bool;
var phi_6342_: type_12;
var local_21: i32;
var phi_6644_: type_12;
var phi_6645_: type_12;
var phi_6646_: type_12;
var phi_6053_: type_12;
var phi_6647_: type_12;
var phi_1203_: type_12;
var phi_1206_: i32;
var local_22: type_12;
var local_23: type_12;
var local_24: type_12;
var local_25: type_12;
var local_26: type_12;
var local_27: type_12;
var local_28: type_12;
var local_29: type_12;
var local_30: type_12;
var local_31: type_12;
var local_32: type_12;
var local_33: type_12;
var local_34: type_12;
var local_35: type_12;
var local_36: type_12;
var local_37: type_12;
var local_38: type_12;
var local_39: type_12;
var local_40: type_12;
var local_41: type_12;
var local_42: type_12;
var local_43: type_12;
var local_44: type_12;
var local_45: type_12;
var local_46: f32;
let _e85 = global;
let _e91 = arrayLength((&global_5.member));
let _e93 = arrayLength((&global_2.member));
let _e99 = global_1.member.member[0u];
let _e103 = global_1.member.member[1u];
if (_e85.x < _e99) {
if (_e85.y < _e103) {
let _e108 = (_e99 * _e103);
let _e110 = ((_e85.y * _e99) + _e85.x);
let _e111 = bitcast<i32>(_e110);
let _e113 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e115 = select(_e113, _e111, (_e111 < _e113));
let _e121 = global_3.member[bitcast<u32>(select(0i, _e115, (_e115 > 0i)))];
let _e122 = (_e108 + _e110);
let _e123 = bitcast<i32>(_e122);
let _e125 = select(_e113, _e123, (_e123 < _e113));
let _e131 = global_3.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e133 = ((2u * _e108) + _e110);
let _e134 = bitcast<i32>(_e133);
let _e136 = select(_e113, _e134, (_e134 < _e113));
let _e142 = global_3.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
let _e144 = ((3u * _e108) + _e110);
let _e145 = bitcast<i32>(_e144);
let _e147 = select(_e113, _e145, (_e145 < _e113));
let _e153 = global_3.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e155 = ((4u * _e108) + _e110);
let _e156 = bitcast<i32>(_e155);
let _e158 = select(_e113, _e156, (_e156 < _e113));
let _e164 = global_3.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
let _e166 = ((5u * _e108) + _e110);
let _e167 = bitcast<i32>(_e166);
let _e169 = select(_e113, _e167, (_e167 < _e113));
let _e175 = global_3.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e177 = ((6u * _e108) + _e110);
let _e178 = bitcast<i32>(_e177);
let _e180 = select(_e113, _e178, (_e178 < _e113));
let _e186 = global_3.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e188 = ((7u * _e108) + _e110);
let _e189 = bitcast<i32>(_e188);
let _e191 = select(_e113, _e189, (_e189 < _e113));
let _e197 = global_3.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e199 = ((8u * _e108) + _e110);
let _e200 = bitcast<i32>(_e199);
let _e202 = select(_e113, _e200, (_e200 < _e113));
let _e208 = global_3.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e210 = ((9u * _e108) + _e110);
let _e211 = bitcast<i32>(_e210);
let _e213 = select(_e113, _e211, (_e211 < _e113));
let _e219 = global_3.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e221 = ((10u * _e108) + _e110);
let _e222 = bitcast<i32>(_e221);
let _e224 = select(_e113, _e222, (_e222 < _e113));
let _e230 = global_3.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e232 = ((11u * _e108) + _e110);
let _e233 = bitcast<i32>(_e232);
let _e235 = select(_e113, _e233, (_e233 < _e113));
let _e241 = global_3.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e243 = ((12u * _e108) + _e110);
let _e244 = bitcast<i32>(_e243);
let _e246 = select(_e113, _e244, (_e244 < _e113));
let _e252 = global_3.member[bitcast<u32>(select(0i, _e246, (_e246 > 0i)))];
let _e254 = ((13u * _e108) + _e110);
let _e255 = bitcast<i32>(_e254);
let _e257 = select(_e113, _e255, (_e255 < _e113));
let _e263 = global_3.member[bitcast<u32>(select(0i, _e257, (_e257 > 0i)))];
let _e265 = ((14u * _e108) + _e110);
let _e266 = bitcast<i32>(_e265);
let _e268 = select(_e113, _e266, (_e266 < _e113));
let _e274 = global_3.member[bitcast<u32>(select(0i, _e268, (_e268 > 0i)))];
let _e276 = ((15u * _e108) + _e110);
let _e277 = bitcast<i32>(_e276);
let _e279 = select(_e113, _e277, (_e277 < _e113));
let _e285 = global_3.member[bitcast<u32>(select(0i, _e279, (_e279 > 0i)))];
let _e287 = ((16u * _e108) + _e110);
let _e288 = bitcast<i32>(_e287);
let _e290 = select(_e113, _e288, (_e288 < _e113));
let _e296 = global_3.member[bitcast<u32>(select(0i, _e290, (_e290 > 0i)))];
let _e298 = ((17u * _e108) + _e110);
let _e299 = bitcast<i32>(_e298);
let _e301 = select(_e113, _e299, (_e299 < _e113));
let _e307 = global_3.member[bitcast<u32>(select(0i, _e301, (_e301 > 0i)))];
let _e309 = ((18u * _e108) + _e110);
let _e310 = bitcast<i32>(_e309);
let _e312 = select(_e113, _e310, (_e310 < _e113));
let _e318 = global_3.member[bitcast<u32>(select(0i, _e312, (_e312 > 0i)))];
let _e320 = ((19u * _e108) + _e110);
let _e321 = bitcast<i32>(_e320);
let _e323 = select(_e113, _e321, (_e321 < _e113));
let _e329 = global_3.member[bitcast<u32>(select(0i, _e323, (_e323 > 0i)))];
let _e331 = ((20u * _e108) + _e110);
let _e332 = bitcast<i32>(_e331);
let _e334 = select(_e113, _e332, (_e332 < _e113));
let _e340 = global_3.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e342 = ((21u * _e108) + _e110);
let _e343 = bitcast<i32>(_e342);
let _e345 = select(_e113, _e343, (_e343 < _e113));
let _e351 = global_3.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
let _e353 = ((22u * _e108) + _e110);
let _e354 = bitcast<i32>(_e353);
let _e356 = select(_e113, _e354, (_e354 < _e113));
let _e362 = global_3.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e364 = ((23u * _e108) + _e110);
let _e365 = bitcast<i32>(_e364);
let _e367 = select(_e113, _e365, (_e365 < _e113));
let _e373 = global_3.member[bitcast<u32>(select(0i, _e367, (_e367 > 0i)))];
let _e375 = ((24u * _e108) + _e110);
let _e376 = bitcast<i32>(_e375);
let _e378 = select(_e113, _e376, (_e376 < _e113));
let _e384 = global_3.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e385 = (_e296 == 0f);
if _e385 {
phi_644_ = 3u;
} else {
phi_644_ = select(0u, 1u, (_e296 == 4f));
}
let _e389 = phi_644_;
if (_e389 > 1u) {
let _e394 = global_1.member.member[2u];
let _e395 = vec3<f32>(_e121, _e131, _e142);
let _e396 = vec3<f32>(_e153, _e164, _e175);
let _e397 = vec3<f32>(_e186, _e197, _e208);
let _e398 = vec3<f32>(_e219, _e230, _e241);
let _e399 = vec3<f32>(_e252, _e263, _e274);
let _e413 = select(0i, select(select(i32(_e362), i32(-2147483648), (_e362 < -2147483600f)), 2147483647i, (_e362 > 2147483500f)), (_e362 == _e362));
let _e420 = select(0i, select(select(i32(_e373), i32(-2147483648), (_e373 < -2147483600f)), 2147483647i, (_e373 > 2147483500f)), (_e373 == _e373));
let _e424 = global_1.member.member_8;
let _e430 = global_1.member.member_9;
if (_e385 && (_e318 == 0f)) {
let _e439 = global_1.member.member_1[3u];
phi_857_ = (bitcast<i32>(_e439) - 1i);
phi_860_ = 16i;
loop {
let _e443 = phi_857_;
let _e445 = phi_860_;
local_2 = _e445;
let _e446 = (_e443 >= 0i);
if _e446 {
let _e450 = global_1.member.member_1[0u];
let _e451 = bitcast<i32>(_e450);
let _e455 = global_1.member.member_1[1u];
let _e456 = bitcast<i32>(_e455);
let _e460 = global_1.member.member_1[2u];
let _e461 = bitcast<i32>(_e460);
let _e462 = (_e121 - 0.5f);
let _e463 = (_e131 - 0.5f);
let _e464 = (_e142 - 0.5f);
let _e466 = f32((_e451 - 2i));
let _e468 = select(0f, _e462, (_e462 > 0f));
let _e470 = select(_e466, _e468, (_e468 < _e466));
let _e477 = select(0i, select(select(i32(_e470), i32(-2147483648), (_e470 < -2147483600f)), 2147483647i, (_e470 > 2147483500f)), (_e470 == _e470));
let _e481 = (_e477 - select(0i, 1i, (_e470 < f32(_e477))));
let _e483 = f32((_e456 - 2i));
let _e485 = select(0f, _e463, (_e463 > 0f));
let _e487 = select(_e483, _e485, (_e485 < _e483));
let _e494 = select(0i, select(select(i32(_e487), i32(-2147483648), (_e487 < -2147483600f)), 2147483647i, (_e487 > 2147483500f)), (_e487 == _e487));
let _e498 = (_e494 - select(0i, 1i, (_e487 < f32(_e494))));
let _e500 = f32((_e461 - 2i));
let _e502 = select(0f, _e464, (_e464 > 0f));
let _e504 = select(_e500, _e502, (_e502 < _e500));
let _e511 = select(0i, select(select(i32(_e504), i32(-2147483648), (_e504 < -2147483600f)), 2147483647i, (_e504 > 2147483500f)), (_e504 == _e504));
let _e515 = (_e511 - select(0i, 1i, (_e504 < f32(_e511))));
let _e517 = (_e462 - f32(_e481));
let _e519 = (_e463 - f32(_e498));
let _e527 = ((((((_e443 * _e461) + _e515) * _e456) + _e498) * _e451) + _e481);
let _e528 = (2i * _e527);
let _e530 = (_e528 >> bitcast<u32>(2i));
let _e533 = bitcast<u32>(((_e528 & 3i) * 8i));
let _e535 = (bitcast<i32>(_e91) - 1i);
let _e537 = select(_e535, _e530, (_e530 < _e535));
let _e543 = global_5.member[bitcast<u32>(select(0i, _e537, (_e537 > 0i)))];
let _e547 = (_e530 + 1i);
let _e549 = select(_e535, _e547, (_e547 < _e535));
let _e555 = global_5.member[bitcast<u32>(select(0i, _e549, (_e549 > 0i)))];
let _e562 = ((_e543 >> bitcast<u32>((_e533 & 31u))) | ((_e555 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e533) & 31u))));
let _e565 = f32(bitcast<i32>((_e562 & 65535u)));
let _e572 = (_e565 + ((f32(bitcast<i32>((_e562 >> bitcast<u32>(16i)))) - _e565) * _e517));
let _e574 = (2i * (_e527 + _e451));
let _e576 = (_e574 >> bitcast<u32>(2i));
let _e579 = bitcast<u32>(((_e574 & 3i) * 8i));
let _e581 = select(_e535, _e576, (_e576 < _e535));
let _e587 = global_5.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e591 = (_e576 + 1i);
let _e593 = select(_e535, _e591, (_e591 < _e535));
let _e599 = global_5.member[bitcast<u32>(select(0i, _e593, (_e593 > 0i)))];
let _e606 = ((_e587 >> bitcast<u32>((_e579 & 31u))) | ((_e599 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e579) & 31u))));
let _e609 = f32(bitcast<i32>((_e606 & 65535u)));
let _e618 = (_e527 + (_e451 * _e456));
let _e619 = (2i * _e618);
let _e621 = (_e619 >> bitcast<u32>(2i));
let _e624 = bitcast<u32>(((_e619 & 3i) * 8i));
let _e626 = select(_e535, _e621, (_e621 < _e535));
let _e632 = global_5.member[bitcast<u32>(select(0i, _e626, (_e626 > 0i)))];
let _e636 = (_e621 + 1i);
let _e638 = select(_e535, _e636, (_e636 < _e535));
let _e644 = global_5.member[bitcast<u32>(select(0i, _e638, (_e638 > 0i)))];
let _e651 = ((_e632 >> bitcast<u32>((_e624 & 31u))) | ((_e644 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e624) & 31u))));
let _e654 = f32(bitcast<i32>((_e651 & 65535u)));
let _e661 = (_e654 + ((f32(bitcast<i32>((_e651 >> bitcast<u32>(16i)))) - _e654) * _e517));
let _e663 = (2i * (_e618 + _e451));
let _e665 = (_e663 >> bitcast<u32>(2i));
let _e668 = bitcast<u32>(((_e663 & 3i) * 8i));
let _e670 = select(_e535, _e665, (_e665 < _e535));
let _e676 = global_5.member[bitcast<u32>(select(0i, _e670, (_e670 > 0i)))];
let _e680 = (_e665 + 1i);
let _e682 = select(_e535, _e680, (_e680 < _e535));
let _e688 = global_5.member[bitcast<u32>(select(0i, _e682, (_e682 > 0i)))];
let _e695 = ((_e676 >> bitcast<u32>((_e668 & 31u))) | ((_e688 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e668) & 31u))));
let _e698 = f32(bitcast<i32>((_e695 & 65535u)));
let _e708 = (_e572 + (((_e609 + ((f32(bitcast<i32>((_e606 >> bitcast<u32>(16i)))) - _e609) * _e517)) - _e572) * _e519));
phi_858_ = (_e443 - 1i);
phi_861_ = select(_e445, _e443, ((_e708 + (((_e661 + (((_e698 + ((f32(bitcast<i32>((_e695 >> bitcast<u32>(16i)))) - _e698) * _e517)) - _e661) * _e519)) - _e708) * (_e464 - f32(_e515)))) > 32767.5f));
} else {
phi_858_ = i32();
phi_861_ = i32();
}
let _e719 = phi_858_;
let _e721 = phi_861_;
continue;
continuing {
phi_857_ = _e719;
phi_860_ = _e721;
break if !(_e446);
}
}
let _e724 = local_2;
phi_1200_ = type_12(_e395, _e396, _e397, _e398, _e399, _e285, _e296, _e724, _e318, _e329, _e340, _e351, _e413, _e420, _e384);
} else {
phi_1200_ = type_12(_e395, _e396, _e397, _e398, _e399, _e285, _e296, select(0i, select(select(i32(_e307), i32(-2147483648), (_e307 < -2147483600f)), 2147483647i, (_e307 > 2147483500f)), (_e307 == _e307)), _e318, _e329, _e340, _e351, _e413, _e420, _e384);
}
let _e727 = phi_1200_;
phi_1202_ = _e727;
phi_1205_ = 0i;
loop {
let _e729 = phi_1202_;
let _e731 = phi_1205_;
local_22 = _e729;
local_23 = _e729;
local_24 = _e729;
local_25 = _e729;
local_26 = _e729;
local_27 = _e729;
local_28 = _e729;
local_29 = _e729;
local_30 = _e729;
local_31 = _e729;
local_32 = _e729;
local_33 = _e729;
local_34 = _e729;
local_35 = _e729;
local_36 = _e729;
local_37 = _e729;
local_38 = _e729;
local_39 = _e729;
local_40 = _e729;
local_41 = _e729;
local_42 = _e729;
local_43 = _e729;
local_44 = _e729;
local_45 = _e729;
let _e735 = ((_e731 < 256i) && (_e729.member_6 == 0f));
local_46 = _e729.member_6;
if _e735 {
let _e746 = (1f / select(_e729.member_1.x, select(1e-12f, -1e-12f, (_e729.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e729.member_1.x) & 2147483647u)) < 1e-12f)));
let _e755 = (1f / select(_e729.member_1.y, select(1e-12f, -1e-12f, (_e729.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e729.member_1.y) & 2147483647u)) < 1e-12f)));
let _e764 = (1f / select(_e729.member_1.z, select(1e-12f, -1e-12f, (_e729.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e729.member_1.z) & 2147483647u)) < 1e-12f)));
let _e768 = ((_e424.member - _e729.member.x) * _e746);
let _e770 = ((_e430.member - _e729.member.x) * _e746);
let _e773 = ((_e424.member_1 - _e729.member.y) * _e755);
let _e775 = ((_e430.member_1 - _e729.member.y) * _e755);
let _e778 = ((_e424.member_2 - _e729.member.z) * _e764);
let _e780 = ((_e430.member_2 - _e729.member.z) * _e764);
let _e782 = select(_e770, _e768, (_e768 > _e770));
let _e784 = select(_e775, _e773, (_e773 > _e775));
let _e786 = select(_e784, _e782, (_e782 < _e784));
let _e788 = select(_e780, _e778, (_e778 > _e780));
let _e790 = select(_e788, _e786, (_e786 < _e788));
let _e794 = global_1.member.member_2[0u];
let _e795 = bitcast<i32>(_e794);
let _e799 = global_1.member.member_2[1u];
let _e800 = bitcast<i32>(_e799);
let _e804 = global_1.member.member_2[2u];
let _e807 = ((_e729.member.x - 0.5f) / 4f);
let _e809 = f32((_e795 - 1i));
let _e811 = select(0f, _e807, (_e807 > 0f));
let _e813 = select(_e809, _e811, (_e811 < _e809));
let _e820 = select(0i, select(select(i32(_e813), i32(-2147483648), (_e813 < -2147483600f)), 2147483647i, (_e813 > 2147483500f)), (_e813 == _e813));
let _e824 = (_e820 - select(0i, 1i, (_e813 < f32(_e820))));
let _e826 = ((_e729.member.y - 0.5f) / 4f);
let _e828 = f32((_e800 - 1i));
let _e830 = select(0f, _e826, (_e826 > 0f));
let _e832 = select(_e828, _e830, (_e830 < _e828));
let _e839 = select(0i, select(select(i32(_e832), i32(-2147483648), (_e832 < -2147483600f)), 2147483647i, (_e832 > 2147483500f)), (_e832 == _e832));
let _e843 = (_e839 - select(0i, 1i, (_e832 < f32(_e839))));
let _e845 = ((_e729.member.z - 0.5f) / 4f);
let _e847 = f32((bitcast<i32>(_e804) - 1i));
let _e849 = select(0f, _e845, (_e845 > 0f));
let _e851 = select(_e847, _e849, (_e849 < _e847));
let _e858 = select(0i, select(select(i32(_e851), i32(-2147483648), (_e851 < -2147483600f)), 2147483647i, (_e851 > 2147483500f)), (_e851 == _e851));
let _e862 = (_e858 - select(0i, 1i, (_e851 < f32(_e858))));
let _e866 = ((((_e862 * _e800) + _e843) * _e795) + _e824);
let _e868 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e870 = select(_e868, _e866, (_e866 < _e868));
let _e876 = global_4.member[bitcast<u32>(select(0i, _e870, (_e870 > 0i)))];
let _e877 = bitcast<i32>(_e876);
if (_e877 > 0i) {
let _e907 = ((((f32(((_e824 - _e877) + 1i)) * 4f) + 0.5f) - _e729.member.x) * _e746);
let _e909 = ((((f32((_e824 + _e877)) * 4f) + 0.5f) - _e729.member.x) * _e746);
let _e911 = ((((f32(((_e843 - _e877) + 1i)) * 4f) + 0.5f) - _e729.member.y) * _e755);
let _e913 = ((((f32((_e843 + _e877)) * 4f) + 0.5f) - _e729.member.y) * _e755);
let _e915 = ((((f32(((_e862 - _e877) + 1i)) * 4f) + 0.5f) - _e729.member.z) * _e764);
let _e917 = ((((f32((_e862 + _e877)) * 4f) + 0.5f) - _e729.member.z) * _e764);
let _e919 = select(_e909, _e907, (_e907 > _e909));
let _e921 = select(_e913, _e911, (_e911 > _e913));
let _e923 = select(_e921, _e919, (_e919 < _e921));
let _e925 = select(_e917, _e915, (_e915 > _e917));
let _e927 = select(_e925, _e923, (_e923 < _e925));
phi_1541_ = (select(0f, _e927, (_e927 > 0f)) + 1e-3f);
} else {
phi_1541_ = 0.5f;
}
let _e932 = phi_1541_;
let _e935 = (select(0f, _e790, (_e790 > 0f)) + 1e-3f);
let _e937 = select(_e935, _e932, (_e932 < _e935));
let _e939 = (_e729.member_14 <= _e937);
let _e940 = select(_e937, _e729.member_14, _e939);
let _e951 = global_1.member.member_1[3u];
let _e953 = (bitcast<i32>(_e951) - 1i);
phi_1580_ = _e953;
phi_1583_ = 16i;
loop {
let _e955 = phi_1580_;
let _e957 = phi_1583_;
local_3 = _e957;
local_21 = _e957;
let _e958 = (_e955 >= 0i);
if _e958 {
let _e962 = global_1.member.member_1[0u];
let _e963 = bitcast<i32>(_e962);
let _e967 = global_1.member.member_1[1u];
let _e968 = bitcast<i32>(_e967);
let _e972 = global_1.member.member_1[2u];
let _e973 = bitcast<i32>(_e972);
let _e974 = ((_e729.member.x + (_e729.member_1.x * _e940)) - 0.5f);
let _e975 = ((_e729.member.y + (_e729.member_1.y * _e940)) - 0.5f);
let _e976 = ((_e729.member.z + (_e729.member_1.z * _e940)) - 0.5f);
let _e978 = f32((_e963 - 2i));
let _e980 = select(0f, _e974, (_e974 > 0f));
let _e982 = select(_e978, _e980, (_e980 < _e978));
let _e989 = select(0i, select(select(i32(_e982), i32(-2147483648), (_e982 < -2147483600f)), 2147483647i, (_e982 > 2147483500f)), (_e982 == _e982));
let _e993 = (_e989 - select(0i, 1i, (_e982 < f32(_e989))));
let _e995 = f32((_e968 - 2i));
let _e997 = select(0f, _e975, (_e975 > 0f));
let _e999 = select(_e995, _e997, (_e997 < _e995));
let _e1006 = select(0i, select(select(i32(_e999), i32(-2147483648), (_e999 < -2147483600f)), 2147483647i, (_e999 > 2147483500f)), (_e999 == _e999));
let _e1010 = (_e1006 - select(0i, 1i, (_e999 < f32(_e1006))));
let _e1012 = f32((_e973 - 2i));
let _e1014 = select(0f, _e976, (_e976 > 0f));
let _e1016 = select(_e1012, _e1014, (_e1014 < _e1012));
let _e1023 = select(0i, select(select(i32(_e1016), i32(-2147483648), (_e1016 < -2147483600f)), 2147483647i, (_e1016 > 2147483500f)), (_e1016 == _e1016));
let _e1027 = (_e1023 - select(0i, 1i, (_e1016 < f32(_e1023))));
let _e1029 = (_e974 - f32(_e993));
let _e1031 = (_e975 - f32(_e1010));
let _e1039 = ((((((_e955 * _e973) + _e1027) * _e968) + _e1010) * _e963) + _e993);
let _e1040 = (2i * _e1039);
let _e1042 = (_e1040 >> bitcast<u32>(2i));
let _e1045 = bitcast<u32>(((_e1040 & 3i) * 8i));
let _e1047 = (bitcast<i32>(_e91) - 1i);
let _e1049 = select(_e1047, _e1042, (_e1042 < _e1047));
let _e1055 = global_5.member[bitcast<u32>(select(0i, _e1049, (_e1049 > 0i)))];
let _e1059 = (_e1042 + 1i);
let _e1061 = select(_e1047, _e1059, (_e1059 < _e1047));
let _e1067 = global_5.member[bitcast<u32>(select(0i, _e1061, (_e1061 > 0i)))];
let _e1074 = ((_e1055 >> bitcast<u32>((_e1045 & 31u))) | ((_e1067 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1045) & 31u))));
let _e1077 = f32(bitcast<i32>((_e1074 & 65535u)));
let _e1084 = (_e1077 + ((f32(bitcast<i32>((_e1074 >> bitcast<u32>(16i)))) - _e1077) * _e1029));
let _e1086 = (2i * (_e1039 + _e963));
let _e1088 = (_e1086 >> bitcast<u32>(2i));
let _e1091 = bitcast<u32>(((_e1086 & 3i) * 8i));
let _e1093 = select(_e1047, _e1088, (_e1088 < _e1047));
let _e1099 = global_5.member[bitcast<u32>(select(0i, _e1093, (_e1093 > 0i)))];
let _e1103 = (_e1088 + 1i);
let _e1105 = select(_e1047, _e1103, (_e1103 < _e1047));
let _e1111 = global_5.member[bitcast<u32>(select(0i, _e1105, (_e1105 > 0i)))];
let _e1118 = ((_e1099 >> bitcast<u32>((_e1091 & 31u))) | ((_e1111 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1091) & 31u))));
let _e1121 = f32(bitcast<i32>((_e1118 & 65535u)));
let _e1130 = (_e1039 + (_e963 * _e968));
let _e1131 = (2i * _e1130);
let _e1133 = (_e1131 >> bitcast<u32>(2i));
let _e1136 = bitcast<u32>(((_e1131 & 3i) * 8i));
let _e1138 = select(_e1047, _e1133, (_e1133 < _e1047));
let _e1144 = global_5.member[bitcast<u32>(select(0i, _e1138, (_e1138 > 0i)))];
let _e1148 = (_e1133 + 1i);
let _e1150 = select(_e1047, _e1148, (_e1148 < _e1047));
let _e1156 = global_5.member[bitcast<u32>(select(0i, _e1150, (_e1150 > 0i)))];
let _e1163 = ((_e1144 >> bitcast<u32>((_e1136 & 31u))) | ((_e1156 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1136) & 31u))));
let _e1166 = f32(bitcast<i32>((_e1163 & 65535u)));
let _e1173 = (_e1166 + ((f32(bitcast<i32>((_e1163 >> bitcast<u32>(16i)))) - _e1166) * _e1029));
let _e1175 = (2i * (_e1130 + _e963));
let _e1177 = (_e1175 >> bitcast<u32>(2i));
let _e1180 = bitcast<u32>(((_e1175 & 3i) * 8i));
let _e1182 = select(_e1047, _e1177, (_e1177 < _e1047));
let _e1188 = global_5.member[bitcast<u32>(select(0i, _e1182, (_e1182 > 0i)))];
let _e1192 = (_e1177 + 1i);
let _e1194 = select(_e1047, _e1192, (_e1192 < _e1047));
let _e1200 = global_5.member[bitcast<u32>(select(0i, _e1194, (_e1194 > 0i)))];
let _e1207 = ((_e1188 >> bitcast<u32>((_e1180 & 31u))) | ((_e1200 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1180) & 31u))));
let _e1210 = f32(bitcast<i32>((_e1207 & 65535u)));
let _e1220 = (_e1084 + (((_e1121 + ((f32(bitcast<i32>((_e1118 >> bitcast<u32>(16i)))) - _e1121) * _e1029)) - _e1084) * _e1031));
phi_1581_ = (_e955 - 1i);
phi_1584_ = select(_e957, _e955, ((_e1220 + (((_e1173 + (((_e1210 + ((f32(bitcast<i32>((_e1207 >> bitcast<u32>(16i)))) - _e1210) * _e1029)) - _e1173) * _e1031)) - _e1220) * (_e976 - f32(_e1027)))) > 32767.5f));
} else {
phi_1581_ = i32();
phi_1584_ = i32();
}
let _e1231 = phi_1581_;
let _e1233 = phi_1584_;
continue;
continuing {
phi_1580_ = _e1231;
phi_1583_ = _e1233;
break if !(_e958);
}
}
let _e1236 = local_3;
let _e1237 = (_e1236 == _e729.member_7);
if _e1237 {
phi_5762_ = _e729;
phi_5763_ = _e1237;
} else {
phi_1927_ = 0i;
phi_1930_ = 0f;
phi_1932_ = _e940;
loop {
let _e1239 = phi_1927_;
let _e1241 = phi_1930_;
let _e1243 = phi_1932_;
local_5 = _e1243;
local_6 = _e1243;
local_7 = _e1243;
local_10 = _e1243;
local_12 = _e1243;
local_13 = _e1243;
local_14 = _e1243;
local_15 = _e1243;
local_16 = _e1243;
let _e1244 = (_e1239 < 12i);
if _e1244 {
let _e1246 = (0.5f * (_e1241 + _e1243));
phi_1962_ = _e953;
phi_1965_ = 16i;
loop {
let _e1254 = phi_1962_;
let _e1256 = phi_1965_;
local_4 = _e1256;
let _e1257 = (_e1254 >= 0i);
if _e1257 {
let _e1261 = global_1.member.member_1[0u];
let _e1262 = bitcast<i32>(_e1261);
let _e1266 = global_1.member.member_1[1u];
let _e1267 = bitcast<i32>(_e1266);
let _e1271 = global_1.member.member_1[2u];
let _e1272 = bitcast<i32>(_e1271);
let _e1273 = ((_e729.member.x + (_e729.member_1.x * _e1246)) - 0.5f);
let _e1274 = ((_e729.member.y + (_e729.member_1.y * _e1246)) - 0.5f);
let _e1275 = ((_e729.member.z + (_e729.member_1.z * _e1246)) - 0.5f);
let _e1277 = f32((_e1262 - 2i));
let _e1279 = select(0f, _e1273, (_e1273 > 0f));
let _e1281 = select(_e1277, _e1279, (_e1279 < _e1277));
let _e1288 = select(0i, select(select(i32(_e1281), i32(-2147483648), (_e1281 < -2147483600f)), 2147483647i, (_e1281 > 2147483500f)), (_e1281 == _e1281));
let _e1292 = (_e1288 - select(0i, 1i, (_e1281 < f32(_e1288))));
let _e1294 = f32((_e1267 - 2i));
let _e1296 = select(0f, _e1274, (_e1274 > 0f));
let _e1298 = select(_e1294, _e1296, (_e1296 < _e1294));
let _e1305 = select(0i, select(select(i32(_e1298), i32(-2147483648), (_e1298 < -2147483600f)), 2147483647i, (_e1298 > 2147483500f)), (_e1298 == _e1298));
let _e1309 = (_e1305 - select(0i, 1i, (_e1298 < f32(_e1305))));
let _e1311 = f32((_e1272 - 2i));
let _e1313 = select(0f, _e1275, (_e1275 > 0f));
let _e1315 = select(_e1311, _e1313, (_e1313 < _e1311));
let _e1322 = select(0i, select(select(i32(_e1315), i32(-2147483648), (_e1315 < -2147483600f)), 2147483647i, (_e1315 > 2147483500f)), (_e1315 == _e1315));
let _e1326 = (_e1322 - select(0i, 1i, (_e1315 < f32(_e1322))));
let _e1328 = (_e1273 - f32(_e1292));
let _e1330 = (_e1274 - f32(_e1309));
let _e1338 = ((((((_e1254 * _e1272) + _e1326) * _e1267) + _e1309) * _e1262) + _e1292);
let _e1339 = (2i * _e1338);
let _e1341 = (_e1339 >> bitcast<u32>(2i));
let _e1344 = bitcast<u32>(((_e1339 & 3i) * 8i));
let _e1346 = (bitcast<i32>(_e91) - 1i);
let _e1348 = select(_e1346, _e1341, (_e1341 < _e1346));
let _e1354 = global_5.member[bitcast<u32>(select(0i, _e1348, (_e1348 > 0i)))];
let _e1358 = (_e1341 + 1i);
let _e1360 = select(_e1346, _e1358, (_e1358 < _e1346));
let _e1366 = global_5.member[bitcast<u32>(select(0i, _e1360, (_e1360 > 0i)))];
let _e1373 = ((_e1354 >> bitcast<u32>((_e1344 & 31u))) | ((_e1366 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1344) & 31u))));
let _e1376 = f32(bitcast<i32>((_e1373 & 65535u)));
let _e1383 = (_e1376 + ((f32(bitcast<i32>((_e1373 >> bitcast<u32>(16i)))) - _e1376) * _e1328));
let _e1385 = (2i * (_e1338 + _e1262));
let _e1387 = (_e1385 >> bitcast<u32>(2i));
let _e1390 = bitcast<u32>(((_e1385 & 3i) * 8i));
let _e1392 = select(_e1346, _e1387, (_e1387 < _e1346));
let _e1398 = global_5.member[bitcast<u32>(select(0i, _e1392, (_e1392 > 0i)))];
let _e1402 = (_e1387 + 1i);
let _e1404 = select(_e1346, _e1402, (_e1402 < _e1346));
let _e1410 = global_5.member[bitcast<u32>(select(0i, _e1404, (_e1404 > 0i)))];
let _e1417 = ((_e1398 >> bitcast<u32>((_e1390 & 31u))) | ((_e1410 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1390) & 31u))));
let _e1420 = f32(bitcast<i32>((_e1417 & 65535u)));
let _e1429 = (_e1338 + (_e1262 * _e1267));
let _e1430 = (2i * _e1429);
let _e1432 = (_e1430 >> bitcast<u32>(2i));
let _e1435 = bitcast<u32>(((_e1430 & 3i) * 8i));
let _e1437 = select(_e1346, _e1432, (_e1432 < _e1346));
let _e1443 = global_5.member[bitcast<u32>(select(0i, _e1437, (_e1437 > 0i)))];
let _e1447 = (_e1432 + 1i);
let _e1449 = select(_e1346, _e1447, (_e1447 < _e1346));
let _e1455 = global_5.member[bitcast<u32>(select(0i, _e1449, (_e1449 > 0i)))];
let _e1462 = ((_e1443 >> bitcast<u32>((_e1435 & 31u))) | ((_e1455 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1435) & 31u))));
let _e1465 = f32(bitcast<i32>((_e1462 & 65535u)));
let _e1472 = (_e1465 + ((f32(bitcast<i32>((_e1462 >> bitcast<u32>(16i)))) - _e1465) * _e1328));
let _e1474 = (2i * (_e1429 + _e1262));
let _e1476 = (_e1474 >> bitcast<u32>(2i));
let _e1479 = bitcast<u32>(((_e1474 & 3i) * 8i));
let _e1481 = select(_e1346, _e1476, (_e1476 < _e1346));
let _e1487 = global_5.member[bitcast<u32>(select(0i, _e1481, (_e1481 > 0i)))];
let _e1491 = (_e1476 + 1i);
let _e1493 = select(_e1346, _e1491, (_e1491 < _e1346));
let _e1499 = global_5.member[bitcast<u32>(select(0i, _e1493, (_e1493 > 0i)))];
let _e1506 = ((_e1487 >> bitcast<u32>((_e1479 & 31u))) | ((_e1499 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1479) & 31u))));
let _e1509 = f32(bitcast<i32>((_e1506 & 65535u)));
let _e1519 = (_e1383 + (((_e1420 + ((f32(bitcast<i32>((_e1417 >> bitcast<u32>(16i)))) - _e1420) * _e1328)) - _e1383) * _e1330));
phi_1963_ = (_e1254 - 1i);
phi_1966_ = select(_e1256, _e1254, ((_e1519 + (((_e1472 + (((_e1509 + ((f32(bitcast<i32>((_e1506 >> bitcast<u32>(16i)))) - _e1509) * _e1328)) - _e1472) * _e1330)) - _e1519) * (_e1275 - f32(_e1326)))) > 32767.5f));
} else {
phi_1963_ = i32();
phi_1966_ = i32();
}
let _e1530 = phi_1963_;
let _e1532 = phi_1966_;
continue;
continuing {
phi_1962_ = _e1530;
phi_1965_ = _e1532;
break if !(_e1257);
}
}
let _e1535 = local_4;
let _e1536 = (_e1535 == _e729.member_7);
phi_1928_ = (_e1239 + 1i);
phi_1931_ = select(_e1241, _e1246, _e1536);
phi_1933_ = select(_e1246, _e1243, _e1536);
} else {
phi_1928_ = i32();
phi_1931_ = f32();
phi_1933_ = f32();
}
let _e1541 = phi_1928_;
let _e1543 = phi_1931_;
let _e1545 = phi_1933_;
continue;
continuing {
phi_1927_ = _e1541;
phi_1930_ = _e1543;
phi_1932_ = _e1545;
break if !(_e1244);
}
}
let _e1548 = local_5;
let _e1549 = (_e729.member_1.x * _e1548);
let _e1551 = local_6;
let _e1552 = (_e729.member_1.y * _e1551);
let _e1554 = local_7;
let _e1555 = (_e729.member_1.z * _e1554);
phi_2333_ = _e953;
phi_2336_ = 16i;
loop {
let _e1562 = phi_2333_;
let _e1564 = phi_2336_;
local_8 = _e1564;
local_9 = _e1564;
local_11 = _e1564;
local_17 = _e1564;
local_18 = _e1564;
local_19 = _e1564;
local_20 = _e1564;
let _e1565 = (_e1562 >= 0i);
if _e1565 {
let _e1569 = global_1.member.member_1[0u];
let _e1570 = bitcast<i32>(_e1569);
let _e1574 = global_1.member.member_1[1u];
let _e1575 = bitcast<i32>(_e1574);
let _e1579 = global_1.member.member_1[2u];
let _e1580 = bitcast<i32>(_e1579);
let _e1581 = ((_e729.member.x + _e1549) - 0.5f);
let _e1582 = ((_e729.member.y + _e1552) - 0.5f);
let _e1583 = ((_e729.member.z + _e1555) - 0.5f);
let _e1585 = f32((_e1570 - 2i));
let _e1587 = select(0f, _e1581, (_e1581 > 0f));
let _e1589 = select(_e1585, _e1587, (_e1587 < _e1585));
let _e1596 = select(0i, select(select(i32(_e1589), i32(-2147483648), (_e1589 < -2147483600f)), 2147483647i, (_e1589 > 2147483500f)), (_e1589 == _e1589));
let _e1600 = (_e1596 - select(0i, 1i, (_e1589 < f32(_e1596))));
let _e1602 = f32((_e1575 - 2i));
let _e1604 = select(0f, _e1582, (_e1582 > 0f));
let _e1606 = select(_e1602, _e1604, (_e1604 < _e1602));
let _e1613 = select(0i, select(select(i32(_e1606), i32(-2147483648), (_e1606 < -2147483600f)), 2147483647i, (_e1606 > 2147483500f)), (_e1606 == _e1606));
let _e1617 = (_e1613 - select(0i, 1i, (_e1606 < f32(_e1613))));
let _e1619 = f32((_e1580 - 2i));
let _e1621 = select(0f, _e1583, (_e1583 > 0f));
let _e1623 = select(_e1619, _e1621, (_e1621 < _e1619));
let _e1630 = select(0i, select(select(i32(_e1623), i32(-2147483648), (_e1623 < -2147483600f)), 2147483647i, (_e1623 > 2147483500f)), (_e1623 == _e1623));
let _e1634 = (_e1630 - select(0i, 1i, (_e1623 < f32(_e1630))));
let _e1636 = (_e1581 - f32(_e1600));
let _e1638 = (_e1582 - f32(_e1617));
let _e1646 = ((((((_e1562 * _e1580) + _e1634) * _e1575) + _e1617) * _e1570) + _e1600);
let _e1647 = (2i * _e1646);
let _e1649 = (_e1647 >> bitcast<u32>(2i));
let _e1652 = bitcast<u32>(((_e1647 & 3i) * 8i));
let _e1654 = (bitcast<i32>(_e91) - 1i);
let _e1656 = select(_e1654, _e1649, (_e1649 < _e1654));
let _e1662 = global_5.member[bitcast<u32>(select(0i, _e1656, (_e1656 > 0i)))];
let _e1666 = (_e1649 + 1i);
let _e1668 = select(_e1654, _e1666, (_e1666 < _e1654));
let _e1674 = global_5.member[bitcast<u32>(select(0i, _e1668, (_e1668 > 0i)))];
let _e1681 = ((_e1662 >> bitcast<u32>((_e1652 & 31u))) | ((_e1674 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1652) & 31u))));
let _e1684 = f32(bitcast<i32>((_e1681 & 65535u)));
let _e1691 = (_e1684 + ((f32(bitcast<i32>((_e1681 >> bitcast<u32>(16i)))) - _e1684) * _e1636));
let _e1693 = (2i * (_e1646 + _e1570));
let _e1695 = (_e1693 >> bitcast<u32>(2i));
let _e1698 = bitcast<u32>(((_e1693 & 3i) * 8i));
let _e1700 = select(_e1654, _e1695, (_e1695 < _e1654));
let _e1706 = global_5.member[bitcast<u32>(select(0i, _e1700, (_e1700 > 0i)))];
let _e1710 = (_e1695 + 1i);
let _e1712 = select(_e1654, _e1710, (_e1710 < _e1654));
let _e1718 = global_5.member[bitcast<u32>(select(0i, _e1712, (_e1712 > 0i)))];
let _e1725 = ((_e1706 >> bitcast<u32>((_e1698 & 31u))) | ((_e1718 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1698) & 31u))));
let _e1728 = f32(bitcast<i32>((_e1725 & 65535u)));
let _e1737 = (_e1646 + (_e1570 * _e1575));
let _e1738 = (2i * _e1737);
let _e1740 = (_e1738 >> bitcast<u32>(2i));
let _e1743 = bitcast<u32>(((_e1738 & 3i) * 8i));
let _e1745 = select(_e1654, _e1740, (_e1740 < _e1654));
let _e1751 = global_5.member[bitcast<u32>(select(0i, _e1745, (_e1745 > 0i)))];
let _e1755 = (_e1740 + 1i);
let _e1757 = select(_e1654, _e1755, (_e1755 < _e1654));
let _e1763 = global_5.member[bitcast<u32>(select(0i, _e1757, (_e1757 > 0i)))];
let _e1770 = ((_e1751 >> bitcast<u32>((_e1743 & 31u))) | ((_e1763 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1743) & 31u))));
let _e1773 = f32(bitcast<i32>((_e1770 & 65535u)));
let _e1780 = (_e1773 + ((f32(bitcast<i32>((_e1770 >> bitcast<u32>(16i)))) - _e1773) * _e1636));
let _e1782 = (2i * (_e1737 + _e1570));
let _e1784 = (_e1782 >> bitcast<u32>(2i));
let _e1787 = bitcast<u32>(((_e1782 & 3i) * 8i));
let _e1789 = select(_e1654, _e1784, (_e1784 < _e1654));
let _e1795 = global_5.member[bitcast<u32>(select(0i, _e1789, (_e1789 > 0i)))];
let _e1799 = (_e1784 + 1i);
let _e1801 = select(_e1654, _e1799, (_e1799 < _e1654));
let _e1807 = global_5.member[bitcast<u32>(select(0i, _e1801, (_e1801 > 0i)))];
let _e1814 = ((_e1795 >> bitcast<u32>((_e1787 & 31u))) | ((_e1807 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1787) & 31u))));
let _e1817 = f32(bitcast<i32>((_e1814 & 65535u)));
let _e1827 = (_e1691 + (((_e1728 + ((f32(bitcast<i32>((_e1725 >> bitcast<u32>(16i)))) - _e1728) * _e1636)) - _e1691) * _e1638));
phi_2334_ = (_e1562 - 1i);
phi_2337_ = select(_e1564, _e1562, ((_e1827 + (((_e1780 + (((_e1817 + ((f32(bitcast<i32>((_e1814 >> bitcast<u32>(16i)))) - _e1817) * _e1636)) - _e1780) * _e1638)) - _e1827) * (_e1583 - f32(_e1634)))) > 32767.5f));
} else {
phi_2334_ = i32();
phi_2337_ = i32();
}
let _e1838 = phi_2334_;
let _e1840 = phi_2337_;
continue;
continuing {
phi_2333_ = _e1838;
phi_2336_ = _e1840;
break if !(_e1565);
}
}
let _e1843 = local_8;
let _e1846 = local_9;
local = select(_e729.member_7, _e1846, (_e1843 < _e729.member_7));
local_1 = (_e729.member + vec3<f32>(_e1549, _e1552, _e1555));
let _e1851 = local;
let _e1852 = local_1[0u];
let _e1854 = local_1[1u];
let _e1856 = local_1[2u];
let _e1860 = global_1.member.member_1[0u];
let _e1861 = bitcast<i32>(_e1860);
let _e1864 = global_1.member.member_1[1u];
let _e1865 = bitcast<i32>(_e1864);
let _e1868 = global_1.member.member_1[2u];
let _e1869 = bitcast<i32>(_e1868);
let _e1870 = ((_e1852 + -1f) - 0.5f);
let _e1871 = ((_e1854 + 0f) - 0.5f);
let _e1872 = ((_e1856 + 0f) - 0.5f);
let _e1874 = f32((_e1861 - 2i));
let _e1876 = select(0f, _e1870, (_e1870 > 0f));
let _e1878 = select(_e1874, _e1876, (_e1876 < _e1874));
let _e1885 = select(0i, select(select(i32(_e1878), i32(-2147483648), (_e1878 < -2147483600f)), 2147483647i, (_e1878 > 2147483500f)), (_e1878 == _e1878));
let _e1889 = (_e1885 - select(0i, 1i, (_e1878 < f32(_e1885))));
let _e1891 = f32((_e1865 - 2i));
let _e1893 = select(0f, _e1871, (_e1871 > 0f));
let _e1895 = select(_e1891, _e1893, (_e1893 < _e1891));
let _e1902 = select(0i, select(select(i32(_e1895), i32(-2147483648), (_e1895 < -2147483600f)), 2147483647i, (_e1895 > 2147483500f)), (_e1895 == _e1895));
let _e1906 = (_e1902 - select(0i, 1i, (_e1895 < f32(_e1902))));
let _e1908 = f32((_e1869 - 2i));
let _e1910 = select(0f, _e1872, (_e1872 > 0f));
let _e1912 = select(_e1908, _e1910, (_e1910 < _e1908));
let _e1919 = select(0i, select(select(i32(_e1912), i32(-2147483648), (_e1912 < -2147483600f)), 2147483647i, (_e1912 > 2147483500f)), (_e1912 == _e1912));
let _e1923 = (_e1919 - select(0i, 1i, (_e1912 < f32(_e1919))));
let _e1925 = (_e1870 - f32(_e1889));
let _e1927 = (_e1871 - f32(_e1906));
let _e1935 = ((((((_e1851 * _e1869) + _e1923) * _e1865) + _e1906) * _e1861) + _e1889);
let _e1936 = (2i * _e1935);
let _e1938 = (_e1936 >> bitcast<u32>(2i));
let _e1941 = bitcast<u32>(((_e1936 & 3i) * 8i));
let _e1943 = (bitcast<i32>(_e91) - 1i);
let _e1945 = select(_e1943, _e1938, (_e1938 < _e1943));
let _e1950 = global_5.member[bitcast<u32>(select(0i, _e1945, (_e1945 > 0i)))];
let _e1954 = (_e1938 + 1i);
let _e1956 = select(_e1943, _e1954, (_e1954 < _e1943));
let _e1961 = global_5.member[bitcast<u32>(select(0i, _e1956, (_e1956 > 0i)))];
let _e1968 = ((_e1950 >> bitcast<u32>((_e1941 & 31u))) | ((_e1961 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1941) & 31u))));
let _e1971 = f32(bitcast<i32>((_e1968 & 65535u)));
let _e1978 = (_e1971 + ((f32(bitcast<i32>((_e1968 >> bitcast<u32>(16i)))) - _e1971) * _e1925));
let _e1980 = (2i * (_e1935 + _e1861));
let _e1982 = (_e1980 >> bitcast<u32>(2i));
let _e1985 = bitcast<u32>(((_e1980 & 3i) * 8i));
let _e1987 = select(_e1943, _e1982, (_e1982 < _e1943));
let _e1992 = global_5.member[bitcast<u32>(select(0i, _e1987, (_e1987 > 0i)))];
let _e1996 = (_e1982 + 1i);
let _e1998 = select(_e1943, _e1996, (_e1996 < _e1943));
let _e2003 = global_5.member[bitcast<u32>(select(0i, _e1998, (_e1998 > 0i)))];
let _e2010 = ((_e1992 >> bitcast<u32>((_e1985 & 31u))) | ((_e2003 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1985) & 31u))));
let _e2013 = f32(bitcast<i32>((_e2010 & 65535u)));
let _e2021 = (_e1861 * _e1865);
let _e2022 = (_e1935 + _e2021);
let _e2023 = (2i * _e2022);
let _e2025 = (_e2023 >> bitcast<u32>(2i));
let _e2028 = bitcast<u32>(((_e2023 & 3i) * 8i));
let _e2030 = select(_e1943, _e2025, (_e2025 < _e1943));
let _e2035 = global_5.member[bitcast<u32>(select(0i, _e2030, (_e2030 > 0i)))];
let _e2039 = (_e2025 + 1i);
let _e2041 = select(_e1943, _e2039, (_e2039 < _e1943));
let _e2046 = global_5.member[bitcast<u32>(select(0i, _e2041, (_e2041 > 0i)))];
let _e2053 = ((_e2035 >> bitcast<u32>((_e2028 & 31u))) | ((_e2046 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2028) & 31u))));
let _e2056 = f32(bitcast<i32>((_e2053 & 65535u)));
let _e2063 = (_e2056 + ((f32(bitcast<i32>((_e2053 >> bitcast<u32>(16i)))) - _e2056) * _e1925));
let _e2065 = (2i * (_e2022 + _e1861));
let _e2067 = (_e2065 >> bitcast<u32>(2i));
let _e2070 = bitcast<u32>(((_e2065 & 3i) * 8i));
let _e2072 = select(_e1943, _e2067, (_e2067 < _e1943));
let _e2077 = global_5.member[bitcast<u32>(select(0i, _e2072, (_e2072 > 0i)))];
let _e2081 = (_e2067 + 1i);
let _e2083 = select(_e1943, _e2081, (_e2081 < _e1943));
let _e2088 = global_5.member[bitcast<u32>(select(0i, _e2083, (_e2083 > 0i)))];
let _e2095 = ((_e2077 >> bitcast<u32>((_e2070 & 31u))) | ((_e2088 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2070) & 31u))));
let _e2098 = f32(bitcast<i32>((_e2095 & 65535u)));
let _e2108 = (_e1978 + (((_e2013 + ((f32(bitcast<i32>((_e2010 >> bitcast<u32>(16i)))) - _e2013) * _e1925)) - _e1978) * _e1927));
let _e2115 = local;
let _e2116 = local_1[0u];
let _e2118 = local_1[1u];
let _e2120 = local_1[2u];
let _e2122 = ((_e2116 + 1f) - 0.5f);
let _e2123 = ((_e2118 + 0f) - 0.5f);
let _e2124 = ((_e2120 + 0f) - 0.5f);
let _e2126 = select(0f, _e2122, (_e2122 > 0f));
let _e2128 = select(_e1874, _e2126, (_e2126 < _e1874));
let _e2135 = select(0i, select(select(i32(_e2128), i32(-2147483648), (_e2128 < -2147483600f)), 2147483647i, (_e2128 > 2147483500f)), (_e2128 == _e2128));
let _e2139 = (_e2135 - select(0i, 1i, (_e2128 < f32(_e2135))));
let _e2141 = select(0f, _e2123, (_e2123 > 0f));
let _e2143 = select(_e1891, _e2141, (_e2141 < _e1891));
let _e2150 = select(0i, select(select(i32(_e2143), i32(-2147483648), (_e2143 < -2147483600f)), 2147483647i, (_e2143 > 2147483500f)), (_e2143 == _e2143));
let _e2154 = (_e2150 - select(0i, 1i, (_e2143 < f32(_e2150))));
let _e2156 = select(0f, _e2124, (_e2124 > 0f));
let _e2158 = select(_e1908, _e2156, (_e2156 < _e1908));
let _e2165 = select(0i, select(select(i32(_e2158), i32(-2147483648), (_e2158 < -2147483600f)), 2147483647i, (_e2158 > 2147483500f)), (_e2158 == _e2158));
let _e2169 = (_e2165 - select(0i, 1i, (_e2158 < f32(_e2165))));
let _e2171 = (_e2122 - f32(_e2139));
let _e2173 = (_e2123 - f32(_e2154));
let _e2181 = ((((((_e2115 * _e1869) + _e2169) * _e1865) + _e2154) * _e1861) + _e2139);
let _e2182 = (2i * _e2181);
let _e2184 = (_e2182 >> bitcast<u32>(2i));
let _e2187 = bitcast<u32>(((_e2182 & 3i) * 8i));
let _e2189 = select(_e1943, _e2184, (_e2184 < _e1943));
let _e2194 = global_5.member[bitcast<u32>(select(0i, _e2189, (_e2189 > 0i)))];
let _e2198 = (_e2184 + 1i);
let _e2200 = select(_e1943, _e2198, (_e2198 < _e1943));
let _e2205 = global_5.member[bitcast<u32>(select(0i, _e2200, (_e2200 > 0i)))];
let _e2212 = ((_e2194 >> bitcast<u32>((_e2187 & 31u))) | ((_e2205 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2187) & 31u))));
let _e2215 = f32(bitcast<i32>((_e2212 & 65535u)));
let _e2222 = (_e2215 + ((f32(bitcast<i32>((_e2212 >> bitcast<u32>(16i)))) - _e2215) * _e2171));
let _e2224 = (2i * (_e2181 + _e1861));
let _e2226 = (_e2224 >> bitcast<u32>(2i));
let _e2229 = bitcast<u32>(((_e2224 & 3i) * 8i));
let _e2231 = select(_e1943, _e2226, (_e2226 < _e1943));
let _e2236 = global_5.member[bitcast<u32>(select(0i, _e2231, (_e2231 > 0i)))];
let _e2240 = (_e2226 + 1i);
let _e2242 = select(_e1943, _e2240, (_e2240 < _e1943));
let _e2247 = global_5.member[bitcast<u32>(select(0i, _e2242, (_e2242 > 0i)))];
let _e2254 = ((_e2236 >> bitcast<u32>((_e2229 & 31u))) | ((_e2247 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2229) & 31u))));
let _e2257 = f32(bitcast<i32>((_e2254 & 65535u)));
let _e2265 = (_e2181 + _e2021);
let _e2266 = (2i * _e2265);
let _e2268 = (_e2266 >> bitcast<u32>(2i));
let _e2271 = bitcast<u32>(((_e2266 & 3i) * 8i));
let _e2273 = select(_e1943, _e2268, (_e2268 < _e1943));
let _e2278 = global_5.member[bitcast<u32>(select(0i, _e2273, (_e2273 > 0i)))];
let _e2282 = (_e2268 + 1i);
let _e2284 = select(_e1943, _e2282, (_e2282 < _e1943));
let _e2289 = global_5.member[bitcast<u32>(select(0i, _e2284, (_e2284 > 0i)))];
let _e2296 = ((_e2278 >> bitcast<u32>((_e2271 & 31u))) | ((_e2289 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2271) & 31u))));
let _e2299 = f32(bitcast<i32>((_e2296 & 65535u)));
let _e2306 = (_e2299 + ((f32(bitcast<i32>((_e2296 >> bitcast<u32>(16i)))) - _e2299) * _e2171));
let _e2308 = (2i * (_e2265 + _e1861));
let _e2310 = (_e2308 >> bitcast<u32>(2i));
let _e2313 = bitcast<u32>(((_e2308 & 3i) * 8i));
let _e2315 = select(_e1943, _e2310, (_e2310 < _e1943));
let _e2320 = global_5.member[bitcast<u32>(select(0i, _e2315, (_e2315 > 0i)))];
let _e2324 = (_e2310 + 1i);
let _e2326 = select(_e1943, _e2324, (_e2324 < _e1943));
let _e2331 = global_5.member[bitcast<u32>(select(0i, _e2326, (_e2326 > 0i)))];
let _e2338 = ((_e2320 >> bitcast<u32>((_e2313 & 31u))) | ((_e2331 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2313) & 31u))));
let _e2341 = f32(bitcast<i32>((_e2338 & 65535u)));
let _e2351 = (_e2222 + (((_e2257 + ((f32(bitcast<i32>((_e2254 >> bitcast<u32>(16i)))) - _e2257) * _e2171)) - _e2222) * _e2173));
let _e2358 = ((_e2108 + (((_e2063 + (((_e2098 + ((f32(bitcast<i32>((_e2095 >> bitcast<u32>(16i)))) - _e2098) * _e1925)) - _e2063) * _e1927)) - _e2108) * (_e1872 - f32(_e1923)))) - (_e2351 + (((_e2306 + (((_e2341 + ((f32(bitcast<i32>((_e2338 >> bitcast<u32>(16i)))) - _e2341) * _e2171)) - _e2306) * _e2173)) - _e2351) * (_e2124 - f32(_e2169)))));
let _e2359 = local;
let _e2360 = local_1[0u];
let _e2362 = local_1[1u];
let _e2364 = local_1[2u];
let _e2366 = ((_e2360 + 0f) - 0.5f);
let _e2367 = ((_e2362 + -1f) - 0.5f);
let _e2368 = ((_e2364 + 0f) - 0.5f);
let _e2370 = select(0f, _e2366, (_e2366 > 0f));
let _e2372 = select(_e1874, _e2370, (_e2370 < _e1874));
let _e2379 = select(0i, select(select(i32(_e2372), i32(-2147483648), (_e2372 < -2147483600f)), 2147483647i, (_e2372 > 2147483500f)), (_e2372 == _e2372));
let _e2383 = (_e2379 - select(0i, 1i, (_e2372 < f32(_e2379))));
let _e2385 = select(0f, _e2367, (_e2367 > 0f));
let _e2387 = select(_e1891, _e2385, (_e2385 < _e1891));
let _e2394 = select(0i, select(select(i32(_e2387), i32(-2147483648), (_e2387 < -2147483600f)), 2147483647i, (_e2387 > 2147483500f)), (_e2387 == _e2387));
let _e2398 = (_e2394 - select(0i, 1i, (_e2387 < f32(_e2394))));
let _e2400 = select(0f, _e2368, (_e2368 > 0f));
let _e2402 = select(_e1908, _e2400, (_e2400 < _e1908));
let _e2409 = select(0i, select(select(i32(_e2402), i32(-2147483648), (_e2402 < -2147483600f)), 2147483647i, (_e2402 > 2147483500f)), (_e2402 == _e2402));
let _e2413 = (_e2409 - select(0i, 1i, (_e2402 < f32(_e2409))));
let _e2415 = (_e2366 - f32(_e2383));
let _e2417 = (_e2367 - f32(_e2398));
let _e2425 = ((((((_e2359 * _e1869) + _e2413) * _e1865) + _e2398) * _e1861) + _e2383);
let _e2426 = (2i * _e2425);
let _e2428 = (_e2426 >> bitcast<u32>(2i));
let _e2431 = bitcast<u32>(((_e2426 & 3i) * 8i));
let _e2433 = select(_e1943, _e2428, (_e2428 < _e1943));
let _e2438 = global_5.member[bitcast<u32>(select(0i, _e2433, (_e2433 > 0i)))];
let _e2442 = (_e2428 + 1i);
let _e2444 = select(_e1943, _e2442, (_e2442 < _e1943));
let _e2449 = global_5.member[bitcast<u32>(select(0i, _e2444, (_e2444 > 0i)))];
let _e2456 = ((_e2438 >> bitcast<u32>((_e2431 & 31u))) | ((_e2449 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2431) & 31u))));
let _e2459 = f32(bitcast<i32>((_e2456 & 65535u)));
let _e2466 = (_e2459 + ((f32(bitcast<i32>((_e2456 >> bitcast<u32>(16i)))) - _e2459) * _e2415));
let _e2468 = (2i * (_e2425 + _e1861));
let _e2470 = (_e2468 >> bitcast<u32>(2i));
let _e2473 = bitcast<u32>(((_e2468 & 3i) * 8i));
let _e2475 = select(_e1943, _e2470, (_e2470 < _e1943));
let _e2480 = global_5.member[bitcast<u32>(select(0i, _e2475, (_e2475 > 0i)))];
let _e2484 = (_e2470 + 1i);
let _e2486 = select(_e1943, _e2484, (_e2484 < _e1943));
let _e2491 = global_5.member[bitcast<u32>(select(0i, _e2486, (_e2486 > 0i)))];
let _e2498 = ((_e2480 >> bitcast<u32>((_e2473 & 31u))) | ((_e2491 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2473) & 31u))));
let _e2501 = f32(bitcast<i32>((_e2498 & 65535u)));
let _e2509 = (_e2425 + _e2021);
let _e2510 = (2i * _e2509);
let _e2512 = (_e2510 >> bitcast<u32>(2i));
let _e2515 = bitcast<u32>(((_e2510 & 3i) * 8i));
let _e2517 = select(_e1943, _e2512, (_e2512 < _e1943));
let _e2522 = global_5.member[bitcast<u32>(select(0i, _e2517, (_e2517 > 0i)))];
let _e2526 = (_e2512 + 1i);
let _e2528 = select(_e1943, _e2526, (_e2526 < _e1943));
let _e2533 = global_5.member[bitcast<u32>(select(0i, _e2528, (_e2528 > 0i)))];
let _e2540 = ((_e2522 >> bitcast<u32>((_e2515 & 31u))) | ((_e2533 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2515) & 31u))));
let _e2543 = f32(bitcast<i32>((_e2540 & 65535u)));
let _e2550 = (_e2543 + ((f32(bitcast<i32>((_e2540 >> bitcast<u32>(16i)))) - _e2543) * _e2415));
let _e2552 = (2i * (_e2509 + _e1861));
let _e2554 = (_e2552 >> bitcast<u32>(2i));
let _e2557 = bitcast<u32>(((_e2552 & 3i) * 8i));
let _e2559 = select(_e1943, _e2554, (_e2554 < _e1943));
let _e2564 = global_5.member[bitcast<u32>(select(0i, _e2559, (_e2559 > 0i)))];
let _e2568 = (_e2554 + 1i);
let _e2570 = select(_e1943, _e2568, (_e2568 < _e1943));
let _e2575 = global_5.member[bitcast<u32>(select(0i, _e2570, (_e2570 > 0i)))];
let _e2582 = ((_e2564 >> bitcast<u32>((_e2557 & 31u))) | ((_e2575 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2557) & 31u))));
let _e2585 = f32(bitcast<i32>((_e2582 & 65535u)));
let _e2595 = (_e2466 + (((_e2501 + ((f32(bitcast<i32>((_e2498 >> bitcast<u32>(16i)))) - _e2501) * _e2415)) - _e2466) * _e2417));
let _e2602 = local;
let _e2603 = local_1[0u];
let _e2605 = local_1[1u];
let _e2607 = local_1[2u];
let _e2609 = ((_e2603 + 0f) - 0.5f);
let _e2610 = ((_e2605 + 1f) - 0.5f);
let _e2611 = ((_e2607 + 0f) - 0.5f);
let _e2613 = select(0f, _e2609, (_e2609 > 0f));
let _e2615 = select(_e1874, _e2613, (_e2613 < _e1874));
let _e2622 = select(0i, select(select(i32(_e2615), i32(-2147483648), (_e2615 < -2147483600f)), 2147483647i, (_e2615 > 2147483500f)), (_e2615 == _e2615));
let _e2626 = (_e2622 - select(0i, 1i, (_e2615 < f32(_e2622))));
let _e2628 = select(0f, _e2610, (_e2610 > 0f));
let _e2630 = select(_e1891, _e2628, (_e2628 < _e1891));
let _e2637 = select(0i, select(select(i32(_e2630), i32(-2147483648), (_e2630 < -2147483600f)), 2147483647i, (_e2630 > 2147483500f)), (_e2630 == _e2630));
let _e2641 = (_e2637 - select(0i, 1i, (_e2630 < f32(_e2637))));
let _e2643 = select(0f, _e2611, (_e2611 > 0f));
let _e2645 = select(_e1908, _e2643, (_e2643 < _e1908));
let _e2652 = select(0i, select(select(i32(_e2645), i32(-2147483648), (_e2645 < -2147483600f)), 2147483647i, (_e2645 > 2147483500f)), (_e2645 == _e2645));
let _e2656 = (_e2652 - select(0i, 1i, (_e2645 < f32(_e2652))));
let _e2658 = (_e2609 - f32(_e2626));
let _e2660 = (_e2610 - f32(_e2641));
let _e2668 = ((((((_e2602 * _e1869) + _e2656) * _e1865) + _e2641) * _e1861) + _e2626);
let _e2669 = (2i * _e2668);
let _e2671 = (_e2669 >> bitcast<u32>(2i));
let _e2674 = bitcast<u32>(((_e2669 & 3i) * 8i));
let _e2676 = select(_e1943, _e2671, (_e2671 < _e1943));
let _e2681 = global_5.member[bitcast<u32>(select(0i, _e2676, (_e2676 > 0i)))];
let _e2685 = (_e2671 + 1i);
let _e2687 = select(_e1943, _e2685, (_e2685 < _e1943));
let _e2692 = global_5.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2699 = ((_e2681 >> bitcast<u32>((_e2674 & 31u))) | ((_e2692 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2674) & 31u))));
let _e2702 = f32(bitcast<i32>((_e2699 & 65535u)));
let _e2709 = (_e2702 + ((f32(bitcast<i32>((_e2699 >> bitcast<u32>(16i)))) - _e2702) * _e2658));
let _e2711 = (2i * (_e2668 + _e1861));
let _e2713 = (_e2711 >> bitcast<u32>(2i));
let _e2716 = bitcast<u32>(((_e2711 & 3i) * 8i));
let _e2718 = select(_e1943, _e2713, (_e2713 < _e1943));
let _e2723 = global_5.member[bitcast<u32>(select(0i, _e2718, (_e2718 > 0i)))];
let _e2727 = (_e2713 + 1i);
let _e2729 = select(_e1943, _e2727, (_e2727 < _e1943));
let _e2734 = global_5.member[bitcast<u32>(select(0i, _e2729, (_e2729 > 0i)))];
let _e2741 = ((_e2723 >> bitcast<u32>((_e2716 & 31u))) | ((_e2734 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2716) & 31u))));
let _e2744 = f32(bitcast<i32>((_e2741 & 65535u)));
let _e2752 = (_e2668 + _e2021);
let _e2753 = (2i * _e2752);
let _e2755 = (_e2753 >> bitcast<u32>(2i));
let _e2758 = bitcast<u32>(((_e2753 & 3i) * 8i));
let _e2760 = select(_e1943, _e2755, (_e2755 < _e1943));
let _e2765 = global_5.member[bitcast<u32>(select(0i, _e2760, (_e2760 > 0i)))];
let _e2769 = (_e2755 + 1i);
let _e2771 = select(_e1943, _e2769, (_e2769 < _e1943));
let _e2776 = global_5.member[bitcast<u32>(select(0i, _e2771, (_e2771 > 0i)))];
let _e2783 = ((_e2765 >> bitcast<u32>((_e2758 & 31u))) | ((_e2776 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2758) & 31u))));
let _e2786 = f32(bitcast<i32>((_e2783 & 65535u)));
let _e2793 = (_e2786 + ((f32(bitcast<i32>((_e2783 >> bitcast<u32>(16i)))) - _e2786) * _e2658));
let _e2795 = (2i * (_e2752 + _e1861));
let _e2797 = (_e2795 >> bitcast<u32>(2i));
let _e2800 = bitcast<u32>(((_e2795 & 3i) * 8i));
let _e2802 = select(_e1943, _e2797, (_e2797 < _e1943));
let _e2807 = global_5.member[bitcast<u32>(select(0i, _e2802, (_e2802 > 0i)))];
let _e2811 = (_e2797 + 1i);
let _e2813 = select(_e1943, _e2811, (_e2811 < _e1943));
let _e2818 = global_5.member[bitcast<u32>(select(0i, _e2813, (_e2813 > 0i)))];
let _e2825 = ((_e2807 >> bitcast<u32>((_e2800 & 31u))) | ((_e2818 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2800) & 31u))));
let _e2828 = f32(bitcast<i32>((_e2825 & 65535u)));
let _e2838 = (_e2709 + (((_e2744 + ((f32(bitcast<i32>((_e2741 >> bitcast<u32>(16i)))) - _e2744) * _e2658)) - _e2709) * _e2660));
let _e2845 = ((_e2595 + (((_e2550 + (((_e2585 + ((f32(bitcast<i32>((_e2582 >> bitcast<u32>(16i)))) - _e2585) * _e2415)) - _e2550) * _e2417)) - _e2595) * (_e2368 - f32(_e2413)))) - (_e2838 + (((_e2793 + (((_e2828 + ((f32(bitcast<i32>((_e2825 >> bitcast<u32>(16i)))) - _e2828) * _e2658)) - _e2793) * _e2660)) - _e2838) * (_e2611 - f32(_e2656)))));
let _e2846 = local;
let _e2847 = local_1[0u];
let _e2849 = local_1[1u];
let _e2851 = local_1[2u];
let _e2853 = ((_e2847 + 0f) - 0.5f);
let _e2854 = ((_e2849 + 0f) - 0.5f);
let _e2855 = ((_e2851 + -1f) - 0.5f);
let _e2857 = select(0f, _e2853, (_e2853 > 0f));
let _e2859 = select(_e1874, _e2857, (_e2857 < _e1874));
let _e2866 = select(0i, select(select(i32(_e2859), i32(-2147483648), (_e2859 < -2147483600f)), 2147483647i, (_e2859 > 2147483500f)), (_e2859 == _e2859));
let _e2870 = (_e2866 - select(0i, 1i, (_e2859 < f32(_e2866))));
let _e2872 = select(0f, _e2854, (_e2854 > 0f));
let _e2874 = select(_e1891, _e2872, (_e2872 < _e1891));
let _e2881 = select(0i, select(select(i32(_e2874), i32(-2147483648), (_e2874 < -2147483600f)), 2147483647i, (_e2874 > 2147483500f)), (_e2874 == _e2874));
let _e2885 = (_e2881 - select(0i, 1i, (_e2874 < f32(_e2881))));
let _e2887 = select(0f, _e2855, (_e2855 > 0f));
let _e2889 = select(_e1908, _e2887, (_e2887 < _e1908));
let _e2896 = select(0i, select(select(i32(_e2889), i32(-2147483648), (_e2889 < -2147483600f)), 2147483647i, (_e2889 > 2147483500f)), (_e2889 == _e2889));
let _e2900 = (_e2896 - select(0i, 1i, (_e2889 < f32(_e2896))));
let _e2902 = (_e2853 - f32(_e2870));
let _e2904 = (_e2854 - f32(_e2885));
let _e2912 = ((((((_e2846 * _e1869) + _e2900) * _e1865) + _e2885) * _e1861) + _e2870);
let _e2913 = (2i * _e2912);
let _e2915 = (_e2913 >> bitcast<u32>(2i));
let _e2918 = bitcast<u32>(((_e2913 & 3i) * 8i));
let _e2920 = select(_e1943, _e2915, (_e2915 < _e1943));
let _e2925 = global_5.member[bitcast<u32>(select(0i, _e2920, (_e2920 > 0i)))];
let _e2929 = (_e2915 + 1i);
let _e2931 = select(_e1943, _e2929, (_e2929 < _e1943));
let _e2936 = global_5.member[bitcast<u32>(select(0i, _e2931, (_e2931 > 0i)))];
let _e2943 = ((_e2925 >> bitcast<u32>((_e2918 & 31u))) | ((_e2936 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2918) & 31u))));
let _e2946 = f32(bitcast<i32>((_e2943 & 65535u)));
let _e2953 = (_e2946 + ((f32(bitcast<i32>((_e2943 >> bitcast<u32>(16i)))) - _e2946) * _e2902));
let _e2955 = (2i * (_e2912 + _e1861));
let _e2957 = (_e2955 >> bitcast<u32>(2i));
let _e2960 = bitcast<u32>(((_e2955 & 3i) * 8i));
let _e2962 = select(_e1943, _e2957, (_e2957 < _e1943));
let _e2967 = global_5.member[bitcast<u32>(select(0i, _e2962, (_e2962 > 0i)))];
let _e2971 = (_e2957 + 1i);
let _e2973 = select(_e1943, _e2971, (_e2971 < _e1943));
let _e2978 = global_5.member[bitcast<u32>(select(0i, _e2973, (_e2973 > 0i)))];
let _e2985 = ((_e2967 >> bitcast<u32>((_e2960 & 31u))) | ((_e2978 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2960) & 31u))));
let _e2988 = f32(bitcast<i32>((_e2985 & 65535u)));
let _e2996 = (_e2912 + _e2021);
let _e2997 = (2i * _e2996);
let _e2999 = (_e2997 >> bitcast<u32>(2i));
let _e3002 = bitcast<u32>(((_e2997 & 3i) * 8i));
let _e3004 = select(_e1943, _e2999, (_e2999 < _e1943));
let _e3009 = global_5.member[bitcast<u32>(select(0i, _e3004, (_e3004 > 0i)))];
let _e3013 = (_e2999 + 1i);
let _e3015 = select(_e1943, _e3013, (_e3013 < _e1943));
let _e3020 = global_5.member[bitcast<u32>(select(0i, _e3015, (_e3015 > 0i)))];
let _e3027 = ((_e3009 >> bitcast<u32>((_e3002 & 31u))) | ((_e3020 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3002) & 31u))));
let _e3030 = f32(bitcast<i32>((_e3027 & 65535u)));
let _e3037 = (_e3030 + ((f32(bitcast<i32>((_e3027 >> bitcast<u32>(16i)))) - _e3030) * _e2902));
let _e3039 = (2i * (_e2996 + _e1861));
let _e3041 = (_e3039 >> bitcast<u32>(2i));
let _e3044 = bitcast<u32>(((_e3039 & 3i) * 8i));
let _e3046 = select(_e1943, _e3041, (_e3041 < _e1943));
let _e3051 = global_5.member[bitcast<u32>(select(0i, _e3046, (_e3046 > 0i)))];
let _e3055 = (_e3041 + 1i);
let _e3057 = select(_e1943, _e3055, (_e3055 < _e1943));
let _e3062 = global_5.member[bitcast<u32>(select(0i, _e3057, (_e3057 > 0i)))];
let _e3069 = ((_e3051 >> bitcast<u32>((_e3044 & 31u))) | ((_e3062 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3044) & 31u))));
let _e3072 = f32(bitcast<i32>((_e3069 & 65535u)));
let _e3082 = (_e2953 + (((_e2988 + ((f32(bitcast<i32>((_e2985 >> bitcast<u32>(16i)))) - _e2988) * _e2902)) - _e2953) * _e2904));
let _e3089 = local;
let _e3090 = local_1[0u];
let _e3092 = local_1[1u];
let _e3094 = local_1[2u];
let _e3096 = ((_e3090 + 0f) - 0.5f);
let _e3097 = ((_e3092 + 0f) - 0.5f);
let _e3098 = ((_e3094 + 1f) - 0.5f);
let _e3100 = select(0f, _e3096, (_e3096 > 0f));
let _e3102 = select(_e1874, _e3100, (_e3100 < _e1874));
let _e3109 = select(0i, select(select(i32(_e3102), i32(-2147483648), (_e3102 < -2147483600f)), 2147483647i, (_e3102 > 2147483500f)), (_e3102 == _e3102));
let _e3113 = (_e3109 - select(0i, 1i, (_e3102 < f32(_e3109))));
let _e3115 = select(0f, _e3097, (_e3097 > 0f));
let _e3117 = select(_e1891, _e3115, (_e3115 < _e1891));
let _e3124 = select(0i, select(select(i32(_e3117), i32(-2147483648), (_e3117 < -2147483600f)), 2147483647i, (_e3117 > 2147483500f)), (_e3117 == _e3117));
let _e3128 = (_e3124 - select(0i, 1i, (_e3117 < f32(_e3124))));
let _e3130 = select(0f, _e3098, (_e3098 > 0f));
let _e3132 = select(_e1908, _e3130, (_e3130 < _e1908));
let _e3139 = select(0i, select(select(i32(_e3132), i32(-2147483648), (_e3132 < -2147483600f)), 2147483647i, (_e3132 > 2147483500f)), (_e3132 == _e3132));
let _e3143 = (_e3139 - select(0i, 1i, (_e3132 < f32(_e3139))));
let _e3145 = (_e3096 - f32(_e3113));
let _e3147 = (_e3097 - f32(_e3128));
let _e3155 = ((((((_e3089 * _e1869) + _e3143) * _e1865) + _e3128) * _e1861) + _e3113);
let _e3156 = (2i * _e3155);
let _e3158 = (_e3156 >> bitcast<u32>(2i));
let _e3161 = bitcast<u32>(((_e3156 & 3i) * 8i));
let _e3163 = select(_e1943, _e3158, (_e3158 < _e1943));
let _e3168 = global_5.member[bitcast<u32>(select(0i, _e3163, (_e3163 > 0i)))];
let _e3172 = (_e3158 + 1i);
let _e3174 = select(_e1943, _e3172, (_e3172 < _e1943));
let _e3179 = global_5.member[bitcast<u32>(select(0i, _e3174, (_e3174 > 0i)))];
let _e3186 = ((_e3168 >> bitcast<u32>((_e3161 & 31u))) | ((_e3179 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3161) & 31u))));
let _e3189 = f32(bitcast<i32>((_e3186 & 65535u)));
let _e3196 = (_e3189 + ((f32(bitcast<i32>((_e3186 >> bitcast<u32>(16i)))) - _e3189) * _e3145));
let _e3198 = (2i * (_e3155 + _e1861));
let _e3200 = (_e3198 >> bitcast<u32>(2i));
let _e3203 = bitcast<u32>(((_e3198 & 3i) * 8i));
let _e3205 = select(_e1943, _e3200, (_e3200 < _e1943));
let _e3210 = global_5.member[bitcast<u32>(select(0i, _e3205, (_e3205 > 0i)))];
let _e3214 = (_e3200 + 1i);
let _e3216 = select(_e1943, _e3214, (_e3214 < _e1943));
let _e3221 = global_5.member[bitcast<u32>(select(0i, _e3216, (_e3216 > 0i)))];
let _e3228 = ((_e3210 >> bitcast<u32>((_e3203 & 31u))) | ((_e3221 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3203) & 31u))));
let _e3231 = f32(bitcast<i32>((_e3228 & 65535u)));
let _e3239 = (_e3155 + _e2021);
let _e3240 = (2i * _e3239);
let _e3242 = (_e3240 >> bitcast<u32>(2i));
let _e3245 = bitcast<u32>(((_e3240 & 3i) * 8i));
let _e3247 = select(_e1943, _e3242, (_e3242 < _e1943));
let _e3252 = global_5.member[bitcast<u32>(select(0i, _e3247, (_e3247 > 0i)))];
let _e3256 = (_e3242 + 1i);
let _e3258 = select(_e1943, _e3256, (_e3256 < _e1943));
let _e3263 = global_5.member[bitcast<u32>(select(0i, _e3258, (_e3258 > 0i)))];
let _e3270 = ((_e3252 >> bitcast<u32>((_e3245 & 31u))) | ((_e3263 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3245) & 31u))));
let _e3273 = f32(bitcast<i32>((_e3270 & 65535u)));
let _e3280 = (_e3273 + ((f32(bitcast<i32>((_e3270 >> bitcast<u32>(16i)))) - _e3273) * _e3145));
let _e3282 = (2i * (_e3239 + _e1861));
let _e3284 = (_e3282 >> bitcast<u32>(2i));
let _e3287 = bitcast<u32>(((_e3282 & 3i) * 8i));
let _e3289 = select(_e1943, _e3284, (_e3284 < _e1943));
let _e3294 = global_5.member[bitcast<u32>(select(0i, _e3289, (_e3289 > 0i)))];
let _e3298 = (_e3284 + 1i);
let _e3300 = select(_e1943, _e3298, (_e3298 < _e1943));
let _e3305 = global_5.member[bitcast<u32>(select(0i, _e3300, (_e3300 > 0i)))];
let _e3312 = ((_e3294 >> bitcast<u32>((_e3287 & 31u))) | ((_e3305 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3287) & 31u))));
let _e3315 = f32(bitcast<i32>((_e3312 & 65535u)));
let _e3325 = (_e3196 + (((_e3231 + ((f32(bitcast<i32>((_e3228 >> bitcast<u32>(16i)))) - _e3231) * _e3145)) - _e3196) * _e3147));
let _e3332 = ((_e3082 + (((_e3037 + (((_e3072 + ((f32(bitcast<i32>((_e3069 >> bitcast<u32>(16i)))) - _e3072) * _e2902)) - _e3037) * _e2904)) - _e3082) * (_e2855 - f32(_e2900)))) - (_e3325 + (((_e3280 + (((_e3315 + ((f32(bitcast<i32>((_e3312 >> bitcast<u32>(16i)))) - _e3315) * _e3145)) - _e3280) * _e3147)) - _e3325) * (_e3098 - f32(_e3143)))));
let _e3337 = (((_e2358 * _e2358) + (_e2845 * _e2845)) + (_e3332 * _e3332));
let _e3340 = sqrt(select(0f, _e3337, (_e3337 > 0f)));
let _e3343 = (1f / select(1e-6f, _e3340, (_e3340 > 1e-6f)));
let _e3344 = (_e2358 * _e3343);
let _e3345 = (_e2845 * _e3343);
let _e3346 = (_e3332 * _e3343);
let _e3347 = vec3<f32>(_e3344, _e3345, _e3346);
let _e3350 = local_10;
let _e3355 = global_1.member.member_7.member_2;
let _e3369 = global_1.member.member_7.member_1;
let _e3373 = local_11;
let _e3375 = ((((_e729.member_5 + _e3350) < _e3355) && ((((_e3344 * _e729.member_4.x) + (_e3345 * _e729.member_4.y)) + (_e3346 * _e729.member_4.z)) > _e3369)) || (_e3373 == _e729.member_7));
if _e3375 {
phi_5761_ = _e729;
} else {
let _e3400 = type_12(vec3<f32>((_e729.member.x + _e1549), (_e729.member.y + _e1552), (_e729.member.z + _e1555)), _e729.member_1, _e729.member_2, _e729.member_3, _e729.member_4, _e729.member_5, _e729.member_6, _e729.member_7, _e729.member_8, _e729.member_9, _e729.member_10, _e729.member_11, _e729.member_12, _e729.member_13, _e729.member_14);
let _e3404 = local_12;
let _e3422 = type_12(_e3400.member, _e3400.member_1, _e3400.member_2, _e3400.member_3, _e3400.member_4, _e3400.member_5, _e3400.member_6, _e3400.member_7, _e3400.member_8, _e3400.member_9, (_e729.member_10 + select(0f, _e3404, (_e729.member_8 == 0f))), _e3400.member_11, _e3400.member_12, _e3400.member_13, _e3400.member_14);
if (_e729.member_7 != 16i) {
let _e3426 = local_13;
let _e3442 = type_12(_e3422.member, _e3422.member_1, _e3422.member_2, _e3422.member_3, _e3422.member_4, _e3422.member_5, _e3422.member_6, _e3422.member_7, _e3422.member_8, (_e729.member_9 + _e3426), _e3422.member_10, _e3422.member_11, _e3422.member_12, _e3422.member_13, _e3422.member_14);
let _e3443 = (_e729.member_7 * 4i);
let _e3444 = (_e3443 + 1i);
let _e3446 = (bitcast<i32>(_e93) - 1i);
let _e3448 = select(_e3446, _e3444, (_e3444 < _e3446));
let _e3454 = global_2.member[bitcast<u32>(select(0i, _e3448, (_e3448 > 0i)))];
let _e3456 = local_14;
let _e3458 = -((_e3454 * _e3456));
let _e3460 = select(-87f, _e3458, (_e3458 > -87f));
let _e3462 = select(88f, _e3460, (_e3460 < 88f));
let _e3464 = ((_e3462 * 1.442695f) + 0.5f);
let _e3466 = select(-127f, _e3464, (_e3464 > -127f));
let _e3468 = select(128f, _e3466, (_e3466 < 128f));
let _e3475 = select(0i, select(select(i32(_e3468), i32(-2147483648), (_e3468 < -2147483600f)), 2147483647i, (_e3468 > 2147483500f)), (_e3468 == _e3468));
let _e3479 = (_e3475 - select(0i, 1i, (_e3468 < f32(_e3475))));
let _e3480 = f32(_e3479);
let _e3484 = ((_e3462 - (_e3480 * 0.6933594f)) - (_e3480 * -2.1219444e-4f));
let _e3508 = (_e3443 + 2i);
let _e3510 = select(_e3446, _e3508, (_e3508 < _e3446));
let _e3516 = global_2.member[bitcast<u32>(select(0i, _e3510, (_e3510 > 0i)))];
let _e3518 = local_15;
let _e3520 = -((_e3516 * _e3518));
let _e3522 = select(-87f, _e3520, (_e3520 > -87f));
let _e3524 = select(88f, _e3522, (_e3522 < 88f));
let _e3526 = ((_e3524 * 1.442695f) + 0.5f);
let _e3528 = select(-127f, _e3526, (_e3526 > -127f));
let _e3530 = select(128f, _e3528, (_e3528 < 128f));
let _e3537 = select(0i, select(select(i32(_e3530), i32(-2147483648), (_e3530 < -2147483600f)), 2147483647i, (_e3530 > 2147483500f)), (_e3530 == _e3530));
let _e3541 = (_e3537 - select(0i, 1i, (_e3530 < f32(_e3537))));
let _e3542 = f32(_e3541);
let _e3546 = ((_e3524 - (_e3542 * 0.6933594f)) - (_e3542 * -2.1219444e-4f));
let _e3570 = (_e3443 + 3i);
let _e3572 = select(_e3446, _e3570, (_e3570 < _e3446));
let _e3578 = global_2.member[bitcast<u32>(select(0i, _e3572, (_e3572 > 0i)))];
let _e3580 = local_16;
let _e3582 = -((_e3578 * _e3580));
let _e3584 = select(-87f, _e3582, (_e3582 > -87f));
let _e3586 = select(88f, _e3584, (_e3584 < 88f));
let _e3588 = ((_e3586 * 1.442695f) + 0.5f);
let _e3590 = select(-127f, _e3588, (_e3588 > -127f));
let _e3592 = select(128f, _e3590, (_e3590 < 128f));
let _e3599 = select(0i, select(select(i32(_e3592), i32(-2147483648), (_e3592 < -2147483600f)), 2147483647i, (_e3592 > 2147483500f)), (_e3592 == _e3592));
let _e3603 = (_e3599 - select(0i, 1i, (_e3592 < f32(_e3599))));
let _e3604 = f32(_e3603);
let _e3608 = ((_e3586 - (_e3604 * 0.6933594f)) - (_e3604 * -2.1219444e-4f));
phi_5033_ = type_12(_e3442.member, _e3442.member_1, vec3<f32>((_e729.member_2.x * ((1f + (_e3484 * (1f + (_e3484 * (0.5f + (_e3484 * (0.16666667f + (_e3484 * (0.041666668f + (_e3484 * (0.008333334f + (_e3484 * (0.001388889f + (_e3484 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3479 + 127i)) << bitcast<u32>(23i))))), (_e729.member_2.y * ((1f + (_e3546 * (1f + (_e3546 * (0.5f + (_e3546 * (0.16666667f + (_e3546 * (0.041666668f + (_e3546 * (0.008333334f + (_e3546 * (0.001388889f + (_e3546 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3541 + 127i)) << bitcast<u32>(23i))))), (_e729.member_2.z * ((1f + (_e3608 * (1f + (_e3608 * (0.5f + (_e3608 * (0.16666667f + (_e3608 * (0.041666668f + (_e3608 * (0.008333334f + (_e3608 * (0.001388889f + (_e3608 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3603 + 127i)) << bitcast<u32>(23i)))))), _e3442.member_3, _e3442.member_4, _e3442.member_5, _e3442.member_6, _e3442.member_7, _e3442.member_8, _e3442.member_9, _e3442.member_10, _e3442.member_11, _e3442.member_12, _e3442.member_13, _e3442.member_14);
} else {
phi_5033_ = _e3422;
}
let _e3649 = phi_5033_;
let _e3651 = (_e729.member_7 * 4i);
let _e3653 = (bitcast<i32>(_e93) - 1i);
let _e3655 = select(_e3653, _e3651, (_e3651 < _e3653));
let _e3661 = global_2.member[bitcast<u32>(select(0i, _e3655, (_e3655 > 0i)))];
let _e3663 = select(_e3661, 1f, (_e729.member_7 == 16i));
let _e3665 = local_17;
let _e3666 = (_e3665 * 4i);
let _e3668 = select(_e3653, _e3666, (_e3666 < _e3653));
let _e3674 = global_2.member[bitcast<u32>(select(0i, _e3668, (_e3668 > 0i)))];
let _e3676 = local_18;
let _e3678 = select(_e3674, 1f, (_e3676 == 16i));
let _e3688 = select(1f, -1f, ((((_e3649.member_1.x * _e3344) + (_e3649.member_1.y * _e3345)) + (_e3649.member_1.z * _e3346)) > 0f));
let _e3689 = (_e3344 * _e3688);
let _e3690 = (_e3345 * _e3688);
let _e3691 = (_e3346 * _e3688);
let _e3697 = -((((_e3649.member_1.x * _e3689) + (_e3649.member_1.y * _e3690)) + (_e3649.member_1.z * _e3691)));
let _e3699 = select(0f, _e3697, (_e3697 > 0f));
let _e3700 = (_e3663 / _e3678);
let _e3702 = (_e3699 * _e3699);
let _e3705 = (1f - ((_e3700 * _e3700) * (1f - _e3702)));
let _e3706 = (_e3705 <= 0f);
let _e3714 = ((_e3700 * _e3699) - sqrt(select(0f, _e3705, (_e3705 > 0f))));
let _e3721 = (2f * _e3699);
let _e3728 = select(((_e3649.member_1.x * _e3700) + (_e3689 * _e3714)), (_e3649.member_1.x + (_e3689 * _e3721)), _e3706);
let _e3729 = select(((_e3649.member_1.y * _e3700) + (_e3690 * _e3714)), (_e3649.member_1.y + (_e3690 * _e3721)), _e3706);
let _e3730 = select(((_e3649.member_1.z * _e3700) + (_e3691 * _e3714)), (_e3649.member_1.z + (_e3691 * _e3721)), _e3706);
let _e3735 = (((_e3728 * _e3728) + (_e3729 * _e3729)) + (_e3730 * _e3730));
let _e3738 = sqrt(select(0f, _e3735, (_e3735 > 0f)));
let _e3741 = (1f / select(1e-20f, _e3738, (_e3738 > 1e-20f)));
let _e3746 = (_e3678 / _e3663);
let _e3749 = (((_e3746 * _e3746) - 1f) + _e3702);
let _e3752 = sqrt(select(0f, _e3749, (_e3749 > 0f)));
let _e3753 = (_e3752 - _e3699);
let _e3754 = (_e3752 + _e3699);
let _e3757 = (_e3753 / select(1e-6f, _e3754, (_e3754 > 1e-6f)));
let _e3761 = ((_e3699 * _e3753) + 1f);
let _e3764 = (((_e3699 * _e3754) - 1f) / select(1e-6f, _e3761, (_e3761 > 1e-6f)));
let _e3779 = global_1.member.member[3u];
let _e3782 = select(0f, select(select((((0.5f * _e3757) * _e3757) * (1f + (_e3764 * _e3764))), 1f, (_e3749 <= 0f)), 0f, (_e3663 == _e3678)), ((_e3779 & 1u) != 0u));
if (_e3649.member_8 == 0f) {
let _e3797 = type_12(_e3649.member, _e3649.member_1, _e3649.member_2, _e3347, _e3649.member_4, _e3649.member_5, _e3649.member_6, _e3649.member_7, _e3649.member_8, _e3649.member_9, _e3649.member_10, _e3649.member_11, _e3649.member_12, _e3649.member_13, _e3649.member_14);
phi_5244_ = type_12(_e3797.member, _e3797.member_1, _e3797.member_2, _e3797.member_3, _e3797.member_4, _e3797.member_5, _e3797.member_6, _e3797.member_7, _e3797.member_8, _e3797.member_9, _e3797.member_10, _e3782, _e3797.member_12, _e3797.member_13, _e3797.member_14);
} else {
phi_5244_ = _e3649;
}
let _e3814 = phi_5244_;
let _e3816 = (_e3814.member_8 + 1f);
let _e3831 = type_12(_e3814.member, _e3814.member_1, _e3814.member_2, _e3814.member_3, _e3814.member_4, _e3814.member_5, _e3814.member_6, _e3814.member_7, _e3816, _e3814.member_9, _e3814.member_10, _e3814.member_11, _e3814.member_12, _e3814.member_13, _e3814.member_14);
let _e3834 = ((_e394 == 0u) && (_e3816 >= 2f));
if (_e3706 && _e3834) {
let _e3859 = (((_e3814.member_1.x * _e3344) + (_e3814.member_1.y * _e3345)) + (_e3814.member_1.z * _e3346));
let _e3863 = (_e3814.member_1.x - (_e3344 * _e3859));
let _e3864 = (_e3814.member_1.y - (_e3345 * _e3859));
let _e3865 = (_e3814.member_1.z - (_e3346 * _e3859));
let _e3870 = (((_e3863 * _e3863) + (_e3864 * _e3864)) + (_e3865 * _e3865));
let _e3873 = sqrt(select(0f, _e3870, (_e3870 > 0f)));
let _e3876 = (1f / select(1e-20f, _e3873, (_e3873 > 1e-20f)));
phi_5297_ = type_12(_e3831.member, vec3<f32>((_e3863 * _e3876), (_e3864 * _e3876), (_e3865 * _e3876)), _e3831.member_2, _e3831.member_3, _e3831.member_4, _e3831.member_5, _e3831.member_6, _e3831.member_7, _e3831.member_8, _e3831.member_9, _e3831.member_10, _e3831.member_11, _e3831.member_12, _e3831.member_13, _e3831.member_14);
} else {
phi_5297_ = type_12(_e3831.member, vec3<f32>((_e3728 * _e3741), (_e3729 * _e3741), (_e3730 * _e3741)), _e3831.member_2, _e3831.member_3, _e3831.member_4, _e3831.member_5, _e3831.member_6, _e3831.member_7, _e3831.member_8, _e3831.member_9, _e3831.member_10, _e3831.member_11, _e3831.member_12, _e3831.member_13, _e3831.member_14);
}
let _e3897 = phi_5297_;
if _e3706 {
phi_5311_ = _e3897;
} else {
let _e3898 = (1f - _e3782);
phi_5311_ = type_12(_e3897.member, _e3897.member_1, vec3<f32>((_e3897.member_2.x * _e3898), (_e3897.member_2.y * _e3898), (_e3897.member_2.z * _e3898)), _e3897.member_3, _e3897.member_4, _e3897.member_5, _e3897.member_6, _e3897.member_7, _e3897.member_8, _e3897.member_9, _e3897.member_10, _e3897.member_11, _e3897.member_12, _e3897.member_13, _e3897.member_14);
}
let _e3925 = phi_5311_;
let _e3930 = global_1.member.member_17;
let _e3943 = ((((_e3930.member * _e3925.member.x) + (_e3930.member_1 * _e3925.member.y)) + (_e3930.member_2 * _e3925.member.z)) + _e3930.member_3);
let _e3952 = -((((_e3930.member * _e3925.member_1.x) + (_e3930.member_1 * _e3925.member_1.y)) + (_e3930.member_2 * _e3925.member_1.z)));
let _e3954 = (_e3952 > 1e-9f);
let _e3958 = ((_e3943 / select(1e-9f, _e3952, _e3954)) - 0.015625f);
let _e3961 = select(1e30f, select(0f, _e3958, (_e3958 > 0f)), ((_e3943 > 0f) && _e3954));
let _e3964 = global_1.member.member_19;
let _e3974 = ((((_e3964.member * _e3925.member.x) + (_e3964.member_1 * _e3925.member.y)) + (_e3964.member_2 * _e3925.member.z)) + _e3964.member_3);
let _e3980 = -((((_e3964.member * _e3925.member_1.x) + (_e3964.member_1 * _e3925.member_1.y)) + (_e3964.member_2 * _e3925.member_1.z)));
let _e3982 = (_e3980 > 1e-9f);
let _e3986 = ((_e3974 / select(1e-9f, _e3980, _e3982)) - 0.015625f);
let _e3989 = select(1e30f, select(0f, _e3986, (_e3986 > 0f)), ((_e3974 > 0f) && _e3982));
let _e3993 = (_e3989 < _e3961);
let _e3995 = select(select(-2i, -3i, _e3993), -1i, ((_e3961 >= 1e30f) && (_e3989 >= 1e30f)));
let _e3996 = select(_e3961, _e3989, _e3993);
let _e4011 = type_12(_e3925.member, _e3925.member_1, _e3925.member_2, _e3925.member_3, _e3925.member_4, _e3925.member_5, _e3925.member_6, _e3925.member_7, _e3925.member_8, _e3925.member_9, _e3925.member_10, _e3925.member_11, 0i, _e3925.member_13, _e3925.member_14);
let _e4026 = type_12(_e4011.member, _e4011.member_1, _e4011.member_2, _e4011.member_3, _e4011.member_4, _e4011.member_5, _e4011.member_6, _e4011.member_7, _e4011.member_8, _e4011.member_9, _e4011.member_10, _e4011.member_11, _e4011.member_12, _e3995, _e4011.member_14);
let _e4041 = type_12(_e4026.member, _e4026.member_1, _e4026.member_2, _e4026.member_3, _e4026.member_4, _e4026.member_5, _e4026.member_6, _e4026.member_7, _e4026.member_8, _e4026.member_9, _e4026.member_10, _e4026.member_11, _e4026.member_12, _e4026.member_13, _e3996);
let _e4043 = local_19;
let _e4046 = ((_e3779 & 2u) != 0u);
if (_e3834 && !(_e4046)) {
if (_e3995 == -1i) {
phi_5730_ = type_12(_e4041.member, _e4041.member_1, _e4041.member_2, _e4041.member_3, _e4041.member_4, _e4041.member_5, 1f, _e4041.member_7, _e4041.member_8, _e4041.member_9, _e4041.member_10, _e4041.member_11, _e4041.member_12, _e4041.member_13, _e4041.member_14);
} else {
let _e4123 = type_12(vec3<f32>((_e3925.member.x + (_e3925.member_1.x * _e3996)), (_e3925.member.y + (_e3925.member_1.y * _e3996)), (_e3925.member.z + (_e3925.member_1.z * _e3996))), _e4041.member_1, _e4041.member_2, _e4041.member_3, _e4041.member_4, _e4041.member_5, _e4041.member_6, _e4041.member_7, _e4041.member_8, _e4041.member_9, _e4041.member_10, _e4041.member_11, _e4041.member_12, _e4041.member_13, _e4041.member_14);
let _e4139 = type_12(_e4123.member, _e4123.member_1, _e4123.member_2, _e4123.member_3, _e4123.member_4, _e4123.member_5, _e4123.member_6, _e4123.member_7, _e4123.member_8, _e4123.member_9, _e4123.member_10, _e4123.member_11, _e4123.member_12, _e4123.member_13, (_e3996 - _e3996));
let _e4159 = type_12(_e4139.member, _e4139.member_1, _e4139.member_2, _e4139.member_3, _e4139.member_4, _e4139.member_5, _e4139.member_6, _e4139.member_7, _e4139.member_8, _e4139.member_9, (_e3925.member_10 + select(0f, _e3996, (_e3925.member_8 == 0f))), _e4139.member_11, _e4139.member_12, _e4139.member_13, _e4139.member_14);
phi_5730_ = type_12(_e4159.member, _e4159.member_1, _e4159.member_2, _e4159.member_3, _e4159.member_4, _e4159.member_5, 3f, _e4159.member_7, _e4159.member_8, _e4159.member_9, _e4159.member_10, _e4159.member_11, _e4159.member_12, _e4159.member_13, _e4159.member_14);
}
let _e4191 = phi_5730_;
phi_5752_ = _e4191;
} else {
let _e4054 = global_1.member.member_2[3u];
if ((!(_e3834) && (_e3925.member_8 >= f32(bitcast<i32>(_e4054)))) && (select(_e4043, _e729.member_7, _e3706) != 16i)) {
phi_5751_ = type_12(_e4041.member, _e4041.member_1, _e4041.member_2, _e4041.member_3, _e4041.member_4, _e4041.member_5, 2f, _e4041.member_7, _e4041.member_8, _e4041.member_9, _e4041.member_10, _e4041.member_11, _e4041.member_12, _e4041.member_13, _e4041.member_14);
} else {
if _e4046 {
phi_5750_ = type_12(_e4041.member, _e4041.member_1, _e4041.member_2, _e4041.member_3, _e4041.member_4, _e4041.member_5, 4f, _e4041.member_7, _e4041.member_8, _e4041.member_9, _e4041.member_10, _e4041.member_11, _e4041.member_12, _e4041.member_13, _e4041.member_14);
} else {
phi_5750_ = _e4041;
}
let _e4077 = phi_5750_;
phi_5751_ = _e4077;
}
let _e4094 = phi_5751_;
phi_5752_ = _e4094;
}
let _e4193 = phi_5752_;
let _e4196 = local_20;
let _e4212 = type_12(_e4193.member, _e4193.member_1, _e4193.member_2, _e4193.member_3, _e4193.member_4, _e4193.member_5, _e4193.member_6, select(_e729.member_7, _e4196, !(_e3706)), _e4193.member_8, _e4193.member_9, _e4193.member_10, _e4193.member_11, _e4193.member_12, _e4193.member_13, _e4193.member_14);
let _e4227 = type_12(_e4212.member, _e4212.member_1, _e4212.member_2, _e4212.member_3, _e3347, _e4212.member_5, _e4212.member_6, _e4212.member_7, _e4212.member_8, _e4212.member_9, _e4212.member_10, _e4212.member_11, _e4212.member_12, _e4212.member_13, _e4212.member_14);
phi_5761_ = type_12(_e4227.member, _e4227.member_1, _e4227.member_2, _e4227.member_3, _e4227.member_4, 0f, _e4227.member_6, _e4227.member_7, _e4227.member_8, _e4227.member_9, _e4227.member_10, _e4227.member_11, _e4227.member_12, _e4227.member_13, _e4227.member_14);
}
let _e4244 = phi_5761_;
phi_5762_ = _e4244;
phi_5763_ = _e3375;
}
let _e4246 = phi_5762_;
let _e4248 = phi_5763_;
if (_e4248 && _e939) {
let _e4718 = type_12(vec3<f32>((_e4246.member.x + (_e4246.member_1.x * _e4246.member_14)), (_e4246.member.y + (_e4246.member_1.y * _e4246.member_14)), (_e4246.member.z + (_e4246.member_1.z * _e4246.member_14))), _e4246.member_1, _e4246.member_2, _e4246.member_3, _e4246.member_4, _e4246.member_5, _e4246.member_6, _e4246.member_7, _e4246.member_8, _e4246.member_9, _e4246.member_10, _e4246.member_11, _e4246.member_12, _e4246.member_13, _e4246.member_14);
let _e4735 = type_12(_e4718.member, _e4718.member_1, _e4718.member_2, _e4718.member_3, _e4718.member_4, (_e4246.member_5 + _e4246.member_14), _e4718.member_6, _e4718.member_7, _e4718.member_8, _e4718.member_9, _e4718.member_10, _e4718.member_11, _e4718.member_12, _e4718.member_13, _e4718.member_14);
let _e4751 = type_12(_e4735.member, _e4735.member_1, _e4735.member_2, _e4735.member_3, _e4735.member_4, _e4735.member_5, _e4735.member_6, _e4735.member_7, _e4735.member_8, _e4735.member_9, _e4735.member_10, _e4735.member_11, _e4735.member_12, _e4735.member_13, (_e4246.member_14 - _e4246.member_14));
let _e4771 = type_12(_e4751.member, _e4751.member_1, _e4751.member_2, _e4751.member_3, _e4751.member_4, _e4751.member_5, _e4751.member_6, _e4751.member_7, _e4751.member_8, _e4751.member_9, (_e4246.member_10 + select(0f, _e4246.member_14, (_e4246.member_8 == 0f))), _e4751.member_11, _e4751.member_12, _e4751.member_13, _e4751.member_14);
if (_e729.member_7 != 16i) {
let _e4789 = type_12(_e4771.member, _e4771.member_1, _e4771.member_2, _e4771.member_3, _e4771.member_4, _e4771.member_5, _e4771.member_6, _e4771.member_7, _e4771.member_8, (_e4246.member_9 + _e4246.member_14), _e4771.member_10, _e4771.member_11, _e4771.member_12, _e4771.member_13, _e4771.member_14);
let _e4790 = (_e729.member_7 * 4i);
let _e4791 = (_e4790 + 1i);
let _e4793 = (bitcast<i32>(_e93) - 1i);
let _e4795 = select(_e4793, _e4791, (_e4791 < _e4793));
let _e4801 = global_2.member[bitcast<u32>(select(0i, _e4795, (_e4795 > 0i)))];
let _e4803 = -((_e4801 * _e4246.member_14));
let _e4805 = select(-87f, _e4803, (_e4803 > -87f));
let _e4807 = select(88f, _e4805, (_e4805 < 88f));
let _e4809 = ((_e4807 * 1.442695f) + 0.5f);
let _e4811 = select(-127f, _e4809, (_e4809 > -127f));
let _e4813 = select(128f, _e4811, (_e4811 < 128f));
let _e4820 = select(0i, select(select(i32(_e4813), i32(-2147483648), (_e4813 < -2147483600f)), 2147483647i, (_e4813 > 2147483500f)), (_e4813 == _e4813));
let _e4824 = (_e4820 - select(0i, 1i, (_e4813 < f32(_e4820))));
let _e4825 = f32(_e4824);
let _e4829 = ((_e4807 - (_e4825 * 0.6933594f)) - (_e4825 * -2.1219444e-4f));
let _e4853 = (_e4790 + 2i);
let _e4855 = select(_e4793, _e4853, (_e4853 < _e4793));
let _e4861 = global_2.member[bitcast<u32>(select(0i, _e4855, (_e4855 > 0i)))];
let _e4863 = -((_e4861 * _e4246.member_14));
let _e4865 = select(-87f, _e4863, (_e4863 > -87f));
let _e4867 = select(88f, _e4865, (_e4865 < 88f));
let _e4869 = ((_e4867 * 1.442695f) + 0.5f);
let _e4871 = select(-127f, _e4869, (_e4869 > -127f));
let _e4873 = select(128f, _e4871, (_e4871 < 128f));
let _e4880 = select(0i, select(select(i32(_e4873), i32(-2147483648), (_e4873 < -2147483600f)), 2147483647i, (_e4873 > 2147483500f)), (_e4873 == _e4873));
let _e4884 = (_e4880 - select(0i, 1i, (_e4873 < f32(_e4880))));
let _e4885 = f32(_e4884);
let _e4889 = ((_e4867 - (_e4885 * 0.6933594f)) - (_e4885 * -2.1219444e-4f));
let _e4913 = (_e4790 + 3i);
let _e4915 = select(_e4793, _e4913, (_e4913 < _e4793));
let _e4921 = global_2.member[bitcast<u32>(select(0i, _e4915, (_e4915 > 0i)))];
let _e4923 = -((_e4921 * _e4246.member_14));
let _e4925 = select(-87f, _e4923, (_e4923 > -87f));
let _e4927 = select(88f, _e4925, (_e4925 < 88f));
let _e4929 = ((_e4927 * 1.442695f) + 0.5f);
let _e4931 = select(-127f, _e4929, (_e4929 > -127f));
let _e4933 = select(128f, _e4931, (_e4931 < 128f));
let _e4940 = select(0i, select(select(i32(_e4933), i32(-2147483648), (_e4933 < -2147483600f)), 2147483647i, (_e4933 > 2147483500f)), (_e4933 == _e4933));
let _e4944 = (_e4940 - select(0i, 1i, (_e4933 < f32(_e4940))));
let _e4945 = f32(_e4944);
let _e4949 = ((_e4927 - (_e4945 * 0.6933594f)) - (_e4945 * -2.1219444e-4f));
phi_6053_ = type_12(_e4789.member, _e4789.member_1, vec3<f32>((_e4246.member_2.x * ((1f + (_e4829 * (1f + (_e4829 * (0.5f + (_e4829 * (0.16666667f + (_e4829 * (0.041666668f + (_e4829 * (0.008333334f + (_e4829 * (0.001388889f + (_e4829 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4824 + 127i)) << bitcast<u32>(23i))))), (_e4246.member_2.y * ((1f + (_e4889 * (1f + (_e4889 * (0.5f + (_e4889 * (0.16666667f + (_e4889 * (0.041666668f + (_e4889 * (0.008333334f + (_e4889 * (0.001388889f + (_e4889 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4884 + 127i)) << bitcast<u32>(23i))))), (_e4246.member_2.z * ((1f + (_e4949 * (1f + (_e4949 * (0.5f + (_e4949 * (0.16666667f + (_e4949 * (0.041666668f + (_e4949 * (0.008333334f + (_e4949 * (0.001388889f + (_e4949 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4944 + 127i)) << bitcast<u32>(23i)))))), _e4789.member_3, _e4789.member_4, _e4789.member_5, _e4789.member_6, _e4789.member_7, _e4789.member_8, _e4789.member_9, _e4789.member_10, _e4789.member_11, _e4789.member_12, _e4789.member_13, _e4789.member_14);
} else {
phi_6053_ = _e4771;
}
let _e4990 = phi_6053_;
phi_6647_ = type_12(_e4990.member, _e4990.member_1, _e4990.member_2, _e4990.member_3, _e4990.member_4, _e4990.member_5, 3f, _e4990.member_7, _e4990.member_8, _e4990.member_9, _e4990.member_10, _e4990.member_11, _e4990.member_12, _e4990.member_13, _e4990.member_14);
} else {
if _e4248 {
let _e4281 = type_12(vec3<f32>((_e4246.member.x + (_e4246.member_1.x * _e940)), (_e4246.member.y + (_e4246.member_1.y * _e940)), (_e4246.member.z + (_e4246.member_1.z * _e940))), _e4246.member_1, _e4246.member_2, _e4246.member_3, _e4246.member_4, _e4246.member_5, _e4246.member_6, _e4246.member_7, _e4246.member_8, _e4246.member_9, _e4246.member_10, _e4246.member_11, _e4246.member_12, _e4246.member_13, _e4246.member_14);
let _e4298 = type_12(_e4281.member, _e4281.member_1, _e4281.member_2, _e4281.member_3, _e4281.member_4, (_e4246.member_5 + _e940), _e4281.member_6, _e4281.member_7, _e4281.member_8, _e4281.member_9, _e4281.member_10, _e4281.member_11, _e4281.member_12, _e4281.member_13, _e4281.member_14);
let _e4315 = type_12(_e4298.member, _e4298.member_1, _e4298.member_2, _e4298.member_3, _e4298.member_4, _e4298.member_5, _e4298.member_6, _e4298.member_7, _e4298.member_8, _e4298.member_9, _e4298.member_10, _e4298.member_11, _e4298.member_12, _e4298.member_13, (_e4246.member_14 - _e940));
let _e4335 = type_12(_e4315.member, _e4315.member_1, _e4315.member_2, _e4315.member_3, _e4315.member_4, _e4315.member_5, _e4315.member_6, _e4315.member_7, _e4315.member_8, _e4315.member_9, (_e4246.member_10 + select(0f, _e940, (_e4246.member_8 == 0f))), _e4315.member_11, _e4315.member_12, _e4315.member_13, _e4315.member_14);
if (_e729.member_7 != 16i) {
let _e4353 = type_12(_e4335.member, _e4335.member_1, _e4335.member_2, _e4335.member_3, _e4335.member_4, _e4335.member_5, _e4335.member_6, _e4335.member_7, _e4335.member_8, (_e4246.member_9 + _e940), _e4335.member_10, _e4335.member_11, _e4335.member_12, _e4335.member_13, _e4335.member_14);
let _e4354 = (_e729.member_7 * 4i);
let _e4355 = (_e4354 + 1i);
let _e4357 = (bitcast<i32>(_e93) - 1i);
let _e4359 = select(_e4357, _e4355, (_e4355 < _e4357));
let _e4365 = global_2.member[bitcast<u32>(select(0i, _e4359, (_e4359 > 0i)))];
let _e4367 = -((_e4365 * _e940));
let _e4369 = select(-87f, _e4367, (_e4367 > -87f));
let _e4371 = select(88f, _e4369, (_e4369 < 88f));
let _e4373 = ((_e4371 * 1.442695f) + 0.5f);
let _e4375 = select(-127f, _e4373, (_e4373 > -127f));
let _e4377 = select(128f, _e4375, (_e4375 < 128f));
let _e4384 = select(0i, select(select(i32(_e4377), i32(-2147483648), (_e4377 < -2147483600f)), 2147483647i, (_e4377 > 2147483500f)), (_e4377 == _e4377));
let _e4388 = (_e4384 - select(0i, 1i, (_e4377 < f32(_e4384))));
let _e4389 = f32(_e4388);
let _e4393 = ((_e4371 - (_e4389 * 0.6933594f)) - (_e4389 * -2.1219444e-4f));
let _e4417 = (_e4354 + 2i);
let _e4419 = select(_e4357, _e4417, (_e4417 < _e4357));
let _e4425 = global_2.member[bitcast<u32>(select(0i, _e4419, (_e4419 > 0i)))];
let _e4427 = -((_e4425 * _e940));
let _e4429 = select(-87f, _e4427, (_e4427 > -87f));
let _e4431 = select(88f, _e4429, (_e4429 < 88f));
let _e4433 = ((_e4431 * 1.442695f) + 0.5f);
let _e4435 = select(-127f, _e4433, (_e4433 > -127f));
let _e4437 = select(128f, _e4435, (_e4435 < 128f));
let _e4444 = select(0i, select(select(i32(_e4437), i32(-2147483648), (_e4437 < -2147483600f)), 2147483647i, (_e4437 > 2147483500f)), (_e4437 == _e4437));
let _e4448 = (_e4444 - select(0i, 1i, (_e4437 < f32(_e4444))));
let _e4449 = f32(_e4448);
let _e4453 = ((_e4431 - (_e4449 * 0.6933594f)) - (_e4449 * -2.1219444e-4f));
let _e4477 = (_e4354 + 3i);
let _e4479 = select(_e4357, _e4477, (_e4477 < _e4357));
let _e4485 = global_2.member[bitcast<u32>(select(0i, _e4479, (_e4479 > 0i)))];
let _e4487 = -((_e4485 * _e940));
let _e4489 = select(-87f, _e4487, (_e4487 > -87f));
let _e4491 = select(88f, _e4489, (_e4489 < 88f));
let _e4493 = ((_e4491 * 1.442695f) + 0.5f);
let _e4495 = select(-127f, _e4493, (_e4493 > -127f));
let _e4497 = select(128f, _e4495, (_e4495 < 128f));
let _e4504 = select(0i, select(select(i32(_e4497), i32(-2147483648), (_e4497 < -2147483600f)), 2147483647i, (_e4497 > 2147483500f)), (_e4497 == _e4497));
let _e4508 = (_e4504 - select(0i, 1i, (_e4497 < f32(_e4504))));
let _e4509 = f32(_e4508);
let _e4513 = ((_e4491 - (_e4509 * 0.6933594f)) - (_e4509 * -2.1219444e-4f));
phi_6342_ = type_12(_e4353.member, _e4353.member_1, vec3<f32>((_e4246.member_2.x * ((1f + (_e4393 * (1f + (_e4393 * (0.5f + (_e4393 * (0.16666667f + (_e4393 * (0.041666668f + (_e4393 * (0.008333334f + (_e4393 * (0.001388889f + (_e4393 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4388 + 127i)) << bitcast<u32>(23i))))), (_e4246.member_2.y * ((1f + (_e4453 * (1f + (_e4453 * (0.5f + (_e4453 * (0.16666667f + (_e4453 * (0.041666668f + (_e4453 * (0.008333334f + (_e4453 * (0.001388889f + (_e4453 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4448 + 127i)) << bitcast<u32>(23i))))), (_e4246.member_2.z * ((1f + (_e4513 * (1f + (_e4513 * (0.5f + (_e4513 * (0.16666667f + (_e4513 * (0.041666668f + (_e4513 * (0.008333334f + (_e4513 * (0.001388889f + (_e4513 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4508 + 127i)) << bitcast<u32>(23i)))))), _e4353.member_3, _e4353.member_4, _e4353.member_5, _e4353.member_6, _e4353.member_7, _e4353.member_8, _e4353.member_9, _e4353.member_10, _e4353.member_11, _e4353.member_12, _e4353.member_13, _e4353.member_14);
} else {
phi_6342_ = _e4335;
}
let _e4554 = phi_6342_;
let _e4557 = local_21;
if (((_e790 <= 0f) && (_e4557 == 16i)) && (_e729.member_7 == 16i)) {
if (_e4554.member_13 == -1i) {
phi_6644_ = type_12(_e4554.member, _e4554.member_1, _e4554.member_2, _e4554.member_3, _e4554.member_4, _e4554.member_5, 1f, _e4554.member_7, _e4554.member_8, _e4554.member_9, _e4554.member_10, _e4554.member_11, _e4554.member_12, _e4554.member_13, _e4554.member_14);
} else {
let _e4596 = type_12(vec3<f32>((_e4554.member.x + (_e4554.member_1.x * _e4554.member_14)), (_e4554.member.y + (_e4554.member_1.y * _e4554.member_14)), (_e4554.member.z + (_e4554.member_1.z * _e4554.member_14))), _e4554.member_1, _e4554.member_2, _e4554.member_3, _e4554.member_4, _e4554.member_5, _e4554.member_6, _e4554.member_7, _e4554.member_8, _e4554.member_9, _e4554.member_10, _e4554.member_11, _e4554.member_12, _e4554.member_13, _e4554.member_14);
let _e4613 = type_12(_e4596.member, _e4596.member_1, _e4596.member_2, _e4596.member_3, _e4596.member_4, (_e4554.member_5 + _e4554.member_14), _e4596.member_6, _e4596.member_7, _e4596.member_8, _e4596.member_9, _e4596.member_10, _e4596.member_11, _e4596.member_12, _e4596.member_13, _e4596.member_14);
let _e4629 = type_12(_e4613.member, _e4613.member_1, _e4613.member_2, _e4613.member_3, _e4613.member_4, _e4613.member_5, _e4613.member_6, _e4613.member_7, _e4613.member_8, _e4613.member_9, _e4613.member_10, _e4613.member_11, _e4613.member_12, _e4613.member_13, (_e4554.member_14 - _e4554.member_14));
let _e4649 = type_12(_e4629.member, _e4629.member_1, _e4629.member_2, _e4629.member_3, _e4629.member_4, _e4629.member_5, _e4629.member_6, _e4629.member_7, _e4629.member_8, _e4629.member_9, (_e4554.member_10 + select(0f, _e4554.member_14, (_e4554.member_8 == 0f))), _e4629.member_11, _e4629.member_12, _e4629.member_13, _e4629.member_14);
phi_6644_ = type_12(_e4649.member, _e4649.member_1, _e4649.member_2, _e4649.member_3, _e4649.member_4, _e4649.member_5, 3f, _e4649.member_7, _e4649.member_8, _e4649.member_9, _e4649.member_10, _e4649.member_11, _e4649.member_12, _e4649.member_13, _e4649.member_14);
}
let _e4681 = phi_6644_;
phi_6645_ = _e4681;
} else {
phi_6645_ = _e4554;
}
let _e4683 = phi_6645_;
phi_6646_ = _e4683;
} else {
phi_6646_ = _e4246;
}
let _e4685 = phi_6646_;
phi_6647_ = _e4685;
}
let _e5007 = phi_6647_;
phi_1203_ = _e5007;
phi_1206_ = (_e731 + 1i);
} else {
phi_1203_ = type_12();
phi_1206_ = i32();
}
let _e5009 = phi_1203_;
let _e5011 = phi_1206_;
continue;
continuing {
phi_1202_ = _e5009;
phi_1205_ = _e5011;
break if !(_e735);
}
}
let _e5014 = local_22;
let _e5018 = local_23;
let _e5022 = local_24;
let _e5026 = local_25;
let _e5030 = local_26;
let _e5034 = local_27;
let _e5038 = local_28;
let _e5042 = local_29;
let _e5046 = local_30;
let _e5050 = local_31;
let _e5054 = local_32;
let _e5058 = local_33;
let _e5062 = local_34;
let _e5066 = local_35;
let _e5070 = local_36;
let _e5074 = local_37;
let _e5077 = local_38;
let _e5081 = local_39;
let _e5084 = local_40;
let _e5087 = local_41;
let _e5090 = local_42;
let _e5093 = local_43;
let _e5097 = local_44;
let _e5101 = local_45;
global_3.member[_e110] = _e5014.member.x;
global_3.member[_e122] = _e5018.member.y;
global_3.member[_e133] = _e5022.member.z;
global_3.member[_e144] = _e5026.member_1.x;
global_3.member[_e155] = _e5030.member_1.y;
global_3.member[_e166] = _e5034.member_1.z;
global_3.member[_e177] = _e5038.member_2.x;
global_3.member[_e188] = _e5042.member_2.y;
global_3.member[_e199] = _e5046.member_2.z;
global_3.member[_e210] = _e5050.member_3.x;
global_3.member[_e221] = _e5054.member_3.y;
global_3.member[_e232] = _e5058.member_3.z;
global_3.member[_e243] = _e5062.member_4.x;
global_3.member[_e254] = _e5066.member_4.y;
global_3.member[_e265] = _e5070.member_4.z;
global_3.member[_e276] = _e5074.member_5;
let _e5138 = local_46;
global_3.member[_e287] = _e5138;
global_3.member[_e298] = f32(_e5077.member_7);
global_3.member[_e309] = _e5081.member_8;
global_3.member[_e320] = _e5084.member_9;
global_3.member[_e331] = _e5087.member_10;
global_3.member[_e342] = _e5090.member_11;
global_3.member[_e353] = f32(_e5093.member_12);
global_3.member[_e364] = f32(_e5097.member_13);
global_3.member[_e375] = _e5101.member_14;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn voxels_march(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
