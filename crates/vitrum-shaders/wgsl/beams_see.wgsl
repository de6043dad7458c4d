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
member: f32,
member_1: f32,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: vec3<f32>,
member_6: vec3<f32>,
member_7: vec3<f32>,
member_8: f32,
member_9: vec3<f32>,
}
struct type_27 {
member: vec3<f32>,
member_1: vec3<f32>,
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
struct type_29 {
member: f32,
member_1: f32,
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
@group(0) @binding(4)
var<storage> global_5: type_15;
@group(0) @binding(7)
var<storage, read_write> global_6: type_15;
@group(0) @binding(5)
var<storage> global_7: type_15;
@group(0) @binding(6)
var<storage> global_8: type_15;
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
var phi_2079_: u32;
var phi_2082_: f32;
var phi_2217_: i32;
var phi_2230_: i32;
var phi_2244_: i32;
var phi_2560_: i32;
var phi_2573_: i32;
var phi_2587_: i32;
var phi_2080_: u32;
var phi_2083_: f32;
var phi_2792_: f32;
var phi_3155_: type_29;
var phi_3159_: type_29;
var phi_3273_: i32;
var phi_3425_: u32;
var phi_3428_: f32;
var phi_3563_: i32;
var phi_3576_: i32;
var phi_3590_: i32;
var phi_3906_: i32;
var phi_3919_: i32;
var phi_3933_: i32;
var phi_3426_: u32;
var phi_3429_: f32;
var phi_4138_: f32;
var phi_4140_: vec3<f32>;
var phi_4143_: i32;
var phi_4145_: f32;
var phi_4319_: i32;
var phi_4332_: i32;
var phi_4346_: i32;
var phi_4546_: f32;
var phi_4709_: i32;
var phi_4722_: i32;
var phi_4736_: i32;
var phi_4936_: f32;
var phi_5098_: i32;
var phi_5111_: i32;
var phi_5125_: i32;
var phi_5325_: f32;
var phi_5487_: i32;
var phi_5500_: i32;
var phi_5514_: i32;
var phi_5714_: f32;
var phi_6305_: vec3<f32>;
var phi_6308_: vec3<f32>;
var phi_6321_: type_27;
var phi_6517_: u32;
var phi_6520_: f32;
var phi_6658_: i32;
var phi_6671_: i32;
var phi_6685_: i32;
var phi_7004_: i32;
var phi_7017_: i32;
var phi_7031_: i32;
var phi_6518_: u32;
var phi_6521_: f32;
var phi_7236_: f32;
var phi_7597_: f32;
var phi_8151_: vec3<f32>;
var phi_8154_: vec3<f32>;
var phi_8167_: type_27;
var phi_8363_: u32;
var phi_8366_: f32;
var phi_8504_: i32;
var phi_8517_: i32;
var phi_8531_: i32;
var phi_8850_: i32;
var phi_8863_: i32;
var phi_8877_: i32;
var phi_8364_: u32;
var phi_8367_: f32;
var phi_9082_: f32;
var phi_9443_: f32;
var phi_10000_: vec3<f32>;
var phi_10003_: vec3<f32>;
var phi_10016_: type_27;
var phi_10212_: u32;
var phi_10215_: f32;
var phi_10353_: i32;
var phi_10366_: i32;
var phi_10380_: i32;
var phi_10699_: i32;
var phi_10712_: i32;
var phi_10726_: i32;
var phi_10213_: u32;
var phi_10216_: f32;
var phi_10931_: f32;
var phi_11292_: f32;
var phi_11846_: vec3<f32>;
var phi_11849_: vec3<f32>;
var phi_11862_: type_27;
var phi_12058_: u32;
var phi_12061_: f32;
var phi_12199_: i32;
var phi_12212_: i32;
var phi_12226_: i32;
var phi_12545_: i32;
var phi_12558_: i32;
var phi_12572_: i32;
var phi_12059_: u32;
var phi_12062_: f32;
var phi_12777_: f32;
var phi_13138_: f32;
var phi_4141_: vec3<f32>;
var phi_4144_: i32;
var phi_4146_: f32;
var phi_13199_: vec3<f32>;
var phi_13214_: type_26;
var phi_13949_: type_28;
var phi_14013_: bool;
var phi_14133_: type_26;
var phi_16162_: vec3<f32>;
var phi_16165_: vec3<f32>;
var phi_16178_: type_27;
var phi_16387_: u32;
var phi_16390_: f32;
var phi_16528_: i32;
var phi_16541_: i32;
var phi_16555_: i32;
var phi_16874_: i32;
var phi_16887_: i32;
var phi_16901_: i32;
var phi_16388_: u32;
var phi_16391_: f32;
var phi_17106_: f32;
var phi_17610_: type_26;
var phi_14839_: i32;
var phi_14842_: i32;
var phi_14844_: i32;
var phi_14846_: i32;
var phi_14861_: i32;
var phi_14867_: i32;
var phi_14840_: i32;
var phi_14843_: i32;
var phi_14845_: i32;
var phi_14847_: i32;
var local_43: i32;
var local_44: i32;
var local_45: i32;
var phi_14942_: i32;
var local_46: i32;
var local_47: i32;
var phi_14948_: i32;
var local_48: i32;
var phi_14955_: i32;
var local_49: i32;
var local_50: i32;
var phi_14961_: i32;
var local_51: i32;
var local_52: i32;
var phi_14972_: i32;
var local_53: i32;
var local_54: i32;
var phi_14984_: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var phi_15220_: i32;
var phi_15223_: i32;
var phi_15225_: i32;
var phi_15227_: i32;
var phi_15242_: i32;
var phi_15248_: i32;
var phi_15221_: i32;
var phi_15224_: i32;
var phi_15226_: i32;
var phi_15228_: i32;
var local_59: i32;
var local_60: i32;
var local_61: i32;
var phi_15323_: i32;
var local_62: i32;
var local_63: i32;
var phi_15329_: i32;
var local_64: i32;
var phi_15336_: i32;
var local_65: i32;
var local_66: i32;
var phi_15342_: i32;
var local_67: i32;
var local_68: i32;
var phi_15353_: i32;
var local_69: i32;
var local_70: i32;
var phi_15365_: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var phi_15620_: vec3<f32>;
var phi_14237_: vec3<f32>;
var phi_15621_: vec3<f32>;
var phi_15622_: vec3<f32>;
var phi_17611_: type_26;
var local_75: f32;
var local_76: f32;
var local_77: f32;
var local_78: f32;
var local_79: f32;
var local_80: f32;
var local_81: vec3<f32>;
var local_82: f32;
let _e174 = global;
let _e181 = arrayLength((&global_3.member));
let _e183 = arrayLength((&global_4.member));
let _e188 = arrayLength((&global_7.member));
let _e195 = global_1.member.member;
if (_e174.x < _e195.member) {
if (_e174.y < _e195.member_1) {
let _e202 = (_e195.member * _e195.member_1);
let _e204 = ((_e174.y * _e195.member) + _e174.x);
let _e205 = bitcast<i32>(_e204);
let _e207 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e209 = select(_e207, _e205, (_e205 < _e207));
let _e215 = global_6.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e216 = (_e202 + _e204);
let _e217 = bitcast<i32>(_e216);
let _e219 = select(_e207, _e217, (_e217 < _e207));
let _e225 = global_6.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e227 = ((2u * _e202) + _e204);
let _e228 = bitcast<i32>(_e227);
let _e230 = select(_e207, _e228, (_e228 < _e207));
let _e236 = global_6.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e238 = ((3u * _e202) + _e204);
let _e239 = bitcast<i32>(_e238);
let _e241 = select(_e207, _e239, (_e239 < _e207));
let _e247 = global_6.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e249 = ((4u * _e202) + _e204);
let _e250 = bitcast<i32>(_e249);
let _e252 = select(_e207, _e250, (_e250 < _e207));
let _e258 = global_6.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e260 = ((5u * _e202) + _e204);
let _e261 = bitcast<i32>(_e260);
let _e263 = select(_e207, _e261, (_e261 < _e207));
let _e269 = global_6.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e271 = ((6u * _e202) + _e204);
let _e272 = bitcast<i32>(_e271);
let _e274 = select(_e207, _e272, (_e272 < _e207));
let _e280 = global_6.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e282 = ((7u * _e202) + _e204);
let _e283 = bitcast<i32>(_e282);
let _e285 = select(_e207, _e283, (_e283 < _e207));
let _e291 = global_6.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e293 = ((8u * _e202) + _e204);
let _e294 = bitcast<i32>(_e293);
let _e296 = select(_e207, _e294, (_e294 < _e207));
let _e302 = global_6.member[bitcast<u32>(select(0i, _e296, (_e296 > 0i)))];
let _e304 = ((9u * _e202) + _e204);
let _e305 = bitcast<i32>(_e304);
let _e307 = select(_e207, _e305, (_e305 < _e207));
let _e313 = global_6.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e315 = ((10u * _e202) + _e204);
let _e316 = bitcast<i32>(_e315);
let _e318 = select(_e207, _e316, (_e316 < _e207));
let _e324 = global_6.member[bitcast<u32>(select(0i, _e318, (_e318 > 0i)))];
let _e326 = ((11u * _e202) + _e204);
let _e327 = bitcast<i32>(_e326);
let _e329 = select(_e207, _e327, (_e327 < _e207));
let _e335 = global_6.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e337 = ((12u * _e202) + _e204);
let _e338 = bitcast<i32>(_e337);
let _e340 = select(_e207, _e338, (_e338 < _e207));
let _e346 = global_6.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e348 = ((13u * _e202) + _e204);
let _e349 = bitcast<i32>(_e348);
let _e351 = select(_e207, _e349, (_e349 < _e207));
let _e357 = global_6.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e359 = ((14u * _e202) + _e204);
let _e360 = bitcast<i32>(_e359);
let _e362 = select(_e207, _e360, (_e360 < _e207));
let _e368 = global_6.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
let _e370 = ((15u * _e202) + _e204);
let _e371 = bitcast<i32>(_e370);
let _e373 = select(_e207, _e371, (_e371 < _e207));
let _e379 = global_6.member[bitcast<u32>(select(0i, _e373, (_e373 > 0i)))];
let _e381 = ((16u * _e202) + _e204);
let _e382 = bitcast<i32>(_e381);
let _e384 = select(_e207, _e382, (_e382 < _e207));
let _e390 = global_6.member[bitcast<u32>(select(0i, _e384, (_e384 > 0i)))];
let _e392 = ((17u * _e202) + _e204);
let _e393 = bitcast<i32>(_e392);
let _e395 = select(_e207, _e393, (_e393 < _e207));
let _e401 = global_6.member[bitcast<u32>(select(0i, _e395, (_e395 > 0i)))];
let _e403 = ((18u * _e202) + _e204);
let _e404 = bitcast<i32>(_e403);
let _e406 = select(_e207, _e404, (_e404 < _e207));
let _e412 = global_6.member[bitcast<u32>(select(0i, _e406, (_e406 > 0i)))];
let _e414 = ((19u * _e202) + _e204);
let _e415 = bitcast<i32>(_e414);
let _e417 = select(_e207, _e415, (_e415 < _e207));
let _e423 = global_6.member[bitcast<u32>(select(0i, _e417, (_e417 > 0i)))];
let _e425 = ((20u * _e202) + _e204);
let _e426 = bitcast<i32>(_e425);
let _e428 = select(_e207, _e426, (_e426 < _e207));
let _e434 = global_6.member[bitcast<u32>(select(0i, _e428, (_e428 > 0i)))];
let _e436 = ((21u * _e202) + _e204);
let _e437 = bitcast<i32>(_e436);
let _e439 = select(_e207, _e437, (_e437 < _e207));
let _e445 = global_6.member[bitcast<u32>(select(0i, _e439, (_e439 > 0i)))];
let _e449 = global_1.member.member.member;
let _e453 = global_1.member.member.member_1;
let _e454 = (_e449 * _e453);
local_41 = bitcast<i32>(_e454);
let _e457 = ((_e174.y * _e449) + _e174.x);
let _e458 = bitcast<i32>(_e457);
local_42 = _e458;
let _e459 = local_41;
let _e461 = local_42;
let _e462 = ((29i * _e459) + _e461);
let _e464 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e466 = select(_e464, _e462, (_e462 < _e464));
let _e471 = global_2.member[bitcast<u32>(select(0i, _e466, (_e466 > 0i)))];
let _e473 = local_41;
let _e475 = local_42;
let _e476 = ((36i * _e473) + _e475);
let _e478 = select(_e464, _e476, (_e476 < _e464));
let _e483 = global_2.member[bitcast<u32>(select(0i, _e478, (_e478 > 0i)))];
let _e494 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e471 == 2f) && (select(0i, select(select(i32(_e483), i32(-2147483648), (_e483 < -2147483600f)), 2147483647i, (_e483 > 2147483500f)), (_e483 == _e483)) == (bitcast<i32>(_e494) + 1i)))) > 1u) {
let _e507 = type_26(_e215, _e225, _e236, vec3<f32>(_e247, _e258, _e269), vec3<f32>(_e280, _e291, _e302), vec3<f32>(_e313, _e324, _e335), vec3<f32>(_e346, _e357, _e368), vec3<f32>(_e379, _e390, _e401), _e412, vec3<f32>(_e423, _e434, _e445));
let _e509 = select(_e464, _e458, (_e458 < _e464));
let _e515 = global_2.member[bitcast<u32>(select(0i, _e509, (_e509 > 0i)))];
let _e517 = bitcast<i32>((_e454 + _e457));
let _e519 = select(_e464, _e517, (_e517 < _e464));
let _e525 = global_2.member[bitcast<u32>(select(0i, _e519, (_e519 > 0i)))];
let _e528 = bitcast<i32>(((2u * _e454) + _e457));
let _e530 = select(_e464, _e528, (_e528 < _e464));
let _e536 = global_2.member[bitcast<u32>(select(0i, _e530, (_e530 > 0i)))];
let _e539 = bitcast<i32>(((3u * _e454) + _e457));
let _e541 = select(_e464, _e539, (_e539 < _e464));
let _e547 = global_2.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e550 = bitcast<i32>(((4u * _e454) + _e457));
let _e552 = select(_e464, _e550, (_e550 < _e464));
let _e558 = global_2.member[bitcast<u32>(select(0i, _e552, (_e552 > 0i)))];
let _e561 = bitcast<i32>(((5u * _e454) + _e457));
let _e563 = select(_e464, _e561, (_e561 < _e464));
let _e569 = global_2.member[bitcast<u32>(select(0i, _e563, (_e563 > 0i)))];
let _e572 = bitcast<i32>(((12u * _e454) + _e457));
let _e574 = select(_e464, _e572, (_e572 < _e464));
let _e580 = global_2.member[bitcast<u32>(select(0i, _e574, (_e574 > 0i)))];
let _e583 = bitcast<i32>(((13u * _e454) + _e457));
let _e585 = select(_e464, _e583, (_e583 < _e464));
let _e591 = global_2.member[bitcast<u32>(select(0i, _e585, (_e585 > 0i)))];
let _e594 = bitcast<i32>(((14u * _e454) + _e457));
let _e596 = select(_e464, _e594, (_e594 < _e464));
let _e602 = global_2.member[bitcast<u32>(select(0i, _e596, (_e596 > 0i)))];
let _e605 = bitcast<i32>(((15u * _e454) + _e457));
let _e607 = select(_e464, _e605, (_e605 < _e464));
let _e613 = global_2.member[bitcast<u32>(select(0i, _e607, (_e607 > 0i)))];
let _e616 = bitcast<i32>(((16u * _e454) + _e457));
let _e618 = select(_e464, _e616, (_e616 < _e464));
let _e624 = global_2.member[bitcast<u32>(select(0i, _e618, (_e618 > 0i)))];
let _e627 = bitcast<i32>(((17u * _e454) + _e457));
let _e629 = select(_e464, _e627, (_e627 < _e464));
let _e635 = global_2.member[bitcast<u32>(select(0i, _e629, (_e629 > 0i)))];
let _e638 = bitcast<i32>(((18u * _e454) + _e457));
let _e640 = select(_e464, _e638, (_e638 < _e464));
let _e646 = global_2.member[bitcast<u32>(select(0i, _e640, (_e640 > 0i)))];
let _e649 = bitcast<i32>(((19u * _e454) + _e457));
let _e651 = select(_e464, _e649, (_e649 < _e464));
let _e657 = global_2.member[bitcast<u32>(select(0i, _e651, (_e651 > 0i)))];
let _e660 = bitcast<i32>(((20u * _e454) + _e457));
let _e662 = select(_e464, _e660, (_e660 < _e464));
let _e668 = global_2.member[bitcast<u32>(select(0i, _e662, (_e662 > 0i)))];
let _e671 = bitcast<i32>(((23u * _e454) + _e457));
let _e673 = select(_e464, _e671, (_e671 < _e464));
let _e679 = global_2.member[bitcast<u32>(select(0i, _e673, (_e673 > 0i)))];
let _e682 = bitcast<i32>(((24u * _e454) + _e457));
let _e684 = select(_e464, _e682, (_e682 < _e464));
let _e690 = global_2.member[bitcast<u32>(select(0i, _e684, (_e684 > 0i)))];
let _e693 = bitcast<i32>(((30u * _e454) + _e457));
let _e695 = select(_e464, _e693, (_e693 < _e464));
let _e701 = global_2.member[bitcast<u32>(select(0i, _e695, (_e695 > 0i)))];
let _e708 = select(0i, select(select(i32(_e679), i32(-2147483648), (_e679 < -2147483600f)), 2147483647i, (_e679 > 2147483500f)), (_e679 == _e679));
let _e716 = (select(0i, select(select(i32(_e701), i32(-2147483648), (_e701 < -2147483600f)), 2147483647i, (_e701 > 2147483500f)), (_e701 == _e701)) == 0i);
let _e724 = global_1.member.member_1.member;
let _e730 = global_1.member.member_1.member_1;
let _e740 = global_1.member.member_2.member;
let _e741 = (((((f32(bitcast<i32>(_e174.x)) + 0.5f) / f32(bitcast<i32>(_e724))) * 2f) - 1f) * _e740);
let _e749 = global_1.member.member_2.member_1;
let _e750 = ((1f - (((f32(bitcast<i32>(_e174.y)) + 0.5f) / f32(bitcast<i32>(_e730))) * 2f)) * _e749);
let _e753 = global_1.member.member_3;
let _e762 = global_1.member.member_4;
let _e775 = global_1.member.member_2.member_3;
let _e776 = (_e775 != 0u);
let _e779 = global_1.member.member_6;
let _e786 = select(_e779.member, (_e779.member + ((_e753.member * _e741) + (_e762.member * _e750))), _e776);
let _e787 = select(_e779.member_1, (_e779.member_1 + ((_e753.member_1 * _e741) + (_e762.member_1 * _e750))), _e776);
let _e788 = select(_e779.member_2, (_e779.member_2 + ((_e753.member_2 * _e741) + (_e762.member_2 * _e750))), _e776);
let _e798 = select(_e515, _e786, _e716);
let _e799 = select(_e525, _e787, _e716);
let _e800 = select(_e536, _e788, _e716);
let _e801 = vec3<f32>(_e798, _e799, _e800);
let _e802 = (select(0f, ((((_e515 - _e786) * _e547) + ((_e525 - _e787) * _e558)) + ((_e536 - _e788) * _e569)), _e716) + _e690);
let _e803 = select(_e646, 1f, _e716);
let _e804 = select(_e657, 1f, _e716);
let _e805 = select(_e668, 1f, _e716);
let _e813 = (1f / select(_e547, select(1e-12f, -1e-12f, (_e547 < 0f)), (bitcast<f32>((bitcast<u32>(_e547) & 2147483647u)) < 1e-12f)));
let _e821 = (1f / select(_e558, select(1e-12f, -1e-12f, (_e558 < 0f)), (bitcast<f32>((bitcast<u32>(_e558) & 2147483647u)) < 1e-12f)));
let _e829 = (1f / select(_e569, select(1e-12f, -1e-12f, (_e569 < 0f)), (bitcast<f32>((bitcast<u32>(_e569) & 2147483647u)) < 1e-12f)));
let _e833 = global_1.member.member_13.member_4;
let _e840 = global_1.member.member_13.member_5;
let _e845 = ((_e833.member - _e798) * _e813);
let _e847 = ((_e840.member - _e798) * _e813);
let _e849 = ((_e833.member_1 - _e799) * _e821);
let _e851 = ((_e840.member_1 - _e799) * _e821);
let _e853 = ((_e833.member_2 - _e800) * _e829);
let _e855 = ((_e840.member_2 - _e800) * _e829);
let _e857 = select(_e847, _e845, (_e845 < _e847));
let _e859 = select(_e851, _e849, (_e849 < _e851));
let _e861 = select(_e859, _e857, (_e857 > _e859));
let _e863 = select(_e855, _e853, (_e853 < _e855));
let _e865 = select(_e863, _e861, (_e861 > _e863));
let _e867 = select(_e847, _e845, (_e845 > _e847));
let _e869 = select(_e851, _e849, (_e849 > _e851));
let _e871 = select(_e869, _e867, (_e867 < _e869));
let _e873 = select(_e855, _e853, (_e853 > _e855));
let _e875 = select(_e873, _e871, (_e871 < _e873));
let _e877 = select(0f, _e865, (_e865 > 0f));
let _e879 = select(_e802, _e875, (_e875 < _e802));
let _e880 = (_e879 > _e877);
let _e881 = select(0f, _e877, _e880);
let _e882 = select(0f, _e879, _e880);
let _e883 = (_e882 - _e881);
let _e887 = global_1.member.member_13.member_6;
let _e888 = (_e887 == 0u);
if _e888 {
phi_2792_ = _e883;
} else {
let _e890 = (_e883 / f32(_e887));
phi_2079_ = 0u;
phi_2082_ = 0f;
loop {
let _e892 = phi_2079_;
let _e894 = phi_2082_;
local_75 = _e894;
let _e897 = ((_e892 < _e887) && (_e883 > 0f));
if _e897 {
let _e900 = (_e881 + (_e890 * f32(_e892)));
let _e901 = (_e900 + _e890);
let _e903 = (0.5f * (_e900 + _e901));
let _e904 = (_e901 - _e900);
let _e905 = (0.28867513f * _e904);
let _e906 = (_e903 - _e905);
let _e916 = global_1.member.member_13.member_7;
let _e917 = bitcast<i32>(_e916);
let _e921 = global_1.member.member_13.member_8;
let _e922 = bitcast<i32>(_e921);
let _e926 = global_1.member.member_13.member_9;
let _e927 = bitcast<i32>(_e926);
let _e928 = f32(_e917);
let _e930 = (_e840.member - _e833.member);
let _e933 = (((((_e798 + (_e547 * _e906)) - _e833.member) / _e930) * _e928) - 0.5f);
let _e934 = (_e928 - 1f);
let _e936 = select(0f, _e933, (_e933 > 0f));
let _e938 = select(_e934, _e936, (_e936 < _e934));
let _e939 = f32(_e922);
let _e941 = (_e840.member_1 - _e833.member_1);
let _e944 = (((((_e799 + (_e558 * _e906)) - _e833.member_1) / _e941) * _e939) - 0.5f);
let _e945 = (_e939 - 1f);
let _e947 = select(0f, _e944, (_e944 > 0f));
let _e949 = select(_e945, _e947, (_e947 < _e945));
let _e950 = f32(_e927);
let _e952 = (_e840.member_2 - _e833.member_2);
let _e955 = (((((_e800 + (_e569 * _e906)) - _e833.member_2) / _e952) * _e950) - 0.5f);
let _e956 = (_e950 - 1f);
let _e958 = select(0f, _e955, (_e955 > 0f));
let _e960 = select(_e956, _e958, (_e958 < _e956));
let _e962 = select(0f, _e938, (_e938 > 0f));
let _e964 = select(1e6f, _e962, (_e962 < 1e6f));
let _e971 = select(0i, select(select(i32(_e964), i32(-2147483648), (_e964 < -2147483600f)), 2147483647i, (_e964 > 2147483500f)), (_e964 == _e964));
let _e975 = (_e971 - select(0i, 1i, (_e964 < f32(_e971))));
let _e977 = select(0f, _e949, (_e949 > 0f));
let _e979 = select(1e6f, _e977, (_e977 < 1e6f));
let _e986 = select(0i, select(select(i32(_e979), i32(-2147483648), (_e979 < -2147483600f)), 2147483647i, (_e979 > 2147483500f)), (_e979 == _e979));
let _e990 = (_e986 - select(0i, 1i, (_e979 < f32(_e986))));
let _e992 = select(0f, _e960, (_e960 > 0f));
let _e994 = select(1e6f, _e992, (_e992 < 1e6f));
let _e1001 = select(0i, select(select(i32(_e994), i32(-2147483648), (_e994 < -2147483600f)), 2147483647i, (_e994 > 2147483500f)), (_e994 == _e994));
let _e1005 = (_e1001 - select(0i, 1i, (_e994 < f32(_e1001))));
let _e1009 = (_e949 - f32(_e990));
let _e1011 = (_e960 - f32(_e1005));
local_39 = (_e938 - f32(_e975));
let _e1012 = (_e975 + 1i);
let _e1014 = select(_e1012, 0i, (_e1012 < 0i));
if (_e1014 >= _e917) {
phi_2217_ = (_e917 - 1i);
} else {
phi_2217_ = _e1014;
}
let _e1018 = phi_2217_;
local_40 = (_e1018 - _e975);
let _e1020 = (_e990 + 1i);
let _e1022 = select(_e1020, 0i, (_e1020 < 0i));
if (_e1022 >= _e922) {
phi_2230_ = (_e922 - 1i);
} else {
phi_2230_ = _e1022;
}
let _e1026 = phi_2230_;
let _e1028 = ((_e1026 - _e990) * _e917);
let _e1029 = (_e1005 + 1i);
let _e1031 = select(_e1029, 0i, (_e1029 < 0i));
if (_e1031 >= _e927) {
phi_2244_ = (_e927 - 1i);
} else {
phi_2244_ = _e1031;
}
let _e1035 = phi_2244_;
let _e1042 = global_1.member.member_13.member_10;
let _e1043 = bitcast<i32>(_e1042);
let _e1048 = ((_e1043 + (((_e1005 * _e922) + _e990) * _e917)) + _e975);
let _e1050 = (bitcast<i32>(_e188) - 1i);
let _e1052 = select(_e1050, _e1048, (_e1048 < _e1050));
let _e1057 = global_7.member[bitcast<u32>(select(0i, _e1052, (_e1052 > 0i)))];
let _e1058 = local_39;
let _e1061 = local_40;
let _e1062 = (_e1048 + _e1061);
let _e1064 = select(_e1050, _e1062, (_e1062 < _e1050));
let _e1069 = global_7.member[bitcast<u32>(select(0i, _e1064, (_e1064 > 0i)))];
let _e1070 = local_39;
let _e1073 = (1f - _e1009);
let _e1075 = (_e1048 + _e1028);
let _e1077 = select(_e1050, _e1075, (_e1075 < _e1050));
let _e1082 = global_7.member[bitcast<u32>(select(0i, _e1077, (_e1077 > 0i)))];
let _e1083 = local_39;
let _e1086 = local_40;
let _e1087 = (_e1075 + _e1086);
let _e1089 = select(_e1050, _e1087, (_e1087 < _e1050));
let _e1094 = global_7.member[bitcast<u32>(select(0i, _e1089, (_e1089 > 0i)))];
let _e1095 = local_39;
let _e1100 = (_e1048 + (((_e1035 - _e1005) * _e917) * _e922));
let _e1102 = select(_e1050, _e1100, (_e1100 < _e1050));
let _e1107 = global_7.member[bitcast<u32>(select(0i, _e1102, (_e1102 > 0i)))];
let _e1108 = local_39;
let _e1111 = local_40;
let _e1112 = (_e1100 + _e1111);
let _e1114 = select(_e1050, _e1112, (_e1112 < _e1050));
let _e1119 = global_7.member[bitcast<u32>(select(0i, _e1114, (_e1114 > 0i)))];
let _e1120 = local_39;
let _e1124 = (_e1100 + _e1028);
let _e1126 = select(_e1050, _e1124, (_e1124 < _e1050));
let _e1131 = global_7.member[bitcast<u32>(select(0i, _e1126, (_e1126 > 0i)))];
let _e1132 = local_39;
let _e1135 = local_40;
let _e1136 = (_e1124 + _e1135);
let _e1138 = select(_e1050, _e1136, (_e1136 < _e1050));
let _e1143 = global_7.member[bitcast<u32>(select(0i, _e1138, (_e1138 > 0i)))];
let _e1144 = local_39;
let _e1153 = (_e903 + _e905);
let _e1163 = (((((_e798 + (_e547 * _e1153)) - _e833.member) / _e930) * _e928) - 0.5f);
let _e1165 = select(0f, _e1163, (_e1163 > 0f));
let _e1167 = select(_e934, _e1165, (_e1165 < _e934));
let _e1171 = (((((_e799 + (_e558 * _e1153)) - _e833.member_1) / _e941) * _e939) - 0.5f);
let _e1173 = select(0f, _e1171, (_e1171 > 0f));
let _e1175 = select(_e945, _e1173, (_e1173 < _e945));
let _e1179 = (((((_e800 + (_e569 * _e1153)) - _e833.member_2) / _e952) * _e950) - 0.5f);
let _e1181 = select(0f, _e1179, (_e1179 > 0f));
let _e1183 = select(_e956, _e1181, (_e1181 < _e956));
let _e1185 = select(0f, _e1167, (_e1167 > 0f));
let _e1187 = select(1e6f, _e1185, (_e1185 < 1e6f));
let _e1194 = select(0i, select(select(i32(_e1187), i32(-2147483648), (_e1187 < -2147483600f)), 2147483647i, (_e1187 > 2147483500f)), (_e1187 == _e1187));
let _e1198 = (_e1194 - select(0i, 1i, (_e1187 < f32(_e1194))));
let _e1200 = select(0f, _e1175, (_e1175 > 0f));
let _e1202 = select(1e6f, _e1200, (_e1200 < 1e6f));
let _e1209 = select(0i, select(select(i32(_e1202), i32(-2147483648), (_e1202 < -2147483600f)), 2147483647i, (_e1202 > 2147483500f)), (_e1202 == _e1202));
let _e1213 = (_e1209 - select(0i, 1i, (_e1202 < f32(_e1209))));
let _e1215 = select(0f, _e1183, (_e1183 > 0f));
let _e1217 = select(1e6f, _e1215, (_e1215 < 1e6f));
let _e1224 = select(0i, select(select(i32(_e1217), i32(-2147483648), (_e1217 < -2147483600f)), 2147483647i, (_e1217 > 2147483500f)), (_e1217 == _e1217));
let _e1228 = (_e1224 - select(0i, 1i, (_e1217 < f32(_e1224))));
let _e1232 = (_e1175 - f32(_e1213));
let _e1234 = (_e1183 - f32(_e1228));
local_37 = (_e1167 - f32(_e1198));
let _e1235 = (_e1198 + 1i);
let _e1237 = select(_e1235, 0i, (_e1235 < 0i));
if (_e1237 >= _e917) {
phi_2560_ = (_e917 - 1i);
} else {
phi_2560_ = _e1237;
}
let _e1241 = phi_2560_;
local_38 = (_e1241 - _e1198);
let _e1243 = (_e1213 + 1i);
let _e1245 = select(_e1243, 0i, (_e1243 < 0i));
if (_e1245 >= _e922) {
phi_2573_ = (_e922 - 1i);
} else {
phi_2573_ = _e1245;
}
let _e1249 = phi_2573_;
let _e1251 = ((_e1249 - _e1213) * _e917);
let _e1252 = (_e1228 + 1i);
let _e1254 = select(_e1252, 0i, (_e1252 < 0i));
if (_e1254 >= _e927) {
phi_2587_ = (_e927 - 1i);
} else {
phi_2587_ = _e1254;
}
let _e1258 = phi_2587_;
let _e1266 = ((_e1043 + (((_e1228 * _e922) + _e1213) * _e917)) + _e1198);
let _e1268 = select(_e1050, _e1266, (_e1266 < _e1050));
let _e1273 = global_7.member[bitcast<u32>(select(0i, _e1268, (_e1268 > 0i)))];
let _e1274 = local_37;
let _e1277 = local_38;
let _e1278 = (_e1266 + _e1277);
let _e1280 = select(_e1050, _e1278, (_e1278 < _e1050));
let _e1285 = global_7.member[bitcast<u32>(select(0i, _e1280, (_e1280 > 0i)))];
let _e1286 = local_37;
let _e1289 = (1f - _e1232);
let _e1291 = (_e1266 + _e1251);
let _e1293 = select(_e1050, _e1291, (_e1291 < _e1050));
let _e1298 = global_7.member[bitcast<u32>(select(0i, _e1293, (_e1293 > 0i)))];
let _e1299 = local_37;
let _e1302 = local_38;
let _e1303 = (_e1291 + _e1302);
let _e1305 = select(_e1050, _e1303, (_e1303 < _e1050));
let _e1310 = global_7.member[bitcast<u32>(select(0i, _e1305, (_e1305 > 0i)))];
let _e1311 = local_37;
let _e1316 = (_e1266 + (((_e1258 - _e1228) * _e917) * _e922));
let _e1318 = select(_e1050, _e1316, (_e1316 < _e1050));
let _e1323 = global_7.member[bitcast<u32>(select(0i, _e1318, (_e1318 > 0i)))];
let _e1324 = local_37;
let _e1327 = local_38;
let _e1328 = (_e1316 + _e1327);
let _e1330 = select(_e1050, _e1328, (_e1328 < _e1050));
let _e1335 = global_7.member[bitcast<u32>(select(0i, _e1330, (_e1330 > 0i)))];
let _e1336 = local_37;
let _e1340 = (_e1316 + _e1251);
let _e1342 = select(_e1050, _e1340, (_e1340 < _e1050));
let _e1347 = global_7.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1348 = local_37;
let _e1351 = local_38;
let _e1352 = (_e1340 + _e1351);
let _e1354 = select(_e1050, _e1352, (_e1352 < _e1050));
let _e1359 = global_7.member[bitcast<u32>(select(0i, _e1354, (_e1354 > 0i)))];
let _e1360 = local_37;
phi_2080_ = (_e892 + 1u);
phi_2083_ = (_e894 + ((0.5f * (((((((_e1057 * (1f - _e1058)) + (_e1069 * _e1070)) * _e1073) + (((_e1082 * (1f - _e1083)) + (_e1094 * _e1095)) * _e1009)) * (1f - _e1011)) + (((((_e1107 * (1f - _e1108)) + (_e1119 * _e1120)) * _e1073) + (((_e1131 * (1f - _e1132)) + (_e1143 * _e1144)) * _e1009)) * _e1011)) + ((((((_e1273 * (1f - _e1274)) + (_e1285 * _e1286)) * _e1289) + (((_e1298 * (1f - _e1299)) + (_e1310 * _e1311)) * _e1232)) * (1f - _e1234)) + (((((_e1323 * (1f - _e1324)) + (_e1335 * _e1336)) * _e1289) + (((_e1347 * (1f - _e1348)) + (_e1359 * _e1360)) * _e1232)) * _e1234)))) * _e904));
} else {
phi_2080_ = u32();
phi_2083_ = f32();
}
let _e1375 = phi_2080_;
let _e1377 = phi_2083_;
continue;
continuing {
phi_2079_ = _e1375;
phi_2082_ = _e1377;
break if !(_e897);
}
}
let _e11324 = local_75;
phi_2792_ = _e11324;
}
let _e1380 = phi_2792_;
let _e1384 = global_1.member.member_13.member;
let _e1389 = -((_e1384.member * _e1380));
let _e1391 = select(-87f, _e1389, (_e1389 > -87f));
let _e1393 = select(88f, _e1391, (_e1391 < 88f));
let _e1395 = ((_e1393 * 1.442695f) + 0.5f);
let _e1397 = select(-127f, _e1395, (_e1395 > -127f));
let _e1399 = select(128f, _e1397, (_e1397 < 128f));
let _e1406 = select(0i, select(select(i32(_e1399), i32(-2147483648), (_e1399 < -2147483600f)), 2147483647i, (_e1399 > 2147483500f)), (_e1399 == _e1399));
let _e1410 = (_e1406 - select(0i, 1i, (_e1399 < f32(_e1406))));
let _e1411 = f32(_e1410);
let _e1415 = ((_e1393 - (_e1411 * 0.6933594f)) - (_e1411 * -2.1219444e-4f));
let _e1435 = ((1f + (_e1415 * (1f + (_e1415 * (0.5f + (_e1415 * (0.16666667f + (_e1415 * (0.041666668f + (_e1415 * (0.008333334f + (_e1415 * (0.001388889f + (_e1415 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1410 + 127i)) << bitcast<u32>(23i))));
let _e1437 = -((_e1384.member_1 * _e1380));
let _e1439 = select(-87f, _e1437, (_e1437 > -87f));
let _e1441 = select(88f, _e1439, (_e1439 < 88f));
let _e1443 = ((_e1441 * 1.442695f) + 0.5f);
let _e1445 = select(-127f, _e1443, (_e1443 > -127f));
let _e1447 = select(128f, _e1445, (_e1445 < 128f));
let _e1454 = select(0i, select(select(i32(_e1447), i32(-2147483648), (_e1447 < -2147483600f)), 2147483647i, (_e1447 > 2147483500f)), (_e1447 == _e1447));
let _e1458 = (_e1454 - select(0i, 1i, (_e1447 < f32(_e1454))));
let _e1459 = f32(_e1458);
let _e1463 = ((_e1441 - (_e1459 * 0.6933594f)) - (_e1459 * -2.1219444e-4f));
let _e1483 = ((1f + (_e1463 * (1f + (_e1463 * (0.5f + (_e1463 * (0.16666667f + (_e1463 * (0.041666668f + (_e1463 * (0.008333334f + (_e1463 * (0.001388889f + (_e1463 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1458 + 127i)) << bitcast<u32>(23i))));
let _e1485 = -((_e1384.member_2 * _e1380));
let _e1487 = select(-87f, _e1485, (_e1485 > -87f));
let _e1489 = select(88f, _e1487, (_e1487 < 88f));
let _e1491 = ((_e1489 * 1.442695f) + 0.5f);
let _e1493 = select(-127f, _e1491, (_e1491 > -127f));
let _e1495 = select(128f, _e1493, (_e1493 < 128f));
let _e1502 = select(0i, select(select(i32(_e1495), i32(-2147483648), (_e1495 < -2147483600f)), 2147483647i, (_e1495 > 2147483500f)), (_e1495 == _e1495));
let _e1506 = (_e1502 - select(0i, 1i, (_e1495 < f32(_e1502))));
let _e1507 = f32(_e1506);
let _e1511 = ((_e1489 - (_e1507 * 0.6933594f)) - (_e1507 * -2.1219444e-4f));
let _e1531 = ((1f + (_e1511 * (1f + (_e1511 * (0.5f + (_e1511 * (0.16666667f + (_e1511 * (0.041666668f + (_e1511 * (0.008333334f + (_e1511 * (0.001388889f + (_e1511 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1506 + 127i)) << bitcast<u32>(23i))));
let _e1534 = global_1.member.member_17;
let _e1539 = (1f / 3f);
if (((_e1534 & 2u) != 0u) && ((((_e803 + _e804) + _e805) * _e1539) >= 0.01f)) {
let _e1547 = global_1.member.member_10.member;
if (_e1547 == 2u) {
let _e1552 = global_1.member.member_10.member_1;
let _e1559 = global_1.member.member_10.member_3;
let _e1563 = (_e798 - _e1559.member);
let _e1564 = (_e799 - _e1559.member_1);
let _e1565 = (_e800 - _e1559.member_2);
let _e1570 = global_1.member.member_10.member_4.member_2;
let _e1572 = (1f + (_e1570 * _e1570));
let _e1577 = (((_e1552.member * _e1563) + (_e1552.member_1 * _e1564)) + (_e1552.member_2 * _e1565));
let _e1582 = (((_e1552.member * _e547) + (_e1552.member_1 * _e558)) + (_e1552.member_2 * _e569));
let _e1583 = (_e1572 * _e1582);
let _e1585 = ((_e1583 * _e1582) - 1f);
let _e1592 = ((_e1583 * _e1577) - (((_e1563 * _e547) + (_e1564 * _e558)) + (_e1565 * _e569)));
let _e1603 = ((_e1592 * _e1592) - (_e1585 * (((_e1572 * _e1577) * _e1577) - (((_e1563 * _e1563) + (_e1564 * _e1564)) + (_e1565 * _e1565)))));
let _e1604 = (_e1603 > 0f);
let _e1606 = sqrt(select(0f, _e1603, _e1604));
let _e1609 = (1f / select(_e1585, 1e-20f, (_e1585 == 0f)));
let _e1610 = -(_e1592);
let _e1612 = ((_e1610 - _e1606) * _e1609);
let _e1614 = ((_e1610 + _e1606) * _e1609);
let _e1616 = select(_e1614, _e1612, (_e1612 < _e1614));
let _e1618 = select(_e1614, _e1612, (_e1612 > _e1614));
if (_e1585 < 0f) {
let _e1639 = (_e1604 && ((_e1577 + (_e1582 * (0.5f * (_e1616 + _e1618)))) > 0f));
let _e1640 = select(_e882, _e1616, _e1639);
let _e1643 = select(_e881, _e1618, _e1639);
phi_3155_ = type_29(select(_e1640, _e881, (_e881 > _e1640)), select(_e1643, _e882, (_e882 < _e1643)));
} else {
let _e1623 = (-(_e1577) / select(_e1582, 1e-20f, (_e1582 == 0f)));
let _e1626 = (_e1582 > 0f);
let _e1627 = select(_e881, select(_e1623, _e1618, _e1604), _e1626);
let _e1630 = select(select(_e1623, _e1616, _e1604), _e882, _e1626);
phi_3155_ = type_29(select(_e1627, _e881, (_e881 > _e1627)), select(_e1630, _e882, (_e882 < _e1630)));
}
let _e1648 = phi_3155_;
phi_3159_ = _e1648;
} else {
phi_3159_ = type_29(_e881, _e882);
}
let _e1650 = phi_3159_;
if (_e1650.member_1 > _e1650.member) {
let _e1657 = global_1.member.member_10.member_3;
let _e1661 = (_e1657.member - _e798);
let _e1662 = (_e1657.member_1 - _e799);
let _e1663 = (_e1657.member_2 - _e800);
let _e1668 = (((_e1661 * _e547) + (_e1662 * _e558)) + (_e1663 * _e569));
let _e1672 = (_e1661 - (_e547 * _e1668));
let _e1673 = (_e1662 - (_e558 * _e1668));
let _e1674 = (_e1663 - (_e569 * _e1668));
let _e1679 = (((_e1672 * _e1672) + (_e1673 * _e1673)) + (_e1674 * _e1674));
let _e1682 = sqrt(select(0f, _e1679, (_e1679 > 0f)));
let _e1684 = select(1e-6f, _e1682, (_e1682 > 1e-6f));
let _e1685 = (_e1547 == 0u);
let _e1687 = ((_e1650.member - _e1668) / _e1684);
let _e1689 = (1f + (_e1687 * _e1687));
let _e1695 = select((_e1687 / (1f + sqrt(select(0f, _e1689, (_e1689 > 0f))))), _e1650.member, _e1685);
let _e1697 = ((_e1650.member_1 - _e1668) / _e1684);
let _e1699 = (1f + (_e1697 * _e1697));
let _e1706 = bitcast<i32>(_e887);
if (12i < _e1706) {
phi_3273_ = (_e1706 / 2i);
} else {
phi_3273_ = 6i;
}
let _e1710 = phi_3273_;
let _e1714 = ((select((_e1697 / (1f + sqrt(select(0f, _e1699, (_e1699 > 0f))))), _e1650.member_1, _e1685) - _e1695) * (0.5f / f32(_e1710)));
let _e1716 = select(_e881, _e865, (_e865 > _e881));
let _e1718 = select(_e1650.member, _e875, (_e875 < _e1650.member));
let _e1719 = (_e1718 > _e1716);
let _e1720 = select(_e881, _e1716, _e1719);
let _e1722 = (select(_e881, _e1718, _e1719) - _e1720);
if _e888 {
phi_4138_ = _e1722;
} else {
let _e1724 = (_e1722 / f32(_e887));
phi_3425_ = 0u;
phi_3428_ = 0f;
loop {
let _e1726 = phi_3425_;
let _e1728 = phi_3428_;
local_76 = _e1728;
let _e1731 = ((_e1726 < _e887) && (_e1722 > 0f));
if _e1731 {
let _e1734 = (_e1720 + (_e1724 * f32(_e1726)));
let _e1735 = (_e1734 + _e1724);
let _e1737 = (0.5f * (_e1734 + _e1735));
let _e1738 = (_e1735 - _e1734);
let _e1739 = (0.28867513f * _e1738);
let _e1740 = (_e1737 - _e1739);
let _e1750 = global_1.member.member_13.member_7;
let _e1751 = bitcast<i32>(_e1750);
let _e1755 = global_1.member.member_13.member_8;
let _e1756 = bitcast<i32>(_e1755);
let _e1760 = global_1.member.member_13.member_9;
let _e1761 = bitcast<i32>(_e1760);
let _e1762 = f32(_e1751);
let _e1764 = (_e840.member - _e833.member);
let _e1767 = (((((_e798 + (_e547 * _e1740)) - _e833.member) / _e1764) * _e1762) - 0.5f);
let _e1768 = (_e1762 - 1f);
let _e1770 = select(0f, _e1767, (_e1767 > 0f));
let _e1772 = select(_e1768, _e1770, (_e1770 < _e1768));
let _e1773 = f32(_e1756);
let _e1775 = (_e840.member_1 - _e833.member_1);
let _e1778 = (((((_e799 + (_e558 * _e1740)) - _e833.member_1) / _e1775) * _e1773) - 0.5f);
let _e1779 = (_e1773 - 1f);
let _e1781 = select(0f, _e1778, (_e1778 > 0f));
let _e1783 = select(_e1779, _e1781, (_e1781 < _e1779));
let _e1784 = f32(_e1761);
let _e1786 = (_e840.member_2 - _e833.member_2);
let _e1789 = (((((_e800 + (_e569 * _e1740)) - _e833.member_2) / _e1786) * _e1784) - 0.5f);
let _e1790 = (_e1784 - 1f);
let _e1792 = select(0f, _e1789, (_e1789 > 0f));
let _e1794 = select(_e1790, _e1792, (_e1792 < _e1790));
let _e1796 = select(0f, _e1772, (_e1772 > 0f));
let _e1798 = select(1e6f, _e1796, (_e1796 < 1e6f));
let _e1805 = select(0i, select(select(i32(_e1798), i32(-2147483648), (_e1798 < -2147483600f)), 2147483647i, (_e1798 > 2147483500f)), (_e1798 == _e1798));
let _e1809 = (_e1805 - select(0i, 1i, (_e1798 < f32(_e1805))));
let _e1811 = select(0f, _e1783, (_e1783 > 0f));
let _e1813 = select(1e6f, _e1811, (_e1811 < 1e6f));
let _e1820 = select(0i, select(select(i32(_e1813), i32(-2147483648), (_e1813 < -2147483600f)), 2147483647i, (_e1813 > 2147483500f)), (_e1813 == _e1813));
let _e1824 = (_e1820 - select(0i, 1i, (_e1813 < f32(_e1820))));
let _e1826 = select(0f, _e1794, (_e1794 > 0f));
let _e1828 = select(1e6f, _e1826, (_e1826 < 1e6f));
let _e1835 = select(0i, select(select(i32(_e1828), i32(-2147483648), (_e1828 < -2147483600f)), 2147483647i, (_e1828 > 2147483500f)), (_e1828 == _e1828));
let _e1839 = (_e1835 - select(0i, 1i, (_e1828 < f32(_e1835))));
let _e1843 = (_e1783 - f32(_e1824));
let _e1845 = (_e1794 - f32(_e1839));
local_35 = (_e1772 - f32(_e1809));
let _e1846 = (_e1809 + 1i);
let _e1848 = select(_e1846, 0i, (_e1846 < 0i));
if (_e1848 >= _e1751) {
phi_3563_ = (_e1751 - 1i);
} else {
phi_3563_ = _e1848;
}
let _e1852 = phi_3563_;
local_36 = (_e1852 - _e1809);
let _e1854 = (_e1824 + 1i);
let _e1856 = select(_e1854, 0i, (_e1854 < 0i));
if (_e1856 >= _e1756) {
phi_3576_ = (_e1756 - 1i);
} else {
phi_3576_ = _e1856;
}
let _e1860 = phi_3576_;
let _e1862 = ((_e1860 - _e1824) * _e1751);
let _e1863 = (_e1839 + 1i);
let _e1865 = select(_e1863, 0i, (_e1863 < 0i));
if (_e1865 >= _e1761) {
phi_3590_ = (_e1761 - 1i);
} else {
phi_3590_ = _e1865;
}
let _e1869 = phi_3590_;
let _e1876 = global_1.member.member_13.member_10;
let _e1877 = bitcast<i32>(_e1876);
let _e1882 = ((_e1877 + (((_e1839 * _e1756) + _e1824) * _e1751)) + _e1809);
let _e1884 = (bitcast<i32>(_e188) - 1i);
let _e1886 = select(_e1884, _e1882, (_e1882 < _e1884));
let _e1891 = global_7.member[bitcast<u32>(select(0i, _e1886, (_e1886 > 0i)))];
let _e1892 = local_35;
let _e1895 = local_36;
let _e1896 = (_e1882 + _e1895);
let _e1898 = select(_e1884, _e1896, (_e1896 < _e1884));
let _e1903 = global_7.member[bitcast<u32>(select(0i, _e1898, (_e1898 > 0i)))];
let _e1904 = local_35;
let _e1907 = (1f - _e1843);
let _e1909 = (_e1882 + _e1862);
let _e1911 = select(_e1884, _e1909, (_e1909 < _e1884));
let _e1916 = global_7.member[bitcast<u32>(select(0i, _e1911, (_e1911 > 0i)))];
let _e1917 = local_35;
let _e1920 = local_36;
let _e1921 = (_e1909 + _e1920);
let _e1923 = select(_e1884, _e1921, (_e1921 < _e1884));
let _e1928 = global_7.member[bitcast<u32>(select(0i, _e1923, (_e1923 > 0i)))];
let _e1929 = local_35;
let _e1934 = (_e1882 + (((_e1869 - _e1839) * _e1751) * _e1756));
let _e1936 = select(_e1884, _e1934, (_e1934 < _e1884));
let _e1941 = global_7.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1942 = local_35;
let _e1945 = local_36;
let _e1946 = (_e1934 + _e1945);
let _e1948 = select(_e1884, _e1946, (_e1946 < _e1884));
let _e1953 = global_7.member[bitcast<u32>(select(0i, _e1948, (_e1948 > 0i)))];
let _e1954 = local_35;
let _e1958 = (_e1934 + _e1862);
let _e1960 = select(_e1884, _e1958, (_e1958 < _e1884));
let _e1965 = global_7.member[bitcast<u32>(select(0i, _e1960, (_e1960 > 0i)))];
let _e1966 = local_35;
let _e1969 = local_36;
let _e1970 = (_e1958 + _e1969);
let _e1972 = select(_e1884, _e1970, (_e1970 < _e1884));
let _e1977 = global_7.member[bitcast<u32>(select(0i, _e1972, (_e1972 > 0i)))];
let _e1978 = local_35;
let _e1987 = (_e1737 + _e1739);
let _e1997 = (((((_e798 + (_e547 * _e1987)) - _e833.member) / _e1764) * _e1762) - 0.5f);
let _e1999 = select(0f, _e1997, (_e1997 > 0f));
let _e2001 = select(_e1768, _e1999, (_e1999 < _e1768));
let _e2005 = (((((_e799 + (_e558 * _e1987)) - _e833.member_1) / _e1775) * _e1773) - 0.5f);
let _e2007 = select(0f, _e2005, (_e2005 > 0f));
let _e2009 = select(_e1779, _e2007, (_e2007 < _e1779));
let _e2013 = (((((_e800 + (_e569 * _e1987)) - _e833.member_2) / _e1786) * _e1784) - 0.5f);
let _e2015 = select(0f, _e2013, (_e2013 > 0f));
let _e2017 = select(_e1790, _e2015, (_e2015 < _e1790));
let _e2019 = select(0f, _e2001, (_e2001 > 0f));
let _e2021 = select(1e6f, _e2019, (_e2019 < 1e6f));
let _e2028 = select(0i, select(select(i32(_e2021), i32(-2147483648), (_e2021 < -2147483600f)), 2147483647i, (_e2021 > 2147483500f)), (_e2021 == _e2021));
let _e2032 = (_e2028 - select(0i, 1i, (_e2021 < f32(_e2028))));
let _e2034 = select(0f, _e2009, (_e2009 > 0f));
let _e2036 = select(1e6f, _e2034, (_e2034 < 1e6f));
let _e2043 = select(0i, select(select(i32(_e2036), i32(-2147483648), (_e2036 < -2147483600f)), 2147483647i, (_e2036 > 2147483500f)), (_e2036 == _e2036));
let _e2047 = (_e2043 - select(0i, 1i, (_e2036 < f32(_e2043))));
let _e2049 = select(0f, _e2017, (_e2017 > 0f));
let _e2051 = select(1e6f, _e2049, (_e2049 < 1e6f));
let _e2058 = select(0i, select(select(i32(_e2051), i32(-2147483648), (_e2051 < -2147483600f)), 2147483647i, (_e2051 > 2147483500f)), (_e2051 == _e2051));
let _e2062 = (_e2058 - select(0i, 1i, (_e2051 < f32(_e2058))));
let _e2066 = (_e2009 - f32(_e2047));
let _e2068 = (_e2017 - f32(_e2062));
local_33 = (_e2001 - f32(_e2032));
let _e2069 = (_e2032 + 1i);
let _e2071 = select(_e2069, 0i, (_e2069 < 0i));
if (_e2071 >= _e1751) {
phi_3906_ = (_e1751 - 1i);
} else {
phi_3906_ = _e2071;
}
let _e2075 = phi_3906_;
local_34 = (_e2075 - _e2032);
let _e2077 = (_e2047 + 1i);
let _e2079 = select(_e2077, 0i, (_e2077 < 0i));
if (_e2079 >= _e1756) {
phi_3919_ = (_e1756 - 1i);
} else {
phi_3919_ = _e2079;
}
let _e2083 = phi_3919_;
let _e2085 = ((_e2083 - _e2047) * _e1751);
let _e2086 = (_e2062 + 1i);
let _e2088 = select(_e2086, 0i, (_e2086 < 0i));
if (_e2088 >= _e1761) {
phi_3933_ = (_e1761 - 1i);
} else {
phi_3933_ = _e2088;
}
let _e2092 = phi_3933_;
let _e2100 = ((_e1877 + (((_e2062 * _e1756) + _e2047) * _e1751)) + _e2032);
let _e2102 = select(_e1884, _e2100, (_e2100 < _e1884));
let _e2107 = global_7.member[bitcast<u32>(select(0i, _e2102, (_e2102 > 0i)))];
let _e2108 = local_33;
let _e2111 = local_34;
let _e2112 = (_e2100 + _e2111);
let _e2114 = select(_e1884, _e2112, (_e2112 < _e1884));
let _e2119 = global_7.member[bitcast<u32>(select(0i, _e2114, (_e2114 > 0i)))];
let _e2120 = local_33;
let _e2123 = (1f - _e2066);
let _e2125 = (_e2100 + _e2085);
let _e2127 = select(_e1884, _e2125, (_e2125 < _e1884));
let _e2132 = global_7.member[bitcast<u32>(select(0i, _e2127, (_e2127 > 0i)))];
let _e2133 = local_33;
let _e2136 = local_34;
let _e2137 = (_e2125 + _e2136);
let _e2139 = select(_e1884, _e2137, (_e2137 < _e1884));
let _e2144 = global_7.member[bitcast<u32>(select(0i, _e2139, (_e2139 > 0i)))];
let _e2145 = local_33;
let _e2150 = (_e2100 + (((_e2092 - _e2062) * _e1751) * _e1756));
let _e2152 = select(_e1884, _e2150, (_e2150 < _e1884));
let _e2157 = global_7.member[bitcast<u32>(select(0i, _e2152, (_e2152 > 0i)))];
let _e2158 = local_33;
let _e2161 = local_34;
let _e2162 = (_e2150 + _e2161);
let _e2164 = select(_e1884, _e2162, (_e2162 < _e1884));
let _e2169 = global_7.member[bitcast<u32>(select(0i, _e2164, (_e2164 > 0i)))];
let _e2170 = local_33;
let _e2174 = (_e2150 + _e2085);
let _e2176 = select(_e1884, _e2174, (_e2174 < _e1884));
let _e2181 = global_7.member[bitcast<u32>(select(0i, _e2176, (_e2176 > 0i)))];
let _e2182 = local_33;
let _e2185 = local_34;
let _e2186 = (_e2174 + _e2185);
let _e2188 = select(_e1884, _e2186, (_e2186 < _e1884));
let _e2193 = global_7.member[bitcast<u32>(select(0i, _e2188, (_e2188 > 0i)))];
let _e2194 = local_33;
phi_3426_ = (_e1726 + 1u);
phi_3429_ = (_e1728 + ((0.5f * (((((((_e1891 * (1f - _e1892)) + (_e1903 * _e1904)) * _e1907) + (((_e1916 * (1f - _e1917)) + (_e1928 * _e1929)) * _e1843)) * (1f - _e1845)) + (((((_e1941 * (1f - _e1942)) + (_e1953 * _e1954)) * _e1907) + (((_e1965 * (1f - _e1966)) + (_e1977 * _e1978)) * _e1843)) * _e1845)) + ((((((_e2107 * (1f - _e2108)) + (_e2119 * _e2120)) * _e2123) + (((_e2132 * (1f - _e2133)) + (_e2144 * _e2145)) * _e2066)) * (1f - _e2068)) + (((((_e2157 * (1f - _e2158)) + (_e2169 * _e2170)) * _e2123) + (((_e2181 * (1f - _e2182)) + (_e2193 * _e2194)) * _e2066)) * _e2068)))) * _e1738));
} else {
phi_3426_ = u32();
phi_3429_ = f32();
}
let _e2209 = phi_3426_;
let _e2211 = phi_3429_;
continue;
continuing {
phi_3425_ = _e2209;
phi_3428_ = _e2211;
break if !(_e1731);
}
}
let _e11340 = local_76;
phi_4138_ = _e11340;
}
let _e2214 = phi_4138_;
phi_4140_ = vec3<f32>(0f, 0f, 0f);
phi_4143_ = 0i;
phi_4145_ = _e2214;
loop {
let _e2216 = phi_4140_;
let _e2218 = phi_4143_;
let _e2220 = phi_4145_;
local_81 = _e2216;
let _e2221 = (_e2218 < _e1710);
if _e2221 {
let _e2226 = (_e1695 + (_e1714 * ((2f * f32(_e2218)) + 1f)));
let _e2229 = (_e2226 + (_e1714 * -(0.8611363f)));
let _e2230 = (_e2229 * _e2229);
let _e2231 = (1f - _e2230);
let _e2233 = select(1e-9f, _e2231, (_e2231 > 1e-9f));
let _e2243 = select((_e1668 + (_e1684 * ((2f * _e2229) / _e2233))), _e2229, _e1685);
let _e2245 = (_e547 * _e2243);
let _e2246 = (_e558 * _e2243);
let _e2247 = (_e569 * _e2243);
let _e2252 = (_e801 + vec3<f32>(_e2245, _e2246, _e2247));
let _e2255 = global_1.member.member_13.member_6;
let _e2256 = (_e2255 == 0u);
if _e2256 {
phi_4546_ = 1f;
} else {
let _e2259 = global_1.member.member_13.member_7;
let _e2260 = bitcast<i32>(_e2259);
let _e2263 = global_1.member.member_13.member_8;
let _e2264 = bitcast<i32>(_e2263);
let _e2267 = global_1.member.member_13.member_9;
let _e2268 = bitcast<i32>(_e2267);
let _e2271 = global_1.member.member_13.member_4;
let _e2277 = global_1.member.member_13.member_5;
let _e2281 = f32(_e2260);
let _e2286 = (((((_e798 + _e2245) - _e2271.member) / (_e2277.member - _e2271.member)) * _e2281) - 0.5f);
let _e2287 = (_e2281 - 1f);
let _e2289 = select(0f, _e2286, (_e2286 > 0f));
let _e2291 = select(_e2287, _e2289, (_e2289 < _e2287));
let _e2292 = f32(_e2264);
let _e2297 = (((((_e799 + _e2246) - _e2271.member_1) / (_e2277.member_1 - _e2271.member_1)) * _e2292) - 0.5f);
let _e2298 = (_e2292 - 1f);
let _e2300 = select(0f, _e2297, (_e2297 > 0f));
let _e2302 = select(_e2298, _e2300, (_e2300 < _e2298));
let _e2303 = f32(_e2268);
let _e2308 = (((((_e800 + _e2247) - _e2271.member_2) / (_e2277.member_2 - _e2271.member_2)) * _e2303) - 0.5f);
let _e2309 = (_e2303 - 1f);
let _e2311 = select(0f, _e2308, (_e2308 > 0f));
let _e2313 = select(_e2309, _e2311, (_e2311 < _e2309));
let _e2315 = select(0f, _e2291, (_e2291 > 0f));
let _e2317 = select(1e6f, _e2315, (_e2315 < 1e6f));
let _e2324 = select(0i, select(select(i32(_e2317), i32(-2147483648), (_e2317 < -2147483600f)), 2147483647i, (_e2317 > 2147483500f)), (_e2317 == _e2317));
let _e2328 = (_e2324 - select(0i, 1i, (_e2317 < f32(_e2324))));
let _e2330 = select(0f, _e2302, (_e2302 > 0f));
let _e2332 = select(1e6f, _e2330, (_e2330 < 1e6f));
let _e2339 = select(0i, select(select(i32(_e2332), i32(-2147483648), (_e2332 < -2147483600f)), 2147483647i, (_e2332 > 2147483500f)), (_e2332 == _e2332));
let _e2343 = (_e2339 - select(0i, 1i, (_e2332 < f32(_e2339))));
let _e2345 = select(0f, _e2313, (_e2313 > 0f));
let _e2347 = select(1e6f, _e2345, (_e2345 < 1e6f));
let _e2354 = select(0i, select(select(i32(_e2347), i32(-2147483648), (_e2347 < -2147483600f)), 2147483647i, (_e2347 > 2147483500f)), (_e2347 == _e2347));
let _e2358 = (_e2354 - select(0i, 1i, (_e2347 < f32(_e2354))));
let _e2362 = (_e2302 - f32(_e2343));
let _e2364 = (_e2313 - f32(_e2358));
local_31 = (_e2291 - f32(_e2328));
let _e2365 = (_e2328 + 1i);
let _e2367 = select(_e2365, 0i, (_e2365 < 0i));
if (_e2367 >= _e2260) {
phi_4319_ = (_e2260 - 1i);
} else {
phi_4319_ = _e2367;
}
let _e2371 = phi_4319_;
local_32 = (_e2371 - _e2328);
let _e2373 = (_e2343 + 1i);
let _e2375 = select(_e2373, 0i, (_e2373 < 0i));
if (_e2375 >= _e2264) {
phi_4332_ = (_e2264 - 1i);
} else {
phi_4332_ = _e2375;
}
let _e2379 = phi_4332_;
let _e2381 = ((_e2379 - _e2343) * _e2260);
let _e2382 = (_e2358 + 1i);
let _e2384 = select(_e2382, 0i, (_e2382 < 0i));
if (_e2384 >= _e2268) {
phi_4346_ = (_e2268 - 1i);
} else {
phi_4346_ = _e2384;
}
let _e2388 = phi_4346_;
let _e2394 = global_1.member.member_13.member_10;
let _e2400 = ((bitcast<i32>(_e2394) + (((_e2358 * _e2264) + _e2343) * _e2260)) + _e2328);
let _e2402 = (bitcast<i32>(_e188) - 1i);
let _e2404 = select(_e2402, _e2400, (_e2400 < _e2402));
let _e2409 = global_7.member[bitcast<u32>(select(0i, _e2404, (_e2404 > 0i)))];
let _e2410 = local_31;
let _e2413 = local_32;
let _e2414 = (_e2400 + _e2413);
let _e2416 = select(_e2402, _e2414, (_e2414 < _e2402));
let _e2421 = global_7.member[bitcast<u32>(select(0i, _e2416, (_e2416 > 0i)))];
let _e2422 = local_31;
let _e2425 = (1f - _e2362);
let _e2427 = (_e2400 + _e2381);
let _e2429 = select(_e2402, _e2427, (_e2427 < _e2402));
let _e2434 = global_7.member[bitcast<u32>(select(0i, _e2429, (_e2429 > 0i)))];
let _e2435 = local_31;
let _e2438 = local_32;
let _e2439 = (_e2427 + _e2438);
let _e2441 = select(_e2402, _e2439, (_e2439 < _e2402));
let _e2446 = global_7.member[bitcast<u32>(select(0i, _e2441, (_e2441 > 0i)))];
let _e2447 = local_31;
let _e2452 = (_e2400 + (((_e2388 - _e2358) * _e2260) * _e2264));
let _e2454 = select(_e2402, _e2452, (_e2452 < _e2402));
let _e2459 = global_7.member[bitcast<u32>(select(0i, _e2454, (_e2454 > 0i)))];
let _e2460 = local_31;
let _e2463 = local_32;
let _e2464 = (_e2452 + _e2463);
let _e2466 = select(_e2402, _e2464, (_e2464 < _e2402));
let _e2471 = global_7.member[bitcast<u32>(select(0i, _e2466, (_e2466 > 0i)))];
let _e2472 = local_31;
let _e2476 = (_e2452 + _e2381);
let _e2478 = select(_e2402, _e2476, (_e2476 < _e2402));
let _e2483 = global_7.member[bitcast<u32>(select(0i, _e2478, (_e2478 > 0i)))];
let _e2484 = local_31;
let _e2487 = local_32;
let _e2488 = (_e2476 + _e2487);
let _e2490 = select(_e2402, _e2488, (_e2488 < _e2402));
let _e2495 = global_7.member[bitcast<u32>(select(0i, _e2490, (_e2490 > 0i)))];
let _e2496 = local_31;
phi_4546_ = ((((((_e2409 * (1f - _e2410)) + (_e2421 * _e2422)) * _e2425) + (((_e2434 * (1f - _e2435)) + (_e2446 * _e2447)) * _e2362)) * (1f - _e2364)) + (((((_e2459 * (1f - _e2460)) + (_e2471 * _e2472)) * _e2425) + (((_e2483 * (1f - _e2484)) + (_e2495 * _e2496)) * _e2362)) * _e2364));
}
let _e2506 = phi_4546_;
let _e2509 = (_e2226 + (_e1714 * -(0.33998105f)));
let _e2510 = (_e2509 * _e2509);
let _e2511 = (1f - _e2510);
let _e2513 = select(1e-9f, _e2511, (_e2511 > 1e-9f));
let _e2523 = select((_e1668 + (_e1684 * ((2f * _e2509) / _e2513))), _e2509, _e1685);
let _e2525 = (_e547 * _e2523);
let _e2526 = (_e558 * _e2523);
let _e2527 = (_e569 * _e2523);
let _e2532 = (_e801 + vec3<f32>(_e2525, _e2526, _e2527));
if _e2256 {
phi_4936_ = 1f;
} else {
let _e2535 = global_1.member.member_13.member_7;
let _e2536 = bitcast<i32>(_e2535);
let _e2539 = global_1.member.member_13.member_8;
let _e2540 = bitcast<i32>(_e2539);
let _e2543 = global_1.member.member_13.member_9;
let _e2544 = bitcast<i32>(_e2543);
let _e2547 = global_1.member.member_13.member_4;
let _e2553 = global_1.member.member_13.member_5;
let _e2557 = f32(_e2536);
let _e2562 = (((((_e798 + _e2525) - _e2547.member) / (_e2553.member - _e2547.member)) * _e2557) - 0.5f);
let _e2563 = (_e2557 - 1f);
let _e2565 = select(0f, _e2562, (_e2562 > 0f));
let _e2567 = select(_e2563, _e2565, (_e2565 < _e2563));
let _e2568 = f32(_e2540);
let _e2573 = (((((_e799 + _e2526) - _e2547.member_1) / (_e2553.member_1 - _e2547.member_1)) * _e2568) - 0.5f);
let _e2574 = (_e2568 - 1f);
let _e2576 = select(0f, _e2573, (_e2573 > 0f));
let _e2578 = select(_e2574, _e2576, (_e2576 < _e2574));
let _e2579 = f32(_e2544);
let _e2584 = (((((_e800 + _e2527) - _e2547.member_2) / (_e2553.member_2 - _e2547.member_2)) * _e2579) - 0.5f);
let _e2585 = (_e2579 - 1f);
let _e2587 = select(0f, _e2584, (_e2584 > 0f));
let _e2589 = select(_e2585, _e2587, (_e2587 < _e2585));
let _e2591 = select(0f, _e2567, (_e2567 > 0f));
let _e2593 = select(1e6f, _e2591, (_e2591 < 1e6f));
let _e2600 = select(0i, select(select(i32(_e2593), i32(-2147483648), (_e2593 < -2147483600f)), 2147483647i, (_e2593 > 2147483500f)), (_e2593 == _e2593));
let _e2604 = (_e2600 - select(0i, 1i, (_e2593 < f32(_e2600))));
let _e2606 = select(0f, _e2578, (_e2578 > 0f));
let _e2608 = select(1e6f, _e2606, (_e2606 < 1e6f));
let _e2615 = select(0i, select(select(i32(_e2608), i32(-2147483648), (_e2608 < -2147483600f)), 2147483647i, (_e2608 > 2147483500f)), (_e2608 == _e2608));
let _e2619 = (_e2615 - select(0i, 1i, (_e2608 < f32(_e2615))));
let _e2621 = select(0f, _e2589, (_e2589 > 0f));
let _e2623 = select(1e6f, _e2621, (_e2621 < 1e6f));
let _e2630 = select(0i, select(select(i32(_e2623), i32(-2147483648), (_e2623 < -2147483600f)), 2147483647i, (_e2623 > 2147483500f)), (_e2623 == _e2623));
let _e2634 = (_e2630 - select(0i, 1i, (_e2623 < f32(_e2630))));
let _e2638 = (_e2578 - f32(_e2619));
let _e2640 = (_e2589 - f32(_e2634));
local_29 = (_e2567 - f32(_e2604));
let _e2641 = (_e2604 + 1i);
let _e2643 = select(_e2641, 0i, (_e2641 < 0i));
if (_e2643 >= _e2536) {
phi_4709_ = (_e2536 - 1i);
} else {
phi_4709_ = _e2643;
}
let _e2647 = phi_4709_;
local_30 = (_e2647 - _e2604);
let _e2649 = (_e2619 + 1i);
let _e2651 = select(_e2649, 0i, (_e2649 < 0i));
if (_e2651 >= _e2540) {
phi_4722_ = (_e2540 - 1i);
} else {
phi_4722_ = _e2651;
}
let _e2655 = phi_4722_;
let _e2657 = ((_e2655 - _e2619) * _e2536);
let _e2658 = (_e2634 + 1i);
let _e2660 = select(_e2658, 0i, (_e2658 < 0i));
if (_e2660 >= _e2544) {
phi_4736_ = (_e2544 - 1i);
} else {
phi_4736_ = _e2660;
}
let _e2664 = phi_4736_;
let _e2670 = global_1.member.member_13.member_10;
let _e2676 = ((bitcast<i32>(_e2670) + (((_e2634 * _e2540) + _e2619) * _e2536)) + _e2604);
let _e2678 = (bitcast<i32>(_e188) - 1i);
let _e2680 = select(_e2678, _e2676, (_e2676 < _e2678));
let _e2685 = global_7.member[bitcast<u32>(select(0i, _e2680, (_e2680 > 0i)))];
let _e2686 = local_29;
let _e2689 = local_30;
let _e2690 = (_e2676 + _e2689);
let _e2692 = select(_e2678, _e2690, (_e2690 < _e2678));
let _e2697 = global_7.member[bitcast<u32>(select(0i, _e2692, (_e2692 > 0i)))];
let _e2698 = local_29;
let _e2701 = (1f - _e2638);
let _e2703 = (_e2676 + _e2657);
let _e2705 = select(_e2678, _e2703, (_e2703 < _e2678));
let _e2710 = global_7.member[bitcast<u32>(select(0i, _e2705, (_e2705 > 0i)))];
let _e2711 = local_29;
let _e2714 = local_30;
let _e2715 = (_e2703 + _e2714);
let _e2717 = select(_e2678, _e2715, (_e2715 < _e2678));
let _e2722 = global_7.member[bitcast<u32>(select(0i, _e2717, (_e2717 > 0i)))];
let _e2723 = local_29;
let _e2728 = (_e2676 + (((_e2664 - _e2634) * _e2536) * _e2540));
let _e2730 = select(_e2678, _e2728, (_e2728 < _e2678));
let _e2735 = global_7.member[bitcast<u32>(select(0i, _e2730, (_e2730 > 0i)))];
let _e2736 = local_29;
let _e2739 = local_30;
let _e2740 = (_e2728 + _e2739);
let _e2742 = select(_e2678, _e2740, (_e2740 < _e2678));
let _e2747 = global_7.member[bitcast<u32>(select(0i, _e2742, (_e2742 > 0i)))];
let _e2748 = local_29;
let _e2752 = (_e2728 + _e2657);
let _e2754 = select(_e2678, _e2752, (_e2752 < _e2678));
let _e2759 = global_7.member[bitcast<u32>(select(0i, _e2754, (_e2754 > 0i)))];
let _e2760 = local_29;
let _e2763 = local_30;
let _e2764 = (_e2752 + _e2763);
let _e2766 = select(_e2678, _e2764, (_e2764 < _e2678));
let _e2771 = global_7.member[bitcast<u32>(select(0i, _e2766, (_e2766 > 0i)))];
let _e2772 = local_29;
phi_4936_ = ((((((_e2685 * (1f - _e2686)) + (_e2697 * _e2698)) * _e2701) + (((_e2710 * (1f - _e2711)) + (_e2722 * _e2723)) * _e2638)) * (1f - _e2640)) + (((((_e2735 * (1f - _e2736)) + (_e2747 * _e2748)) * _e2701) + (((_e2759 * (1f - _e2760)) + (_e2771 * _e2772)) * _e2638)) * _e2640));
}
let _e2782 = phi_4936_;
let _e2784 = (_e2226 + (_e1714 * 0.33998105f));
let _e2785 = (_e2784 * _e2784);
let _e2786 = (1f - _e2785);
let _e2788 = select(1e-9f, _e2786, (_e2786 > 1e-9f));
let _e2798 = select((_e1668 + (_e1684 * ((2f * _e2784) / _e2788))), _e2784, _e1685);
let _e2800 = (_e547 * _e2798);
let _e2801 = (_e558 * _e2798);
let _e2802 = (_e569 * _e2798);
let _e2807 = (_e801 + vec3<f32>(_e2800, _e2801, _e2802));
if _e2256 {
phi_5325_ = 1f;
} else {
let _e2810 = global_1.member.member_13.member_7;
let _e2811 = bitcast<i32>(_e2810);
let _e2814 = global_1.member.member_13.member_8;
let _e2815 = bitcast<i32>(_e2814);
let _e2818 = global_1.member.member_13.member_9;
let _e2819 = bitcast<i32>(_e2818);
let _e2822 = global_1.member.member_13.member_4;
let _e2828 = global_1.member.member_13.member_5;
let _e2832 = f32(_e2811);
let _e2837 = (((((_e798 + _e2800) - _e2822.member) / (_e2828.member - _e2822.member)) * _e2832) - 0.5f);
let _e2838 = (_e2832 - 1f);
let _e2840 = select(0f, _e2837, (_e2837 > 0f));
let _e2842 = select(_e2838, _e2840, (_e2840 < _e2838));
let _e2843 = f32(_e2815);
let _e2848 = (((((_e799 + _e2801) - _e2822.member_1) / (_e2828.member_1 - _e2822.member_1)) * _e2843) - 0.5f);
let _e2849 = (_e2843 - 1f);
let _e2851 = select(0f, _e2848, (_e2848 > 0f));
let _e2853 = select(_e2849, _e2851, (_e2851 < _e2849));
let _e2854 = f32(_e2819);
let _e2859 = (((((_e800 + _e2802) - _e2822.member_2) / (_e2828.member_2 - _e2822.member_2)) * _e2854) - 0.5f);
let _e2860 = (_e2854 - 1f);
let _e2862 = select(0f, _e2859, (_e2859 > 0f));
let _e2864 = select(_e2860, _e2862, (_e2862 < _e2860));
let _e2866 = select(0f, _e2842, (_e2842 > 0f));
let _e2868 = select(1e6f, _e2866, (_e2866 < 1e6f));
let _e2875 = select(0i, select(select(i32(_e2868), i32(-2147483648), (_e2868 < -2147483600f)), 2147483647i, (_e2868 > 2147483500f)), (_e2868 == _e2868));
let _e2879 = (_e2875 - select(0i, 1i, (_e2868 < f32(_e2875))));
let _e2881 = select(0f, _e2853, (_e2853 > 0f));
let _e2883 = select(1e6f, _e2881, (_e2881 < 1e6f));
let _e2890 = select(0i, select(select(i32(_e2883), i32(-2147483648), (_e2883 < -2147483600f)), 2147483647i, (_e2883 > 2147483500f)), (_e2883 == _e2883));
let _e2894 = (_e2890 - select(0i, 1i, (_e2883 < f32(_e2890))));
let _e2896 = select(0f, _e2864, (_e2864 > 0f));
let _e2898 = select(1e6f, _e2896, (_e2896 < 1e6f));
let _e2905 = select(0i, select(select(i32(_e2898), i32(-2147483648), (_e2898 < -2147483600f)), 2147483647i, (_e2898 > 2147483500f)), (_e2898 == _e2898));
let _e2909 = (_e2905 - select(0i, 1i, (_e2898 < f32(_e2905))));
let _e2913 = (_e2853 - f32(_e2894));
let _e2915 = (_e2864 - f32(_e2909));
local_27 = (_e2842 - f32(_e2879));
let _e2916 = (_e2879 + 1i);
let _e2918 = select(_e2916, 0i, (_e2916 < 0i));
if (_e2918 >= _e2811) {
phi_5098_ = (_e2811 - 1i);
} else {
phi_5098_ = _e2918;
}
let _e2922 = phi_5098_;
local_28 = (_e2922 - _e2879);
let _e2924 = (_e2894 + 1i);
let _e2926 = select(_e2924, 0i, (_e2924 < 0i));
if (_e2926 >= _e2815) {
phi_5111_ = (_e2815 - 1i);
} else {
phi_5111_ = _e2926;
}
let _e2930 = phi_5111_;
let _e2932 = ((_e2930 - _e2894) * _e2811);
let _e2933 = (_e2909 + 1i);
let _e2935 = select(_e2933, 0i, (_e2933 < 0i));
if (_e2935 >= _e2819) {
phi_5125_ = (_e2819 - 1i);
} else {
phi_5125_ = _e2935;
}
let _e2939 = phi_5125_;
let _e2945 = global_1.member.member_13.member_10;
let _e2951 = ((bitcast<i32>(_e2945) + (((_e2909 * _e2815) + _e2894) * _e2811)) + _e2879);
let _e2953 = (bitcast<i32>(_e188) - 1i);
let _e2955 = select(_e2953, _e2951, (_e2951 < _e2953));
let _e2960 = global_7.member[bitcast<u32>(select(0i, _e2955, (_e2955 > 0i)))];
let _e2961 = local_27;
let _e2964 = local_28;
let _e2965 = (_e2951 + _e2964);
let _e2967 = select(_e2953, _e2965, (_e2965 < _e2953));
let _e2972 = global_7.member[bitcast<u32>(select(0i, _e2967, (_e2967 > 0i)))];
let _e2973 = local_27;
let _e2976 = (1f - _e2913);
let _e2978 = (_e2951 + _e2932);
let _e2980 = select(_e2953, _e2978, (_e2978 < _e2953));
let _e2985 = global_7.member[bitcast<u32>(select(0i, _e2980, (_e2980 > 0i)))];
let _e2986 = local_27;
let _e2989 = local_28;
let _e2990 = (_e2978 + _e2989);
let _e2992 = select(_e2953, _e2990, (_e2990 < _e2953));
let _e2997 = global_7.member[bitcast<u32>(select(0i, _e2992, (_e2992 > 0i)))];
let _e2998 = local_27;
let _e3003 = (_e2951 + (((_e2939 - _e2909) * _e2811) * _e2815));
let _e3005 = select(_e2953, _e3003, (_e3003 < _e2953));
let _e3010 = global_7.member[bitcast<u32>(select(0i, _e3005, (_e3005 > 0i)))];
let _e3011 = local_27;
let _e3014 = local_28;
let _e3015 = (_e3003 + _e3014);
let _e3017 = select(_e2953, _e3015, (_e3015 < _e2953));
let _e3022 = global_7.member[bitcast<u32>(select(0i, _e3017, (_e3017 > 0i)))];
let _e3023 = local_27;
let _e3027 = (_e3003 + _e2932);
let _e3029 = select(_e2953, _e3027, (_e3027 < _e2953));
let _e3034 = global_7.member[bitcast<u32>(select(0i, _e3029, (_e3029 > 0i)))];
let _e3035 = local_27;
let _e3038 = local_28;
let _e3039 = (_e3027 + _e3038);
let _e3041 = select(_e2953, _e3039, (_e3039 < _e2953));
let _e3046 = global_7.member[bitcast<u32>(select(0i, _e3041, (_e3041 > 0i)))];
let _e3047 = local_27;
phi_5325_ = ((((((_e2960 * (1f - _e2961)) + (_e2972 * _e2973)) * _e2976) + (((_e2985 * (1f - _e2986)) + (_e2997 * _e2998)) * _e2913)) * (1f - _e2915)) + (((((_e3010 * (1f - _e3011)) + (_e3022 * _e3023)) * _e2976) + (((_e3034 * (1f - _e3035)) + (_e3046 * _e3047)) * _e2913)) * _e2915));
}
let _e3057 = phi_5325_;
let _e3059 = (_e2226 + (_e1714 * 0.8611363f));
let _e3060 = (_e3059 * _e3059);
let _e3061 = (1f - _e3060);
let _e3063 = select(1e-9f, _e3061, (_e3061 > 1e-9f));
let _e3073 = select((_e1668 + (_e1684 * ((2f * _e3059) / _e3063))), _e3059, _e1685);
let _e3075 = (_e547 * _e3073);
let _e3076 = (_e558 * _e3073);
let _e3077 = (_e569 * _e3073);
let _e3082 = (_e801 + vec3<f32>(_e3075, _e3076, _e3077));
if _e2256 {
phi_5714_ = 1f;
} else {
let _e3085 = global_1.member.member_13.member_7;
let _e3086 = bitcast<i32>(_e3085);
let _e3089 = global_1.member.member_13.member_8;
let _e3090 = bitcast<i32>(_e3089);
let _e3093 = global_1.member.member_13.member_9;
let _e3094 = bitcast<i32>(_e3093);
let _e3097 = global_1.member.member_13.member_4;
let _e3103 = global_1.member.member_13.member_5;
let _e3107 = f32(_e3086);
let _e3112 = (((((_e798 + _e3075) - _e3097.member) / (_e3103.member - _e3097.member)) * _e3107) - 0.5f);
let _e3113 = (_e3107 - 1f);
let _e3115 = select(0f, _e3112, (_e3112 > 0f));
let _e3117 = select(_e3113, _e3115, (_e3115 < _e3113));
let _e3118 = f32(_e3090);
let _e3123 = (((((_e799 + _e3076) - _e3097.member_1) / (_e3103.member_1 - _e3097.member_1)) * _e3118) - 0.5f);
let _e3124 = (_e3118 - 1f);
let _e3126 = select(0f, _e3123, (_e3123 > 0f));
let _e3128 = select(_e3124, _e3126, (_e3126 < _e3124));
let _e3129 = f32(_e3094);
let _e3134 = (((((_e800 + _e3077) - _e3097.member_2) / (_e3103.member_2 - _e3097.member_2)) * _e3129) - 0.5f);
let _e3135 = (_e3129 - 1f);
let _e3137 = select(0f, _e3134, (_e3134 > 0f));
let _e3139 = select(_e3135, _e3137, (_e3137 < _e3135));
let _e3141 = select(0f, _e3117, (_e3117 > 0f));
let _e3143 = select(1e6f, _e3141, (_e3141 < 1e6f));
let _e3150 = select(0i, select(select(i32(_e3143), i32(-2147483648), (_e3143 < -2147483600f)), 2147483647i, (_e3143 > 2147483500f)), (_e3143 == _e3143));
let _e3154 = (_e3150 - select(0i, 1i, (_e3143 < f32(_e3150))));
let _e3156 = select(0f, _e3128, (_e3128 > 0f));
let _e3158 = select(1e6f, _e3156, (_e3156 < 1e6f));
let _e3165 = select(0i, select(select(i32(_e3158), i32(-2147483648), (_e3158 < -2147483600f)), 2147483647i, (_e3158 > 2147483500f)), (_e3158 == _e3158));
let _e3169 = (_e3165 - select(0i, 1i, (_e3158 < f32(_e3165))));
let _e3171 = select(0f, _e3139, (_e3139 > 0f));
let _e3173 = select(1e6f, _e3171, (_e3171 < 1e6f));
let _e3180 = select(0i, select(select(i32(_e3173), i32(-2147483648), (_e3173 < -2147483600f)), 2147483647i, (_e3173 > 2147483500f)), (_e3173 == _e3173));
let _e3184 = (_e3180 - select(0i, 1i, (_e3173 < f32(_e3180))));
let _e3188 = (_e3128 - f32(_e3169));
let _e3190 = (_e3139 - f32(_e3184));
local_25 = (_e3117 - f32(_e3154));
let _e3191 = (_e3154 + 1i);
let _e3193 = select(_e3191, 0i, (_e3191 < 0i));
if (_e3193 >= _e3086) {
phi_5487_ = (_e3086 - 1i);
} else {
phi_5487_ = _e3193;
}
let _e3197 = phi_5487_;
local_26 = (_e3197 - _e3154);
let _e3199 = (_e3169 + 1i);
let _e3201 = select(_e3199, 0i, (_e3199 < 0i));
if (_e3201 >= _e3090) {
phi_5500_ = (_e3090 - 1i);
} else {
phi_5500_ = _e3201;
}
let _e3205 = phi_5500_;
let _e3207 = ((_e3205 - _e3169) * _e3086);
let _e3208 = (_e3184 + 1i);
let _e3210 = select(_e3208, 0i, (_e3208 < 0i));
if (_e3210 >= _e3094) {
phi_5514_ = (_e3094 - 1i);
} else {
phi_5514_ = _e3210;
}
let _e3214 = phi_5514_;
let _e3220 = global_1.member.member_13.member_10;
let _e3226 = ((bitcast<i32>(_e3220) + (((_e3184 * _e3090) + _e3169) * _e3086)) + _e3154);
let _e3228 = (bitcast<i32>(_e188) - 1i);
let _e3230 = select(_e3228, _e3226, (_e3226 < _e3228));
let _e3235 = global_7.member[bitcast<u32>(select(0i, _e3230, (_e3230 > 0i)))];
let _e3236 = local_25;
let _e3239 = local_26;
let _e3240 = (_e3226 + _e3239);
let _e3242 = select(_e3228, _e3240, (_e3240 < _e3228));
let _e3247 = global_7.member[bitcast<u32>(select(0i, _e3242, (_e3242 > 0i)))];
let _e3248 = local_25;
let _e3251 = (1f - _e3188);
let _e3253 = (_e3226 + _e3207);
let _e3255 = select(_e3228, _e3253, (_e3253 < _e3228));
let _e3260 = global_7.member[bitcast<u32>(select(0i, _e3255, (_e3255 > 0i)))];
let _e3261 = local_25;
let _e3264 = local_26;
let _e3265 = (_e3253 + _e3264);
let _e3267 = select(_e3228, _e3265, (_e3265 < _e3228));
let _e3272 = global_7.member[bitcast<u32>(select(0i, _e3267, (_e3267 > 0i)))];
let _e3273 = local_25;
let _e3278 = (_e3226 + (((_e3214 - _e3184) * _e3086) * _e3090));
let _e3280 = select(_e3228, _e3278, (_e3278 < _e3228));
let _e3285 = global_7.member[bitcast<u32>(select(0i, _e3280, (_e3280 > 0i)))];
let _e3286 = local_25;
let _e3289 = local_26;
let _e3290 = (_e3278 + _e3289);
let _e3292 = select(_e3228, _e3290, (_e3290 < _e3228));
let _e3297 = global_7.member[bitcast<u32>(select(0i, _e3292, (_e3292 > 0i)))];
let _e3298 = local_25;
let _e3302 = (_e3278 + _e3207);
let _e3304 = select(_e3228, _e3302, (_e3302 < _e3228));
let _e3309 = global_7.member[bitcast<u32>(select(0i, _e3304, (_e3304 > 0i)))];
let _e3310 = local_25;
let _e3313 = local_26;
let _e3314 = (_e3302 + _e3313);
let _e3316 = select(_e3228, _e3314, (_e3314 < _e3228));
let _e3321 = global_7.member[bitcast<u32>(select(0i, _e3316, (_e3316 > 0i)))];
let _e3322 = local_25;
phi_5714_ = ((((((_e3235 * (1f - _e3236)) + (_e3247 * _e3248)) * _e3251) + (((_e3260 * (1f - _e3261)) + (_e3272 * _e3273)) * _e3188)) * (1f - _e3190)) + (((((_e3285 * (1f - _e3286)) + (_e3297 * _e3298)) * _e3251) + (((_e3309 * (1f - _e3310)) + (_e3321 * _e3322)) * _e3188)) * _e3190));
}
let _e3332 = phi_5714_;
let _e3333 = (_e2226 - _e1714);
let _e3335 = (1f - (_e3333 * _e3333));
let _e3343 = (_e2226 + _e1714);
let _e3345 = (1f - (_e3343 * _e3343));
let _e3355 = (_e2220 + (_e2506 * (_e2243 - select((_e1668 + (_e1684 * ((2f * _e3333) / select(1e-9f, _e3335, (_e3335 > 1e-9f))))), _e3333, _e1685))));
let _e3360 = (_e3355 + ((0.5f * (_e2506 + _e2782)) * (_e2523 - _e2243)));
let _e3365 = (_e3360 + ((0.5f * (_e2782 + _e3057)) * (_e2798 - _e2523)));
let _e3370 = (_e3365 + ((0.5f * (_e3057 + _e3332)) * (_e3073 - _e2798)));
let _e3371 = (_e2243 - _e881);
let _e3377 = global_1.member.member_10.member_2;
let _e3381 = vec3<f32>(_e3377.member, _e3377.member_1, _e3377.member_2);
let _e3384 = global_1.member.member_10.member;
let _e3385 = (_e3384 == 0u);
if _e3385 {
let _e3723 = global_1.member.member_10.member_1;
phi_6321_ = type_27(vec3<f32>(_e3723.member, _e3723.member_1, _e3723.member_2), _e3381);
} else {
let _e3388 = global_1.member.member_10.member_3;
let _e3393 = (_e2252.x - _e3388.member);
let _e3395 = (_e2252.y - _e3388.member_1);
let _e3397 = (_e2252.z - _e3388.member_2);
let _e3402 = (((_e3393 * _e3393) + (_e3395 * _e3395)) + (_e3397 * _e3397));
let _e3404 = select(1e-12f, _e3402, (_e3402 > 1e-12f));
let _e3405 = (1f / _e3404);
let _e3409 = vec3<f32>((_e3377.member * _e3405), (_e3377.member_1 * _e3405), (_e3377.member_2 * _e3405));
if (_e3384 == 2u) {
let _e3413 = global_1.member.member_10.member_1;
let _e3421 = (((_e3413.member * _e3393) + (_e3413.member_1 * _e3395)) + (_e3413.member_2 * _e3397));
let _e3424 = (1f / select(1e-20f, _e3421, (_e3421 > 1e-20f)));
let _e3428 = global_1.member.member_10.member_4.member;
let _e3437 = ((((_e3428.member * _e3393) + (_e3428.member_1 * _e3395)) + (_e3428.member_2 * _e3397)) * _e3424);
let _e3441 = global_1.member.member_10.member_4.member_1;
let _e3450 = ((((_e3441.member * _e3393) + (_e3441.member_1 * _e3395)) + (_e3441.member_2 * _e3397)) * _e3424);
let _e3454 = global_1.member.member_10.member_4.member_2;
let _e3457 = ((_e3437 * _e3437) + (_e3450 * _e3450));
let _e3465 = global_1.member.member_10.member_4.member_3;
let _e3466 = ((_e3454 - sqrt(select(0f, _e3457, (_e3457 > 0f)))) * _e3465);
let _e3468 = select(0f, _e3466, (_e3466 > 0f));
let _e3470 = select(1f, _e3468, (_e3468 < 1f));
let _e3476 = select(0f, ((_e3470 * _e3470) * (3f - (2f * _e3470))), (_e3421 > 0f));
let _e3480 = global_1.member.member_10.member_4.member_5;
if ((_e3480 > 0u) && (_e3476 > 0f)) {
let _e3485 = (0.5f / _e3454);
let _e3494 = global_1.member.member_10.member_4.member_6;
let _e3495 = bitcast<i32>(_e3494);
local_24 = bitcast<i32>(_e3480);
let _e3496 = local_24;
let _e3498 = f32((_e3496 - 1i));
let _e3500 = f32((_e3495 - 1i));
let _e3501 = local_24;
let _e3504 = (((0.5f + (_e3437 * _e3485)) * f32(_e3501)) - 0.5f);
let _e3506 = select(0f, _e3504, (_e3504 > 0f));
let _e3508 = select(_e3498, _e3506, (_e3506 < _e3498));
let _e3511 = (((0.5f - (_e3450 * _e3485)) * f32(_e3495)) - 0.5f);
let _e3513 = select(0f, _e3511, (_e3511 > 0f));
let _e3515 = select(_e3500, _e3513, (_e3513 < _e3500));
let _e3517 = select(0f, _e3508, (_e3508 > 0f));
let _e3519 = select(_e3498, _e3517, (_e3517 < _e3498));
let _e3526 = select(0i, select(select(i32(_e3519), i32(-2147483648), (_e3519 < -2147483600f)), 2147483647i, (_e3519 > 2147483500f)), (_e3519 == _e3519));
let _e3530 = (_e3526 - select(0i, 1i, (_e3519 < f32(_e3526))));
let _e3532 = select(0f, _e3515, (_e3515 > 0f));
let _e3534 = select(_e3500, _e3532, (_e3532 < _e3500));
let _e3541 = select(0i, select(select(i32(_e3534), i32(-2147483648), (_e3534 < -2147483600f)), 2147483647i, (_e3534 > 2147483500f)), (_e3534 == _e3534));
let _e3545 = (_e3541 - select(0i, 1i, (_e3534 < f32(_e3541))));
let _e3547 = (_e3508 - f32(_e3530));
let _e3549 = (_e3515 - f32(_e3545));
let _e3550 = (_e3530 + 1i);
let _e3551 = local_24;
let _e3553 = select(_e3530, _e3550, (_e3550 < _e3551));
let _e3554 = (_e3545 + 1i);
let _e3556 = select(_e3545, _e3554, (_e3554 < _e3495));
let _e3560 = global_1.member.member_10.member_4.member_4;
let _e3561 = bitcast<i32>(_e3560);
let _e3562 = local_24;
let _e3566 = (_e3561 + (3i * ((_e3545 * _e3562) + _e3530)));
let _e3568 = (bitcast<i32>(_e181) - 1i);
let _e3570 = select(_e3568, _e3566, (_e3566 < _e3568));
let _e3575 = global_3.member[bitcast<u32>(select(0i, _e3570, (_e3570 > 0i)))];
let _e3576 = (_e3566 + 1i);
let _e3578 = select(_e3568, _e3576, (_e3576 < _e3568));
let _e3583 = global_3.member[bitcast<u32>(select(0i, _e3578, (_e3578 > 0i)))];
let _e3584 = (_e3566 + 2i);
let _e3586 = select(_e3568, _e3584, (_e3584 < _e3568));
let _e3591 = global_3.member[bitcast<u32>(select(0i, _e3586, (_e3586 > 0i)))];
let _e3592 = local_24;
let _e3596 = (_e3561 + (3i * ((_e3545 * _e3592) + _e3553)));
let _e3598 = select(_e3568, _e3596, (_e3596 < _e3568));
let _e3603 = global_3.member[bitcast<u32>(select(0i, _e3598, (_e3598 > 0i)))];
let _e3604 = (_e3596 + 1i);
let _e3606 = select(_e3568, _e3604, (_e3604 < _e3568));
let _e3611 = global_3.member[bitcast<u32>(select(0i, _e3606, (_e3606 > 0i)))];
let _e3612 = (_e3596 + 2i);
let _e3614 = select(_e3568, _e3612, (_e3612 < _e3568));
let _e3619 = global_3.member[bitcast<u32>(select(0i, _e3614, (_e3614 > 0i)))];
let _e3620 = local_24;
let _e3624 = (_e3561 + (3i * ((_e3556 * _e3620) + _e3530)));
let _e3626 = select(_e3568, _e3624, (_e3624 < _e3568));
let _e3631 = global_3.member[bitcast<u32>(select(0i, _e3626, (_e3626 > 0i)))];
let _e3632 = (_e3624 + 1i);
let _e3634 = select(_e3568, _e3632, (_e3632 < _e3568));
let _e3639 = global_3.member[bitcast<u32>(select(0i, _e3634, (_e3634 > 0i)))];
let _e3640 = (_e3624 + 2i);
let _e3642 = select(_e3568, _e3640, (_e3640 < _e3568));
let _e3647 = global_3.member[bitcast<u32>(select(0i, _e3642, (_e3642 > 0i)))];
let _e3648 = local_24;
let _e3652 = (_e3561 + (3i * ((_e3556 * _e3648) + _e3553)));
let _e3654 = select(_e3568, _e3652, (_e3652 < _e3568));
let _e3659 = global_3.member[bitcast<u32>(select(0i, _e3654, (_e3654 > 0i)))];
let _e3660 = (_e3652 + 1i);
let _e3662 = select(_e3568, _e3660, (_e3660 < _e3568));
let _e3667 = global_3.member[bitcast<u32>(select(0i, _e3662, (_e3662 > 0i)))];
let _e3668 = (_e3652 + 2i);
let _e3670 = select(_e3568, _e3668, (_e3668 < _e3568));
let _e3675 = global_3.member[bitcast<u32>(select(0i, _e3670, (_e3670 > 0i)))];
let _e3682 = (_e3575 + ((_e3603 - _e3575) * _e3547));
let _e3683 = (_e3583 + ((_e3611 - _e3583) * _e3547));
let _e3684 = (_e3591 + ((_e3619 - _e3591) * _e3547));
phi_6305_ = vec3<f32>(((_e3682 + (((_e3631 + ((_e3659 - _e3631) * _e3547)) - _e3682) * _e3549)) * _e3476), ((_e3683 + (((_e3639 + ((_e3667 - _e3639) * _e3547)) - _e3683) * _e3549)) * _e3476), ((_e3684 + (((_e3647 + ((_e3675 - _e3647) * _e3547)) - _e3684) * _e3549)) * _e3476));
} else {
phi_6305_ = vec3(_e3476);
}
let _e3708 = phi_6305_;
phi_6308_ = (_e3409 * _e3708);
} else {
phi_6308_ = _e3409;
}
let _e3711 = phi_6308_;
let _e3715 = (1f / sqrt(select(0f, _e3404, (_e3404 > 0f))));
phi_6321_ = type_27(vec3<f32>((_e3393 * _e3715), (_e3395 * _e3715), (_e3397 * _e3715)), _e3711);
}
let _e3730 = phi_6321_;
let _e3734 = global_1.member.member_10.member_3;
let _e3739 = (_e3734.member - _e2252.x);
let _e3741 = (_e3734.member_1 - _e2252.y);
let _e3743 = (_e3734.member_2 - _e2252.z);
let _e3748 = (((_e3739 * _e3739) + (_e3741 * _e3741)) + (_e3743 * _e3743));
let _e3752 = select(sqrt(select(0f, _e3748, (_e3748 > 0f))), 1e30f, _e3385);
let _e3754 = -(_e3730.member.x);
let _e3756 = -(_e3730.member.y);
let _e3758 = -(_e3730.member.z);
let _e3766 = (1f / select(_e3754, select(1e-12f, -1e-12f, (_e3754 < 0f)), (bitcast<f32>((bitcast<u32>(_e3754) & 2147483647u)) < 1e-12f)));
let _e3774 = (1f / select(_e3756, select(1e-12f, -1e-12f, (_e3756 < 0f)), (bitcast<f32>((bitcast<u32>(_e3756) & 2147483647u)) < 1e-12f)));
let _e3782 = (1f / select(_e3758, select(1e-12f, -1e-12f, (_e3758 < 0f)), (bitcast<f32>((bitcast<u32>(_e3758) & 2147483647u)) < 1e-12f)));
let _e3785 = global_1.member.member_13.member_4;
let _e3791 = global_1.member.member_13.member_5;
let _e3796 = ((_e3785.member - _e2252.x) * _e3766);
let _e3798 = ((_e3791.member - _e2252.x) * _e3766);
let _e3800 = ((_e3785.member_1 - _e2252.y) * _e3774);
let _e3802 = ((_e3791.member_1 - _e2252.y) * _e3774);
let _e3804 = ((_e3785.member_2 - _e2252.z) * _e3782);
let _e3806 = ((_e3791.member_2 - _e2252.z) * _e3782);
let _e3808 = select(_e3798, _e3796, (_e3796 < _e3798));
let _e3810 = select(_e3802, _e3800, (_e3800 < _e3802));
let _e3812 = select(_e3810, _e3808, (_e3808 > _e3810));
let _e3814 = select(_e3806, _e3804, (_e3804 < _e3806));
let _e3816 = select(_e3814, _e3812, (_e3812 > _e3814));
let _e3818 = select(_e3798, _e3796, (_e3796 > _e3798));
let _e3820 = select(_e3802, _e3800, (_e3800 > _e3802));
let _e3822 = select(_e3820, _e3818, (_e3818 < _e3820));
let _e3824 = select(_e3806, _e3804, (_e3804 > _e3806));
let _e3826 = select(_e3824, _e3822, (_e3822 < _e3824));
let _e3828 = select(0f, _e3816, (_e3816 > 0f));
let _e3830 = select(_e3752, _e3826, (_e3826 < _e3752));
let _e3831 = (_e3830 > _e3828);
let _e3832 = select(0f, _e3828, _e3831);
let _e3834 = (select(0f, _e3830, _e3831) - _e3832);
if _e2256 {
phi_7236_ = _e3834;
} else {
let _e3836 = (_e3834 / f32(_e2255));
phi_6517_ = 0u;
phi_6520_ = 0f;
loop {
let _e3838 = phi_6517_;
let _e3840 = phi_6520_;
local_77 = _e3840;
let _e3843 = ((_e3838 < _e2255) && (_e3834 > 0f));
if _e3843 {
let _e3846 = (_e3832 + (_e3836 * f32(_e3838)));
let _e3847 = (_e3846 + _e3836);
let _e3849 = (0.5f * (_e3846 + _e3847));
let _e3850 = (_e3847 - _e3846);
let _e3851 = (0.28867513f * _e3850);
let _e3852 = (_e3849 - _e3851);
let _e3861 = global_1.member.member_13.member_7;
let _e3862 = bitcast<i32>(_e3861);
let _e3865 = global_1.member.member_13.member_8;
let _e3866 = bitcast<i32>(_e3865);
let _e3869 = global_1.member.member_13.member_9;
let _e3870 = bitcast<i32>(_e3869);
let _e3871 = f32(_e3862);
let _e3873 = (_e3791.member - _e3785.member);
let _e3876 = (((((_e2252.x + (_e3754 * _e3852)) - _e3785.member) / _e3873) * _e3871) - 0.5f);
let _e3877 = (_e3871 - 1f);
let _e3879 = select(0f, _e3876, (_e3876 > 0f));
let _e3881 = select(_e3877, _e3879, (_e3879 < _e3877));
let _e3882 = f32(_e3866);
let _e3884 = (_e3791.member_1 - _e3785.member_1);
let _e3887 = (((((_e2252.y + (_e3756 * _e3852)) - _e3785.member_1) / _e3884) * _e3882) - 0.5f);
let _e3888 = (_e3882 - 1f);
let _e3890 = select(0f, _e3887, (_e3887 > 0f));
let _e3892 = select(_e3888, _e3890, (_e3890 < _e3888));
let _e3893 = f32(_e3870);
let _e3895 = (_e3791.member_2 - _e3785.member_2);
let _e3898 = (((((_e2252.z + (_e3758 * _e3852)) - _e3785.member_2) / _e3895) * _e3893) - 0.5f);
let _e3899 = (_e3893 - 1f);
let _e3901 = select(0f, _e3898, (_e3898 > 0f));
let _e3903 = select(_e3899, _e3901, (_e3901 < _e3899));
let _e3905 = select(0f, _e3881, (_e3881 > 0f));
let _e3907 = select(1e6f, _e3905, (_e3905 < 1e6f));
let _e3914 = select(0i, select(select(i32(_e3907), i32(-2147483648), (_e3907 < -2147483600f)), 2147483647i, (_e3907 > 2147483500f)), (_e3907 == _e3907));
let _e3918 = (_e3914 - select(0i, 1i, (_e3907 < f32(_e3914))));
let _e3920 = select(0f, _e3892, (_e3892 > 0f));
let _e3922 = select(1e6f, _e3920, (_e3920 < 1e6f));
let _e3929 = select(0i, select(select(i32(_e3922), i32(-2147483648), (_e3922 < -2147483600f)), 2147483647i, (_e3922 > 2147483500f)), (_e3922 == _e3922));
let _e3933 = (_e3929 - select(0i, 1i, (_e3922 < f32(_e3929))));
let _e3935 = select(0f, _e3903, (_e3903 > 0f));
let _e3937 = select(1e6f, _e3935, (_e3935 < 1e6f));
let _e3944 = select(0i, select(select(i32(_e3937), i32(-2147483648), (_e3937 < -2147483600f)), 2147483647i, (_e3937 > 2147483500f)), (_e3937 == _e3937));
let _e3948 = (_e3944 - select(0i, 1i, (_e3937 < f32(_e3944))));
let _e3952 = (_e3892 - f32(_e3933));
let _e3954 = (_e3903 - f32(_e3948));
local_22 = (_e3881 - f32(_e3918));
let _e3955 = (_e3918 + 1i);
let _e3957 = select(_e3955, 0i, (_e3955 < 0i));
if (_e3957 >= _e3862) {
phi_6658_ = (_e3862 - 1i);
} else {
phi_6658_ = _e3957;
}
let _e3961 = phi_6658_;
local_23 = (_e3961 - _e3918);
let _e3963 = (_e3933 + 1i);
let _e3965 = select(_e3963, 0i, (_e3963 < 0i));
if (_e3965 >= _e3866) {
phi_6671_ = (_e3866 - 1i);
} else {
phi_6671_ = _e3965;
}
let _e3969 = phi_6671_;
let _e3971 = ((_e3969 - _e3933) * _e3862);
let _e3972 = (_e3948 + 1i);
let _e3974 = select(_e3972, 0i, (_e3972 < 0i));
if (_e3974 >= _e3870) {
phi_6685_ = (_e3870 - 1i);
} else {
phi_6685_ = _e3974;
}
let _e3978 = phi_6685_;
let _e3984 = global_1.member.member_13.member_10;
let _e3985 = bitcast<i32>(_e3984);
let _e3990 = ((_e3985 + (((_e3948 * _e3866) + _e3933) * _e3862)) + _e3918);
let _e3992 = (bitcast<i32>(_e188) - 1i);
let _e3994 = select(_e3992, _e3990, (_e3990 < _e3992));
let _e3999 = global_7.member[bitcast<u32>(select(0i, _e3994, (_e3994 > 0i)))];
let _e4000 = local_22;
let _e4003 = local_23;
let _e4004 = (_e3990 + _e4003);
let _e4006 = select(_e3992, _e4004, (_e4004 < _e3992));
let _e4011 = global_7.member[bitcast<u32>(select(0i, _e4006, (_e4006 > 0i)))];
let _e4012 = local_22;
let _e4015 = (1f - _e3952);
let _e4017 = (_e3990 + _e3971);
let _e4019 = select(_e3992, _e4017, (_e4017 < _e3992));
let _e4024 = global_7.member[bitcast<u32>(select(0i, _e4019, (_e4019 > 0i)))];
let _e4025 = local_22;
let _e4028 = local_23;
let _e4029 = (_e4017 + _e4028);
let _e4031 = select(_e3992, _e4029, (_e4029 < _e3992));
let _e4036 = global_7.member[bitcast<u32>(select(0i, _e4031, (_e4031 > 0i)))];
let _e4037 = local_22;
let _e4042 = (_e3990 + (((_e3978 - _e3948) * _e3862) * _e3866));
let _e4044 = select(_e3992, _e4042, (_e4042 < _e3992));
let _e4049 = global_7.member[bitcast<u32>(select(0i, _e4044, (_e4044 > 0i)))];
let _e4050 = local_22;
let _e4053 = local_23;
let _e4054 = (_e4042 + _e4053);
let _e4056 = select(_e3992, _e4054, (_e4054 < _e3992));
let _e4061 = global_7.member[bitcast<u32>(select(0i, _e4056, (_e4056 > 0i)))];
let _e4062 = local_22;
let _e4066 = (_e4042 + _e3971);
let _e4068 = select(_e3992, _e4066, (_e4066 < _e3992));
let _e4073 = global_7.member[bitcast<u32>(select(0i, _e4068, (_e4068 > 0i)))];
let _e4074 = local_22;
let _e4077 = local_23;
let _e4078 = (_e4066 + _e4077);
let _e4080 = select(_e3992, _e4078, (_e4078 < _e3992));
let _e4085 = global_7.member[bitcast<u32>(select(0i, _e4080, (_e4080 > 0i)))];
let _e4086 = local_22;
let _e4095 = (_e3849 + _e3851);
let _e4105 = (((((_e2252.x + (_e3754 * _e4095)) - _e3785.member) / _e3873) * _e3871) - 0.5f);
let _e4107 = select(0f, _e4105, (_e4105 > 0f));
let _e4109 = select(_e3877, _e4107, (_e4107 < _e3877));
let _e4113 = (((((_e2252.y + (_e3756 * _e4095)) - _e3785.member_1) / _e3884) * _e3882) - 0.5f);
let _e4115 = select(0f, _e4113, (_e4113 > 0f));
let _e4117 = select(_e3888, _e4115, (_e4115 < _e3888));
let _e4121 = (((((_e2252.z + (_e3758 * _e4095)) - _e3785.member_2) / _e3895) * _e3893) - 0.5f);
let _e4123 = select(0f, _e4121, (_e4121 > 0f));
let _e4125 = select(_e3899, _e4123, (_e4123 < _e3899));
let _e4127 = select(0f, _e4109, (_e4109 > 0f));
let _e4129 = select(1e6f, _e4127, (_e4127 < 1e6f));
let _e4136 = select(0i, select(select(i32(_e4129), i32(-2147483648), (_e4129 < -2147483600f)), 2147483647i, (_e4129 > 2147483500f)), (_e4129 == _e4129));
let _e4140 = (_e4136 - select(0i, 1i, (_e4129 < f32(_e4136))));
let _e4142 = select(0f, _e4117, (_e4117 > 0f));
let _e4144 = select(1e6f, _e4142, (_e4142 < 1e6f));
let _e4151 = select(0i, select(select(i32(_e4144), i32(-2147483648), (_e4144 < -2147483600f)), 2147483647i, (_e4144 > 2147483500f)), (_e4144 == _e4144));
let _e4155 = (_e4151 - select(0i, 1i, (_e4144 < f32(_e4151))));
let _e4157 = select(0f, _e4125, (_e4125 > 0f));
let _e4159 = select(1e6f, _e4157, (_e4157 < 1e6f));
let _e4166 = select(0i, select(select(i32(_e4159), i32(-2147483648), (_e4159 < -2147483600f)), 2147483647i, (_e4159 > 2147483500f)), (_e4159 == _e4159));
let _e4170 = (_e4166 - select(0i, 1i, (_e4159 < f32(_e4166))));
let _e4174 = (_e4117 - f32(_e4155));
let _e4176 = (_e4125 - f32(_e4170));
local_20 = (_e4109 - f32(_e4140));
let _e4177 = (_e4140 + 1i);
let _e4179 = select(_e4177, 0i, (_e4177 < 0i));
if (_e4179 >= _e3862) {
phi_7004_ = (_e3862 - 1i);
} else {
phi_7004_ = _e4179;
}
let _e4183 = phi_7004_;
local_21 = (_e4183 - _e4140);
let _e4185 = (_e4155 + 1i);
let _e4187 = select(_e4185, 0i, (_e4185 < 0i));
if (_e4187 >= _e3866) {
phi_7017_ = (_e3866 - 1i);
} else {
phi_7017_ = _e4187;
}
let _e4191 = phi_7017_;
let _e4193 = ((_e4191 - _e4155) * _e3862);
let _e4194 = (_e4170 + 1i);
let _e4196 = select(_e4194, 0i, (_e4194 < 0i));
if (_e4196 >= _e3870) {
phi_7031_ = (_e3870 - 1i);
} else {
phi_7031_ = _e4196;
}
let _e4200 = phi_7031_;
let _e4208 = ((_e3985 + (((_e4170 * _e3866) + _e4155) * _e3862)) + _e4140);
let _e4210 = select(_e3992, _e4208, (_e4208 < _e3992));
let _e4215 = global_7.member[bitcast<u32>(select(0i, _e4210, (_e4210 > 0i)))];
let _e4216 = local_20;
let _e4219 = local_21;
let _e4220 = (_e4208 + _e4219);
let _e4222 = select(_e3992, _e4220, (_e4220 < _e3992));
let _e4227 = global_7.member[bitcast<u32>(select(0i, _e4222, (_e4222 > 0i)))];
let _e4228 = local_20;
let _e4231 = (1f - _e4174);
let _e4233 = (_e4208 + _e4193);
let _e4235 = select(_e3992, _e4233, (_e4233 < _e3992));
let _e4240 = global_7.member[bitcast<u32>(select(0i, _e4235, (_e4235 > 0i)))];
let _e4241 = local_20;
let _e4244 = local_21;
let _e4245 = (_e4233 + _e4244);
let _e4247 = select(_e3992, _e4245, (_e4245 < _e3992));
let _e4252 = global_7.member[bitcast<u32>(select(0i, _e4247, (_e4247 > 0i)))];
let _e4253 = local_20;
let _e4258 = (_e4208 + (((_e4200 - _e4170) * _e3862) * _e3866));
let _e4260 = select(_e3992, _e4258, (_e4258 < _e3992));
let _e4265 = global_7.member[bitcast<u32>(select(0i, _e4260, (_e4260 > 0i)))];
let _e4266 = local_20;
let _e4269 = local_21;
let _e4270 = (_e4258 + _e4269);
let _e4272 = select(_e3992, _e4270, (_e4270 < _e3992));
let _e4277 = global_7.member[bitcast<u32>(select(0i, _e4272, (_e4272 > 0i)))];
let _e4278 = local_20;
let _e4282 = (_e4258 + _e4193);
let _e4284 = select(_e3992, _e4282, (_e4282 < _e3992));
let _e4289 = global_7.member[bitcast<u32>(select(0i, _e4284, (_e4284 > 0i)))];
let _e4290 = local_20;
let _e4293 = local_21;
let _e4294 = (_e4282 + _e4293);
let _e4296 = select(_e3992, _e4294, (_e4294 < _e3992));
let _e4301 = global_7.member[bitcast<u32>(select(0i, _e4296, (_e4296 > 0i)))];
let _e4302 = local_20;
phi_6518_ = (_e3838 + 1u);
phi_6521_ = (_e3840 + ((0.5f * (((((((_e3999 * (1f - _e4000)) + (_e4011 * _e4012)) * _e4015) + (((_e4024 * (1f - _e4025)) + (_e4036 * _e4037)) * _e3952)) * (1f - _e3954)) + (((((_e4049 * (1f - _e4050)) + (_e4061 * _e4062)) * _e4015) + (((_e4073 * (1f - _e4074)) + (_e4085 * _e4086)) * _e3952)) * _e3954)) + ((((((_e4215 * (1f - _e4216)) + (_e4227 * _e4228)) * _e4231) + (((_e4240 * (1f - _e4241)) + (_e4252 * _e4253)) * _e4174)) * (1f - _e4176)) + (((((_e4265 * (1f - _e4266)) + (_e4277 * _e4278)) * _e4231) + (((_e4289 * (1f - _e4290)) + (_e4301 * _e4302)) * _e4174)) * _e4176)))) * _e3850));
} else {
phi_6518_ = u32();
phi_6521_ = f32();
}
let _e4317 = phi_6518_;
let _e4319 = phi_6521_;
continue;
continuing {
phi_6517_ = _e4317;
phi_6520_ = _e4319;
break if !(_e3843);
}
}
let _e11375 = local_77;
phi_7236_ = _e11375;
}
let _e4322 = phi_7236_;
let _e4323 = (_e4322 + select(_e3355, select(0f, _e3371, (_e3371 > 0f)), _e888));
let _e4326 = global_1.member.member_13.member;
let _e4331 = -((_e4326.member * _e4323));
let _e4333 = select(-87f, _e4331, (_e4331 > -87f));
let _e4335 = select(88f, _e4333, (_e4333 < 88f));
let _e4337 = ((_e4335 * 1.442695f) + 0.5f);
let _e4339 = select(-127f, _e4337, (_e4337 > -127f));
let _e4341 = select(128f, _e4339, (_e4339 < 128f));
let _e4348 = select(0i, select(select(i32(_e4341), i32(-2147483648), (_e4341 < -2147483600f)), 2147483647i, (_e4341 > 2147483500f)), (_e4341 == _e4341));
let _e4352 = (_e4348 - select(0i, 1i, (_e4341 < f32(_e4348))));
let _e4353 = f32(_e4352);
let _e4357 = ((_e4335 - (_e4353 * 0.6933594f)) - (_e4353 * -2.1219444e-4f));
let _e4379 = -((_e4326.member_1 * _e4323));
let _e4381 = select(-87f, _e4379, (_e4379 > -87f));
let _e4383 = select(88f, _e4381, (_e4381 < 88f));
let _e4385 = ((_e4383 * 1.442695f) + 0.5f);
let _e4387 = select(-127f, _e4385, (_e4385 > -127f));
let _e4389 = select(128f, _e4387, (_e4387 < 128f));
let _e4396 = select(0i, select(select(i32(_e4389), i32(-2147483648), (_e4389 < -2147483600f)), 2147483647i, (_e4389 > 2147483500f)), (_e4389 == _e4389));
let _e4400 = (_e4396 - select(0i, 1i, (_e4389 < f32(_e4396))));
let _e4401 = f32(_e4400);
let _e4405 = ((_e4383 - (_e4401 * 0.6933594f)) - (_e4401 * -2.1219444e-4f));
let _e4427 = -((_e4326.member_2 * _e4323));
let _e4429 = select(-87f, _e4427, (_e4427 > -87f));
let _e4431 = select(88f, _e4429, (_e4429 < 88f));
let _e4433 = ((_e4431 * 1.442695f) + 0.5f);
let _e4435 = select(-127f, _e4433, (_e4433 > -127f));
let _e4437 = select(128f, _e4435, (_e4435 < 128f));
let _e4444 = select(0i, select(select(i32(_e4437), i32(-2147483648), (_e4437 < -2147483600f)), 2147483647i, (_e4437 > 2147483500f)), (_e4437 == _e4437));
let _e4448 = (_e4444 - select(0i, 1i, (_e4437 < f32(_e4444))));
let _e4449 = f32(_e4448);
let _e4453 = ((_e4431 - (_e4449 * 0.6933594f)) - (_e4449 * -2.1219444e-4f));
let _e4479 = -((((_e3730.member.x * _e547) + (_e3730.member.y * _e558)) + (_e3730.member.z * _e569)));
let _e4482 = global_1.member.member_13.member_2;
let _e4483 = (_e4482 * _e4482);
let _e4484 = (1f + _e4483);
let _e4485 = (2f * _e4482);
let _e4487 = (_e4484 - (_e4485 * _e4479));
let _e4489 = select(1e-9f, _e4487, (_e4487 > 1e-9f));
let _e4490 = (1f - _e4483);
let _e4501 = global_1.member.member_13.member_3;
let _e4502 = (_e4501 == 1u);
let _e4504 = (_e4501 == 2u);
if _e4504 {
let _e4506 = (0.5f - (0.5f * _e4479));
let _e4508 = select(0f, _e4506, (_e4506 > 0f));
let _e4512 = (sqrt(select(0f, _e4508, (_e4508 > 0f))) * 255f);
let _e4513 = (255f - 1f);
let _e4515 = select(0f, _e4512, (_e4512 > 0f));
let _e4517 = select(_e4513, _e4515, (_e4515 < _e4513));
let _e4524 = select(0i, select(select(i32(_e4517), i32(-2147483648), (_e4517 < -2147483600f)), 2147483647i, (_e4517 > 2147483500f)), (_e4517 == _e4517));
let _e4528 = (_e4524 - select(0i, 1i, (_e4517 < f32(_e4524))));
let _e4531 = global_1.member.member_13.member_11;
let _e4532 = bitcast<i32>(_e4531);
let _e4533 = (_e4532 + _e4528);
let _e4535 = (bitcast<i32>(_e188) - 1i);
let _e4537 = select(_e4535, _e4533, (_e4533 < _e4535));
let _e4542 = global_7.member[bitcast<u32>(select(0i, _e4537, (_e4537 > 0i)))];
let _e4544 = (_e4532 + (_e4528 + 1i));
let _e4546 = select(_e4535, _e4544, (_e4544 < _e4535));
let _e4551 = global_7.member[bitcast<u32>(select(0i, _e4546, (_e4546 > 0i)))];
phi_7597_ = (_e4542 + ((_e4551 - _e4542) * (_e4512 - f32(_e4528))));
} else {
phi_7597_ = select((_e4490 / (_e4489 * sqrt(select(0f, _e4489, (_e4489 > 0f))))), (0.75f * (1f + (_e4479 * _e4479))), _e4502);
}
let _e4558 = phi_7597_;
let _e4559 = (0.25f / 3.1415927f);
let _e4563 = ((3.1415927f * (_e4558 * _e4559)) * (select((_e1684 * ((2f * (1f + _e2230)) / (_e2233 * _e2233))), 1f, _e1685) * _e2506));
let _e4573 = global_1.member.member_13.member_1;
let _e4583 = (_e3073 - _e881);
if _e3385 {
let _e4918 = global_1.member.member_10.member_1;
phi_8167_ = type_27(vec3<f32>(_e4918.member, _e4918.member_1, _e4918.member_2), _e3381);
} else {
let _e4588 = (_e3082.x - _e3734.member);
let _e4590 = (_e3082.y - _e3734.member_1);
let _e4592 = (_e3082.z - _e3734.member_2);
let _e4597 = (((_e4588 * _e4588) + (_e4590 * _e4590)) + (_e4592 * _e4592));
let _e4599 = select(1e-12f, _e4597, (_e4597 > 1e-12f));
let _e4600 = (1f / _e4599);
let _e4604 = vec3<f32>((_e3377.member * _e4600), (_e3377.member_1 * _e4600), (_e3377.member_2 * _e4600));
if (_e3384 == 2u) {
let _e4608 = global_1.member.member_10.member_1;
let _e4616 = (((_e4608.member * _e4588) + (_e4608.member_1 * _e4590)) + (_e4608.member_2 * _e4592));
let _e4619 = (1f / select(1e-20f, _e4616, (_e4616 > 1e-20f)));
let _e4623 = global_1.member.member_10.member_4.member;
let _e4632 = ((((_e4623.member * _e4588) + (_e4623.member_1 * _e4590)) + (_e4623.member_2 * _e4592)) * _e4619);
let _e4636 = global_1.member.member_10.member_4.member_1;
let _e4645 = ((((_e4636.member * _e4588) + (_e4636.member_1 * _e4590)) + (_e4636.member_2 * _e4592)) * _e4619);
let _e4649 = global_1.member.member_10.member_4.member_2;
let _e4652 = ((_e4632 * _e4632) + (_e4645 * _e4645));
let _e4660 = global_1.member.member_10.member_4.member_3;
let _e4661 = ((_e4649 - sqrt(select(0f, _e4652, (_e4652 > 0f)))) * _e4660);
let _e4663 = select(0f, _e4661, (_e4661 > 0f));
let _e4665 = select(1f, _e4663, (_e4663 < 1f));
let _e4671 = select(0f, ((_e4665 * _e4665) * (3f - (2f * _e4665))), (_e4616 > 0f));
let _e4675 = global_1.member.member_10.member_4.member_5;
if ((_e4675 > 0u) && (_e4671 > 0f)) {
let _e4680 = (0.5f / _e4649);
let _e4689 = global_1.member.member_10.member_4.member_6;
let _e4690 = bitcast<i32>(_e4689);
local_19 = bitcast<i32>(_e4675);
let _e4691 = local_19;
let _e4693 = f32((_e4691 - 1i));
let _e4695 = f32((_e4690 - 1i));
let _e4696 = local_19;
let _e4699 = (((0.5f + (_e4632 * _e4680)) * f32(_e4696)) - 0.5f);
let _e4701 = select(0f, _e4699, (_e4699 > 0f));
let _e4703 = select(_e4693, _e4701, (_e4701 < _e4693));
let _e4706 = (((0.5f - (_e4645 * _e4680)) * f32(_e4690)) - 0.5f);
let _e4708 = select(0f, _e4706, (_e4706 > 0f));
let _e4710 = select(_e4695, _e4708, (_e4708 < _e4695));
let _e4712 = select(0f, _e4703, (_e4703 > 0f));
let _e4714 = select(_e4693, _e4712, (_e4712 < _e4693));
let _e4721 = select(0i, select(select(i32(_e4714), i32(-2147483648), (_e4714 < -2147483600f)), 2147483647i, (_e4714 > 2147483500f)), (_e4714 == _e4714));
let _e4725 = (_e4721 - select(0i, 1i, (_e4714 < f32(_e4721))));
let _e4727 = select(0f, _e4710, (_e4710 > 0f));
let _e4729 = select(_e4695, _e4727, (_e4727 < _e4695));
let _e4736 = select(0i, select(select(i32(_e4729), i32(-2147483648), (_e4729 < -2147483600f)), 2147483647i, (_e4729 > 2147483500f)), (_e4729 == _e4729));
let _e4740 = (_e4736 - select(0i, 1i, (_e4729 < f32(_e4736))));
let _e4742 = (_e4703 - f32(_e4725));
let _e4744 = (_e4710 - f32(_e4740));
let _e4745 = (_e4725 + 1i);
let _e4746 = local_19;
let _e4748 = select(_e4725, _e4745, (_e4745 < _e4746));
let _e4749 = (_e4740 + 1i);
let _e4751 = select(_e4740, _e4749, (_e4749 < _e4690));
let _e4755 = global_1.member.member_10.member_4.member_4;
let _e4756 = bitcast<i32>(_e4755);
let _e4757 = local_19;
let _e4761 = (_e4756 + (3i * ((_e4740 * _e4757) + _e4725)));
let _e4763 = (bitcast<i32>(_e181) - 1i);
let _e4765 = select(_e4763, _e4761, (_e4761 < _e4763));
let _e4770 = global_3.member[bitcast<u32>(select(0i, _e4765, (_e4765 > 0i)))];
let _e4771 = (_e4761 + 1i);
let _e4773 = select(_e4763, _e4771, (_e4771 < _e4763));
let _e4778 = global_3.member[bitcast<u32>(select(0i, _e4773, (_e4773 > 0i)))];
let _e4779 = (_e4761 + 2i);
let _e4781 = select(_e4763, _e4779, (_e4779 < _e4763));
let _e4786 = global_3.member[bitcast<u32>(select(0i, _e4781, (_e4781 > 0i)))];
let _e4787 = local_19;
let _e4791 = (_e4756 + (3i * ((_e4740 * _e4787) + _e4748)));
let _e4793 = select(_e4763, _e4791, (_e4791 < _e4763));
let _e4798 = global_3.member[bitcast<u32>(select(0i, _e4793, (_e4793 > 0i)))];
let _e4799 = (_e4791 + 1i);
let _e4801 = select(_e4763, _e4799, (_e4799 < _e4763));
let _e4806 = global_3.member[bitcast<u32>(select(0i, _e4801, (_e4801 > 0i)))];
let _e4807 = (_e4791 + 2i);
let _e4809 = select(_e4763, _e4807, (_e4807 < _e4763));
let _e4814 = global_3.member[bitcast<u32>(select(0i, _e4809, (_e4809 > 0i)))];
let _e4815 = local_19;
let _e4819 = (_e4756 + (3i * ((_e4751 * _e4815) + _e4725)));
let _e4821 = select(_e4763, _e4819, (_e4819 < _e4763));
let _e4826 = global_3.member[bitcast<u32>(select(0i, _e4821, (_e4821 > 0i)))];
let _e4827 = (_e4819 + 1i);
let _e4829 = select(_e4763, _e4827, (_e4827 < _e4763));
let _e4834 = global_3.member[bitcast<u32>(select(0i, _e4829, (_e4829 > 0i)))];
let _e4835 = (_e4819 + 2i);
let _e4837 = select(_e4763, _e4835, (_e4835 < _e4763));
let _e4842 = global_3.member[bitcast<u32>(select(0i, _e4837, (_e4837 > 0i)))];
let _e4843 = local_19;
let _e4847 = (_e4756 + (3i * ((_e4751 * _e4843) + _e4748)));
let _e4849 = select(_e4763, _e4847, (_e4847 < _e4763));
let _e4854 = global_3.member[bitcast<u32>(select(0i, _e4849, (_e4849 > 0i)))];
let _e4855 = (_e4847 + 1i);
let _e4857 = select(_e4763, _e4855, (_e4855 < _e4763));
let _e4862 = global_3.member[bitcast<u32>(select(0i, _e4857, (_e4857 > 0i)))];
let _e4863 = (_e4847 + 2i);
let _e4865 = select(_e4763, _e4863, (_e4863 < _e4763));
let _e4870 = global_3.member[bitcast<u32>(select(0i, _e4865, (_e4865 > 0i)))];
let _e4877 = (_e4770 + ((_e4798 - _e4770) * _e4742));
let _e4878 = (_e4778 + ((_e4806 - _e4778) * _e4742));
let _e4879 = (_e4786 + ((_e4814 - _e4786) * _e4742));
phi_8151_ = vec3<f32>(((_e4877 + (((_e4826 + ((_e4854 - _e4826) * _e4742)) - _e4877) * _e4744)) * _e4671), ((_e4878 + (((_e4834 + ((_e4862 - _e4834) * _e4742)) - _e4878) * _e4744)) * _e4671), ((_e4879 + (((_e4842 + ((_e4870 - _e4842) * _e4742)) - _e4879) * _e4744)) * _e4671));
} else {
phi_8151_ = vec3(_e4671);
}
let _e4903 = phi_8151_;
phi_8154_ = (_e4604 * _e4903);
} else {
phi_8154_ = _e4604;
}
let _e4906 = phi_8154_;
let _e4910 = (1f / sqrt(select(0f, _e4599, (_e4599 > 0f))));
phi_8167_ = type_27(vec3<f32>((_e4588 * _e4910), (_e4590 * _e4910), (_e4592 * _e4910)), _e4906);
}
let _e4925 = phi_8167_;
let _e4928 = (_e3734.member - _e3082.x);
let _e4930 = (_e3734.member_1 - _e3082.y);
let _e4932 = (_e3734.member_2 - _e3082.z);
let _e4937 = (((_e4928 * _e4928) + (_e4930 * _e4930)) + (_e4932 * _e4932));
let _e4941 = select(sqrt(select(0f, _e4937, (_e4937 > 0f))), 1e30f, _e3385);
let _e4943 = -(_e4925.member.x);
let _e4945 = -(_e4925.member.y);
let _e4947 = -(_e4925.member.z);
let _e4955 = (1f / select(_e4943, select(1e-12f, -1e-12f, (_e4943 < 0f)), (bitcast<f32>((bitcast<u32>(_e4943) & 2147483647u)) < 1e-12f)));
let _e4963 = (1f / select(_e4945, select(1e-12f, -1e-12f, (_e4945 < 0f)), (bitcast<f32>((bitcast<u32>(_e4945) & 2147483647u)) < 1e-12f)));
let _e4971 = (1f / select(_e4947, select(1e-12f, -1e-12f, (_e4947 < 0f)), (bitcast<f32>((bitcast<u32>(_e4947) & 2147483647u)) < 1e-12f)));
let _e4973 = ((_e3785.member - _e3082.x) * _e4955);
let _e4975 = ((_e3791.member - _e3082.x) * _e4955);
let _e4977 = ((_e3785.member_1 - _e3082.y) * _e4963);
let _e4979 = ((_e3791.member_1 - _e3082.y) * _e4963);
let _e4981 = ((_e3785.member_2 - _e3082.z) * _e4971);
let _e4983 = ((_e3791.member_2 - _e3082.z) * _e4971);
let _e4985 = select(_e4975, _e4973, (_e4973 < _e4975));
let _e4987 = select(_e4979, _e4977, (_e4977 < _e4979));
let _e4989 = select(_e4987, _e4985, (_e4985 > _e4987));
let _e4991 = select(_e4983, _e4981, (_e4981 < _e4983));
let _e4993 = select(_e4991, _e4989, (_e4989 > _e4991));
let _e4995 = select(_e4975, _e4973, (_e4973 > _e4975));
let _e4997 = select(_e4979, _e4977, (_e4977 > _e4979));
let _e4999 = select(_e4997, _e4995, (_e4995 < _e4997));
let _e5001 = select(_e4983, _e4981, (_e4981 > _e4983));
let _e5003 = select(_e5001, _e4999, (_e4999 < _e5001));
let _e5005 = select(0f, _e4993, (_e4993 > 0f));
let _e5007 = select(_e4941, _e5003, (_e5003 < _e4941));
let _e5008 = (_e5007 > _e5005);
let _e5009 = select(0f, _e5005, _e5008);
let _e5011 = (select(0f, _e5007, _e5008) - _e5009);
if _e2256 {
phi_9082_ = _e5011;
} else {
let _e5013 = (_e5011 / f32(_e2255));
phi_8363_ = 0u;
phi_8366_ = 0f;
loop {
let _e5015 = phi_8363_;
let _e5017 = phi_8366_;
local_78 = _e5017;
let _e5020 = ((_e5015 < _e2255) && (_e5011 > 0f));
if _e5020 {
let _e5023 = (_e5009 + (_e5013 * f32(_e5015)));
let _e5024 = (_e5023 + _e5013);
let _e5026 = (0.5f * (_e5023 + _e5024));
let _e5027 = (_e5024 - _e5023);
let _e5028 = (0.28867513f * _e5027);
let _e5029 = (_e5026 - _e5028);
let _e5038 = global_1.member.member_13.member_7;
let _e5039 = bitcast<i32>(_e5038);
let _e5042 = global_1.member.member_13.member_8;
let _e5043 = bitcast<i32>(_e5042);
let _e5046 = global_1.member.member_13.member_9;
let _e5047 = bitcast<i32>(_e5046);
let _e5048 = f32(_e5039);
let _e5050 = (_e3791.member - _e3785.member);
let _e5053 = (((((_e3082.x + (_e4943 * _e5029)) - _e3785.member) / _e5050) * _e5048) - 0.5f);
let _e5054 = (_e5048 - 1f);
let _e5056 = select(0f, _e5053, (_e5053 > 0f));
let _e5058 = select(_e5054, _e5056, (_e5056 < _e5054));
let _e5059 = f32(_e5043);
let _e5061 = (_e3791.member_1 - _e3785.member_1);
let _e5064 = (((((_e3082.y + (_e4945 * _e5029)) - _e3785.member_1) / _e5061) * _e5059) - 0.5f);
let _e5065 = (_e5059 - 1f);
let _e5067 = select(0f, _e5064, (_e5064 > 0f));
let _e5069 = select(_e5065, _e5067, (_e5067 < _e5065));
let _e5070 = f32(_e5047);
let _e5072 = (_e3791.member_2 - _e3785.member_2);
let _e5075 = (((((_e3082.z + (_e4947 * _e5029)) - _e3785.member_2) / _e5072) * _e5070) - 0.5f);
let _e5076 = (_e5070 - 1f);
let _e5078 = select(0f, _e5075, (_e5075 > 0f));
let _e5080 = select(_e5076, _e5078, (_e5078 < _e5076));
let _e5082 = select(0f, _e5058, (_e5058 > 0f));
let _e5084 = select(1e6f, _e5082, (_e5082 < 1e6f));
let _e5091 = select(0i, select(select(i32(_e5084), i32(-2147483648), (_e5084 < -2147483600f)), 2147483647i, (_e5084 > 2147483500f)), (_e5084 == _e5084));
let _e5095 = (_e5091 - select(0i, 1i, (_e5084 < f32(_e5091))));
let _e5097 = select(0f, _e5069, (_e5069 > 0f));
let _e5099 = select(1e6f, _e5097, (_e5097 < 1e6f));
let _e5106 = select(0i, select(select(i32(_e5099), i32(-2147483648), (_e5099 < -2147483600f)), 2147483647i, (_e5099 > 2147483500f)), (_e5099 == _e5099));
let _e5110 = (_e5106 - select(0i, 1i, (_e5099 < f32(_e5106))));
let _e5112 = select(0f, _e5080, (_e5080 > 0f));
let _e5114 = select(1e6f, _e5112, (_e5112 < 1e6f));
let _e5121 = select(0i, select(select(i32(_e5114), i32(-2147483648), (_e5114 < -2147483600f)), 2147483647i, (_e5114 > 2147483500f)), (_e5114 == _e5114));
let _e5125 = (_e5121 - select(0i, 1i, (_e5114 < f32(_e5121))));
let _e5129 = (_e5069 - f32(_e5110));
let _e5131 = (_e5080 - f32(_e5125));
local_17 = (_e5058 - f32(_e5095));
let _e5132 = (_e5095 + 1i);
let _e5134 = select(_e5132, 0i, (_e5132 < 0i));
if (_e5134 >= _e5039) {
phi_8504_ = (_e5039 - 1i);
} else {
phi_8504_ = _e5134;
}
let _e5138 = phi_8504_;
local_18 = (_e5138 - _e5095);
let _e5140 = (_e5110 + 1i);
let _e5142 = select(_e5140, 0i, (_e5140 < 0i));
if (_e5142 >= _e5043) {
phi_8517_ = (_e5043 - 1i);
} else {
phi_8517_ = _e5142;
}
let _e5146 = phi_8517_;
let _e5148 = ((_e5146 - _e5110) * _e5039);
let _e5149 = (_e5125 + 1i);
let _e5151 = select(_e5149, 0i, (_e5149 < 0i));
if (_e5151 >= _e5047) {
phi_8531_ = (_e5047 - 1i);
} else {
phi_8531_ = _e5151;
}
let _e5155 = phi_8531_;
let _e5161 = global_1.member.member_13.member_10;
let _e5162 = bitcast<i32>(_e5161);
let _e5167 = ((_e5162 + (((_e5125 * _e5043) + _e5110) * _e5039)) + _e5095);
let _e5169 = (bitcast<i32>(_e188) - 1i);
let _e5171 = select(_e5169, _e5167, (_e5167 < _e5169));
let _e5176 = global_7.member[bitcast<u32>(select(0i, _e5171, (_e5171 > 0i)))];
let _e5177 = local_17;
let _e5180 = local_18;
let _e5181 = (_e5167 + _e5180);
let _e5183 = select(_e5169, _e5181, (_e5181 < _e5169));
let _e5188 = global_7.member[bitcast<u32>(select(0i, _e5183, (_e5183 > 0i)))];
let _e5189 = local_17;
let _e5192 = (1f - _e5129);
let _e5194 = (_e5167 + _e5148);
let _e5196 = select(_e5169, _e5194, (_e5194 < _e5169));
let _e5201 = global_7.member[bitcast<u32>(select(0i, _e5196, (_e5196 > 0i)))];
let _e5202 = local_17;
let _e5205 = local_18;
let _e5206 = (_e5194 + _e5205);
let _e5208 = select(_e5169, _e5206, (_e5206 < _e5169));
let _e5213 = global_7.member[bitcast<u32>(select(0i, _e5208, (_e5208 > 0i)))];
let _e5214 = local_17;
let _e5219 = (_e5167 + (((_e5155 - _e5125) * _e5039) * _e5043));
let _e5221 = select(_e5169, _e5219, (_e5219 < _e5169));
let _e5226 = global_7.member[bitcast<u32>(select(0i, _e5221, (_e5221 > 0i)))];
let _e5227 = local_17;
let _e5230 = local_18;
let _e5231 = (_e5219 + _e5230);
let _e5233 = select(_e5169, _e5231, (_e5231 < _e5169));
let _e5238 = global_7.member[bitcast<u32>(select(0i, _e5233, (_e5233 > 0i)))];
let _e5239 = local_17;
let _e5243 = (_e5219 + _e5148);
let _e5245 = select(_e5169, _e5243, (_e5243 < _e5169));
let _e5250 = global_7.member[bitcast<u32>(select(0i, _e5245, (_e5245 > 0i)))];
let _e5251 = local_17;
let _e5254 = local_18;
let _e5255 = (_e5243 + _e5254);
let _e5257 = select(_e5169, _e5255, (_e5255 < _e5169));
let _e5262 = global_7.member[bitcast<u32>(select(0i, _e5257, (_e5257 > 0i)))];
let _e5263 = local_17;
let _e5272 = (_e5026 + _e5028);
let _e5282 = (((((_e3082.x + (_e4943 * _e5272)) - _e3785.member) / _e5050) * _e5048) - 0.5f);
let _e5284 = select(0f, _e5282, (_e5282 > 0f));
let _e5286 = select(_e5054, _e5284, (_e5284 < _e5054));
let _e5290 = (((((_e3082.y + (_e4945 * _e5272)) - _e3785.member_1) / _e5061) * _e5059) - 0.5f);
let _e5292 = select(0f, _e5290, (_e5290 > 0f));
let _e5294 = select(_e5065, _e5292, (_e5292 < _e5065));
let _e5298 = (((((_e3082.z + (_e4947 * _e5272)) - _e3785.member_2) / _e5072) * _e5070) - 0.5f);
let _e5300 = select(0f, _e5298, (_e5298 > 0f));
let _e5302 = select(_e5076, _e5300, (_e5300 < _e5076));
let _e5304 = select(0f, _e5286, (_e5286 > 0f));
let _e5306 = select(1e6f, _e5304, (_e5304 < 1e6f));
let _e5313 = select(0i, select(select(i32(_e5306), i32(-2147483648), (_e5306 < -2147483600f)), 2147483647i, (_e5306 > 2147483500f)), (_e5306 == _e5306));
let _e5317 = (_e5313 - select(0i, 1i, (_e5306 < f32(_e5313))));
let _e5319 = select(0f, _e5294, (_e5294 > 0f));
let _e5321 = select(1e6f, _e5319, (_e5319 < 1e6f));
let _e5328 = select(0i, select(select(i32(_e5321), i32(-2147483648), (_e5321 < -2147483600f)), 2147483647i, (_e5321 > 2147483500f)), (_e5321 == _e5321));
let _e5332 = (_e5328 - select(0i, 1i, (_e5321 < f32(_e5328))));
let _e5334 = select(0f, _e5302, (_e5302 > 0f));
let _e5336 = select(1e6f, _e5334, (_e5334 < 1e6f));
let _e5343 = select(0i, select(select(i32(_e5336), i32(-2147483648), (_e5336 < -2147483600f)), 2147483647i, (_e5336 > 2147483500f)), (_e5336 == _e5336));
let _e5347 = (_e5343 - select(0i, 1i, (_e5336 < f32(_e5343))));
let _e5351 = (_e5294 - f32(_e5332));
let _e5353 = (_e5302 - f32(_e5347));
local_15 = (_e5286 - f32(_e5317));
let _e5354 = (_e5317 + 1i);
let _e5356 = select(_e5354, 0i, (_e5354 < 0i));
if (_e5356 >= _e5039) {
phi_8850_ = (_e5039 - 1i);
} else {
phi_8850_ = _e5356;
}
let _e5360 = phi_8850_;
local_16 = (_e5360 - _e5317);
let _e5362 = (_e5332 + 1i);
let _e5364 = select(_e5362, 0i, (_e5362 < 0i));
if (_e5364 >= _e5043) {
phi_8863_ = (_e5043 - 1i);
} else {
phi_8863_ = _e5364;
}
let _e5368 = phi_8863_;
let _e5370 = ((_e5368 - _e5332) * _e5039);
let _e5371 = (_e5347 + 1i);
let _e5373 = select(_e5371, 0i, (_e5371 < 0i));
if (_e5373 >= _e5047) {
phi_8877_ = (_e5047 - 1i);
} else {
phi_8877_ = _e5373;
}
let _e5377 = phi_8877_;
let _e5385 = ((_e5162 + (((_e5347 * _e5043) + _e5332) * _e5039)) + _e5317);
let _e5387 = select(_e5169, _e5385, (_e5385 < _e5169));
let _e5392 = global_7.member[bitcast<u32>(select(0i, _e5387, (_e5387 > 0i)))];
let _e5393 = local_15;
let _e5396 = local_16;
let _e5397 = (_e5385 + _e5396);
let _e5399 = select(_e5169, _e5397, (_e5397 < _e5169));
let _e5404 = global_7.member[bitcast<u32>(select(0i, _e5399, (_e5399 > 0i)))];
let _e5405 = local_15;
let _e5408 = (1f - _e5351);
let _e5410 = (_e5385 + _e5370);
let _e5412 = select(_e5169, _e5410, (_e5410 < _e5169));
let _e5417 = global_7.member[bitcast<u32>(select(0i, _e5412, (_e5412 > 0i)))];
let _e5418 = local_15;
let _e5421 = local_16;
let _e5422 = (_e5410 + _e5421);
let _e5424 = select(_e5169, _e5422, (_e5422 < _e5169));
let _e5429 = global_7.member[bitcast<u32>(select(0i, _e5424, (_e5424 > 0i)))];
let _e5430 = local_15;
let _e5435 = (_e5385 + (((_e5377 - _e5347) * _e5039) * _e5043));
let _e5437 = select(_e5169, _e5435, (_e5435 < _e5169));
let _e5442 = global_7.member[bitcast<u32>(select(0i, _e5437, (_e5437 > 0i)))];
let _e5443 = local_15;
let _e5446 = local_16;
let _e5447 = (_e5435 + _e5446);
let _e5449 = select(_e5169, _e5447, (_e5447 < _e5169));
let _e5454 = global_7.member[bitcast<u32>(select(0i, _e5449, (_e5449 > 0i)))];
let _e5455 = local_15;
let _e5459 = (_e5435 + _e5370);
let _e5461 = select(_e5169, _e5459, (_e5459 < _e5169));
let _e5466 = global_7.member[bitcast<u32>(select(0i, _e5461, (_e5461 > 0i)))];
let _e5467 = local_15;
let _e5470 = local_16;
let _e5471 = (_e5459 + _e5470);
let _e5473 = select(_e5169, _e5471, (_e5471 < _e5169));
let _e5478 = global_7.member[bitcast<u32>(select(0i, _e5473, (_e5473 > 0i)))];
let _e5479 = local_15;
phi_8364_ = (_e5015 + 1u);
phi_8367_ = (_e5017 + ((0.5f * (((((((_e5176 * (1f - _e5177)) + (_e5188 * _e5189)) * _e5192) + (((_e5201 * (1f - _e5202)) + (_e5213 * _e5214)) * _e5129)) * (1f - _e5131)) + (((((_e5226 * (1f - _e5227)) + (_e5238 * _e5239)) * _e5192) + (((_e5250 * (1f - _e5251)) + (_e5262 * _e5263)) * _e5129)) * _e5131)) + ((((((_e5392 * (1f - _e5393)) + (_e5404 * _e5405)) * _e5408) + (((_e5417 * (1f - _e5418)) + (_e5429 * _e5430)) * _e5351)) * (1f - _e5353)) + (((((_e5442 * (1f - _e5443)) + (_e5454 * _e5455)) * _e5408) + (((_e5466 * (1f - _e5467)) + (_e5478 * _e5479)) * _e5351)) * _e5353)))) * _e5027));
} else {
phi_8364_ = u32();
phi_8367_ = f32();
}
let _e5494 = phi_8364_;
let _e5496 = phi_8367_;
continue;
continuing {
phi_8363_ = _e5494;
phi_8366_ = _e5496;
break if !(_e5020);
}
}
let _e11392 = local_78;
phi_9082_ = _e11392;
}
let _e5499 = phi_9082_;
let _e5500 = (_e5499 + select(_e3370, select(0f, _e4583, (_e4583 > 0f)), _e888));
let _e5502 = -((_e4326.member * _e5500));
let _e5504 = select(-87f, _e5502, (_e5502 > -87f));
let _e5506 = select(88f, _e5504, (_e5504 < 88f));
let _e5508 = ((_e5506 * 1.442695f) + 0.5f);
let _e5510 = select(-127f, _e5508, (_e5508 > -127f));
let _e5512 = select(128f, _e5510, (_e5510 < 128f));
let _e5519 = select(0i, select(select(i32(_e5512), i32(-2147483648), (_e5512 < -2147483600f)), 2147483647i, (_e5512 > 2147483500f)), (_e5512 == _e5512));
let _e5523 = (_e5519 - select(0i, 1i, (_e5512 < f32(_e5519))));
let _e5524 = f32(_e5523);
let _e5528 = ((_e5506 - (_e5524 * 0.6933594f)) - (_e5524 * -2.1219444e-4f));
let _e5550 = -((_e4326.member_1 * _e5500));
let _e5552 = select(-87f, _e5550, (_e5550 > -87f));
let _e5554 = select(88f, _e5552, (_e5552 < 88f));
let _e5556 = ((_e5554 * 1.442695f) + 0.5f);
let _e5558 = select(-127f, _e5556, (_e5556 > -127f));
let _e5560 = select(128f, _e5558, (_e5558 < 128f));
let _e5567 = select(0i, select(select(i32(_e5560), i32(-2147483648), (_e5560 < -2147483600f)), 2147483647i, (_e5560 > 2147483500f)), (_e5560 == _e5560));
let _e5571 = (_e5567 - select(0i, 1i, (_e5560 < f32(_e5567))));
let _e5572 = f32(_e5571);
let _e5576 = ((_e5554 - (_e5572 * 0.6933594f)) - (_e5572 * -2.1219444e-4f));
let _e5598 = -((_e4326.member_2 * _e5500));
let _e5600 = select(-87f, _e5598, (_e5598 > -87f));
let _e5602 = select(88f, _e5600, (_e5600 < 88f));
let _e5604 = ((_e5602 * 1.442695f) + 0.5f);
let _e5606 = select(-127f, _e5604, (_e5604 > -127f));
let _e5608 = select(128f, _e5606, (_e5606 < 128f));
let _e5615 = select(0i, select(select(i32(_e5608), i32(-2147483648), (_e5608 < -2147483600f)), 2147483647i, (_e5608 > 2147483500f)), (_e5608 == _e5608));
let _e5619 = (_e5615 - select(0i, 1i, (_e5608 < f32(_e5615))));
let _e5620 = f32(_e5619);
let _e5624 = ((_e5602 - (_e5620 * 0.6933594f)) - (_e5620 * -2.1219444e-4f));
let _e5650 = -((((_e4925.member.x * _e547) + (_e4925.member.y * _e558)) + (_e4925.member.z * _e569)));
let _e5652 = (_e4484 - (_e4485 * _e5650));
let _e5654 = select(1e-9f, _e5652, (_e5652 > 1e-9f));
if _e4504 {
let _e5665 = (0.5f - (0.5f * _e5650));
let _e5667 = select(0f, _e5665, (_e5665 > 0f));
let _e5671 = (sqrt(select(0f, _e5667, (_e5667 > 0f))) * 255f);
let _e5672 = (255f - 1f);
let _e5674 = select(0f, _e5671, (_e5671 > 0f));
let _e5676 = select(_e5672, _e5674, (_e5674 < _e5672));
let _e5683 = select(0i, select(select(i32(_e5676), i32(-2147483648), (_e5676 < -2147483600f)), 2147483647i, (_e5676 > 2147483500f)), (_e5676 == _e5676));
let _e5687 = (_e5683 - select(0i, 1i, (_e5676 < f32(_e5683))));
let _e5690 = global_1.member.member_13.member_11;
let _e5691 = bitcast<i32>(_e5690);
let _e5692 = (_e5691 + _e5687);
let _e5694 = (bitcast<i32>(_e188) - 1i);
let _e5696 = select(_e5694, _e5692, (_e5692 < _e5694));
let _e5701 = global_7.member[bitcast<u32>(select(0i, _e5696, (_e5696 > 0i)))];
let _e5703 = (_e5691 + (_e5687 + 1i));
let _e5705 = select(_e5694, _e5703, (_e5703 < _e5694));
let _e5710 = global_7.member[bitcast<u32>(select(0i, _e5705, (_e5705 > 0i)))];
phi_9443_ = (_e5701 + ((_e5710 - _e5701) * (_e5671 - f32(_e5687))));
} else {
phi_9443_ = select((_e4490 / (_e5654 * sqrt(select(0f, _e5654, (_e5654 > 0f))))), (0.75f * (1f + (_e5650 * _e5650))), _e4502);
}
let _e5717 = phi_9443_;
let _e5721 = ((3.1415927f * (_e5717 * _e4559)) * (select((_e1684 * ((2f * (1f + _e3060)) / (_e3063 * _e3063))), 1f, _e1685) * _e3332));
let _e5738 = (_e2523 - _e881);
if _e3385 {
let _e6073 = global_1.member.member_10.member_1;
phi_10016_ = type_27(vec3<f32>(_e6073.member, _e6073.member_1, _e6073.member_2), _e3381);
} else {
let _e5743 = (_e2532.x - _e3734.member);
let _e5745 = (_e2532.y - _e3734.member_1);
let _e5747 = (_e2532.z - _e3734.member_2);
let _e5752 = (((_e5743 * _e5743) + (_e5745 * _e5745)) + (_e5747 * _e5747));
let _e5754 = select(1e-12f, _e5752, (_e5752 > 1e-12f));
let _e5755 = (1f / _e5754);
let _e5759 = vec3<f32>((_e3377.member * _e5755), (_e3377.member_1 * _e5755), (_e3377.member_2 * _e5755));
if (_e3384 == 2u) {
let _e5763 = global_1.member.member_10.member_1;
let _e5771 = (((_e5763.member * _e5743) + (_e5763.member_1 * _e5745)) + (_e5763.member_2 * _e5747));
let _e5774 = (1f / select(1e-20f, _e5771, (_e5771 > 1e-20f)));
let _e5778 = global_1.member.member_10.member_4.member;
let _e5787 = ((((_e5778.member * _e5743) + (_e5778.member_1 * _e5745)) + (_e5778.member_2 * _e5747)) * _e5774);
let _e5791 = global_1.member.member_10.member_4.member_1;
let _e5800 = ((((_e5791.member * _e5743) + (_e5791.member_1 * _e5745)) + (_e5791.member_2 * _e5747)) * _e5774);
let _e5804 = global_1.member.member_10.member_4.member_2;
let _e5807 = ((_e5787 * _e5787) + (_e5800 * _e5800));
let _e5815 = global_1.member.member_10.member_4.member_3;
let _e5816 = ((_e5804 - sqrt(select(0f, _e5807, (_e5807 > 0f)))) * _e5815);
let _e5818 = select(0f, _e5816, (_e5816 > 0f));
let _e5820 = select(1f, _e5818, (_e5818 < 1f));
let _e5826 = select(0f, ((_e5820 * _e5820) * (3f - (2f * _e5820))), (_e5771 > 0f));
let _e5830 = global_1.member.member_10.member_4.member_5;
if ((_e5830 > 0u) && (_e5826 > 0f)) {
let _e5835 = (0.5f / _e5804);
let _e5844 = global_1.member.member_10.member_4.member_6;
let _e5845 = bitcast<i32>(_e5844);
local_14 = bitcast<i32>(_e5830);
let _e5846 = local_14;
let _e5848 = f32((_e5846 - 1i));
let _e5850 = f32((_e5845 - 1i));
let _e5851 = local_14;
let _e5854 = (((0.5f + (_e5787 * _e5835)) * f32(_e5851)) - 0.5f);
let _e5856 = select(0f, _e5854, (_e5854 > 0f));
let _e5858 = select(_e5848, _e5856, (_e5856 < _e5848));
let _e5861 = (((0.5f - (_e5800 * _e5835)) * f32(_e5845)) - 0.5f);
let _e5863 = select(0f, _e5861, (_e5861 > 0f));
let _e5865 = select(_e5850, _e5863, (_e5863 < _e5850));
let _e5867 = select(0f, _e5858, (_e5858 > 0f));
let _e5869 = select(_e5848, _e5867, (_e5867 < _e5848));
let _e5876 = select(0i, select(select(i32(_e5869), i32(-2147483648), (_e5869 < -2147483600f)), 2147483647i, (_e5869 > 2147483500f)), (_e5869 == _e5869));
let _e5880 = (_e5876 - select(0i, 1i, (_e5869 < f32(_e5876))));
let _e5882 = select(0f, _e5865, (_e5865 > 0f));
let _e5884 = select(_e5850, _e5882, (_e5882 < _e5850));
let _e5891 = select(0i, select(select(i32(_e5884), i32(-2147483648), (_e5884 < -2147483600f)), 2147483647i, (_e5884 > 2147483500f)), (_e5884 == _e5884));
let _e5895 = (_e5891 - select(0i, 1i, (_e5884 < f32(_e5891))));
let _e5897 = (_e5858 - f32(_e5880));
let _e5899 = (_e5865 - f32(_e5895));
let _e5900 = (_e5880 + 1i);
let _e5901 = local_14;
let _e5903 = select(_e5880, _e5900, (_e5900 < _e5901));
let _e5904 = (_e5895 + 1i);
let _e5906 = select(_e5895, _e5904, (_e5904 < _e5845));
let _e5910 = global_1.member.member_10.member_4.member_4;
let _e5911 = bitcast<i32>(_e5910);
let _e5912 = local_14;
let _e5916 = (_e5911 + (3i * ((_e5895 * _e5912) + _e5880)));
let _e5918 = (bitcast<i32>(_e181) - 1i);
let _e5920 = select(_e5918, _e5916, (_e5916 < _e5918));
let _e5925 = global_3.member[bitcast<u32>(select(0i, _e5920, (_e5920 > 0i)))];
let _e5926 = (_e5916 + 1i);
let _e5928 = select(_e5918, _e5926, (_e5926 < _e5918));
let _e5933 = global_3.member[bitcast<u32>(select(0i, _e5928, (_e5928 > 0i)))];
let _e5934 = (_e5916 + 2i);
let _e5936 = select(_e5918, _e5934, (_e5934 < _e5918));
let _e5941 = global_3.member[bitcast<u32>(select(0i, _e5936, (_e5936 > 0i)))];
let _e5942 = local_14;
let _e5946 = (_e5911 + (3i * ((_e5895 * _e5942) + _e5903)));
let _e5948 = select(_e5918, _e5946, (_e5946 < _e5918));
let _e5953 = global_3.member[bitcast<u32>(select(0i, _e5948, (_e5948 > 0i)))];
let _e5954 = (_e5946 + 1i);
let _e5956 = select(_e5918, _e5954, (_e5954 < _e5918));
let _e5961 = global_3.member[bitcast<u32>(select(0i, _e5956, (_e5956 > 0i)))];
let _e5962 = (_e5946 + 2i);
let _e5964 = select(_e5918, _e5962, (_e5962 < _e5918));
let _e5969 = global_3.member[bitcast<u32>(select(0i, _e5964, (_e5964 > 0i)))];
let _e5970 = local_14;
let _e5974 = (_e5911 + (3i * ((_e5906 * _e5970) + _e5880)));
let _e5976 = select(_e5918, _e5974, (_e5974 < _e5918));
let _e5981 = global_3.member[bitcast<u32>(select(0i, _e5976, (_e5976 > 0i)))];
let _e5982 = (_e5974 + 1i);
let _e5984 = select(_e5918, _e5982, (_e5982 < _e5918));
let _e5989 = global_3.member[bitcast<u32>(select(0i, _e5984, (_e5984 > 0i)))];
let _e5990 = (_e5974 + 2i);
let _e5992 = select(_e5918, _e5990, (_e5990 < _e5918));
let _e5997 = global_3.member[bitcast<u32>(select(0i, _e5992, (_e5992 > 0i)))];
let _e5998 = local_14;
let _e6002 = (_e5911 + (3i * ((_e5906 * _e5998) + _e5903)));
let _e6004 = select(_e5918, _e6002, (_e6002 < _e5918));
let _e6009 = global_3.member[bitcast<u32>(select(0i, _e6004, (_e6004 > 0i)))];
let _e6010 = (_e6002 + 1i);
let _e6012 = select(_e5918, _e6010, (_e6010 < _e5918));
let _e6017 = global_3.member[bitcast<u32>(select(0i, _e6012, (_e6012 > 0i)))];
let _e6018 = (_e6002 + 2i);
let _e6020 = select(_e5918, _e6018, (_e6018 < _e5918));
let _e6025 = global_3.member[bitcast<u32>(select(0i, _e6020, (_e6020 > 0i)))];
let _e6032 = (_e5925 + ((_e5953 - _e5925) * _e5897));
let _e6033 = (_e5933 + ((_e5961 - _e5933) * _e5897));
let _e6034 = (_e5941 + ((_e5969 - _e5941) * _e5897));
phi_10000_ = vec3<f32>(((_e6032 + (((_e5981 + ((_e6009 - _e5981) * _e5897)) - _e6032) * _e5899)) * _e5826), ((_e6033 + (((_e5989 + ((_e6017 - _e5989) * _e5897)) - _e6033) * _e5899)) * _e5826), ((_e6034 + (((_e5997 + ((_e6025 - _e5997) * _e5897)) - _e6034) * _e5899)) * _e5826));
} else {
phi_10000_ = vec3(_e5826);
}
let _e6058 = phi_10000_;
phi_10003_ = (_e5759 * _e6058);
} else {
phi_10003_ = _e5759;
}
let _e6061 = phi_10003_;
let _e6065 = (1f / sqrt(select(0f, _e5754, (_e5754 > 0f))));
phi_10016_ = type_27(vec3<f32>((_e5743 * _e6065), (_e5745 * _e6065), (_e5747 * _e6065)), _e6061);
}
let _e6080 = phi_10016_;
let _e6083 = (_e3734.member - _e2532.x);
let _e6085 = (_e3734.member_1 - _e2532.y);
let _e6087 = (_e3734.member_2 - _e2532.z);
let _e6092 = (((_e6083 * _e6083) + (_e6085 * _e6085)) + (_e6087 * _e6087));
let _e6096 = select(sqrt(select(0f, _e6092, (_e6092 > 0f))), 1e30f, _e3385);
let _e6098 = -(_e6080.member.x);
let _e6100 = -(_e6080.member.y);
let _e6102 = -(_e6080.member.z);
let _e6110 = (1f / select(_e6098, select(1e-12f, -1e-12f, (_e6098 < 0f)), (bitcast<f32>((bitcast<u32>(_e6098) & 2147483647u)) < 1e-12f)));
let _e6118 = (1f / select(_e6100, select(1e-12f, -1e-12f, (_e6100 < 0f)), (bitcast<f32>((bitcast<u32>(_e6100) & 2147483647u)) < 1e-12f)));
let _e6126 = (1f / select(_e6102, select(1e-12f, -1e-12f, (_e6102 < 0f)), (bitcast<f32>((bitcast<u32>(_e6102) & 2147483647u)) < 1e-12f)));
let _e6128 = ((_e3785.member - _e2532.x) * _e6110);
let _e6130 = ((_e3791.member - _e2532.x) * _e6110);
let _e6132 = ((_e3785.member_1 - _e2532.y) * _e6118);
let _e6134 = ((_e3791.member_1 - _e2532.y) * _e6118);
let _e6136 = ((_e3785.member_2 - _e2532.z) * _e6126);
let _e6138 = ((_e3791.member_2 - _e2532.z) * _e6126);
let _e6140 = select(_e6130, _e6128, (_e6128 < _e6130));
let _e6142 = select(_e6134, _e6132, (_e6132 < _e6134));
let _e6144 = select(_e6142, _e6140, (_e6140 > _e6142));
let _e6146 = select(_e6138, _e6136, (_e6136 < _e6138));
let _e6148 = select(_e6146, _e6144, (_e6144 > _e6146));
let _e6150 = select(_e6130, _e6128, (_e6128 > _e6130));
let _e6152 = select(_e6134, _e6132, (_e6132 > _e6134));
let _e6154 = select(_e6152, _e6150, (_e6150 < _e6152));
let _e6156 = select(_e6138, _e6136, (_e6136 > _e6138));
let _e6158 = select(_e6156, _e6154, (_e6154 < _e6156));
let _e6160 = select(0f, _e6148, (_e6148 > 0f));
let _e6162 = select(_e6096, _e6158, (_e6158 < _e6096));
let _e6163 = (_e6162 > _e6160);
let _e6164 = select(0f, _e6160, _e6163);
let _e6166 = (select(0f, _e6162, _e6163) - _e6164);
if _e2256 {
phi_10931_ = _e6166;
} else {
let _e6168 = (_e6166 / f32(_e2255));
phi_10212_ = 0u;
phi_10215_ = 0f;
loop {
let _e6170 = phi_10212_;
let _e6172 = phi_10215_;
local_79 = _e6172;
let _e6175 = ((_e6170 < _e2255) && (_e6166 > 0f));
if _e6175 {
let _e6178 = (_e6164 + (_e6168 * f32(_e6170)));
let _e6179 = (_e6178 + _e6168);
let _e6181 = (0.5f * (_e6178 + _e6179));
let _e6182 = (_e6179 - _e6178);
let _e6183 = (0.28867513f * _e6182);
let _e6184 = (_e6181 - _e6183);
let _e6193 = global_1.member.member_13.member_7;
let _e6194 = bitcast<i32>(_e6193);
let _e6197 = global_1.member.member_13.member_8;
let _e6198 = bitcast<i32>(_e6197);
let _e6201 = global_1.member.member_13.member_9;
let _e6202 = bitcast<i32>(_e6201);
let _e6203 = f32(_e6194);
let _e6205 = (_e3791.member - _e3785.member);
let _e6208 = (((((_e2532.x + (_e6098 * _e6184)) - _e3785.member) / _e6205) * _e6203) - 0.5f);
let _e6209 = (_e6203 - 1f);
let _e6211 = select(0f, _e6208, (_e6208 > 0f));
let _e6213 = select(_e6209, _e6211, (_e6211 < _e6209));
let _e6214 = f32(_e6198);
let _e6216 = (_e3791.member_1 - _e3785.member_1);
let _e6219 = (((((_e2532.y + (_e6100 * _e6184)) - _e3785.member_1) / _e6216) * _e6214) - 0.5f);
let _e6220 = (_e6214 - 1f);
let _e6222 = select(0f, _e6219, (_e6219 > 0f));
let _e6224 = select(_e6220, _e6222, (_e6222 < _e6220));
let _e6225 = f32(_e6202);
let _e6227 = (_e3791.member_2 - _e3785.member_2);
let _e6230 = (((((_e2532.z + (_e6102 * _e6184)) - _e3785.member_2) / _e6227) * _e6225) - 0.5f);
let _e6231 = (_e6225 - 1f);
let _e6233 = select(0f, _e6230, (_e6230 > 0f));
let _e6235 = select(_e6231, _e6233, (_e6233 < _e6231));
let _e6237 = select(0f, _e6213, (_e6213 > 0f));
let _e6239 = select(1e6f, _e6237, (_e6237 < 1e6f));
let _e6246 = select(0i, select(select(i32(_e6239), i32(-2147483648), (_e6239 < -2147483600f)), 2147483647i, (_e6239 > 2147483500f)), (_e6239 == _e6239));
let _e6250 = (_e6246 - select(0i, 1i, (_e6239 < f32(_e6246))));
let _e6252 = select(0f, _e6224, (_e6224 > 0f));
let _e6254 = select(1e6f, _e6252, (_e6252 < 1e6f));
let _e6261 = select(0i, select(select(i32(_e6254), i32(-2147483648), (_e6254 < -2147483600f)), 2147483647i, (_e6254 > 2147483500f)), (_e6254 == _e6254));
let _e6265 = (_e6261 - select(0i, 1i, (_e6254 < f32(_e6261))));
let _e6267 = select(0f, _e6235, (_e6235 > 0f));
let _e6269 = select(1e6f, _e6267, (_e6267 < 1e6f));
let _e6276 = select(0i, select(select(i32(_e6269), i32(-2147483648), (_e6269 < -2147483600f)), 2147483647i, (_e6269 > 2147483500f)), (_e6269 == _e6269));
let _e6280 = (_e6276 - select(0i, 1i, (_e6269 < f32(_e6276))));
let _e6284 = (_e6224 - f32(_e6265));
let _e6286 = (_e6235 - f32(_e6280));
local_12 = (_e6213 - f32(_e6250));
let _e6287 = (_e6250 + 1i);
let _e6289 = select(_e6287, 0i, (_e6287 < 0i));
if (_e6289 >= _e6194) {
phi_10353_ = (_e6194 - 1i);
} else {
phi_10353_ = _e6289;
}
let _e6293 = phi_10353_;
local_13 = (_e6293 - _e6250);
let _e6295 = (_e6265 + 1i);
let _e6297 = select(_e6295, 0i, (_e6295 < 0i));
if (_e6297 >= _e6198) {
phi_10366_ = (_e6198 - 1i);
} else {
phi_10366_ = _e6297;
}
let _e6301 = phi_10366_;
let _e6303 = ((_e6301 - _e6265) * _e6194);
let _e6304 = (_e6280 + 1i);
let _e6306 = select(_e6304, 0i, (_e6304 < 0i));
if (_e6306 >= _e6202) {
phi_10380_ = (_e6202 - 1i);
} else {
phi_10380_ = _e6306;
}
let _e6310 = phi_10380_;
let _e6316 = global_1.member.member_13.member_10;
let _e6317 = bitcast<i32>(_e6316);
let _e6322 = ((_e6317 + (((_e6280 * _e6198) + _e6265) * _e6194)) + _e6250);
let _e6324 = (bitcast<i32>(_e188) - 1i);
let _e6326 = select(_e6324, _e6322, (_e6322 < _e6324));
let _e6331 = global_7.member[bitcast<u32>(select(0i, _e6326, (_e6326 > 0i)))];
let _e6332 = local_12;
let _e6335 = local_13;
let _e6336 = (_e6322 + _e6335);
let _e6338 = select(_e6324, _e6336, (_e6336 < _e6324));
let _e6343 = global_7.member[bitcast<u32>(select(0i, _e6338, (_e6338 > 0i)))];
let _e6344 = local_12;
let _e6347 = (1f - _e6284);
let _e6349 = (_e6322 + _e6303);
let _e6351 = select(_e6324, _e6349, (_e6349 < _e6324));
let _e6356 = global_7.member[bitcast<u32>(select(0i, _e6351, (_e6351 > 0i)))];
let _e6357 = local_12;
let _e6360 = local_13;
let _e6361 = (_e6349 + _e6360);
let _e6363 = select(_e6324, _e6361, (_e6361 < _e6324));
let _e6368 = global_7.member[bitcast<u32>(select(0i, _e6363, (_e6363 > 0i)))];
let _e6369 = local_12;
let _e6374 = (_e6322 + (((_e6310 - _e6280) * _e6194) * _e6198));
let _e6376 = select(_e6324, _e6374, (_e6374 < _e6324));
let _e6381 = global_7.member[bitcast<u32>(select(0i, _e6376, (_e6376 > 0i)))];
let _e6382 = local_12;
let _e6385 = local_13;
let _e6386 = (_e6374 + _e6385);
let _e6388 = select(_e6324, _e6386, (_e6386 < _e6324));
let _e6393 = global_7.member[bitcast<u32>(select(0i, _e6388, (_e6388 > 0i)))];
let _e6394 = local_12;
let _e6398 = (_e6374 + _e6303);
let _e6400 = select(_e6324, _e6398, (_e6398 < _e6324));
let _e6405 = global_7.member[bitcast<u32>(select(0i, _e6400, (_e6400 > 0i)))];
let _e6406 = local_12;
let _e6409 = local_13;
let _e6410 = (_e6398 + _e6409);
let _e6412 = select(_e6324, _e6410, (_e6410 < _e6324));
let _e6417 = global_7.member[bitcast<u32>(select(0i, _e6412, (_e6412 > 0i)))];
let _e6418 = local_12;
let _e6427 = (_e6181 + _e6183);
let _e6437 = (((((_e2532.x + (_e6098 * _e6427)) - _e3785.member) / _e6205) * _e6203) - 0.5f);
let _e6439 = select(0f, _e6437, (_e6437 > 0f));
let _e6441 = select(_e6209, _e6439, (_e6439 < _e6209));
let _e6445 = (((((_e2532.y + (_e6100 * _e6427)) - _e3785.member_1) / _e6216) * _e6214) - 0.5f);
let _e6447 = select(0f, _e6445, (_e6445 > 0f));
let _e6449 = select(_e6220, _e6447, (_e6447 < _e6220));
let _e6453 = (((((_e2532.z + (_e6102 * _e6427)) - _e3785.member_2) / _e6227) * _e6225) - 0.5f);
let _e6455 = select(0f, _e6453, (_e6453 > 0f));
let _e6457 = select(_e6231, _e6455, (_e6455 < _e6231));
let _e6459 = select(0f, _e6441, (_e6441 > 0f));
let _e6461 = select(1e6f, _e6459, (_e6459 < 1e6f));
let _e6468 = select(0i, select(select(i32(_e6461), i32(-2147483648), (_e6461 < -2147483600f)), 2147483647i, (_e6461 > 2147483500f)), (_e6461 == _e6461));
let _e6472 = (_e6468 - select(0i, 1i, (_e6461 < f32(_e6468))));
let _e6474 = select(0f, _e6449, (_e6449 > 0f));
let _e6476 = select(1e6f, _e6474, (_e6474 < 1e6f));
let _e6483 = select(0i, select(select(i32(_e6476), i32(-2147483648), (_e6476 < -2147483600f)), 2147483647i, (_e6476 > 2147483500f)), (_e6476 == _e6476));
let _e6487 = (_e6483 - select(0i, 1i, (_e6476 < f32(_e6483))));
let _e6489 = select(0f, _e6457, (_e6457 > 0f));
let _e6491 = select(1e6f, _e6489, (_e6489 < 1e6f));
let _e6498 = select(0i, select(select(i32(_e6491), i32(-2147483648), (_e6491 < -2147483600f)), 2147483647i, (_e6491 > 2147483500f)), (_e6491 == _e6491));
let _e6502 = (_e6498 - select(0i, 1i, (_e6491 < f32(_e6498))));
let _e6506 = (_e6449 - f32(_e6487));
let _e6508 = (_e6457 - f32(_e6502));
local_10 = (_e6441 - f32(_e6472));
let _e6509 = (_e6472 + 1i);
let _e6511 = select(_e6509, 0i, (_e6509 < 0i));
if (_e6511 >= _e6194) {
phi_10699_ = (_e6194 - 1i);
} else {
phi_10699_ = _e6511;
}
let _e6515 = phi_10699_;
local_11 = (_e6515 - _e6472);
let _e6517 = (_e6487 + 1i);
let _e6519 = select(_e6517, 0i, (_e6517 < 0i));
if (_e6519 >= _e6198) {
phi_10712_ = (_e6198 - 1i);
} else {
phi_10712_ = _e6519;
}
let _e6523 = phi_10712_;
let _e6525 = ((_e6523 - _e6487) * _e6194);
let _e6526 = (_e6502 + 1i);
let _e6528 = select(_e6526, 0i, (_e6526 < 0i));
if (_e6528 >= _e6202) {
phi_10726_ = (_e6202 - 1i);
} else {
phi_10726_ = _e6528;
}
let _e6532 = phi_10726_;
let _e6540 = ((_e6317 + (((_e6502 * _e6198) + _e6487) * _e6194)) + _e6472);
let _e6542 = select(_e6324, _e6540, (_e6540 < _e6324));
let _e6547 = global_7.member[bitcast<u32>(select(0i, _e6542, (_e6542 > 0i)))];
let _e6548 = local_10;
let _e6551 = local_11;
let _e6552 = (_e6540 + _e6551);
let _e6554 = select(_e6324, _e6552, (_e6552 < _e6324));
let _e6559 = global_7.member[bitcast<u32>(select(0i, _e6554, (_e6554 > 0i)))];
let _e6560 = local_10;
let _e6563 = (1f - _e6506);
let _e6565 = (_e6540 + _e6525);
let _e6567 = select(_e6324, _e6565, (_e6565 < _e6324));
let _e6572 = global_7.member[bitcast<u32>(select(0i, _e6567, (_e6567 > 0i)))];
let _e6573 = local_10;
let _e6576 = local_11;
let _e6577 = (_e6565 + _e6576);
let _e6579 = select(_e6324, _e6577, (_e6577 < _e6324));
let _e6584 = global_7.member[bitcast<u32>(select(0i, _e6579, (_e6579 > 0i)))];
let _e6585 = local_10;
let _e6590 = (_e6540 + (((_e6532 - _e6502) * _e6194) * _e6198));
let _e6592 = select(_e6324, _e6590, (_e6590 < _e6324));
let _e6597 = global_7.member[bitcast<u32>(select(0i, _e6592, (_e6592 > 0i)))];
let _e6598 = local_10;
let _e6601 = local_11;
let _e6602 = (_e6590 + _e6601);
let _e6604 = select(_e6324, _e6602, (_e6602 < _e6324));
let _e6609 = global_7.member[bitcast<u32>(select(0i, _e6604, (_e6604 > 0i)))];
let _e6610 = local_10;
let _e6614 = (_e6590 + _e6525);
let _e6616 = select(_e6324, _e6614, (_e6614 < _e6324));
let _e6621 = global_7.member[bitcast<u32>(select(0i, _e6616, (_e6616 > 0i)))];
let _e6622 = local_10;
let _e6625 = local_11;
let _e6626 = (_e6614 + _e6625);
let _e6628 = select(_e6324, _e6626, (_e6626 < _e6324));
let _e6633 = global_7.member[bitcast<u32>(select(0i, _e6628, (_e6628 > 0i)))];
let _e6634 = local_10;
phi_10213_ = (_e6170 + 1u);
phi_10216_ = (_e6172 + ((0.5f * (((((((_e6331 * (1f - _e6332)) + (_e6343 * _e6344)) * _e6347) + (((_e6356 * (1f - _e6357)) + (_e6368 * _e6369)) * _e6284)) * (1f - _e6286)) + (((((_e6381 * (1f - _e6382)) + (_e6393 * _e6394)) * _e6347) + (((_e6405 * (1f - _e6406)) + (_e6417 * _e6418)) * _e6284)) * _e6286)) + ((((((_e6547 * (1f - _e6548)) + (_e6559 * _e6560)) * _e6563) + (((_e6572 * (1f - _e6573)) + (_e6584 * _e6585)) * _e6506)) * (1f - _e6508)) + (((((_e6597 * (1f - _e6598)) + (_e6609 * _e6610)) * _e6563) + (((_e6621 * (1f - _e6622)) + (_e6633 * _e6634)) * _e6506)) * _e6508)))) * _e6182));
} else {
phi_10213_ = u32();
phi_10216_ = f32();
}
let _e6649 = phi_10213_;
let _e6651 = phi_10216_;
continue;
continuing {
phi_10212_ = _e6649;
phi_10215_ = _e6651;
break if !(_e6175);
}
}
let _e11409 = local_79;
phi_10931_ = _e11409;
}
let _e6654 = phi_10931_;
let _e6655 = (_e6654 + select(_e3360, select(0f, _e5738, (_e5738 > 0f)), _e888));
let _e6657 = -((_e4326.member * _e6655));
let _e6659 = select(-87f, _e6657, (_e6657 > -87f));
let _e6661 = select(88f, _e6659, (_e6659 < 88f));
let _e6663 = ((_e6661 * 1.442695f) + 0.5f);
let _e6665 = select(-127f, _e6663, (_e6663 > -127f));
let _e6667 = select(128f, _e6665, (_e6665 < 128f));
let _e6674 = select(0i, select(select(i32(_e6667), i32(-2147483648), (_e6667 < -2147483600f)), 2147483647i, (_e6667 > 2147483500f)), (_e6667 == _e6667));
let _e6678 = (_e6674 - select(0i, 1i, (_e6667 < f32(_e6674))));
let _e6679 = f32(_e6678);
let _e6683 = ((_e6661 - (_e6679 * 0.6933594f)) - (_e6679 * -2.1219444e-4f));
let _e6705 = -((_e4326.member_1 * _e6655));
let _e6707 = select(-87f, _e6705, (_e6705 > -87f));
let _e6709 = select(88f, _e6707, (_e6707 < 88f));
let _e6711 = ((_e6709 * 1.442695f) + 0.5f);
let _e6713 = select(-127f, _e6711, (_e6711 > -127f));
let _e6715 = select(128f, _e6713, (_e6713 < 128f));
let _e6722 = select(0i, select(select(i32(_e6715), i32(-2147483648), (_e6715 < -2147483600f)), 2147483647i, (_e6715 > 2147483500f)), (_e6715 == _e6715));
let _e6726 = (_e6722 - select(0i, 1i, (_e6715 < f32(_e6722))));
let _e6727 = f32(_e6726);
let _e6731 = ((_e6709 - (_e6727 * 0.6933594f)) - (_e6727 * -2.1219444e-4f));
let _e6753 = -((_e4326.member_2 * _e6655));
let _e6755 = select(-87f, _e6753, (_e6753 > -87f));
let _e6757 = select(88f, _e6755, (_e6755 < 88f));
let _e6759 = ((_e6757 * 1.442695f) + 0.5f);
let _e6761 = select(-127f, _e6759, (_e6759 > -127f));
let _e6763 = select(128f, _e6761, (_e6761 < 128f));
let _e6770 = select(0i, select(select(i32(_e6763), i32(-2147483648), (_e6763 < -2147483600f)), 2147483647i, (_e6763 > 2147483500f)), (_e6763 == _e6763));
let _e6774 = (_e6770 - select(0i, 1i, (_e6763 < f32(_e6770))));
let _e6775 = f32(_e6774);
let _e6779 = ((_e6757 - (_e6775 * 0.6933594f)) - (_e6775 * -2.1219444e-4f));
let _e6805 = -((((_e6080.member.x * _e547) + (_e6080.member.y * _e558)) + (_e6080.member.z * _e569)));
let _e6807 = (_e4484 - (_e4485 * _e6805));
let _e6809 = select(1e-9f, _e6807, (_e6807 > 1e-9f));
if _e4504 {
let _e6820 = (0.5f - (0.5f * _e6805));
let _e6822 = select(0f, _e6820, (_e6820 > 0f));
let _e6826 = (sqrt(select(0f, _e6822, (_e6822 > 0f))) * 255f);
let _e6827 = (255f - 1f);
let _e6829 = select(0f, _e6826, (_e6826 > 0f));
let _e6831 = select(_e6827, _e6829, (_e6829 < _e6827));
let _e6838 = select(0i, select(select(i32(_e6831), i32(-2147483648), (_e6831 < -2147483600f)), 2147483647i, (_e6831 > 2147483500f)), (_e6831 == _e6831));
let _e6842 = (_e6838 - select(0i, 1i, (_e6831 < f32(_e6838))));
let _e6845 = global_1.member.member_13.member_11;
let _e6846 = bitcast<i32>(_e6845);
let _e6847 = (_e6846 + _e6842);
let _e6849 = (bitcast<i32>(_e188) - 1i);
let _e6851 = select(_e6849, _e6847, (_e6847 < _e6849));
let _e6856 = global_7.member[bitcast<u32>(select(0i, _e6851, (_e6851 > 0i)))];
let _e6858 = (_e6846 + (_e6842 + 1i));
let _e6860 = select(_e6849, _e6858, (_e6858 < _e6849));
let _e6865 = global_7.member[bitcast<u32>(select(0i, _e6860, (_e6860 > 0i)))];
phi_11292_ = (_e6856 + ((_e6865 - _e6856) * (_e6826 - f32(_e6842))));
} else {
phi_11292_ = select((_e4490 / (_e6809 * sqrt(select(0f, _e6809, (_e6809 > 0f))))), (0.75f * (1f + (_e6805 * _e6805))), _e4502);
}
let _e6872 = phi_11292_;
let _e6876 = ((3.1415927f * (_e6872 * _e4559)) * (select((_e1684 * ((2f * (1f + _e2510)) / (_e2513 * _e2513))), 1f, _e1685) * _e2782));
let _e6890 = (_e2798 - _e881);
if _e3385 {
let _e7225 = global_1.member.member_10.member_1;
phi_11862_ = type_27(vec3<f32>(_e7225.member, _e7225.member_1, _e7225.member_2), _e3381);
} else {
let _e6895 = (_e2807.x - _e3734.member);
let _e6897 = (_e2807.y - _e3734.member_1);
let _e6899 = (_e2807.z - _e3734.member_2);
let _e6904 = (((_e6895 * _e6895) + (_e6897 * _e6897)) + (_e6899 * _e6899));
let _e6906 = select(1e-12f, _e6904, (_e6904 > 1e-12f));
let _e6907 = (1f / _e6906);
let _e6911 = vec3<f32>((_e3377.member * _e6907), (_e3377.member_1 * _e6907), (_e3377.member_2 * _e6907));
if (_e3384 == 2u) {
let _e6915 = global_1.member.member_10.member_1;
let _e6923 = (((_e6915.member * _e6895) + (_e6915.member_1 * _e6897)) + (_e6915.member_2 * _e6899));
let _e6926 = (1f / select(1e-20f, _e6923, (_e6923 > 1e-20f)));
let _e6930 = global_1.member.member_10.member_4.member;
let _e6939 = ((((_e6930.member * _e6895) + (_e6930.member_1 * _e6897)) + (_e6930.member_2 * _e6899)) * _e6926);
let _e6943 = global_1.member.member_10.member_4.member_1;
let _e6952 = ((((_e6943.member * _e6895) + (_e6943.member_1 * _e6897)) + (_e6943.member_2 * _e6899)) * _e6926);
let _e6956 = global_1.member.member_10.member_4.member_2;
let _e6959 = ((_e6939 * _e6939) + (_e6952 * _e6952));
let _e6967 = global_1.member.member_10.member_4.member_3;
let _e6968 = ((_e6956 - sqrt(select(0f, _e6959, (_e6959 > 0f)))) * _e6967);
let _e6970 = select(0f, _e6968, (_e6968 > 0f));
let _e6972 = select(1f, _e6970, (_e6970 < 1f));
let _e6978 = select(0f, ((_e6972 * _e6972) * (3f - (2f * _e6972))), (_e6923 > 0f));
let _e6982 = global_1.member.member_10.member_4.member_5;
if ((_e6982 > 0u) && (_e6978 > 0f)) {
let _e6987 = (0.5f / _e6956);
let _e6996 = global_1.member.member_10.member_4.member_6;
let _e6997 = bitcast<i32>(_e6996);
local_9 = bitcast<i32>(_e6982);
let _e6998 = local_9;
let _e7000 = f32((_e6998 - 1i));
let _e7002 = f32((_e6997 - 1i));
let _e7003 = local_9;
let _e7006 = (((0.5f + (_e6939 * _e6987)) * f32(_e7003)) - 0.5f);
let _e7008 = select(0f, _e7006, (_e7006 > 0f));
let _e7010 = select(_e7000, _e7008, (_e7008 < _e7000));
let _e7013 = (((0.5f - (_e6952 * _e6987)) * f32(_e6997)) - 0.5f);
let _e7015 = select(0f, _e7013, (_e7013 > 0f));
let _e7017 = select(_e7002, _e7015, (_e7015 < _e7002));
let _e7019 = select(0f, _e7010, (_e7010 > 0f));
let _e7021 = select(_e7000, _e7019, (_e7019 < _e7000));
let _e7028 = select(0i, select(select(i32(_e7021), i32(-2147483648), (_e7021 < -2147483600f)), 2147483647i, (_e7021 > 2147483500f)), (_e7021 == _e7021));
let _e7032 = (_e7028 - select(0i, 1i, (_e7021 < f32(_e7028))));
let _e7034 = select(0f, _e7017, (_e7017 > 0f));
let _e7036 = select(_e7002, _e7034, (_e7034 < _e7002));
let _e7043 = select(0i, select(select(i32(_e7036), i32(-2147483648), (_e7036 < -2147483600f)), 2147483647i, (_e7036 > 2147483500f)), (_e7036 == _e7036));
let _e7047 = (_e7043 - select(0i, 1i, (_e7036 < f32(_e7043))));
let _e7049 = (_e7010 - f32(_e7032));
let _e7051 = (_e7017 - f32(_e7047));
let _e7052 = (_e7032 + 1i);
let _e7053 = local_9;
let _e7055 = select(_e7032, _e7052, (_e7052 < _e7053));
let _e7056 = (_e7047 + 1i);
let _e7058 = select(_e7047, _e7056, (_e7056 < _e6997));
let _e7062 = global_1.member.member_10.member_4.member_4;
let _e7063 = bitcast<i32>(_e7062);
let _e7064 = local_9;
let _e7068 = (_e7063 + (3i * ((_e7047 * _e7064) + _e7032)));
let _e7070 = (bitcast<i32>(_e181) - 1i);
let _e7072 = select(_e7070, _e7068, (_e7068 < _e7070));
let _e7077 = global_3.member[bitcast<u32>(select(0i, _e7072, (_e7072 > 0i)))];
let _e7078 = (_e7068 + 1i);
let _e7080 = select(_e7070, _e7078, (_e7078 < _e7070));
let _e7085 = global_3.member[bitcast<u32>(select(0i, _e7080, (_e7080 > 0i)))];
let _e7086 = (_e7068 + 2i);
let _e7088 = select(_e7070, _e7086, (_e7086 < _e7070));
let _e7093 = global_3.member[bitcast<u32>(select(0i, _e7088, (_e7088 > 0i)))];
let _e7094 = local_9;
let _e7098 = (_e7063 + (3i * ((_e7047 * _e7094) + _e7055)));
let _e7100 = select(_e7070, _e7098, (_e7098 < _e7070));
let _e7105 = global_3.member[bitcast<u32>(select(0i, _e7100, (_e7100 > 0i)))];
let _e7106 = (_e7098 + 1i);
let _e7108 = select(_e7070, _e7106, (_e7106 < _e7070));
let _e7113 = global_3.member[bitcast<u32>(select(0i, _e7108, (_e7108 > 0i)))];
let _e7114 = (_e7098 + 2i);
let _e7116 = select(_e7070, _e7114, (_e7114 < _e7070));
let _e7121 = global_3.member[bitcast<u32>(select(0i, _e7116, (_e7116 > 0i)))];
let _e7122 = local_9;
let _e7126 = (_e7063 + (3i * ((_e7058 * _e7122) + _e7032)));
let _e7128 = select(_e7070, _e7126, (_e7126 < _e7070));
let _e7133 = global_3.member[bitcast<u32>(select(0i, _e7128, (_e7128 > 0i)))];
let _e7134 = (_e7126 + 1i);
let _e7136 = select(_e7070, _e7134, (_e7134 < _e7070));
let _e7141 = global_3.member[bitcast<u32>(select(0i, _e7136, (_e7136 > 0i)))];
let _e7142 = (_e7126 + 2i);
let _e7144 = select(_e7070, _e7142, (_e7142 < _e7070));
let _e7149 = global_3.member[bitcast<u32>(select(0i, _e7144, (_e7144 > 0i)))];
let _e7150 = local_9;
let _e7154 = (_e7063 + (3i * ((_e7058 * _e7150) + _e7055)));
let _e7156 = select(_e7070, _e7154, (_e7154 < _e7070));
let _e7161 = global_3.member[bitcast<u32>(select(0i, _e7156, (_e7156 > 0i)))];
let _e7162 = (_e7154 + 1i);
let _e7164 = select(_e7070, _e7162, (_e7162 < _e7070));
let _e7169 = global_3.member[bitcast<u32>(select(0i, _e7164, (_e7164 > 0i)))];
let _e7170 = (_e7154 + 2i);
let _e7172 = select(_e7070, _e7170, (_e7170 < _e7070));
let _e7177 = global_3.member[bitcast<u32>(select(0i, _e7172, (_e7172 > 0i)))];
let _e7184 = (_e7077 + ((_e7105 - _e7077) * _e7049));
let _e7185 = (_e7085 + ((_e7113 - _e7085) * _e7049));
let _e7186 = (_e7093 + ((_e7121 - _e7093) * _e7049));
phi_11846_ = vec3<f32>(((_e7184 + (((_e7133 + ((_e7161 - _e7133) * _e7049)) - _e7184) * _e7051)) * _e6978), ((_e7185 + (((_e7141 + ((_e7169 - _e7141) * _e7049)) - _e7185) * _e7051)) * _e6978), ((_e7186 + (((_e7149 + ((_e7177 - _e7149) * _e7049)) - _e7186) * _e7051)) * _e6978));
} else {
phi_11846_ = vec3(_e6978);
}
let _e7210 = phi_11846_;
phi_11849_ = (_e6911 * _e7210);
} else {
phi_11849_ = _e6911;
}
let _e7213 = phi_11849_;
let _e7217 = (1f / sqrt(select(0f, _e6906, (_e6906 > 0f))));
phi_11862_ = type_27(vec3<f32>((_e6895 * _e7217), (_e6897 * _e7217), (_e6899 * _e7217)), _e7213);
}
let _e7232 = phi_11862_;
let _e7235 = (_e3734.member - _e2807.x);
let _e7237 = (_e3734.member_1 - _e2807.y);
let _e7239 = (_e3734.member_2 - _e2807.z);
let _e7244 = (((_e7235 * _e7235) + (_e7237 * _e7237)) + (_e7239 * _e7239));
let _e7248 = select(sqrt(select(0f, _e7244, (_e7244 > 0f))), 1e30f, _e3385);
let _e7250 = -(_e7232.member.x);
let _e7252 = -(_e7232.member.y);
let _e7254 = -(_e7232.member.z);
let _e7262 = (1f / select(_e7250, select(1e-12f, -1e-12f, (_e7250 < 0f)), (bitcast<f32>((bitcast<u32>(_e7250) & 2147483647u)) < 1e-12f)));
let _e7270 = (1f / select(_e7252, select(1e-12f, -1e-12f, (_e7252 < 0f)), (bitcast<f32>((bitcast<u32>(_e7252) & 2147483647u)) < 1e-12f)));
let _e7278 = (1f / select(_e7254, select(1e-12f, -1e-12f, (_e7254 < 0f)), (bitcast<f32>((bitcast<u32>(_e7254) & 2147483647u)) < 1e-12f)));
let _e7280 = ((_e3785.member - _e2807.x) * _e7262);
let _e7282 = ((_e3791.member - _e2807.x) * _e7262);
let _e7284 = ((_e3785.member_1 - _e2807.y) * _e7270);
let _e7286 = ((_e3791.member_1 - _e2807.y) * _e7270);
let _e7288 = ((_e3785.member_2 - _e2807.z) * _e7278);
let _e7290 = ((_e3791.member_2 - _e2807.z) * _e7278);
let _e7292 = select(_e7282, _e7280, (_e7280 < _e7282));
let _e7294 = select(_e7286, _e7284, (_e7284 < _e7286));
let _e7296 = select(_e7294, _e7292, (_e7292 > _e7294));
let _e7298 = select(_e7290, _e7288, (_e7288 < _e7290));
let _e7300 = select(_e7298, _e7296, (_e7296 > _e7298));
let _e7302 = select(_e7282, _e7280, (_e7280 > _e7282));
let _e7304 = select(_e7286, _e7284, (_e7284 > _e7286));
let _e7306 = select(_e7304, _e7302, (_e7302 < _e7304));
let _e7308 = select(_e7290, _e7288, (_e7288 > _e7290));
let _e7310 = select(_e7308, _e7306, (_e7306 < _e7308));
let _e7312 = select(0f, _e7300, (_e7300 > 0f));
let _e7314 = select(_e7248, _e7310, (_e7310 < _e7248));
let _e7315 = (_e7314 > _e7312);
let _e7316 = select(0f, _e7312, _e7315);
let _e7318 = (select(0f, _e7314, _e7315) - _e7316);
if _e2256 {
phi_12777_ = _e7318;
} else {
let _e7320 = (_e7318 / f32(_e2255));
phi_12058_ = 0u;
phi_12061_ = 0f;
loop {
let _e7322 = phi_12058_;
let _e7324 = phi_12061_;
local_80 = _e7324;
let _e7327 = ((_e7322 < _e2255) && (_e7318 > 0f));
if _e7327 {
let _e7330 = (_e7316 + (_e7320 * f32(_e7322)));
let _e7331 = (_e7330 + _e7320);
let _e7333 = (0.5f * (_e7330 + _e7331));
let _e7334 = (_e7331 - _e7330);
let _e7335 = (0.28867513f * _e7334);
let _e7336 = (_e7333 - _e7335);
let _e7345 = global_1.member.member_13.member_7;
let _e7346 = bitcast<i32>(_e7345);
let _e7349 = global_1.member.member_13.member_8;
let _e7350 = bitcast<i32>(_e7349);
let _e7353 = global_1.member.member_13.member_9;
let _e7354 = bitcast<i32>(_e7353);
let _e7355 = f32(_e7346);
let _e7357 = (_e3791.member - _e3785.member);
let _e7360 = (((((_e2807.x + (_e7250 * _e7336)) - _e3785.member) / _e7357) * _e7355) - 0.5f);
let _e7361 = (_e7355 - 1f);
let _e7363 = select(0f, _e7360, (_e7360 > 0f));
let _e7365 = select(_e7361, _e7363, (_e7363 < _e7361));
let _e7366 = f32(_e7350);
let _e7368 = (_e3791.member_1 - _e3785.member_1);
let _e7371 = (((((_e2807.y + (_e7252 * _e7336)) - _e3785.member_1) / _e7368) * _e7366) - 0.5f);
let _e7372 = (_e7366 - 1f);
let _e7374 = select(0f, _e7371, (_e7371 > 0f));
let _e7376 = select(_e7372, _e7374, (_e7374 < _e7372));
let _e7377 = f32(_e7354);
let _e7379 = (_e3791.member_2 - _e3785.member_2);
let _e7382 = (((((_e2807.z + (_e7254 * _e7336)) - _e3785.member_2) / _e7379) * _e7377) - 0.5f);
let _e7383 = (_e7377 - 1f);
let _e7385 = select(0f, _e7382, (_e7382 > 0f));
let _e7387 = select(_e7383, _e7385, (_e7385 < _e7383));
let _e7389 = select(0f, _e7365, (_e7365 > 0f));
let _e7391 = select(1e6f, _e7389, (_e7389 < 1e6f));
let _e7398 = select(0i, select(select(i32(_e7391), i32(-2147483648), (_e7391 < -2147483600f)), 2147483647i, (_e7391 > 2147483500f)), (_e7391 == _e7391));
let _e7402 = (_e7398 - select(0i, 1i, (_e7391 < f32(_e7398))));
let _e7404 = select(0f, _e7376, (_e7376 > 0f));
let _e7406 = select(1e6f, _e7404, (_e7404 < 1e6f));
let _e7413 = select(0i, select(select(i32(_e7406), i32(-2147483648), (_e7406 < -2147483600f)), 2147483647i, (_e7406 > 2147483500f)), (_e7406 == _e7406));
let _e7417 = (_e7413 - select(0i, 1i, (_e7406 < f32(_e7413))));
let _e7419 = select(0f, _e7387, (_e7387 > 0f));
let _e7421 = select(1e6f, _e7419, (_e7419 < 1e6f));
let _e7428 = select(0i, select(select(i32(_e7421), i32(-2147483648), (_e7421 < -2147483600f)), 2147483647i, (_e7421 > 2147483500f)), (_e7421 == _e7421));
let _e7432 = (_e7428 - select(0i, 1i, (_e7421 < f32(_e7428))));
let _e7436 = (_e7376 - f32(_e7417));
let _e7438 = (_e7387 - f32(_e7432));
local_7 = (_e7365 - f32(_e7402));
let _e7439 = (_e7402 + 1i);
let _e7441 = select(_e7439, 0i, (_e7439 < 0i));
if (_e7441 >= _e7346) {
phi_12199_ = (_e7346 - 1i);
} else {
phi_12199_ = _e7441;
}
let _e7445 = phi_12199_;
local_8 = (_e7445 - _e7402);
let _e7447 = (_e7417 + 1i);
let _e7449 = select(_e7447, 0i, (_e7447 < 0i));
if (_e7449 >= _e7350) {
phi_12212_ = (_e7350 - 1i);
} else {
phi_12212_ = _e7449;
}
let _e7453 = phi_12212_;
let _e7455 = ((_e7453 - _e7417) * _e7346);
let _e7456 = (_e7432 + 1i);
let _e7458 = select(_e7456, 0i, (_e7456 < 0i));
if (_e7458 >= _e7354) {
phi_12226_ = (_e7354 - 1i);
} else {
phi_12226_ = _e7458;
}
let _e7462 = phi_12226_;
let _e7468 = global_1.member.member_13.member_10;
let _e7469 = bitcast<i32>(_e7468);
let _e7474 = ((_e7469 + (((_e7432 * _e7350) + _e7417) * _e7346)) + _e7402);
let _e7476 = (bitcast<i32>(_e188) - 1i);
let _e7478 = select(_e7476, _e7474, (_e7474 < _e7476));
let _e7483 = global_7.member[bitcast<u32>(select(0i, _e7478, (_e7478 > 0i)))];
let _e7484 = local_7;
let _e7487 = local_8;
let _e7488 = (_e7474 + _e7487);
let _e7490 = select(_e7476, _e7488, (_e7488 < _e7476));
let _e7495 = global_7.member[bitcast<u32>(select(0i, _e7490, (_e7490 > 0i)))];
let _e7496 = local_7;
let _e7499 = (1f - _e7436);
let _e7501 = (_e7474 + _e7455);
let _e7503 = select(_e7476, _e7501, (_e7501 < _e7476));
let _e7508 = global_7.member[bitcast<u32>(select(0i, _e7503, (_e7503 > 0i)))];
let _e7509 = local_7;
let _e7512 = local_8;
let _e7513 = (_e7501 + _e7512);
let _e7515 = select(_e7476, _e7513, (_e7513 < _e7476));
let _e7520 = global_7.member[bitcast<u32>(select(0i, _e7515, (_e7515 > 0i)))];
let _e7521 = local_7;
let _e7526 = (_e7474 + (((_e7462 - _e7432) * _e7346) * _e7350));
let _e7528 = select(_e7476, _e7526, (_e7526 < _e7476));
let _e7533 = global_7.member[bitcast<u32>(select(0i, _e7528, (_e7528 > 0i)))];
let _e7534 = local_7;
let _e7537 = local_8;
let _e7538 = (_e7526 + _e7537);
let _e7540 = select(_e7476, _e7538, (_e7538 < _e7476));
let _e7545 = global_7.member[bitcast<u32>(select(0i, _e7540, (_e7540 > 0i)))];
let _e7546 = local_7;
let _e7550 = (_e7526 + _e7455);
let _e7552 = select(_e7476, _e7550, (_e7550 < _e7476));
let _e7557 = global_7.member[bitcast<u32>(select(0i, _e7552, (_e7552 > 0i)))];
let _e7558 = local_7;
let _e7561 = local_8;
let _e7562 = (_e7550 + _e7561);
let _e7564 = select(_e7476, _e7562, (_e7562 < _e7476));
let _e7569 = global_7.member[bitcast<u32>(select(0i, _e7564, (_e7564 > 0i)))];
let _e7570 = local_7;
let _e7579 = (_e7333 + _e7335);
let _e7589 = (((((_e2807.x + (_e7250 * _e7579)) - _e3785.member) / _e7357) * _e7355) - 0.5f);
let _e7591 = select(0f, _e7589, (_e7589 > 0f));
let _e7593 = select(_e7361, _e7591, (_e7591 < _e7361));
let _e7597 = (((((_e2807.y + (_e7252 * _e7579)) - _e3785.member_1) / _e7368) * _e7366) - 0.5f);
let _e7599 = select(0f, _e7597, (_e7597 > 0f));
let _e7601 = select(_e7372, _e7599, (_e7599 < _e7372));
let _e7605 = (((((_e2807.z + (_e7254 * _e7579)) - _e3785.member_2) / _e7379) * _e7377) - 0.5f);
let _e7607 = select(0f, _e7605, (_e7605 > 0f));
let _e7609 = select(_e7383, _e7607, (_e7607 < _e7383));
let _e7611 = select(0f, _e7593, (_e7593 > 0f));
let _e7613 = select(1e6f, _e7611, (_e7611 < 1e6f));
let _e7620 = select(0i, select(select(i32(_e7613), i32(-2147483648), (_e7613 < -2147483600f)), 2147483647i, (_e7613 > 2147483500f)), (_e7613 == _e7613));
let _e7624 = (_e7620 - select(0i, 1i, (_e7613 < f32(_e7620))));
let _e7626 = select(0f, _e7601, (_e7601 > 0f));
let _e7628 = select(1e6f, _e7626, (_e7626 < 1e6f));
let _e7635 = select(0i, select(select(i32(_e7628), i32(-2147483648), (_e7628 < -2147483600f)), 2147483647i, (_e7628 > 2147483500f)), (_e7628 == _e7628));
let _e7639 = (_e7635 - select(0i, 1i, (_e7628 < f32(_e7635))));
let _e7641 = select(0f, _e7609, (_e7609 > 0f));
let _e7643 = select(1e6f, _e7641, (_e7641 < 1e6f));
let _e7650 = select(0i, select(select(i32(_e7643), i32(-2147483648), (_e7643 < -2147483600f)), 2147483647i, (_e7643 > 2147483500f)), (_e7643 == _e7643));
let _e7654 = (_e7650 - select(0i, 1i, (_e7643 < f32(_e7650))));
let _e7658 = (_e7601 - f32(_e7639));
let _e7660 = (_e7609 - f32(_e7654));
local_5 = (_e7593 - f32(_e7624));
let _e7661 = (_e7624 + 1i);
let _e7663 = select(_e7661, 0i, (_e7661 < 0i));
if (_e7663 >= _e7346) {
phi_12545_ = (_e7346 - 1i);
} else {
phi_12545_ = _e7663;
}
let _e7667 = phi_12545_;
local_6 = (_e7667 - _e7624);
let _e7669 = (_e7639 + 1i);
let _e7671 = select(_e7669, 0i, (_e7669 < 0i));
if (_e7671 >= _e7350) {
phi_12558_ = (_e7350 - 1i);
} else {
phi_12558_ = _e7671;
}
let _e7675 = phi_12558_;
let _e7677 = ((_e7675 - _e7639) * _e7346);
let _e7678 = (_e7654 + 1i);
let _e7680 = select(_e7678, 0i, (_e7678 < 0i));
if (_e7680 >= _e7354) {
phi_12572_ = (_e7354 - 1i);
} else {
phi_12572_ = _e7680;
}
let _e7684 = phi_12572_;
let _e7692 = ((_e7469 + (((_e7654 * _e7350) + _e7639) * _e7346)) + _e7624);
let _e7694 = select(_e7476, _e7692, (_e7692 < _e7476));
let _e7699 = global_7.member[bitcast<u32>(select(0i, _e7694, (_e7694 > 0i)))];
let _e7700 = local_5;
let _e7703 = local_6;
let _e7704 = (_e7692 + _e7703);
let _e7706 = select(_e7476, _e7704, (_e7704 < _e7476));
let _e7711 = global_7.member[bitcast<u32>(select(0i, _e7706, (_e7706 > 0i)))];
let _e7712 = local_5;
let _e7715 = (1f - _e7658);
let _e7717 = (_e7692 + _e7677);
let _e7719 = select(_e7476, _e7717, (_e7717 < _e7476));
let _e7724 = global_7.member[bitcast<u32>(select(0i, _e7719, (_e7719 > 0i)))];
let _e7725 = local_5;
let _e7728 = local_6;
let _e7729 = (_e7717 + _e7728);
let _e7731 = select(_e7476, _e7729, (_e7729 < _e7476));
let _e7736 = global_7.member[bitcast<u32>(select(0i, _e7731, (_e7731 > 0i)))];
let _e7737 = local_5;
let _e7742 = (_e7692 + (((_e7684 - _e7654) * _e7346) * _e7350));
let _e7744 = select(_e7476, _e7742, (_e7742 < _e7476));
let _e7749 = global_7.member[bitcast<u32>(select(0i, _e7744, (_e7744 > 0i)))];
let _e7750 = local_5;
let _e7753 = local_6;
let _e7754 = (_e7742 + _e7753);
let _e7756 = select(_e7476, _e7754, (_e7754 < _e7476));
let _e7761 = global_7.member[bitcast<u32>(select(0i, _e7756, (_e7756 > 0i)))];
let _e7762 = local_5;
let _e7766 = (_e7742 + _e7677);
let _e7768 = select(_e7476, _e7766, (_e7766 < _e7476));
let _e7773 = global_7.member[bitcast<u32>(select(0i, _e7768, (_e7768 > 0i)))];
let _e7774 = local_5;
let _e7777 = local_6;
let _e7778 = (_e7766 + _e7777);
let _e7780 = select(_e7476, _e7778, (_e7778 < _e7476));
let _e7785 = global_7.member[bitcast<u32>(select(0i, _e7780, (_e7780 > 0i)))];
let _e7786 = local_5;
phi_12059_ = (_e7322 + 1u);
phi_12062_ = (_e7324 + ((0.5f * (((((((_e7483 * (1f - _e7484)) + (_e7495 * _e7496)) * _e7499) + (((_e7508 * (1f - _e7509)) + (_e7520 * _e7521)) * _e7436)) * (1f - _e7438)) + (((((_e7533 * (1f - _e7534)) + (_e7545 * _e7546)) * _e7499) + (((_e7557 * (1f - _e7558)) + (_e7569 * _e7570)) * _e7436)) * _e7438)) + ((((((_e7699 * (1f - _e7700)) + (_e7711 * _e7712)) * _e7715) + (((_e7724 * (1f - _e7725)) + (_e7736 * _e7737)) * _e7658)) * (1f - _e7660)) + (((((_e7749 * (1f - _e7750)) + (_e7761 * _e7762)) * _e7715) + (((_e7773 * (1f - _e7774)) + (_e7785 * _e7786)) * _e7658)) * _e7660)))) * _e7334));
} else {
phi_12059_ = u32();
phi_12062_ = f32();
}
let _e7801 = phi_12059_;
let _e7803 = phi_12062_;
continue;
continuing {
phi_12058_ = _e7801;
phi_12061_ = _e7803;
break if !(_e7327);
}
}
let _e11426 = local_80;
phi_12777_ = _e11426;
}
let _e7806 = phi_12777_;
let _e7807 = (_e7806 + select(_e3365, select(0f, _e6890, (_e6890 > 0f)), _e888));
let _e7809 = -((_e4326.member * _e7807));
let _e7811 = select(-87f, _e7809, (_e7809 > -87f));
let _e7813 = select(88f, _e7811, (_e7811 < 88f));
let _e7815 = ((_e7813 * 1.442695f) + 0.5f);
let _e7817 = select(-127f, _e7815, (_e7815 > -127f));
let _e7819 = select(128f, _e7817, (_e7817 < 128f));
let _e7826 = select(0i, select(select(i32(_e7819), i32(-2147483648), (_e7819 < -2147483600f)), 2147483647i, (_e7819 > 2147483500f)), (_e7819 == _e7819));
let _e7830 = (_e7826 - select(0i, 1i, (_e7819 < f32(_e7826))));
let _e7831 = f32(_e7830);
let _e7835 = ((_e7813 - (_e7831 * 0.6933594f)) - (_e7831 * -2.1219444e-4f));
let _e7857 = -((_e4326.member_1 * _e7807));
let _e7859 = select(-87f, _e7857, (_e7857 > -87f));
let _e7861 = select(88f, _e7859, (_e7859 < 88f));
let _e7863 = ((_e7861 * 1.442695f) + 0.5f);
let _e7865 = select(-127f, _e7863, (_e7863 > -127f));
let _e7867 = select(128f, _e7865, (_e7865 < 128f));
let _e7874 = select(0i, select(select(i32(_e7867), i32(-2147483648), (_e7867 < -2147483600f)), 2147483647i, (_e7867 > 2147483500f)), (_e7867 == _e7867));
let _e7878 = (_e7874 - select(0i, 1i, (_e7867 < f32(_e7874))));
let _e7879 = f32(_e7878);
let _e7883 = ((_e7861 - (_e7879 * 0.6933594f)) - (_e7879 * -2.1219444e-4f));
let _e7905 = -((_e4326.member_2 * _e7807));
let _e7907 = select(-87f, _e7905, (_e7905 > -87f));
let _e7909 = select(88f, _e7907, (_e7907 < 88f));
let _e7911 = ((_e7909 * 1.442695f) + 0.5f);
let _e7913 = select(-127f, _e7911, (_e7911 > -127f));
let _e7915 = select(128f, _e7913, (_e7913 < 128f));
let _e7922 = select(0i, select(select(i32(_e7915), i32(-2147483648), (_e7915 < -2147483600f)), 2147483647i, (_e7915 > 2147483500f)), (_e7915 == _e7915));
let _e7926 = (_e7922 - select(0i, 1i, (_e7915 < f32(_e7922))));
let _e7927 = f32(_e7926);
let _e7931 = ((_e7909 - (_e7927 * 0.6933594f)) - (_e7927 * -2.1219444e-4f));
let _e7957 = -((((_e7232.member.x * _e547) + (_e7232.member.y * _e558)) + (_e7232.member.z * _e569)));
let _e7959 = (_e4484 - (_e4485 * _e7957));
let _e7961 = select(1e-9f, _e7959, (_e7959 > 1e-9f));
if _e4504 {
let _e7972 = (0.5f - (0.5f * _e7957));
let _e7974 = select(0f, _e7972, (_e7972 > 0f));
let _e7978 = (sqrt(select(0f, _e7974, (_e7974 > 0f))) * 255f);
let _e7979 = (255f - 1f);
let _e7981 = select(0f, _e7978, (_e7978 > 0f));
let _e7983 = select(_e7979, _e7981, (_e7981 < _e7979));
let _e7990 = select(0i, select(select(i32(_e7983), i32(-2147483648), (_e7983 < -2147483600f)), 2147483647i, (_e7983 > 2147483500f)), (_e7983 == _e7983));
let _e7994 = (_e7990 - select(0i, 1i, (_e7983 < f32(_e7990))));
let _e7997 = global_1.member.member_13.member_11;
let _e7998 = bitcast<i32>(_e7997);
let _e7999 = (_e7998 + _e7994);
let _e8001 = (bitcast<i32>(_e188) - 1i);
let _e8003 = select(_e8001, _e7999, (_e7999 < _e8001));
let _e8008 = global_7.member[bitcast<u32>(select(0i, _e8003, (_e8003 > 0i)))];
let _e8010 = (_e7998 + (_e7994 + 1i));
let _e8012 = select(_e8001, _e8010, (_e8010 < _e8001));
let _e8017 = global_7.member[bitcast<u32>(select(0i, _e8012, (_e8012 > 0i)))];
phi_13138_ = (_e8008 + ((_e8017 - _e8008) * (_e7978 - f32(_e7994))));
} else {
phi_13138_ = select((_e4490 / (_e7961 * sqrt(select(0f, _e7961, (_e7961 > 0f))))), (0.75f * (1f + (_e7957 * _e7957))), _e4502);
}
let _e8024 = phi_13138_;
let _e8028 = ((3.1415927f * (_e8024 * _e4559)) * (select((_e1684 * ((2f * (1f + _e2785)) / (_e2788 * _e2788))), 1f, _e1685) * _e3057));
let _e8045 = (_e1714 * 0.34785485f);
let _e8055 = (_e1714 * 0.65214515f);
phi_4141_ = vec3<f32>(((_e2216.x + (((((_e3730.member_1.x * ((1f + (_e4357 * (1f + (_e4357 * (0.5f + (_e4357 * (0.16666667f + (_e4357 * (0.041666668f + (_e4357 * (0.008333334f + (_e4357 * (0.001388889f + (_e4357 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4352 + 127i)) << bitcast<u32>(23i))))) * _e4573.member) * _e4563) + (((_e4925.member_1.x * ((1f + (_e5528 * (1f + (_e5528 * (0.5f + (_e5528 * (0.16666667f + (_e5528 * (0.041666668f + (_e5528 * (0.008333334f + (_e5528 * (0.001388889f + (_e5528 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5523 + 127i)) << bitcast<u32>(23i))))) * _e4573.member) * _e5721)) * _e8045)) + (((((_e6080.member_1.x * ((1f + (_e6683 * (1f + (_e6683 * (0.5f + (_e6683 * (0.16666667f + (_e6683 * (0.041666668f + (_e6683 * (0.008333334f + (_e6683 * (0.001388889f + (_e6683 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6678 + 127i)) << bitcast<u32>(23i))))) * _e4573.member) * _e6876) + (((_e7232.member_1.x * ((1f + (_e7835 * (1f + (_e7835 * (0.5f + (_e7835 * (0.16666667f + (_e7835 * (0.041666668f + (_e7835 * (0.008333334f + (_e7835 * (0.001388889f + (_e7835 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7830 + 127i)) << bitcast<u32>(23i))))) * _e4573.member) * _e8028)) * _e8055)), ((_e2216.y + (((((_e3730.member_1.y * ((1f + (_e4405 * (1f + (_e4405 * (0.5f + (_e4405 * (0.16666667f + (_e4405 * (0.041666668f + (_e4405 * (0.008333334f + (_e4405 * (0.001388889f + (_e4405 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4400 + 127i)) << bitcast<u32>(23i))))) * _e4573.member_1) * _e4563) + (((_e4925.member_1.y * ((1f + (_e5576 * (1f + (_e5576 * (0.5f + (_e5576 * (0.16666667f + (_e5576 * (0.041666668f + (_e5576 * (0.008333334f + (_e5576 * (0.001388889f + (_e5576 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5571 + 127i)) << bitcast<u32>(23i))))) * _e4573.member_1) * _e5721)) * _e8045)) + (((((_e6080.member_1.y * ((1f + (_e6731 * (1f + (_e6731 * (0.5f + (_e6731 * (0.16666667f + (_e6731 * (0.041666668f + (_e6731 * (0.008333334f + (_e6731 * (0.001388889f + (_e6731 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6726 + 127i)) << bitcast<u32>(23i))))) * _e4573.member_1) * _e6876) + (((_e7232.member_1.y * ((1f + (_e7883 * (1f + (_e7883 * (0.5f + (_e7883 * (0.16666667f + (_e7883 * (0.041666668f + (_e7883 * (0.008333334f + (_e7883 * (0.001388889f + (_e7883 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7878 + 127i)) << bitcast<u32>(23i))))) * _e4573.member_1) * _e8028)) * _e8055)), ((_e2216.z + (((((_e3730.member_1.z * ((1f + (_e4453 * (1f + (_e4453 * (0.5f + (_e4453 * (0.16666667f + (_e4453 * (0.041666668f + (_e4453 * (0.008333334f + (_e4453 * (0.001388889f + (_e4453 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4448 + 127i)) << bitcast<u32>(23i))))) * _e4573.member_2) * _e4563) + (((_e4925.member_1.z * ((1f + (_e5624 * (1f + (_e5624 * (0.5f + (_e5624 * (0.16666667f + (_e5624 * (0.041666668f + (_e5624 * (0.008333334f + (_e5624 * (0.001388889f + (_e5624 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5619 + 127i)) << bitcast<u32>(23i))))) * _e4573.member_2) * _e5721)) * _e8045)) + (((((_e6080.member_1.z * ((1f + (_e6779 * (1f + (_e6779 * (0.5f + (_e6779 * (0.16666667f + (_e6779 * (0.041666668f + (_e6779 * (0.008333334f + (_e6779 * (0.001388889f + (_e6779 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6774 + 127i)) << bitcast<u32>(23i))))) * _e4573.member_2) * _e6876) + (((_e7232.member_1.z * ((1f + (_e7931 * (1f + (_e7931 * (0.5f + (_e7931 * (0.16666667f + (_e7931 * (0.041666668f + (_e7931 * (0.008333334f + (_e7931 * (0.001388889f + (_e7931 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7926 + 127i)) << bitcast<u32>(23i))))) * _e4573.member_2) * _e8028)) * _e8055)));
phi_4144_ = (_e2218 + 1i);
phi_4146_ = (_e3370 + (_e3332 * (select((_e1668 + (_e1684 * ((2f * _e3343) / select(1e-9f, _e3345, (_e3345 > 1e-9f))))), _e3343, _e1685) - _e3073)));
} else {
phi_4141_ = vec3<f32>();
phi_4144_ = i32();
phi_4146_ = f32();
}
let _e8068 = phi_4141_;
let _e8070 = phi_4144_;
let _e8072 = phi_4146_;
continue;
continuing {
phi_4140_ = _e8068;
phi_4143_ = _e8070;
phi_4145_ = _e8072;
break if !(_e2221);
}
}
let _e11433 = local_81;
phi_13199_ = _e11433;
} else {
phi_13199_ = vec3<f32>(0f, 0f, 0f);
}
let _e8075 = phi_13199_;
phi_13214_ = type_26(_e507.member, _e507.member_1, _e507.member_2, _e507.member_3, vec3<f32>((_e280 + (_e8075.x * _e803)), (_e291 + (_e8075.y * _e804)), (_e302 + (_e8075.z * _e805))), _e507.member_5, _e507.member_6, _e507.member_7, _e507.member_8, _e507.member_9);
} else {
phi_13214_ = _e507;
}
let _e8097 = phi_13214_;
let _e8098 = (_e708 == -1i);
let _e8099 = select(_e802, 0f, _e8098);
let _e8103 = (_e798 + (_e547 * _e8099));
let _e8104 = (_e799 + (_e558 * _e8099));
let _e8105 = (_e800 + (_e569 * _e8099));
let _e8106 = vec3<f32>(_e8103, _e8104, _e8105);
let _e8109 = (_e708 >= 0i);
if _e8109 {
let _e8154 = (_e708 * 19i);
let _e8156 = (bitcast<i32>(_e183) - 1i);
let _e8158 = select(_e8156, _e8154, (_e8154 < _e8156));
let _e8164 = global_4.member[bitcast<u32>(select(0i, _e8158, (_e8158 > 0i)))];
let _e8165 = (_e8154 + 1i);
let _e8167 = select(_e8156, _e8165, (_e8165 < _e8156));
let _e8173 = global_4.member[bitcast<u32>(select(0i, _e8167, (_e8167 > 0i)))];
let _e8174 = (_e8154 + 2i);
let _e8176 = select(_e8156, _e8174, (_e8174 < _e8156));
let _e8182 = global_4.member[bitcast<u32>(select(0i, _e8176, (_e8176 > 0i)))];
let _e8183 = (_e8154 + 3i);
let _e8185 = select(_e8156, _e8183, (_e8183 < _e8156));
let _e8191 = global_4.member[bitcast<u32>(select(0i, _e8185, (_e8185 > 0i)))];
let _e8192 = (_e8154 + 4i);
let _e8194 = select(_e8156, _e8192, (_e8192 < _e8156));
let _e8200 = global_4.member[bitcast<u32>(select(0i, _e8194, (_e8194 > 0i)))];
let _e8201 = (_e8154 + 5i);
let _e8203 = select(_e8156, _e8201, (_e8201 < _e8156));
let _e8209 = global_4.member[bitcast<u32>(select(0i, _e8203, (_e8203 > 0i)))];
let _e8210 = (_e8154 + 6i);
let _e8212 = select(_e8156, _e8210, (_e8210 < _e8156));
let _e8218 = global_4.member[bitcast<u32>(select(0i, _e8212, (_e8212 > 0i)))];
let _e8219 = (_e8154 + 7i);
let _e8221 = select(_e8156, _e8219, (_e8219 < _e8156));
let _e8227 = global_4.member[bitcast<u32>(select(0i, _e8221, (_e8221 > 0i)))];
let _e8228 = (_e8154 + 8i);
let _e8230 = select(_e8156, _e8228, (_e8228 < _e8156));
let _e8236 = global_4.member[bitcast<u32>(select(0i, _e8230, (_e8230 > 0i)))];
let _e8237 = (_e8191 - _e8164);
let _e8238 = (_e8200 - _e8173);
let _e8239 = (_e8209 - _e8182);
let _e8240 = (_e8218 - _e8164);
let _e8241 = (_e8227 - _e8173);
let _e8242 = (_e8236 - _e8182);
let _e8245 = ((_e8238 * _e8242) - (_e8239 * _e8241));
let _e8248 = ((_e8239 * _e8240) - (_e8237 * _e8242));
let _e8251 = ((_e8237 * _e8241) - (_e8238 * _e8240));
let _e8252 = (_e8191 - _e8103);
let _e8253 = (_e8200 - _e8104);
let _e8254 = (_e8209 - _e8105);
let _e8255 = (_e8218 - _e8103);
let _e8256 = (_e8227 - _e8104);
let _e8257 = (_e8236 - _e8105);
let _e8271 = (((((_e8253 * _e8257) - (_e8254 * _e8256)) * _e8245) + (((_e8254 * _e8255) - (_e8252 * _e8257)) * _e8248)) + (((_e8252 * _e8256) - (_e8253 * _e8255)) * _e8251));
let _e8273 = select(0f, _e8271, (_e8271 > 0f));
let _e8274 = (_e8164 - _e8103);
let _e8275 = (_e8173 - _e8104);
let _e8276 = (_e8182 - _e8105);
let _e8290 = (((((_e8256 * _e8276) - (_e8257 * _e8275)) * _e8245) + (((_e8257 * _e8274) - (_e8255 * _e8276)) * _e8248)) + (((_e8255 * _e8275) - (_e8256 * _e8274)) * _e8251));
let _e8292 = select(0f, _e8290, (_e8290 > 0f));
let _e8306 = (((((_e8275 * _e8254) - (_e8276 * _e8253)) * _e8245) + (((_e8276 * _e8252) - (_e8274 * _e8254)) * _e8248)) + (((_e8274 * _e8253) - (_e8275 * _e8252)) * _e8251));
let _e8308 = select(0f, _e8306, (_e8306 > 0f));
let _e8310 = ((_e8273 + _e8292) + _e8308);
let _e8312 = select(1e-30f, _e8310, (_e8310 > 1e-30f));
let _e8313 = (_e8273 / _e8312);
let _e8314 = (_e8292 / _e8312);
let _e8315 = (_e8308 / _e8312);
let _e8320 = (((_e8245 * _e8245) + (_e8248 * _e8248)) + (_e8251 * _e8251));
let _e8323 = sqrt(select(0f, _e8320, (_e8320 > 0f)));
let _e8326 = (1f / select(1e-20f, _e8323, (_e8323 > 1e-20f)));
let _e8331 = (_e8154 + 9i);
let _e8333 = select(_e8156, _e8331, (_e8331 < _e8156));
let _e8339 = global_4.member[bitcast<u32>(select(0i, _e8333, (_e8333 > 0i)))];
let _e8340 = (_e8154 + 10i);
let _e8342 = select(_e8156, _e8340, (_e8340 < _e8156));
let _e8348 = global_4.member[bitcast<u32>(select(0i, _e8342, (_e8342 > 0i)))];
let _e8349 = (_e8154 + 11i);
let _e8351 = select(_e8156, _e8349, (_e8349 < _e8156));
let _e8357 = global_4.member[bitcast<u32>(select(0i, _e8351, (_e8351 > 0i)))];
let _e8361 = (_e8154 + 12i);
let _e8363 = select(_e8156, _e8361, (_e8361 < _e8156));
let _e8369 = global_4.member[bitcast<u32>(select(0i, _e8363, (_e8363 > 0i)))];
let _e8370 = (_e8154 + 13i);
let _e8372 = select(_e8156, _e8370, (_e8370 < _e8156));
let _e8378 = global_4.member[bitcast<u32>(select(0i, _e8372, (_e8372 > 0i)))];
let _e8379 = (_e8154 + 14i);
let _e8381 = select(_e8156, _e8379, (_e8379 < _e8156));
let _e8387 = global_4.member[bitcast<u32>(select(0i, _e8381, (_e8381 > 0i)))];
let _e8394 = (_e8154 + 15i);
let _e8396 = select(_e8156, _e8394, (_e8394 < _e8156));
let _e8402 = global_4.member[bitcast<u32>(select(0i, _e8396, (_e8396 > 0i)))];
let _e8403 = (_e8154 + 16i);
let _e8405 = select(_e8156, _e8403, (_e8403 < _e8156));
let _e8411 = global_4.member[bitcast<u32>(select(0i, _e8405, (_e8405 > 0i)))];
let _e8412 = (_e8154 + 17i);
let _e8414 = select(_e8156, _e8412, (_e8412 < _e8156));
let _e8420 = global_4.member[bitcast<u32>(select(0i, _e8414, (_e8414 > 0i)))];
let _e8424 = (((_e8339 * _e8313) + (_e8369 * _e8314)) + (_e8402 * _e8315));
let _e8425 = (((_e8348 * _e8313) + (_e8378 * _e8314)) + (_e8411 * _e8315));
let _e8426 = (((_e8357 * _e8313) + (_e8387 * _e8314)) + (_e8420 * _e8315));
let _e8431 = (((_e8424 * _e8424) + (_e8425 * _e8425)) + (_e8426 * _e8426));
let _e8434 = sqrt(select(0f, _e8431, (_e8431 > 0f)));
let _e8437 = (1f / select(1e-20f, _e8434, (_e8434 > 1e-20f)));
let _e8442 = (_e8154 + 18i);
let _e8444 = select(_e8156, _e8442, (_e8442 < _e8156));
let _e8450 = global_4.member[bitcast<u32>(select(0i, _e8444, (_e8444 > 0i)))];
let _e8459 = (select(select(0i, select(select(i32(_e8450), i32(-2147483648), (_e8450 < -2147483600f)), 2147483647i, (_e8450 > 2147483500f)), (_e8450 == _e8450)), _e708, ((_e1534 & 1u) != 0u)) * 10i);
let _e8461 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e8463 = select(_e8461, _e8459, (_e8459 < _e8461));
let _e8469 = global_5.member[bitcast<u32>(select(0i, _e8463, (_e8463 > 0i)))];
let _e8470 = (_e8459 + 1i);
let _e8472 = select(_e8461, _e8470, (_e8470 < _e8461));
let _e8478 = global_5.member[bitcast<u32>(select(0i, _e8472, (_e8472 > 0i)))];
let _e8479 = (_e8459 + 2i);
let _e8481 = select(_e8461, _e8479, (_e8479 < _e8461));
let _e8487 = global_5.member[bitcast<u32>(select(0i, _e8481, (_e8481 > 0i)))];
let _e8491 = (_e8459 + 3i);
let _e8493 = select(_e8461, _e8491, (_e8491 < _e8461));
let _e8499 = global_5.member[bitcast<u32>(select(0i, _e8493, (_e8493 > 0i)))];
let _e8500 = (_e8459 + 4i);
let _e8502 = select(_e8461, _e8500, (_e8500 < _e8461));
let _e8508 = global_5.member[bitcast<u32>(select(0i, _e8502, (_e8502 > 0i)))];
let _e8509 = (_e8459 + 5i);
let _e8511 = select(_e8461, _e8509, (_e8509 < _e8461));
let _e8517 = global_5.member[bitcast<u32>(select(0i, _e8511, (_e8511 > 0i)))];
let _e8524 = (_e8459 + 6i);
let _e8526 = select(_e8461, _e8524, (_e8524 < _e8461));
let _e8532 = global_5.member[bitcast<u32>(select(0i, _e8526, (_e8526 > 0i)))];
let _e8533 = (_e8459 + 7i);
let _e8535 = select(_e8461, _e8533, (_e8533 < _e8461));
let _e8541 = global_5.member[bitcast<u32>(select(0i, _e8535, (_e8535 > 0i)))];
let _e8542 = (_e8459 + 8i);
let _e8544 = select(_e8461, _e8542, (_e8542 < _e8461));
let _e8550 = global_5.member[bitcast<u32>(select(0i, _e8544, (_e8544 > 0i)))];
let _e8558 = (_e8459 + 9i);
let _e8560 = select(_e8461, _e8558, (_e8558 < _e8461));
let _e8566 = global_5.member[bitcast<u32>(select(0i, _e8560, (_e8560 > 0i)))];
phi_13949_ = type_28(_e8106, vec3<f32>((_e8245 * _e8326), (_e8248 * _e8326), (_e8251 * _e8326)), vec3<f32>((_e8424 * _e8437), (_e8425 * _e8437), (_e8426 * _e8437)), vec3<f32>((((_e8469 * _e8313) + (_e8499 * _e8314)) + (_e8532 * _e8315)), (((_e8478 * _e8313) + (_e8508 * _e8314)) + (_e8541 * _e8315)), (((_e8487 * _e8313) + (_e8517 * _e8314)) + (_e8550 * _e8315))), _e8566, true, false);
} else {
let _e8110 = (_e708 == -3i);
let _e8116 = global_1.member.member_14.member_1.member.member;
let _e8121 = global_1.member.member_14.member_1.member_1;
let _e8127 = global_1.member.member_14.member.member.member;
let _e8132 = global_1.member.member_14.member.member_1;
let _e8142 = vec3<f32>(select(_e8127.member, _e8116.member, _e8110), select(_e8127.member_1, _e8116.member_1, _e8110), select(_e8127.member_2, _e8116.member_2, _e8110));
phi_13949_ = type_28(_e8106, _e8142, _e8142, vec3<f32>(select(_e8132.member, _e8121.member, _e8110), select(_e8132.member_1, _e8121.member_1, _e8110), select(_e8132.member_2, _e8121.member_2, _e8110)), 0f, false, _e8110);
}
let _e8569 = phi_13949_;
let _e8572 = ((select(0i, _e708, _e8109) * 19i) + 18i);
let _e8574 = (bitcast<i32>(_e183) - 1i);
let _e8576 = select(_e8574, _e8572, (_e8572 < _e8574));
let _e8582 = global_4.member[bitcast<u32>(select(0i, _e8576, (_e8576 > 0i)))];
let _e8589 = select(0i, select(select(i32(_e8582), i32(-2147483648), (_e8582 < -2147483600f)), 2147483647i, (_e8582 > 2147483500f)), (_e8582 == _e8582));
let _e8590 = (_e8589 * 4i);
let _e8592 = (bitcast<i32>(_e188) - 1i);
let _e8594 = select(_e8592, _e8590, (_e8590 < _e8592));
let _e8600 = global_7.member[bitcast<u32>(select(0i, _e8594, (_e8594 > 0i)))];
if _e8109 {
phi_14013_ = (select(_e8600, 1f, (_e8589 == 16i)) == 0f);
} else {
phi_14013_ = (_e708 != -1i);
}
let _e8606 = phi_14013_;
if _e716 {
let _e8617 = type_26(select(_e802, 1e30f, _e8098), _e8097.member_1, _e8097.member_2, _e8097.member_3, _e8097.member_4, _e8097.member_5, _e8097.member_6, _e8097.member_7, _e8097.member_8, _e8097.member_9);
let _e8629 = type_26(_e8617.member, select(_e802, _e881, (_e881 < _e802)), _e8617.member_2, _e8617.member_3, _e8617.member_4, _e8617.member_5, _e8617.member_6, _e8617.member_7, _e8617.member_8, _e8617.member_9);
let _e8641 = type_26(_e8629.member, _e8629.member_1, select(_e802, _e882, (_e882 < _e802)), _e8629.member_3, _e8629.member_4, _e8629.member_5, _e8629.member_6, _e8629.member_7, _e8629.member_8, _e8629.member_9);
let _e8652 = select(1f, -1f, ((((_e8569.member_1.x * _e547) + (_e8569.member_1.y * _e558)) + (_e8569.member_1.z * _e569)) > 0f));
let _e8664 = select(_e8652, -(_e8652), ((((_e8569.member_2.x * _e8569.member_1.x) + (_e8569.member_2.y * _e8569.member_1.y)) + (_e8569.member_2.z * _e8569.member_1.z)) < 0f));
let _e8665 = (_e8569.member_2.x * _e8664);
let _e8666 = (_e8569.member_2.y * _e8664);
let _e8667 = (_e8569.member_2.z * _e8664);
let _e8676 = ((((_e8665 * _e547) + (_e8666 * _e558)) + (_e8667 * _e569)) > 0f);
let _e8693 = type_26(_e8641.member, _e8641.member_1, _e8641.member_2, _e8641.member_3, _e8641.member_4, _e8641.member_5, _e8641.member_6, _e8641.member_7, _e8641.member_8, vec3<f32>(select(select(_e8665, (_e8569.member_1.x * _e8652), _e8676), 0f, _e8098), select(select(_e8666, (_e8569.member_1.y * _e8652), _e8676), 0f, _e8098), select(select(_e8667, (_e8569.member_1.z * _e8652), _e8676), 0f, _e8098)));
let _e8697 = (1f - (((_e1435 + _e1483) + _e1531) * _e1539));
let _e8701 = global_1.member.member_15.member_12;
phi_14133_ = type_26(_e8693.member, _e8693.member_1, _e8693.member_2, _e8693.member_3, _e8693.member_4, _e8693.member_5, _e8693.member_6, _e8693.member_7, select(1f, select(_e8697, _e8701, (_e8701 > _e8697)), _e8098), _e8693.member_9);
} else {
phi_14133_ = _e8097;
}
let _e8716 = phi_14133_;
if _e8098 {
let _e10110 = (((_e580 * _e580) + (_e591 * _e591)) + (_e602 * _e602));
let _e10113 = sqrt(select(0f, _e10110, (_e10110 > 0f)));
let _e10118 = (((_e613 * _e613) + (_e624 * _e624)) + (_e635 * _e635));
let _e10121 = sqrt(select(0f, _e10118, (_e10118 > 0f)));
let _e10123 = select(_e10121, _e10113, (_e10113 > _e10121));
let _e10127 = global_1.member.member_15.member_4;
let _e10135 = (((_e10127.member * _e547) + (_e10127.member_1 * _e558)) + (_e10127.member_2 * _e569));
let _e10139 = global_1.member.member_15.member_5;
let _e10147 = (((_e10139.member * _e547) + (_e10139.member_1 * _e558)) + (_e10139.member_2 * _e569));
let _e10151 = global_1.member.member_15.member_6;
let _e10159 = (((_e10151.member * _e547) + (_e10151.member_1 * _e558)) + (_e10151.member_2 * _e569));
let _e10163 = global_1.member.member_15.member;
let _e10167 = global_1.member.member_15.member_7;
let _e10171 = vec3<f32>(_e10167.member, _e10167.member_1, _e10167.member_2);
let _e10175 = global_1.member.member_15.member_8;
if (_e10163 == 0u) {
phi_15622_ = _e10171;
} else {
if (_e10163 == 1u) {
let _e11152 = select(-1f, _e10159, (_e10159 > -1f));
let _e11154 = select(1f, _e11152, (_e11152 < 1f));
if (_e11154 > 0f) {
phi_14237_ = _e10171;
} else {
let _e11159 = global_1.member.member_15.member_9;
phi_14237_ = vec3<f32>(_e11159.member, _e11159.member_1, _e11159.member_2);
}
let _e11165 = phi_14237_;
let _e11174 = bitcast<f32>((bitcast<u32>(_e11154) & 2147483647u));
let _e11177 = sqrt(select(0f, _e11174, (_e11174 > 0f)));
phi_15621_ = vec3<f32>((_e10175.member + ((_e11165.x - _e10175.member) * _e11177)), (_e10175.member_1 + ((_e11165.y - _e10175.member_1) * _e11177)), (_e10175.member_2 + ((_e11165.z - _e10175.member_2) * _e11177)));
} else {
if (_e10163 == 2u) {
let _e10952 = global_1.member.member_15.member_10;
let _e10953 = (_e10123 / _e10952);
let _e10955 = select(1e-4f, _e10953, (_e10953 > 1e-4f));
let _e10958 = bitcast<f32>((bitcast<u32>(_e10135) & 2147483647u));
let _e10961 = bitcast<f32>((bitcast<u32>(_e10147) & 2147483647u));
let _e10965 = select(_e10961, _e10958, (_e10958 > _e10961));
let _e10968 = (select(_e10961, _e10958, (_e10958 < _e10961)) / select(1.1754944e-38f, _e10965, (_e10965 > 1.1754944e-38f)));
let _e10969 = (_e10968 > 0.41421357f);
let _e10973 = select(_e10968, ((_e10968 - 1f) / (_e10968 + 1f)), _e10969);
let _e10974 = (_e10973 * _e10973);
let _e10989 = (select(0f, 0.7853982f, _e10969) + (_e10973 + ((_e10973 * _e10974) * (-0.33333334f + (_e10974 * (0.2f + (_e10974 * (-0.14285713f + (_e10974 * (0.11111111f + (_e10974 * (-0.09090909f + (_e10974 * 0.0585f)))))))))))));
let _e10992 = select(_e10989, (1.5707964f - _e10989), (_e10961 > _e10958));
let _e10995 = select(_e10992, (3.1415927f - _e10992), (_e10135 < 0f));
let _e11001 = (1f - (_e10159 * _e10159));
let _e11004 = sqrt(select(0f, _e11001, (_e11001 > 0f)));
let _e11007 = (_e10955 / select(1e-3f, _e11004, (_e11004 > 1e-3f)));
let _e11008 = ((select(_e10995, -(_e10995), (_e10147 < 0f)) / _e10952) * 0.5f);
let _e11010 = select(-8e6f, _e11008, (_e11008 > -8e6f));
let _e11012 = select(8e6f, _e11010, (_e11010 < 8e6f));
let _e11019 = select(0i, select(select(i32(_e11012), i32(-2147483648), (_e11012 < -2147483600f)), 2147483647i, (_e11012 > 2147483500f)), (_e11012 == _e11012));
let _e11026 = ((_e11008 - f32((_e11019 - select(0i, 1i, (_e11012 < f32(_e11019)))))) * 2f);
let _e11034 = ((select(select((_e11026 - 2f), (1f - _e11026), (_e11026 < 1.5f)), _e11026, (_e11026 < 0.5f)) * 2f) / _e11007);
let _e11036 = select(-1f, _e11034, (_e11034 > -1f));
let _e11039 = (2f - _e11007);
let _e11041 = select(0f, _e11039, (_e11039 > 0f));
let _e11046 = select(-1f, _e10159, (_e10159 > -1f));
let _e11048 = select(1f, _e11046, (_e11046 < 1f));
let _e11051 = ((1f - _e11048) * (1f + _e11048));
let _e11054 = sqrt(select(0f, _e11051, (_e11051 > 0f)));
let _e11057 = bitcast<f32>((bitcast<u32>(_e11054) & 2147483647u));
let _e11060 = bitcast<f32>((bitcast<u32>(_e11048) & 2147483647u));
let _e11064 = select(_e11060, _e11057, (_e11057 > _e11060));
let _e11067 = (select(_e11060, _e11057, (_e11057 < _e11060)) / select(1.1754944e-38f, _e11064, (_e11064 > 1.1754944e-38f)));
let _e11068 = (_e11067 > 0.41421357f);
let _e11072 = select(_e11067, ((_e11067 - 1f) / (_e11067 + 1f)), _e11068);
let _e11073 = (_e11072 * _e11072);
let _e11088 = (select(0f, 0.7853982f, _e11068) + (_e11072 + ((_e11072 * _e11073) * (-0.33333334f + (_e11073 * (0.2f + (_e11073 * (-0.14285713f + (_e11073 * (0.11111111f + (_e11073 * (-0.09090909f + (_e11073 * 0.0585f)))))))))))));
let _e11091 = select(_e11088, (1.5707964f - _e11088), (_e11060 > _e11057));
let _e11094 = select(_e11091, (3.1415927f - _e11091), (_e11054 < 0f));
let _e11099 = ((select(_e11094, -(_e11094), (_e11048 < 0f)) / _e10952) * 0.5f);
let _e11101 = select(-8e6f, _e11099, (_e11099 > -8e6f));
let _e11103 = select(8e6f, _e11101, (_e11101 < 8e6f));
let _e11110 = select(0i, select(select(i32(_e11103), i32(-2147483648), (_e11103 < -2147483600f)), 2147483647i, (_e11103 > 2147483500f)), (_e11103 == _e11103));
let _e11117 = ((_e11099 - f32((_e11110 - select(0i, 1i, (_e11103 < f32(_e11110)))))) * 2f);
let _e11125 = ((select(select((_e11117 - 2f), (1f - _e11117), (_e11117 < 1.5f)), _e11117, (_e11117 < 0.5f)) * 2f) / _e10955);
let _e11127 = select(-1f, _e11125, (_e11125 > -1f));
let _e11130 = (2f - _e10955);
let _e11132 = select(0f, _e11130, (_e11130 > 0f));
let _e11138 = (0.5f + ((0.5f * (select(1f, _e11036, (_e11036 < 1f)) * select(1f, _e11041, (_e11041 < 1f)))) * (select(1f, _e11127, (_e11127 < 1f)) * select(1f, _e11132, (_e11132 < 1f)))));
phi_15620_ = vec3<f32>((_e10167.member + ((_e10175.member - _e10167.member) * _e11138)), (_e10167.member_1 + ((_e10175.member_1 - _e10167.member_1) * _e11138)), (_e10167.member_2 + ((_e10175.member_2 - _e10167.member_2) * _e11138)));
} else {
let _e10185 = global_1.member.member_15.member_1;
let _e10186 = bitcast<i32>(_e10185);
let _e10191 = global_1.member.member_15.member_3;
let _e10193 = f32(bitcast<i32>(_e10191));
let _e10195 = (2f * 3.1415927f);
let _e10196 = ((_e10123 * f32(_e10186)) / _e10195);
let _e10198 = select(1e-6f, _e10196, (_e10196 > 1e-6f));
let _e10201 = bitcast<u32>(select(1.1754944e-38f, _e10198, (_e10198 > 1.1754944e-38f)));
let _e10202 = (_e10201 & 8388607u);
let _e10204 = select(0u, 1u, (_e10202 > 3474675u));
let _e10215 = bitcast<f32>((_e10202 | ((127u - _e10204) << bitcast<u32>(23i))));
let _e10218 = ((_e10215 - 1f) / (_e10215 + 1f));
let _e10219 = (_e10218 * _e10218);
let _e10234 = (f32(((bitcast<i32>((_e10201 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e10204))) + (((2f * _e10218) + ((_e10218 * _e10219) * (0.6666667f + (_e10219 * (0.4f + (_e10219 * (0.2857143f + (_e10219 * (0.22222222f + (_e10219 * 0.18181819f)))))))))) * 1.442695f));
let _e10235 = (_e10193 - 1f);
let _e10237 = select(0f, _e10234, (_e10234 > 0f));
let _e10239 = select(_e10235, _e10237, (_e10237 < _e10235));
let _e10240 = (_e10193 - 2f);
let _e10242 = select(0f, _e10240, (_e10240 > 0f));
let _e10244 = select(0f, _e10239, (_e10239 > 0f));
let _e10246 = select(_e10242, _e10244, (_e10244 < _e10242));
let _e10253 = select(0i, select(select(i32(_e10246), i32(-2147483648), (_e10246 < -2147483600f)), 2147483647i, (_e10246 > 2147483500f)), (_e10246 == _e10246));
let _e10257 = (_e10253 - select(0i, 1i, (_e10246 < f32(_e10253))));
let _e10260 = bitcast<f32>((bitcast<u32>(_e10147) & 2147483647u));
let _e10263 = bitcast<f32>((bitcast<u32>(_e10135) & 2147483647u));
let _e10267 = select(_e10263, _e10260, (_e10260 > _e10263));
let _e10270 = (select(_e10263, _e10260, (_e10260 < _e10263)) / select(1.1754944e-38f, _e10267, (_e10267 > 1.1754944e-38f)));
let _e10271 = (_e10270 > 0.41421357f);
let _e10275 = select(_e10270, ((_e10270 - 1f) / (_e10270 + 1f)), _e10271);
let _e10276 = (_e10275 * _e10275);
let _e10291 = (select(0f, 0.7853982f, _e10271) + (_e10275 + ((_e10275 * _e10276) * (-0.33333334f + (_e10276 * (0.2f + (_e10276 * (-0.14285713f + (_e10276 * (0.11111111f + (_e10276 * (-0.09090909f + (_e10276 * 0.0585f)))))))))))));
let _e10294 = select(_e10291, (1.5707964f - _e10291), (_e10263 > _e10260));
let _e10297 = select(_e10294, (3.1415927f - _e10294), (_e10147 < 0f));
let _e10302 = (0.5f - (select(_e10297, -(_e10297), (_e10135 < 0f)) / _e10195));
let _e10304 = select(-1f, _e10159, (_e10159 > -1f));
let _e10306 = select(1f, _e10304, (_e10304 < 1f));
let _e10309 = ((1f - _e10306) * (1f + _e10306));
let _e10312 = sqrt(select(0f, _e10309, (_e10309 > 0f)));
let _e10315 = bitcast<f32>((bitcast<u32>(_e10312) & 2147483647u));
let _e10318 = bitcast<f32>((bitcast<u32>(_e10306) & 2147483647u));
let _e10322 = select(_e10318, _e10315, (_e10315 > _e10318));
let _e10325 = (select(_e10318, _e10315, (_e10315 < _e10318)) / select(1.1754944e-38f, _e10322, (_e10322 > 1.1754944e-38f)));
let _e10326 = (_e10325 > 0.41421357f);
let _e10330 = select(_e10325, ((_e10325 - 1f) / (_e10325 + 1f)), _e10326);
let _e10331 = (_e10330 * _e10330);
let _e10346 = (select(0f, 0.7853982f, _e10326) + (_e10330 + ((_e10330 * _e10331) * (-0.33333334f + (_e10331 * (0.2f + (_e10331 * (-0.14285713f + (_e10331 * (0.11111111f + (_e10331 * (-0.09090909f + (_e10331 * 0.0585f)))))))))))));
let _e10349 = select(_e10346, (1.5707964f - _e10346), (_e10318 > _e10315));
let _e10352 = select(_e10349, (3.1415927f - _e10349), (_e10312 < 0f));
let _e10357 = (0.5f - (select(_e10352, -(_e10352), (_e10306 < 0f)) / 3.1415927f));
let _e10361 = global_1.member.member_15.member_2;
let _e10362 = bitcast<i32>(_e10361);
phi_14839_ = 0i;
phi_14842_ = 0i;
phi_14844_ = _e10362;
phi_14846_ = _e10186;
loop {
let _e10364 = phi_14839_;
let _e10366 = phi_14842_;
let _e10368 = phi_14844_;
let _e10370 = phi_14846_;
local_43 = _e10370;
local_44 = _e10368;
local_45 = _e10370;
local_46 = _e10370;
local_47 = _e10370;
local_48 = _e10370;
local_49 = _e10370;
local_50 = _e10370;
local_51 = _e10368;
local_52 = _e10368;
local_53 = _e10368;
local_54 = _e10368;
local_55 = _e10370;
local_56 = _e10366;
local_57 = _e10370;
local_58 = _e10366;
let _e10371 = (_e10364 < _e10257);
if _e10371 {
if (_e10370 > 1i) {
phi_14861_ = (_e10370 >> bitcast<u32>(1i));
} else {
phi_14861_ = 1i;
}
let _e10378 = phi_14861_;
if (_e10368 > 1i) {
phi_14867_ = (_e10368 >> bitcast<u32>(1i));
} else {
phi_14867_ = 1i;
}
let _e10383 = phi_14867_;
phi_14840_ = (_e10364 + 1i);
phi_14843_ = (_e10366 + (_e10370 * _e10368));
phi_14845_ = _e10383;
phi_14847_ = _e10378;
} else {
phi_14840_ = i32();
phi_14843_ = i32();
phi_14845_ = i32();
phi_14847_ = i32();
}
let _e10386 = phi_14840_;
let _e10388 = phi_14843_;
let _e10390 = phi_14845_;
let _e10392 = phi_14847_;
continue;
continuing {
phi_14839_ = _e10386;
phi_14842_ = _e10388;
phi_14844_ = _e10390;
phi_14846_ = _e10392;
break if !(_e10371);
}
}
let _e10395 = local_43;
let _e10396 = f32(_e10395);
let _e10398 = ((_e10302 * _e10396) - 0.5f);
let _e10400 = local_44;
let _e10401 = f32(_e10400);
let _e10403 = ((_e10357 * _e10401) - 0.5f);
let _e10405 = select(-1f, _e10398, (_e10398 > -1f));
let _e10407 = select(_e10396, _e10405, (_e10405 < _e10396));
let _e10414 = select(0i, select(select(i32(_e10407), i32(-2147483648), (_e10407 < -2147483600f)), 2147483647i, (_e10407 > 2147483500f)), (_e10407 == _e10407));
let _e10418 = (_e10414 - select(0i, 1i, (_e10407 < f32(_e10414))));
let _e10420 = select(-1f, _e10403, (_e10403 > -1f));
let _e10422 = select(_e10401, _e10420, (_e10420 < _e10401));
let _e10429 = select(0i, select(select(i32(_e10422), i32(-2147483648), (_e10422 < -2147483600f)), 2147483647i, (_e10422 > 2147483500f)), (_e10422 == _e10422));
let _e10433 = (_e10429 - select(0i, 1i, (_e10422 < f32(_e10429))));
let _e10435 = (_e10398 - f32(_e10418));
let _e10437 = (_e10403 - f32(_e10433));
let _e10439 = select(0f, _e10437, (_e10437 > 0f));
let _e10441 = select(1f, _e10439, (_e10439 < 1f));
if (_e10418 < 0i) {
let _e10444 = local_45;
phi_14942_ = (_e10418 + _e10444);
} else {
phi_14942_ = _e10418;
}
let _e10447 = phi_14942_;
let _e10449 = local_46;
if (_e10447 >= _e10449) {
let _e10452 = local_47;
phi_14948_ = (_e10447 - _e10452);
} else {
phi_14948_ = _e10447;
}
let _e10455 = phi_14948_;
let _e10456 = (_e10418 + 1i);
if (_e10456 < 0i) {
let _e10459 = local_48;
phi_14955_ = (_e10456 + _e10459);
} else {
phi_14955_ = _e10456;
}
let _e10462 = phi_14955_;
let _e10464 = local_49;
if (_e10462 >= _e10464) {
let _e10467 = local_50;
phi_14961_ = (_e10462 - _e10467);
} else {
phi_14961_ = _e10462;
}
let _e10470 = phi_14961_;
let _e10472 = select(_e10433, 0i, (_e10433 < 0i));
let _e10474 = local_51;
if (_e10472 >= _e10474) {
let _e10477 = local_52;
phi_14972_ = (_e10477 - 1i);
} else {
phi_14972_ = _e10472;
}
let _e10480 = phi_14972_;
let _e10481 = (_e10433 + 1i);
let _e10483 = select(_e10481, 0i, (_e10481 < 0i));
let _e10485 = local_53;
if (_e10483 >= _e10485) {
let _e10488 = local_54;
phi_14984_ = (_e10488 - 1i);
} else {
phi_14984_ = _e10483;
}
let _e10491 = phi_14984_;
let _e10493 = local_55;
let _e10496 = local_56;
let _e10497 = (_e10496 + (_e10480 * _e10493));
let _e10499 = local_57;
let _e10502 = local_58;
let _e10503 = (_e10502 + (_e10491 * _e10499));
let _e10505 = (3i * (_e10497 + _e10455));
let _e10507 = (bitcast<i32>(_e181) - 1i);
let _e10509 = select(_e10507, _e10505, (_e10505 < _e10507));
let _e10515 = global_3.member[bitcast<u32>(select(0i, _e10509, (_e10509 > 0i)))];
let _e10516 = (_e10505 + 1i);
let _e10518 = select(_e10507, _e10516, (_e10516 < _e10507));
let _e10524 = global_3.member[bitcast<u32>(select(0i, _e10518, (_e10518 > 0i)))];
let _e10525 = (_e10505 + 2i);
let _e10527 = select(_e10507, _e10525, (_e10525 < _e10507));
let _e10533 = global_3.member[bitcast<u32>(select(0i, _e10527, (_e10527 > 0i)))];
let _e10535 = (3i * (_e10497 + _e10470));
let _e10537 = select(_e10507, _e10535, (_e10535 < _e10507));
let _e10543 = global_3.member[bitcast<u32>(select(0i, _e10537, (_e10537 > 0i)))];
let _e10544 = (_e10535 + 1i);
let _e10546 = select(_e10507, _e10544, (_e10544 < _e10507));
let _e10552 = global_3.member[bitcast<u32>(select(0i, _e10546, (_e10546 > 0i)))];
let _e10553 = (_e10535 + 2i);
let _e10555 = select(_e10507, _e10553, (_e10553 < _e10507));
let _e10561 = global_3.member[bitcast<u32>(select(0i, _e10555, (_e10555 > 0i)))];
let _e10563 = (3i * (_e10503 + _e10455));
let _e10565 = select(_e10507, _e10563, (_e10563 < _e10507));
let _e10571 = global_3.member[bitcast<u32>(select(0i, _e10565, (_e10565 > 0i)))];
let _e10572 = (_e10563 + 1i);
let _e10574 = select(_e10507, _e10572, (_e10572 < _e10507));
let _e10580 = global_3.member[bitcast<u32>(select(0i, _e10574, (_e10574 > 0i)))];
let _e10581 = (_e10563 + 2i);
let _e10583 = select(_e10507, _e10581, (_e10581 < _e10507));
let _e10589 = global_3.member[bitcast<u32>(select(0i, _e10583, (_e10583 > 0i)))];
let _e10591 = (3i * (_e10503 + _e10470));
let _e10593 = select(_e10507, _e10591, (_e10591 < _e10507));
let _e10599 = global_3.member[bitcast<u32>(select(0i, _e10593, (_e10593 > 0i)))];
let _e10600 = (_e10591 + 1i);
let _e10602 = select(_e10507, _e10600, (_e10600 < _e10507));
let _e10608 = global_3.member[bitcast<u32>(select(0i, _e10602, (_e10602 > 0i)))];
let _e10609 = (_e10591 + 2i);
let _e10611 = select(_e10507, _e10609, (_e10609 < _e10507));
let _e10617 = global_3.member[bitcast<u32>(select(0i, _e10611, (_e10611 > 0i)))];
let _e10624 = (_e10515 + ((_e10543 - _e10515) * _e10435));
let _e10625 = (_e10524 + ((_e10552 - _e10524) * _e10435));
let _e10626 = (_e10533 + ((_e10561 - _e10533) * _e10435));
let _e10642 = (_e10624 + (((_e10571 + ((_e10599 - _e10571) * _e10435)) - _e10624) * _e10441));
let _e10643 = (_e10625 + (((_e10580 + ((_e10608 - _e10580) * _e10435)) - _e10625) * _e10441));
let _e10644 = (_e10626 + (((_e10589 + ((_e10617 - _e10589) * _e10435)) - _e10626) * _e10441));
phi_15220_ = 0i;
phi_15223_ = 0i;
phi_15225_ = _e10362;
phi_15227_ = _e10186;
loop {
let _e10647 = phi_15220_;
let _e10649 = phi_15223_;
let _e10651 = phi_15225_;
let _e10653 = phi_15227_;
local_59 = _e10653;
local_60 = _e10651;
local_61 = _e10653;
local_62 = _e10653;
local_63 = _e10653;
local_64 = _e10653;
local_65 = _e10653;
local_66 = _e10653;
local_67 = _e10651;
local_68 = _e10651;
local_69 = _e10651;
local_70 = _e10651;
local_71 = _e10653;
local_72 = _e10649;
local_73 = _e10653;
local_74 = _e10649;
let _e10654 = (_e10647 < (_e10257 + 1i));
if _e10654 {
if (_e10653 > 1i) {
phi_15242_ = (_e10653 >> bitcast<u32>(1i));
} else {
phi_15242_ = 1i;
}
let _e10661 = phi_15242_;
if (_e10651 > 1i) {
phi_15248_ = (_e10651 >> bitcast<u32>(1i));
} else {
phi_15248_ = 1i;
}
let _e10666 = phi_15248_;
phi_15221_ = (_e10647 + 1i);
phi_15224_ = (_e10649 + (_e10653 * _e10651));
phi_15226_ = _e10666;
phi_15228_ = _e10661;
} else {
phi_15221_ = i32();
phi_15224_ = i32();
phi_15226_ = i32();
phi_15228_ = i32();
}
let _e10669 = phi_15221_;
let _e10671 = phi_15224_;
let _e10673 = phi_15226_;
let _e10675 = phi_15228_;
continue;
continuing {
phi_15220_ = _e10669;
phi_15223_ = _e10671;
phi_15225_ = _e10673;
phi_15227_ = _e10675;
break if !(_e10654);
}
}
let _e10678 = local_59;
let _e10679 = f32(_e10678);
let _e10681 = ((_e10302 * _e10679) - 0.5f);
let _e10683 = local_60;
let _e10684 = f32(_e10683);
let _e10686 = ((_e10357 * _e10684) - 0.5f);
let _e10688 = select(-1f, _e10681, (_e10681 > -1f));
let _e10690 = select(_e10679, _e10688, (_e10688 < _e10679));
let _e10697 = select(0i, select(select(i32(_e10690), i32(-2147483648), (_e10690 < -2147483600f)), 2147483647i, (_e10690 > 2147483500f)), (_e10690 == _e10690));
let _e10701 = (_e10697 - select(0i, 1i, (_e10690 < f32(_e10697))));
let _e10703 = select(-1f, _e10686, (_e10686 > -1f));
let _e10705 = select(_e10684, _e10703, (_e10703 < _e10684));
let _e10712 = select(0i, select(select(i32(_e10705), i32(-2147483648), (_e10705 < -2147483600f)), 2147483647i, (_e10705 > 2147483500f)), (_e10705 == _e10705));
let _e10716 = (_e10712 - select(0i, 1i, (_e10705 < f32(_e10712))));
let _e10718 = (_e10681 - f32(_e10701));
let _e10720 = (_e10686 - f32(_e10716));
let _e10722 = select(0f, _e10720, (_e10720 > 0f));
let _e10724 = select(1f, _e10722, (_e10722 < 1f));
if (_e10701 < 0i) {
let _e10727 = local_61;
phi_15323_ = (_e10701 + _e10727);
} else {
phi_15323_ = _e10701;
}
let _e10730 = phi_15323_;
let _e10732 = local_62;
if (_e10730 >= _e10732) {
let _e10735 = local_63;
phi_15329_ = (_e10730 - _e10735);
} else {
phi_15329_ = _e10730;
}
let _e10738 = phi_15329_;
let _e10739 = (_e10701 + 1i);
if (_e10739 < 0i) {
let _e10742 = local_64;
phi_15336_ = (_e10739 + _e10742);
} else {
phi_15336_ = _e10739;
}
let _e10745 = phi_15336_;
let _e10747 = local_65;
if (_e10745 >= _e10747) {
let _e10750 = local_66;
phi_15342_ = (_e10745 - _e10750);
} else {
phi_15342_ = _e10745;
}
let _e10753 = phi_15342_;
let _e10755 = select(_e10716, 0i, (_e10716 < 0i));
let _e10757 = local_67;
if (_e10755 >= _e10757) {
let _e10760 = local_68;
phi_15353_ = (_e10760 - 1i);
} else {
phi_15353_ = _e10755;
}
let _e10763 = phi_15353_;
let _e10764 = (_e10716 + 1i);
let _e10766 = select(_e10764, 0i, (_e10764 < 0i));
let _e10768 = local_69;
if (_e10766 >= _e10768) {
let _e10771 = local_70;
phi_15365_ = (_e10771 - 1i);
} else {
phi_15365_ = _e10766;
}
let _e10774 = phi_15365_;
let _e10776 = local_71;
let _e10779 = local_72;
let _e10780 = (_e10779 + (_e10763 * _e10776));
let _e10782 = local_73;
let _e10785 = local_74;
let _e10786 = (_e10785 + (_e10774 * _e10782));
let _e10788 = (3i * (_e10780 + _e10738));
let _e10790 = select(_e10507, _e10788, (_e10788 < _e10507));
let _e10796 = global_3.member[bitcast<u32>(select(0i, _e10790, (_e10790 > 0i)))];
let _e10797 = (_e10788 + 1i);
let _e10799 = select(_e10507, _e10797, (_e10797 < _e10507));
let _e10805 = global_3.member[bitcast<u32>(select(0i, _e10799, (_e10799 > 0i)))];
let _e10806 = (_e10788 + 2i);
let _e10808 = select(_e10507, _e10806, (_e10806 < _e10507));
let _e10814 = global_3.member[bitcast<u32>(select(0i, _e10808, (_e10808 > 0i)))];
let _e10816 = (3i * (_e10780 + _e10753));
let _e10818 = select(_e10507, _e10816, (_e10816 < _e10507));
let _e10824 = global_3.member[bitcast<u32>(select(0i, _e10818, (_e10818 > 0i)))];
let _e10825 = (_e10816 + 1i);
let _e10827 = select(_e10507, _e10825, (_e10825 < _e10507));
let _e10833 = global_3.member[bitcast<u32>(select(0i, _e10827, (_e10827 > 0i)))];
let _e10834 = (_e10816 + 2i);
let _e10836 = select(_e10507, _e10834, (_e10834 < _e10507));
let _e10842 = global_3.member[bitcast<u32>(select(0i, _e10836, (_e10836 > 0i)))];
let _e10844 = (3i * (_e10786 + _e10738));
let _e10846 = select(_e10507, _e10844, (_e10844 < _e10507));
let _e10852 = global_3.member[bitcast<u32>(select(0i, _e10846, (_e10846 > 0i)))];
let _e10853 = (_e10844 + 1i);
let _e10855 = select(_e10507, _e10853, (_e10853 < _e10507));
let _e10861 = global_3.member[bitcast<u32>(select(0i, _e10855, (_e10855 > 0i)))];
let _e10862 = (_e10844 + 2i);
let _e10864 = select(_e10507, _e10862, (_e10862 < _e10507));
let _e10870 = global_3.member[bitcast<u32>(select(0i, _e10864, (_e10864 > 0i)))];
let _e10872 = (3i * (_e10786 + _e10753));
let _e10874 = select(_e10507, _e10872, (_e10872 < _e10507));
let _e10880 = global_3.member[bitcast<u32>(select(0i, _e10874, (_e10874 > 0i)))];
let _e10881 = (_e10872 + 1i);
let _e10883 = select(_e10507, _e10881, (_e10881 < _e10507));
let _e10889 = global_3.member[bitcast<u32>(select(0i, _e10883, (_e10883 > 0i)))];
let _e10890 = (_e10872 + 2i);
let _e10892 = select(_e10507, _e10890, (_e10890 < _e10507));
let _e10898 = global_3.member[bitcast<u32>(select(0i, _e10892, (_e10892 > 0i)))];
let _e10905 = (_e10796 + ((_e10824 - _e10796) * _e10718));
let _e10906 = (_e10805 + ((_e10833 - _e10805) * _e10718));
let _e10907 = (_e10814 + ((_e10842 - _e10814) * _e10718));
let _e10930 = (_e10239 - f32(_e10257));
let _e10932 = select(0f, _e10930, (_e10930 > 0f));
let _e10934 = select(1f, _e10932, (_e10932 < 1f));
let _e10944 = global_1.member.member_15.member_11;
phi_15620_ = vec3<f32>(((_e10642 + (((_e10905 + (((_e10852 + ((_e10880 - _e10852) * _e10718)) - _e10905) * _e10724)) - _e10642) * _e10934)) * _e10944), ((_e10643 + (((_e10906 + (((_e10861 + ((_e10889 - _e10861) * _e10718)) - _e10906) * _e10724)) - _e10643) * _e10934)) * _e10944), ((_e10644 + (((_e10907 + (((_e10870 + ((_e10898 - _e10870) * _e10718)) - _e10907) * _e10724)) - _e10644) * _e10934)) * _e10944));
}
let _e11150 = phi_15620_;
phi_15621_ = _e11150;
}
let _e11186 = phi_15621_;
phi_15622_ = _e11186;
}
let _e11188 = phi_15622_;
let _e11192 = global_1.member.member_15.member_12;
let _e11193 = select(1f, _e11192, _e716);
phi_17611_ = type_26(_e8716.member, _e8716.member_1, _e8716.member_2, vec3<f32>((_e8716.member_3.x + (((_e11188.x * _e1435) * _e803) * _e11193)), (_e8716.member_3.y + (((_e11188.y * _e1483) * _e804) * _e11193)), (_e8716.member_3.z + (((_e11188.z * _e1531) * _e805) * _e11193))), _e8716.member_4, _e8716.member_5, _e8716.member_6, _e8716.member_7, _e8716.member_8, _e8716.member_9);
} else {
if _e8606 {
let _e8721 = global_1.member.member_10.member_2;
let _e8729 = global_1.member.member_10.member;
let _e8730 = (_e8729 == 0u);
if _e8730 {
let _e9078 = global_1.member.member_10.member_1;
phi_16178_ = type_27(vec3<f32>(_e9078.member, _e9078.member_1, _e9078.member_2), vec3<f32>(_e8721.member, _e8721.member_1, _e8721.member_2));
} else {
let _e8734 = global_1.member.member_10.member_3;
let _e8739 = (_e8569.member.x - _e8734.member);
let _e8741 = (_e8569.member.y - _e8734.member_1);
let _e8743 = (_e8569.member.z - _e8734.member_2);
let _e8748 = (((_e8739 * _e8739) + (_e8741 * _e8741)) + (_e8743 * _e8743));
let _e8750 = select(1e-12f, _e8748, (_e8748 > 1e-12f));
let _e8751 = (1f / _e8750);
let _e8755 = vec3<f32>((_e8721.member * _e8751), (_e8721.member_1 * _e8751), (_e8721.member_2 * _e8751));
if (_e8729 == 2u) {
let _e8760 = global_1.member.member_10.member_1;
let _e8768 = (((_e8760.member * _e8739) + (_e8760.member_1 * _e8741)) + (_e8760.member_2 * _e8743));
let _e8771 = (1f / select(1e-20f, _e8768, (_e8768 > 1e-20f)));
let _e8776 = global_1.member.member_10.member_4.member;
let _e8785 = ((((_e8776.member * _e8739) + (_e8776.member_1 * _e8741)) + (_e8776.member_2 * _e8743)) * _e8771);
let _e8790 = global_1.member.member_10.member_4.member_1;
let _e8799 = ((((_e8790.member * _e8739) + (_e8790.member_1 * _e8741)) + (_e8790.member_2 * _e8743)) * _e8771);
let _e8804 = global_1.member.member_10.member_4.member_2;
let _e8807 = ((_e8785 * _e8785) + (_e8799 * _e8799));
let _e8816 = global_1.member.member_10.member_4.member_3;
let _e8817 = ((_e8804 - sqrt(select(0f, _e8807, (_e8807 > 0f)))) * _e8816);
let _e8819 = select(0f, _e8817, (_e8817 > 0f));
let _e8821 = select(1f, _e8819, (_e8819 < 1f));
let _e8827 = select(0f, ((_e8821 * _e8821) * (3f - (2f * _e8821))), (_e8768 > 0f));
let _e8832 = global_1.member.member_10.member_4.member_5;
if ((_e8832 > 0u) && (_e8827 > 0f)) {
let _e8837 = (0.5f / _e8804);
let _e8847 = global_1.member.member_10.member_4.member_6;
let _e8848 = bitcast<i32>(_e8847);
local_4 = bitcast<i32>(_e8832);
let _e8849 = local_4;
let _e8851 = f32((_e8849 - 1i));
let _e8853 = f32((_e8848 - 1i));
let _e8854 = local_4;
let _e8857 = (((0.5f + (_e8785 * _e8837)) * f32(_e8854)) - 0.5f);
let _e8859 = select(0f, _e8857, (_e8857 > 0f));
let _e8861 = select(_e8851, _e8859, (_e8859 < _e8851));
let _e8864 = (((0.5f - (_e8799 * _e8837)) * f32(_e8848)) - 0.5f);
let _e8866 = select(0f, _e8864, (_e8864 > 0f));
let _e8868 = select(_e8853, _e8866, (_e8866 < _e8853));
let _e8870 = select(0f, _e8861, (_e8861 > 0f));
let _e8872 = select(_e8851, _e8870, (_e8870 < _e8851));
let _e8879 = select(0i, select(select(i32(_e8872), i32(-2147483648), (_e8872 < -2147483600f)), 2147483647i, (_e8872 > 2147483500f)), (_e8872 == _e8872));
let _e8883 = (_e8879 - select(0i, 1i, (_e8872 < f32(_e8879))));
let _e8885 = select(0f, _e8868, (_e8868 > 0f));
let _e8887 = select(_e8853, _e8885, (_e8885 < _e8853));
let _e8894 = select(0i, select(select(i32(_e8887), i32(-2147483648), (_e8887 < -2147483600f)), 2147483647i, (_e8887 > 2147483500f)), (_e8887 == _e8887));
let _e8898 = (_e8894 - select(0i, 1i, (_e8887 < f32(_e8894))));
let _e8900 = (_e8861 - f32(_e8883));
let _e8902 = (_e8868 - f32(_e8898));
let _e8903 = (_e8883 + 1i);
let _e8904 = local_4;
let _e8906 = select(_e8883, _e8903, (_e8903 < _e8904));
let _e8907 = (_e8898 + 1i);
let _e8909 = select(_e8898, _e8907, (_e8907 < _e8848));
let _e8914 = global_1.member.member_10.member_4.member_4;
let _e8915 = bitcast<i32>(_e8914);
let _e8916 = local_4;
let _e8920 = (_e8915 + (3i * ((_e8898 * _e8916) + _e8883)));
let _e8922 = (bitcast<i32>(_e181) - 1i);
let _e8924 = select(_e8922, _e8920, (_e8920 < _e8922));
let _e8929 = global_3.member[bitcast<u32>(select(0i, _e8924, (_e8924 > 0i)))];
let _e8930 = (_e8920 + 1i);
let _e8932 = select(_e8922, _e8930, (_e8930 < _e8922));
let _e8937 = global_3.member[bitcast<u32>(select(0i, _e8932, (_e8932 > 0i)))];
let _e8938 = (_e8920 + 2i);
let _e8940 = select(_e8922, _e8938, (_e8938 < _e8922));
let _e8945 = global_3.member[bitcast<u32>(select(0i, _e8940, (_e8940 > 0i)))];
let _e8946 = local_4;
let _e8950 = (_e8915 + (3i * ((_e8898 * _e8946) + _e8906)));
let _e8952 = select(_e8922, _e8950, (_e8950 < _e8922));
let _e8957 = global_3.member[bitcast<u32>(select(0i, _e8952, (_e8952 > 0i)))];
let _e8958 = (_e8950 + 1i);
let _e8960 = select(_e8922, _e8958, (_e8958 < _e8922));
let _e8965 = global_3.member[bitcast<u32>(select(0i, _e8960, (_e8960 > 0i)))];
let _e8966 = (_e8950 + 2i);
let _e8968 = select(_e8922, _e8966, (_e8966 < _e8922));
let _e8973 = global_3.member[bitcast<u32>(select(0i, _e8968, (_e8968 > 0i)))];
let _e8974 = local_4;
let _e8978 = (_e8915 + (3i * ((_e8909 * _e8974) + _e8883)));
let _e8980 = select(_e8922, _e8978, (_e8978 < _e8922));
let _e8985 = global_3.member[bitcast<u32>(select(0i, _e8980, (_e8980 > 0i)))];
let _e8986 = (_e8978 + 1i);
let _e8988 = select(_e8922, _e8986, (_e8986 < _e8922));
let _e8993 = global_3.member[bitcast<u32>(select(0i, _e8988, (_e8988 > 0i)))];
let _e8994 = (_e8978 + 2i);
let _e8996 = select(_e8922, _e8994, (_e8994 < _e8922));
let _e9001 = global_3.member[bitcast<u32>(select(0i, _e8996, (_e8996 > 0i)))];
let _e9002 = local_4;
let _e9006 = (_e8915 + (3i * ((_e8909 * _e9002) + _e8906)));
let _e9008 = select(_e8922, _e9006, (_e9006 < _e8922));
let _e9013 = global_3.member[bitcast<u32>(select(0i, _e9008, (_e9008 > 0i)))];
let _e9014 = (_e9006 + 1i);
let _e9016 = select(_e8922, _e9014, (_e9014 < _e8922));
let _e9021 = global_3.member[bitcast<u32>(select(0i, _e9016, (_e9016 > 0i)))];
let _e9022 = (_e9006 + 2i);
let _e9024 = select(_e8922, _e9022, (_e9022 < _e8922));
let _e9029 = global_3.member[bitcast<u32>(select(0i, _e9024, (_e9024 > 0i)))];
let _e9036 = (_e8929 + ((_e8957 - _e8929) * _e8900));
let _e9037 = (_e8937 + ((_e8965 - _e8937) * _e8900));
let _e9038 = (_e8945 + ((_e8973 - _e8945) * _e8900));
phi_16162_ = vec3<f32>(((_e9036 + (((_e8985 + ((_e9013 - _e8985) * _e8900)) - _e9036) * _e8902)) * _e8827), ((_e9037 + (((_e8993 + ((_e9021 - _e8993) * _e8900)) - _e9037) * _e8902)) * _e8827), ((_e9038 + (((_e9001 + ((_e9029 - _e9001) * _e8900)) - _e9038) * _e8902)) * _e8827));
} else {
phi_16162_ = vec3(_e8827);
}
let _e9062 = phi_16162_;
phi_16165_ = (_e8755 * _e9062);
} else {
phi_16165_ = _e8755;
}
let _e9065 = phi_16165_;
let _e9069 = (1f / sqrt(select(0f, _e8750, (_e8750 > 0f))));
phi_16178_ = type_27(vec3<f32>((_e8739 * _e9069), (_e8741 * _e9069), (_e8743 * _e9069)), _e9065);
}
let _e9085 = phi_16178_;
let _e9087 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e9089 = select(_e9087, _e528, (_e528 < _e9087));
let _e9095 = global_8.member[bitcast<u32>(select(0i, _e9089, (_e9089 > 0i)))];
let _e9100 = global_1.member.member_10.member_3;
let _e9105 = (_e9100.member - _e8569.member.x);
let _e9107 = (_e9100.member_1 - _e8569.member.y);
let _e9109 = (_e9100.member_2 - _e8569.member.z);
let _e9114 = (((_e9105 * _e9105) + (_e9107 * _e9107)) + (_e9109 * _e9109));
let _e9118 = select(sqrt(select(0f, _e9114, (_e9114 > 0f))), 1e30f, _e8730);
let _e9120 = -(_e9085.member.x);
let _e9122 = -(_e9085.member.y);
let _e9124 = -(_e9085.member.z);
let _e9132 = (1f / select(_e9120, select(1e-12f, -1e-12f, (_e9120 < 0f)), (bitcast<f32>((bitcast<u32>(_e9120) & 2147483647u)) < 1e-12f)));
let _e9140 = (1f / select(_e9122, select(1e-12f, -1e-12f, (_e9122 < 0f)), (bitcast<f32>((bitcast<u32>(_e9122) & 2147483647u)) < 1e-12f)));
let _e9148 = (1f / select(_e9124, select(1e-12f, -1e-12f, (_e9124 < 0f)), (bitcast<f32>((bitcast<u32>(_e9124) & 2147483647u)) < 1e-12f)));
let _e9150 = ((_e833.member - _e8569.member.x) * _e9132);
let _e9152 = ((_e840.member - _e8569.member.x) * _e9132);
let _e9154 = ((_e833.member_1 - _e8569.member.y) * _e9140);
let _e9156 = ((_e840.member_1 - _e8569.member.y) * _e9140);
let _e9158 = ((_e833.member_2 - _e8569.member.z) * _e9148);
let _e9160 = ((_e840.member_2 - _e8569.member.z) * _e9148);
let _e9162 = select(_e9152, _e9150, (_e9150 < _e9152));
let _e9164 = select(_e9156, _e9154, (_e9154 < _e9156));
let _e9166 = select(_e9164, _e9162, (_e9162 > _e9164));
let _e9168 = select(_e9160, _e9158, (_e9158 < _e9160));
let _e9170 = select(_e9168, _e9166, (_e9166 > _e9168));
let _e9172 = select(_e9152, _e9150, (_e9150 > _e9152));
let _e9174 = select(_e9156, _e9154, (_e9154 > _e9156));
let _e9176 = select(_e9174, _e9172, (_e9172 < _e9174));
let _e9178 = select(_e9160, _e9158, (_e9158 > _e9160));
let _e9180 = select(_e9178, _e9176, (_e9176 < _e9178));
let _e9182 = select(0f, _e9170, (_e9170 > 0f));
let _e9184 = select(_e9118, _e9180, (_e9180 < _e9118));
let _e9185 = (_e9184 > _e9182);
let _e9186 = select(0f, _e9182, _e9185);
let _e9188 = (select(0f, _e9184, _e9185) - _e9186);
if _e888 {
phi_17106_ = _e9188;
} else {
let _e9190 = (_e9188 / f32(_e887));
phi_16387_ = 0u;
phi_16390_ = 0f;
loop {
let _e9192 = phi_16387_;
let _e9194 = phi_16390_;
local_82 = _e9194;
let _e9197 = ((_e9192 < _e887) && (_e9188 > 0f));
if _e9197 {
let _e9200 = (_e9186 + (_e9190 * f32(_e9192)));
let _e9201 = (_e9200 + _e9190);
let _e9203 = (0.5f * (_e9200 + _e9201));
let _e9204 = (_e9201 - _e9200);
let _e9205 = (0.28867513f * _e9204);
let _e9206 = (_e9203 - _e9205);
let _e9216 = global_1.member.member_13.member_7;
let _e9217 = bitcast<i32>(_e9216);
let _e9221 = global_1.member.member_13.member_8;
let _e9222 = bitcast<i32>(_e9221);
let _e9226 = global_1.member.member_13.member_9;
let _e9227 = bitcast<i32>(_e9226);
let _e9228 = f32(_e9217);
let _e9230 = (_e840.member - _e833.member);
let _e9233 = (((((_e8569.member.x + (_e9120 * _e9206)) - _e833.member) / _e9230) * _e9228) - 0.5f);
let _e9234 = (_e9228 - 1f);
let _e9236 = select(0f, _e9233, (_e9233 > 0f));
let _e9238 = select(_e9234, _e9236, (_e9236 < _e9234));
let _e9239 = f32(_e9222);
let _e9241 = (_e840.member_1 - _e833.member_1);
let _e9244 = (((((_e8569.member.y + (_e9122 * _e9206)) - _e833.member_1) / _e9241) * _e9239) - 0.5f);
let _e9245 = (_e9239 - 1f);
let _e9247 = select(0f, _e9244, (_e9244 > 0f));
let _e9249 = select(_e9245, _e9247, (_e9247 < _e9245));
let _e9250 = f32(_e9227);
let _e9252 = (_e840.member_2 - _e833.member_2);
let _e9255 = (((((_e8569.member.z + (_e9124 * _e9206)) - _e833.member_2) / _e9252) * _e9250) - 0.5f);
let _e9256 = (_e9250 - 1f);
let _e9258 = select(0f, _e9255, (_e9255 > 0f));
let _e9260 = select(_e9256, _e9258, (_e9258 < _e9256));
let _e9262 = select(0f, _e9238, (_e9238 > 0f));
let _e9264 = select(1e6f, _e9262, (_e9262 < 1e6f));
let _e9271 = select(0i, select(select(i32(_e9264), i32(-2147483648), (_e9264 < -2147483600f)), 2147483647i, (_e9264 > 2147483500f)), (_e9264 == _e9264));
let _e9275 = (_e9271 - select(0i, 1i, (_e9264 < f32(_e9271))));
let _e9277 = select(0f, _e9249, (_e9249 > 0f));
let _e9279 = select(1e6f, _e9277, (_e9277 < 1e6f));
let _e9286 = select(0i, select(select(i32(_e9279), i32(-2147483648), (_e9279 < -2147483600f)), 2147483647i, (_e9279 > 2147483500f)), (_e9279 == _e9279));
let _e9290 = (_e9286 - select(0i, 1i, (_e9279 < f32(_e9286))));
let _e9292 = select(0f, _e9260, (_e9260 > 0f));
let _e9294 = select(1e6f, _e9292, (_e9292 < 1e6f));
let _e9301 = select(0i, select(select(i32(_e9294), i32(-2147483648), (_e9294 < -2147483600f)), 2147483647i, (_e9294 > 2147483500f)), (_e9294 == _e9294));
let _e9305 = (_e9301 - select(0i, 1i, (_e9294 < f32(_e9301))));
let _e9309 = (_e9249 - f32(_e9290));
let _e9311 = (_e9260 - f32(_e9305));
local_2 = (_e9238 - f32(_e9275));
let _e9312 = (_e9275 + 1i);
let _e9314 = select(_e9312, 0i, (_e9312 < 0i));
if (_e9314 >= _e9217) {
phi_16528_ = (_e9217 - 1i);
} else {
phi_16528_ = _e9314;
}
let _e9318 = phi_16528_;
local_3 = (_e9318 - _e9275);
let _e9320 = (_e9290 + 1i);
let _e9322 = select(_e9320, 0i, (_e9320 < 0i));
if (_e9322 >= _e9222) {
phi_16541_ = (_e9222 - 1i);
} else {
phi_16541_ = _e9322;
}
let _e9326 = phi_16541_;
let _e9328 = ((_e9326 - _e9290) * _e9217);
let _e9329 = (_e9305 + 1i);
let _e9331 = select(_e9329, 0i, (_e9329 < 0i));
if (_e9331 >= _e9227) {
phi_16555_ = (_e9227 - 1i);
} else {
phi_16555_ = _e9331;
}
let _e9335 = phi_16555_;
let _e9342 = global_1.member.member_13.member_10;
let _e9343 = bitcast<i32>(_e9342);
let _e9348 = ((_e9343 + (((_e9305 * _e9222) + _e9290) * _e9217)) + _e9275);
let _e9350 = select(_e8592, _e9348, (_e9348 < _e8592));
let _e9355 = global_7.member[bitcast<u32>(select(0i, _e9350, (_e9350 > 0i)))];
let _e9356 = local_2;
let _e9359 = local_3;
let _e9360 = (_e9348 + _e9359);
let _e9362 = select(_e8592, _e9360, (_e9360 < _e8592));
let _e9367 = global_7.member[bitcast<u32>(select(0i, _e9362, (_e9362 > 0i)))];
let _e9368 = local_2;
let _e9371 = (1f - _e9309);
let _e9373 = (_e9348 + _e9328);
let _e9375 = select(_e8592, _e9373, (_e9373 < _e8592));
let _e9380 = global_7.member[bitcast<u32>(select(0i, _e9375, (_e9375 > 0i)))];
let _e9381 = local_2;
let _e9384 = local_3;
let _e9385 = (_e9373 + _e9384);
let _e9387 = select(_e8592, _e9385, (_e9385 < _e8592));
let _e9392 = global_7.member[bitcast<u32>(select(0i, _e9387, (_e9387 > 0i)))];
let _e9393 = local_2;
let _e9398 = (_e9348 + (((_e9335 - _e9305) * _e9217) * _e9222));
let _e9400 = select(_e8592, _e9398, (_e9398 < _e8592));
let _e9405 = global_7.member[bitcast<u32>(select(0i, _e9400, (_e9400 > 0i)))];
let _e9406 = local_2;
let _e9409 = local_3;
let _e9410 = (_e9398 + _e9409);
let _e9412 = select(_e8592, _e9410, (_e9410 < _e8592));
let _e9417 = global_7.member[bitcast<u32>(select(0i, _e9412, (_e9412 > 0i)))];
let _e9418 = local_2;
let _e9422 = (_e9398 + _e9328);
let _e9424 = select(_e8592, _e9422, (_e9422 < _e8592));
let _e9429 = global_7.member[bitcast<u32>(select(0i, _e9424, (_e9424 > 0i)))];
let _e9430 = local_2;
let _e9433 = local_3;
let _e9434 = (_e9422 + _e9433);
let _e9436 = select(_e8592, _e9434, (_e9434 < _e8592));
let _e9441 = global_7.member[bitcast<u32>(select(0i, _e9436, (_e9436 > 0i)))];
let _e9442 = local_2;
let _e9451 = (_e9203 + _e9205);
let _e9461 = (((((_e8569.member.x + (_e9120 * _e9451)) - _e833.member) / _e9230) * _e9228) - 0.5f);
let _e9463 = select(0f, _e9461, (_e9461 > 0f));
let _e9465 = select(_e9234, _e9463, (_e9463 < _e9234));
let _e9469 = (((((_e8569.member.y + (_e9122 * _e9451)) - _e833.member_1) / _e9241) * _e9239) - 0.5f);
let _e9471 = select(0f, _e9469, (_e9469 > 0f));
let _e9473 = select(_e9245, _e9471, (_e9471 < _e9245));
let _e9477 = (((((_e8569.member.z + (_e9124 * _e9451)) - _e833.member_2) / _e9252) * _e9250) - 0.5f);
let _e9479 = select(0f, _e9477, (_e9477 > 0f));
let _e9481 = select(_e9256, _e9479, (_e9479 < _e9256));
let _e9483 = select(0f, _e9465, (_e9465 > 0f));
let _e9485 = select(1e6f, _e9483, (_e9483 < 1e6f));
let _e9492 = select(0i, select(select(i32(_e9485), i32(-2147483648), (_e9485 < -2147483600f)), 2147483647i, (_e9485 > 2147483500f)), (_e9485 == _e9485));
let _e9496 = (_e9492 - select(0i, 1i, (_e9485 < f32(_e9492))));
let _e9498 = select(0f, _e9473, (_e9473 > 0f));
let _e9500 = select(1e6f, _e9498, (_e9498 < 1e6f));
let _e9507 = select(0i, select(select(i32(_e9500), i32(-2147483648), (_e9500 < -2147483600f)), 2147483647i, (_e9500 > 2147483500f)), (_e9500 == _e9500));
let _e9511 = (_e9507 - select(0i, 1i, (_e9500 < f32(_e9507))));
let _e9513 = select(0f, _e9481, (_e9481 > 0f));
let _e9515 = select(1e6f, _e9513, (_e9513 < 1e6f));
let _e9522 = select(0i, select(select(i32(_e9515), i32(-2147483648), (_e9515 < -2147483600f)), 2147483647i, (_e9515 > 2147483500f)), (_e9515 == _e9515));
let _e9526 = (_e9522 - select(0i, 1i, (_e9515 < f32(_e9522))));
let _e9530 = (_e9473 - f32(_e9511));
let _e9532 = (_e9481 - f32(_e9526));
local = (_e9465 - f32(_e9496));
let _e9533 = (_e9496 + 1i);
let _e9535 = select(_e9533, 0i, (_e9533 < 0i));
if (_e9535 >= _e9217) {
phi_16874_ = (_e9217 - 1i);
} else {
phi_16874_ = _e9535;
}
let _e9539 = phi_16874_;
local_1 = (_e9539 - _e9496);
let _e9541 = (_e9511 + 1i);
let _e9543 = select(_e9541, 0i, (_e9541 < 0i));
if (_e9543 >= _e9222) {
phi_16887_ = (_e9222 - 1i);
} else {
phi_16887_ = _e9543;
}
let _e9547 = phi_16887_;
let _e9549 = ((_e9547 - _e9511) * _e9217);
let _e9550 = (_e9526 + 1i);
let _e9552 = select(_e9550, 0i, (_e9550 < 0i));
if (_e9552 >= _e9227) {
phi_16901_ = (_e9227 - 1i);
} else {
phi_16901_ = _e9552;
}
let _e9556 = phi_16901_;
let _e9564 = ((_e9343 + (((_e9526 * _e9222) + _e9511) * _e9217)) + _e9496);
let _e9566 = select(_e8592, _e9564, (_e9564 < _e8592));
let _e9571 = global_7.member[bitcast<u32>(select(0i, _e9566, (_e9566 > 0i)))];
let _e9572 = local;
let _e9575 = local_1;
let _e9576 = (_e9564 + _e9575);
let _e9578 = select(_e8592, _e9576, (_e9576 < _e8592));
let _e9583 = global_7.member[bitcast<u32>(select(0i, _e9578, (_e9578 > 0i)))];
let _e9584 = local;
let _e9587 = (1f - _e9530);
let _e9589 = (_e9564 + _e9549);
let _e9591 = select(_e8592, _e9589, (_e9589 < _e8592));
let _e9596 = global_7.member[bitcast<u32>(select(0i, _e9591, (_e9591 > 0i)))];
let _e9597 = local;
let _e9600 = local_1;
let _e9601 = (_e9589 + _e9600);
let _e9603 = select(_e8592, _e9601, (_e9601 < _e8592));
let _e9608 = global_7.member[bitcast<u32>(select(0i, _e9603, (_e9603 > 0i)))];
let _e9609 = local;
let _e9614 = (_e9564 + (((_e9556 - _e9526) * _e9217) * _e9222));
let _e9616 = select(_e8592, _e9614, (_e9614 < _e8592));
let _e9621 = global_7.member[bitcast<u32>(select(0i, _e9616, (_e9616 > 0i)))];
let _e9622 = local;
let _e9625 = local_1;
let _e9626 = (_e9614 + _e9625);
let _e9628 = select(_e8592, _e9626, (_e9626 < _e8592));
let _e9633 = global_7.member[bitcast<u32>(select(0i, _e9628, (_e9628 > 0i)))];
let _e9634 = local;
let _e9638 = (_e9614 + _e9549);
let _e9640 = select(_e8592, _e9638, (_e9638 < _e8592));
let _e9645 = global_7.member[bitcast<u32>(select(0i, _e9640, (_e9640 > 0i)))];
let _e9646 = local;
let _e9649 = local_1;
let _e9650 = (_e9638 + _e9649);
let _e9652 = select(_e8592, _e9650, (_e9650 < _e8592));
let _e9657 = global_7.member[bitcast<u32>(select(0i, _e9652, (_e9652 > 0i)))];
let _e9658 = local;
phi_16388_ = (_e9192 + 1u);
phi_16391_ = (_e9194 + ((0.5f * (((((((_e9355 * (1f - _e9356)) + (_e9367 * _e9368)) * _e9371) + (((_e9380 * (1f - _e9381)) + (_e9392 * _e9393)) * _e9309)) * (1f - _e9311)) + (((((_e9405 * (1f - _e9406)) + (_e9417 * _e9418)) * _e9371) + (((_e9429 * (1f - _e9430)) + (_e9441 * _e9442)) * _e9309)) * _e9311)) + ((((((_e9571 * (1f - _e9572)) + (_e9583 * _e9584)) * _e9587) + (((_e9596 * (1f - _e9597)) + (_e9608 * _e9609)) * _e9530)) * (1f - _e9532)) + (((((_e9621 * (1f - _e9622)) + (_e9633 * _e9634)) * _e9587) + (((_e9645 * (1f - _e9646)) + (_e9657 * _e9658)) * _e9530)) * _e9532)))) * _e9204));
} else {
phi_16388_ = u32();
phi_16391_ = f32();
}
let _e9673 = phi_16388_;
let _e9675 = phi_16391_;
continue;
continuing {
phi_16387_ = _e9673;
phi_16390_ = _e9675;
break if !(_e9197);
}
}
let _e11453 = local_82;
phi_17106_ = _e11453;
}
let _e9678 = phi_17106_;
let _e9680 = -((_e1384.member * _e9678));
let _e9682 = select(-87f, _e9680, (_e9680 > -87f));
let _e9684 = select(88f, _e9682, (_e9682 < 88f));
let _e9686 = ((_e9684 * 1.442695f) + 0.5f);
let _e9688 = select(-127f, _e9686, (_e9686 > -127f));
let _e9690 = select(128f, _e9688, (_e9688 < 128f));
let _e9697 = select(0i, select(select(i32(_e9690), i32(-2147483648), (_e9690 < -2147483600f)), 2147483647i, (_e9690 > 2147483500f)), (_e9690 == _e9690));
let _e9701 = (_e9697 - select(0i, 1i, (_e9690 < f32(_e9697))));
let _e9702 = f32(_e9701);
let _e9706 = ((_e9684 - (_e9702 * 0.6933594f)) - (_e9702 * -2.1219444e-4f));
let _e9728 = -((_e1384.member_1 * _e9678));
let _e9730 = select(-87f, _e9728, (_e9728 > -87f));
let _e9732 = select(88f, _e9730, (_e9730 < 88f));
let _e9734 = ((_e9732 * 1.442695f) + 0.5f);
let _e9736 = select(-127f, _e9734, (_e9734 > -127f));
let _e9738 = select(128f, _e9736, (_e9736 < 128f));
let _e9745 = select(0i, select(select(i32(_e9738), i32(-2147483648), (_e9738 < -2147483600f)), 2147483647i, (_e9738 > 2147483500f)), (_e9738 == _e9738));
let _e9749 = (_e9745 - select(0i, 1i, (_e9738 < f32(_e9745))));
let _e9750 = f32(_e9749);
let _e9754 = ((_e9732 - (_e9750 * 0.6933594f)) - (_e9750 * -2.1219444e-4f));
let _e9776 = -((_e1384.member_2 * _e9678));
let _e9778 = select(-87f, _e9776, (_e9776 > -87f));
let _e9780 = select(88f, _e9778, (_e9778 < 88f));
let _e9782 = ((_e9780 * 1.442695f) + 0.5f);
let _e9784 = select(-127f, _e9782, (_e9782 > -127f));
let _e9786 = select(128f, _e9784, (_e9784 < 128f));
let _e9793 = select(0i, select(select(i32(_e9786), i32(-2147483648), (_e9786 < -2147483600f)), 2147483647i, (_e9786 > 2147483500f)), (_e9786 == _e9786));
let _e9797 = (_e9793 - select(0i, 1i, (_e9786 < f32(_e9793))));
let _e9798 = f32(_e9797);
let _e9802 = ((_e9780 - (_e9798 * 0.6933594f)) - (_e9798 * -2.1219444e-4f));
let _e9823 = (1f - _e9095);
let _e9835 = (((_e8569.member_1.x * _e547) + (_e8569.member_1.y * _e558)) + (_e8569.member_1.z * _e569));
let _e9837 = select(1f, -1f, (_e9835 > 0f));
let _e9849 = select(_e9837, -(_e9837), ((((_e8569.member_2.x * _e8569.member_1.x) + (_e8569.member_2.y * _e8569.member_1.y)) + (_e8569.member_2.z * _e8569.member_1.z)) < 0f));
let _e9850 = (_e8569.member_2.x * _e9849);
let _e9851 = (_e8569.member_2.y * _e9849);
let _e9852 = (_e8569.member_2.z * _e9849);
let _e9861 = ((((_e9850 * _e547) + (_e9851 * _e558)) + (_e9852 * _e569)) > 0f);
let _e9862 = select(_e9850, (_e8569.member_1.x * _e9837), _e9861);
let _e9863 = select(_e9851, (_e8569.member_1.y * _e9837), _e9861);
let _e9864 = select(_e9852, (_e8569.member_1.z * _e9837), _e9861);
let _e9870 = -((((_e9862 * _e9085.member.x) + (_e9863 * _e9085.member.y)) + (_e9864 * _e9085.member.z)));
let _e9880 = -(_e9870);
let _e9885 = select((select(0f, _e9880, (_e9880 > 0f)) * _e8569.member_4), select(0f, _e9870, (_e9870 > 0f)), (((((_e8569.member_1.x * _e9085.member.x) + (_e8569.member_1.y * _e9085.member.y)) + (_e8569.member_1.z * _e9085.member.z)) * _e9835) > 0f));
let _e9889 = global_1.member.member_15.member_4;
let _e9897 = (((_e9889.member * _e9862) + (_e9889.member_1 * _e9863)) + (_e9889.member_2 * _e9864));
let _e9901 = global_1.member.member_15.member_5;
let _e9909 = (((_e9901.member * _e9862) + (_e9901.member_1 * _e9863)) + (_e9901.member_2 * _e9864));
let _e9913 = global_1.member.member_15.member_6;
let _e9921 = (((_e9913.member * _e9862) + (_e9913.member_1 * _e9863)) + (_e9913.member_2 * _e9864));
let _e9925 = global_1.member.member_16.member_1;
let _e9935 = global_1.member.member_16.member_2;
let _e9948 = global_1.member.member_16.member_3;
let _e9961 = global_1.member.member_16.member_4;
let _e9965 = (_e9897 * _e9897);
let _e9972 = global_1.member.member_16.member_5;
let _e9976 = (_e9909 * _e9909);
let _e9986 = global_1.member.member_16.member_6;
let _e9990 = (_e9921 * _e9921);
let _e10000 = global_1.member.member_16.member_7;
let _e10004 = (_e9897 * _e9909);
let _e10011 = global_1.member.member_16.member_8;
let _e10015 = (_e9897 * _e9921);
let _e10025 = global_1.member.member_16.member_9;
let _e10029 = (_e9909 * _e9921);
let _e10039 = global_1.member.member_16.member;
let _e10049 = ((_e10039.member + (((_e9925.member * _e9897) + (_e9935.member * _e9909)) + (_e9948.member * _e9921))) + ((((_e9961.member * _e9965) + (_e9972.member * _e9976)) + (_e9986.member * _e9990)) + (((_e10000.member * _e10004) + (_e10011.member * _e10015)) + (_e10025.member * _e10029))));
let _e10050 = ((_e10039.member_1 + (((_e9925.member_1 * _e9897) + (_e9935.member_1 * _e9909)) + (_e9948.member_1 * _e9921))) + ((((_e9961.member_1 * _e9965) + (_e9972.member_1 * _e9976)) + (_e9986.member_1 * _e9990)) + (((_e10000.member_1 * _e10004) + (_e10011.member_1 * _e10015)) + (_e10025.member_1 * _e10029))));
let _e10051 = ((_e10039.member_2 + (((_e9925.member_2 * _e9897) + (_e9935.member_2 * _e9909)) + (_e9948.member_2 * _e9921))) + ((((_e9961.member_2 * _e9965) + (_e9972.member_2 * _e9976)) + (_e9986.member_2 * _e9990)) + (((_e10000.member_2 * _e10004) + (_e10011.member_2 * _e10015)) + (_e10025.member_2 * _e10029))));
phi_17610_ = type_26(_e8716.member, _e8716.member_1, _e8716.member_2, vec3<f32>((_e8716.member_3.x + (((_e8569.member_3.x * (((_e9085.member_1.x * (((1f + (_e9706 * (1f + (_e9706 * (0.5f + (_e9706 * (0.16666667f + (_e9706 * (0.041666668f + (_e9706 * (0.008333334f + (_e9706 * (0.001388889f + (_e9706 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9701 + 127i)) << bitcast<u32>(23i)))) * _e9823)) * _e9885) + select(0f, _e10049, (_e10049 > 0f)))) * _e1435) * _e803)), (_e8716.member_3.y + (((_e8569.member_3.y * (((_e9085.member_1.y * (((1f + (_e9754 * (1f + (_e9754 * (0.5f + (_e9754 * (0.16666667f + (_e9754 * (0.041666668f + (_e9754 * (0.008333334f + (_e9754 * (0.001388889f + (_e9754 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9749 + 127i)) << bitcast<u32>(23i)))) * _e9823)) * _e9885) + select(0f, _e10050, (_e10050 > 0f)))) * _e1483) * _e804)), (_e8716.member_3.z + (((_e8569.member_3.z * (((_e9085.member_1.z * (((1f + (_e9802 * (1f + (_e9802 * (0.5f + (_e9802 * (0.16666667f + (_e9802 * (0.041666668f + (_e9802 * (0.008333334f + (_e9802 * (0.001388889f + (_e9802 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9797 + 127i)) << bitcast<u32>(23i)))) * _e9823)) * _e9885) + select(0f, _e10051, (_e10051 > 0f)))) * _e1531) * _e805))), _e8716.member_4, _e8716.member_5, _e8716.member_6, _e8716.member_7, _e8716.member_8, _e8716.member_9);
} else {
phi_17610_ = _e8716;
}
let _e10105 = phi_17610_;
phi_17611_ = _e10105;
}
let _e11227 = phi_17611_;
global_6.member[_e204] = _e11227.member;
global_6.member[_e216] = _e11227.member_1;
global_6.member[_e227] = _e11227.member_2;
global_6.member[_e238] = _e11227.member_3.x;
global_6.member[_e249] = _e11227.member_3.y;
global_6.member[_e260] = _e11227.member_3.z;
global_6.member[_e271] = _e11227.member_4.x;
global_6.member[_e282] = _e11227.member_4.y;
global_6.member[_e293] = _e11227.member_4.z;
global_6.member[_e304] = _e11227.member_5.x;
global_6.member[_e315] = _e11227.member_5.y;
global_6.member[_e326] = _e11227.member_5.z;
global_6.member[_e337] = _e11227.member_6.x;
global_6.member[_e348] = _e11227.member_6.y;
global_6.member[_e359] = _e11227.member_6.z;
global_6.member[_e370] = _e11227.member_7.x;
global_6.member[_e381] = _e11227.member_7.y;
global_6.member[_e392] = _e11227.member_7.z;
global_6.member[_e403] = _e11227.member_8;
global_6.member[_e414] = _e11227.member_9.x;
global_6.member[_e425] = _e11227.member_9.y;
global_6.member[_e436] = _e11227.member_9.z;
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
