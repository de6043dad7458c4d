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
member_12: u32,
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
member_11: u32,
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
member: f32,
member_1: f32,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: vec3<f32>,
member_6: vec3<f32>,
member_7: f32,
member_8: vec3<f32>,
}
struct type_25 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
struct type_26 {
member: vec3<f32>,
member_1: vec3<f32>,
}
struct type_27 {
member: f32,
member_1: f32,
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
@group(0) @binding(7)
var<storage, read_write> global_6: type_13;
@group(0) @binding(5)
var<storage> global_7: type_13;
@group(0) @binding(6)
var<storage> global_8: type_13;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: i32;
var local_5: f32;
var local_6: i32;
var local_7: f32;
var local_8: i32;
var local_9: i32;
var local_10: f32;
var local_11: i32;
var local_12: f32;
var local_13: i32;
var local_14: i32;
var local_15: f32;
var local_16: i32;
var local_17: f32;
var local_18: i32;
var local_19: i32;
var local_20: f32;
var local_21: i32;
var local_22: f32;
var local_23: i32;
var local_24: i32;
var local_25: f32;
var local_26: i32;
var local_27: f32;
var local_28: i32;
var local_29: f32;
var local_30: i32;
var local_31: f32;
var local_32: i32;
var local_33: f32;
var local_34: i32;
var local_35: f32;
var local_36: i32;
var local_37: f32;
var local_38: i32;
var local_39: f32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var phi_2020_: u32;
var phi_2023_: f32;
var phi_2158_: i32;
var phi_2171_: i32;
var phi_2185_: i32;
var phi_2501_: i32;
var phi_2514_: i32;
var phi_2528_: i32;
var phi_2021_: u32;
var phi_2024_: f32;
var phi_2733_: f32;
var phi_3096_: type_27;
var phi_3100_: type_27;
var phi_3214_: i32;
var phi_3366_: u32;
var phi_3369_: f32;
var phi_3504_: i32;
var phi_3517_: i32;
var phi_3531_: i32;
var phi_3847_: i32;
var phi_3860_: i32;
var phi_3874_: i32;
var phi_3367_: u32;
var phi_3370_: f32;
var phi_4079_: f32;
var phi_4081_: f32;
var phi_4084_: vec3<f32>;
var phi_4086_: i32;
var phi_4260_: i32;
var phi_4273_: i32;
var phi_4287_: i32;
var phi_4487_: f32;
var phi_4650_: i32;
var phi_4663_: i32;
var phi_4677_: i32;
var phi_4877_: f32;
var phi_5039_: i32;
var phi_5052_: i32;
var phi_5066_: i32;
var phi_5266_: f32;
var phi_5428_: i32;
var phi_5441_: i32;
var phi_5455_: i32;
var phi_5655_: f32;
var phi_6216_: vec3<f32>;
var phi_6219_: vec3<f32>;
var phi_6232_: type_26;
var phi_6428_: u32;
var phi_6431_: f32;
var phi_6569_: i32;
var phi_6582_: i32;
var phi_6596_: i32;
var phi_6915_: i32;
var phi_6928_: i32;
var phi_6942_: i32;
var phi_6429_: u32;
var phi_6432_: f32;
var phi_7147_: f32;
var phi_7508_: f32;
var phi_8066_: vec3<f32>;
var phi_8069_: vec3<f32>;
var phi_8082_: type_26;
var phi_8278_: u32;
var phi_8281_: f32;
var phi_8419_: i32;
var phi_8432_: i32;
var phi_8446_: i32;
var phi_8765_: i32;
var phi_8778_: i32;
var phi_8792_: i32;
var phi_8279_: u32;
var phi_8282_: f32;
var phi_8997_: f32;
var phi_9358_: f32;
var phi_9920_: vec3<f32>;
var phi_9923_: vec3<f32>;
var phi_9936_: type_26;
var phi_10132_: u32;
var phi_10135_: f32;
var phi_10273_: i32;
var phi_10286_: i32;
var phi_10300_: i32;
var phi_10619_: i32;
var phi_10632_: i32;
var phi_10646_: i32;
var phi_10133_: u32;
var phi_10136_: f32;
var phi_10851_: f32;
var phi_11212_: f32;
var phi_11770_: vec3<f32>;
var phi_11773_: vec3<f32>;
var phi_11786_: type_26;
var phi_11982_: u32;
var phi_11985_: f32;
var phi_12123_: i32;
var phi_12136_: i32;
var phi_12150_: i32;
var phi_12469_: i32;
var phi_12482_: i32;
var phi_12496_: i32;
var phi_11983_: u32;
var phi_11986_: f32;
var phi_12701_: f32;
var phi_13062_: f32;
var phi_4082_: f32;
var phi_4085_: vec3<f32>;
var phi_4087_: i32;
var phi_13117_: vec3<f32>;
var phi_13132_: type_24;
var phi_13867_: type_25;
var phi_13931_: bool;
var phi_14051_: type_24;
var phi_16080_: vec3<f32>;
var phi_16083_: vec3<f32>;
var phi_16096_: type_26;
var phi_16305_: u32;
var phi_16308_: f32;
var phi_16446_: i32;
var phi_16459_: i32;
var phi_16473_: i32;
var phi_16792_: i32;
var phi_16805_: i32;
var phi_16819_: i32;
var phi_16306_: u32;
var phi_16309_: f32;
var phi_17024_: f32;
var phi_17376_: type_24;
var phi_14757_: i32;
var phi_14760_: i32;
var phi_14762_: i32;
var phi_14764_: i32;
var phi_14779_: i32;
var phi_14785_: i32;
var phi_14758_: i32;
var phi_14761_: i32;
var phi_14763_: i32;
var phi_14765_: i32;
var local_43: i32;
var local_44: i32;
var local_45: i32;
var phi_14860_: i32;
var local_46: i32;
var local_47: i32;
var phi_14866_: i32;
var local_48: i32;
var phi_14873_: i32;
var local_49: i32;
var local_50: i32;
var phi_14879_: i32;
var local_51: i32;
var local_52: i32;
var phi_14890_: i32;
var local_53: i32;
var local_54: i32;
var phi_14902_: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var phi_15138_: i32;
var phi_15141_: i32;
var phi_15143_: i32;
var phi_15145_: i32;
var phi_15160_: i32;
var phi_15166_: i32;
var phi_15139_: i32;
var phi_15142_: i32;
var phi_15144_: i32;
var phi_15146_: i32;
var local_59: i32;
var local_60: i32;
var local_61: i32;
var phi_15241_: i32;
var local_62: i32;
var local_63: i32;
var phi_15247_: i32;
var local_64: i32;
var phi_15254_: i32;
var local_65: i32;
var local_66: i32;
var phi_15260_: i32;
var local_67: i32;
var local_68: i32;
var phi_15271_: i32;
var local_69: i32;
var local_70: i32;
var phi_15283_: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var phi_15538_: vec3<f32>;
var phi_14155_: vec3<f32>;
var phi_15539_: vec3<f32>;
var phi_15540_: vec3<f32>;
var phi_17377_: type_24;
var local_75: f32;
var local_76: f32;
var local_77: f32;
var local_78: f32;
var local_79: f32;
var local_80: f32;
var local_81: vec3<f32>;
var local_82: f32;
let _e173 = global;
let _e180 = arrayLength((&global_3.member));
let _e182 = arrayLength((&global_4.member));
let _e187 = arrayLength((&global_7.member));
let _e194 = global_1.member.member;
if (_e173.x < _e194.member) {
if (_e173.y < _e194.member_1) {
let _e201 = (_e194.member * _e194.member_1);
let _e203 = ((_e173.y * _e194.member) + _e173.x);
let _e204 = bitcast<i32>(_e203);
let _e206 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e208 = select(_e206, _e204, (_e204 < _e206));
let _e214 = global_6.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e215 = (_e201 + _e203);
let _e216 = bitcast<i32>(_e215);
let _e218 = select(_e206, _e216, (_e216 < _e206));
let _e224 = global_6.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e226 = ((2u * _e201) + _e203);
let _e227 = bitcast<i32>(_e226);
let _e229 = select(_e206, _e227, (_e227 < _e206));
let _e235 = global_6.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e237 = ((3u * _e201) + _e203);
let _e238 = bitcast<i32>(_e237);
let _e240 = select(_e206, _e238, (_e238 < _e206));
let _e246 = global_6.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e248 = ((4u * _e201) + _e203);
let _e249 = bitcast<i32>(_e248);
let _e251 = select(_e206, _e249, (_e249 < _e206));
let _e257 = global_6.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e259 = ((5u * _e201) + _e203);
let _e260 = bitcast<i32>(_e259);
let _e262 = select(_e206, _e260, (_e260 < _e206));
let _e268 = global_6.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e270 = ((6u * _e201) + _e203);
let _e271 = bitcast<i32>(_e270);
let _e273 = select(_e206, _e271, (_e271 < _e206));
let _e279 = global_6.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e281 = ((7u * _e201) + _e203);
let _e282 = bitcast<i32>(_e281);
let _e284 = select(_e206, _e282, (_e282 < _e206));
let _e290 = global_6.member[bitcast<u32>(select(0i, _e284, (_e284 > 0i)))];
let _e292 = ((8u * _e201) + _e203);
let _e293 = bitcast<i32>(_e292);
let _e295 = select(_e206, _e293, (_e293 < _e206));
let _e301 = global_6.member[bitcast<u32>(select(0i, _e295, (_e295 > 0i)))];
let _e303 = ((9u * _e201) + _e203);
let _e304 = bitcast<i32>(_e303);
let _e306 = select(_e206, _e304, (_e304 < _e206));
let _e312 = global_6.member[bitcast<u32>(select(0i, _e306, (_e306 > 0i)))];
let _e314 = ((10u * _e201) + _e203);
let _e315 = bitcast<i32>(_e314);
let _e317 = select(_e206, _e315, (_e315 < _e206));
let _e323 = global_6.member[bitcast<u32>(select(0i, _e317, (_e317 > 0i)))];
let _e325 = ((11u * _e201) + _e203);
let _e326 = bitcast<i32>(_e325);
let _e328 = select(_e206, _e326, (_e326 < _e206));
let _e334 = global_6.member[bitcast<u32>(select(0i, _e328, (_e328 > 0i)))];
let _e336 = ((12u * _e201) + _e203);
let _e337 = bitcast<i32>(_e336);
let _e339 = select(_e206, _e337, (_e337 < _e206));
let _e345 = global_6.member[bitcast<u32>(select(0i, _e339, (_e339 > 0i)))];
let _e347 = ((13u * _e201) + _e203);
let _e348 = bitcast<i32>(_e347);
let _e350 = select(_e206, _e348, (_e348 < _e206));
let _e356 = global_6.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
let _e358 = ((14u * _e201) + _e203);
let _e359 = bitcast<i32>(_e358);
let _e361 = select(_e206, _e359, (_e359 < _e206));
let _e367 = global_6.member[bitcast<u32>(select(0i, _e361, (_e361 > 0i)))];
let _e369 = ((15u * _e201) + _e203);
let _e370 = bitcast<i32>(_e369);
let _e372 = select(_e206, _e370, (_e370 < _e206));
let _e378 = global_6.member[bitcast<u32>(select(0i, _e372, (_e372 > 0i)))];
let _e380 = ((16u * _e201) + _e203);
let _e381 = bitcast<i32>(_e380);
let _e383 = select(_e206, _e381, (_e381 < _e206));
let _e389 = global_6.member[bitcast<u32>(select(0i, _e383, (_e383 > 0i)))];
let _e391 = ((17u * _e201) + _e203);
let _e392 = bitcast<i32>(_e391);
let _e394 = select(_e206, _e392, (_e392 < _e206));
let _e400 = global_6.member[bitcast<u32>(select(0i, _e394, (_e394 > 0i)))];
let _e402 = ((18u * _e201) + _e203);
let _e403 = bitcast<i32>(_e402);
let _e405 = select(_e206, _e403, (_e403 < _e206));
let _e411 = global_6.member[bitcast<u32>(select(0i, _e405, (_e405 > 0i)))];
let _e415 = global_1.member.member.member;
let _e419 = global_1.member.member.member_1;
let _e420 = (_e415 * _e419);
local_41 = bitcast<i32>(_e420);
let _e423 = ((_e173.y * _e415) + _e173.x);
let _e424 = bitcast<i32>(_e423);
local_42 = _e424;
let _e425 = local_41;
let _e427 = local_42;
let _e428 = ((29i * _e425) + _e427);
let _e430 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e432 = select(_e430, _e428, (_e428 < _e430));
let _e437 = global_2.member[bitcast<u32>(select(0i, _e432, (_e432 > 0i)))];
let _e439 = local_41;
let _e441 = local_42;
let _e442 = ((36i * _e439) + _e441);
let _e444 = select(_e430, _e442, (_e442 < _e430));
let _e449 = global_2.member[bitcast<u32>(select(0i, _e444, (_e444 > 0i)))];
let _e460 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e437 == 2f) && (select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < -2147483600f)), 2147483647i, (_e449 > 2147483500f)), (_e449 == _e449)) == (bitcast<i32>(_e460) + 1i)))) > 1u) {
let _e472 = type_24(_e214, _e224, _e235, vec3<f32>(_e246, _e257, _e268), vec3<f32>(_e279, _e290, _e301), vec3<f32>(_e312, _e323, _e334), vec3<f32>(_e345, _e356, _e367), _e378, vec3<f32>(_e389, _e400, _e411));
let _e474 = select(_e430, _e424, (_e424 < _e430));
let _e480 = global_2.member[bitcast<u32>(select(0i, _e474, (_e474 > 0i)))];
let _e482 = bitcast<i32>((_e420 + _e423));
let _e484 = select(_e430, _e482, (_e482 < _e430));
let _e490 = global_2.member[bitcast<u32>(select(0i, _e484, (_e484 > 0i)))];
let _e493 = bitcast<i32>(((2u * _e420) + _e423));
let _e495 = select(_e430, _e493, (_e493 < _e430));
let _e501 = global_2.member[bitcast<u32>(select(0i, _e495, (_e495 > 0i)))];
let _e504 = bitcast<i32>(((3u * _e420) + _e423));
let _e506 = select(_e430, _e504, (_e504 < _e430));
let _e512 = global_2.member[bitcast<u32>(select(0i, _e506, (_e506 > 0i)))];
let _e515 = bitcast<i32>(((4u * _e420) + _e423));
let _e517 = select(_e430, _e515, (_e515 < _e430));
let _e523 = global_2.member[bitcast<u32>(select(0i, _e517, (_e517 > 0i)))];
let _e526 = bitcast<i32>(((5u * _e420) + _e423));
let _e528 = select(_e430, _e526, (_e526 < _e430));
let _e534 = global_2.member[bitcast<u32>(select(0i, _e528, (_e528 > 0i)))];
let _e537 = bitcast<i32>(((12u * _e420) + _e423));
let _e539 = select(_e430, _e537, (_e537 < _e430));
let _e545 = global_2.member[bitcast<u32>(select(0i, _e539, (_e539 > 0i)))];
let _e548 = bitcast<i32>(((13u * _e420) + _e423));
let _e550 = select(_e430, _e548, (_e548 < _e430));
let _e556 = global_2.member[bitcast<u32>(select(0i, _e550, (_e550 > 0i)))];
let _e559 = bitcast<i32>(((14u * _e420) + _e423));
let _e561 = select(_e430, _e559, (_e559 < _e430));
let _e567 = global_2.member[bitcast<u32>(select(0i, _e561, (_e561 > 0i)))];
let _e570 = bitcast<i32>(((15u * _e420) + _e423));
let _e572 = select(_e430, _e570, (_e570 < _e430));
let _e578 = global_2.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
let _e581 = bitcast<i32>(((16u * _e420) + _e423));
let _e583 = select(_e430, _e581, (_e581 < _e430));
let _e589 = global_2.member[bitcast<u32>(select(0i, _e583, (_e583 > 0i)))];
let _e592 = bitcast<i32>(((17u * _e420) + _e423));
let _e594 = select(_e430, _e592, (_e592 < _e430));
let _e600 = global_2.member[bitcast<u32>(select(0i, _e594, (_e594 > 0i)))];
let _e603 = bitcast<i32>(((18u * _e420) + _e423));
let _e605 = select(_e430, _e603, (_e603 < _e430));
let _e611 = global_2.member[bitcast<u32>(select(0i, _e605, (_e605 > 0i)))];
let _e614 = bitcast<i32>(((19u * _e420) + _e423));
let _e616 = select(_e430, _e614, (_e614 < _e430));
let _e622 = global_2.member[bitcast<u32>(select(0i, _e616, (_e616 > 0i)))];
let _e625 = bitcast<i32>(((20u * _e420) + _e423));
let _e627 = select(_e430, _e625, (_e625 < _e430));
let _e633 = global_2.member[bitcast<u32>(select(0i, _e627, (_e627 > 0i)))];
let _e636 = bitcast<i32>(((23u * _e420) + _e423));
let _e638 = select(_e430, _e636, (_e636 < _e430));
let _e644 = global_2.member[bitcast<u32>(select(0i, _e638, (_e638 > 0i)))];
let _e647 = bitcast<i32>(((24u * _e420) + _e423));
let _e649 = select(_e430, _e647, (_e647 < _e430));
let _e655 = global_2.member[bitcast<u32>(select(0i, _e649, (_e649 > 0i)))];
let _e658 = bitcast<i32>(((30u * _e420) + _e423));
let _e660 = select(_e430, _e658, (_e658 < _e430));
let _e666 = global_2.member[bitcast<u32>(select(0i, _e660, (_e660 > 0i)))];
let _e673 = select(0i, select(select(i32(_e644), i32(-2147483648), (_e644 < -2147483600f)), 2147483647i, (_e644 > 2147483500f)), (_e644 == _e644));
let _e681 = (select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < -2147483600f)), 2147483647i, (_e666 > 2147483500f)), (_e666 == _e666)) == 0i);
let _e689 = global_1.member.member_1.member;
let _e695 = global_1.member.member_1.member_1;
let _e705 = global_1.member.member_2.member;
let _e706 = (((((f32(bitcast<i32>(_e173.x)) + 0.5f) / f32(bitcast<i32>(_e689))) * 2f) - 1f) * _e705);
let _e714 = global_1.member.member_2.member_1;
let _e715 = ((1f - (((f32(bitcast<i32>(_e173.y)) + 0.5f) / f32(bitcast<i32>(_e695))) * 2f)) * _e714);
let _e718 = global_1.member.member_3;
let _e727 = global_1.member.member_4;
let _e740 = global_1.member.member_2.member_3;
let _e741 = (_e740 != 0u);
let _e744 = global_1.member.member_6;
let _e751 = select(_e744.member, (_e744.member + ((_e718.member * _e706) + (_e727.member * _e715))), _e741);
let _e752 = select(_e744.member_1, (_e744.member_1 + ((_e718.member_1 * _e706) + (_e727.member_1 * _e715))), _e741);
let _e753 = select(_e744.member_2, (_e744.member_2 + ((_e718.member_2 * _e706) + (_e727.member_2 * _e715))), _e741);
let _e763 = select(_e480, _e751, _e681);
let _e764 = select(_e490, _e752, _e681);
let _e765 = select(_e501, _e753, _e681);
let _e766 = vec3<f32>(_e763, _e764, _e765);
let _e767 = (select(0f, ((((_e480 - _e751) * _e512) + ((_e490 - _e752) * _e523)) + ((_e501 - _e753) * _e534)), _e681) + _e655);
let _e768 = select(_e611, 1f, _e681);
let _e769 = select(_e622, 1f, _e681);
let _e770 = select(_e633, 1f, _e681);
let _e778 = (1f / select(_e512, select(1e-12f, -1e-12f, (_e512 < 0f)), (bitcast<f32>((bitcast<u32>(_e512) & 2147483647u)) < 1e-12f)));
let _e786 = (1f / select(_e523, select(1e-12f, -1e-12f, (_e523 < 0f)), (bitcast<f32>((bitcast<u32>(_e523) & 2147483647u)) < 1e-12f)));
let _e794 = (1f / select(_e534, select(1e-12f, -1e-12f, (_e534 < 0f)), (bitcast<f32>((bitcast<u32>(_e534) & 2147483647u)) < 1e-12f)));
let _e798 = global_1.member.member_13.member_4;
let _e805 = global_1.member.member_13.member_5;
let _e810 = ((_e798.member - _e763) * _e778);
let _e812 = ((_e805.member - _e763) * _e778);
let _e814 = ((_e798.member_1 - _e764) * _e786);
let _e816 = ((_e805.member_1 - _e764) * _e786);
let _e818 = ((_e798.member_2 - _e765) * _e794);
let _e820 = ((_e805.member_2 - _e765) * _e794);
let _e822 = select(_e812, _e810, (_e810 < _e812));
let _e824 = select(_e816, _e814, (_e814 < _e816));
let _e826 = select(_e824, _e822, (_e822 > _e824));
let _e828 = select(_e820, _e818, (_e818 < _e820));
let _e830 = select(_e828, _e826, (_e826 > _e828));
let _e832 = select(_e812, _e810, (_e810 > _e812));
let _e834 = select(_e816, _e814, (_e814 > _e816));
let _e836 = select(_e834, _e832, (_e832 < _e834));
let _e838 = select(_e820, _e818, (_e818 > _e820));
let _e840 = select(_e838, _e836, (_e836 < _e838));
let _e842 = select(0f, _e830, (_e830 > 0f));
let _e844 = select(_e767, _e840, (_e840 < _e767));
let _e845 = (_e844 > _e842);
let _e846 = select(0f, _e842, _e845);
let _e847 = select(0f, _e844, _e845);
let _e848 = (_e847 - _e846);
let _e852 = global_1.member.member_13.member_6;
let _e853 = (_e852 == 0u);
if _e853 {
phi_2733_ = _e848;
} else {
let _e855 = (_e848 / f32(_e852));
phi_2020_ = 0u;
phi_2023_ = 0f;
loop {
let _e857 = phi_2020_;
let _e859 = phi_2023_;
local_75 = _e859;
let _e862 = ((_e857 < _e852) && (_e848 > 0f));
if _e862 {
let _e865 = (_e846 + (_e855 * f32(_e857)));
let _e866 = (_e865 + _e855);
let _e868 = (0.5f * (_e865 + _e866));
let _e869 = (_e866 - _e865);
let _e870 = (0.28867513f * _e869);
let _e871 = (_e868 - _e870);
let _e881 = global_1.member.member_13.member_7;
let _e882 = bitcast<i32>(_e881);
let _e886 = global_1.member.member_13.member_8;
let _e887 = bitcast<i32>(_e886);
let _e891 = global_1.member.member_13.member_9;
let _e892 = bitcast<i32>(_e891);
let _e893 = f32(_e882);
let _e895 = (_e805.member - _e798.member);
let _e898 = (((((_e763 + (_e512 * _e871)) - _e798.member) / _e895) * _e893) - 0.5f);
let _e899 = (_e893 - 1f);
let _e901 = select(0f, _e898, (_e898 > 0f));
let _e903 = select(_e899, _e901, (_e901 < _e899));
let _e904 = f32(_e887);
let _e906 = (_e805.member_1 - _e798.member_1);
let _e909 = (((((_e764 + (_e523 * _e871)) - _e798.member_1) / _e906) * _e904) - 0.5f);
let _e910 = (_e904 - 1f);
let _e912 = select(0f, _e909, (_e909 > 0f));
let _e914 = select(_e910, _e912, (_e912 < _e910));
let _e915 = f32(_e892);
let _e917 = (_e805.member_2 - _e798.member_2);
let _e920 = (((((_e765 + (_e534 * _e871)) - _e798.member_2) / _e917) * _e915) - 0.5f);
let _e921 = (_e915 - 1f);
let _e923 = select(0f, _e920, (_e920 > 0f));
let _e925 = select(_e921, _e923, (_e923 < _e921));
let _e927 = select(0f, _e903, (_e903 > 0f));
let _e929 = select(1e6f, _e927, (_e927 < 1e6f));
let _e936 = select(0i, select(select(i32(_e929), i32(-2147483648), (_e929 < -2147483600f)), 2147483647i, (_e929 > 2147483500f)), (_e929 == _e929));
let _e940 = (_e936 - select(0i, 1i, (_e929 < f32(_e936))));
let _e942 = select(0f, _e914, (_e914 > 0f));
let _e944 = select(1e6f, _e942, (_e942 < 1e6f));
let _e951 = select(0i, select(select(i32(_e944), i32(-2147483648), (_e944 < -2147483600f)), 2147483647i, (_e944 > 2147483500f)), (_e944 == _e944));
let _e955 = (_e951 - select(0i, 1i, (_e944 < f32(_e951))));
let _e957 = select(0f, _e925, (_e925 > 0f));
let _e959 = select(1e6f, _e957, (_e957 < 1e6f));
let _e966 = select(0i, select(select(i32(_e959), i32(-2147483648), (_e959 < -2147483600f)), 2147483647i, (_e959 > 2147483500f)), (_e959 == _e959));
let _e970 = (_e966 - select(0i, 1i, (_e959 < f32(_e966))));
let _e974 = (_e914 - f32(_e955));
let _e976 = (_e925 - f32(_e970));
local_39 = (_e903 - f32(_e940));
let _e977 = (_e940 + 1i);
let _e979 = select(_e977, 0i, (_e977 < 0i));
if (_e979 >= _e882) {
phi_2158_ = (_e882 - 1i);
} else {
phi_2158_ = _e979;
}
let _e983 = phi_2158_;
local_40 = (_e983 - _e940);
let _e985 = (_e955 + 1i);
let _e987 = select(_e985, 0i, (_e985 < 0i));
if (_e987 >= _e887) {
phi_2171_ = (_e887 - 1i);
} else {
phi_2171_ = _e987;
}
let _e991 = phi_2171_;
let _e993 = ((_e991 - _e955) * _e882);
let _e994 = (_e970 + 1i);
let _e996 = select(_e994, 0i, (_e994 < 0i));
if (_e996 >= _e892) {
phi_2185_ = (_e892 - 1i);
} else {
phi_2185_ = _e996;
}
let _e1000 = phi_2185_;
let _e1007 = global_1.member.member_13.member_10;
let _e1008 = bitcast<i32>(_e1007);
let _e1013 = ((_e1008 + (((_e970 * _e887) + _e955) * _e882)) + _e940);
let _e1015 = (bitcast<i32>(_e187) - 1i);
let _e1017 = select(_e1015, _e1013, (_e1013 < _e1015));
let _e1022 = global_7.member[bitcast<u32>(select(0i, _e1017, (_e1017 > 0i)))];
let _e1023 = local_39;
let _e1026 = local_40;
let _e1027 = (_e1013 + _e1026);
let _e1029 = select(_e1015, _e1027, (_e1027 < _e1015));
let _e1034 = global_7.member[bitcast<u32>(select(0i, _e1029, (_e1029 > 0i)))];
let _e1035 = local_39;
let _e1038 = (1f - _e974);
let _e1040 = (_e1013 + _e993);
let _e1042 = select(_e1015, _e1040, (_e1040 < _e1015));
let _e1047 = global_7.member[bitcast<u32>(select(0i, _e1042, (_e1042 > 0i)))];
let _e1048 = local_39;
let _e1051 = local_40;
let _e1052 = (_e1040 + _e1051);
let _e1054 = select(_e1015, _e1052, (_e1052 < _e1015));
let _e1059 = global_7.member[bitcast<u32>(select(0i, _e1054, (_e1054 > 0i)))];
let _e1060 = local_39;
let _e1065 = (_e1013 + (((_e1000 - _e970) * _e882) * _e887));
let _e1067 = select(_e1015, _e1065, (_e1065 < _e1015));
let _e1072 = global_7.member[bitcast<u32>(select(0i, _e1067, (_e1067 > 0i)))];
let _e1073 = local_39;
let _e1076 = local_40;
let _e1077 = (_e1065 + _e1076);
let _e1079 = select(_e1015, _e1077, (_e1077 < _e1015));
let _e1084 = global_7.member[bitcast<u32>(select(0i, _e1079, (_e1079 > 0i)))];
let _e1085 = local_39;
let _e1089 = (_e1065 + _e993);
let _e1091 = select(_e1015, _e1089, (_e1089 < _e1015));
let _e1096 = global_7.member[bitcast<u32>(select(0i, _e1091, (_e1091 > 0i)))];
let _e1097 = local_39;
let _e1100 = local_40;
let _e1101 = (_e1089 + _e1100);
let _e1103 = select(_e1015, _e1101, (_e1101 < _e1015));
let _e1108 = global_7.member[bitcast<u32>(select(0i, _e1103, (_e1103 > 0i)))];
let _e1109 = local_39;
let _e1118 = (_e868 + _e870);
let _e1128 = (((((_e763 + (_e512 * _e1118)) - _e798.member) / _e895) * _e893) - 0.5f);
let _e1130 = select(0f, _e1128, (_e1128 > 0f));
let _e1132 = select(_e899, _e1130, (_e1130 < _e899));
let _e1136 = (((((_e764 + (_e523 * _e1118)) - _e798.member_1) / _e906) * _e904) - 0.5f);
let _e1138 = select(0f, _e1136, (_e1136 > 0f));
let _e1140 = select(_e910, _e1138, (_e1138 < _e910));
let _e1144 = (((((_e765 + (_e534 * _e1118)) - _e798.member_2) / _e917) * _e915) - 0.5f);
let _e1146 = select(0f, _e1144, (_e1144 > 0f));
let _e1148 = select(_e921, _e1146, (_e1146 < _e921));
let _e1150 = select(0f, _e1132, (_e1132 > 0f));
let _e1152 = select(1e6f, _e1150, (_e1150 < 1e6f));
let _e1159 = select(0i, select(select(i32(_e1152), i32(-2147483648), (_e1152 < -2147483600f)), 2147483647i, (_e1152 > 2147483500f)), (_e1152 == _e1152));
let _e1163 = (_e1159 - select(0i, 1i, (_e1152 < f32(_e1159))));
let _e1165 = select(0f, _e1140, (_e1140 > 0f));
let _e1167 = select(1e6f, _e1165, (_e1165 < 1e6f));
let _e1174 = select(0i, select(select(i32(_e1167), i32(-2147483648), (_e1167 < -2147483600f)), 2147483647i, (_e1167 > 2147483500f)), (_e1167 == _e1167));
let _e1178 = (_e1174 - select(0i, 1i, (_e1167 < f32(_e1174))));
let _e1180 = select(0f, _e1148, (_e1148 > 0f));
let _e1182 = select(1e6f, _e1180, (_e1180 < 1e6f));
let _e1189 = select(0i, select(select(i32(_e1182), i32(-2147483648), (_e1182 < -2147483600f)), 2147483647i, (_e1182 > 2147483500f)), (_e1182 == _e1182));
let _e1193 = (_e1189 - select(0i, 1i, (_e1182 < f32(_e1189))));
let _e1197 = (_e1140 - f32(_e1178));
let _e1199 = (_e1148 - f32(_e1193));
local_37 = (_e1132 - f32(_e1163));
let _e1200 = (_e1163 + 1i);
let _e1202 = select(_e1200, 0i, (_e1200 < 0i));
if (_e1202 >= _e882) {
phi_2501_ = (_e882 - 1i);
} else {
phi_2501_ = _e1202;
}
let _e1206 = phi_2501_;
local_38 = (_e1206 - _e1163);
let _e1208 = (_e1178 + 1i);
let _e1210 = select(_e1208, 0i, (_e1208 < 0i));
if (_e1210 >= _e887) {
phi_2514_ = (_e887 - 1i);
} else {
phi_2514_ = _e1210;
}
let _e1214 = phi_2514_;
let _e1216 = ((_e1214 - _e1178) * _e882);
let _e1217 = (_e1193 + 1i);
let _e1219 = select(_e1217, 0i, (_e1217 < 0i));
if (_e1219 >= _e892) {
phi_2528_ = (_e892 - 1i);
} else {
phi_2528_ = _e1219;
}
let _e1223 = phi_2528_;
let _e1231 = ((_e1008 + (((_e1193 * _e887) + _e1178) * _e882)) + _e1163);
let _e1233 = select(_e1015, _e1231, (_e1231 < _e1015));
let _e1238 = global_7.member[bitcast<u32>(select(0i, _e1233, (_e1233 > 0i)))];
let _e1239 = local_37;
let _e1242 = local_38;
let _e1243 = (_e1231 + _e1242);
let _e1245 = select(_e1015, _e1243, (_e1243 < _e1015));
let _e1250 = global_7.member[bitcast<u32>(select(0i, _e1245, (_e1245 > 0i)))];
let _e1251 = local_37;
let _e1254 = (1f - _e1197);
let _e1256 = (_e1231 + _e1216);
let _e1258 = select(_e1015, _e1256, (_e1256 < _e1015));
let _e1263 = global_7.member[bitcast<u32>(select(0i, _e1258, (_e1258 > 0i)))];
let _e1264 = local_37;
let _e1267 = local_38;
let _e1268 = (_e1256 + _e1267);
let _e1270 = select(_e1015, _e1268, (_e1268 < _e1015));
let _e1275 = global_7.member[bitcast<u32>(select(0i, _e1270, (_e1270 > 0i)))];
let _e1276 = local_37;
let _e1281 = (_e1231 + (((_e1223 - _e1193) * _e882) * _e887));
let _e1283 = select(_e1015, _e1281, (_e1281 < _e1015));
let _e1288 = global_7.member[bitcast<u32>(select(0i, _e1283, (_e1283 > 0i)))];
let _e1289 = local_37;
let _e1292 = local_38;
let _e1293 = (_e1281 + _e1292);
let _e1295 = select(_e1015, _e1293, (_e1293 < _e1015));
let _e1300 = global_7.member[bitcast<u32>(select(0i, _e1295, (_e1295 > 0i)))];
let _e1301 = local_37;
let _e1305 = (_e1281 + _e1216);
let _e1307 = select(_e1015, _e1305, (_e1305 < _e1015));
let _e1312 = global_7.member[bitcast<u32>(select(0i, _e1307, (_e1307 > 0i)))];
let _e1313 = local_37;
let _e1316 = local_38;
let _e1317 = (_e1305 + _e1316);
let _e1319 = select(_e1015, _e1317, (_e1317 < _e1015));
let _e1324 = global_7.member[bitcast<u32>(select(0i, _e1319, (_e1319 > 0i)))];
let _e1325 = local_37;
phi_2021_ = (_e857 + 1u);
phi_2024_ = (_e859 + ((0.5f * (((((((_e1022 * (1f - _e1023)) + (_e1034 * _e1035)) * _e1038) + (((_e1047 * (1f - _e1048)) + (_e1059 * _e1060)) * _e974)) * (1f - _e976)) + (((((_e1072 * (1f - _e1073)) + (_e1084 * _e1085)) * _e1038) + (((_e1096 * (1f - _e1097)) + (_e1108 * _e1109)) * _e974)) * _e976)) + ((((((_e1238 * (1f - _e1239)) + (_e1250 * _e1251)) * _e1254) + (((_e1263 * (1f - _e1264)) + (_e1275 * _e1276)) * _e1197)) * (1f - _e1199)) + (((((_e1288 * (1f - _e1289)) + (_e1300 * _e1301)) * _e1254) + (((_e1312 * (1f - _e1313)) + (_e1324 * _e1325)) * _e1197)) * _e1199)))) * _e869));
} else {
phi_2021_ = u32();
phi_2024_ = f32();
}
let _e1340 = phi_2021_;
let _e1342 = phi_2024_;
continue;
continuing {
phi_2020_ = _e1340;
phi_2023_ = _e1342;
break if !(_e862);
}
}
let _e11089 = local_75;
phi_2733_ = _e11089;
}
let _e1345 = phi_2733_;
let _e1349 = global_1.member.member_13.member;
let _e1354 = -((_e1349.member * _e1345));
let _e1356 = select(-87f, _e1354, (_e1354 > -87f));
let _e1358 = select(88f, _e1356, (_e1356 < 88f));
let _e1360 = ((_e1358 * 1.442695f) + 0.5f);
let _e1362 = select(-127f, _e1360, (_e1360 > -127f));
let _e1364 = select(128f, _e1362, (_e1362 < 128f));
let _e1371 = select(0i, select(select(i32(_e1364), i32(-2147483648), (_e1364 < -2147483600f)), 2147483647i, (_e1364 > 2147483500f)), (_e1364 == _e1364));
let _e1375 = (_e1371 - select(0i, 1i, (_e1364 < f32(_e1371))));
let _e1376 = f32(_e1375);
let _e1380 = ((_e1358 - (_e1376 * 0.6933594f)) - (_e1376 * -2.1219444e-4f));
let _e1400 = ((1f + (_e1380 * (1f + (_e1380 * (0.5f + (_e1380 * (0.16666667f + (_e1380 * (0.041666668f + (_e1380 * (0.008333334f + (_e1380 * (0.001388889f + (_e1380 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1375 + 127i)) << bitcast<u32>(23i))));
let _e1402 = -((_e1349.member_1 * _e1345));
let _e1404 = select(-87f, _e1402, (_e1402 > -87f));
let _e1406 = select(88f, _e1404, (_e1404 < 88f));
let _e1408 = ((_e1406 * 1.442695f) + 0.5f);
let _e1410 = select(-127f, _e1408, (_e1408 > -127f));
let _e1412 = select(128f, _e1410, (_e1410 < 128f));
let _e1419 = select(0i, select(select(i32(_e1412), i32(-2147483648), (_e1412 < -2147483600f)), 2147483647i, (_e1412 > 2147483500f)), (_e1412 == _e1412));
let _e1423 = (_e1419 - select(0i, 1i, (_e1412 < f32(_e1419))));
let _e1424 = f32(_e1423);
let _e1428 = ((_e1406 - (_e1424 * 0.6933594f)) - (_e1424 * -2.1219444e-4f));
let _e1448 = ((1f + (_e1428 * (1f + (_e1428 * (0.5f + (_e1428 * (0.16666667f + (_e1428 * (0.041666668f + (_e1428 * (0.008333334f + (_e1428 * (0.001388889f + (_e1428 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1423 + 127i)) << bitcast<u32>(23i))));
let _e1450 = -((_e1349.member_2 * _e1345));
let _e1452 = select(-87f, _e1450, (_e1450 > -87f));
let _e1454 = select(88f, _e1452, (_e1452 < 88f));
let _e1456 = ((_e1454 * 1.442695f) + 0.5f);
let _e1458 = select(-127f, _e1456, (_e1456 > -127f));
let _e1460 = select(128f, _e1458, (_e1458 < 128f));
let _e1467 = select(0i, select(select(i32(_e1460), i32(-2147483648), (_e1460 < -2147483600f)), 2147483647i, (_e1460 > 2147483500f)), (_e1460 == _e1460));
let _e1471 = (_e1467 - select(0i, 1i, (_e1460 < f32(_e1467))));
let _e1472 = f32(_e1471);
let _e1476 = ((_e1454 - (_e1472 * 0.6933594f)) - (_e1472 * -2.1219444e-4f));
let _e1496 = ((1f + (_e1476 * (1f + (_e1476 * (0.5f + (_e1476 * (0.16666667f + (_e1476 * (0.041666668f + (_e1476 * (0.008333334f + (_e1476 * (0.001388889f + (_e1476 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1471 + 127i)) << bitcast<u32>(23i))));
let _e1499 = global_1.member.member_17;
let _e1504 = (1f / 3f);
if (((_e1499 & 2u) != 0u) && ((((_e768 + _e769) + _e770) * _e1504) >= 0.01f)) {
let _e1512 = global_1.member.member_10.member;
if (_e1512 == 2u) {
let _e1517 = global_1.member.member_10.member_1;
let _e1524 = global_1.member.member_10.member_3;
let _e1528 = (_e763 - _e1524.member);
let _e1529 = (_e764 - _e1524.member_1);
let _e1530 = (_e765 - _e1524.member_2);
let _e1535 = global_1.member.member_10.member_4.member_2;
let _e1537 = (1f + (_e1535 * _e1535));
let _e1542 = (((_e1517.member * _e1528) + (_e1517.member_1 * _e1529)) + (_e1517.member_2 * _e1530));
let _e1547 = (((_e1517.member * _e512) + (_e1517.member_1 * _e523)) + (_e1517.member_2 * _e534));
let _e1548 = (_e1537 * _e1547);
let _e1550 = ((_e1548 * _e1547) - 1f);
let _e1557 = ((_e1548 * _e1542) - (((_e1528 * _e512) + (_e1529 * _e523)) + (_e1530 * _e534)));
let _e1568 = ((_e1557 * _e1557) - (_e1550 * (((_e1537 * _e1542) * _e1542) - (((_e1528 * _e1528) + (_e1529 * _e1529)) + (_e1530 * _e1530)))));
let _e1569 = (_e1568 > 0f);
let _e1571 = sqrt(select(0f, _e1568, _e1569));
let _e1574 = (1f / select(_e1550, 1e-20f, (_e1550 == 0f)));
let _e1575 = -(_e1557);
let _e1577 = ((_e1575 - _e1571) * _e1574);
let _e1579 = ((_e1575 + _e1571) * _e1574);
let _e1581 = select(_e1579, _e1577, (_e1577 < _e1579));
let _e1583 = select(_e1579, _e1577, (_e1577 > _e1579));
if (_e1550 < 0f) {
let _e1604 = (_e1569 && ((_e1542 + (_e1547 * (0.5f * (_e1581 + _e1583)))) > 0f));
let _e1605 = select(_e847, _e1581, _e1604);
let _e1608 = select(_e846, _e1583, _e1604);
phi_3096_ = type_27(select(_e1605, _e846, (_e846 > _e1605)), select(_e1608, _e847, (_e847 < _e1608)));
} else {
let _e1588 = (-(_e1542) / select(_e1547, 1e-20f, (_e1547 == 0f)));
let _e1591 = (_e1547 > 0f);
let _e1592 = select(_e846, select(_e1588, _e1583, _e1569), _e1591);
let _e1595 = select(select(_e1588, _e1581, _e1569), _e847, _e1591);
phi_3096_ = type_27(select(_e1592, _e846, (_e846 > _e1592)), select(_e1595, _e847, (_e847 < _e1595)));
}
let _e1613 = phi_3096_;
phi_3100_ = _e1613;
} else {
phi_3100_ = type_27(_e846, _e847);
}
let _e1615 = phi_3100_;
if (_e1615.member_1 > _e1615.member) {
let _e1622 = global_1.member.member_10.member_3;
let _e1626 = (_e1622.member - _e763);
let _e1627 = (_e1622.member_1 - _e764);
let _e1628 = (_e1622.member_2 - _e765);
let _e1633 = (((_e1626 * _e512) + (_e1627 * _e523)) + (_e1628 * _e534));
let _e1637 = (_e1626 - (_e512 * _e1633));
let _e1638 = (_e1627 - (_e523 * _e1633));
let _e1639 = (_e1628 - (_e534 * _e1633));
let _e1644 = (((_e1637 * _e1637) + (_e1638 * _e1638)) + (_e1639 * _e1639));
let _e1647 = sqrt(select(0f, _e1644, (_e1644 > 0f)));
let _e1649 = select(1e-6f, _e1647, (_e1647 > 1e-6f));
let _e1650 = (_e1512 == 0u);
let _e1652 = ((_e1615.member - _e1633) / _e1649);
let _e1654 = (1f + (_e1652 * _e1652));
let _e1660 = select((_e1652 / (1f + sqrt(select(0f, _e1654, (_e1654 > 0f))))), _e1615.member, _e1650);
let _e1662 = ((_e1615.member_1 - _e1633) / _e1649);
let _e1664 = (1f + (_e1662 * _e1662));
let _e1671 = bitcast<i32>(_e852);
if (12i < _e1671) {
phi_3214_ = (_e1671 / 2i);
} else {
phi_3214_ = 6i;
}
let _e1675 = phi_3214_;
let _e1679 = ((select((_e1662 / (1f + sqrt(select(0f, _e1664, (_e1664 > 0f))))), _e1615.member_1, _e1650) - _e1660) * (0.5f / f32(_e1675)));
let _e1681 = select(_e846, _e830, (_e830 > _e846));
let _e1683 = select(_e1615.member, _e840, (_e840 < _e1615.member));
let _e1684 = (_e1683 > _e1681);
let _e1685 = select(_e846, _e1681, _e1684);
let _e1687 = (select(_e846, _e1683, _e1684) - _e1685);
if _e853 {
phi_4079_ = _e1687;
} else {
let _e1689 = (_e1687 / f32(_e852));
phi_3366_ = 0u;
phi_3369_ = 0f;
loop {
let _e1691 = phi_3366_;
let _e1693 = phi_3369_;
local_76 = _e1693;
let _e1696 = ((_e1691 < _e852) && (_e1687 > 0f));
if _e1696 {
let _e1699 = (_e1685 + (_e1689 * f32(_e1691)));
let _e1700 = (_e1699 + _e1689);
let _e1702 = (0.5f * (_e1699 + _e1700));
let _e1703 = (_e1700 - _e1699);
let _e1704 = (0.28867513f * _e1703);
let _e1705 = (_e1702 - _e1704);
let _e1715 = global_1.member.member_13.member_7;
let _e1716 = bitcast<i32>(_e1715);
let _e1720 = global_1.member.member_13.member_8;
let _e1721 = bitcast<i32>(_e1720);
let _e1725 = global_1.member.member_13.member_9;
let _e1726 = bitcast<i32>(_e1725);
let _e1727 = f32(_e1716);
let _e1729 = (_e805.member - _e798.member);
let _e1732 = (((((_e763 + (_e512 * _e1705)) - _e798.member) / _e1729) * _e1727) - 0.5f);
let _e1733 = (_e1727 - 1f);
let _e1735 = select(0f, _e1732, (_e1732 > 0f));
let _e1737 = select(_e1733, _e1735, (_e1735 < _e1733));
let _e1738 = f32(_e1721);
let _e1740 = (_e805.member_1 - _e798.member_1);
let _e1743 = (((((_e764 + (_e523 * _e1705)) - _e798.member_1) / _e1740) * _e1738) - 0.5f);
let _e1744 = (_e1738 - 1f);
let _e1746 = select(0f, _e1743, (_e1743 > 0f));
let _e1748 = select(_e1744, _e1746, (_e1746 < _e1744));
let _e1749 = f32(_e1726);
let _e1751 = (_e805.member_2 - _e798.member_2);
let _e1754 = (((((_e765 + (_e534 * _e1705)) - _e798.member_2) / _e1751) * _e1749) - 0.5f);
let _e1755 = (_e1749 - 1f);
let _e1757 = select(0f, _e1754, (_e1754 > 0f));
let _e1759 = select(_e1755, _e1757, (_e1757 < _e1755));
let _e1761 = select(0f, _e1737, (_e1737 > 0f));
let _e1763 = select(1e6f, _e1761, (_e1761 < 1e6f));
let _e1770 = select(0i, select(select(i32(_e1763), i32(-2147483648), (_e1763 < -2147483600f)), 2147483647i, (_e1763 > 2147483500f)), (_e1763 == _e1763));
let _e1774 = (_e1770 - select(0i, 1i, (_e1763 < f32(_e1770))));
let _e1776 = select(0f, _e1748, (_e1748 > 0f));
let _e1778 = select(1e6f, _e1776, (_e1776 < 1e6f));
let _e1785 = select(0i, select(select(i32(_e1778), i32(-2147483648), (_e1778 < -2147483600f)), 2147483647i, (_e1778 > 2147483500f)), (_e1778 == _e1778));
let _e1789 = (_e1785 - select(0i, 1i, (_e1778 < f32(_e1785))));
let _e1791 = select(0f, _e1759, (_e1759 > 0f));
let _e1793 = select(1e6f, _e1791, (_e1791 < 1e6f));
let _e1800 = select(0i, select(select(i32(_e1793), i32(-2147483648), (_e1793 < -2147483600f)), 2147483647i, (_e1793 > 2147483500f)), (_e1793 == _e1793));
let _e1804 = (_e1800 - select(0i, 1i, (_e1793 < f32(_e1800))));
let _e1808 = (_e1748 - f32(_e1789));
let _e1810 = (_e1759 - f32(_e1804));
local_35 = (_e1737 - f32(_e1774));
let _e1811 = (_e1774 + 1i);
let _e1813 = select(_e1811, 0i, (_e1811 < 0i));
if (_e1813 >= _e1716) {
phi_3504_ = (_e1716 - 1i);
} else {
phi_3504_ = _e1813;
}
let _e1817 = phi_3504_;
local_36 = (_e1817 - _e1774);
let _e1819 = (_e1789 + 1i);
let _e1821 = select(_e1819, 0i, (_e1819 < 0i));
if (_e1821 >= _e1721) {
phi_3517_ = (_e1721 - 1i);
} else {
phi_3517_ = _e1821;
}
let _e1825 = phi_3517_;
let _e1827 = ((_e1825 - _e1789) * _e1716);
let _e1828 = (_e1804 + 1i);
let _e1830 = select(_e1828, 0i, (_e1828 < 0i));
if (_e1830 >= _e1726) {
phi_3531_ = (_e1726 - 1i);
} else {
phi_3531_ = _e1830;
}
let _e1834 = phi_3531_;
let _e1841 = global_1.member.member_13.member_10;
let _e1842 = bitcast<i32>(_e1841);
let _e1847 = ((_e1842 + (((_e1804 * _e1721) + _e1789) * _e1716)) + _e1774);
let _e1849 = (bitcast<i32>(_e187) - 1i);
let _e1851 = select(_e1849, _e1847, (_e1847 < _e1849));
let _e1856 = global_7.member[bitcast<u32>(select(0i, _e1851, (_e1851 > 0i)))];
let _e1857 = local_35;
let _e1860 = local_36;
let _e1861 = (_e1847 + _e1860);
let _e1863 = select(_e1849, _e1861, (_e1861 < _e1849));
let _e1868 = global_7.member[bitcast<u32>(select(0i, _e1863, (_e1863 > 0i)))];
let _e1869 = local_35;
let _e1872 = (1f - _e1808);
let _e1874 = (_e1847 + _e1827);
let _e1876 = select(_e1849, _e1874, (_e1874 < _e1849));
let _e1881 = global_7.member[bitcast<u32>(select(0i, _e1876, (_e1876 > 0i)))];
let _e1882 = local_35;
let _e1885 = local_36;
let _e1886 = (_e1874 + _e1885);
let _e1888 = select(_e1849, _e1886, (_e1886 < _e1849));
let _e1893 = global_7.member[bitcast<u32>(select(0i, _e1888, (_e1888 > 0i)))];
let _e1894 = local_35;
let _e1899 = (_e1847 + (((_e1834 - _e1804) * _e1716) * _e1721));
let _e1901 = select(_e1849, _e1899, (_e1899 < _e1849));
let _e1906 = global_7.member[bitcast<u32>(select(0i, _e1901, (_e1901 > 0i)))];
let _e1907 = local_35;
let _e1910 = local_36;
let _e1911 = (_e1899 + _e1910);
let _e1913 = select(_e1849, _e1911, (_e1911 < _e1849));
let _e1918 = global_7.member[bitcast<u32>(select(0i, _e1913, (_e1913 > 0i)))];
let _e1919 = local_35;
let _e1923 = (_e1899 + _e1827);
let _e1925 = select(_e1849, _e1923, (_e1923 < _e1849));
let _e1930 = global_7.member[bitcast<u32>(select(0i, _e1925, (_e1925 > 0i)))];
let _e1931 = local_35;
let _e1934 = local_36;
let _e1935 = (_e1923 + _e1934);
let _e1937 = select(_e1849, _e1935, (_e1935 < _e1849));
let _e1942 = global_7.member[bitcast<u32>(select(0i, _e1937, (_e1937 > 0i)))];
let _e1943 = local_35;
let _e1952 = (_e1702 + _e1704);
let _e1962 = (((((_e763 + (_e512 * _e1952)) - _e798.member) / _e1729) * _e1727) - 0.5f);
let _e1964 = select(0f, _e1962, (_e1962 > 0f));
let _e1966 = select(_e1733, _e1964, (_e1964 < _e1733));
let _e1970 = (((((_e764 + (_e523 * _e1952)) - _e798.member_1) / _e1740) * _e1738) - 0.5f);
let _e1972 = select(0f, _e1970, (_e1970 > 0f));
let _e1974 = select(_e1744, _e1972, (_e1972 < _e1744));
let _e1978 = (((((_e765 + (_e534 * _e1952)) - _e798.member_2) / _e1751) * _e1749) - 0.5f);
let _e1980 = select(0f, _e1978, (_e1978 > 0f));
let _e1982 = select(_e1755, _e1980, (_e1980 < _e1755));
let _e1984 = select(0f, _e1966, (_e1966 > 0f));
let _e1986 = select(1e6f, _e1984, (_e1984 < 1e6f));
let _e1993 = select(0i, select(select(i32(_e1986), i32(-2147483648), (_e1986 < -2147483600f)), 2147483647i, (_e1986 > 2147483500f)), (_e1986 == _e1986));
let _e1997 = (_e1993 - select(0i, 1i, (_e1986 < f32(_e1993))));
let _e1999 = select(0f, _e1974, (_e1974 > 0f));
let _e2001 = select(1e6f, _e1999, (_e1999 < 1e6f));
let _e2008 = select(0i, select(select(i32(_e2001), i32(-2147483648), (_e2001 < -2147483600f)), 2147483647i, (_e2001 > 2147483500f)), (_e2001 == _e2001));
let _e2012 = (_e2008 - select(0i, 1i, (_e2001 < f32(_e2008))));
let _e2014 = select(0f, _e1982, (_e1982 > 0f));
let _e2016 = select(1e6f, _e2014, (_e2014 < 1e6f));
let _e2023 = select(0i, select(select(i32(_e2016), i32(-2147483648), (_e2016 < -2147483600f)), 2147483647i, (_e2016 > 2147483500f)), (_e2016 == _e2016));
let _e2027 = (_e2023 - select(0i, 1i, (_e2016 < f32(_e2023))));
let _e2031 = (_e1974 - f32(_e2012));
let _e2033 = (_e1982 - f32(_e2027));
local_33 = (_e1966 - f32(_e1997));
let _e2034 = (_e1997 + 1i);
let _e2036 = select(_e2034, 0i, (_e2034 < 0i));
if (_e2036 >= _e1716) {
phi_3847_ = (_e1716 - 1i);
} else {
phi_3847_ = _e2036;
}
let _e2040 = phi_3847_;
local_34 = (_e2040 - _e1997);
let _e2042 = (_e2012 + 1i);
let _e2044 = select(_e2042, 0i, (_e2042 < 0i));
if (_e2044 >= _e1721) {
phi_3860_ = (_e1721 - 1i);
} else {
phi_3860_ = _e2044;
}
let _e2048 = phi_3860_;
let _e2050 = ((_e2048 - _e2012) * _e1716);
let _e2051 = (_e2027 + 1i);
let _e2053 = select(_e2051, 0i, (_e2051 < 0i));
if (_e2053 >= _e1726) {
phi_3874_ = (_e1726 - 1i);
} else {
phi_3874_ = _e2053;
}
let _e2057 = phi_3874_;
let _e2065 = ((_e1842 + (((_e2027 * _e1721) + _e2012) * _e1716)) + _e1997);
let _e2067 = select(_e1849, _e2065, (_e2065 < _e1849));
let _e2072 = global_7.member[bitcast<u32>(select(0i, _e2067, (_e2067 > 0i)))];
let _e2073 = local_33;
let _e2076 = local_34;
let _e2077 = (_e2065 + _e2076);
let _e2079 = select(_e1849, _e2077, (_e2077 < _e1849));
let _e2084 = global_7.member[bitcast<u32>(select(0i, _e2079, (_e2079 > 0i)))];
let _e2085 = local_33;
let _e2088 = (1f - _e2031);
let _e2090 = (_e2065 + _e2050);
let _e2092 = select(_e1849, _e2090, (_e2090 < _e1849));
let _e2097 = global_7.member[bitcast<u32>(select(0i, _e2092, (_e2092 > 0i)))];
let _e2098 = local_33;
let _e2101 = local_34;
let _e2102 = (_e2090 + _e2101);
let _e2104 = select(_e1849, _e2102, (_e2102 < _e1849));
let _e2109 = global_7.member[bitcast<u32>(select(0i, _e2104, (_e2104 > 0i)))];
let _e2110 = local_33;
let _e2115 = (_e2065 + (((_e2057 - _e2027) * _e1716) * _e1721));
let _e2117 = select(_e1849, _e2115, (_e2115 < _e1849));
let _e2122 = global_7.member[bitcast<u32>(select(0i, _e2117, (_e2117 > 0i)))];
let _e2123 = local_33;
let _e2126 = local_34;
let _e2127 = (_e2115 + _e2126);
let _e2129 = select(_e1849, _e2127, (_e2127 < _e1849));
let _e2134 = global_7.member[bitcast<u32>(select(0i, _e2129, (_e2129 > 0i)))];
let _e2135 = local_33;
let _e2139 = (_e2115 + _e2050);
let _e2141 = select(_e1849, _e2139, (_e2139 < _e1849));
let _e2146 = global_7.member[bitcast<u32>(select(0i, _e2141, (_e2141 > 0i)))];
let _e2147 = local_33;
let _e2150 = local_34;
let _e2151 = (_e2139 + _e2150);
let _e2153 = select(_e1849, _e2151, (_e2151 < _e1849));
let _e2158 = global_7.member[bitcast<u32>(select(0i, _e2153, (_e2153 > 0i)))];
let _e2159 = local_33;
phi_3367_ = (_e1691 + 1u);
phi_3370_ = (_e1693 + ((0.5f * (((((((_e1856 * (1f - _e1857)) + (_e1868 * _e1869)) * _e1872) + (((_e1881 * (1f - _e1882)) + (_e1893 * _e1894)) * _e1808)) * (1f - _e1810)) + (((((_e1906 * (1f - _e1907)) + (_e1918 * _e1919)) * _e1872) + (((_e1930 * (1f - _e1931)) + (_e1942 * _e1943)) * _e1808)) * _e1810)) + ((((((_e2072 * (1f - _e2073)) + (_e2084 * _e2085)) * _e2088) + (((_e2097 * (1f - _e2098)) + (_e2109 * _e2110)) * _e2031)) * (1f - _e2033)) + (((((_e2122 * (1f - _e2123)) + (_e2134 * _e2135)) * _e2088) + (((_e2146 * (1f - _e2147)) + (_e2158 * _e2159)) * _e2031)) * _e2033)))) * _e1703));
} else {
phi_3367_ = u32();
phi_3370_ = f32();
}
let _e2174 = phi_3367_;
let _e2176 = phi_3370_;
continue;
continuing {
phi_3366_ = _e2174;
phi_3369_ = _e2176;
break if !(_e1696);
}
}
let _e11105 = local_76;
phi_4079_ = _e11105;
}
let _e2179 = phi_4079_;
phi_4081_ = _e2179;
phi_4084_ = vec3<f32>(0f, 0f, 0f);
phi_4086_ = 0i;
loop {
let _e2181 = phi_4081_;
let _e2183 = phi_4084_;
let _e2185 = phi_4086_;
local_81 = _e2183;
let _e2186 = (_e2185 < _e1675);
if _e2186 {
let _e2191 = (_e1660 + (_e1679 * ((2f * f32(_e2185)) + 1f)));
let _e2192 = -(0.8611363f);
let _e2194 = (_e2191 + (_e1679 * _e2192));
let _e2195 = (_e2194 * _e2194);
let _e2196 = (1f - _e2195);
let _e2198 = select(1e-9f, _e2196, (_e2196 > 1e-9f));
let _e2208 = select((_e1633 + (_e1649 * ((2f * _e2194) / _e2198))), _e2194, _e1650);
let _e2209 = select((_e1649 * ((2f * (1f + _e2195)) / (_e2198 * _e2198))), 1f, _e1650);
let _e2210 = (_e512 * _e2208);
let _e2211 = (_e523 * _e2208);
let _e2212 = (_e534 * _e2208);
let _e2217 = (_e766 + vec3<f32>(_e2210, _e2211, _e2212));
let _e2220 = global_1.member.member_13.member_6;
let _e2221 = (_e2220 == 0u);
if _e2221 {
phi_4487_ = 1f;
} else {
let _e2224 = global_1.member.member_13.member_7;
let _e2225 = bitcast<i32>(_e2224);
let _e2228 = global_1.member.member_13.member_8;
let _e2229 = bitcast<i32>(_e2228);
let _e2232 = global_1.member.member_13.member_9;
let _e2233 = bitcast<i32>(_e2232);
let _e2236 = global_1.member.member_13.member_4;
let _e2242 = global_1.member.member_13.member_5;
let _e2246 = f32(_e2225);
let _e2251 = (((((_e763 + _e2210) - _e2236.member) / (_e2242.member - _e2236.member)) * _e2246) - 0.5f);
let _e2252 = (_e2246 - 1f);
let _e2254 = select(0f, _e2251, (_e2251 > 0f));
let _e2256 = select(_e2252, _e2254, (_e2254 < _e2252));
let _e2257 = f32(_e2229);
let _e2262 = (((((_e764 + _e2211) - _e2236.member_1) / (_e2242.member_1 - _e2236.member_1)) * _e2257) - 0.5f);
let _e2263 = (_e2257 - 1f);
let _e2265 = select(0f, _e2262, (_e2262 > 0f));
let _e2267 = select(_e2263, _e2265, (_e2265 < _e2263));
let _e2268 = f32(_e2233);
let _e2273 = (((((_e765 + _e2212) - _e2236.member_2) / (_e2242.member_2 - _e2236.member_2)) * _e2268) - 0.5f);
let _e2274 = (_e2268 - 1f);
let _e2276 = select(0f, _e2273, (_e2273 > 0f));
let _e2278 = select(_e2274, _e2276, (_e2276 < _e2274));
let _e2280 = select(0f, _e2256, (_e2256 > 0f));
let _e2282 = select(1e6f, _e2280, (_e2280 < 1e6f));
let _e2289 = select(0i, select(select(i32(_e2282), i32(-2147483648), (_e2282 < -2147483600f)), 2147483647i, (_e2282 > 2147483500f)), (_e2282 == _e2282));
let _e2293 = (_e2289 - select(0i, 1i, (_e2282 < f32(_e2289))));
let _e2295 = select(0f, _e2267, (_e2267 > 0f));
let _e2297 = select(1e6f, _e2295, (_e2295 < 1e6f));
let _e2304 = select(0i, select(select(i32(_e2297), i32(-2147483648), (_e2297 < -2147483600f)), 2147483647i, (_e2297 > 2147483500f)), (_e2297 == _e2297));
let _e2308 = (_e2304 - select(0i, 1i, (_e2297 < f32(_e2304))));
let _e2310 = select(0f, _e2278, (_e2278 > 0f));
let _e2312 = select(1e6f, _e2310, (_e2310 < 1e6f));
let _e2319 = select(0i, select(select(i32(_e2312), i32(-2147483648), (_e2312 < -2147483600f)), 2147483647i, (_e2312 > 2147483500f)), (_e2312 == _e2312));
let _e2323 = (_e2319 - select(0i, 1i, (_e2312 < f32(_e2319))));
let _e2327 = (_e2267 - f32(_e2308));
let _e2329 = (_e2278 - f32(_e2323));
local_31 = (_e2256 - f32(_e2293));
let _e2330 = (_e2293 + 1i);
let _e2332 = select(_e2330, 0i, (_e2330 < 0i));
if (_e2332 >= _e2225) {
phi_4260_ = (_e2225 - 1i);
} else {
phi_4260_ = _e2332;
}
let _e2336 = phi_4260_;
local_32 = (_e2336 - _e2293);
let _e2338 = (_e2308 + 1i);
let _e2340 = select(_e2338, 0i, (_e2338 < 0i));
if (_e2340 >= _e2229) {
phi_4273_ = (_e2229 - 1i);
} else {
phi_4273_ = _e2340;
}
let _e2344 = phi_4273_;
let _e2346 = ((_e2344 - _e2308) * _e2225);
let _e2347 = (_e2323 + 1i);
let _e2349 = select(_e2347, 0i, (_e2347 < 0i));
if (_e2349 >= _e2233) {
phi_4287_ = (_e2233 - 1i);
} else {
phi_4287_ = _e2349;
}
let _e2353 = phi_4287_;
let _e2359 = global_1.member.member_13.member_10;
let _e2365 = ((bitcast<i32>(_e2359) + (((_e2323 * _e2229) + _e2308) * _e2225)) + _e2293);
let _e2367 = (bitcast<i32>(_e187) - 1i);
let _e2369 = select(_e2367, _e2365, (_e2365 < _e2367));
let _e2374 = global_7.member[bitcast<u32>(select(0i, _e2369, (_e2369 > 0i)))];
let _e2375 = local_31;
let _e2378 = local_32;
let _e2379 = (_e2365 + _e2378);
let _e2381 = select(_e2367, _e2379, (_e2379 < _e2367));
let _e2386 = global_7.member[bitcast<u32>(select(0i, _e2381, (_e2381 > 0i)))];
let _e2387 = local_31;
let _e2390 = (1f - _e2327);
let _e2392 = (_e2365 + _e2346);
let _e2394 = select(_e2367, _e2392, (_e2392 < _e2367));
let _e2399 = global_7.member[bitcast<u32>(select(0i, _e2394, (_e2394 > 0i)))];
let _e2400 = local_31;
let _e2403 = local_32;
let _e2404 = (_e2392 + _e2403);
let _e2406 = select(_e2367, _e2404, (_e2404 < _e2367));
let _e2411 = global_7.member[bitcast<u32>(select(0i, _e2406, (_e2406 > 0i)))];
let _e2412 = local_31;
let _e2417 = (_e2365 + (((_e2353 - _e2323) * _e2225) * _e2229));
let _e2419 = select(_e2367, _e2417, (_e2417 < _e2367));
let _e2424 = global_7.member[bitcast<u32>(select(0i, _e2419, (_e2419 > 0i)))];
let _e2425 = local_31;
let _e2428 = local_32;
let _e2429 = (_e2417 + _e2428);
let _e2431 = select(_e2367, _e2429, (_e2429 < _e2367));
let _e2436 = global_7.member[bitcast<u32>(select(0i, _e2431, (_e2431 > 0i)))];
let _e2437 = local_31;
let _e2441 = (_e2417 + _e2346);
let _e2443 = select(_e2367, _e2441, (_e2441 < _e2367));
let _e2448 = global_7.member[bitcast<u32>(select(0i, _e2443, (_e2443 > 0i)))];
let _e2449 = local_31;
let _e2452 = local_32;
let _e2453 = (_e2441 + _e2452);
let _e2455 = select(_e2367, _e2453, (_e2453 < _e2367));
let _e2460 = global_7.member[bitcast<u32>(select(0i, _e2455, (_e2455 > 0i)))];
let _e2461 = local_31;
phi_4487_ = ((((((_e2374 * (1f - _e2375)) + (_e2386 * _e2387)) * _e2390) + (((_e2399 * (1f - _e2400)) + (_e2411 * _e2412)) * _e2327)) * (1f - _e2329)) + (((((_e2424 * (1f - _e2425)) + (_e2436 * _e2437)) * _e2390) + (((_e2448 * (1f - _e2449)) + (_e2460 * _e2461)) * _e2327)) * _e2329));
}
let _e2471 = phi_4487_;
let _e2472 = -(0.33998105f);
let _e2474 = (_e2191 + (_e1679 * _e2472));
let _e2475 = (_e2474 * _e2474);
let _e2476 = (1f - _e2475);
let _e2478 = select(1e-9f, _e2476, (_e2476 > 1e-9f));
let _e2488 = select((_e1633 + (_e1649 * ((2f * _e2474) / _e2478))), _e2474, _e1650);
let _e2489 = select((_e1649 * ((2f * (1f + _e2475)) / (_e2478 * _e2478))), 1f, _e1650);
let _e2490 = (_e512 * _e2488);
let _e2491 = (_e523 * _e2488);
let _e2492 = (_e534 * _e2488);
let _e2497 = (_e766 + vec3<f32>(_e2490, _e2491, _e2492));
if _e2221 {
phi_4877_ = 1f;
} else {
let _e2500 = global_1.member.member_13.member_7;
let _e2501 = bitcast<i32>(_e2500);
let _e2504 = global_1.member.member_13.member_8;
let _e2505 = bitcast<i32>(_e2504);
let _e2508 = global_1.member.member_13.member_9;
let _e2509 = bitcast<i32>(_e2508);
let _e2512 = global_1.member.member_13.member_4;
let _e2518 = global_1.member.member_13.member_5;
let _e2522 = f32(_e2501);
let _e2527 = (((((_e763 + _e2490) - _e2512.member) / (_e2518.member - _e2512.member)) * _e2522) - 0.5f);
let _e2528 = (_e2522 - 1f);
let _e2530 = select(0f, _e2527, (_e2527 > 0f));
let _e2532 = select(_e2528, _e2530, (_e2530 < _e2528));
let _e2533 = f32(_e2505);
let _e2538 = (((((_e764 + _e2491) - _e2512.member_1) / (_e2518.member_1 - _e2512.member_1)) * _e2533) - 0.5f);
let _e2539 = (_e2533 - 1f);
let _e2541 = select(0f, _e2538, (_e2538 > 0f));
let _e2543 = select(_e2539, _e2541, (_e2541 < _e2539));
let _e2544 = f32(_e2509);
let _e2549 = (((((_e765 + _e2492) - _e2512.member_2) / (_e2518.member_2 - _e2512.member_2)) * _e2544) - 0.5f);
let _e2550 = (_e2544 - 1f);
let _e2552 = select(0f, _e2549, (_e2549 > 0f));
let _e2554 = select(_e2550, _e2552, (_e2552 < _e2550));
let _e2556 = select(0f, _e2532, (_e2532 > 0f));
let _e2558 = select(1e6f, _e2556, (_e2556 < 1e6f));
let _e2565 = select(0i, select(select(i32(_e2558), i32(-2147483648), (_e2558 < -2147483600f)), 2147483647i, (_e2558 > 2147483500f)), (_e2558 == _e2558));
let _e2569 = (_e2565 - select(0i, 1i, (_e2558 < f32(_e2565))));
let _e2571 = select(0f, _e2543, (_e2543 > 0f));
let _e2573 = select(1e6f, _e2571, (_e2571 < 1e6f));
let _e2580 = select(0i, select(select(i32(_e2573), i32(-2147483648), (_e2573 < -2147483600f)), 2147483647i, (_e2573 > 2147483500f)), (_e2573 == _e2573));
let _e2584 = (_e2580 - select(0i, 1i, (_e2573 < f32(_e2580))));
let _e2586 = select(0f, _e2554, (_e2554 > 0f));
let _e2588 = select(1e6f, _e2586, (_e2586 < 1e6f));
let _e2595 = select(0i, select(select(i32(_e2588), i32(-2147483648), (_e2588 < -2147483600f)), 2147483647i, (_e2588 > 2147483500f)), (_e2588 == _e2588));
let _e2599 = (_e2595 - select(0i, 1i, (_e2588 < f32(_e2595))));
let _e2603 = (_e2543 - f32(_e2584));
let _e2605 = (_e2554 - f32(_e2599));
local_29 = (_e2532 - f32(_e2569));
let _e2606 = (_e2569 + 1i);
let _e2608 = select(_e2606, 0i, (_e2606 < 0i));
if (_e2608 >= _e2501) {
phi_4650_ = (_e2501 - 1i);
} else {
phi_4650_ = _e2608;
}
let _e2612 = phi_4650_;
local_30 = (_e2612 - _e2569);
let _e2614 = (_e2584 + 1i);
let _e2616 = select(_e2614, 0i, (_e2614 < 0i));
if (_e2616 >= _e2505) {
phi_4663_ = (_e2505 - 1i);
} else {
phi_4663_ = _e2616;
}
let _e2620 = phi_4663_;
let _e2622 = ((_e2620 - _e2584) * _e2501);
let _e2623 = (_e2599 + 1i);
let _e2625 = select(_e2623, 0i, (_e2623 < 0i));
if (_e2625 >= _e2509) {
phi_4677_ = (_e2509 - 1i);
} else {
phi_4677_ = _e2625;
}
let _e2629 = phi_4677_;
let _e2635 = global_1.member.member_13.member_10;
let _e2641 = ((bitcast<i32>(_e2635) + (((_e2599 * _e2505) + _e2584) * _e2501)) + _e2569);
let _e2643 = (bitcast<i32>(_e187) - 1i);
let _e2645 = select(_e2643, _e2641, (_e2641 < _e2643));
let _e2650 = global_7.member[bitcast<u32>(select(0i, _e2645, (_e2645 > 0i)))];
let _e2651 = local_29;
let _e2654 = local_30;
let _e2655 = (_e2641 + _e2654);
let _e2657 = select(_e2643, _e2655, (_e2655 < _e2643));
let _e2662 = global_7.member[bitcast<u32>(select(0i, _e2657, (_e2657 > 0i)))];
let _e2663 = local_29;
let _e2666 = (1f - _e2603);
let _e2668 = (_e2641 + _e2622);
let _e2670 = select(_e2643, _e2668, (_e2668 < _e2643));
let _e2675 = global_7.member[bitcast<u32>(select(0i, _e2670, (_e2670 > 0i)))];
let _e2676 = local_29;
let _e2679 = local_30;
let _e2680 = (_e2668 + _e2679);
let _e2682 = select(_e2643, _e2680, (_e2680 < _e2643));
let _e2687 = global_7.member[bitcast<u32>(select(0i, _e2682, (_e2682 > 0i)))];
let _e2688 = local_29;
let _e2693 = (_e2641 + (((_e2629 - _e2599) * _e2501) * _e2505));
let _e2695 = select(_e2643, _e2693, (_e2693 < _e2643));
let _e2700 = global_7.member[bitcast<u32>(select(0i, _e2695, (_e2695 > 0i)))];
let _e2701 = local_29;
let _e2704 = local_30;
let _e2705 = (_e2693 + _e2704);
let _e2707 = select(_e2643, _e2705, (_e2705 < _e2643));
let _e2712 = global_7.member[bitcast<u32>(select(0i, _e2707, (_e2707 > 0i)))];
let _e2713 = local_29;
let _e2717 = (_e2693 + _e2622);
let _e2719 = select(_e2643, _e2717, (_e2717 < _e2643));
let _e2724 = global_7.member[bitcast<u32>(select(0i, _e2719, (_e2719 > 0i)))];
let _e2725 = local_29;
let _e2728 = local_30;
let _e2729 = (_e2717 + _e2728);
let _e2731 = select(_e2643, _e2729, (_e2729 < _e2643));
let _e2736 = global_7.member[bitcast<u32>(select(0i, _e2731, (_e2731 > 0i)))];
let _e2737 = local_29;
phi_4877_ = ((((((_e2650 * (1f - _e2651)) + (_e2662 * _e2663)) * _e2666) + (((_e2675 * (1f - _e2676)) + (_e2687 * _e2688)) * _e2603)) * (1f - _e2605)) + (((((_e2700 * (1f - _e2701)) + (_e2712 * _e2713)) * _e2666) + (((_e2724 * (1f - _e2725)) + (_e2736 * _e2737)) * _e2603)) * _e2605));
}
let _e2747 = phi_4877_;
let _e2749 = (_e2191 + (_e1679 * 0.33998105f));
let _e2750 = (_e2749 * _e2749);
let _e2751 = (1f - _e2750);
let _e2753 = select(1e-9f, _e2751, (_e2751 > 1e-9f));
let _e2763 = select((_e1633 + (_e1649 * ((2f * _e2749) / _e2753))), _e2749, _e1650);
let _e2764 = select((_e1649 * ((2f * (1f + _e2750)) / (_e2753 * _e2753))), 1f, _e1650);
let _e2765 = (_e512 * _e2763);
let _e2766 = (_e523 * _e2763);
let _e2767 = (_e534 * _e2763);
let _e2772 = (_e766 + vec3<f32>(_e2765, _e2766, _e2767));
if _e2221 {
phi_5266_ = 1f;
} else {
let _e2775 = global_1.member.member_13.member_7;
let _e2776 = bitcast<i32>(_e2775);
let _e2779 = global_1.member.member_13.member_8;
let _e2780 = bitcast<i32>(_e2779);
let _e2783 = global_1.member.member_13.member_9;
let _e2784 = bitcast<i32>(_e2783);
let _e2787 = global_1.member.member_13.member_4;
let _e2793 = global_1.member.member_13.member_5;
let _e2797 = f32(_e2776);
let _e2802 = (((((_e763 + _e2765) - _e2787.member) / (_e2793.member - _e2787.member)) * _e2797) - 0.5f);
let _e2803 = (_e2797 - 1f);
let _e2805 = select(0f, _e2802, (_e2802 > 0f));
let _e2807 = select(_e2803, _e2805, (_e2805 < _e2803));
let _e2808 = f32(_e2780);
let _e2813 = (((((_e764 + _e2766) - _e2787.member_1) / (_e2793.member_1 - _e2787.member_1)) * _e2808) - 0.5f);
let _e2814 = (_e2808 - 1f);
let _e2816 = select(0f, _e2813, (_e2813 > 0f));
let _e2818 = select(_e2814, _e2816, (_e2816 < _e2814));
let _e2819 = f32(_e2784);
let _e2824 = (((((_e765 + _e2767) - _e2787.member_2) / (_e2793.member_2 - _e2787.member_2)) * _e2819) - 0.5f);
let _e2825 = (_e2819 - 1f);
let _e2827 = select(0f, _e2824, (_e2824 > 0f));
let _e2829 = select(_e2825, _e2827, (_e2827 < _e2825));
let _e2831 = select(0f, _e2807, (_e2807 > 0f));
let _e2833 = select(1e6f, _e2831, (_e2831 < 1e6f));
let _e2840 = select(0i, select(select(i32(_e2833), i32(-2147483648), (_e2833 < -2147483600f)), 2147483647i, (_e2833 > 2147483500f)), (_e2833 == _e2833));
let _e2844 = (_e2840 - select(0i, 1i, (_e2833 < f32(_e2840))));
let _e2846 = select(0f, _e2818, (_e2818 > 0f));
let _e2848 = select(1e6f, _e2846, (_e2846 < 1e6f));
let _e2855 = select(0i, select(select(i32(_e2848), i32(-2147483648), (_e2848 < -2147483600f)), 2147483647i, (_e2848 > 2147483500f)), (_e2848 == _e2848));
let _e2859 = (_e2855 - select(0i, 1i, (_e2848 < f32(_e2855))));
let _e2861 = select(0f, _e2829, (_e2829 > 0f));
let _e2863 = select(1e6f, _e2861, (_e2861 < 1e6f));
let _e2870 = select(0i, select(select(i32(_e2863), i32(-2147483648), (_e2863 < -2147483600f)), 2147483647i, (_e2863 > 2147483500f)), (_e2863 == _e2863));
let _e2874 = (_e2870 - select(0i, 1i, (_e2863 < f32(_e2870))));
let _e2878 = (_e2818 - f32(_e2859));
let _e2880 = (_e2829 - f32(_e2874));
local_27 = (_e2807 - f32(_e2844));
let _e2881 = (_e2844 + 1i);
let _e2883 = select(_e2881, 0i, (_e2881 < 0i));
if (_e2883 >= _e2776) {
phi_5039_ = (_e2776 - 1i);
} else {
phi_5039_ = _e2883;
}
let _e2887 = phi_5039_;
local_28 = (_e2887 - _e2844);
let _e2889 = (_e2859 + 1i);
let _e2891 = select(_e2889, 0i, (_e2889 < 0i));
if (_e2891 >= _e2780) {
phi_5052_ = (_e2780 - 1i);
} else {
phi_5052_ = _e2891;
}
let _e2895 = phi_5052_;
let _e2897 = ((_e2895 - _e2859) * _e2776);
let _e2898 = (_e2874 + 1i);
let _e2900 = select(_e2898, 0i, (_e2898 < 0i));
if (_e2900 >= _e2784) {
phi_5066_ = (_e2784 - 1i);
} else {
phi_5066_ = _e2900;
}
let _e2904 = phi_5066_;
let _e2910 = global_1.member.member_13.member_10;
let _e2916 = ((bitcast<i32>(_e2910) + (((_e2874 * _e2780) + _e2859) * _e2776)) + _e2844);
let _e2918 = (bitcast<i32>(_e187) - 1i);
let _e2920 = select(_e2918, _e2916, (_e2916 < _e2918));
let _e2925 = global_7.member[bitcast<u32>(select(0i, _e2920, (_e2920 > 0i)))];
let _e2926 = local_27;
let _e2929 = local_28;
let _e2930 = (_e2916 + _e2929);
let _e2932 = select(_e2918, _e2930, (_e2930 < _e2918));
let _e2937 = global_7.member[bitcast<u32>(select(0i, _e2932, (_e2932 > 0i)))];
let _e2938 = local_27;
let _e2941 = (1f - _e2878);
let _e2943 = (_e2916 + _e2897);
let _e2945 = select(_e2918, _e2943, (_e2943 < _e2918));
let _e2950 = global_7.member[bitcast<u32>(select(0i, _e2945, (_e2945 > 0i)))];
let _e2951 = local_27;
let _e2954 = local_28;
let _e2955 = (_e2943 + _e2954);
let _e2957 = select(_e2918, _e2955, (_e2955 < _e2918));
let _e2962 = global_7.member[bitcast<u32>(select(0i, _e2957, (_e2957 > 0i)))];
let _e2963 = local_27;
let _e2968 = (_e2916 + (((_e2904 - _e2874) * _e2776) * _e2780));
let _e2970 = select(_e2918, _e2968, (_e2968 < _e2918));
let _e2975 = global_7.member[bitcast<u32>(select(0i, _e2970, (_e2970 > 0i)))];
let _e2976 = local_27;
let _e2979 = local_28;
let _e2980 = (_e2968 + _e2979);
let _e2982 = select(_e2918, _e2980, (_e2980 < _e2918));
let _e2987 = global_7.member[bitcast<u32>(select(0i, _e2982, (_e2982 > 0i)))];
let _e2988 = local_27;
let _e2992 = (_e2968 + _e2897);
let _e2994 = select(_e2918, _e2992, (_e2992 < _e2918));
let _e2999 = global_7.member[bitcast<u32>(select(0i, _e2994, (_e2994 > 0i)))];
let _e3000 = local_27;
let _e3003 = local_28;
let _e3004 = (_e2992 + _e3003);
let _e3006 = select(_e2918, _e3004, (_e3004 < _e2918));
let _e3011 = global_7.member[bitcast<u32>(select(0i, _e3006, (_e3006 > 0i)))];
let _e3012 = local_27;
phi_5266_ = ((((((_e2925 * (1f - _e2926)) + (_e2937 * _e2938)) * _e2941) + (((_e2950 * (1f - _e2951)) + (_e2962 * _e2963)) * _e2878)) * (1f - _e2880)) + (((((_e2975 * (1f - _e2976)) + (_e2987 * _e2988)) * _e2941) + (((_e2999 * (1f - _e3000)) + (_e3011 * _e3012)) * _e2878)) * _e2880));
}
let _e3022 = phi_5266_;
let _e3024 = (_e2191 + (_e1679 * 0.8611363f));
let _e3025 = (_e3024 * _e3024);
let _e3026 = (1f - _e3025);
let _e3028 = select(1e-9f, _e3026, (_e3026 > 1e-9f));
let _e3038 = select((_e1633 + (_e1649 * ((2f * _e3024) / _e3028))), _e3024, _e1650);
let _e3039 = select((_e1649 * ((2f * (1f + _e3025)) / (_e3028 * _e3028))), 1f, _e1650);
let _e3040 = (_e512 * _e3038);
let _e3041 = (_e523 * _e3038);
let _e3042 = (_e534 * _e3038);
let _e3047 = (_e766 + vec3<f32>(_e3040, _e3041, _e3042));
if _e2221 {
phi_5655_ = 1f;
} else {
let _e3050 = global_1.member.member_13.member_7;
let _e3051 = bitcast<i32>(_e3050);
let _e3054 = global_1.member.member_13.member_8;
let _e3055 = bitcast<i32>(_e3054);
let _e3058 = global_1.member.member_13.member_9;
let _e3059 = bitcast<i32>(_e3058);
let _e3062 = global_1.member.member_13.member_4;
let _e3068 = global_1.member.member_13.member_5;
let _e3072 = f32(_e3051);
let _e3077 = (((((_e763 + _e3040) - _e3062.member) / (_e3068.member - _e3062.member)) * _e3072) - 0.5f);
let _e3078 = (_e3072 - 1f);
let _e3080 = select(0f, _e3077, (_e3077 > 0f));
let _e3082 = select(_e3078, _e3080, (_e3080 < _e3078));
let _e3083 = f32(_e3055);
let _e3088 = (((((_e764 + _e3041) - _e3062.member_1) / (_e3068.member_1 - _e3062.member_1)) * _e3083) - 0.5f);
let _e3089 = (_e3083 - 1f);
let _e3091 = select(0f, _e3088, (_e3088 > 0f));
let _e3093 = select(_e3089, _e3091, (_e3091 < _e3089));
let _e3094 = f32(_e3059);
let _e3099 = (((((_e765 + _e3042) - _e3062.member_2) / (_e3068.member_2 - _e3062.member_2)) * _e3094) - 0.5f);
let _e3100 = (_e3094 - 1f);
let _e3102 = select(0f, _e3099, (_e3099 > 0f));
let _e3104 = select(_e3100, _e3102, (_e3102 < _e3100));
let _e3106 = select(0f, _e3082, (_e3082 > 0f));
let _e3108 = select(1e6f, _e3106, (_e3106 < 1e6f));
let _e3115 = select(0i, select(select(i32(_e3108), i32(-2147483648), (_e3108 < -2147483600f)), 2147483647i, (_e3108 > 2147483500f)), (_e3108 == _e3108));
let _e3119 = (_e3115 - select(0i, 1i, (_e3108 < f32(_e3115))));
let _e3121 = select(0f, _e3093, (_e3093 > 0f));
let _e3123 = select(1e6f, _e3121, (_e3121 < 1e6f));
let _e3130 = select(0i, select(select(i32(_e3123), i32(-2147483648), (_e3123 < -2147483600f)), 2147483647i, (_e3123 > 2147483500f)), (_e3123 == _e3123));
let _e3134 = (_e3130 - select(0i, 1i, (_e3123 < f32(_e3130))));
let _e3136 = select(0f, _e3104, (_e3104 > 0f));
let _e3138 = select(1e6f, _e3136, (_e3136 < 1e6f));
let _e3145 = select(0i, select(select(i32(_e3138), i32(-2147483648), (_e3138 < -2147483600f)), 2147483647i, (_e3138 > 2147483500f)), (_e3138 == _e3138));
let _e3149 = (_e3145 - select(0i, 1i, (_e3138 < f32(_e3145))));
let _e3153 = (_e3093 - f32(_e3134));
let _e3155 = (_e3104 - f32(_e3149));
local_25 = (_e3082 - f32(_e3119));
let _e3156 = (_e3119 + 1i);
let _e3158 = select(_e3156, 0i, (_e3156 < 0i));
if (_e3158 >= _e3051) {
phi_5428_ = (_e3051 - 1i);
} else {
phi_5428_ = _e3158;
}
let _e3162 = phi_5428_;
local_26 = (_e3162 - _e3119);
let _e3164 = (_e3134 + 1i);
let _e3166 = select(_e3164, 0i, (_e3164 < 0i));
if (_e3166 >= _e3055) {
phi_5441_ = (_e3055 - 1i);
} else {
phi_5441_ = _e3166;
}
let _e3170 = phi_5441_;
let _e3172 = ((_e3170 - _e3134) * _e3051);
let _e3173 = (_e3149 + 1i);
let _e3175 = select(_e3173, 0i, (_e3173 < 0i));
if (_e3175 >= _e3059) {
phi_5455_ = (_e3059 - 1i);
} else {
phi_5455_ = _e3175;
}
let _e3179 = phi_5455_;
let _e3185 = global_1.member.member_13.member_10;
let _e3191 = ((bitcast<i32>(_e3185) + (((_e3149 * _e3055) + _e3134) * _e3051)) + _e3119);
let _e3193 = (bitcast<i32>(_e187) - 1i);
let _e3195 = select(_e3193, _e3191, (_e3191 < _e3193));
let _e3200 = global_7.member[bitcast<u32>(select(0i, _e3195, (_e3195 > 0i)))];
let _e3201 = local_25;
let _e3204 = local_26;
let _e3205 = (_e3191 + _e3204);
let _e3207 = select(_e3193, _e3205, (_e3205 < _e3193));
let _e3212 = global_7.member[bitcast<u32>(select(0i, _e3207, (_e3207 > 0i)))];
let _e3213 = local_25;
let _e3216 = (1f - _e3153);
let _e3218 = (_e3191 + _e3172);
let _e3220 = select(_e3193, _e3218, (_e3218 < _e3193));
let _e3225 = global_7.member[bitcast<u32>(select(0i, _e3220, (_e3220 > 0i)))];
let _e3226 = local_25;
let _e3229 = local_26;
let _e3230 = (_e3218 + _e3229);
let _e3232 = select(_e3193, _e3230, (_e3230 < _e3193));
let _e3237 = global_7.member[bitcast<u32>(select(0i, _e3232, (_e3232 > 0i)))];
let _e3238 = local_25;
let _e3243 = (_e3191 + (((_e3179 - _e3149) * _e3051) * _e3055));
let _e3245 = select(_e3193, _e3243, (_e3243 < _e3193));
let _e3250 = global_7.member[bitcast<u32>(select(0i, _e3245, (_e3245 > 0i)))];
let _e3251 = local_25;
let _e3254 = local_26;
let _e3255 = (_e3243 + _e3254);
let _e3257 = select(_e3193, _e3255, (_e3255 < _e3193));
let _e3262 = global_7.member[bitcast<u32>(select(0i, _e3257, (_e3257 > 0i)))];
let _e3263 = local_25;
let _e3267 = (_e3243 + _e3172);
let _e3269 = select(_e3193, _e3267, (_e3267 < _e3193));
let _e3274 = global_7.member[bitcast<u32>(select(0i, _e3269, (_e3269 > 0i)))];
let _e3275 = local_25;
let _e3278 = local_26;
let _e3279 = (_e3267 + _e3278);
let _e3281 = select(_e3193, _e3279, (_e3279 < _e3193));
let _e3286 = global_7.member[bitcast<u32>(select(0i, _e3281, (_e3281 > 0i)))];
let _e3287 = local_25;
phi_5655_ = ((((((_e3200 * (1f - _e3201)) + (_e3212 * _e3213)) * _e3216) + (((_e3225 * (1f - _e3226)) + (_e3237 * _e3238)) * _e3153)) * (1f - _e3155)) + (((((_e3250 * (1f - _e3251)) + (_e3262 * _e3263)) * _e3216) + (((_e3274 * (1f - _e3275)) + (_e3286 * _e3287)) * _e3153)) * _e3155));
}
let _e3297 = phi_5655_;
let _e3307 = (_e1679 * ((0.34785485f * ((_e2471 * _e2209) + (_e3297 * _e3039))) + (0.65214515f * ((_e2747 * _e2489) + (_e3022 * _e2764)))));
let _e3308 = (_e2208 - _e846);
let _e3318 = global_1.member.member_10.member_2;
let _e3322 = vec3<f32>(_e3318.member, _e3318.member_1, _e3318.member_2);
let _e3325 = global_1.member.member_10.member;
let _e3326 = (_e3325 == 0u);
if _e3326 {
let _e3664 = global_1.member.member_10.member_1;
phi_6232_ = type_26(vec3<f32>(_e3664.member, _e3664.member_1, _e3664.member_2), _e3322);
} else {
let _e3329 = global_1.member.member_10.member_3;
let _e3334 = (_e2217.x - _e3329.member);
let _e3336 = (_e2217.y - _e3329.member_1);
let _e3338 = (_e2217.z - _e3329.member_2);
let _e3343 = (((_e3334 * _e3334) + (_e3336 * _e3336)) + (_e3338 * _e3338));
let _e3345 = select(1e-12f, _e3343, (_e3343 > 1e-12f));
let _e3346 = (1f / _e3345);
let _e3350 = vec3<f32>((_e3318.member * _e3346), (_e3318.member_1 * _e3346), (_e3318.member_2 * _e3346));
if (_e3325 == 2u) {
let _e3354 = global_1.member.member_10.member_1;
let _e3362 = (((_e3354.member * _e3334) + (_e3354.member_1 * _e3336)) + (_e3354.member_2 * _e3338));
let _e3365 = (1f / select(1e-20f, _e3362, (_e3362 > 1e-20f)));
let _e3369 = global_1.member.member_10.member_4.member;
let _e3378 = ((((_e3369.member * _e3334) + (_e3369.member_1 * _e3336)) + (_e3369.member_2 * _e3338)) * _e3365);
let _e3382 = global_1.member.member_10.member_4.member_1;
let _e3391 = ((((_e3382.member * _e3334) + (_e3382.member_1 * _e3336)) + (_e3382.member_2 * _e3338)) * _e3365);
let _e3395 = global_1.member.member_10.member_4.member_2;
let _e3398 = ((_e3378 * _e3378) + (_e3391 * _e3391));
let _e3406 = global_1.member.member_10.member_4.member_3;
let _e3407 = ((_e3395 - sqrt(select(0f, _e3398, (_e3398 > 0f)))) * _e3406);
let _e3409 = select(0f, _e3407, (_e3407 > 0f));
let _e3411 = select(1f, _e3409, (_e3409 < 1f));
let _e3417 = select(0f, ((_e3411 * _e3411) * (3f - (2f * _e3411))), (_e3362 > 0f));
let _e3421 = global_1.member.member_10.member_4.member_5;
if ((_e3421 > 0u) && (_e3417 > 0f)) {
let _e3426 = (0.5f / _e3395);
let _e3435 = global_1.member.member_10.member_4.member_6;
let _e3436 = bitcast<i32>(_e3435);
local_24 = bitcast<i32>(_e3421);
let _e3437 = local_24;
let _e3439 = f32((_e3437 - 1i));
let _e3441 = f32((_e3436 - 1i));
let _e3442 = local_24;
let _e3445 = (((0.5f + (_e3378 * _e3426)) * f32(_e3442)) - 0.5f);
let _e3447 = select(0f, _e3445, (_e3445 > 0f));
let _e3449 = select(_e3439, _e3447, (_e3447 < _e3439));
let _e3452 = (((0.5f - (_e3391 * _e3426)) * f32(_e3436)) - 0.5f);
let _e3454 = select(0f, _e3452, (_e3452 > 0f));
let _e3456 = select(_e3441, _e3454, (_e3454 < _e3441));
let _e3458 = select(0f, _e3449, (_e3449 > 0f));
let _e3460 = select(_e3439, _e3458, (_e3458 < _e3439));
let _e3467 = select(0i, select(select(i32(_e3460), i32(-2147483648), (_e3460 < -2147483600f)), 2147483647i, (_e3460 > 2147483500f)), (_e3460 == _e3460));
let _e3471 = (_e3467 - select(0i, 1i, (_e3460 < f32(_e3467))));
let _e3473 = select(0f, _e3456, (_e3456 > 0f));
let _e3475 = select(_e3441, _e3473, (_e3473 < _e3441));
let _e3482 = select(0i, select(select(i32(_e3475), i32(-2147483648), (_e3475 < -2147483600f)), 2147483647i, (_e3475 > 2147483500f)), (_e3475 == _e3475));
let _e3486 = (_e3482 - select(0i, 1i, (_e3475 < f32(_e3482))));
let _e3488 = (_e3449 - f32(_e3471));
let _e3490 = (_e3456 - f32(_e3486));
let _e3491 = (_e3471 + 1i);
let _e3492 = local_24;
let _e3494 = select(_e3471, _e3491, (_e3491 < _e3492));
let _e3495 = (_e3486 + 1i);
let _e3497 = select(_e3486, _e3495, (_e3495 < _e3436));
let _e3501 = global_1.member.member_10.member_4.member_4;
let _e3502 = bitcast<i32>(_e3501);
let _e3503 = local_24;
let _e3507 = (_e3502 + (3i * ((_e3486 * _e3503) + _e3471)));
let _e3509 = (bitcast<i32>(_e180) - 1i);
let _e3511 = select(_e3509, _e3507, (_e3507 < _e3509));
let _e3516 = global_3.member[bitcast<u32>(select(0i, _e3511, (_e3511 > 0i)))];
let _e3517 = (_e3507 + 1i);
let _e3519 = select(_e3509, _e3517, (_e3517 < _e3509));
let _e3524 = global_3.member[bitcast<u32>(select(0i, _e3519, (_e3519 > 0i)))];
let _e3525 = (_e3507 + 2i);
let _e3527 = select(_e3509, _e3525, (_e3525 < _e3509));
let _e3532 = global_3.member[bitcast<u32>(select(0i, _e3527, (_e3527 > 0i)))];
let _e3533 = local_24;
let _e3537 = (_e3502 + (3i * ((_e3486 * _e3533) + _e3494)));
let _e3539 = select(_e3509, _e3537, (_e3537 < _e3509));
let _e3544 = global_3.member[bitcast<u32>(select(0i, _e3539, (_e3539 > 0i)))];
let _e3545 = (_e3537 + 1i);
let _e3547 = select(_e3509, _e3545, (_e3545 < _e3509));
let _e3552 = global_3.member[bitcast<u32>(select(0i, _e3547, (_e3547 > 0i)))];
let _e3553 = (_e3537 + 2i);
let _e3555 = select(_e3509, _e3553, (_e3553 < _e3509));
let _e3560 = global_3.member[bitcast<u32>(select(0i, _e3555, (_e3555 > 0i)))];
let _e3561 = local_24;
let _e3565 = (_e3502 + (3i * ((_e3497 * _e3561) + _e3471)));
let _e3567 = select(_e3509, _e3565, (_e3565 < _e3509));
let _e3572 = global_3.member[bitcast<u32>(select(0i, _e3567, (_e3567 > 0i)))];
let _e3573 = (_e3565 + 1i);
let _e3575 = select(_e3509, _e3573, (_e3573 < _e3509));
let _e3580 = global_3.member[bitcast<u32>(select(0i, _e3575, (_e3575 > 0i)))];
let _e3581 = (_e3565 + 2i);
let _e3583 = select(_e3509, _e3581, (_e3581 < _e3509));
let _e3588 = global_3.member[bitcast<u32>(select(0i, _e3583, (_e3583 > 0i)))];
let _e3589 = local_24;
let _e3593 = (_e3502 + (3i * ((_e3497 * _e3589) + _e3494)));
let _e3595 = select(_e3509, _e3593, (_e3593 < _e3509));
let _e3600 = global_3.member[bitcast<u32>(select(0i, _e3595, (_e3595 > 0i)))];
let _e3601 = (_e3593 + 1i);
let _e3603 = select(_e3509, _e3601, (_e3601 < _e3509));
let _e3608 = global_3.member[bitcast<u32>(select(0i, _e3603, (_e3603 > 0i)))];
let _e3609 = (_e3593 + 2i);
let _e3611 = select(_e3509, _e3609, (_e3609 < _e3509));
let _e3616 = global_3.member[bitcast<u32>(select(0i, _e3611, (_e3611 > 0i)))];
let _e3623 = (_e3516 + ((_e3544 - _e3516) * _e3488));
let _e3624 = (_e3524 + ((_e3552 - _e3524) * _e3488));
let _e3625 = (_e3532 + ((_e3560 - _e3532) * _e3488));
phi_6216_ = vec3<f32>(((_e3623 + (((_e3572 + ((_e3600 - _e3572) * _e3488)) - _e3623) * _e3490)) * _e3417), ((_e3624 + (((_e3580 + ((_e3608 - _e3580) * _e3488)) - _e3624) * _e3490)) * _e3417), ((_e3625 + (((_e3588 + ((_e3616 - _e3588) * _e3488)) - _e3625) * _e3490)) * _e3417));
} else {
phi_6216_ = vec3(_e3417);
}
let _e3649 = phi_6216_;
phi_6219_ = (_e3350 * _e3649);
} else {
phi_6219_ = _e3350;
}
let _e3652 = phi_6219_;
let _e3656 = (1f / sqrt(select(0f, _e3345, (_e3345 > 0f))));
phi_6232_ = type_26(vec3<f32>((_e3334 * _e3656), (_e3336 * _e3656), (_e3338 * _e3656)), _e3652);
}
let _e3671 = phi_6232_;
let _e3675 = global_1.member.member_10.member_3;
let _e3680 = (_e3675.member - _e2217.x);
let _e3682 = (_e3675.member_1 - _e2217.y);
let _e3684 = (_e3675.member_2 - _e2217.z);
let _e3689 = (((_e3680 * _e3680) + (_e3682 * _e3682)) + (_e3684 * _e3684));
let _e3693 = select(sqrt(select(0f, _e3689, (_e3689 > 0f))), 1e30f, _e3326);
let _e3695 = -(_e3671.member.x);
let _e3697 = -(_e3671.member.y);
let _e3699 = -(_e3671.member.z);
let _e3707 = (1f / select(_e3695, select(1e-12f, -1e-12f, (_e3695 < 0f)), (bitcast<f32>((bitcast<u32>(_e3695) & 2147483647u)) < 1e-12f)));
let _e3715 = (1f / select(_e3697, select(1e-12f, -1e-12f, (_e3697 < 0f)), (bitcast<f32>((bitcast<u32>(_e3697) & 2147483647u)) < 1e-12f)));
let _e3723 = (1f / select(_e3699, select(1e-12f, -1e-12f, (_e3699 < 0f)), (bitcast<f32>((bitcast<u32>(_e3699) & 2147483647u)) < 1e-12f)));
let _e3726 = global_1.member.member_13.member_4;
let _e3732 = global_1.member.member_13.member_5;
let _e3737 = ((_e3726.member - _e2217.x) * _e3707);
let _e3739 = ((_e3732.member - _e2217.x) * _e3707);
let _e3741 = ((_e3726.member_1 - _e2217.y) * _e3715);
let _e3743 = ((_e3732.member_1 - _e2217.y) * _e3715);
let _e3745 = ((_e3726.member_2 - _e2217.z) * _e3723);
let _e3747 = ((_e3732.member_2 - _e2217.z) * _e3723);
let _e3749 = select(_e3739, _e3737, (_e3737 < _e3739));
let _e3751 = select(_e3743, _e3741, (_e3741 < _e3743));
let _e3753 = select(_e3751, _e3749, (_e3749 > _e3751));
let _e3755 = select(_e3747, _e3745, (_e3745 < _e3747));
let _e3757 = select(_e3755, _e3753, (_e3753 > _e3755));
let _e3759 = select(_e3739, _e3737, (_e3737 > _e3739));
let _e3761 = select(_e3743, _e3741, (_e3741 > _e3743));
let _e3763 = select(_e3761, _e3759, (_e3759 < _e3761));
let _e3765 = select(_e3747, _e3745, (_e3745 > _e3747));
let _e3767 = select(_e3765, _e3763, (_e3763 < _e3765));
let _e3769 = select(0f, _e3757, (_e3757 > 0f));
let _e3771 = select(_e3693, _e3767, (_e3767 < _e3693));
let _e3772 = (_e3771 > _e3769);
let _e3773 = select(0f, _e3769, _e3772);
let _e3775 = (select(0f, _e3771, _e3772) - _e3773);
if _e2221 {
phi_7147_ = _e3775;
} else {
let _e3777 = (_e3775 / f32(_e2220));
phi_6428_ = 0u;
phi_6431_ = 0f;
loop {
let _e3779 = phi_6428_;
let _e3781 = phi_6431_;
local_77 = _e3781;
let _e3784 = ((_e3779 < _e2220) && (_e3775 > 0f));
if _e3784 {
let _e3787 = (_e3773 + (_e3777 * f32(_e3779)));
let _e3788 = (_e3787 + _e3777);
let _e3790 = (0.5f * (_e3787 + _e3788));
let _e3791 = (_e3788 - _e3787);
let _e3792 = (0.28867513f * _e3791);
let _e3793 = (_e3790 - _e3792);
let _e3802 = global_1.member.member_13.member_7;
let _e3803 = bitcast<i32>(_e3802);
let _e3806 = global_1.member.member_13.member_8;
let _e3807 = bitcast<i32>(_e3806);
let _e3810 = global_1.member.member_13.member_9;
let _e3811 = bitcast<i32>(_e3810);
let _e3812 = f32(_e3803);
let _e3814 = (_e3732.member - _e3726.member);
let _e3817 = (((((_e2217.x + (_e3695 * _e3793)) - _e3726.member) / _e3814) * _e3812) - 0.5f);
let _e3818 = (_e3812 - 1f);
let _e3820 = select(0f, _e3817, (_e3817 > 0f));
let _e3822 = select(_e3818, _e3820, (_e3820 < _e3818));
let _e3823 = f32(_e3807);
let _e3825 = (_e3732.member_1 - _e3726.member_1);
let _e3828 = (((((_e2217.y + (_e3697 * _e3793)) - _e3726.member_1) / _e3825) * _e3823) - 0.5f);
let _e3829 = (_e3823 - 1f);
let _e3831 = select(0f, _e3828, (_e3828 > 0f));
let _e3833 = select(_e3829, _e3831, (_e3831 < _e3829));
let _e3834 = f32(_e3811);
let _e3836 = (_e3732.member_2 - _e3726.member_2);
let _e3839 = (((((_e2217.z + (_e3699 * _e3793)) - _e3726.member_2) / _e3836) * _e3834) - 0.5f);
let _e3840 = (_e3834 - 1f);
let _e3842 = select(0f, _e3839, (_e3839 > 0f));
let _e3844 = select(_e3840, _e3842, (_e3842 < _e3840));
let _e3846 = select(0f, _e3822, (_e3822 > 0f));
let _e3848 = select(1e6f, _e3846, (_e3846 < 1e6f));
let _e3855 = select(0i, select(select(i32(_e3848), i32(-2147483648), (_e3848 < -2147483600f)), 2147483647i, (_e3848 > 2147483500f)), (_e3848 == _e3848));
let _e3859 = (_e3855 - select(0i, 1i, (_e3848 < f32(_e3855))));
let _e3861 = select(0f, _e3833, (_e3833 > 0f));
let _e3863 = select(1e6f, _e3861, (_e3861 < 1e6f));
let _e3870 = select(0i, select(select(i32(_e3863), i32(-2147483648), (_e3863 < -2147483600f)), 2147483647i, (_e3863 > 2147483500f)), (_e3863 == _e3863));
let _e3874 = (_e3870 - select(0i, 1i, (_e3863 < f32(_e3870))));
let _e3876 = select(0f, _e3844, (_e3844 > 0f));
let _e3878 = select(1e6f, _e3876, (_e3876 < 1e6f));
let _e3885 = select(0i, select(select(i32(_e3878), i32(-2147483648), (_e3878 < -2147483600f)), 2147483647i, (_e3878 > 2147483500f)), (_e3878 == _e3878));
let _e3889 = (_e3885 - select(0i, 1i, (_e3878 < f32(_e3885))));
let _e3893 = (_e3833 - f32(_e3874));
let _e3895 = (_e3844 - f32(_e3889));
local_22 = (_e3822 - f32(_e3859));
let _e3896 = (_e3859 + 1i);
let _e3898 = select(_e3896, 0i, (_e3896 < 0i));
if (_e3898 >= _e3803) {
phi_6569_ = (_e3803 - 1i);
} else {
phi_6569_ = _e3898;
}
let _e3902 = phi_6569_;
local_23 = (_e3902 - _e3859);
let _e3904 = (_e3874 + 1i);
let _e3906 = select(_e3904, 0i, (_e3904 < 0i));
if (_e3906 >= _e3807) {
phi_6582_ = (_e3807 - 1i);
} else {
phi_6582_ = _e3906;
}
let _e3910 = phi_6582_;
let _e3912 = ((_e3910 - _e3874) * _e3803);
let _e3913 = (_e3889 + 1i);
let _e3915 = select(_e3913, 0i, (_e3913 < 0i));
if (_e3915 >= _e3811) {
phi_6596_ = (_e3811 - 1i);
} else {
phi_6596_ = _e3915;
}
let _e3919 = phi_6596_;
let _e3925 = global_1.member.member_13.member_10;
let _e3926 = bitcast<i32>(_e3925);
let _e3931 = ((_e3926 + (((_e3889 * _e3807) + _e3874) * _e3803)) + _e3859);
let _e3933 = (bitcast<i32>(_e187) - 1i);
let _e3935 = select(_e3933, _e3931, (_e3931 < _e3933));
let _e3940 = global_7.member[bitcast<u32>(select(0i, _e3935, (_e3935 > 0i)))];
let _e3941 = local_22;
let _e3944 = local_23;
let _e3945 = (_e3931 + _e3944);
let _e3947 = select(_e3933, _e3945, (_e3945 < _e3933));
let _e3952 = global_7.member[bitcast<u32>(select(0i, _e3947, (_e3947 > 0i)))];
let _e3953 = local_22;
let _e3956 = (1f - _e3893);
let _e3958 = (_e3931 + _e3912);
let _e3960 = select(_e3933, _e3958, (_e3958 < _e3933));
let _e3965 = global_7.member[bitcast<u32>(select(0i, _e3960, (_e3960 > 0i)))];
let _e3966 = local_22;
let _e3969 = local_23;
let _e3970 = (_e3958 + _e3969);
let _e3972 = select(_e3933, _e3970, (_e3970 < _e3933));
let _e3977 = global_7.member[bitcast<u32>(select(0i, _e3972, (_e3972 > 0i)))];
let _e3978 = local_22;
let _e3983 = (_e3931 + (((_e3919 - _e3889) * _e3803) * _e3807));
let _e3985 = select(_e3933, _e3983, (_e3983 < _e3933));
let _e3990 = global_7.member[bitcast<u32>(select(0i, _e3985, (_e3985 > 0i)))];
let _e3991 = local_22;
let _e3994 = local_23;
let _e3995 = (_e3983 + _e3994);
let _e3997 = select(_e3933, _e3995, (_e3995 < _e3933));
let _e4002 = global_7.member[bitcast<u32>(select(0i, _e3997, (_e3997 > 0i)))];
let _e4003 = local_22;
let _e4007 = (_e3983 + _e3912);
let _e4009 = select(_e3933, _e4007, (_e4007 < _e3933));
let _e4014 = global_7.member[bitcast<u32>(select(0i, _e4009, (_e4009 > 0i)))];
let _e4015 = local_22;
let _e4018 = local_23;
let _e4019 = (_e4007 + _e4018);
let _e4021 = select(_e3933, _e4019, (_e4019 < _e3933));
let _e4026 = global_7.member[bitcast<u32>(select(0i, _e4021, (_e4021 > 0i)))];
let _e4027 = local_22;
let _e4036 = (_e3790 + _e3792);
let _e4046 = (((((_e2217.x + (_e3695 * _e4036)) - _e3726.member) / _e3814) * _e3812) - 0.5f);
let _e4048 = select(0f, _e4046, (_e4046 > 0f));
let _e4050 = select(_e3818, _e4048, (_e4048 < _e3818));
let _e4054 = (((((_e2217.y + (_e3697 * _e4036)) - _e3726.member_1) / _e3825) * _e3823) - 0.5f);
let _e4056 = select(0f, _e4054, (_e4054 > 0f));
let _e4058 = select(_e3829, _e4056, (_e4056 < _e3829));
let _e4062 = (((((_e2217.z + (_e3699 * _e4036)) - _e3726.member_2) / _e3836) * _e3834) - 0.5f);
let _e4064 = select(0f, _e4062, (_e4062 > 0f));
let _e4066 = select(_e3840, _e4064, (_e4064 < _e3840));
let _e4068 = select(0f, _e4050, (_e4050 > 0f));
let _e4070 = select(1e6f, _e4068, (_e4068 < 1e6f));
let _e4077 = select(0i, select(select(i32(_e4070), i32(-2147483648), (_e4070 < -2147483600f)), 2147483647i, (_e4070 > 2147483500f)), (_e4070 == _e4070));
let _e4081 = (_e4077 - select(0i, 1i, (_e4070 < f32(_e4077))));
let _e4083 = select(0f, _e4058, (_e4058 > 0f));
let _e4085 = select(1e6f, _e4083, (_e4083 < 1e6f));
let _e4092 = select(0i, select(select(i32(_e4085), i32(-2147483648), (_e4085 < -2147483600f)), 2147483647i, (_e4085 > 2147483500f)), (_e4085 == _e4085));
let _e4096 = (_e4092 - select(0i, 1i, (_e4085 < f32(_e4092))));
let _e4098 = select(0f, _e4066, (_e4066 > 0f));
let _e4100 = select(1e6f, _e4098, (_e4098 < 1e6f));
let _e4107 = select(0i, select(select(i32(_e4100), i32(-2147483648), (_e4100 < -2147483600f)), 2147483647i, (_e4100 > 2147483500f)), (_e4100 == _e4100));
let _e4111 = (_e4107 - select(0i, 1i, (_e4100 < f32(_e4107))));
let _e4115 = (_e4058 - f32(_e4096));
let _e4117 = (_e4066 - f32(_e4111));
local_20 = (_e4050 - f32(_e4081));
let _e4118 = (_e4081 + 1i);
let _e4120 = select(_e4118, 0i, (_e4118 < 0i));
if (_e4120 >= _e3803) {
phi_6915_ = (_e3803 - 1i);
} else {
phi_6915_ = _e4120;
}
let _e4124 = phi_6915_;
local_21 = (_e4124 - _e4081);
let _e4126 = (_e4096 + 1i);
let _e4128 = select(_e4126, 0i, (_e4126 < 0i));
if (_e4128 >= _e3807) {
phi_6928_ = (_e3807 - 1i);
} else {
phi_6928_ = _e4128;
}
let _e4132 = phi_6928_;
let _e4134 = ((_e4132 - _e4096) * _e3803);
let _e4135 = (_e4111 + 1i);
let _e4137 = select(_e4135, 0i, (_e4135 < 0i));
if (_e4137 >= _e3811) {
phi_6942_ = (_e3811 - 1i);
} else {
phi_6942_ = _e4137;
}
let _e4141 = phi_6942_;
let _e4149 = ((_e3926 + (((_e4111 * _e3807) + _e4096) * _e3803)) + _e4081);
let _e4151 = select(_e3933, _e4149, (_e4149 < _e3933));
let _e4156 = global_7.member[bitcast<u32>(select(0i, _e4151, (_e4151 > 0i)))];
let _e4157 = local_20;
let _e4160 = local_21;
let _e4161 = (_e4149 + _e4160);
let _e4163 = select(_e3933, _e4161, (_e4161 < _e3933));
let _e4168 = global_7.member[bitcast<u32>(select(0i, _e4163, (_e4163 > 0i)))];
let _e4169 = local_20;
let _e4172 = (1f - _e4115);
let _e4174 = (_e4149 + _e4134);
let _e4176 = select(_e3933, _e4174, (_e4174 < _e3933));
let _e4181 = global_7.member[bitcast<u32>(select(0i, _e4176, (_e4176 > 0i)))];
let _e4182 = local_20;
let _e4185 = local_21;
let _e4186 = (_e4174 + _e4185);
let _e4188 = select(_e3933, _e4186, (_e4186 < _e3933));
let _e4193 = global_7.member[bitcast<u32>(select(0i, _e4188, (_e4188 > 0i)))];
let _e4194 = local_20;
let _e4199 = (_e4149 + (((_e4141 - _e4111) * _e3803) * _e3807));
let _e4201 = select(_e3933, _e4199, (_e4199 < _e3933));
let _e4206 = global_7.member[bitcast<u32>(select(0i, _e4201, (_e4201 > 0i)))];
let _e4207 = local_20;
let _e4210 = local_21;
let _e4211 = (_e4199 + _e4210);
let _e4213 = select(_e3933, _e4211, (_e4211 < _e3933));
let _e4218 = global_7.member[bitcast<u32>(select(0i, _e4213, (_e4213 > 0i)))];
let _e4219 = local_20;
let _e4223 = (_e4199 + _e4134);
let _e4225 = select(_e3933, _e4223, (_e4223 < _e3933));
let _e4230 = global_7.member[bitcast<u32>(select(0i, _e4225, (_e4225 > 0i)))];
let _e4231 = local_20;
let _e4234 = local_21;
let _e4235 = (_e4223 + _e4234);
let _e4237 = select(_e3933, _e4235, (_e4235 < _e3933));
let _e4242 = global_7.member[bitcast<u32>(select(0i, _e4237, (_e4237 > 0i)))];
let _e4243 = local_20;
phi_6429_ = (_e3779 + 1u);
phi_6432_ = (_e3781 + ((0.5f * (((((((_e3940 * (1f - _e3941)) + (_e3952 * _e3953)) * _e3956) + (((_e3965 * (1f - _e3966)) + (_e3977 * _e3978)) * _e3893)) * (1f - _e3895)) + (((((_e3990 * (1f - _e3991)) + (_e4002 * _e4003)) * _e3956) + (((_e4014 * (1f - _e4015)) + (_e4026 * _e4027)) * _e3893)) * _e3895)) + ((((((_e4156 * (1f - _e4157)) + (_e4168 * _e4169)) * _e4172) + (((_e4181 * (1f - _e4182)) + (_e4193 * _e4194)) * _e4115)) * (1f - _e4117)) + (((((_e4206 * (1f - _e4207)) + (_e4218 * _e4219)) * _e4172) + (((_e4230 * (1f - _e4231)) + (_e4242 * _e4243)) * _e4115)) * _e4117)))) * _e3791));
} else {
phi_6429_ = u32();
phi_6432_ = f32();
}
let _e4258 = phi_6429_;
let _e4260 = phi_6432_;
continue;
continuing {
phi_6428_ = _e4258;
phi_6431_ = _e4260;
break if !(_e3784);
}
}
let _e11140 = local_77;
phi_7147_ = _e11140;
}
let _e4263 = phi_7147_;
let _e4264 = (_e4263 + select((_e2181 + (_e3307 * (0.5f + (0.5f * _e2192)))), select(0f, _e3308, (_e3308 > 0f)), _e853));
let _e4267 = global_1.member.member_13.member;
let _e4272 = -((_e4267.member * _e4264));
let _e4274 = select(-87f, _e4272, (_e4272 > -87f));
let _e4276 = select(88f, _e4274, (_e4274 < 88f));
let _e4278 = ((_e4276 * 1.442695f) + 0.5f);
let _e4280 = select(-127f, _e4278, (_e4278 > -127f));
let _e4282 = select(128f, _e4280, (_e4280 < 128f));
let _e4289 = select(0i, select(select(i32(_e4282), i32(-2147483648), (_e4282 < -2147483600f)), 2147483647i, (_e4282 > 2147483500f)), (_e4282 == _e4282));
let _e4293 = (_e4289 - select(0i, 1i, (_e4282 < f32(_e4289))));
let _e4294 = f32(_e4293);
let _e4298 = ((_e4276 - (_e4294 * 0.6933594f)) - (_e4294 * -2.1219444e-4f));
let _e4320 = -((_e4267.member_1 * _e4264));
let _e4322 = select(-87f, _e4320, (_e4320 > -87f));
let _e4324 = select(88f, _e4322, (_e4322 < 88f));
let _e4326 = ((_e4324 * 1.442695f) + 0.5f);
let _e4328 = select(-127f, _e4326, (_e4326 > -127f));
let _e4330 = select(128f, _e4328, (_e4328 < 128f));
let _e4337 = select(0i, select(select(i32(_e4330), i32(-2147483648), (_e4330 < -2147483600f)), 2147483647i, (_e4330 > 2147483500f)), (_e4330 == _e4330));
let _e4341 = (_e4337 - select(0i, 1i, (_e4330 < f32(_e4337))));
let _e4342 = f32(_e4341);
let _e4346 = ((_e4324 - (_e4342 * 0.6933594f)) - (_e4342 * -2.1219444e-4f));
let _e4368 = -((_e4267.member_2 * _e4264));
let _e4370 = select(-87f, _e4368, (_e4368 > -87f));
let _e4372 = select(88f, _e4370, (_e4370 < 88f));
let _e4374 = ((_e4372 * 1.442695f) + 0.5f);
let _e4376 = select(-127f, _e4374, (_e4374 > -127f));
let _e4378 = select(128f, _e4376, (_e4376 < 128f));
let _e4385 = select(0i, select(select(i32(_e4378), i32(-2147483648), (_e4378 < -2147483600f)), 2147483647i, (_e4378 > 2147483500f)), (_e4378 == _e4378));
let _e4389 = (_e4385 - select(0i, 1i, (_e4378 < f32(_e4385))));
let _e4390 = f32(_e4389);
let _e4394 = ((_e4372 - (_e4390 * 0.6933594f)) - (_e4390 * -2.1219444e-4f));
let _e4420 = -((((_e3671.member.x * _e512) + (_e3671.member.y * _e523)) + (_e3671.member.z * _e534)));
let _e4423 = global_1.member.member_13.member_2;
let _e4424 = (_e4423 * _e4423);
let _e4425 = (1f + _e4424);
let _e4426 = (2f * _e4423);
let _e4428 = (_e4425 - (_e4426 * _e4420));
let _e4430 = select(1e-9f, _e4428, (_e4428 > 1e-9f));
let _e4431 = (1f - _e4424);
let _e4442 = global_1.member.member_13.member_3;
let _e4443 = (_e4442 == 1u);
let _e4445 = (_e4442 == 2u);
if _e4445 {
let _e4447 = (0.5f - (0.5f * _e4420));
let _e4449 = select(0f, _e4447, (_e4447 > 0f));
let _e4453 = (sqrt(select(0f, _e4449, (_e4449 > 0f))) * 255f);
let _e4454 = (255f - 1f);
let _e4456 = select(0f, _e4453, (_e4453 > 0f));
let _e4458 = select(_e4454, _e4456, (_e4456 < _e4454));
let _e4465 = select(0i, select(select(i32(_e4458), i32(-2147483648), (_e4458 < -2147483600f)), 2147483647i, (_e4458 > 2147483500f)), (_e4458 == _e4458));
let _e4469 = (_e4465 - select(0i, 1i, (_e4458 < f32(_e4465))));
let _e4472 = global_1.member.member_13.member_11;
let _e4473 = bitcast<i32>(_e4472);
let _e4474 = (_e4473 + _e4469);
let _e4476 = (bitcast<i32>(_e187) - 1i);
let _e4478 = select(_e4476, _e4474, (_e4474 < _e4476));
let _e4483 = global_7.member[bitcast<u32>(select(0i, _e4478, (_e4478 > 0i)))];
let _e4485 = (_e4473 + (_e4469 + 1i));
let _e4487 = select(_e4476, _e4485, (_e4485 < _e4476));
let _e4492 = global_7.member[bitcast<u32>(select(0i, _e4487, (_e4487 > 0i)))];
phi_7508_ = (_e4483 + ((_e4492 - _e4483) * (_e4453 - f32(_e4469))));
} else {
phi_7508_ = select((_e4431 / (_e4430 * sqrt(select(0f, _e4430, (_e4430 > 0f))))), (0.75f * (1f + (_e4420 * _e4420))), _e4443);
}
let _e4499 = phi_7508_;
let _e4500 = (0.25f / 3.1415927f);
let _e4504 = ((3.1415927f * (_e4499 * _e4500)) * (_e2209 * _e2471));
let _e4514 = global_1.member.member_13.member_1;
let _e4524 = (_e3038 - _e846);
if _e3326 {
let _e4863 = global_1.member.member_10.member_1;
phi_8082_ = type_26(vec3<f32>(_e4863.member, _e4863.member_1, _e4863.member_2), _e3322);
} else {
let _e4533 = (_e3047.x - _e3675.member);
let _e4535 = (_e3047.y - _e3675.member_1);
let _e4537 = (_e3047.z - _e3675.member_2);
let _e4542 = (((_e4533 * _e4533) + (_e4535 * _e4535)) + (_e4537 * _e4537));
let _e4544 = select(1e-12f, _e4542, (_e4542 > 1e-12f));
let _e4545 = (1f / _e4544);
let _e4549 = vec3<f32>((_e3318.member * _e4545), (_e3318.member_1 * _e4545), (_e3318.member_2 * _e4545));
if (_e3325 == 2u) {
let _e4553 = global_1.member.member_10.member_1;
let _e4561 = (((_e4553.member * _e4533) + (_e4553.member_1 * _e4535)) + (_e4553.member_2 * _e4537));
let _e4564 = (1f / select(1e-20f, _e4561, (_e4561 > 1e-20f)));
let _e4568 = global_1.member.member_10.member_4.member;
let _e4577 = ((((_e4568.member * _e4533) + (_e4568.member_1 * _e4535)) + (_e4568.member_2 * _e4537)) * _e4564);
let _e4581 = global_1.member.member_10.member_4.member_1;
let _e4590 = ((((_e4581.member * _e4533) + (_e4581.member_1 * _e4535)) + (_e4581.member_2 * _e4537)) * _e4564);
let _e4594 = global_1.member.member_10.member_4.member_2;
let _e4597 = ((_e4577 * _e4577) + (_e4590 * _e4590));
let _e4605 = global_1.member.member_10.member_4.member_3;
let _e4606 = ((_e4594 - sqrt(select(0f, _e4597, (_e4597 > 0f)))) * _e4605);
let _e4608 = select(0f, _e4606, (_e4606 > 0f));
let _e4610 = select(1f, _e4608, (_e4608 < 1f));
let _e4616 = select(0f, ((_e4610 * _e4610) * (3f - (2f * _e4610))), (_e4561 > 0f));
let _e4620 = global_1.member.member_10.member_4.member_5;
if ((_e4620 > 0u) && (_e4616 > 0f)) {
let _e4625 = (0.5f / _e4594);
let _e4634 = global_1.member.member_10.member_4.member_6;
let _e4635 = bitcast<i32>(_e4634);
local_19 = bitcast<i32>(_e4620);
let _e4636 = local_19;
let _e4638 = f32((_e4636 - 1i));
let _e4640 = f32((_e4635 - 1i));
let _e4641 = local_19;
let _e4644 = (((0.5f + (_e4577 * _e4625)) * f32(_e4641)) - 0.5f);
let _e4646 = select(0f, _e4644, (_e4644 > 0f));
let _e4648 = select(_e4638, _e4646, (_e4646 < _e4638));
let _e4651 = (((0.5f - (_e4590 * _e4625)) * f32(_e4635)) - 0.5f);
let _e4653 = select(0f, _e4651, (_e4651 > 0f));
let _e4655 = select(_e4640, _e4653, (_e4653 < _e4640));
let _e4657 = select(0f, _e4648, (_e4648 > 0f));
let _e4659 = select(_e4638, _e4657, (_e4657 < _e4638));
let _e4666 = select(0i, select(select(i32(_e4659), i32(-2147483648), (_e4659 < -2147483600f)), 2147483647i, (_e4659 > 2147483500f)), (_e4659 == _e4659));
let _e4670 = (_e4666 - select(0i, 1i, (_e4659 < f32(_e4666))));
let _e4672 = select(0f, _e4655, (_e4655 > 0f));
let _e4674 = select(_e4640, _e4672, (_e4672 < _e4640));
let _e4681 = select(0i, select(select(i32(_e4674), i32(-2147483648), (_e4674 < -2147483600f)), 2147483647i, (_e4674 > 2147483500f)), (_e4674 == _e4674));
let _e4685 = (_e4681 - select(0i, 1i, (_e4674 < f32(_e4681))));
let _e4687 = (_e4648 - f32(_e4670));
let _e4689 = (_e4655 - f32(_e4685));
let _e4690 = (_e4670 + 1i);
let _e4691 = local_19;
let _e4693 = select(_e4670, _e4690, (_e4690 < _e4691));
let _e4694 = (_e4685 + 1i);
let _e4696 = select(_e4685, _e4694, (_e4694 < _e4635));
let _e4700 = global_1.member.member_10.member_4.member_4;
let _e4701 = bitcast<i32>(_e4700);
let _e4702 = local_19;
let _e4706 = (_e4701 + (3i * ((_e4685 * _e4702) + _e4670)));
let _e4708 = (bitcast<i32>(_e180) - 1i);
let _e4710 = select(_e4708, _e4706, (_e4706 < _e4708));
let _e4715 = global_3.member[bitcast<u32>(select(0i, _e4710, (_e4710 > 0i)))];
let _e4716 = (_e4706 + 1i);
let _e4718 = select(_e4708, _e4716, (_e4716 < _e4708));
let _e4723 = global_3.member[bitcast<u32>(select(0i, _e4718, (_e4718 > 0i)))];
let _e4724 = (_e4706 + 2i);
let _e4726 = select(_e4708, _e4724, (_e4724 < _e4708));
let _e4731 = global_3.member[bitcast<u32>(select(0i, _e4726, (_e4726 > 0i)))];
let _e4732 = local_19;
let _e4736 = (_e4701 + (3i * ((_e4685 * _e4732) + _e4693)));
let _e4738 = select(_e4708, _e4736, (_e4736 < _e4708));
let _e4743 = global_3.member[bitcast<u32>(select(0i, _e4738, (_e4738 > 0i)))];
let _e4744 = (_e4736 + 1i);
let _e4746 = select(_e4708, _e4744, (_e4744 < _e4708));
let _e4751 = global_3.member[bitcast<u32>(select(0i, _e4746, (_e4746 > 0i)))];
let _e4752 = (_e4736 + 2i);
let _e4754 = select(_e4708, _e4752, (_e4752 < _e4708));
let _e4759 = global_3.member[bitcast<u32>(select(0i, _e4754, (_e4754 > 0i)))];
let _e4760 = local_19;
let _e4764 = (_e4701 + (3i * ((_e4696 * _e4760) + _e4670)));
let _e4766 = select(_e4708, _e4764, (_e4764 < _e4708));
let _e4771 = global_3.member[bitcast<u32>(select(0i, _e4766, (_e4766 > 0i)))];
let _e4772 = (_e4764 + 1i);
let _e4774 = select(_e4708, _e4772, (_e4772 < _e4708));
let _e4779 = global_3.member[bitcast<u32>(select(0i, _e4774, (_e4774 > 0i)))];
let _e4780 = (_e4764 + 2i);
let _e4782 = select(_e4708, _e4780, (_e4780 < _e4708));
let _e4787 = global_3.member[bitcast<u32>(select(0i, _e4782, (_e4782 > 0i)))];
let _e4788 = local_19;
let _e4792 = (_e4701 + (3i * ((_e4696 * _e4788) + _e4693)));
let _e4794 = select(_e4708, _e4792, (_e4792 < _e4708));
let _e4799 = global_3.member[bitcast<u32>(select(0i, _e4794, (_e4794 > 0i)))];
let _e4800 = (_e4792 + 1i);
let _e4802 = select(_e4708, _e4800, (_e4800 < _e4708));
let _e4807 = global_3.member[bitcast<u32>(select(0i, _e4802, (_e4802 > 0i)))];
let _e4808 = (_e4792 + 2i);
let _e4810 = select(_e4708, _e4808, (_e4808 < _e4708));
let _e4815 = global_3.member[bitcast<u32>(select(0i, _e4810, (_e4810 > 0i)))];
let _e4822 = (_e4715 + ((_e4743 - _e4715) * _e4687));
let _e4823 = (_e4723 + ((_e4751 - _e4723) * _e4687));
let _e4824 = (_e4731 + ((_e4759 - _e4731) * _e4687));
phi_8066_ = vec3<f32>(((_e4822 + (((_e4771 + ((_e4799 - _e4771) * _e4687)) - _e4822) * _e4689)) * _e4616), ((_e4823 + (((_e4779 + ((_e4807 - _e4779) * _e4687)) - _e4823) * _e4689)) * _e4616), ((_e4824 + (((_e4787 + ((_e4815 - _e4787) * _e4687)) - _e4824) * _e4689)) * _e4616));
} else {
phi_8066_ = vec3(_e4616);
}
let _e4848 = phi_8066_;
phi_8069_ = (_e4549 * _e4848);
} else {
phi_8069_ = _e4549;
}
let _e4851 = phi_8069_;
let _e4855 = (1f / sqrt(select(0f, _e4544, (_e4544 > 0f))));
phi_8082_ = type_26(vec3<f32>((_e4533 * _e4855), (_e4535 * _e4855), (_e4537 * _e4855)), _e4851);
}
let _e4870 = phi_8082_;
let _e4873 = (_e3675.member - _e3047.x);
let _e4875 = (_e3675.member_1 - _e3047.y);
let _e4877 = (_e3675.member_2 - _e3047.z);
let _e4882 = (((_e4873 * _e4873) + (_e4875 * _e4875)) + (_e4877 * _e4877));
let _e4886 = select(sqrt(select(0f, _e4882, (_e4882 > 0f))), 1e30f, _e3326);
let _e4888 = -(_e4870.member.x);
let _e4890 = -(_e4870.member.y);
let _e4892 = -(_e4870.member.z);
let _e4900 = (1f / select(_e4888, select(1e-12f, -1e-12f, (_e4888 < 0f)), (bitcast<f32>((bitcast<u32>(_e4888) & 2147483647u)) < 1e-12f)));
let _e4908 = (1f / select(_e4890, select(1e-12f, -1e-12f, (_e4890 < 0f)), (bitcast<f32>((bitcast<u32>(_e4890) & 2147483647u)) < 1e-12f)));
let _e4916 = (1f / select(_e4892, select(1e-12f, -1e-12f, (_e4892 < 0f)), (bitcast<f32>((bitcast<u32>(_e4892) & 2147483647u)) < 1e-12f)));
let _e4918 = ((_e3726.member - _e3047.x) * _e4900);
let _e4920 = ((_e3732.member - _e3047.x) * _e4900);
let _e4922 = ((_e3726.member_1 - _e3047.y) * _e4908);
let _e4924 = ((_e3732.member_1 - _e3047.y) * _e4908);
let _e4926 = ((_e3726.member_2 - _e3047.z) * _e4916);
let _e4928 = ((_e3732.member_2 - _e3047.z) * _e4916);
let _e4930 = select(_e4920, _e4918, (_e4918 < _e4920));
let _e4932 = select(_e4924, _e4922, (_e4922 < _e4924));
let _e4934 = select(_e4932, _e4930, (_e4930 > _e4932));
let _e4936 = select(_e4928, _e4926, (_e4926 < _e4928));
let _e4938 = select(_e4936, _e4934, (_e4934 > _e4936));
let _e4940 = select(_e4920, _e4918, (_e4918 > _e4920));
let _e4942 = select(_e4924, _e4922, (_e4922 > _e4924));
let _e4944 = select(_e4942, _e4940, (_e4940 < _e4942));
let _e4946 = select(_e4928, _e4926, (_e4926 > _e4928));
let _e4948 = select(_e4946, _e4944, (_e4944 < _e4946));
let _e4950 = select(0f, _e4938, (_e4938 > 0f));
let _e4952 = select(_e4886, _e4948, (_e4948 < _e4886));
let _e4953 = (_e4952 > _e4950);
let _e4954 = select(0f, _e4950, _e4953);
let _e4956 = (select(0f, _e4952, _e4953) - _e4954);
if _e2221 {
phi_8997_ = _e4956;
} else {
let _e4958 = (_e4956 / f32(_e2220));
phi_8278_ = 0u;
phi_8281_ = 0f;
loop {
let _e4960 = phi_8278_;
let _e4962 = phi_8281_;
local_78 = _e4962;
let _e4965 = ((_e4960 < _e2220) && (_e4956 > 0f));
if _e4965 {
let _e4968 = (_e4954 + (_e4958 * f32(_e4960)));
let _e4969 = (_e4968 + _e4958);
let _e4971 = (0.5f * (_e4968 + _e4969));
let _e4972 = (_e4969 - _e4968);
let _e4973 = (0.28867513f * _e4972);
let _e4974 = (_e4971 - _e4973);
let _e4983 = global_1.member.member_13.member_7;
let _e4984 = bitcast<i32>(_e4983);
let _e4987 = global_1.member.member_13.member_8;
let _e4988 = bitcast<i32>(_e4987);
let _e4991 = global_1.member.member_13.member_9;
let _e4992 = bitcast<i32>(_e4991);
let _e4993 = f32(_e4984);
let _e4995 = (_e3732.member - _e3726.member);
let _e4998 = (((((_e3047.x + (_e4888 * _e4974)) - _e3726.member) / _e4995) * _e4993) - 0.5f);
let _e4999 = (_e4993 - 1f);
let _e5001 = select(0f, _e4998, (_e4998 > 0f));
let _e5003 = select(_e4999, _e5001, (_e5001 < _e4999));
let _e5004 = f32(_e4988);
let _e5006 = (_e3732.member_1 - _e3726.member_1);
let _e5009 = (((((_e3047.y + (_e4890 * _e4974)) - _e3726.member_1) / _e5006) * _e5004) - 0.5f);
let _e5010 = (_e5004 - 1f);
let _e5012 = select(0f, _e5009, (_e5009 > 0f));
let _e5014 = select(_e5010, _e5012, (_e5012 < _e5010));
let _e5015 = f32(_e4992);
let _e5017 = (_e3732.member_2 - _e3726.member_2);
let _e5020 = (((((_e3047.z + (_e4892 * _e4974)) - _e3726.member_2) / _e5017) * _e5015) - 0.5f);
let _e5021 = (_e5015 - 1f);
let _e5023 = select(0f, _e5020, (_e5020 > 0f));
let _e5025 = select(_e5021, _e5023, (_e5023 < _e5021));
let _e5027 = select(0f, _e5003, (_e5003 > 0f));
let _e5029 = select(1e6f, _e5027, (_e5027 < 1e6f));
let _e5036 = select(0i, select(select(i32(_e5029), i32(-2147483648), (_e5029 < -2147483600f)), 2147483647i, (_e5029 > 2147483500f)), (_e5029 == _e5029));
let _e5040 = (_e5036 - select(0i, 1i, (_e5029 < f32(_e5036))));
let _e5042 = select(0f, _e5014, (_e5014 > 0f));
let _e5044 = select(1e6f, _e5042, (_e5042 < 1e6f));
let _e5051 = select(0i, select(select(i32(_e5044), i32(-2147483648), (_e5044 < -2147483600f)), 2147483647i, (_e5044 > 2147483500f)), (_e5044 == _e5044));
let _e5055 = (_e5051 - select(0i, 1i, (_e5044 < f32(_e5051))));
let _e5057 = select(0f, _e5025, (_e5025 > 0f));
let _e5059 = select(1e6f, _e5057, (_e5057 < 1e6f));
let _e5066 = select(0i, select(select(i32(_e5059), i32(-2147483648), (_e5059 < -2147483600f)), 2147483647i, (_e5059 > 2147483500f)), (_e5059 == _e5059));
let _e5070 = (_e5066 - select(0i, 1i, (_e5059 < f32(_e5066))));
let _e5074 = (_e5014 - f32(_e5055));
let _e5076 = (_e5025 - f32(_e5070));
local_17 = (_e5003 - f32(_e5040));
let _e5077 = (_e5040 + 1i);
let _e5079 = select(_e5077, 0i, (_e5077 < 0i));
if (_e5079 >= _e4984) {
phi_8419_ = (_e4984 - 1i);
} else {
phi_8419_ = _e5079;
}
let _e5083 = phi_8419_;
local_18 = (_e5083 - _e5040);
let _e5085 = (_e5055 + 1i);
let _e5087 = select(_e5085, 0i, (_e5085 < 0i));
if (_e5087 >= _e4988) {
phi_8432_ = (_e4988 - 1i);
} else {
phi_8432_ = _e5087;
}
let _e5091 = phi_8432_;
let _e5093 = ((_e5091 - _e5055) * _e4984);
let _e5094 = (_e5070 + 1i);
let _e5096 = select(_e5094, 0i, (_e5094 < 0i));
if (_e5096 >= _e4992) {
phi_8446_ = (_e4992 - 1i);
} else {
phi_8446_ = _e5096;
}
let _e5100 = phi_8446_;
let _e5106 = global_1.member.member_13.member_10;
let _e5107 = bitcast<i32>(_e5106);
let _e5112 = ((_e5107 + (((_e5070 * _e4988) + _e5055) * _e4984)) + _e5040);
let _e5114 = (bitcast<i32>(_e187) - 1i);
let _e5116 = select(_e5114, _e5112, (_e5112 < _e5114));
let _e5121 = global_7.member[bitcast<u32>(select(0i, _e5116, (_e5116 > 0i)))];
let _e5122 = local_17;
let _e5125 = local_18;
let _e5126 = (_e5112 + _e5125);
let _e5128 = select(_e5114, _e5126, (_e5126 < _e5114));
let _e5133 = global_7.member[bitcast<u32>(select(0i, _e5128, (_e5128 > 0i)))];
let _e5134 = local_17;
let _e5137 = (1f - _e5074);
let _e5139 = (_e5112 + _e5093);
let _e5141 = select(_e5114, _e5139, (_e5139 < _e5114));
let _e5146 = global_7.member[bitcast<u32>(select(0i, _e5141, (_e5141 > 0i)))];
let _e5147 = local_17;
let _e5150 = local_18;
let _e5151 = (_e5139 + _e5150);
let _e5153 = select(_e5114, _e5151, (_e5151 < _e5114));
let _e5158 = global_7.member[bitcast<u32>(select(0i, _e5153, (_e5153 > 0i)))];
let _e5159 = local_17;
let _e5164 = (_e5112 + (((_e5100 - _e5070) * _e4984) * _e4988));
let _e5166 = select(_e5114, _e5164, (_e5164 < _e5114));
let _e5171 = global_7.member[bitcast<u32>(select(0i, _e5166, (_e5166 > 0i)))];
let _e5172 = local_17;
let _e5175 = local_18;
let _e5176 = (_e5164 + _e5175);
let _e5178 = select(_e5114, _e5176, (_e5176 < _e5114));
let _e5183 = global_7.member[bitcast<u32>(select(0i, _e5178, (_e5178 > 0i)))];
let _e5184 = local_17;
let _e5188 = (_e5164 + _e5093);
let _e5190 = select(_e5114, _e5188, (_e5188 < _e5114));
let _e5195 = global_7.member[bitcast<u32>(select(0i, _e5190, (_e5190 > 0i)))];
let _e5196 = local_17;
let _e5199 = local_18;
let _e5200 = (_e5188 + _e5199);
let _e5202 = select(_e5114, _e5200, (_e5200 < _e5114));
let _e5207 = global_7.member[bitcast<u32>(select(0i, _e5202, (_e5202 > 0i)))];
let _e5208 = local_17;
let _e5217 = (_e4971 + _e4973);
let _e5227 = (((((_e3047.x + (_e4888 * _e5217)) - _e3726.member) / _e4995) * _e4993) - 0.5f);
let _e5229 = select(0f, _e5227, (_e5227 > 0f));
let _e5231 = select(_e4999, _e5229, (_e5229 < _e4999));
let _e5235 = (((((_e3047.y + (_e4890 * _e5217)) - _e3726.member_1) / _e5006) * _e5004) - 0.5f);
let _e5237 = select(0f, _e5235, (_e5235 > 0f));
let _e5239 = select(_e5010, _e5237, (_e5237 < _e5010));
let _e5243 = (((((_e3047.z + (_e4892 * _e5217)) - _e3726.member_2) / _e5017) * _e5015) - 0.5f);
let _e5245 = select(0f, _e5243, (_e5243 > 0f));
let _e5247 = select(_e5021, _e5245, (_e5245 < _e5021));
let _e5249 = select(0f, _e5231, (_e5231 > 0f));
let _e5251 = select(1e6f, _e5249, (_e5249 < 1e6f));
let _e5258 = select(0i, select(select(i32(_e5251), i32(-2147483648), (_e5251 < -2147483600f)), 2147483647i, (_e5251 > 2147483500f)), (_e5251 == _e5251));
let _e5262 = (_e5258 - select(0i, 1i, (_e5251 < f32(_e5258))));
let _e5264 = select(0f, _e5239, (_e5239 > 0f));
let _e5266 = select(1e6f, _e5264, (_e5264 < 1e6f));
let _e5273 = select(0i, select(select(i32(_e5266), i32(-2147483648), (_e5266 < -2147483600f)), 2147483647i, (_e5266 > 2147483500f)), (_e5266 == _e5266));
let _e5277 = (_e5273 - select(0i, 1i, (_e5266 < f32(_e5273))));
let _e5279 = select(0f, _e5247, (_e5247 > 0f));
let _e5281 = select(1e6f, _e5279, (_e5279 < 1e6f));
let _e5288 = select(0i, select(select(i32(_e5281), i32(-2147483648), (_e5281 < -2147483600f)), 2147483647i, (_e5281 > 2147483500f)), (_e5281 == _e5281));
let _e5292 = (_e5288 - select(0i, 1i, (_e5281 < f32(_e5288))));
let _e5296 = (_e5239 - f32(_e5277));
let _e5298 = (_e5247 - f32(_e5292));
local_15 = (_e5231 - f32(_e5262));
let _e5299 = (_e5262 + 1i);
let _e5301 = select(_e5299, 0i, (_e5299 < 0i));
if (_e5301 >= _e4984) {
phi_8765_ = (_e4984 - 1i);
} else {
phi_8765_ = _e5301;
}
let _e5305 = phi_8765_;
local_16 = (_e5305 - _e5262);
let _e5307 = (_e5277 + 1i);
let _e5309 = select(_e5307, 0i, (_e5307 < 0i));
if (_e5309 >= _e4988) {
phi_8778_ = (_e4988 - 1i);
} else {
phi_8778_ = _e5309;
}
let _e5313 = phi_8778_;
let _e5315 = ((_e5313 - _e5277) * _e4984);
let _e5316 = (_e5292 + 1i);
let _e5318 = select(_e5316, 0i, (_e5316 < 0i));
if (_e5318 >= _e4992) {
phi_8792_ = (_e4992 - 1i);
} else {
phi_8792_ = _e5318;
}
let _e5322 = phi_8792_;
let _e5330 = ((_e5107 + (((_e5292 * _e4988) + _e5277) * _e4984)) + _e5262);
let _e5332 = select(_e5114, _e5330, (_e5330 < _e5114));
let _e5337 = global_7.member[bitcast<u32>(select(0i, _e5332, (_e5332 > 0i)))];
let _e5338 = local_15;
let _e5341 = local_16;
let _e5342 = (_e5330 + _e5341);
let _e5344 = select(_e5114, _e5342, (_e5342 < _e5114));
let _e5349 = global_7.member[bitcast<u32>(select(0i, _e5344, (_e5344 > 0i)))];
let _e5350 = local_15;
let _e5353 = (1f - _e5296);
let _e5355 = (_e5330 + _e5315);
let _e5357 = select(_e5114, _e5355, (_e5355 < _e5114));
let _e5362 = global_7.member[bitcast<u32>(select(0i, _e5357, (_e5357 > 0i)))];
let _e5363 = local_15;
let _e5366 = local_16;
let _e5367 = (_e5355 + _e5366);
let _e5369 = select(_e5114, _e5367, (_e5367 < _e5114));
let _e5374 = global_7.member[bitcast<u32>(select(0i, _e5369, (_e5369 > 0i)))];
let _e5375 = local_15;
let _e5380 = (_e5330 + (((_e5322 - _e5292) * _e4984) * _e4988));
let _e5382 = select(_e5114, _e5380, (_e5380 < _e5114));
let _e5387 = global_7.member[bitcast<u32>(select(0i, _e5382, (_e5382 > 0i)))];
let _e5388 = local_15;
let _e5391 = local_16;
let _e5392 = (_e5380 + _e5391);
let _e5394 = select(_e5114, _e5392, (_e5392 < _e5114));
let _e5399 = global_7.member[bitcast<u32>(select(0i, _e5394, (_e5394 > 0i)))];
let _e5400 = local_15;
let _e5404 = (_e5380 + _e5315);
let _e5406 = select(_e5114, _e5404, (_e5404 < _e5114));
let _e5411 = global_7.member[bitcast<u32>(select(0i, _e5406, (_e5406 > 0i)))];
let _e5412 = local_15;
let _e5415 = local_16;
let _e5416 = (_e5404 + _e5415);
let _e5418 = select(_e5114, _e5416, (_e5416 < _e5114));
let _e5423 = global_7.member[bitcast<u32>(select(0i, _e5418, (_e5418 > 0i)))];
let _e5424 = local_15;
phi_8279_ = (_e4960 + 1u);
phi_8282_ = (_e4962 + ((0.5f * (((((((_e5121 * (1f - _e5122)) + (_e5133 * _e5134)) * _e5137) + (((_e5146 * (1f - _e5147)) + (_e5158 * _e5159)) * _e5074)) * (1f - _e5076)) + (((((_e5171 * (1f - _e5172)) + (_e5183 * _e5184)) * _e5137) + (((_e5195 * (1f - _e5196)) + (_e5207 * _e5208)) * _e5074)) * _e5076)) + ((((((_e5337 * (1f - _e5338)) + (_e5349 * _e5350)) * _e5353) + (((_e5362 * (1f - _e5363)) + (_e5374 * _e5375)) * _e5296)) * (1f - _e5298)) + (((((_e5387 * (1f - _e5388)) + (_e5399 * _e5400)) * _e5353) + (((_e5411 * (1f - _e5412)) + (_e5423 * _e5424)) * _e5296)) * _e5298)))) * _e4972));
} else {
phi_8279_ = u32();
phi_8282_ = f32();
}
let _e5439 = phi_8279_;
let _e5441 = phi_8282_;
continue;
continuing {
phi_8278_ = _e5439;
phi_8281_ = _e5441;
break if !(_e4965);
}
}
let _e11157 = local_78;
phi_8997_ = _e11157;
}
let _e5444 = phi_8997_;
let _e5445 = (_e5444 + select((_e2181 + (_e3307 * (0.5f + (0.5f * 0.8611363f)))), select(0f, _e4524, (_e4524 > 0f)), _e853));
let _e5447 = -((_e4267.member * _e5445));
let _e5449 = select(-87f, _e5447, (_e5447 > -87f));
let _e5451 = select(88f, _e5449, (_e5449 < 88f));
let _e5453 = ((_e5451 * 1.442695f) + 0.5f);
let _e5455 = select(-127f, _e5453, (_e5453 > -127f));
let _e5457 = select(128f, _e5455, (_e5455 < 128f));
let _e5464 = select(0i, select(select(i32(_e5457), i32(-2147483648), (_e5457 < -2147483600f)), 2147483647i, (_e5457 > 2147483500f)), (_e5457 == _e5457));
let _e5468 = (_e5464 - select(0i, 1i, (_e5457 < f32(_e5464))));
let _e5469 = f32(_e5468);
let _e5473 = ((_e5451 - (_e5469 * 0.6933594f)) - (_e5469 * -2.1219444e-4f));
let _e5495 = -((_e4267.member_1 * _e5445));
let _e5497 = select(-87f, _e5495, (_e5495 > -87f));
let _e5499 = select(88f, _e5497, (_e5497 < 88f));
let _e5501 = ((_e5499 * 1.442695f) + 0.5f);
let _e5503 = select(-127f, _e5501, (_e5501 > -127f));
let _e5505 = select(128f, _e5503, (_e5503 < 128f));
let _e5512 = select(0i, select(select(i32(_e5505), i32(-2147483648), (_e5505 < -2147483600f)), 2147483647i, (_e5505 > 2147483500f)), (_e5505 == _e5505));
let _e5516 = (_e5512 - select(0i, 1i, (_e5505 < f32(_e5512))));
let _e5517 = f32(_e5516);
let _e5521 = ((_e5499 - (_e5517 * 0.6933594f)) - (_e5517 * -2.1219444e-4f));
let _e5543 = -((_e4267.member_2 * _e5445));
let _e5545 = select(-87f, _e5543, (_e5543 > -87f));
let _e5547 = select(88f, _e5545, (_e5545 < 88f));
let _e5549 = ((_e5547 * 1.442695f) + 0.5f);
let _e5551 = select(-127f, _e5549, (_e5549 > -127f));
let _e5553 = select(128f, _e5551, (_e5551 < 128f));
let _e5560 = select(0i, select(select(i32(_e5553), i32(-2147483648), (_e5553 < -2147483600f)), 2147483647i, (_e5553 > 2147483500f)), (_e5553 == _e5553));
let _e5564 = (_e5560 - select(0i, 1i, (_e5553 < f32(_e5560))));
let _e5565 = f32(_e5564);
let _e5569 = ((_e5547 - (_e5565 * 0.6933594f)) - (_e5565 * -2.1219444e-4f));
let _e5595 = -((((_e4870.member.x * _e512) + (_e4870.member.y * _e523)) + (_e4870.member.z * _e534)));
let _e5597 = (_e4425 - (_e4426 * _e5595));
let _e5599 = select(1e-9f, _e5597, (_e5597 > 1e-9f));
if _e4445 {
let _e5610 = (0.5f - (0.5f * _e5595));
let _e5612 = select(0f, _e5610, (_e5610 > 0f));
let _e5616 = (sqrt(select(0f, _e5612, (_e5612 > 0f))) * 255f);
let _e5617 = (255f - 1f);
let _e5619 = select(0f, _e5616, (_e5616 > 0f));
let _e5621 = select(_e5617, _e5619, (_e5619 < _e5617));
let _e5628 = select(0i, select(select(i32(_e5621), i32(-2147483648), (_e5621 < -2147483600f)), 2147483647i, (_e5621 > 2147483500f)), (_e5621 == _e5621));
let _e5632 = (_e5628 - select(0i, 1i, (_e5621 < f32(_e5628))));
let _e5635 = global_1.member.member_13.member_11;
let _e5636 = bitcast<i32>(_e5635);
let _e5637 = (_e5636 + _e5632);
let _e5639 = (bitcast<i32>(_e187) - 1i);
let _e5641 = select(_e5639, _e5637, (_e5637 < _e5639));
let _e5646 = global_7.member[bitcast<u32>(select(0i, _e5641, (_e5641 > 0i)))];
let _e5648 = (_e5636 + (_e5632 + 1i));
let _e5650 = select(_e5639, _e5648, (_e5648 < _e5639));
let _e5655 = global_7.member[bitcast<u32>(select(0i, _e5650, (_e5650 > 0i)))];
phi_9358_ = (_e5646 + ((_e5655 - _e5646) * (_e5616 - f32(_e5632))));
} else {
phi_9358_ = select((_e4431 / (_e5599 * sqrt(select(0f, _e5599, (_e5599 > 0f))))), (0.75f * (1f + (_e5595 * _e5595))), _e4443);
}
let _e5662 = phi_9358_;
let _e5666 = ((3.1415927f * (_e5662 * _e4500)) * (_e3039 * _e3297));
let _e5683 = (_e2488 - _e846);
if _e3326 {
let _e6022 = global_1.member.member_10.member_1;
phi_9936_ = type_26(vec3<f32>(_e6022.member, _e6022.member_1, _e6022.member_2), _e3322);
} else {
let _e5692 = (_e2497.x - _e3675.member);
let _e5694 = (_e2497.y - _e3675.member_1);
let _e5696 = (_e2497.z - _e3675.member_2);
let _e5701 = (((_e5692 * _e5692) + (_e5694 * _e5694)) + (_e5696 * _e5696));
let _e5703 = select(1e-12f, _e5701, (_e5701 > 1e-12f));
let _e5704 = (1f / _e5703);
let _e5708 = vec3<f32>((_e3318.member * _e5704), (_e3318.member_1 * _e5704), (_e3318.member_2 * _e5704));
if (_e3325 == 2u) {
let _e5712 = global_1.member.member_10.member_1;
let _e5720 = (((_e5712.member * _e5692) + (_e5712.member_1 * _e5694)) + (_e5712.member_2 * _e5696));
let _e5723 = (1f / select(1e-20f, _e5720, (_e5720 > 1e-20f)));
let _e5727 = global_1.member.member_10.member_4.member;
let _e5736 = ((((_e5727.member * _e5692) + (_e5727.member_1 * _e5694)) + (_e5727.member_2 * _e5696)) * _e5723);
let _e5740 = global_1.member.member_10.member_4.member_1;
let _e5749 = ((((_e5740.member * _e5692) + (_e5740.member_1 * _e5694)) + (_e5740.member_2 * _e5696)) * _e5723);
let _e5753 = global_1.member.member_10.member_4.member_2;
let _e5756 = ((_e5736 * _e5736) + (_e5749 * _e5749));
let _e5764 = global_1.member.member_10.member_4.member_3;
let _e5765 = ((_e5753 - sqrt(select(0f, _e5756, (_e5756 > 0f)))) * _e5764);
let _e5767 = select(0f, _e5765, (_e5765 > 0f));
let _e5769 = select(1f, _e5767, (_e5767 < 1f));
let _e5775 = select(0f, ((_e5769 * _e5769) * (3f - (2f * _e5769))), (_e5720 > 0f));
let _e5779 = global_1.member.member_10.member_4.member_5;
if ((_e5779 > 0u) && (_e5775 > 0f)) {
let _e5784 = (0.5f / _e5753);
let _e5793 = global_1.member.member_10.member_4.member_6;
let _e5794 = bitcast<i32>(_e5793);
local_14 = bitcast<i32>(_e5779);
let _e5795 = local_14;
let _e5797 = f32((_e5795 - 1i));
let _e5799 = f32((_e5794 - 1i));
let _e5800 = local_14;
let _e5803 = (((0.5f + (_e5736 * _e5784)) * f32(_e5800)) - 0.5f);
let _e5805 = select(0f, _e5803, (_e5803 > 0f));
let _e5807 = select(_e5797, _e5805, (_e5805 < _e5797));
let _e5810 = (((0.5f - (_e5749 * _e5784)) * f32(_e5794)) - 0.5f);
let _e5812 = select(0f, _e5810, (_e5810 > 0f));
let _e5814 = select(_e5799, _e5812, (_e5812 < _e5799));
let _e5816 = select(0f, _e5807, (_e5807 > 0f));
let _e5818 = select(_e5797, _e5816, (_e5816 < _e5797));
let _e5825 = select(0i, select(select(i32(_e5818), i32(-2147483648), (_e5818 < -2147483600f)), 2147483647i, (_e5818 > 2147483500f)), (_e5818 == _e5818));
let _e5829 = (_e5825 - select(0i, 1i, (_e5818 < f32(_e5825))));
let _e5831 = select(0f, _e5814, (_e5814 > 0f));
let _e5833 = select(_e5799, _e5831, (_e5831 < _e5799));
let _e5840 = select(0i, select(select(i32(_e5833), i32(-2147483648), (_e5833 < -2147483600f)), 2147483647i, (_e5833 > 2147483500f)), (_e5833 == _e5833));
let _e5844 = (_e5840 - select(0i, 1i, (_e5833 < f32(_e5840))));
let _e5846 = (_e5807 - f32(_e5829));
let _e5848 = (_e5814 - f32(_e5844));
let _e5849 = (_e5829 + 1i);
let _e5850 = local_14;
let _e5852 = select(_e5829, _e5849, (_e5849 < _e5850));
let _e5853 = (_e5844 + 1i);
let _e5855 = select(_e5844, _e5853, (_e5853 < _e5794));
let _e5859 = global_1.member.member_10.member_4.member_4;
let _e5860 = bitcast<i32>(_e5859);
let _e5861 = local_14;
let _e5865 = (_e5860 + (3i * ((_e5844 * _e5861) + _e5829)));
let _e5867 = (bitcast<i32>(_e180) - 1i);
let _e5869 = select(_e5867, _e5865, (_e5865 < _e5867));
let _e5874 = global_3.member[bitcast<u32>(select(0i, _e5869, (_e5869 > 0i)))];
let _e5875 = (_e5865 + 1i);
let _e5877 = select(_e5867, _e5875, (_e5875 < _e5867));
let _e5882 = global_3.member[bitcast<u32>(select(0i, _e5877, (_e5877 > 0i)))];
let _e5883 = (_e5865 + 2i);
let _e5885 = select(_e5867, _e5883, (_e5883 < _e5867));
let _e5890 = global_3.member[bitcast<u32>(select(0i, _e5885, (_e5885 > 0i)))];
let _e5891 = local_14;
let _e5895 = (_e5860 + (3i * ((_e5844 * _e5891) + _e5852)));
let _e5897 = select(_e5867, _e5895, (_e5895 < _e5867));
let _e5902 = global_3.member[bitcast<u32>(select(0i, _e5897, (_e5897 > 0i)))];
let _e5903 = (_e5895 + 1i);
let _e5905 = select(_e5867, _e5903, (_e5903 < _e5867));
let _e5910 = global_3.member[bitcast<u32>(select(0i, _e5905, (_e5905 > 0i)))];
let _e5911 = (_e5895 + 2i);
let _e5913 = select(_e5867, _e5911, (_e5911 < _e5867));
let _e5918 = global_3.member[bitcast<u32>(select(0i, _e5913, (_e5913 > 0i)))];
let _e5919 = local_14;
let _e5923 = (_e5860 + (3i * ((_e5855 * _e5919) + _e5829)));
let _e5925 = select(_e5867, _e5923, (_e5923 < _e5867));
let _e5930 = global_3.member[bitcast<u32>(select(0i, _e5925, (_e5925 > 0i)))];
let _e5931 = (_e5923 + 1i);
let _e5933 = select(_e5867, _e5931, (_e5931 < _e5867));
let _e5938 = global_3.member[bitcast<u32>(select(0i, _e5933, (_e5933 > 0i)))];
let _e5939 = (_e5923 + 2i);
let _e5941 = select(_e5867, _e5939, (_e5939 < _e5867));
let _e5946 = global_3.member[bitcast<u32>(select(0i, _e5941, (_e5941 > 0i)))];
let _e5947 = local_14;
let _e5951 = (_e5860 + (3i * ((_e5855 * _e5947) + _e5852)));
let _e5953 = select(_e5867, _e5951, (_e5951 < _e5867));
let _e5958 = global_3.member[bitcast<u32>(select(0i, _e5953, (_e5953 > 0i)))];
let _e5959 = (_e5951 + 1i);
let _e5961 = select(_e5867, _e5959, (_e5959 < _e5867));
let _e5966 = global_3.member[bitcast<u32>(select(0i, _e5961, (_e5961 > 0i)))];
let _e5967 = (_e5951 + 2i);
let _e5969 = select(_e5867, _e5967, (_e5967 < _e5867));
let _e5974 = global_3.member[bitcast<u32>(select(0i, _e5969, (_e5969 > 0i)))];
let _e5981 = (_e5874 + ((_e5902 - _e5874) * _e5846));
let _e5982 = (_e5882 + ((_e5910 - _e5882) * _e5846));
let _e5983 = (_e5890 + ((_e5918 - _e5890) * _e5846));
phi_9920_ = vec3<f32>(((_e5981 + (((_e5930 + ((_e5958 - _e5930) * _e5846)) - _e5981) * _e5848)) * _e5775), ((_e5982 + (((_e5938 + ((_e5966 - _e5938) * _e5846)) - _e5982) * _e5848)) * _e5775), ((_e5983 + (((_e5946 + ((_e5974 - _e5946) * _e5846)) - _e5983) * _e5848)) * _e5775));
} else {
phi_9920_ = vec3(_e5775);
}
let _e6007 = phi_9920_;
phi_9923_ = (_e5708 * _e6007);
} else {
phi_9923_ = _e5708;
}
let _e6010 = phi_9923_;
let _e6014 = (1f / sqrt(select(0f, _e5703, (_e5703 > 0f))));
phi_9936_ = type_26(vec3<f32>((_e5692 * _e6014), (_e5694 * _e6014), (_e5696 * _e6014)), _e6010);
}
let _e6029 = phi_9936_;
let _e6032 = (_e3675.member - _e2497.x);
let _e6034 = (_e3675.member_1 - _e2497.y);
let _e6036 = (_e3675.member_2 - _e2497.z);
let _e6041 = (((_e6032 * _e6032) + (_e6034 * _e6034)) + (_e6036 * _e6036));
let _e6045 = select(sqrt(select(0f, _e6041, (_e6041 > 0f))), 1e30f, _e3326);
let _e6047 = -(_e6029.member.x);
let _e6049 = -(_e6029.member.y);
let _e6051 = -(_e6029.member.z);
let _e6059 = (1f / select(_e6047, select(1e-12f, -1e-12f, (_e6047 < 0f)), (bitcast<f32>((bitcast<u32>(_e6047) & 2147483647u)) < 1e-12f)));
let _e6067 = (1f / select(_e6049, select(1e-12f, -1e-12f, (_e6049 < 0f)), (bitcast<f32>((bitcast<u32>(_e6049) & 2147483647u)) < 1e-12f)));
let _e6075 = (1f / select(_e6051, select(1e-12f, -1e-12f, (_e6051 < 0f)), (bitcast<f32>((bitcast<u32>(_e6051) & 2147483647u)) < 1e-12f)));
let _e6077 = ((_e3726.member - _e2497.x) * _e6059);
let _e6079 = ((_e3732.member - _e2497.x) * _e6059);
let _e6081 = ((_e3726.member_1 - _e2497.y) * _e6067);
let _e6083 = ((_e3732.member_1 - _e2497.y) * _e6067);
let _e6085 = ((_e3726.member_2 - _e2497.z) * _e6075);
let _e6087 = ((_e3732.member_2 - _e2497.z) * _e6075);
let _e6089 = select(_e6079, _e6077, (_e6077 < _e6079));
let _e6091 = select(_e6083, _e6081, (_e6081 < _e6083));
let _e6093 = select(_e6091, _e6089, (_e6089 > _e6091));
let _e6095 = select(_e6087, _e6085, (_e6085 < _e6087));
let _e6097 = select(_e6095, _e6093, (_e6093 > _e6095));
let _e6099 = select(_e6079, _e6077, (_e6077 > _e6079));
let _e6101 = select(_e6083, _e6081, (_e6081 > _e6083));
let _e6103 = select(_e6101, _e6099, (_e6099 < _e6101));
let _e6105 = select(_e6087, _e6085, (_e6085 > _e6087));
let _e6107 = select(_e6105, _e6103, (_e6103 < _e6105));
let _e6109 = select(0f, _e6097, (_e6097 > 0f));
let _e6111 = select(_e6045, _e6107, (_e6107 < _e6045));
let _e6112 = (_e6111 > _e6109);
let _e6113 = select(0f, _e6109, _e6112);
let _e6115 = (select(0f, _e6111, _e6112) - _e6113);
if _e2221 {
phi_10851_ = _e6115;
} else {
let _e6117 = (_e6115 / f32(_e2220));
phi_10132_ = 0u;
phi_10135_ = 0f;
loop {
let _e6119 = phi_10132_;
let _e6121 = phi_10135_;
local_79 = _e6121;
let _e6124 = ((_e6119 < _e2220) && (_e6115 > 0f));
if _e6124 {
let _e6127 = (_e6113 + (_e6117 * f32(_e6119)));
let _e6128 = (_e6127 + _e6117);
let _e6130 = (0.5f * (_e6127 + _e6128));
let _e6131 = (_e6128 - _e6127);
let _e6132 = (0.28867513f * _e6131);
let _e6133 = (_e6130 - _e6132);
let _e6142 = global_1.member.member_13.member_7;
let _e6143 = bitcast<i32>(_e6142);
let _e6146 = global_1.member.member_13.member_8;
let _e6147 = bitcast<i32>(_e6146);
let _e6150 = global_1.member.member_13.member_9;
let _e6151 = bitcast<i32>(_e6150);
let _e6152 = f32(_e6143);
let _e6154 = (_e3732.member - _e3726.member);
let _e6157 = (((((_e2497.x + (_e6047 * _e6133)) - _e3726.member) / _e6154) * _e6152) - 0.5f);
let _e6158 = (_e6152 - 1f);
let _e6160 = select(0f, _e6157, (_e6157 > 0f));
let _e6162 = select(_e6158, _e6160, (_e6160 < _e6158));
let _e6163 = f32(_e6147);
let _e6165 = (_e3732.member_1 - _e3726.member_1);
let _e6168 = (((((_e2497.y + (_e6049 * _e6133)) - _e3726.member_1) / _e6165) * _e6163) - 0.5f);
let _e6169 = (_e6163 - 1f);
let _e6171 = select(0f, _e6168, (_e6168 > 0f));
let _e6173 = select(_e6169, _e6171, (_e6171 < _e6169));
let _e6174 = f32(_e6151);
let _e6176 = (_e3732.member_2 - _e3726.member_2);
let _e6179 = (((((_e2497.z + (_e6051 * _e6133)) - _e3726.member_2) / _e6176) * _e6174) - 0.5f);
let _e6180 = (_e6174 - 1f);
let _e6182 = select(0f, _e6179, (_e6179 > 0f));
let _e6184 = select(_e6180, _e6182, (_e6182 < _e6180));
let _e6186 = select(0f, _e6162, (_e6162 > 0f));
let _e6188 = select(1e6f, _e6186, (_e6186 < 1e6f));
let _e6195 = select(0i, select(select(i32(_e6188), i32(-2147483648), (_e6188 < -2147483600f)), 2147483647i, (_e6188 > 2147483500f)), (_e6188 == _e6188));
let _e6199 = (_e6195 - select(0i, 1i, (_e6188 < f32(_e6195))));
let _e6201 = select(0f, _e6173, (_e6173 > 0f));
let _e6203 = select(1e6f, _e6201, (_e6201 < 1e6f));
let _e6210 = select(0i, select(select(i32(_e6203), i32(-2147483648), (_e6203 < -2147483600f)), 2147483647i, (_e6203 > 2147483500f)), (_e6203 == _e6203));
let _e6214 = (_e6210 - select(0i, 1i, (_e6203 < f32(_e6210))));
let _e6216 = select(0f, _e6184, (_e6184 > 0f));
let _e6218 = select(1e6f, _e6216, (_e6216 < 1e6f));
let _e6225 = select(0i, select(select(i32(_e6218), i32(-2147483648), (_e6218 < -2147483600f)), 2147483647i, (_e6218 > 2147483500f)), (_e6218 == _e6218));
let _e6229 = (_e6225 - select(0i, 1i, (_e6218 < f32(_e6225))));
let _e6233 = (_e6173 - f32(_e6214));
let _e6235 = (_e6184 - f32(_e6229));
local_12 = (_e6162 - f32(_e6199));
let _e6236 = (_e6199 + 1i);
let _e6238 = select(_e6236, 0i, (_e6236 < 0i));
if (_e6238 >= _e6143) {
phi_10273_ = (_e6143 - 1i);
} else {
phi_10273_ = _e6238;
}
let _e6242 = phi_10273_;
local_13 = (_e6242 - _e6199);
let _e6244 = (_e6214 + 1i);
let _e6246 = select(_e6244, 0i, (_e6244 < 0i));
if (_e6246 >= _e6147) {
phi_10286_ = (_e6147 - 1i);
} else {
phi_10286_ = _e6246;
}
let _e6250 = phi_10286_;
let _e6252 = ((_e6250 - _e6214) * _e6143);
let _e6253 = (_e6229 + 1i);
let _e6255 = select(_e6253, 0i, (_e6253 < 0i));
if (_e6255 >= _e6151) {
phi_10300_ = (_e6151 - 1i);
} else {
phi_10300_ = _e6255;
}
let _e6259 = phi_10300_;
let _e6265 = global_1.member.member_13.member_10;
let _e6266 = bitcast<i32>(_e6265);
let _e6271 = ((_e6266 + (((_e6229 * _e6147) + _e6214) * _e6143)) + _e6199);
let _e6273 = (bitcast<i32>(_e187) - 1i);
let _e6275 = select(_e6273, _e6271, (_e6271 < _e6273));
let _e6280 = global_7.member[bitcast<u32>(select(0i, _e6275, (_e6275 > 0i)))];
let _e6281 = local_12;
let _e6284 = local_13;
let _e6285 = (_e6271 + _e6284);
let _e6287 = select(_e6273, _e6285, (_e6285 < _e6273));
let _e6292 = global_7.member[bitcast<u32>(select(0i, _e6287, (_e6287 > 0i)))];
let _e6293 = local_12;
let _e6296 = (1f - _e6233);
let _e6298 = (_e6271 + _e6252);
let _e6300 = select(_e6273, _e6298, (_e6298 < _e6273));
let _e6305 = global_7.member[bitcast<u32>(select(0i, _e6300, (_e6300 > 0i)))];
let _e6306 = local_12;
let _e6309 = local_13;
let _e6310 = (_e6298 + _e6309);
let _e6312 = select(_e6273, _e6310, (_e6310 < _e6273));
let _e6317 = global_7.member[bitcast<u32>(select(0i, _e6312, (_e6312 > 0i)))];
let _e6318 = local_12;
let _e6323 = (_e6271 + (((_e6259 - _e6229) * _e6143) * _e6147));
let _e6325 = select(_e6273, _e6323, (_e6323 < _e6273));
let _e6330 = global_7.member[bitcast<u32>(select(0i, _e6325, (_e6325 > 0i)))];
let _e6331 = local_12;
let _e6334 = local_13;
let _e6335 = (_e6323 + _e6334);
let _e6337 = select(_e6273, _e6335, (_e6335 < _e6273));
let _e6342 = global_7.member[bitcast<u32>(select(0i, _e6337, (_e6337 > 0i)))];
let _e6343 = local_12;
let _e6347 = (_e6323 + _e6252);
let _e6349 = select(_e6273, _e6347, (_e6347 < _e6273));
let _e6354 = global_7.member[bitcast<u32>(select(0i, _e6349, (_e6349 > 0i)))];
let _e6355 = local_12;
let _e6358 = local_13;
let _e6359 = (_e6347 + _e6358);
let _e6361 = select(_e6273, _e6359, (_e6359 < _e6273));
let _e6366 = global_7.member[bitcast<u32>(select(0i, _e6361, (_e6361 > 0i)))];
let _e6367 = local_12;
let _e6376 = (_e6130 + _e6132);
let _e6386 = (((((_e2497.x + (_e6047 * _e6376)) - _e3726.member) / _e6154) * _e6152) - 0.5f);
let _e6388 = select(0f, _e6386, (_e6386 > 0f));
let _e6390 = select(_e6158, _e6388, (_e6388 < _e6158));
let _e6394 = (((((_e2497.y + (_e6049 * _e6376)) - _e3726.member_1) / _e6165) * _e6163) - 0.5f);
let _e6396 = select(0f, _e6394, (_e6394 > 0f));
let _e6398 = select(_e6169, _e6396, (_e6396 < _e6169));
let _e6402 = (((((_e2497.z + (_e6051 * _e6376)) - _e3726.member_2) / _e6176) * _e6174) - 0.5f);
let _e6404 = select(0f, _e6402, (_e6402 > 0f));
let _e6406 = select(_e6180, _e6404, (_e6404 < _e6180));
let _e6408 = select(0f, _e6390, (_e6390 > 0f));
let _e6410 = select(1e6f, _e6408, (_e6408 < 1e6f));
let _e6417 = select(0i, select(select(i32(_e6410), i32(-2147483648), (_e6410 < -2147483600f)), 2147483647i, (_e6410 > 2147483500f)), (_e6410 == _e6410));
let _e6421 = (_e6417 - select(0i, 1i, (_e6410 < f32(_e6417))));
let _e6423 = select(0f, _e6398, (_e6398 > 0f));
let _e6425 = select(1e6f, _e6423, (_e6423 < 1e6f));
let _e6432 = select(0i, select(select(i32(_e6425), i32(-2147483648), (_e6425 < -2147483600f)), 2147483647i, (_e6425 > 2147483500f)), (_e6425 == _e6425));
let _e6436 = (_e6432 - select(0i, 1i, (_e6425 < f32(_e6432))));
let _e6438 = select(0f, _e6406, (_e6406 > 0f));
let _e6440 = select(1e6f, _e6438, (_e6438 < 1e6f));
let _e6447 = select(0i, select(select(i32(_e6440), i32(-2147483648), (_e6440 < -2147483600f)), 2147483647i, (_e6440 > 2147483500f)), (_e6440 == _e6440));
let _e6451 = (_e6447 - select(0i, 1i, (_e6440 < f32(_e6447))));
let _e6455 = (_e6398 - f32(_e6436));
let _e6457 = (_e6406 - f32(_e6451));
local_10 = (_e6390 - f32(_e6421));
let _e6458 = (_e6421 + 1i);
let _e6460 = select(_e6458, 0i, (_e6458 < 0i));
if (_e6460 >= _e6143) {
phi_10619_ = (_e6143 - 1i);
} else {
phi_10619_ = _e6460;
}
let _e6464 = phi_10619_;
local_11 = (_e6464 - _e6421);
let _e6466 = (_e6436 + 1i);
let _e6468 = select(_e6466, 0i, (_e6466 < 0i));
if (_e6468 >= _e6147) {
phi_10632_ = (_e6147 - 1i);
} else {
phi_10632_ = _e6468;
}
let _e6472 = phi_10632_;
let _e6474 = ((_e6472 - _e6436) * _e6143);
let _e6475 = (_e6451 + 1i);
let _e6477 = select(_e6475, 0i, (_e6475 < 0i));
if (_e6477 >= _e6151) {
phi_10646_ = (_e6151 - 1i);
} else {
phi_10646_ = _e6477;
}
let _e6481 = phi_10646_;
let _e6489 = ((_e6266 + (((_e6451 * _e6147) + _e6436) * _e6143)) + _e6421);
let _e6491 = select(_e6273, _e6489, (_e6489 < _e6273));
let _e6496 = global_7.member[bitcast<u32>(select(0i, _e6491, (_e6491 > 0i)))];
let _e6497 = local_10;
let _e6500 = local_11;
let _e6501 = (_e6489 + _e6500);
let _e6503 = select(_e6273, _e6501, (_e6501 < _e6273));
let _e6508 = global_7.member[bitcast<u32>(select(0i, _e6503, (_e6503 > 0i)))];
let _e6509 = local_10;
let _e6512 = (1f - _e6455);
let _e6514 = (_e6489 + _e6474);
let _e6516 = select(_e6273, _e6514, (_e6514 < _e6273));
let _e6521 = global_7.member[bitcast<u32>(select(0i, _e6516, (_e6516 > 0i)))];
let _e6522 = local_10;
let _e6525 = local_11;
let _e6526 = (_e6514 + _e6525);
let _e6528 = select(_e6273, _e6526, (_e6526 < _e6273));
let _e6533 = global_7.member[bitcast<u32>(select(0i, _e6528, (_e6528 > 0i)))];
let _e6534 = local_10;
let _e6539 = (_e6489 + (((_e6481 - _e6451) * _e6143) * _e6147));
let _e6541 = select(_e6273, _e6539, (_e6539 < _e6273));
let _e6546 = global_7.member[bitcast<u32>(select(0i, _e6541, (_e6541 > 0i)))];
let _e6547 = local_10;
let _e6550 = local_11;
let _e6551 = (_e6539 + _e6550);
let _e6553 = select(_e6273, _e6551, (_e6551 < _e6273));
let _e6558 = global_7.member[bitcast<u32>(select(0i, _e6553, (_e6553 > 0i)))];
let _e6559 = local_10;
let _e6563 = (_e6539 + _e6474);
let _e6565 = select(_e6273, _e6563, (_e6563 < _e6273));
let _e6570 = global_7.member[bitcast<u32>(select(0i, _e6565, (_e6565 > 0i)))];
let _e6571 = local_10;
let _e6574 = local_11;
let _e6575 = (_e6563 + _e6574);
let _e6577 = select(_e6273, _e6575, (_e6575 < _e6273));
let _e6582 = global_7.member[bitcast<u32>(select(0i, _e6577, (_e6577 > 0i)))];
let _e6583 = local_10;
phi_10133_ = (_e6119 + 1u);
phi_10136_ = (_e6121 + ((0.5f * (((((((_e6280 * (1f - _e6281)) + (_e6292 * _e6293)) * _e6296) + (((_e6305 * (1f - _e6306)) + (_e6317 * _e6318)) * _e6233)) * (1f - _e6235)) + (((((_e6330 * (1f - _e6331)) + (_e6342 * _e6343)) * _e6296) + (((_e6354 * (1f - _e6355)) + (_e6366 * _e6367)) * _e6233)) * _e6235)) + ((((((_e6496 * (1f - _e6497)) + (_e6508 * _e6509)) * _e6512) + (((_e6521 * (1f - _e6522)) + (_e6533 * _e6534)) * _e6455)) * (1f - _e6457)) + (((((_e6546 * (1f - _e6547)) + (_e6558 * _e6559)) * _e6512) + (((_e6570 * (1f - _e6571)) + (_e6582 * _e6583)) * _e6455)) * _e6457)))) * _e6131));
} else {
phi_10133_ = u32();
phi_10136_ = f32();
}
let _e6598 = phi_10133_;
let _e6600 = phi_10136_;
continue;
continuing {
phi_10132_ = _e6598;
phi_10135_ = _e6600;
break if !(_e6124);
}
}
let _e11174 = local_79;
phi_10851_ = _e11174;
}
let _e6603 = phi_10851_;
let _e6604 = (_e6603 + select((_e2181 + (_e3307 * (0.5f + (0.5f * _e2472)))), select(0f, _e5683, (_e5683 > 0f)), _e853));
let _e6606 = -((_e4267.member * _e6604));
let _e6608 = select(-87f, _e6606, (_e6606 > -87f));
let _e6610 = select(88f, _e6608, (_e6608 < 88f));
let _e6612 = ((_e6610 * 1.442695f) + 0.5f);
let _e6614 = select(-127f, _e6612, (_e6612 > -127f));
let _e6616 = select(128f, _e6614, (_e6614 < 128f));
let _e6623 = select(0i, select(select(i32(_e6616), i32(-2147483648), (_e6616 < -2147483600f)), 2147483647i, (_e6616 > 2147483500f)), (_e6616 == _e6616));
let _e6627 = (_e6623 - select(0i, 1i, (_e6616 < f32(_e6623))));
let _e6628 = f32(_e6627);
let _e6632 = ((_e6610 - (_e6628 * 0.6933594f)) - (_e6628 * -2.1219444e-4f));
let _e6654 = -((_e4267.member_1 * _e6604));
let _e6656 = select(-87f, _e6654, (_e6654 > -87f));
let _e6658 = select(88f, _e6656, (_e6656 < 88f));
let _e6660 = ((_e6658 * 1.442695f) + 0.5f);
let _e6662 = select(-127f, _e6660, (_e6660 > -127f));
let _e6664 = select(128f, _e6662, (_e6662 < 128f));
let _e6671 = select(0i, select(select(i32(_e6664), i32(-2147483648), (_e6664 < -2147483600f)), 2147483647i, (_e6664 > 2147483500f)), (_e6664 == _e6664));
let _e6675 = (_e6671 - select(0i, 1i, (_e6664 < f32(_e6671))));
let _e6676 = f32(_e6675);
let _e6680 = ((_e6658 - (_e6676 * 0.6933594f)) - (_e6676 * -2.1219444e-4f));
let _e6702 = -((_e4267.member_2 * _e6604));
let _e6704 = select(-87f, _e6702, (_e6702 > -87f));
let _e6706 = select(88f, _e6704, (_e6704 < 88f));
let _e6708 = ((_e6706 * 1.442695f) + 0.5f);
let _e6710 = select(-127f, _e6708, (_e6708 > -127f));
let _e6712 = select(128f, _e6710, (_e6710 < 128f));
let _e6719 = select(0i, select(select(i32(_e6712), i32(-2147483648), (_e6712 < -2147483600f)), 2147483647i, (_e6712 > 2147483500f)), (_e6712 == _e6712));
let _e6723 = (_e6719 - select(0i, 1i, (_e6712 < f32(_e6719))));
let _e6724 = f32(_e6723);
let _e6728 = ((_e6706 - (_e6724 * 0.6933594f)) - (_e6724 * -2.1219444e-4f));
let _e6754 = -((((_e6029.member.x * _e512) + (_e6029.member.y * _e523)) + (_e6029.member.z * _e534)));
let _e6756 = (_e4425 - (_e4426 * _e6754));
let _e6758 = select(1e-9f, _e6756, (_e6756 > 1e-9f));
if _e4445 {
let _e6769 = (0.5f - (0.5f * _e6754));
let _e6771 = select(0f, _e6769, (_e6769 > 0f));
let _e6775 = (sqrt(select(0f, _e6771, (_e6771 > 0f))) * 255f);
let _e6776 = (255f - 1f);
let _e6778 = select(0f, _e6775, (_e6775 > 0f));
let _e6780 = select(_e6776, _e6778, (_e6778 < _e6776));
let _e6787 = select(0i, select(select(i32(_e6780), i32(-2147483648), (_e6780 < -2147483600f)), 2147483647i, (_e6780 > 2147483500f)), (_e6780 == _e6780));
let _e6791 = (_e6787 - select(0i, 1i, (_e6780 < f32(_e6787))));
let _e6794 = global_1.member.member_13.member_11;
let _e6795 = bitcast<i32>(_e6794);
let _e6796 = (_e6795 + _e6791);
let _e6798 = (bitcast<i32>(_e187) - 1i);
let _e6800 = select(_e6798, _e6796, (_e6796 < _e6798));
let _e6805 = global_7.member[bitcast<u32>(select(0i, _e6800, (_e6800 > 0i)))];
let _e6807 = (_e6795 + (_e6791 + 1i));
let _e6809 = select(_e6798, _e6807, (_e6807 < _e6798));
let _e6814 = global_7.member[bitcast<u32>(select(0i, _e6809, (_e6809 > 0i)))];
phi_11212_ = (_e6805 + ((_e6814 - _e6805) * (_e6775 - f32(_e6791))));
} else {
phi_11212_ = select((_e4431 / (_e6758 * sqrt(select(0f, _e6758, (_e6758 > 0f))))), (0.75f * (1f + (_e6754 * _e6754))), _e4443);
}
let _e6821 = phi_11212_;
let _e6825 = ((3.1415927f * (_e6821 * _e4500)) * (_e2489 * _e2747));
let _e6839 = (_e2763 - _e846);
if _e3326 {
let _e7178 = global_1.member.member_10.member_1;
phi_11786_ = type_26(vec3<f32>(_e7178.member, _e7178.member_1, _e7178.member_2), _e3322);
} else {
let _e6848 = (_e2772.x - _e3675.member);
let _e6850 = (_e2772.y - _e3675.member_1);
let _e6852 = (_e2772.z - _e3675.member_2);
let _e6857 = (((_e6848 * _e6848) + (_e6850 * _e6850)) + (_e6852 * _e6852));
let _e6859 = select(1e-12f, _e6857, (_e6857 > 1e-12f));
let _e6860 = (1f / _e6859);
let _e6864 = vec3<f32>((_e3318.member * _e6860), (_e3318.member_1 * _e6860), (_e3318.member_2 * _e6860));
if (_e3325 == 2u) {
let _e6868 = global_1.member.member_10.member_1;
let _e6876 = (((_e6868.member * _e6848) + (_e6868.member_1 * _e6850)) + (_e6868.member_2 * _e6852));
let _e6879 = (1f / select(1e-20f, _e6876, (_e6876 > 1e-20f)));
let _e6883 = global_1.member.member_10.member_4.member;
let _e6892 = ((((_e6883.member * _e6848) + (_e6883.member_1 * _e6850)) + (_e6883.member_2 * _e6852)) * _e6879);
let _e6896 = global_1.member.member_10.member_4.member_1;
let _e6905 = ((((_e6896.member * _e6848) + (_e6896.member_1 * _e6850)) + (_e6896.member_2 * _e6852)) * _e6879);
let _e6909 = global_1.member.member_10.member_4.member_2;
let _e6912 = ((_e6892 * _e6892) + (_e6905 * _e6905));
let _e6920 = global_1.member.member_10.member_4.member_3;
let _e6921 = ((_e6909 - sqrt(select(0f, _e6912, (_e6912 > 0f)))) * _e6920);
let _e6923 = select(0f, _e6921, (_e6921 > 0f));
let _e6925 = select(1f, _e6923, (_e6923 < 1f));
let _e6931 = select(0f, ((_e6925 * _e6925) * (3f - (2f * _e6925))), (_e6876 > 0f));
let _e6935 = global_1.member.member_10.member_4.member_5;
if ((_e6935 > 0u) && (_e6931 > 0f)) {
let _e6940 = (0.5f / _e6909);
let _e6949 = global_1.member.member_10.member_4.member_6;
let _e6950 = bitcast<i32>(_e6949);
local_9 = bitcast<i32>(_e6935);
let _e6951 = local_9;
let _e6953 = f32((_e6951 - 1i));
let _e6955 = f32((_e6950 - 1i));
let _e6956 = local_9;
let _e6959 = (((0.5f + (_e6892 * _e6940)) * f32(_e6956)) - 0.5f);
let _e6961 = select(0f, _e6959, (_e6959 > 0f));
let _e6963 = select(_e6953, _e6961, (_e6961 < _e6953));
let _e6966 = (((0.5f - (_e6905 * _e6940)) * f32(_e6950)) - 0.5f);
let _e6968 = select(0f, _e6966, (_e6966 > 0f));
let _e6970 = select(_e6955, _e6968, (_e6968 < _e6955));
let _e6972 = select(0f, _e6963, (_e6963 > 0f));
let _e6974 = select(_e6953, _e6972, (_e6972 < _e6953));
let _e6981 = select(0i, select(select(i32(_e6974), i32(-2147483648), (_e6974 < -2147483600f)), 2147483647i, (_e6974 > 2147483500f)), (_e6974 == _e6974));
let _e6985 = (_e6981 - select(0i, 1i, (_e6974 < f32(_e6981))));
let _e6987 = select(0f, _e6970, (_e6970 > 0f));
let _e6989 = select(_e6955, _e6987, (_e6987 < _e6955));
let _e6996 = select(0i, select(select(i32(_e6989), i32(-2147483648), (_e6989 < -2147483600f)), 2147483647i, (_e6989 > 2147483500f)), (_e6989 == _e6989));
let _e7000 = (_e6996 - select(0i, 1i, (_e6989 < f32(_e6996))));
let _e7002 = (_e6963 - f32(_e6985));
let _e7004 = (_e6970 - f32(_e7000));
let _e7005 = (_e6985 + 1i);
let _e7006 = local_9;
let _e7008 = select(_e6985, _e7005, (_e7005 < _e7006));
let _e7009 = (_e7000 + 1i);
let _e7011 = select(_e7000, _e7009, (_e7009 < _e6950));
let _e7015 = global_1.member.member_10.member_4.member_4;
let _e7016 = bitcast<i32>(_e7015);
let _e7017 = local_9;
let _e7021 = (_e7016 + (3i * ((_e7000 * _e7017) + _e6985)));
let _e7023 = (bitcast<i32>(_e180) - 1i);
let _e7025 = select(_e7023, _e7021, (_e7021 < _e7023));
let _e7030 = global_3.member[bitcast<u32>(select(0i, _e7025, (_e7025 > 0i)))];
let _e7031 = (_e7021 + 1i);
let _e7033 = select(_e7023, _e7031, (_e7031 < _e7023));
let _e7038 = global_3.member[bitcast<u32>(select(0i, _e7033, (_e7033 > 0i)))];
let _e7039 = (_e7021 + 2i);
let _e7041 = select(_e7023, _e7039, (_e7039 < _e7023));
let _e7046 = global_3.member[bitcast<u32>(select(0i, _e7041, (_e7041 > 0i)))];
let _e7047 = local_9;
let _e7051 = (_e7016 + (3i * ((_e7000 * _e7047) + _e7008)));
let _e7053 = select(_e7023, _e7051, (_e7051 < _e7023));
let _e7058 = global_3.member[bitcast<u32>(select(0i, _e7053, (_e7053 > 0i)))];
let _e7059 = (_e7051 + 1i);
let _e7061 = select(_e7023, _e7059, (_e7059 < _e7023));
let _e7066 = global_3.member[bitcast<u32>(select(0i, _e7061, (_e7061 > 0i)))];
let _e7067 = (_e7051 + 2i);
let _e7069 = select(_e7023, _e7067, (_e7067 < _e7023));
let _e7074 = global_3.member[bitcast<u32>(select(0i, _e7069, (_e7069 > 0i)))];
let _e7075 = local_9;
let _e7079 = (_e7016 + (3i * ((_e7011 * _e7075) + _e6985)));
let _e7081 = select(_e7023, _e7079, (_e7079 < _e7023));
let _e7086 = global_3.member[bitcast<u32>(select(0i, _e7081, (_e7081 > 0i)))];
let _e7087 = (_e7079 + 1i);
let _e7089 = select(_e7023, _e7087, (_e7087 < _e7023));
let _e7094 = global_3.member[bitcast<u32>(select(0i, _e7089, (_e7089 > 0i)))];
let _e7095 = (_e7079 + 2i);
let _e7097 = select(_e7023, _e7095, (_e7095 < _e7023));
let _e7102 = global_3.member[bitcast<u32>(select(0i, _e7097, (_e7097 > 0i)))];
let _e7103 = local_9;
let _e7107 = (_e7016 + (3i * ((_e7011 * _e7103) + _e7008)));
let _e7109 = select(_e7023, _e7107, (_e7107 < _e7023));
let _e7114 = global_3.member[bitcast<u32>(select(0i, _e7109, (_e7109 > 0i)))];
let _e7115 = (_e7107 + 1i);
let _e7117 = select(_e7023, _e7115, (_e7115 < _e7023));
let _e7122 = global_3.member[bitcast<u32>(select(0i, _e7117, (_e7117 > 0i)))];
let _e7123 = (_e7107 + 2i);
let _e7125 = select(_e7023, _e7123, (_e7123 < _e7023));
let _e7130 = global_3.member[bitcast<u32>(select(0i, _e7125, (_e7125 > 0i)))];
let _e7137 = (_e7030 + ((_e7058 - _e7030) * _e7002));
let _e7138 = (_e7038 + ((_e7066 - _e7038) * _e7002));
let _e7139 = (_e7046 + ((_e7074 - _e7046) * _e7002));
phi_11770_ = vec3<f32>(((_e7137 + (((_e7086 + ((_e7114 - _e7086) * _e7002)) - _e7137) * _e7004)) * _e6931), ((_e7138 + (((_e7094 + ((_e7122 - _e7094) * _e7002)) - _e7138) * _e7004)) * _e6931), ((_e7139 + (((_e7102 + ((_e7130 - _e7102) * _e7002)) - _e7139) * _e7004)) * _e6931));
} else {
phi_11770_ = vec3(_e6931);
}
let _e7163 = phi_11770_;
phi_11773_ = (_e6864 * _e7163);
} else {
phi_11773_ = _e6864;
}
let _e7166 = phi_11773_;
let _e7170 = (1f / sqrt(select(0f, _e6859, (_e6859 > 0f))));
phi_11786_ = type_26(vec3<f32>((_e6848 * _e7170), (_e6850 * _e7170), (_e6852 * _e7170)), _e7166);
}
let _e7185 = phi_11786_;
let _e7188 = (_e3675.member - _e2772.x);
let _e7190 = (_e3675.member_1 - _e2772.y);
let _e7192 = (_e3675.member_2 - _e2772.z);
let _e7197 = (((_e7188 * _e7188) + (_e7190 * _e7190)) + (_e7192 * _e7192));
let _e7201 = select(sqrt(select(0f, _e7197, (_e7197 > 0f))), 1e30f, _e3326);
let _e7203 = -(_e7185.member.x);
let _e7205 = -(_e7185.member.y);
let _e7207 = -(_e7185.member.z);
let _e7215 = (1f / select(_e7203, select(1e-12f, -1e-12f, (_e7203 < 0f)), (bitcast<f32>((bitcast<u32>(_e7203) & 2147483647u)) < 1e-12f)));
let _e7223 = (1f / select(_e7205, select(1e-12f, -1e-12f, (_e7205 < 0f)), (bitcast<f32>((bitcast<u32>(_e7205) & 2147483647u)) < 1e-12f)));
let _e7231 = (1f / select(_e7207, select(1e-12f, -1e-12f, (_e7207 < 0f)), (bitcast<f32>((bitcast<u32>(_e7207) & 2147483647u)) < 1e-12f)));
let _e7233 = ((_e3726.member - _e2772.x) * _e7215);
let _e7235 = ((_e3732.member - _e2772.x) * _e7215);
let _e7237 = ((_e3726.member_1 - _e2772.y) * _e7223);
let _e7239 = ((_e3732.member_1 - _e2772.y) * _e7223);
let _e7241 = ((_e3726.member_2 - _e2772.z) * _e7231);
let _e7243 = ((_e3732.member_2 - _e2772.z) * _e7231);
let _e7245 = select(_e7235, _e7233, (_e7233 < _e7235));
let _e7247 = select(_e7239, _e7237, (_e7237 < _e7239));
let _e7249 = select(_e7247, _e7245, (_e7245 > _e7247));
let _e7251 = select(_e7243, _e7241, (_e7241 < _e7243));
let _e7253 = select(_e7251, _e7249, (_e7249 > _e7251));
let _e7255 = select(_e7235, _e7233, (_e7233 > _e7235));
let _e7257 = select(_e7239, _e7237, (_e7237 > _e7239));
let _e7259 = select(_e7257, _e7255, (_e7255 < _e7257));
let _e7261 = select(_e7243, _e7241, (_e7241 > _e7243));
let _e7263 = select(_e7261, _e7259, (_e7259 < _e7261));
let _e7265 = select(0f, _e7253, (_e7253 > 0f));
let _e7267 = select(_e7201, _e7263, (_e7263 < _e7201));
let _e7268 = (_e7267 > _e7265);
let _e7269 = select(0f, _e7265, _e7268);
let _e7271 = (select(0f, _e7267, _e7268) - _e7269);
if _e2221 {
phi_12701_ = _e7271;
} else {
let _e7273 = (_e7271 / f32(_e2220));
phi_11982_ = 0u;
phi_11985_ = 0f;
loop {
let _e7275 = phi_11982_;
let _e7277 = phi_11985_;
local_80 = _e7277;
let _e7280 = ((_e7275 < _e2220) && (_e7271 > 0f));
if _e7280 {
let _e7283 = (_e7269 + (_e7273 * f32(_e7275)));
let _e7284 = (_e7283 + _e7273);
let _e7286 = (0.5f * (_e7283 + _e7284));
let _e7287 = (_e7284 - _e7283);
let _e7288 = (0.28867513f * _e7287);
let _e7289 = (_e7286 - _e7288);
let _e7298 = global_1.member.member_13.member_7;
let _e7299 = bitcast<i32>(_e7298);
let _e7302 = global_1.member.member_13.member_8;
let _e7303 = bitcast<i32>(_e7302);
let _e7306 = global_1.member.member_13.member_9;
let _e7307 = bitcast<i32>(_e7306);
let _e7308 = f32(_e7299);
let _e7310 = (_e3732.member - _e3726.member);
let _e7313 = (((((_e2772.x + (_e7203 * _e7289)) - _e3726.member) / _e7310) * _e7308) - 0.5f);
let _e7314 = (_e7308 - 1f);
let _e7316 = select(0f, _e7313, (_e7313 > 0f));
let _e7318 = select(_e7314, _e7316, (_e7316 < _e7314));
let _e7319 = f32(_e7303);
let _e7321 = (_e3732.member_1 - _e3726.member_1);
let _e7324 = (((((_e2772.y + (_e7205 * _e7289)) - _e3726.member_1) / _e7321) * _e7319) - 0.5f);
let _e7325 = (_e7319 - 1f);
let _e7327 = select(0f, _e7324, (_e7324 > 0f));
let _e7329 = select(_e7325, _e7327, (_e7327 < _e7325));
let _e7330 = f32(_e7307);
let _e7332 = (_e3732.member_2 - _e3726.member_2);
let _e7335 = (((((_e2772.z + (_e7207 * _e7289)) - _e3726.member_2) / _e7332) * _e7330) - 0.5f);
let _e7336 = (_e7330 - 1f);
let _e7338 = select(0f, _e7335, (_e7335 > 0f));
let _e7340 = select(_e7336, _e7338, (_e7338 < _e7336));
let _e7342 = select(0f, _e7318, (_e7318 > 0f));
let _e7344 = select(1e6f, _e7342, (_e7342 < 1e6f));
let _e7351 = select(0i, select(select(i32(_e7344), i32(-2147483648), (_e7344 < -2147483600f)), 2147483647i, (_e7344 > 2147483500f)), (_e7344 == _e7344));
let _e7355 = (_e7351 - select(0i, 1i, (_e7344 < f32(_e7351))));
let _e7357 = select(0f, _e7329, (_e7329 > 0f));
let _e7359 = select(1e6f, _e7357, (_e7357 < 1e6f));
let _e7366 = select(0i, select(select(i32(_e7359), i32(-2147483648), (_e7359 < -2147483600f)), 2147483647i, (_e7359 > 2147483500f)), (_e7359 == _e7359));
let _e7370 = (_e7366 - select(0i, 1i, (_e7359 < f32(_e7366))));
let _e7372 = select(0f, _e7340, (_e7340 > 0f));
let _e7374 = select(1e6f, _e7372, (_e7372 < 1e6f));
let _e7381 = select(0i, select(select(i32(_e7374), i32(-2147483648), (_e7374 < -2147483600f)), 2147483647i, (_e7374 > 2147483500f)), (_e7374 == _e7374));
let _e7385 = (_e7381 - select(0i, 1i, (_e7374 < f32(_e7381))));
let _e7389 = (_e7329 - f32(_e7370));
let _e7391 = (_e7340 - f32(_e7385));
local_7 = (_e7318 - f32(_e7355));
let _e7392 = (_e7355 + 1i);
let _e7394 = select(_e7392, 0i, (_e7392 < 0i));
if (_e7394 >= _e7299) {
phi_12123_ = (_e7299 - 1i);
} else {
phi_12123_ = _e7394;
}
let _e7398 = phi_12123_;
local_8 = (_e7398 - _e7355);
let _e7400 = (_e7370 + 1i);
let _e7402 = select(_e7400, 0i, (_e7400 < 0i));
if (_e7402 >= _e7303) {
phi_12136_ = (_e7303 - 1i);
} else {
phi_12136_ = _e7402;
}
let _e7406 = phi_12136_;
let _e7408 = ((_e7406 - _e7370) * _e7299);
let _e7409 = (_e7385 + 1i);
let _e7411 = select(_e7409, 0i, (_e7409 < 0i));
if (_e7411 >= _e7307) {
phi_12150_ = (_e7307 - 1i);
} else {
phi_12150_ = _e7411;
}
let _e7415 = phi_12150_;
let _e7421 = global_1.member.member_13.member_10;
let _e7422 = bitcast<i32>(_e7421);
let _e7427 = ((_e7422 + (((_e7385 * _e7303) + _e7370) * _e7299)) + _e7355);
let _e7429 = (bitcast<i32>(_e187) - 1i);
let _e7431 = select(_e7429, _e7427, (_e7427 < _e7429));
let _e7436 = global_7.member[bitcast<u32>(select(0i, _e7431, (_e7431 > 0i)))];
let _e7437 = local_7;
let _e7440 = local_8;
let _e7441 = (_e7427 + _e7440);
let _e7443 = select(_e7429, _e7441, (_e7441 < _e7429));
let _e7448 = global_7.member[bitcast<u32>(select(0i, _e7443, (_e7443 > 0i)))];
let _e7449 = local_7;
let _e7452 = (1f - _e7389);
let _e7454 = (_e7427 + _e7408);
let _e7456 = select(_e7429, _e7454, (_e7454 < _e7429));
let _e7461 = global_7.member[bitcast<u32>(select(0i, _e7456, (_e7456 > 0i)))];
let _e7462 = local_7;
let _e7465 = local_8;
let _e7466 = (_e7454 + _e7465);
let _e7468 = select(_e7429, _e7466, (_e7466 < _e7429));
let _e7473 = global_7.member[bitcast<u32>(select(0i, _e7468, (_e7468 > 0i)))];
let _e7474 = local_7;
let _e7479 = (_e7427 + (((_e7415 - _e7385) * _e7299) * _e7303));
let _e7481 = select(_e7429, _e7479, (_e7479 < _e7429));
let _e7486 = global_7.member[bitcast<u32>(select(0i, _e7481, (_e7481 > 0i)))];
let _e7487 = local_7;
let _e7490 = local_8;
let _e7491 = (_e7479 + _e7490);
let _e7493 = select(_e7429, _e7491, (_e7491 < _e7429));
let _e7498 = global_7.member[bitcast<u32>(select(0i, _e7493, (_e7493 > 0i)))];
let _e7499 = local_7;
let _e7503 = (_e7479 + _e7408);
let _e7505 = select(_e7429, _e7503, (_e7503 < _e7429));
let _e7510 = global_7.member[bitcast<u32>(select(0i, _e7505, (_e7505 > 0i)))];
let _e7511 = local_7;
let _e7514 = local_8;
let _e7515 = (_e7503 + _e7514);
let _e7517 = select(_e7429, _e7515, (_e7515 < _e7429));
let _e7522 = global_7.member[bitcast<u32>(select(0i, _e7517, (_e7517 > 0i)))];
let _e7523 = local_7;
let _e7532 = (_e7286 + _e7288);
let _e7542 = (((((_e2772.x + (_e7203 * _e7532)) - _e3726.member) / _e7310) * _e7308) - 0.5f);
let _e7544 = select(0f, _e7542, (_e7542 > 0f));
let _e7546 = select(_e7314, _e7544, (_e7544 < _e7314));
let _e7550 = (((((_e2772.y + (_e7205 * _e7532)) - _e3726.member_1) / _e7321) * _e7319) - 0.5f);
let _e7552 = select(0f, _e7550, (_e7550 > 0f));
let _e7554 = select(_e7325, _e7552, (_e7552 < _e7325));
let _e7558 = (((((_e2772.z + (_e7207 * _e7532)) - _e3726.member_2) / _e7332) * _e7330) - 0.5f);
let _e7560 = select(0f, _e7558, (_e7558 > 0f));
let _e7562 = select(_e7336, _e7560, (_e7560 < _e7336));
let _e7564 = select(0f, _e7546, (_e7546 > 0f));
let _e7566 = select(1e6f, _e7564, (_e7564 < 1e6f));
let _e7573 = select(0i, select(select(i32(_e7566), i32(-2147483648), (_e7566 < -2147483600f)), 2147483647i, (_e7566 > 2147483500f)), (_e7566 == _e7566));
let _e7577 = (_e7573 - select(0i, 1i, (_e7566 < f32(_e7573))));
let _e7579 = select(0f, _e7554, (_e7554 > 0f));
let _e7581 = select(1e6f, _e7579, (_e7579 < 1e6f));
let _e7588 = select(0i, select(select(i32(_e7581), i32(-2147483648), (_e7581 < -2147483600f)), 2147483647i, (_e7581 > 2147483500f)), (_e7581 == _e7581));
let _e7592 = (_e7588 - select(0i, 1i, (_e7581 < f32(_e7588))));
let _e7594 = select(0f, _e7562, (_e7562 > 0f));
let _e7596 = select(1e6f, _e7594, (_e7594 < 1e6f));
let _e7603 = select(0i, select(select(i32(_e7596), i32(-2147483648), (_e7596 < -2147483600f)), 2147483647i, (_e7596 > 2147483500f)), (_e7596 == _e7596));
let _e7607 = (_e7603 - select(0i, 1i, (_e7596 < f32(_e7603))));
let _e7611 = (_e7554 - f32(_e7592));
let _e7613 = (_e7562 - f32(_e7607));
local_5 = (_e7546 - f32(_e7577));
let _e7614 = (_e7577 + 1i);
let _e7616 = select(_e7614, 0i, (_e7614 < 0i));
if (_e7616 >= _e7299) {
phi_12469_ = (_e7299 - 1i);
} else {
phi_12469_ = _e7616;
}
let _e7620 = phi_12469_;
local_6 = (_e7620 - _e7577);
let _e7622 = (_e7592 + 1i);
let _e7624 = select(_e7622, 0i, (_e7622 < 0i));
if (_e7624 >= _e7303) {
phi_12482_ = (_e7303 - 1i);
} else {
phi_12482_ = _e7624;
}
let _e7628 = phi_12482_;
let _e7630 = ((_e7628 - _e7592) * _e7299);
let _e7631 = (_e7607 + 1i);
let _e7633 = select(_e7631, 0i, (_e7631 < 0i));
if (_e7633 >= _e7307) {
phi_12496_ = (_e7307 - 1i);
} else {
phi_12496_ = _e7633;
}
let _e7637 = phi_12496_;
let _e7645 = ((_e7422 + (((_e7607 * _e7303) + _e7592) * _e7299)) + _e7577);
let _e7647 = select(_e7429, _e7645, (_e7645 < _e7429));
let _e7652 = global_7.member[bitcast<u32>(select(0i, _e7647, (_e7647 > 0i)))];
let _e7653 = local_5;
let _e7656 = local_6;
let _e7657 = (_e7645 + _e7656);
let _e7659 = select(_e7429, _e7657, (_e7657 < _e7429));
let _e7664 = global_7.member[bitcast<u32>(select(0i, _e7659, (_e7659 > 0i)))];
let _e7665 = local_5;
let _e7668 = (1f - _e7611);
let _e7670 = (_e7645 + _e7630);
let _e7672 = select(_e7429, _e7670, (_e7670 < _e7429));
let _e7677 = global_7.member[bitcast<u32>(select(0i, _e7672, (_e7672 > 0i)))];
let _e7678 = local_5;
let _e7681 = local_6;
let _e7682 = (_e7670 + _e7681);
let _e7684 = select(_e7429, _e7682, (_e7682 < _e7429));
let _e7689 = global_7.member[bitcast<u32>(select(0i, _e7684, (_e7684 > 0i)))];
let _e7690 = local_5;
let _e7695 = (_e7645 + (((_e7637 - _e7607) * _e7299) * _e7303));
let _e7697 = select(_e7429, _e7695, (_e7695 < _e7429));
let _e7702 = global_7.member[bitcast<u32>(select(0i, _e7697, (_e7697 > 0i)))];
let _e7703 = local_5;
let _e7706 = local_6;
let _e7707 = (_e7695 + _e7706);
let _e7709 = select(_e7429, _e7707, (_e7707 < _e7429));
let _e7714 = global_7.member[bitcast<u32>(select(0i, _e7709, (_e7709 > 0i)))];
let _e7715 = local_5;
let _e7719 = (_e7695 + _e7630);
let _e7721 = select(_e7429, _e7719, (_e7719 < _e7429));
let _e7726 = global_7.member[bitcast<u32>(select(0i, _e7721, (_e7721 > 0i)))];
let _e7727 = local_5;
let _e7730 = local_6;
let _e7731 = (_e7719 + _e7730);
let _e7733 = select(_e7429, _e7731, (_e7731 < _e7429));
let _e7738 = global_7.member[bitcast<u32>(select(0i, _e7733, (_e7733 > 0i)))];
let _e7739 = local_5;
phi_11983_ = (_e7275 + 1u);
phi_11986_ = (_e7277 + ((0.5f * (((((((_e7436 * (1f - _e7437)) + (_e7448 * _e7449)) * _e7452) + (((_e7461 * (1f - _e7462)) + (_e7473 * _e7474)) * _e7389)) * (1f - _e7391)) + (((((_e7486 * (1f - _e7487)) + (_e7498 * _e7499)) * _e7452) + (((_e7510 * (1f - _e7511)) + (_e7522 * _e7523)) * _e7389)) * _e7391)) + ((((((_e7652 * (1f - _e7653)) + (_e7664 * _e7665)) * _e7668) + (((_e7677 * (1f - _e7678)) + (_e7689 * _e7690)) * _e7611)) * (1f - _e7613)) + (((((_e7702 * (1f - _e7703)) + (_e7714 * _e7715)) * _e7668) + (((_e7726 * (1f - _e7727)) + (_e7738 * _e7739)) * _e7611)) * _e7613)))) * _e7287));
} else {
phi_11983_ = u32();
phi_11986_ = f32();
}
let _e7754 = phi_11983_;
let _e7756 = phi_11986_;
continue;
continuing {
phi_11982_ = _e7754;
phi_11985_ = _e7756;
break if !(_e7280);
}
}
let _e11191 = local_80;
phi_12701_ = _e11191;
}
let _e7759 = phi_12701_;
let _e7760 = (_e7759 + select((_e2181 + (_e3307 * (0.5f + (0.5f * 0.33998105f)))), select(0f, _e6839, (_e6839 > 0f)), _e853));
let _e7762 = -((_e4267.member * _e7760));
let _e7764 = select(-87f, _e7762, (_e7762 > -87f));
let _e7766 = select(88f, _e7764, (_e7764 < 88f));
let _e7768 = ((_e7766 * 1.442695f) + 0.5f);
let _e7770 = select(-127f, _e7768, (_e7768 > -127f));
let _e7772 = select(128f, _e7770, (_e7770 < 128f));
let _e7779 = select(0i, select(select(i32(_e7772), i32(-2147483648), (_e7772 < -2147483600f)), 2147483647i, (_e7772 > 2147483500f)), (_e7772 == _e7772));
let _e7783 = (_e7779 - select(0i, 1i, (_e7772 < f32(_e7779))));
let _e7784 = f32(_e7783);
let _e7788 = ((_e7766 - (_e7784 * 0.6933594f)) - (_e7784 * -2.1219444e-4f));
let _e7810 = -((_e4267.member_1 * _e7760));
let _e7812 = select(-87f, _e7810, (_e7810 > -87f));
let _e7814 = select(88f, _e7812, (_e7812 < 88f));
let _e7816 = ((_e7814 * 1.442695f) + 0.5f);
let _e7818 = select(-127f, _e7816, (_e7816 > -127f));
let _e7820 = select(128f, _e7818, (_e7818 < 128f));
let _e7827 = select(0i, select(select(i32(_e7820), i32(-2147483648), (_e7820 < -2147483600f)), 2147483647i, (_e7820 > 2147483500f)), (_e7820 == _e7820));
let _e7831 = (_e7827 - select(0i, 1i, (_e7820 < f32(_e7827))));
let _e7832 = f32(_e7831);
let _e7836 = ((_e7814 - (_e7832 * 0.6933594f)) - (_e7832 * -2.1219444e-4f));
let _e7858 = -((_e4267.member_2 * _e7760));
let _e7860 = select(-87f, _e7858, (_e7858 > -87f));
let _e7862 = select(88f, _e7860, (_e7860 < 88f));
let _e7864 = ((_e7862 * 1.442695f) + 0.5f);
let _e7866 = select(-127f, _e7864, (_e7864 > -127f));
let _e7868 = select(128f, _e7866, (_e7866 < 128f));
let _e7875 = select(0i, select(select(i32(_e7868), i32(-2147483648), (_e7868 < -2147483600f)), 2147483647i, (_e7868 > 2147483500f)), (_e7868 == _e7868));
let _e7879 = (_e7875 - select(0i, 1i, (_e7868 < f32(_e7875))));
let _e7880 = f32(_e7879);
let _e7884 = ((_e7862 - (_e7880 * 0.6933594f)) - (_e7880 * -2.1219444e-4f));
let _e7910 = -((((_e7185.member.x * _e512) + (_e7185.member.y * _e523)) + (_e7185.member.z * _e534)));
let _e7912 = (_e4425 - (_e4426 * _e7910));
let _e7914 = select(1e-9f, _e7912, (_e7912 > 1e-9f));
if _e4445 {
let _e7925 = (0.5f - (0.5f * _e7910));
let _e7927 = select(0f, _e7925, (_e7925 > 0f));
let _e7931 = (sqrt(select(0f, _e7927, (_e7927 > 0f))) * 255f);
let _e7932 = (255f - 1f);
let _e7934 = select(0f, _e7931, (_e7931 > 0f));
let _e7936 = select(_e7932, _e7934, (_e7934 < _e7932));
let _e7943 = select(0i, select(select(i32(_e7936), i32(-2147483648), (_e7936 < -2147483600f)), 2147483647i, (_e7936 > 2147483500f)), (_e7936 == _e7936));
let _e7947 = (_e7943 - select(0i, 1i, (_e7936 < f32(_e7943))));
let _e7950 = global_1.member.member_13.member_11;
let _e7951 = bitcast<i32>(_e7950);
let _e7952 = (_e7951 + _e7947);
let _e7954 = (bitcast<i32>(_e187) - 1i);
let _e7956 = select(_e7954, _e7952, (_e7952 < _e7954));
let _e7961 = global_7.member[bitcast<u32>(select(0i, _e7956, (_e7956 > 0i)))];
let _e7963 = (_e7951 + (_e7947 + 1i));
let _e7965 = select(_e7954, _e7963, (_e7963 < _e7954));
let _e7970 = global_7.member[bitcast<u32>(select(0i, _e7965, (_e7965 > 0i)))];
phi_13062_ = (_e7961 + ((_e7970 - _e7961) * (_e7931 - f32(_e7947))));
} else {
phi_13062_ = select((_e4431 / (_e7914 * sqrt(select(0f, _e7914, (_e7914 > 0f))))), (0.75f * (1f + (_e7910 * _e7910))), _e4443);
}
let _e7977 = phi_13062_;
let _e7981 = ((3.1415927f * (_e7977 * _e4500)) * (_e2764 * _e3022));
let _e7998 = (_e1679 * 0.34785485f);
let _e8008 = (_e1679 * 0.65214515f);
phi_4082_ = (_e2181 + _e3307);
phi_4085_ = vec3<f32>(((_e2183.x + (((((_e3671.member_1.x * ((1f + (_e4298 * (1f + (_e4298 * (0.5f + (_e4298 * (0.16666667f + (_e4298 * (0.041666668f + (_e4298 * (0.008333334f + (_e4298 * (0.001388889f + (_e4298 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4293 + 127i)) << bitcast<u32>(23i))))) * _e4514.member) * _e4504) + (((_e4870.member_1.x * ((1f + (_e5473 * (1f + (_e5473 * (0.5f + (_e5473 * (0.16666667f + (_e5473 * (0.041666668f + (_e5473 * (0.008333334f + (_e5473 * (0.001388889f + (_e5473 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5468 + 127i)) << bitcast<u32>(23i))))) * _e4514.member) * _e5666)) * _e7998)) + (((((_e6029.member_1.x * ((1f + (_e6632 * (1f + (_e6632 * (0.5f + (_e6632 * (0.16666667f + (_e6632 * (0.041666668f + (_e6632 * (0.008333334f + (_e6632 * (0.001388889f + (_e6632 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6627 + 127i)) << bitcast<u32>(23i))))) * _e4514.member) * _e6825) + (((_e7185.member_1.x * ((1f + (_e7788 * (1f + (_e7788 * (0.5f + (_e7788 * (0.16666667f + (_e7788 * (0.041666668f + (_e7788 * (0.008333334f + (_e7788 * (0.001388889f + (_e7788 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7783 + 127i)) << bitcast<u32>(23i))))) * _e4514.member) * _e7981)) * _e8008)), ((_e2183.y + (((((_e3671.member_1.y * ((1f + (_e4346 * (1f + (_e4346 * (0.5f + (_e4346 * (0.16666667f + (_e4346 * (0.041666668f + (_e4346 * (0.008333334f + (_e4346 * (0.001388889f + (_e4346 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4341 + 127i)) << bitcast<u32>(23i))))) * _e4514.member_1) * _e4504) + (((_e4870.member_1.y * ((1f + (_e5521 * (1f + (_e5521 * (0.5f + (_e5521 * (0.16666667f + (_e5521 * (0.041666668f + (_e5521 * (0.008333334f + (_e5521 * (0.001388889f + (_e5521 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5516 + 127i)) << bitcast<u32>(23i))))) * _e4514.member_1) * _e5666)) * _e7998)) + (((((_e6029.member_1.y * ((1f + (_e6680 * (1f + (_e6680 * (0.5f + (_e6680 * (0.16666667f + (_e6680 * (0.041666668f + (_e6680 * (0.008333334f + (_e6680 * (0.001388889f + (_e6680 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6675 + 127i)) << bitcast<u32>(23i))))) * _e4514.member_1) * _e6825) + (((_e7185.member_1.y * ((1f + (_e7836 * (1f + (_e7836 * (0.5f + (_e7836 * (0.16666667f + (_e7836 * (0.041666668f + (_e7836 * (0.008333334f + (_e7836 * (0.001388889f + (_e7836 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7831 + 127i)) << bitcast<u32>(23i))))) * _e4514.member_1) * _e7981)) * _e8008)), ((_e2183.z + (((((_e3671.member_1.z * ((1f + (_e4394 * (1f + (_e4394 * (0.5f + (_e4394 * (0.16666667f + (_e4394 * (0.041666668f + (_e4394 * (0.008333334f + (_e4394 * (0.001388889f + (_e4394 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4389 + 127i)) << bitcast<u32>(23i))))) * _e4514.member_2) * _e4504) + (((_e4870.member_1.z * ((1f + (_e5569 * (1f + (_e5569 * (0.5f + (_e5569 * (0.16666667f + (_e5569 * (0.041666668f + (_e5569 * (0.008333334f + (_e5569 * (0.001388889f + (_e5569 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5564 + 127i)) << bitcast<u32>(23i))))) * _e4514.member_2) * _e5666)) * _e7998)) + (((((_e6029.member_1.z * ((1f + (_e6728 * (1f + (_e6728 * (0.5f + (_e6728 * (0.16666667f + (_e6728 * (0.041666668f + (_e6728 * (0.008333334f + (_e6728 * (0.001388889f + (_e6728 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6723 + 127i)) << bitcast<u32>(23i))))) * _e4514.member_2) * _e6825) + (((_e7185.member_1.z * ((1f + (_e7884 * (1f + (_e7884 * (0.5f + (_e7884 * (0.16666667f + (_e7884 * (0.041666668f + (_e7884 * (0.008333334f + (_e7884 * (0.001388889f + (_e7884 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7879 + 127i)) << bitcast<u32>(23i))))) * _e4514.member_2) * _e7981)) * _e8008)));
phi_4087_ = (_e2185 + 1i);
} else {
phi_4082_ = f32();
phi_4085_ = vec3<f32>();
phi_4087_ = i32();
}
let _e8019 = phi_4082_;
let _e8021 = phi_4085_;
let _e8023 = phi_4087_;
continue;
continuing {
phi_4081_ = _e8019;
phi_4084_ = _e8021;
phi_4086_ = _e8023;
break if !(_e2186);
}
}
let _e11198 = local_81;
phi_13117_ = _e11198;
} else {
phi_13117_ = vec3<f32>(0f, 0f, 0f);
}
let _e8026 = phi_13117_;
phi_13132_ = type_24(_e472.member, _e472.member_1, _e472.member_2, _e472.member_3, vec3<f32>((_e279 + (_e8026.x * _e768)), (_e290 + (_e8026.y * _e769)), (_e301 + (_e8026.z * _e770))), _e472.member_5, _e472.member_6, _e472.member_7, _e472.member_8);
} else {
phi_13132_ = _e472;
}
let _e8047 = phi_13132_;
let _e8048 = (_e673 == -1i);
let _e8049 = select(_e767, 0f, _e8048);
let _e8053 = (_e763 + (_e512 * _e8049));
let _e8054 = (_e764 + (_e523 * _e8049));
let _e8055 = (_e765 + (_e534 * _e8049));
let _e8056 = vec3<f32>(_e8053, _e8054, _e8055);
let _e8059 = (_e673 >= 0i);
if _e8059 {
let _e8104 = (_e673 * 19i);
let _e8106 = (bitcast<i32>(_e182) - 1i);
let _e8108 = select(_e8106, _e8104, (_e8104 < _e8106));
let _e8114 = global_4.member[bitcast<u32>(select(0i, _e8108, (_e8108 > 0i)))];
let _e8115 = (_e8104 + 1i);
let _e8117 = select(_e8106, _e8115, (_e8115 < _e8106));
let _e8123 = global_4.member[bitcast<u32>(select(0i, _e8117, (_e8117 > 0i)))];
let _e8124 = (_e8104 + 2i);
let _e8126 = select(_e8106, _e8124, (_e8124 < _e8106));
let _e8132 = global_4.member[bitcast<u32>(select(0i, _e8126, (_e8126 > 0i)))];
let _e8133 = (_e8104 + 3i);
let _e8135 = select(_e8106, _e8133, (_e8133 < _e8106));
let _e8141 = global_4.member[bitcast<u32>(select(0i, _e8135, (_e8135 > 0i)))];
let _e8142 = (_e8104 + 4i);
let _e8144 = select(_e8106, _e8142, (_e8142 < _e8106));
let _e8150 = global_4.member[bitcast<u32>(select(0i, _e8144, (_e8144 > 0i)))];
let _e8151 = (_e8104 + 5i);
let _e8153 = select(_e8106, _e8151, (_e8151 < _e8106));
let _e8159 = global_4.member[bitcast<u32>(select(0i, _e8153, (_e8153 > 0i)))];
let _e8160 = (_e8104 + 6i);
let _e8162 = select(_e8106, _e8160, (_e8160 < _e8106));
let _e8168 = global_4.member[bitcast<u32>(select(0i, _e8162, (_e8162 > 0i)))];
let _e8169 = (_e8104 + 7i);
let _e8171 = select(_e8106, _e8169, (_e8169 < _e8106));
let _e8177 = global_4.member[bitcast<u32>(select(0i, _e8171, (_e8171 > 0i)))];
let _e8178 = (_e8104 + 8i);
let _e8180 = select(_e8106, _e8178, (_e8178 < _e8106));
let _e8186 = global_4.member[bitcast<u32>(select(0i, _e8180, (_e8180 > 0i)))];
let _e8187 = (_e8141 - _e8114);
let _e8188 = (_e8150 - _e8123);
let _e8189 = (_e8159 - _e8132);
let _e8190 = (_e8168 - _e8114);
let _e8191 = (_e8177 - _e8123);
let _e8192 = (_e8186 - _e8132);
let _e8195 = ((_e8188 * _e8192) - (_e8189 * _e8191));
let _e8198 = ((_e8189 * _e8190) - (_e8187 * _e8192));
let _e8201 = ((_e8187 * _e8191) - (_e8188 * _e8190));
let _e8202 = (_e8141 - _e8053);
let _e8203 = (_e8150 - _e8054);
let _e8204 = (_e8159 - _e8055);
let _e8205 = (_e8168 - _e8053);
let _e8206 = (_e8177 - _e8054);
let _e8207 = (_e8186 - _e8055);
let _e8221 = (((((_e8203 * _e8207) - (_e8204 * _e8206)) * _e8195) + (((_e8204 * _e8205) - (_e8202 * _e8207)) * _e8198)) + (((_e8202 * _e8206) - (_e8203 * _e8205)) * _e8201));
let _e8223 = select(0f, _e8221, (_e8221 > 0f));
let _e8224 = (_e8114 - _e8053);
let _e8225 = (_e8123 - _e8054);
let _e8226 = (_e8132 - _e8055);
let _e8240 = (((((_e8206 * _e8226) - (_e8207 * _e8225)) * _e8195) + (((_e8207 * _e8224) - (_e8205 * _e8226)) * _e8198)) + (((_e8205 * _e8225) - (_e8206 * _e8224)) * _e8201));
let _e8242 = select(0f, _e8240, (_e8240 > 0f));
let _e8256 = (((((_e8225 * _e8204) - (_e8226 * _e8203)) * _e8195) + (((_e8226 * _e8202) - (_e8224 * _e8204)) * _e8198)) + (((_e8224 * _e8203) - (_e8225 * _e8202)) * _e8201));
let _e8258 = select(0f, _e8256, (_e8256 > 0f));
let _e8260 = ((_e8223 + _e8242) + _e8258);
let _e8262 = select(1e-30f, _e8260, (_e8260 > 1e-30f));
let _e8263 = (_e8223 / _e8262);
let _e8264 = (_e8242 / _e8262);
let _e8265 = (_e8258 / _e8262);
let _e8270 = (((_e8195 * _e8195) + (_e8198 * _e8198)) + (_e8201 * _e8201));
let _e8273 = sqrt(select(0f, _e8270, (_e8270 > 0f)));
let _e8276 = (1f / select(1e-20f, _e8273, (_e8273 > 1e-20f)));
let _e8281 = (_e8104 + 9i);
let _e8283 = select(_e8106, _e8281, (_e8281 < _e8106));
let _e8289 = global_4.member[bitcast<u32>(select(0i, _e8283, (_e8283 > 0i)))];
let _e8290 = (_e8104 + 10i);
let _e8292 = select(_e8106, _e8290, (_e8290 < _e8106));
let _e8298 = global_4.member[bitcast<u32>(select(0i, _e8292, (_e8292 > 0i)))];
let _e8299 = (_e8104 + 11i);
let _e8301 = select(_e8106, _e8299, (_e8299 < _e8106));
let _e8307 = global_4.member[bitcast<u32>(select(0i, _e8301, (_e8301 > 0i)))];
let _e8311 = (_e8104 + 12i);
let _e8313 = select(_e8106, _e8311, (_e8311 < _e8106));
let _e8319 = global_4.member[bitcast<u32>(select(0i, _e8313, (_e8313 > 0i)))];
let _e8320 = (_e8104 + 13i);
let _e8322 = select(_e8106, _e8320, (_e8320 < _e8106));
let _e8328 = global_4.member[bitcast<u32>(select(0i, _e8322, (_e8322 > 0i)))];
let _e8329 = (_e8104 + 14i);
let _e8331 = select(_e8106, _e8329, (_e8329 < _e8106));
let _e8337 = global_4.member[bitcast<u32>(select(0i, _e8331, (_e8331 > 0i)))];
let _e8344 = (_e8104 + 15i);
let _e8346 = select(_e8106, _e8344, (_e8344 < _e8106));
let _e8352 = global_4.member[bitcast<u32>(select(0i, _e8346, (_e8346 > 0i)))];
let _e8353 = (_e8104 + 16i);
let _e8355 = select(_e8106, _e8353, (_e8353 < _e8106));
let _e8361 = global_4.member[bitcast<u32>(select(0i, _e8355, (_e8355 > 0i)))];
let _e8362 = (_e8104 + 17i);
let _e8364 = select(_e8106, _e8362, (_e8362 < _e8106));
let _e8370 = global_4.member[bitcast<u32>(select(0i, _e8364, (_e8364 > 0i)))];
let _e8374 = (((_e8289 * _e8263) + (_e8319 * _e8264)) + (_e8352 * _e8265));
let _e8375 = (((_e8298 * _e8263) + (_e8328 * _e8264)) + (_e8361 * _e8265));
let _e8376 = (((_e8307 * _e8263) + (_e8337 * _e8264)) + (_e8370 * _e8265));
let _e8381 = (((_e8374 * _e8374) + (_e8375 * _e8375)) + (_e8376 * _e8376));
let _e8384 = sqrt(select(0f, _e8381, (_e8381 > 0f)));
let _e8387 = (1f / select(1e-20f, _e8384, (_e8384 > 1e-20f)));
let _e8392 = (_e8104 + 18i);
let _e8394 = select(_e8106, _e8392, (_e8392 < _e8106));
let _e8400 = global_4.member[bitcast<u32>(select(0i, _e8394, (_e8394 > 0i)))];
let _e8409 = (select(select(0i, select(select(i32(_e8400), i32(-2147483648), (_e8400 < -2147483600f)), 2147483647i, (_e8400 > 2147483500f)), (_e8400 == _e8400)), _e673, ((_e1499 & 1u) != 0u)) * 10i);
let _e8411 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e8413 = select(_e8411, _e8409, (_e8409 < _e8411));
let _e8419 = global_5.member[bitcast<u32>(select(0i, _e8413, (_e8413 > 0i)))];
let _e8420 = (_e8409 + 1i);
let _e8422 = select(_e8411, _e8420, (_e8420 < _e8411));
let _e8428 = global_5.member[bitcast<u32>(select(0i, _e8422, (_e8422 > 0i)))];
let _e8429 = (_e8409 + 2i);
let _e8431 = select(_e8411, _e8429, (_e8429 < _e8411));
let _e8437 = global_5.member[bitcast<u32>(select(0i, _e8431, (_e8431 > 0i)))];
let _e8441 = (_e8409 + 3i);
let _e8443 = select(_e8411, _e8441, (_e8441 < _e8411));
let _e8449 = global_5.member[bitcast<u32>(select(0i, _e8443, (_e8443 > 0i)))];
let _e8450 = (_e8409 + 4i);
let _e8452 = select(_e8411, _e8450, (_e8450 < _e8411));
let _e8458 = global_5.member[bitcast<u32>(select(0i, _e8452, (_e8452 > 0i)))];
let _e8459 = (_e8409 + 5i);
let _e8461 = select(_e8411, _e8459, (_e8459 < _e8411));
let _e8467 = global_5.member[bitcast<u32>(select(0i, _e8461, (_e8461 > 0i)))];
let _e8474 = (_e8409 + 6i);
let _e8476 = select(_e8411, _e8474, (_e8474 < _e8411));
let _e8482 = global_5.member[bitcast<u32>(select(0i, _e8476, (_e8476 > 0i)))];
let _e8483 = (_e8409 + 7i);
let _e8485 = select(_e8411, _e8483, (_e8483 < _e8411));
let _e8491 = global_5.member[bitcast<u32>(select(0i, _e8485, (_e8485 > 0i)))];
let _e8492 = (_e8409 + 8i);
let _e8494 = select(_e8411, _e8492, (_e8492 < _e8411));
let _e8500 = global_5.member[bitcast<u32>(select(0i, _e8494, (_e8494 > 0i)))];
let _e8508 = (_e8409 + 9i);
let _e8510 = select(_e8411, _e8508, (_e8508 < _e8411));
let _e8516 = global_5.member[bitcast<u32>(select(0i, _e8510, (_e8510 > 0i)))];
phi_13867_ = type_25(_e8056, vec3<f32>((_e8195 * _e8276), (_e8198 * _e8276), (_e8201 * _e8276)), vec3<f32>((_e8374 * _e8387), (_e8375 * _e8387), (_e8376 * _e8387)), vec3<f32>((((_e8419 * _e8263) + (_e8449 * _e8264)) + (_e8482 * _e8265)), (((_e8428 * _e8263) + (_e8458 * _e8264)) + (_e8491 * _e8265)), (((_e8437 * _e8263) + (_e8467 * _e8264)) + (_e8500 * _e8265))), _e8516, true);
} else {
let _e8060 = (_e673 == -3i);
let _e8066 = global_1.member.member_14.member_1.member.member;
let _e8071 = global_1.member.member_14.member_1.member_1;
let _e8077 = global_1.member.member_14.member.member.member;
let _e8082 = global_1.member.member_14.member.member_1;
let _e8092 = vec3<f32>(select(_e8077.member, _e8066.member, _e8060), select(_e8077.member_1, _e8066.member_1, _e8060), select(_e8077.member_2, _e8066.member_2, _e8060));
phi_13867_ = type_25(_e8056, _e8092, _e8092, vec3<f32>(select(_e8082.member, _e8071.member, _e8060), select(_e8082.member_1, _e8071.member_1, _e8060), select(_e8082.member_2, _e8071.member_2, _e8060)), 0f, false);
}
let _e8519 = phi_13867_;
let _e8522 = ((select(0i, _e673, _e8059) * 19i) + 18i);
let _e8524 = (bitcast<i32>(_e182) - 1i);
let _e8526 = select(_e8524, _e8522, (_e8522 < _e8524));
let _e8532 = global_4.member[bitcast<u32>(select(0i, _e8526, (_e8526 > 0i)))];
let _e8539 = select(0i, select(select(i32(_e8532), i32(-2147483648), (_e8532 < -2147483600f)), 2147483647i, (_e8532 > 2147483500f)), (_e8532 == _e8532));
let _e8540 = (_e8539 * 4i);
let _e8542 = (bitcast<i32>(_e187) - 1i);
let _e8544 = select(_e8542, _e8540, (_e8540 < _e8542));
let _e8550 = global_7.member[bitcast<u32>(select(0i, _e8544, (_e8544 > 0i)))];
if _e8059 {
phi_13931_ = (select(_e8550, 1f, (_e8539 == 16i)) == 0f);
} else {
phi_13931_ = (_e673 != -1i);
}
let _e8556 = phi_13931_;
if _e681 {
let _e8566 = type_24(select(_e767, 1e30f, _e8048), _e8047.member_1, _e8047.member_2, _e8047.member_3, _e8047.member_4, _e8047.member_5, _e8047.member_6, _e8047.member_7, _e8047.member_8);
let _e8577 = type_24(_e8566.member, select(_e767, _e846, (_e846 < _e767)), _e8566.member_2, _e8566.member_3, _e8566.member_4, _e8566.member_5, _e8566.member_6, _e8566.member_7, _e8566.member_8);
let _e8588 = type_24(_e8577.member, _e8577.member_1, select(_e767, _e847, (_e847 < _e767)), _e8577.member_3, _e8577.member_4, _e8577.member_5, _e8577.member_6, _e8577.member_7, _e8577.member_8);
let _e8599 = select(1f, -1f, ((((_e8519.member_1.x * _e512) + (_e8519.member_1.y * _e523)) + (_e8519.member_1.z * _e534)) > 0f));
let _e8611 = select(_e8599, -(_e8599), ((((_e8519.member_2.x * _e8519.member_1.x) + (_e8519.member_2.y * _e8519.member_1.y)) + (_e8519.member_2.z * _e8519.member_1.z)) < 0f));
let _e8612 = (_e8519.member_2.x * _e8611);
let _e8613 = (_e8519.member_2.y * _e8611);
let _e8614 = (_e8519.member_2.z * _e8611);
let _e8623 = ((((_e8612 * _e512) + (_e8613 * _e523)) + (_e8614 * _e534)) > 0f);
let _e8639 = type_24(_e8588.member, _e8588.member_1, _e8588.member_2, _e8588.member_3, _e8588.member_4, _e8588.member_5, _e8588.member_6, _e8588.member_7, vec3<f32>(select(select(_e8612, (_e8519.member_1.x * _e8599), _e8623), 0f, _e8048), select(select(_e8613, (_e8519.member_1.y * _e8599), _e8623), 0f, _e8048), select(select(_e8614, (_e8519.member_1.z * _e8599), _e8623), 0f, _e8048)));
let _e8643 = (1f - (((_e1400 + _e1448) + _e1496) * _e1504));
let _e8647 = global_1.member.member_15.member_12;
phi_14051_ = type_24(_e8639.member, _e8639.member_1, _e8639.member_2, _e8639.member_3, _e8639.member_4, _e8639.member_5, _e8639.member_6, select(1f, select(_e8643, _e8647, (_e8647 > _e8643)), _e8048), _e8639.member_8);
} else {
phi_14051_ = _e8047;
}
let _e8661 = phi_14051_;
if _e8048 {
let _e9888 = (((_e545 * _e545) + (_e556 * _e556)) + (_e567 * _e567));
let _e9891 = sqrt(select(0f, _e9888, (_e9888 > 0f)));
let _e9896 = (((_e578 * _e578) + (_e589 * _e589)) + (_e600 * _e600));
let _e9899 = sqrt(select(0f, _e9896, (_e9896 > 0f)));
let _e9901 = select(_e9899, _e9891, (_e9891 > _e9899));
let _e9905 = global_1.member.member_15.member_4;
let _e9913 = (((_e9905.member * _e512) + (_e9905.member_1 * _e523)) + (_e9905.member_2 * _e534));
let _e9917 = global_1.member.member_15.member_5;
let _e9925 = (((_e9917.member * _e512) + (_e9917.member_1 * _e523)) + (_e9917.member_2 * _e534));
let _e9929 = global_1.member.member_15.member_6;
let _e9937 = (((_e9929.member * _e512) + (_e9929.member_1 * _e523)) + (_e9929.member_2 * _e534));
let _e9941 = global_1.member.member_15.member;
let _e9945 = global_1.member.member_15.member_7;
let _e9949 = vec3<f32>(_e9945.member, _e9945.member_1, _e9945.member_2);
let _e9953 = global_1.member.member_15.member_8;
if (_e9941 == 0u) {
phi_15540_ = _e9949;
} else {
if (_e9941 == 1u) {
let _e10930 = select(-1f, _e9937, (_e9937 > -1f));
let _e10932 = select(1f, _e10930, (_e10930 < 1f));
if (_e10932 > 0f) {
phi_14155_ = _e9949;
} else {
let _e10937 = global_1.member.member_15.member_9;
phi_14155_ = vec3<f32>(_e10937.member, _e10937.member_1, _e10937.member_2);
}
let _e10943 = phi_14155_;
let _e10952 = bitcast<f32>((bitcast<u32>(_e10932) & 2147483647u));
let _e10955 = sqrt(select(0f, _e10952, (_e10952 > 0f)));
phi_15539_ = vec3<f32>((_e9953.member + ((_e10943.x - _e9953.member) * _e10955)), (_e9953.member_1 + ((_e10943.y - _e9953.member_1) * _e10955)), (_e9953.member_2 + ((_e10943.z - _e9953.member_2) * _e10955)));
} else {
if (_e9941 == 2u) {
let _e10730 = global_1.member.member_15.member_10;
let _e10731 = (_e9901 / _e10730);
let _e10733 = select(1e-4f, _e10731, (_e10731 > 1e-4f));
let _e10736 = bitcast<f32>((bitcast<u32>(_e9913) & 2147483647u));
let _e10739 = bitcast<f32>((bitcast<u32>(_e9925) & 2147483647u));
let _e10743 = select(_e10739, _e10736, (_e10736 > _e10739));
let _e10746 = (select(_e10739, _e10736, (_e10736 < _e10739)) / select(1.1754944e-38f, _e10743, (_e10743 > 1.1754944e-38f)));
let _e10747 = (_e10746 > 0.41421357f);
let _e10751 = select(_e10746, ((_e10746 - 1f) / (_e10746 + 1f)), _e10747);
let _e10752 = (_e10751 * _e10751);
let _e10767 = (select(0f, 0.7853982f, _e10747) + (_e10751 + ((_e10751 * _e10752) * (-0.33333334f + (_e10752 * (0.2f + (_e10752 * (-0.14285713f + (_e10752 * (0.11111111f + (_e10752 * (-0.09090909f + (_e10752 * 0.0585f)))))))))))));
let _e10770 = select(_e10767, (1.5707964f - _e10767), (_e10739 > _e10736));
let _e10773 = select(_e10770, (3.1415927f - _e10770), (_e9913 < 0f));
let _e10779 = (1f - (_e9937 * _e9937));
let _e10782 = sqrt(select(0f, _e10779, (_e10779 > 0f)));
let _e10785 = (_e10733 / select(1e-3f, _e10782, (_e10782 > 1e-3f)));
let _e10786 = ((select(_e10773, -(_e10773), (_e9925 < 0f)) / _e10730) * 0.5f);
let _e10788 = select(-8e6f, _e10786, (_e10786 > -8e6f));
let _e10790 = select(8e6f, _e10788, (_e10788 < 8e6f));
let _e10797 = select(0i, select(select(i32(_e10790), i32(-2147483648), (_e10790 < -2147483600f)), 2147483647i, (_e10790 > 2147483500f)), (_e10790 == _e10790));
let _e10804 = ((_e10786 - f32((_e10797 - select(0i, 1i, (_e10790 < f32(_e10797)))))) * 2f);
let _e10812 = ((select(select((_e10804 - 2f), (1f - _e10804), (_e10804 < 1.5f)), _e10804, (_e10804 < 0.5f)) * 2f) / _e10785);
let _e10814 = select(-1f, _e10812, (_e10812 > -1f));
let _e10817 = (2f - _e10785);
let _e10819 = select(0f, _e10817, (_e10817 > 0f));
let _e10824 = select(-1f, _e9937, (_e9937 > -1f));
let _e10826 = select(1f, _e10824, (_e10824 < 1f));
let _e10829 = ((1f - _e10826) * (1f + _e10826));
let _e10832 = sqrt(select(0f, _e10829, (_e10829 > 0f)));
let _e10835 = bitcast<f32>((bitcast<u32>(_e10832) & 2147483647u));
let _e10838 = bitcast<f32>((bitcast<u32>(_e10826) & 2147483647u));
let _e10842 = select(_e10838, _e10835, (_e10835 > _e10838));
let _e10845 = (select(_e10838, _e10835, (_e10835 < _e10838)) / select(1.1754944e-38f, _e10842, (_e10842 > 1.1754944e-38f)));
let _e10846 = (_e10845 > 0.41421357f);
let _e10850 = select(_e10845, ((_e10845 - 1f) / (_e10845 + 1f)), _e10846);
let _e10851 = (_e10850 * _e10850);
let _e10866 = (select(0f, 0.7853982f, _e10846) + (_e10850 + ((_e10850 * _e10851) * (-0.33333334f + (_e10851 * (0.2f + (_e10851 * (-0.14285713f + (_e10851 * (0.11111111f + (_e10851 * (-0.09090909f + (_e10851 * 0.0585f)))))))))))));
let _e10869 = select(_e10866, (1.5707964f - _e10866), (_e10838 > _e10835));
let _e10872 = select(_e10869, (3.1415927f - _e10869), (_e10832 < 0f));
let _e10877 = ((select(_e10872, -(_e10872), (_e10826 < 0f)) / _e10730) * 0.5f);
let _e10879 = select(-8e6f, _e10877, (_e10877 > -8e6f));
let _e10881 = select(8e6f, _e10879, (_e10879 < 8e6f));
let _e10888 = select(0i, select(select(i32(_e10881), i32(-2147483648), (_e10881 < -2147483600f)), 2147483647i, (_e10881 > 2147483500f)), (_e10881 == _e10881));
let _e10895 = ((_e10877 - f32((_e10888 - select(0i, 1i, (_e10881 < f32(_e10888)))))) * 2f);
let _e10903 = ((select(select((_e10895 - 2f), (1f - _e10895), (_e10895 < 1.5f)), _e10895, (_e10895 < 0.5f)) * 2f) / _e10733);
let _e10905 = select(-1f, _e10903, (_e10903 > -1f));
let _e10908 = (2f - _e10733);
let _e10910 = select(0f, _e10908, (_e10908 > 0f));
let _e10916 = (0.5f + ((0.5f * (select(1f, _e10814, (_e10814 < 1f)) * select(1f, _e10819, (_e10819 < 1f)))) * (select(1f, _e10905, (_e10905 < 1f)) * select(1f, _e10910, (_e10910 < 1f)))));
phi_15538_ = vec3<f32>((_e9945.member + ((_e9953.member - _e9945.member) * _e10916)), (_e9945.member_1 + ((_e9953.member_1 - _e9945.member_1) * _e10916)), (_e9945.member_2 + ((_e9953.member_2 - _e9945.member_2) * _e10916)));
} else {
let _e9963 = global_1.member.member_15.member_1;
let _e9964 = bitcast<i32>(_e9963);
let _e9969 = global_1.member.member_15.member_3;
let _e9971 = f32(bitcast<i32>(_e9969));
let _e9973 = (2f * 3.1415927f);
let _e9974 = ((_e9901 * f32(_e9964)) / _e9973);
let _e9976 = select(1e-6f, _e9974, (_e9974 > 1e-6f));
let _e9979 = bitcast<u32>(select(1.1754944e-38f, _e9976, (_e9976 > 1.1754944e-38f)));
let _e9980 = (_e9979 & 8388607u);
let _e9982 = select(0u, 1u, (_e9980 > 3474675u));
let _e9993 = bitcast<f32>((_e9980 | ((127u - _e9982) << bitcast<u32>(23i))));
let _e9996 = ((_e9993 - 1f) / (_e9993 + 1f));
let _e9997 = (_e9996 * _e9996);
let _e10012 = (f32(((bitcast<i32>((_e9979 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e9982))) + (((2f * _e9996) + ((_e9996 * _e9997) * (0.6666667f + (_e9997 * (0.4f + (_e9997 * (0.2857143f + (_e9997 * (0.22222222f + (_e9997 * 0.18181819f)))))))))) * 1.442695f));
let _e10013 = (_e9971 - 1f);
let _e10015 = select(0f, _e10012, (_e10012 > 0f));
let _e10017 = select(_e10013, _e10015, (_e10015 < _e10013));
let _e10018 = (_e9971 - 2f);
let _e10020 = select(0f, _e10018, (_e10018 > 0f));
let _e10022 = select(0f, _e10017, (_e10017 > 0f));
let _e10024 = select(_e10020, _e10022, (_e10022 < _e10020));
let _e10031 = select(0i, select(select(i32(_e10024), i32(-2147483648), (_e10024 < -2147483600f)), 2147483647i, (_e10024 > 2147483500f)), (_e10024 == _e10024));
let _e10035 = (_e10031 - select(0i, 1i, (_e10024 < f32(_e10031))));
let _e10038 = bitcast<f32>((bitcast<u32>(_e9925) & 2147483647u));
let _e10041 = bitcast<f32>((bitcast<u32>(_e9913) & 2147483647u));
let _e10045 = select(_e10041, _e10038, (_e10038 > _e10041));
let _e10048 = (select(_e10041, _e10038, (_e10038 < _e10041)) / select(1.1754944e-38f, _e10045, (_e10045 > 1.1754944e-38f)));
let _e10049 = (_e10048 > 0.41421357f);
let _e10053 = select(_e10048, ((_e10048 - 1f) / (_e10048 + 1f)), _e10049);
let _e10054 = (_e10053 * _e10053);
let _e10069 = (select(0f, 0.7853982f, _e10049) + (_e10053 + ((_e10053 * _e10054) * (-0.33333334f + (_e10054 * (0.2f + (_e10054 * (-0.14285713f + (_e10054 * (0.11111111f + (_e10054 * (-0.09090909f + (_e10054 * 0.0585f)))))))))))));
let _e10072 = select(_e10069, (1.5707964f - _e10069), (_e10041 > _e10038));
let _e10075 = select(_e10072, (3.1415927f - _e10072), (_e9925 < 0f));
let _e10080 = (0.5f - (select(_e10075, -(_e10075), (_e9913 < 0f)) / _e9973));
let _e10082 = select(-1f, _e9937, (_e9937 > -1f));
let _e10084 = select(1f, _e10082, (_e10082 < 1f));
let _e10087 = ((1f - _e10084) * (1f + _e10084));
let _e10090 = sqrt(select(0f, _e10087, (_e10087 > 0f)));
let _e10093 = bitcast<f32>((bitcast<u32>(_e10090) & 2147483647u));
let _e10096 = bitcast<f32>((bitcast<u32>(_e10084) & 2147483647u));
let _e10100 = select(_e10096, _e10093, (_e10093 > _e10096));
let _e10103 = (select(_e10096, _e10093, (_e10093 < _e10096)) / select(1.1754944e-38f, _e10100, (_e10100 > 1.1754944e-38f)));
let _e10104 = (_e10103 > 0.41421357f);
let _e10108 = select(_e10103, ((_e10103 - 1f) / (_e10103 + 1f)), _e10104);
let _e10109 = (_e10108 * _e10108);
let _e10124 = (select(0f, 0.7853982f, _e10104) + (_e10108 + ((_e10108 * _e10109) * (-0.33333334f + (_e10109 * (0.2f + (_e10109 * (-0.14285713f + (_e10109 * (0.11111111f + (_e10109 * (-0.09090909f + (_e10109 * 0.0585f)))))))))))));
let _e10127 = select(_e10124, (1.5707964f - _e10124), (_e10096 > _e10093));
let _e10130 = select(_e10127, (3.1415927f - _e10127), (_e10090 < 0f));
let _e10135 = (0.5f - (select(_e10130, -(_e10130), (_e10084 < 0f)) / 3.1415927f));
let _e10139 = global_1.member.member_15.member_2;
let _e10140 = bitcast<i32>(_e10139);
phi_14757_ = 0i;
phi_14760_ = 0i;
phi_14762_ = _e10140;
phi_14764_ = _e9964;
loop {
let _e10142 = phi_14757_;
let _e10144 = phi_14760_;
let _e10146 = phi_14762_;
let _e10148 = phi_14764_;
local_43 = _e10148;
local_44 = _e10146;
local_45 = _e10148;
local_46 = _e10148;
local_47 = _e10148;
local_48 = _e10148;
local_49 = _e10148;
local_50 = _e10148;
local_51 = _e10146;
local_52 = _e10146;
local_53 = _e10146;
local_54 = _e10146;
local_55 = _e10148;
local_56 = _e10144;
local_57 = _e10148;
local_58 = _e10144;
let _e10149 = (_e10142 < _e10035);
if _e10149 {
if (_e10148 > 1i) {
phi_14779_ = (_e10148 >> bitcast<u32>(1i));
} else {
phi_14779_ = 1i;
}
let _e10156 = phi_14779_;
if (_e10146 > 1i) {
phi_14785_ = (_e10146 >> bitcast<u32>(1i));
} else {
phi_14785_ = 1i;
}
let _e10161 = phi_14785_;
phi_14758_ = (_e10142 + 1i);
phi_14761_ = (_e10144 + (_e10148 * _e10146));
phi_14763_ = _e10161;
phi_14765_ = _e10156;
} else {
phi_14758_ = i32();
phi_14761_ = i32();
phi_14763_ = i32();
phi_14765_ = i32();
}
let _e10164 = phi_14758_;
let _e10166 = phi_14761_;
let _e10168 = phi_14763_;
let _e10170 = phi_14765_;
continue;
continuing {
phi_14757_ = _e10164;
phi_14760_ = _e10166;
phi_14762_ = _e10168;
phi_14764_ = _e10170;
break if !(_e10149);
}
}
let _e10173 = local_43;
let _e10174 = f32(_e10173);
let _e10176 = ((_e10080 * _e10174) - 0.5f);
let _e10178 = local_44;
let _e10179 = f32(_e10178);
let _e10181 = ((_e10135 * _e10179) - 0.5f);
let _e10183 = select(-1f, _e10176, (_e10176 > -1f));
let _e10185 = select(_e10174, _e10183, (_e10183 < _e10174));
let _e10192 = select(0i, select(select(i32(_e10185), i32(-2147483648), (_e10185 < -2147483600f)), 2147483647i, (_e10185 > 2147483500f)), (_e10185 == _e10185));
let _e10196 = (_e10192 - select(0i, 1i, (_e10185 < f32(_e10192))));
let _e10198 = select(-1f, _e10181, (_e10181 > -1f));
let _e10200 = select(_e10179, _e10198, (_e10198 < _e10179));
let _e10207 = select(0i, select(select(i32(_e10200), i32(-2147483648), (_e10200 < -2147483600f)), 2147483647i, (_e10200 > 2147483500f)), (_e10200 == _e10200));
let _e10211 = (_e10207 - select(0i, 1i, (_e10200 < f32(_e10207))));
let _e10213 = (_e10176 - f32(_e10196));
let _e10215 = (_e10181 - f32(_e10211));
let _e10217 = select(0f, _e10215, (_e10215 > 0f));
let _e10219 = select(1f, _e10217, (_e10217 < 1f));
if (_e10196 < 0i) {
let _e10222 = local_45;
phi_14860_ = (_e10196 + _e10222);
} else {
phi_14860_ = _e10196;
}
let _e10225 = phi_14860_;
let _e10227 = local_46;
if (_e10225 >= _e10227) {
let _e10230 = local_47;
phi_14866_ = (_e10225 - _e10230);
} else {
phi_14866_ = _e10225;
}
let _e10233 = phi_14866_;
let _e10234 = (_e10196 + 1i);
if (_e10234 < 0i) {
let _e10237 = local_48;
phi_14873_ = (_e10234 + _e10237);
} else {
phi_14873_ = _e10234;
}
let _e10240 = phi_14873_;
let _e10242 = local_49;
if (_e10240 >= _e10242) {
let _e10245 = local_50;
phi_14879_ = (_e10240 - _e10245);
} else {
phi_14879_ = _e10240;
}
let _e10248 = phi_14879_;
let _e10250 = select(_e10211, 0i, (_e10211 < 0i));
let _e10252 = local_51;
if (_e10250 >= _e10252) {
let _e10255 = local_52;
phi_14890_ = (_e10255 - 1i);
} else {
phi_14890_ = _e10250;
}
let _e10258 = phi_14890_;
let _e10259 = (_e10211 + 1i);
let _e10261 = select(_e10259, 0i, (_e10259 < 0i));
let _e10263 = local_53;
if (_e10261 >= _e10263) {
let _e10266 = local_54;
phi_14902_ = (_e10266 - 1i);
} else {
phi_14902_ = _e10261;
}
let _e10269 = phi_14902_;
let _e10271 = local_55;
let _e10274 = local_56;
let _e10275 = (_e10274 + (_e10258 * _e10271));
let _e10277 = local_57;
let _e10280 = local_58;
let _e10281 = (_e10280 + (_e10269 * _e10277));
let _e10283 = (3i * (_e10275 + _e10233));
let _e10285 = (bitcast<i32>(_e180) - 1i);
let _e10287 = select(_e10285, _e10283, (_e10283 < _e10285));
let _e10293 = global_3.member[bitcast<u32>(select(0i, _e10287, (_e10287 > 0i)))];
let _e10294 = (_e10283 + 1i);
let _e10296 = select(_e10285, _e10294, (_e10294 < _e10285));
let _e10302 = global_3.member[bitcast<u32>(select(0i, _e10296, (_e10296 > 0i)))];
let _e10303 = (_e10283 + 2i);
let _e10305 = select(_e10285, _e10303, (_e10303 < _e10285));
let _e10311 = global_3.member[bitcast<u32>(select(0i, _e10305, (_e10305 > 0i)))];
let _e10313 = (3i * (_e10275 + _e10248));
let _e10315 = select(_e10285, _e10313, (_e10313 < _e10285));
let _e10321 = global_3.member[bitcast<u32>(select(0i, _e10315, (_e10315 > 0i)))];
let _e10322 = (_e10313 + 1i);
let _e10324 = select(_e10285, _e10322, (_e10322 < _e10285));
let _e10330 = global_3.member[bitcast<u32>(select(0i, _e10324, (_e10324 > 0i)))];
let _e10331 = (_e10313 + 2i);
let _e10333 = select(_e10285, _e10331, (_e10331 < _e10285));
let _e10339 = global_3.member[bitcast<u32>(select(0i, _e10333, (_e10333 > 0i)))];
let _e10341 = (3i * (_e10281 + _e10233));
let _e10343 = select(_e10285, _e10341, (_e10341 < _e10285));
let _e10349 = global_3.member[bitcast<u32>(select(0i, _e10343, (_e10343 > 0i)))];
let _e10350 = (_e10341 + 1i);
let _e10352 = select(_e10285, _e10350, (_e10350 < _e10285));
let _e10358 = global_3.member[bitcast<u32>(select(0i, _e10352, (_e10352 > 0i)))];
let _e10359 = (_e10341 + 2i);
let _e10361 = select(_e10285, _e10359, (_e10359 < _e10285));
let _e10367 = global_3.member[bitcast<u32>(select(0i, _e10361, (_e10361 > 0i)))];
let _e10369 = (3i * (_e10281 + _e10248));
let _e10371 = select(_e10285, _e10369, (_e10369 < _e10285));
let _e10377 = global_3.member[bitcast<u32>(select(0i, _e10371, (_e10371 > 0i)))];
let _e10378 = (_e10369 + 1i);
let _e10380 = select(_e10285, _e10378, (_e10378 < _e10285));
let _e10386 = global_3.member[bitcast<u32>(select(0i, _e10380, (_e10380 > 0i)))];
let _e10387 = (_e10369 + 2i);
let _e10389 = select(_e10285, _e10387, (_e10387 < _e10285));
let _e10395 = global_3.member[bitcast<u32>(select(0i, _e10389, (_e10389 > 0i)))];
let _e10402 = (_e10293 + ((_e10321 - _e10293) * _e10213));
let _e10403 = (_e10302 + ((_e10330 - _e10302) * _e10213));
let _e10404 = (_e10311 + ((_e10339 - _e10311) * _e10213));
let _e10420 = (_e10402 + (((_e10349 + ((_e10377 - _e10349) * _e10213)) - _e10402) * _e10219));
let _e10421 = (_e10403 + (((_e10358 + ((_e10386 - _e10358) * _e10213)) - _e10403) * _e10219));
let _e10422 = (_e10404 + (((_e10367 + ((_e10395 - _e10367) * _e10213)) - _e10404) * _e10219));
phi_15138_ = 0i;
phi_15141_ = 0i;
phi_15143_ = _e10140;
phi_15145_ = _e9964;
loop {
let _e10425 = phi_15138_;
let _e10427 = phi_15141_;
let _e10429 = phi_15143_;
let _e10431 = phi_15145_;
local_59 = _e10431;
local_60 = _e10429;
local_61 = _e10431;
local_62 = _e10431;
local_63 = _e10431;
local_64 = _e10431;
local_65 = _e10431;
local_66 = _e10431;
local_67 = _e10429;
local_68 = _e10429;
local_69 = _e10429;
local_70 = _e10429;
local_71 = _e10431;
local_72 = _e10427;
local_73 = _e10431;
local_74 = _e10427;
let _e10432 = (_e10425 < (_e10035 + 1i));
if _e10432 {
if (_e10431 > 1i) {
phi_15160_ = (_e10431 >> bitcast<u32>(1i));
} else {
phi_15160_ = 1i;
}
let _e10439 = phi_15160_;
if (_e10429 > 1i) {
phi_15166_ = (_e10429 >> bitcast<u32>(1i));
} else {
phi_15166_ = 1i;
}
let _e10444 = phi_15166_;
phi_15139_ = (_e10425 + 1i);
phi_15142_ = (_e10427 + (_e10431 * _e10429));
phi_15144_ = _e10444;
phi_15146_ = _e10439;
} else {
phi_15139_ = i32();
phi_15142_ = i32();
phi_15144_ = i32();
phi_15146_ = i32();
}
let _e10447 = phi_15139_;
let _e10449 = phi_15142_;
let _e10451 = phi_15144_;
let _e10453 = phi_15146_;
continue;
continuing {
phi_15138_ = _e10447;
phi_15141_ = _e10449;
phi_15143_ = _e10451;
phi_15145_ = _e10453;
break if !(_e10432);
}
}
let _e10456 = local_59;
let _e10457 = f32(_e10456);
let _e10459 = ((_e10080 * _e10457) - 0.5f);
let _e10461 = local_60;
let _e10462 = f32(_e10461);
let _e10464 = ((_e10135 * _e10462) - 0.5f);
let _e10466 = select(-1f, _e10459, (_e10459 > -1f));
let _e10468 = select(_e10457, _e10466, (_e10466 < _e10457));
let _e10475 = select(0i, select(select(i32(_e10468), i32(-2147483648), (_e10468 < -2147483600f)), 2147483647i, (_e10468 > 2147483500f)), (_e10468 == _e10468));
let _e10479 = (_e10475 - select(0i, 1i, (_e10468 < f32(_e10475))));
let _e10481 = select(-1f, _e10464, (_e10464 > -1f));
let _e10483 = select(_e10462, _e10481, (_e10481 < _e10462));
let _e10490 = select(0i, select(select(i32(_e10483), i32(-2147483648), (_e10483 < -2147483600f)), 2147483647i, (_e10483 > 2147483500f)), (_e10483 == _e10483));
let _e10494 = (_e10490 - select(0i, 1i, (_e10483 < f32(_e10490))));
let _e10496 = (_e10459 - f32(_e10479));
let _e10498 = (_e10464 - f32(_e10494));
let _e10500 = select(0f, _e10498, (_e10498 > 0f));
let _e10502 = select(1f, _e10500, (_e10500 < 1f));
if (_e10479 < 0i) {
let _e10505 = local_61;
phi_15241_ = (_e10479 + _e10505);
} else {
phi_15241_ = _e10479;
}
let _e10508 = phi_15241_;
let _e10510 = local_62;
if (_e10508 >= _e10510) {
let _e10513 = local_63;
phi_15247_ = (_e10508 - _e10513);
} else {
phi_15247_ = _e10508;
}
let _e10516 = phi_15247_;
let _e10517 = (_e10479 + 1i);
if (_e10517 < 0i) {
let _e10520 = local_64;
phi_15254_ = (_e10517 + _e10520);
} else {
phi_15254_ = _e10517;
}
let _e10523 = phi_15254_;
let _e10525 = local_65;
if (_e10523 >= _e10525) {
let _e10528 = local_66;
phi_15260_ = (_e10523 - _e10528);
} else {
phi_15260_ = _e10523;
}
let _e10531 = phi_15260_;
let _e10533 = select(_e10494, 0i, (_e10494 < 0i));
let _e10535 = local_67;
if (_e10533 >= _e10535) {
let _e10538 = local_68;
phi_15271_ = (_e10538 - 1i);
} else {
phi_15271_ = _e10533;
}
let _e10541 = phi_15271_;
let _e10542 = (_e10494 + 1i);
let _e10544 = select(_e10542, 0i, (_e10542 < 0i));
let _e10546 = local_69;
if (_e10544 >= _e10546) {
let _e10549 = local_70;
phi_15283_ = (_e10549 - 1i);
} else {
phi_15283_ = _e10544;
}
let _e10552 = phi_15283_;
let _e10554 = local_71;
let _e10557 = local_72;
let _e10558 = (_e10557 + (_e10541 * _e10554));
let _e10560 = local_73;
let _e10563 = local_74;
let _e10564 = (_e10563 + (_e10552 * _e10560));
let _e10566 = (3i * (_e10558 + _e10516));
let _e10568 = select(_e10285, _e10566, (_e10566 < _e10285));
let _e10574 = global_3.member[bitcast<u32>(select(0i, _e10568, (_e10568 > 0i)))];
let _e10575 = (_e10566 + 1i);
let _e10577 = select(_e10285, _e10575, (_e10575 < _e10285));
let _e10583 = global_3.member[bitcast<u32>(select(0i, _e10577, (_e10577 > 0i)))];
let _e10584 = (_e10566 + 2i);
let _e10586 = select(_e10285, _e10584, (_e10584 < _e10285));
let _e10592 = global_3.member[bitcast<u32>(select(0i, _e10586, (_e10586 > 0i)))];
let _e10594 = (3i * (_e10558 + _e10531));
let _e10596 = select(_e10285, _e10594, (_e10594 < _e10285));
let _e10602 = global_3.member[bitcast<u32>(select(0i, _e10596, (_e10596 > 0i)))];
let _e10603 = (_e10594 + 1i);
let _e10605 = select(_e10285, _e10603, (_e10603 < _e10285));
let _e10611 = global_3.member[bitcast<u32>(select(0i, _e10605, (_e10605 > 0i)))];
let _e10612 = (_e10594 + 2i);
let _e10614 = select(_e10285, _e10612, (_e10612 < _e10285));
let _e10620 = global_3.member[bitcast<u32>(select(0i, _e10614, (_e10614 > 0i)))];
let _e10622 = (3i * (_e10564 + _e10516));
let _e10624 = select(_e10285, _e10622, (_e10622 < _e10285));
let _e10630 = global_3.member[bitcast<u32>(select(0i, _e10624, (_e10624 > 0i)))];
let _e10631 = (_e10622 + 1i);
let _e10633 = select(_e10285, _e10631, (_e10631 < _e10285));
let _e10639 = global_3.member[bitcast<u32>(select(0i, _e10633, (_e10633 > 0i)))];
let _e10640 = (_e10622 + 2i);
let _e10642 = select(_e10285, _e10640, (_e10640 < _e10285));
let _e10648 = global_3.member[bitcast<u32>(select(0i, _e10642, (_e10642 > 0i)))];
let _e10650 = (3i * (_e10564 + _e10531));
let _e10652 = select(_e10285, _e10650, (_e10650 < _e10285));
let _e10658 = global_3.member[bitcast<u32>(select(0i, _e10652, (_e10652 > 0i)))];
let _e10659 = (_e10650 + 1i);
let _e10661 = select(_e10285, _e10659, (_e10659 < _e10285));
let _e10667 = global_3.member[bitcast<u32>(select(0i, _e10661, (_e10661 > 0i)))];
let _e10668 = (_e10650 + 2i);
let _e10670 = select(_e10285, _e10668, (_e10668 < _e10285));
let _e10676 = global_3.member[bitcast<u32>(select(0i, _e10670, (_e10670 > 0i)))];
let _e10683 = (_e10574 + ((_e10602 - _e10574) * _e10496));
let _e10684 = (_e10583 + ((_e10611 - _e10583) * _e10496));
let _e10685 = (_e10592 + ((_e10620 - _e10592) * _e10496));
let _e10708 = (_e10017 - f32(_e10035));
let _e10710 = select(0f, _e10708, (_e10708 > 0f));
let _e10712 = select(1f, _e10710, (_e10710 < 1f));
let _e10722 = global_1.member.member_15.member_11;
phi_15538_ = vec3<f32>(((_e10420 + (((_e10683 + (((_e10630 + ((_e10658 - _e10630) * _e10496)) - _e10683) * _e10502)) - _e10420) * _e10712)) * _e10722), ((_e10421 + (((_e10684 + (((_e10639 + ((_e10667 - _e10639) * _e10496)) - _e10684) * _e10502)) - _e10421) * _e10712)) * _e10722), ((_e10422 + (((_e10685 + (((_e10648 + ((_e10676 - _e10648) * _e10496)) - _e10685) * _e10502)) - _e10422) * _e10712)) * _e10722));
}
let _e10928 = phi_15538_;
phi_15539_ = _e10928;
}
let _e10964 = phi_15539_;
phi_15540_ = _e10964;
}
let _e10966 = phi_15540_;
let _e10970 = global_1.member.member_15.member_12;
let _e10971 = select(1f, _e10970, _e681);
phi_17377_ = type_24(_e8661.member, _e8661.member_1, _e8661.member_2, vec3<f32>((_e8661.member_3.x + (((_e10966.x * _e1400) * _e768) * _e10971)), (_e8661.member_3.y + (((_e10966.y * _e1448) * _e769) * _e10971)), (_e8661.member_3.z + (((_e10966.z * _e1496) * _e770) * _e10971))), _e8661.member_4, _e8661.member_5, _e8661.member_6, _e8661.member_7, _e8661.member_8);
} else {
if _e8556 {
let _e8666 = global_1.member.member_10.member_2;
let _e8674 = global_1.member.member_10.member;
let _e8675 = (_e8674 == 0u);
if _e8675 {
let _e9023 = global_1.member.member_10.member_1;
phi_16096_ = type_26(vec3<f32>(_e9023.member, _e9023.member_1, _e9023.member_2), vec3<f32>(_e8666.member, _e8666.member_1, _e8666.member_2));
} else {
let _e8679 = global_1.member.member_10.member_3;
let _e8684 = (_e8519.member.x - _e8679.member);
let _e8686 = (_e8519.member.y - _e8679.member_1);
let _e8688 = (_e8519.member.z - _e8679.member_2);
let _e8693 = (((_e8684 * _e8684) + (_e8686 * _e8686)) + (_e8688 * _e8688));
let _e8695 = select(1e-12f, _e8693, (_e8693 > 1e-12f));
let _e8696 = (1f / _e8695);
let _e8700 = vec3<f32>((_e8666.member * _e8696), (_e8666.member_1 * _e8696), (_e8666.member_2 * _e8696));
if (_e8674 == 2u) {
let _e8705 = global_1.member.member_10.member_1;
let _e8713 = (((_e8705.member * _e8684) + (_e8705.member_1 * _e8686)) + (_e8705.member_2 * _e8688));
let _e8716 = (1f / select(1e-20f, _e8713, (_e8713 > 1e-20f)));
let _e8721 = global_1.member.member_10.member_4.member;
let _e8730 = ((((_e8721.member * _e8684) + (_e8721.member_1 * _e8686)) + (_e8721.member_2 * _e8688)) * _e8716);
let _e8735 = global_1.member.member_10.member_4.member_1;
let _e8744 = ((((_e8735.member * _e8684) + (_e8735.member_1 * _e8686)) + (_e8735.member_2 * _e8688)) * _e8716);
let _e8749 = global_1.member.member_10.member_4.member_2;
let _e8752 = ((_e8730 * _e8730) + (_e8744 * _e8744));
let _e8761 = global_1.member.member_10.member_4.member_3;
let _e8762 = ((_e8749 - sqrt(select(0f, _e8752, (_e8752 > 0f)))) * _e8761);
let _e8764 = select(0f, _e8762, (_e8762 > 0f));
let _e8766 = select(1f, _e8764, (_e8764 < 1f));
let _e8772 = select(0f, ((_e8766 * _e8766) * (3f - (2f * _e8766))), (_e8713 > 0f));
let _e8777 = global_1.member.member_10.member_4.member_5;
if ((_e8777 > 0u) && (_e8772 > 0f)) {
let _e8782 = (0.5f / _e8749);
let _e8792 = global_1.member.member_10.member_4.member_6;
let _e8793 = bitcast<i32>(_e8792);
local_4 = bitcast<i32>(_e8777);
let _e8794 = local_4;
let _e8796 = f32((_e8794 - 1i));
let _e8798 = f32((_e8793 - 1i));
let _e8799 = local_4;
let _e8802 = (((0.5f + (_e8730 * _e8782)) * f32(_e8799)) - 0.5f);
let _e8804 = select(0f, _e8802, (_e8802 > 0f));
let _e8806 = select(_e8796, _e8804, (_e8804 < _e8796));
let _e8809 = (((0.5f - (_e8744 * _e8782)) * f32(_e8793)) - 0.5f);
let _e8811 = select(0f, _e8809, (_e8809 > 0f));
let _e8813 = select(_e8798, _e8811, (_e8811 < _e8798));
let _e8815 = select(0f, _e8806, (_e8806 > 0f));
let _e8817 = select(_e8796, _e8815, (_e8815 < _e8796));
let _e8824 = select(0i, select(select(i32(_e8817), i32(-2147483648), (_e8817 < -2147483600f)), 2147483647i, (_e8817 > 2147483500f)), (_e8817 == _e8817));
let _e8828 = (_e8824 - select(0i, 1i, (_e8817 < f32(_e8824))));
let _e8830 = select(0f, _e8813, (_e8813 > 0f));
let _e8832 = select(_e8798, _e8830, (_e8830 < _e8798));
let _e8839 = select(0i, select(select(i32(_e8832), i32(-2147483648), (_e8832 < -2147483600f)), 2147483647i, (_e8832 > 2147483500f)), (_e8832 == _e8832));
let _e8843 = (_e8839 - select(0i, 1i, (_e8832 < f32(_e8839))));
let _e8845 = (_e8806 - f32(_e8828));
let _e8847 = (_e8813 - f32(_e8843));
let _e8848 = (_e8828 + 1i);
let _e8849 = local_4;
let _e8851 = select(_e8828, _e8848, (_e8848 < _e8849));
let _e8852 = (_e8843 + 1i);
let _e8854 = select(_e8843, _e8852, (_e8852 < _e8793));
let _e8859 = global_1.member.member_10.member_4.member_4;
let _e8860 = bitcast<i32>(_e8859);
let _e8861 = local_4;
let _e8865 = (_e8860 + (3i * ((_e8843 * _e8861) + _e8828)));
let _e8867 = (bitcast<i32>(_e180) - 1i);
let _e8869 = select(_e8867, _e8865, (_e8865 < _e8867));
let _e8874 = global_3.member[bitcast<u32>(select(0i, _e8869, (_e8869 > 0i)))];
let _e8875 = (_e8865 + 1i);
let _e8877 = select(_e8867, _e8875, (_e8875 < _e8867));
let _e8882 = global_3.member[bitcast<u32>(select(0i, _e8877, (_e8877 > 0i)))];
let _e8883 = (_e8865 + 2i);
let _e8885 = select(_e8867, _e8883, (_e8883 < _e8867));
let _e8890 = global_3.member[bitcast<u32>(select(0i, _e8885, (_e8885 > 0i)))];
let _e8891 = local_4;
let _e8895 = (_e8860 + (3i * ((_e8843 * _e8891) + _e8851)));
let _e8897 = select(_e8867, _e8895, (_e8895 < _e8867));
let _e8902 = global_3.member[bitcast<u32>(select(0i, _e8897, (_e8897 > 0i)))];
let _e8903 = (_e8895 + 1i);
let _e8905 = select(_e8867, _e8903, (_e8903 < _e8867));
let _e8910 = global_3.member[bitcast<u32>(select(0i, _e8905, (_e8905 > 0i)))];
let _e8911 = (_e8895 + 2i);
let _e8913 = select(_e8867, _e8911, (_e8911 < _e8867));
let _e8918 = global_3.member[bitcast<u32>(select(0i, _e8913, (_e8913 > 0i)))];
let _e8919 = local_4;
let _e8923 = (_e8860 + (3i * ((_e8854 * _e8919) + _e8828)));
let _e8925 = select(_e8867, _e8923, (_e8923 < _e8867));
let _e8930 = global_3.member[bitcast<u32>(select(0i, _e8925, (_e8925 > 0i)))];
let _e8931 = (_e8923 + 1i);
let _e8933 = select(_e8867, _e8931, (_e8931 < _e8867));
let _e8938 = global_3.member[bitcast<u32>(select(0i, _e8933, (_e8933 > 0i)))];
let _e8939 = (_e8923 + 2i);
let _e8941 = select(_e8867, _e8939, (_e8939 < _e8867));
let _e8946 = global_3.member[bitcast<u32>(select(0i, _e8941, (_e8941 > 0i)))];
let _e8947 = local_4;
let _e8951 = (_e8860 + (3i * ((_e8854 * _e8947) + _e8851)));
let _e8953 = select(_e8867, _e8951, (_e8951 < _e8867));
let _e8958 = global_3.member[bitcast<u32>(select(0i, _e8953, (_e8953 > 0i)))];
let _e8959 = (_e8951 + 1i);
let _e8961 = select(_e8867, _e8959, (_e8959 < _e8867));
let _e8966 = global_3.member[bitcast<u32>(select(0i, _e8961, (_e8961 > 0i)))];
let _e8967 = (_e8951 + 2i);
let _e8969 = select(_e8867, _e8967, (_e8967 < _e8867));
let _e8974 = global_3.member[bitcast<u32>(select(0i, _e8969, (_e8969 > 0i)))];
let _e8981 = (_e8874 + ((_e8902 - _e8874) * _e8845));
let _e8982 = (_e8882 + ((_e8910 - _e8882) * _e8845));
let _e8983 = (_e8890 + ((_e8918 - _e8890) * _e8845));
phi_16080_ = vec3<f32>(((_e8981 + (((_e8930 + ((_e8958 - _e8930) * _e8845)) - _e8981) * _e8847)) * _e8772), ((_e8982 + (((_e8938 + ((_e8966 - _e8938) * _e8845)) - _e8982) * _e8847)) * _e8772), ((_e8983 + (((_e8946 + ((_e8974 - _e8946) * _e8845)) - _e8983) * _e8847)) * _e8772));
} else {
phi_16080_ = vec3(_e8772);
}
let _e9007 = phi_16080_;
phi_16083_ = (_e8700 * _e9007);
} else {
phi_16083_ = _e8700;
}
let _e9010 = phi_16083_;
let _e9014 = (1f / sqrt(select(0f, _e8695, (_e8695 > 0f))));
phi_16096_ = type_26(vec3<f32>((_e8684 * _e9014), (_e8686 * _e9014), (_e8688 * _e9014)), _e9010);
}
let _e9030 = phi_16096_;
let _e9032 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e9034 = select(_e9032, _e493, (_e493 < _e9032));
let _e9040 = global_8.member[bitcast<u32>(select(0i, _e9034, (_e9034 > 0i)))];
let _e9045 = global_1.member.member_10.member_3;
let _e9050 = (_e9045.member - _e8519.member.x);
let _e9052 = (_e9045.member_1 - _e8519.member.y);
let _e9054 = (_e9045.member_2 - _e8519.member.z);
let _e9059 = (((_e9050 * _e9050) + (_e9052 * _e9052)) + (_e9054 * _e9054));
let _e9063 = select(sqrt(select(0f, _e9059, (_e9059 > 0f))), 1e30f, _e8675);
let _e9065 = -(_e9030.member.x);
let _e9067 = -(_e9030.member.y);
let _e9069 = -(_e9030.member.z);
let _e9077 = (1f / select(_e9065, select(1e-12f, -1e-12f, (_e9065 < 0f)), (bitcast<f32>((bitcast<u32>(_e9065) & 2147483647u)) < 1e-12f)));
let _e9085 = (1f / select(_e9067, select(1e-12f, -1e-12f, (_e9067 < 0f)), (bitcast<f32>((bitcast<u32>(_e9067) & 2147483647u)) < 1e-12f)));
let _e9093 = (1f / select(_e9069, select(1e-12f, -1e-12f, (_e9069 < 0f)), (bitcast<f32>((bitcast<u32>(_e9069) & 2147483647u)) < 1e-12f)));
let _e9095 = ((_e798.member - _e8519.member.x) * _e9077);
let _e9097 = ((_e805.member - _e8519.member.x) * _e9077);
let _e9099 = ((_e798.member_1 - _e8519.member.y) * _e9085);
let _e9101 = ((_e805.member_1 - _e8519.member.y) * _e9085);
let _e9103 = ((_e798.member_2 - _e8519.member.z) * _e9093);
let _e9105 = ((_e805.member_2 - _e8519.member.z) * _e9093);
let _e9107 = select(_e9097, _e9095, (_e9095 < _e9097));
let _e9109 = select(_e9101, _e9099, (_e9099 < _e9101));
let _e9111 = select(_e9109, _e9107, (_e9107 > _e9109));
let _e9113 = select(_e9105, _e9103, (_e9103 < _e9105));
let _e9115 = select(_e9113, _e9111, (_e9111 > _e9113));
let _e9117 = select(_e9097, _e9095, (_e9095 > _e9097));
let _e9119 = select(_e9101, _e9099, (_e9099 > _e9101));
let _e9121 = select(_e9119, _e9117, (_e9117 < _e9119));
let _e9123 = select(_e9105, _e9103, (_e9103 > _e9105));
let _e9125 = select(_e9123, _e9121, (_e9121 < _e9123));
let _e9127 = select(0f, _e9115, (_e9115 > 0f));
let _e9129 = select(_e9063, _e9125, (_e9125 < _e9063));
let _e9130 = (_e9129 > _e9127);
let _e9131 = select(0f, _e9127, _e9130);
let _e9133 = (select(0f, _e9129, _e9130) - _e9131);
if _e853 {
phi_17024_ = _e9133;
} else {
let _e9135 = (_e9133 / f32(_e852));
phi_16305_ = 0u;
phi_16308_ = 0f;
loop {
let _e9137 = phi_16305_;
let _e9139 = phi_16308_;
local_82 = _e9139;
let _e9142 = ((_e9137 < _e852) && (_e9133 > 0f));
if _e9142 {
let _e9145 = (_e9131 + (_e9135 * f32(_e9137)));
let _e9146 = (_e9145 + _e9135);
let _e9148 = (0.5f * (_e9145 + _e9146));
let _e9149 = (_e9146 - _e9145);
let _e9150 = (0.28867513f * _e9149);
let _e9151 = (_e9148 - _e9150);
let _e9161 = global_1.member.member_13.member_7;
let _e9162 = bitcast<i32>(_e9161);
let _e9166 = global_1.member.member_13.member_8;
let _e9167 = bitcast<i32>(_e9166);
let _e9171 = global_1.member.member_13.member_9;
let _e9172 = bitcast<i32>(_e9171);
let _e9173 = f32(_e9162);
let _e9175 = (_e805.member - _e798.member);
let _e9178 = (((((_e8519.member.x + (_e9065 * _e9151)) - _e798.member) / _e9175) * _e9173) - 0.5f);
let _e9179 = (_e9173 - 1f);
let _e9181 = select(0f, _e9178, (_e9178 > 0f));
let _e9183 = select(_e9179, _e9181, (_e9181 < _e9179));
let _e9184 = f32(_e9167);
let _e9186 = (_e805.member_1 - _e798.member_1);
let _e9189 = (((((_e8519.member.y + (_e9067 * _e9151)) - _e798.member_1) / _e9186) * _e9184) - 0.5f);
let _e9190 = (_e9184 - 1f);
let _e9192 = select(0f, _e9189, (_e9189 > 0f));
let _e9194 = select(_e9190, _e9192, (_e9192 < _e9190));
let _e9195 = f32(_e9172);
let _e9197 = (_e805.member_2 - _e798.member_2);
let _e9200 = (((((_e8519.member.z + (_e9069 * _e9151)) - _e798.member_2) / _e9197) * _e9195) - 0.5f);
let _e9201 = (_e9195 - 1f);
let _e9203 = select(0f, _e9200, (_e9200 > 0f));
let _e9205 = select(_e9201, _e9203, (_e9203 < _e9201));
let _e9207 = select(0f, _e9183, (_e9183 > 0f));
let _e9209 = select(1e6f, _e9207, (_e9207 < 1e6f));
let _e9216 = select(0i, select(select(i32(_e9209), i32(-2147483648), (_e9209 < -2147483600f)), 2147483647i, (_e9209 > 2147483500f)), (_e9209 == _e9209));
let _e9220 = (_e9216 - select(0i, 1i, (_e9209 < f32(_e9216))));
let _e9222 = select(0f, _e9194, (_e9194 > 0f));
let _e9224 = select(1e6f, _e9222, (_e9222 < 1e6f));
let _e9231 = select(0i, select(select(i32(_e9224), i32(-2147483648), (_e9224 < -2147483600f)), 2147483647i, (_e9224 > 2147483500f)), (_e9224 == _e9224));
let _e9235 = (_e9231 - select(0i, 1i, (_e9224 < f32(_e9231))));
let _e9237 = select(0f, _e9205, (_e9205 > 0f));
let _e9239 = select(1e6f, _e9237, (_e9237 < 1e6f));
let _e9246 = select(0i, select(select(i32(_e9239), i32(-2147483648), (_e9239 < -2147483600f)), 2147483647i, (_e9239 > 2147483500f)), (_e9239 == _e9239));
let _e9250 = (_e9246 - select(0i, 1i, (_e9239 < f32(_e9246))));
let _e9254 = (_e9194 - f32(_e9235));
let _e9256 = (_e9205 - f32(_e9250));
local_2 = (_e9183 - f32(_e9220));
let _e9257 = (_e9220 + 1i);
let _e9259 = select(_e9257, 0i, (_e9257 < 0i));
if (_e9259 >= _e9162) {
phi_16446_ = (_e9162 - 1i);
} else {
phi_16446_ = _e9259;
}
let _e9263 = phi_16446_;
local_3 = (_e9263 - _e9220);
let _e9265 = (_e9235 + 1i);
let _e9267 = select(_e9265, 0i, (_e9265 < 0i));
if (_e9267 >= _e9167) {
phi_16459_ = (_e9167 - 1i);
} else {
phi_16459_ = _e9267;
}
let _e9271 = phi_16459_;
let _e9273 = ((_e9271 - _e9235) * _e9162);
let _e9274 = (_e9250 + 1i);
let _e9276 = select(_e9274, 0i, (_e9274 < 0i));
if (_e9276 >= _e9172) {
phi_16473_ = (_e9172 - 1i);
} else {
phi_16473_ = _e9276;
}
let _e9280 = phi_16473_;
let _e9287 = global_1.member.member_13.member_10;
let _e9288 = bitcast<i32>(_e9287);
let _e9293 = ((_e9288 + (((_e9250 * _e9167) + _e9235) * _e9162)) + _e9220);
let _e9295 = select(_e8542, _e9293, (_e9293 < _e8542));
let _e9300 = global_7.member[bitcast<u32>(select(0i, _e9295, (_e9295 > 0i)))];
let _e9301 = local_2;
let _e9304 = local_3;
let _e9305 = (_e9293 + _e9304);
let _e9307 = select(_e8542, _e9305, (_e9305 < _e8542));
let _e9312 = global_7.member[bitcast<u32>(select(0i, _e9307, (_e9307 > 0i)))];
let _e9313 = local_2;
let _e9316 = (1f - _e9254);
let _e9318 = (_e9293 + _e9273);
let _e9320 = select(_e8542, _e9318, (_e9318 < _e8542));
let _e9325 = global_7.member[bitcast<u32>(select(0i, _e9320, (_e9320 > 0i)))];
let _e9326 = local_2;
let _e9329 = local_3;
let _e9330 = (_e9318 + _e9329);
let _e9332 = select(_e8542, _e9330, (_e9330 < _e8542));
let _e9337 = global_7.member[bitcast<u32>(select(0i, _e9332, (_e9332 > 0i)))];
let _e9338 = local_2;
let _e9343 = (_e9293 + (((_e9280 - _e9250) * _e9162) * _e9167));
let _e9345 = select(_e8542, _e9343, (_e9343 < _e8542));
let _e9350 = global_7.member[bitcast<u32>(select(0i, _e9345, (_e9345 > 0i)))];
let _e9351 = local_2;
let _e9354 = local_3;
let _e9355 = (_e9343 + _e9354);
let _e9357 = select(_e8542, _e9355, (_e9355 < _e8542));
let _e9362 = global_7.member[bitcast<u32>(select(0i, _e9357, (_e9357 > 0i)))];
let _e9363 = local_2;
let _e9367 = (_e9343 + _e9273);
let _e9369 = select(_e8542, _e9367, (_e9367 < _e8542));
let _e9374 = global_7.member[bitcast<u32>(select(0i, _e9369, (_e9369 > 0i)))];
let _e9375 = local_2;
let _e9378 = local_3;
let _e9379 = (_e9367 + _e9378);
let _e9381 = select(_e8542, _e9379, (_e9379 < _e8542));
let _e9386 = global_7.member[bitcast<u32>(select(0i, _e9381, (_e9381 > 0i)))];
let _e9387 = local_2;
let _e9396 = (_e9148 + _e9150);
let _e9406 = (((((_e8519.member.x + (_e9065 * _e9396)) - _e798.member) / _e9175) * _e9173) - 0.5f);
let _e9408 = select(0f, _e9406, (_e9406 > 0f));
let _e9410 = select(_e9179, _e9408, (_e9408 < _e9179));
let _e9414 = (((((_e8519.member.y + (_e9067 * _e9396)) - _e798.member_1) / _e9186) * _e9184) - 0.5f);
let _e9416 = select(0f, _e9414, (_e9414 > 0f));
let _e9418 = select(_e9190, _e9416, (_e9416 < _e9190));
let _e9422 = (((((_e8519.member.z + (_e9069 * _e9396)) - _e798.member_2) / _e9197) * _e9195) - 0.5f);
let _e9424 = select(0f, _e9422, (_e9422 > 0f));
let _e9426 = select(_e9201, _e9424, (_e9424 < _e9201));
let _e9428 = select(0f, _e9410, (_e9410 > 0f));
let _e9430 = select(1e6f, _e9428, (_e9428 < 1e6f));
let _e9437 = select(0i, select(select(i32(_e9430), i32(-2147483648), (_e9430 < -2147483600f)), 2147483647i, (_e9430 > 2147483500f)), (_e9430 == _e9430));
let _e9441 = (_e9437 - select(0i, 1i, (_e9430 < f32(_e9437))));
let _e9443 = select(0f, _e9418, (_e9418 > 0f));
let _e9445 = select(1e6f, _e9443, (_e9443 < 1e6f));
let _e9452 = select(0i, select(select(i32(_e9445), i32(-2147483648), (_e9445 < -2147483600f)), 2147483647i, (_e9445 > 2147483500f)), (_e9445 == _e9445));
let _e9456 = (_e9452 - select(0i, 1i, (_e9445 < f32(_e9452))));
let _e9458 = select(0f, _e9426, (_e9426 > 0f));
let _e9460 = select(1e6f, _e9458, (_e9458 < 1e6f));
let _e9467 = select(0i, select(select(i32(_e9460), i32(-2147483648), (_e9460 < -2147483600f)), 2147483647i, (_e9460 > 2147483500f)), (_e9460 == _e9460));
let _e9471 = (_e9467 - select(0i, 1i, (_e9460 < f32(_e9467))));
let _e9475 = (_e9418 - f32(_e9456));
let _e9477 = (_e9426 - f32(_e9471));
local = (_e9410 - f32(_e9441));
let _e9478 = (_e9441 + 1i);
let _e9480 = select(_e9478, 0i, (_e9478 < 0i));
if (_e9480 >= _e9162) {
phi_16792_ = (_e9162 - 1i);
} else {
phi_16792_ = _e9480;
}
let _e9484 = phi_16792_;
local_1 = (_e9484 - _e9441);
let _e9486 = (_e9456 + 1i);
let _e9488 = select(_e9486, 0i, (_e9486 < 0i));
if (_e9488 >= _e9167) {
phi_16805_ = (_e9167 - 1i);
} else {
phi_16805_ = _e9488;
}
let _e9492 = phi_16805_;
let _e9494 = ((_e9492 - _e9456) * _e9162);
let _e9495 = (_e9471 + 1i);
let _e9497 = select(_e9495, 0i, (_e9495 < 0i));
if (_e9497 >= _e9172) {
phi_16819_ = (_e9172 - 1i);
} else {
phi_16819_ = _e9497;
}
let _e9501 = phi_16819_;
let _e9509 = ((_e9288 + (((_e9471 * _e9167) + _e9456) * _e9162)) + _e9441);
let _e9511 = select(_e8542, _e9509, (_e9509 < _e8542));
let _e9516 = global_7.member[bitcast<u32>(select(0i, _e9511, (_e9511 > 0i)))];
let _e9517 = local;
let _e9520 = local_1;
let _e9521 = (_e9509 + _e9520);
let _e9523 = select(_e8542, _e9521, (_e9521 < _e8542));
let _e9528 = global_7.member[bitcast<u32>(select(0i, _e9523, (_e9523 > 0i)))];
let _e9529 = local;
let _e9532 = (1f - _e9475);
let _e9534 = (_e9509 + _e9494);
let _e9536 = select(_e8542, _e9534, (_e9534 < _e8542));
let _e9541 = global_7.member[bitcast<u32>(select(0i, _e9536, (_e9536 > 0i)))];
let _e9542 = local;
let _e9545 = local_1;
let _e9546 = (_e9534 + _e9545);
let _e9548 = select(_e8542, _e9546, (_e9546 < _e8542));
let _e9553 = global_7.member[bitcast<u32>(select(0i, _e9548, (_e9548 > 0i)))];
let _e9554 = local;
let _e9559 = (_e9509 + (((_e9501 - _e9471) * _e9162) * _e9167));
let _e9561 = select(_e8542, _e9559, (_e9559 < _e8542));
let _e9566 = global_7.member[bitcast<u32>(select(0i, _e9561, (_e9561 > 0i)))];
let _e9567 = local;
let _e9570 = local_1;
let _e9571 = (_e9559 + _e9570);
let _e9573 = select(_e8542, _e9571, (_e9571 < _e8542));
let _e9578 = global_7.member[bitcast<u32>(select(0i, _e9573, (_e9573 > 0i)))];
let _e9579 = local;
let _e9583 = (_e9559 + _e9494);
let _e9585 = select(_e8542, _e9583, (_e9583 < _e8542));
let _e9590 = global_7.member[bitcast<u32>(select(0i, _e9585, (_e9585 > 0i)))];
let _e9591 = local;
let _e9594 = local_1;
let _e9595 = (_e9583 + _e9594);
let _e9597 = select(_e8542, _e9595, (_e9595 < _e8542));
let _e9602 = global_7.member[bitcast<u32>(select(0i, _e9597, (_e9597 > 0i)))];
let _e9603 = local;
phi_16306_ = (_e9137 + 1u);
phi_16309_ = (_e9139 + ((0.5f * (((((((_e9300 * (1f - _e9301)) + (_e9312 * _e9313)) * _e9316) + (((_e9325 * (1f - _e9326)) + (_e9337 * _e9338)) * _e9254)) * (1f - _e9256)) + (((((_e9350 * (1f - _e9351)) + (_e9362 * _e9363)) * _e9316) + (((_e9374 * (1f - _e9375)) + (_e9386 * _e9387)) * _e9254)) * _e9256)) + ((((((_e9516 * (1f - _e9517)) + (_e9528 * _e9529)) * _e9532) + (((_e9541 * (1f - _e9542)) + (_e9553 * _e9554)) * _e9475)) * (1f - _e9477)) + (((((_e9566 * (1f - _e9567)) + (_e9578 * _e9579)) * _e9532) + (((_e9590 * (1f - _e9591)) + (_e9602 * _e9603)) * _e9475)) * _e9477)))) * _e9149));
} else {
phi_16306_ = u32();
phi_16309_ = f32();
}
let _e9618 = phi_16306_;
let _e9620 = phi_16309_;
continue;
continuing {
phi_16305_ = _e9618;
phi_16308_ = _e9620;
break if !(_e9142);
}
}
let _e11218 = local_82;
phi_17024_ = _e11218;
}
let _e9623 = phi_17024_;
let _e9625 = -((_e1349.member * _e9623));
let _e9627 = select(-87f, _e9625, (_e9625 > -87f));
let _e9629 = select(88f, _e9627, (_e9627 < 88f));
let _e9631 = ((_e9629 * 1.442695f) + 0.5f);
let _e9633 = select(-127f, _e9631, (_e9631 > -127f));
let _e9635 = select(128f, _e9633, (_e9633 < 128f));
let _e9642 = select(0i, select(select(i32(_e9635), i32(-2147483648), (_e9635 < -2147483600f)), 2147483647i, (_e9635 > 2147483500f)), (_e9635 == _e9635));
let _e9646 = (_e9642 - select(0i, 1i, (_e9635 < f32(_e9642))));
let _e9647 = f32(_e9646);
let _e9651 = ((_e9629 - (_e9647 * 0.6933594f)) - (_e9647 * -2.1219444e-4f));
let _e9673 = -((_e1349.member_1 * _e9623));
let _e9675 = select(-87f, _e9673, (_e9673 > -87f));
let _e9677 = select(88f, _e9675, (_e9675 < 88f));
let _e9679 = ((_e9677 * 1.442695f) + 0.5f);
let _e9681 = select(-127f, _e9679, (_e9679 > -127f));
let _e9683 = select(128f, _e9681, (_e9681 < 128f));
let _e9690 = select(0i, select(select(i32(_e9683), i32(-2147483648), (_e9683 < -2147483600f)), 2147483647i, (_e9683 > 2147483500f)), (_e9683 == _e9683));
let _e9694 = (_e9690 - select(0i, 1i, (_e9683 < f32(_e9690))));
let _e9695 = f32(_e9694);
let _e9699 = ((_e9677 - (_e9695 * 0.6933594f)) - (_e9695 * -2.1219444e-4f));
let _e9721 = -((_e1349.member_2 * _e9623));
let _e9723 = select(-87f, _e9721, (_e9721 > -87f));
let _e9725 = select(88f, _e9723, (_e9723 < 88f));
let _e9727 = ((_e9725 * 1.442695f) + 0.5f);
let _e9729 = select(-127f, _e9727, (_e9727 > -127f));
let _e9731 = select(128f, _e9729, (_e9729 < 128f));
let _e9738 = select(0i, select(select(i32(_e9731), i32(-2147483648), (_e9731 < -2147483600f)), 2147483647i, (_e9731 > 2147483500f)), (_e9731 == _e9731));
let _e9742 = (_e9738 - select(0i, 1i, (_e9731 < f32(_e9738))));
let _e9743 = f32(_e9742);
let _e9747 = ((_e9725 - (_e9743 * 0.6933594f)) - (_e9743 * -2.1219444e-4f));
let _e9768 = (1f - _e9040);
let _e9780 = (((_e8519.member_1.x * _e512) + (_e8519.member_1.y * _e523)) + (_e8519.member_1.z * _e534));
let _e9782 = select(1f, -1f, (_e9780 > 0f));
let _e9794 = select(_e9782, -(_e9782), ((((_e8519.member_2.x * _e8519.member_1.x) + (_e8519.member_2.y * _e8519.member_1.y)) + (_e8519.member_2.z * _e8519.member_1.z)) < 0f));
let _e9795 = (_e8519.member_2.x * _e9794);
let _e9796 = (_e8519.member_2.y * _e9794);
let _e9797 = (_e8519.member_2.z * _e9794);
let _e9806 = ((((_e9795 * _e512) + (_e9796 * _e523)) + (_e9797 * _e534)) > 0f);
let _e9815 = -((((select(_e9795, (_e8519.member_1.x * _e9782), _e9806) * _e9030.member.x) + (select(_e9796, (_e8519.member_1.y * _e9782), _e9806) * _e9030.member.y)) + (select(_e9797, (_e8519.member_1.z * _e9782), _e9806) * _e9030.member.z)));
let _e9825 = -(_e9815);
let _e9830 = select((select(0f, _e9825, (_e9825 > 0f)) * _e8519.member_4), select(0f, _e9815, (_e9815 > 0f)), (((((_e8519.member_1.x * _e9030.member.x) + (_e8519.member_1.y * _e9030.member.y)) + (_e8519.member_1.z * _e9030.member.z)) * _e9780) > 0f));
let _e9844 = global_1.member.member_16;
phi_17376_ = type_24(_e8661.member, _e8661.member_1, _e8661.member_2, vec3<f32>((_e8661.member_3.x + (((_e8519.member_3.x * (((_e9030.member_1.x * (((1f + (_e9651 * (1f + (_e9651 * (0.5f + (_e9651 * (0.16666667f + (_e9651 * (0.041666668f + (_e9651 * (0.008333334f + (_e9651 * (0.001388889f + (_e9651 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9646 + 127i)) << bitcast<u32>(23i)))) * _e9768)) * _e9830) + _e9844.member)) * _e1400) * _e768)), (_e8661.member_3.y + (((_e8519.member_3.y * (((_e9030.member_1.y * (((1f + (_e9699 * (1f + (_e9699 * (0.5f + (_e9699 * (0.16666667f + (_e9699 * (0.041666668f + (_e9699 * (0.008333334f + (_e9699 * (0.001388889f + (_e9699 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9694 + 127i)) << bitcast<u32>(23i)))) * _e9768)) * _e9830) + _e9844.member_1)) * _e1448) * _e769)), (_e8661.member_3.z + (((_e8519.member_3.z * (((_e9030.member_1.z * (((1f + (_e9747 * (1f + (_e9747 * (0.5f + (_e9747 * (0.16666667f + (_e9747 * (0.041666668f + (_e9747 * (0.008333334f + (_e9747 * (0.001388889f + (_e9747 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9742 + 127i)) << bitcast<u32>(23i)))) * _e9768)) * _e9830) + _e9844.member_2)) * _e1496) * _e770))), _e8661.member_4, _e8661.member_5, _e8661.member_6, _e8661.member_7, _e8661.member_8);
} else {
phi_17376_ = _e8661;
}
let _e9883 = phi_17376_;
phi_17377_ = _e9883;
}
let _e11004 = phi_17377_;
global_6.member[_e203] = _e11004.member;
global_6.member[_e215] = _e11004.member_1;
global_6.member[_e226] = _e11004.member_2;
global_6.member[_e237] = _e11004.member_3.x;
global_6.member[_e248] = _e11004.member_3.y;
global_6.member[_e259] = _e11004.member_3.z;
global_6.member[_e270] = _e11004.member_4.x;
global_6.member[_e281] = _e11004.member_4.y;
global_6.member[_e292] = _e11004.member_4.z;
global_6.member[_e303] = _e11004.member_5.x;
global_6.member[_e314] = _e11004.member_5.y;
global_6.member[_e325] = _e11004.member_5.z;
global_6.member[_e336] = _e11004.member_6.x;
global_6.member[_e347] = _e11004.member_6.y;
global_6.member[_e358] = _e11004.member_6.z;
global_6.member[_e369] = _e11004.member_7;
global_6.member[_e380] = _e11004.member_8.x;
global_6.member[_e391] = _e11004.member_8.y;
global_6.member[_e402] = _e11004.member_8.z;
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
