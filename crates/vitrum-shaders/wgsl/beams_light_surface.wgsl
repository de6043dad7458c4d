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
struct type_12 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_19 {
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
struct type_20 {
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
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_21 {
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
member_11: u32,
}
struct type_22 {
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
struct type_23 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_24 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_19,
member_12: type_20,
member_13: type_21,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_22,
member_19: type_23,
}
struct type_25 {
member: type_24,
}
struct type_26 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
struct type_28 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
member_6: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(2)
var<storage> global_3: type_15;
@group(0) @binding(3)
var<storage> global_4: type_15;
@group(0) @binding(7)
var<storage, read_write> global_5: type_15;
@group(0) @binding(4)
var<storage> global_6: type_15;
@group(0) @binding(5)
var<storage> global_7: type_15;
@group(0) @binding(6)
var<storage> global_8: type_15;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: f32;
var local_5: i32;
var local_6: f32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: u32;
var local_12: u32;
var local_13: u32;
var local_14: u32;
var local_15: type_13;
var local_16: u32;
var local_17: u32;
var local_18: type_13;
var local_19: u32;
var local_20: type_26;
var local_21: i32;
var local_22: i32;
var phi_2482_: type_28;
var phi_2546_: bool;
var phi_2578_: f32;
var phi_2658_: u32;
var phi_2659_: u32;
var phi_2671_: u32;
var phi_2672_: u32;
var local_23: u32;
var local_24: u32;
var phi_2689_: u32;
var phi_2690_: u32;
var phi_2702_: u32;
var phi_2703_: u32;
var local_25: u32;
var local_26: u32;
var local_27: u32;
var phi_2728_: u32;
var phi_2729_: u32;
var local_28: u32;
var local_29: u32;
var phi_2746_: u32;
var phi_2747_: u32;
var local_30: u32;
var local_31: u32;
var phi_2769_: u32;
var phi_2770_: u32;
var phi_2782_: u32;
var phi_2783_: u32;
var local_32: u32;
var local_33: u32;
var local_34: u32;
var phi_2819_: u32;
var local_35: u32;
var phi_2832_: vec3<f32>;
var phi_2835_: type_13;
var phi_3094_: u32;
var phi_3125_: u32;
var phi_3149_: u32;
var phi_3185_: u32;
var phi_3256_: u32;
var phi_3346_: u32;
var phi_3150_: u32;
var phi_3397_: u32;
var phi_3399_: vec3<f32>;
var phi_3402_: u32;
var phi_3431_: u32;
var phi_3477_: i32;
var phi_5356_: f32;
var phi_5357_: f32;
var phi_5380_: u32;
var phi_5383_: f32;
var phi_5518_: i32;
var phi_5531_: i32;
var phi_5545_: i32;
var phi_5861_: i32;
var phi_5874_: i32;
var phi_5888_: i32;
var phi_5381_: u32;
var phi_5384_: f32;
var phi_6093_: f32;
var phi_6426_: vec3<f32>;
var phi_6427_: vec3<f32>;
var phi_6428_: bool;
var phi_6432_: vec3<f32>;
var phi_6433_: bool;
var phi_6449_: vec3<f32>;
var phi_3400_: vec3<f32>;
var phi_3403_: u32;
var phi_6459_: type_13;
var phi_6460_: type_13;
var phi_6481_: vec3<f32>;
var phi_6482_: type_13;
var phi_2833_: vec3<f32>;
var phi_2836_: type_13;
var local_36: vec3<f32>;
var local_37: vec3<f32>;
var local_38: vec3<f32>;
var phi_6639_: u32;
var phi_6642_: f32;
var phi_6777_: i32;
var phi_6790_: i32;
var phi_6804_: i32;
var phi_7120_: i32;
var phi_7133_: i32;
var phi_7147_: i32;
var phi_6640_: u32;
var phi_6643_: f32;
var phi_7352_: f32;
var phi_7591_: array<f32, 22>;
var phi_7592_: array<f32, 22>;
var phi_7593_: bool;
var phi_7597_: array<f32, 22>;
var local_39: u32;
var local_40: f32;
var local_41: vec3<f32>;
var local_42: type_13;
var local_43: f32;
let _e134 = global;
let _e143 = arrayLength((&global_4.member));
let _e145 = arrayLength((&global_6.member));
let _e155 = global_1.member.member;
if (_e134.x < _e155.member) {
if (_e134.y < _e155.member_1) {
let _e162 = (_e155.member * _e155.member_1);
let _e164 = ((_e134.y * _e155.member) + _e134.x);
let _e165 = bitcast<i32>(_e164);
let _e167 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e169 = select(_e167, _e165, (_e165 < _e167));
let _e175 = global_5.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e176 = (_e162 + _e164);
let _e177 = bitcast<i32>(_e176);
let _e179 = select(_e167, _e177, (_e177 < _e167));
let _e185 = global_5.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e187 = ((2u * _e162) + _e164);
let _e188 = bitcast<i32>(_e187);
let _e190 = select(_e167, _e188, (_e188 < _e167));
let _e196 = global_5.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e198 = ((3u * _e162) + _e164);
let _e199 = bitcast<i32>(_e198);
let _e201 = select(_e167, _e199, (_e199 < _e167));
let _e207 = global_5.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e209 = ((4u * _e162) + _e164);
let _e210 = bitcast<i32>(_e209);
let _e212 = select(_e167, _e210, (_e210 < _e167));
let _e218 = global_5.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e220 = ((5u * _e162) + _e164);
let _e221 = bitcast<i32>(_e220);
let _e223 = select(_e167, _e221, (_e221 < _e167));
let _e229 = global_5.member[bitcast<u32>(select(0i, _e223, (_e223 > 0i)))];
let _e231 = ((6u * _e162) + _e164);
let _e232 = bitcast<i32>(_e231);
let _e234 = select(_e167, _e232, (_e232 < _e167));
let _e240 = global_5.member[bitcast<u32>(select(0i, _e234, (_e234 > 0i)))];
let _e242 = ((7u * _e162) + _e164);
let _e243 = bitcast<i32>(_e242);
let _e245 = select(_e167, _e243, (_e243 < _e167));
let _e251 = global_5.member[bitcast<u32>(select(0i, _e245, (_e245 > 0i)))];
let _e253 = ((8u * _e162) + _e164);
let _e254 = bitcast<i32>(_e253);
let _e256 = select(_e167, _e254, (_e254 < _e167));
let _e262 = global_5.member[bitcast<u32>(select(0i, _e256, (_e256 > 0i)))];
let _e264 = ((9u * _e162) + _e164);
let _e265 = bitcast<i32>(_e264);
let _e267 = select(_e167, _e265, (_e265 < _e167));
let _e273 = global_5.member[bitcast<u32>(select(0i, _e267, (_e267 > 0i)))];
let _e275 = ((10u * _e162) + _e164);
let _e276 = bitcast<i32>(_e275);
let _e278 = select(_e167, _e276, (_e276 < _e167));
let _e284 = global_5.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e286 = ((11u * _e162) + _e164);
let _e287 = bitcast<i32>(_e286);
let _e289 = select(_e167, _e287, (_e287 < _e167));
let _e295 = global_5.member[bitcast<u32>(select(0i, _e289, (_e289 > 0i)))];
let _e297 = ((12u * _e162) + _e164);
let _e298 = bitcast<i32>(_e297);
let _e300 = select(_e167, _e298, (_e298 < _e167));
let _e306 = global_5.member[bitcast<u32>(select(0i, _e300, (_e300 > 0i)))];
let _e308 = ((13u * _e162) + _e164);
let _e309 = bitcast<i32>(_e308);
let _e311 = select(_e167, _e309, (_e309 < _e167));
let _e317 = global_5.member[bitcast<u32>(select(0i, _e311, (_e311 > 0i)))];
let _e319 = ((14u * _e162) + _e164);
let _e320 = bitcast<i32>(_e319);
let _e322 = select(_e167, _e320, (_e320 < _e167));
let _e328 = global_5.member[bitcast<u32>(select(0i, _e322, (_e322 > 0i)))];
let _e330 = ((15u * _e162) + _e164);
let _e331 = bitcast<i32>(_e330);
let _e333 = select(_e167, _e331, (_e331 < _e167));
let _e339 = global_5.member[bitcast<u32>(select(0i, _e333, (_e333 > 0i)))];
let _e341 = ((16u * _e162) + _e164);
let _e342 = bitcast<i32>(_e341);
let _e344 = select(_e167, _e342, (_e342 < _e167));
let _e350 = global_5.member[bitcast<u32>(select(0i, _e344, (_e344 > 0i)))];
let _e352 = ((17u * _e162) + _e164);
let _e353 = bitcast<i32>(_e352);
let _e355 = select(_e167, _e353, (_e353 < _e167));
let _e361 = global_5.member[bitcast<u32>(select(0i, _e355, (_e355 > 0i)))];
let _e363 = ((18u * _e162) + _e164);
let _e364 = bitcast<i32>(_e363);
let _e366 = select(_e167, _e364, (_e364 < _e167));
let _e372 = global_5.member[bitcast<u32>(select(0i, _e366, (_e366 > 0i)))];
let _e374 = ((19u * _e162) + _e164);
let _e375 = bitcast<i32>(_e374);
let _e377 = select(_e167, _e375, (_e375 < _e167));
let _e383 = global_5.member[bitcast<u32>(select(0i, _e377, (_e377 > 0i)))];
let _e385 = ((20u * _e162) + _e164);
let _e386 = bitcast<i32>(_e385);
let _e388 = select(_e167, _e386, (_e386 < _e167));
let _e394 = global_5.member[bitcast<u32>(select(0i, _e388, (_e388 > 0i)))];
let _e396 = ((21u * _e162) + _e164);
let _e397 = bitcast<i32>(_e396);
let _e399 = select(_e167, _e397, (_e397 < _e167));
let _e405 = global_5.member[bitcast<u32>(select(0i, _e399, (_e399 > 0i)))];
let _e410 = global_1.member.member.member;
let _e414 = global_1.member.member.member_1;
let _e415 = (_e410 * _e414);
local_21 = bitcast<i32>(_e415);
let _e418 = ((_e134.y * _e410) + _e134.x);
let _e419 = bitcast<i32>(_e418);
local_22 = _e419;
let _e420 = local_21;
let _e422 = local_22;
let _e423 = ((29i * _e420) + _e422);
let _e425 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e427 = select(_e425, _e423, (_e423 < _e425));
let _e432 = global_2.member[bitcast<u32>(select(0i, _e427, (_e427 > 0i)))];
let _e434 = local_21;
let _e436 = local_22;
let _e437 = ((36i * _e434) + _e436);
let _e439 = select(_e425, _e437, (_e437 < _e425));
let _e444 = global_2.member[bitcast<u32>(select(0i, _e439, (_e439 > 0i)))];
let _e455 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e432 == 2f) && (select(0i, select(select(i32(_e444), i32(-2147483648), (_e444 < -2147483600f)), 2147483647i, (_e444 > 2147483500f)), (_e444 == _e444)) == (bitcast<i32>(_e455) + 1i)))) > 1u) {
let _e463 = select(_e425, _e419, (_e419 < _e425));
let _e469 = global_2.member[bitcast<u32>(select(0i, _e463, (_e463 > 0i)))];
let _e471 = bitcast<i32>((_e415 + _e418));
let _e473 = select(_e425, _e471, (_e471 < _e425));
let _e479 = global_2.member[bitcast<u32>(select(0i, _e473, (_e473 > 0i)))];
let _e482 = bitcast<i32>(((2u * _e415) + _e418));
let _e484 = select(_e425, _e482, (_e482 < _e425));
let _e490 = global_2.member[bitcast<u32>(select(0i, _e484, (_e484 > 0i)))];
let _e493 = bitcast<i32>(((3u * _e415) + _e418));
let _e495 = select(_e425, _e493, (_e493 < _e425));
let _e501 = global_2.member[bitcast<u32>(select(0i, _e495, (_e495 > 0i)))];
let _e504 = bitcast<i32>(((4u * _e415) + _e418));
let _e506 = select(_e425, _e504, (_e504 < _e425));
let _e512 = global_2.member[bitcast<u32>(select(0i, _e506, (_e506 > 0i)))];
let _e515 = bitcast<i32>(((5u * _e415) + _e418));
let _e517 = select(_e425, _e515, (_e515 < _e425));
let _e523 = global_2.member[bitcast<u32>(select(0i, _e517, (_e517 > 0i)))];
let _e526 = bitcast<i32>(((6u * _e415) + _e418));
let _e528 = select(_e425, _e526, (_e526 < _e425));
let _e534 = global_2.member[bitcast<u32>(select(0i, _e528, (_e528 > 0i)))];
let _e537 = bitcast<i32>(((7u * _e415) + _e418));
let _e539 = select(_e425, _e537, (_e537 < _e425));
let _e545 = global_2.member[bitcast<u32>(select(0i, _e539, (_e539 > 0i)))];
let _e548 = bitcast<i32>(((8u * _e415) + _e418));
let _e550 = select(_e425, _e548, (_e548 < _e425));
let _e556 = global_2.member[bitcast<u32>(select(0i, _e550, (_e550 > 0i)))];
let _e559 = bitcast<i32>(((9u * _e415) + _e418));
let _e561 = select(_e425, _e559, (_e559 < _e425));
let _e567 = global_2.member[bitcast<u32>(select(0i, _e561, (_e561 > 0i)))];
let _e570 = bitcast<i32>(((10u * _e415) + _e418));
let _e572 = select(_e425, _e570, (_e570 < _e425));
let _e578 = global_2.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
let _e581 = bitcast<i32>(((11u * _e415) + _e418));
let _e583 = select(_e425, _e581, (_e581 < _e425));
let _e589 = global_2.member[bitcast<u32>(select(0i, _e583, (_e583 > 0i)))];
let _e592 = bitcast<i32>(((12u * _e415) + _e418));
let _e594 = select(_e425, _e592, (_e592 < _e425));
let _e600 = global_2.member[bitcast<u32>(select(0i, _e594, (_e594 > 0i)))];
let _e603 = bitcast<i32>(((13u * _e415) + _e418));
let _e605 = select(_e425, _e603, (_e603 < _e425));
let _e611 = global_2.member[bitcast<u32>(select(0i, _e605, (_e605 > 0i)))];
let _e614 = bitcast<i32>(((14u * _e415) + _e418));
let _e616 = select(_e425, _e614, (_e614 < _e425));
let _e622 = global_2.member[bitcast<u32>(select(0i, _e616, (_e616 > 0i)))];
let _e625 = bitcast<i32>(((15u * _e415) + _e418));
let _e627 = select(_e425, _e625, (_e625 < _e425));
let _e633 = global_2.member[bitcast<u32>(select(0i, _e627, (_e627 > 0i)))];
let _e636 = bitcast<i32>(((16u * _e415) + _e418));
let _e638 = select(_e425, _e636, (_e636 < _e425));
let _e644 = global_2.member[bitcast<u32>(select(0i, _e638, (_e638 > 0i)))];
let _e647 = bitcast<i32>(((17u * _e415) + _e418));
let _e649 = select(_e425, _e647, (_e647 < _e425));
let _e655 = global_2.member[bitcast<u32>(select(0i, _e649, (_e649 > 0i)))];
let _e658 = bitcast<i32>(((18u * _e415) + _e418));
let _e660 = select(_e425, _e658, (_e658 < _e425));
let _e666 = global_2.member[bitcast<u32>(select(0i, _e660, (_e660 > 0i)))];
let _e669 = bitcast<i32>(((19u * _e415) + _e418));
let _e671 = select(_e425, _e669, (_e669 < _e425));
let _e677 = global_2.member[bitcast<u32>(select(0i, _e671, (_e671 > 0i)))];
let _e680 = bitcast<i32>(((20u * _e415) + _e418));
let _e682 = select(_e425, _e680, (_e680 < _e425));
let _e688 = global_2.member[bitcast<u32>(select(0i, _e682, (_e682 > 0i)))];
let _e691 = bitcast<i32>(((23u * _e415) + _e418));
let _e693 = select(_e425, _e691, (_e691 < _e425));
let _e699 = global_2.member[bitcast<u32>(select(0i, _e693, (_e693 > 0i)))];
let _e702 = bitcast<i32>(((24u * _e415) + _e418));
let _e704 = select(_e425, _e702, (_e702 < _e425));
let _e710 = global_2.member[bitcast<u32>(select(0i, _e704, (_e704 > 0i)))];
let _e713 = bitcast<i32>(((30u * _e415) + _e418));
let _e715 = select(_e425, _e713, (_e713 < _e425));
let _e721 = global_2.member[bitcast<u32>(select(0i, _e715, (_e715 > 0i)))];
let _e728 = select(0i, select(select(i32(_e699), i32(-2147483648), (_e699 < -2147483600f)), 2147483647i, (_e699 > 2147483500f)), (_e699 == _e699));
let _e736 = (select(0i, select(select(i32(_e721), i32(-2147483648), (_e721 < -2147483600f)), 2147483647i, (_e721 > 2147483500f)), (_e721 == _e721)) == 0i);
let _e744 = global_1.member.member_1.member;
let _e750 = global_1.member.member_1.member_1;
let _e760 = global_1.member.member_2.member;
let _e761 = (((((f32(bitcast<i32>(_e134.x)) + 0.5f) / f32(bitcast<i32>(_e744))) * 2f) - 1f) * _e760);
let _e769 = global_1.member.member_2.member_1;
let _e770 = ((1f - (((f32(bitcast<i32>(_e134.y)) + 0.5f) / f32(bitcast<i32>(_e750))) * 2f)) * _e769);
let _e773 = global_1.member.member_3;
let _e782 = global_1.member.member_4;
let _e795 = global_1.member.member_2.member_3;
let _e796 = (_e795 != 0u);
let _e799 = global_1.member.member_6;
let _e806 = select(_e799.member, (_e799.member + ((_e773.member * _e761) + (_e782.member * _e770))), _e796);
let _e807 = select(_e799.member_1, (_e799.member_1 + ((_e773.member_1 * _e761) + (_e782.member_1 * _e770))), _e796);
let _e808 = select(_e799.member_2, (_e799.member_2 + ((_e773.member_2 * _e761) + (_e782.member_2 * _e770))), _e796);
let _e818 = select(_e469, _e806, _e736);
let _e819 = select(_e479, _e807, _e736);
let _e820 = select(_e490, _e808, _e736);
let _e821 = (select(0f, ((((_e469 - _e806) * _e501) + ((_e479 - _e807) * _e512)) + ((_e490 - _e808) * _e523)), _e736) + _e710);
let _e826 = select(_e821, 0f, (_e728 == -1i));
let _e830 = (_e818 + (_e501 * _e826));
let _e831 = (_e819 + (_e512 * _e826));
let _e832 = (_e820 + (_e523 * _e826));
let _e833 = vec3<f32>(_e830, _e831, _e832);
let _e836 = global_1.member.member_17;
let _e839 = (_e728 >= 0i);
if _e839 {
let _e884 = (_e728 * 19i);
let _e886 = (bitcast<i32>(_e145) - 1i);
let _e888 = select(_e886, _e884, (_e884 < _e886));
let _e894 = global_6.member[bitcast<u32>(select(0i, _e888, (_e888 > 0i)))];
let _e895 = (_e884 + 1i);
let _e897 = select(_e886, _e895, (_e895 < _e886));
let _e903 = global_6.member[bitcast<u32>(select(0i, _e897, (_e897 > 0i)))];
let _e904 = (_e884 + 2i);
let _e906 = select(_e886, _e904, (_e904 < _e886));
let _e912 = global_6.member[bitcast<u32>(select(0i, _e906, (_e906 > 0i)))];
let _e913 = (_e884 + 3i);
let _e915 = select(_e886, _e913, (_e913 < _e886));
let _e921 = global_6.member[bitcast<u32>(select(0i, _e915, (_e915 > 0i)))];
let _e922 = (_e884 + 4i);
let _e924 = select(_e886, _e922, (_e922 < _e886));
let _e930 = global_6.member[bitcast<u32>(select(0i, _e924, (_e924 > 0i)))];
let _e931 = (_e884 + 5i);
let _e933 = select(_e886, _e931, (_e931 < _e886));
let _e939 = global_6.member[bitcast<u32>(select(0i, _e933, (_e933 > 0i)))];
let _e940 = (_e884 + 6i);
let _e942 = select(_e886, _e940, (_e940 < _e886));
let _e948 = global_6.member[bitcast<u32>(select(0i, _e942, (_e942 > 0i)))];
let _e949 = (_e884 + 7i);
let _e951 = select(_e886, _e949, (_e949 < _e886));
let _e957 = global_6.member[bitcast<u32>(select(0i, _e951, (_e951 > 0i)))];
let _e958 = (_e884 + 8i);
let _e960 = select(_e886, _e958, (_e958 < _e886));
let _e966 = global_6.member[bitcast<u32>(select(0i, _e960, (_e960 > 0i)))];
let _e967 = (_e921 - _e894);
let _e968 = (_e930 - _e903);
let _e969 = (_e939 - _e912);
let _e970 = (_e948 - _e894);
let _e971 = (_e957 - _e903);
let _e972 = (_e966 - _e912);
let _e975 = ((_e968 * _e972) - (_e969 * _e971));
let _e978 = ((_e969 * _e970) - (_e967 * _e972));
let _e981 = ((_e967 * _e971) - (_e968 * _e970));
let _e982 = (_e921 - _e830);
let _e983 = (_e930 - _e831);
let _e984 = (_e939 - _e832);
let _e985 = (_e948 - _e830);
let _e986 = (_e957 - _e831);
let _e987 = (_e966 - _e832);
let _e1001 = (((((_e983 * _e987) - (_e984 * _e986)) * _e975) + (((_e984 * _e985) - (_e982 * _e987)) * _e978)) + (((_e982 * _e986) - (_e983 * _e985)) * _e981));
let _e1003 = select(0f, _e1001, (_e1001 > 0f));
let _e1004 = (_e894 - _e830);
let _e1005 = (_e903 - _e831);
let _e1006 = (_e912 - _e832);
let _e1020 = (((((_e986 * _e1006) - (_e987 * _e1005)) * _e975) + (((_e987 * _e1004) - (_e985 * _e1006)) * _e978)) + (((_e985 * _e1005) - (_e986 * _e1004)) * _e981));
let _e1022 = select(0f, _e1020, (_e1020 > 0f));
let _e1036 = (((((_e1005 * _e984) - (_e1006 * _e983)) * _e975) + (((_e1006 * _e982) - (_e1004 * _e984)) * _e978)) + (((_e1004 * _e983) - (_e1005 * _e982)) * _e981));
let _e1038 = select(0f, _e1036, (_e1036 > 0f));
let _e1040 = ((_e1003 + _e1022) + _e1038);
let _e1042 = select(1e-30f, _e1040, (_e1040 > 1e-30f));
let _e1043 = (_e1003 / _e1042);
let _e1044 = (_e1022 / _e1042);
let _e1045 = (_e1038 / _e1042);
let _e1050 = (((_e975 * _e975) + (_e978 * _e978)) + (_e981 * _e981));
let _e1053 = sqrt(select(0f, _e1050, (_e1050 > 0f)));
let _e1056 = (1f / select(1e-20f, _e1053, (_e1053 > 1e-20f)));
let _e1061 = (_e884 + 9i);
let _e1063 = select(_e886, _e1061, (_e1061 < _e886));
let _e1069 = global_6.member[bitcast<u32>(select(0i, _e1063, (_e1063 > 0i)))];
let _e1070 = (_e884 + 10i);
let _e1072 = select(_e886, _e1070, (_e1070 < _e886));
let _e1078 = global_6.member[bitcast<u32>(select(0i, _e1072, (_e1072 > 0i)))];
let _e1079 = (_e884 + 11i);
let _e1081 = select(_e886, _e1079, (_e1079 < _e886));
let _e1087 = global_6.member[bitcast<u32>(select(0i, _e1081, (_e1081 > 0i)))];
let _e1091 = (_e884 + 12i);
let _e1093 = select(_e886, _e1091, (_e1091 < _e886));
let _e1099 = global_6.member[bitcast<u32>(select(0i, _e1093, (_e1093 > 0i)))];
let _e1100 = (_e884 + 13i);
let _e1102 = select(_e886, _e1100, (_e1100 < _e886));
let _e1108 = global_6.member[bitcast<u32>(select(0i, _e1102, (_e1102 > 0i)))];
let _e1109 = (_e884 + 14i);
let _e1111 = select(_e886, _e1109, (_e1109 < _e886));
let _e1117 = global_6.member[bitcast<u32>(select(0i, _e1111, (_e1111 > 0i)))];
let _e1124 = (_e884 + 15i);
let _e1126 = select(_e886, _e1124, (_e1124 < _e886));
let _e1132 = global_6.member[bitcast<u32>(select(0i, _e1126, (_e1126 > 0i)))];
let _e1133 = (_e884 + 16i);
let _e1135 = select(_e886, _e1133, (_e1133 < _e886));
let _e1141 = global_6.member[bitcast<u32>(select(0i, _e1135, (_e1135 > 0i)))];
let _e1142 = (_e884 + 17i);
let _e1144 = select(_e886, _e1142, (_e1142 < _e886));
let _e1150 = global_6.member[bitcast<u32>(select(0i, _e1144, (_e1144 > 0i)))];
let _e1154 = (((_e1069 * _e1043) + (_e1099 * _e1044)) + (_e1132 * _e1045));
let _e1155 = (((_e1078 * _e1043) + (_e1108 * _e1044)) + (_e1141 * _e1045));
let _e1156 = (((_e1087 * _e1043) + (_e1117 * _e1044)) + (_e1150 * _e1045));
let _e1161 = (((_e1154 * _e1154) + (_e1155 * _e1155)) + (_e1156 * _e1156));
let _e1164 = sqrt(select(0f, _e1161, (_e1161 > 0f)));
let _e1167 = (1f / select(1e-20f, _e1164, (_e1164 > 1e-20f)));
let _e1172 = (_e884 + 18i);
let _e1174 = select(_e886, _e1172, (_e1172 < _e886));
let _e1180 = global_6.member[bitcast<u32>(select(0i, _e1174, (_e1174 > 0i)))];
let _e1189 = (select(select(0i, select(select(i32(_e1180), i32(-2147483648), (_e1180 < -2147483600f)), 2147483647i, (_e1180 > 2147483500f)), (_e1180 == _e1180)), _e728, ((_e836 & 1u) != 0u)) * 10i);
let _e1191 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1193 = select(_e1191, _e1189, (_e1189 < _e1191));
let _e1199 = global_7.member[bitcast<u32>(select(0i, _e1193, (_e1193 > 0i)))];
let _e1200 = (_e1189 + 1i);
let _e1202 = select(_e1191, _e1200, (_e1200 < _e1191));
let _e1208 = global_7.member[bitcast<u32>(select(0i, _e1202, (_e1202 > 0i)))];
let _e1209 = (_e1189 + 2i);
let _e1211 = select(_e1191, _e1209, (_e1209 < _e1191));
let _e1217 = global_7.member[bitcast<u32>(select(0i, _e1211, (_e1211 > 0i)))];
let _e1221 = (_e1189 + 3i);
let _e1223 = select(_e1191, _e1221, (_e1221 < _e1191));
let _e1229 = global_7.member[bitcast<u32>(select(0i, _e1223, (_e1223 > 0i)))];
let _e1230 = (_e1189 + 4i);
let _e1232 = select(_e1191, _e1230, (_e1230 < _e1191));
let _e1238 = global_7.member[bitcast<u32>(select(0i, _e1232, (_e1232 > 0i)))];
let _e1239 = (_e1189 + 5i);
let _e1241 = select(_e1191, _e1239, (_e1239 < _e1191));
let _e1247 = global_7.member[bitcast<u32>(select(0i, _e1241, (_e1241 > 0i)))];
let _e1254 = (_e1189 + 6i);
let _e1256 = select(_e1191, _e1254, (_e1254 < _e1191));
let _e1262 = global_7.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1263 = (_e1189 + 7i);
let _e1265 = select(_e1191, _e1263, (_e1263 < _e1191));
let _e1271 = global_7.member[bitcast<u32>(select(0i, _e1265, (_e1265 > 0i)))];
let _e1272 = (_e1189 + 8i);
let _e1274 = select(_e1191, _e1272, (_e1272 < _e1191));
let _e1280 = global_7.member[bitcast<u32>(select(0i, _e1274, (_e1274 > 0i)))];
let _e1288 = (_e1189 + 9i);
let _e1290 = select(_e1191, _e1288, (_e1288 < _e1191));
let _e1296 = global_7.member[bitcast<u32>(select(0i, _e1290, (_e1290 > 0i)))];
phi_2482_ = type_28(_e833, vec3<f32>((_e975 * _e1056), (_e978 * _e1056), (_e981 * _e1056)), vec3<f32>((_e1154 * _e1167), (_e1155 * _e1167), (_e1156 * _e1167)), vec3<f32>((((_e1199 * _e1043) + (_e1229 * _e1044)) + (_e1262 * _e1045)), (((_e1208 * _e1043) + (_e1238 * _e1044)) + (_e1271 * _e1045)), (((_e1217 * _e1043) + (_e1247 * _e1044)) + (_e1280 * _e1045))), _e1296, true, false);
} else {
let _e840 = (_e728 == -3i);
let _e846 = global_1.member.member_14.member_1.member.member;
let _e851 = global_1.member.member_14.member_1.member_1;
let _e857 = global_1.member.member_14.member.member.member;
let _e862 = global_1.member.member_14.member.member_1;
let _e872 = vec3<f32>(select(_e857.member, _e846.member, _e840), select(_e857.member_1, _e846.member_1, _e840), select(_e857.member_2, _e846.member_2, _e840));
phi_2482_ = type_28(_e833, _e872, _e872, vec3<f32>(select(_e862.member, _e851.member, _e840), select(_e862.member_1, _e851.member_1, _e840), select(_e862.member_2, _e851.member_2, _e840)), 0f, false, _e840);
}
let _e1299 = phi_2482_;
let _e1302 = ((select(0i, _e728, _e839) * 19i) + 18i);
let _e1304 = (bitcast<i32>(_e145) - 1i);
let _e1306 = select(_e1304, _e1302, (_e1302 < _e1304));
let _e1312 = global_6.member[bitcast<u32>(select(0i, _e1306, (_e1306 > 0i)))];
let _e1319 = select(0i, select(select(i32(_e1312), i32(-2147483648), (_e1312 < -2147483600f)), 2147483647i, (_e1312 > 2147483500f)), (_e1312 == _e1312));
let _e1320 = (_e1319 * 4i);
let _e1322 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e1324 = select(_e1322, _e1320, (_e1320 < _e1322));
let _e1330 = global_8.member[bitcast<u32>(select(0i, _e1324, (_e1324 > 0i)))];
if _e839 {
phi_2546_ = (select(_e1330, 1f, (_e1319 == 16i)) == 0f);
} else {
phi_2546_ = (_e728 != -1i);
}
let _e1336 = phi_2546_;
if _e1336 {
let _e1340 = (_e534 + (_e600 * _e710));
let _e1341 = (_e545 + (_e611 * _e710));
let _e1342 = (_e556 + (_e622 * _e710));
let _e1346 = (_e567 + (_e633 * _e710));
let _e1347 = (_e578 + (_e644 * _e710));
let _e1348 = (_e589 + (_e655 * _e710));
let _e1357 = (((_e501 * _e1299.member_1.x) + (_e512 * _e1299.member_1.y)) + (_e523 * _e1299.member_1.z));
if ((_e1357 * _e1357) > 1e-12f) {
phi_2578_ = (1f / _e1357);
} else {
phi_2578_ = 0f;
}
let _e1362 = phi_2578_;
let _e1368 = ((((_e1340 * _e1299.member_1.x) + (_e1341 * _e1299.member_1.y)) + (_e1342 * _e1299.member_1.z)) * _e1362);
let _e1372 = (_e1340 - (_e501 * _e1368));
let _e1373 = (_e1341 - (_e512 * _e1368));
let _e1374 = (_e1342 - (_e523 * _e1368));
let _e1380 = ((((_e1346 * _e1299.member_1.x) + (_e1347 * _e1299.member_1.y)) + (_e1348 * _e1299.member_1.z)) * _e1362);
let _e1384 = (_e1346 - (_e501 * _e1380));
let _e1385 = (_e1347 - (_e512 * _e1380));
let _e1386 = (_e1348 - (_e523 * _e1380));
let _e1391 = (((_e1372 * _e1372) + (_e1373 * _e1373)) + (_e1374 * _e1374));
let _e1399 = (((_e1384 * _e1384) + (_e1385 * _e1385)) + (_e1386 * _e1386));
let _e1405 = (0.05f + (0.5f * (sqrt(select(0f, _e1391, (_e1391 > 0f))) + sqrt(select(0f, _e1399, (_e1399 > 0f))))));
let _e1409 = global_1.member.member_11.member;
let _e1415 = global_1.member.member_12.member_5;
let _e1419 = global_1.member.member_12.member_6;
phi_2658_ = 0u;
loop {
let _e1423 = phi_2658_;
local_35 = _e1423;
let _e1427 = ((1u << bitcast<u32>((_e1423 & 31u))) < _e1409);
if _e1427 {
phi_2659_ = (_e1423 + 1u);
} else {
phi_2659_ = u32();
}
let _e1430 = phi_2659_;
continue;
continuing {
phi_2658_ = _e1430;
break if !(_e1427);
}
}
phi_2671_ = 0u;
loop {
let _e1433 = phi_2671_;
local_23 = _e1433;
local_24 = _e1433;
let _e1437 = ((1u << bitcast<u32>((_e1433 & 31u))) < _e1409);
if _e1437 {
phi_2672_ = (_e1433 + 1u);
} else {
phi_2672_ = u32();
}
let _e1440 = phi_2672_;
continue;
continuing {
phi_2671_ = _e1440;
break if !(_e1437);
}
}
let _e1443 = local_23;
let _e1446 = local_24;
phi_2689_ = 0u;
loop {
let _e1449 = phi_2689_;
local_27 = _e1449;
let _e1453 = ((1u << bitcast<u32>((_e1449 & 31u))) < _e1409);
if _e1453 {
phi_2690_ = (_e1449 + 1u);
} else {
phi_2690_ = u32();
}
let _e1456 = phi_2690_;
continue;
continuing {
phi_2689_ = _e1456;
break if !(_e1453);
}
}
phi_2702_ = 0u;
loop {
let _e1459 = phi_2702_;
local_25 = _e1459;
local_26 = _e1459;
let _e1463 = ((1u << bitcast<u32>((_e1459 & 31u))) < _e1409);
if _e1463 {
phi_2703_ = (_e1459 + 1u);
} else {
phi_2703_ = u32();
}
let _e1466 = phi_2703_;
continue;
continuing {
phi_2702_ = _e1466;
break if !(_e1463);
}
}
let _e1469 = local_25;
let _e1472 = local_26;
let _e1475 = local_27;
let _e1484 = global_1.member.member_12.member_8;
phi_2728_ = 0u;
loop {
let _e1487 = phi_2728_;
local_28 = _e1487;
local_29 = _e1487;
let _e1491 = ((1u << bitcast<u32>((_e1487 & 31u))) < _e1409);
if _e1491 {
phi_2729_ = (_e1487 + 1u);
} else {
phi_2729_ = u32();
}
let _e1494 = phi_2729_;
continue;
continuing {
phi_2728_ = _e1494;
break if !(_e1491);
}
}
let _e1497 = local_28;
let _e1500 = local_29;
phi_2746_ = 0u;
loop {
let _e1503 = phi_2746_;
local_30 = _e1503;
local_31 = _e1503;
let _e1507 = ((1u << bitcast<u32>((_e1503 & 31u))) < _e1409);
if _e1507 {
phi_2747_ = (_e1503 + 1u);
} else {
phi_2747_ = u32();
}
let _e1510 = phi_2747_;
continue;
continuing {
phi_2746_ = _e1510;
break if !(_e1507);
}
}
let _e1513 = local_30;
let _e1519 = local_31;
phi_2769_ = 0u;
loop {
let _e1529 = phi_2769_;
local_34 = _e1529;
let _e1533 = ((1u << bitcast<u32>((_e1529 & 31u))) < _e1409);
if _e1533 {
phi_2770_ = (_e1529 + 1u);
} else {
phi_2770_ = u32();
}
let _e1536 = phi_2770_;
continue;
continuing {
phi_2769_ = _e1536;
break if !(_e1533);
}
}
phi_2782_ = 0u;
loop {
let _e1539 = phi_2782_;
local_32 = _e1539;
local_33 = _e1539;
let _e1543 = ((1u << bitcast<u32>((_e1539 & 31u))) < _e1409);
if _e1543 {
phi_2783_ = (_e1539 + 1u);
} else {
phi_2783_ = u32();
}
let _e1546 = phi_2783_;
continue;
continuing {
phi_2782_ = _e1546;
break if !(_e1543);
}
}
let _e1549 = local_32;
let _e1552 = local_33;
let _e1555 = local_34;
let _e1561 = (((((1u << bitcast<u32>(((2u * _e1513) & 31u))) - (1u << bitcast<u32>(((2u * (_e1519 - select(6u, _e1500, (_e1497 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1555 - select(6u, _e1552, (_e1549 < 6u)))) & 31u))));
let _e1562 = (_e1561 / 64u);
if ((_e1561 % 64u) > 0u) {
phi_2819_ = (_e1562 + 1u);
} else {
phi_2819_ = _e1562;
}
let _e1567 = phi_2819_;
let _e1570 = local_35;
local_20 = type_26(_e1570, select(6u, _e1446, (_e1443 < 6u)), (1u << bitcast<u32>(((2u * (_e1475 - select(6u, _e1472, (_e1469 < 6u)))) & 31u))), (_e1415 * _e1484), (_e1567 * 64u));
let _e1573 = local_20.member_1;
phi_2832_ = vec3<f32>(0f, 0f, 0f);
phi_2835_ = type_13(_e1573, 0u);
loop {
let _e1576 = phi_2832_;
let _e1578 = phi_2835_;
local_36 = _e1576;
local_37 = _e1576;
local_38 = _e1576;
let _e1581 = local_20.member_1;
let _e1584 = local_20.member_2;
let _e1586 = ((_e1578.member < _e1581) || (_e1578.member_1 < _e1584));
if _e1586 {
local_18.member = _e1578.member;
local_18.member_1 = _e1578.member_1;
let _e1590 = local_18.member;
let _e1591 = local_18.member_1;
let _e1593 = local_20.member;
let _e1608 = local_20.member_3;
let _e1610 = local_20.member_4;
local_19 = ((_e1608 + (18u * _e1610)) + (((((1u << bitcast<u32>(((2u * _e1593) & 31u))) - (1u << bitcast<u32>(((2u * (_e1593 - _e1590)) & 31u)))) / 3u) * 4u) + _e1591));
let _e1614 = local_19;
let _e1615 = bitcast<i32>(_e1614);
let _e1617 = (bitcast<i32>(_e143) - 1i);
let _e1619 = select(_e1617, _e1615, (_e1615 < _e1617));
let _e1624 = global_4.member[bitcast<u32>(select(0i, _e1619, (_e1619 > 0i)))];
let _e1625 = local_19;
let _e1626 = local_20.member_4;
let _e1628 = bitcast<i32>((_e1625 + _e1626));
let _e1630 = select(_e1617, _e1628, (_e1628 < _e1617));
let _e1635 = global_4.member[bitcast<u32>(select(0i, _e1630, (_e1630 > 0i)))];
let _e1636 = local_19;
let _e1637 = local_20.member_4;
let _e1640 = bitcast<i32>((_e1636 + (2u * _e1637)));
let _e1642 = select(_e1617, _e1640, (_e1640 < _e1617));
let _e1647 = global_4.member[bitcast<u32>(select(0i, _e1642, (_e1642 > 0i)))];
let _e1648 = local_18.member;
let _e1649 = local_18.member_1;
let _e1650 = local_20.member;
let _e1664 = local_20.member_3;
let _e1665 = local_20.member_4;
local_17 = ((_e1664 + (21u * _e1665)) + (((((1u << bitcast<u32>(((2u * _e1650) & 31u))) - (1u << bitcast<u32>(((2u * (_e1650 - _e1648)) & 31u)))) / 3u) * 4u) + _e1649));
let _e1669 = local_17;
let _e1670 = bitcast<i32>(_e1669);
let _e1672 = select(_e1617, _e1670, (_e1670 < _e1617));
let _e1677 = global_4.member[bitcast<u32>(select(0i, _e1672, (_e1672 > 0i)))];
let _e1678 = local_17;
let _e1679 = local_20.member_4;
let _e1681 = bitcast<i32>((_e1678 + _e1679));
let _e1683 = select(_e1617, _e1681, (_e1681 < _e1617));
let _e1688 = global_4.member[bitcast<u32>(select(0i, _e1683, (_e1683 > 0i)))];
let _e1689 = local_17;
let _e1690 = local_20.member_4;
let _e1693 = bitcast<i32>((_e1689 + (2u * _e1690)));
let _e1695 = select(_e1617, _e1693, (_e1693 < _e1617));
let _e1700 = global_4.member[bitcast<u32>(select(0i, _e1695, (_e1695 > 0i)))];
let _e1722 = ((((_e1624 <= _e1677) && ((_e1299.member.x >= (_e1624 - _e1405)) && (_e1299.member.x <= (_e1677 + _e1405)))) && ((_e1299.member.y >= (_e1635 - _e1405)) && (_e1299.member.y <= (_e1688 + _e1405)))) && ((_e1299.member.z >= (_e1647 - _e1405)) && (_e1299.member.z <= (_e1700 + _e1405))));
let _e1723 = local_20.member_1;
if (_e1723 < 2u) {
let _e1725 = local_20.member_1;
phi_3094_ = _e1725;
} else {
phi_3094_ = 2u;
}
let _e1727 = phi_3094_;
if (_e1722 && (_e1578.member > _e1727)) {
phi_6481_ = _e1576;
phi_6482_ = type_13((_e1578.member - 1u), (_e1578.member_1 << bitcast<u32>(2i)));
} else {
if _e1722 {
local_15.member = _e1578.member;
local_15.member_1 = _e1578.member_1;
let _e1732 = local_15.member_1;
let _e1733 = local_20.member_1;
if (_e1733 < 2u) {
let _e1735 = local_20.member_1;
phi_3125_ = _e1735;
} else {
phi_3125_ = 2u;
}
let _e1737 = phi_3125_;
let _e1743 = local_20.member_3;
let _e1744 = local_20.member_4;
let _e1747 = local_20.member_4;
local_16 = 0u;
phi_3149_ = 0u;
loop {
let _e1753 = phi_3149_;
local_39 = _e1753;
let _e1754 = local_16;
let _e1755 = (_e1754 < select(0u, 16u, ((((_e1732 << bitcast<u32>(((2u * _e1737) & 31u))) + 16u) <= _e1747) && ((_e1743 + (24u * _e1744)) <= _e143))));
if _e1755 {
let _e1756 = local_15.member_1;
let _e1757 = local_16;
local_13 = _e1757;
let _e1758 = local_20.member_3;
let _e1759 = local_20.member_4;
let _e1762 = local_20.member_1;
if (_e1762 < 2u) {
let _e1764 = local_20.member_1;
phi_3185_ = _e1764;
} else {
phi_3185_ = 2u;
}
let _e1766 = phi_3185_;
local_14 = ((_e1758 + (18u * _e1759)) + (_e1756 << bitcast<u32>(((2u * _e1766) & 31u))));
let _e1772 = local_14;
let _e1774 = local_13;
let _e1779 = global_4.member[bitcast<u32>((bitcast<i32>(_e1772) + bitcast<i32>(_e1774)))];
let _e1780 = local_14;
let _e1781 = local_20.member_4;
let _e1784 = local_13;
let _e1789 = global_4.member[bitcast<u32>((bitcast<i32>((_e1780 + _e1781)) + bitcast<i32>(_e1784)))];
let _e1790 = local_14;
let _e1791 = local_20.member_4;
let _e1795 = local_13;
let _e1800 = global_4.member[bitcast<u32>((bitcast<i32>((_e1790 + (2u * _e1791))) + bitcast<i32>(_e1795)))];
let _e1801 = local_15.member_1;
let _e1802 = local_16;
local_11 = _e1802;
let _e1803 = local_20.member_3;
let _e1804 = local_20.member_4;
let _e1807 = local_20.member_1;
if (_e1807 < 2u) {
let _e1809 = local_20.member_1;
phi_3256_ = _e1809;
} else {
phi_3256_ = 2u;
}
let _e1811 = phi_3256_;
local_12 = ((_e1803 + (21u * _e1804)) + (_e1801 << bitcast<u32>(((2u * _e1811) & 31u))));
let _e1817 = local_12;
let _e1819 = local_11;
let _e1824 = global_4.member[bitcast<u32>((bitcast<i32>(_e1817) + bitcast<i32>(_e1819)))];
let _e1825 = local_12;
let _e1826 = local_20.member_4;
let _e1829 = local_11;
let _e1834 = global_4.member[bitcast<u32>((bitcast<i32>((_e1825 + _e1826)) + bitcast<i32>(_e1829)))];
let _e1835 = local_12;
let _e1836 = local_20.member_4;
let _e1840 = local_11;
let _e1845 = global_4.member[bitcast<u32>((bitcast<i32>((_e1835 + (2u * _e1836))) + bitcast<i32>(_e1840)))];
let _e1865 = local_16;
let _e1866 = local_15.member_1;
let _e1867 = local_20.member_1;
if (_e1867 < 2u) {
let _e1869 = local_20.member_1;
phi_3346_ = _e1869;
} else {
phi_3346_ = 2u;
}
let _e1871 = phi_3346_;
let _e1873 = ((2u * _e1871) & 31u);
let _e1876 = ((_e1866 << bitcast<u32>(_e1873)) + _e1865);
let _e1877 = (_e1876 & 1431655765u);
let _e1881 = ((_e1877 | (_e1877 >> bitcast<u32>(1i))) & 858993459u);
let _e1885 = ((_e1881 | (_e1881 >> bitcast<u32>(2i))) & 252645135u);
let _e1889 = ((_e1885 | (_e1885 >> bitcast<u32>(4i))) & 16711935u);
let _e1896 = ((_e1876 >> bitcast<u32>(1i)) & 1431655765u);
let _e1900 = ((_e1896 | (_e1896 >> bitcast<u32>(1i))) & 858993459u);
let _e1904 = ((_e1900 | (_e1900 >> bitcast<u32>(2i))) & 252645135u);
let _e1908 = ((_e1904 | (_e1904 >> bitcast<u32>(4i))) & 16711935u);
let _e1922 = local_16;
let _e1927 = local_16;
local_16 = (_e1927 + 1u);
phi_3150_ = (_e1753 | (select(0u, 1u, ((((_e1865 < (1u << bitcast<u32>(_e1873))) && (((_e1889 | (_e1889 >> bitcast<u32>(8i))) & 65535u) < _e1409)) && (((_e1908 | (_e1908 >> bitcast<u32>(8i))) & 65535u) < _e1409)) && ((((_e1779 <= _e1824) && ((_e1299.member.x >= (_e1779 - _e1405)) && (_e1299.member.x <= (_e1824 + _e1405)))) && ((_e1299.member.y >= (_e1789 - _e1405)) && (_e1299.member.y <= (_e1834 + _e1405)))) && ((_e1299.member.z >= (_e1800 - _e1405)) && (_e1299.member.z <= (_e1845 + _e1405)))))) << bitcast<u32>((_e1922 & 31u))));
} else {
phi_3150_ = u32();
}
let _e1930 = phi_3150_;
continue;
continuing {
phi_3149_ = _e1930;
break if !(_e1755);
}
}
let _e4741 = local_39;
phi_3397_ = _e4741;
} else {
phi_3397_ = 0u;
}
let _e1933 = phi_3397_;
phi_3399_ = _e1576;
phi_3402_ = 0u;
loop {
let _e1935 = phi_3399_;
let _e1937 = phi_3402_;
local_41 = _e1935;
let _e1940 = (_e1933 >> bitcast<u32>((_e1937 & 31u)));
let _e1941 = (_e1940 == 0u);
if _e1941 {
phi_3400_ = vec3<f32>();
phi_3403_ = u32();
} else {
if ((_e1940 & 1u) == 0u) {
phi_6449_ = _e1935;
} else {
let _e1944 = local_20.member_1;
if (_e1944 < 2u) {
let _e1946 = local_20.member_1;
phi_3431_ = _e1946;
} else {
phi_3431_ = 2u;
}
let _e1948 = phi_3431_;
let _e1950 = ((2u * _e1948) & 31u);
let _e1953 = ((_e1578.member_1 << bitcast<u32>(_e1950)) + _e1937);
let _e1954 = (_e1953 & 1431655765u);
let _e1958 = ((_e1954 | (_e1954 >> bitcast<u32>(1i))) & 858993459u);
let _e1962 = ((_e1958 | (_e1958 >> bitcast<u32>(2i))) & 252645135u);
let _e1966 = ((_e1962 | (_e1962 >> bitcast<u32>(4i))) & 16711935u);
let _e1970 = ((_e1966 | (_e1966 >> bitcast<u32>(8i))) & 65535u);
let _e1973 = ((_e1953 >> bitcast<u32>(1i)) & 1431655765u);
let _e1977 = ((_e1973 | (_e1973 >> bitcast<u32>(1i))) & 858993459u);
let _e1981 = ((_e1977 | (_e1977 >> bitcast<u32>(2i))) & 252645135u);
let _e1985 = ((_e1981 | (_e1981 >> bitcast<u32>(4i))) & 16711935u);
let _e1989 = ((_e1985 | (_e1985 >> bitcast<u32>(8i))) & 65535u);
if (((_e1937 < (1u << bitcast<u32>(_e1950))) && (_e1970 < _e1409)) && (_e1989 < _e1409)) {
phi_3477_ = bitcast<i32>(((_e1989 * _e1409) + _e1970));
} else {
phi_3477_ = 0i;
}
let _e2001 = phi_3477_;
local_8 = bitcast<i32>((_e1415 * _e1419));
local_9 = _e2001;
local_10 = bitcast<i32>((_e1409 * _e1409));
let _e2002 = local_8;
let _e2003 = local_9;
let _e2004 = (_e2002 + _e2003);
let _e2006 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e2008 = select(_e2006, _e2004, (_e2004 < _e2006));
let _e2013 = global_3.member[bitcast<u32>(select(0i, _e2008, (_e2008 > 0i)))];
let _e2014 = local_8;
let _e2015 = local_10;
let _e2017 = local_9;
let _e2018 = ((_e2014 + _e2015) + _e2017);
let _e2020 = select(_e2006, _e2018, (_e2018 < _e2006));
let _e2025 = global_3.member[bitcast<u32>(select(0i, _e2020, (_e2020 > 0i)))];
let _e2026 = local_8;
let _e2027 = local_10;
let _e2030 = local_9;
let _e2031 = ((_e2026 + (2i * _e2027)) + _e2030);
let _e2033 = select(_e2006, _e2031, (_e2031 < _e2006));
let _e2038 = global_3.member[bitcast<u32>(select(0i, _e2033, (_e2033 > 0i)))];
let _e2039 = local_8;
let _e2040 = local_10;
let _e2043 = local_9;
let _e2044 = ((_e2039 + (3i * _e2040)) + _e2043);
let _e2046 = select(_e2006, _e2044, (_e2044 < _e2006));
let _e2051 = global_3.member[bitcast<u32>(select(0i, _e2046, (_e2046 > 0i)))];
let _e2052 = local_8;
let _e2053 = local_10;
let _e2056 = local_9;
let _e2057 = ((_e2052 + (4i * _e2053)) + _e2056);
let _e2059 = select(_e2006, _e2057, (_e2057 < _e2006));
let _e2064 = global_3.member[bitcast<u32>(select(0i, _e2059, (_e2059 > 0i)))];
let _e2065 = local_8;
let _e2066 = local_10;
let _e2069 = local_9;
let _e2070 = ((_e2065 + (5i * _e2066)) + _e2069);
let _e2072 = select(_e2006, _e2070, (_e2070 < _e2006));
let _e2077 = global_3.member[bitcast<u32>(select(0i, _e2072, (_e2072 > 0i)))];
let _e2078 = local_8;
let _e2079 = local_10;
let _e2082 = local_9;
let _e2083 = ((_e2078 + (6i * _e2079)) + _e2082);
let _e2085 = select(_e2006, _e2083, (_e2083 < _e2006));
let _e2090 = global_3.member[bitcast<u32>(select(0i, _e2085, (_e2085 > 0i)))];
let _e2091 = local_8;
let _e2092 = local_10;
let _e2095 = local_9;
let _e2096 = ((_e2091 + (7i * _e2092)) + _e2095);
let _e2098 = select(_e2006, _e2096, (_e2096 < _e2006));
let _e2103 = global_3.member[bitcast<u32>(select(0i, _e2098, (_e2098 > 0i)))];
let _e2104 = local_8;
let _e2105 = local_10;
let _e2108 = local_9;
let _e2109 = ((_e2104 + (8i * _e2105)) + _e2108);
let _e2111 = select(_e2006, _e2109, (_e2109 < _e2006));
let _e2116 = global_3.member[bitcast<u32>(select(0i, _e2111, (_e2111 > 0i)))];
let _e2117 = local_8;
let _e2118 = local_10;
let _e2121 = local_9;
let _e2122 = ((_e2117 + (9i * _e2118)) + _e2121);
let _e2124 = select(_e2006, _e2122, (_e2122 < _e2006));
let _e2129 = global_3.member[bitcast<u32>(select(0i, _e2124, (_e2124 > 0i)))];
let _e2130 = local_8;
let _e2131 = local_10;
let _e2134 = local_9;
let _e2135 = ((_e2130 + (10i * _e2131)) + _e2134);
let _e2137 = select(_e2006, _e2135, (_e2135 < _e2006));
let _e2142 = global_3.member[bitcast<u32>(select(0i, _e2137, (_e2137 > 0i)))];
let _e2143 = local_8;
let _e2144 = local_10;
let _e2147 = local_9;
let _e2148 = ((_e2143 + (11i * _e2144)) + _e2147);
let _e2150 = select(_e2006, _e2148, (_e2148 < _e2006));
let _e2155 = global_3.member[bitcast<u32>(select(0i, _e2150, (_e2150 > 0i)))];
let _e2156 = local_8;
let _e2157 = local_10;
let _e2160 = local_9;
let _e2161 = ((_e2156 + (12i * _e2157)) + _e2160);
let _e2163 = select(_e2006, _e2161, (_e2161 < _e2006));
let _e2168 = global_3.member[bitcast<u32>(select(0i, _e2163, (_e2163 > 0i)))];
let _e2169 = local_8;
let _e2170 = local_10;
let _e2173 = local_9;
let _e2174 = ((_e2169 + (13i * _e2170)) + _e2173);
let _e2176 = select(_e2006, _e2174, (_e2174 < _e2006));
let _e2181 = global_3.member[bitcast<u32>(select(0i, _e2176, (_e2176 > 0i)))];
let _e2182 = local_8;
let _e2183 = local_10;
let _e2186 = local_9;
let _e2187 = ((_e2182 + (14i * _e2183)) + _e2186);
let _e2189 = select(_e2006, _e2187, (_e2187 < _e2006));
let _e2194 = global_3.member[bitcast<u32>(select(0i, _e2189, (_e2189 > 0i)))];
let _e2195 = local_8;
let _e2196 = local_10;
let _e2199 = local_9;
let _e2200 = ((_e2195 + (15i * _e2196)) + _e2199);
let _e2202 = select(_e2006, _e2200, (_e2200 < _e2006));
let _e2207 = global_3.member[bitcast<u32>(select(0i, _e2202, (_e2202 > 0i)))];
let _e2208 = local_8;
let _e2209 = local_10;
let _e2212 = local_9;
let _e2213 = ((_e2208 + (16i * _e2209)) + _e2212);
let _e2215 = select(_e2006, _e2213, (_e2213 < _e2006));
let _e2220 = global_3.member[bitcast<u32>(select(0i, _e2215, (_e2215 > 0i)))];
let _e2221 = local_8;
let _e2222 = local_10;
let _e2225 = local_9;
let _e2226 = ((_e2221 + (17i * _e2222)) + _e2225);
let _e2228 = select(_e2006, _e2226, (_e2226 < _e2006));
let _e2233 = global_3.member[bitcast<u32>(select(0i, _e2228, (_e2228 > 0i)))];
let _e2234 = local_8;
let _e2235 = local_10;
let _e2238 = local_9;
let _e2239 = ((_e2234 + (18i * _e2235)) + _e2238);
let _e2241 = select(_e2006, _e2239, (_e2239 < _e2006));
let _e2246 = global_3.member[bitcast<u32>(select(0i, _e2241, (_e2241 > 0i)))];
let _e2247 = local_8;
let _e2248 = local_10;
let _e2251 = local_9;
let _e2252 = ((_e2247 + (19i * _e2248)) + _e2251);
let _e2254 = select(_e2006, _e2252, (_e2252 < _e2006));
let _e2259 = global_3.member[bitcast<u32>(select(0i, _e2254, (_e2254 > 0i)))];
let _e2260 = local_8;
let _e2261 = local_10;
let _e2264 = local_9;
let _e2265 = ((_e2260 + (20i * _e2261)) + _e2264);
let _e2267 = select(_e2006, _e2265, (_e2265 < _e2006));
let _e2272 = global_3.member[bitcast<u32>(select(0i, _e2267, (_e2267 > 0i)))];
let _e2273 = local_8;
let _e2274 = local_10;
let _e2277 = local_9;
let _e2278 = ((_e2273 + (23i * _e2274)) + _e2277);
let _e2280 = select(_e2006, _e2278, (_e2278 < _e2006));
let _e2285 = global_3.member[bitcast<u32>(select(0i, _e2280, (_e2280 > 0i)))];
let _e2286 = local_8;
let _e2287 = local_10;
let _e2290 = local_9;
let _e2291 = ((_e2286 + (24i * _e2287)) + _e2290);
let _e2293 = select(_e2006, _e2291, (_e2291 < _e2006));
let _e2298 = global_3.member[bitcast<u32>(select(0i, _e2293, (_e2293 > 0i)))];
let _e2303 = (((_e1299.member_1.x * _e2051) + (_e1299.member_1.y * _e2064)) + (_e1299.member_1.z * _e2077));
let _e2306 = bitcast<f32>((bitcast<u32>(_e2303) & 2147483647u));
if (_e2306 < 1e-6f) {
phi_6432_ = vec3<f32>();
phi_6433_ = true;
} else {
let _e2308 = (1f / _e2303);
let _e2317 = ((((_e1299.member_1.x * (_e1299.member.x - _e2013)) + (_e1299.member_1.y * (_e1299.member.y - _e2025))) + (_e1299.member_1.z * (_e1299.member.z - _e2038))) * _e2308);
let _e2321 = (_e2090 + (_e2168 * _e2317));
let _e2322 = (_e2103 + (_e2181 * _e2317));
let _e2323 = (_e2116 + (_e2194 * _e2317));
let _e2329 = ((((_e1299.member_1.x * _e2321) + (_e1299.member_1.y * _e2322)) + (_e1299.member_1.z * _e2323)) * _e2308);
let _e2333 = (_e2321 - (_e2051 * _e2329));
let _e2334 = (_e2322 - (_e2064 * _e2329));
let _e2335 = (_e2323 - (_e2077 * _e2329));
let _e2339 = (_e2129 + (_e2207 * _e2317));
let _e2340 = (_e2142 + (_e2220 * _e2317));
let _e2341 = (_e2155 + (_e2233 * _e2317));
let _e2347 = ((((_e1299.member_1.x * _e2339) + (_e1299.member_1.y * _e2340)) + (_e1299.member_1.z * _e2341)) * _e2308);
let _e2351 = (_e2339 - (_e2051 * _e2347));
let _e2352 = (_e2340 - (_e2064 * _e2347));
let _e2353 = (_e2341 - (_e2077 * _e2347));
let _e2389 = (((0.5f * (bitcast<f32>((bitcast<u32>((((_e2333 * _e2051) + (_e2334 * _e2064)) + (_e2335 * _e2077))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((((_e2351 * _e2051) + (_e2352 * _e2064)) + (_e2353 * _e2077))) & 2147483647u)))) + bitcast<f32>((bitcast<u32>((((_e1372 * _e2051) + (_e1373 * _e2064)) + (_e1374 * _e2077))) & 2147483647u))) + bitcast<f32>((bitcast<u32>((((_e1384 * _e2051) + (_e1385 * _e2064)) + (_e1386 * _e2077))) & 2147483647u)));
if ((_e2317 < (-(0.05f) - _e2389)) || (bitcast<f32>((bitcast<u32>((_e2317 - _e2298)) & 2147483647u)) > (_e2389 + 0.05f))) {
phi_6427_ = vec3<f32>();
phi_6428_ = true;
} else {
let _e2406 = (_e1299.member.x - (_e2013 + (_e2051 * _e2317)));
let _e2407 = (_e1299.member.y - (_e2025 + (_e2064 * _e2317)));
let _e2408 = (_e1299.member.z - (_e2038 + (_e2077 * _e2317)));
let _e2413 = (((_e2333 * _e2333) + (_e2334 * _e2334)) + (_e2335 * _e2335));
let _e2416 = sqrt(select(0f, _e2413, (_e2413 > 0f)));
let _e2421 = (((_e2351 * _e2351) + (_e2352 * _e2352)) + (_e2353 * _e2353));
let _e2424 = sqrt(select(0f, _e2421, (_e2421 > 0f)));
let _e2439 = (1f / (((((_e1373 * _e1386) - (_e1374 * _e1385)) * _e1299.member_1.x) + (((_e1374 * _e1384) - (_e1372 * _e1386)) * _e1299.member_1.y)) + (((_e1372 * _e1385) - (_e1373 * _e1384)) * _e1299.member_1.z)));
let _e2453 = (((((_e2334 * _e1386) - (_e2335 * _e1385)) * _e1299.member_1.x) + (((_e2335 * _e1384) - (_e2333 * _e1386)) * _e1299.member_1.y)) + (((_e2333 * _e1385) - (_e2334 * _e1384)) * _e1299.member_1.z));
let _e2498 = (((((_e1373 * _e2353) - (_e1374 * _e2352)) * _e1299.member_1.x) + (((_e1374 * _e2351) - (_e1372 * _e2353)) * _e1299.member_1.y)) + (((_e1372 * _e2352) - (_e1373 * _e2351)) * _e1299.member_1.z));
let _e2502 = bitcast<f32>((bitcast<u32>((_e2453 * _e2439)) & 2147483647u));
let _e2505 = bitcast<f32>((bitcast<u32>(((((((_e2352 * _e1386) - (_e2353 * _e1385)) * _e1299.member_1.x) + (((_e2353 * _e1384) - (_e2351 * _e1386)) * _e1299.member_1.y)) + (((_e2351 * _e1385) - (_e2352 * _e1384)) * _e1299.member_1.z)) * _e2439)) & 2147483647u));
let _e2509 = bitcast<f32>((bitcast<u32>(((((((_e1373 * _e2335) - (_e1374 * _e2334)) * _e1299.member_1.x) + (((_e1374 * _e2333) - (_e1372 * _e2335)) * _e1299.member_1.y)) + (((_e1372 * _e2334) - (_e1373 * _e2333)) * _e1299.member_1.z)) * _e2439)) & 2147483647u));
let _e2512 = bitcast<f32>((bitcast<u32>((_e2498 * _e2439)) & 2147483647u));
if (((_e2502 + _e2505) < 1f) && ((_e2509 + _e2512) < 1f)) {
let _e2951 = ((((((_e2407 * _e1386) - (_e2408 * _e1385)) * _e1299.member_1.x) + (((_e2408 * _e1384) - (_e2406 * _e1386)) * _e1299.member_1.y)) + (((_e2406 * _e1385) - (_e2407 * _e1384)) * _e1299.member_1.z)) * _e2439);
let _e2966 = ((((((_e1373 * _e2408) - (_e1374 * _e2407)) * _e1299.member_1.x) + (((_e1374 * _e2406) - (_e1372 * _e2408)) * _e1299.member_1.y)) + (((_e1372 * _e2407) - (_e1373 * _e2406)) * _e1299.member_1.z)) * _e2439);
let _e2967 = (1e-4f * 1f);
let _e2969 = select(_e2505, _e2502, (_e2502 > _e2505));
let _e2971 = select(_e2967, _e2969, (_e2969 > _e2967));
let _e2973 = select(_e2505, _e2502, (_e2502 < _e2505));
let _e2975 = select(_e2967, _e2973, (_e2973 > _e2967));
let _e2977 = (0.5f * (_e2971 + _e2975));
let _e2978 = (0.5f / _e2975);
let _e2979 = (1f / _e2971);
let _e2980 = (1f / 1f);
let _e2981 = (0.5f * 1f);
let _e2982 = (_e2951 + _e2981);
let _e2983 = -(_e2982);
let _e2986 = (_e2977 - select(_e2983, _e2982, (_e2982 > _e2983)));
let _e2988 = select(0f, _e2986, (_e2986 > 0f));
let _e2990 = select(_e2975, _e2988, (_e2988 < _e2975));
let _e2993 = (_e2986 - _e2975);
let _e2997 = (((_e2990 * (_e2990 * _e2978)) + select(0f, _e2993, (_e2993 > 0f))) * _e2979);
let _e3001 = (_e2951 - _e2981);
let _e3002 = -(_e3001);
let _e3005 = (_e2977 - select(_e3002, _e3001, (_e3001 > _e3002)));
let _e3007 = select(0f, _e3005, (_e3005 > 0f));
let _e3009 = select(_e2975, _e3007, (_e3007 < _e2975));
let _e3012 = (_e3005 - _e2975);
let _e3016 = (((_e3009 * (_e3009 * _e2978)) + select(0f, _e3012, (_e3012 > 0f))) * _e2979);
let _e3023 = select(_e2512, _e2509, (_e2509 > _e2512));
let _e3025 = select(_e2967, _e3023, (_e3023 > _e2967));
let _e3027 = select(_e2512, _e2509, (_e2509 < _e2512));
let _e3029 = select(_e2967, _e3027, (_e3027 > _e2967));
let _e3031 = (0.5f * (_e3025 + _e3029));
let _e3032 = (0.5f / _e3029);
let _e3033 = (1f / _e3025);
let _e3034 = (_e2966 + _e2981);
let _e3035 = -(_e3034);
let _e3038 = (_e3031 - select(_e3035, _e3034, (_e3034 > _e3035)));
let _e3040 = select(0f, _e3038, (_e3038 > 0f));
let _e3042 = select(_e3029, _e3040, (_e3040 < _e3029));
let _e3045 = (_e3038 - _e3029);
let _e3049 = (((_e3042 * (_e3042 * _e3032)) + select(0f, _e3045, (_e3045 > 0f))) * _e3033);
let _e3053 = (_e2966 - _e2981);
let _e3054 = -(_e3053);
let _e3057 = (_e3031 - select(_e3054, _e3053, (_e3053 > _e3054)));
let _e3059 = select(0f, _e3057, (_e3057 > 0f));
let _e3061 = select(_e3029, _e3059, (_e3059 < _e3029));
let _e3064 = (_e3057 - _e3029);
let _e3068 = (((_e3061 * (_e3061 * _e3032)) + select(0f, _e3064, (_e3064 > 0f))) * _e3033);
phi_5357_ = ((((select(_e2997, (1f - _e2997), (_e2982 >= 0f)) - select(_e3016, (1f - _e3016), (_e3001 >= 0f))) * _e2980) * ((select(_e3049, (1f - _e3049), (_e3034 >= 0f)) - select(_e3068, (1f - _e3068), (_e3053 >= 0f))) * _e2980)) * bitcast<f32>((bitcast<u32>(_e2439) & 2147483647u)));
} else {
let _e2530 = (((((_e2334 * _e2353) - (_e2335 * _e2352)) * _e1299.member_1.x) + (((_e2335 * _e2351) - (_e2333 * _e2353)) * _e1299.member_1.y)) + (((_e2333 * _e2352) - (_e2334 * _e2351)) * _e1299.member_1.z));
let _e2531 = (1f / _e2530);
if (bitcast<f32>((bitcast<u32>(_e2530) & 2147483647u)) > ((0.5f * _e2416) * _e2424)) {
let _e2760 = ((((((_e2407 * _e2353) - (_e2408 * _e2352)) * _e1299.member_1.x) + (((_e2408 * _e2351) - (_e2406 * _e2353)) * _e1299.member_1.y)) + (((_e2406 * _e2352) - (_e2407 * _e2351)) * _e1299.member_1.z)) * _e2531);
let _e2775 = ((((((_e2334 * _e2408) - (_e2335 * _e2407)) * _e1299.member_1.x) + (((_e2335 * _e2406) - (_e2333 * _e2408)) * _e1299.member_1.y)) + (((_e2333 * _e2407) - (_e2334 * _e2406)) * _e1299.member_1.z)) * _e2531);
let _e2810 = bitcast<f32>((bitcast<u32>((_e2498 * _e2531)) & 2147483647u));
let _e2813 = bitcast<f32>((bitcast<u32>(((((((_e1385 * _e2353) - (_e1386 * _e2352)) * _e1299.member_1.x) + (((_e1386 * _e2351) - (_e1384 * _e2353)) * _e1299.member_1.y)) + (((_e1384 * _e2352) - (_e1385 * _e2351)) * _e1299.member_1.z)) * _e2531)) & 2147483647u));
let _e2815 = select(_e2813, _e2810, (_e2810 > _e2813));
let _e2817 = select(1e-3f, _e2815, (_e2815 > 1e-3f));
let _e2820 = bitcast<f32>((bitcast<u32>(((((((_e2334 * _e1374) - (_e2335 * _e1373)) * _e1299.member_1.x) + (((_e2335 * _e1372) - (_e2333 * _e1374)) * _e1299.member_1.y)) + (((_e2333 * _e1373) - (_e2334 * _e1372)) * _e1299.member_1.z)) * _e2531)) & 2147483647u));
let _e2823 = bitcast<f32>((bitcast<u32>((_e2453 * _e2531)) & 2147483647u));
let _e2825 = select(_e2823, _e2820, (_e2820 > _e2823));
let _e2827 = select(1e-3f, _e2825, (_e2825 > 1e-3f));
let _e2828 = (1e-4f * _e2817);
let _e2830 = select(_e2828, 1f, (1f > _e2828));
let _e2832 = select(_e2828, 0f, (0f > _e2828));
let _e2834 = (0.5f * (_e2830 + _e2832));
let _e2835 = (0.5f / _e2832);
let _e2836 = (1f / _e2830);
let _e2838 = (0.5f * _e2817);
let _e2839 = (_e2760 + _e2838);
let _e2840 = -(_e2839);
let _e2843 = (_e2834 - select(_e2840, _e2839, (_e2839 > _e2840)));
let _e2845 = select(0f, _e2843, (_e2843 > 0f));
let _e2847 = select(_e2832, _e2845, (_e2845 < _e2832));
let _e2850 = (_e2843 - _e2832);
let _e2854 = (((_e2847 * (_e2847 * _e2835)) + select(0f, _e2850, (_e2850 > 0f))) * _e2836);
let _e2858 = (_e2760 - _e2838);
let _e2859 = -(_e2858);
let _e2862 = (_e2834 - select(_e2859, _e2858, (_e2858 > _e2859)));
let _e2864 = select(0f, _e2862, (_e2862 > 0f));
let _e2866 = select(_e2832, _e2864, (_e2864 < _e2832));
let _e2869 = (_e2862 - _e2832);
let _e2873 = (((_e2866 * (_e2866 * _e2835)) + select(0f, _e2869, (_e2869 > 0f))) * _e2836);
let _e2879 = (1e-4f * _e2827);
let _e2881 = select(_e2879, 1f, (1f > _e2879));
let _e2883 = select(_e2879, 0f, (0f > _e2879));
let _e2885 = (0.5f * (_e2881 + _e2883));
let _e2886 = (0.5f / _e2883);
let _e2887 = (1f / _e2881);
let _e2889 = (0.5f * _e2827);
let _e2890 = (_e2775 + _e2889);
let _e2891 = -(_e2890);
let _e2894 = (_e2885 - select(_e2891, _e2890, (_e2890 > _e2891)));
let _e2896 = select(0f, _e2894, (_e2894 > 0f));
let _e2898 = select(_e2883, _e2896, (_e2896 < _e2883));
let _e2901 = (_e2894 - _e2883);
let _e2905 = (((_e2898 * (_e2898 * _e2886)) + select(0f, _e2901, (_e2901 > 0f))) * _e2887);
let _e2909 = (_e2775 - _e2889);
let _e2910 = -(_e2909);
let _e2913 = (_e2885 - select(_e2910, _e2909, (_e2909 > _e2910)));
let _e2915 = select(0f, _e2913, (_e2913 > 0f));
let _e2917 = select(_e2883, _e2915, (_e2915 < _e2883));
let _e2920 = (_e2913 - _e2883);
let _e2924 = (((_e2917 * (_e2917 * _e2886)) + select(0f, _e2920, (_e2920 > 0f))) * _e2887);
phi_5356_ = ((((select(_e2854, (1f - _e2854), (_e2839 >= 0f)) - select(_e2873, (1f - _e2873), (_e2858 >= 0f))) * (1f / _e2817)) * ((select(_e2905, (1f - _e2905), (_e2890 >= 0f)) - select(_e2924, (1f - _e2924), (_e2909 >= 0f))) * (1f / _e2827))) * bitcast<f32>((bitcast<u32>(_e2531) & 2147483647u)));
} else {
let _e2538 = (_e2416 >= _e2424);
let _e2539 = select(_e2351, _e2333, _e2538);
let _e2540 = select(_e2352, _e2334, _e2538);
let _e2541 = select(_e2353, _e2335, _e2538);
let _e2542 = select(_e2333, _e2351, _e2538);
let _e2543 = select(_e2334, _e2352, _e2538);
let _e2544 = select(_e2335, _e2353, _e2538);
let _e2549 = (((_e2539 * _e2539) + (_e2540 * _e2540)) + (_e2541 * _e2541));
let _e2552 = sqrt(select(0f, _e2549, (_e2549 > 0f)));
let _e2555 = (1f / select(1e-30f, _e2552, (_e2552 > 1e-30f)));
let _e2556 = (_e2539 * _e2555);
let _e2557 = (_e2540 * _e2555);
let _e2558 = (_e2541 * _e2555);
let _e2561 = ((_e1299.member_1.y * _e2558) - (_e1299.member_1.z * _e2557));
let _e2564 = ((_e1299.member_1.z * _e2556) - (_e1299.member_1.x * _e2558));
let _e2567 = ((_e1299.member_1.x * _e2557) - (_e1299.member_1.y * _e2556));
let _e2575 = bitcast<f32>((bitcast<u32>((((_e1372 * _e2556) + (_e1373 * _e2557)) + (_e1374 * _e2558))) & 2147483647u));
let _e2583 = bitcast<f32>((bitcast<u32>((((_e1384 * _e2556) + (_e1385 * _e2557)) + (_e1386 * _e2558))) & 2147483647u));
let _e2585 = select(_e2583, _e2575, (_e2575 > _e2583));
let _e2586 = (1e-3f * _e2552);
let _e2588 = select(_e2586, _e2585, (_e2585 > _e2586));
let _e2596 = bitcast<f32>((bitcast<u32>((((_e1372 * _e2561) + (_e1373 * _e2564)) + (_e1374 * _e2567))) & 2147483647u));
let _e2604 = bitcast<f32>((bitcast<u32>((((_e1384 * _e2561) + (_e1385 * _e2564)) + (_e1386 * _e2567))) & 2147483647u));
let _e2606 = select(_e2604, _e2596, (_e2596 > _e2604));
let _e2608 = select(_e2586, _e2606, (_e2606 > _e2586));
let _e2613 = (((_e2406 * _e2556) + (_e2407 * _e2557)) + (_e2408 * _e2558));
let _e2621 = bitcast<f32>((bitcast<u32>((((_e2542 * _e2556) + (_e2543 * _e2557)) + (_e2544 * _e2558))) & 2147483647u));
let _e2622 = (1e-4f * _e2588);
let _e2624 = select(_e2621, _e2552, (_e2552 > _e2621));
let _e2626 = select(_e2622, _e2624, (_e2624 > _e2622));
let _e2628 = select(_e2621, _e2552, (_e2552 < _e2621));
let _e2630 = select(_e2622, _e2628, (_e2628 > _e2622));
let _e2632 = (0.5f * (_e2626 + _e2630));
let _e2633 = (0.5f / _e2630);
let _e2634 = (1f / _e2626);
let _e2636 = (0.5f * _e2588);
let _e2637 = (_e2613 + _e2636);
let _e2638 = -(_e2637);
let _e2641 = (_e2632 - select(_e2638, _e2637, (_e2637 > _e2638)));
let _e2643 = select(0f, _e2641, (_e2641 > 0f));
let _e2645 = select(_e2630, _e2643, (_e2643 < _e2630));
let _e2648 = (_e2641 - _e2630);
let _e2652 = (((_e2645 * (_e2645 * _e2633)) + select(0f, _e2648, (_e2648 > 0f))) * _e2634);
let _e2656 = (_e2613 - _e2636);
let _e2657 = -(_e2656);
let _e2660 = (_e2632 - select(_e2657, _e2656, (_e2656 > _e2657)));
let _e2662 = select(0f, _e2660, (_e2660 > 0f));
let _e2664 = select(_e2630, _e2662, (_e2662 < _e2630));
let _e2667 = (_e2660 - _e2630);
let _e2671 = (((_e2664 * (_e2664 * _e2633)) + select(0f, _e2667, (_e2667 > 0f))) * _e2634);
let _e2681 = (((_e2406 * _e2561) + (_e2407 * _e2564)) + (_e2408 * _e2567));
let _e2689 = bitcast<f32>((bitcast<u32>((((_e2542 * _e2561) + (_e2543 * _e2564)) + (_e2544 * _e2567))) & 2147483647u));
let _e2690 = (1e-4f * _e2608);
let _e2692 = select(0f, _e2689, (_e2689 > 0f));
let _e2694 = select(_e2690, _e2692, (_e2692 > _e2690));
let _e2696 = select(0f, _e2689, (_e2689 < 0f));
let _e2698 = select(_e2690, _e2696, (_e2696 > _e2690));
let _e2700 = (0.5f * (_e2694 + _e2698));
let _e2701 = (0.5f / _e2698);
let _e2702 = (1f / _e2694);
let _e2704 = (0.5f * _e2608);
let _e2705 = (_e2681 + _e2704);
let _e2706 = -(_e2705);
let _e2709 = (_e2700 - select(_e2706, _e2705, (_e2705 > _e2706)));
let _e2711 = select(0f, _e2709, (_e2709 > 0f));
let _e2713 = select(_e2698, _e2711, (_e2711 < _e2698));
let _e2716 = (_e2709 - _e2698);
let _e2720 = (((_e2713 * (_e2713 * _e2701)) + select(0f, _e2716, (_e2716 > 0f))) * _e2702);
let _e2724 = (_e2681 - _e2704);
let _e2725 = -(_e2724);
let _e2728 = (_e2700 - select(_e2725, _e2724, (_e2724 > _e2725)));
let _e2730 = select(0f, _e2728, (_e2728 > 0f));
let _e2732 = select(_e2698, _e2730, (_e2730 < _e2698));
let _e2735 = (_e2728 - _e2698);
let _e2739 = (((_e2732 * (_e2732 * _e2701)) + select(0f, _e2735, (_e2735 > 0f))) * _e2702);
phi_5356_ = (((select(_e2652, (1f - _e2652), (_e2637 >= 0f)) - select(_e2671, (1f - _e2671), (_e2656 >= 0f))) * (1f / _e2588)) * ((select(_e2720, (1f - _e2720), (_e2705 >= 0f)) - select(_e2739, (1f - _e2739), (_e2724 >= 0f))) * (1f / _e2608)));
}
let _e2936 = phi_5356_;
phi_5357_ = _e2936;
}
let _e3080 = phi_5357_;
let _e3081 = (_e3080 <= 0f);
if _e3081 {
phi_6426_ = vec3<f32>();
} else {
let _e3084 = (select(_e2285, _e2317, (_e2317 < _e2285)) - 0f);
let _e3088 = global_1.member.member_13.member_6;
if (_e3088 == 0u) {
phi_6093_ = _e3084;
} else {
let _e3091 = (_e3084 / f32(_e3088));
phi_5380_ = 0u;
phi_5383_ = 0f;
loop {
let _e3093 = phi_5380_;
let _e3095 = phi_5383_;
local_40 = _e3095;
let _e3098 = ((_e3093 < _e3088) && (_e3084 > 0f));
if _e3098 {
let _e3101 = (0f + (_e3091 * f32(_e3093)));
let _e3102 = (_e3101 + _e3091);
let _e3104 = (0.5f * (_e3101 + _e3102));
let _e3105 = (_e3102 - _e3101);
let _e3106 = (0.28867513f * _e3105);
let _e3107 = (_e3104 - _e3106);
let _e3117 = global_1.member.member_13.member_7;
let _e3118 = bitcast<i32>(_e3117);
let _e3122 = global_1.member.member_13.member_8;
let _e3123 = bitcast<i32>(_e3122);
let _e3127 = global_1.member.member_13.member_9;
let _e3128 = bitcast<i32>(_e3127);
let _e3132 = global_1.member.member_13.member_4;
let _e3139 = global_1.member.member_13.member_5;
let _e3143 = f32(_e3118);
let _e3145 = (_e3139.member - _e3132.member);
let _e3148 = (((((_e2013 + (_e2051 * _e3107)) - _e3132.member) / _e3145) * _e3143) - 0.5f);
let _e3149 = (_e3143 - 1f);
let _e3151 = select(0f, _e3148, (_e3148 > 0f));
let _e3153 = select(_e3149, _e3151, (_e3151 < _e3149));
let _e3154 = f32(_e3123);
let _e3156 = (_e3139.member_1 - _e3132.member_1);
let _e3159 = (((((_e2025 + (_e2064 * _e3107)) - _e3132.member_1) / _e3156) * _e3154) - 0.5f);
let _e3160 = (_e3154 - 1f);
let _e3162 = select(0f, _e3159, (_e3159 > 0f));
let _e3164 = select(_e3160, _e3162, (_e3162 < _e3160));
let _e3165 = f32(_e3128);
let _e3167 = (_e3139.member_2 - _e3132.member_2);
let _e3170 = (((((_e2038 + (_e2077 * _e3107)) - _e3132.member_2) / _e3167) * _e3165) - 0.5f);
let _e3171 = (_e3165 - 1f);
let _e3173 = select(0f, _e3170, (_e3170 > 0f));
let _e3175 = select(_e3171, _e3173, (_e3173 < _e3171));
let _e3177 = select(0f, _e3153, (_e3153 > 0f));
let _e3179 = select(1e6f, _e3177, (_e3177 < 1e6f));
let _e3186 = select(0i, select(select(i32(_e3179), i32(-2147483648), (_e3179 < -2147483600f)), 2147483647i, (_e3179 > 2147483500f)), (_e3179 == _e3179));
let _e3190 = (_e3186 - select(0i, 1i, (_e3179 < f32(_e3186))));
let _e3192 = select(0f, _e3164, (_e3164 > 0f));
let _e3194 = select(1e6f, _e3192, (_e3192 < 1e6f));
let _e3201 = select(0i, select(select(i32(_e3194), i32(-2147483648), (_e3194 < -2147483600f)), 2147483647i, (_e3194 > 2147483500f)), (_e3194 == _e3194));
let _e3205 = (_e3201 - select(0i, 1i, (_e3194 < f32(_e3201))));
let _e3207 = select(0f, _e3175, (_e3175 > 0f));
let _e3209 = select(1e6f, _e3207, (_e3207 < 1e6f));
let _e3216 = select(0i, select(select(i32(_e3209), i32(-2147483648), (_e3209 < -2147483600f)), 2147483647i, (_e3209 > 2147483500f)), (_e3209 == _e3209));
let _e3220 = (_e3216 - select(0i, 1i, (_e3209 < f32(_e3216))));
let _e3224 = (_e3164 - f32(_e3205));
let _e3226 = (_e3175 - f32(_e3220));
local_6 = (_e3153 - f32(_e3190));
let _e3227 = (_e3190 + 1i);
let _e3229 = select(_e3227, 0i, (_e3227 < 0i));
if (_e3229 >= _e3118) {
phi_5518_ = (_e3118 - 1i);
} else {
phi_5518_ = _e3229;
}
let _e3233 = phi_5518_;
local_7 = (_e3233 - _e3190);
let _e3235 = (_e3205 + 1i);
let _e3237 = select(_e3235, 0i, (_e3235 < 0i));
if (_e3237 >= _e3123) {
phi_5531_ = (_e3123 - 1i);
} else {
phi_5531_ = _e3237;
}
let _e3241 = phi_5531_;
let _e3243 = ((_e3241 - _e3205) * _e3118);
let _e3244 = (_e3220 + 1i);
let _e3246 = select(_e3244, 0i, (_e3244 < 0i));
if (_e3246 >= _e3128) {
phi_5545_ = (_e3128 - 1i);
} else {
phi_5545_ = _e3246;
}
let _e3250 = phi_5545_;
let _e3257 = global_1.member.member_13.member_10;
let _e3258 = bitcast<i32>(_e3257);
let _e3263 = ((_e3258 + (((_e3220 * _e3123) + _e3205) * _e3118)) + _e3190);
let _e3265 = select(_e1322, _e3263, (_e3263 < _e1322));
let _e3270 = global_8.member[bitcast<u32>(select(0i, _e3265, (_e3265 > 0i)))];
let _e3271 = local_6;
let _e3274 = local_7;
let _e3275 = (_e3263 + _e3274);
let _e3277 = select(_e1322, _e3275, (_e3275 < _e1322));
let _e3282 = global_8.member[bitcast<u32>(select(0i, _e3277, (_e3277 > 0i)))];
let _e3283 = local_6;
let _e3286 = (1f - _e3224);
let _e3288 = (_e3263 + _e3243);
let _e3290 = select(_e1322, _e3288, (_e3288 < _e1322));
let _e3295 = global_8.member[bitcast<u32>(select(0i, _e3290, (_e3290 > 0i)))];
let _e3296 = local_6;
let _e3299 = local_7;
let _e3300 = (_e3288 + _e3299);
let _e3302 = select(_e1322, _e3300, (_e3300 < _e1322));
let _e3307 = global_8.member[bitcast<u32>(select(0i, _e3302, (_e3302 > 0i)))];
let _e3308 = local_6;
let _e3313 = (_e3263 + (((_e3250 - _e3220) * _e3118) * _e3123));
let _e3315 = select(_e1322, _e3313, (_e3313 < _e1322));
let _e3320 = global_8.member[bitcast<u32>(select(0i, _e3315, (_e3315 > 0i)))];
let _e3321 = local_6;
let _e3324 = local_7;
let _e3325 = (_e3313 + _e3324);
let _e3327 = select(_e1322, _e3325, (_e3325 < _e1322));
let _e3332 = global_8.member[bitcast<u32>(select(0i, _e3327, (_e3327 > 0i)))];
let _e3333 = local_6;
let _e3337 = (_e3313 + _e3243);
let _e3339 = select(_e1322, _e3337, (_e3337 < _e1322));
let _e3344 = global_8.member[bitcast<u32>(select(0i, _e3339, (_e3339 > 0i)))];
let _e3345 = local_6;
let _e3348 = local_7;
let _e3349 = (_e3337 + _e3348);
let _e3351 = select(_e1322, _e3349, (_e3349 < _e1322));
let _e3356 = global_8.member[bitcast<u32>(select(0i, _e3351, (_e3351 > 0i)))];
let _e3357 = local_6;
let _e3366 = (_e3104 + _e3106);
let _e3376 = (((((_e2013 + (_e2051 * _e3366)) - _e3132.member) / _e3145) * _e3143) - 0.5f);
let _e3378 = select(0f, _e3376, (_e3376 > 0f));
let _e3380 = select(_e3149, _e3378, (_e3378 < _e3149));
let _e3384 = (((((_e2025 + (_e2064 * _e3366)) - _e3132.member_1) / _e3156) * _e3154) - 0.5f);
let _e3386 = select(0f, _e3384, (_e3384 > 0f));
let _e3388 = select(_e3160, _e3386, (_e3386 < _e3160));
let _e3392 = (((((_e2038 + (_e2077 * _e3366)) - _e3132.member_2) / _e3167) * _e3165) - 0.5f);
let _e3394 = select(0f, _e3392, (_e3392 > 0f));
let _e3396 = select(_e3171, _e3394, (_e3394 < _e3171));
let _e3398 = select(0f, _e3380, (_e3380 > 0f));
let _e3400 = select(1e6f, _e3398, (_e3398 < 1e6f));
let _e3407 = select(0i, select(select(i32(_e3400), i32(-2147483648), (_e3400 < -2147483600f)), 2147483647i, (_e3400 > 2147483500f)), (_e3400 == _e3400));
let _e3411 = (_e3407 - select(0i, 1i, (_e3400 < f32(_e3407))));
let _e3413 = select(0f, _e3388, (_e3388 > 0f));
let _e3415 = select(1e6f, _e3413, (_e3413 < 1e6f));
let _e3422 = select(0i, select(select(i32(_e3415), i32(-2147483648), (_e3415 < -2147483600f)), 2147483647i, (_e3415 > 2147483500f)), (_e3415 == _e3415));
let _e3426 = (_e3422 - select(0i, 1i, (_e3415 < f32(_e3422))));
let _e3428 = select(0f, _e3396, (_e3396 > 0f));
let _e3430 = select(1e6f, _e3428, (_e3428 < 1e6f));
let _e3437 = select(0i, select(select(i32(_e3430), i32(-2147483648), (_e3430 < -2147483600f)), 2147483647i, (_e3430 > 2147483500f)), (_e3430 == _e3430));
let _e3441 = (_e3437 - select(0i, 1i, (_e3430 < f32(_e3437))));
let _e3445 = (_e3388 - f32(_e3426));
let _e3447 = (_e3396 - f32(_e3441));
local_4 = (_e3380 - f32(_e3411));
let _e3448 = (_e3411 + 1i);
let _e3450 = select(_e3448, 0i, (_e3448 < 0i));
if (_e3450 >= _e3118) {
phi_5861_ = (_e3118 - 1i);
} else {
phi_5861_ = _e3450;
}
let _e3454 = phi_5861_;
local_5 = (_e3454 - _e3411);
let _e3456 = (_e3426 + 1i);
let _e3458 = select(_e3456, 0i, (_e3456 < 0i));
if (_e3458 >= _e3123) {
phi_5874_ = (_e3123 - 1i);
} else {
phi_5874_ = _e3458;
}
let _e3462 = phi_5874_;
let _e3464 = ((_e3462 - _e3426) * _e3118);
let _e3465 = (_e3441 + 1i);
let _e3467 = select(_e3465, 0i, (_e3465 < 0i));
if (_e3467 >= _e3128) {
phi_5888_ = (_e3128 - 1i);
} else {
phi_5888_ = _e3467;
}
let _e3471 = phi_5888_;
let _e3479 = ((_e3258 + (((_e3441 * _e3123) + _e3426) * _e3118)) + _e3411);
let _e3481 = select(_e1322, _e3479, (_e3479 < _e1322));
let _e3486 = global_8.member[bitcast<u32>(select(0i, _e3481, (_e3481 > 0i)))];
let _e3487 = local_4;
let _e3490 = local_5;
let _e3491 = (_e3479 + _e3490);
let _e3493 = select(_e1322, _e3491, (_e3491 < _e1322));
let _e3498 = global_8.member[bitcast<u32>(select(0i, _e3493, (_e3493 > 0i)))];
let _e3499 = local_4;
let _e3502 = (1f - _e3445);
let _e3504 = (_e3479 + _e3464);
let _e3506 = select(_e1322, _e3504, (_e3504 < _e1322));
let _e3511 = global_8.member[bitcast<u32>(select(0i, _e3506, (_e3506 > 0i)))];
let _e3512 = local_4;
let _e3515 = local_5;
let _e3516 = (_e3504 + _e3515);
let _e3518 = select(_e1322, _e3516, (_e3516 < _e1322));
let _e3523 = global_8.member[bitcast<u32>(select(0i, _e3518, (_e3518 > 0i)))];
let _e3524 = local_4;
let _e3529 = (_e3479 + (((_e3471 - _e3441) * _e3118) * _e3123));
let _e3531 = select(_e1322, _e3529, (_e3529 < _e1322));
let _e3536 = global_8.member[bitcast<u32>(select(0i, _e3531, (_e3531 > 0i)))];
let _e3537 = local_4;
let _e3540 = local_5;
let _e3541 = (_e3529 + _e3540);
let _e3543 = select(_e1322, _e3541, (_e3541 < _e1322));
let _e3548 = global_8.member[bitcast<u32>(select(0i, _e3543, (_e3543 > 0i)))];
let _e3549 = local_4;
let _e3553 = (_e3529 + _e3464);
let _e3555 = select(_e1322, _e3553, (_e3553 < _e1322));
let _e3560 = global_8.member[bitcast<u32>(select(0i, _e3555, (_e3555 > 0i)))];
let _e3561 = local_4;
let _e3564 = local_5;
let _e3565 = (_e3553 + _e3564);
let _e3567 = select(_e1322, _e3565, (_e3565 < _e1322));
let _e3572 = global_8.member[bitcast<u32>(select(0i, _e3567, (_e3567 > 0i)))];
let _e3573 = local_4;
phi_5381_ = (_e3093 + 1u);
phi_5384_ = (_e3095 + ((0.5f * (((((((_e3270 * (1f - _e3271)) + (_e3282 * _e3283)) * _e3286) + (((_e3295 * (1f - _e3296)) + (_e3307 * _e3308)) * _e3224)) * (1f - _e3226)) + (((((_e3320 * (1f - _e3321)) + (_e3332 * _e3333)) * _e3286) + (((_e3344 * (1f - _e3345)) + (_e3356 * _e3357)) * _e3224)) * _e3226)) + ((((((_e3486 * (1f - _e3487)) + (_e3498 * _e3499)) * _e3502) + (((_e3511 * (1f - _e3512)) + (_e3523 * _e3524)) * _e3445)) * (1f - _e3447)) + (((((_e3536 * (1f - _e3537)) + (_e3548 * _e3549)) * _e3502) + (((_e3560 * (1f - _e3561)) + (_e3572 * _e3573)) * _e3445)) * _e3447)))) * _e3105));
} else {
phi_5381_ = u32();
phi_5384_ = f32();
}
let _e3588 = phi_5381_;
let _e3590 = phi_5384_;
continue;
continuing {
phi_5380_ = _e3588;
phi_5383_ = _e3590;
break if !(_e3098);
}
}
let _e4760 = local_40;
phi_6093_ = _e4760;
}
let _e3593 = phi_6093_;
let _e3606 = (0.25f * bitcast<f32>((bitcast<u32>((((_e1299.member_2.x * _e2051) + (_e1299.member_2.y * _e2064)) + (_e1299.member_2.z * _e2077))) & 2147483647u)));
let _e3613 = (((_e1299.member_1.x * _e501) + (_e1299.member_1.y * _e512)) + (_e1299.member_1.z * _e523));
let _e3615 = select(1f, -1f, (_e3613 > 0f));
let _e3623 = select(_e3615, -(_e3615), ((((_e1299.member_2.x * _e1299.member_1.x) + (_e1299.member_2.y * _e1299.member_1.y)) + (_e1299.member_2.z * _e1299.member_1.z)) < 0f));
let _e3624 = (_e1299.member_2.x * _e3623);
let _e3625 = (_e1299.member_2.y * _e3623);
let _e3626 = (_e1299.member_2.z * _e3623);
let _e3635 = ((((_e3624 * _e501) + (_e3625 * _e512)) + (_e3626 * _e523)) > 0f);
let _e3644 = -((((select(_e3624, (_e1299.member_1.x * _e3615), _e3635) * _e2051) + (select(_e3625, (_e1299.member_1.y * _e3615), _e3635) * _e2064)) + (select(_e3626, (_e1299.member_1.z * _e3615), _e3635) * _e2077)));
let _e3649 = -(_e3644);
let _e3659 = global_1.member.member_13.member;
let _e3664 = -((_e3659.member * _e3593));
let _e3666 = select(-87f, _e3664, (_e3664 > -87f));
let _e3668 = select(88f, _e3666, (_e3666 < 88f));
let _e3670 = ((_e3668 * 1.442695f) + 0.5f);
let _e3672 = select(-127f, _e3670, (_e3670 > -127f));
let _e3674 = select(128f, _e3672, (_e3672 < 128f));
let _e3681 = select(0i, select(select(i32(_e3674), i32(-2147483648), (_e3674 < -2147483600f)), 2147483647i, (_e3674 > 2147483500f)), (_e3674 == _e3674));
let _e3685 = (_e3681 - select(0i, 1i, (_e3674 < f32(_e3681))));
let _e3686 = f32(_e3685);
let _e3690 = ((_e3668 - (_e3686 * 0.6933594f)) - (_e3686 * -2.1219444e-4f));
let _e3712 = -((_e3659.member_1 * _e3593));
let _e3714 = select(-87f, _e3712, (_e3712 > -87f));
let _e3716 = select(88f, _e3714, (_e3714 < 88f));
let _e3718 = ((_e3716 * 1.442695f) + 0.5f);
let _e3720 = select(-127f, _e3718, (_e3718 > -127f));
let _e3722 = select(128f, _e3720, (_e3720 < 128f));
let _e3729 = select(0i, select(select(i32(_e3722), i32(-2147483648), (_e3722 < -2147483600f)), 2147483647i, (_e3722 > 2147483500f)), (_e3722 == _e3722));
let _e3733 = (_e3729 - select(0i, 1i, (_e3722 < f32(_e3729))));
let _e3734 = f32(_e3733);
let _e3738 = ((_e3716 - (_e3734 * 0.6933594f)) - (_e3734 * -2.1219444e-4f));
let _e3760 = -((_e3659.member_2 * _e3593));
let _e3762 = select(-87f, _e3760, (_e3760 > -87f));
let _e3764 = select(88f, _e3762, (_e3762 < 88f));
let _e3766 = ((_e3764 * 1.442695f) + 0.5f);
let _e3768 = select(-127f, _e3766, (_e3766 > -127f));
let _e3770 = select(128f, _e3768, (_e3768 < 128f));
let _e3777 = select(0i, select(select(i32(_e3770), i32(-2147483648), (_e3770 < -2147483600f)), 2147483647i, (_e3770 > 2147483500f)), (_e3770 == _e3770));
let _e3781 = (_e3777 - select(0i, 1i, (_e3770 < f32(_e3777))));
let _e3782 = f32(_e3781);
let _e3786 = ((_e3764 - (_e3782 * 0.6933594f)) - (_e3782 * -2.1219444e-4f));
let _e3812 = ((_e3080 * (select((select(0f, _e3649, (_e3649 > 0f)) * _e1299.member_4), select(0f, _e3644, (_e3644 > 0f)), ((_e2303 * _e3613) > 0f)) / select(_e3606, _e2306, (_e2306 > _e3606)))) * (1f / 3.1415927f));
phi_6426_ = vec3<f32>(((_e2246 * ((1f + (_e3690 * (1f + (_e3690 * (0.5f + (_e3690 * (0.16666667f + (_e3690 * (0.041666668f + (_e3690 * (0.008333334f + (_e3690 * (0.001388889f + (_e3690 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3685 + 127i)) << bitcast<u32>(23i))))) * _e3812), ((_e2259 * ((1f + (_e3738 * (1f + (_e3738 * (0.5f + (_e3738 * (0.16666667f + (_e3738 * (0.041666668f + (_e3738 * (0.008333334f + (_e3738 * (0.001388889f + (_e3738 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3733 + 127i)) << bitcast<u32>(23i))))) * _e3812), ((_e2272 * ((1f + (_e3786 * (1f + (_e3786 * (0.5f + (_e3786 * (0.16666667f + (_e3786 * (0.041666668f + (_e3786 * (0.008333334f + (_e3786 * (0.001388889f + (_e3786 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3781 + 127i)) << bitcast<u32>(23i))))) * _e3812));
}
let _e3818 = phi_6426_;
phi_6427_ = _e3818;
phi_6428_ = _e3081;
}
let _e3820 = phi_6427_;
let _e3822 = phi_6428_;
phi_6432_ = _e3820;
phi_6433_ = _e3822;
}
let _e3824 = phi_6432_;
let _e3826 = phi_6433_;
phi_6449_ = (_e1935 + select(_e3824, vec3<f32>(0f, 0f, 0f), vec3(_e3826)));
}
let _e3831 = phi_6449_;
phi_3400_ = _e3831;
phi_3403_ = (_e1937 + 1u);
}
let _e3834 = phi_3400_;
let _e3836 = phi_3403_;
continue;
continuing {
phi_3399_ = _e3834;
phi_3402_ = _e3836;
break if !(select(true, false, _e1941));
}
}
let _e3839 = local_20.member_1;
phi_6459_ = type_13(_e1578.member, (_e1578.member_1 + 1u));
loop {
let _e3843 = phi_6459_;
local_42 = _e3843;
let _e3849 = (((_e3843.member_1 & 3u) == 0u) && (_e3843.member < _e3839));
if _e3849 {
phi_6460_ = type_13((_e3843.member + 1u), (_e3843.member_1 >> bitcast<u32>(2i)));
} else {
phi_6460_ = type_13();
}
let _e3855 = phi_6460_;
continue;
continuing {
phi_6459_ = _e3855;
break if !(_e3849);
}
}
let _e4773 = local_41;
phi_6481_ = _e4773;
let _e4776 = local_42;
phi_6482_ = _e4776;
}
let _e3862 = phi_6481_;
let _e3864 = phi_6482_;
phi_2833_ = _e3862;
phi_2836_ = _e3864;
} else {
phi_2833_ = vec3<f32>();
phi_2836_ = type_13();
}
let _e3866 = phi_2833_;
let _e3868 = phi_2836_;
continue;
continuing {
phi_2832_ = _e3866;
phi_2835_ = _e3868;
break if !(_e1586);
}
}
let _e3871 = local_36;
let _e3874 = local_37;
let _e3878 = local_38;
let _e3881 = (((_e3871.x + _e3874.y) + _e3878.z) <= 0f);
if _e3881 {
phi_7591_ = array<f32, 22>();
} else {
let _e3889 = (1f / select(_e501, select(1e-12f, -1e-12f, (_e501 < 0f)), (bitcast<f32>((bitcast<u32>(_e501) & 2147483647u)) < 1e-12f)));
let _e3897 = (1f / select(_e512, select(1e-12f, -1e-12f, (_e512 < 0f)), (bitcast<f32>((bitcast<u32>(_e512) & 2147483647u)) < 1e-12f)));
let _e3905 = (1f / select(_e523, select(1e-12f, -1e-12f, (_e523 < 0f)), (bitcast<f32>((bitcast<u32>(_e523) & 2147483647u)) < 1e-12f)));
let _e3909 = global_1.member.member_13.member_4;
let _e3916 = global_1.member.member_13.member_5;
let _e3921 = ((_e3909.member - _e818) * _e3889);
let _e3923 = ((_e3916.member - _e818) * _e3889);
let _e3925 = ((_e3909.member_1 - _e819) * _e3897);
let _e3927 = ((_e3916.member_1 - _e819) * _e3897);
let _e3929 = ((_e3909.member_2 - _e820) * _e3905);
let _e3931 = ((_e3916.member_2 - _e820) * _e3905);
let _e3933 = select(_e3923, _e3921, (_e3921 < _e3923));
let _e3935 = select(_e3927, _e3925, (_e3925 < _e3927));
let _e3937 = select(_e3935, _e3933, (_e3933 > _e3935));
let _e3939 = select(_e3931, _e3929, (_e3929 < _e3931));
let _e3941 = select(_e3939, _e3937, (_e3937 > _e3939));
let _e3943 = select(_e3923, _e3921, (_e3921 > _e3923));
let _e3945 = select(_e3927, _e3925, (_e3925 > _e3927));
let _e3947 = select(_e3945, _e3943, (_e3943 < _e3945));
let _e3949 = select(_e3931, _e3929, (_e3929 > _e3931));
let _e3951 = select(_e3949, _e3947, (_e3947 < _e3949));
let _e3953 = select(0f, _e3941, (_e3941 > 0f));
let _e3955 = select(_e821, _e3951, (_e3951 < _e821));
let _e3956 = (_e3955 > _e3953);
let _e3957 = select(0f, _e3953, _e3956);
let _e3959 = (select(0f, _e3955, _e3956) - _e3957);
let _e3963 = global_1.member.member_13.member_6;
if (_e3963 == 0u) {
phi_7352_ = _e3959;
} else {
let _e3966 = (_e3959 / f32(_e3963));
phi_6639_ = 0u;
phi_6642_ = 0f;
loop {
let _e3968 = phi_6639_;
let _e3970 = phi_6642_;
local_43 = _e3970;
let _e3973 = ((_e3968 < _e3963) && (_e3959 > 0f));
if _e3973 {
let _e3976 = (_e3957 + (_e3966 * f32(_e3968)));
let _e3977 = (_e3976 + _e3966);
let _e3979 = (0.5f * (_e3976 + _e3977));
let _e3980 = (_e3977 - _e3976);
let _e3981 = (0.28867513f * _e3980);
let _e3982 = (_e3979 - _e3981);
let _e3992 = global_1.member.member_13.member_7;
let _e3993 = bitcast<i32>(_e3992);
let _e3997 = global_1.member.member_13.member_8;
let _e3998 = bitcast<i32>(_e3997);
let _e4002 = global_1.member.member_13.member_9;
let _e4003 = bitcast<i32>(_e4002);
let _e4004 = f32(_e3993);
let _e4006 = (_e3916.member - _e3909.member);
let _e4009 = (((((_e818 + (_e501 * _e3982)) - _e3909.member) / _e4006) * _e4004) - 0.5f);
let _e4010 = (_e4004 - 1f);
let _e4012 = select(0f, _e4009, (_e4009 > 0f));
let _e4014 = select(_e4010, _e4012, (_e4012 < _e4010));
let _e4015 = f32(_e3998);
let _e4017 = (_e3916.member_1 - _e3909.member_1);
let _e4020 = (((((_e819 + (_e512 * _e3982)) - _e3909.member_1) / _e4017) * _e4015) - 0.5f);
let _e4021 = (_e4015 - 1f);
let _e4023 = select(0f, _e4020, (_e4020 > 0f));
let _e4025 = select(_e4021, _e4023, (_e4023 < _e4021));
let _e4026 = f32(_e4003);
let _e4028 = (_e3916.member_2 - _e3909.member_2);
let _e4031 = (((((_e820 + (_e523 * _e3982)) - _e3909.member_2) / _e4028) * _e4026) - 0.5f);
let _e4032 = (_e4026 - 1f);
let _e4034 = select(0f, _e4031, (_e4031 > 0f));
let _e4036 = select(_e4032, _e4034, (_e4034 < _e4032));
let _e4038 = select(0f, _e4014, (_e4014 > 0f));
let _e4040 = select(1e6f, _e4038, (_e4038 < 1e6f));
let _e4047 = select(0i, select(select(i32(_e4040), i32(-2147483648), (_e4040 < -2147483600f)), 2147483647i, (_e4040 > 2147483500f)), (_e4040 == _e4040));
let _e4051 = (_e4047 - select(0i, 1i, (_e4040 < f32(_e4047))));
let _e4053 = select(0f, _e4025, (_e4025 > 0f));
let _e4055 = select(1e6f, _e4053, (_e4053 < 1e6f));
let _e4062 = select(0i, select(select(i32(_e4055), i32(-2147483648), (_e4055 < -2147483600f)), 2147483647i, (_e4055 > 2147483500f)), (_e4055 == _e4055));
let _e4066 = (_e4062 - select(0i, 1i, (_e4055 < f32(_e4062))));
let _e4068 = select(0f, _e4036, (_e4036 > 0f));
let _e4070 = select(1e6f, _e4068, (_e4068 < 1e6f));
let _e4077 = select(0i, select(select(i32(_e4070), i32(-2147483648), (_e4070 < -2147483600f)), 2147483647i, (_e4070 > 2147483500f)), (_e4070 == _e4070));
let _e4081 = (_e4077 - select(0i, 1i, (_e4070 < f32(_e4077))));
let _e4085 = (_e4025 - f32(_e4066));
let _e4087 = (_e4036 - f32(_e4081));
local_2 = (_e4014 - f32(_e4051));
let _e4088 = (_e4051 + 1i);
let _e4090 = select(_e4088, 0i, (_e4088 < 0i));
if (_e4090 >= _e3993) {
phi_6777_ = (_e3993 - 1i);
} else {
phi_6777_ = _e4090;
}
let _e4094 = phi_6777_;
local_3 = (_e4094 - _e4051);
let _e4096 = (_e4066 + 1i);
let _e4098 = select(_e4096, 0i, (_e4096 < 0i));
if (_e4098 >= _e3998) {
phi_6790_ = (_e3998 - 1i);
} else {
phi_6790_ = _e4098;
}
let _e4102 = phi_6790_;
let _e4104 = ((_e4102 - _e4066) * _e3993);
let _e4105 = (_e4081 + 1i);
let _e4107 = select(_e4105, 0i, (_e4105 < 0i));
if (_e4107 >= _e4003) {
phi_6804_ = (_e4003 - 1i);
} else {
phi_6804_ = _e4107;
}
let _e4111 = phi_6804_;
let _e4118 = global_1.member.member_13.member_10;
let _e4119 = bitcast<i32>(_e4118);
let _e4124 = ((_e4119 + (((_e4081 * _e3998) + _e4066) * _e3993)) + _e4051);
let _e4126 = select(_e1322, _e4124, (_e4124 < _e1322));
let _e4131 = global_8.member[bitcast<u32>(select(0i, _e4126, (_e4126 > 0i)))];
let _e4132 = local_2;
let _e4135 = local_3;
let _e4136 = (_e4124 + _e4135);
let _e4138 = select(_e1322, _e4136, (_e4136 < _e1322));
let _e4143 = global_8.member[bitcast<u32>(select(0i, _e4138, (_e4138 > 0i)))];
let _e4144 = local_2;
let _e4147 = (1f - _e4085);
let _e4149 = (_e4124 + _e4104);
let _e4151 = select(_e1322, _e4149, (_e4149 < _e1322));
let _e4156 = global_8.member[bitcast<u32>(select(0i, _e4151, (_e4151 > 0i)))];
let _e4157 = local_2;
let _e4160 = local_3;
let _e4161 = (_e4149 + _e4160);
let _e4163 = select(_e1322, _e4161, (_e4161 < _e1322));
let _e4168 = global_8.member[bitcast<u32>(select(0i, _e4163, (_e4163 > 0i)))];
let _e4169 = local_2;
let _e4174 = (_e4124 + (((_e4111 - _e4081) * _e3993) * _e3998));
let _e4176 = select(_e1322, _e4174, (_e4174 < _e1322));
let _e4181 = global_8.member[bitcast<u32>(select(0i, _e4176, (_e4176 > 0i)))];
let _e4182 = local_2;
let _e4185 = local_3;
let _e4186 = (_e4174 + _e4185);
let _e4188 = select(_e1322, _e4186, (_e4186 < _e1322));
let _e4193 = global_8.member[bitcast<u32>(select(0i, _e4188, (_e4188 > 0i)))];
let _e4194 = local_2;
let _e4198 = (_e4174 + _e4104);
let _e4200 = select(_e1322, _e4198, (_e4198 < _e1322));
let _e4205 = global_8.member[bitcast<u32>(select(0i, _e4200, (_e4200 > 0i)))];
let _e4206 = local_2;
let _e4209 = local_3;
let _e4210 = (_e4198 + _e4209);
let _e4212 = select(_e1322, _e4210, (_e4210 < _e1322));
let _e4217 = global_8.member[bitcast<u32>(select(0i, _e4212, (_e4212 > 0i)))];
let _e4218 = local_2;
let _e4227 = (_e3979 + _e3981);
let _e4237 = (((((_e818 + (_e501 * _e4227)) - _e3909.member) / _e4006) * _e4004) - 0.5f);
let _e4239 = select(0f, _e4237, (_e4237 > 0f));
let _e4241 = select(_e4010, _e4239, (_e4239 < _e4010));
let _e4245 = (((((_e819 + (_e512 * _e4227)) - _e3909.member_1) / _e4017) * _e4015) - 0.5f);
let _e4247 = select(0f, _e4245, (_e4245 > 0f));
let _e4249 = select(_e4021, _e4247, (_e4247 < _e4021));
let _e4253 = (((((_e820 + (_e523 * _e4227)) - _e3909.member_2) / _e4028) * _e4026) - 0.5f);
let _e4255 = select(0f, _e4253, (_e4253 > 0f));
let _e4257 = select(_e4032, _e4255, (_e4255 < _e4032));
let _e4259 = select(0f, _e4241, (_e4241 > 0f));
let _e4261 = select(1e6f, _e4259, (_e4259 < 1e6f));
let _e4268 = select(0i, select(select(i32(_e4261), i32(-2147483648), (_e4261 < -2147483600f)), 2147483647i, (_e4261 > 2147483500f)), (_e4261 == _e4261));
let _e4272 = (_e4268 - select(0i, 1i, (_e4261 < f32(_e4268))));
let _e4274 = select(0f, _e4249, (_e4249 > 0f));
let _e4276 = select(1e6f, _e4274, (_e4274 < 1e6f));
let _e4283 = select(0i, select(select(i32(_e4276), i32(-2147483648), (_e4276 < -2147483600f)), 2147483647i, (_e4276 > 2147483500f)), (_e4276 == _e4276));
let _e4287 = (_e4283 - select(0i, 1i, (_e4276 < f32(_e4283))));
let _e4289 = select(0f, _e4257, (_e4257 > 0f));
let _e4291 = select(1e6f, _e4289, (_e4289 < 1e6f));
let _e4298 = select(0i, select(select(i32(_e4291), i32(-2147483648), (_e4291 < -2147483600f)), 2147483647i, (_e4291 > 2147483500f)), (_e4291 == _e4291));
let _e4302 = (_e4298 - select(0i, 1i, (_e4291 < f32(_e4298))));
let _e4306 = (_e4249 - f32(_e4287));
let _e4308 = (_e4257 - f32(_e4302));
local = (_e4241 - f32(_e4272));
let _e4309 = (_e4272 + 1i);
let _e4311 = select(_e4309, 0i, (_e4309 < 0i));
if (_e4311 >= _e3993) {
phi_7120_ = (_e3993 - 1i);
} else {
phi_7120_ = _e4311;
}
let _e4315 = phi_7120_;
local_1 = (_e4315 - _e4272);
let _e4317 = (_e4287 + 1i);
let _e4319 = select(_e4317, 0i, (_e4317 < 0i));
if (_e4319 >= _e3998) {
phi_7133_ = (_e3998 - 1i);
} else {
phi_7133_ = _e4319;
}
let _e4323 = phi_7133_;
let _e4325 = ((_e4323 - _e4287) * _e3993);
let _e4326 = (_e4302 + 1i);
let _e4328 = select(_e4326, 0i, (_e4326 < 0i));
if (_e4328 >= _e4003) {
phi_7147_ = (_e4003 - 1i);
} else {
phi_7147_ = _e4328;
}
let _e4332 = phi_7147_;
let _e4340 = ((_e4119 + (((_e4302 * _e3998) + _e4287) * _e3993)) + _e4272);
let _e4342 = select(_e1322, _e4340, (_e4340 < _e1322));
let _e4347 = global_8.member[bitcast<u32>(select(0i, _e4342, (_e4342 > 0i)))];
let _e4348 = local;
let _e4351 = local_1;
let _e4352 = (_e4340 + _e4351);
let _e4354 = select(_e1322, _e4352, (_e4352 < _e1322));
let _e4359 = global_8.member[bitcast<u32>(select(0i, _e4354, (_e4354 > 0i)))];
let _e4360 = local;
let _e4363 = (1f - _e4306);
let _e4365 = (_e4340 + _e4325);
let _e4367 = select(_e1322, _e4365, (_e4365 < _e1322));
let _e4372 = global_8.member[bitcast<u32>(select(0i, _e4367, (_e4367 > 0i)))];
let _e4373 = local;
let _e4376 = local_1;
let _e4377 = (_e4365 + _e4376);
let _e4379 = select(_e1322, _e4377, (_e4377 < _e1322));
let _e4384 = global_8.member[bitcast<u32>(select(0i, _e4379, (_e4379 > 0i)))];
let _e4385 = local;
let _e4390 = (_e4340 + (((_e4332 - _e4302) * _e3993) * _e3998));
let _e4392 = select(_e1322, _e4390, (_e4390 < _e1322));
let _e4397 = global_8.member[bitcast<u32>(select(0i, _e4392, (_e4392 > 0i)))];
let _e4398 = local;
let _e4401 = local_1;
let _e4402 = (_e4390 + _e4401);
let _e4404 = select(_e1322, _e4402, (_e4402 < _e1322));
let _e4409 = global_8.member[bitcast<u32>(select(0i, _e4404, (_e4404 > 0i)))];
let _e4410 = local;
let _e4414 = (_e4390 + _e4325);
let _e4416 = select(_e1322, _e4414, (_e4414 < _e1322));
let _e4421 = global_8.member[bitcast<u32>(select(0i, _e4416, (_e4416 > 0i)))];
let _e4422 = local;
let _e4425 = local_1;
let _e4426 = (_e4414 + _e4425);
let _e4428 = select(_e1322, _e4426, (_e4426 < _e1322));
let _e4433 = global_8.member[bitcast<u32>(select(0i, _e4428, (_e4428 > 0i)))];
let _e4434 = local;
phi_6640_ = (_e3968 + 1u);
phi_6643_ = (_e3970 + ((0.5f * (((((((_e4131 * (1f - _e4132)) + (_e4143 * _e4144)) * _e4147) + (((_e4156 * (1f - _e4157)) + (_e4168 * _e4169)) * _e4085)) * (1f - _e4087)) + (((((_e4181 * (1f - _e4182)) + (_e4193 * _e4194)) * _e4147) + (((_e4205 * (1f - _e4206)) + (_e4217 * _e4218)) * _e4085)) * _e4087)) + ((((((_e4347 * (1f - _e4348)) + (_e4359 * _e4360)) * _e4363) + (((_e4372 * (1f - _e4373)) + (_e4384 * _e4385)) * _e4306)) * (1f - _e4308)) + (((((_e4397 * (1f - _e4398)) + (_e4409 * _e4410)) * _e4363) + (((_e4421 * (1f - _e4422)) + (_e4433 * _e4434)) * _e4306)) * _e4308)))) * _e3980));
} else {
phi_6640_ = u32();
phi_6643_ = f32();
}
let _e4449 = phi_6640_;
let _e4451 = phi_6643_;
continue;
continuing {
phi_6639_ = _e4449;
phi_6642_ = _e4451;
break if !(_e3973);
}
}
let _e4794 = local_43;
phi_7352_ = _e4794;
}
let _e4454 = phi_7352_;
let _e4458 = global_1.member.member_13.member;
let _e4463 = -((_e4458.member * _e4454));
let _e4465 = select(-87f, _e4463, (_e4463 > -87f));
let _e4467 = select(88f, _e4465, (_e4465 < 88f));
let _e4469 = ((_e4467 * 1.442695f) + 0.5f);
let _e4471 = select(-127f, _e4469, (_e4469 > -127f));
let _e4473 = select(128f, _e4471, (_e4471 < 128f));
let _e4480 = select(0i, select(select(i32(_e4473), i32(-2147483648), (_e4473 < -2147483600f)), 2147483647i, (_e4473 > 2147483500f)), (_e4473 == _e4473));
let _e4484 = (_e4480 - select(0i, 1i, (_e4473 < f32(_e4480))));
let _e4485 = f32(_e4484);
let _e4489 = ((_e4467 - (_e4485 * 0.6933594f)) - (_e4485 * -2.1219444e-4f));
let _e4511 = -((_e4458.member_1 * _e4454));
let _e4513 = select(-87f, _e4511, (_e4511 > -87f));
let _e4515 = select(88f, _e4513, (_e4513 < 88f));
let _e4517 = ((_e4515 * 1.442695f) + 0.5f);
let _e4519 = select(-127f, _e4517, (_e4517 > -127f));
let _e4521 = select(128f, _e4519, (_e4519 < 128f));
let _e4528 = select(0i, select(select(i32(_e4521), i32(-2147483648), (_e4521 < -2147483600f)), 2147483647i, (_e4521 > 2147483500f)), (_e4521 == _e4521));
let _e4532 = (_e4528 - select(0i, 1i, (_e4521 < f32(_e4528))));
let _e4533 = f32(_e4532);
let _e4537 = ((_e4515 - (_e4533 * 0.6933594f)) - (_e4533 * -2.1219444e-4f));
let _e4559 = -((_e4458.member_2 * _e4454));
let _e4561 = select(-87f, _e4559, (_e4559 > -87f));
let _e4563 = select(88f, _e4561, (_e4561 < 88f));
let _e4565 = ((_e4563 * 1.442695f) + 0.5f);
let _e4567 = select(-127f, _e4565, (_e4565 > -127f));
let _e4569 = select(128f, _e4567, (_e4567 < 128f));
let _e4576 = select(0i, select(select(i32(_e4569), i32(-2147483648), (_e4569 < -2147483600f)), 2147483647i, (_e4569 > 2147483500f)), (_e4569 == _e4569));
let _e4580 = (_e4576 - select(0i, 1i, (_e4569 < f32(_e4576))));
let _e4581 = f32(_e4580);
let _e4585 = ((_e4563 - (_e4581 * 0.6933594f)) - (_e4581 * -2.1219444e-4f));
phi_7591_ = array<f32, 22>(_e175, _e185, _e196, (_e207 + (((_e3871.x * _e1299.member_3.x) * ((1f + (_e4489 * (1f + (_e4489 * (0.5f + (_e4489 * (0.16666667f + (_e4489 * (0.041666668f + (_e4489 * (0.008333334f + (_e4489 * (0.001388889f + (_e4489 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4484 + 127i)) << bitcast<u32>(23i))))) * select(_e666, 1f, _e736))), (_e218 + (((_e3874.y * _e1299.member_3.y) * ((1f + (_e4537 * (1f + (_e4537 * (0.5f + (_e4537 * (0.16666667f + (_e4537 * (0.041666668f + (_e4537 * (0.008333334f + (_e4537 * (0.001388889f + (_e4537 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4532 + 127i)) << bitcast<u32>(23i))))) * select(_e677, 1f, _e736))), (_e229 + (((_e3878.z * _e1299.member_3.z) * ((1f + (_e4585 * (1f + (_e4585 * (0.5f + (_e4585 * (0.16666667f + (_e4585 * (0.041666668f + (_e4585 * (0.008333334f + (_e4585 * (0.001388889f + (_e4585 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4580 + 127i)) << bitcast<u32>(23i))))) * select(_e688, 1f, _e736))), _e240, _e251, _e262, _e273, _e284, _e295, _e306, _e317, _e328, _e339, _e350, _e361, _e372, _e383, _e394, _e405);
}
let _e4624 = phi_7591_;
phi_7592_ = _e4624;
phi_7593_ = _e3881;
} else {
phi_7592_ = array<f32, 22>();
phi_7593_ = true;
}
let _e4626 = phi_7592_;
let _e4628 = phi_7593_;
if _e4628 {
phi_7597_ = array<f32, 22>(_e175, _e185, _e196, _e207, _e218, _e229, _e240, _e251, _e262, _e273, _e284, _e295, _e306, _e317, _e328, _e339, _e350, _e361, _e372, _e383, _e394, _e405);
} else {
phi_7597_ = _e4626;
}
let _e4630 = phi_7597_;
global_5.member[_e164] = _e4630[0];
global_5.member[_e176] = _e4630[1];
global_5.member[_e187] = _e4630[2];
global_5.member[_e198] = _e4630[3];
global_5.member[_e209] = _e4630[4];
global_5.member[_e220] = _e4630[5];
global_5.member[_e231] = _e4630[6];
global_5.member[_e242] = _e4630[7];
global_5.member[_e253] = _e4630[8];
global_5.member[_e264] = _e4630[9];
global_5.member[_e275] = _e4630[10];
global_5.member[_e286] = _e4630[11];
global_5.member[_e297] = _e4630[12];
global_5.member[_e308] = _e4630[13];
global_5.member[_e319] = _e4630[14];
global_5.member[_e330] = _e4630[15];
global_5.member[_e341] = _e4630[16];
global_5.member[_e352] = _e4630[17];
global_5.member[_e363] = _e4630[18];
global_5.member[_e374] = _e4630[19];
global_5.member[_e385] = _e4630[20];
global_5.member[_e396] = _e4630[21];
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
