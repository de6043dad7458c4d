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
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_13 {
member: array<f32>,
}
struct type_17 {
member: u32,
member_1: u32,
}
struct type_18 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_20 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
}
struct type_21 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_22 {
member: type_2,
member_1: type_17,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_21,
}
struct type_23 {
member: type_22,
}
struct type_24 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(4)
var<storage> global_5: type_13;
@group(0) @binding(5)
var<storage, read_write> global_6: type_13;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: f32;
var local_5: i32;
var local_6: f32;
var local_7: i32;
var local_8: f32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: u32;
var local_17: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var local_21: type_17;
var local_22: u32;
var local_23: type_24;
var local_24: i32;
var local_25: i32;
var phi_1884_: vec3<f32>;
var phi_1887_: vec3<f32>;
var phi_1889_: u32;
var phi_1909_: u32;
var phi_1910_: u32;
var phi_1922_: u32;
var phi_1923_: u32;
var local_26: u32;
var local_27: u32;
var phi_1940_: u32;
var phi_1941_: u32;
var phi_1953_: u32;
var phi_1954_: u32;
var local_28: u32;
var local_29: u32;
var local_30: u32;
var phi_1979_: u32;
var phi_1980_: u32;
var local_31: u32;
var local_32: u32;
var phi_1997_: u32;
var phi_1998_: u32;
var local_33: u32;
var local_34: u32;
var phi_2020_: u32;
var phi_2021_: u32;
var phi_2033_: u32;
var phi_2034_: u32;
var local_35: u32;
var local_36: u32;
var local_37: u32;
var phi_2070_: u32;
var local_38: u32;
var phi_2084_: vec3<f32>;
var phi_2087_: vec3<f32>;
var phi_2089_: type_17;
var phi_2151_: i32;
var phi_2952_: bool;
var phi_3191_: bool;
var phi_4055_: u32;
var phi_4058_: f32;
var phi_4193_: i32;
var phi_4206_: i32;
var phi_4220_: i32;
var phi_4536_: i32;
var phi_4549_: i32;
var phi_4563_: i32;
var phi_4056_: u32;
var phi_4059_: f32;
var phi_4768_: f32;
var phi_4781_: u32;
var phi_4784_: f32;
var phi_4919_: i32;
var phi_4932_: i32;
var phi_4946_: i32;
var phi_5262_: i32;
var phi_5275_: i32;
var phi_5289_: i32;
var phi_4782_: u32;
var phi_4785_: f32;
var phi_5494_: f32;
var phi_5616_: i32;
var phi_5629_: i32;
var phi_5643_: i32;
var phi_5843_: f32;
var phi_6186_: vec3<f32>;
var phi_6188_: vec3<f32>;
var phi_6189_: bool;
var phi_6232_: vec3<f32>;
var phi_6233_: vec3<f32>;
var phi_6241_: type_17;
var phi_6242_: type_17;
var phi_6263_: vec3<f32>;
var phi_6264_: vec3<f32>;
var phi_6265_: type_17;
var phi_2085_: vec3<f32>;
var phi_2088_: vec3<f32>;
var phi_2090_: type_17;
var phi_1885_: vec3<f32>;
var phi_1888_: vec3<f32>;
var phi_1890_: u32;
var local_39: vec3<f32>;
var local_40: vec3<f32>;
var local_41: vec3<f32>;
var local_42: vec3<f32>;
var local_43: vec3<f32>;
var local_44: vec3<f32>;
var phi_6316_: array<f32, 19>;
var local_45: f32;
var local_46: f32;
var local_47: type_17;
var local_48: vec3<f32>;
var local_49: vec3<f32>;
let _e129 = global;
let _e135 = arrayLength((&global_3.member));
let _e141 = arrayLength((&global_5.member));
let _e146 = global_1.member.member;
if (_e129.x < _e146.member) {
if (_e129.y < _e146.member_1) {
let _e153 = (_e146.member * _e146.member_1);
let _e155 = ((_e129.y * _e146.member) + _e129.x);
let _e156 = bitcast<i32>(_e155);
let _e158 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e160 = select(_e158, _e156, (_e156 < _e158));
let _e166 = global_6.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e167 = (_e153 + _e155);
let _e168 = bitcast<i32>(_e167);
let _e170 = select(_e158, _e168, (_e168 < _e158));
let _e176 = global_6.member[bitcast<u32>(select(0i, _e170, (_e170 > 0i)))];
let _e178 = ((2u * _e153) + _e155);
let _e179 = bitcast<i32>(_e178);
let _e181 = select(_e158, _e179, (_e179 < _e158));
let _e187 = global_6.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e189 = ((3u * _e153) + _e155);
let _e190 = bitcast<i32>(_e189);
let _e192 = select(_e158, _e190, (_e190 < _e158));
let _e198 = global_6.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = ((4u * _e153) + _e155);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e158, _e201, (_e201 < _e158));
let _e209 = global_6.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((5u * _e153) + _e155);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e158, _e212, (_e212 < _e158));
let _e220 = global_6.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e222 = ((6u * _e153) + _e155);
let _e223 = bitcast<i32>(_e222);
let _e225 = select(_e158, _e223, (_e223 < _e158));
let _e231 = global_6.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e233 = ((7u * _e153) + _e155);
let _e234 = bitcast<i32>(_e233);
let _e236 = select(_e158, _e234, (_e234 < _e158));
let _e242 = global_6.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
let _e244 = ((8u * _e153) + _e155);
let _e245 = bitcast<i32>(_e244);
let _e247 = select(_e158, _e245, (_e245 < _e158));
let _e253 = global_6.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e255 = ((9u * _e153) + _e155);
let _e256 = bitcast<i32>(_e255);
let _e258 = select(_e158, _e256, (_e256 < _e158));
let _e264 = global_6.member[bitcast<u32>(select(0i, _e258, (_e258 > 0i)))];
let _e266 = ((10u * _e153) + _e155);
let _e267 = bitcast<i32>(_e266);
let _e269 = select(_e158, _e267, (_e267 < _e158));
let _e275 = global_6.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e277 = ((11u * _e153) + _e155);
let _e278 = bitcast<i32>(_e277);
let _e280 = select(_e158, _e278, (_e278 < _e158));
let _e286 = global_6.member[bitcast<u32>(select(0i, _e280, (_e280 > 0i)))];
let _e288 = ((12u * _e153) + _e155);
let _e289 = bitcast<i32>(_e288);
let _e291 = select(_e158, _e289, (_e289 < _e158));
let _e297 = global_6.member[bitcast<u32>(select(0i, _e291, (_e291 > 0i)))];
let _e299 = ((13u * _e153) + _e155);
let _e300 = bitcast<i32>(_e299);
let _e302 = select(_e158, _e300, (_e300 < _e158));
let _e308 = global_6.member[bitcast<u32>(select(0i, _e302, (_e302 > 0i)))];
let _e310 = ((14u * _e153) + _e155);
let _e311 = bitcast<i32>(_e310);
let _e313 = select(_e158, _e311, (_e311 < _e158));
let _e319 = global_6.member[bitcast<u32>(select(0i, _e313, (_e313 > 0i)))];
let _e321 = ((15u * _e153) + _e155);
let _e322 = bitcast<i32>(_e321);
let _e324 = select(_e158, _e322, (_e322 < _e158));
let _e330 = global_6.member[bitcast<u32>(select(0i, _e324, (_e324 > 0i)))];
let _e332 = ((16u * _e153) + _e155);
let _e333 = bitcast<i32>(_e332);
let _e335 = select(_e158, _e333, (_e333 < _e158));
let _e341 = global_6.member[bitcast<u32>(select(0i, _e335, (_e335 > 0i)))];
let _e343 = ((17u * _e153) + _e155);
let _e344 = bitcast<i32>(_e343);
let _e346 = select(_e158, _e344, (_e344 < _e158));
let _e352 = global_6.member[bitcast<u32>(select(0i, _e346, (_e346 > 0i)))];
let _e354 = ((18u * _e153) + _e155);
let _e355 = bitcast<i32>(_e354);
let _e357 = select(_e158, _e355, (_e355 < _e158));
let _e363 = global_6.member[bitcast<u32>(select(0i, _e357, (_e357 > 0i)))];
let _e368 = global_1.member.member.member;
let _e372 = global_1.member.member.member_1;
let _e373 = (_e368 * _e372);
local_24 = bitcast<i32>(_e373);
let _e376 = ((_e129.y * _e368) + _e129.x);
let _e377 = bitcast<i32>(_e376);
local_25 = _e377;
let _e378 = local_24;
let _e380 = local_25;
let _e381 = ((29i * _e378) + _e380);
let _e383 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e385 = select(_e383, _e381, (_e381 < _e383));
let _e390 = global_2.member[bitcast<u32>(select(0i, _e385, (_e385 > 0i)))];
let _e392 = local_24;
let _e394 = local_25;
let _e395 = ((36i * _e392) + _e394);
let _e397 = select(_e383, _e395, (_e395 < _e383));
let _e402 = global_2.member[bitcast<u32>(select(0i, _e397, (_e397 > 0i)))];
let _e413 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e390 == 2f) && (select(0i, select(select(i32(_e402), i32(-2147483648), (_e402 < -2147483600f)), 2147483647i, (_e402 > 2147483500f)), (_e402 == _e402)) == (bitcast<i32>(_e413) + 1i)))) > 1u) {
let _e421 = select(_e383, _e377, (_e377 < _e383));
let _e427 = global_2.member[bitcast<u32>(select(0i, _e421, (_e421 > 0i)))];
let _e429 = bitcast<i32>((_e373 + _e376));
let _e431 = select(_e383, _e429, (_e429 < _e383));
let _e437 = global_2.member[bitcast<u32>(select(0i, _e431, (_e431 > 0i)))];
let _e440 = bitcast<i32>(((2u * _e373) + _e376));
let _e442 = select(_e383, _e440, (_e440 < _e383));
let _e448 = global_2.member[bitcast<u32>(select(0i, _e442, (_e442 > 0i)))];
let _e451 = bitcast<i32>(((3u * _e373) + _e376));
let _e453 = select(_e383, _e451, (_e451 < _e383));
let _e459 = global_2.member[bitcast<u32>(select(0i, _e453, (_e453 > 0i)))];
let _e462 = bitcast<i32>(((4u * _e373) + _e376));
let _e464 = select(_e383, _e462, (_e462 < _e383));
let _e470 = global_2.member[bitcast<u32>(select(0i, _e464, (_e464 > 0i)))];
let _e473 = bitcast<i32>(((5u * _e373) + _e376));
let _e475 = select(_e383, _e473, (_e473 < _e383));
let _e481 = global_2.member[bitcast<u32>(select(0i, _e475, (_e475 > 0i)))];
let _e484 = bitcast<i32>(((6u * _e373) + _e376));
let _e486 = select(_e383, _e484, (_e484 < _e383));
let _e492 = global_2.member[bitcast<u32>(select(0i, _e486, (_e486 > 0i)))];
let _e495 = bitcast<i32>(((7u * _e373) + _e376));
let _e497 = select(_e383, _e495, (_e495 < _e383));
let _e503 = global_2.member[bitcast<u32>(select(0i, _e497, (_e497 > 0i)))];
let _e506 = bitcast<i32>(((8u * _e373) + _e376));
let _e508 = select(_e383, _e506, (_e506 < _e383));
let _e514 = global_2.member[bitcast<u32>(select(0i, _e508, (_e508 > 0i)))];
let _e517 = bitcast<i32>(((9u * _e373) + _e376));
let _e519 = select(_e383, _e517, (_e517 < _e383));
let _e525 = global_2.member[bitcast<u32>(select(0i, _e519, (_e519 > 0i)))];
let _e528 = bitcast<i32>(((10u * _e373) + _e376));
let _e530 = select(_e383, _e528, (_e528 < _e383));
let _e536 = global_2.member[bitcast<u32>(select(0i, _e530, (_e530 > 0i)))];
let _e539 = bitcast<i32>(((11u * _e373) + _e376));
let _e541 = select(_e383, _e539, (_e539 < _e383));
let _e547 = global_2.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e550 = bitcast<i32>(((12u * _e373) + _e376));
let _e552 = select(_e383, _e550, (_e550 < _e383));
let _e558 = global_2.member[bitcast<u32>(select(0i, _e552, (_e552 > 0i)))];
let _e561 = bitcast<i32>(((13u * _e373) + _e376));
let _e563 = select(_e383, _e561, (_e561 < _e383));
let _e569 = global_2.member[bitcast<u32>(select(0i, _e563, (_e563 > 0i)))];
let _e572 = bitcast<i32>(((14u * _e373) + _e376));
let _e574 = select(_e383, _e572, (_e572 < _e383));
let _e580 = global_2.member[bitcast<u32>(select(0i, _e574, (_e574 > 0i)))];
let _e583 = bitcast<i32>(((15u * _e373) + _e376));
let _e585 = select(_e383, _e583, (_e583 < _e383));
let _e591 = global_2.member[bitcast<u32>(select(0i, _e585, (_e585 > 0i)))];
let _e594 = bitcast<i32>(((16u * _e373) + _e376));
let _e596 = select(_e383, _e594, (_e594 < _e383));
let _e602 = global_2.member[bitcast<u32>(select(0i, _e596, (_e596 > 0i)))];
let _e605 = bitcast<i32>(((17u * _e373) + _e376));
let _e607 = select(_e383, _e605, (_e605 < _e383));
let _e613 = global_2.member[bitcast<u32>(select(0i, _e607, (_e607 > 0i)))];
let _e616 = bitcast<i32>(((18u * _e373) + _e376));
let _e618 = select(_e383, _e616, (_e616 < _e383));
let _e624 = global_2.member[bitcast<u32>(select(0i, _e618, (_e618 > 0i)))];
let _e627 = bitcast<i32>(((19u * _e373) + _e376));
let _e629 = select(_e383, _e627, (_e627 < _e383));
let _e635 = global_2.member[bitcast<u32>(select(0i, _e629, (_e629 > 0i)))];
let _e638 = bitcast<i32>(((20u * _e373) + _e376));
let _e640 = select(_e383, _e638, (_e638 < _e383));
let _e646 = global_2.member[bitcast<u32>(select(0i, _e640, (_e640 > 0i)))];
let _e649 = bitcast<i32>(((24u * _e373) + _e376));
let _e651 = select(_e383, _e649, (_e649 < _e383));
let _e657 = global_2.member[bitcast<u32>(select(0i, _e651, (_e651 > 0i)))];
let _e660 = bitcast<i32>(((30u * _e373) + _e376));
let _e662 = select(_e383, _e660, (_e660 < _e383));
let _e668 = global_2.member[bitcast<u32>(select(0i, _e662, (_e662 > 0i)))];
let _e676 = (select(0i, select(select(i32(_e668), i32(-2147483648), (_e668 < -2147483600f)), 2147483647i, (_e668 > 2147483500f)), (_e668 == _e668)) == 0i);
let _e684 = global_1.member.member_1.member;
let _e690 = global_1.member.member_1.member_1;
let _e700 = global_1.member.member_2.member;
let _e701 = (((((f32(bitcast<i32>(_e129.x)) + 0.5f) / f32(bitcast<i32>(_e684))) * 2f) - 1f) * _e700);
let _e709 = global_1.member.member_2.member_1;
let _e710 = ((1f - (((f32(bitcast<i32>(_e129.y)) + 0.5f) / f32(bitcast<i32>(_e690))) * 2f)) * _e709);
let _e713 = global_1.member.member_3;
let _e722 = global_1.member.member_4;
let _e735 = global_1.member.member_2.member_3;
let _e736 = (_e735 != 0u);
let _e739 = global_1.member.member_6;
let _e746 = select(_e739.member, (_e739.member + ((_e713.member * _e701) + (_e722.member * _e710))), _e736);
let _e747 = select(_e739.member_1, (_e739.member_1 + ((_e713.member_1 * _e701) + (_e722.member_1 * _e710))), _e736);
let _e748 = select(_e739.member_2, (_e739.member_2 + ((_e713.member_2 * _e701) + (_e722.member_2 * _e710))), _e736);
let _e758 = select(_e427, _e746, _e676);
let _e759 = select(_e437, _e747, _e676);
let _e760 = select(_e448, _e748, _e676);
let _e761 = (select(0f, ((((_e427 - _e746) * _e459) + ((_e437 - _e747) * _e470)) + ((_e448 - _e748) * _e481)), _e676) + _e657);
let _e762 = select(_e624, 1f, _e676);
let _e763 = select(_e635, 1f, _e676);
let _e764 = select(_e646, 1f, _e676);
let _e772 = (1f / select(_e459, select(1e-12f, -1e-12f, (_e459 < 0f)), (bitcast<f32>((bitcast<u32>(_e459) & 2147483647u)) < 1e-12f)));
let _e780 = (1f / select(_e470, select(1e-12f, -1e-12f, (_e470 < 0f)), (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) < 1e-12f)));
let _e788 = (1f / select(_e481, select(1e-12f, -1e-12f, (_e481 < 0f)), (bitcast<f32>((bitcast<u32>(_e481) & 2147483647u)) < 1e-12f)));
let _e792 = global_1.member.member_13.member_4;
let _e799 = global_1.member.member_13.member_5;
let _e804 = ((_e792.member - _e758) * _e772);
let _e806 = ((_e799.member - _e758) * _e772);
let _e808 = ((_e792.member_1 - _e759) * _e780);
let _e810 = ((_e799.member_1 - _e759) * _e780);
let _e812 = ((_e792.member_2 - _e760) * _e788);
let _e814 = ((_e799.member_2 - _e760) * _e788);
let _e816 = select(_e806, _e804, (_e804 < _e806));
let _e818 = select(_e810, _e808, (_e808 < _e810));
let _e820 = select(_e818, _e816, (_e816 > _e818));
let _e822 = select(_e814, _e812, (_e812 < _e814));
let _e824 = select(_e822, _e820, (_e820 > _e822));
let _e826 = select(_e806, _e804, (_e804 > _e806));
let _e828 = select(_e810, _e808, (_e808 > _e810));
let _e830 = select(_e828, _e826, (_e826 < _e828));
let _e832 = select(_e814, _e812, (_e812 > _e814));
let _e834 = select(_e832, _e830, (_e830 < _e832));
let _e836 = select(0f, _e824, (_e824 > 0f));
let _e838 = select(_e761, _e834, (_e834 < _e761));
let _e839 = (_e838 > _e836);
let _e840 = select(0f, _e836, _e839);
let _e841 = select(0f, _e838, _e839);
if ((_e676 || (_e841 <= _e840)) || ((((_e762 + _e763) + _e764) * (1f / 3f)) < 0.01f)) {
phi_6316_ = array<f32, 19>(_e166, _e176, _e187, _e198, _e209, _e220, _e231, _e242, _e253, _e264, _e275, _e286, _e297, _e308, _e319, _e330, _e341, _e352, _e363);
} else {
let _e854 = (((_e492 * _e492) + (_e503 * _e503)) + (_e514 * _e514));
let _e862 = (((_e525 * _e525) + (_e536 * _e536)) + (_e547 * _e547));
let _e867 = (0.5f * (sqrt(select(0f, _e854, (_e854 > 0f))) + sqrt(select(0f, _e862, (_e862 > 0f)))));
let _e872 = (((_e558 * _e558) + (_e569 * _e569)) + (_e580 * _e580));
let _e880 = (((_e591 * _e591) + (_e602 * _e602)) + (_e613 * _e613));
let _e885 = (0.5f * (sqrt(select(0f, _e872, (_e872 > 0f))) + sqrt(select(0f, _e880, (_e880 > 0f)))));
let _e889 = global_1.member.member_11.member;
let _e891 = bitcast<i32>((_e889 * _e889));
phi_1884_ = vec3<f32>(0f, 0f, 0f);
phi_1887_ = vec3<f32>(0f, 0f, 0f);
phi_1889_ = 0u;
loop {
let _e893 = phi_1884_;
let _e895 = phi_1887_;
let _e897 = phi_1889_;
local_39 = _e895;
local_40 = _e895;
local_41 = _e895;
local_42 = _e893;
local_43 = _e893;
local_44 = _e893;
let _e901 = global_1.member.member_12.member_8;
let _e902 = (_e897 <= _e901);
if _e902 {
let _e906 = global_1.member.member_12.member_5;
let _e908 = bitcast<i32>((_e897 * _e906));
phi_1909_ = 0u;
loop {
let _e910 = phi_1909_;
local_38 = _e910;
let _e914 = ((1u << bitcast<u32>((_e910 & 31u))) < _e889);
if _e914 {
phi_1910_ = (_e910 + 1u);
} else {
phi_1910_ = u32();
}
let _e917 = phi_1910_;
continue;
continuing {
phi_1909_ = _e917;
break if !(_e914);
}
}
phi_1922_ = 0u;
loop {
let _e920 = phi_1922_;
local_26 = _e920;
local_27 = _e920;
let _e924 = ((1u << bitcast<u32>((_e920 & 31u))) < _e889);
if _e924 {
phi_1923_ = (_e920 + 1u);
} else {
phi_1923_ = u32();
}
let _e927 = phi_1923_;
continue;
continuing {
phi_1922_ = _e927;
break if !(_e924);
}
}
let _e930 = local_26;
let _e933 = local_27;
phi_1940_ = 0u;
loop {
let _e936 = phi_1940_;
local_30 = _e936;
let _e940 = ((1u << bitcast<u32>((_e936 & 31u))) < _e889);
if _e940 {
phi_1941_ = (_e936 + 1u);
} else {
phi_1941_ = u32();
}
let _e943 = phi_1941_;
continue;
continuing {
phi_1940_ = _e943;
break if !(_e940);
}
}
phi_1953_ = 0u;
loop {
let _e946 = phi_1953_;
local_28 = _e946;
local_29 = _e946;
let _e950 = ((1u << bitcast<u32>((_e946 & 31u))) < _e889);
if _e950 {
phi_1954_ = (_e946 + 1u);
} else {
phi_1954_ = u32();
}
let _e953 = phi_1954_;
continue;
continuing {
phi_1953_ = _e953;
break if !(_e950);
}
}
let _e956 = local_28;
let _e959 = local_29;
let _e962 = local_30;
let _e971 = global_1.member.member_12.member_7;
phi_1979_ = 0u;
loop {
let _e974 = phi_1979_;
local_31 = _e974;
local_32 = _e974;
let _e978 = ((1u << bitcast<u32>((_e974 & 31u))) < _e889);
if _e978 {
phi_1980_ = (_e974 + 1u);
} else {
phi_1980_ = u32();
}
let _e981 = phi_1980_;
continue;
continuing {
phi_1979_ = _e981;
break if !(_e978);
}
}
let _e984 = local_31;
let _e987 = local_32;
phi_1997_ = 0u;
loop {
let _e990 = phi_1997_;
local_33 = _e990;
local_34 = _e990;
let _e994 = ((1u << bitcast<u32>((_e990 & 31u))) < _e889);
if _e994 {
phi_1998_ = (_e990 + 1u);
} else {
phi_1998_ = u32();
}
let _e997 = phi_1998_;
continue;
continuing {
phi_1997_ = _e997;
break if !(_e994);
}
}
let _e1000 = local_33;
let _e1006 = local_34;
phi_2020_ = 0u;
loop {
let _e1016 = phi_2020_;
local_37 = _e1016;
let _e1020 = ((1u << bitcast<u32>((_e1016 & 31u))) < _e889);
if _e1020 {
phi_2021_ = (_e1016 + 1u);
} else {
phi_2021_ = u32();
}
let _e1023 = phi_2021_;
continue;
continuing {
phi_2020_ = _e1023;
break if !(_e1020);
}
}
phi_2033_ = 0u;
loop {
let _e1026 = phi_2033_;
local_35 = _e1026;
local_36 = _e1026;
let _e1030 = ((1u << bitcast<u32>((_e1026 & 31u))) < _e889);
if _e1030 {
phi_2034_ = (_e1026 + 1u);
} else {
phi_2034_ = u32();
}
let _e1033 = phi_2034_;
continue;
continuing {
phi_2033_ = _e1033;
break if !(_e1030);
}
}
let _e1036 = local_35;
let _e1039 = local_36;
let _e1042 = local_37;
let _e1048 = (((((1u << bitcast<u32>(((2u * _e1000) & 31u))) - (1u << bitcast<u32>(((2u * (_e1006 - select(6u, _e987, (_e984 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1042 - select(6u, _e1039, (_e1036 < 6u)))) & 31u))));
let _e1049 = (_e1048 / 64u);
if ((_e1048 % 64u) > 0u) {
phi_2070_ = (_e1049 + 1u);
} else {
phi_2070_ = _e1049;
}
let _e1054 = phi_2070_;
let _e1057 = local_38;
local_23 = type_24(_e1057, select(6u, _e933, (_e930 < 6u)), (1u << bitcast<u32>(((2u * (_e962 - select(6u, _e959, (_e956 < 6u)))) & 31u))), (_e897 * _e971), (_e1054 * 64u));
let _e1059 = (_e897 == 0u);
let _e1061 = local_23.member_1;
phi_2084_ = _e893;
phi_2087_ = _e895;
phi_2089_ = type_17(_e1061, 0u);
loop {
let _e1064 = phi_2084_;
let _e1066 = phi_2087_;
let _e1068 = phi_2089_;
local_48 = _e1064;
local_49 = _e1066;
let _e1071 = local_23.member_1;
let _e1074 = local_23.member_2;
let _e1076 = ((_e1068.member < _e1071) || (_e1068.member_1 < _e1074));
if _e1076 {
let _e1077 = (_e1068.member_1 & 1431655765u);
let _e1081 = ((_e1077 | (_e1077 >> bitcast<u32>(1i))) & 858993459u);
let _e1085 = ((_e1081 | (_e1081 >> bitcast<u32>(2i))) & 252645135u);
let _e1089 = ((_e1085 | (_e1085 >> bitcast<u32>(4i))) & 16711935u);
let _e1093 = ((_e1089 | (_e1089 >> bitcast<u32>(8i))) & 65535u);
let _e1096 = ((_e1068.member_1 >> bitcast<u32>(1i)) & 1431655765u);
let _e1100 = ((_e1096 | (_e1096 >> bitcast<u32>(1i))) & 858993459u);
let _e1104 = ((_e1100 | (_e1100 >> bitcast<u32>(2i))) & 252645135u);
let _e1108 = ((_e1104 | (_e1104 >> bitcast<u32>(4i))) & 16711935u);
let _e1112 = ((_e1108 | (_e1108 >> bitcast<u32>(8i))) & 65535u);
let _e1115 = ((_e1093 < _e889) && (_e1112 < _e889));
if _e1115 {
phi_2151_ = bitcast<i32>(((_e1112 * _e889) + _e1093));
} else {
phi_2151_ = 0i;
}
let _e1120 = phi_2151_;
let _e1121 = (_e1068.member > 0u);
if _e1121 {
local_21.member = _e1068.member;
local_21.member_1 = _e1068.member_1;
let _e1260 = local_21.member;
let _e1261 = local_21.member_1;
let _e1263 = local_23.member;
let _e1278 = local_23.member_3;
local_22 = (_e1278 + (((((1u << bitcast<u32>(((2u * _e1263) & 31u))) - (1u << bitcast<u32>(((2u * (_e1263 - _e1260)) & 31u)))) / 3u) * 4u) + _e1261));
let _e1280 = local_22;
let _e1281 = bitcast<i32>(_e1280);
let _e1283 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1285 = select(_e1283, _e1281, (_e1281 < _e1283));
let _e1290 = global_4.member[bitcast<u32>(select(0i, _e1285, (_e1285 > 0i)))];
let _e1291 = local_22;
let _e1293 = local_23.member_4;
let _e1295 = bitcast<i32>((_e1291 + _e1293));
let _e1297 = select(_e1283, _e1295, (_e1295 < _e1283));
let _e1302 = global_4.member[bitcast<u32>(select(0i, _e1297, (_e1297 > 0i)))];
let _e1303 = local_22;
let _e1304 = local_23.member_4;
let _e1307 = bitcast<i32>((_e1303 + (2u * _e1304)));
let _e1309 = select(_e1283, _e1307, (_e1307 < _e1283));
let _e1314 = global_4.member[bitcast<u32>(select(0i, _e1309, (_e1309 > 0i)))];
let _e1315 = local_21.member;
let _e1316 = local_21.member_1;
let _e1317 = local_23.member;
let _e1331 = local_23.member_3;
let _e1332 = local_23.member_4;
local_20 = ((_e1331 + (3u * _e1332)) + (((((1u << bitcast<u32>(((2u * _e1317) & 31u))) - (1u << bitcast<u32>(((2u * (_e1317 - _e1315)) & 31u)))) / 3u) * 4u) + _e1316));
let _e1336 = local_20;
let _e1337 = bitcast<i32>(_e1336);
let _e1339 = select(_e1283, _e1337, (_e1337 < _e1283));
let _e1344 = global_4.member[bitcast<u32>(select(0i, _e1339, (_e1339 > 0i)))];
let _e1345 = local_20;
let _e1346 = local_23.member_4;
let _e1348 = bitcast<i32>((_e1345 + _e1346));
let _e1350 = select(_e1283, _e1348, (_e1348 < _e1283));
let _e1355 = global_4.member[bitcast<u32>(select(0i, _e1350, (_e1350 > 0i)))];
let _e1356 = local_20;
let _e1357 = local_23.member_4;
let _e1360 = bitcast<i32>((_e1356 + (2u * _e1357)));
let _e1362 = select(_e1283, _e1360, (_e1360 < _e1283));
let _e1367 = global_4.member[bitcast<u32>(select(0i, _e1362, (_e1362 > 0i)))];
let _e1369 = ((_e1290 - _e758) * _e772);
let _e1371 = ((_e1344 - _e758) * _e772);
let _e1373 = ((_e1302 - _e759) * _e780);
let _e1375 = ((_e1355 - _e759) * _e780);
let _e1377 = ((_e1314 - _e760) * _e788);
let _e1379 = ((_e1367 - _e760) * _e788);
let _e1381 = select(_e1371, _e1369, (_e1369 < _e1371));
let _e1383 = select(_e1375, _e1373, (_e1373 < _e1375));
let _e1385 = select(_e1383, _e1381, (_e1381 > _e1383));
let _e1387 = select(_e1379, _e1377, (_e1377 < _e1379));
let _e1389 = select(_e1387, _e1385, (_e1385 > _e1387));
let _e1391 = select(_e1371, _e1369, (_e1369 > _e1371));
let _e1393 = select(_e1375, _e1373, (_e1373 > _e1375));
let _e1395 = select(_e1393, _e1391, (_e1391 < _e1393));
let _e1397 = select(_e1379, _e1377, (_e1377 > _e1379));
let _e1399 = select(_e1397, _e1395, (_e1395 < _e1397));
if ((_e1290 <= _e1344) && (select(_e840, _e1389, (_e1389 > _e840)) <= select(_e841, _e1399, (_e1399 < _e841)))) {
let _e1407 = local_21.member;
let _e1408 = local_21.member_1;
let _e1409 = local_23.member;
let _e1423 = local_23.member_3;
let _e1424 = local_23.member_4;
local_19 = ((_e1423 + (6u * _e1424)) + (((((1u << bitcast<u32>(((2u * _e1409) & 31u))) - (1u << bitcast<u32>(((2u * (_e1409 - _e1407)) & 31u)))) / 3u) * 4u) + _e1408));
let _e1428 = local_19;
let _e1429 = bitcast<i32>(_e1428);
let _e1431 = select(_e1283, _e1429, (_e1429 < _e1283));
let _e1436 = global_4.member[bitcast<u32>(select(0i, _e1431, (_e1431 > 0i)))];
let _e1437 = local_19;
let _e1438 = local_23.member_4;
let _e1440 = bitcast<i32>((_e1437 + _e1438));
let _e1442 = select(_e1283, _e1440, (_e1440 < _e1283));
let _e1447 = global_4.member[bitcast<u32>(select(0i, _e1442, (_e1442 > 0i)))];
let _e1448 = local_19;
let _e1449 = local_23.member_4;
let _e1452 = bitcast<i32>((_e1448 + (2u * _e1449)));
let _e1454 = select(_e1283, _e1452, (_e1452 < _e1283));
let _e1459 = global_4.member[bitcast<u32>(select(0i, _e1454, (_e1454 > 0i)))];
let _e1460 = local_21.member;
let _e1461 = local_21.member_1;
let _e1462 = local_23.member;
let _e1476 = local_23.member_3;
let _e1477 = local_23.member_4;
local_18 = ((_e1476 + (9u * _e1477)) + (((((1u << bitcast<u32>(((2u * _e1462) & 31u))) - (1u << bitcast<u32>(((2u * (_e1462 - _e1460)) & 31u)))) / 3u) * 4u) + _e1461));
let _e1481 = local_18;
let _e1482 = bitcast<i32>(_e1481);
let _e1484 = select(_e1283, _e1482, (_e1482 < _e1283));
let _e1489 = global_4.member[bitcast<u32>(select(0i, _e1484, (_e1484 > 0i)))];
let _e1490 = local_18;
let _e1491 = local_23.member_4;
let _e1493 = bitcast<i32>((_e1490 + _e1491));
let _e1495 = select(_e1283, _e1493, (_e1493 < _e1283));
let _e1500 = global_4.member[bitcast<u32>(select(0i, _e1495, (_e1495 > 0i)))];
let _e1501 = local_18;
let _e1502 = local_23.member_4;
let _e1505 = bitcast<i32>((_e1501 + (2u * _e1502)));
let _e1507 = select(_e1283, _e1505, (_e1505 < _e1283));
let _e1512 = global_4.member[bitcast<u32>(select(0i, _e1507, (_e1507 > 0i)))];
let _e1513 = local_21.member;
let _e1514 = local_21.member_1;
let _e1515 = local_23.member;
let _e1529 = local_23.member_3;
let _e1530 = local_23.member_4;
local_17 = ((_e1529 + (12u * _e1530)) + (((((1u << bitcast<u32>(((2u * _e1515) & 31u))) - (1u << bitcast<u32>(((2u * (_e1515 - _e1513)) & 31u)))) / 3u) * 4u) + _e1514));
let _e1534 = local_17;
let _e1535 = bitcast<i32>(_e1534);
let _e1537 = select(_e1283, _e1535, (_e1535 < _e1283));
let _e1542 = global_4.member[bitcast<u32>(select(0i, _e1537, (_e1537 > 0i)))];
let _e1543 = local_17;
let _e1544 = local_23.member_4;
let _e1546 = bitcast<i32>((_e1543 + _e1544));
let _e1548 = select(_e1283, _e1546, (_e1546 < _e1283));
let _e1553 = global_4.member[bitcast<u32>(select(0i, _e1548, (_e1548 > 0i)))];
let _e1554 = local_17;
let _e1555 = local_23.member_4;
let _e1558 = bitcast<i32>((_e1554 + (2u * _e1555)));
let _e1560 = select(_e1283, _e1558, (_e1558 < _e1283));
let _e1565 = global_4.member[bitcast<u32>(select(0i, _e1560, (_e1560 > 0i)))];
let _e1566 = local_21.member;
let _e1567 = local_21.member_1;
let _e1568 = local_23.member;
let _e1582 = local_23.member_3;
let _e1583 = local_23.member_4;
local_16 = ((_e1582 + (15u * _e1583)) + (((((1u << bitcast<u32>(((2u * _e1568) & 31u))) - (1u << bitcast<u32>(((2u * (_e1568 - _e1566)) & 31u)))) / 3u) * 4u) + _e1567));
let _e1587 = local_16;
let _e1588 = bitcast<i32>(_e1587);
let _e1590 = select(_e1283, _e1588, (_e1588 < _e1283));
let _e1595 = global_4.member[bitcast<u32>(select(0i, _e1590, (_e1590 > 0i)))];
let _e1596 = local_16;
let _e1597 = local_23.member_4;
let _e1599 = bitcast<i32>((_e1596 + _e1597));
let _e1601 = select(_e1283, _e1599, (_e1599 < _e1283));
let _e1606 = global_4.member[bitcast<u32>(select(0i, _e1601, (_e1601 > 0i)))];
let _e1607 = local_16;
let _e1608 = local_23.member_4;
let _e1611 = bitcast<i32>((_e1607 + (2u * _e1608)));
let _e1613 = select(_e1283, _e1611, (_e1611 < _e1283));
let _e1618 = global_4.member[bitcast<u32>(select(0i, _e1613, (_e1613 > 0i)))];
let _e1619 = (_e1436 - _e758);
let _e1620 = (_e1447 - _e759);
let _e1621 = (_e1459 - _e760);
let _e1624 = ((_e1553 * _e481) - (_e1565 * _e470));
let _e1627 = ((_e1565 * _e459) - (_e1542 * _e481));
let _e1630 = ((_e1542 * _e470) - (_e1553 * _e459));
let _e1678 = (((_e1489 * _e1489) + (_e1500 * _e1500)) + (_e1512 * _e1512));
let _e1681 = sqrt(select(0f, _e1678, (_e1678 > 0f)));
let _e1686 = (((_e1595 * _e1595) + (_e1606 * _e1606)) + (_e1618 * _e1618));
let _e1696 = (((_e1619 * _e1619) + (_e1620 * _e1620)) + (_e1621 * _e1621));
phi_2952_ = (bitcast<f32>((bitcast<u32>((((_e1619 * _e1624) + (_e1620 * _e1627)) + (_e1621 * _e1630))) & 2147483647u)) <= ((((((bitcast<f32>((bitcast<u32>(_e1624) & 2147483647u)) * _e1489) + (bitcast<f32>((bitcast<u32>(_e1627) & 2147483647u)) * _e1500)) + (bitcast<f32>((bitcast<u32>(_e1630) & 2147483647u)) * _e1512)) + (((bitcast<f32>((bitcast<u32>(((_e470 * _e1621) - (_e481 * _e1620))) & 2147483647u)) * _e1595) + (bitcast<f32>((bitcast<u32>(((_e481 * _e1619) - (_e459 * _e1621))) & 2147483647u)) * _e1606)) + (bitcast<f32>((bitcast<u32>(((_e459 * _e1620) - (_e470 * _e1619))) & 2147483647u)) * _e1618))) + (_e1681 * sqrt(select(0f, _e1686, (_e1686 > 0f))))) + (_e867 + (_e885 * (sqrt(select(0f, _e1696, (_e1696 > 0f))) + _e1681)))));
} else {
phi_2952_ = false;
}
let _e1709 = phi_2952_;
phi_3191_ = _e1709;
} else {
local_13 = _e908;
local_14 = _e1120;
local_15 = _e891;
let _e1122 = local_13;
let _e1123 = local_14;
let _e1124 = (_e1122 + _e1123);
let _e1126 = (bitcast<i32>(_e135) - 1i);
let _e1128 = select(_e1126, _e1124, (_e1124 < _e1126));
let _e1133 = global_3.member[bitcast<u32>(select(0i, _e1128, (_e1128 > 0i)))];
let _e1134 = local_13;
let _e1135 = local_15;
let _e1137 = local_14;
let _e1138 = ((_e1134 + _e1135) + _e1137);
let _e1140 = select(_e1126, _e1138, (_e1138 < _e1126));
let _e1145 = global_3.member[bitcast<u32>(select(0i, _e1140, (_e1140 > 0i)))];
let _e1146 = local_13;
let _e1147 = local_15;
let _e1150 = local_14;
let _e1151 = ((_e1146 + (2i * _e1147)) + _e1150);
let _e1153 = select(_e1126, _e1151, (_e1151 < _e1126));
let _e1158 = global_3.member[bitcast<u32>(select(0i, _e1153, (_e1153 > 0i)))];
let _e1159 = local_13;
let _e1160 = local_15;
let _e1163 = local_14;
let _e1164 = ((_e1159 + (3i * _e1160)) + _e1163);
let _e1166 = select(_e1126, _e1164, (_e1164 < _e1126));
let _e1171 = global_3.member[bitcast<u32>(select(0i, _e1166, (_e1166 > 0i)))];
let _e1172 = local_13;
let _e1173 = local_15;
let _e1176 = local_14;
let _e1177 = ((_e1172 + (4i * _e1173)) + _e1176);
let _e1179 = select(_e1126, _e1177, (_e1177 < _e1126));
let _e1184 = global_3.member[bitcast<u32>(select(0i, _e1179, (_e1179 > 0i)))];
let _e1185 = local_13;
let _e1186 = local_15;
let _e1189 = local_14;
let _e1190 = ((_e1185 + (5i * _e1186)) + _e1189);
let _e1192 = select(_e1126, _e1190, (_e1190 < _e1126));
let _e1197 = global_3.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1198 = (_e1133 - _e758);
let _e1199 = (_e1145 - _e759);
let _e1200 = (_e1158 - _e760);
let _e1219 = (((_e1198 * _e1198) + (_e1199 * _e1199)) + (_e1200 * _e1200));
let _e1223 = local_13;
let _e1224 = local_15;
let _e1227 = local_14;
let _e1228 = ((_e1223 + (21i * _e1224)) + _e1227);
let _e1230 = select(_e1126, _e1228, (_e1228 < _e1126));
let _e1235 = global_3.member[bitcast<u32>(select(0i, _e1230, (_e1230 > 0i)))];
let _e1240 = local_13;
let _e1241 = local_15;
let _e1244 = local_14;
let _e1245 = ((_e1240 + (22i * _e1241)) + _e1244);
let _e1247 = select(_e1126, _e1245, (_e1245 < _e1126));
let _e1252 = global_3.member[bitcast<u32>(select(0i, _e1247, (_e1247 > 0i)))];
phi_3191_ = (_e1115 && (bitcast<f32>((bitcast<u32>((((_e459 * ((_e1199 * _e1197) - (_e1200 * _e1184))) + (_e470 * ((_e1200 * _e1171) - (_e1198 * _e1197)))) + (_e481 * ((_e1198 * _e1184) - (_e1199 * _e1171))))) & 2147483647u)) <= ((_e1235 + _e867) + ((_e1252 + _e885) * sqrt(select(0f, _e1219, (_e1219 > 0f)))))));
}
let _e1711 = phi_3191_;
if (_e1711 && _e1121) {
phi_6263_ = _e1064;
phi_6264_ = _e1066;
phi_6265_ = type_17((_e1068.member - 1u), (_e1068.member_1 << bitcast<u32>(2i)));
} else {
if _e1711 {
local_10 = _e908;
local_11 = _e1120;
local_12 = _e891;
let _e1713 = local_10;
let _e1714 = local_11;
let _e1715 = (_e1713 + _e1714);
let _e1717 = (bitcast<i32>(_e135) - 1i);
let _e1719 = select(_e1717, _e1715, (_e1715 < _e1717));
let _e1724 = global_3.member[bitcast<u32>(select(0i, _e1719, (_e1719 > 0i)))];
let _e1725 = local_10;
let _e1726 = local_12;
let _e1728 = local_11;
let _e1729 = ((_e1725 + _e1726) + _e1728);
let _e1731 = select(_e1717, _e1729, (_e1729 < _e1717));
let _e1736 = global_3.member[bitcast<u32>(select(0i, _e1731, (_e1731 > 0i)))];
let _e1737 = local_10;
let _e1738 = local_12;
let _e1741 = local_11;
let _e1742 = ((_e1737 + (2i * _e1738)) + _e1741);
let _e1744 = select(_e1717, _e1742, (_e1742 < _e1717));
let _e1749 = global_3.member[bitcast<u32>(select(0i, _e1744, (_e1744 > 0i)))];
let _e1750 = local_10;
let _e1751 = local_12;
let _e1754 = local_11;
let _e1755 = ((_e1750 + (3i * _e1751)) + _e1754);
let _e1757 = select(_e1717, _e1755, (_e1755 < _e1717));
let _e1762 = global_3.member[bitcast<u32>(select(0i, _e1757, (_e1757 > 0i)))];
let _e1763 = local_10;
let _e1764 = local_12;
let _e1767 = local_11;
let _e1768 = ((_e1763 + (4i * _e1764)) + _e1767);
let _e1770 = select(_e1717, _e1768, (_e1768 < _e1717));
let _e1775 = global_3.member[bitcast<u32>(select(0i, _e1770, (_e1770 > 0i)))];
let _e1776 = local_10;
let _e1777 = local_12;
let _e1780 = local_11;
let _e1781 = ((_e1776 + (5i * _e1777)) + _e1780);
let _e1783 = select(_e1717, _e1781, (_e1781 < _e1717));
let _e1788 = global_3.member[bitcast<u32>(select(0i, _e1783, (_e1783 > 0i)))];
let _e1789 = local_10;
let _e1790 = local_12;
let _e1793 = local_11;
let _e1794 = ((_e1789 + (6i * _e1790)) + _e1793);
let _e1796 = select(_e1717, _e1794, (_e1794 < _e1717));
let _e1801 = global_3.member[bitcast<u32>(select(0i, _e1796, (_e1796 > 0i)))];
let _e1802 = local_10;
let _e1803 = local_12;
let _e1806 = local_11;
let _e1807 = ((_e1802 + (7i * _e1803)) + _e1806);
let _e1809 = select(_e1717, _e1807, (_e1807 < _e1717));
let _e1814 = global_3.member[bitcast<u32>(select(0i, _e1809, (_e1809 > 0i)))];
let _e1815 = local_10;
let _e1816 = local_12;
let _e1819 = local_11;
let _e1820 = ((_e1815 + (8i * _e1816)) + _e1819);
let _e1822 = select(_e1717, _e1820, (_e1820 < _e1717));
let _e1827 = global_3.member[bitcast<u32>(select(0i, _e1822, (_e1822 > 0i)))];
let _e1828 = local_10;
let _e1829 = local_12;
let _e1832 = local_11;
let _e1833 = ((_e1828 + (9i * _e1829)) + _e1832);
let _e1835 = select(_e1717, _e1833, (_e1833 < _e1717));
let _e1840 = global_3.member[bitcast<u32>(select(0i, _e1835, (_e1835 > 0i)))];
let _e1841 = local_10;
let _e1842 = local_12;
let _e1845 = local_11;
let _e1846 = ((_e1841 + (10i * _e1842)) + _e1845);
let _e1848 = select(_e1717, _e1846, (_e1846 < _e1717));
let _e1853 = global_3.member[bitcast<u32>(select(0i, _e1848, (_e1848 > 0i)))];
let _e1854 = local_10;
let _e1855 = local_12;
let _e1858 = local_11;
let _e1859 = ((_e1854 + (11i * _e1855)) + _e1858);
let _e1861 = select(_e1717, _e1859, (_e1859 < _e1717));
let _e1866 = global_3.member[bitcast<u32>(select(0i, _e1861, (_e1861 > 0i)))];
let _e1867 = local_10;
let _e1868 = local_12;
let _e1871 = local_11;
let _e1872 = ((_e1867 + (12i * _e1868)) + _e1871);
let _e1874 = select(_e1717, _e1872, (_e1872 < _e1717));
let _e1879 = global_3.member[bitcast<u32>(select(0i, _e1874, (_e1874 > 0i)))];
let _e1880 = local_10;
let _e1881 = local_12;
let _e1884 = local_11;
let _e1885 = ((_e1880 + (13i * _e1881)) + _e1884);
let _e1887 = select(_e1717, _e1885, (_e1885 < _e1717));
let _e1892 = global_3.member[bitcast<u32>(select(0i, _e1887, (_e1887 > 0i)))];
let _e1893 = local_10;
let _e1894 = local_12;
let _e1897 = local_11;
let _e1898 = ((_e1893 + (14i * _e1894)) + _e1897);
let _e1900 = select(_e1717, _e1898, (_e1898 < _e1717));
let _e1905 = global_3.member[bitcast<u32>(select(0i, _e1900, (_e1900 > 0i)))];
let _e1906 = local_10;
let _e1907 = local_12;
let _e1910 = local_11;
let _e1911 = ((_e1906 + (15i * _e1907)) + _e1910);
let _e1913 = select(_e1717, _e1911, (_e1911 < _e1717));
let _e1918 = global_3.member[bitcast<u32>(select(0i, _e1913, (_e1913 > 0i)))];
let _e1919 = local_10;
let _e1920 = local_12;
let _e1923 = local_11;
let _e1924 = ((_e1919 + (16i * _e1920)) + _e1923);
let _e1926 = select(_e1717, _e1924, (_e1924 < _e1717));
let _e1931 = global_3.member[bitcast<u32>(select(0i, _e1926, (_e1926 > 0i)))];
let _e1932 = local_10;
let _e1933 = local_12;
let _e1936 = local_11;
let _e1937 = ((_e1932 + (17i * _e1933)) + _e1936);
let _e1939 = select(_e1717, _e1937, (_e1937 < _e1717));
let _e1944 = global_3.member[bitcast<u32>(select(0i, _e1939, (_e1939 > 0i)))];
let _e1945 = local_10;
let _e1946 = local_12;
let _e1949 = local_11;
let _e1950 = ((_e1945 + (18i * _e1946)) + _e1949);
let _e1952 = select(_e1717, _e1950, (_e1950 < _e1717));
let _e1957 = global_3.member[bitcast<u32>(select(0i, _e1952, (_e1952 > 0i)))];
let _e1958 = local_10;
let _e1959 = local_12;
let _e1962 = local_11;
let _e1963 = ((_e1958 + (19i * _e1959)) + _e1962);
let _e1965 = select(_e1717, _e1963, (_e1963 < _e1717));
let _e1970 = global_3.member[bitcast<u32>(select(0i, _e1965, (_e1965 > 0i)))];
let _e1971 = local_10;
let _e1972 = local_12;
let _e1975 = local_11;
let _e1976 = ((_e1971 + (20i * _e1972)) + _e1975);
let _e1978 = select(_e1717, _e1976, (_e1976 < _e1717));
let _e1983 = global_3.member[bitcast<u32>(select(0i, _e1978, (_e1978 > 0i)))];
let _e1984 = local_10;
let _e1985 = local_12;
let _e1988 = local_11;
let _e1989 = ((_e1984 + (23i * _e1985)) + _e1988);
let _e1991 = select(_e1717, _e1989, (_e1989 < _e1717));
let _e1996 = global_3.member[bitcast<u32>(select(0i, _e1991, (_e1991 > 0i)))];
let _e1997 = (_e1724 - _e758);
let _e1998 = (_e1736 - _e759);
let _e1999 = (_e1749 - _e760);
let _e2002 = ((_e1998 * _e1788) - (_e1999 * _e1775));
let _e2005 = ((_e1999 * _e1762) - (_e1997 * _e1788));
let _e2008 = ((_e1997 * _e1775) - (_e1998 * _e1762));
let _e2013 = (((_e459 * _e2002) + (_e470 * _e2005)) + (_e481 * _e2008));
let _e2042 = bitcast<f32>((bitcast<u32>((((_e459 * (((_e1814 * _e1788) - (_e1827 * _e1775)) + ((_e1998 * _e1905) - (_e1999 * _e1892)))) + (_e470 * (((_e1827 * _e1762) - (_e1801 * _e1788)) + ((_e1999 * _e1879) - (_e1997 * _e1905))))) + (_e481 * (((_e1801 * _e1775) - (_e1814 * _e1762)) + ((_e1997 * _e1892) - (_e1998 * _e1879)))))) & 2147483647u));
let _e2071 = bitcast<f32>((bitcast<u32>((((_e459 * (((_e1853 * _e1788) - (_e1866 * _e1775)) + ((_e1998 * _e1944) - (_e1999 * _e1931)))) + (_e470 * (((_e1866 * _e1762) - (_e1840 * _e1788)) + ((_e1999 * _e1918) - (_e1997 * _e1944))))) + (_e481 * (((_e1840 * _e1775) - (_e1853 * _e1762)) + ((_e1997 * _e1931) - (_e1998 * _e1918)))))) & 2147483647u));
let _e2094 = bitcast<f32>((bitcast<u32>(((((_e558 * _e2002) + (_e569 * _e2005)) + (_e580 * _e2008)) - (((_e459 * ((_e503 * _e1788) - (_e514 * _e1775))) + (_e470 * ((_e514 * _e1762) - (_e492 * _e1788)))) + (_e481 * ((_e492 * _e1775) - (_e503 * _e1762)))))) & 2147483647u));
let _e2117 = bitcast<f32>((bitcast<u32>(((((_e591 * _e2002) + (_e602 * _e2005)) + (_e613 * _e2008)) - (((_e459 * ((_e536 * _e1788) - (_e547 * _e1775))) + (_e470 * ((_e547 * _e1762) - (_e525 * _e1788)))) + (_e481 * ((_e525 * _e1775) - (_e536 * _e1762)))))) & 2147483647u));
let _e2119 = select(_e2117, _e2094, (_e2094 > _e2117));
let _e2121 = select(1e-12f, _e2119, (_e2119 > 1e-12f));
if (bitcast<f32>((bitcast<u32>(_e2013) & 2147483647u)) > (0.5f * ((_e2042 + _e2071) + _e2121))) {
phi_6188_ = vec3<f32>();
phi_6189_ = true;
} else {
let _e2133 = (((_e1997 * _e459) + (_e1998 * _e470)) + (_e1999 * _e481));
let _e2138 = (((_e1997 * _e1762) + (_e1998 * _e1775)) + (_e1999 * _e1788));
let _e2143 = (((_e459 * _e1762) + (_e470 * _e1775)) + (_e481 * _e1788));
let _e2146 = ((_e470 * _e1788) - (_e481 * _e1775));
let _e2149 = ((_e481 * _e1762) - (_e459 * _e1788));
let _e2152 = ((_e459 * _e1775) - (_e470 * _e1762));
let _e2157 = (((_e2146 * _e2146) + (_e2149 * _e2149)) + (_e2152 * _e2152));
let _e2160 = (1f / select(1e-9f, _e2157, (_e2157 > 1e-9f)));
let _e2163 = ((_e2133 - (_e2143 * _e2138)) * _e2160);
let _e2166 = (((_e2143 * _e2133) - _e2138) * _e2160);
let _e2173 = ((((_e2166 >= 0f) && (_e2166 < _e1996)) && (_e2163 > _e840)) && (_e2163 < _e841));
if _e2173 {
let _e2174 = (_e2166 - 0f);
let _e2178 = global_1.member.member_13.member_6;
let _e2179 = (_e2178 == 0u);
if _e2179 {
phi_4768_ = _e2174;
} else {
let _e2181 = (_e2174 / f32(_e2178));
phi_4055_ = 0u;
phi_4058_ = 0f;
loop {
let _e2183 = phi_4055_;
let _e2185 = phi_4058_;
local_45 = _e2185;
let _e2188 = ((_e2183 < _e2178) && (_e2174 > 0f));
if _e2188 {
let _e2191 = (0f + (_e2181 * f32(_e2183)));
let _e2192 = (_e2191 + _e2181);
let _e2194 = (0.5f * (_e2191 + _e2192));
let _e2195 = (_e2192 - _e2191);
let _e2196 = (0.28867513f * _e2195);
let _e2197 = (_e2194 - _e2196);
let _e2207 = global_1.member.member_13.member_7;
let _e2208 = bitcast<i32>(_e2207);
let _e2212 = global_1.member.member_13.member_8;
let _e2213 = bitcast<i32>(_e2212);
let _e2217 = global_1.member.member_13.member_9;
let _e2218 = bitcast<i32>(_e2217);
let _e2219 = f32(_e2208);
let _e2221 = (_e799.member - _e792.member);
let _e2224 = (((((_e1724 + (_e1762 * _e2197)) - _e792.member) / _e2221) * _e2219) - 0.5f);
let _e2225 = (_e2219 - 1f);
let _e2227 = select(0f, _e2224, (_e2224 > 0f));
let _e2229 = select(_e2225, _e2227, (_e2227 < _e2225));
let _e2230 = f32(_e2213);
let _e2232 = (_e799.member_1 - _e792.member_1);
let _e2235 = (((((_e1736 + (_e1775 * _e2197)) - _e792.member_1) / _e2232) * _e2230) - 0.5f);
let _e2236 = (_e2230 - 1f);
let _e2238 = select(0f, _e2235, (_e2235 > 0f));
let _e2240 = select(_e2236, _e2238, (_e2238 < _e2236));
let _e2241 = f32(_e2218);
let _e2243 = (_e799.member_2 - _e792.member_2);
let _e2246 = (((((_e1749 + (_e1788 * _e2197)) - _e792.member_2) / _e2243) * _e2241) - 0.5f);
let _e2247 = (_e2241 - 1f);
let _e2249 = select(0f, _e2246, (_e2246 > 0f));
let _e2251 = select(_e2247, _e2249, (_e2249 < _e2247));
let _e2253 = select(0f, _e2229, (_e2229 > 0f));
let _e2255 = select(1e6f, _e2253, (_e2253 < 1e6f));
let _e2262 = select(0i, select(select(i32(_e2255), i32(-2147483648), (_e2255 < -2147483600f)), 2147483647i, (_e2255 > 2147483500f)), (_e2255 == _e2255));
let _e2266 = (_e2262 - select(0i, 1i, (_e2255 < f32(_e2262))));
let _e2268 = select(0f, _e2240, (_e2240 > 0f));
let _e2270 = select(1e6f, _e2268, (_e2268 < 1e6f));
let _e2277 = select(0i, select(select(i32(_e2270), i32(-2147483648), (_e2270 < -2147483600f)), 2147483647i, (_e2270 > 2147483500f)), (_e2270 == _e2270));
let _e2281 = (_e2277 - select(0i, 1i, (_e2270 < f32(_e2277))));
let _e2283 = select(0f, _e2251, (_e2251 > 0f));
let _e2285 = select(1e6f, _e2283, (_e2283 < 1e6f));
let _e2292 = select(0i, select(select(i32(_e2285), i32(-2147483648), (_e2285 < -2147483600f)), 2147483647i, (_e2285 > 2147483500f)), (_e2285 == _e2285));
let _e2296 = (_e2292 - select(0i, 1i, (_e2285 < f32(_e2292))));
let _e2300 = (_e2240 - f32(_e2281));
let _e2302 = (_e2251 - f32(_e2296));
local_8 = (_e2229 - f32(_e2266));
let _e2303 = (_e2266 + 1i);
let _e2305 = select(_e2303, 0i, (_e2303 < 0i));
if (_e2305 >= _e2208) {
phi_4193_ = (_e2208 - 1i);
} else {
phi_4193_ = _e2305;
}
let _e2309 = phi_4193_;
local_9 = (_e2309 - _e2266);
let _e2311 = (_e2281 + 1i);
let _e2313 = select(_e2311, 0i, (_e2311 < 0i));
if (_e2313 >= _e2213) {
phi_4206_ = (_e2213 - 1i);
} else {
phi_4206_ = _e2313;
}
let _e2317 = phi_4206_;
let _e2319 = ((_e2317 - _e2281) * _e2208);
let _e2320 = (_e2296 + 1i);
let _e2322 = select(_e2320, 0i, (_e2320 < 0i));
if (_e2322 >= _e2218) {
phi_4220_ = (_e2218 - 1i);
} else {
phi_4220_ = _e2322;
}
let _e2326 = phi_4220_;
let _e2333 = global_1.member.member_13.member_10;
let _e2334 = bitcast<i32>(_e2333);
let _e2339 = ((_e2334 + (((_e2296 * _e2213) + _e2281) * _e2208)) + _e2266);
let _e2341 = (bitcast<i32>(_e141) - 1i);
let _e2343 = select(_e2341, _e2339, (_e2339 < _e2341));
let _e2348 = global_5.member[bitcast<u32>(select(0i, _e2343, (_e2343 > 0i)))];
let _e2349 = local_8;
let _e2352 = local_9;
let _e2353 = (_e2339 + _e2352);
let _e2355 = select(_e2341, _e2353, (_e2353 < _e2341));
let _e2360 = global_5.member[bitcast<u32>(select(0i, _e2355, (_e2355 > 0i)))];
let _e2361 = local_8;
let _e2364 = (1f - _e2300);
let _e2366 = (_e2339 + _e2319);
let _e2368 = select(_e2341, _e2366, (_e2366 < _e2341));
let _e2373 = global_5.member[bitcast<u32>(select(0i, _e2368, (_e2368 > 0i)))];
let _e2374 = local_8;
let _e2377 = local_9;
let _e2378 = (_e2366 + _e2377);
let _e2380 = select(_e2341, _e2378, (_e2378 < _e2341));
let _e2385 = global_5.member[bitcast<u32>(select(0i, _e2380, (_e2380 > 0i)))];
let _e2386 = local_8;
let _e2391 = (_e2339 + (((_e2326 - _e2296) * _e2208) * _e2213));
let _e2393 = select(_e2341, _e2391, (_e2391 < _e2341));
let _e2398 = global_5.member[bitcast<u32>(select(0i, _e2393, (_e2393 > 0i)))];
let _e2399 = local_8;
let _e2402 = local_9;
let _e2403 = (_e2391 + _e2402);
let _e2405 = select(_e2341, _e2403, (_e2403 < _e2341));
let _e2410 = global_5.member[bitcast<u32>(select(0i, _e2405, (_e2405 > 0i)))];
let _e2411 = local_8;
let _e2415 = (_e2391 + _e2319);
let _e2417 = select(_e2341, _e2415, (_e2415 < _e2341));
let _e2422 = global_5.member[bitcast<u32>(select(0i, _e2417, (_e2417 > 0i)))];
let _e2423 = local_8;
let _e2426 = local_9;
let _e2427 = (_e2415 + _e2426);
let _e2429 = select(_e2341, _e2427, (_e2427 < _e2341));
let _e2434 = global_5.member[bitcast<u32>(select(0i, _e2429, (_e2429 > 0i)))];
let _e2435 = local_8;
let _e2444 = (_e2194 + _e2196);
let _e2454 = (((((_e1724 + (_e1762 * _e2444)) - _e792.member) / _e2221) * _e2219) - 0.5f);
let _e2456 = select(0f, _e2454, (_e2454 > 0f));
let _e2458 = select(_e2225, _e2456, (_e2456 < _e2225));
let _e2462 = (((((_e1736 + (_e1775 * _e2444)) - _e792.member_1) / _e2232) * _e2230) - 0.5f);
let _e2464 = select(0f, _e2462, (_e2462 > 0f));
let _e2466 = select(_e2236, _e2464, (_e2464 < _e2236));
let _e2470 = (((((_e1749 + (_e1788 * _e2444)) - _e792.member_2) / _e2243) * _e2241) - 0.5f);
let _e2472 = select(0f, _e2470, (_e2470 > 0f));
let _e2474 = select(_e2247, _e2472, (_e2472 < _e2247));
let _e2476 = select(0f, _e2458, (_e2458 > 0f));
let _e2478 = select(1e6f, _e2476, (_e2476 < 1e6f));
let _e2485 = select(0i, select(select(i32(_e2478), i32(-2147483648), (_e2478 < -2147483600f)), 2147483647i, (_e2478 > 2147483500f)), (_e2478 == _e2478));
let _e2489 = (_e2485 - select(0i, 1i, (_e2478 < f32(_e2485))));
let _e2491 = select(0f, _e2466, (_e2466 > 0f));
let _e2493 = select(1e6f, _e2491, (_e2491 < 1e6f));
let _e2500 = select(0i, select(select(i32(_e2493), i32(-2147483648), (_e2493 < -2147483600f)), 2147483647i, (_e2493 > 2147483500f)), (_e2493 == _e2493));
let _e2504 = (_e2500 - select(0i, 1i, (_e2493 < f32(_e2500))));
let _e2506 = select(0f, _e2474, (_e2474 > 0f));
let _e2508 = select(1e6f, _e2506, (_e2506 < 1e6f));
let _e2515 = select(0i, select(select(i32(_e2508), i32(-2147483648), (_e2508 < -2147483600f)), 2147483647i, (_e2508 > 2147483500f)), (_e2508 == _e2508));
let _e2519 = (_e2515 - select(0i, 1i, (_e2508 < f32(_e2515))));
let _e2523 = (_e2466 - f32(_e2504));
let _e2525 = (_e2474 - f32(_e2519));
local_6 = (_e2458 - f32(_e2489));
let _e2526 = (_e2489 + 1i);
let _e2528 = select(_e2526, 0i, (_e2526 < 0i));
if (_e2528 >= _e2208) {
phi_4536_ = (_e2208 - 1i);
} else {
phi_4536_ = _e2528;
}
let _e2532 = phi_4536_;
local_7 = (_e2532 - _e2489);
let _e2534 = (_e2504 + 1i);
let _e2536 = select(_e2534, 0i, (_e2534 < 0i));
if (_e2536 >= _e2213) {
phi_4549_ = (_e2213 - 1i);
} else {
phi_4549_ = _e2536;
}
let _e2540 = phi_4549_;
let _e2542 = ((_e2540 - _e2504) * _e2208);
let _e2543 = (_e2519 + 1i);
let _e2545 = select(_e2543, 0i, (_e2543 < 0i));
if (_e2545 >= _e2218) {
phi_4563_ = (_e2218 - 1i);
} else {
phi_4563_ = _e2545;
}
let _e2549 = phi_4563_;
let _e2557 = ((_e2334 + (((_e2519 * _e2213) + _e2504) * _e2208)) + _e2489);
let _e2559 = select(_e2341, _e2557, (_e2557 < _e2341));
let _e2564 = global_5.member[bitcast<u32>(select(0i, _e2559, (_e2559 > 0i)))];
let _e2565 = local_6;
let _e2568 = local_7;
let _e2569 = (_e2557 + _e2568);
let _e2571 = select(_e2341, _e2569, (_e2569 < _e2341));
let _e2576 = global_5.member[bitcast<u32>(select(0i, _e2571, (_e2571 > 0i)))];
let _e2577 = local_6;
let _e2580 = (1f - _e2523);
let _e2582 = (_e2557 + _e2542);
let _e2584 = select(_e2341, _e2582, (_e2582 < _e2341));
let _e2589 = global_5.member[bitcast<u32>(select(0i, _e2584, (_e2584 > 0i)))];
let _e2590 = local_6;
let _e2593 = local_7;
let _e2594 = (_e2582 + _e2593);
let _e2596 = select(_e2341, _e2594, (_e2594 < _e2341));
let _e2601 = global_5.member[bitcast<u32>(select(0i, _e2596, (_e2596 > 0i)))];
let _e2602 = local_6;
let _e2607 = (_e2557 + (((_e2549 - _e2519) * _e2208) * _e2213));
let _e2609 = select(_e2341, _e2607, (_e2607 < _e2341));
let _e2614 = global_5.member[bitcast<u32>(select(0i, _e2609, (_e2609 > 0i)))];
let _e2615 = local_6;
let _e2618 = local_7;
let _e2619 = (_e2607 + _e2618);
let _e2621 = select(_e2341, _e2619, (_e2619 < _e2341));
let _e2626 = global_5.member[bitcast<u32>(select(0i, _e2621, (_e2621 > 0i)))];
let _e2627 = local_6;
let _e2631 = (_e2607 + _e2542);
let _e2633 = select(_e2341, _e2631, (_e2631 < _e2341));
let _e2638 = global_5.member[bitcast<u32>(select(0i, _e2633, (_e2633 > 0i)))];
let _e2639 = local_6;
let _e2642 = local_7;
let _e2643 = (_e2631 + _e2642);
let _e2645 = select(_e2341, _e2643, (_e2643 < _e2341));
let _e2650 = global_5.member[bitcast<u32>(select(0i, _e2645, (_e2645 > 0i)))];
let _e2651 = local_6;
phi_4056_ = (_e2183 + 1u);
phi_4059_ = (_e2185 + ((0.5f * (((((((_e2348 * (1f - _e2349)) + (_e2360 * _e2361)) * _e2364) + (((_e2373 * (1f - _e2374)) + (_e2385 * _e2386)) * _e2300)) * (1f - _e2302)) + (((((_e2398 * (1f - _e2399)) + (_e2410 * _e2411)) * _e2364) + (((_e2422 * (1f - _e2423)) + (_e2434 * _e2435)) * _e2300)) * _e2302)) + ((((((_e2564 * (1f - _e2565)) + (_e2576 * _e2577)) * _e2580) + (((_e2589 * (1f - _e2590)) + (_e2601 * _e2602)) * _e2523)) * (1f - _e2525)) + (((((_e2614 * (1f - _e2615)) + (_e2626 * _e2627)) * _e2580) + (((_e2638 * (1f - _e2639)) + (_e2650 * _e2651)) * _e2523)) * _e2525)))) * _e2195));
} else {
phi_4056_ = u32();
phi_4059_ = f32();
}
let _e2666 = phi_4056_;
let _e2668 = phi_4059_;
continue;
continuing {
phi_4055_ = _e2666;
phi_4058_ = _e2668;
break if !(_e2188);
}
}
let _e3890 = local_45;
phi_4768_ = _e3890;
}
let _e2671 = phi_4768_;
let _e2672 = (_e2163 - _e840);
if _e2179 {
phi_5494_ = _e2672;
} else {
let _e2674 = (_e2672 / f32(_e2178));
phi_4781_ = 0u;
phi_4784_ = 0f;
loop {
let _e2676 = phi_4781_;
let _e2678 = phi_4784_;
local_46 = _e2678;
let _e2681 = ((_e2676 < _e2178) && (_e2672 > 0f));
if _e2681 {
let _e2684 = (_e840 + (_e2674 * f32(_e2676)));
let _e2685 = (_e2684 + _e2674);
let _e2687 = (0.5f * (_e2684 + _e2685));
let _e2688 = (_e2685 - _e2684);
let _e2689 = (0.28867513f * _e2688);
let _e2690 = (_e2687 - _e2689);
let _e2700 = global_1.member.member_13.member_7;
let _e2701 = bitcast<i32>(_e2700);
let _e2705 = global_1.member.member_13.member_8;
let _e2706 = bitcast<i32>(_e2705);
let _e2710 = global_1.member.member_13.member_9;
let _e2711 = bitcast<i32>(_e2710);
let _e2712 = f32(_e2701);
let _e2714 = (_e799.member - _e792.member);
let _e2717 = (((((_e758 + (_e459 * _e2690)) - _e792.member) / _e2714) * _e2712) - 0.5f);
let _e2718 = (_e2712 - 1f);
let _e2720 = select(0f, _e2717, (_e2717 > 0f));
let _e2722 = select(_e2718, _e2720, (_e2720 < _e2718));
let _e2723 = f32(_e2706);
let _e2725 = (_e799.member_1 - _e792.member_1);
let _e2728 = (((((_e759 + (_e470 * _e2690)) - _e792.member_1) / _e2725) * _e2723) - 0.5f);
let _e2729 = (_e2723 - 1f);
let _e2731 = select(0f, _e2728, (_e2728 > 0f));
let _e2733 = select(_e2729, _e2731, (_e2731 < _e2729));
let _e2734 = f32(_e2711);
let _e2736 = (_e799.member_2 - _e792.member_2);
let _e2739 = (((((_e760 + (_e481 * _e2690)) - _e792.member_2) / _e2736) * _e2734) - 0.5f);
let _e2740 = (_e2734 - 1f);
let _e2742 = select(0f, _e2739, (_e2739 > 0f));
let _e2744 = select(_e2740, _e2742, (_e2742 < _e2740));
let _e2746 = select(0f, _e2722, (_e2722 > 0f));
let _e2748 = select(1e6f, _e2746, (_e2746 < 1e6f));
let _e2755 = select(0i, select(select(i32(_e2748), i32(-2147483648), (_e2748 < -2147483600f)), 2147483647i, (_e2748 > 2147483500f)), (_e2748 == _e2748));
let _e2759 = (_e2755 - select(0i, 1i, (_e2748 < f32(_e2755))));
let _e2761 = select(0f, _e2733, (_e2733 > 0f));
let _e2763 = select(1e6f, _e2761, (_e2761 < 1e6f));
let _e2770 = select(0i, select(select(i32(_e2763), i32(-2147483648), (_e2763 < -2147483600f)), 2147483647i, (_e2763 > 2147483500f)), (_e2763 == _e2763));
let _e2774 = (_e2770 - select(0i, 1i, (_e2763 < f32(_e2770))));
let _e2776 = select(0f, _e2744, (_e2744 > 0f));
let _e2778 = select(1e6f, _e2776, (_e2776 < 1e6f));
let _e2785 = select(0i, select(select(i32(_e2778), i32(-2147483648), (_e2778 < -2147483600f)), 2147483647i, (_e2778 > 2147483500f)), (_e2778 == _e2778));
let _e2789 = (_e2785 - select(0i, 1i, (_e2778 < f32(_e2785))));
let _e2793 = (_e2733 - f32(_e2774));
let _e2795 = (_e2744 - f32(_e2789));
local_4 = (_e2722 - f32(_e2759));
let _e2796 = (_e2759 + 1i);
let _e2798 = select(_e2796, 0i, (_e2796 < 0i));
if (_e2798 >= _e2701) {
phi_4919_ = (_e2701 - 1i);
} else {
phi_4919_ = _e2798;
}
let _e2802 = phi_4919_;
local_5 = (_e2802 - _e2759);
let _e2804 = (_e2774 + 1i);
let _e2806 = select(_e2804, 0i, (_e2804 < 0i));
if (_e2806 >= _e2706) {
phi_4932_ = (_e2706 - 1i);
} else {
phi_4932_ = _e2806;
}
let _e2810 = phi_4932_;
let _e2812 = ((_e2810 - _e2774) * _e2701);
let _e2813 = (_e2789 + 1i);
let _e2815 = select(_e2813, 0i, (_e2813 < 0i));
if (_e2815 >= _e2711) {
phi_4946_ = (_e2711 - 1i);
} else {
phi_4946_ = _e2815;
}
let _e2819 = phi_4946_;
let _e2826 = global_1.member.member_13.member_10;
let _e2827 = bitcast<i32>(_e2826);
let _e2832 = ((_e2827 + (((_e2789 * _e2706) + _e2774) * _e2701)) + _e2759);
let _e2834 = (bitcast<i32>(_e141) - 1i);
let _e2836 = select(_e2834, _e2832, (_e2832 < _e2834));
let _e2841 = global_5.member[bitcast<u32>(select(0i, _e2836, (_e2836 > 0i)))];
let _e2842 = local_4;
let _e2845 = local_5;
let _e2846 = (_e2832 + _e2845);
let _e2848 = select(_e2834, _e2846, (_e2846 < _e2834));
let _e2853 = global_5.member[bitcast<u32>(select(0i, _e2848, (_e2848 > 0i)))];
let _e2854 = local_4;
let _e2857 = (1f - _e2793);
let _e2859 = (_e2832 + _e2812);
let _e2861 = select(_e2834, _e2859, (_e2859 < _e2834));
let _e2866 = global_5.member[bitcast<u32>(select(0i, _e2861, (_e2861 > 0i)))];
let _e2867 = local_4;
let _e2870 = local_5;
let _e2871 = (_e2859 + _e2870);
let _e2873 = select(_e2834, _e2871, (_e2871 < _e2834));
let _e2878 = global_5.member[bitcast<u32>(select(0i, _e2873, (_e2873 > 0i)))];
let _e2879 = local_4;
let _e2884 = (_e2832 + (((_e2819 - _e2789) * _e2701) * _e2706));
let _e2886 = select(_e2834, _e2884, (_e2884 < _e2834));
let _e2891 = global_5.member[bitcast<u32>(select(0i, _e2886, (_e2886 > 0i)))];
let _e2892 = local_4;
let _e2895 = local_5;
let _e2896 = (_e2884 + _e2895);
let _e2898 = select(_e2834, _e2896, (_e2896 < _e2834));
let _e2903 = global_5.member[bitcast<u32>(select(0i, _e2898, (_e2898 > 0i)))];
let _e2904 = local_4;
let _e2908 = (_e2884 + _e2812);
let _e2910 = select(_e2834, _e2908, (_e2908 < _e2834));
let _e2915 = global_5.member[bitcast<u32>(select(0i, _e2910, (_e2910 > 0i)))];
let _e2916 = local_4;
let _e2919 = local_5;
let _e2920 = (_e2908 + _e2919);
let _e2922 = select(_e2834, _e2920, (_e2920 < _e2834));
let _e2927 = global_5.member[bitcast<u32>(select(0i, _e2922, (_e2922 > 0i)))];
let _e2928 = local_4;
let _e2937 = (_e2687 + _e2689);
let _e2947 = (((((_e758 + (_e459 * _e2937)) - _e792.member) / _e2714) * _e2712) - 0.5f);
let _e2949 = select(0f, _e2947, (_e2947 > 0f));
let _e2951 = select(_e2718, _e2949, (_e2949 < _e2718));
let _e2955 = (((((_e759 + (_e470 * _e2937)) - _e792.member_1) / _e2725) * _e2723) - 0.5f);
let _e2957 = select(0f, _e2955, (_e2955 > 0f));
let _e2959 = select(_e2729, _e2957, (_e2957 < _e2729));
let _e2963 = (((((_e760 + (_e481 * _e2937)) - _e792.member_2) / _e2736) * _e2734) - 0.5f);
let _e2965 = select(0f, _e2963, (_e2963 > 0f));
let _e2967 = select(_e2740, _e2965, (_e2965 < _e2740));
let _e2969 = select(0f, _e2951, (_e2951 > 0f));
let _e2971 = select(1e6f, _e2969, (_e2969 < 1e6f));
let _e2978 = select(0i, select(select(i32(_e2971), i32(-2147483648), (_e2971 < -2147483600f)), 2147483647i, (_e2971 > 2147483500f)), (_e2971 == _e2971));
let _e2982 = (_e2978 - select(0i, 1i, (_e2971 < f32(_e2978))));
let _e2984 = select(0f, _e2959, (_e2959 > 0f));
let _e2986 = select(1e6f, _e2984, (_e2984 < 1e6f));
let _e2993 = select(0i, select(select(i32(_e2986), i32(-2147483648), (_e2986 < -2147483600f)), 2147483647i, (_e2986 > 2147483500f)), (_e2986 == _e2986));
let _e2997 = (_e2993 - select(0i, 1i, (_e2986 < f32(_e2993))));
let _e2999 = select(0f, _e2967, (_e2967 > 0f));
let _e3001 = select(1e6f, _e2999, (_e2999 < 1e6f));
let _e3008 = select(0i, select(select(i32(_e3001), i32(-2147483648), (_e3001 < -2147483600f)), 2147483647i, (_e3001 > 2147483500f)), (_e3001 == _e3001));
let _e3012 = (_e3008 - select(0i, 1i, (_e3001 < f32(_e3008))));
let _e3016 = (_e2959 - f32(_e2997));
let _e3018 = (_e2967 - f32(_e3012));
local_2 = (_e2951 - f32(_e2982));
let _e3019 = (_e2982 + 1i);
let _e3021 = select(_e3019, 0i, (_e3019 < 0i));
if (_e3021 >= _e2701) {
phi_5262_ = (_e2701 - 1i);
} else {
phi_5262_ = _e3021;
}
let _e3025 = phi_5262_;
local_3 = (_e3025 - _e2982);
let _e3027 = (_e2997 + 1i);
let _e3029 = select(_e3027, 0i, (_e3027 < 0i));
if (_e3029 >= _e2706) {
phi_5275_ = (_e2706 - 1i);
} else {
phi_5275_ = _e3029;
}
let _e3033 = phi_5275_;
let _e3035 = ((_e3033 - _e2997) * _e2701);
let _e3036 = (_e3012 + 1i);
let _e3038 = select(_e3036, 0i, (_e3036 < 0i));
if (_e3038 >= _e2711) {
phi_5289_ = (_e2711 - 1i);
} else {
phi_5289_ = _e3038;
}
let _e3042 = phi_5289_;
let _e3050 = ((_e2827 + (((_e3012 * _e2706) + _e2997) * _e2701)) + _e2982);
let _e3052 = select(_e2834, _e3050, (_e3050 < _e2834));
let _e3057 = global_5.member[bitcast<u32>(select(0i, _e3052, (_e3052 > 0i)))];
let _e3058 = local_2;
let _e3061 = local_3;
let _e3062 = (_e3050 + _e3061);
let _e3064 = select(_e2834, _e3062, (_e3062 < _e2834));
let _e3069 = global_5.member[bitcast<u32>(select(0i, _e3064, (_e3064 > 0i)))];
let _e3070 = local_2;
let _e3073 = (1f - _e3016);
let _e3075 = (_e3050 + _e3035);
let _e3077 = select(_e2834, _e3075, (_e3075 < _e2834));
let _e3082 = global_5.member[bitcast<u32>(select(0i, _e3077, (_e3077 > 0i)))];
let _e3083 = local_2;
let _e3086 = local_3;
let _e3087 = (_e3075 + _e3086);
let _e3089 = select(_e2834, _e3087, (_e3087 < _e2834));
let _e3094 = global_5.member[bitcast<u32>(select(0i, _e3089, (_e3089 > 0i)))];
let _e3095 = local_2;
let _e3100 = (_e3050 + (((_e3042 - _e3012) * _e2701) * _e2706));
let _e3102 = select(_e2834, _e3100, (_e3100 < _e2834));
let _e3107 = global_5.member[bitcast<u32>(select(0i, _e3102, (_e3102 > 0i)))];
let _e3108 = local_2;
let _e3111 = local_3;
let _e3112 = (_e3100 + _e3111);
let _e3114 = select(_e2834, _e3112, (_e3112 < _e2834));
let _e3119 = global_5.member[bitcast<u32>(select(0i, _e3114, (_e3114 > 0i)))];
let _e3120 = local_2;
let _e3124 = (_e3100 + _e3035);
let _e3126 = select(_e2834, _e3124, (_e3124 < _e2834));
let _e3131 = global_5.member[bitcast<u32>(select(0i, _e3126, (_e3126 > 0i)))];
let _e3132 = local_2;
let _e3135 = local_3;
let _e3136 = (_e3124 + _e3135);
let _e3138 = select(_e2834, _e3136, (_e3136 < _e2834));
let _e3143 = global_5.member[bitcast<u32>(select(0i, _e3138, (_e3138 > 0i)))];
let _e3144 = local_2;
phi_4782_ = (_e2676 + 1u);
phi_4785_ = (_e2678 + ((0.5f * (((((((_e2841 * (1f - _e2842)) + (_e2853 * _e2854)) * _e2857) + (((_e2866 * (1f - _e2867)) + (_e2878 * _e2879)) * _e2793)) * (1f - _e2795)) + (((((_e2891 * (1f - _e2892)) + (_e2903 * _e2904)) * _e2857) + (((_e2915 * (1f - _e2916)) + (_e2927 * _e2928)) * _e2793)) * _e2795)) + ((((((_e3057 * (1f - _e3058)) + (_e3069 * _e3070)) * _e3073) + (((_e3082 * (1f - _e3083)) + (_e3094 * _e3095)) * _e3016)) * (1f - _e3018)) + (((((_e3107 * (1f - _e3108)) + (_e3119 * _e3120)) * _e3073) + (((_e3131 * (1f - _e3132)) + (_e3143 * _e3144)) * _e3016)) * _e3018)))) * _e2688));
} else {
phi_4782_ = u32();
phi_4785_ = f32();
}
let _e3159 = phi_4782_;
let _e3161 = phi_4785_;
continue;
continuing {
phi_4781_ = _e3159;
phi_4784_ = _e3161;
break if !(_e2681);
}
}
let _e3903 = local_46;
phi_5494_ = _e3903;
}
let _e3164 = phi_5494_;
if _e2179 {
phi_5843_ = 1f;
} else {
let _e3174 = global_1.member.member_13.member_7;
let _e3175 = bitcast<i32>(_e3174);
let _e3179 = global_1.member.member_13.member_8;
let _e3180 = bitcast<i32>(_e3179);
let _e3184 = global_1.member.member_13.member_9;
let _e3185 = bitcast<i32>(_e3184);
let _e3186 = f32(_e3175);
let _e3191 = (((((_e758 + (_e459 * _e2163)) - _e792.member) / (_e799.member - _e792.member)) * _e3186) - 0.5f);
let _e3192 = (_e3186 - 1f);
let _e3194 = select(0f, _e3191, (_e3191 > 0f));
let _e3196 = select(_e3192, _e3194, (_e3194 < _e3192));
let _e3197 = f32(_e3180);
let _e3202 = (((((_e759 + (_e470 * _e2163)) - _e792.member_1) / (_e799.member_1 - _e792.member_1)) * _e3197) - 0.5f);
let _e3203 = (_e3197 - 1f);
let _e3205 = select(0f, _e3202, (_e3202 > 0f));
let _e3207 = select(_e3203, _e3205, (_e3205 < _e3203));
let _e3208 = f32(_e3185);
let _e3213 = (((((_e760 + (_e481 * _e2163)) - _e792.member_2) / (_e799.member_2 - _e792.member_2)) * _e3208) - 0.5f);
let _e3214 = (_e3208 - 1f);
let _e3216 = select(0f, _e3213, (_e3213 > 0f));
let _e3218 = select(_e3214, _e3216, (_e3216 < _e3214));
let _e3220 = select(0f, _e3196, (_e3196 > 0f));
let _e3222 = select(1e6f, _e3220, (_e3220 < 1e6f));
let _e3229 = select(0i, select(select(i32(_e3222), i32(-2147483648), (_e3222 < -2147483600f)), 2147483647i, (_e3222 > 2147483500f)), (_e3222 == _e3222));
let _e3233 = (_e3229 - select(0i, 1i, (_e3222 < f32(_e3229))));
let _e3235 = select(0f, _e3207, (_e3207 > 0f));
let _e3237 = select(1e6f, _e3235, (_e3235 < 1e6f));
let _e3244 = select(0i, select(select(i32(_e3237), i32(-2147483648), (_e3237 < -2147483600f)), 2147483647i, (_e3237 > 2147483500f)), (_e3237 == _e3237));
let _e3248 = (_e3244 - select(0i, 1i, (_e3237 < f32(_e3244))));
let _e3250 = select(0f, _e3218, (_e3218 > 0f));
let _e3252 = select(1e6f, _e3250, (_e3250 < 1e6f));
let _e3259 = select(0i, select(select(i32(_e3252), i32(-2147483648), (_e3252 < -2147483600f)), 2147483647i, (_e3252 > 2147483500f)), (_e3252 == _e3252));
let _e3263 = (_e3259 - select(0i, 1i, (_e3252 < f32(_e3259))));
let _e3267 = (_e3207 - f32(_e3248));
let _e3269 = (_e3218 - f32(_e3263));
local = (_e3196 - f32(_e3233));
let _e3270 = (_e3233 + 1i);
let _e3272 = select(_e3270, 0i, (_e3270 < 0i));
if (_e3272 >= _e3175) {
phi_5616_ = (_e3175 - 1i);
} else {
phi_5616_ = _e3272;
}
let _e3276 = phi_5616_;
local_1 = (_e3276 - _e3233);
let _e3278 = (_e3248 + 1i);
let _e3280 = select(_e3278, 0i, (_e3278 < 0i));
if (_e3280 >= _e3180) {
phi_5629_ = (_e3180 - 1i);
} else {
phi_5629_ = _e3280;
}
let _e3284 = phi_5629_;
let _e3286 = ((_e3284 - _e3248) * _e3175);
let _e3287 = (_e3263 + 1i);
let _e3289 = select(_e3287, 0i, (_e3287 < 0i));
if (_e3289 >= _e3185) {
phi_5643_ = (_e3185 - 1i);
} else {
phi_5643_ = _e3289;
}
let _e3293 = phi_5643_;
let _e3300 = global_1.member.member_13.member_10;
let _e3306 = ((bitcast<i32>(_e3300) + (((_e3263 * _e3180) + _e3248) * _e3175)) + _e3233);
let _e3308 = (bitcast<i32>(_e141) - 1i);
let _e3310 = select(_e3308, _e3306, (_e3306 < _e3308));
let _e3315 = global_5.member[bitcast<u32>(select(0i, _e3310, (_e3310 > 0i)))];
let _e3316 = local;
let _e3319 = local_1;
let _e3320 = (_e3306 + _e3319);
let _e3322 = select(_e3308, _e3320, (_e3320 < _e3308));
let _e3327 = global_5.member[bitcast<u32>(select(0i, _e3322, (_e3322 > 0i)))];
let _e3328 = local;
let _e3331 = (1f - _e3267);
let _e3333 = (_e3306 + _e3286);
let _e3335 = select(_e3308, _e3333, (_e3333 < _e3308));
let _e3340 = global_5.member[bitcast<u32>(select(0i, _e3335, (_e3335 > 0i)))];
let _e3341 = local;
let _e3344 = local_1;
let _e3345 = (_e3333 + _e3344);
let _e3347 = select(_e3308, _e3345, (_e3345 < _e3308));
let _e3352 = global_5.member[bitcast<u32>(select(0i, _e3347, (_e3347 > 0i)))];
let _e3353 = local;
let _e3358 = (_e3306 + (((_e3293 - _e3263) * _e3175) * _e3180));
let _e3360 = select(_e3308, _e3358, (_e3358 < _e3308));
let _e3365 = global_5.member[bitcast<u32>(select(0i, _e3360, (_e3360 > 0i)))];
let _e3366 = local;
let _e3369 = local_1;
let _e3370 = (_e3358 + _e3369);
let _e3372 = select(_e3308, _e3370, (_e3370 < _e3308));
let _e3377 = global_5.member[bitcast<u32>(select(0i, _e3372, (_e3372 > 0i)))];
let _e3378 = local;
let _e3382 = (_e3358 + _e3286);
let _e3384 = select(_e3308, _e3382, (_e3382 < _e3308));
let _e3389 = global_5.member[bitcast<u32>(select(0i, _e3384, (_e3384 > 0i)))];
let _e3390 = local;
let _e3393 = local_1;
let _e3394 = (_e3382 + _e3393);
let _e3396 = select(_e3308, _e3394, (_e3394 < _e3308));
let _e3401 = global_5.member[bitcast<u32>(select(0i, _e3396, (_e3396 > 0i)))];
let _e3402 = local;
phi_5843_ = ((((((_e3315 * (1f - _e3316)) + (_e3327 * _e3328)) * _e3331) + (((_e3340 * (1f - _e3341)) + (_e3352 * _e3353)) * _e3267)) * (1f - _e3269)) + (((((_e3365 * (1f - _e3366)) + (_e3377 * _e3378)) * _e3331) + (((_e3389 * (1f - _e3390)) + (_e3401 * _e3402)) * _e3267)) * _e3269));
}
let _e3412 = phi_5843_;
let _e3413 = (_e2671 + _e3164);
let _e3417 = global_1.member.member_13.member;
let _e3422 = -((_e3417.member * _e3413));
let _e3424 = select(-87f, _e3422, (_e3422 > -87f));
let _e3426 = select(88f, _e3424, (_e3424 < 88f));
let _e3428 = ((_e3426 * 1.442695f) + 0.5f);
let _e3430 = select(-127f, _e3428, (_e3428 > -127f));
let _e3432 = select(128f, _e3430, (_e3430 < 128f));
let _e3439 = select(0i, select(select(i32(_e3432), i32(-2147483648), (_e3432 < -2147483600f)), 2147483647i, (_e3432 > 2147483500f)), (_e3432 == _e3432));
let _e3443 = (_e3439 - select(0i, 1i, (_e3432 < f32(_e3439))));
let _e3444 = f32(_e3443);
let _e3448 = ((_e3426 - (_e3444 * 0.6933594f)) - (_e3444 * -2.1219444e-4f));
let _e3470 = -((_e3417.member_1 * _e3413));
let _e3472 = select(-87f, _e3470, (_e3470 > -87f));
let _e3474 = select(88f, _e3472, (_e3472 < 88f));
let _e3476 = ((_e3474 * 1.442695f) + 0.5f);
let _e3478 = select(-127f, _e3476, (_e3476 > -127f));
let _e3480 = select(128f, _e3478, (_e3478 < 128f));
let _e3487 = select(0i, select(select(i32(_e3480), i32(-2147483648), (_e3480 < -2147483600f)), 2147483647i, (_e3480 > 2147483500f)), (_e3480 == _e3480));
let _e3491 = (_e3487 - select(0i, 1i, (_e3480 < f32(_e3487))));
let _e3492 = f32(_e3491);
let _e3496 = ((_e3474 - (_e3492 * 0.6933594f)) - (_e3492 * -2.1219444e-4f));
let _e3518 = -((_e3417.member_2 * _e3413));
let _e3520 = select(-87f, _e3518, (_e3518 > -87f));
let _e3522 = select(88f, _e3520, (_e3520 < 88f));
let _e3524 = ((_e3522 * 1.442695f) + 0.5f);
let _e3526 = select(-127f, _e3524, (_e3524 > -127f));
let _e3528 = select(128f, _e3526, (_e3526 < 128f));
let _e3535 = select(0i, select(select(i32(_e3528), i32(-2147483648), (_e3528 < -2147483600f)), 2147483647i, (_e3528 > 2147483500f)), (_e3528 == _e3528));
let _e3539 = (_e3535 - select(0i, 1i, (_e3528 < f32(_e3535))));
let _e3540 = f32(_e3539);
let _e3544 = ((_e3522 - (_e3540 * 0.6933594f)) - (_e3540 * -2.1219444e-4f));
let _e3565 = -(_e2143);
let _e3569 = global_1.member.member_13.member_2;
let _e3570 = (_e3569 * _e3569);
let _e3574 = ((1f + _e3570) - ((2f * _e3569) * _e3565));
let _e3576 = select(1e-9f, _e3574, (_e3574 > 1e-9f));
let _e3589 = global_1.member.member_13.member_3;
let _e3594 = (1e-4f * _e2121);
let _e3596 = select(_e2071, _e2042, (_e2042 > _e2071));
let _e3598 = select(_e3594, _e3596, (_e3596 > _e3594));
let _e3600 = select(_e2071, _e2042, (_e2042 < _e2071));
let _e3602 = select(_e3594, _e3600, (_e3600 > _e3594));
let _e3604 = (0.5f * (_e3598 + _e3602));
let _e3605 = (0.5f / _e3602);
let _e3606 = (1f / _e3598);
let _e3608 = (0.5f * _e2121);
let _e3609 = (_e2013 + _e3608);
let _e3610 = -(_e3609);
let _e3613 = (_e3604 - select(_e3610, _e3609, (_e3609 > _e3610)));
let _e3615 = select(0f, _e3613, (_e3613 > 0f));
let _e3617 = select(_e3602, _e3615, (_e3615 < _e3602));
let _e3620 = (_e3613 - _e3602);
let _e3624 = (((_e3617 * (_e3617 * _e3605)) + select(0f, _e3620, (_e3620 > 0f))) * _e3606);
let _e3628 = (_e2013 - _e3608);
let _e3629 = -(_e3628);
let _e3632 = (_e3604 - select(_e3629, _e3628, (_e3628 > _e3629)));
let _e3634 = select(0f, _e3632, (_e3632 > 0f));
let _e3636 = select(_e3602, _e3634, (_e3634 < _e3602));
let _e3639 = (_e3632 - _e3602);
let _e3643 = (((_e3636 * (_e3636 * _e3605)) + select(0f, _e3639, (_e3639 > 0f))) * _e3606);
let _e3650 = (((select(((1f - _e3570) / (_e3576 * sqrt(select(0f, _e3576, (_e3576 > 0f))))), (0.75f * (1f + (_e3565 * _e3565))), (_e3589 == 1u)) * (0.25f / 3.1415927f)) * ((select(_e3624, (1f - _e3624), (_e3609 >= 0f)) - select(_e3643, (1f - _e3643), (_e3628 >= 0f))) * (1f / _e2121))) * _e3412);
let _e3657 = global_1.member.member_13.member_1;
phi_6186_ = vec3<f32>((((_e1957 * ((1f + (_e3448 * (1f + (_e3448 * (0.5f + (_e3448 * (0.16666667f + (_e3448 * (0.041666668f + (_e3448 * (0.008333334f + (_e3448 * (0.001388889f + (_e3448 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3443 + 127i)) << bitcast<u32>(23i))))) * _e3657.member) * _e3650), (((_e1970 * ((1f + (_e3496 * (1f + (_e3496 * (0.5f + (_e3496 * (0.16666667f + (_e3496 * (0.041666668f + (_e3496 * (0.008333334f + (_e3496 * (0.001388889f + (_e3496 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3491 + 127i)) << bitcast<u32>(23i))))) * _e3657.member_1) * _e3650), (((_e1983 * ((1f + (_e3544 * (1f + (_e3544 * (0.5f + (_e3544 * (0.16666667f + (_e3544 * (0.041666668f + (_e3544 * (0.008333334f + (_e3544 * (0.001388889f + (_e3544 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3539 + 127i)) << bitcast<u32>(23i))))) * _e3657.member_2) * _e3650));
} else {
phi_6186_ = vec3<f32>();
}
let _e3669 = phi_6186_;
phi_6188_ = _e3669;
phi_6189_ = select(true, false, _e2173);
}
let _e3672 = phi_6188_;
let _e3674 = phi_6189_;
let _e3676 = select(_e3672, vec3<f32>(0f, 0f, 0f), vec3(_e3674));
let _e3677 = select(1f, 0f, _e1059);
let _e3691 = select(0f, 1f, _e1059);
phi_6232_ = vec3<f32>((_e1064.x + (_e3676.x * _e3691)), (_e1064.y + (_e3676.y * _e3691)), (_e1064.z + (_e3676.z * _e3691)));
phi_6233_ = vec3<f32>((_e1066.x + (_e3676.x * _e3677)), (_e1066.y + (_e3676.y * _e3677)), (_e1066.z + (_e3676.z * _e3677)));
} else {
phi_6232_ = _e1064;
phi_6233_ = _e1066;
}
let _e3703 = phi_6232_;
let _e3705 = phi_6233_;
let _e3706 = local_23.member_1;
phi_6241_ = type_17(_e1068.member, (_e1068.member_1 + 1u));
loop {
let _e3710 = phi_6241_;
local_47 = _e3710;
let _e3716 = (((_e3710.member_1 & 3u) == 0u) && (_e3710.member < _e3706));
if _e3716 {
phi_6242_ = type_17((_e3710.member + 1u), (_e3710.member_1 >> bitcast<u32>(2i)));
} else {
phi_6242_ = type_17();
}
let _e3722 = phi_6242_;
continue;
continuing {
phi_6241_ = _e3722;
break if !(_e3716);
}
}
phi_6263_ = _e3703;
phi_6264_ = _e3705;
let _e3919 = local_47;
phi_6265_ = _e3919;
}
let _e3729 = phi_6263_;
let _e3731 = phi_6264_;
let _e3733 = phi_6265_;
phi_2085_ = _e3729;
phi_2088_ = _e3731;
phi_2090_ = _e3733;
} else {
phi_2085_ = vec3<f32>();
phi_2088_ = vec3<f32>();
phi_2090_ = type_17();
}
let _e3735 = phi_2085_;
let _e3737 = phi_2088_;
let _e3739 = phi_2090_;
continue;
continuing {
phi_2084_ = _e3735;
phi_2087_ = _e3737;
phi_2089_ = _e3739;
break if !(_e1076);
}
}
let _e3925 = local_48;
phi_1885_ = _e3925;
let _e3928 = local_49;
phi_1888_ = _e3928;
phi_1890_ = (_e897 + 1u);
} else {
phi_1885_ = vec3<f32>();
phi_1888_ = vec3<f32>();
phi_1890_ = u32();
}
let _e3743 = phi_1885_;
let _e3745 = phi_1888_;
let _e3747 = phi_1890_;
continue;
continuing {
phi_1884_ = _e3743;
phi_1887_ = _e3745;
phi_1889_ = _e3747;
break if !(_e902);
}
}
let _e3750 = local_39;
let _e3754 = local_40;
let _e3758 = local_41;
let _e3765 = local_42;
let _e3769 = local_43;
let _e3773 = local_44;
phi_6316_ = array<f32, 19>(_e166, _e176, _e187, _e198, _e209, _e220, _e231, _e242, _e253, (_e264 + (_e3750.x * _e762)), (_e275 + (_e3754.y * _e763)), (_e286 + (_e3758.z * _e764)), (_e297 + (_e3765.x * _e762)), (_e308 + (_e3769.y * _e763)), (_e319 + (_e3773.z * _e764)), _e330, _e341, _e352, _e363);
}
let _e3781 = phi_6316_;
global_6.member[_e155] = _e3781[0];
global_6.member[_e167] = _e3781[1];
global_6.member[_e178] = _e3781[2];
global_6.member[_e189] = _e3781[3];
global_6.member[_e200] = _e3781[4];
global_6.member[_e211] = _e3781[5];
global_6.member[_e222] = _e3781[6];
global_6.member[_e233] = _e3781[7];
global_6.member[_e244] = _e3781[8];
global_6.member[_e255] = _e3781[9];
global_6.member[_e266] = _e3781[10];
global_6.member[_e277] = _e3781[11];
global_6.member[_e288] = _e3781[12];
global_6.member[_e299] = _e3781[13];
global_6.member[_e310] = _e3781[14];
global_6.member[_e321] = _e3781[15];
global_6.member[_e332] = _e3781[16];
global_6.member[_e343] = _e3781[17];
global_6.member[_e354] = _e3781[18];
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
