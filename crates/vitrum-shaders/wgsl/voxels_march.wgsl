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
var phi_1296_: f32;
var phi_858_: i32;
var phi_861_: i32;
var local_2: i32;
var phi_1304_: type_12;
var phi_1306_: type_12;
var phi_1309_: i32;
var phi_1645_: f32;
var phi_1684_: i32;
var phi_1687_: i32;
var phi_2123_: f32;
var phi_1685_: i32;
var phi_1688_: i32;
var local_3: i32;
var phi_2135_: i32;
var phi_2138_: f32;
var phi_2140_: f32;
var phi_2170_: i32;
var phi_2173_: i32;
var phi_2609_: f32;
var phi_2171_: i32;
var phi_2174_: i32;
var local_4: i32;
var phi_2136_: i32;
var phi_2139_: f32;
var phi_2141_: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var phi_2645_: i32;
var phi_2648_: i32;
var phi_3084_: f32;
var phi_2646_: i32;
var phi_2649_: i32;
var local_8: i32;
var local_9: i32;
var phi_3544_: f32;
var phi_3983_: f32;
var phi_4423_: f32;
var phi_4862_: f32;
var phi_5302_: f32;
var phi_5741_: f32;
var local_10: f32;
var local_11: i32;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var phi_6073_: type_12;
var local_17: i32;
var local_18: i32;
var phi_6284_: type_12;
var phi_6337_: type_12;
var phi_6351_: type_12;
var local_19: i32;
var phi_6790_: type_12;
var phi_6791_: type_12;
var phi_6770_: type_12;
var phi_6792_: type_12;
var local_20: i32;
var phi_6801_: type_12;
var phi_6802_: type_12;
var phi_6803_: bool;
var phi_7382_: type_12;
var local_21: i32;
var phi_7684_: type_12;
var phi_7685_: type_12;
var phi_7686_: type_12;
var phi_7093_: type_12;
var phi_7687_: type_12;
var phi_1307_: type_12;
var phi_1310_: i32;
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
let _e455 = global_1.member.member_1[1u];
let _e460 = global_1.member.member_1[2u];
let _e462 = (_e121 - 0.5f);
let _e463 = (_e131 - 0.5f);
let _e464 = (_e142 - 0.5f);
let _e466 = f32((bitcast<i32>(_e450) - 2i));
let _e468 = select(0f, _e462, (_e462 > 0f));
let _e470 = select(_e466, _e468, (_e468 < _e466));
let _e477 = select(0i, select(select(i32(_e470), i32(-2147483648), (_e470 < -2147483600f)), 2147483647i, (_e470 > 2147483500f)), (_e470 == _e470));
let _e481 = (_e477 - select(0i, 1i, (_e470 < f32(_e477))));
let _e483 = f32((bitcast<i32>(_e455) - 2i));
let _e485 = select(0f, _e463, (_e463 > 0f));
let _e487 = select(_e483, _e485, (_e485 < _e483));
let _e494 = select(0i, select(select(i32(_e487), i32(-2147483648), (_e487 < -2147483600f)), 2147483647i, (_e487 > 2147483500f)), (_e487 == _e487));
let _e498 = (_e494 - select(0i, 1i, (_e487 < f32(_e494))));
let _e500 = f32((bitcast<i32>(_e460) - 2i));
let _e502 = select(0f, _e464, (_e464 > 0f));
let _e504 = select(_e500, _e502, (_e502 < _e500));
let _e511 = select(0i, select(select(i32(_e504), i32(-2147483648), (_e504 < -2147483600f)), 2147483647i, (_e504 > 2147483500f)), (_e504 == _e504));
let _e515 = (_e511 - select(0i, 1i, (_e504 < f32(_e511))));
let _e516 = (_e443 * 4i);
let _e517 = (_e516 + 1i);
let _e519 = (bitcast<i32>(_e91) - 1i);
let _e521 = select(_e519, _e517, (_e517 < _e519));
let _e527 = global_5.member[bitcast<u32>(select(0i, _e521, (_e521 > 0i)))];
let _e528 = (_e516 + 2i);
let _e530 = select(_e519, _e528, (_e528 < _e519));
let _e536 = global_5.member[bitcast<u32>(select(0i, _e530, (_e530 > 0i)))];
let _e537 = (_e516 + 3i);
let _e539 = select(_e519, _e537, (_e537 < _e519));
let _e545 = global_5.member[bitcast<u32>(select(0i, _e539, (_e539 > 0i)))];
let _e548 = (_e481 - bitcast<i32>((_e527 & 65535u)));
let _e553 = bitcast<i32>((_e527 >> bitcast<u32>(16i)));
let _e558 = (_e498 - bitcast<i32>((_e536 & 65535u)));
let _e563 = bitcast<i32>((_e536 >> bitcast<u32>(16i)));
let _e568 = (_e515 - bitcast<i32>((_e545 & 65535u)));
if ((((_e548 >= 0i) && ((_e548 + 1i) < _e553)) && ((_e558 >= 0i) && ((_e558 + 1i) < _e563))) && ((_e568 >= 0i) && ((_e568 + 1i) < bitcast<i32>((_e545 >> bitcast<u32>(16i)))))) {
let _e578 = (_e563 * _e553);
let _e580 = select(_e519, _e516, (_e516 < _e519));
let _e586 = global_5.member[bitcast<u32>(select(0i, _e580, (_e580 > 0i)))];
let _e592 = (((bitcast<i32>(_e586) + (_e568 * _e578)) + (_e558 * _e553)) + _e548);
let _e594 = (_e462 - f32(_e481));
let _e596 = (_e463 - f32(_e498));
let _e599 = (2i * _e592);
let _e601 = (_e599 >> bitcast<u32>(2i));
let _e604 = bitcast<u32>(((_e599 & 3i) * 8i));
let _e606 = select(_e519, _e601, (_e601 < _e519));
let _e612 = global_5.member[bitcast<u32>(select(0i, _e606, (_e606 > 0i)))];
let _e616 = (_e601 + 1i);
let _e618 = select(_e519, _e616, (_e616 < _e519));
let _e624 = global_5.member[bitcast<u32>(select(0i, _e618, (_e618 > 0i)))];
let _e631 = ((_e612 >> bitcast<u32>((_e604 & 31u))) | ((_e624 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e604) & 31u))));
let _e634 = f32(bitcast<i32>((_e631 & 65535u)));
let _e641 = (_e634 + ((f32(bitcast<i32>((_e631 >> bitcast<u32>(16i)))) - _e634) * _e594));
let _e643 = (2i * (_e592 + _e553));
let _e645 = (_e643 >> bitcast<u32>(2i));
let _e648 = bitcast<u32>(((_e643 & 3i) * 8i));
let _e650 = select(_e519, _e645, (_e645 < _e519));
let _e656 = global_5.member[bitcast<u32>(select(0i, _e650, (_e650 > 0i)))];
let _e660 = (_e645 + 1i);
let _e662 = select(_e519, _e660, (_e660 < _e519));
let _e668 = global_5.member[bitcast<u32>(select(0i, _e662, (_e662 > 0i)))];
let _e675 = ((_e656 >> bitcast<u32>((_e648 & 31u))) | ((_e668 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e648) & 31u))));
let _e678 = f32(bitcast<i32>((_e675 & 65535u)));
let _e686 = (_e592 + _e578);
let _e687 = (2i * _e686);
let _e689 = (_e687 >> bitcast<u32>(2i));
let _e692 = bitcast<u32>(((_e687 & 3i) * 8i));
let _e694 = select(_e519, _e689, (_e689 < _e519));
let _e700 = global_5.member[bitcast<u32>(select(0i, _e694, (_e694 > 0i)))];
let _e704 = (_e689 + 1i);
let _e706 = select(_e519, _e704, (_e704 < _e519));
let _e712 = global_5.member[bitcast<u32>(select(0i, _e706, (_e706 > 0i)))];
let _e719 = ((_e700 >> bitcast<u32>((_e692 & 31u))) | ((_e712 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e692) & 31u))));
let _e722 = f32(bitcast<i32>((_e719 & 65535u)));
let _e729 = (_e722 + ((f32(bitcast<i32>((_e719 >> bitcast<u32>(16i)))) - _e722) * _e594));
let _e731 = (2i * (_e686 + _e553));
let _e733 = (_e731 >> bitcast<u32>(2i));
let _e736 = bitcast<u32>(((_e731 & 3i) * 8i));
let _e738 = select(_e519, _e733, (_e733 < _e519));
let _e744 = global_5.member[bitcast<u32>(select(0i, _e738, (_e738 > 0i)))];
let _e748 = (_e733 + 1i);
let _e750 = select(_e519, _e748, (_e748 < _e519));
let _e756 = global_5.member[bitcast<u32>(select(0i, _e750, (_e750 > 0i)))];
let _e763 = ((_e744 >> bitcast<u32>((_e736 & 31u))) | ((_e756 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e736) & 31u))));
let _e766 = f32(bitcast<i32>((_e763 & 65535u)));
let _e776 = (_e641 + (((_e678 + ((f32(bitcast<i32>((_e675 >> bitcast<u32>(16i)))) - _e678) * _e594)) - _e641) * _e596));
phi_1296_ = (_e776 + (((_e729 + (((_e766 + ((f32(bitcast<i32>((_e763 >> bitcast<u32>(16i)))) - _e766) * _e594)) - _e729) * _e596)) - _e776) * (_e464 - f32(_e515))));
} else {
phi_1296_ = 0f;
}
let _e784 = phi_1296_;
phi_858_ = (_e443 - 1i);
phi_861_ = select(_e445, _e443, (_e784 > 32767.5f));
} else {
phi_858_ = i32();
phi_861_ = i32();
}
let _e789 = phi_858_;
let _e791 = phi_861_;
continue;
continuing {
phi_857_ = _e789;
phi_860_ = _e791;
break if !(_e446);
}
}
let _e794 = local_2;
phi_1304_ = type_12(_e395, _e396, _e397, _e398, _e399, _e285, _e296, _e794, _e318, _e329, _e340, _e351, _e413, _e420, _e384);
} else {
phi_1304_ = type_12(_e395, _e396, _e397, _e398, _e399, _e285, _e296, select(0i, select(select(i32(_e307), i32(-2147483648), (_e307 < -2147483600f)), 2147483647i, (_e307 > 2147483500f)), (_e307 == _e307)), _e318, _e329, _e340, _e351, _e413, _e420, _e384);
}
let _e797 = phi_1304_;
phi_1306_ = _e797;
phi_1309_ = 0i;
loop {
let _e799 = phi_1306_;
let _e801 = phi_1309_;
local_22 = _e799;
local_23 = _e799;
local_24 = _e799;
local_25 = _e799;
local_26 = _e799;
local_27 = _e799;
local_28 = _e799;
local_29 = _e799;
local_30 = _e799;
local_31 = _e799;
local_32 = _e799;
local_33 = _e799;
local_34 = _e799;
local_35 = _e799;
local_36 = _e799;
local_37 = _e799;
local_38 = _e799;
local_39 = _e799;
local_40 = _e799;
local_41 = _e799;
local_42 = _e799;
local_43 = _e799;
local_44 = _e799;
local_45 = _e799;
let _e805 = ((_e801 < 256i) && (_e799.member_6 == 0f));
local_46 = _e799.member_6;
if _e805 {
let _e816 = (1f / select(_e799.member_1.x, select(1e-12f, -1e-12f, (_e799.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e799.member_1.x) & 2147483647u)) < 1e-12f)));
let _e825 = (1f / select(_e799.member_1.y, select(1e-12f, -1e-12f, (_e799.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e799.member_1.y) & 2147483647u)) < 1e-12f)));
let _e834 = (1f / select(_e799.member_1.z, select(1e-12f, -1e-12f, (_e799.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e799.member_1.z) & 2147483647u)) < 1e-12f)));
let _e838 = ((_e424.member - _e799.member.x) * _e816);
let _e840 = ((_e430.member - _e799.member.x) * _e816);
let _e843 = ((_e424.member_1 - _e799.member.y) * _e825);
let _e845 = ((_e430.member_1 - _e799.member.y) * _e825);
let _e848 = ((_e424.member_2 - _e799.member.z) * _e834);
let _e850 = ((_e430.member_2 - _e799.member.z) * _e834);
let _e852 = select(_e840, _e838, (_e838 > _e840));
let _e854 = select(_e845, _e843, (_e843 > _e845));
let _e856 = select(_e854, _e852, (_e852 < _e854));
let _e858 = select(_e850, _e848, (_e848 > _e850));
let _e860 = select(_e858, _e856, (_e856 < _e858));
let _e864 = global_1.member.member_2[0u];
let _e865 = bitcast<i32>(_e864);
let _e869 = global_1.member.member_2[1u];
let _e870 = bitcast<i32>(_e869);
let _e874 = global_1.member.member_2[2u];
let _e877 = ((_e799.member.x - 0.5f) / 4f);
let _e879 = f32((_e865 - 1i));
let _e881 = select(0f, _e877, (_e877 > 0f));
let _e883 = select(_e879, _e881, (_e881 < _e879));
let _e890 = select(0i, select(select(i32(_e883), i32(-2147483648), (_e883 < -2147483600f)), 2147483647i, (_e883 > 2147483500f)), (_e883 == _e883));
let _e894 = (_e890 - select(0i, 1i, (_e883 < f32(_e890))));
let _e896 = ((_e799.member.y - 0.5f) / 4f);
let _e898 = f32((_e870 - 1i));
let _e900 = select(0f, _e896, (_e896 > 0f));
let _e902 = select(_e898, _e900, (_e900 < _e898));
let _e909 = select(0i, select(select(i32(_e902), i32(-2147483648), (_e902 < -2147483600f)), 2147483647i, (_e902 > 2147483500f)), (_e902 == _e902));
let _e913 = (_e909 - select(0i, 1i, (_e902 < f32(_e909))));
let _e915 = ((_e799.member.z - 0.5f) / 4f);
let _e917 = f32((bitcast<i32>(_e874) - 1i));
let _e919 = select(0f, _e915, (_e915 > 0f));
let _e921 = select(_e917, _e919, (_e919 < _e917));
let _e928 = select(0i, select(select(i32(_e921), i32(-2147483648), (_e921 < -2147483600f)), 2147483647i, (_e921 > 2147483500f)), (_e921 == _e921));
let _e932 = (_e928 - select(0i, 1i, (_e921 < f32(_e928))));
let _e936 = ((((_e932 * _e870) + _e913) * _e865) + _e894);
let _e938 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e940 = select(_e938, _e936, (_e936 < _e938));
let _e946 = global_4.member[bitcast<u32>(select(0i, _e940, (_e940 > 0i)))];
let _e947 = bitcast<i32>(_e946);
if (_e947 > 0i) {
let _e977 = ((((f32(((_e894 - _e947) + 1i)) * 4f) + 0.5f) - _e799.member.x) * _e816);
let _e979 = ((((f32((_e894 + _e947)) * 4f) + 0.5f) - _e799.member.x) * _e816);
let _e981 = ((((f32(((_e913 - _e947) + 1i)) * 4f) + 0.5f) - _e799.member.y) * _e825);
let _e983 = ((((f32((_e913 + _e947)) * 4f) + 0.5f) - _e799.member.y) * _e825);
let _e985 = ((((f32(((_e932 - _e947) + 1i)) * 4f) + 0.5f) - _e799.member.z) * _e834);
let _e987 = ((((f32((_e932 + _e947)) * 4f) + 0.5f) - _e799.member.z) * _e834);
let _e989 = select(_e979, _e977, (_e977 > _e979));
let _e991 = select(_e983, _e981, (_e981 > _e983));
let _e993 = select(_e991, _e989, (_e989 < _e991));
let _e995 = select(_e987, _e985, (_e985 > _e987));
let _e997 = select(_e995, _e993, (_e993 < _e995));
phi_1645_ = (select(0f, _e997, (_e997 > 0f)) + 1e-3f);
} else {
phi_1645_ = 0.5f;
}
let _e1002 = phi_1645_;
let _e1005 = (select(0f, _e860, (_e860 > 0f)) + 1e-3f);
let _e1007 = select(_e1005, _e1002, (_e1002 < _e1005));
let _e1009 = (_e799.member_14 <= _e1007);
let _e1010 = select(_e1007, _e799.member_14, _e1009);
let _e1021 = global_1.member.member_1[3u];
let _e1023 = (bitcast<i32>(_e1021) - 1i);
phi_1684_ = _e1023;
phi_1687_ = 16i;
loop {
let _e1025 = phi_1684_;
let _e1027 = phi_1687_;
local_3 = _e1027;
local_21 = _e1027;
let _e1028 = (_e1025 >= 0i);
if _e1028 {
let _e1032 = global_1.member.member_1[0u];
let _e1037 = global_1.member.member_1[1u];
let _e1042 = global_1.member.member_1[2u];
let _e1044 = ((_e799.member.x + (_e799.member_1.x * _e1010)) - 0.5f);
let _e1045 = ((_e799.member.y + (_e799.member_1.y * _e1010)) - 0.5f);
let _e1046 = ((_e799.member.z + (_e799.member_1.z * _e1010)) - 0.5f);
let _e1048 = f32((bitcast<i32>(_e1032) - 2i));
let _e1050 = select(0f, _e1044, (_e1044 > 0f));
let _e1052 = select(_e1048, _e1050, (_e1050 < _e1048));
let _e1059 = select(0i, select(select(i32(_e1052), i32(-2147483648), (_e1052 < -2147483600f)), 2147483647i, (_e1052 > 2147483500f)), (_e1052 == _e1052));
let _e1063 = (_e1059 - select(0i, 1i, (_e1052 < f32(_e1059))));
let _e1065 = f32((bitcast<i32>(_e1037) - 2i));
let _e1067 = select(0f, _e1045, (_e1045 > 0f));
let _e1069 = select(_e1065, _e1067, (_e1067 < _e1065));
let _e1076 = select(0i, select(select(i32(_e1069), i32(-2147483648), (_e1069 < -2147483600f)), 2147483647i, (_e1069 > 2147483500f)), (_e1069 == _e1069));
let _e1080 = (_e1076 - select(0i, 1i, (_e1069 < f32(_e1076))));
let _e1082 = f32((bitcast<i32>(_e1042) - 2i));
let _e1084 = select(0f, _e1046, (_e1046 > 0f));
let _e1086 = select(_e1082, _e1084, (_e1084 < _e1082));
let _e1093 = select(0i, select(select(i32(_e1086), i32(-2147483648), (_e1086 < -2147483600f)), 2147483647i, (_e1086 > 2147483500f)), (_e1086 == _e1086));
let _e1097 = (_e1093 - select(0i, 1i, (_e1086 < f32(_e1093))));
let _e1098 = (_e1025 * 4i);
let _e1099 = (_e1098 + 1i);
let _e1101 = (bitcast<i32>(_e91) - 1i);
let _e1103 = select(_e1101, _e1099, (_e1099 < _e1101));
let _e1109 = global_5.member[bitcast<u32>(select(0i, _e1103, (_e1103 > 0i)))];
let _e1110 = (_e1098 + 2i);
let _e1112 = select(_e1101, _e1110, (_e1110 < _e1101));
let _e1118 = global_5.member[bitcast<u32>(select(0i, _e1112, (_e1112 > 0i)))];
let _e1119 = (_e1098 + 3i);
let _e1121 = select(_e1101, _e1119, (_e1119 < _e1101));
let _e1127 = global_5.member[bitcast<u32>(select(0i, _e1121, (_e1121 > 0i)))];
let _e1130 = (_e1063 - bitcast<i32>((_e1109 & 65535u)));
let _e1135 = bitcast<i32>((_e1109 >> bitcast<u32>(16i)));
let _e1140 = (_e1080 - bitcast<i32>((_e1118 & 65535u)));
let _e1145 = bitcast<i32>((_e1118 >> bitcast<u32>(16i)));
let _e1150 = (_e1097 - bitcast<i32>((_e1127 & 65535u)));
if ((((_e1130 >= 0i) && ((_e1130 + 1i) < _e1135)) && ((_e1140 >= 0i) && ((_e1140 + 1i) < _e1145))) && ((_e1150 >= 0i) && ((_e1150 + 1i) < bitcast<i32>((_e1127 >> bitcast<u32>(16i)))))) {
let _e1160 = (_e1145 * _e1135);
let _e1162 = select(_e1101, _e1098, (_e1098 < _e1101));
let _e1168 = global_5.member[bitcast<u32>(select(0i, _e1162, (_e1162 > 0i)))];
let _e1174 = (((bitcast<i32>(_e1168) + (_e1150 * _e1160)) + (_e1140 * _e1135)) + _e1130);
let _e1176 = (_e1044 - f32(_e1063));
let _e1178 = (_e1045 - f32(_e1080));
let _e1181 = (2i * _e1174);
let _e1183 = (_e1181 >> bitcast<u32>(2i));
let _e1186 = bitcast<u32>(((_e1181 & 3i) * 8i));
let _e1188 = select(_e1101, _e1183, (_e1183 < _e1101));
let _e1194 = global_5.member[bitcast<u32>(select(0i, _e1188, (_e1188 > 0i)))];
let _e1198 = (_e1183 + 1i);
let _e1200 = select(_e1101, _e1198, (_e1198 < _e1101));
let _e1206 = global_5.member[bitcast<u32>(select(0i, _e1200, (_e1200 > 0i)))];
let _e1213 = ((_e1194 >> bitcast<u32>((_e1186 & 31u))) | ((_e1206 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1186) & 31u))));
let _e1216 = f32(bitcast<i32>((_e1213 & 65535u)));
let _e1223 = (_e1216 + ((f32(bitcast<i32>((_e1213 >> bitcast<u32>(16i)))) - _e1216) * _e1176));
let _e1225 = (2i * (_e1174 + _e1135));
let _e1227 = (_e1225 >> bitcast<u32>(2i));
let _e1230 = bitcast<u32>(((_e1225 & 3i) * 8i));
let _e1232 = select(_e1101, _e1227, (_e1227 < _e1101));
let _e1238 = global_5.member[bitcast<u32>(select(0i, _e1232, (_e1232 > 0i)))];
let _e1242 = (_e1227 + 1i);
let _e1244 = select(_e1101, _e1242, (_e1242 < _e1101));
let _e1250 = global_5.member[bitcast<u32>(select(0i, _e1244, (_e1244 > 0i)))];
let _e1257 = ((_e1238 >> bitcast<u32>((_e1230 & 31u))) | ((_e1250 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1230) & 31u))));
let _e1260 = f32(bitcast<i32>((_e1257 & 65535u)));
let _e1268 = (_e1174 + _e1160);
let _e1269 = (2i * _e1268);
let _e1271 = (_e1269 >> bitcast<u32>(2i));
let _e1274 = bitcast<u32>(((_e1269 & 3i) * 8i));
let _e1276 = select(_e1101, _e1271, (_e1271 < _e1101));
let _e1282 = global_5.member[bitcast<u32>(select(0i, _e1276, (_e1276 > 0i)))];
let _e1286 = (_e1271 + 1i);
let _e1288 = select(_e1101, _e1286, (_e1286 < _e1101));
let _e1294 = global_5.member[bitcast<u32>(select(0i, _e1288, (_e1288 > 0i)))];
let _e1301 = ((_e1282 >> bitcast<u32>((_e1274 & 31u))) | ((_e1294 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1274) & 31u))));
let _e1304 = f32(bitcast<i32>((_e1301 & 65535u)));
let _e1311 = (_e1304 + ((f32(bitcast<i32>((_e1301 >> bitcast<u32>(16i)))) - _e1304) * _e1176));
let _e1313 = (2i * (_e1268 + _e1135));
let _e1315 = (_e1313 >> bitcast<u32>(2i));
let _e1318 = bitcast<u32>(((_e1313 & 3i) * 8i));
let _e1320 = select(_e1101, _e1315, (_e1315 < _e1101));
let _e1326 = global_5.member[bitcast<u32>(select(0i, _e1320, (_e1320 > 0i)))];
let _e1330 = (_e1315 + 1i);
let _e1332 = select(_e1101, _e1330, (_e1330 < _e1101));
let _e1338 = global_5.member[bitcast<u32>(select(0i, _e1332, (_e1332 > 0i)))];
let _e1345 = ((_e1326 >> bitcast<u32>((_e1318 & 31u))) | ((_e1338 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1318) & 31u))));
let _e1348 = f32(bitcast<i32>((_e1345 & 65535u)));
let _e1358 = (_e1223 + (((_e1260 + ((f32(bitcast<i32>((_e1257 >> bitcast<u32>(16i)))) - _e1260) * _e1176)) - _e1223) * _e1178));
phi_2123_ = (_e1358 + (((_e1311 + (((_e1348 + ((f32(bitcast<i32>((_e1345 >> bitcast<u32>(16i)))) - _e1348) * _e1176)) - _e1311) * _e1178)) - _e1358) * (_e1046 - f32(_e1097))));
} else {
phi_2123_ = 0f;
}
let _e1366 = phi_2123_;
phi_1685_ = (_e1025 - 1i);
phi_1688_ = select(_e1027, _e1025, (_e1366 > 32767.5f));
} else {
phi_1685_ = i32();
phi_1688_ = i32();
}
let _e1371 = phi_1685_;
let _e1373 = phi_1688_;
continue;
continuing {
phi_1684_ = _e1371;
phi_1687_ = _e1373;
break if !(_e1028);
}
}
let _e1376 = local_3;
let _e1377 = (_e1376 == _e799.member_7);
if _e1377 {
phi_6802_ = _e799;
phi_6803_ = _e1377;
} else {
phi_2135_ = 0i;
phi_2138_ = 0f;
phi_2140_ = _e1010;
loop {
let _e1379 = phi_2135_;
let _e1381 = phi_2138_;
let _e1383 = phi_2140_;
local_5 = _e1383;
local_6 = _e1383;
local_7 = _e1383;
local_10 = _e1383;
local_12 = _e1383;
local_13 = _e1383;
local_14 = _e1383;
local_15 = _e1383;
local_16 = _e1383;
let _e1384 = (_e1379 < 12i);
if _e1384 {
let _e1386 = (0.5f * (_e1381 + _e1383));
phi_2170_ = _e1023;
phi_2173_ = 16i;
loop {
let _e1394 = phi_2170_;
let _e1396 = phi_2173_;
local_4 = _e1396;
let _e1397 = (_e1394 >= 0i);
if _e1397 {
let _e1401 = global_1.member.member_1[0u];
let _e1406 = global_1.member.member_1[1u];
let _e1411 = global_1.member.member_1[2u];
let _e1413 = ((_e799.member.x + (_e799.member_1.x * _e1386)) - 0.5f);
let _e1414 = ((_e799.member.y + (_e799.member_1.y * _e1386)) - 0.5f);
let _e1415 = ((_e799.member.z + (_e799.member_1.z * _e1386)) - 0.5f);
let _e1417 = f32((bitcast<i32>(_e1401) - 2i));
let _e1419 = select(0f, _e1413, (_e1413 > 0f));
let _e1421 = select(_e1417, _e1419, (_e1419 < _e1417));
let _e1428 = select(0i, select(select(i32(_e1421), i32(-2147483648), (_e1421 < -2147483600f)), 2147483647i, (_e1421 > 2147483500f)), (_e1421 == _e1421));
let _e1432 = (_e1428 - select(0i, 1i, (_e1421 < f32(_e1428))));
let _e1434 = f32((bitcast<i32>(_e1406) - 2i));
let _e1436 = select(0f, _e1414, (_e1414 > 0f));
let _e1438 = select(_e1434, _e1436, (_e1436 < _e1434));
let _e1445 = select(0i, select(select(i32(_e1438), i32(-2147483648), (_e1438 < -2147483600f)), 2147483647i, (_e1438 > 2147483500f)), (_e1438 == _e1438));
let _e1449 = (_e1445 - select(0i, 1i, (_e1438 < f32(_e1445))));
let _e1451 = f32((bitcast<i32>(_e1411) - 2i));
let _e1453 = select(0f, _e1415, (_e1415 > 0f));
let _e1455 = select(_e1451, _e1453, (_e1453 < _e1451));
let _e1462 = select(0i, select(select(i32(_e1455), i32(-2147483648), (_e1455 < -2147483600f)), 2147483647i, (_e1455 > 2147483500f)), (_e1455 == _e1455));
let _e1466 = (_e1462 - select(0i, 1i, (_e1455 < f32(_e1462))));
let _e1467 = (_e1394 * 4i);
let _e1468 = (_e1467 + 1i);
let _e1470 = (bitcast<i32>(_e91) - 1i);
let _e1472 = select(_e1470, _e1468, (_e1468 < _e1470));
let _e1478 = global_5.member[bitcast<u32>(select(0i, _e1472, (_e1472 > 0i)))];
let _e1479 = (_e1467 + 2i);
let _e1481 = select(_e1470, _e1479, (_e1479 < _e1470));
let _e1487 = global_5.member[bitcast<u32>(select(0i, _e1481, (_e1481 > 0i)))];
let _e1488 = (_e1467 + 3i);
let _e1490 = select(_e1470, _e1488, (_e1488 < _e1470));
let _e1496 = global_5.member[bitcast<u32>(select(0i, _e1490, (_e1490 > 0i)))];
let _e1499 = (_e1432 - bitcast<i32>((_e1478 & 65535u)));
let _e1504 = bitcast<i32>((_e1478 >> bitcast<u32>(16i)));
let _e1509 = (_e1449 - bitcast<i32>((_e1487 & 65535u)));
let _e1514 = bitcast<i32>((_e1487 >> bitcast<u32>(16i)));
let _e1519 = (_e1466 - bitcast<i32>((_e1496 & 65535u)));
if ((((_e1499 >= 0i) && ((_e1499 + 1i) < _e1504)) && ((_e1509 >= 0i) && ((_e1509 + 1i) < _e1514))) && ((_e1519 >= 0i) && ((_e1519 + 1i) < bitcast<i32>((_e1496 >> bitcast<u32>(16i)))))) {
let _e1529 = (_e1514 * _e1504);
let _e1531 = select(_e1470, _e1467, (_e1467 < _e1470));
let _e1537 = global_5.member[bitcast<u32>(select(0i, _e1531, (_e1531 > 0i)))];
let _e1543 = (((bitcast<i32>(_e1537) + (_e1519 * _e1529)) + (_e1509 * _e1504)) + _e1499);
let _e1545 = (_e1413 - f32(_e1432));
let _e1547 = (_e1414 - f32(_e1449));
let _e1550 = (2i * _e1543);
let _e1552 = (_e1550 >> bitcast<u32>(2i));
let _e1555 = bitcast<u32>(((_e1550 & 3i) * 8i));
let _e1557 = select(_e1470, _e1552, (_e1552 < _e1470));
let _e1563 = global_5.member[bitcast<u32>(select(0i, _e1557, (_e1557 > 0i)))];
let _e1567 = (_e1552 + 1i);
let _e1569 = select(_e1470, _e1567, (_e1567 < _e1470));
let _e1575 = global_5.member[bitcast<u32>(select(0i, _e1569, (_e1569 > 0i)))];
let _e1582 = ((_e1563 >> bitcast<u32>((_e1555 & 31u))) | ((_e1575 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1555) & 31u))));
let _e1585 = f32(bitcast<i32>((_e1582 & 65535u)));
let _e1592 = (_e1585 + ((f32(bitcast<i32>((_e1582 >> bitcast<u32>(16i)))) - _e1585) * _e1545));
let _e1594 = (2i * (_e1543 + _e1504));
let _e1596 = (_e1594 >> bitcast<u32>(2i));
let _e1599 = bitcast<u32>(((_e1594 & 3i) * 8i));
let _e1601 = select(_e1470, _e1596, (_e1596 < _e1470));
let _e1607 = global_5.member[bitcast<u32>(select(0i, _e1601, (_e1601 > 0i)))];
let _e1611 = (_e1596 + 1i);
let _e1613 = select(_e1470, _e1611, (_e1611 < _e1470));
let _e1619 = global_5.member[bitcast<u32>(select(0i, _e1613, (_e1613 > 0i)))];
let _e1626 = ((_e1607 >> bitcast<u32>((_e1599 & 31u))) | ((_e1619 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1599) & 31u))));
let _e1629 = f32(bitcast<i32>((_e1626 & 65535u)));
let _e1637 = (_e1543 + _e1529);
let _e1638 = (2i * _e1637);
let _e1640 = (_e1638 >> bitcast<u32>(2i));
let _e1643 = bitcast<u32>(((_e1638 & 3i) * 8i));
let _e1645 = select(_e1470, _e1640, (_e1640 < _e1470));
let _e1651 = global_5.member[bitcast<u32>(select(0i, _e1645, (_e1645 > 0i)))];
let _e1655 = (_e1640 + 1i);
let _e1657 = select(_e1470, _e1655, (_e1655 < _e1470));
let _e1663 = global_5.member[bitcast<u32>(select(0i, _e1657, (_e1657 > 0i)))];
let _e1670 = ((_e1651 >> bitcast<u32>((_e1643 & 31u))) | ((_e1663 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1643) & 31u))));
let _e1673 = f32(bitcast<i32>((_e1670 & 65535u)));
let _e1680 = (_e1673 + ((f32(bitcast<i32>((_e1670 >> bitcast<u32>(16i)))) - _e1673) * _e1545));
let _e1682 = (2i * (_e1637 + _e1504));
let _e1684 = (_e1682 >> bitcast<u32>(2i));
let _e1687 = bitcast<u32>(((_e1682 & 3i) * 8i));
let _e1689 = select(_e1470, _e1684, (_e1684 < _e1470));
let _e1695 = global_5.member[bitcast<u32>(select(0i, _e1689, (_e1689 > 0i)))];
let _e1699 = (_e1684 + 1i);
let _e1701 = select(_e1470, _e1699, (_e1699 < _e1470));
let _e1707 = global_5.member[bitcast<u32>(select(0i, _e1701, (_e1701 > 0i)))];
let _e1714 = ((_e1695 >> bitcast<u32>((_e1687 & 31u))) | ((_e1707 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1687) & 31u))));
let _e1717 = f32(bitcast<i32>((_e1714 & 65535u)));
let _e1727 = (_e1592 + (((_e1629 + ((f32(bitcast<i32>((_e1626 >> bitcast<u32>(16i)))) - _e1629) * _e1545)) - _e1592) * _e1547));
phi_2609_ = (_e1727 + (((_e1680 + (((_e1717 + ((f32(bitcast<i32>((_e1714 >> bitcast<u32>(16i)))) - _e1717) * _e1545)) - _e1680) * _e1547)) - _e1727) * (_e1415 - f32(_e1466))));
} else {
phi_2609_ = 0f;
}
let _e1735 = phi_2609_;
phi_2171_ = (_e1394 - 1i);
phi_2174_ = select(_e1396, _e1394, (_e1735 > 32767.5f));
} else {
phi_2171_ = i32();
phi_2174_ = i32();
}
let _e1740 = phi_2171_;
let _e1742 = phi_2174_;
continue;
continuing {
phi_2170_ = _e1740;
phi_2173_ = _e1742;
break if !(_e1397);
}
}
let _e1745 = local_4;
let _e1746 = (_e1745 == _e799.member_7);
phi_2136_ = (_e1379 + 1i);
phi_2139_ = select(_e1381, _e1386, _e1746);
phi_2141_ = select(_e1386, _e1383, _e1746);
} else {
phi_2136_ = i32();
phi_2139_ = f32();
phi_2141_ = f32();
}
let _e1751 = phi_2136_;
let _e1753 = phi_2139_;
let _e1755 = phi_2141_;
continue;
continuing {
phi_2135_ = _e1751;
phi_2138_ = _e1753;
phi_2140_ = _e1755;
break if !(_e1384);
}
}
let _e1758 = local_5;
let _e1759 = (_e799.member_1.x * _e1758);
let _e1761 = local_6;
let _e1762 = (_e799.member_1.y * _e1761);
let _e1764 = local_7;
let _e1765 = (_e799.member_1.z * _e1764);
phi_2645_ = _e1023;
phi_2648_ = 16i;
loop {
let _e1772 = phi_2645_;
let _e1774 = phi_2648_;
local_8 = _e1774;
local_9 = _e1774;
local_11 = _e1774;
local_17 = _e1774;
local_18 = _e1774;
local_19 = _e1774;
local_20 = _e1774;
let _e1775 = (_e1772 >= 0i);
if _e1775 {
let _e1779 = global_1.member.member_1[0u];
let _e1784 = global_1.member.member_1[1u];
let _e1789 = global_1.member.member_1[2u];
let _e1791 = ((_e799.member.x + _e1759) - 0.5f);
let _e1792 = ((_e799.member.y + _e1762) - 0.5f);
let _e1793 = ((_e799.member.z + _e1765) - 0.5f);
let _e1795 = f32((bitcast<i32>(_e1779) - 2i));
let _e1797 = select(0f, _e1791, (_e1791 > 0f));
let _e1799 = select(_e1795, _e1797, (_e1797 < _e1795));
let _e1806 = select(0i, select(select(i32(_e1799), i32(-2147483648), (_e1799 < -2147483600f)), 2147483647i, (_e1799 > 2147483500f)), (_e1799 == _e1799));
let _e1810 = (_e1806 - select(0i, 1i, (_e1799 < f32(_e1806))));
let _e1812 = f32((bitcast<i32>(_e1784) - 2i));
let _e1814 = select(0f, _e1792, (_e1792 > 0f));
let _e1816 = select(_e1812, _e1814, (_e1814 < _e1812));
let _e1823 = select(0i, select(select(i32(_e1816), i32(-2147483648), (_e1816 < -2147483600f)), 2147483647i, (_e1816 > 2147483500f)), (_e1816 == _e1816));
let _e1827 = (_e1823 - select(0i, 1i, (_e1816 < f32(_e1823))));
let _e1829 = f32((bitcast<i32>(_e1789) - 2i));
let _e1831 = select(0f, _e1793, (_e1793 > 0f));
let _e1833 = select(_e1829, _e1831, (_e1831 < _e1829));
let _e1840 = select(0i, select(select(i32(_e1833), i32(-2147483648), (_e1833 < -2147483600f)), 2147483647i, (_e1833 > 2147483500f)), (_e1833 == _e1833));
let _e1844 = (_e1840 - select(0i, 1i, (_e1833 < f32(_e1840))));
let _e1845 = (_e1772 * 4i);
let _e1846 = (_e1845 + 1i);
let _e1848 = (bitcast<i32>(_e91) - 1i);
let _e1850 = select(_e1848, _e1846, (_e1846 < _e1848));
let _e1856 = global_5.member[bitcast<u32>(select(0i, _e1850, (_e1850 > 0i)))];
let _e1857 = (_e1845 + 2i);
let _e1859 = select(_e1848, _e1857, (_e1857 < _e1848));
let _e1865 = global_5.member[bitcast<u32>(select(0i, _e1859, (_e1859 > 0i)))];
let _e1866 = (_e1845 + 3i);
let _e1868 = select(_e1848, _e1866, (_e1866 < _e1848));
let _e1874 = global_5.member[bitcast<u32>(select(0i, _e1868, (_e1868 > 0i)))];
let _e1877 = (_e1810 - bitcast<i32>((_e1856 & 65535u)));
let _e1882 = bitcast<i32>((_e1856 >> bitcast<u32>(16i)));
let _e1887 = (_e1827 - bitcast<i32>((_e1865 & 65535u)));
let _e1892 = bitcast<i32>((_e1865 >> bitcast<u32>(16i)));
let _e1897 = (_e1844 - bitcast<i32>((_e1874 & 65535u)));
if ((((_e1877 >= 0i) && ((_e1877 + 1i) < _e1882)) && ((_e1887 >= 0i) && ((_e1887 + 1i) < _e1892))) && ((_e1897 >= 0i) && ((_e1897 + 1i) < bitcast<i32>((_e1874 >> bitcast<u32>(16i)))))) {
let _e1907 = (_e1892 * _e1882);
let _e1909 = select(_e1848, _e1845, (_e1845 < _e1848));
let _e1915 = global_5.member[bitcast<u32>(select(0i, _e1909, (_e1909 > 0i)))];
let _e1921 = (((bitcast<i32>(_e1915) + (_e1897 * _e1907)) + (_e1887 * _e1882)) + _e1877);
let _e1923 = (_e1791 - f32(_e1810));
let _e1925 = (_e1792 - f32(_e1827));
let _e1928 = (2i * _e1921);
let _e1930 = (_e1928 >> bitcast<u32>(2i));
let _e1933 = bitcast<u32>(((_e1928 & 3i) * 8i));
let _e1935 = select(_e1848, _e1930, (_e1930 < _e1848));
let _e1941 = global_5.member[bitcast<u32>(select(0i, _e1935, (_e1935 > 0i)))];
let _e1945 = (_e1930 + 1i);
let _e1947 = select(_e1848, _e1945, (_e1945 < _e1848));
let _e1953 = global_5.member[bitcast<u32>(select(0i, _e1947, (_e1947 > 0i)))];
let _e1960 = ((_e1941 >> bitcast<u32>((_e1933 & 31u))) | ((_e1953 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1933) & 31u))));
let _e1963 = f32(bitcast<i32>((_e1960 & 65535u)));
let _e1970 = (_e1963 + ((f32(bitcast<i32>((_e1960 >> bitcast<u32>(16i)))) - _e1963) * _e1923));
let _e1972 = (2i * (_e1921 + _e1882));
let _e1974 = (_e1972 >> bitcast<u32>(2i));
let _e1977 = bitcast<u32>(((_e1972 & 3i) * 8i));
let _e1979 = select(_e1848, _e1974, (_e1974 < _e1848));
let _e1985 = global_5.member[bitcast<u32>(select(0i, _e1979, (_e1979 > 0i)))];
let _e1989 = (_e1974 + 1i);
let _e1991 = select(_e1848, _e1989, (_e1989 < _e1848));
let _e1997 = global_5.member[bitcast<u32>(select(0i, _e1991, (_e1991 > 0i)))];
let _e2004 = ((_e1985 >> bitcast<u32>((_e1977 & 31u))) | ((_e1997 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1977) & 31u))));
let _e2007 = f32(bitcast<i32>((_e2004 & 65535u)));
let _e2015 = (_e1921 + _e1907);
let _e2016 = (2i * _e2015);
let _e2018 = (_e2016 >> bitcast<u32>(2i));
let _e2021 = bitcast<u32>(((_e2016 & 3i) * 8i));
let _e2023 = select(_e1848, _e2018, (_e2018 < _e1848));
let _e2029 = global_5.member[bitcast<u32>(select(0i, _e2023, (_e2023 > 0i)))];
let _e2033 = (_e2018 + 1i);
let _e2035 = select(_e1848, _e2033, (_e2033 < _e1848));
let _e2041 = global_5.member[bitcast<u32>(select(0i, _e2035, (_e2035 > 0i)))];
let _e2048 = ((_e2029 >> bitcast<u32>((_e2021 & 31u))) | ((_e2041 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2021) & 31u))));
let _e2051 = f32(bitcast<i32>((_e2048 & 65535u)));
let _e2058 = (_e2051 + ((f32(bitcast<i32>((_e2048 >> bitcast<u32>(16i)))) - _e2051) * _e1923));
let _e2060 = (2i * (_e2015 + _e1882));
let _e2062 = (_e2060 >> bitcast<u32>(2i));
let _e2065 = bitcast<u32>(((_e2060 & 3i) * 8i));
let _e2067 = select(_e1848, _e2062, (_e2062 < _e1848));
let _e2073 = global_5.member[bitcast<u32>(select(0i, _e2067, (_e2067 > 0i)))];
let _e2077 = (_e2062 + 1i);
let _e2079 = select(_e1848, _e2077, (_e2077 < _e1848));
let _e2085 = global_5.member[bitcast<u32>(select(0i, _e2079, (_e2079 > 0i)))];
let _e2092 = ((_e2073 >> bitcast<u32>((_e2065 & 31u))) | ((_e2085 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2065) & 31u))));
let _e2095 = f32(bitcast<i32>((_e2092 & 65535u)));
let _e2105 = (_e1970 + (((_e2007 + ((f32(bitcast<i32>((_e2004 >> bitcast<u32>(16i)))) - _e2007) * _e1923)) - _e1970) * _e1925));
phi_3084_ = (_e2105 + (((_e2058 + (((_e2095 + ((f32(bitcast<i32>((_e2092 >> bitcast<u32>(16i)))) - _e2095) * _e1923)) - _e2058) * _e1925)) - _e2105) * (_e1793 - f32(_e1844))));
} else {
phi_3084_ = 0f;
}
let _e2113 = phi_3084_;
phi_2646_ = (_e1772 - 1i);
phi_2649_ = select(_e1774, _e1772, (_e2113 > 32767.5f));
} else {
phi_2646_ = i32();
phi_2649_ = i32();
}
let _e2118 = phi_2646_;
let _e2120 = phi_2649_;
continue;
continuing {
phi_2645_ = _e2118;
phi_2648_ = _e2120;
break if !(_e1775);
}
}
let _e2123 = local_8;
let _e2126 = local_9;
local = select(_e799.member_7, _e2126, (_e2123 < _e799.member_7));
local_1 = (_e799.member + vec3<f32>(_e1759, _e1762, _e1765));
let _e2131 = local;
let _e2132 = local_1[0u];
let _e2134 = local_1[1u];
let _e2136 = local_1[2u];
let _e2140 = global_1.member.member_1[0u];
let _e2144 = global_1.member.member_1[1u];
let _e2148 = global_1.member.member_1[2u];
let _e2150 = ((_e2132 + -1f) - 0.5f);
let _e2151 = ((_e2134 + 0f) - 0.5f);
let _e2152 = ((_e2136 + 0f) - 0.5f);
let _e2154 = f32((bitcast<i32>(_e2140) - 2i));
let _e2156 = select(0f, _e2150, (_e2150 > 0f));
let _e2158 = select(_e2154, _e2156, (_e2156 < _e2154));
let _e2165 = select(0i, select(select(i32(_e2158), i32(-2147483648), (_e2158 < -2147483600f)), 2147483647i, (_e2158 > 2147483500f)), (_e2158 == _e2158));
let _e2169 = (_e2165 - select(0i, 1i, (_e2158 < f32(_e2165))));
let _e2171 = f32((bitcast<i32>(_e2144) - 2i));
let _e2173 = select(0f, _e2151, (_e2151 > 0f));
let _e2175 = select(_e2171, _e2173, (_e2173 < _e2171));
let _e2182 = select(0i, select(select(i32(_e2175), i32(-2147483648), (_e2175 < -2147483600f)), 2147483647i, (_e2175 > 2147483500f)), (_e2175 == _e2175));
let _e2186 = (_e2182 - select(0i, 1i, (_e2175 < f32(_e2182))));
let _e2188 = f32((bitcast<i32>(_e2148) - 2i));
let _e2190 = select(0f, _e2152, (_e2152 > 0f));
let _e2192 = select(_e2188, _e2190, (_e2190 < _e2188));
let _e2199 = select(0i, select(select(i32(_e2192), i32(-2147483648), (_e2192 < -2147483600f)), 2147483647i, (_e2192 > 2147483500f)), (_e2192 == _e2192));
let _e2203 = (_e2199 - select(0i, 1i, (_e2192 < f32(_e2199))));
let _e2204 = (_e2131 * 4i);
let _e2205 = (_e2204 + 1i);
let _e2207 = (bitcast<i32>(_e91) - 1i);
let _e2209 = select(_e2207, _e2205, (_e2205 < _e2207));
let _e2214 = global_5.member[bitcast<u32>(select(0i, _e2209, (_e2209 > 0i)))];
let _e2215 = (_e2204 + 2i);
let _e2217 = select(_e2207, _e2215, (_e2215 < _e2207));
let _e2222 = global_5.member[bitcast<u32>(select(0i, _e2217, (_e2217 > 0i)))];
let _e2223 = (_e2204 + 3i);
let _e2225 = select(_e2207, _e2223, (_e2223 < _e2207));
let _e2230 = global_5.member[bitcast<u32>(select(0i, _e2225, (_e2225 > 0i)))];
let _e2233 = (_e2169 - bitcast<i32>((_e2214 & 65535u)));
let _e2238 = bitcast<i32>((_e2214 >> bitcast<u32>(16i)));
let _e2243 = (_e2186 - bitcast<i32>((_e2222 & 65535u)));
let _e2248 = bitcast<i32>((_e2222 >> bitcast<u32>(16i)));
let _e2253 = (_e2203 - bitcast<i32>((_e2230 & 65535u)));
if ((((_e2233 >= 0i) && ((_e2233 + 1i) < _e2238)) && ((_e2243 >= 0i) && ((_e2243 + 1i) < _e2248))) && ((_e2253 >= 0i) && ((_e2253 + 1i) < bitcast<i32>((_e2230 >> bitcast<u32>(16i)))))) {
let _e2263 = (_e2248 * _e2238);
let _e2265 = select(_e2207, _e2204, (_e2204 < _e2207));
let _e2270 = global_5.member[bitcast<u32>(select(0i, _e2265, (_e2265 > 0i)))];
let _e2276 = (((bitcast<i32>(_e2270) + (_e2253 * _e2263)) + (_e2243 * _e2238)) + _e2233);
let _e2278 = (_e2150 - f32(_e2169));
let _e2280 = (_e2151 - f32(_e2186));
let _e2283 = (2i * _e2276);
let _e2285 = (_e2283 >> bitcast<u32>(2i));
let _e2288 = bitcast<u32>(((_e2283 & 3i) * 8i));
let _e2290 = select(_e2207, _e2285, (_e2285 < _e2207));
let _e2295 = global_5.member[bitcast<u32>(select(0i, _e2290, (_e2290 > 0i)))];
let _e2299 = (_e2285 + 1i);
let _e2301 = select(_e2207, _e2299, (_e2299 < _e2207));
let _e2306 = global_5.member[bitcast<u32>(select(0i, _e2301, (_e2301 > 0i)))];
let _e2313 = ((_e2295 >> bitcast<u32>((_e2288 & 31u))) | ((_e2306 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2288) & 31u))));
let _e2316 = f32(bitcast<i32>((_e2313 & 65535u)));
let _e2323 = (_e2316 + ((f32(bitcast<i32>((_e2313 >> bitcast<u32>(16i)))) - _e2316) * _e2278));
let _e2325 = (2i * (_e2276 + _e2238));
let _e2327 = (_e2325 >> bitcast<u32>(2i));
let _e2330 = bitcast<u32>(((_e2325 & 3i) * 8i));
let _e2332 = select(_e2207, _e2327, (_e2327 < _e2207));
let _e2337 = global_5.member[bitcast<u32>(select(0i, _e2332, (_e2332 > 0i)))];
let _e2341 = (_e2327 + 1i);
let _e2343 = select(_e2207, _e2341, (_e2341 < _e2207));
let _e2348 = global_5.member[bitcast<u32>(select(0i, _e2343, (_e2343 > 0i)))];
let _e2355 = ((_e2337 >> bitcast<u32>((_e2330 & 31u))) | ((_e2348 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2330) & 31u))));
let _e2358 = f32(bitcast<i32>((_e2355 & 65535u)));
let _e2366 = (_e2276 + _e2263);
let _e2367 = (2i * _e2366);
let _e2369 = (_e2367 >> bitcast<u32>(2i));
let _e2372 = bitcast<u32>(((_e2367 & 3i) * 8i));
let _e2374 = select(_e2207, _e2369, (_e2369 < _e2207));
let _e2379 = global_5.member[bitcast<u32>(select(0i, _e2374, (_e2374 > 0i)))];
let _e2383 = (_e2369 + 1i);
let _e2385 = select(_e2207, _e2383, (_e2383 < _e2207));
let _e2390 = global_5.member[bitcast<u32>(select(0i, _e2385, (_e2385 > 0i)))];
let _e2397 = ((_e2379 >> bitcast<u32>((_e2372 & 31u))) | ((_e2390 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2372) & 31u))));
let _e2400 = f32(bitcast<i32>((_e2397 & 65535u)));
let _e2407 = (_e2400 + ((f32(bitcast<i32>((_e2397 >> bitcast<u32>(16i)))) - _e2400) * _e2278));
let _e2409 = (2i * (_e2366 + _e2238));
let _e2411 = (_e2409 >> bitcast<u32>(2i));
let _e2414 = bitcast<u32>(((_e2409 & 3i) * 8i));
let _e2416 = select(_e2207, _e2411, (_e2411 < _e2207));
let _e2421 = global_5.member[bitcast<u32>(select(0i, _e2416, (_e2416 > 0i)))];
let _e2425 = (_e2411 + 1i);
let _e2427 = select(_e2207, _e2425, (_e2425 < _e2207));
let _e2432 = global_5.member[bitcast<u32>(select(0i, _e2427, (_e2427 > 0i)))];
let _e2439 = ((_e2421 >> bitcast<u32>((_e2414 & 31u))) | ((_e2432 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2414) & 31u))));
let _e2442 = f32(bitcast<i32>((_e2439 & 65535u)));
let _e2452 = (_e2323 + (((_e2358 + ((f32(bitcast<i32>((_e2355 >> bitcast<u32>(16i)))) - _e2358) * _e2278)) - _e2323) * _e2280));
phi_3544_ = (_e2452 + (((_e2407 + (((_e2442 + ((f32(bitcast<i32>((_e2439 >> bitcast<u32>(16i)))) - _e2442) * _e2278)) - _e2407) * _e2280)) - _e2452) * (_e2152 - f32(_e2203))));
} else {
phi_3544_ = 0f;
}
let _e2460 = phi_3544_;
let _e2461 = local;
let _e2462 = local_1[0u];
let _e2464 = local_1[1u];
let _e2466 = local_1[2u];
let _e2468 = ((_e2462 + 1f) - 0.5f);
let _e2469 = ((_e2464 + 0f) - 0.5f);
let _e2470 = ((_e2466 + 0f) - 0.5f);
let _e2472 = select(0f, _e2468, (_e2468 > 0f));
let _e2474 = select(_e2154, _e2472, (_e2472 < _e2154));
let _e2481 = select(0i, select(select(i32(_e2474), i32(-2147483648), (_e2474 < -2147483600f)), 2147483647i, (_e2474 > 2147483500f)), (_e2474 == _e2474));
let _e2485 = (_e2481 - select(0i, 1i, (_e2474 < f32(_e2481))));
let _e2487 = select(0f, _e2469, (_e2469 > 0f));
let _e2489 = select(_e2171, _e2487, (_e2487 < _e2171));
let _e2496 = select(0i, select(select(i32(_e2489), i32(-2147483648), (_e2489 < -2147483600f)), 2147483647i, (_e2489 > 2147483500f)), (_e2489 == _e2489));
let _e2500 = (_e2496 - select(0i, 1i, (_e2489 < f32(_e2496))));
let _e2502 = select(0f, _e2470, (_e2470 > 0f));
let _e2504 = select(_e2188, _e2502, (_e2502 < _e2188));
let _e2511 = select(0i, select(select(i32(_e2504), i32(-2147483648), (_e2504 < -2147483600f)), 2147483647i, (_e2504 > 2147483500f)), (_e2504 == _e2504));
let _e2515 = (_e2511 - select(0i, 1i, (_e2504 < f32(_e2511))));
let _e2516 = (_e2461 * 4i);
let _e2517 = (_e2516 + 1i);
let _e2519 = select(_e2207, _e2517, (_e2517 < _e2207));
let _e2524 = global_5.member[bitcast<u32>(select(0i, _e2519, (_e2519 > 0i)))];
let _e2525 = (_e2516 + 2i);
let _e2527 = select(_e2207, _e2525, (_e2525 < _e2207));
let _e2532 = global_5.member[bitcast<u32>(select(0i, _e2527, (_e2527 > 0i)))];
let _e2533 = (_e2516 + 3i);
let _e2535 = select(_e2207, _e2533, (_e2533 < _e2207));
let _e2540 = global_5.member[bitcast<u32>(select(0i, _e2535, (_e2535 > 0i)))];
let _e2543 = (_e2485 - bitcast<i32>((_e2524 & 65535u)));
let _e2548 = bitcast<i32>((_e2524 >> bitcast<u32>(16i)));
let _e2553 = (_e2500 - bitcast<i32>((_e2532 & 65535u)));
let _e2558 = bitcast<i32>((_e2532 >> bitcast<u32>(16i)));
let _e2563 = (_e2515 - bitcast<i32>((_e2540 & 65535u)));
if ((((_e2543 >= 0i) && ((_e2543 + 1i) < _e2548)) && ((_e2553 >= 0i) && ((_e2553 + 1i) < _e2558))) && ((_e2563 >= 0i) && ((_e2563 + 1i) < bitcast<i32>((_e2540 >> bitcast<u32>(16i)))))) {
let _e2573 = (_e2558 * _e2548);
let _e2575 = select(_e2207, _e2516, (_e2516 < _e2207));
let _e2580 = global_5.member[bitcast<u32>(select(0i, _e2575, (_e2575 > 0i)))];
let _e2586 = (((bitcast<i32>(_e2580) + (_e2563 * _e2573)) + (_e2553 * _e2548)) + _e2543);
let _e2588 = (_e2468 - f32(_e2485));
let _e2590 = (_e2469 - f32(_e2500));
let _e2593 = (2i * _e2586);
let _e2595 = (_e2593 >> bitcast<u32>(2i));
let _e2598 = bitcast<u32>(((_e2593 & 3i) * 8i));
let _e2600 = select(_e2207, _e2595, (_e2595 < _e2207));
let _e2605 = global_5.member[bitcast<u32>(select(0i, _e2600, (_e2600 > 0i)))];
let _e2609 = (_e2595 + 1i);
let _e2611 = select(_e2207, _e2609, (_e2609 < _e2207));
let _e2616 = global_5.member[bitcast<u32>(select(0i, _e2611, (_e2611 > 0i)))];
let _e2623 = ((_e2605 >> bitcast<u32>((_e2598 & 31u))) | ((_e2616 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2598) & 31u))));
let _e2626 = f32(bitcast<i32>((_e2623 & 65535u)));
let _e2633 = (_e2626 + ((f32(bitcast<i32>((_e2623 >> bitcast<u32>(16i)))) - _e2626) * _e2588));
let _e2635 = (2i * (_e2586 + _e2548));
let _e2637 = (_e2635 >> bitcast<u32>(2i));
let _e2640 = bitcast<u32>(((_e2635 & 3i) * 8i));
let _e2642 = select(_e2207, _e2637, (_e2637 < _e2207));
let _e2647 = global_5.member[bitcast<u32>(select(0i, _e2642, (_e2642 > 0i)))];
let _e2651 = (_e2637 + 1i);
let _e2653 = select(_e2207, _e2651, (_e2651 < _e2207));
let _e2658 = global_5.member[bitcast<u32>(select(0i, _e2653, (_e2653 > 0i)))];
let _e2665 = ((_e2647 >> bitcast<u32>((_e2640 & 31u))) | ((_e2658 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2640) & 31u))));
let _e2668 = f32(bitcast<i32>((_e2665 & 65535u)));
let _e2676 = (_e2586 + _e2573);
let _e2677 = (2i * _e2676);
let _e2679 = (_e2677 >> bitcast<u32>(2i));
let _e2682 = bitcast<u32>(((_e2677 & 3i) * 8i));
let _e2684 = select(_e2207, _e2679, (_e2679 < _e2207));
let _e2689 = global_5.member[bitcast<u32>(select(0i, _e2684, (_e2684 > 0i)))];
let _e2693 = (_e2679 + 1i);
let _e2695 = select(_e2207, _e2693, (_e2693 < _e2207));
let _e2700 = global_5.member[bitcast<u32>(select(0i, _e2695, (_e2695 > 0i)))];
let _e2707 = ((_e2689 >> bitcast<u32>((_e2682 & 31u))) | ((_e2700 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2682) & 31u))));
let _e2710 = f32(bitcast<i32>((_e2707 & 65535u)));
let _e2717 = (_e2710 + ((f32(bitcast<i32>((_e2707 >> bitcast<u32>(16i)))) - _e2710) * _e2588));
let _e2719 = (2i * (_e2676 + _e2548));
let _e2721 = (_e2719 >> bitcast<u32>(2i));
let _e2724 = bitcast<u32>(((_e2719 & 3i) * 8i));
let _e2726 = select(_e2207, _e2721, (_e2721 < _e2207));
let _e2731 = global_5.member[bitcast<u32>(select(0i, _e2726, (_e2726 > 0i)))];
let _e2735 = (_e2721 + 1i);
let _e2737 = select(_e2207, _e2735, (_e2735 < _e2207));
let _e2742 = global_5.member[bitcast<u32>(select(0i, _e2737, (_e2737 > 0i)))];
let _e2749 = ((_e2731 >> bitcast<u32>((_e2724 & 31u))) | ((_e2742 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2724) & 31u))));
let _e2752 = f32(bitcast<i32>((_e2749 & 65535u)));
let _e2762 = (_e2633 + (((_e2668 + ((f32(bitcast<i32>((_e2665 >> bitcast<u32>(16i)))) - _e2668) * _e2588)) - _e2633) * _e2590));
phi_3983_ = (_e2762 + (((_e2717 + (((_e2752 + ((f32(bitcast<i32>((_e2749 >> bitcast<u32>(16i)))) - _e2752) * _e2588)) - _e2717) * _e2590)) - _e2762) * (_e2470 - f32(_e2515))));
} else {
phi_3983_ = 0f;
}
let _e2770 = phi_3983_;
let _e2771 = (_e2460 - _e2770);
let _e2772 = local;
let _e2773 = local_1[0u];
let _e2775 = local_1[1u];
let _e2777 = local_1[2u];
let _e2779 = ((_e2773 + 0f) - 0.5f);
let _e2780 = ((_e2775 + -1f) - 0.5f);
let _e2781 = ((_e2777 + 0f) - 0.5f);
let _e2783 = select(0f, _e2779, (_e2779 > 0f));
let _e2785 = select(_e2154, _e2783, (_e2783 < _e2154));
let _e2792 = select(0i, select(select(i32(_e2785), i32(-2147483648), (_e2785 < -2147483600f)), 2147483647i, (_e2785 > 2147483500f)), (_e2785 == _e2785));
let _e2796 = (_e2792 - select(0i, 1i, (_e2785 < f32(_e2792))));
let _e2798 = select(0f, _e2780, (_e2780 > 0f));
let _e2800 = select(_e2171, _e2798, (_e2798 < _e2171));
let _e2807 = select(0i, select(select(i32(_e2800), i32(-2147483648), (_e2800 < -2147483600f)), 2147483647i, (_e2800 > 2147483500f)), (_e2800 == _e2800));
let _e2811 = (_e2807 - select(0i, 1i, (_e2800 < f32(_e2807))));
let _e2813 = select(0f, _e2781, (_e2781 > 0f));
let _e2815 = select(_e2188, _e2813, (_e2813 < _e2188));
let _e2822 = select(0i, select(select(i32(_e2815), i32(-2147483648), (_e2815 < -2147483600f)), 2147483647i, (_e2815 > 2147483500f)), (_e2815 == _e2815));
let _e2826 = (_e2822 - select(0i, 1i, (_e2815 < f32(_e2822))));
let _e2827 = (_e2772 * 4i);
let _e2828 = (_e2827 + 1i);
let _e2830 = select(_e2207, _e2828, (_e2828 < _e2207));
let _e2835 = global_5.member[bitcast<u32>(select(0i, _e2830, (_e2830 > 0i)))];
let _e2836 = (_e2827 + 2i);
let _e2838 = select(_e2207, _e2836, (_e2836 < _e2207));
let _e2843 = global_5.member[bitcast<u32>(select(0i, _e2838, (_e2838 > 0i)))];
let _e2844 = (_e2827 + 3i);
let _e2846 = select(_e2207, _e2844, (_e2844 < _e2207));
let _e2851 = global_5.member[bitcast<u32>(select(0i, _e2846, (_e2846 > 0i)))];
let _e2854 = (_e2796 - bitcast<i32>((_e2835 & 65535u)));
let _e2859 = bitcast<i32>((_e2835 >> bitcast<u32>(16i)));
let _e2864 = (_e2811 - bitcast<i32>((_e2843 & 65535u)));
let _e2869 = bitcast<i32>((_e2843 >> bitcast<u32>(16i)));
let _e2874 = (_e2826 - bitcast<i32>((_e2851 & 65535u)));
if ((((_e2854 >= 0i) && ((_e2854 + 1i) < _e2859)) && ((_e2864 >= 0i) && ((_e2864 + 1i) < _e2869))) && ((_e2874 >= 0i) && ((_e2874 + 1i) < bitcast<i32>((_e2851 >> bitcast<u32>(16i)))))) {
let _e2884 = (_e2869 * _e2859);
let _e2886 = select(_e2207, _e2827, (_e2827 < _e2207));
let _e2891 = global_5.member[bitcast<u32>(select(0i, _e2886, (_e2886 > 0i)))];
let _e2897 = (((bitcast<i32>(_e2891) + (_e2874 * _e2884)) + (_e2864 * _e2859)) + _e2854);
let _e2899 = (_e2779 - f32(_e2796));
let _e2901 = (_e2780 - f32(_e2811));
let _e2904 = (2i * _e2897);
let _e2906 = (_e2904 >> bitcast<u32>(2i));
let _e2909 = bitcast<u32>(((_e2904 & 3i) * 8i));
let _e2911 = select(_e2207, _e2906, (_e2906 < _e2207));
let _e2916 = global_5.member[bitcast<u32>(select(0i, _e2911, (_e2911 > 0i)))];
let _e2920 = (_e2906 + 1i);
let _e2922 = select(_e2207, _e2920, (_e2920 < _e2207));
let _e2927 = global_5.member[bitcast<u32>(select(0i, _e2922, (_e2922 > 0i)))];
let _e2934 = ((_e2916 >> bitcast<u32>((_e2909 & 31u))) | ((_e2927 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2909) & 31u))));
let _e2937 = f32(bitcast<i32>((_e2934 & 65535u)));
let _e2944 = (_e2937 + ((f32(bitcast<i32>((_e2934 >> bitcast<u32>(16i)))) - _e2937) * _e2899));
let _e2946 = (2i * (_e2897 + _e2859));
let _e2948 = (_e2946 >> bitcast<u32>(2i));
let _e2951 = bitcast<u32>(((_e2946 & 3i) * 8i));
let _e2953 = select(_e2207, _e2948, (_e2948 < _e2207));
let _e2958 = global_5.member[bitcast<u32>(select(0i, _e2953, (_e2953 > 0i)))];
let _e2962 = (_e2948 + 1i);
let _e2964 = select(_e2207, _e2962, (_e2962 < _e2207));
let _e2969 = global_5.member[bitcast<u32>(select(0i, _e2964, (_e2964 > 0i)))];
let _e2976 = ((_e2958 >> bitcast<u32>((_e2951 & 31u))) | ((_e2969 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2951) & 31u))));
let _e2979 = f32(bitcast<i32>((_e2976 & 65535u)));
let _e2987 = (_e2897 + _e2884);
let _e2988 = (2i * _e2987);
let _e2990 = (_e2988 >> bitcast<u32>(2i));
let _e2993 = bitcast<u32>(((_e2988 & 3i) * 8i));
let _e2995 = select(_e2207, _e2990, (_e2990 < _e2207));
let _e3000 = global_5.member[bitcast<u32>(select(0i, _e2995, (_e2995 > 0i)))];
let _e3004 = (_e2990 + 1i);
let _e3006 = select(_e2207, _e3004, (_e3004 < _e2207));
let _e3011 = global_5.member[bitcast<u32>(select(0i, _e3006, (_e3006 > 0i)))];
let _e3018 = ((_e3000 >> bitcast<u32>((_e2993 & 31u))) | ((_e3011 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2993) & 31u))));
let _e3021 = f32(bitcast<i32>((_e3018 & 65535u)));
let _e3028 = (_e3021 + ((f32(bitcast<i32>((_e3018 >> bitcast<u32>(16i)))) - _e3021) * _e2899));
let _e3030 = (2i * (_e2987 + _e2859));
let _e3032 = (_e3030 >> bitcast<u32>(2i));
let _e3035 = bitcast<u32>(((_e3030 & 3i) * 8i));
let _e3037 = select(_e2207, _e3032, (_e3032 < _e2207));
let _e3042 = global_5.member[bitcast<u32>(select(0i, _e3037, (_e3037 > 0i)))];
let _e3046 = (_e3032 + 1i);
let _e3048 = select(_e2207, _e3046, (_e3046 < _e2207));
let _e3053 = global_5.member[bitcast<u32>(select(0i, _e3048, (_e3048 > 0i)))];
let _e3060 = ((_e3042 >> bitcast<u32>((_e3035 & 31u))) | ((_e3053 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3035) & 31u))));
let _e3063 = f32(bitcast<i32>((_e3060 & 65535u)));
let _e3073 = (_e2944 + (((_e2979 + ((f32(bitcast<i32>((_e2976 >> bitcast<u32>(16i)))) - _e2979) * _e2899)) - _e2944) * _e2901));
phi_4423_ = (_e3073 + (((_e3028 + (((_e3063 + ((f32(bitcast<i32>((_e3060 >> bitcast<u32>(16i)))) - _e3063) * _e2899)) - _e3028) * _e2901)) - _e3073) * (_e2781 - f32(_e2826))));
} else {
phi_4423_ = 0f;
}
let _e3081 = phi_4423_;
let _e3082 = local;
let _e3083 = local_1[0u];
let _e3085 = local_1[1u];
let _e3087 = local_1[2u];
let _e3089 = ((_e3083 + 0f) - 0.5f);
let _e3090 = ((_e3085 + 1f) - 0.5f);
let _e3091 = ((_e3087 + 0f) - 0.5f);
let _e3093 = select(0f, _e3089, (_e3089 > 0f));
let _e3095 = select(_e2154, _e3093, (_e3093 < _e2154));
let _e3102 = select(0i, select(select(i32(_e3095), i32(-2147483648), (_e3095 < -2147483600f)), 2147483647i, (_e3095 > 2147483500f)), (_e3095 == _e3095));
let _e3106 = (_e3102 - select(0i, 1i, (_e3095 < f32(_e3102))));
let _e3108 = select(0f, _e3090, (_e3090 > 0f));
let _e3110 = select(_e2171, _e3108, (_e3108 < _e2171));
let _e3117 = select(0i, select(select(i32(_e3110), i32(-2147483648), (_e3110 < -2147483600f)), 2147483647i, (_e3110 > 2147483500f)), (_e3110 == _e3110));
let _e3121 = (_e3117 - select(0i, 1i, (_e3110 < f32(_e3117))));
let _e3123 = select(0f, _e3091, (_e3091 > 0f));
let _e3125 = select(_e2188, _e3123, (_e3123 < _e2188));
let _e3132 = select(0i, select(select(i32(_e3125), i32(-2147483648), (_e3125 < -2147483600f)), 2147483647i, (_e3125 > 2147483500f)), (_e3125 == _e3125));
let _e3136 = (_e3132 - select(0i, 1i, (_e3125 < f32(_e3132))));
let _e3137 = (_e3082 * 4i);
let _e3138 = (_e3137 + 1i);
let _e3140 = select(_e2207, _e3138, (_e3138 < _e2207));
let _e3145 = global_5.member[bitcast<u32>(select(0i, _e3140, (_e3140 > 0i)))];
let _e3146 = (_e3137 + 2i);
let _e3148 = select(_e2207, _e3146, (_e3146 < _e2207));
let _e3153 = global_5.member[bitcast<u32>(select(0i, _e3148, (_e3148 > 0i)))];
let _e3154 = (_e3137 + 3i);
let _e3156 = select(_e2207, _e3154, (_e3154 < _e2207));
let _e3161 = global_5.member[bitcast<u32>(select(0i, _e3156, (_e3156 > 0i)))];
let _e3164 = (_e3106 - bitcast<i32>((_e3145 & 65535u)));
let _e3169 = bitcast<i32>((_e3145 >> bitcast<u32>(16i)));
let _e3174 = (_e3121 - bitcast<i32>((_e3153 & 65535u)));
let _e3179 = bitcast<i32>((_e3153 >> bitcast<u32>(16i)));
let _e3184 = (_e3136 - bitcast<i32>((_e3161 & 65535u)));
if ((((_e3164 >= 0i) && ((_e3164 + 1i) < _e3169)) && ((_e3174 >= 0i) && ((_e3174 + 1i) < _e3179))) && ((_e3184 >= 0i) && ((_e3184 + 1i) < bitcast<i32>((_e3161 >> bitcast<u32>(16i)))))) {
let _e3194 = (_e3179 * _e3169);
let _e3196 = select(_e2207, _e3137, (_e3137 < _e2207));
let _e3201 = global_5.member[bitcast<u32>(select(0i, _e3196, (_e3196 > 0i)))];
let _e3207 = (((bitcast<i32>(_e3201) + (_e3184 * _e3194)) + (_e3174 * _e3169)) + _e3164);
let _e3209 = (_e3089 - f32(_e3106));
let _e3211 = (_e3090 - f32(_e3121));
let _e3214 = (2i * _e3207);
let _e3216 = (_e3214 >> bitcast<u32>(2i));
let _e3219 = bitcast<u32>(((_e3214 & 3i) * 8i));
let _e3221 = select(_e2207, _e3216, (_e3216 < _e2207));
let _e3226 = global_5.member[bitcast<u32>(select(0i, _e3221, (_e3221 > 0i)))];
let _e3230 = (_e3216 + 1i);
let _e3232 = select(_e2207, _e3230, (_e3230 < _e2207));
let _e3237 = global_5.member[bitcast<u32>(select(0i, _e3232, (_e3232 > 0i)))];
let _e3244 = ((_e3226 >> bitcast<u32>((_e3219 & 31u))) | ((_e3237 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3219) & 31u))));
let _e3247 = f32(bitcast<i32>((_e3244 & 65535u)));
let _e3254 = (_e3247 + ((f32(bitcast<i32>((_e3244 >> bitcast<u32>(16i)))) - _e3247) * _e3209));
let _e3256 = (2i * (_e3207 + _e3169));
let _e3258 = (_e3256 >> bitcast<u32>(2i));
let _e3261 = bitcast<u32>(((_e3256 & 3i) * 8i));
let _e3263 = select(_e2207, _e3258, (_e3258 < _e2207));
let _e3268 = global_5.member[bitcast<u32>(select(0i, _e3263, (_e3263 > 0i)))];
let _e3272 = (_e3258 + 1i);
let _e3274 = select(_e2207, _e3272, (_e3272 < _e2207));
let _e3279 = global_5.member[bitcast<u32>(select(0i, _e3274, (_e3274 > 0i)))];
let _e3286 = ((_e3268 >> bitcast<u32>((_e3261 & 31u))) | ((_e3279 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3261) & 31u))));
let _e3289 = f32(bitcast<i32>((_e3286 & 65535u)));
let _e3297 = (_e3207 + _e3194);
let _e3298 = (2i * _e3297);
let _e3300 = (_e3298 >> bitcast<u32>(2i));
let _e3303 = bitcast<u32>(((_e3298 & 3i) * 8i));
let _e3305 = select(_e2207, _e3300, (_e3300 < _e2207));
let _e3310 = global_5.member[bitcast<u32>(select(0i, _e3305, (_e3305 > 0i)))];
let _e3314 = (_e3300 + 1i);
let _e3316 = select(_e2207, _e3314, (_e3314 < _e2207));
let _e3321 = global_5.member[bitcast<u32>(select(0i, _e3316, (_e3316 > 0i)))];
let _e3328 = ((_e3310 >> bitcast<u32>((_e3303 & 31u))) | ((_e3321 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3303) & 31u))));
let _e3331 = f32(bitcast<i32>((_e3328 & 65535u)));
let _e3338 = (_e3331 + ((f32(bitcast<i32>((_e3328 >> bitcast<u32>(16i)))) - _e3331) * _e3209));
let _e3340 = (2i * (_e3297 + _e3169));
let _e3342 = (_e3340 >> bitcast<u32>(2i));
let _e3345 = bitcast<u32>(((_e3340 & 3i) * 8i));
let _e3347 = select(_e2207, _e3342, (_e3342 < _e2207));
let _e3352 = global_5.member[bitcast<u32>(select(0i, _e3347, (_e3347 > 0i)))];
let _e3356 = (_e3342 + 1i);
let _e3358 = select(_e2207, _e3356, (_e3356 < _e2207));
let _e3363 = global_5.member[bitcast<u32>(select(0i, _e3358, (_e3358 > 0i)))];
let _e3370 = ((_e3352 >> bitcast<u32>((_e3345 & 31u))) | ((_e3363 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3345) & 31u))));
let _e3373 = f32(bitcast<i32>((_e3370 & 65535u)));
let _e3383 = (_e3254 + (((_e3289 + ((f32(bitcast<i32>((_e3286 >> bitcast<u32>(16i)))) - _e3289) * _e3209)) - _e3254) * _e3211));
phi_4862_ = (_e3383 + (((_e3338 + (((_e3373 + ((f32(bitcast<i32>((_e3370 >> bitcast<u32>(16i)))) - _e3373) * _e3209)) - _e3338) * _e3211)) - _e3383) * (_e3091 - f32(_e3136))));
} else {
phi_4862_ = 0f;
}
let _e3391 = phi_4862_;
let _e3392 = (_e3081 - _e3391);
let _e3393 = local;
let _e3394 = local_1[0u];
let _e3396 = local_1[1u];
let _e3398 = local_1[2u];
let _e3400 = ((_e3394 + 0f) - 0.5f);
let _e3401 = ((_e3396 + 0f) - 0.5f);
let _e3402 = ((_e3398 + -1f) - 0.5f);
let _e3404 = select(0f, _e3400, (_e3400 > 0f));
let _e3406 = select(_e2154, _e3404, (_e3404 < _e2154));
let _e3413 = select(0i, select(select(i32(_e3406), i32(-2147483648), (_e3406 < -2147483600f)), 2147483647i, (_e3406 > 2147483500f)), (_e3406 == _e3406));
let _e3417 = (_e3413 - select(0i, 1i, (_e3406 < f32(_e3413))));
let _e3419 = select(0f, _e3401, (_e3401 > 0f));
let _e3421 = select(_e2171, _e3419, (_e3419 < _e2171));
let _e3428 = select(0i, select(select(i32(_e3421), i32(-2147483648), (_e3421 < -2147483600f)), 2147483647i, (_e3421 > 2147483500f)), (_e3421 == _e3421));
let _e3432 = (_e3428 - select(0i, 1i, (_e3421 < f32(_e3428))));
let _e3434 = select(0f, _e3402, (_e3402 > 0f));
let _e3436 = select(_e2188, _e3434, (_e3434 < _e2188));
let _e3443 = select(0i, select(select(i32(_e3436), i32(-2147483648), (_e3436 < -2147483600f)), 2147483647i, (_e3436 > 2147483500f)), (_e3436 == _e3436));
let _e3447 = (_e3443 - select(0i, 1i, (_e3436 < f32(_e3443))));
let _e3448 = (_e3393 * 4i);
let _e3449 = (_e3448 + 1i);
let _e3451 = select(_e2207, _e3449, (_e3449 < _e2207));
let _e3456 = global_5.member[bitcast<u32>(select(0i, _e3451, (_e3451 > 0i)))];
let _e3457 = (_e3448 + 2i);
let _e3459 = select(_e2207, _e3457, (_e3457 < _e2207));
let _e3464 = global_5.member[bitcast<u32>(select(0i, _e3459, (_e3459 > 0i)))];
let _e3465 = (_e3448 + 3i);
let _e3467 = select(_e2207, _e3465, (_e3465 < _e2207));
let _e3472 = global_5.member[bitcast<u32>(select(0i, _e3467, (_e3467 > 0i)))];
let _e3475 = (_e3417 - bitcast<i32>((_e3456 & 65535u)));
let _e3480 = bitcast<i32>((_e3456 >> bitcast<u32>(16i)));
let _e3485 = (_e3432 - bitcast<i32>((_e3464 & 65535u)));
let _e3490 = bitcast<i32>((_e3464 >> bitcast<u32>(16i)));
let _e3495 = (_e3447 - bitcast<i32>((_e3472 & 65535u)));
if ((((_e3475 >= 0i) && ((_e3475 + 1i) < _e3480)) && ((_e3485 >= 0i) && ((_e3485 + 1i) < _e3490))) && ((_e3495 >= 0i) && ((_e3495 + 1i) < bitcast<i32>((_e3472 >> bitcast<u32>(16i)))))) {
let _e3505 = (_e3490 * _e3480);
let _e3507 = select(_e2207, _e3448, (_e3448 < _e2207));
let _e3512 = global_5.member[bitcast<u32>(select(0i, _e3507, (_e3507 > 0i)))];
let _e3518 = (((bitcast<i32>(_e3512) + (_e3495 * _e3505)) + (_e3485 * _e3480)) + _e3475);
let _e3520 = (_e3400 - f32(_e3417));
let _e3522 = (_e3401 - f32(_e3432));
let _e3525 = (2i * _e3518);
let _e3527 = (_e3525 >> bitcast<u32>(2i));
let _e3530 = bitcast<u32>(((_e3525 & 3i) * 8i));
let _e3532 = select(_e2207, _e3527, (_e3527 < _e2207));
let _e3537 = global_5.member[bitcast<u32>(select(0i, _e3532, (_e3532 > 0i)))];
let _e3541 = (_e3527 + 1i);
let _e3543 = select(_e2207, _e3541, (_e3541 < _e2207));
let _e3548 = global_5.member[bitcast<u32>(select(0i, _e3543, (_e3543 > 0i)))];
let _e3555 = ((_e3537 >> bitcast<u32>((_e3530 & 31u))) | ((_e3548 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3530) & 31u))));
let _e3558 = f32(bitcast<i32>((_e3555 & 65535u)));
let _e3565 = (_e3558 + ((f32(bitcast<i32>((_e3555 >> bitcast<u32>(16i)))) - _e3558) * _e3520));
let _e3567 = (2i * (_e3518 + _e3480));
let _e3569 = (_e3567 >> bitcast<u32>(2i));
let _e3572 = bitcast<u32>(((_e3567 & 3i) * 8i));
let _e3574 = select(_e2207, _e3569, (_e3569 < _e2207));
let _e3579 = global_5.member[bitcast<u32>(select(0i, _e3574, (_e3574 > 0i)))];
let _e3583 = (_e3569 + 1i);
let _e3585 = select(_e2207, _e3583, (_e3583 < _e2207));
let _e3590 = global_5.member[bitcast<u32>(select(0i, _e3585, (_e3585 > 0i)))];
let _e3597 = ((_e3579 >> bitcast<u32>((_e3572 & 31u))) | ((_e3590 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3572) & 31u))));
let _e3600 = f32(bitcast<i32>((_e3597 & 65535u)));
let _e3608 = (_e3518 + _e3505);
let _e3609 = (2i * _e3608);
let _e3611 = (_e3609 >> bitcast<u32>(2i));
let _e3614 = bitcast<u32>(((_e3609 & 3i) * 8i));
let _e3616 = select(_e2207, _e3611, (_e3611 < _e2207));
let _e3621 = global_5.member[bitcast<u32>(select(0i, _e3616, (_e3616 > 0i)))];
let _e3625 = (_e3611 + 1i);
let _e3627 = select(_e2207, _e3625, (_e3625 < _e2207));
let _e3632 = global_5.member[bitcast<u32>(select(0i, _e3627, (_e3627 > 0i)))];
let _e3639 = ((_e3621 >> bitcast<u32>((_e3614 & 31u))) | ((_e3632 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3614) & 31u))));
let _e3642 = f32(bitcast<i32>((_e3639 & 65535u)));
let _e3649 = (_e3642 + ((f32(bitcast<i32>((_e3639 >> bitcast<u32>(16i)))) - _e3642) * _e3520));
let _e3651 = (2i * (_e3608 + _e3480));
let _e3653 = (_e3651 >> bitcast<u32>(2i));
let _e3656 = bitcast<u32>(((_e3651 & 3i) * 8i));
let _e3658 = select(_e2207, _e3653, (_e3653 < _e2207));
let _e3663 = global_5.member[bitcast<u32>(select(0i, _e3658, (_e3658 > 0i)))];
let _e3667 = (_e3653 + 1i);
let _e3669 = select(_e2207, _e3667, (_e3667 < _e2207));
let _e3674 = global_5.member[bitcast<u32>(select(0i, _e3669, (_e3669 > 0i)))];
let _e3681 = ((_e3663 >> bitcast<u32>((_e3656 & 31u))) | ((_e3674 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3656) & 31u))));
let _e3684 = f32(bitcast<i32>((_e3681 & 65535u)));
let _e3694 = (_e3565 + (((_e3600 + ((f32(bitcast<i32>((_e3597 >> bitcast<u32>(16i)))) - _e3600) * _e3520)) - _e3565) * _e3522));
phi_5302_ = (_e3694 + (((_e3649 + (((_e3684 + ((f32(bitcast<i32>((_e3681 >> bitcast<u32>(16i)))) - _e3684) * _e3520)) - _e3649) * _e3522)) - _e3694) * (_e3402 - f32(_e3447))));
} else {
phi_5302_ = 0f;
}
let _e3702 = phi_5302_;
let _e3703 = local;
let _e3704 = local_1[0u];
let _e3706 = local_1[1u];
let _e3708 = local_1[2u];
let _e3710 = ((_e3704 + 0f) - 0.5f);
let _e3711 = ((_e3706 + 0f) - 0.5f);
let _e3712 = ((_e3708 + 1f) - 0.5f);
let _e3714 = select(0f, _e3710, (_e3710 > 0f));
let _e3716 = select(_e2154, _e3714, (_e3714 < _e2154));
let _e3723 = select(0i, select(select(i32(_e3716), i32(-2147483648), (_e3716 < -2147483600f)), 2147483647i, (_e3716 > 2147483500f)), (_e3716 == _e3716));
let _e3727 = (_e3723 - select(0i, 1i, (_e3716 < f32(_e3723))));
let _e3729 = select(0f, _e3711, (_e3711 > 0f));
let _e3731 = select(_e2171, _e3729, (_e3729 < _e2171));
let _e3738 = select(0i, select(select(i32(_e3731), i32(-2147483648), (_e3731 < -2147483600f)), 2147483647i, (_e3731 > 2147483500f)), (_e3731 == _e3731));
let _e3742 = (_e3738 - select(0i, 1i, (_e3731 < f32(_e3738))));
let _e3744 = select(0f, _e3712, (_e3712 > 0f));
let _e3746 = select(_e2188, _e3744, (_e3744 < _e2188));
let _e3753 = select(0i, select(select(i32(_e3746), i32(-2147483648), (_e3746 < -2147483600f)), 2147483647i, (_e3746 > 2147483500f)), (_e3746 == _e3746));
let _e3757 = (_e3753 - select(0i, 1i, (_e3746 < f32(_e3753))));
let _e3758 = (_e3703 * 4i);
let _e3759 = (_e3758 + 1i);
let _e3761 = select(_e2207, _e3759, (_e3759 < _e2207));
let _e3766 = global_5.member[bitcast<u32>(select(0i, _e3761, (_e3761 > 0i)))];
let _e3767 = (_e3758 + 2i);
let _e3769 = select(_e2207, _e3767, (_e3767 < _e2207));
let _e3774 = global_5.member[bitcast<u32>(select(0i, _e3769, (_e3769 > 0i)))];
let _e3775 = (_e3758 + 3i);
let _e3777 = select(_e2207, _e3775, (_e3775 < _e2207));
let _e3782 = global_5.member[bitcast<u32>(select(0i, _e3777, (_e3777 > 0i)))];
let _e3785 = (_e3727 - bitcast<i32>((_e3766 & 65535u)));
let _e3790 = bitcast<i32>((_e3766 >> bitcast<u32>(16i)));
let _e3795 = (_e3742 - bitcast<i32>((_e3774 & 65535u)));
let _e3800 = bitcast<i32>((_e3774 >> bitcast<u32>(16i)));
let _e3805 = (_e3757 - bitcast<i32>((_e3782 & 65535u)));
if ((((_e3785 >= 0i) && ((_e3785 + 1i) < _e3790)) && ((_e3795 >= 0i) && ((_e3795 + 1i) < _e3800))) && ((_e3805 >= 0i) && ((_e3805 + 1i) < bitcast<i32>((_e3782 >> bitcast<u32>(16i)))))) {
let _e3815 = (_e3800 * _e3790);
let _e3817 = select(_e2207, _e3758, (_e3758 < _e2207));
let _e3822 = global_5.member[bitcast<u32>(select(0i, _e3817, (_e3817 > 0i)))];
let _e3828 = (((bitcast<i32>(_e3822) + (_e3805 * _e3815)) + (_e3795 * _e3790)) + _e3785);
let _e3830 = (_e3710 - f32(_e3727));
let _e3832 = (_e3711 - f32(_e3742));
let _e3835 = (2i * _e3828);
let _e3837 = (_e3835 >> bitcast<u32>(2i));
let _e3840 = bitcast<u32>(((_e3835 & 3i) * 8i));
let _e3842 = select(_e2207, _e3837, (_e3837 < _e2207));
let _e3847 = global_5.member[bitcast<u32>(select(0i, _e3842, (_e3842 > 0i)))];
let _e3851 = (_e3837 + 1i);
let _e3853 = select(_e2207, _e3851, (_e3851 < _e2207));
let _e3858 = global_5.member[bitcast<u32>(select(0i, _e3853, (_e3853 > 0i)))];
let _e3865 = ((_e3847 >> bitcast<u32>((_e3840 & 31u))) | ((_e3858 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3840) & 31u))));
let _e3868 = f32(bitcast<i32>((_e3865 & 65535u)));
let _e3875 = (_e3868 + ((f32(bitcast<i32>((_e3865 >> bitcast<u32>(16i)))) - _e3868) * _e3830));
let _e3877 = (2i * (_e3828 + _e3790));
let _e3879 = (_e3877 >> bitcast<u32>(2i));
let _e3882 = bitcast<u32>(((_e3877 & 3i) * 8i));
let _e3884 = select(_e2207, _e3879, (_e3879 < _e2207));
let _e3889 = global_5.member[bitcast<u32>(select(0i, _e3884, (_e3884 > 0i)))];
let _e3893 = (_e3879 + 1i);
let _e3895 = select(_e2207, _e3893, (_e3893 < _e2207));
let _e3900 = global_5.member[bitcast<u32>(select(0i, _e3895, (_e3895 > 0i)))];
let _e3907 = ((_e3889 >> bitcast<u32>((_e3882 & 31u))) | ((_e3900 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3882) & 31u))));
let _e3910 = f32(bitcast<i32>((_e3907 & 65535u)));
let _e3918 = (_e3828 + _e3815);
let _e3919 = (2i * _e3918);
let _e3921 = (_e3919 >> bitcast<u32>(2i));
let _e3924 = bitcast<u32>(((_e3919 & 3i) * 8i));
let _e3926 = select(_e2207, _e3921, (_e3921 < _e2207));
let _e3931 = global_5.member[bitcast<u32>(select(0i, _e3926, (_e3926 > 0i)))];
let _e3935 = (_e3921 + 1i);
let _e3937 = select(_e2207, _e3935, (_e3935 < _e2207));
let _e3942 = global_5.member[bitcast<u32>(select(0i, _e3937, (_e3937 > 0i)))];
let _e3949 = ((_e3931 >> bitcast<u32>((_e3924 & 31u))) | ((_e3942 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3924) & 31u))));
let _e3952 = f32(bitcast<i32>((_e3949 & 65535u)));
let _e3959 = (_e3952 + ((f32(bitcast<i32>((_e3949 >> bitcast<u32>(16i)))) - _e3952) * _e3830));
let _e3961 = (2i * (_e3918 + _e3790));
let _e3963 = (_e3961 >> bitcast<u32>(2i));
let _e3966 = bitcast<u32>(((_e3961 & 3i) * 8i));
let _e3968 = select(_e2207, _e3963, (_e3963 < _e2207));
let _e3973 = global_5.member[bitcast<u32>(select(0i, _e3968, (_e3968 > 0i)))];
let _e3977 = (_e3963 + 1i);
let _e3979 = select(_e2207, _e3977, (_e3977 < _e2207));
let _e3984 = global_5.member[bitcast<u32>(select(0i, _e3979, (_e3979 > 0i)))];
let _e3991 = ((_e3973 >> bitcast<u32>((_e3966 & 31u))) | ((_e3984 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3966) & 31u))));
let _e3994 = f32(bitcast<i32>((_e3991 & 65535u)));
let _e4004 = (_e3875 + (((_e3910 + ((f32(bitcast<i32>((_e3907 >> bitcast<u32>(16i)))) - _e3910) * _e3830)) - _e3875) * _e3832));
phi_5741_ = (_e4004 + (((_e3959 + (((_e3994 + ((f32(bitcast<i32>((_e3991 >> bitcast<u32>(16i)))) - _e3994) * _e3830)) - _e3959) * _e3832)) - _e4004) * (_e3712 - f32(_e3757))));
} else {
phi_5741_ = 0f;
}
let _e4012 = phi_5741_;
let _e4013 = (_e3702 - _e4012);
let _e4018 = (((_e2771 * _e2771) + (_e3392 * _e3392)) + (_e4013 * _e4013));
let _e4021 = sqrt(select(0f, _e4018, (_e4018 > 0f)));
let _e4024 = (1f / select(1e-6f, _e4021, (_e4021 > 1e-6f)));
let _e4025 = (_e2771 * _e4024);
let _e4026 = (_e3392 * _e4024);
let _e4027 = (_e4013 * _e4024);
let _e4028 = vec3<f32>(_e4025, _e4026, _e4027);
let _e4031 = local_10;
let _e4036 = global_1.member.member_7.member_2;
let _e4050 = global_1.member.member_7.member_1;
let _e4054 = local_11;
let _e4056 = ((((_e799.member_5 + _e4031) < _e4036) && ((((_e4025 * _e799.member_4.x) + (_e4026 * _e799.member_4.y)) + (_e4027 * _e799.member_4.z)) > _e4050)) || (_e4054 == _e799.member_7));
if _e4056 {
phi_6801_ = _e799;
} else {
let _e4081 = type_12(vec3<f32>((_e799.member.x + _e1759), (_e799.member.y + _e1762), (_e799.member.z + _e1765)), _e799.member_1, _e799.member_2, _e799.member_3, _e799.member_4, _e799.member_5, _e799.member_6, _e799.member_7, _e799.member_8, _e799.member_9, _e799.member_10, _e799.member_11, _e799.member_12, _e799.member_13, _e799.member_14);
let _e4085 = local_12;
let _e4103 = type_12(_e4081.member, _e4081.member_1, _e4081.member_2, _e4081.member_3, _e4081.member_4, _e4081.member_5, _e4081.member_6, _e4081.member_7, _e4081.member_8, _e4081.member_9, (_e799.member_10 + select(0f, _e4085, (_e799.member_8 == 0f))), _e4081.member_11, _e4081.member_12, _e4081.member_13, _e4081.member_14);
if (_e799.member_7 != 16i) {
let _e4107 = local_13;
let _e4123 = type_12(_e4103.member, _e4103.member_1, _e4103.member_2, _e4103.member_3, _e4103.member_4, _e4103.member_5, _e4103.member_6, _e4103.member_7, _e4103.member_8, (_e799.member_9 + _e4107), _e4103.member_10, _e4103.member_11, _e4103.member_12, _e4103.member_13, _e4103.member_14);
let _e4124 = (_e799.member_7 * 4i);
let _e4125 = (_e4124 + 1i);
let _e4127 = (bitcast<i32>(_e93) - 1i);
let _e4129 = select(_e4127, _e4125, (_e4125 < _e4127));
let _e4135 = global_2.member[bitcast<u32>(select(0i, _e4129, (_e4129 > 0i)))];
let _e4137 = local_14;
let _e4139 = -((_e4135 * _e4137));
let _e4141 = select(-87f, _e4139, (_e4139 > -87f));
let _e4143 = select(88f, _e4141, (_e4141 < 88f));
let _e4145 = ((_e4143 * 1.442695f) + 0.5f);
let _e4147 = select(-127f, _e4145, (_e4145 > -127f));
let _e4149 = select(128f, _e4147, (_e4147 < 128f));
let _e4156 = select(0i, select(select(i32(_e4149), i32(-2147483648), (_e4149 < -2147483600f)), 2147483647i, (_e4149 > 2147483500f)), (_e4149 == _e4149));
let _e4160 = (_e4156 - select(0i, 1i, (_e4149 < f32(_e4156))));
let _e4161 = f32(_e4160);
let _e4165 = ((_e4143 - (_e4161 * 0.6933594f)) - (_e4161 * -2.1219444e-4f));
let _e4189 = (_e4124 + 2i);
let _e4191 = select(_e4127, _e4189, (_e4189 < _e4127));
let _e4197 = global_2.member[bitcast<u32>(select(0i, _e4191, (_e4191 > 0i)))];
let _e4199 = local_15;
let _e4201 = -((_e4197 * _e4199));
let _e4203 = select(-87f, _e4201, (_e4201 > -87f));
let _e4205 = select(88f, _e4203, (_e4203 < 88f));
let _e4207 = ((_e4205 * 1.442695f) + 0.5f);
let _e4209 = select(-127f, _e4207, (_e4207 > -127f));
let _e4211 = select(128f, _e4209, (_e4209 < 128f));
let _e4218 = select(0i, select(select(i32(_e4211), i32(-2147483648), (_e4211 < -2147483600f)), 2147483647i, (_e4211 > 2147483500f)), (_e4211 == _e4211));
let _e4222 = (_e4218 - select(0i, 1i, (_e4211 < f32(_e4218))));
let _e4223 = f32(_e4222);
let _e4227 = ((_e4205 - (_e4223 * 0.6933594f)) - (_e4223 * -2.1219444e-4f));
let _e4251 = (_e4124 + 3i);
let _e4253 = select(_e4127, _e4251, (_e4251 < _e4127));
let _e4259 = global_2.member[bitcast<u32>(select(0i, _e4253, (_e4253 > 0i)))];
let _e4261 = local_16;
let _e4263 = -((_e4259 * _e4261));
let _e4265 = select(-87f, _e4263, (_e4263 > -87f));
let _e4267 = select(88f, _e4265, (_e4265 < 88f));
let _e4269 = ((_e4267 * 1.442695f) + 0.5f);
let _e4271 = select(-127f, _e4269, (_e4269 > -127f));
let _e4273 = select(128f, _e4271, (_e4271 < 128f));
let _e4280 = select(0i, select(select(i32(_e4273), i32(-2147483648), (_e4273 < -2147483600f)), 2147483647i, (_e4273 > 2147483500f)), (_e4273 == _e4273));
let _e4284 = (_e4280 - select(0i, 1i, (_e4273 < f32(_e4280))));
let _e4285 = f32(_e4284);
let _e4289 = ((_e4267 - (_e4285 * 0.6933594f)) - (_e4285 * -2.1219444e-4f));
phi_6073_ = type_12(_e4123.member, _e4123.member_1, vec3<f32>((_e799.member_2.x * ((1f + (_e4165 * (1f + (_e4165 * (0.5f + (_e4165 * (0.16666667f + (_e4165 * (0.041666668f + (_e4165 * (0.008333334f + (_e4165 * (0.001388889f + (_e4165 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4160 + 127i)) << bitcast<u32>(23i))))), (_e799.member_2.y * ((1f + (_e4227 * (1f + (_e4227 * (0.5f + (_e4227 * (0.16666667f + (_e4227 * (0.041666668f + (_e4227 * (0.008333334f + (_e4227 * (0.001388889f + (_e4227 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4222 + 127i)) << bitcast<u32>(23i))))), (_e799.member_2.z * ((1f + (_e4289 * (1f + (_e4289 * (0.5f + (_e4289 * (0.16666667f + (_e4289 * (0.041666668f + (_e4289 * (0.008333334f + (_e4289 * (0.001388889f + (_e4289 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4284 + 127i)) << bitcast<u32>(23i)))))), _e4123.member_3, _e4123.member_4, _e4123.member_5, _e4123.member_6, _e4123.member_7, _e4123.member_8, _e4123.member_9, _e4123.member_10, _e4123.member_11, _e4123.member_12, _e4123.member_13, _e4123.member_14);
} else {
phi_6073_ = _e4103;
}
let _e4330 = phi_6073_;
let _e4332 = (_e799.member_7 * 4i);
let _e4334 = (bitcast<i32>(_e93) - 1i);
let _e4336 = select(_e4334, _e4332, (_e4332 < _e4334));
let _e4342 = global_2.member[bitcast<u32>(select(0i, _e4336, (_e4336 > 0i)))];
let _e4344 = select(_e4342, 1f, (_e799.member_7 == 16i));
let _e4346 = local_17;
let _e4347 = (_e4346 * 4i);
let _e4349 = select(_e4334, _e4347, (_e4347 < _e4334));
let _e4355 = global_2.member[bitcast<u32>(select(0i, _e4349, (_e4349 > 0i)))];
let _e4357 = local_18;
let _e4359 = select(_e4355, 1f, (_e4357 == 16i));
let _e4369 = select(1f, -1f, ((((_e4330.member_1.x * _e4025) + (_e4330.member_1.y * _e4026)) + (_e4330.member_1.z * _e4027)) > 0f));
let _e4370 = (_e4025 * _e4369);
let _e4371 = (_e4026 * _e4369);
let _e4372 = (_e4027 * _e4369);
let _e4378 = -((((_e4330.member_1.x * _e4370) + (_e4330.member_1.y * _e4371)) + (_e4330.member_1.z * _e4372)));
let _e4380 = select(0f, _e4378, (_e4378 > 0f));
let _e4381 = (_e4344 / _e4359);
let _e4383 = (_e4380 * _e4380);
let _e4386 = (1f - ((_e4381 * _e4381) * (1f - _e4383)));
let _e4387 = (_e4386 <= 0f);
let _e4395 = ((_e4381 * _e4380) - sqrt(select(0f, _e4386, (_e4386 > 0f))));
let _e4402 = (2f * _e4380);
let _e4409 = select(((_e4330.member_1.x * _e4381) + (_e4370 * _e4395)), (_e4330.member_1.x + (_e4370 * _e4402)), _e4387);
let _e4410 = select(((_e4330.member_1.y * _e4381) + (_e4371 * _e4395)), (_e4330.member_1.y + (_e4371 * _e4402)), _e4387);
let _e4411 = select(((_e4330.member_1.z * _e4381) + (_e4372 * _e4395)), (_e4330.member_1.z + (_e4372 * _e4402)), _e4387);
let _e4416 = (((_e4409 * _e4409) + (_e4410 * _e4410)) + (_e4411 * _e4411));
let _e4419 = sqrt(select(0f, _e4416, (_e4416 > 0f)));
let _e4422 = (1f / select(1e-20f, _e4419, (_e4419 > 1e-20f)));
let _e4427 = (_e4359 / _e4344);
let _e4430 = (((_e4427 * _e4427) - 1f) + _e4383);
let _e4433 = sqrt(select(0f, _e4430, (_e4430 > 0f)));
let _e4434 = (_e4433 - _e4380);
let _e4435 = (_e4433 + _e4380);
let _e4438 = (_e4434 / select(1e-6f, _e4435, (_e4435 > 1e-6f)));
let _e4442 = ((_e4380 * _e4434) + 1f);
let _e4445 = (((_e4380 * _e4435) - 1f) / select(1e-6f, _e4442, (_e4442 > 1e-6f)));
let _e4460 = global_1.member.member[3u];
let _e4463 = select(0f, select(select((((0.5f * _e4438) * _e4438) * (1f + (_e4445 * _e4445))), 1f, (_e4430 <= 0f)), 0f, (_e4344 == _e4359)), ((_e4460 & 1u) != 0u));
if (_e4330.member_8 == 0f) {
let _e4478 = type_12(_e4330.member, _e4330.member_1, _e4330.member_2, _e4028, _e4330.member_4, _e4330.member_5, _e4330.member_6, _e4330.member_7, _e4330.member_8, _e4330.member_9, _e4330.member_10, _e4330.member_11, _e4330.member_12, _e4330.member_13, _e4330.member_14);
phi_6284_ = type_12(_e4478.member, _e4478.member_1, _e4478.member_2, _e4478.member_3, _e4478.member_4, _e4478.member_5, _e4478.member_6, _e4478.member_7, _e4478.member_8, _e4478.member_9, _e4478.member_10, _e4463, _e4478.member_12, _e4478.member_13, _e4478.member_14);
} else {
phi_6284_ = _e4330;
}
let _e4495 = phi_6284_;
let _e4497 = (_e4495.member_8 + 1f);
let _e4512 = type_12(_e4495.member, _e4495.member_1, _e4495.member_2, _e4495.member_3, _e4495.member_4, _e4495.member_5, _e4495.member_6, _e4495.member_7, _e4497, _e4495.member_9, _e4495.member_10, _e4495.member_11, _e4495.member_12, _e4495.member_13, _e4495.member_14);
let _e4515 = ((_e394 == 0u) && (_e4497 >= 2f));
if (_e4387 && _e4515) {
let _e4540 = (((_e4495.member_1.x * _e4025) + (_e4495.member_1.y * _e4026)) + (_e4495.member_1.z * _e4027));
let _e4544 = (_e4495.member_1.x - (_e4025 * _e4540));
let _e4545 = (_e4495.member_1.y - (_e4026 * _e4540));
let _e4546 = (_e4495.member_1.z - (_e4027 * _e4540));
let _e4551 = (((_e4544 * _e4544) + (_e4545 * _e4545)) + (_e4546 * _e4546));
let _e4554 = sqrt(select(0f, _e4551, (_e4551 > 0f)));
let _e4557 = (1f / select(1e-20f, _e4554, (_e4554 > 1e-20f)));
phi_6337_ = type_12(_e4512.member, vec3<f32>((_e4544 * _e4557), (_e4545 * _e4557), (_e4546 * _e4557)), _e4512.member_2, _e4512.member_3, _e4512.member_4, _e4512.member_5, _e4512.member_6, _e4512.member_7, _e4512.member_8, _e4512.member_9, _e4512.member_10, _e4512.member_11, _e4512.member_12, _e4512.member_13, _e4512.member_14);
} else {
phi_6337_ = type_12(_e4512.member, vec3<f32>((_e4409 * _e4422), (_e4410 * _e4422), (_e4411 * _e4422)), _e4512.member_2, _e4512.member_3, _e4512.member_4, _e4512.member_5, _e4512.member_6, _e4512.member_7, _e4512.member_8, _e4512.member_9, _e4512.member_10, _e4512.member_11, _e4512.member_12, _e4512.member_13, _e4512.member_14);
}
let _e4578 = phi_6337_;
if _e4387 {
phi_6351_ = _e4578;
} else {
let _e4579 = (1f - _e4463);
phi_6351_ = type_12(_e4578.member, _e4578.member_1, vec3<f32>((_e4578.member_2.x * _e4579), (_e4578.member_2.y * _e4579), (_e4578.member_2.z * _e4579)), _e4578.member_3, _e4578.member_4, _e4578.member_5, _e4578.member_6, _e4578.member_7, _e4578.member_8, _e4578.member_9, _e4578.member_10, _e4578.member_11, _e4578.member_12, _e4578.member_13, _e4578.member_14);
}
let _e4606 = phi_6351_;
let _e4611 = global_1.member.member_17;
let _e4624 = ((((_e4611.member * _e4606.member.x) + (_e4611.member_1 * _e4606.member.y)) + (_e4611.member_2 * _e4606.member.z)) + _e4611.member_3);
let _e4633 = -((((_e4611.member * _e4606.member_1.x) + (_e4611.member_1 * _e4606.member_1.y)) + (_e4611.member_2 * _e4606.member_1.z)));
let _e4635 = (_e4633 > 1e-9f);
let _e4639 = ((_e4624 / select(1e-9f, _e4633, _e4635)) - 0.015625f);
let _e4642 = select(1e30f, select(0f, _e4639, (_e4639 > 0f)), ((_e4624 > 0f) && _e4635));
let _e4645 = global_1.member.member_19;
let _e4655 = ((((_e4645.member * _e4606.member.x) + (_e4645.member_1 * _e4606.member.y)) + (_e4645.member_2 * _e4606.member.z)) + _e4645.member_3);
let _e4661 = -((((_e4645.member * _e4606.member_1.x) + (_e4645.member_1 * _e4606.member_1.y)) + (_e4645.member_2 * _e4606.member_1.z)));
let _e4663 = (_e4661 > 1e-9f);
let _e4667 = ((_e4655 / select(1e-9f, _e4661, _e4663)) - 0.015625f);
let _e4670 = select(1e30f, select(0f, _e4667, (_e4667 > 0f)), ((_e4655 > 0f) && _e4663));
let _e4674 = (_e4670 < _e4642);
let _e4676 = select(select(-2i, -3i, _e4674), -1i, ((_e4642 >= 1e30f) && (_e4670 >= 1e30f)));
let _e4677 = select(_e4642, _e4670, _e4674);
let _e4692 = type_12(_e4606.member, _e4606.member_1, _e4606.member_2, _e4606.member_3, _e4606.member_4, _e4606.member_5, _e4606.member_6, _e4606.member_7, _e4606.member_8, _e4606.member_9, _e4606.member_10, _e4606.member_11, 0i, _e4606.member_13, _e4606.member_14);
let _e4707 = type_12(_e4692.member, _e4692.member_1, _e4692.member_2, _e4692.member_3, _e4692.member_4, _e4692.member_5, _e4692.member_6, _e4692.member_7, _e4692.member_8, _e4692.member_9, _e4692.member_10, _e4692.member_11, _e4692.member_12, _e4676, _e4692.member_14);
let _e4722 = type_12(_e4707.member, _e4707.member_1, _e4707.member_2, _e4707.member_3, _e4707.member_4, _e4707.member_5, _e4707.member_6, _e4707.member_7, _e4707.member_8, _e4707.member_9, _e4707.member_10, _e4707.member_11, _e4707.member_12, _e4707.member_13, _e4677);
let _e4724 = local_19;
let _e4727 = ((_e4460 & 2u) != 0u);
if (_e4515 && !(_e4727)) {
if (_e4676 == -1i) {
phi_6770_ = type_12(_e4722.member, _e4722.member_1, _e4722.member_2, _e4722.member_3, _e4722.member_4, _e4722.member_5, 1f, _e4722.member_7, _e4722.member_8, _e4722.member_9, _e4722.member_10, _e4722.member_11, _e4722.member_12, _e4722.member_13, _e4722.member_14);
} else {
let _e4804 = type_12(vec3<f32>((_e4606.member.x + (_e4606.member_1.x * _e4677)), (_e4606.member.y + (_e4606.member_1.y * _e4677)), (_e4606.member.z + (_e4606.member_1.z * _e4677))), _e4722.member_1, _e4722.member_2, _e4722.member_3, _e4722.member_4, _e4722.member_5, _e4722.member_6, _e4722.member_7, _e4722.member_8, _e4722.member_9, _e4722.member_10, _e4722.member_11, _e4722.member_12, _e4722.member_13, _e4722.member_14);
let _e4820 = type_12(_e4804.member, _e4804.member_1, _e4804.member_2, _e4804.member_3, _e4804.member_4, _e4804.member_5, _e4804.member_6, _e4804.member_7, _e4804.member_8, _e4804.member_9, _e4804.member_10, _e4804.member_11, _e4804.member_12, _e4804.member_13, (_e4677 - _e4677));
let _e4840 = type_12(_e4820.member, _e4820.member_1, _e4820.member_2, _e4820.member_3, _e4820.member_4, _e4820.member_5, _e4820.member_6, _e4820.member_7, _e4820.member_8, _e4820.member_9, (_e4606.member_10 + select(0f, _e4677, (_e4606.member_8 == 0f))), _e4820.member_11, _e4820.member_12, _e4820.member_13, _e4820.member_14);
phi_6770_ = type_12(_e4840.member, _e4840.member_1, _e4840.member_2, _e4840.member_3, _e4840.member_4, _e4840.member_5, 3f, _e4840.member_7, _e4840.member_8, _e4840.member_9, _e4840.member_10, _e4840.member_11, _e4840.member_12, _e4840.member_13, _e4840.member_14);
}
let _e4872 = phi_6770_;
phi_6792_ = _e4872;
} else {
let _e4735 = global_1.member.member_2[3u];
if ((!(_e4515) && (_e4606.member_8 >= f32(bitcast<i32>(_e4735)))) && (select(_e4724, _e799.member_7, _e4387) != 16i)) {
phi_6791_ = type_12(_e4722.member, _e4722.member_1, _e4722.member_2, _e4722.member_3, _e4722.member_4, _e4722.member_5, 2f, _e4722.member_7, _e4722.member_8, _e4722.member_9, _e4722.member_10, _e4722.member_11, _e4722.member_12, _e4722.member_13, _e4722.member_14);
} else {
if _e4727 {
phi_6790_ = type_12(_e4722.member, _e4722.member_1, _e4722.member_2, _e4722.member_3, _e4722.member_4, _e4722.member_5, 4f, _e4722.member_7, _e4722.member_8, _e4722.member_9, _e4722.member_10, _e4722.member_11, _e4722.member_12, _e4722.member_13, _e4722.member_14);
} else {
phi_6790_ = _e4722;
}
let _e4758 = phi_6790_;
phi_6791_ = _e4758;
}
let _e4775 = phi_6791_;
phi_6792_ = _e4775;
}
let _e4874 = phi_6792_;
let _e4877 = local_20;
let _e4893 = type_12(_e4874.member, _e4874.member_1, _e4874.member_2, _e4874.member_3, _e4874.member_4, _e4874.member_5, _e4874.member_6, select(_e799.member_7, _e4877, !(_e4387)), _e4874.member_8, _e4874.member_9, _e4874.member_10, _e4874.member_11, _e4874.member_12, _e4874.member_13, _e4874.member_14);
let _e4908 = type_12(_e4893.member, _e4893.member_1, _e4893.member_2, _e4893.member_3, _e4028, _e4893.member_5, _e4893.member_6, _e4893.member_7, _e4893.member_8, _e4893.member_9, _e4893.member_10, _e4893.member_11, _e4893.member_12, _e4893.member_13, _e4893.member_14);
phi_6801_ = type_12(_e4908.member, _e4908.member_1, _e4908.member_2, _e4908.member_3, _e4908.member_4, 0f, _e4908.member_6, _e4908.member_7, _e4908.member_8, _e4908.member_9, _e4908.member_10, _e4908.member_11, _e4908.member_12, _e4908.member_13, _e4908.member_14);
}
let _e4925 = phi_6801_;
phi_6802_ = _e4925;
phi_6803_ = _e4056;
}
let _e4927 = phi_6802_;
let _e4929 = phi_6803_;
if (_e4929 && _e1009) {
let _e5399 = type_12(vec3<f32>((_e4927.member.x + (_e4927.member_1.x * _e4927.member_14)), (_e4927.member.y + (_e4927.member_1.y * _e4927.member_14)), (_e4927.member.z + (_e4927.member_1.z * _e4927.member_14))), _e4927.member_1, _e4927.member_2, _e4927.member_3, _e4927.member_4, _e4927.member_5, _e4927.member_6, _e4927.member_7, _e4927.member_8, _e4927.member_9, _e4927.member_10, _e4927.member_11, _e4927.member_12, _e4927.member_13, _e4927.member_14);
let _e5416 = type_12(_e5399.member, _e5399.member_1, _e5399.member_2, _e5399.member_3, _e5399.member_4, (_e4927.member_5 + _e4927.member_14), _e5399.member_6, _e5399.member_7, _e5399.member_8, _e5399.member_9, _e5399.member_10, _e5399.member_11, _e5399.member_12, _e5399.member_13, _e5399.member_14);
let _e5432 = type_12(_e5416.member, _e5416.member_1, _e5416.member_2, _e5416.member_3, _e5416.member_4, _e5416.member_5, _e5416.member_6, _e5416.member_7, _e5416.member_8, _e5416.member_9, _e5416.member_10, _e5416.member_11, _e5416.member_12, _e5416.member_13, (_e4927.member_14 - _e4927.member_14));
let _e5452 = type_12(_e5432.member, _e5432.member_1, _e5432.member_2, _e5432.member_3, _e5432.member_4, _e5432.member_5, _e5432.member_6, _e5432.member_7, _e5432.member_8, _e5432.member_9, (_e4927.member_10 + select(0f, _e4927.member_14, (_e4927.member_8 == 0f))), _e5432.member_11, _e5432.member_12, _e5432.member_13, _e5432.member_14);
if (_e799.member_7 != 16i) {
let _e5470 = type_12(_e5452.member, _e5452.member_1, _e5452.member_2, _e5452.member_3, _e5452.member_4, _e5452.member_5, _e5452.member_6, _e5452.member_7, _e5452.member_8, (_e4927.member_9 + _e4927.member_14), _e5452.member_10, _e5452.member_11, _e5452.member_12, _e5452.member_13, _e5452.member_14);
let _e5471 = (_e799.member_7 * 4i);
let _e5472 = (_e5471 + 1i);
let _e5474 = (bitcast<i32>(_e93) - 1i);
let _e5476 = select(_e5474, _e5472, (_e5472 < _e5474));
let _e5482 = global_2.member[bitcast<u32>(select(0i, _e5476, (_e5476 > 0i)))];
let _e5484 = -((_e5482 * _e4927.member_14));
let _e5486 = select(-87f, _e5484, (_e5484 > -87f));
let _e5488 = select(88f, _e5486, (_e5486 < 88f));
let _e5490 = ((_e5488 * 1.442695f) + 0.5f);
let _e5492 = select(-127f, _e5490, (_e5490 > -127f));
let _e5494 = select(128f, _e5492, (_e5492 < 128f));
let _e5501 = select(0i, select(select(i32(_e5494), i32(-2147483648), (_e5494 < -2147483600f)), 2147483647i, (_e5494 > 2147483500f)), (_e5494 == _e5494));
let _e5505 = (_e5501 - select(0i, 1i, (_e5494 < f32(_e5501))));
let _e5506 = f32(_e5505);
let _e5510 = ((_e5488 - (_e5506 * 0.6933594f)) - (_e5506 * -2.1219444e-4f));
let _e5534 = (_e5471 + 2i);
let _e5536 = select(_e5474, _e5534, (_e5534 < _e5474));
let _e5542 = global_2.member[bitcast<u32>(select(0i, _e5536, (_e5536 > 0i)))];
let _e5544 = -((_e5542 * _e4927.member_14));
let _e5546 = select(-87f, _e5544, (_e5544 > -87f));
let _e5548 = select(88f, _e5546, (_e5546 < 88f));
let _e5550 = ((_e5548 * 1.442695f) + 0.5f);
let _e5552 = select(-127f, _e5550, (_e5550 > -127f));
let _e5554 = select(128f, _e5552, (_e5552 < 128f));
let _e5561 = select(0i, select(select(i32(_e5554), i32(-2147483648), (_e5554 < -2147483600f)), 2147483647i, (_e5554 > 2147483500f)), (_e5554 == _e5554));
let _e5565 = (_e5561 - select(0i, 1i, (_e5554 < f32(_e5561))));
let _e5566 = f32(_e5565);
let _e5570 = ((_e5548 - (_e5566 * 0.6933594f)) - (_e5566 * -2.1219444e-4f));
let _e5594 = (_e5471 + 3i);
let _e5596 = select(_e5474, _e5594, (_e5594 < _e5474));
let _e5602 = global_2.member[bitcast<u32>(select(0i, _e5596, (_e5596 > 0i)))];
let _e5604 = -((_e5602 * _e4927.member_14));
let _e5606 = select(-87f, _e5604, (_e5604 > -87f));
let _e5608 = select(88f, _e5606, (_e5606 < 88f));
let _e5610 = ((_e5608 * 1.442695f) + 0.5f);
let _e5612 = select(-127f, _e5610, (_e5610 > -127f));
let _e5614 = select(128f, _e5612, (_e5612 < 128f));
let _e5621 = select(0i, select(select(i32(_e5614), i32(-2147483648), (_e5614 < -2147483600f)), 2147483647i, (_e5614 > 2147483500f)), (_e5614 == _e5614));
let _e5625 = (_e5621 - select(0i, 1i, (_e5614 < f32(_e5621))));
let _e5626 = f32(_e5625);
let _e5630 = ((_e5608 - (_e5626 * 0.6933594f)) - (_e5626 * -2.1219444e-4f));
phi_7093_ = type_12(_e5470.member, _e5470.member_1, vec3<f32>((_e4927.member_2.x * ((1f + (_e5510 * (1f + (_e5510 * (0.5f + (_e5510 * (0.16666667f + (_e5510 * (0.041666668f + (_e5510 * (0.008333334f + (_e5510 * (0.001388889f + (_e5510 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5505 + 127i)) << bitcast<u32>(23i))))), (_e4927.member_2.y * ((1f + (_e5570 * (1f + (_e5570 * (0.5f + (_e5570 * (0.16666667f + (_e5570 * (0.041666668f + (_e5570 * (0.008333334f + (_e5570 * (0.001388889f + (_e5570 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5565 + 127i)) << bitcast<u32>(23i))))), (_e4927.member_2.z * ((1f + (_e5630 * (1f + (_e5630 * (0.5f + (_e5630 * (0.16666667f + (_e5630 * (0.041666668f + (_e5630 * (0.008333334f + (_e5630 * (0.001388889f + (_e5630 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5625 + 127i)) << bitcast<u32>(23i)))))), _e5470.member_3, _e5470.member_4, _e5470.member_5, _e5470.member_6, _e5470.member_7, _e5470.member_8, _e5470.member_9, _e5470.member_10, _e5470.member_11, _e5470.member_12, _e5470.member_13, _e5470.member_14);
} else {
phi_7093_ = _e5452;
}
let _e5671 = phi_7093_;
phi_7687_ = type_12(_e5671.member, _e5671.member_1, _e5671.member_2, _e5671.member_3, _e5671.member_4, _e5671.member_5, 3f, _e5671.member_7, _e5671.member_8, _e5671.member_9, _e5671.member_10, _e5671.member_11, _e5671.member_12, _e5671.member_13, _e5671.member_14);
} else {
if _e4929 {
let _e4962 = type_12(vec3<f32>((_e4927.member.x + (_e4927.member_1.x * _e1010)), (_e4927.member.y + (_e4927.member_1.y * _e1010)), (_e4927.member.z + (_e4927.member_1.z * _e1010))), _e4927.member_1, _e4927.member_2, _e4927.member_3, _e4927.member_4, _e4927.member_5, _e4927.member_6, _e4927.member_7, _e4927.member_8, _e4927.member_9, _e4927.member_10, _e4927.member_11, _e4927.member_12, _e4927.member_13, _e4927.member_14);
let _e4979 = type_12(_e4962.member, _e4962.member_1, _e4962.member_2, _e4962.member_3, _e4962.member_4, (_e4927.member_5 + _e1010), _e4962.member_6, _e4962.member_7, _e4962.member_8, _e4962.member_9, _e4962.member_10, _e4962.member_11, _e4962.member_12, _e4962.member_13, _e4962.member_14);
let _e4996 = type_12(_e4979.member, _e4979.member_1, _e4979.member_2, _e4979.member_3, _e4979.member_4, _e4979.member_5, _e4979.member_6, _e4979.member_7, _e4979.member_8, _e4979.member_9, _e4979.member_10, _e4979.member_11, _e4979.member_12, _e4979.member_13, (_e4927.member_14 - _e1010));
let _e5016 = type_12(_e4996.member, _e4996.member_1, _e4996.member_2, _e4996.member_3, _e4996.member_4, _e4996.member_5, _e4996.member_6, _e4996.member_7, _e4996.member_8, _e4996.member_9, (_e4927.member_10 + select(0f, _e1010, (_e4927.member_8 == 0f))), _e4996.member_11, _e4996.member_12, _e4996.member_13, _e4996.member_14);
if (_e799.member_7 != 16i) {
let _e5034 = type_12(_e5016.member, _e5016.member_1, _e5016.member_2, _e5016.member_3, _e5016.member_4, _e5016.member_5, _e5016.member_6, _e5016.member_7, _e5016.member_8, (_e4927.member_9 + _e1010), _e5016.member_10, _e5016.member_11, _e5016.member_12, _e5016.member_13, _e5016.member_14);
let _e5035 = (_e799.member_7 * 4i);
let _e5036 = (_e5035 + 1i);
let _e5038 = (bitcast<i32>(_e93) - 1i);
let _e5040 = select(_e5038, _e5036, (_e5036 < _e5038));
let _e5046 = global_2.member[bitcast<u32>(select(0i, _e5040, (_e5040 > 0i)))];
let _e5048 = -((_e5046 * _e1010));
let _e5050 = select(-87f, _e5048, (_e5048 > -87f));
let _e5052 = select(88f, _e5050, (_e5050 < 88f));
let _e5054 = ((_e5052 * 1.442695f) + 0.5f);
let _e5056 = select(-127f, _e5054, (_e5054 > -127f));
let _e5058 = select(128f, _e5056, (_e5056 < 128f));
let _e5065 = select(0i, select(select(i32(_e5058), i32(-2147483648), (_e5058 < -2147483600f)), 2147483647i, (_e5058 > 2147483500f)), (_e5058 == _e5058));
let _e5069 = (_e5065 - select(0i, 1i, (_e5058 < f32(_e5065))));
let _e5070 = f32(_e5069);
let _e5074 = ((_e5052 - (_e5070 * 0.6933594f)) - (_e5070 * -2.1219444e-4f));
let _e5098 = (_e5035 + 2i);
let _e5100 = select(_e5038, _e5098, (_e5098 < _e5038));
let _e5106 = global_2.member[bitcast<u32>(select(0i, _e5100, (_e5100 > 0i)))];
let _e5108 = -((_e5106 * _e1010));
let _e5110 = select(-87f, _e5108, (_e5108 > -87f));
let _e5112 = select(88f, _e5110, (_e5110 < 88f));
let _e5114 = ((_e5112 * 1.442695f) + 0.5f);
let _e5116 = select(-127f, _e5114, (_e5114 > -127f));
let _e5118 = select(128f, _e5116, (_e5116 < 128f));
let _e5125 = select(0i, select(select(i32(_e5118), i32(-2147483648), (_e5118 < -2147483600f)), 2147483647i, (_e5118 > 2147483500f)), (_e5118 == _e5118));
let _e5129 = (_e5125 - select(0i, 1i, (_e5118 < f32(_e5125))));
let _e5130 = f32(_e5129);
let _e5134 = ((_e5112 - (_e5130 * 0.6933594f)) - (_e5130 * -2.1219444e-4f));
let _e5158 = (_e5035 + 3i);
let _e5160 = select(_e5038, _e5158, (_e5158 < _e5038));
let _e5166 = global_2.member[bitcast<u32>(select(0i, _e5160, (_e5160 > 0i)))];
let _e5168 = -((_e5166 * _e1010));
let _e5170 = select(-87f, _e5168, (_e5168 > -87f));
let _e5172 = select(88f, _e5170, (_e5170 < 88f));
let _e5174 = ((_e5172 * 1.442695f) + 0.5f);
let _e5176 = select(-127f, _e5174, (_e5174 > -127f));
let _e5178 = select(128f, _e5176, (_e5176 < 128f));
let _e5185 = select(0i, select(select(i32(_e5178), i32(-2147483648), (_e5178 < -2147483600f)), 2147483647i, (_e5178 > 2147483500f)), (_e5178 == _e5178));
let _e5189 = (_e5185 - select(0i, 1i, (_e5178 < f32(_e5185))));
let _e5190 = f32(_e5189);
let _e5194 = ((_e5172 - (_e5190 * 0.6933594f)) - (_e5190 * -2.1219444e-4f));
phi_7382_ = type_12(_e5034.member, _e5034.member_1, vec3<f32>((_e4927.member_2.x * ((1f + (_e5074 * (1f + (_e5074 * (0.5f + (_e5074 * (0.16666667f + (_e5074 * (0.041666668f + (_e5074 * (0.008333334f + (_e5074 * (0.001388889f + (_e5074 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5069 + 127i)) << bitcast<u32>(23i))))), (_e4927.member_2.y * ((1f + (_e5134 * (1f + (_e5134 * (0.5f + (_e5134 * (0.16666667f + (_e5134 * (0.041666668f + (_e5134 * (0.008333334f + (_e5134 * (0.001388889f + (_e5134 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5129 + 127i)) << bitcast<u32>(23i))))), (_e4927.member_2.z * ((1f + (_e5194 * (1f + (_e5194 * (0.5f + (_e5194 * (0.16666667f + (_e5194 * (0.041666668f + (_e5194 * (0.008333334f + (_e5194 * (0.001388889f + (_e5194 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5189 + 127i)) << bitcast<u32>(23i)))))), _e5034.member_3, _e5034.member_4, _e5034.member_5, _e5034.member_6, _e5034.member_7, _e5034.member_8, _e5034.member_9, _e5034.member_10, _e5034.member_11, _e5034.member_12, _e5034.member_13, _e5034.member_14);
} else {
phi_7382_ = _e5016;
}
let _e5235 = phi_7382_;
let _e5238 = local_21;
if (((_e860 <= 0f) && (_e5238 == 16i)) && (_e799.member_7 == 16i)) {
if (_e5235.member_13 == -1i) {
phi_7684_ = type_12(_e5235.member, _e5235.member_1, _e5235.member_2, _e5235.member_3, _e5235.member_4, _e5235.member_5, 1f, _e5235.member_7, _e5235.member_8, _e5235.member_9, _e5235.member_10, _e5235.member_11, _e5235.member_12, _e5235.member_13, _e5235.member_14);
} else {
let _e5277 = type_12(vec3<f32>((_e5235.member.x + (_e5235.member_1.x * _e5235.member_14)), (_e5235.member.y + (_e5235.member_1.y * _e5235.member_14)), (_e5235.member.z + (_e5235.member_1.z * _e5235.member_14))), _e5235.member_1, _e5235.member_2, _e5235.member_3, _e5235.member_4, _e5235.member_5, _e5235.member_6, _e5235.member_7, _e5235.member_8, _e5235.member_9, _e5235.member_10, _e5235.member_11, _e5235.member_12, _e5235.member_13, _e5235.member_14);
let _e5294 = type_12(_e5277.member, _e5277.member_1, _e5277.member_2, _e5277.member_3, _e5277.member_4, (_e5235.member_5 + _e5235.member_14), _e5277.member_6, _e5277.member_7, _e5277.member_8, _e5277.member_9, _e5277.member_10, _e5277.member_11, _e5277.member_12, _e5277.member_13, _e5277.member_14);
let _e5310 = type_12(_e5294.member, _e5294.member_1, _e5294.member_2, _e5294.member_3, _e5294.member_4, _e5294.member_5, _e5294.member_6, _e5294.member_7, _e5294.member_8, _e5294.member_9, _e5294.member_10, _e5294.member_11, _e5294.member_12, _e5294.member_13, (_e5235.member_14 - _e5235.member_14));
let _e5330 = type_12(_e5310.member, _e5310.member_1, _e5310.member_2, _e5310.member_3, _e5310.member_4, _e5310.member_5, _e5310.member_6, _e5310.member_7, _e5310.member_8, _e5310.member_9, (_e5235.member_10 + select(0f, _e5235.member_14, (_e5235.member_8 == 0f))), _e5310.member_11, _e5310.member_12, _e5310.member_13, _e5310.member_14);
phi_7684_ = type_12(_e5330.member, _e5330.member_1, _e5330.member_2, _e5330.member_3, _e5330.member_4, _e5330.member_5, 3f, _e5330.member_7, _e5330.member_8, _e5330.member_9, _e5330.member_10, _e5330.member_11, _e5330.member_12, _e5330.member_13, _e5330.member_14);
}
let _e5362 = phi_7684_;
phi_7685_ = _e5362;
} else {
phi_7685_ = _e5235;
}
let _e5364 = phi_7685_;
phi_7686_ = _e5364;
} else {
phi_7686_ = _e4927;
}
let _e5366 = phi_7686_;
phi_7687_ = _e5366;
}
let _e5688 = phi_7687_;
phi_1307_ = _e5688;
phi_1310_ = (_e801 + 1i);
} else {
phi_1307_ = type_12();
phi_1310_ = i32();
}
let _e5690 = phi_1307_;
let _e5692 = phi_1310_;
continue;
continuing {
phi_1306_ = _e5690;
phi_1309_ = _e5692;
break if !(_e805);
}
}
let _e5695 = local_22;
let _e5699 = local_23;
let _e5703 = local_24;
let _e5707 = local_25;
let _e5711 = local_26;
let _e5715 = local_27;
let _e5719 = local_28;
let _e5723 = local_29;
let _e5727 = local_30;
let _e5731 = local_31;
let _e5735 = local_32;
let _e5739 = local_33;
let _e5743 = local_34;
let _e5747 = local_35;
let _e5751 = local_36;
let _e5755 = local_37;
let _e5758 = local_38;
let _e5762 = local_39;
let _e5765 = local_40;
let _e5768 = local_41;
let _e5771 = local_42;
let _e5774 = local_43;
let _e5778 = local_44;
let _e5782 = local_45;
global_3.member[_e110] = _e5695.member.x;
global_3.member[_e122] = _e5699.member.y;
global_3.member[_e133] = _e5703.member.z;
global_3.member[_e144] = _e5707.member_1.x;
global_3.member[_e155] = _e5711.member_1.y;
global_3.member[_e166] = _e5715.member_1.z;
global_3.member[_e177] = _e5719.member_2.x;
global_3.member[_e188] = _e5723.member_2.y;
global_3.member[_e199] = _e5727.member_2.z;
global_3.member[_e210] = _e5731.member_3.x;
global_3.member[_e221] = _e5735.member_3.y;
global_3.member[_e232] = _e5739.member_3.z;
global_3.member[_e243] = _e5743.member_4.x;
global_3.member[_e254] = _e5747.member_4.y;
global_3.member[_e265] = _e5751.member_4.z;
global_3.member[_e276] = _e5755.member_5;
let _e5819 = local_46;
global_3.member[_e287] = _e5819;
global_3.member[_e298] = f32(_e5758.member_7);
global_3.member[_e309] = _e5762.member_8;
global_3.member[_e320] = _e5765.member_9;
global_3.member[_e331] = _e5768.member_10;
global_3.member[_e342] = _e5771.member_11;
global_3.member[_e353] = f32(_e5774.member_12);
global_3.member[_e364] = f32(_e5778.member_13);
global_3.member[_e375] = _e5782.member_14;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
