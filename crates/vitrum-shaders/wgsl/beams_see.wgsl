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
member_13: u32,
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
var phi_4081_: vec3<f32>;
var phi_4084_: i32;
var phi_4086_: f32;
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
var phi_6246_: vec3<f32>;
var phi_6249_: vec3<f32>;
var phi_6262_: type_26;
var phi_6458_: u32;
var phi_6461_: f32;
var phi_6599_: i32;
var phi_6612_: i32;
var phi_6626_: i32;
var phi_6945_: i32;
var phi_6958_: i32;
var phi_6972_: i32;
var phi_6459_: u32;
var phi_6462_: f32;
var phi_7177_: f32;
var phi_7538_: f32;
var phi_8092_: vec3<f32>;
var phi_8095_: vec3<f32>;
var phi_8108_: type_26;
var phi_8304_: u32;
var phi_8307_: f32;
var phi_8445_: i32;
var phi_8458_: i32;
var phi_8472_: i32;
var phi_8791_: i32;
var phi_8804_: i32;
var phi_8818_: i32;
var phi_8305_: u32;
var phi_8308_: f32;
var phi_9023_: f32;
var phi_9384_: f32;
var phi_9941_: vec3<f32>;
var phi_9944_: vec3<f32>;
var phi_9957_: type_26;
var phi_10153_: u32;
var phi_10156_: f32;
var phi_10294_: i32;
var phi_10307_: i32;
var phi_10321_: i32;
var phi_10640_: i32;
var phi_10653_: i32;
var phi_10667_: i32;
var phi_10154_: u32;
var phi_10157_: f32;
var phi_10872_: f32;
var phi_11233_: f32;
var phi_11787_: vec3<f32>;
var phi_11790_: vec3<f32>;
var phi_11803_: type_26;
var phi_11999_: u32;
var phi_12002_: f32;
var phi_12140_: i32;
var phi_12153_: i32;
var phi_12167_: i32;
var phi_12486_: i32;
var phi_12499_: i32;
var phi_12513_: i32;
var phi_12000_: u32;
var phi_12003_: f32;
var phi_12718_: f32;
var phi_13079_: f32;
var phi_4082_: vec3<f32>;
var phi_4085_: i32;
var phi_4087_: f32;
var phi_13140_: vec3<f32>;
var phi_13155_: type_24;
var phi_13890_: type_25;
var phi_13954_: bool;
var phi_14074_: type_24;
var phi_16103_: vec3<f32>;
var phi_16106_: vec3<f32>;
var phi_16119_: type_26;
var phi_16328_: u32;
var phi_16331_: f32;
var phi_16469_: i32;
var phi_16482_: i32;
var phi_16496_: i32;
var phi_16815_: i32;
var phi_16828_: i32;
var phi_16842_: i32;
var phi_16329_: u32;
var phi_16332_: f32;
var phi_17047_: f32;
var phi_17399_: type_24;
var phi_14780_: i32;
var phi_14783_: i32;
var phi_14785_: i32;
var phi_14787_: i32;
var phi_14802_: i32;
var phi_14808_: i32;
var phi_14781_: i32;
var phi_14784_: i32;
var phi_14786_: i32;
var phi_14788_: i32;
var local_43: i32;
var local_44: i32;
var local_45: i32;
var phi_14883_: i32;
var local_46: i32;
var local_47: i32;
var phi_14889_: i32;
var local_48: i32;
var phi_14896_: i32;
var local_49: i32;
var local_50: i32;
var phi_14902_: i32;
var local_51: i32;
var local_52: i32;
var phi_14913_: i32;
var local_53: i32;
var local_54: i32;
var phi_14925_: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var phi_15161_: i32;
var phi_15164_: i32;
var phi_15166_: i32;
var phi_15168_: i32;
var phi_15183_: i32;
var phi_15189_: i32;
var phi_15162_: i32;
var phi_15165_: i32;
var phi_15167_: i32;
var phi_15169_: i32;
var local_59: i32;
var local_60: i32;
var local_61: i32;
var phi_15264_: i32;
var local_62: i32;
var local_63: i32;
var phi_15270_: i32;
var local_64: i32;
var phi_15277_: i32;
var local_65: i32;
var local_66: i32;
var phi_15283_: i32;
var local_67: i32;
var local_68: i32;
var phi_15294_: i32;
var local_69: i32;
var local_70: i32;
var phi_15306_: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var phi_15561_: vec3<f32>;
var phi_14178_: vec3<f32>;
var phi_15562_: vec3<f32>;
var phi_15563_: vec3<f32>;
var phi_17400_: type_24;
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
let _e11103 = local_75;
phi_2733_ = _e11103;
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
let _e11119 = local_76;
phi_4079_ = _e11119;
}
let _e2179 = phi_4079_;
phi_4081_ = vec3<f32>(0f, 0f, 0f);
phi_4084_ = 0i;
phi_4086_ = _e2179;
loop {
let _e2181 = phi_4081_;
let _e2183 = phi_4084_;
let _e2185 = phi_4086_;
local_81 = _e2181;
let _e2186 = (_e2183 < _e1675);
if _e2186 {
let _e2191 = (_e1660 + (_e1679 * ((2f * f32(_e2183)) + 1f)));
let _e2194 = (_e2191 + (_e1679 * -(0.8611363f)));
let _e2195 = (_e2194 * _e2194);
let _e2196 = (1f - _e2195);
let _e2198 = select(1e-9f, _e2196, (_e2196 > 1e-9f));
let _e2208 = select((_e1633 + (_e1649 * ((2f * _e2194) / _e2198))), _e2194, _e1650);
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
let _e2474 = (_e2191 + (_e1679 * -(0.33998105f)));
let _e2475 = (_e2474 * _e2474);
let _e2476 = (1f - _e2475);
let _e2478 = select(1e-9f, _e2476, (_e2476 > 1e-9f));
let _e2488 = select((_e1633 + (_e1649 * ((2f * _e2474) / _e2478))), _e2474, _e1650);
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
let _e3298 = (_e2191 - _e1679);
let _e3300 = (1f - (_e3298 * _e3298));
let _e3308 = (_e2191 + _e1679);
let _e3310 = (1f - (_e3308 * _e3308));
let _e3320 = (_e2185 + (_e2471 * (_e2208 - select((_e1633 + (_e1649 * ((2f * _e3298) / select(1e-9f, _e3300, (_e3300 > 1e-9f))))), _e3298, _e1650))));
let _e3325 = (_e3320 + ((0.5f * (_e2471 + _e2747)) * (_e2488 - _e2208)));
let _e3330 = (_e3325 + ((0.5f * (_e2747 + _e3022)) * (_e2763 - _e2488)));
let _e3335 = (_e3330 + ((0.5f * (_e3022 + _e3297)) * (_e3038 - _e2763)));
let _e3336 = (_e2208 - _e846);
let _e3342 = global_1.member.member_10.member_2;
let _e3346 = vec3<f32>(_e3342.member, _e3342.member_1, _e3342.member_2);
let _e3349 = global_1.member.member_10.member;
let _e3350 = (_e3349 == 0u);
if _e3350 {
let _e3688 = global_1.member.member_10.member_1;
phi_6262_ = type_26(vec3<f32>(_e3688.member, _e3688.member_1, _e3688.member_2), _e3346);
} else {
let _e3353 = global_1.member.member_10.member_3;
let _e3358 = (_e2217.x - _e3353.member);
let _e3360 = (_e2217.y - _e3353.member_1);
let _e3362 = (_e2217.z - _e3353.member_2);
let _e3367 = (((_e3358 * _e3358) + (_e3360 * _e3360)) + (_e3362 * _e3362));
let _e3369 = select(1e-12f, _e3367, (_e3367 > 1e-12f));
let _e3370 = (1f / _e3369);
let _e3374 = vec3<f32>((_e3342.member * _e3370), (_e3342.member_1 * _e3370), (_e3342.member_2 * _e3370));
if (_e3349 == 2u) {
let _e3378 = global_1.member.member_10.member_1;
let _e3386 = (((_e3378.member * _e3358) + (_e3378.member_1 * _e3360)) + (_e3378.member_2 * _e3362));
let _e3389 = (1f / select(1e-20f, _e3386, (_e3386 > 1e-20f)));
let _e3393 = global_1.member.member_10.member_4.member;
let _e3402 = ((((_e3393.member * _e3358) + (_e3393.member_1 * _e3360)) + (_e3393.member_2 * _e3362)) * _e3389);
let _e3406 = global_1.member.member_10.member_4.member_1;
let _e3415 = ((((_e3406.member * _e3358) + (_e3406.member_1 * _e3360)) + (_e3406.member_2 * _e3362)) * _e3389);
let _e3419 = global_1.member.member_10.member_4.member_2;
let _e3422 = ((_e3402 * _e3402) + (_e3415 * _e3415));
let _e3430 = global_1.member.member_10.member_4.member_3;
let _e3431 = ((_e3419 - sqrt(select(0f, _e3422, (_e3422 > 0f)))) * _e3430);
let _e3433 = select(0f, _e3431, (_e3431 > 0f));
let _e3435 = select(1f, _e3433, (_e3433 < 1f));
let _e3441 = select(0f, ((_e3435 * _e3435) * (3f - (2f * _e3435))), (_e3386 > 0f));
let _e3445 = global_1.member.member_10.member_4.member_5;
if ((_e3445 > 0u) && (_e3441 > 0f)) {
let _e3450 = (0.5f / _e3419);
let _e3459 = global_1.member.member_10.member_4.member_6;
let _e3460 = bitcast<i32>(_e3459);
local_24 = bitcast<i32>(_e3445);
let _e3461 = local_24;
let _e3463 = f32((_e3461 - 1i));
let _e3465 = f32((_e3460 - 1i));
let _e3466 = local_24;
let _e3469 = (((0.5f + (_e3402 * _e3450)) * f32(_e3466)) - 0.5f);
let _e3471 = select(0f, _e3469, (_e3469 > 0f));
let _e3473 = select(_e3463, _e3471, (_e3471 < _e3463));
let _e3476 = (((0.5f - (_e3415 * _e3450)) * f32(_e3460)) - 0.5f);
let _e3478 = select(0f, _e3476, (_e3476 > 0f));
let _e3480 = select(_e3465, _e3478, (_e3478 < _e3465));
let _e3482 = select(0f, _e3473, (_e3473 > 0f));
let _e3484 = select(_e3463, _e3482, (_e3482 < _e3463));
let _e3491 = select(0i, select(select(i32(_e3484), i32(-2147483648), (_e3484 < -2147483600f)), 2147483647i, (_e3484 > 2147483500f)), (_e3484 == _e3484));
let _e3495 = (_e3491 - select(0i, 1i, (_e3484 < f32(_e3491))));
let _e3497 = select(0f, _e3480, (_e3480 > 0f));
let _e3499 = select(_e3465, _e3497, (_e3497 < _e3465));
let _e3506 = select(0i, select(select(i32(_e3499), i32(-2147483648), (_e3499 < -2147483600f)), 2147483647i, (_e3499 > 2147483500f)), (_e3499 == _e3499));
let _e3510 = (_e3506 - select(0i, 1i, (_e3499 < f32(_e3506))));
let _e3512 = (_e3473 - f32(_e3495));
let _e3514 = (_e3480 - f32(_e3510));
let _e3515 = (_e3495 + 1i);
let _e3516 = local_24;
let _e3518 = select(_e3495, _e3515, (_e3515 < _e3516));
let _e3519 = (_e3510 + 1i);
let _e3521 = select(_e3510, _e3519, (_e3519 < _e3460));
let _e3525 = global_1.member.member_10.member_4.member_4;
let _e3526 = bitcast<i32>(_e3525);
let _e3527 = local_24;
let _e3531 = (_e3526 + (3i * ((_e3510 * _e3527) + _e3495)));
let _e3533 = (bitcast<i32>(_e180) - 1i);
let _e3535 = select(_e3533, _e3531, (_e3531 < _e3533));
let _e3540 = global_3.member[bitcast<u32>(select(0i, _e3535, (_e3535 > 0i)))];
let _e3541 = (_e3531 + 1i);
let _e3543 = select(_e3533, _e3541, (_e3541 < _e3533));
let _e3548 = global_3.member[bitcast<u32>(select(0i, _e3543, (_e3543 > 0i)))];
let _e3549 = (_e3531 + 2i);
let _e3551 = select(_e3533, _e3549, (_e3549 < _e3533));
let _e3556 = global_3.member[bitcast<u32>(select(0i, _e3551, (_e3551 > 0i)))];
let _e3557 = local_24;
let _e3561 = (_e3526 + (3i * ((_e3510 * _e3557) + _e3518)));
let _e3563 = select(_e3533, _e3561, (_e3561 < _e3533));
let _e3568 = global_3.member[bitcast<u32>(select(0i, _e3563, (_e3563 > 0i)))];
let _e3569 = (_e3561 + 1i);
let _e3571 = select(_e3533, _e3569, (_e3569 < _e3533));
let _e3576 = global_3.member[bitcast<u32>(select(0i, _e3571, (_e3571 > 0i)))];
let _e3577 = (_e3561 + 2i);
let _e3579 = select(_e3533, _e3577, (_e3577 < _e3533));
let _e3584 = global_3.member[bitcast<u32>(select(0i, _e3579, (_e3579 > 0i)))];
let _e3585 = local_24;
let _e3589 = (_e3526 + (3i * ((_e3521 * _e3585) + _e3495)));
let _e3591 = select(_e3533, _e3589, (_e3589 < _e3533));
let _e3596 = global_3.member[bitcast<u32>(select(0i, _e3591, (_e3591 > 0i)))];
let _e3597 = (_e3589 + 1i);
let _e3599 = select(_e3533, _e3597, (_e3597 < _e3533));
let _e3604 = global_3.member[bitcast<u32>(select(0i, _e3599, (_e3599 > 0i)))];
let _e3605 = (_e3589 + 2i);
let _e3607 = select(_e3533, _e3605, (_e3605 < _e3533));
let _e3612 = global_3.member[bitcast<u32>(select(0i, _e3607, (_e3607 > 0i)))];
let _e3613 = local_24;
let _e3617 = (_e3526 + (3i * ((_e3521 * _e3613) + _e3518)));
let _e3619 = select(_e3533, _e3617, (_e3617 < _e3533));
let _e3624 = global_3.member[bitcast<u32>(select(0i, _e3619, (_e3619 > 0i)))];
let _e3625 = (_e3617 + 1i);
let _e3627 = select(_e3533, _e3625, (_e3625 < _e3533));
let _e3632 = global_3.member[bitcast<u32>(select(0i, _e3627, (_e3627 > 0i)))];
let _e3633 = (_e3617 + 2i);
let _e3635 = select(_e3533, _e3633, (_e3633 < _e3533));
let _e3640 = global_3.member[bitcast<u32>(select(0i, _e3635, (_e3635 > 0i)))];
let _e3647 = (_e3540 + ((_e3568 - _e3540) * _e3512));
let _e3648 = (_e3548 + ((_e3576 - _e3548) * _e3512));
let _e3649 = (_e3556 + ((_e3584 - _e3556) * _e3512));
phi_6246_ = vec3<f32>(((_e3647 + (((_e3596 + ((_e3624 - _e3596) * _e3512)) - _e3647) * _e3514)) * _e3441), ((_e3648 + (((_e3604 + ((_e3632 - _e3604) * _e3512)) - _e3648) * _e3514)) * _e3441), ((_e3649 + (((_e3612 + ((_e3640 - _e3612) * _e3512)) - _e3649) * _e3514)) * _e3441));
} else {
phi_6246_ = vec3(_e3441);
}
let _e3673 = phi_6246_;
phi_6249_ = (_e3374 * _e3673);
} else {
phi_6249_ = _e3374;
}
let _e3676 = phi_6249_;
let _e3680 = (1f / sqrt(select(0f, _e3369, (_e3369 > 0f))));
phi_6262_ = type_26(vec3<f32>((_e3358 * _e3680), (_e3360 * _e3680), (_e3362 * _e3680)), _e3676);
}
let _e3695 = phi_6262_;
let _e3699 = global_1.member.member_10.member_3;
let _e3704 = (_e3699.member - _e2217.x);
let _e3706 = (_e3699.member_1 - _e2217.y);
let _e3708 = (_e3699.member_2 - _e2217.z);
let _e3713 = (((_e3704 * _e3704) + (_e3706 * _e3706)) + (_e3708 * _e3708));
let _e3717 = select(sqrt(select(0f, _e3713, (_e3713 > 0f))), 1e30f, _e3350);
let _e3719 = -(_e3695.member.x);
let _e3721 = -(_e3695.member.y);
let _e3723 = -(_e3695.member.z);
let _e3731 = (1f / select(_e3719, select(1e-12f, -1e-12f, (_e3719 < 0f)), (bitcast<f32>((bitcast<u32>(_e3719) & 2147483647u)) < 1e-12f)));
let _e3739 = (1f / select(_e3721, select(1e-12f, -1e-12f, (_e3721 < 0f)), (bitcast<f32>((bitcast<u32>(_e3721) & 2147483647u)) < 1e-12f)));
let _e3747 = (1f / select(_e3723, select(1e-12f, -1e-12f, (_e3723 < 0f)), (bitcast<f32>((bitcast<u32>(_e3723) & 2147483647u)) < 1e-12f)));
let _e3750 = global_1.member.member_13.member_4;
let _e3756 = global_1.member.member_13.member_5;
let _e3761 = ((_e3750.member - _e2217.x) * _e3731);
let _e3763 = ((_e3756.member - _e2217.x) * _e3731);
let _e3765 = ((_e3750.member_1 - _e2217.y) * _e3739);
let _e3767 = ((_e3756.member_1 - _e2217.y) * _e3739);
let _e3769 = ((_e3750.member_2 - _e2217.z) * _e3747);
let _e3771 = ((_e3756.member_2 - _e2217.z) * _e3747);
let _e3773 = select(_e3763, _e3761, (_e3761 < _e3763));
let _e3775 = select(_e3767, _e3765, (_e3765 < _e3767));
let _e3777 = select(_e3775, _e3773, (_e3773 > _e3775));
let _e3779 = select(_e3771, _e3769, (_e3769 < _e3771));
let _e3781 = select(_e3779, _e3777, (_e3777 > _e3779));
let _e3783 = select(_e3763, _e3761, (_e3761 > _e3763));
let _e3785 = select(_e3767, _e3765, (_e3765 > _e3767));
let _e3787 = select(_e3785, _e3783, (_e3783 < _e3785));
let _e3789 = select(_e3771, _e3769, (_e3769 > _e3771));
let _e3791 = select(_e3789, _e3787, (_e3787 < _e3789));
let _e3793 = select(0f, _e3781, (_e3781 > 0f));
let _e3795 = select(_e3717, _e3791, (_e3791 < _e3717));
let _e3796 = (_e3795 > _e3793);
let _e3797 = select(0f, _e3793, _e3796);
let _e3799 = (select(0f, _e3795, _e3796) - _e3797);
if _e2221 {
phi_7177_ = _e3799;
} else {
let _e3801 = (_e3799 / f32(_e2220));
phi_6458_ = 0u;
phi_6461_ = 0f;
loop {
let _e3803 = phi_6458_;
let _e3805 = phi_6461_;
local_77 = _e3805;
let _e3808 = ((_e3803 < _e2220) && (_e3799 > 0f));
if _e3808 {
let _e3811 = (_e3797 + (_e3801 * f32(_e3803)));
let _e3812 = (_e3811 + _e3801);
let _e3814 = (0.5f * (_e3811 + _e3812));
let _e3815 = (_e3812 - _e3811);
let _e3816 = (0.28867513f * _e3815);
let _e3817 = (_e3814 - _e3816);
let _e3826 = global_1.member.member_13.member_7;
let _e3827 = bitcast<i32>(_e3826);
let _e3830 = global_1.member.member_13.member_8;
let _e3831 = bitcast<i32>(_e3830);
let _e3834 = global_1.member.member_13.member_9;
let _e3835 = bitcast<i32>(_e3834);
let _e3836 = f32(_e3827);
let _e3838 = (_e3756.member - _e3750.member);
let _e3841 = (((((_e2217.x + (_e3719 * _e3817)) - _e3750.member) / _e3838) * _e3836) - 0.5f);
let _e3842 = (_e3836 - 1f);
let _e3844 = select(0f, _e3841, (_e3841 > 0f));
let _e3846 = select(_e3842, _e3844, (_e3844 < _e3842));
let _e3847 = f32(_e3831);
let _e3849 = (_e3756.member_1 - _e3750.member_1);
let _e3852 = (((((_e2217.y + (_e3721 * _e3817)) - _e3750.member_1) / _e3849) * _e3847) - 0.5f);
let _e3853 = (_e3847 - 1f);
let _e3855 = select(0f, _e3852, (_e3852 > 0f));
let _e3857 = select(_e3853, _e3855, (_e3855 < _e3853));
let _e3858 = f32(_e3835);
let _e3860 = (_e3756.member_2 - _e3750.member_2);
let _e3863 = (((((_e2217.z + (_e3723 * _e3817)) - _e3750.member_2) / _e3860) * _e3858) - 0.5f);
let _e3864 = (_e3858 - 1f);
let _e3866 = select(0f, _e3863, (_e3863 > 0f));
let _e3868 = select(_e3864, _e3866, (_e3866 < _e3864));
let _e3870 = select(0f, _e3846, (_e3846 > 0f));
let _e3872 = select(1e6f, _e3870, (_e3870 < 1e6f));
let _e3879 = select(0i, select(select(i32(_e3872), i32(-2147483648), (_e3872 < -2147483600f)), 2147483647i, (_e3872 > 2147483500f)), (_e3872 == _e3872));
let _e3883 = (_e3879 - select(0i, 1i, (_e3872 < f32(_e3879))));
let _e3885 = select(0f, _e3857, (_e3857 > 0f));
let _e3887 = select(1e6f, _e3885, (_e3885 < 1e6f));
let _e3894 = select(0i, select(select(i32(_e3887), i32(-2147483648), (_e3887 < -2147483600f)), 2147483647i, (_e3887 > 2147483500f)), (_e3887 == _e3887));
let _e3898 = (_e3894 - select(0i, 1i, (_e3887 < f32(_e3894))));
let _e3900 = select(0f, _e3868, (_e3868 > 0f));
let _e3902 = select(1e6f, _e3900, (_e3900 < 1e6f));
let _e3909 = select(0i, select(select(i32(_e3902), i32(-2147483648), (_e3902 < -2147483600f)), 2147483647i, (_e3902 > 2147483500f)), (_e3902 == _e3902));
let _e3913 = (_e3909 - select(0i, 1i, (_e3902 < f32(_e3909))));
let _e3917 = (_e3857 - f32(_e3898));
let _e3919 = (_e3868 - f32(_e3913));
local_22 = (_e3846 - f32(_e3883));
let _e3920 = (_e3883 + 1i);
let _e3922 = select(_e3920, 0i, (_e3920 < 0i));
if (_e3922 >= _e3827) {
phi_6599_ = (_e3827 - 1i);
} else {
phi_6599_ = _e3922;
}
let _e3926 = phi_6599_;
local_23 = (_e3926 - _e3883);
let _e3928 = (_e3898 + 1i);
let _e3930 = select(_e3928, 0i, (_e3928 < 0i));
if (_e3930 >= _e3831) {
phi_6612_ = (_e3831 - 1i);
} else {
phi_6612_ = _e3930;
}
let _e3934 = phi_6612_;
let _e3936 = ((_e3934 - _e3898) * _e3827);
let _e3937 = (_e3913 + 1i);
let _e3939 = select(_e3937, 0i, (_e3937 < 0i));
if (_e3939 >= _e3835) {
phi_6626_ = (_e3835 - 1i);
} else {
phi_6626_ = _e3939;
}
let _e3943 = phi_6626_;
let _e3949 = global_1.member.member_13.member_10;
let _e3950 = bitcast<i32>(_e3949);
let _e3955 = ((_e3950 + (((_e3913 * _e3831) + _e3898) * _e3827)) + _e3883);
let _e3957 = (bitcast<i32>(_e187) - 1i);
let _e3959 = select(_e3957, _e3955, (_e3955 < _e3957));
let _e3964 = global_7.member[bitcast<u32>(select(0i, _e3959, (_e3959 > 0i)))];
let _e3965 = local_22;
let _e3968 = local_23;
let _e3969 = (_e3955 + _e3968);
let _e3971 = select(_e3957, _e3969, (_e3969 < _e3957));
let _e3976 = global_7.member[bitcast<u32>(select(0i, _e3971, (_e3971 > 0i)))];
let _e3977 = local_22;
let _e3980 = (1f - _e3917);
let _e3982 = (_e3955 + _e3936);
let _e3984 = select(_e3957, _e3982, (_e3982 < _e3957));
let _e3989 = global_7.member[bitcast<u32>(select(0i, _e3984, (_e3984 > 0i)))];
let _e3990 = local_22;
let _e3993 = local_23;
let _e3994 = (_e3982 + _e3993);
let _e3996 = select(_e3957, _e3994, (_e3994 < _e3957));
let _e4001 = global_7.member[bitcast<u32>(select(0i, _e3996, (_e3996 > 0i)))];
let _e4002 = local_22;
let _e4007 = (_e3955 + (((_e3943 - _e3913) * _e3827) * _e3831));
let _e4009 = select(_e3957, _e4007, (_e4007 < _e3957));
let _e4014 = global_7.member[bitcast<u32>(select(0i, _e4009, (_e4009 > 0i)))];
let _e4015 = local_22;
let _e4018 = local_23;
let _e4019 = (_e4007 + _e4018);
let _e4021 = select(_e3957, _e4019, (_e4019 < _e3957));
let _e4026 = global_7.member[bitcast<u32>(select(0i, _e4021, (_e4021 > 0i)))];
let _e4027 = local_22;
let _e4031 = (_e4007 + _e3936);
let _e4033 = select(_e3957, _e4031, (_e4031 < _e3957));
let _e4038 = global_7.member[bitcast<u32>(select(0i, _e4033, (_e4033 > 0i)))];
let _e4039 = local_22;
let _e4042 = local_23;
let _e4043 = (_e4031 + _e4042);
let _e4045 = select(_e3957, _e4043, (_e4043 < _e3957));
let _e4050 = global_7.member[bitcast<u32>(select(0i, _e4045, (_e4045 > 0i)))];
let _e4051 = local_22;
let _e4060 = (_e3814 + _e3816);
let _e4070 = (((((_e2217.x + (_e3719 * _e4060)) - _e3750.member) / _e3838) * _e3836) - 0.5f);
let _e4072 = select(0f, _e4070, (_e4070 > 0f));
let _e4074 = select(_e3842, _e4072, (_e4072 < _e3842));
let _e4078 = (((((_e2217.y + (_e3721 * _e4060)) - _e3750.member_1) / _e3849) * _e3847) - 0.5f);
let _e4080 = select(0f, _e4078, (_e4078 > 0f));
let _e4082 = select(_e3853, _e4080, (_e4080 < _e3853));
let _e4086 = (((((_e2217.z + (_e3723 * _e4060)) - _e3750.member_2) / _e3860) * _e3858) - 0.5f);
let _e4088 = select(0f, _e4086, (_e4086 > 0f));
let _e4090 = select(_e3864, _e4088, (_e4088 < _e3864));
let _e4092 = select(0f, _e4074, (_e4074 > 0f));
let _e4094 = select(1e6f, _e4092, (_e4092 < 1e6f));
let _e4101 = select(0i, select(select(i32(_e4094), i32(-2147483648), (_e4094 < -2147483600f)), 2147483647i, (_e4094 > 2147483500f)), (_e4094 == _e4094));
let _e4105 = (_e4101 - select(0i, 1i, (_e4094 < f32(_e4101))));
let _e4107 = select(0f, _e4082, (_e4082 > 0f));
let _e4109 = select(1e6f, _e4107, (_e4107 < 1e6f));
let _e4116 = select(0i, select(select(i32(_e4109), i32(-2147483648), (_e4109 < -2147483600f)), 2147483647i, (_e4109 > 2147483500f)), (_e4109 == _e4109));
let _e4120 = (_e4116 - select(0i, 1i, (_e4109 < f32(_e4116))));
let _e4122 = select(0f, _e4090, (_e4090 > 0f));
let _e4124 = select(1e6f, _e4122, (_e4122 < 1e6f));
let _e4131 = select(0i, select(select(i32(_e4124), i32(-2147483648), (_e4124 < -2147483600f)), 2147483647i, (_e4124 > 2147483500f)), (_e4124 == _e4124));
let _e4135 = (_e4131 - select(0i, 1i, (_e4124 < f32(_e4131))));
let _e4139 = (_e4082 - f32(_e4120));
let _e4141 = (_e4090 - f32(_e4135));
local_20 = (_e4074 - f32(_e4105));
let _e4142 = (_e4105 + 1i);
let _e4144 = select(_e4142, 0i, (_e4142 < 0i));
if (_e4144 >= _e3827) {
phi_6945_ = (_e3827 - 1i);
} else {
phi_6945_ = _e4144;
}
let _e4148 = phi_6945_;
local_21 = (_e4148 - _e4105);
let _e4150 = (_e4120 + 1i);
let _e4152 = select(_e4150, 0i, (_e4150 < 0i));
if (_e4152 >= _e3831) {
phi_6958_ = (_e3831 - 1i);
} else {
phi_6958_ = _e4152;
}
let _e4156 = phi_6958_;
let _e4158 = ((_e4156 - _e4120) * _e3827);
let _e4159 = (_e4135 + 1i);
let _e4161 = select(_e4159, 0i, (_e4159 < 0i));
if (_e4161 >= _e3835) {
phi_6972_ = (_e3835 - 1i);
} else {
phi_6972_ = _e4161;
}
let _e4165 = phi_6972_;
let _e4173 = ((_e3950 + (((_e4135 * _e3831) + _e4120) * _e3827)) + _e4105);
let _e4175 = select(_e3957, _e4173, (_e4173 < _e3957));
let _e4180 = global_7.member[bitcast<u32>(select(0i, _e4175, (_e4175 > 0i)))];
let _e4181 = local_20;
let _e4184 = local_21;
let _e4185 = (_e4173 + _e4184);
let _e4187 = select(_e3957, _e4185, (_e4185 < _e3957));
let _e4192 = global_7.member[bitcast<u32>(select(0i, _e4187, (_e4187 > 0i)))];
let _e4193 = local_20;
let _e4196 = (1f - _e4139);
let _e4198 = (_e4173 + _e4158);
let _e4200 = select(_e3957, _e4198, (_e4198 < _e3957));
let _e4205 = global_7.member[bitcast<u32>(select(0i, _e4200, (_e4200 > 0i)))];
let _e4206 = local_20;
let _e4209 = local_21;
let _e4210 = (_e4198 + _e4209);
let _e4212 = select(_e3957, _e4210, (_e4210 < _e3957));
let _e4217 = global_7.member[bitcast<u32>(select(0i, _e4212, (_e4212 > 0i)))];
let _e4218 = local_20;
let _e4223 = (_e4173 + (((_e4165 - _e4135) * _e3827) * _e3831));
let _e4225 = select(_e3957, _e4223, (_e4223 < _e3957));
let _e4230 = global_7.member[bitcast<u32>(select(0i, _e4225, (_e4225 > 0i)))];
let _e4231 = local_20;
let _e4234 = local_21;
let _e4235 = (_e4223 + _e4234);
let _e4237 = select(_e3957, _e4235, (_e4235 < _e3957));
let _e4242 = global_7.member[bitcast<u32>(select(0i, _e4237, (_e4237 > 0i)))];
let _e4243 = local_20;
let _e4247 = (_e4223 + _e4158);
let _e4249 = select(_e3957, _e4247, (_e4247 < _e3957));
let _e4254 = global_7.member[bitcast<u32>(select(0i, _e4249, (_e4249 > 0i)))];
let _e4255 = local_20;
let _e4258 = local_21;
let _e4259 = (_e4247 + _e4258);
let _e4261 = select(_e3957, _e4259, (_e4259 < _e3957));
let _e4266 = global_7.member[bitcast<u32>(select(0i, _e4261, (_e4261 > 0i)))];
let _e4267 = local_20;
phi_6459_ = (_e3803 + 1u);
phi_6462_ = (_e3805 + ((0.5f * (((((((_e3964 * (1f - _e3965)) + (_e3976 * _e3977)) * _e3980) + (((_e3989 * (1f - _e3990)) + (_e4001 * _e4002)) * _e3917)) * (1f - _e3919)) + (((((_e4014 * (1f - _e4015)) + (_e4026 * _e4027)) * _e3980) + (((_e4038 * (1f - _e4039)) + (_e4050 * _e4051)) * _e3917)) * _e3919)) + ((((((_e4180 * (1f - _e4181)) + (_e4192 * _e4193)) * _e4196) + (((_e4205 * (1f - _e4206)) + (_e4217 * _e4218)) * _e4139)) * (1f - _e4141)) + (((((_e4230 * (1f - _e4231)) + (_e4242 * _e4243)) * _e4196) + (((_e4254 * (1f - _e4255)) + (_e4266 * _e4267)) * _e4139)) * _e4141)))) * _e3815));
} else {
phi_6459_ = u32();
phi_6462_ = f32();
}
let _e4282 = phi_6459_;
let _e4284 = phi_6462_;
continue;
continuing {
phi_6458_ = _e4282;
phi_6461_ = _e4284;
break if !(_e3808);
}
}
let _e11154 = local_77;
phi_7177_ = _e11154;
}
let _e4287 = phi_7177_;
let _e4288 = (_e4287 + select(_e3320, select(0f, _e3336, (_e3336 > 0f)), _e853));
let _e4291 = global_1.member.member_13.member;
let _e4296 = -((_e4291.member * _e4288));
let _e4298 = select(-87f, _e4296, (_e4296 > -87f));
let _e4300 = select(88f, _e4298, (_e4298 < 88f));
let _e4302 = ((_e4300 * 1.442695f) + 0.5f);
let _e4304 = select(-127f, _e4302, (_e4302 > -127f));
let _e4306 = select(128f, _e4304, (_e4304 < 128f));
let _e4313 = select(0i, select(select(i32(_e4306), i32(-2147483648), (_e4306 < -2147483600f)), 2147483647i, (_e4306 > 2147483500f)), (_e4306 == _e4306));
let _e4317 = (_e4313 - select(0i, 1i, (_e4306 < f32(_e4313))));
let _e4318 = f32(_e4317);
let _e4322 = ((_e4300 - (_e4318 * 0.6933594f)) - (_e4318 * -2.1219444e-4f));
let _e4344 = -((_e4291.member_1 * _e4288));
let _e4346 = select(-87f, _e4344, (_e4344 > -87f));
let _e4348 = select(88f, _e4346, (_e4346 < 88f));
let _e4350 = ((_e4348 * 1.442695f) + 0.5f);
let _e4352 = select(-127f, _e4350, (_e4350 > -127f));
let _e4354 = select(128f, _e4352, (_e4352 < 128f));
let _e4361 = select(0i, select(select(i32(_e4354), i32(-2147483648), (_e4354 < -2147483600f)), 2147483647i, (_e4354 > 2147483500f)), (_e4354 == _e4354));
let _e4365 = (_e4361 - select(0i, 1i, (_e4354 < f32(_e4361))));
let _e4366 = f32(_e4365);
let _e4370 = ((_e4348 - (_e4366 * 0.6933594f)) - (_e4366 * -2.1219444e-4f));
let _e4392 = -((_e4291.member_2 * _e4288));
let _e4394 = select(-87f, _e4392, (_e4392 > -87f));
let _e4396 = select(88f, _e4394, (_e4394 < 88f));
let _e4398 = ((_e4396 * 1.442695f) + 0.5f);
let _e4400 = select(-127f, _e4398, (_e4398 > -127f));
let _e4402 = select(128f, _e4400, (_e4400 < 128f));
let _e4409 = select(0i, select(select(i32(_e4402), i32(-2147483648), (_e4402 < -2147483600f)), 2147483647i, (_e4402 > 2147483500f)), (_e4402 == _e4402));
let _e4413 = (_e4409 - select(0i, 1i, (_e4402 < f32(_e4409))));
let _e4414 = f32(_e4413);
let _e4418 = ((_e4396 - (_e4414 * 0.6933594f)) - (_e4414 * -2.1219444e-4f));
let _e4444 = -((((_e3695.member.x * _e512) + (_e3695.member.y * _e523)) + (_e3695.member.z * _e534)));
let _e4447 = global_1.member.member_13.member_2;
let _e4448 = (_e4447 * _e4447);
let _e4449 = (1f + _e4448);
let _e4450 = (2f * _e4447);
let _e4452 = (_e4449 - (_e4450 * _e4444));
let _e4454 = select(1e-9f, _e4452, (_e4452 > 1e-9f));
let _e4455 = (1f - _e4448);
let _e4466 = global_1.member.member_13.member_3;
let _e4467 = (_e4466 == 1u);
let _e4469 = (_e4466 == 2u);
if _e4469 {
let _e4471 = (0.5f - (0.5f * _e4444));
let _e4473 = select(0f, _e4471, (_e4471 > 0f));
let _e4477 = (sqrt(select(0f, _e4473, (_e4473 > 0f))) * 255f);
let _e4478 = (255f - 1f);
let _e4480 = select(0f, _e4477, (_e4477 > 0f));
let _e4482 = select(_e4478, _e4480, (_e4480 < _e4478));
let _e4489 = select(0i, select(select(i32(_e4482), i32(-2147483648), (_e4482 < -2147483600f)), 2147483647i, (_e4482 > 2147483500f)), (_e4482 == _e4482));
let _e4493 = (_e4489 - select(0i, 1i, (_e4482 < f32(_e4489))));
let _e4496 = global_1.member.member_13.member_11;
let _e4497 = bitcast<i32>(_e4496);
let _e4498 = (_e4497 + _e4493);
let _e4500 = (bitcast<i32>(_e187) - 1i);
let _e4502 = select(_e4500, _e4498, (_e4498 < _e4500));
let _e4507 = global_7.member[bitcast<u32>(select(0i, _e4502, (_e4502 > 0i)))];
let _e4509 = (_e4497 + (_e4493 + 1i));
let _e4511 = select(_e4500, _e4509, (_e4509 < _e4500));
let _e4516 = global_7.member[bitcast<u32>(select(0i, _e4511, (_e4511 > 0i)))];
phi_7538_ = (_e4507 + ((_e4516 - _e4507) * (_e4477 - f32(_e4493))));
} else {
phi_7538_ = select((_e4455 / (_e4454 * sqrt(select(0f, _e4454, (_e4454 > 0f))))), (0.75f * (1f + (_e4444 * _e4444))), _e4467);
}
let _e4523 = phi_7538_;
let _e4524 = (0.25f / 3.1415927f);
let _e4528 = ((3.1415927f * (_e4523 * _e4524)) * (select((_e1649 * ((2f * (1f + _e2195)) / (_e2198 * _e2198))), 1f, _e1650) * _e2471));
let _e4538 = global_1.member.member_13.member_1;
let _e4548 = (_e3038 - _e846);
if _e3350 {
let _e4883 = global_1.member.member_10.member_1;
phi_8108_ = type_26(vec3<f32>(_e4883.member, _e4883.member_1, _e4883.member_2), _e3346);
} else {
let _e4553 = (_e3047.x - _e3699.member);
let _e4555 = (_e3047.y - _e3699.member_1);
let _e4557 = (_e3047.z - _e3699.member_2);
let _e4562 = (((_e4553 * _e4553) + (_e4555 * _e4555)) + (_e4557 * _e4557));
let _e4564 = select(1e-12f, _e4562, (_e4562 > 1e-12f));
let _e4565 = (1f / _e4564);
let _e4569 = vec3<f32>((_e3342.member * _e4565), (_e3342.member_1 * _e4565), (_e3342.member_2 * _e4565));
if (_e3349 == 2u) {
let _e4573 = global_1.member.member_10.member_1;
let _e4581 = (((_e4573.member * _e4553) + (_e4573.member_1 * _e4555)) + (_e4573.member_2 * _e4557));
let _e4584 = (1f / select(1e-20f, _e4581, (_e4581 > 1e-20f)));
let _e4588 = global_1.member.member_10.member_4.member;
let _e4597 = ((((_e4588.member * _e4553) + (_e4588.member_1 * _e4555)) + (_e4588.member_2 * _e4557)) * _e4584);
let _e4601 = global_1.member.member_10.member_4.member_1;
let _e4610 = ((((_e4601.member * _e4553) + (_e4601.member_1 * _e4555)) + (_e4601.member_2 * _e4557)) * _e4584);
let _e4614 = global_1.member.member_10.member_4.member_2;
let _e4617 = ((_e4597 * _e4597) + (_e4610 * _e4610));
let _e4625 = global_1.member.member_10.member_4.member_3;
let _e4626 = ((_e4614 - sqrt(select(0f, _e4617, (_e4617 > 0f)))) * _e4625);
let _e4628 = select(0f, _e4626, (_e4626 > 0f));
let _e4630 = select(1f, _e4628, (_e4628 < 1f));
let _e4636 = select(0f, ((_e4630 * _e4630) * (3f - (2f * _e4630))), (_e4581 > 0f));
let _e4640 = global_1.member.member_10.member_4.member_5;
if ((_e4640 > 0u) && (_e4636 > 0f)) {
let _e4645 = (0.5f / _e4614);
let _e4654 = global_1.member.member_10.member_4.member_6;
let _e4655 = bitcast<i32>(_e4654);
local_19 = bitcast<i32>(_e4640);
let _e4656 = local_19;
let _e4658 = f32((_e4656 - 1i));
let _e4660 = f32((_e4655 - 1i));
let _e4661 = local_19;
let _e4664 = (((0.5f + (_e4597 * _e4645)) * f32(_e4661)) - 0.5f);
let _e4666 = select(0f, _e4664, (_e4664 > 0f));
let _e4668 = select(_e4658, _e4666, (_e4666 < _e4658));
let _e4671 = (((0.5f - (_e4610 * _e4645)) * f32(_e4655)) - 0.5f);
let _e4673 = select(0f, _e4671, (_e4671 > 0f));
let _e4675 = select(_e4660, _e4673, (_e4673 < _e4660));
let _e4677 = select(0f, _e4668, (_e4668 > 0f));
let _e4679 = select(_e4658, _e4677, (_e4677 < _e4658));
let _e4686 = select(0i, select(select(i32(_e4679), i32(-2147483648), (_e4679 < -2147483600f)), 2147483647i, (_e4679 > 2147483500f)), (_e4679 == _e4679));
let _e4690 = (_e4686 - select(0i, 1i, (_e4679 < f32(_e4686))));
let _e4692 = select(0f, _e4675, (_e4675 > 0f));
let _e4694 = select(_e4660, _e4692, (_e4692 < _e4660));
let _e4701 = select(0i, select(select(i32(_e4694), i32(-2147483648), (_e4694 < -2147483600f)), 2147483647i, (_e4694 > 2147483500f)), (_e4694 == _e4694));
let _e4705 = (_e4701 - select(0i, 1i, (_e4694 < f32(_e4701))));
let _e4707 = (_e4668 - f32(_e4690));
let _e4709 = (_e4675 - f32(_e4705));
let _e4710 = (_e4690 + 1i);
let _e4711 = local_19;
let _e4713 = select(_e4690, _e4710, (_e4710 < _e4711));
let _e4714 = (_e4705 + 1i);
let _e4716 = select(_e4705, _e4714, (_e4714 < _e4655));
let _e4720 = global_1.member.member_10.member_4.member_4;
let _e4721 = bitcast<i32>(_e4720);
let _e4722 = local_19;
let _e4726 = (_e4721 + (3i * ((_e4705 * _e4722) + _e4690)));
let _e4728 = (bitcast<i32>(_e180) - 1i);
let _e4730 = select(_e4728, _e4726, (_e4726 < _e4728));
let _e4735 = global_3.member[bitcast<u32>(select(0i, _e4730, (_e4730 > 0i)))];
let _e4736 = (_e4726 + 1i);
let _e4738 = select(_e4728, _e4736, (_e4736 < _e4728));
let _e4743 = global_3.member[bitcast<u32>(select(0i, _e4738, (_e4738 > 0i)))];
let _e4744 = (_e4726 + 2i);
let _e4746 = select(_e4728, _e4744, (_e4744 < _e4728));
let _e4751 = global_3.member[bitcast<u32>(select(0i, _e4746, (_e4746 > 0i)))];
let _e4752 = local_19;
let _e4756 = (_e4721 + (3i * ((_e4705 * _e4752) + _e4713)));
let _e4758 = select(_e4728, _e4756, (_e4756 < _e4728));
let _e4763 = global_3.member[bitcast<u32>(select(0i, _e4758, (_e4758 > 0i)))];
let _e4764 = (_e4756 + 1i);
let _e4766 = select(_e4728, _e4764, (_e4764 < _e4728));
let _e4771 = global_3.member[bitcast<u32>(select(0i, _e4766, (_e4766 > 0i)))];
let _e4772 = (_e4756 + 2i);
let _e4774 = select(_e4728, _e4772, (_e4772 < _e4728));
let _e4779 = global_3.member[bitcast<u32>(select(0i, _e4774, (_e4774 > 0i)))];
let _e4780 = local_19;
let _e4784 = (_e4721 + (3i * ((_e4716 * _e4780) + _e4690)));
let _e4786 = select(_e4728, _e4784, (_e4784 < _e4728));
let _e4791 = global_3.member[bitcast<u32>(select(0i, _e4786, (_e4786 > 0i)))];
let _e4792 = (_e4784 + 1i);
let _e4794 = select(_e4728, _e4792, (_e4792 < _e4728));
let _e4799 = global_3.member[bitcast<u32>(select(0i, _e4794, (_e4794 > 0i)))];
let _e4800 = (_e4784 + 2i);
let _e4802 = select(_e4728, _e4800, (_e4800 < _e4728));
let _e4807 = global_3.member[bitcast<u32>(select(0i, _e4802, (_e4802 > 0i)))];
let _e4808 = local_19;
let _e4812 = (_e4721 + (3i * ((_e4716 * _e4808) + _e4713)));
let _e4814 = select(_e4728, _e4812, (_e4812 < _e4728));
let _e4819 = global_3.member[bitcast<u32>(select(0i, _e4814, (_e4814 > 0i)))];
let _e4820 = (_e4812 + 1i);
let _e4822 = select(_e4728, _e4820, (_e4820 < _e4728));
let _e4827 = global_3.member[bitcast<u32>(select(0i, _e4822, (_e4822 > 0i)))];
let _e4828 = (_e4812 + 2i);
let _e4830 = select(_e4728, _e4828, (_e4828 < _e4728));
let _e4835 = global_3.member[bitcast<u32>(select(0i, _e4830, (_e4830 > 0i)))];
let _e4842 = (_e4735 + ((_e4763 - _e4735) * _e4707));
let _e4843 = (_e4743 + ((_e4771 - _e4743) * _e4707));
let _e4844 = (_e4751 + ((_e4779 - _e4751) * _e4707));
phi_8092_ = vec3<f32>(((_e4842 + (((_e4791 + ((_e4819 - _e4791) * _e4707)) - _e4842) * _e4709)) * _e4636), ((_e4843 + (((_e4799 + ((_e4827 - _e4799) * _e4707)) - _e4843) * _e4709)) * _e4636), ((_e4844 + (((_e4807 + ((_e4835 - _e4807) * _e4707)) - _e4844) * _e4709)) * _e4636));
} else {
phi_8092_ = vec3(_e4636);
}
let _e4868 = phi_8092_;
phi_8095_ = (_e4569 * _e4868);
} else {
phi_8095_ = _e4569;
}
let _e4871 = phi_8095_;
let _e4875 = (1f / sqrt(select(0f, _e4564, (_e4564 > 0f))));
phi_8108_ = type_26(vec3<f32>((_e4553 * _e4875), (_e4555 * _e4875), (_e4557 * _e4875)), _e4871);
}
let _e4890 = phi_8108_;
let _e4893 = (_e3699.member - _e3047.x);
let _e4895 = (_e3699.member_1 - _e3047.y);
let _e4897 = (_e3699.member_2 - _e3047.z);
let _e4902 = (((_e4893 * _e4893) + (_e4895 * _e4895)) + (_e4897 * _e4897));
let _e4906 = select(sqrt(select(0f, _e4902, (_e4902 > 0f))), 1e30f, _e3350);
let _e4908 = -(_e4890.member.x);
let _e4910 = -(_e4890.member.y);
let _e4912 = -(_e4890.member.z);
let _e4920 = (1f / select(_e4908, select(1e-12f, -1e-12f, (_e4908 < 0f)), (bitcast<f32>((bitcast<u32>(_e4908) & 2147483647u)) < 1e-12f)));
let _e4928 = (1f / select(_e4910, select(1e-12f, -1e-12f, (_e4910 < 0f)), (bitcast<f32>((bitcast<u32>(_e4910) & 2147483647u)) < 1e-12f)));
let _e4936 = (1f / select(_e4912, select(1e-12f, -1e-12f, (_e4912 < 0f)), (bitcast<f32>((bitcast<u32>(_e4912) & 2147483647u)) < 1e-12f)));
let _e4938 = ((_e3750.member - _e3047.x) * _e4920);
let _e4940 = ((_e3756.member - _e3047.x) * _e4920);
let _e4942 = ((_e3750.member_1 - _e3047.y) * _e4928);
let _e4944 = ((_e3756.member_1 - _e3047.y) * _e4928);
let _e4946 = ((_e3750.member_2 - _e3047.z) * _e4936);
let _e4948 = ((_e3756.member_2 - _e3047.z) * _e4936);
let _e4950 = select(_e4940, _e4938, (_e4938 < _e4940));
let _e4952 = select(_e4944, _e4942, (_e4942 < _e4944));
let _e4954 = select(_e4952, _e4950, (_e4950 > _e4952));
let _e4956 = select(_e4948, _e4946, (_e4946 < _e4948));
let _e4958 = select(_e4956, _e4954, (_e4954 > _e4956));
let _e4960 = select(_e4940, _e4938, (_e4938 > _e4940));
let _e4962 = select(_e4944, _e4942, (_e4942 > _e4944));
let _e4964 = select(_e4962, _e4960, (_e4960 < _e4962));
let _e4966 = select(_e4948, _e4946, (_e4946 > _e4948));
let _e4968 = select(_e4966, _e4964, (_e4964 < _e4966));
let _e4970 = select(0f, _e4958, (_e4958 > 0f));
let _e4972 = select(_e4906, _e4968, (_e4968 < _e4906));
let _e4973 = (_e4972 > _e4970);
let _e4974 = select(0f, _e4970, _e4973);
let _e4976 = (select(0f, _e4972, _e4973) - _e4974);
if _e2221 {
phi_9023_ = _e4976;
} else {
let _e4978 = (_e4976 / f32(_e2220));
phi_8304_ = 0u;
phi_8307_ = 0f;
loop {
let _e4980 = phi_8304_;
let _e4982 = phi_8307_;
local_78 = _e4982;
let _e4985 = ((_e4980 < _e2220) && (_e4976 > 0f));
if _e4985 {
let _e4988 = (_e4974 + (_e4978 * f32(_e4980)));
let _e4989 = (_e4988 + _e4978);
let _e4991 = (0.5f * (_e4988 + _e4989));
let _e4992 = (_e4989 - _e4988);
let _e4993 = (0.28867513f * _e4992);
let _e4994 = (_e4991 - _e4993);
let _e5003 = global_1.member.member_13.member_7;
let _e5004 = bitcast<i32>(_e5003);
let _e5007 = global_1.member.member_13.member_8;
let _e5008 = bitcast<i32>(_e5007);
let _e5011 = global_1.member.member_13.member_9;
let _e5012 = bitcast<i32>(_e5011);
let _e5013 = f32(_e5004);
let _e5015 = (_e3756.member - _e3750.member);
let _e5018 = (((((_e3047.x + (_e4908 * _e4994)) - _e3750.member) / _e5015) * _e5013) - 0.5f);
let _e5019 = (_e5013 - 1f);
let _e5021 = select(0f, _e5018, (_e5018 > 0f));
let _e5023 = select(_e5019, _e5021, (_e5021 < _e5019));
let _e5024 = f32(_e5008);
let _e5026 = (_e3756.member_1 - _e3750.member_1);
let _e5029 = (((((_e3047.y + (_e4910 * _e4994)) - _e3750.member_1) / _e5026) * _e5024) - 0.5f);
let _e5030 = (_e5024 - 1f);
let _e5032 = select(0f, _e5029, (_e5029 > 0f));
let _e5034 = select(_e5030, _e5032, (_e5032 < _e5030));
let _e5035 = f32(_e5012);
let _e5037 = (_e3756.member_2 - _e3750.member_2);
let _e5040 = (((((_e3047.z + (_e4912 * _e4994)) - _e3750.member_2) / _e5037) * _e5035) - 0.5f);
let _e5041 = (_e5035 - 1f);
let _e5043 = select(0f, _e5040, (_e5040 > 0f));
let _e5045 = select(_e5041, _e5043, (_e5043 < _e5041));
let _e5047 = select(0f, _e5023, (_e5023 > 0f));
let _e5049 = select(1e6f, _e5047, (_e5047 < 1e6f));
let _e5056 = select(0i, select(select(i32(_e5049), i32(-2147483648), (_e5049 < -2147483600f)), 2147483647i, (_e5049 > 2147483500f)), (_e5049 == _e5049));
let _e5060 = (_e5056 - select(0i, 1i, (_e5049 < f32(_e5056))));
let _e5062 = select(0f, _e5034, (_e5034 > 0f));
let _e5064 = select(1e6f, _e5062, (_e5062 < 1e6f));
let _e5071 = select(0i, select(select(i32(_e5064), i32(-2147483648), (_e5064 < -2147483600f)), 2147483647i, (_e5064 > 2147483500f)), (_e5064 == _e5064));
let _e5075 = (_e5071 - select(0i, 1i, (_e5064 < f32(_e5071))));
let _e5077 = select(0f, _e5045, (_e5045 > 0f));
let _e5079 = select(1e6f, _e5077, (_e5077 < 1e6f));
let _e5086 = select(0i, select(select(i32(_e5079), i32(-2147483648), (_e5079 < -2147483600f)), 2147483647i, (_e5079 > 2147483500f)), (_e5079 == _e5079));
let _e5090 = (_e5086 - select(0i, 1i, (_e5079 < f32(_e5086))));
let _e5094 = (_e5034 - f32(_e5075));
let _e5096 = (_e5045 - f32(_e5090));
local_17 = (_e5023 - f32(_e5060));
let _e5097 = (_e5060 + 1i);
let _e5099 = select(_e5097, 0i, (_e5097 < 0i));
if (_e5099 >= _e5004) {
phi_8445_ = (_e5004 - 1i);
} else {
phi_8445_ = _e5099;
}
let _e5103 = phi_8445_;
local_18 = (_e5103 - _e5060);
let _e5105 = (_e5075 + 1i);
let _e5107 = select(_e5105, 0i, (_e5105 < 0i));
if (_e5107 >= _e5008) {
phi_8458_ = (_e5008 - 1i);
} else {
phi_8458_ = _e5107;
}
let _e5111 = phi_8458_;
let _e5113 = ((_e5111 - _e5075) * _e5004);
let _e5114 = (_e5090 + 1i);
let _e5116 = select(_e5114, 0i, (_e5114 < 0i));
if (_e5116 >= _e5012) {
phi_8472_ = (_e5012 - 1i);
} else {
phi_8472_ = _e5116;
}
let _e5120 = phi_8472_;
let _e5126 = global_1.member.member_13.member_10;
let _e5127 = bitcast<i32>(_e5126);
let _e5132 = ((_e5127 + (((_e5090 * _e5008) + _e5075) * _e5004)) + _e5060);
let _e5134 = (bitcast<i32>(_e187) - 1i);
let _e5136 = select(_e5134, _e5132, (_e5132 < _e5134));
let _e5141 = global_7.member[bitcast<u32>(select(0i, _e5136, (_e5136 > 0i)))];
let _e5142 = local_17;
let _e5145 = local_18;
let _e5146 = (_e5132 + _e5145);
let _e5148 = select(_e5134, _e5146, (_e5146 < _e5134));
let _e5153 = global_7.member[bitcast<u32>(select(0i, _e5148, (_e5148 > 0i)))];
let _e5154 = local_17;
let _e5157 = (1f - _e5094);
let _e5159 = (_e5132 + _e5113);
let _e5161 = select(_e5134, _e5159, (_e5159 < _e5134));
let _e5166 = global_7.member[bitcast<u32>(select(0i, _e5161, (_e5161 > 0i)))];
let _e5167 = local_17;
let _e5170 = local_18;
let _e5171 = (_e5159 + _e5170);
let _e5173 = select(_e5134, _e5171, (_e5171 < _e5134));
let _e5178 = global_7.member[bitcast<u32>(select(0i, _e5173, (_e5173 > 0i)))];
let _e5179 = local_17;
let _e5184 = (_e5132 + (((_e5120 - _e5090) * _e5004) * _e5008));
let _e5186 = select(_e5134, _e5184, (_e5184 < _e5134));
let _e5191 = global_7.member[bitcast<u32>(select(0i, _e5186, (_e5186 > 0i)))];
let _e5192 = local_17;
let _e5195 = local_18;
let _e5196 = (_e5184 + _e5195);
let _e5198 = select(_e5134, _e5196, (_e5196 < _e5134));
let _e5203 = global_7.member[bitcast<u32>(select(0i, _e5198, (_e5198 > 0i)))];
let _e5204 = local_17;
let _e5208 = (_e5184 + _e5113);
let _e5210 = select(_e5134, _e5208, (_e5208 < _e5134));
let _e5215 = global_7.member[bitcast<u32>(select(0i, _e5210, (_e5210 > 0i)))];
let _e5216 = local_17;
let _e5219 = local_18;
let _e5220 = (_e5208 + _e5219);
let _e5222 = select(_e5134, _e5220, (_e5220 < _e5134));
let _e5227 = global_7.member[bitcast<u32>(select(0i, _e5222, (_e5222 > 0i)))];
let _e5228 = local_17;
let _e5237 = (_e4991 + _e4993);
let _e5247 = (((((_e3047.x + (_e4908 * _e5237)) - _e3750.member) / _e5015) * _e5013) - 0.5f);
let _e5249 = select(0f, _e5247, (_e5247 > 0f));
let _e5251 = select(_e5019, _e5249, (_e5249 < _e5019));
let _e5255 = (((((_e3047.y + (_e4910 * _e5237)) - _e3750.member_1) / _e5026) * _e5024) - 0.5f);
let _e5257 = select(0f, _e5255, (_e5255 > 0f));
let _e5259 = select(_e5030, _e5257, (_e5257 < _e5030));
let _e5263 = (((((_e3047.z + (_e4912 * _e5237)) - _e3750.member_2) / _e5037) * _e5035) - 0.5f);
let _e5265 = select(0f, _e5263, (_e5263 > 0f));
let _e5267 = select(_e5041, _e5265, (_e5265 < _e5041));
let _e5269 = select(0f, _e5251, (_e5251 > 0f));
let _e5271 = select(1e6f, _e5269, (_e5269 < 1e6f));
let _e5278 = select(0i, select(select(i32(_e5271), i32(-2147483648), (_e5271 < -2147483600f)), 2147483647i, (_e5271 > 2147483500f)), (_e5271 == _e5271));
let _e5282 = (_e5278 - select(0i, 1i, (_e5271 < f32(_e5278))));
let _e5284 = select(0f, _e5259, (_e5259 > 0f));
let _e5286 = select(1e6f, _e5284, (_e5284 < 1e6f));
let _e5293 = select(0i, select(select(i32(_e5286), i32(-2147483648), (_e5286 < -2147483600f)), 2147483647i, (_e5286 > 2147483500f)), (_e5286 == _e5286));
let _e5297 = (_e5293 - select(0i, 1i, (_e5286 < f32(_e5293))));
let _e5299 = select(0f, _e5267, (_e5267 > 0f));
let _e5301 = select(1e6f, _e5299, (_e5299 < 1e6f));
let _e5308 = select(0i, select(select(i32(_e5301), i32(-2147483648), (_e5301 < -2147483600f)), 2147483647i, (_e5301 > 2147483500f)), (_e5301 == _e5301));
let _e5312 = (_e5308 - select(0i, 1i, (_e5301 < f32(_e5308))));
let _e5316 = (_e5259 - f32(_e5297));
let _e5318 = (_e5267 - f32(_e5312));
local_15 = (_e5251 - f32(_e5282));
let _e5319 = (_e5282 + 1i);
let _e5321 = select(_e5319, 0i, (_e5319 < 0i));
if (_e5321 >= _e5004) {
phi_8791_ = (_e5004 - 1i);
} else {
phi_8791_ = _e5321;
}
let _e5325 = phi_8791_;
local_16 = (_e5325 - _e5282);
let _e5327 = (_e5297 + 1i);
let _e5329 = select(_e5327, 0i, (_e5327 < 0i));
if (_e5329 >= _e5008) {
phi_8804_ = (_e5008 - 1i);
} else {
phi_8804_ = _e5329;
}
let _e5333 = phi_8804_;
let _e5335 = ((_e5333 - _e5297) * _e5004);
let _e5336 = (_e5312 + 1i);
let _e5338 = select(_e5336, 0i, (_e5336 < 0i));
if (_e5338 >= _e5012) {
phi_8818_ = (_e5012 - 1i);
} else {
phi_8818_ = _e5338;
}
let _e5342 = phi_8818_;
let _e5350 = ((_e5127 + (((_e5312 * _e5008) + _e5297) * _e5004)) + _e5282);
let _e5352 = select(_e5134, _e5350, (_e5350 < _e5134));
let _e5357 = global_7.member[bitcast<u32>(select(0i, _e5352, (_e5352 > 0i)))];
let _e5358 = local_15;
let _e5361 = local_16;
let _e5362 = (_e5350 + _e5361);
let _e5364 = select(_e5134, _e5362, (_e5362 < _e5134));
let _e5369 = global_7.member[bitcast<u32>(select(0i, _e5364, (_e5364 > 0i)))];
let _e5370 = local_15;
let _e5373 = (1f - _e5316);
let _e5375 = (_e5350 + _e5335);
let _e5377 = select(_e5134, _e5375, (_e5375 < _e5134));
let _e5382 = global_7.member[bitcast<u32>(select(0i, _e5377, (_e5377 > 0i)))];
let _e5383 = local_15;
let _e5386 = local_16;
let _e5387 = (_e5375 + _e5386);
let _e5389 = select(_e5134, _e5387, (_e5387 < _e5134));
let _e5394 = global_7.member[bitcast<u32>(select(0i, _e5389, (_e5389 > 0i)))];
let _e5395 = local_15;
let _e5400 = (_e5350 + (((_e5342 - _e5312) * _e5004) * _e5008));
let _e5402 = select(_e5134, _e5400, (_e5400 < _e5134));
let _e5407 = global_7.member[bitcast<u32>(select(0i, _e5402, (_e5402 > 0i)))];
let _e5408 = local_15;
let _e5411 = local_16;
let _e5412 = (_e5400 + _e5411);
let _e5414 = select(_e5134, _e5412, (_e5412 < _e5134));
let _e5419 = global_7.member[bitcast<u32>(select(0i, _e5414, (_e5414 > 0i)))];
let _e5420 = local_15;
let _e5424 = (_e5400 + _e5335);
let _e5426 = select(_e5134, _e5424, (_e5424 < _e5134));
let _e5431 = global_7.member[bitcast<u32>(select(0i, _e5426, (_e5426 > 0i)))];
let _e5432 = local_15;
let _e5435 = local_16;
let _e5436 = (_e5424 + _e5435);
let _e5438 = select(_e5134, _e5436, (_e5436 < _e5134));
let _e5443 = global_7.member[bitcast<u32>(select(0i, _e5438, (_e5438 > 0i)))];
let _e5444 = local_15;
phi_8305_ = (_e4980 + 1u);
phi_8308_ = (_e4982 + ((0.5f * (((((((_e5141 * (1f - _e5142)) + (_e5153 * _e5154)) * _e5157) + (((_e5166 * (1f - _e5167)) + (_e5178 * _e5179)) * _e5094)) * (1f - _e5096)) + (((((_e5191 * (1f - _e5192)) + (_e5203 * _e5204)) * _e5157) + (((_e5215 * (1f - _e5216)) + (_e5227 * _e5228)) * _e5094)) * _e5096)) + ((((((_e5357 * (1f - _e5358)) + (_e5369 * _e5370)) * _e5373) + (((_e5382 * (1f - _e5383)) + (_e5394 * _e5395)) * _e5316)) * (1f - _e5318)) + (((((_e5407 * (1f - _e5408)) + (_e5419 * _e5420)) * _e5373) + (((_e5431 * (1f - _e5432)) + (_e5443 * _e5444)) * _e5316)) * _e5318)))) * _e4992));
} else {
phi_8305_ = u32();
phi_8308_ = f32();
}
let _e5459 = phi_8305_;
let _e5461 = phi_8308_;
continue;
continuing {
phi_8304_ = _e5459;
phi_8307_ = _e5461;
break if !(_e4985);
}
}
let _e11171 = local_78;
phi_9023_ = _e11171;
}
let _e5464 = phi_9023_;
let _e5465 = (_e5464 + select(_e3335, select(0f, _e4548, (_e4548 > 0f)), _e853));
let _e5467 = -((_e4291.member * _e5465));
let _e5469 = select(-87f, _e5467, (_e5467 > -87f));
let _e5471 = select(88f, _e5469, (_e5469 < 88f));
let _e5473 = ((_e5471 * 1.442695f) + 0.5f);
let _e5475 = select(-127f, _e5473, (_e5473 > -127f));
let _e5477 = select(128f, _e5475, (_e5475 < 128f));
let _e5484 = select(0i, select(select(i32(_e5477), i32(-2147483648), (_e5477 < -2147483600f)), 2147483647i, (_e5477 > 2147483500f)), (_e5477 == _e5477));
let _e5488 = (_e5484 - select(0i, 1i, (_e5477 < f32(_e5484))));
let _e5489 = f32(_e5488);
let _e5493 = ((_e5471 - (_e5489 * 0.6933594f)) - (_e5489 * -2.1219444e-4f));
let _e5515 = -((_e4291.member_1 * _e5465));
let _e5517 = select(-87f, _e5515, (_e5515 > -87f));
let _e5519 = select(88f, _e5517, (_e5517 < 88f));
let _e5521 = ((_e5519 * 1.442695f) + 0.5f);
let _e5523 = select(-127f, _e5521, (_e5521 > -127f));
let _e5525 = select(128f, _e5523, (_e5523 < 128f));
let _e5532 = select(0i, select(select(i32(_e5525), i32(-2147483648), (_e5525 < -2147483600f)), 2147483647i, (_e5525 > 2147483500f)), (_e5525 == _e5525));
let _e5536 = (_e5532 - select(0i, 1i, (_e5525 < f32(_e5532))));
let _e5537 = f32(_e5536);
let _e5541 = ((_e5519 - (_e5537 * 0.6933594f)) - (_e5537 * -2.1219444e-4f));
let _e5563 = -((_e4291.member_2 * _e5465));
let _e5565 = select(-87f, _e5563, (_e5563 > -87f));
let _e5567 = select(88f, _e5565, (_e5565 < 88f));
let _e5569 = ((_e5567 * 1.442695f) + 0.5f);
let _e5571 = select(-127f, _e5569, (_e5569 > -127f));
let _e5573 = select(128f, _e5571, (_e5571 < 128f));
let _e5580 = select(0i, select(select(i32(_e5573), i32(-2147483648), (_e5573 < -2147483600f)), 2147483647i, (_e5573 > 2147483500f)), (_e5573 == _e5573));
let _e5584 = (_e5580 - select(0i, 1i, (_e5573 < f32(_e5580))));
let _e5585 = f32(_e5584);
let _e5589 = ((_e5567 - (_e5585 * 0.6933594f)) - (_e5585 * -2.1219444e-4f));
let _e5615 = -((((_e4890.member.x * _e512) + (_e4890.member.y * _e523)) + (_e4890.member.z * _e534)));
let _e5617 = (_e4449 - (_e4450 * _e5615));
let _e5619 = select(1e-9f, _e5617, (_e5617 > 1e-9f));
if _e4469 {
let _e5630 = (0.5f - (0.5f * _e5615));
let _e5632 = select(0f, _e5630, (_e5630 > 0f));
let _e5636 = (sqrt(select(0f, _e5632, (_e5632 > 0f))) * 255f);
let _e5637 = (255f - 1f);
let _e5639 = select(0f, _e5636, (_e5636 > 0f));
let _e5641 = select(_e5637, _e5639, (_e5639 < _e5637));
let _e5648 = select(0i, select(select(i32(_e5641), i32(-2147483648), (_e5641 < -2147483600f)), 2147483647i, (_e5641 > 2147483500f)), (_e5641 == _e5641));
let _e5652 = (_e5648 - select(0i, 1i, (_e5641 < f32(_e5648))));
let _e5655 = global_1.member.member_13.member_11;
let _e5656 = bitcast<i32>(_e5655);
let _e5657 = (_e5656 + _e5652);
let _e5659 = (bitcast<i32>(_e187) - 1i);
let _e5661 = select(_e5659, _e5657, (_e5657 < _e5659));
let _e5666 = global_7.member[bitcast<u32>(select(0i, _e5661, (_e5661 > 0i)))];
let _e5668 = (_e5656 + (_e5652 + 1i));
let _e5670 = select(_e5659, _e5668, (_e5668 < _e5659));
let _e5675 = global_7.member[bitcast<u32>(select(0i, _e5670, (_e5670 > 0i)))];
phi_9384_ = (_e5666 + ((_e5675 - _e5666) * (_e5636 - f32(_e5652))));
} else {
phi_9384_ = select((_e4455 / (_e5619 * sqrt(select(0f, _e5619, (_e5619 > 0f))))), (0.75f * (1f + (_e5615 * _e5615))), _e4467);
}
let _e5682 = phi_9384_;
let _e5686 = ((3.1415927f * (_e5682 * _e4524)) * (select((_e1649 * ((2f * (1f + _e3025)) / (_e3028 * _e3028))), 1f, _e1650) * _e3297));
let _e5703 = (_e2488 - _e846);
if _e3350 {
let _e6038 = global_1.member.member_10.member_1;
phi_9957_ = type_26(vec3<f32>(_e6038.member, _e6038.member_1, _e6038.member_2), _e3346);
} else {
let _e5708 = (_e2497.x - _e3699.member);
let _e5710 = (_e2497.y - _e3699.member_1);
let _e5712 = (_e2497.z - _e3699.member_2);
let _e5717 = (((_e5708 * _e5708) + (_e5710 * _e5710)) + (_e5712 * _e5712));
let _e5719 = select(1e-12f, _e5717, (_e5717 > 1e-12f));
let _e5720 = (1f / _e5719);
let _e5724 = vec3<f32>((_e3342.member * _e5720), (_e3342.member_1 * _e5720), (_e3342.member_2 * _e5720));
if (_e3349 == 2u) {
let _e5728 = global_1.member.member_10.member_1;
let _e5736 = (((_e5728.member * _e5708) + (_e5728.member_1 * _e5710)) + (_e5728.member_2 * _e5712));
let _e5739 = (1f / select(1e-20f, _e5736, (_e5736 > 1e-20f)));
let _e5743 = global_1.member.member_10.member_4.member;
let _e5752 = ((((_e5743.member * _e5708) + (_e5743.member_1 * _e5710)) + (_e5743.member_2 * _e5712)) * _e5739);
let _e5756 = global_1.member.member_10.member_4.member_1;
let _e5765 = ((((_e5756.member * _e5708) + (_e5756.member_1 * _e5710)) + (_e5756.member_2 * _e5712)) * _e5739);
let _e5769 = global_1.member.member_10.member_4.member_2;
let _e5772 = ((_e5752 * _e5752) + (_e5765 * _e5765));
let _e5780 = global_1.member.member_10.member_4.member_3;
let _e5781 = ((_e5769 - sqrt(select(0f, _e5772, (_e5772 > 0f)))) * _e5780);
let _e5783 = select(0f, _e5781, (_e5781 > 0f));
let _e5785 = select(1f, _e5783, (_e5783 < 1f));
let _e5791 = select(0f, ((_e5785 * _e5785) * (3f - (2f * _e5785))), (_e5736 > 0f));
let _e5795 = global_1.member.member_10.member_4.member_5;
if ((_e5795 > 0u) && (_e5791 > 0f)) {
let _e5800 = (0.5f / _e5769);
let _e5809 = global_1.member.member_10.member_4.member_6;
let _e5810 = bitcast<i32>(_e5809);
local_14 = bitcast<i32>(_e5795);
let _e5811 = local_14;
let _e5813 = f32((_e5811 - 1i));
let _e5815 = f32((_e5810 - 1i));
let _e5816 = local_14;
let _e5819 = (((0.5f + (_e5752 * _e5800)) * f32(_e5816)) - 0.5f);
let _e5821 = select(0f, _e5819, (_e5819 > 0f));
let _e5823 = select(_e5813, _e5821, (_e5821 < _e5813));
let _e5826 = (((0.5f - (_e5765 * _e5800)) * f32(_e5810)) - 0.5f);
let _e5828 = select(0f, _e5826, (_e5826 > 0f));
let _e5830 = select(_e5815, _e5828, (_e5828 < _e5815));
let _e5832 = select(0f, _e5823, (_e5823 > 0f));
let _e5834 = select(_e5813, _e5832, (_e5832 < _e5813));
let _e5841 = select(0i, select(select(i32(_e5834), i32(-2147483648), (_e5834 < -2147483600f)), 2147483647i, (_e5834 > 2147483500f)), (_e5834 == _e5834));
let _e5845 = (_e5841 - select(0i, 1i, (_e5834 < f32(_e5841))));
let _e5847 = select(0f, _e5830, (_e5830 > 0f));
let _e5849 = select(_e5815, _e5847, (_e5847 < _e5815));
let _e5856 = select(0i, select(select(i32(_e5849), i32(-2147483648), (_e5849 < -2147483600f)), 2147483647i, (_e5849 > 2147483500f)), (_e5849 == _e5849));
let _e5860 = (_e5856 - select(0i, 1i, (_e5849 < f32(_e5856))));
let _e5862 = (_e5823 - f32(_e5845));
let _e5864 = (_e5830 - f32(_e5860));
let _e5865 = (_e5845 + 1i);
let _e5866 = local_14;
let _e5868 = select(_e5845, _e5865, (_e5865 < _e5866));
let _e5869 = (_e5860 + 1i);
let _e5871 = select(_e5860, _e5869, (_e5869 < _e5810));
let _e5875 = global_1.member.member_10.member_4.member_4;
let _e5876 = bitcast<i32>(_e5875);
let _e5877 = local_14;
let _e5881 = (_e5876 + (3i * ((_e5860 * _e5877) + _e5845)));
let _e5883 = (bitcast<i32>(_e180) - 1i);
let _e5885 = select(_e5883, _e5881, (_e5881 < _e5883));
let _e5890 = global_3.member[bitcast<u32>(select(0i, _e5885, (_e5885 > 0i)))];
let _e5891 = (_e5881 + 1i);
let _e5893 = select(_e5883, _e5891, (_e5891 < _e5883));
let _e5898 = global_3.member[bitcast<u32>(select(0i, _e5893, (_e5893 > 0i)))];
let _e5899 = (_e5881 + 2i);
let _e5901 = select(_e5883, _e5899, (_e5899 < _e5883));
let _e5906 = global_3.member[bitcast<u32>(select(0i, _e5901, (_e5901 > 0i)))];
let _e5907 = local_14;
let _e5911 = (_e5876 + (3i * ((_e5860 * _e5907) + _e5868)));
let _e5913 = select(_e5883, _e5911, (_e5911 < _e5883));
let _e5918 = global_3.member[bitcast<u32>(select(0i, _e5913, (_e5913 > 0i)))];
let _e5919 = (_e5911 + 1i);
let _e5921 = select(_e5883, _e5919, (_e5919 < _e5883));
let _e5926 = global_3.member[bitcast<u32>(select(0i, _e5921, (_e5921 > 0i)))];
let _e5927 = (_e5911 + 2i);
let _e5929 = select(_e5883, _e5927, (_e5927 < _e5883));
let _e5934 = global_3.member[bitcast<u32>(select(0i, _e5929, (_e5929 > 0i)))];
let _e5935 = local_14;
let _e5939 = (_e5876 + (3i * ((_e5871 * _e5935) + _e5845)));
let _e5941 = select(_e5883, _e5939, (_e5939 < _e5883));
let _e5946 = global_3.member[bitcast<u32>(select(0i, _e5941, (_e5941 > 0i)))];
let _e5947 = (_e5939 + 1i);
let _e5949 = select(_e5883, _e5947, (_e5947 < _e5883));
let _e5954 = global_3.member[bitcast<u32>(select(0i, _e5949, (_e5949 > 0i)))];
let _e5955 = (_e5939 + 2i);
let _e5957 = select(_e5883, _e5955, (_e5955 < _e5883));
let _e5962 = global_3.member[bitcast<u32>(select(0i, _e5957, (_e5957 > 0i)))];
let _e5963 = local_14;
let _e5967 = (_e5876 + (3i * ((_e5871 * _e5963) + _e5868)));
let _e5969 = select(_e5883, _e5967, (_e5967 < _e5883));
let _e5974 = global_3.member[bitcast<u32>(select(0i, _e5969, (_e5969 > 0i)))];
let _e5975 = (_e5967 + 1i);
let _e5977 = select(_e5883, _e5975, (_e5975 < _e5883));
let _e5982 = global_3.member[bitcast<u32>(select(0i, _e5977, (_e5977 > 0i)))];
let _e5983 = (_e5967 + 2i);
let _e5985 = select(_e5883, _e5983, (_e5983 < _e5883));
let _e5990 = global_3.member[bitcast<u32>(select(0i, _e5985, (_e5985 > 0i)))];
let _e5997 = (_e5890 + ((_e5918 - _e5890) * _e5862));
let _e5998 = (_e5898 + ((_e5926 - _e5898) * _e5862));
let _e5999 = (_e5906 + ((_e5934 - _e5906) * _e5862));
phi_9941_ = vec3<f32>(((_e5997 + (((_e5946 + ((_e5974 - _e5946) * _e5862)) - _e5997) * _e5864)) * _e5791), ((_e5998 + (((_e5954 + ((_e5982 - _e5954) * _e5862)) - _e5998) * _e5864)) * _e5791), ((_e5999 + (((_e5962 + ((_e5990 - _e5962) * _e5862)) - _e5999) * _e5864)) * _e5791));
} else {
phi_9941_ = vec3(_e5791);
}
let _e6023 = phi_9941_;
phi_9944_ = (_e5724 * _e6023);
} else {
phi_9944_ = _e5724;
}
let _e6026 = phi_9944_;
let _e6030 = (1f / sqrt(select(0f, _e5719, (_e5719 > 0f))));
phi_9957_ = type_26(vec3<f32>((_e5708 * _e6030), (_e5710 * _e6030), (_e5712 * _e6030)), _e6026);
}
let _e6045 = phi_9957_;
let _e6048 = (_e3699.member - _e2497.x);
let _e6050 = (_e3699.member_1 - _e2497.y);
let _e6052 = (_e3699.member_2 - _e2497.z);
let _e6057 = (((_e6048 * _e6048) + (_e6050 * _e6050)) + (_e6052 * _e6052));
let _e6061 = select(sqrt(select(0f, _e6057, (_e6057 > 0f))), 1e30f, _e3350);
let _e6063 = -(_e6045.member.x);
let _e6065 = -(_e6045.member.y);
let _e6067 = -(_e6045.member.z);
let _e6075 = (1f / select(_e6063, select(1e-12f, -1e-12f, (_e6063 < 0f)), (bitcast<f32>((bitcast<u32>(_e6063) & 2147483647u)) < 1e-12f)));
let _e6083 = (1f / select(_e6065, select(1e-12f, -1e-12f, (_e6065 < 0f)), (bitcast<f32>((bitcast<u32>(_e6065) & 2147483647u)) < 1e-12f)));
let _e6091 = (1f / select(_e6067, select(1e-12f, -1e-12f, (_e6067 < 0f)), (bitcast<f32>((bitcast<u32>(_e6067) & 2147483647u)) < 1e-12f)));
let _e6093 = ((_e3750.member - _e2497.x) * _e6075);
let _e6095 = ((_e3756.member - _e2497.x) * _e6075);
let _e6097 = ((_e3750.member_1 - _e2497.y) * _e6083);
let _e6099 = ((_e3756.member_1 - _e2497.y) * _e6083);
let _e6101 = ((_e3750.member_2 - _e2497.z) * _e6091);
let _e6103 = ((_e3756.member_2 - _e2497.z) * _e6091);
let _e6105 = select(_e6095, _e6093, (_e6093 < _e6095));
let _e6107 = select(_e6099, _e6097, (_e6097 < _e6099));
let _e6109 = select(_e6107, _e6105, (_e6105 > _e6107));
let _e6111 = select(_e6103, _e6101, (_e6101 < _e6103));
let _e6113 = select(_e6111, _e6109, (_e6109 > _e6111));
let _e6115 = select(_e6095, _e6093, (_e6093 > _e6095));
let _e6117 = select(_e6099, _e6097, (_e6097 > _e6099));
let _e6119 = select(_e6117, _e6115, (_e6115 < _e6117));
let _e6121 = select(_e6103, _e6101, (_e6101 > _e6103));
let _e6123 = select(_e6121, _e6119, (_e6119 < _e6121));
let _e6125 = select(0f, _e6113, (_e6113 > 0f));
let _e6127 = select(_e6061, _e6123, (_e6123 < _e6061));
let _e6128 = (_e6127 > _e6125);
let _e6129 = select(0f, _e6125, _e6128);
let _e6131 = (select(0f, _e6127, _e6128) - _e6129);
if _e2221 {
phi_10872_ = _e6131;
} else {
let _e6133 = (_e6131 / f32(_e2220));
phi_10153_ = 0u;
phi_10156_ = 0f;
loop {
let _e6135 = phi_10153_;
let _e6137 = phi_10156_;
local_79 = _e6137;
let _e6140 = ((_e6135 < _e2220) && (_e6131 > 0f));
if _e6140 {
let _e6143 = (_e6129 + (_e6133 * f32(_e6135)));
let _e6144 = (_e6143 + _e6133);
let _e6146 = (0.5f * (_e6143 + _e6144));
let _e6147 = (_e6144 - _e6143);
let _e6148 = (0.28867513f * _e6147);
let _e6149 = (_e6146 - _e6148);
let _e6158 = global_1.member.member_13.member_7;
let _e6159 = bitcast<i32>(_e6158);
let _e6162 = global_1.member.member_13.member_8;
let _e6163 = bitcast<i32>(_e6162);
let _e6166 = global_1.member.member_13.member_9;
let _e6167 = bitcast<i32>(_e6166);
let _e6168 = f32(_e6159);
let _e6170 = (_e3756.member - _e3750.member);
let _e6173 = (((((_e2497.x + (_e6063 * _e6149)) - _e3750.member) / _e6170) * _e6168) - 0.5f);
let _e6174 = (_e6168 - 1f);
let _e6176 = select(0f, _e6173, (_e6173 > 0f));
let _e6178 = select(_e6174, _e6176, (_e6176 < _e6174));
let _e6179 = f32(_e6163);
let _e6181 = (_e3756.member_1 - _e3750.member_1);
let _e6184 = (((((_e2497.y + (_e6065 * _e6149)) - _e3750.member_1) / _e6181) * _e6179) - 0.5f);
let _e6185 = (_e6179 - 1f);
let _e6187 = select(0f, _e6184, (_e6184 > 0f));
let _e6189 = select(_e6185, _e6187, (_e6187 < _e6185));
let _e6190 = f32(_e6167);
let _e6192 = (_e3756.member_2 - _e3750.member_2);
let _e6195 = (((((_e2497.z + (_e6067 * _e6149)) - _e3750.member_2) / _e6192) * _e6190) - 0.5f);
let _e6196 = (_e6190 - 1f);
let _e6198 = select(0f, _e6195, (_e6195 > 0f));
let _e6200 = select(_e6196, _e6198, (_e6198 < _e6196));
let _e6202 = select(0f, _e6178, (_e6178 > 0f));
let _e6204 = select(1e6f, _e6202, (_e6202 < 1e6f));
let _e6211 = select(0i, select(select(i32(_e6204), i32(-2147483648), (_e6204 < -2147483600f)), 2147483647i, (_e6204 > 2147483500f)), (_e6204 == _e6204));
let _e6215 = (_e6211 - select(0i, 1i, (_e6204 < f32(_e6211))));
let _e6217 = select(0f, _e6189, (_e6189 > 0f));
let _e6219 = select(1e6f, _e6217, (_e6217 < 1e6f));
let _e6226 = select(0i, select(select(i32(_e6219), i32(-2147483648), (_e6219 < -2147483600f)), 2147483647i, (_e6219 > 2147483500f)), (_e6219 == _e6219));
let _e6230 = (_e6226 - select(0i, 1i, (_e6219 < f32(_e6226))));
let _e6232 = select(0f, _e6200, (_e6200 > 0f));
let _e6234 = select(1e6f, _e6232, (_e6232 < 1e6f));
let _e6241 = select(0i, select(select(i32(_e6234), i32(-2147483648), (_e6234 < -2147483600f)), 2147483647i, (_e6234 > 2147483500f)), (_e6234 == _e6234));
let _e6245 = (_e6241 - select(0i, 1i, (_e6234 < f32(_e6241))));
let _e6249 = (_e6189 - f32(_e6230));
let _e6251 = (_e6200 - f32(_e6245));
local_12 = (_e6178 - f32(_e6215));
let _e6252 = (_e6215 + 1i);
let _e6254 = select(_e6252, 0i, (_e6252 < 0i));
if (_e6254 >= _e6159) {
phi_10294_ = (_e6159 - 1i);
} else {
phi_10294_ = _e6254;
}
let _e6258 = phi_10294_;
local_13 = (_e6258 - _e6215);
let _e6260 = (_e6230 + 1i);
let _e6262 = select(_e6260, 0i, (_e6260 < 0i));
if (_e6262 >= _e6163) {
phi_10307_ = (_e6163 - 1i);
} else {
phi_10307_ = _e6262;
}
let _e6266 = phi_10307_;
let _e6268 = ((_e6266 - _e6230) * _e6159);
let _e6269 = (_e6245 + 1i);
let _e6271 = select(_e6269, 0i, (_e6269 < 0i));
if (_e6271 >= _e6167) {
phi_10321_ = (_e6167 - 1i);
} else {
phi_10321_ = _e6271;
}
let _e6275 = phi_10321_;
let _e6281 = global_1.member.member_13.member_10;
let _e6282 = bitcast<i32>(_e6281);
let _e6287 = ((_e6282 + (((_e6245 * _e6163) + _e6230) * _e6159)) + _e6215);
let _e6289 = (bitcast<i32>(_e187) - 1i);
let _e6291 = select(_e6289, _e6287, (_e6287 < _e6289));
let _e6296 = global_7.member[bitcast<u32>(select(0i, _e6291, (_e6291 > 0i)))];
let _e6297 = local_12;
let _e6300 = local_13;
let _e6301 = (_e6287 + _e6300);
let _e6303 = select(_e6289, _e6301, (_e6301 < _e6289));
let _e6308 = global_7.member[bitcast<u32>(select(0i, _e6303, (_e6303 > 0i)))];
let _e6309 = local_12;
let _e6312 = (1f - _e6249);
let _e6314 = (_e6287 + _e6268);
let _e6316 = select(_e6289, _e6314, (_e6314 < _e6289));
let _e6321 = global_7.member[bitcast<u32>(select(0i, _e6316, (_e6316 > 0i)))];
let _e6322 = local_12;
let _e6325 = local_13;
let _e6326 = (_e6314 + _e6325);
let _e6328 = select(_e6289, _e6326, (_e6326 < _e6289));
let _e6333 = global_7.member[bitcast<u32>(select(0i, _e6328, (_e6328 > 0i)))];
let _e6334 = local_12;
let _e6339 = (_e6287 + (((_e6275 - _e6245) * _e6159) * _e6163));
let _e6341 = select(_e6289, _e6339, (_e6339 < _e6289));
let _e6346 = global_7.member[bitcast<u32>(select(0i, _e6341, (_e6341 > 0i)))];
let _e6347 = local_12;
let _e6350 = local_13;
let _e6351 = (_e6339 + _e6350);
let _e6353 = select(_e6289, _e6351, (_e6351 < _e6289));
let _e6358 = global_7.member[bitcast<u32>(select(0i, _e6353, (_e6353 > 0i)))];
let _e6359 = local_12;
let _e6363 = (_e6339 + _e6268);
let _e6365 = select(_e6289, _e6363, (_e6363 < _e6289));
let _e6370 = global_7.member[bitcast<u32>(select(0i, _e6365, (_e6365 > 0i)))];
let _e6371 = local_12;
let _e6374 = local_13;
let _e6375 = (_e6363 + _e6374);
let _e6377 = select(_e6289, _e6375, (_e6375 < _e6289));
let _e6382 = global_7.member[bitcast<u32>(select(0i, _e6377, (_e6377 > 0i)))];
let _e6383 = local_12;
let _e6392 = (_e6146 + _e6148);
let _e6402 = (((((_e2497.x + (_e6063 * _e6392)) - _e3750.member) / _e6170) * _e6168) - 0.5f);
let _e6404 = select(0f, _e6402, (_e6402 > 0f));
let _e6406 = select(_e6174, _e6404, (_e6404 < _e6174));
let _e6410 = (((((_e2497.y + (_e6065 * _e6392)) - _e3750.member_1) / _e6181) * _e6179) - 0.5f);
let _e6412 = select(0f, _e6410, (_e6410 > 0f));
let _e6414 = select(_e6185, _e6412, (_e6412 < _e6185));
let _e6418 = (((((_e2497.z + (_e6067 * _e6392)) - _e3750.member_2) / _e6192) * _e6190) - 0.5f);
let _e6420 = select(0f, _e6418, (_e6418 > 0f));
let _e6422 = select(_e6196, _e6420, (_e6420 < _e6196));
let _e6424 = select(0f, _e6406, (_e6406 > 0f));
let _e6426 = select(1e6f, _e6424, (_e6424 < 1e6f));
let _e6433 = select(0i, select(select(i32(_e6426), i32(-2147483648), (_e6426 < -2147483600f)), 2147483647i, (_e6426 > 2147483500f)), (_e6426 == _e6426));
let _e6437 = (_e6433 - select(0i, 1i, (_e6426 < f32(_e6433))));
let _e6439 = select(0f, _e6414, (_e6414 > 0f));
let _e6441 = select(1e6f, _e6439, (_e6439 < 1e6f));
let _e6448 = select(0i, select(select(i32(_e6441), i32(-2147483648), (_e6441 < -2147483600f)), 2147483647i, (_e6441 > 2147483500f)), (_e6441 == _e6441));
let _e6452 = (_e6448 - select(0i, 1i, (_e6441 < f32(_e6448))));
let _e6454 = select(0f, _e6422, (_e6422 > 0f));
let _e6456 = select(1e6f, _e6454, (_e6454 < 1e6f));
let _e6463 = select(0i, select(select(i32(_e6456), i32(-2147483648), (_e6456 < -2147483600f)), 2147483647i, (_e6456 > 2147483500f)), (_e6456 == _e6456));
let _e6467 = (_e6463 - select(0i, 1i, (_e6456 < f32(_e6463))));
let _e6471 = (_e6414 - f32(_e6452));
let _e6473 = (_e6422 - f32(_e6467));
local_10 = (_e6406 - f32(_e6437));
let _e6474 = (_e6437 + 1i);
let _e6476 = select(_e6474, 0i, (_e6474 < 0i));
if (_e6476 >= _e6159) {
phi_10640_ = (_e6159 - 1i);
} else {
phi_10640_ = _e6476;
}
let _e6480 = phi_10640_;
local_11 = (_e6480 - _e6437);
let _e6482 = (_e6452 + 1i);
let _e6484 = select(_e6482, 0i, (_e6482 < 0i));
if (_e6484 >= _e6163) {
phi_10653_ = (_e6163 - 1i);
} else {
phi_10653_ = _e6484;
}
let _e6488 = phi_10653_;
let _e6490 = ((_e6488 - _e6452) * _e6159);
let _e6491 = (_e6467 + 1i);
let _e6493 = select(_e6491, 0i, (_e6491 < 0i));
if (_e6493 >= _e6167) {
phi_10667_ = (_e6167 - 1i);
} else {
phi_10667_ = _e6493;
}
let _e6497 = phi_10667_;
let _e6505 = ((_e6282 + (((_e6467 * _e6163) + _e6452) * _e6159)) + _e6437);
let _e6507 = select(_e6289, _e6505, (_e6505 < _e6289));
let _e6512 = global_7.member[bitcast<u32>(select(0i, _e6507, (_e6507 > 0i)))];
let _e6513 = local_10;
let _e6516 = local_11;
let _e6517 = (_e6505 + _e6516);
let _e6519 = select(_e6289, _e6517, (_e6517 < _e6289));
let _e6524 = global_7.member[bitcast<u32>(select(0i, _e6519, (_e6519 > 0i)))];
let _e6525 = local_10;
let _e6528 = (1f - _e6471);
let _e6530 = (_e6505 + _e6490);
let _e6532 = select(_e6289, _e6530, (_e6530 < _e6289));
let _e6537 = global_7.member[bitcast<u32>(select(0i, _e6532, (_e6532 > 0i)))];
let _e6538 = local_10;
let _e6541 = local_11;
let _e6542 = (_e6530 + _e6541);
let _e6544 = select(_e6289, _e6542, (_e6542 < _e6289));
let _e6549 = global_7.member[bitcast<u32>(select(0i, _e6544, (_e6544 > 0i)))];
let _e6550 = local_10;
let _e6555 = (_e6505 + (((_e6497 - _e6467) * _e6159) * _e6163));
let _e6557 = select(_e6289, _e6555, (_e6555 < _e6289));
let _e6562 = global_7.member[bitcast<u32>(select(0i, _e6557, (_e6557 > 0i)))];
let _e6563 = local_10;
let _e6566 = local_11;
let _e6567 = (_e6555 + _e6566);
let _e6569 = select(_e6289, _e6567, (_e6567 < _e6289));
let _e6574 = global_7.member[bitcast<u32>(select(0i, _e6569, (_e6569 > 0i)))];
let _e6575 = local_10;
let _e6579 = (_e6555 + _e6490);
let _e6581 = select(_e6289, _e6579, (_e6579 < _e6289));
let _e6586 = global_7.member[bitcast<u32>(select(0i, _e6581, (_e6581 > 0i)))];
let _e6587 = local_10;
let _e6590 = local_11;
let _e6591 = (_e6579 + _e6590);
let _e6593 = select(_e6289, _e6591, (_e6591 < _e6289));
let _e6598 = global_7.member[bitcast<u32>(select(0i, _e6593, (_e6593 > 0i)))];
let _e6599 = local_10;
phi_10154_ = (_e6135 + 1u);
phi_10157_ = (_e6137 + ((0.5f * (((((((_e6296 * (1f - _e6297)) + (_e6308 * _e6309)) * _e6312) + (((_e6321 * (1f - _e6322)) + (_e6333 * _e6334)) * _e6249)) * (1f - _e6251)) + (((((_e6346 * (1f - _e6347)) + (_e6358 * _e6359)) * _e6312) + (((_e6370 * (1f - _e6371)) + (_e6382 * _e6383)) * _e6249)) * _e6251)) + ((((((_e6512 * (1f - _e6513)) + (_e6524 * _e6525)) * _e6528) + (((_e6537 * (1f - _e6538)) + (_e6549 * _e6550)) * _e6471)) * (1f - _e6473)) + (((((_e6562 * (1f - _e6563)) + (_e6574 * _e6575)) * _e6528) + (((_e6586 * (1f - _e6587)) + (_e6598 * _e6599)) * _e6471)) * _e6473)))) * _e6147));
} else {
phi_10154_ = u32();
phi_10157_ = f32();
}
let _e6614 = phi_10154_;
let _e6616 = phi_10157_;
continue;
continuing {
phi_10153_ = _e6614;
phi_10156_ = _e6616;
break if !(_e6140);
}
}
let _e11188 = local_79;
phi_10872_ = _e11188;
}
let _e6619 = phi_10872_;
let _e6620 = (_e6619 + select(_e3325, select(0f, _e5703, (_e5703 > 0f)), _e853));
let _e6622 = -((_e4291.member * _e6620));
let _e6624 = select(-87f, _e6622, (_e6622 > -87f));
let _e6626 = select(88f, _e6624, (_e6624 < 88f));
let _e6628 = ((_e6626 * 1.442695f) + 0.5f);
let _e6630 = select(-127f, _e6628, (_e6628 > -127f));
let _e6632 = select(128f, _e6630, (_e6630 < 128f));
let _e6639 = select(0i, select(select(i32(_e6632), i32(-2147483648), (_e6632 < -2147483600f)), 2147483647i, (_e6632 > 2147483500f)), (_e6632 == _e6632));
let _e6643 = (_e6639 - select(0i, 1i, (_e6632 < f32(_e6639))));
let _e6644 = f32(_e6643);
let _e6648 = ((_e6626 - (_e6644 * 0.6933594f)) - (_e6644 * -2.1219444e-4f));
let _e6670 = -((_e4291.member_1 * _e6620));
let _e6672 = select(-87f, _e6670, (_e6670 > -87f));
let _e6674 = select(88f, _e6672, (_e6672 < 88f));
let _e6676 = ((_e6674 * 1.442695f) + 0.5f);
let _e6678 = select(-127f, _e6676, (_e6676 > -127f));
let _e6680 = select(128f, _e6678, (_e6678 < 128f));
let _e6687 = select(0i, select(select(i32(_e6680), i32(-2147483648), (_e6680 < -2147483600f)), 2147483647i, (_e6680 > 2147483500f)), (_e6680 == _e6680));
let _e6691 = (_e6687 - select(0i, 1i, (_e6680 < f32(_e6687))));
let _e6692 = f32(_e6691);
let _e6696 = ((_e6674 - (_e6692 * 0.6933594f)) - (_e6692 * -2.1219444e-4f));
let _e6718 = -((_e4291.member_2 * _e6620));
let _e6720 = select(-87f, _e6718, (_e6718 > -87f));
let _e6722 = select(88f, _e6720, (_e6720 < 88f));
let _e6724 = ((_e6722 * 1.442695f) + 0.5f);
let _e6726 = select(-127f, _e6724, (_e6724 > -127f));
let _e6728 = select(128f, _e6726, (_e6726 < 128f));
let _e6735 = select(0i, select(select(i32(_e6728), i32(-2147483648), (_e6728 < -2147483600f)), 2147483647i, (_e6728 > 2147483500f)), (_e6728 == _e6728));
let _e6739 = (_e6735 - select(0i, 1i, (_e6728 < f32(_e6735))));
let _e6740 = f32(_e6739);
let _e6744 = ((_e6722 - (_e6740 * 0.6933594f)) - (_e6740 * -2.1219444e-4f));
let _e6770 = -((((_e6045.member.x * _e512) + (_e6045.member.y * _e523)) + (_e6045.member.z * _e534)));
let _e6772 = (_e4449 - (_e4450 * _e6770));
let _e6774 = select(1e-9f, _e6772, (_e6772 > 1e-9f));
if _e4469 {
let _e6785 = (0.5f - (0.5f * _e6770));
let _e6787 = select(0f, _e6785, (_e6785 > 0f));
let _e6791 = (sqrt(select(0f, _e6787, (_e6787 > 0f))) * 255f);
let _e6792 = (255f - 1f);
let _e6794 = select(0f, _e6791, (_e6791 > 0f));
let _e6796 = select(_e6792, _e6794, (_e6794 < _e6792));
let _e6803 = select(0i, select(select(i32(_e6796), i32(-2147483648), (_e6796 < -2147483600f)), 2147483647i, (_e6796 > 2147483500f)), (_e6796 == _e6796));
let _e6807 = (_e6803 - select(0i, 1i, (_e6796 < f32(_e6803))));
let _e6810 = global_1.member.member_13.member_11;
let _e6811 = bitcast<i32>(_e6810);
let _e6812 = (_e6811 + _e6807);
let _e6814 = (bitcast<i32>(_e187) - 1i);
let _e6816 = select(_e6814, _e6812, (_e6812 < _e6814));
let _e6821 = global_7.member[bitcast<u32>(select(0i, _e6816, (_e6816 > 0i)))];
let _e6823 = (_e6811 + (_e6807 + 1i));
let _e6825 = select(_e6814, _e6823, (_e6823 < _e6814));
let _e6830 = global_7.member[bitcast<u32>(select(0i, _e6825, (_e6825 > 0i)))];
phi_11233_ = (_e6821 + ((_e6830 - _e6821) * (_e6791 - f32(_e6807))));
} else {
phi_11233_ = select((_e4455 / (_e6774 * sqrt(select(0f, _e6774, (_e6774 > 0f))))), (0.75f * (1f + (_e6770 * _e6770))), _e4467);
}
let _e6837 = phi_11233_;
let _e6841 = ((3.1415927f * (_e6837 * _e4524)) * (select((_e1649 * ((2f * (1f + _e2475)) / (_e2478 * _e2478))), 1f, _e1650) * _e2747));
let _e6855 = (_e2763 - _e846);
if _e3350 {
let _e7190 = global_1.member.member_10.member_1;
phi_11803_ = type_26(vec3<f32>(_e7190.member, _e7190.member_1, _e7190.member_2), _e3346);
} else {
let _e6860 = (_e2772.x - _e3699.member);
let _e6862 = (_e2772.y - _e3699.member_1);
let _e6864 = (_e2772.z - _e3699.member_2);
let _e6869 = (((_e6860 * _e6860) + (_e6862 * _e6862)) + (_e6864 * _e6864));
let _e6871 = select(1e-12f, _e6869, (_e6869 > 1e-12f));
let _e6872 = (1f / _e6871);
let _e6876 = vec3<f32>((_e3342.member * _e6872), (_e3342.member_1 * _e6872), (_e3342.member_2 * _e6872));
if (_e3349 == 2u) {
let _e6880 = global_1.member.member_10.member_1;
let _e6888 = (((_e6880.member * _e6860) + (_e6880.member_1 * _e6862)) + (_e6880.member_2 * _e6864));
let _e6891 = (1f / select(1e-20f, _e6888, (_e6888 > 1e-20f)));
let _e6895 = global_1.member.member_10.member_4.member;
let _e6904 = ((((_e6895.member * _e6860) + (_e6895.member_1 * _e6862)) + (_e6895.member_2 * _e6864)) * _e6891);
let _e6908 = global_1.member.member_10.member_4.member_1;
let _e6917 = ((((_e6908.member * _e6860) + (_e6908.member_1 * _e6862)) + (_e6908.member_2 * _e6864)) * _e6891);
let _e6921 = global_1.member.member_10.member_4.member_2;
let _e6924 = ((_e6904 * _e6904) + (_e6917 * _e6917));
let _e6932 = global_1.member.member_10.member_4.member_3;
let _e6933 = ((_e6921 - sqrt(select(0f, _e6924, (_e6924 > 0f)))) * _e6932);
let _e6935 = select(0f, _e6933, (_e6933 > 0f));
let _e6937 = select(1f, _e6935, (_e6935 < 1f));
let _e6943 = select(0f, ((_e6937 * _e6937) * (3f - (2f * _e6937))), (_e6888 > 0f));
let _e6947 = global_1.member.member_10.member_4.member_5;
if ((_e6947 > 0u) && (_e6943 > 0f)) {
let _e6952 = (0.5f / _e6921);
let _e6961 = global_1.member.member_10.member_4.member_6;
let _e6962 = bitcast<i32>(_e6961);
local_9 = bitcast<i32>(_e6947);
let _e6963 = local_9;
let _e6965 = f32((_e6963 - 1i));
let _e6967 = f32((_e6962 - 1i));
let _e6968 = local_9;
let _e6971 = (((0.5f + (_e6904 * _e6952)) * f32(_e6968)) - 0.5f);
let _e6973 = select(0f, _e6971, (_e6971 > 0f));
let _e6975 = select(_e6965, _e6973, (_e6973 < _e6965));
let _e6978 = (((0.5f - (_e6917 * _e6952)) * f32(_e6962)) - 0.5f);
let _e6980 = select(0f, _e6978, (_e6978 > 0f));
let _e6982 = select(_e6967, _e6980, (_e6980 < _e6967));
let _e6984 = select(0f, _e6975, (_e6975 > 0f));
let _e6986 = select(_e6965, _e6984, (_e6984 < _e6965));
let _e6993 = select(0i, select(select(i32(_e6986), i32(-2147483648), (_e6986 < -2147483600f)), 2147483647i, (_e6986 > 2147483500f)), (_e6986 == _e6986));
let _e6997 = (_e6993 - select(0i, 1i, (_e6986 < f32(_e6993))));
let _e6999 = select(0f, _e6982, (_e6982 > 0f));
let _e7001 = select(_e6967, _e6999, (_e6999 < _e6967));
let _e7008 = select(0i, select(select(i32(_e7001), i32(-2147483648), (_e7001 < -2147483600f)), 2147483647i, (_e7001 > 2147483500f)), (_e7001 == _e7001));
let _e7012 = (_e7008 - select(0i, 1i, (_e7001 < f32(_e7008))));
let _e7014 = (_e6975 - f32(_e6997));
let _e7016 = (_e6982 - f32(_e7012));
let _e7017 = (_e6997 + 1i);
let _e7018 = local_9;
let _e7020 = select(_e6997, _e7017, (_e7017 < _e7018));
let _e7021 = (_e7012 + 1i);
let _e7023 = select(_e7012, _e7021, (_e7021 < _e6962));
let _e7027 = global_1.member.member_10.member_4.member_4;
let _e7028 = bitcast<i32>(_e7027);
let _e7029 = local_9;
let _e7033 = (_e7028 + (3i * ((_e7012 * _e7029) + _e6997)));
let _e7035 = (bitcast<i32>(_e180) - 1i);
let _e7037 = select(_e7035, _e7033, (_e7033 < _e7035));
let _e7042 = global_3.member[bitcast<u32>(select(0i, _e7037, (_e7037 > 0i)))];
let _e7043 = (_e7033 + 1i);
let _e7045 = select(_e7035, _e7043, (_e7043 < _e7035));
let _e7050 = global_3.member[bitcast<u32>(select(0i, _e7045, (_e7045 > 0i)))];
let _e7051 = (_e7033 + 2i);
let _e7053 = select(_e7035, _e7051, (_e7051 < _e7035));
let _e7058 = global_3.member[bitcast<u32>(select(0i, _e7053, (_e7053 > 0i)))];
let _e7059 = local_9;
let _e7063 = (_e7028 + (3i * ((_e7012 * _e7059) + _e7020)));
let _e7065 = select(_e7035, _e7063, (_e7063 < _e7035));
let _e7070 = global_3.member[bitcast<u32>(select(0i, _e7065, (_e7065 > 0i)))];
let _e7071 = (_e7063 + 1i);
let _e7073 = select(_e7035, _e7071, (_e7071 < _e7035));
let _e7078 = global_3.member[bitcast<u32>(select(0i, _e7073, (_e7073 > 0i)))];
let _e7079 = (_e7063 + 2i);
let _e7081 = select(_e7035, _e7079, (_e7079 < _e7035));
let _e7086 = global_3.member[bitcast<u32>(select(0i, _e7081, (_e7081 > 0i)))];
let _e7087 = local_9;
let _e7091 = (_e7028 + (3i * ((_e7023 * _e7087) + _e6997)));
let _e7093 = select(_e7035, _e7091, (_e7091 < _e7035));
let _e7098 = global_3.member[bitcast<u32>(select(0i, _e7093, (_e7093 > 0i)))];
let _e7099 = (_e7091 + 1i);
let _e7101 = select(_e7035, _e7099, (_e7099 < _e7035));
let _e7106 = global_3.member[bitcast<u32>(select(0i, _e7101, (_e7101 > 0i)))];
let _e7107 = (_e7091 + 2i);
let _e7109 = select(_e7035, _e7107, (_e7107 < _e7035));
let _e7114 = global_3.member[bitcast<u32>(select(0i, _e7109, (_e7109 > 0i)))];
let _e7115 = local_9;
let _e7119 = (_e7028 + (3i * ((_e7023 * _e7115) + _e7020)));
let _e7121 = select(_e7035, _e7119, (_e7119 < _e7035));
let _e7126 = global_3.member[bitcast<u32>(select(0i, _e7121, (_e7121 > 0i)))];
let _e7127 = (_e7119 + 1i);
let _e7129 = select(_e7035, _e7127, (_e7127 < _e7035));
let _e7134 = global_3.member[bitcast<u32>(select(0i, _e7129, (_e7129 > 0i)))];
let _e7135 = (_e7119 + 2i);
let _e7137 = select(_e7035, _e7135, (_e7135 < _e7035));
let _e7142 = global_3.member[bitcast<u32>(select(0i, _e7137, (_e7137 > 0i)))];
let _e7149 = (_e7042 + ((_e7070 - _e7042) * _e7014));
let _e7150 = (_e7050 + ((_e7078 - _e7050) * _e7014));
let _e7151 = (_e7058 + ((_e7086 - _e7058) * _e7014));
phi_11787_ = vec3<f32>(((_e7149 + (((_e7098 + ((_e7126 - _e7098) * _e7014)) - _e7149) * _e7016)) * _e6943), ((_e7150 + (((_e7106 + ((_e7134 - _e7106) * _e7014)) - _e7150) * _e7016)) * _e6943), ((_e7151 + (((_e7114 + ((_e7142 - _e7114) * _e7014)) - _e7151) * _e7016)) * _e6943));
} else {
phi_11787_ = vec3(_e6943);
}
let _e7175 = phi_11787_;
phi_11790_ = (_e6876 * _e7175);
} else {
phi_11790_ = _e6876;
}
let _e7178 = phi_11790_;
let _e7182 = (1f / sqrt(select(0f, _e6871, (_e6871 > 0f))));
phi_11803_ = type_26(vec3<f32>((_e6860 * _e7182), (_e6862 * _e7182), (_e6864 * _e7182)), _e7178);
}
let _e7197 = phi_11803_;
let _e7200 = (_e3699.member - _e2772.x);
let _e7202 = (_e3699.member_1 - _e2772.y);
let _e7204 = (_e3699.member_2 - _e2772.z);
let _e7209 = (((_e7200 * _e7200) + (_e7202 * _e7202)) + (_e7204 * _e7204));
let _e7213 = select(sqrt(select(0f, _e7209, (_e7209 > 0f))), 1e30f, _e3350);
let _e7215 = -(_e7197.member.x);
let _e7217 = -(_e7197.member.y);
let _e7219 = -(_e7197.member.z);
let _e7227 = (1f / select(_e7215, select(1e-12f, -1e-12f, (_e7215 < 0f)), (bitcast<f32>((bitcast<u32>(_e7215) & 2147483647u)) < 1e-12f)));
let _e7235 = (1f / select(_e7217, select(1e-12f, -1e-12f, (_e7217 < 0f)), (bitcast<f32>((bitcast<u32>(_e7217) & 2147483647u)) < 1e-12f)));
let _e7243 = (1f / select(_e7219, select(1e-12f, -1e-12f, (_e7219 < 0f)), (bitcast<f32>((bitcast<u32>(_e7219) & 2147483647u)) < 1e-12f)));
let _e7245 = ((_e3750.member - _e2772.x) * _e7227);
let _e7247 = ((_e3756.member - _e2772.x) * _e7227);
let _e7249 = ((_e3750.member_1 - _e2772.y) * _e7235);
let _e7251 = ((_e3756.member_1 - _e2772.y) * _e7235);
let _e7253 = ((_e3750.member_2 - _e2772.z) * _e7243);
let _e7255 = ((_e3756.member_2 - _e2772.z) * _e7243);
let _e7257 = select(_e7247, _e7245, (_e7245 < _e7247));
let _e7259 = select(_e7251, _e7249, (_e7249 < _e7251));
let _e7261 = select(_e7259, _e7257, (_e7257 > _e7259));
let _e7263 = select(_e7255, _e7253, (_e7253 < _e7255));
let _e7265 = select(_e7263, _e7261, (_e7261 > _e7263));
let _e7267 = select(_e7247, _e7245, (_e7245 > _e7247));
let _e7269 = select(_e7251, _e7249, (_e7249 > _e7251));
let _e7271 = select(_e7269, _e7267, (_e7267 < _e7269));
let _e7273 = select(_e7255, _e7253, (_e7253 > _e7255));
let _e7275 = select(_e7273, _e7271, (_e7271 < _e7273));
let _e7277 = select(0f, _e7265, (_e7265 > 0f));
let _e7279 = select(_e7213, _e7275, (_e7275 < _e7213));
let _e7280 = (_e7279 > _e7277);
let _e7281 = select(0f, _e7277, _e7280);
let _e7283 = (select(0f, _e7279, _e7280) - _e7281);
if _e2221 {
phi_12718_ = _e7283;
} else {
let _e7285 = (_e7283 / f32(_e2220));
phi_11999_ = 0u;
phi_12002_ = 0f;
loop {
let _e7287 = phi_11999_;
let _e7289 = phi_12002_;
local_80 = _e7289;
let _e7292 = ((_e7287 < _e2220) && (_e7283 > 0f));
if _e7292 {
let _e7295 = (_e7281 + (_e7285 * f32(_e7287)));
let _e7296 = (_e7295 + _e7285);
let _e7298 = (0.5f * (_e7295 + _e7296));
let _e7299 = (_e7296 - _e7295);
let _e7300 = (0.28867513f * _e7299);
let _e7301 = (_e7298 - _e7300);
let _e7310 = global_1.member.member_13.member_7;
let _e7311 = bitcast<i32>(_e7310);
let _e7314 = global_1.member.member_13.member_8;
let _e7315 = bitcast<i32>(_e7314);
let _e7318 = global_1.member.member_13.member_9;
let _e7319 = bitcast<i32>(_e7318);
let _e7320 = f32(_e7311);
let _e7322 = (_e3756.member - _e3750.member);
let _e7325 = (((((_e2772.x + (_e7215 * _e7301)) - _e3750.member) / _e7322) * _e7320) - 0.5f);
let _e7326 = (_e7320 - 1f);
let _e7328 = select(0f, _e7325, (_e7325 > 0f));
let _e7330 = select(_e7326, _e7328, (_e7328 < _e7326));
let _e7331 = f32(_e7315);
let _e7333 = (_e3756.member_1 - _e3750.member_1);
let _e7336 = (((((_e2772.y + (_e7217 * _e7301)) - _e3750.member_1) / _e7333) * _e7331) - 0.5f);
let _e7337 = (_e7331 - 1f);
let _e7339 = select(0f, _e7336, (_e7336 > 0f));
let _e7341 = select(_e7337, _e7339, (_e7339 < _e7337));
let _e7342 = f32(_e7319);
let _e7344 = (_e3756.member_2 - _e3750.member_2);
let _e7347 = (((((_e2772.z + (_e7219 * _e7301)) - _e3750.member_2) / _e7344) * _e7342) - 0.5f);
let _e7348 = (_e7342 - 1f);
let _e7350 = select(0f, _e7347, (_e7347 > 0f));
let _e7352 = select(_e7348, _e7350, (_e7350 < _e7348));
let _e7354 = select(0f, _e7330, (_e7330 > 0f));
let _e7356 = select(1e6f, _e7354, (_e7354 < 1e6f));
let _e7363 = select(0i, select(select(i32(_e7356), i32(-2147483648), (_e7356 < -2147483600f)), 2147483647i, (_e7356 > 2147483500f)), (_e7356 == _e7356));
let _e7367 = (_e7363 - select(0i, 1i, (_e7356 < f32(_e7363))));
let _e7369 = select(0f, _e7341, (_e7341 > 0f));
let _e7371 = select(1e6f, _e7369, (_e7369 < 1e6f));
let _e7378 = select(0i, select(select(i32(_e7371), i32(-2147483648), (_e7371 < -2147483600f)), 2147483647i, (_e7371 > 2147483500f)), (_e7371 == _e7371));
let _e7382 = (_e7378 - select(0i, 1i, (_e7371 < f32(_e7378))));
let _e7384 = select(0f, _e7352, (_e7352 > 0f));
let _e7386 = select(1e6f, _e7384, (_e7384 < 1e6f));
let _e7393 = select(0i, select(select(i32(_e7386), i32(-2147483648), (_e7386 < -2147483600f)), 2147483647i, (_e7386 > 2147483500f)), (_e7386 == _e7386));
let _e7397 = (_e7393 - select(0i, 1i, (_e7386 < f32(_e7393))));
let _e7401 = (_e7341 - f32(_e7382));
let _e7403 = (_e7352 - f32(_e7397));
local_7 = (_e7330 - f32(_e7367));
let _e7404 = (_e7367 + 1i);
let _e7406 = select(_e7404, 0i, (_e7404 < 0i));
if (_e7406 >= _e7311) {
phi_12140_ = (_e7311 - 1i);
} else {
phi_12140_ = _e7406;
}
let _e7410 = phi_12140_;
local_8 = (_e7410 - _e7367);
let _e7412 = (_e7382 + 1i);
let _e7414 = select(_e7412, 0i, (_e7412 < 0i));
if (_e7414 >= _e7315) {
phi_12153_ = (_e7315 - 1i);
} else {
phi_12153_ = _e7414;
}
let _e7418 = phi_12153_;
let _e7420 = ((_e7418 - _e7382) * _e7311);
let _e7421 = (_e7397 + 1i);
let _e7423 = select(_e7421, 0i, (_e7421 < 0i));
if (_e7423 >= _e7319) {
phi_12167_ = (_e7319 - 1i);
} else {
phi_12167_ = _e7423;
}
let _e7427 = phi_12167_;
let _e7433 = global_1.member.member_13.member_10;
let _e7434 = bitcast<i32>(_e7433);
let _e7439 = ((_e7434 + (((_e7397 * _e7315) + _e7382) * _e7311)) + _e7367);
let _e7441 = (bitcast<i32>(_e187) - 1i);
let _e7443 = select(_e7441, _e7439, (_e7439 < _e7441));
let _e7448 = global_7.member[bitcast<u32>(select(0i, _e7443, (_e7443 > 0i)))];
let _e7449 = local_7;
let _e7452 = local_8;
let _e7453 = (_e7439 + _e7452);
let _e7455 = select(_e7441, _e7453, (_e7453 < _e7441));
let _e7460 = global_7.member[bitcast<u32>(select(0i, _e7455, (_e7455 > 0i)))];
let _e7461 = local_7;
let _e7464 = (1f - _e7401);
let _e7466 = (_e7439 + _e7420);
let _e7468 = select(_e7441, _e7466, (_e7466 < _e7441));
let _e7473 = global_7.member[bitcast<u32>(select(0i, _e7468, (_e7468 > 0i)))];
let _e7474 = local_7;
let _e7477 = local_8;
let _e7478 = (_e7466 + _e7477);
let _e7480 = select(_e7441, _e7478, (_e7478 < _e7441));
let _e7485 = global_7.member[bitcast<u32>(select(0i, _e7480, (_e7480 > 0i)))];
let _e7486 = local_7;
let _e7491 = (_e7439 + (((_e7427 - _e7397) * _e7311) * _e7315));
let _e7493 = select(_e7441, _e7491, (_e7491 < _e7441));
let _e7498 = global_7.member[bitcast<u32>(select(0i, _e7493, (_e7493 > 0i)))];
let _e7499 = local_7;
let _e7502 = local_8;
let _e7503 = (_e7491 + _e7502);
let _e7505 = select(_e7441, _e7503, (_e7503 < _e7441));
let _e7510 = global_7.member[bitcast<u32>(select(0i, _e7505, (_e7505 > 0i)))];
let _e7511 = local_7;
let _e7515 = (_e7491 + _e7420);
let _e7517 = select(_e7441, _e7515, (_e7515 < _e7441));
let _e7522 = global_7.member[bitcast<u32>(select(0i, _e7517, (_e7517 > 0i)))];
let _e7523 = local_7;
let _e7526 = local_8;
let _e7527 = (_e7515 + _e7526);
let _e7529 = select(_e7441, _e7527, (_e7527 < _e7441));
let _e7534 = global_7.member[bitcast<u32>(select(0i, _e7529, (_e7529 > 0i)))];
let _e7535 = local_7;
let _e7544 = (_e7298 + _e7300);
let _e7554 = (((((_e2772.x + (_e7215 * _e7544)) - _e3750.member) / _e7322) * _e7320) - 0.5f);
let _e7556 = select(0f, _e7554, (_e7554 > 0f));
let _e7558 = select(_e7326, _e7556, (_e7556 < _e7326));
let _e7562 = (((((_e2772.y + (_e7217 * _e7544)) - _e3750.member_1) / _e7333) * _e7331) - 0.5f);
let _e7564 = select(0f, _e7562, (_e7562 > 0f));
let _e7566 = select(_e7337, _e7564, (_e7564 < _e7337));
let _e7570 = (((((_e2772.z + (_e7219 * _e7544)) - _e3750.member_2) / _e7344) * _e7342) - 0.5f);
let _e7572 = select(0f, _e7570, (_e7570 > 0f));
let _e7574 = select(_e7348, _e7572, (_e7572 < _e7348));
let _e7576 = select(0f, _e7558, (_e7558 > 0f));
let _e7578 = select(1e6f, _e7576, (_e7576 < 1e6f));
let _e7585 = select(0i, select(select(i32(_e7578), i32(-2147483648), (_e7578 < -2147483600f)), 2147483647i, (_e7578 > 2147483500f)), (_e7578 == _e7578));
let _e7589 = (_e7585 - select(0i, 1i, (_e7578 < f32(_e7585))));
let _e7591 = select(0f, _e7566, (_e7566 > 0f));
let _e7593 = select(1e6f, _e7591, (_e7591 < 1e6f));
let _e7600 = select(0i, select(select(i32(_e7593), i32(-2147483648), (_e7593 < -2147483600f)), 2147483647i, (_e7593 > 2147483500f)), (_e7593 == _e7593));
let _e7604 = (_e7600 - select(0i, 1i, (_e7593 < f32(_e7600))));
let _e7606 = select(0f, _e7574, (_e7574 > 0f));
let _e7608 = select(1e6f, _e7606, (_e7606 < 1e6f));
let _e7615 = select(0i, select(select(i32(_e7608), i32(-2147483648), (_e7608 < -2147483600f)), 2147483647i, (_e7608 > 2147483500f)), (_e7608 == _e7608));
let _e7619 = (_e7615 - select(0i, 1i, (_e7608 < f32(_e7615))));
let _e7623 = (_e7566 - f32(_e7604));
let _e7625 = (_e7574 - f32(_e7619));
local_5 = (_e7558 - f32(_e7589));
let _e7626 = (_e7589 + 1i);
let _e7628 = select(_e7626, 0i, (_e7626 < 0i));
if (_e7628 >= _e7311) {
phi_12486_ = (_e7311 - 1i);
} else {
phi_12486_ = _e7628;
}
let _e7632 = phi_12486_;
local_6 = (_e7632 - _e7589);
let _e7634 = (_e7604 + 1i);
let _e7636 = select(_e7634, 0i, (_e7634 < 0i));
if (_e7636 >= _e7315) {
phi_12499_ = (_e7315 - 1i);
} else {
phi_12499_ = _e7636;
}
let _e7640 = phi_12499_;
let _e7642 = ((_e7640 - _e7604) * _e7311);
let _e7643 = (_e7619 + 1i);
let _e7645 = select(_e7643, 0i, (_e7643 < 0i));
if (_e7645 >= _e7319) {
phi_12513_ = (_e7319 - 1i);
} else {
phi_12513_ = _e7645;
}
let _e7649 = phi_12513_;
let _e7657 = ((_e7434 + (((_e7619 * _e7315) + _e7604) * _e7311)) + _e7589);
let _e7659 = select(_e7441, _e7657, (_e7657 < _e7441));
let _e7664 = global_7.member[bitcast<u32>(select(0i, _e7659, (_e7659 > 0i)))];
let _e7665 = local_5;
let _e7668 = local_6;
let _e7669 = (_e7657 + _e7668);
let _e7671 = select(_e7441, _e7669, (_e7669 < _e7441));
let _e7676 = global_7.member[bitcast<u32>(select(0i, _e7671, (_e7671 > 0i)))];
let _e7677 = local_5;
let _e7680 = (1f - _e7623);
let _e7682 = (_e7657 + _e7642);
let _e7684 = select(_e7441, _e7682, (_e7682 < _e7441));
let _e7689 = global_7.member[bitcast<u32>(select(0i, _e7684, (_e7684 > 0i)))];
let _e7690 = local_5;
let _e7693 = local_6;
let _e7694 = (_e7682 + _e7693);
let _e7696 = select(_e7441, _e7694, (_e7694 < _e7441));
let _e7701 = global_7.member[bitcast<u32>(select(0i, _e7696, (_e7696 > 0i)))];
let _e7702 = local_5;
let _e7707 = (_e7657 + (((_e7649 - _e7619) * _e7311) * _e7315));
let _e7709 = select(_e7441, _e7707, (_e7707 < _e7441));
let _e7714 = global_7.member[bitcast<u32>(select(0i, _e7709, (_e7709 > 0i)))];
let _e7715 = local_5;
let _e7718 = local_6;
let _e7719 = (_e7707 + _e7718);
let _e7721 = select(_e7441, _e7719, (_e7719 < _e7441));
let _e7726 = global_7.member[bitcast<u32>(select(0i, _e7721, (_e7721 > 0i)))];
let _e7727 = local_5;
let _e7731 = (_e7707 + _e7642);
let _e7733 = select(_e7441, _e7731, (_e7731 < _e7441));
let _e7738 = global_7.member[bitcast<u32>(select(0i, _e7733, (_e7733 > 0i)))];
let _e7739 = local_5;
let _e7742 = local_6;
let _e7743 = (_e7731 + _e7742);
let _e7745 = select(_e7441, _e7743, (_e7743 < _e7441));
let _e7750 = global_7.member[bitcast<u32>(select(0i, _e7745, (_e7745 > 0i)))];
let _e7751 = local_5;
phi_12000_ = (_e7287 + 1u);
phi_12003_ = (_e7289 + ((0.5f * (((((((_e7448 * (1f - _e7449)) + (_e7460 * _e7461)) * _e7464) + (((_e7473 * (1f - _e7474)) + (_e7485 * _e7486)) * _e7401)) * (1f - _e7403)) + (((((_e7498 * (1f - _e7499)) + (_e7510 * _e7511)) * _e7464) + (((_e7522 * (1f - _e7523)) + (_e7534 * _e7535)) * _e7401)) * _e7403)) + ((((((_e7664 * (1f - _e7665)) + (_e7676 * _e7677)) * _e7680) + (((_e7689 * (1f - _e7690)) + (_e7701 * _e7702)) * _e7623)) * (1f - _e7625)) + (((((_e7714 * (1f - _e7715)) + (_e7726 * _e7727)) * _e7680) + (((_e7738 * (1f - _e7739)) + (_e7750 * _e7751)) * _e7623)) * _e7625)))) * _e7299));
} else {
phi_12000_ = u32();
phi_12003_ = f32();
}
let _e7766 = phi_12000_;
let _e7768 = phi_12003_;
continue;
continuing {
phi_11999_ = _e7766;
phi_12002_ = _e7768;
break if !(_e7292);
}
}
let _e11205 = local_80;
phi_12718_ = _e11205;
}
let _e7771 = phi_12718_;
let _e7772 = (_e7771 + select(_e3330, select(0f, _e6855, (_e6855 > 0f)), _e853));
let _e7774 = -((_e4291.member * _e7772));
let _e7776 = select(-87f, _e7774, (_e7774 > -87f));
let _e7778 = select(88f, _e7776, (_e7776 < 88f));
let _e7780 = ((_e7778 * 1.442695f) + 0.5f);
let _e7782 = select(-127f, _e7780, (_e7780 > -127f));
let _e7784 = select(128f, _e7782, (_e7782 < 128f));
let _e7791 = select(0i, select(select(i32(_e7784), i32(-2147483648), (_e7784 < -2147483600f)), 2147483647i, (_e7784 > 2147483500f)), (_e7784 == _e7784));
let _e7795 = (_e7791 - select(0i, 1i, (_e7784 < f32(_e7791))));
let _e7796 = f32(_e7795);
let _e7800 = ((_e7778 - (_e7796 * 0.6933594f)) - (_e7796 * -2.1219444e-4f));
let _e7822 = -((_e4291.member_1 * _e7772));
let _e7824 = select(-87f, _e7822, (_e7822 > -87f));
let _e7826 = select(88f, _e7824, (_e7824 < 88f));
let _e7828 = ((_e7826 * 1.442695f) + 0.5f);
let _e7830 = select(-127f, _e7828, (_e7828 > -127f));
let _e7832 = select(128f, _e7830, (_e7830 < 128f));
let _e7839 = select(0i, select(select(i32(_e7832), i32(-2147483648), (_e7832 < -2147483600f)), 2147483647i, (_e7832 > 2147483500f)), (_e7832 == _e7832));
let _e7843 = (_e7839 - select(0i, 1i, (_e7832 < f32(_e7839))));
let _e7844 = f32(_e7843);
let _e7848 = ((_e7826 - (_e7844 * 0.6933594f)) - (_e7844 * -2.1219444e-4f));
let _e7870 = -((_e4291.member_2 * _e7772));
let _e7872 = select(-87f, _e7870, (_e7870 > -87f));
let _e7874 = select(88f, _e7872, (_e7872 < 88f));
let _e7876 = ((_e7874 * 1.442695f) + 0.5f);
let _e7878 = select(-127f, _e7876, (_e7876 > -127f));
let _e7880 = select(128f, _e7878, (_e7878 < 128f));
let _e7887 = select(0i, select(select(i32(_e7880), i32(-2147483648), (_e7880 < -2147483600f)), 2147483647i, (_e7880 > 2147483500f)), (_e7880 == _e7880));
let _e7891 = (_e7887 - select(0i, 1i, (_e7880 < f32(_e7887))));
let _e7892 = f32(_e7891);
let _e7896 = ((_e7874 - (_e7892 * 0.6933594f)) - (_e7892 * -2.1219444e-4f));
let _e7922 = -((((_e7197.member.x * _e512) + (_e7197.member.y * _e523)) + (_e7197.member.z * _e534)));
let _e7924 = (_e4449 - (_e4450 * _e7922));
let _e7926 = select(1e-9f, _e7924, (_e7924 > 1e-9f));
if _e4469 {
let _e7937 = (0.5f - (0.5f * _e7922));
let _e7939 = select(0f, _e7937, (_e7937 > 0f));
let _e7943 = (sqrt(select(0f, _e7939, (_e7939 > 0f))) * 255f);
let _e7944 = (255f - 1f);
let _e7946 = select(0f, _e7943, (_e7943 > 0f));
let _e7948 = select(_e7944, _e7946, (_e7946 < _e7944));
let _e7955 = select(0i, select(select(i32(_e7948), i32(-2147483648), (_e7948 < -2147483600f)), 2147483647i, (_e7948 > 2147483500f)), (_e7948 == _e7948));
let _e7959 = (_e7955 - select(0i, 1i, (_e7948 < f32(_e7955))));
let _e7962 = global_1.member.member_13.member_11;
let _e7963 = bitcast<i32>(_e7962);
let _e7964 = (_e7963 + _e7959);
let _e7966 = (bitcast<i32>(_e187) - 1i);
let _e7968 = select(_e7966, _e7964, (_e7964 < _e7966));
let _e7973 = global_7.member[bitcast<u32>(select(0i, _e7968, (_e7968 > 0i)))];
let _e7975 = (_e7963 + (_e7959 + 1i));
let _e7977 = select(_e7966, _e7975, (_e7975 < _e7966));
let _e7982 = global_7.member[bitcast<u32>(select(0i, _e7977, (_e7977 > 0i)))];
phi_13079_ = (_e7973 + ((_e7982 - _e7973) * (_e7943 - f32(_e7959))));
} else {
phi_13079_ = select((_e4455 / (_e7926 * sqrt(select(0f, _e7926, (_e7926 > 0f))))), (0.75f * (1f + (_e7922 * _e7922))), _e4467);
}
let _e7989 = phi_13079_;
let _e7993 = ((3.1415927f * (_e7989 * _e4524)) * (select((_e1649 * ((2f * (1f + _e2750)) / (_e2753 * _e2753))), 1f, _e1650) * _e3022));
let _e8010 = (_e1679 * 0.34785485f);
let _e8020 = (_e1679 * 0.65214515f);
phi_4082_ = vec3<f32>(((_e2181.x + (((((_e3695.member_1.x * ((1f + (_e4322 * (1f + (_e4322 * (0.5f + (_e4322 * (0.16666667f + (_e4322 * (0.041666668f + (_e4322 * (0.008333334f + (_e4322 * (0.001388889f + (_e4322 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4317 + 127i)) << bitcast<u32>(23i))))) * _e4538.member) * _e4528) + (((_e4890.member_1.x * ((1f + (_e5493 * (1f + (_e5493 * (0.5f + (_e5493 * (0.16666667f + (_e5493 * (0.041666668f + (_e5493 * (0.008333334f + (_e5493 * (0.001388889f + (_e5493 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5488 + 127i)) << bitcast<u32>(23i))))) * _e4538.member) * _e5686)) * _e8010)) + (((((_e6045.member_1.x * ((1f + (_e6648 * (1f + (_e6648 * (0.5f + (_e6648 * (0.16666667f + (_e6648 * (0.041666668f + (_e6648 * (0.008333334f + (_e6648 * (0.001388889f + (_e6648 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6643 + 127i)) << bitcast<u32>(23i))))) * _e4538.member) * _e6841) + (((_e7197.member_1.x * ((1f + (_e7800 * (1f + (_e7800 * (0.5f + (_e7800 * (0.16666667f + (_e7800 * (0.041666668f + (_e7800 * (0.008333334f + (_e7800 * (0.001388889f + (_e7800 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7795 + 127i)) << bitcast<u32>(23i))))) * _e4538.member) * _e7993)) * _e8020)), ((_e2181.y + (((((_e3695.member_1.y * ((1f + (_e4370 * (1f + (_e4370 * (0.5f + (_e4370 * (0.16666667f + (_e4370 * (0.041666668f + (_e4370 * (0.008333334f + (_e4370 * (0.001388889f + (_e4370 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4365 + 127i)) << bitcast<u32>(23i))))) * _e4538.member_1) * _e4528) + (((_e4890.member_1.y * ((1f + (_e5541 * (1f + (_e5541 * (0.5f + (_e5541 * (0.16666667f + (_e5541 * (0.041666668f + (_e5541 * (0.008333334f + (_e5541 * (0.001388889f + (_e5541 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5536 + 127i)) << bitcast<u32>(23i))))) * _e4538.member_1) * _e5686)) * _e8010)) + (((((_e6045.member_1.y * ((1f + (_e6696 * (1f + (_e6696 * (0.5f + (_e6696 * (0.16666667f + (_e6696 * (0.041666668f + (_e6696 * (0.008333334f + (_e6696 * (0.001388889f + (_e6696 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6691 + 127i)) << bitcast<u32>(23i))))) * _e4538.member_1) * _e6841) + (((_e7197.member_1.y * ((1f + (_e7848 * (1f + (_e7848 * (0.5f + (_e7848 * (0.16666667f + (_e7848 * (0.041666668f + (_e7848 * (0.008333334f + (_e7848 * (0.001388889f + (_e7848 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7843 + 127i)) << bitcast<u32>(23i))))) * _e4538.member_1) * _e7993)) * _e8020)), ((_e2181.z + (((((_e3695.member_1.z * ((1f + (_e4418 * (1f + (_e4418 * (0.5f + (_e4418 * (0.16666667f + (_e4418 * (0.041666668f + (_e4418 * (0.008333334f + (_e4418 * (0.001388889f + (_e4418 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4413 + 127i)) << bitcast<u32>(23i))))) * _e4538.member_2) * _e4528) + (((_e4890.member_1.z * ((1f + (_e5589 * (1f + (_e5589 * (0.5f + (_e5589 * (0.16666667f + (_e5589 * (0.041666668f + (_e5589 * (0.008333334f + (_e5589 * (0.001388889f + (_e5589 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5584 + 127i)) << bitcast<u32>(23i))))) * _e4538.member_2) * _e5686)) * _e8010)) + (((((_e6045.member_1.z * ((1f + (_e6744 * (1f + (_e6744 * (0.5f + (_e6744 * (0.16666667f + (_e6744 * (0.041666668f + (_e6744 * (0.008333334f + (_e6744 * (0.001388889f + (_e6744 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6739 + 127i)) << bitcast<u32>(23i))))) * _e4538.member_2) * _e6841) + (((_e7197.member_1.z * ((1f + (_e7896 * (1f + (_e7896 * (0.5f + (_e7896 * (0.16666667f + (_e7896 * (0.041666668f + (_e7896 * (0.008333334f + (_e7896 * (0.001388889f + (_e7896 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7891 + 127i)) << bitcast<u32>(23i))))) * _e4538.member_2) * _e7993)) * _e8020)));
phi_4085_ = (_e2183 + 1i);
phi_4087_ = (_e3335 + (_e3297 * (select((_e1633 + (_e1649 * ((2f * _e3308) / select(1e-9f, _e3310, (_e3310 > 1e-9f))))), _e3308, _e1650) - _e3038)));
} else {
phi_4082_ = vec3<f32>();
phi_4085_ = i32();
phi_4087_ = f32();
}
let _e8033 = phi_4082_;
let _e8035 = phi_4085_;
let _e8037 = phi_4087_;
continue;
continuing {
phi_4081_ = _e8033;
phi_4084_ = _e8035;
phi_4086_ = _e8037;
break if !(_e2186);
}
}
let _e11212 = local_81;
phi_13140_ = _e11212;
} else {
phi_13140_ = vec3<f32>(0f, 0f, 0f);
}
let _e8040 = phi_13140_;
phi_13155_ = type_24(_e472.member, _e472.member_1, _e472.member_2, _e472.member_3, vec3<f32>((_e279 + (_e8040.x * _e768)), (_e290 + (_e8040.y * _e769)), (_e301 + (_e8040.z * _e770))), _e472.member_5, _e472.member_6, _e472.member_7, _e472.member_8);
} else {
phi_13155_ = _e472;
}
let _e8061 = phi_13155_;
let _e8062 = (_e673 == -1i);
let _e8063 = select(_e767, 0f, _e8062);
let _e8067 = (_e763 + (_e512 * _e8063));
let _e8068 = (_e764 + (_e523 * _e8063));
let _e8069 = (_e765 + (_e534 * _e8063));
let _e8070 = vec3<f32>(_e8067, _e8068, _e8069);
let _e8073 = (_e673 >= 0i);
if _e8073 {
let _e8118 = (_e673 * 19i);
let _e8120 = (bitcast<i32>(_e182) - 1i);
let _e8122 = select(_e8120, _e8118, (_e8118 < _e8120));
let _e8128 = global_4.member[bitcast<u32>(select(0i, _e8122, (_e8122 > 0i)))];
let _e8129 = (_e8118 + 1i);
let _e8131 = select(_e8120, _e8129, (_e8129 < _e8120));
let _e8137 = global_4.member[bitcast<u32>(select(0i, _e8131, (_e8131 > 0i)))];
let _e8138 = (_e8118 + 2i);
let _e8140 = select(_e8120, _e8138, (_e8138 < _e8120));
let _e8146 = global_4.member[bitcast<u32>(select(0i, _e8140, (_e8140 > 0i)))];
let _e8147 = (_e8118 + 3i);
let _e8149 = select(_e8120, _e8147, (_e8147 < _e8120));
let _e8155 = global_4.member[bitcast<u32>(select(0i, _e8149, (_e8149 > 0i)))];
let _e8156 = (_e8118 + 4i);
let _e8158 = select(_e8120, _e8156, (_e8156 < _e8120));
let _e8164 = global_4.member[bitcast<u32>(select(0i, _e8158, (_e8158 > 0i)))];
let _e8165 = (_e8118 + 5i);
let _e8167 = select(_e8120, _e8165, (_e8165 < _e8120));
let _e8173 = global_4.member[bitcast<u32>(select(0i, _e8167, (_e8167 > 0i)))];
let _e8174 = (_e8118 + 6i);
let _e8176 = select(_e8120, _e8174, (_e8174 < _e8120));
let _e8182 = global_4.member[bitcast<u32>(select(0i, _e8176, (_e8176 > 0i)))];
let _e8183 = (_e8118 + 7i);
let _e8185 = select(_e8120, _e8183, (_e8183 < _e8120));
let _e8191 = global_4.member[bitcast<u32>(select(0i, _e8185, (_e8185 > 0i)))];
let _e8192 = (_e8118 + 8i);
let _e8194 = select(_e8120, _e8192, (_e8192 < _e8120));
let _e8200 = global_4.member[bitcast<u32>(select(0i, _e8194, (_e8194 > 0i)))];
let _e8201 = (_e8155 - _e8128);
let _e8202 = (_e8164 - _e8137);
let _e8203 = (_e8173 - _e8146);
let _e8204 = (_e8182 - _e8128);
let _e8205 = (_e8191 - _e8137);
let _e8206 = (_e8200 - _e8146);
let _e8209 = ((_e8202 * _e8206) - (_e8203 * _e8205));
let _e8212 = ((_e8203 * _e8204) - (_e8201 * _e8206));
let _e8215 = ((_e8201 * _e8205) - (_e8202 * _e8204));
let _e8216 = (_e8155 - _e8067);
let _e8217 = (_e8164 - _e8068);
let _e8218 = (_e8173 - _e8069);
let _e8219 = (_e8182 - _e8067);
let _e8220 = (_e8191 - _e8068);
let _e8221 = (_e8200 - _e8069);
let _e8235 = (((((_e8217 * _e8221) - (_e8218 * _e8220)) * _e8209) + (((_e8218 * _e8219) - (_e8216 * _e8221)) * _e8212)) + (((_e8216 * _e8220) - (_e8217 * _e8219)) * _e8215));
let _e8237 = select(0f, _e8235, (_e8235 > 0f));
let _e8238 = (_e8128 - _e8067);
let _e8239 = (_e8137 - _e8068);
let _e8240 = (_e8146 - _e8069);
let _e8254 = (((((_e8220 * _e8240) - (_e8221 * _e8239)) * _e8209) + (((_e8221 * _e8238) - (_e8219 * _e8240)) * _e8212)) + (((_e8219 * _e8239) - (_e8220 * _e8238)) * _e8215));
let _e8256 = select(0f, _e8254, (_e8254 > 0f));
let _e8270 = (((((_e8239 * _e8218) - (_e8240 * _e8217)) * _e8209) + (((_e8240 * _e8216) - (_e8238 * _e8218)) * _e8212)) + (((_e8238 * _e8217) - (_e8239 * _e8216)) * _e8215));
let _e8272 = select(0f, _e8270, (_e8270 > 0f));
let _e8274 = ((_e8237 + _e8256) + _e8272);
let _e8276 = select(1e-30f, _e8274, (_e8274 > 1e-30f));
let _e8277 = (_e8237 / _e8276);
let _e8278 = (_e8256 / _e8276);
let _e8279 = (_e8272 / _e8276);
let _e8284 = (((_e8209 * _e8209) + (_e8212 * _e8212)) + (_e8215 * _e8215));
let _e8287 = sqrt(select(0f, _e8284, (_e8284 > 0f)));
let _e8290 = (1f / select(1e-20f, _e8287, (_e8287 > 1e-20f)));
let _e8295 = (_e8118 + 9i);
let _e8297 = select(_e8120, _e8295, (_e8295 < _e8120));
let _e8303 = global_4.member[bitcast<u32>(select(0i, _e8297, (_e8297 > 0i)))];
let _e8304 = (_e8118 + 10i);
let _e8306 = select(_e8120, _e8304, (_e8304 < _e8120));
let _e8312 = global_4.member[bitcast<u32>(select(0i, _e8306, (_e8306 > 0i)))];
let _e8313 = (_e8118 + 11i);
let _e8315 = select(_e8120, _e8313, (_e8313 < _e8120));
let _e8321 = global_4.member[bitcast<u32>(select(0i, _e8315, (_e8315 > 0i)))];
let _e8325 = (_e8118 + 12i);
let _e8327 = select(_e8120, _e8325, (_e8325 < _e8120));
let _e8333 = global_4.member[bitcast<u32>(select(0i, _e8327, (_e8327 > 0i)))];
let _e8334 = (_e8118 + 13i);
let _e8336 = select(_e8120, _e8334, (_e8334 < _e8120));
let _e8342 = global_4.member[bitcast<u32>(select(0i, _e8336, (_e8336 > 0i)))];
let _e8343 = (_e8118 + 14i);
let _e8345 = select(_e8120, _e8343, (_e8343 < _e8120));
let _e8351 = global_4.member[bitcast<u32>(select(0i, _e8345, (_e8345 > 0i)))];
let _e8358 = (_e8118 + 15i);
let _e8360 = select(_e8120, _e8358, (_e8358 < _e8120));
let _e8366 = global_4.member[bitcast<u32>(select(0i, _e8360, (_e8360 > 0i)))];
let _e8367 = (_e8118 + 16i);
let _e8369 = select(_e8120, _e8367, (_e8367 < _e8120));
let _e8375 = global_4.member[bitcast<u32>(select(0i, _e8369, (_e8369 > 0i)))];
let _e8376 = (_e8118 + 17i);
let _e8378 = select(_e8120, _e8376, (_e8376 < _e8120));
let _e8384 = global_4.member[bitcast<u32>(select(0i, _e8378, (_e8378 > 0i)))];
let _e8388 = (((_e8303 * _e8277) + (_e8333 * _e8278)) + (_e8366 * _e8279));
let _e8389 = (((_e8312 * _e8277) + (_e8342 * _e8278)) + (_e8375 * _e8279));
let _e8390 = (((_e8321 * _e8277) + (_e8351 * _e8278)) + (_e8384 * _e8279));
let _e8395 = (((_e8388 * _e8388) + (_e8389 * _e8389)) + (_e8390 * _e8390));
let _e8398 = sqrt(select(0f, _e8395, (_e8395 > 0f)));
let _e8401 = (1f / select(1e-20f, _e8398, (_e8398 > 1e-20f)));
let _e8406 = (_e8118 + 18i);
let _e8408 = select(_e8120, _e8406, (_e8406 < _e8120));
let _e8414 = global_4.member[bitcast<u32>(select(0i, _e8408, (_e8408 > 0i)))];
let _e8423 = (select(select(0i, select(select(i32(_e8414), i32(-2147483648), (_e8414 < -2147483600f)), 2147483647i, (_e8414 > 2147483500f)), (_e8414 == _e8414)), _e673, ((_e1499 & 1u) != 0u)) * 10i);
let _e8425 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e8427 = select(_e8425, _e8423, (_e8423 < _e8425));
let _e8433 = global_5.member[bitcast<u32>(select(0i, _e8427, (_e8427 > 0i)))];
let _e8434 = (_e8423 + 1i);
let _e8436 = select(_e8425, _e8434, (_e8434 < _e8425));
let _e8442 = global_5.member[bitcast<u32>(select(0i, _e8436, (_e8436 > 0i)))];
let _e8443 = (_e8423 + 2i);
let _e8445 = select(_e8425, _e8443, (_e8443 < _e8425));
let _e8451 = global_5.member[bitcast<u32>(select(0i, _e8445, (_e8445 > 0i)))];
let _e8455 = (_e8423 + 3i);
let _e8457 = select(_e8425, _e8455, (_e8455 < _e8425));
let _e8463 = global_5.member[bitcast<u32>(select(0i, _e8457, (_e8457 > 0i)))];
let _e8464 = (_e8423 + 4i);
let _e8466 = select(_e8425, _e8464, (_e8464 < _e8425));
let _e8472 = global_5.member[bitcast<u32>(select(0i, _e8466, (_e8466 > 0i)))];
let _e8473 = (_e8423 + 5i);
let _e8475 = select(_e8425, _e8473, (_e8473 < _e8425));
let _e8481 = global_5.member[bitcast<u32>(select(0i, _e8475, (_e8475 > 0i)))];
let _e8488 = (_e8423 + 6i);
let _e8490 = select(_e8425, _e8488, (_e8488 < _e8425));
let _e8496 = global_5.member[bitcast<u32>(select(0i, _e8490, (_e8490 > 0i)))];
let _e8497 = (_e8423 + 7i);
let _e8499 = select(_e8425, _e8497, (_e8497 < _e8425));
let _e8505 = global_5.member[bitcast<u32>(select(0i, _e8499, (_e8499 > 0i)))];
let _e8506 = (_e8423 + 8i);
let _e8508 = select(_e8425, _e8506, (_e8506 < _e8425));
let _e8514 = global_5.member[bitcast<u32>(select(0i, _e8508, (_e8508 > 0i)))];
let _e8522 = (_e8423 + 9i);
let _e8524 = select(_e8425, _e8522, (_e8522 < _e8425));
let _e8530 = global_5.member[bitcast<u32>(select(0i, _e8524, (_e8524 > 0i)))];
phi_13890_ = type_25(_e8070, vec3<f32>((_e8209 * _e8290), (_e8212 * _e8290), (_e8215 * _e8290)), vec3<f32>((_e8388 * _e8401), (_e8389 * _e8401), (_e8390 * _e8401)), vec3<f32>((((_e8433 * _e8277) + (_e8463 * _e8278)) + (_e8496 * _e8279)), (((_e8442 * _e8277) + (_e8472 * _e8278)) + (_e8505 * _e8279)), (((_e8451 * _e8277) + (_e8481 * _e8278)) + (_e8514 * _e8279))), _e8530, true);
} else {
let _e8074 = (_e673 == -3i);
let _e8080 = global_1.member.member_14.member_1.member.member;
let _e8085 = global_1.member.member_14.member_1.member_1;
let _e8091 = global_1.member.member_14.member.member.member;
let _e8096 = global_1.member.member_14.member.member_1;
let _e8106 = vec3<f32>(select(_e8091.member, _e8080.member, _e8074), select(_e8091.member_1, _e8080.member_1, _e8074), select(_e8091.member_2, _e8080.member_2, _e8074));
phi_13890_ = type_25(_e8070, _e8106, _e8106, vec3<f32>(select(_e8096.member, _e8085.member, _e8074), select(_e8096.member_1, _e8085.member_1, _e8074), select(_e8096.member_2, _e8085.member_2, _e8074)), 0f, false);
}
let _e8533 = phi_13890_;
let _e8536 = ((select(0i, _e673, _e8073) * 19i) + 18i);
let _e8538 = (bitcast<i32>(_e182) - 1i);
let _e8540 = select(_e8538, _e8536, (_e8536 < _e8538));
let _e8546 = global_4.member[bitcast<u32>(select(0i, _e8540, (_e8540 > 0i)))];
let _e8553 = select(0i, select(select(i32(_e8546), i32(-2147483648), (_e8546 < -2147483600f)), 2147483647i, (_e8546 > 2147483500f)), (_e8546 == _e8546));
let _e8554 = (_e8553 * 4i);
let _e8556 = (bitcast<i32>(_e187) - 1i);
let _e8558 = select(_e8556, _e8554, (_e8554 < _e8556));
let _e8564 = global_7.member[bitcast<u32>(select(0i, _e8558, (_e8558 > 0i)))];
if _e8073 {
phi_13954_ = (select(_e8564, 1f, (_e8553 == 16i)) == 0f);
} else {
phi_13954_ = (_e673 != -1i);
}
let _e8570 = phi_13954_;
if _e681 {
let _e8580 = type_24(select(_e767, 1e30f, _e8062), _e8061.member_1, _e8061.member_2, _e8061.member_3, _e8061.member_4, _e8061.member_5, _e8061.member_6, _e8061.member_7, _e8061.member_8);
let _e8591 = type_24(_e8580.member, select(_e767, _e846, (_e846 < _e767)), _e8580.member_2, _e8580.member_3, _e8580.member_4, _e8580.member_5, _e8580.member_6, _e8580.member_7, _e8580.member_8);
let _e8602 = type_24(_e8591.member, _e8591.member_1, select(_e767, _e847, (_e847 < _e767)), _e8591.member_3, _e8591.member_4, _e8591.member_5, _e8591.member_6, _e8591.member_7, _e8591.member_8);
let _e8613 = select(1f, -1f, ((((_e8533.member_1.x * _e512) + (_e8533.member_1.y * _e523)) + (_e8533.member_1.z * _e534)) > 0f));
let _e8625 = select(_e8613, -(_e8613), ((((_e8533.member_2.x * _e8533.member_1.x) + (_e8533.member_2.y * _e8533.member_1.y)) + (_e8533.member_2.z * _e8533.member_1.z)) < 0f));
let _e8626 = (_e8533.member_2.x * _e8625);
let _e8627 = (_e8533.member_2.y * _e8625);
let _e8628 = (_e8533.member_2.z * _e8625);
let _e8637 = ((((_e8626 * _e512) + (_e8627 * _e523)) + (_e8628 * _e534)) > 0f);
let _e8653 = type_24(_e8602.member, _e8602.member_1, _e8602.member_2, _e8602.member_3, _e8602.member_4, _e8602.member_5, _e8602.member_6, _e8602.member_7, vec3<f32>(select(select(_e8626, (_e8533.member_1.x * _e8613), _e8637), 0f, _e8062), select(select(_e8627, (_e8533.member_1.y * _e8613), _e8637), 0f, _e8062), select(select(_e8628, (_e8533.member_1.z * _e8613), _e8637), 0f, _e8062)));
let _e8657 = (1f - (((_e1400 + _e1448) + _e1496) * _e1504));
let _e8661 = global_1.member.member_15.member_12;
phi_14074_ = type_24(_e8653.member, _e8653.member_1, _e8653.member_2, _e8653.member_3, _e8653.member_4, _e8653.member_5, _e8653.member_6, select(1f, select(_e8657, _e8661, (_e8661 > _e8657)), _e8062), _e8653.member_8);
} else {
phi_14074_ = _e8061;
}
let _e8675 = phi_14074_;
if _e8062 {
let _e9902 = (((_e545 * _e545) + (_e556 * _e556)) + (_e567 * _e567));
let _e9905 = sqrt(select(0f, _e9902, (_e9902 > 0f)));
let _e9910 = (((_e578 * _e578) + (_e589 * _e589)) + (_e600 * _e600));
let _e9913 = sqrt(select(0f, _e9910, (_e9910 > 0f)));
let _e9915 = select(_e9913, _e9905, (_e9905 > _e9913));
let _e9919 = global_1.member.member_15.member_4;
let _e9927 = (((_e9919.member * _e512) + (_e9919.member_1 * _e523)) + (_e9919.member_2 * _e534));
let _e9931 = global_1.member.member_15.member_5;
let _e9939 = (((_e9931.member * _e512) + (_e9931.member_1 * _e523)) + (_e9931.member_2 * _e534));
let _e9943 = global_1.member.member_15.member_6;
let _e9951 = (((_e9943.member * _e512) + (_e9943.member_1 * _e523)) + (_e9943.member_2 * _e534));
let _e9955 = global_1.member.member_15.member;
let _e9959 = global_1.member.member_15.member_7;
let _e9963 = vec3<f32>(_e9959.member, _e9959.member_1, _e9959.member_2);
let _e9967 = global_1.member.member_15.member_8;
if (_e9955 == 0u) {
phi_15563_ = _e9963;
} else {
if (_e9955 == 1u) {
let _e10944 = select(-1f, _e9951, (_e9951 > -1f));
let _e10946 = select(1f, _e10944, (_e10944 < 1f));
if (_e10946 > 0f) {
phi_14178_ = _e9963;
} else {
let _e10951 = global_1.member.member_15.member_9;
phi_14178_ = vec3<f32>(_e10951.member, _e10951.member_1, _e10951.member_2);
}
let _e10957 = phi_14178_;
let _e10966 = bitcast<f32>((bitcast<u32>(_e10946) & 2147483647u));
let _e10969 = sqrt(select(0f, _e10966, (_e10966 > 0f)));
phi_15562_ = vec3<f32>((_e9967.member + ((_e10957.x - _e9967.member) * _e10969)), (_e9967.member_1 + ((_e10957.y - _e9967.member_1) * _e10969)), (_e9967.member_2 + ((_e10957.z - _e9967.member_2) * _e10969)));
} else {
if (_e9955 == 2u) {
let _e10744 = global_1.member.member_15.member_10;
let _e10745 = (_e9915 / _e10744);
let _e10747 = select(1e-4f, _e10745, (_e10745 > 1e-4f));
let _e10750 = bitcast<f32>((bitcast<u32>(_e9927) & 2147483647u));
let _e10753 = bitcast<f32>((bitcast<u32>(_e9939) & 2147483647u));
let _e10757 = select(_e10753, _e10750, (_e10750 > _e10753));
let _e10760 = (select(_e10753, _e10750, (_e10750 < _e10753)) / select(1.1754944e-38f, _e10757, (_e10757 > 1.1754944e-38f)));
let _e10761 = (_e10760 > 0.41421357f);
let _e10765 = select(_e10760, ((_e10760 - 1f) / (_e10760 + 1f)), _e10761);
let _e10766 = (_e10765 * _e10765);
let _e10781 = (select(0f, 0.7853982f, _e10761) + (_e10765 + ((_e10765 * _e10766) * (-0.33333334f + (_e10766 * (0.2f + (_e10766 * (-0.14285713f + (_e10766 * (0.11111111f + (_e10766 * (-0.09090909f + (_e10766 * 0.0585f)))))))))))));
let _e10784 = select(_e10781, (1.5707964f - _e10781), (_e10753 > _e10750));
let _e10787 = select(_e10784, (3.1415927f - _e10784), (_e9927 < 0f));
let _e10793 = (1f - (_e9951 * _e9951));
let _e10796 = sqrt(select(0f, _e10793, (_e10793 > 0f)));
let _e10799 = (_e10747 / select(1e-3f, _e10796, (_e10796 > 1e-3f)));
let _e10800 = ((select(_e10787, -(_e10787), (_e9939 < 0f)) / _e10744) * 0.5f);
let _e10802 = select(-8e6f, _e10800, (_e10800 > -8e6f));
let _e10804 = select(8e6f, _e10802, (_e10802 < 8e6f));
let _e10811 = select(0i, select(select(i32(_e10804), i32(-2147483648), (_e10804 < -2147483600f)), 2147483647i, (_e10804 > 2147483500f)), (_e10804 == _e10804));
let _e10818 = ((_e10800 - f32((_e10811 - select(0i, 1i, (_e10804 < f32(_e10811)))))) * 2f);
let _e10826 = ((select(select((_e10818 - 2f), (1f - _e10818), (_e10818 < 1.5f)), _e10818, (_e10818 < 0.5f)) * 2f) / _e10799);
let _e10828 = select(-1f, _e10826, (_e10826 > -1f));
let _e10831 = (2f - _e10799);
let _e10833 = select(0f, _e10831, (_e10831 > 0f));
let _e10838 = select(-1f, _e9951, (_e9951 > -1f));
let _e10840 = select(1f, _e10838, (_e10838 < 1f));
let _e10843 = ((1f - _e10840) * (1f + _e10840));
let _e10846 = sqrt(select(0f, _e10843, (_e10843 > 0f)));
let _e10849 = bitcast<f32>((bitcast<u32>(_e10846) & 2147483647u));
let _e10852 = bitcast<f32>((bitcast<u32>(_e10840) & 2147483647u));
let _e10856 = select(_e10852, _e10849, (_e10849 > _e10852));
let _e10859 = (select(_e10852, _e10849, (_e10849 < _e10852)) / select(1.1754944e-38f, _e10856, (_e10856 > 1.1754944e-38f)));
let _e10860 = (_e10859 > 0.41421357f);
let _e10864 = select(_e10859, ((_e10859 - 1f) / (_e10859 + 1f)), _e10860);
let _e10865 = (_e10864 * _e10864);
let _e10880 = (select(0f, 0.7853982f, _e10860) + (_e10864 + ((_e10864 * _e10865) * (-0.33333334f + (_e10865 * (0.2f + (_e10865 * (-0.14285713f + (_e10865 * (0.11111111f + (_e10865 * (-0.09090909f + (_e10865 * 0.0585f)))))))))))));
let _e10883 = select(_e10880, (1.5707964f - _e10880), (_e10852 > _e10849));
let _e10886 = select(_e10883, (3.1415927f - _e10883), (_e10846 < 0f));
let _e10891 = ((select(_e10886, -(_e10886), (_e10840 < 0f)) / _e10744) * 0.5f);
let _e10893 = select(-8e6f, _e10891, (_e10891 > -8e6f));
let _e10895 = select(8e6f, _e10893, (_e10893 < 8e6f));
let _e10902 = select(0i, select(select(i32(_e10895), i32(-2147483648), (_e10895 < -2147483600f)), 2147483647i, (_e10895 > 2147483500f)), (_e10895 == _e10895));
let _e10909 = ((_e10891 - f32((_e10902 - select(0i, 1i, (_e10895 < f32(_e10902)))))) * 2f);
let _e10917 = ((select(select((_e10909 - 2f), (1f - _e10909), (_e10909 < 1.5f)), _e10909, (_e10909 < 0.5f)) * 2f) / _e10747);
let _e10919 = select(-1f, _e10917, (_e10917 > -1f));
let _e10922 = (2f - _e10747);
let _e10924 = select(0f, _e10922, (_e10922 > 0f));
let _e10930 = (0.5f + ((0.5f * (select(1f, _e10828, (_e10828 < 1f)) * select(1f, _e10833, (_e10833 < 1f)))) * (select(1f, _e10919, (_e10919 < 1f)) * select(1f, _e10924, (_e10924 < 1f)))));
phi_15561_ = vec3<f32>((_e9959.member + ((_e9967.member - _e9959.member) * _e10930)), (_e9959.member_1 + ((_e9967.member_1 - _e9959.member_1) * _e10930)), (_e9959.member_2 + ((_e9967.member_2 - _e9959.member_2) * _e10930)));
} else {
let _e9977 = global_1.member.member_15.member_1;
let _e9978 = bitcast<i32>(_e9977);
let _e9983 = global_1.member.member_15.member_3;
let _e9985 = f32(bitcast<i32>(_e9983));
let _e9987 = (2f * 3.1415927f);
let _e9988 = ((_e9915 * f32(_e9978)) / _e9987);
let _e9990 = select(1e-6f, _e9988, (_e9988 > 1e-6f));
let _e9993 = bitcast<u32>(select(1.1754944e-38f, _e9990, (_e9990 > 1.1754944e-38f)));
let _e9994 = (_e9993 & 8388607u);
let _e9996 = select(0u, 1u, (_e9994 > 3474675u));
let _e10007 = bitcast<f32>((_e9994 | ((127u - _e9996) << bitcast<u32>(23i))));
let _e10010 = ((_e10007 - 1f) / (_e10007 + 1f));
let _e10011 = (_e10010 * _e10010);
let _e10026 = (f32(((bitcast<i32>((_e9993 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e9996))) + (((2f * _e10010) + ((_e10010 * _e10011) * (0.6666667f + (_e10011 * (0.4f + (_e10011 * (0.2857143f + (_e10011 * (0.22222222f + (_e10011 * 0.18181819f)))))))))) * 1.442695f));
let _e10027 = (_e9985 - 1f);
let _e10029 = select(0f, _e10026, (_e10026 > 0f));
let _e10031 = select(_e10027, _e10029, (_e10029 < _e10027));
let _e10032 = (_e9985 - 2f);
let _e10034 = select(0f, _e10032, (_e10032 > 0f));
let _e10036 = select(0f, _e10031, (_e10031 > 0f));
let _e10038 = select(_e10034, _e10036, (_e10036 < _e10034));
let _e10045 = select(0i, select(select(i32(_e10038), i32(-2147483648), (_e10038 < -2147483600f)), 2147483647i, (_e10038 > 2147483500f)), (_e10038 == _e10038));
let _e10049 = (_e10045 - select(0i, 1i, (_e10038 < f32(_e10045))));
let _e10052 = bitcast<f32>((bitcast<u32>(_e9939) & 2147483647u));
let _e10055 = bitcast<f32>((bitcast<u32>(_e9927) & 2147483647u));
let _e10059 = select(_e10055, _e10052, (_e10052 > _e10055));
let _e10062 = (select(_e10055, _e10052, (_e10052 < _e10055)) / select(1.1754944e-38f, _e10059, (_e10059 > 1.1754944e-38f)));
let _e10063 = (_e10062 > 0.41421357f);
let _e10067 = select(_e10062, ((_e10062 - 1f) / (_e10062 + 1f)), _e10063);
let _e10068 = (_e10067 * _e10067);
let _e10083 = (select(0f, 0.7853982f, _e10063) + (_e10067 + ((_e10067 * _e10068) * (-0.33333334f + (_e10068 * (0.2f + (_e10068 * (-0.14285713f + (_e10068 * (0.11111111f + (_e10068 * (-0.09090909f + (_e10068 * 0.0585f)))))))))))));
let _e10086 = select(_e10083, (1.5707964f - _e10083), (_e10055 > _e10052));
let _e10089 = select(_e10086, (3.1415927f - _e10086), (_e9939 < 0f));
let _e10094 = (0.5f - (select(_e10089, -(_e10089), (_e9927 < 0f)) / _e9987));
let _e10096 = select(-1f, _e9951, (_e9951 > -1f));
let _e10098 = select(1f, _e10096, (_e10096 < 1f));
let _e10101 = ((1f - _e10098) * (1f + _e10098));
let _e10104 = sqrt(select(0f, _e10101, (_e10101 > 0f)));
let _e10107 = bitcast<f32>((bitcast<u32>(_e10104) & 2147483647u));
let _e10110 = bitcast<f32>((bitcast<u32>(_e10098) & 2147483647u));
let _e10114 = select(_e10110, _e10107, (_e10107 > _e10110));
let _e10117 = (select(_e10110, _e10107, (_e10107 < _e10110)) / select(1.1754944e-38f, _e10114, (_e10114 > 1.1754944e-38f)));
let _e10118 = (_e10117 > 0.41421357f);
let _e10122 = select(_e10117, ((_e10117 - 1f) / (_e10117 + 1f)), _e10118);
let _e10123 = (_e10122 * _e10122);
let _e10138 = (select(0f, 0.7853982f, _e10118) + (_e10122 + ((_e10122 * _e10123) * (-0.33333334f + (_e10123 * (0.2f + (_e10123 * (-0.14285713f + (_e10123 * (0.11111111f + (_e10123 * (-0.09090909f + (_e10123 * 0.0585f)))))))))))));
let _e10141 = select(_e10138, (1.5707964f - _e10138), (_e10110 > _e10107));
let _e10144 = select(_e10141, (3.1415927f - _e10141), (_e10104 < 0f));
let _e10149 = (0.5f - (select(_e10144, -(_e10144), (_e10098 < 0f)) / 3.1415927f));
let _e10153 = global_1.member.member_15.member_2;
let _e10154 = bitcast<i32>(_e10153);
phi_14780_ = 0i;
phi_14783_ = 0i;
phi_14785_ = _e10154;
phi_14787_ = _e9978;
loop {
let _e10156 = phi_14780_;
let _e10158 = phi_14783_;
let _e10160 = phi_14785_;
let _e10162 = phi_14787_;
local_43 = _e10162;
local_44 = _e10160;
local_45 = _e10162;
local_46 = _e10162;
local_47 = _e10162;
local_48 = _e10162;
local_49 = _e10162;
local_50 = _e10162;
local_51 = _e10160;
local_52 = _e10160;
local_53 = _e10160;
local_54 = _e10160;
local_55 = _e10162;
local_56 = _e10158;
local_57 = _e10162;
local_58 = _e10158;
let _e10163 = (_e10156 < _e10049);
if _e10163 {
if (_e10162 > 1i) {
phi_14802_ = (_e10162 >> bitcast<u32>(1i));
} else {
phi_14802_ = 1i;
}
let _e10170 = phi_14802_;
if (_e10160 > 1i) {
phi_14808_ = (_e10160 >> bitcast<u32>(1i));
} else {
phi_14808_ = 1i;
}
let _e10175 = phi_14808_;
phi_14781_ = (_e10156 + 1i);
phi_14784_ = (_e10158 + (_e10162 * _e10160));
phi_14786_ = _e10175;
phi_14788_ = _e10170;
} else {
phi_14781_ = i32();
phi_14784_ = i32();
phi_14786_ = i32();
phi_14788_ = i32();
}
let _e10178 = phi_14781_;
let _e10180 = phi_14784_;
let _e10182 = phi_14786_;
let _e10184 = phi_14788_;
continue;
continuing {
phi_14780_ = _e10178;
phi_14783_ = _e10180;
phi_14785_ = _e10182;
phi_14787_ = _e10184;
break if !(_e10163);
}
}
let _e10187 = local_43;
let _e10188 = f32(_e10187);
let _e10190 = ((_e10094 * _e10188) - 0.5f);
let _e10192 = local_44;
let _e10193 = f32(_e10192);
let _e10195 = ((_e10149 * _e10193) - 0.5f);
let _e10197 = select(-1f, _e10190, (_e10190 > -1f));
let _e10199 = select(_e10188, _e10197, (_e10197 < _e10188));
let _e10206 = select(0i, select(select(i32(_e10199), i32(-2147483648), (_e10199 < -2147483600f)), 2147483647i, (_e10199 > 2147483500f)), (_e10199 == _e10199));
let _e10210 = (_e10206 - select(0i, 1i, (_e10199 < f32(_e10206))));
let _e10212 = select(-1f, _e10195, (_e10195 > -1f));
let _e10214 = select(_e10193, _e10212, (_e10212 < _e10193));
let _e10221 = select(0i, select(select(i32(_e10214), i32(-2147483648), (_e10214 < -2147483600f)), 2147483647i, (_e10214 > 2147483500f)), (_e10214 == _e10214));
let _e10225 = (_e10221 - select(0i, 1i, (_e10214 < f32(_e10221))));
let _e10227 = (_e10190 - f32(_e10210));
let _e10229 = (_e10195 - f32(_e10225));
let _e10231 = select(0f, _e10229, (_e10229 > 0f));
let _e10233 = select(1f, _e10231, (_e10231 < 1f));
if (_e10210 < 0i) {
let _e10236 = local_45;
phi_14883_ = (_e10210 + _e10236);
} else {
phi_14883_ = _e10210;
}
let _e10239 = phi_14883_;
let _e10241 = local_46;
if (_e10239 >= _e10241) {
let _e10244 = local_47;
phi_14889_ = (_e10239 - _e10244);
} else {
phi_14889_ = _e10239;
}
let _e10247 = phi_14889_;
let _e10248 = (_e10210 + 1i);
if (_e10248 < 0i) {
let _e10251 = local_48;
phi_14896_ = (_e10248 + _e10251);
} else {
phi_14896_ = _e10248;
}
let _e10254 = phi_14896_;
let _e10256 = local_49;
if (_e10254 >= _e10256) {
let _e10259 = local_50;
phi_14902_ = (_e10254 - _e10259);
} else {
phi_14902_ = _e10254;
}
let _e10262 = phi_14902_;
let _e10264 = select(_e10225, 0i, (_e10225 < 0i));
let _e10266 = local_51;
if (_e10264 >= _e10266) {
let _e10269 = local_52;
phi_14913_ = (_e10269 - 1i);
} else {
phi_14913_ = _e10264;
}
let _e10272 = phi_14913_;
let _e10273 = (_e10225 + 1i);
let _e10275 = select(_e10273, 0i, (_e10273 < 0i));
let _e10277 = local_53;
if (_e10275 >= _e10277) {
let _e10280 = local_54;
phi_14925_ = (_e10280 - 1i);
} else {
phi_14925_ = _e10275;
}
let _e10283 = phi_14925_;
let _e10285 = local_55;
let _e10288 = local_56;
let _e10289 = (_e10288 + (_e10272 * _e10285));
let _e10291 = local_57;
let _e10294 = local_58;
let _e10295 = (_e10294 + (_e10283 * _e10291));
let _e10297 = (3i * (_e10289 + _e10247));
let _e10299 = (bitcast<i32>(_e180) - 1i);
let _e10301 = select(_e10299, _e10297, (_e10297 < _e10299));
let _e10307 = global_3.member[bitcast<u32>(select(0i, _e10301, (_e10301 > 0i)))];
let _e10308 = (_e10297 + 1i);
let _e10310 = select(_e10299, _e10308, (_e10308 < _e10299));
let _e10316 = global_3.member[bitcast<u32>(select(0i, _e10310, (_e10310 > 0i)))];
let _e10317 = (_e10297 + 2i);
let _e10319 = select(_e10299, _e10317, (_e10317 < _e10299));
let _e10325 = global_3.member[bitcast<u32>(select(0i, _e10319, (_e10319 > 0i)))];
let _e10327 = (3i * (_e10289 + _e10262));
let _e10329 = select(_e10299, _e10327, (_e10327 < _e10299));
let _e10335 = global_3.member[bitcast<u32>(select(0i, _e10329, (_e10329 > 0i)))];
let _e10336 = (_e10327 + 1i);
let _e10338 = select(_e10299, _e10336, (_e10336 < _e10299));
let _e10344 = global_3.member[bitcast<u32>(select(0i, _e10338, (_e10338 > 0i)))];
let _e10345 = (_e10327 + 2i);
let _e10347 = select(_e10299, _e10345, (_e10345 < _e10299));
let _e10353 = global_3.member[bitcast<u32>(select(0i, _e10347, (_e10347 > 0i)))];
let _e10355 = (3i * (_e10295 + _e10247));
let _e10357 = select(_e10299, _e10355, (_e10355 < _e10299));
let _e10363 = global_3.member[bitcast<u32>(select(0i, _e10357, (_e10357 > 0i)))];
let _e10364 = (_e10355 + 1i);
let _e10366 = select(_e10299, _e10364, (_e10364 < _e10299));
let _e10372 = global_3.member[bitcast<u32>(select(0i, _e10366, (_e10366 > 0i)))];
let _e10373 = (_e10355 + 2i);
let _e10375 = select(_e10299, _e10373, (_e10373 < _e10299));
let _e10381 = global_3.member[bitcast<u32>(select(0i, _e10375, (_e10375 > 0i)))];
let _e10383 = (3i * (_e10295 + _e10262));
let _e10385 = select(_e10299, _e10383, (_e10383 < _e10299));
let _e10391 = global_3.member[bitcast<u32>(select(0i, _e10385, (_e10385 > 0i)))];
let _e10392 = (_e10383 + 1i);
let _e10394 = select(_e10299, _e10392, (_e10392 < _e10299));
let _e10400 = global_3.member[bitcast<u32>(select(0i, _e10394, (_e10394 > 0i)))];
let _e10401 = (_e10383 + 2i);
let _e10403 = select(_e10299, _e10401, (_e10401 < _e10299));
let _e10409 = global_3.member[bitcast<u32>(select(0i, _e10403, (_e10403 > 0i)))];
let _e10416 = (_e10307 + ((_e10335 - _e10307) * _e10227));
let _e10417 = (_e10316 + ((_e10344 - _e10316) * _e10227));
let _e10418 = (_e10325 + ((_e10353 - _e10325) * _e10227));
let _e10434 = (_e10416 + (((_e10363 + ((_e10391 - _e10363) * _e10227)) - _e10416) * _e10233));
let _e10435 = (_e10417 + (((_e10372 + ((_e10400 - _e10372) * _e10227)) - _e10417) * _e10233));
let _e10436 = (_e10418 + (((_e10381 + ((_e10409 - _e10381) * _e10227)) - _e10418) * _e10233));
phi_15161_ = 0i;
phi_15164_ = 0i;
phi_15166_ = _e10154;
phi_15168_ = _e9978;
loop {
let _e10439 = phi_15161_;
let _e10441 = phi_15164_;
let _e10443 = phi_15166_;
let _e10445 = phi_15168_;
local_59 = _e10445;
local_60 = _e10443;
local_61 = _e10445;
local_62 = _e10445;
local_63 = _e10445;
local_64 = _e10445;
local_65 = _e10445;
local_66 = _e10445;
local_67 = _e10443;
local_68 = _e10443;
local_69 = _e10443;
local_70 = _e10443;
local_71 = _e10445;
local_72 = _e10441;
local_73 = _e10445;
local_74 = _e10441;
let _e10446 = (_e10439 < (_e10049 + 1i));
if _e10446 {
if (_e10445 > 1i) {
phi_15183_ = (_e10445 >> bitcast<u32>(1i));
} else {
phi_15183_ = 1i;
}
let _e10453 = phi_15183_;
if (_e10443 > 1i) {
phi_15189_ = (_e10443 >> bitcast<u32>(1i));
} else {
phi_15189_ = 1i;
}
let _e10458 = phi_15189_;
phi_15162_ = (_e10439 + 1i);
phi_15165_ = (_e10441 + (_e10445 * _e10443));
phi_15167_ = _e10458;
phi_15169_ = _e10453;
} else {
phi_15162_ = i32();
phi_15165_ = i32();
phi_15167_ = i32();
phi_15169_ = i32();
}
let _e10461 = phi_15162_;
let _e10463 = phi_15165_;
let _e10465 = phi_15167_;
let _e10467 = phi_15169_;
continue;
continuing {
phi_15161_ = _e10461;
phi_15164_ = _e10463;
phi_15166_ = _e10465;
phi_15168_ = _e10467;
break if !(_e10446);
}
}
let _e10470 = local_59;
let _e10471 = f32(_e10470);
let _e10473 = ((_e10094 * _e10471) - 0.5f);
let _e10475 = local_60;
let _e10476 = f32(_e10475);
let _e10478 = ((_e10149 * _e10476) - 0.5f);
let _e10480 = select(-1f, _e10473, (_e10473 > -1f));
let _e10482 = select(_e10471, _e10480, (_e10480 < _e10471));
let _e10489 = select(0i, select(select(i32(_e10482), i32(-2147483648), (_e10482 < -2147483600f)), 2147483647i, (_e10482 > 2147483500f)), (_e10482 == _e10482));
let _e10493 = (_e10489 - select(0i, 1i, (_e10482 < f32(_e10489))));
let _e10495 = select(-1f, _e10478, (_e10478 > -1f));
let _e10497 = select(_e10476, _e10495, (_e10495 < _e10476));
let _e10504 = select(0i, select(select(i32(_e10497), i32(-2147483648), (_e10497 < -2147483600f)), 2147483647i, (_e10497 > 2147483500f)), (_e10497 == _e10497));
let _e10508 = (_e10504 - select(0i, 1i, (_e10497 < f32(_e10504))));
let _e10510 = (_e10473 - f32(_e10493));
let _e10512 = (_e10478 - f32(_e10508));
let _e10514 = select(0f, _e10512, (_e10512 > 0f));
let _e10516 = select(1f, _e10514, (_e10514 < 1f));
if (_e10493 < 0i) {
let _e10519 = local_61;
phi_15264_ = (_e10493 + _e10519);
} else {
phi_15264_ = _e10493;
}
let _e10522 = phi_15264_;
let _e10524 = local_62;
if (_e10522 >= _e10524) {
let _e10527 = local_63;
phi_15270_ = (_e10522 - _e10527);
} else {
phi_15270_ = _e10522;
}
let _e10530 = phi_15270_;
let _e10531 = (_e10493 + 1i);
if (_e10531 < 0i) {
let _e10534 = local_64;
phi_15277_ = (_e10531 + _e10534);
} else {
phi_15277_ = _e10531;
}
let _e10537 = phi_15277_;
let _e10539 = local_65;
if (_e10537 >= _e10539) {
let _e10542 = local_66;
phi_15283_ = (_e10537 - _e10542);
} else {
phi_15283_ = _e10537;
}
let _e10545 = phi_15283_;
let _e10547 = select(_e10508, 0i, (_e10508 < 0i));
let _e10549 = local_67;
if (_e10547 >= _e10549) {
let _e10552 = local_68;
phi_15294_ = (_e10552 - 1i);
} else {
phi_15294_ = _e10547;
}
let _e10555 = phi_15294_;
let _e10556 = (_e10508 + 1i);
let _e10558 = select(_e10556, 0i, (_e10556 < 0i));
let _e10560 = local_69;
if (_e10558 >= _e10560) {
let _e10563 = local_70;
phi_15306_ = (_e10563 - 1i);
} else {
phi_15306_ = _e10558;
}
let _e10566 = phi_15306_;
let _e10568 = local_71;
let _e10571 = local_72;
let _e10572 = (_e10571 + (_e10555 * _e10568));
let _e10574 = local_73;
let _e10577 = local_74;
let _e10578 = (_e10577 + (_e10566 * _e10574));
let _e10580 = (3i * (_e10572 + _e10530));
let _e10582 = select(_e10299, _e10580, (_e10580 < _e10299));
let _e10588 = global_3.member[bitcast<u32>(select(0i, _e10582, (_e10582 > 0i)))];
let _e10589 = (_e10580 + 1i);
let _e10591 = select(_e10299, _e10589, (_e10589 < _e10299));
let _e10597 = global_3.member[bitcast<u32>(select(0i, _e10591, (_e10591 > 0i)))];
let _e10598 = (_e10580 + 2i);
let _e10600 = select(_e10299, _e10598, (_e10598 < _e10299));
let _e10606 = global_3.member[bitcast<u32>(select(0i, _e10600, (_e10600 > 0i)))];
let _e10608 = (3i * (_e10572 + _e10545));
let _e10610 = select(_e10299, _e10608, (_e10608 < _e10299));
let _e10616 = global_3.member[bitcast<u32>(select(0i, _e10610, (_e10610 > 0i)))];
let _e10617 = (_e10608 + 1i);
let _e10619 = select(_e10299, _e10617, (_e10617 < _e10299));
let _e10625 = global_3.member[bitcast<u32>(select(0i, _e10619, (_e10619 > 0i)))];
let _e10626 = (_e10608 + 2i);
let _e10628 = select(_e10299, _e10626, (_e10626 < _e10299));
let _e10634 = global_3.member[bitcast<u32>(select(0i, _e10628, (_e10628 > 0i)))];
let _e10636 = (3i * (_e10578 + _e10530));
let _e10638 = select(_e10299, _e10636, (_e10636 < _e10299));
let _e10644 = global_3.member[bitcast<u32>(select(0i, _e10638, (_e10638 > 0i)))];
let _e10645 = (_e10636 + 1i);
let _e10647 = select(_e10299, _e10645, (_e10645 < _e10299));
let _e10653 = global_3.member[bitcast<u32>(select(0i, _e10647, (_e10647 > 0i)))];
let _e10654 = (_e10636 + 2i);
let _e10656 = select(_e10299, _e10654, (_e10654 < _e10299));
let _e10662 = global_3.member[bitcast<u32>(select(0i, _e10656, (_e10656 > 0i)))];
let _e10664 = (3i * (_e10578 + _e10545));
let _e10666 = select(_e10299, _e10664, (_e10664 < _e10299));
let _e10672 = global_3.member[bitcast<u32>(select(0i, _e10666, (_e10666 > 0i)))];
let _e10673 = (_e10664 + 1i);
let _e10675 = select(_e10299, _e10673, (_e10673 < _e10299));
let _e10681 = global_3.member[bitcast<u32>(select(0i, _e10675, (_e10675 > 0i)))];
let _e10682 = (_e10664 + 2i);
let _e10684 = select(_e10299, _e10682, (_e10682 < _e10299));
let _e10690 = global_3.member[bitcast<u32>(select(0i, _e10684, (_e10684 > 0i)))];
let _e10697 = (_e10588 + ((_e10616 - _e10588) * _e10510));
let _e10698 = (_e10597 + ((_e10625 - _e10597) * _e10510));
let _e10699 = (_e10606 + ((_e10634 - _e10606) * _e10510));
let _e10722 = (_e10031 - f32(_e10049));
let _e10724 = select(0f, _e10722, (_e10722 > 0f));
let _e10726 = select(1f, _e10724, (_e10724 < 1f));
let _e10736 = global_1.member.member_15.member_11;
phi_15561_ = vec3<f32>(((_e10434 + (((_e10697 + (((_e10644 + ((_e10672 - _e10644) * _e10510)) - _e10697) * _e10516)) - _e10434) * _e10726)) * _e10736), ((_e10435 + (((_e10698 + (((_e10653 + ((_e10681 - _e10653) * _e10510)) - _e10698) * _e10516)) - _e10435) * _e10726)) * _e10736), ((_e10436 + (((_e10699 + (((_e10662 + ((_e10690 - _e10662) * _e10510)) - _e10699) * _e10516)) - _e10436) * _e10726)) * _e10736));
}
let _e10942 = phi_15561_;
phi_15562_ = _e10942;
}
let _e10978 = phi_15562_;
phi_15563_ = _e10978;
}
let _e10980 = phi_15563_;
let _e10984 = global_1.member.member_15.member_12;
let _e10985 = select(1f, _e10984, _e681);
phi_17400_ = type_24(_e8675.member, _e8675.member_1, _e8675.member_2, vec3<f32>((_e8675.member_3.x + (((_e10980.x * _e1400) * _e768) * _e10985)), (_e8675.member_3.y + (((_e10980.y * _e1448) * _e769) * _e10985)), (_e8675.member_3.z + (((_e10980.z * _e1496) * _e770) * _e10985))), _e8675.member_4, _e8675.member_5, _e8675.member_6, _e8675.member_7, _e8675.member_8);
} else {
if _e8570 {
let _e8680 = global_1.member.member_10.member_2;
let _e8688 = global_1.member.member_10.member;
let _e8689 = (_e8688 == 0u);
if _e8689 {
let _e9037 = global_1.member.member_10.member_1;
phi_16119_ = type_26(vec3<f32>(_e9037.member, _e9037.member_1, _e9037.member_2), vec3<f32>(_e8680.member, _e8680.member_1, _e8680.member_2));
} else {
let _e8693 = global_1.member.member_10.member_3;
let _e8698 = (_e8533.member.x - _e8693.member);
let _e8700 = (_e8533.member.y - _e8693.member_1);
let _e8702 = (_e8533.member.z - _e8693.member_2);
let _e8707 = (((_e8698 * _e8698) + (_e8700 * _e8700)) + (_e8702 * _e8702));
let _e8709 = select(1e-12f, _e8707, (_e8707 > 1e-12f));
let _e8710 = (1f / _e8709);
let _e8714 = vec3<f32>((_e8680.member * _e8710), (_e8680.member_1 * _e8710), (_e8680.member_2 * _e8710));
if (_e8688 == 2u) {
let _e8719 = global_1.member.member_10.member_1;
let _e8727 = (((_e8719.member * _e8698) + (_e8719.member_1 * _e8700)) + (_e8719.member_2 * _e8702));
let _e8730 = (1f / select(1e-20f, _e8727, (_e8727 > 1e-20f)));
let _e8735 = global_1.member.member_10.member_4.member;
let _e8744 = ((((_e8735.member * _e8698) + (_e8735.member_1 * _e8700)) + (_e8735.member_2 * _e8702)) * _e8730);
let _e8749 = global_1.member.member_10.member_4.member_1;
let _e8758 = ((((_e8749.member * _e8698) + (_e8749.member_1 * _e8700)) + (_e8749.member_2 * _e8702)) * _e8730);
let _e8763 = global_1.member.member_10.member_4.member_2;
let _e8766 = ((_e8744 * _e8744) + (_e8758 * _e8758));
let _e8775 = global_1.member.member_10.member_4.member_3;
let _e8776 = ((_e8763 - sqrt(select(0f, _e8766, (_e8766 > 0f)))) * _e8775);
let _e8778 = select(0f, _e8776, (_e8776 > 0f));
let _e8780 = select(1f, _e8778, (_e8778 < 1f));
let _e8786 = select(0f, ((_e8780 * _e8780) * (3f - (2f * _e8780))), (_e8727 > 0f));
let _e8791 = global_1.member.member_10.member_4.member_5;
if ((_e8791 > 0u) && (_e8786 > 0f)) {
let _e8796 = (0.5f / _e8763);
let _e8806 = global_1.member.member_10.member_4.member_6;
let _e8807 = bitcast<i32>(_e8806);
local_4 = bitcast<i32>(_e8791);
let _e8808 = local_4;
let _e8810 = f32((_e8808 - 1i));
let _e8812 = f32((_e8807 - 1i));
let _e8813 = local_4;
let _e8816 = (((0.5f + (_e8744 * _e8796)) * f32(_e8813)) - 0.5f);
let _e8818 = select(0f, _e8816, (_e8816 > 0f));
let _e8820 = select(_e8810, _e8818, (_e8818 < _e8810));
let _e8823 = (((0.5f - (_e8758 * _e8796)) * f32(_e8807)) - 0.5f);
let _e8825 = select(0f, _e8823, (_e8823 > 0f));
let _e8827 = select(_e8812, _e8825, (_e8825 < _e8812));
let _e8829 = select(0f, _e8820, (_e8820 > 0f));
let _e8831 = select(_e8810, _e8829, (_e8829 < _e8810));
let _e8838 = select(0i, select(select(i32(_e8831), i32(-2147483648), (_e8831 < -2147483600f)), 2147483647i, (_e8831 > 2147483500f)), (_e8831 == _e8831));
let _e8842 = (_e8838 - select(0i, 1i, (_e8831 < f32(_e8838))));
let _e8844 = select(0f, _e8827, (_e8827 > 0f));
let _e8846 = select(_e8812, _e8844, (_e8844 < _e8812));
let _e8853 = select(0i, select(select(i32(_e8846), i32(-2147483648), (_e8846 < -2147483600f)), 2147483647i, (_e8846 > 2147483500f)), (_e8846 == _e8846));
let _e8857 = (_e8853 - select(0i, 1i, (_e8846 < f32(_e8853))));
let _e8859 = (_e8820 - f32(_e8842));
let _e8861 = (_e8827 - f32(_e8857));
let _e8862 = (_e8842 + 1i);
let _e8863 = local_4;
let _e8865 = select(_e8842, _e8862, (_e8862 < _e8863));
let _e8866 = (_e8857 + 1i);
let _e8868 = select(_e8857, _e8866, (_e8866 < _e8807));
let _e8873 = global_1.member.member_10.member_4.member_4;
let _e8874 = bitcast<i32>(_e8873);
let _e8875 = local_4;
let _e8879 = (_e8874 + (3i * ((_e8857 * _e8875) + _e8842)));
let _e8881 = (bitcast<i32>(_e180) - 1i);
let _e8883 = select(_e8881, _e8879, (_e8879 < _e8881));
let _e8888 = global_3.member[bitcast<u32>(select(0i, _e8883, (_e8883 > 0i)))];
let _e8889 = (_e8879 + 1i);
let _e8891 = select(_e8881, _e8889, (_e8889 < _e8881));
let _e8896 = global_3.member[bitcast<u32>(select(0i, _e8891, (_e8891 > 0i)))];
let _e8897 = (_e8879 + 2i);
let _e8899 = select(_e8881, _e8897, (_e8897 < _e8881));
let _e8904 = global_3.member[bitcast<u32>(select(0i, _e8899, (_e8899 > 0i)))];
let _e8905 = local_4;
let _e8909 = (_e8874 + (3i * ((_e8857 * _e8905) + _e8865)));
let _e8911 = select(_e8881, _e8909, (_e8909 < _e8881));
let _e8916 = global_3.member[bitcast<u32>(select(0i, _e8911, (_e8911 > 0i)))];
let _e8917 = (_e8909 + 1i);
let _e8919 = select(_e8881, _e8917, (_e8917 < _e8881));
let _e8924 = global_3.member[bitcast<u32>(select(0i, _e8919, (_e8919 > 0i)))];
let _e8925 = (_e8909 + 2i);
let _e8927 = select(_e8881, _e8925, (_e8925 < _e8881));
let _e8932 = global_3.member[bitcast<u32>(select(0i, _e8927, (_e8927 > 0i)))];
let _e8933 = local_4;
let _e8937 = (_e8874 + (3i * ((_e8868 * _e8933) + _e8842)));
let _e8939 = select(_e8881, _e8937, (_e8937 < _e8881));
let _e8944 = global_3.member[bitcast<u32>(select(0i, _e8939, (_e8939 > 0i)))];
let _e8945 = (_e8937 + 1i);
let _e8947 = select(_e8881, _e8945, (_e8945 < _e8881));
let _e8952 = global_3.member[bitcast<u32>(select(0i, _e8947, (_e8947 > 0i)))];
let _e8953 = (_e8937 + 2i);
let _e8955 = select(_e8881, _e8953, (_e8953 < _e8881));
let _e8960 = global_3.member[bitcast<u32>(select(0i, _e8955, (_e8955 > 0i)))];
let _e8961 = local_4;
let _e8965 = (_e8874 + (3i * ((_e8868 * _e8961) + _e8865)));
let _e8967 = select(_e8881, _e8965, (_e8965 < _e8881));
let _e8972 = global_3.member[bitcast<u32>(select(0i, _e8967, (_e8967 > 0i)))];
let _e8973 = (_e8965 + 1i);
let _e8975 = select(_e8881, _e8973, (_e8973 < _e8881));
let _e8980 = global_3.member[bitcast<u32>(select(0i, _e8975, (_e8975 > 0i)))];
let _e8981 = (_e8965 + 2i);
let _e8983 = select(_e8881, _e8981, (_e8981 < _e8881));
let _e8988 = global_3.member[bitcast<u32>(select(0i, _e8983, (_e8983 > 0i)))];
let _e8995 = (_e8888 + ((_e8916 - _e8888) * _e8859));
let _e8996 = (_e8896 + ((_e8924 - _e8896) * _e8859));
let _e8997 = (_e8904 + ((_e8932 - _e8904) * _e8859));
phi_16103_ = vec3<f32>(((_e8995 + (((_e8944 + ((_e8972 - _e8944) * _e8859)) - _e8995) * _e8861)) * _e8786), ((_e8996 + (((_e8952 + ((_e8980 - _e8952) * _e8859)) - _e8996) * _e8861)) * _e8786), ((_e8997 + (((_e8960 + ((_e8988 - _e8960) * _e8859)) - _e8997) * _e8861)) * _e8786));
} else {
phi_16103_ = vec3(_e8786);
}
let _e9021 = phi_16103_;
phi_16106_ = (_e8714 * _e9021);
} else {
phi_16106_ = _e8714;
}
let _e9024 = phi_16106_;
let _e9028 = (1f / sqrt(select(0f, _e8709, (_e8709 > 0f))));
phi_16119_ = type_26(vec3<f32>((_e8698 * _e9028), (_e8700 * _e9028), (_e8702 * _e9028)), _e9024);
}
let _e9044 = phi_16119_;
let _e9046 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e9048 = select(_e9046, _e493, (_e493 < _e9046));
let _e9054 = global_8.member[bitcast<u32>(select(0i, _e9048, (_e9048 > 0i)))];
let _e9059 = global_1.member.member_10.member_3;
let _e9064 = (_e9059.member - _e8533.member.x);
let _e9066 = (_e9059.member_1 - _e8533.member.y);
let _e9068 = (_e9059.member_2 - _e8533.member.z);
let _e9073 = (((_e9064 * _e9064) + (_e9066 * _e9066)) + (_e9068 * _e9068));
let _e9077 = select(sqrt(select(0f, _e9073, (_e9073 > 0f))), 1e30f, _e8689);
let _e9079 = -(_e9044.member.x);
let _e9081 = -(_e9044.member.y);
let _e9083 = -(_e9044.member.z);
let _e9091 = (1f / select(_e9079, select(1e-12f, -1e-12f, (_e9079 < 0f)), (bitcast<f32>((bitcast<u32>(_e9079) & 2147483647u)) < 1e-12f)));
let _e9099 = (1f / select(_e9081, select(1e-12f, -1e-12f, (_e9081 < 0f)), (bitcast<f32>((bitcast<u32>(_e9081) & 2147483647u)) < 1e-12f)));
let _e9107 = (1f / select(_e9083, select(1e-12f, -1e-12f, (_e9083 < 0f)), (bitcast<f32>((bitcast<u32>(_e9083) & 2147483647u)) < 1e-12f)));
let _e9109 = ((_e798.member - _e8533.member.x) * _e9091);
let _e9111 = ((_e805.member - _e8533.member.x) * _e9091);
let _e9113 = ((_e798.member_1 - _e8533.member.y) * _e9099);
let _e9115 = ((_e805.member_1 - _e8533.member.y) * _e9099);
let _e9117 = ((_e798.member_2 - _e8533.member.z) * _e9107);
let _e9119 = ((_e805.member_2 - _e8533.member.z) * _e9107);
let _e9121 = select(_e9111, _e9109, (_e9109 < _e9111));
let _e9123 = select(_e9115, _e9113, (_e9113 < _e9115));
let _e9125 = select(_e9123, _e9121, (_e9121 > _e9123));
let _e9127 = select(_e9119, _e9117, (_e9117 < _e9119));
let _e9129 = select(_e9127, _e9125, (_e9125 > _e9127));
let _e9131 = select(_e9111, _e9109, (_e9109 > _e9111));
let _e9133 = select(_e9115, _e9113, (_e9113 > _e9115));
let _e9135 = select(_e9133, _e9131, (_e9131 < _e9133));
let _e9137 = select(_e9119, _e9117, (_e9117 > _e9119));
let _e9139 = select(_e9137, _e9135, (_e9135 < _e9137));
let _e9141 = select(0f, _e9129, (_e9129 > 0f));
let _e9143 = select(_e9077, _e9139, (_e9139 < _e9077));
let _e9144 = (_e9143 > _e9141);
let _e9145 = select(0f, _e9141, _e9144);
let _e9147 = (select(0f, _e9143, _e9144) - _e9145);
if _e853 {
phi_17047_ = _e9147;
} else {
let _e9149 = (_e9147 / f32(_e852));
phi_16328_ = 0u;
phi_16331_ = 0f;
loop {
let _e9151 = phi_16328_;
let _e9153 = phi_16331_;
local_82 = _e9153;
let _e9156 = ((_e9151 < _e852) && (_e9147 > 0f));
if _e9156 {
let _e9159 = (_e9145 + (_e9149 * f32(_e9151)));
let _e9160 = (_e9159 + _e9149);
let _e9162 = (0.5f * (_e9159 + _e9160));
let _e9163 = (_e9160 - _e9159);
let _e9164 = (0.28867513f * _e9163);
let _e9165 = (_e9162 - _e9164);
let _e9175 = global_1.member.member_13.member_7;
let _e9176 = bitcast<i32>(_e9175);
let _e9180 = global_1.member.member_13.member_8;
let _e9181 = bitcast<i32>(_e9180);
let _e9185 = global_1.member.member_13.member_9;
let _e9186 = bitcast<i32>(_e9185);
let _e9187 = f32(_e9176);
let _e9189 = (_e805.member - _e798.member);
let _e9192 = (((((_e8533.member.x + (_e9079 * _e9165)) - _e798.member) / _e9189) * _e9187) - 0.5f);
let _e9193 = (_e9187 - 1f);
let _e9195 = select(0f, _e9192, (_e9192 > 0f));
let _e9197 = select(_e9193, _e9195, (_e9195 < _e9193));
let _e9198 = f32(_e9181);
let _e9200 = (_e805.member_1 - _e798.member_1);
let _e9203 = (((((_e8533.member.y + (_e9081 * _e9165)) - _e798.member_1) / _e9200) * _e9198) - 0.5f);
let _e9204 = (_e9198 - 1f);
let _e9206 = select(0f, _e9203, (_e9203 > 0f));
let _e9208 = select(_e9204, _e9206, (_e9206 < _e9204));
let _e9209 = f32(_e9186);
let _e9211 = (_e805.member_2 - _e798.member_2);
let _e9214 = (((((_e8533.member.z + (_e9083 * _e9165)) - _e798.member_2) / _e9211) * _e9209) - 0.5f);
let _e9215 = (_e9209 - 1f);
let _e9217 = select(0f, _e9214, (_e9214 > 0f));
let _e9219 = select(_e9215, _e9217, (_e9217 < _e9215));
let _e9221 = select(0f, _e9197, (_e9197 > 0f));
let _e9223 = select(1e6f, _e9221, (_e9221 < 1e6f));
let _e9230 = select(0i, select(select(i32(_e9223), i32(-2147483648), (_e9223 < -2147483600f)), 2147483647i, (_e9223 > 2147483500f)), (_e9223 == _e9223));
let _e9234 = (_e9230 - select(0i, 1i, (_e9223 < f32(_e9230))));
let _e9236 = select(0f, _e9208, (_e9208 > 0f));
let _e9238 = select(1e6f, _e9236, (_e9236 < 1e6f));
let _e9245 = select(0i, select(select(i32(_e9238), i32(-2147483648), (_e9238 < -2147483600f)), 2147483647i, (_e9238 > 2147483500f)), (_e9238 == _e9238));
let _e9249 = (_e9245 - select(0i, 1i, (_e9238 < f32(_e9245))));
let _e9251 = select(0f, _e9219, (_e9219 > 0f));
let _e9253 = select(1e6f, _e9251, (_e9251 < 1e6f));
let _e9260 = select(0i, select(select(i32(_e9253), i32(-2147483648), (_e9253 < -2147483600f)), 2147483647i, (_e9253 > 2147483500f)), (_e9253 == _e9253));
let _e9264 = (_e9260 - select(0i, 1i, (_e9253 < f32(_e9260))));
let _e9268 = (_e9208 - f32(_e9249));
let _e9270 = (_e9219 - f32(_e9264));
local_2 = (_e9197 - f32(_e9234));
let _e9271 = (_e9234 + 1i);
let _e9273 = select(_e9271, 0i, (_e9271 < 0i));
if (_e9273 >= _e9176) {
phi_16469_ = (_e9176 - 1i);
} else {
phi_16469_ = _e9273;
}
let _e9277 = phi_16469_;
local_3 = (_e9277 - _e9234);
let _e9279 = (_e9249 + 1i);
let _e9281 = select(_e9279, 0i, (_e9279 < 0i));
if (_e9281 >= _e9181) {
phi_16482_ = (_e9181 - 1i);
} else {
phi_16482_ = _e9281;
}
let _e9285 = phi_16482_;
let _e9287 = ((_e9285 - _e9249) * _e9176);
let _e9288 = (_e9264 + 1i);
let _e9290 = select(_e9288, 0i, (_e9288 < 0i));
if (_e9290 >= _e9186) {
phi_16496_ = (_e9186 - 1i);
} else {
phi_16496_ = _e9290;
}
let _e9294 = phi_16496_;
let _e9301 = global_1.member.member_13.member_10;
let _e9302 = bitcast<i32>(_e9301);
let _e9307 = ((_e9302 + (((_e9264 * _e9181) + _e9249) * _e9176)) + _e9234);
let _e9309 = select(_e8556, _e9307, (_e9307 < _e8556));
let _e9314 = global_7.member[bitcast<u32>(select(0i, _e9309, (_e9309 > 0i)))];
let _e9315 = local_2;
let _e9318 = local_3;
let _e9319 = (_e9307 + _e9318);
let _e9321 = select(_e8556, _e9319, (_e9319 < _e8556));
let _e9326 = global_7.member[bitcast<u32>(select(0i, _e9321, (_e9321 > 0i)))];
let _e9327 = local_2;
let _e9330 = (1f - _e9268);
let _e9332 = (_e9307 + _e9287);
let _e9334 = select(_e8556, _e9332, (_e9332 < _e8556));
let _e9339 = global_7.member[bitcast<u32>(select(0i, _e9334, (_e9334 > 0i)))];
let _e9340 = local_2;
let _e9343 = local_3;
let _e9344 = (_e9332 + _e9343);
let _e9346 = select(_e8556, _e9344, (_e9344 < _e8556));
let _e9351 = global_7.member[bitcast<u32>(select(0i, _e9346, (_e9346 > 0i)))];
let _e9352 = local_2;
let _e9357 = (_e9307 + (((_e9294 - _e9264) * _e9176) * _e9181));
let _e9359 = select(_e8556, _e9357, (_e9357 < _e8556));
let _e9364 = global_7.member[bitcast<u32>(select(0i, _e9359, (_e9359 > 0i)))];
let _e9365 = local_2;
let _e9368 = local_3;
let _e9369 = (_e9357 + _e9368);
let _e9371 = select(_e8556, _e9369, (_e9369 < _e8556));
let _e9376 = global_7.member[bitcast<u32>(select(0i, _e9371, (_e9371 > 0i)))];
let _e9377 = local_2;
let _e9381 = (_e9357 + _e9287);
let _e9383 = select(_e8556, _e9381, (_e9381 < _e8556));
let _e9388 = global_7.member[bitcast<u32>(select(0i, _e9383, (_e9383 > 0i)))];
let _e9389 = local_2;
let _e9392 = local_3;
let _e9393 = (_e9381 + _e9392);
let _e9395 = select(_e8556, _e9393, (_e9393 < _e8556));
let _e9400 = global_7.member[bitcast<u32>(select(0i, _e9395, (_e9395 > 0i)))];
let _e9401 = local_2;
let _e9410 = (_e9162 + _e9164);
let _e9420 = (((((_e8533.member.x + (_e9079 * _e9410)) - _e798.member) / _e9189) * _e9187) - 0.5f);
let _e9422 = select(0f, _e9420, (_e9420 > 0f));
let _e9424 = select(_e9193, _e9422, (_e9422 < _e9193));
let _e9428 = (((((_e8533.member.y + (_e9081 * _e9410)) - _e798.member_1) / _e9200) * _e9198) - 0.5f);
let _e9430 = select(0f, _e9428, (_e9428 > 0f));
let _e9432 = select(_e9204, _e9430, (_e9430 < _e9204));
let _e9436 = (((((_e8533.member.z + (_e9083 * _e9410)) - _e798.member_2) / _e9211) * _e9209) - 0.5f);
let _e9438 = select(0f, _e9436, (_e9436 > 0f));
let _e9440 = select(_e9215, _e9438, (_e9438 < _e9215));
let _e9442 = select(0f, _e9424, (_e9424 > 0f));
let _e9444 = select(1e6f, _e9442, (_e9442 < 1e6f));
let _e9451 = select(0i, select(select(i32(_e9444), i32(-2147483648), (_e9444 < -2147483600f)), 2147483647i, (_e9444 > 2147483500f)), (_e9444 == _e9444));
let _e9455 = (_e9451 - select(0i, 1i, (_e9444 < f32(_e9451))));
let _e9457 = select(0f, _e9432, (_e9432 > 0f));
let _e9459 = select(1e6f, _e9457, (_e9457 < 1e6f));
let _e9466 = select(0i, select(select(i32(_e9459), i32(-2147483648), (_e9459 < -2147483600f)), 2147483647i, (_e9459 > 2147483500f)), (_e9459 == _e9459));
let _e9470 = (_e9466 - select(0i, 1i, (_e9459 < f32(_e9466))));
let _e9472 = select(0f, _e9440, (_e9440 > 0f));
let _e9474 = select(1e6f, _e9472, (_e9472 < 1e6f));
let _e9481 = select(0i, select(select(i32(_e9474), i32(-2147483648), (_e9474 < -2147483600f)), 2147483647i, (_e9474 > 2147483500f)), (_e9474 == _e9474));
let _e9485 = (_e9481 - select(0i, 1i, (_e9474 < f32(_e9481))));
let _e9489 = (_e9432 - f32(_e9470));
let _e9491 = (_e9440 - f32(_e9485));
local = (_e9424 - f32(_e9455));
let _e9492 = (_e9455 + 1i);
let _e9494 = select(_e9492, 0i, (_e9492 < 0i));
if (_e9494 >= _e9176) {
phi_16815_ = (_e9176 - 1i);
} else {
phi_16815_ = _e9494;
}
let _e9498 = phi_16815_;
local_1 = (_e9498 - _e9455);
let _e9500 = (_e9470 + 1i);
let _e9502 = select(_e9500, 0i, (_e9500 < 0i));
if (_e9502 >= _e9181) {
phi_16828_ = (_e9181 - 1i);
} else {
phi_16828_ = _e9502;
}
let _e9506 = phi_16828_;
let _e9508 = ((_e9506 - _e9470) * _e9176);
let _e9509 = (_e9485 + 1i);
let _e9511 = select(_e9509, 0i, (_e9509 < 0i));
if (_e9511 >= _e9186) {
phi_16842_ = (_e9186 - 1i);
} else {
phi_16842_ = _e9511;
}
let _e9515 = phi_16842_;
let _e9523 = ((_e9302 + (((_e9485 * _e9181) + _e9470) * _e9176)) + _e9455);
let _e9525 = select(_e8556, _e9523, (_e9523 < _e8556));
let _e9530 = global_7.member[bitcast<u32>(select(0i, _e9525, (_e9525 > 0i)))];
let _e9531 = local;
let _e9534 = local_1;
let _e9535 = (_e9523 + _e9534);
let _e9537 = select(_e8556, _e9535, (_e9535 < _e8556));
let _e9542 = global_7.member[bitcast<u32>(select(0i, _e9537, (_e9537 > 0i)))];
let _e9543 = local;
let _e9546 = (1f - _e9489);
let _e9548 = (_e9523 + _e9508);
let _e9550 = select(_e8556, _e9548, (_e9548 < _e8556));
let _e9555 = global_7.member[bitcast<u32>(select(0i, _e9550, (_e9550 > 0i)))];
let _e9556 = local;
let _e9559 = local_1;
let _e9560 = (_e9548 + _e9559);
let _e9562 = select(_e8556, _e9560, (_e9560 < _e8556));
let _e9567 = global_7.member[bitcast<u32>(select(0i, _e9562, (_e9562 > 0i)))];
let _e9568 = local;
let _e9573 = (_e9523 + (((_e9515 - _e9485) * _e9176) * _e9181));
let _e9575 = select(_e8556, _e9573, (_e9573 < _e8556));
let _e9580 = global_7.member[bitcast<u32>(select(0i, _e9575, (_e9575 > 0i)))];
let _e9581 = local;
let _e9584 = local_1;
let _e9585 = (_e9573 + _e9584);
let _e9587 = select(_e8556, _e9585, (_e9585 < _e8556));
let _e9592 = global_7.member[bitcast<u32>(select(0i, _e9587, (_e9587 > 0i)))];
let _e9593 = local;
let _e9597 = (_e9573 + _e9508);
let _e9599 = select(_e8556, _e9597, (_e9597 < _e8556));
let _e9604 = global_7.member[bitcast<u32>(select(0i, _e9599, (_e9599 > 0i)))];
let _e9605 = local;
let _e9608 = local_1;
let _e9609 = (_e9597 + _e9608);
let _e9611 = select(_e8556, _e9609, (_e9609 < _e8556));
let _e9616 = global_7.member[bitcast<u32>(select(0i, _e9611, (_e9611 > 0i)))];
let _e9617 = local;
phi_16329_ = (_e9151 + 1u);
phi_16332_ = (_e9153 + ((0.5f * (((((((_e9314 * (1f - _e9315)) + (_e9326 * _e9327)) * _e9330) + (((_e9339 * (1f - _e9340)) + (_e9351 * _e9352)) * _e9268)) * (1f - _e9270)) + (((((_e9364 * (1f - _e9365)) + (_e9376 * _e9377)) * _e9330) + (((_e9388 * (1f - _e9389)) + (_e9400 * _e9401)) * _e9268)) * _e9270)) + ((((((_e9530 * (1f - _e9531)) + (_e9542 * _e9543)) * _e9546) + (((_e9555 * (1f - _e9556)) + (_e9567 * _e9568)) * _e9489)) * (1f - _e9491)) + (((((_e9580 * (1f - _e9581)) + (_e9592 * _e9593)) * _e9546) + (((_e9604 * (1f - _e9605)) + (_e9616 * _e9617)) * _e9489)) * _e9491)))) * _e9163));
} else {
phi_16329_ = u32();
phi_16332_ = f32();
}
let _e9632 = phi_16329_;
let _e9634 = phi_16332_;
continue;
continuing {
phi_16328_ = _e9632;
phi_16331_ = _e9634;
break if !(_e9156);
}
}
let _e11232 = local_82;
phi_17047_ = _e11232;
}
let _e9637 = phi_17047_;
let _e9639 = -((_e1349.member * _e9637));
let _e9641 = select(-87f, _e9639, (_e9639 > -87f));
let _e9643 = select(88f, _e9641, (_e9641 < 88f));
let _e9645 = ((_e9643 * 1.442695f) + 0.5f);
let _e9647 = select(-127f, _e9645, (_e9645 > -127f));
let _e9649 = select(128f, _e9647, (_e9647 < 128f));
let _e9656 = select(0i, select(select(i32(_e9649), i32(-2147483648), (_e9649 < -2147483600f)), 2147483647i, (_e9649 > 2147483500f)), (_e9649 == _e9649));
let _e9660 = (_e9656 - select(0i, 1i, (_e9649 < f32(_e9656))));
let _e9661 = f32(_e9660);
let _e9665 = ((_e9643 - (_e9661 * 0.6933594f)) - (_e9661 * -2.1219444e-4f));
let _e9687 = -((_e1349.member_1 * _e9637));
let _e9689 = select(-87f, _e9687, (_e9687 > -87f));
let _e9691 = select(88f, _e9689, (_e9689 < 88f));
let _e9693 = ((_e9691 * 1.442695f) + 0.5f);
let _e9695 = select(-127f, _e9693, (_e9693 > -127f));
let _e9697 = select(128f, _e9695, (_e9695 < 128f));
let _e9704 = select(0i, select(select(i32(_e9697), i32(-2147483648), (_e9697 < -2147483600f)), 2147483647i, (_e9697 > 2147483500f)), (_e9697 == _e9697));
let _e9708 = (_e9704 - select(0i, 1i, (_e9697 < f32(_e9704))));
let _e9709 = f32(_e9708);
let _e9713 = ((_e9691 - (_e9709 * 0.6933594f)) - (_e9709 * -2.1219444e-4f));
let _e9735 = -((_e1349.member_2 * _e9637));
let _e9737 = select(-87f, _e9735, (_e9735 > -87f));
let _e9739 = select(88f, _e9737, (_e9737 < 88f));
let _e9741 = ((_e9739 * 1.442695f) + 0.5f);
let _e9743 = select(-127f, _e9741, (_e9741 > -127f));
let _e9745 = select(128f, _e9743, (_e9743 < 128f));
let _e9752 = select(0i, select(select(i32(_e9745), i32(-2147483648), (_e9745 < -2147483600f)), 2147483647i, (_e9745 > 2147483500f)), (_e9745 == _e9745));
let _e9756 = (_e9752 - select(0i, 1i, (_e9745 < f32(_e9752))));
let _e9757 = f32(_e9756);
let _e9761 = ((_e9739 - (_e9757 * 0.6933594f)) - (_e9757 * -2.1219444e-4f));
let _e9782 = (1f - _e9054);
let _e9794 = (((_e8533.member_1.x * _e512) + (_e8533.member_1.y * _e523)) + (_e8533.member_1.z * _e534));
let _e9796 = select(1f, -1f, (_e9794 > 0f));
let _e9808 = select(_e9796, -(_e9796), ((((_e8533.member_2.x * _e8533.member_1.x) + (_e8533.member_2.y * _e8533.member_1.y)) + (_e8533.member_2.z * _e8533.member_1.z)) < 0f));
let _e9809 = (_e8533.member_2.x * _e9808);
let _e9810 = (_e8533.member_2.y * _e9808);
let _e9811 = (_e8533.member_2.z * _e9808);
let _e9820 = ((((_e9809 * _e512) + (_e9810 * _e523)) + (_e9811 * _e534)) > 0f);
let _e9829 = -((((select(_e9809, (_e8533.member_1.x * _e9796), _e9820) * _e9044.member.x) + (select(_e9810, (_e8533.member_1.y * _e9796), _e9820) * _e9044.member.y)) + (select(_e9811, (_e8533.member_1.z * _e9796), _e9820) * _e9044.member.z)));
let _e9839 = -(_e9829);
let _e9844 = select((select(0f, _e9839, (_e9839 > 0f)) * _e8533.member_4), select(0f, _e9829, (_e9829 > 0f)), (((((_e8533.member_1.x * _e9044.member.x) + (_e8533.member_1.y * _e9044.member.y)) + (_e8533.member_1.z * _e9044.member.z)) * _e9794) > 0f));
let _e9858 = global_1.member.member_16;
phi_17399_ = type_24(_e8675.member, _e8675.member_1, _e8675.member_2, vec3<f32>((_e8675.member_3.x + (((_e8533.member_3.x * (((_e9044.member_1.x * (((1f + (_e9665 * (1f + (_e9665 * (0.5f + (_e9665 * (0.16666667f + (_e9665 * (0.041666668f + (_e9665 * (0.008333334f + (_e9665 * (0.001388889f + (_e9665 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9660 + 127i)) << bitcast<u32>(23i)))) * _e9782)) * _e9844) + _e9858.member)) * _e1400) * _e768)), (_e8675.member_3.y + (((_e8533.member_3.y * (((_e9044.member_1.y * (((1f + (_e9713 * (1f + (_e9713 * (0.5f + (_e9713 * (0.16666667f + (_e9713 * (0.041666668f + (_e9713 * (0.008333334f + (_e9713 * (0.001388889f + (_e9713 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9708 + 127i)) << bitcast<u32>(23i)))) * _e9782)) * _e9844) + _e9858.member_1)) * _e1448) * _e769)), (_e8675.member_3.z + (((_e8533.member_3.z * (((_e9044.member_1.z * (((1f + (_e9761 * (1f + (_e9761 * (0.5f + (_e9761 * (0.16666667f + (_e9761 * (0.041666668f + (_e9761 * (0.008333334f + (_e9761 * (0.001388889f + (_e9761 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9756 + 127i)) << bitcast<u32>(23i)))) * _e9782)) * _e9844) + _e9858.member_2)) * _e1496) * _e770))), _e8675.member_4, _e8675.member_5, _e8675.member_6, _e8675.member_7, _e8675.member_8);
} else {
phi_17399_ = _e8675;
}
let _e9897 = phi_17399_;
phi_17400_ = _e9897;
}
let _e11018 = phi_17400_;
global_6.member[_e203] = _e11018.member;
global_6.member[_e215] = _e11018.member_1;
global_6.member[_e226] = _e11018.member_2;
global_6.member[_e237] = _e11018.member_3.x;
global_6.member[_e248] = _e11018.member_3.y;
global_6.member[_e259] = _e11018.member_3.z;
global_6.member[_e270] = _e11018.member_4.x;
global_6.member[_e281] = _e11018.member_4.y;
global_6.member[_e292] = _e11018.member_4.z;
global_6.member[_e303] = _e11018.member_5.x;
global_6.member[_e314] = _e11018.member_5.y;
global_6.member[_e325] = _e11018.member_5.z;
global_6.member[_e336] = _e11018.member_6.x;
global_6.member[_e347] = _e11018.member_6.y;
global_6.member[_e358] = _e11018.member_6.z;
global_6.member[_e369] = _e11018.member_7;
global_6.member[_e380] = _e11018.member_8.x;
global_6.member[_e391] = _e11018.member_8.y;
global_6.member[_e402] = _e11018.member_8.z;
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
