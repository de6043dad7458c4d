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
var phi_2017_: u32;
var phi_2020_: f32;
var phi_2155_: i32;
var phi_2168_: i32;
var phi_2182_: i32;
var phi_2498_: i32;
var phi_2511_: i32;
var phi_2525_: i32;
var phi_2018_: u32;
var phi_2021_: f32;
var phi_2730_: f32;
var phi_3093_: type_27;
var phi_3097_: type_27;
var phi_3211_: i32;
var phi_3363_: u32;
var phi_3366_: f32;
var phi_3501_: i32;
var phi_3514_: i32;
var phi_3528_: i32;
var phi_3844_: i32;
var phi_3857_: i32;
var phi_3871_: i32;
var phi_3364_: u32;
var phi_3367_: f32;
var phi_4076_: f32;
var phi_4078_: f32;
var phi_4081_: vec3<f32>;
var phi_4083_: i32;
var phi_4257_: i32;
var phi_4270_: i32;
var phi_4284_: i32;
var phi_4484_: f32;
var phi_4647_: i32;
var phi_4660_: i32;
var phi_4674_: i32;
var phi_4874_: f32;
var phi_5036_: i32;
var phi_5049_: i32;
var phi_5063_: i32;
var phi_5263_: f32;
var phi_5425_: i32;
var phi_5438_: i32;
var phi_5452_: i32;
var phi_5652_: f32;
var phi_6213_: vec3<f32>;
var phi_6216_: vec3<f32>;
var phi_6229_: type_26;
var phi_6425_: u32;
var phi_6428_: f32;
var phi_6566_: i32;
var phi_6579_: i32;
var phi_6593_: i32;
var phi_6912_: i32;
var phi_6925_: i32;
var phi_6939_: i32;
var phi_6426_: u32;
var phi_6429_: f32;
var phi_7144_: f32;
var phi_7943_: vec3<f32>;
var phi_7946_: vec3<f32>;
var phi_7959_: type_26;
var phi_8155_: u32;
var phi_8158_: f32;
var phi_8296_: i32;
var phi_8309_: i32;
var phi_8323_: i32;
var phi_8642_: i32;
var phi_8655_: i32;
var phi_8669_: i32;
var phi_8156_: u32;
var phi_8159_: f32;
var phi_8874_: f32;
var phi_9677_: vec3<f32>;
var phi_9680_: vec3<f32>;
var phi_9693_: type_26;
var phi_9889_: u32;
var phi_9892_: f32;
var phi_10030_: i32;
var phi_10043_: i32;
var phi_10057_: i32;
var phi_10376_: i32;
var phi_10389_: i32;
var phi_10403_: i32;
var phi_9890_: u32;
var phi_9893_: f32;
var phi_10608_: f32;
var phi_11407_: vec3<f32>;
var phi_11410_: vec3<f32>;
var phi_11423_: type_26;
var phi_11619_: u32;
var phi_11622_: f32;
var phi_11760_: i32;
var phi_11773_: i32;
var phi_11787_: i32;
var phi_12106_: i32;
var phi_12119_: i32;
var phi_12133_: i32;
var phi_11620_: u32;
var phi_11623_: f32;
var phi_12338_: f32;
var phi_4079_: f32;
var phi_4082_: vec3<f32>;
var phi_4084_: i32;
var phi_12634_: vec3<f32>;
var phi_12649_: type_24;
var phi_13384_: type_25;
var phi_13448_: bool;
var phi_13568_: type_24;
var phi_15597_: vec3<f32>;
var phi_15600_: vec3<f32>;
var phi_15613_: type_26;
var phi_15822_: u32;
var phi_15825_: f32;
var phi_15963_: i32;
var phi_15976_: i32;
var phi_15990_: i32;
var phi_16309_: i32;
var phi_16322_: i32;
var phi_16336_: i32;
var phi_15823_: u32;
var phi_15826_: f32;
var phi_16541_: f32;
var phi_16893_: type_24;
var phi_14274_: i32;
var phi_14277_: i32;
var phi_14279_: i32;
var phi_14281_: i32;
var phi_14296_: i32;
var phi_14302_: i32;
var phi_14275_: i32;
var phi_14278_: i32;
var phi_14280_: i32;
var phi_14282_: i32;
var local_43: i32;
var local_44: i32;
var local_45: i32;
var phi_14377_: i32;
var local_46: i32;
var local_47: i32;
var phi_14383_: i32;
var local_48: i32;
var phi_14390_: i32;
var local_49: i32;
var local_50: i32;
var phi_14396_: i32;
var local_51: i32;
var local_52: i32;
var phi_14407_: i32;
var local_53: i32;
var local_54: i32;
var phi_14419_: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var phi_14655_: i32;
var phi_14658_: i32;
var phi_14660_: i32;
var phi_14662_: i32;
var phi_14677_: i32;
var phi_14683_: i32;
var phi_14656_: i32;
var phi_14659_: i32;
var phi_14661_: i32;
var phi_14663_: i32;
var local_59: i32;
var local_60: i32;
var local_61: i32;
var phi_14758_: i32;
var local_62: i32;
var local_63: i32;
var phi_14764_: i32;
var local_64: i32;
var phi_14771_: i32;
var local_65: i32;
var local_66: i32;
var phi_14777_: i32;
var local_67: i32;
var local_68: i32;
var phi_14788_: i32;
var local_69: i32;
var local_70: i32;
var phi_14800_: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var phi_15055_: vec3<f32>;
var phi_13672_: vec3<f32>;
var phi_15056_: vec3<f32>;
var phi_15057_: vec3<f32>;
var phi_16894_: type_24;
var local_75: f32;
var local_76: f32;
var local_77: f32;
var local_78: f32;
var local_79: f32;
var local_80: f32;
var local_81: vec3<f32>;
var local_82: f32;
let _e172 = global;
let _e179 = arrayLength((&global_3.member));
let _e181 = arrayLength((&global_4.member));
let _e186 = arrayLength((&global_7.member));
let _e193 = global_1.member.member;
if (_e172.x < _e193.member) {
if (_e172.y < _e193.member_1) {
let _e200 = (_e193.member * _e193.member_1);
let _e202 = ((_e172.y * _e193.member) + _e172.x);
let _e203 = bitcast<i32>(_e202);
let _e205 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e207 = select(_e205, _e203, (_e203 < _e205));
let _e213 = global_6.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e214 = (_e200 + _e202);
let _e215 = bitcast<i32>(_e214);
let _e217 = select(_e205, _e215, (_e215 < _e205));
let _e223 = global_6.member[bitcast<u32>(select(0i, _e217, (_e217 > 0i)))];
let _e225 = ((2u * _e200) + _e202);
let _e226 = bitcast<i32>(_e225);
let _e228 = select(_e205, _e226, (_e226 < _e205));
let _e234 = global_6.member[bitcast<u32>(select(0i, _e228, (_e228 > 0i)))];
let _e236 = ((3u * _e200) + _e202);
let _e237 = bitcast<i32>(_e236);
let _e239 = select(_e205, _e237, (_e237 < _e205));
let _e245 = global_6.member[bitcast<u32>(select(0i, _e239, (_e239 > 0i)))];
let _e247 = ((4u * _e200) + _e202);
let _e248 = bitcast<i32>(_e247);
let _e250 = select(_e205, _e248, (_e248 < _e205));
let _e256 = global_6.member[bitcast<u32>(select(0i, _e250, (_e250 > 0i)))];
let _e258 = ((5u * _e200) + _e202);
let _e259 = bitcast<i32>(_e258);
let _e261 = select(_e205, _e259, (_e259 < _e205));
let _e267 = global_6.member[bitcast<u32>(select(0i, _e261, (_e261 > 0i)))];
let _e269 = ((6u * _e200) + _e202);
let _e270 = bitcast<i32>(_e269);
let _e272 = select(_e205, _e270, (_e270 < _e205));
let _e278 = global_6.member[bitcast<u32>(select(0i, _e272, (_e272 > 0i)))];
let _e280 = ((7u * _e200) + _e202);
let _e281 = bitcast<i32>(_e280);
let _e283 = select(_e205, _e281, (_e281 < _e205));
let _e289 = global_6.member[bitcast<u32>(select(0i, _e283, (_e283 > 0i)))];
let _e291 = ((8u * _e200) + _e202);
let _e292 = bitcast<i32>(_e291);
let _e294 = select(_e205, _e292, (_e292 < _e205));
let _e300 = global_6.member[bitcast<u32>(select(0i, _e294, (_e294 > 0i)))];
let _e302 = ((9u * _e200) + _e202);
let _e303 = bitcast<i32>(_e302);
let _e305 = select(_e205, _e303, (_e303 < _e205));
let _e311 = global_6.member[bitcast<u32>(select(0i, _e305, (_e305 > 0i)))];
let _e313 = ((10u * _e200) + _e202);
let _e314 = bitcast<i32>(_e313);
let _e316 = select(_e205, _e314, (_e314 < _e205));
let _e322 = global_6.member[bitcast<u32>(select(0i, _e316, (_e316 > 0i)))];
let _e324 = ((11u * _e200) + _e202);
let _e325 = bitcast<i32>(_e324);
let _e327 = select(_e205, _e325, (_e325 < _e205));
let _e333 = global_6.member[bitcast<u32>(select(0i, _e327, (_e327 > 0i)))];
let _e335 = ((12u * _e200) + _e202);
let _e336 = bitcast<i32>(_e335);
let _e338 = select(_e205, _e336, (_e336 < _e205));
let _e344 = global_6.member[bitcast<u32>(select(0i, _e338, (_e338 > 0i)))];
let _e346 = ((13u * _e200) + _e202);
let _e347 = bitcast<i32>(_e346);
let _e349 = select(_e205, _e347, (_e347 < _e205));
let _e355 = global_6.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e357 = ((14u * _e200) + _e202);
let _e358 = bitcast<i32>(_e357);
let _e360 = select(_e205, _e358, (_e358 < _e205));
let _e366 = global_6.member[bitcast<u32>(select(0i, _e360, (_e360 > 0i)))];
let _e368 = ((15u * _e200) + _e202);
let _e369 = bitcast<i32>(_e368);
let _e371 = select(_e205, _e369, (_e369 < _e205));
let _e377 = global_6.member[bitcast<u32>(select(0i, _e371, (_e371 > 0i)))];
let _e379 = ((16u * _e200) + _e202);
let _e380 = bitcast<i32>(_e379);
let _e382 = select(_e205, _e380, (_e380 < _e205));
let _e388 = global_6.member[bitcast<u32>(select(0i, _e382, (_e382 > 0i)))];
let _e390 = ((17u * _e200) + _e202);
let _e391 = bitcast<i32>(_e390);
let _e393 = select(_e205, _e391, (_e391 < _e205));
let _e399 = global_6.member[bitcast<u32>(select(0i, _e393, (_e393 > 0i)))];
let _e401 = ((18u * _e200) + _e202);
let _e402 = bitcast<i32>(_e401);
let _e404 = select(_e205, _e402, (_e402 < _e205));
let _e410 = global_6.member[bitcast<u32>(select(0i, _e404, (_e404 > 0i)))];
let _e414 = global_1.member.member.member;
let _e418 = global_1.member.member.member_1;
let _e419 = (_e414 * _e418);
local_41 = bitcast<i32>(_e419);
let _e422 = ((_e172.y * _e414) + _e172.x);
let _e423 = bitcast<i32>(_e422);
local_42 = _e423;
let _e424 = local_41;
let _e426 = local_42;
let _e427 = ((29i * _e424) + _e426);
let _e429 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e431 = select(_e429, _e427, (_e427 < _e429));
let _e436 = global_2.member[bitcast<u32>(select(0i, _e431, (_e431 > 0i)))];
let _e438 = local_41;
let _e440 = local_42;
let _e441 = ((36i * _e438) + _e440);
let _e443 = select(_e429, _e441, (_e441 < _e429));
let _e448 = global_2.member[bitcast<u32>(select(0i, _e443, (_e443 > 0i)))];
let _e459 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e436 == 2f) && (select(0i, select(select(i32(_e448), i32(-2147483648), (_e448 < -2147483600f)), 2147483647i, (_e448 > 2147483500f)), (_e448 == _e448)) == (bitcast<i32>(_e459) + 1i)))) > 1u) {
let _e471 = type_24(_e213, _e223, _e234, vec3<f32>(_e245, _e256, _e267), vec3<f32>(_e278, _e289, _e300), vec3<f32>(_e311, _e322, _e333), vec3<f32>(_e344, _e355, _e366), _e377, vec3<f32>(_e388, _e399, _e410));
let _e473 = select(_e429, _e423, (_e423 < _e429));
let _e479 = global_2.member[bitcast<u32>(select(0i, _e473, (_e473 > 0i)))];
let _e481 = bitcast<i32>((_e419 + _e422));
let _e483 = select(_e429, _e481, (_e481 < _e429));
let _e489 = global_2.member[bitcast<u32>(select(0i, _e483, (_e483 > 0i)))];
let _e492 = bitcast<i32>(((2u * _e419) + _e422));
let _e494 = select(_e429, _e492, (_e492 < _e429));
let _e500 = global_2.member[bitcast<u32>(select(0i, _e494, (_e494 > 0i)))];
let _e503 = bitcast<i32>(((3u * _e419) + _e422));
let _e505 = select(_e429, _e503, (_e503 < _e429));
let _e511 = global_2.member[bitcast<u32>(select(0i, _e505, (_e505 > 0i)))];
let _e514 = bitcast<i32>(((4u * _e419) + _e422));
let _e516 = select(_e429, _e514, (_e514 < _e429));
let _e522 = global_2.member[bitcast<u32>(select(0i, _e516, (_e516 > 0i)))];
let _e525 = bitcast<i32>(((5u * _e419) + _e422));
let _e527 = select(_e429, _e525, (_e525 < _e429));
let _e533 = global_2.member[bitcast<u32>(select(0i, _e527, (_e527 > 0i)))];
let _e536 = bitcast<i32>(((12u * _e419) + _e422));
let _e538 = select(_e429, _e536, (_e536 < _e429));
let _e544 = global_2.member[bitcast<u32>(select(0i, _e538, (_e538 > 0i)))];
let _e547 = bitcast<i32>(((13u * _e419) + _e422));
let _e549 = select(_e429, _e547, (_e547 < _e429));
let _e555 = global_2.member[bitcast<u32>(select(0i, _e549, (_e549 > 0i)))];
let _e558 = bitcast<i32>(((14u * _e419) + _e422));
let _e560 = select(_e429, _e558, (_e558 < _e429));
let _e566 = global_2.member[bitcast<u32>(select(0i, _e560, (_e560 > 0i)))];
let _e569 = bitcast<i32>(((15u * _e419) + _e422));
let _e571 = select(_e429, _e569, (_e569 < _e429));
let _e577 = global_2.member[bitcast<u32>(select(0i, _e571, (_e571 > 0i)))];
let _e580 = bitcast<i32>(((16u * _e419) + _e422));
let _e582 = select(_e429, _e580, (_e580 < _e429));
let _e588 = global_2.member[bitcast<u32>(select(0i, _e582, (_e582 > 0i)))];
let _e591 = bitcast<i32>(((17u * _e419) + _e422));
let _e593 = select(_e429, _e591, (_e591 < _e429));
let _e599 = global_2.member[bitcast<u32>(select(0i, _e593, (_e593 > 0i)))];
let _e602 = bitcast<i32>(((18u * _e419) + _e422));
let _e604 = select(_e429, _e602, (_e602 < _e429));
let _e610 = global_2.member[bitcast<u32>(select(0i, _e604, (_e604 > 0i)))];
let _e613 = bitcast<i32>(((19u * _e419) + _e422));
let _e615 = select(_e429, _e613, (_e613 < _e429));
let _e621 = global_2.member[bitcast<u32>(select(0i, _e615, (_e615 > 0i)))];
let _e624 = bitcast<i32>(((20u * _e419) + _e422));
let _e626 = select(_e429, _e624, (_e624 < _e429));
let _e632 = global_2.member[bitcast<u32>(select(0i, _e626, (_e626 > 0i)))];
let _e635 = bitcast<i32>(((23u * _e419) + _e422));
let _e637 = select(_e429, _e635, (_e635 < _e429));
let _e643 = global_2.member[bitcast<u32>(select(0i, _e637, (_e637 > 0i)))];
let _e646 = bitcast<i32>(((24u * _e419) + _e422));
let _e648 = select(_e429, _e646, (_e646 < _e429));
let _e654 = global_2.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e657 = bitcast<i32>(((30u * _e419) + _e422));
let _e659 = select(_e429, _e657, (_e657 < _e429));
let _e665 = global_2.member[bitcast<u32>(select(0i, _e659, (_e659 > 0i)))];
let _e672 = select(0i, select(select(i32(_e643), i32(-2147483648), (_e643 < -2147483600f)), 2147483647i, (_e643 > 2147483500f)), (_e643 == _e643));
let _e680 = (select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < -2147483600f)), 2147483647i, (_e665 > 2147483500f)), (_e665 == _e665)) == 0i);
let _e688 = global_1.member.member_1.member;
let _e694 = global_1.member.member_1.member_1;
let _e704 = global_1.member.member_2.member;
let _e705 = (((((f32(bitcast<i32>(_e172.x)) + 0.5f) / f32(bitcast<i32>(_e688))) * 2f) - 1f) * _e704);
let _e713 = global_1.member.member_2.member_1;
let _e714 = ((1f - (((f32(bitcast<i32>(_e172.y)) + 0.5f) / f32(bitcast<i32>(_e694))) * 2f)) * _e713);
let _e717 = global_1.member.member_3;
let _e726 = global_1.member.member_4;
let _e739 = global_1.member.member_2.member_3;
let _e740 = (_e739 != 0u);
let _e743 = global_1.member.member_6;
let _e750 = select(_e743.member, (_e743.member + ((_e717.member * _e705) + (_e726.member * _e714))), _e740);
let _e751 = select(_e743.member_1, (_e743.member_1 + ((_e717.member_1 * _e705) + (_e726.member_1 * _e714))), _e740);
let _e752 = select(_e743.member_2, (_e743.member_2 + ((_e717.member_2 * _e705) + (_e726.member_2 * _e714))), _e740);
let _e762 = select(_e479, _e750, _e680);
let _e763 = select(_e489, _e751, _e680);
let _e764 = select(_e500, _e752, _e680);
let _e765 = vec3<f32>(_e762, _e763, _e764);
let _e766 = (select(0f, ((((_e479 - _e750) * _e511) + ((_e489 - _e751) * _e522)) + ((_e500 - _e752) * _e533)), _e680) + _e654);
let _e767 = select(_e610, 1f, _e680);
let _e768 = select(_e621, 1f, _e680);
let _e769 = select(_e632, 1f, _e680);
let _e777 = (1f / select(_e511, select(1e-12f, -1e-12f, (_e511 < 0f)), (bitcast<f32>((bitcast<u32>(_e511) & 2147483647u)) < 1e-12f)));
let _e785 = (1f / select(_e522, select(1e-12f, -1e-12f, (_e522 < 0f)), (bitcast<f32>((bitcast<u32>(_e522) & 2147483647u)) < 1e-12f)));
let _e793 = (1f / select(_e533, select(1e-12f, -1e-12f, (_e533 < 0f)), (bitcast<f32>((bitcast<u32>(_e533) & 2147483647u)) < 1e-12f)));
let _e797 = global_1.member.member_13.member_4;
let _e804 = global_1.member.member_13.member_5;
let _e809 = ((_e797.member - _e762) * _e777);
let _e811 = ((_e804.member - _e762) * _e777);
let _e813 = ((_e797.member_1 - _e763) * _e785);
let _e815 = ((_e804.member_1 - _e763) * _e785);
let _e817 = ((_e797.member_2 - _e764) * _e793);
let _e819 = ((_e804.member_2 - _e764) * _e793);
let _e821 = select(_e811, _e809, (_e809 < _e811));
let _e823 = select(_e815, _e813, (_e813 < _e815));
let _e825 = select(_e823, _e821, (_e821 > _e823));
let _e827 = select(_e819, _e817, (_e817 < _e819));
let _e829 = select(_e827, _e825, (_e825 > _e827));
let _e831 = select(_e811, _e809, (_e809 > _e811));
let _e833 = select(_e815, _e813, (_e813 > _e815));
let _e835 = select(_e833, _e831, (_e831 < _e833));
let _e837 = select(_e819, _e817, (_e817 > _e819));
let _e839 = select(_e837, _e835, (_e835 < _e837));
let _e841 = select(0f, _e829, (_e829 > 0f));
let _e843 = select(_e766, _e839, (_e839 < _e766));
let _e844 = (_e843 > _e841);
let _e845 = select(0f, _e841, _e844);
let _e846 = select(0f, _e843, _e844);
let _e847 = (_e846 - _e845);
let _e851 = global_1.member.member_13.member_6;
let _e852 = (_e851 == 0u);
if _e852 {
phi_2730_ = _e847;
} else {
let _e854 = (_e847 / f32(_e851));
phi_2017_ = 0u;
phi_2020_ = 0f;
loop {
let _e856 = phi_2017_;
let _e858 = phi_2020_;
local_75 = _e858;
let _e861 = ((_e856 < _e851) && (_e847 > 0f));
if _e861 {
let _e864 = (_e845 + (_e854 * f32(_e856)));
let _e865 = (_e864 + _e854);
let _e867 = (0.5f * (_e864 + _e865));
let _e868 = (_e865 - _e864);
let _e869 = (0.28867513f * _e868);
let _e870 = (_e867 - _e869);
let _e880 = global_1.member.member_13.member_7;
let _e881 = bitcast<i32>(_e880);
let _e885 = global_1.member.member_13.member_8;
let _e886 = bitcast<i32>(_e885);
let _e890 = global_1.member.member_13.member_9;
let _e891 = bitcast<i32>(_e890);
let _e892 = f32(_e881);
let _e894 = (_e804.member - _e797.member);
let _e897 = (((((_e762 + (_e511 * _e870)) - _e797.member) / _e894) * _e892) - 0.5f);
let _e898 = (_e892 - 1f);
let _e900 = select(0f, _e897, (_e897 > 0f));
let _e902 = select(_e898, _e900, (_e900 < _e898));
let _e903 = f32(_e886);
let _e905 = (_e804.member_1 - _e797.member_1);
let _e908 = (((((_e763 + (_e522 * _e870)) - _e797.member_1) / _e905) * _e903) - 0.5f);
let _e909 = (_e903 - 1f);
let _e911 = select(0f, _e908, (_e908 > 0f));
let _e913 = select(_e909, _e911, (_e911 < _e909));
let _e914 = f32(_e891);
let _e916 = (_e804.member_2 - _e797.member_2);
let _e919 = (((((_e764 + (_e533 * _e870)) - _e797.member_2) / _e916) * _e914) - 0.5f);
let _e920 = (_e914 - 1f);
let _e922 = select(0f, _e919, (_e919 > 0f));
let _e924 = select(_e920, _e922, (_e922 < _e920));
let _e926 = select(0f, _e902, (_e902 > 0f));
let _e928 = select(1e6f, _e926, (_e926 < 1e6f));
let _e935 = select(0i, select(select(i32(_e928), i32(-2147483648), (_e928 < -2147483600f)), 2147483647i, (_e928 > 2147483500f)), (_e928 == _e928));
let _e939 = (_e935 - select(0i, 1i, (_e928 < f32(_e935))));
let _e941 = select(0f, _e913, (_e913 > 0f));
let _e943 = select(1e6f, _e941, (_e941 < 1e6f));
let _e950 = select(0i, select(select(i32(_e943), i32(-2147483648), (_e943 < -2147483600f)), 2147483647i, (_e943 > 2147483500f)), (_e943 == _e943));
let _e954 = (_e950 - select(0i, 1i, (_e943 < f32(_e950))));
let _e956 = select(0f, _e924, (_e924 > 0f));
let _e958 = select(1e6f, _e956, (_e956 < 1e6f));
let _e965 = select(0i, select(select(i32(_e958), i32(-2147483648), (_e958 < -2147483600f)), 2147483647i, (_e958 > 2147483500f)), (_e958 == _e958));
let _e969 = (_e965 - select(0i, 1i, (_e958 < f32(_e965))));
let _e973 = (_e913 - f32(_e954));
let _e975 = (_e924 - f32(_e969));
local_39 = (_e902 - f32(_e939));
let _e976 = (_e939 + 1i);
let _e978 = select(_e976, 0i, (_e976 < 0i));
if (_e978 >= _e881) {
phi_2155_ = (_e881 - 1i);
} else {
phi_2155_ = _e978;
}
let _e982 = phi_2155_;
local_40 = (_e982 - _e939);
let _e984 = (_e954 + 1i);
let _e986 = select(_e984, 0i, (_e984 < 0i));
if (_e986 >= _e886) {
phi_2168_ = (_e886 - 1i);
} else {
phi_2168_ = _e986;
}
let _e990 = phi_2168_;
let _e992 = ((_e990 - _e954) * _e881);
let _e993 = (_e969 + 1i);
let _e995 = select(_e993, 0i, (_e993 < 0i));
if (_e995 >= _e891) {
phi_2182_ = (_e891 - 1i);
} else {
phi_2182_ = _e995;
}
let _e999 = phi_2182_;
let _e1006 = global_1.member.member_13.member_10;
let _e1007 = bitcast<i32>(_e1006);
let _e1012 = ((_e1007 + (((_e969 * _e886) + _e954) * _e881)) + _e939);
let _e1014 = (bitcast<i32>(_e186) - 1i);
let _e1016 = select(_e1014, _e1012, (_e1012 < _e1014));
let _e1021 = global_7.member[bitcast<u32>(select(0i, _e1016, (_e1016 > 0i)))];
let _e1022 = local_39;
let _e1025 = local_40;
let _e1026 = (_e1012 + _e1025);
let _e1028 = select(_e1014, _e1026, (_e1026 < _e1014));
let _e1033 = global_7.member[bitcast<u32>(select(0i, _e1028, (_e1028 > 0i)))];
let _e1034 = local_39;
let _e1037 = (1f - _e973);
let _e1039 = (_e1012 + _e992);
let _e1041 = select(_e1014, _e1039, (_e1039 < _e1014));
let _e1046 = global_7.member[bitcast<u32>(select(0i, _e1041, (_e1041 > 0i)))];
let _e1047 = local_39;
let _e1050 = local_40;
let _e1051 = (_e1039 + _e1050);
let _e1053 = select(_e1014, _e1051, (_e1051 < _e1014));
let _e1058 = global_7.member[bitcast<u32>(select(0i, _e1053, (_e1053 > 0i)))];
let _e1059 = local_39;
let _e1064 = (_e1012 + (((_e999 - _e969) * _e881) * _e886));
let _e1066 = select(_e1014, _e1064, (_e1064 < _e1014));
let _e1071 = global_7.member[bitcast<u32>(select(0i, _e1066, (_e1066 > 0i)))];
let _e1072 = local_39;
let _e1075 = local_40;
let _e1076 = (_e1064 + _e1075);
let _e1078 = select(_e1014, _e1076, (_e1076 < _e1014));
let _e1083 = global_7.member[bitcast<u32>(select(0i, _e1078, (_e1078 > 0i)))];
let _e1084 = local_39;
let _e1088 = (_e1064 + _e992);
let _e1090 = select(_e1014, _e1088, (_e1088 < _e1014));
let _e1095 = global_7.member[bitcast<u32>(select(0i, _e1090, (_e1090 > 0i)))];
let _e1096 = local_39;
let _e1099 = local_40;
let _e1100 = (_e1088 + _e1099);
let _e1102 = select(_e1014, _e1100, (_e1100 < _e1014));
let _e1107 = global_7.member[bitcast<u32>(select(0i, _e1102, (_e1102 > 0i)))];
let _e1108 = local_39;
let _e1117 = (_e867 + _e869);
let _e1127 = (((((_e762 + (_e511 * _e1117)) - _e797.member) / _e894) * _e892) - 0.5f);
let _e1129 = select(0f, _e1127, (_e1127 > 0f));
let _e1131 = select(_e898, _e1129, (_e1129 < _e898));
let _e1135 = (((((_e763 + (_e522 * _e1117)) - _e797.member_1) / _e905) * _e903) - 0.5f);
let _e1137 = select(0f, _e1135, (_e1135 > 0f));
let _e1139 = select(_e909, _e1137, (_e1137 < _e909));
let _e1143 = (((((_e764 + (_e533 * _e1117)) - _e797.member_2) / _e916) * _e914) - 0.5f);
let _e1145 = select(0f, _e1143, (_e1143 > 0f));
let _e1147 = select(_e920, _e1145, (_e1145 < _e920));
let _e1149 = select(0f, _e1131, (_e1131 > 0f));
let _e1151 = select(1e6f, _e1149, (_e1149 < 1e6f));
let _e1158 = select(0i, select(select(i32(_e1151), i32(-2147483648), (_e1151 < -2147483600f)), 2147483647i, (_e1151 > 2147483500f)), (_e1151 == _e1151));
let _e1162 = (_e1158 - select(0i, 1i, (_e1151 < f32(_e1158))));
let _e1164 = select(0f, _e1139, (_e1139 > 0f));
let _e1166 = select(1e6f, _e1164, (_e1164 < 1e6f));
let _e1173 = select(0i, select(select(i32(_e1166), i32(-2147483648), (_e1166 < -2147483600f)), 2147483647i, (_e1166 > 2147483500f)), (_e1166 == _e1166));
let _e1177 = (_e1173 - select(0i, 1i, (_e1166 < f32(_e1173))));
let _e1179 = select(0f, _e1147, (_e1147 > 0f));
let _e1181 = select(1e6f, _e1179, (_e1179 < 1e6f));
let _e1188 = select(0i, select(select(i32(_e1181), i32(-2147483648), (_e1181 < -2147483600f)), 2147483647i, (_e1181 > 2147483500f)), (_e1181 == _e1181));
let _e1192 = (_e1188 - select(0i, 1i, (_e1181 < f32(_e1188))));
let _e1196 = (_e1139 - f32(_e1177));
let _e1198 = (_e1147 - f32(_e1192));
local_37 = (_e1131 - f32(_e1162));
let _e1199 = (_e1162 + 1i);
let _e1201 = select(_e1199, 0i, (_e1199 < 0i));
if (_e1201 >= _e881) {
phi_2498_ = (_e881 - 1i);
} else {
phi_2498_ = _e1201;
}
let _e1205 = phi_2498_;
local_38 = (_e1205 - _e1162);
let _e1207 = (_e1177 + 1i);
let _e1209 = select(_e1207, 0i, (_e1207 < 0i));
if (_e1209 >= _e886) {
phi_2511_ = (_e886 - 1i);
} else {
phi_2511_ = _e1209;
}
let _e1213 = phi_2511_;
let _e1215 = ((_e1213 - _e1177) * _e881);
let _e1216 = (_e1192 + 1i);
let _e1218 = select(_e1216, 0i, (_e1216 < 0i));
if (_e1218 >= _e891) {
phi_2525_ = (_e891 - 1i);
} else {
phi_2525_ = _e1218;
}
let _e1222 = phi_2525_;
let _e1230 = ((_e1007 + (((_e1192 * _e886) + _e1177) * _e881)) + _e1162);
let _e1232 = select(_e1014, _e1230, (_e1230 < _e1014));
let _e1237 = global_7.member[bitcast<u32>(select(0i, _e1232, (_e1232 > 0i)))];
let _e1238 = local_37;
let _e1241 = local_38;
let _e1242 = (_e1230 + _e1241);
let _e1244 = select(_e1014, _e1242, (_e1242 < _e1014));
let _e1249 = global_7.member[bitcast<u32>(select(0i, _e1244, (_e1244 > 0i)))];
let _e1250 = local_37;
let _e1253 = (1f - _e1196);
let _e1255 = (_e1230 + _e1215);
let _e1257 = select(_e1014, _e1255, (_e1255 < _e1014));
let _e1262 = global_7.member[bitcast<u32>(select(0i, _e1257, (_e1257 > 0i)))];
let _e1263 = local_37;
let _e1266 = local_38;
let _e1267 = (_e1255 + _e1266);
let _e1269 = select(_e1014, _e1267, (_e1267 < _e1014));
let _e1274 = global_7.member[bitcast<u32>(select(0i, _e1269, (_e1269 > 0i)))];
let _e1275 = local_37;
let _e1280 = (_e1230 + (((_e1222 - _e1192) * _e881) * _e886));
let _e1282 = select(_e1014, _e1280, (_e1280 < _e1014));
let _e1287 = global_7.member[bitcast<u32>(select(0i, _e1282, (_e1282 > 0i)))];
let _e1288 = local_37;
let _e1291 = local_38;
let _e1292 = (_e1280 + _e1291);
let _e1294 = select(_e1014, _e1292, (_e1292 < _e1014));
let _e1299 = global_7.member[bitcast<u32>(select(0i, _e1294, (_e1294 > 0i)))];
let _e1300 = local_37;
let _e1304 = (_e1280 + _e1215);
let _e1306 = select(_e1014, _e1304, (_e1304 < _e1014));
let _e1311 = global_7.member[bitcast<u32>(select(0i, _e1306, (_e1306 > 0i)))];
let _e1312 = local_37;
let _e1315 = local_38;
let _e1316 = (_e1304 + _e1315);
let _e1318 = select(_e1014, _e1316, (_e1316 < _e1014));
let _e1323 = global_7.member[bitcast<u32>(select(0i, _e1318, (_e1318 > 0i)))];
let _e1324 = local_37;
phi_2018_ = (_e856 + 1u);
phi_2021_ = (_e858 + ((0.5f * (((((((_e1021 * (1f - _e1022)) + (_e1033 * _e1034)) * _e1037) + (((_e1046 * (1f - _e1047)) + (_e1058 * _e1059)) * _e973)) * (1f - _e975)) + (((((_e1071 * (1f - _e1072)) + (_e1083 * _e1084)) * _e1037) + (((_e1095 * (1f - _e1096)) + (_e1107 * _e1108)) * _e973)) * _e975)) + ((((((_e1237 * (1f - _e1238)) + (_e1249 * _e1250)) * _e1253) + (((_e1262 * (1f - _e1263)) + (_e1274 * _e1275)) * _e1196)) * (1f - _e1198)) + (((((_e1287 * (1f - _e1288)) + (_e1299 * _e1300)) * _e1253) + (((_e1311 * (1f - _e1312)) + (_e1323 * _e1324)) * _e1196)) * _e1198)))) * _e868));
} else {
phi_2018_ = u32();
phi_2021_ = f32();
}
let _e1339 = phi_2018_;
let _e1341 = phi_2021_;
continue;
continuing {
phi_2017_ = _e1339;
phi_2020_ = _e1341;
break if !(_e861);
}
}
let _e10871 = local_75;
phi_2730_ = _e10871;
}
let _e1344 = phi_2730_;
let _e1348 = global_1.member.member_13.member;
let _e1353 = -((_e1348.member * _e1344));
let _e1355 = select(-87f, _e1353, (_e1353 > -87f));
let _e1357 = select(88f, _e1355, (_e1355 < 88f));
let _e1359 = ((_e1357 * 1.442695f) + 0.5f);
let _e1361 = select(-127f, _e1359, (_e1359 > -127f));
let _e1363 = select(128f, _e1361, (_e1361 < 128f));
let _e1370 = select(0i, select(select(i32(_e1363), i32(-2147483648), (_e1363 < -2147483600f)), 2147483647i, (_e1363 > 2147483500f)), (_e1363 == _e1363));
let _e1374 = (_e1370 - select(0i, 1i, (_e1363 < f32(_e1370))));
let _e1375 = f32(_e1374);
let _e1379 = ((_e1357 - (_e1375 * 0.6933594f)) - (_e1375 * -2.1219444e-4f));
let _e1399 = ((1f + (_e1379 * (1f + (_e1379 * (0.5f + (_e1379 * (0.16666667f + (_e1379 * (0.041666668f + (_e1379 * (0.008333334f + (_e1379 * (0.001388889f + (_e1379 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1374 + 127i)) << bitcast<u32>(23i))));
let _e1401 = -((_e1348.member_1 * _e1344));
let _e1403 = select(-87f, _e1401, (_e1401 > -87f));
let _e1405 = select(88f, _e1403, (_e1403 < 88f));
let _e1407 = ((_e1405 * 1.442695f) + 0.5f);
let _e1409 = select(-127f, _e1407, (_e1407 > -127f));
let _e1411 = select(128f, _e1409, (_e1409 < 128f));
let _e1418 = select(0i, select(select(i32(_e1411), i32(-2147483648), (_e1411 < -2147483600f)), 2147483647i, (_e1411 > 2147483500f)), (_e1411 == _e1411));
let _e1422 = (_e1418 - select(0i, 1i, (_e1411 < f32(_e1418))));
let _e1423 = f32(_e1422);
let _e1427 = ((_e1405 - (_e1423 * 0.6933594f)) - (_e1423 * -2.1219444e-4f));
let _e1447 = ((1f + (_e1427 * (1f + (_e1427 * (0.5f + (_e1427 * (0.16666667f + (_e1427 * (0.041666668f + (_e1427 * (0.008333334f + (_e1427 * (0.001388889f + (_e1427 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1422 + 127i)) << bitcast<u32>(23i))));
let _e1449 = -((_e1348.member_2 * _e1344));
let _e1451 = select(-87f, _e1449, (_e1449 > -87f));
let _e1453 = select(88f, _e1451, (_e1451 < 88f));
let _e1455 = ((_e1453 * 1.442695f) + 0.5f);
let _e1457 = select(-127f, _e1455, (_e1455 > -127f));
let _e1459 = select(128f, _e1457, (_e1457 < 128f));
let _e1466 = select(0i, select(select(i32(_e1459), i32(-2147483648), (_e1459 < -2147483600f)), 2147483647i, (_e1459 > 2147483500f)), (_e1459 == _e1459));
let _e1470 = (_e1466 - select(0i, 1i, (_e1459 < f32(_e1466))));
let _e1471 = f32(_e1470);
let _e1475 = ((_e1453 - (_e1471 * 0.6933594f)) - (_e1471 * -2.1219444e-4f));
let _e1495 = ((1f + (_e1475 * (1f + (_e1475 * (0.5f + (_e1475 * (0.16666667f + (_e1475 * (0.041666668f + (_e1475 * (0.008333334f + (_e1475 * (0.001388889f + (_e1475 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1470 + 127i)) << bitcast<u32>(23i))));
let _e1498 = global_1.member.member_17;
let _e1503 = (1f / 3f);
if (((_e1498 & 2u) != 0u) && ((((_e767 + _e768) + _e769) * _e1503) >= 0.01f)) {
let _e1511 = global_1.member.member_10.member;
if (_e1511 == 2u) {
let _e1516 = global_1.member.member_10.member_1;
let _e1523 = global_1.member.member_10.member_3;
let _e1527 = (_e762 - _e1523.member);
let _e1528 = (_e763 - _e1523.member_1);
let _e1529 = (_e764 - _e1523.member_2);
let _e1534 = global_1.member.member_10.member_4.member_2;
let _e1536 = (1f + (_e1534 * _e1534));
let _e1541 = (((_e1516.member * _e1527) + (_e1516.member_1 * _e1528)) + (_e1516.member_2 * _e1529));
let _e1546 = (((_e1516.member * _e511) + (_e1516.member_1 * _e522)) + (_e1516.member_2 * _e533));
let _e1547 = (_e1536 * _e1546);
let _e1549 = ((_e1547 * _e1546) - 1f);
let _e1556 = ((_e1547 * _e1541) - (((_e1527 * _e511) + (_e1528 * _e522)) + (_e1529 * _e533)));
let _e1567 = ((_e1556 * _e1556) - (_e1549 * (((_e1536 * _e1541) * _e1541) - (((_e1527 * _e1527) + (_e1528 * _e1528)) + (_e1529 * _e1529)))));
let _e1568 = (_e1567 > 0f);
let _e1570 = sqrt(select(0f, _e1567, _e1568));
let _e1573 = (1f / select(_e1549, 1e-20f, (_e1549 == 0f)));
let _e1574 = -(_e1556);
let _e1576 = ((_e1574 - _e1570) * _e1573);
let _e1578 = ((_e1574 + _e1570) * _e1573);
let _e1580 = select(_e1578, _e1576, (_e1576 < _e1578));
let _e1582 = select(_e1578, _e1576, (_e1576 > _e1578));
if (_e1549 < 0f) {
let _e1603 = (_e1568 && ((_e1541 + (_e1546 * (0.5f * (_e1580 + _e1582)))) > 0f));
let _e1604 = select(_e846, _e1580, _e1603);
let _e1607 = select(_e845, _e1582, _e1603);
phi_3093_ = type_27(select(_e1604, _e845, (_e845 > _e1604)), select(_e1607, _e846, (_e846 < _e1607)));
} else {
let _e1587 = (-(_e1541) / select(_e1546, 1e-20f, (_e1546 == 0f)));
let _e1590 = (_e1546 > 0f);
let _e1591 = select(_e845, select(_e1587, _e1582, _e1568), _e1590);
let _e1594 = select(select(_e1587, _e1580, _e1568), _e846, _e1590);
phi_3093_ = type_27(select(_e1591, _e845, (_e845 > _e1591)), select(_e1594, _e846, (_e846 < _e1594)));
}
let _e1612 = phi_3093_;
phi_3097_ = _e1612;
} else {
phi_3097_ = type_27(_e845, _e846);
}
let _e1614 = phi_3097_;
if (_e1614.member_1 > _e1614.member) {
let _e1621 = global_1.member.member_10.member_3;
let _e1625 = (_e1621.member - _e762);
let _e1626 = (_e1621.member_1 - _e763);
let _e1627 = (_e1621.member_2 - _e764);
let _e1632 = (((_e1625 * _e511) + (_e1626 * _e522)) + (_e1627 * _e533));
let _e1636 = (_e1625 - (_e511 * _e1632));
let _e1637 = (_e1626 - (_e522 * _e1632));
let _e1638 = (_e1627 - (_e533 * _e1632));
let _e1643 = (((_e1636 * _e1636) + (_e1637 * _e1637)) + (_e1638 * _e1638));
let _e1646 = sqrt(select(0f, _e1643, (_e1643 > 0f)));
let _e1648 = select(1e-6f, _e1646, (_e1646 > 1e-6f));
let _e1649 = (_e1511 == 0u);
let _e1651 = ((_e1614.member - _e1632) / _e1648);
let _e1653 = (1f + (_e1651 * _e1651));
let _e1659 = select((_e1651 / (1f + sqrt(select(0f, _e1653, (_e1653 > 0f))))), _e1614.member, _e1649);
let _e1661 = ((_e1614.member_1 - _e1632) / _e1648);
let _e1663 = (1f + (_e1661 * _e1661));
let _e1670 = bitcast<i32>(_e851);
if (12i < _e1670) {
phi_3211_ = (_e1670 / 2i);
} else {
phi_3211_ = 6i;
}
let _e1674 = phi_3211_;
let _e1678 = ((select((_e1661 / (1f + sqrt(select(0f, _e1663, (_e1663 > 0f))))), _e1614.member_1, _e1649) - _e1659) * (0.5f / f32(_e1674)));
let _e1680 = select(_e845, _e829, (_e829 > _e845));
let _e1682 = select(_e1614.member, _e839, (_e839 < _e1614.member));
let _e1683 = (_e1682 > _e1680);
let _e1684 = select(_e845, _e1680, _e1683);
let _e1686 = (select(_e845, _e1682, _e1683) - _e1684);
if _e852 {
phi_4076_ = _e1686;
} else {
let _e1688 = (_e1686 / f32(_e851));
phi_3363_ = 0u;
phi_3366_ = 0f;
loop {
let _e1690 = phi_3363_;
let _e1692 = phi_3366_;
local_76 = _e1692;
let _e1695 = ((_e1690 < _e851) && (_e1686 > 0f));
if _e1695 {
let _e1698 = (_e1684 + (_e1688 * f32(_e1690)));
let _e1699 = (_e1698 + _e1688);
let _e1701 = (0.5f * (_e1698 + _e1699));
let _e1702 = (_e1699 - _e1698);
let _e1703 = (0.28867513f * _e1702);
let _e1704 = (_e1701 - _e1703);
let _e1714 = global_1.member.member_13.member_7;
let _e1715 = bitcast<i32>(_e1714);
let _e1719 = global_1.member.member_13.member_8;
let _e1720 = bitcast<i32>(_e1719);
let _e1724 = global_1.member.member_13.member_9;
let _e1725 = bitcast<i32>(_e1724);
let _e1726 = f32(_e1715);
let _e1728 = (_e804.member - _e797.member);
let _e1731 = (((((_e762 + (_e511 * _e1704)) - _e797.member) / _e1728) * _e1726) - 0.5f);
let _e1732 = (_e1726 - 1f);
let _e1734 = select(0f, _e1731, (_e1731 > 0f));
let _e1736 = select(_e1732, _e1734, (_e1734 < _e1732));
let _e1737 = f32(_e1720);
let _e1739 = (_e804.member_1 - _e797.member_1);
let _e1742 = (((((_e763 + (_e522 * _e1704)) - _e797.member_1) / _e1739) * _e1737) - 0.5f);
let _e1743 = (_e1737 - 1f);
let _e1745 = select(0f, _e1742, (_e1742 > 0f));
let _e1747 = select(_e1743, _e1745, (_e1745 < _e1743));
let _e1748 = f32(_e1725);
let _e1750 = (_e804.member_2 - _e797.member_2);
let _e1753 = (((((_e764 + (_e533 * _e1704)) - _e797.member_2) / _e1750) * _e1748) - 0.5f);
let _e1754 = (_e1748 - 1f);
let _e1756 = select(0f, _e1753, (_e1753 > 0f));
let _e1758 = select(_e1754, _e1756, (_e1756 < _e1754));
let _e1760 = select(0f, _e1736, (_e1736 > 0f));
let _e1762 = select(1e6f, _e1760, (_e1760 < 1e6f));
let _e1769 = select(0i, select(select(i32(_e1762), i32(-2147483648), (_e1762 < -2147483600f)), 2147483647i, (_e1762 > 2147483500f)), (_e1762 == _e1762));
let _e1773 = (_e1769 - select(0i, 1i, (_e1762 < f32(_e1769))));
let _e1775 = select(0f, _e1747, (_e1747 > 0f));
let _e1777 = select(1e6f, _e1775, (_e1775 < 1e6f));
let _e1784 = select(0i, select(select(i32(_e1777), i32(-2147483648), (_e1777 < -2147483600f)), 2147483647i, (_e1777 > 2147483500f)), (_e1777 == _e1777));
let _e1788 = (_e1784 - select(0i, 1i, (_e1777 < f32(_e1784))));
let _e1790 = select(0f, _e1758, (_e1758 > 0f));
let _e1792 = select(1e6f, _e1790, (_e1790 < 1e6f));
let _e1799 = select(0i, select(select(i32(_e1792), i32(-2147483648), (_e1792 < -2147483600f)), 2147483647i, (_e1792 > 2147483500f)), (_e1792 == _e1792));
let _e1803 = (_e1799 - select(0i, 1i, (_e1792 < f32(_e1799))));
let _e1807 = (_e1747 - f32(_e1788));
let _e1809 = (_e1758 - f32(_e1803));
local_35 = (_e1736 - f32(_e1773));
let _e1810 = (_e1773 + 1i);
let _e1812 = select(_e1810, 0i, (_e1810 < 0i));
if (_e1812 >= _e1715) {
phi_3501_ = (_e1715 - 1i);
} else {
phi_3501_ = _e1812;
}
let _e1816 = phi_3501_;
local_36 = (_e1816 - _e1773);
let _e1818 = (_e1788 + 1i);
let _e1820 = select(_e1818, 0i, (_e1818 < 0i));
if (_e1820 >= _e1720) {
phi_3514_ = (_e1720 - 1i);
} else {
phi_3514_ = _e1820;
}
let _e1824 = phi_3514_;
let _e1826 = ((_e1824 - _e1788) * _e1715);
let _e1827 = (_e1803 + 1i);
let _e1829 = select(_e1827, 0i, (_e1827 < 0i));
if (_e1829 >= _e1725) {
phi_3528_ = (_e1725 - 1i);
} else {
phi_3528_ = _e1829;
}
let _e1833 = phi_3528_;
let _e1840 = global_1.member.member_13.member_10;
let _e1841 = bitcast<i32>(_e1840);
let _e1846 = ((_e1841 + (((_e1803 * _e1720) + _e1788) * _e1715)) + _e1773);
let _e1848 = (bitcast<i32>(_e186) - 1i);
let _e1850 = select(_e1848, _e1846, (_e1846 < _e1848));
let _e1855 = global_7.member[bitcast<u32>(select(0i, _e1850, (_e1850 > 0i)))];
let _e1856 = local_35;
let _e1859 = local_36;
let _e1860 = (_e1846 + _e1859);
let _e1862 = select(_e1848, _e1860, (_e1860 < _e1848));
let _e1867 = global_7.member[bitcast<u32>(select(0i, _e1862, (_e1862 > 0i)))];
let _e1868 = local_35;
let _e1871 = (1f - _e1807);
let _e1873 = (_e1846 + _e1826);
let _e1875 = select(_e1848, _e1873, (_e1873 < _e1848));
let _e1880 = global_7.member[bitcast<u32>(select(0i, _e1875, (_e1875 > 0i)))];
let _e1881 = local_35;
let _e1884 = local_36;
let _e1885 = (_e1873 + _e1884);
let _e1887 = select(_e1848, _e1885, (_e1885 < _e1848));
let _e1892 = global_7.member[bitcast<u32>(select(0i, _e1887, (_e1887 > 0i)))];
let _e1893 = local_35;
let _e1898 = (_e1846 + (((_e1833 - _e1803) * _e1715) * _e1720));
let _e1900 = select(_e1848, _e1898, (_e1898 < _e1848));
let _e1905 = global_7.member[bitcast<u32>(select(0i, _e1900, (_e1900 > 0i)))];
let _e1906 = local_35;
let _e1909 = local_36;
let _e1910 = (_e1898 + _e1909);
let _e1912 = select(_e1848, _e1910, (_e1910 < _e1848));
let _e1917 = global_7.member[bitcast<u32>(select(0i, _e1912, (_e1912 > 0i)))];
let _e1918 = local_35;
let _e1922 = (_e1898 + _e1826);
let _e1924 = select(_e1848, _e1922, (_e1922 < _e1848));
let _e1929 = global_7.member[bitcast<u32>(select(0i, _e1924, (_e1924 > 0i)))];
let _e1930 = local_35;
let _e1933 = local_36;
let _e1934 = (_e1922 + _e1933);
let _e1936 = select(_e1848, _e1934, (_e1934 < _e1848));
let _e1941 = global_7.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1942 = local_35;
let _e1951 = (_e1701 + _e1703);
let _e1961 = (((((_e762 + (_e511 * _e1951)) - _e797.member) / _e1728) * _e1726) - 0.5f);
let _e1963 = select(0f, _e1961, (_e1961 > 0f));
let _e1965 = select(_e1732, _e1963, (_e1963 < _e1732));
let _e1969 = (((((_e763 + (_e522 * _e1951)) - _e797.member_1) / _e1739) * _e1737) - 0.5f);
let _e1971 = select(0f, _e1969, (_e1969 > 0f));
let _e1973 = select(_e1743, _e1971, (_e1971 < _e1743));
let _e1977 = (((((_e764 + (_e533 * _e1951)) - _e797.member_2) / _e1750) * _e1748) - 0.5f);
let _e1979 = select(0f, _e1977, (_e1977 > 0f));
let _e1981 = select(_e1754, _e1979, (_e1979 < _e1754));
let _e1983 = select(0f, _e1965, (_e1965 > 0f));
let _e1985 = select(1e6f, _e1983, (_e1983 < 1e6f));
let _e1992 = select(0i, select(select(i32(_e1985), i32(-2147483648), (_e1985 < -2147483600f)), 2147483647i, (_e1985 > 2147483500f)), (_e1985 == _e1985));
let _e1996 = (_e1992 - select(0i, 1i, (_e1985 < f32(_e1992))));
let _e1998 = select(0f, _e1973, (_e1973 > 0f));
let _e2000 = select(1e6f, _e1998, (_e1998 < 1e6f));
let _e2007 = select(0i, select(select(i32(_e2000), i32(-2147483648), (_e2000 < -2147483600f)), 2147483647i, (_e2000 > 2147483500f)), (_e2000 == _e2000));
let _e2011 = (_e2007 - select(0i, 1i, (_e2000 < f32(_e2007))));
let _e2013 = select(0f, _e1981, (_e1981 > 0f));
let _e2015 = select(1e6f, _e2013, (_e2013 < 1e6f));
let _e2022 = select(0i, select(select(i32(_e2015), i32(-2147483648), (_e2015 < -2147483600f)), 2147483647i, (_e2015 > 2147483500f)), (_e2015 == _e2015));
let _e2026 = (_e2022 - select(0i, 1i, (_e2015 < f32(_e2022))));
let _e2030 = (_e1973 - f32(_e2011));
let _e2032 = (_e1981 - f32(_e2026));
local_33 = (_e1965 - f32(_e1996));
let _e2033 = (_e1996 + 1i);
let _e2035 = select(_e2033, 0i, (_e2033 < 0i));
if (_e2035 >= _e1715) {
phi_3844_ = (_e1715 - 1i);
} else {
phi_3844_ = _e2035;
}
let _e2039 = phi_3844_;
local_34 = (_e2039 - _e1996);
let _e2041 = (_e2011 + 1i);
let _e2043 = select(_e2041, 0i, (_e2041 < 0i));
if (_e2043 >= _e1720) {
phi_3857_ = (_e1720 - 1i);
} else {
phi_3857_ = _e2043;
}
let _e2047 = phi_3857_;
let _e2049 = ((_e2047 - _e2011) * _e1715);
let _e2050 = (_e2026 + 1i);
let _e2052 = select(_e2050, 0i, (_e2050 < 0i));
if (_e2052 >= _e1725) {
phi_3871_ = (_e1725 - 1i);
} else {
phi_3871_ = _e2052;
}
let _e2056 = phi_3871_;
let _e2064 = ((_e1841 + (((_e2026 * _e1720) + _e2011) * _e1715)) + _e1996);
let _e2066 = select(_e1848, _e2064, (_e2064 < _e1848));
let _e2071 = global_7.member[bitcast<u32>(select(0i, _e2066, (_e2066 > 0i)))];
let _e2072 = local_33;
let _e2075 = local_34;
let _e2076 = (_e2064 + _e2075);
let _e2078 = select(_e1848, _e2076, (_e2076 < _e1848));
let _e2083 = global_7.member[bitcast<u32>(select(0i, _e2078, (_e2078 > 0i)))];
let _e2084 = local_33;
let _e2087 = (1f - _e2030);
let _e2089 = (_e2064 + _e2049);
let _e2091 = select(_e1848, _e2089, (_e2089 < _e1848));
let _e2096 = global_7.member[bitcast<u32>(select(0i, _e2091, (_e2091 > 0i)))];
let _e2097 = local_33;
let _e2100 = local_34;
let _e2101 = (_e2089 + _e2100);
let _e2103 = select(_e1848, _e2101, (_e2101 < _e1848));
let _e2108 = global_7.member[bitcast<u32>(select(0i, _e2103, (_e2103 > 0i)))];
let _e2109 = local_33;
let _e2114 = (_e2064 + (((_e2056 - _e2026) * _e1715) * _e1720));
let _e2116 = select(_e1848, _e2114, (_e2114 < _e1848));
let _e2121 = global_7.member[bitcast<u32>(select(0i, _e2116, (_e2116 > 0i)))];
let _e2122 = local_33;
let _e2125 = local_34;
let _e2126 = (_e2114 + _e2125);
let _e2128 = select(_e1848, _e2126, (_e2126 < _e1848));
let _e2133 = global_7.member[bitcast<u32>(select(0i, _e2128, (_e2128 > 0i)))];
let _e2134 = local_33;
let _e2138 = (_e2114 + _e2049);
let _e2140 = select(_e1848, _e2138, (_e2138 < _e1848));
let _e2145 = global_7.member[bitcast<u32>(select(0i, _e2140, (_e2140 > 0i)))];
let _e2146 = local_33;
let _e2149 = local_34;
let _e2150 = (_e2138 + _e2149);
let _e2152 = select(_e1848, _e2150, (_e2150 < _e1848));
let _e2157 = global_7.member[bitcast<u32>(select(0i, _e2152, (_e2152 > 0i)))];
let _e2158 = local_33;
phi_3364_ = (_e1690 + 1u);
phi_3367_ = (_e1692 + ((0.5f * (((((((_e1855 * (1f - _e1856)) + (_e1867 * _e1868)) * _e1871) + (((_e1880 * (1f - _e1881)) + (_e1892 * _e1893)) * _e1807)) * (1f - _e1809)) + (((((_e1905 * (1f - _e1906)) + (_e1917 * _e1918)) * _e1871) + (((_e1929 * (1f - _e1930)) + (_e1941 * _e1942)) * _e1807)) * _e1809)) + ((((((_e2071 * (1f - _e2072)) + (_e2083 * _e2084)) * _e2087) + (((_e2096 * (1f - _e2097)) + (_e2108 * _e2109)) * _e2030)) * (1f - _e2032)) + (((((_e2121 * (1f - _e2122)) + (_e2133 * _e2134)) * _e2087) + (((_e2145 * (1f - _e2146)) + (_e2157 * _e2158)) * _e2030)) * _e2032)))) * _e1702));
} else {
phi_3364_ = u32();
phi_3367_ = f32();
}
let _e2173 = phi_3364_;
let _e2175 = phi_3367_;
continue;
continuing {
phi_3363_ = _e2173;
phi_3366_ = _e2175;
break if !(_e1695);
}
}
let _e10887 = local_76;
phi_4076_ = _e10887;
}
let _e2178 = phi_4076_;
phi_4078_ = _e2178;
phi_4081_ = vec3<f32>(0f, 0f, 0f);
phi_4083_ = 0i;
loop {
let _e2180 = phi_4078_;
let _e2182 = phi_4081_;
let _e2184 = phi_4083_;
local_81 = _e2182;
let _e2185 = (_e2184 < _e1674);
if _e2185 {
let _e2190 = (_e1659 + (_e1678 * ((2f * f32(_e2184)) + 1f)));
let _e2191 = -(0.8611363f);
let _e2193 = (_e2190 + (_e1678 * _e2191));
let _e2194 = (_e2193 * _e2193);
let _e2195 = (1f - _e2194);
let _e2197 = select(1e-9f, _e2195, (_e2195 > 1e-9f));
let _e2207 = select((_e1632 + (_e1648 * ((2f * _e2193) / _e2197))), _e2193, _e1649);
let _e2208 = select((_e1648 * ((2f * (1f + _e2194)) / (_e2197 * _e2197))), 1f, _e1649);
let _e2209 = (_e511 * _e2207);
let _e2210 = (_e522 * _e2207);
let _e2211 = (_e533 * _e2207);
let _e2216 = (_e765 + vec3<f32>(_e2209, _e2210, _e2211));
let _e2219 = global_1.member.member_13.member_6;
let _e2220 = (_e2219 == 0u);
if _e2220 {
phi_4484_ = 1f;
} else {
let _e2223 = global_1.member.member_13.member_7;
let _e2224 = bitcast<i32>(_e2223);
let _e2227 = global_1.member.member_13.member_8;
let _e2228 = bitcast<i32>(_e2227);
let _e2231 = global_1.member.member_13.member_9;
let _e2232 = bitcast<i32>(_e2231);
let _e2235 = global_1.member.member_13.member_4;
let _e2241 = global_1.member.member_13.member_5;
let _e2245 = f32(_e2224);
let _e2250 = (((((_e762 + _e2209) - _e2235.member) / (_e2241.member - _e2235.member)) * _e2245) - 0.5f);
let _e2251 = (_e2245 - 1f);
let _e2253 = select(0f, _e2250, (_e2250 > 0f));
let _e2255 = select(_e2251, _e2253, (_e2253 < _e2251));
let _e2256 = f32(_e2228);
let _e2261 = (((((_e763 + _e2210) - _e2235.member_1) / (_e2241.member_1 - _e2235.member_1)) * _e2256) - 0.5f);
let _e2262 = (_e2256 - 1f);
let _e2264 = select(0f, _e2261, (_e2261 > 0f));
let _e2266 = select(_e2262, _e2264, (_e2264 < _e2262));
let _e2267 = f32(_e2232);
let _e2272 = (((((_e764 + _e2211) - _e2235.member_2) / (_e2241.member_2 - _e2235.member_2)) * _e2267) - 0.5f);
let _e2273 = (_e2267 - 1f);
let _e2275 = select(0f, _e2272, (_e2272 > 0f));
let _e2277 = select(_e2273, _e2275, (_e2275 < _e2273));
let _e2279 = select(0f, _e2255, (_e2255 > 0f));
let _e2281 = select(1e6f, _e2279, (_e2279 < 1e6f));
let _e2288 = select(0i, select(select(i32(_e2281), i32(-2147483648), (_e2281 < -2147483600f)), 2147483647i, (_e2281 > 2147483500f)), (_e2281 == _e2281));
let _e2292 = (_e2288 - select(0i, 1i, (_e2281 < f32(_e2288))));
let _e2294 = select(0f, _e2266, (_e2266 > 0f));
let _e2296 = select(1e6f, _e2294, (_e2294 < 1e6f));
let _e2303 = select(0i, select(select(i32(_e2296), i32(-2147483648), (_e2296 < -2147483600f)), 2147483647i, (_e2296 > 2147483500f)), (_e2296 == _e2296));
let _e2307 = (_e2303 - select(0i, 1i, (_e2296 < f32(_e2303))));
let _e2309 = select(0f, _e2277, (_e2277 > 0f));
let _e2311 = select(1e6f, _e2309, (_e2309 < 1e6f));
let _e2318 = select(0i, select(select(i32(_e2311), i32(-2147483648), (_e2311 < -2147483600f)), 2147483647i, (_e2311 > 2147483500f)), (_e2311 == _e2311));
let _e2322 = (_e2318 - select(0i, 1i, (_e2311 < f32(_e2318))));
let _e2326 = (_e2266 - f32(_e2307));
let _e2328 = (_e2277 - f32(_e2322));
local_31 = (_e2255 - f32(_e2292));
let _e2329 = (_e2292 + 1i);
let _e2331 = select(_e2329, 0i, (_e2329 < 0i));
if (_e2331 >= _e2224) {
phi_4257_ = (_e2224 - 1i);
} else {
phi_4257_ = _e2331;
}
let _e2335 = phi_4257_;
local_32 = (_e2335 - _e2292);
let _e2337 = (_e2307 + 1i);
let _e2339 = select(_e2337, 0i, (_e2337 < 0i));
if (_e2339 >= _e2228) {
phi_4270_ = (_e2228 - 1i);
} else {
phi_4270_ = _e2339;
}
let _e2343 = phi_4270_;
let _e2345 = ((_e2343 - _e2307) * _e2224);
let _e2346 = (_e2322 + 1i);
let _e2348 = select(_e2346, 0i, (_e2346 < 0i));
if (_e2348 >= _e2232) {
phi_4284_ = (_e2232 - 1i);
} else {
phi_4284_ = _e2348;
}
let _e2352 = phi_4284_;
let _e2358 = global_1.member.member_13.member_10;
let _e2364 = ((bitcast<i32>(_e2358) + (((_e2322 * _e2228) + _e2307) * _e2224)) + _e2292);
let _e2366 = (bitcast<i32>(_e186) - 1i);
let _e2368 = select(_e2366, _e2364, (_e2364 < _e2366));
let _e2373 = global_7.member[bitcast<u32>(select(0i, _e2368, (_e2368 > 0i)))];
let _e2374 = local_31;
let _e2377 = local_32;
let _e2378 = (_e2364 + _e2377);
let _e2380 = select(_e2366, _e2378, (_e2378 < _e2366));
let _e2385 = global_7.member[bitcast<u32>(select(0i, _e2380, (_e2380 > 0i)))];
let _e2386 = local_31;
let _e2389 = (1f - _e2326);
let _e2391 = (_e2364 + _e2345);
let _e2393 = select(_e2366, _e2391, (_e2391 < _e2366));
let _e2398 = global_7.member[bitcast<u32>(select(0i, _e2393, (_e2393 > 0i)))];
let _e2399 = local_31;
let _e2402 = local_32;
let _e2403 = (_e2391 + _e2402);
let _e2405 = select(_e2366, _e2403, (_e2403 < _e2366));
let _e2410 = global_7.member[bitcast<u32>(select(0i, _e2405, (_e2405 > 0i)))];
let _e2411 = local_31;
let _e2416 = (_e2364 + (((_e2352 - _e2322) * _e2224) * _e2228));
let _e2418 = select(_e2366, _e2416, (_e2416 < _e2366));
let _e2423 = global_7.member[bitcast<u32>(select(0i, _e2418, (_e2418 > 0i)))];
let _e2424 = local_31;
let _e2427 = local_32;
let _e2428 = (_e2416 + _e2427);
let _e2430 = select(_e2366, _e2428, (_e2428 < _e2366));
let _e2435 = global_7.member[bitcast<u32>(select(0i, _e2430, (_e2430 > 0i)))];
let _e2436 = local_31;
let _e2440 = (_e2416 + _e2345);
let _e2442 = select(_e2366, _e2440, (_e2440 < _e2366));
let _e2447 = global_7.member[bitcast<u32>(select(0i, _e2442, (_e2442 > 0i)))];
let _e2448 = local_31;
let _e2451 = local_32;
let _e2452 = (_e2440 + _e2451);
let _e2454 = select(_e2366, _e2452, (_e2452 < _e2366));
let _e2459 = global_7.member[bitcast<u32>(select(0i, _e2454, (_e2454 > 0i)))];
let _e2460 = local_31;
phi_4484_ = ((((((_e2373 * (1f - _e2374)) + (_e2385 * _e2386)) * _e2389) + (((_e2398 * (1f - _e2399)) + (_e2410 * _e2411)) * _e2326)) * (1f - _e2328)) + (((((_e2423 * (1f - _e2424)) + (_e2435 * _e2436)) * _e2389) + (((_e2447 * (1f - _e2448)) + (_e2459 * _e2460)) * _e2326)) * _e2328));
}
let _e2470 = phi_4484_;
let _e2471 = -(0.33998105f);
let _e2473 = (_e2190 + (_e1678 * _e2471));
let _e2474 = (_e2473 * _e2473);
let _e2475 = (1f - _e2474);
let _e2477 = select(1e-9f, _e2475, (_e2475 > 1e-9f));
let _e2487 = select((_e1632 + (_e1648 * ((2f * _e2473) / _e2477))), _e2473, _e1649);
let _e2488 = select((_e1648 * ((2f * (1f + _e2474)) / (_e2477 * _e2477))), 1f, _e1649);
let _e2489 = (_e511 * _e2487);
let _e2490 = (_e522 * _e2487);
let _e2491 = (_e533 * _e2487);
let _e2496 = (_e765 + vec3<f32>(_e2489, _e2490, _e2491));
if _e2220 {
phi_4874_ = 1f;
} else {
let _e2499 = global_1.member.member_13.member_7;
let _e2500 = bitcast<i32>(_e2499);
let _e2503 = global_1.member.member_13.member_8;
let _e2504 = bitcast<i32>(_e2503);
let _e2507 = global_1.member.member_13.member_9;
let _e2508 = bitcast<i32>(_e2507);
let _e2511 = global_1.member.member_13.member_4;
let _e2517 = global_1.member.member_13.member_5;
let _e2521 = f32(_e2500);
let _e2526 = (((((_e762 + _e2489) - _e2511.member) / (_e2517.member - _e2511.member)) * _e2521) - 0.5f);
let _e2527 = (_e2521 - 1f);
let _e2529 = select(0f, _e2526, (_e2526 > 0f));
let _e2531 = select(_e2527, _e2529, (_e2529 < _e2527));
let _e2532 = f32(_e2504);
let _e2537 = (((((_e763 + _e2490) - _e2511.member_1) / (_e2517.member_1 - _e2511.member_1)) * _e2532) - 0.5f);
let _e2538 = (_e2532 - 1f);
let _e2540 = select(0f, _e2537, (_e2537 > 0f));
let _e2542 = select(_e2538, _e2540, (_e2540 < _e2538));
let _e2543 = f32(_e2508);
let _e2548 = (((((_e764 + _e2491) - _e2511.member_2) / (_e2517.member_2 - _e2511.member_2)) * _e2543) - 0.5f);
let _e2549 = (_e2543 - 1f);
let _e2551 = select(0f, _e2548, (_e2548 > 0f));
let _e2553 = select(_e2549, _e2551, (_e2551 < _e2549));
let _e2555 = select(0f, _e2531, (_e2531 > 0f));
let _e2557 = select(1e6f, _e2555, (_e2555 < 1e6f));
let _e2564 = select(0i, select(select(i32(_e2557), i32(-2147483648), (_e2557 < -2147483600f)), 2147483647i, (_e2557 > 2147483500f)), (_e2557 == _e2557));
let _e2568 = (_e2564 - select(0i, 1i, (_e2557 < f32(_e2564))));
let _e2570 = select(0f, _e2542, (_e2542 > 0f));
let _e2572 = select(1e6f, _e2570, (_e2570 < 1e6f));
let _e2579 = select(0i, select(select(i32(_e2572), i32(-2147483648), (_e2572 < -2147483600f)), 2147483647i, (_e2572 > 2147483500f)), (_e2572 == _e2572));
let _e2583 = (_e2579 - select(0i, 1i, (_e2572 < f32(_e2579))));
let _e2585 = select(0f, _e2553, (_e2553 > 0f));
let _e2587 = select(1e6f, _e2585, (_e2585 < 1e6f));
let _e2594 = select(0i, select(select(i32(_e2587), i32(-2147483648), (_e2587 < -2147483600f)), 2147483647i, (_e2587 > 2147483500f)), (_e2587 == _e2587));
let _e2598 = (_e2594 - select(0i, 1i, (_e2587 < f32(_e2594))));
let _e2602 = (_e2542 - f32(_e2583));
let _e2604 = (_e2553 - f32(_e2598));
local_29 = (_e2531 - f32(_e2568));
let _e2605 = (_e2568 + 1i);
let _e2607 = select(_e2605, 0i, (_e2605 < 0i));
if (_e2607 >= _e2500) {
phi_4647_ = (_e2500 - 1i);
} else {
phi_4647_ = _e2607;
}
let _e2611 = phi_4647_;
local_30 = (_e2611 - _e2568);
let _e2613 = (_e2583 + 1i);
let _e2615 = select(_e2613, 0i, (_e2613 < 0i));
if (_e2615 >= _e2504) {
phi_4660_ = (_e2504 - 1i);
} else {
phi_4660_ = _e2615;
}
let _e2619 = phi_4660_;
let _e2621 = ((_e2619 - _e2583) * _e2500);
let _e2622 = (_e2598 + 1i);
let _e2624 = select(_e2622, 0i, (_e2622 < 0i));
if (_e2624 >= _e2508) {
phi_4674_ = (_e2508 - 1i);
} else {
phi_4674_ = _e2624;
}
let _e2628 = phi_4674_;
let _e2634 = global_1.member.member_13.member_10;
let _e2640 = ((bitcast<i32>(_e2634) + (((_e2598 * _e2504) + _e2583) * _e2500)) + _e2568);
let _e2642 = (bitcast<i32>(_e186) - 1i);
let _e2644 = select(_e2642, _e2640, (_e2640 < _e2642));
let _e2649 = global_7.member[bitcast<u32>(select(0i, _e2644, (_e2644 > 0i)))];
let _e2650 = local_29;
let _e2653 = local_30;
let _e2654 = (_e2640 + _e2653);
let _e2656 = select(_e2642, _e2654, (_e2654 < _e2642));
let _e2661 = global_7.member[bitcast<u32>(select(0i, _e2656, (_e2656 > 0i)))];
let _e2662 = local_29;
let _e2665 = (1f - _e2602);
let _e2667 = (_e2640 + _e2621);
let _e2669 = select(_e2642, _e2667, (_e2667 < _e2642));
let _e2674 = global_7.member[bitcast<u32>(select(0i, _e2669, (_e2669 > 0i)))];
let _e2675 = local_29;
let _e2678 = local_30;
let _e2679 = (_e2667 + _e2678);
let _e2681 = select(_e2642, _e2679, (_e2679 < _e2642));
let _e2686 = global_7.member[bitcast<u32>(select(0i, _e2681, (_e2681 > 0i)))];
let _e2687 = local_29;
let _e2692 = (_e2640 + (((_e2628 - _e2598) * _e2500) * _e2504));
let _e2694 = select(_e2642, _e2692, (_e2692 < _e2642));
let _e2699 = global_7.member[bitcast<u32>(select(0i, _e2694, (_e2694 > 0i)))];
let _e2700 = local_29;
let _e2703 = local_30;
let _e2704 = (_e2692 + _e2703);
let _e2706 = select(_e2642, _e2704, (_e2704 < _e2642));
let _e2711 = global_7.member[bitcast<u32>(select(0i, _e2706, (_e2706 > 0i)))];
let _e2712 = local_29;
let _e2716 = (_e2692 + _e2621);
let _e2718 = select(_e2642, _e2716, (_e2716 < _e2642));
let _e2723 = global_7.member[bitcast<u32>(select(0i, _e2718, (_e2718 > 0i)))];
let _e2724 = local_29;
let _e2727 = local_30;
let _e2728 = (_e2716 + _e2727);
let _e2730 = select(_e2642, _e2728, (_e2728 < _e2642));
let _e2735 = global_7.member[bitcast<u32>(select(0i, _e2730, (_e2730 > 0i)))];
let _e2736 = local_29;
phi_4874_ = ((((((_e2649 * (1f - _e2650)) + (_e2661 * _e2662)) * _e2665) + (((_e2674 * (1f - _e2675)) + (_e2686 * _e2687)) * _e2602)) * (1f - _e2604)) + (((((_e2699 * (1f - _e2700)) + (_e2711 * _e2712)) * _e2665) + (((_e2723 * (1f - _e2724)) + (_e2735 * _e2736)) * _e2602)) * _e2604));
}
let _e2746 = phi_4874_;
let _e2748 = (_e2190 + (_e1678 * 0.33998105f));
let _e2749 = (_e2748 * _e2748);
let _e2750 = (1f - _e2749);
let _e2752 = select(1e-9f, _e2750, (_e2750 > 1e-9f));
let _e2762 = select((_e1632 + (_e1648 * ((2f * _e2748) / _e2752))), _e2748, _e1649);
let _e2763 = select((_e1648 * ((2f * (1f + _e2749)) / (_e2752 * _e2752))), 1f, _e1649);
let _e2764 = (_e511 * _e2762);
let _e2765 = (_e522 * _e2762);
let _e2766 = (_e533 * _e2762);
let _e2771 = (_e765 + vec3<f32>(_e2764, _e2765, _e2766));
if _e2220 {
phi_5263_ = 1f;
} else {
let _e2774 = global_1.member.member_13.member_7;
let _e2775 = bitcast<i32>(_e2774);
let _e2778 = global_1.member.member_13.member_8;
let _e2779 = bitcast<i32>(_e2778);
let _e2782 = global_1.member.member_13.member_9;
let _e2783 = bitcast<i32>(_e2782);
let _e2786 = global_1.member.member_13.member_4;
let _e2792 = global_1.member.member_13.member_5;
let _e2796 = f32(_e2775);
let _e2801 = (((((_e762 + _e2764) - _e2786.member) / (_e2792.member - _e2786.member)) * _e2796) - 0.5f);
let _e2802 = (_e2796 - 1f);
let _e2804 = select(0f, _e2801, (_e2801 > 0f));
let _e2806 = select(_e2802, _e2804, (_e2804 < _e2802));
let _e2807 = f32(_e2779);
let _e2812 = (((((_e763 + _e2765) - _e2786.member_1) / (_e2792.member_1 - _e2786.member_1)) * _e2807) - 0.5f);
let _e2813 = (_e2807 - 1f);
let _e2815 = select(0f, _e2812, (_e2812 > 0f));
let _e2817 = select(_e2813, _e2815, (_e2815 < _e2813));
let _e2818 = f32(_e2783);
let _e2823 = (((((_e764 + _e2766) - _e2786.member_2) / (_e2792.member_2 - _e2786.member_2)) * _e2818) - 0.5f);
let _e2824 = (_e2818 - 1f);
let _e2826 = select(0f, _e2823, (_e2823 > 0f));
let _e2828 = select(_e2824, _e2826, (_e2826 < _e2824));
let _e2830 = select(0f, _e2806, (_e2806 > 0f));
let _e2832 = select(1e6f, _e2830, (_e2830 < 1e6f));
let _e2839 = select(0i, select(select(i32(_e2832), i32(-2147483648), (_e2832 < -2147483600f)), 2147483647i, (_e2832 > 2147483500f)), (_e2832 == _e2832));
let _e2843 = (_e2839 - select(0i, 1i, (_e2832 < f32(_e2839))));
let _e2845 = select(0f, _e2817, (_e2817 > 0f));
let _e2847 = select(1e6f, _e2845, (_e2845 < 1e6f));
let _e2854 = select(0i, select(select(i32(_e2847), i32(-2147483648), (_e2847 < -2147483600f)), 2147483647i, (_e2847 > 2147483500f)), (_e2847 == _e2847));
let _e2858 = (_e2854 - select(0i, 1i, (_e2847 < f32(_e2854))));
let _e2860 = select(0f, _e2828, (_e2828 > 0f));
let _e2862 = select(1e6f, _e2860, (_e2860 < 1e6f));
let _e2869 = select(0i, select(select(i32(_e2862), i32(-2147483648), (_e2862 < -2147483600f)), 2147483647i, (_e2862 > 2147483500f)), (_e2862 == _e2862));
let _e2873 = (_e2869 - select(0i, 1i, (_e2862 < f32(_e2869))));
let _e2877 = (_e2817 - f32(_e2858));
let _e2879 = (_e2828 - f32(_e2873));
local_27 = (_e2806 - f32(_e2843));
let _e2880 = (_e2843 + 1i);
let _e2882 = select(_e2880, 0i, (_e2880 < 0i));
if (_e2882 >= _e2775) {
phi_5036_ = (_e2775 - 1i);
} else {
phi_5036_ = _e2882;
}
let _e2886 = phi_5036_;
local_28 = (_e2886 - _e2843);
let _e2888 = (_e2858 + 1i);
let _e2890 = select(_e2888, 0i, (_e2888 < 0i));
if (_e2890 >= _e2779) {
phi_5049_ = (_e2779 - 1i);
} else {
phi_5049_ = _e2890;
}
let _e2894 = phi_5049_;
let _e2896 = ((_e2894 - _e2858) * _e2775);
let _e2897 = (_e2873 + 1i);
let _e2899 = select(_e2897, 0i, (_e2897 < 0i));
if (_e2899 >= _e2783) {
phi_5063_ = (_e2783 - 1i);
} else {
phi_5063_ = _e2899;
}
let _e2903 = phi_5063_;
let _e2909 = global_1.member.member_13.member_10;
let _e2915 = ((bitcast<i32>(_e2909) + (((_e2873 * _e2779) + _e2858) * _e2775)) + _e2843);
let _e2917 = (bitcast<i32>(_e186) - 1i);
let _e2919 = select(_e2917, _e2915, (_e2915 < _e2917));
let _e2924 = global_7.member[bitcast<u32>(select(0i, _e2919, (_e2919 > 0i)))];
let _e2925 = local_27;
let _e2928 = local_28;
let _e2929 = (_e2915 + _e2928);
let _e2931 = select(_e2917, _e2929, (_e2929 < _e2917));
let _e2936 = global_7.member[bitcast<u32>(select(0i, _e2931, (_e2931 > 0i)))];
let _e2937 = local_27;
let _e2940 = (1f - _e2877);
let _e2942 = (_e2915 + _e2896);
let _e2944 = select(_e2917, _e2942, (_e2942 < _e2917));
let _e2949 = global_7.member[bitcast<u32>(select(0i, _e2944, (_e2944 > 0i)))];
let _e2950 = local_27;
let _e2953 = local_28;
let _e2954 = (_e2942 + _e2953);
let _e2956 = select(_e2917, _e2954, (_e2954 < _e2917));
let _e2961 = global_7.member[bitcast<u32>(select(0i, _e2956, (_e2956 > 0i)))];
let _e2962 = local_27;
let _e2967 = (_e2915 + (((_e2903 - _e2873) * _e2775) * _e2779));
let _e2969 = select(_e2917, _e2967, (_e2967 < _e2917));
let _e2974 = global_7.member[bitcast<u32>(select(0i, _e2969, (_e2969 > 0i)))];
let _e2975 = local_27;
let _e2978 = local_28;
let _e2979 = (_e2967 + _e2978);
let _e2981 = select(_e2917, _e2979, (_e2979 < _e2917));
let _e2986 = global_7.member[bitcast<u32>(select(0i, _e2981, (_e2981 > 0i)))];
let _e2987 = local_27;
let _e2991 = (_e2967 + _e2896);
let _e2993 = select(_e2917, _e2991, (_e2991 < _e2917));
let _e2998 = global_7.member[bitcast<u32>(select(0i, _e2993, (_e2993 > 0i)))];
let _e2999 = local_27;
let _e3002 = local_28;
let _e3003 = (_e2991 + _e3002);
let _e3005 = select(_e2917, _e3003, (_e3003 < _e2917));
let _e3010 = global_7.member[bitcast<u32>(select(0i, _e3005, (_e3005 > 0i)))];
let _e3011 = local_27;
phi_5263_ = ((((((_e2924 * (1f - _e2925)) + (_e2936 * _e2937)) * _e2940) + (((_e2949 * (1f - _e2950)) + (_e2961 * _e2962)) * _e2877)) * (1f - _e2879)) + (((((_e2974 * (1f - _e2975)) + (_e2986 * _e2987)) * _e2940) + (((_e2998 * (1f - _e2999)) + (_e3010 * _e3011)) * _e2877)) * _e2879));
}
let _e3021 = phi_5263_;
let _e3023 = (_e2190 + (_e1678 * 0.8611363f));
let _e3024 = (_e3023 * _e3023);
let _e3025 = (1f - _e3024);
let _e3027 = select(1e-9f, _e3025, (_e3025 > 1e-9f));
let _e3037 = select((_e1632 + (_e1648 * ((2f * _e3023) / _e3027))), _e3023, _e1649);
let _e3038 = select((_e1648 * ((2f * (1f + _e3024)) / (_e3027 * _e3027))), 1f, _e1649);
let _e3039 = (_e511 * _e3037);
let _e3040 = (_e522 * _e3037);
let _e3041 = (_e533 * _e3037);
let _e3046 = (_e765 + vec3<f32>(_e3039, _e3040, _e3041));
if _e2220 {
phi_5652_ = 1f;
} else {
let _e3049 = global_1.member.member_13.member_7;
let _e3050 = bitcast<i32>(_e3049);
let _e3053 = global_1.member.member_13.member_8;
let _e3054 = bitcast<i32>(_e3053);
let _e3057 = global_1.member.member_13.member_9;
let _e3058 = bitcast<i32>(_e3057);
let _e3061 = global_1.member.member_13.member_4;
let _e3067 = global_1.member.member_13.member_5;
let _e3071 = f32(_e3050);
let _e3076 = (((((_e762 + _e3039) - _e3061.member) / (_e3067.member - _e3061.member)) * _e3071) - 0.5f);
let _e3077 = (_e3071 - 1f);
let _e3079 = select(0f, _e3076, (_e3076 > 0f));
let _e3081 = select(_e3077, _e3079, (_e3079 < _e3077));
let _e3082 = f32(_e3054);
let _e3087 = (((((_e763 + _e3040) - _e3061.member_1) / (_e3067.member_1 - _e3061.member_1)) * _e3082) - 0.5f);
let _e3088 = (_e3082 - 1f);
let _e3090 = select(0f, _e3087, (_e3087 > 0f));
let _e3092 = select(_e3088, _e3090, (_e3090 < _e3088));
let _e3093 = f32(_e3058);
let _e3098 = (((((_e764 + _e3041) - _e3061.member_2) / (_e3067.member_2 - _e3061.member_2)) * _e3093) - 0.5f);
let _e3099 = (_e3093 - 1f);
let _e3101 = select(0f, _e3098, (_e3098 > 0f));
let _e3103 = select(_e3099, _e3101, (_e3101 < _e3099));
let _e3105 = select(0f, _e3081, (_e3081 > 0f));
let _e3107 = select(1e6f, _e3105, (_e3105 < 1e6f));
let _e3114 = select(0i, select(select(i32(_e3107), i32(-2147483648), (_e3107 < -2147483600f)), 2147483647i, (_e3107 > 2147483500f)), (_e3107 == _e3107));
let _e3118 = (_e3114 - select(0i, 1i, (_e3107 < f32(_e3114))));
let _e3120 = select(0f, _e3092, (_e3092 > 0f));
let _e3122 = select(1e6f, _e3120, (_e3120 < 1e6f));
let _e3129 = select(0i, select(select(i32(_e3122), i32(-2147483648), (_e3122 < -2147483600f)), 2147483647i, (_e3122 > 2147483500f)), (_e3122 == _e3122));
let _e3133 = (_e3129 - select(0i, 1i, (_e3122 < f32(_e3129))));
let _e3135 = select(0f, _e3103, (_e3103 > 0f));
let _e3137 = select(1e6f, _e3135, (_e3135 < 1e6f));
let _e3144 = select(0i, select(select(i32(_e3137), i32(-2147483648), (_e3137 < -2147483600f)), 2147483647i, (_e3137 > 2147483500f)), (_e3137 == _e3137));
let _e3148 = (_e3144 - select(0i, 1i, (_e3137 < f32(_e3144))));
let _e3152 = (_e3092 - f32(_e3133));
let _e3154 = (_e3103 - f32(_e3148));
local_25 = (_e3081 - f32(_e3118));
let _e3155 = (_e3118 + 1i);
let _e3157 = select(_e3155, 0i, (_e3155 < 0i));
if (_e3157 >= _e3050) {
phi_5425_ = (_e3050 - 1i);
} else {
phi_5425_ = _e3157;
}
let _e3161 = phi_5425_;
local_26 = (_e3161 - _e3118);
let _e3163 = (_e3133 + 1i);
let _e3165 = select(_e3163, 0i, (_e3163 < 0i));
if (_e3165 >= _e3054) {
phi_5438_ = (_e3054 - 1i);
} else {
phi_5438_ = _e3165;
}
let _e3169 = phi_5438_;
let _e3171 = ((_e3169 - _e3133) * _e3050);
let _e3172 = (_e3148 + 1i);
let _e3174 = select(_e3172, 0i, (_e3172 < 0i));
if (_e3174 >= _e3058) {
phi_5452_ = (_e3058 - 1i);
} else {
phi_5452_ = _e3174;
}
let _e3178 = phi_5452_;
let _e3184 = global_1.member.member_13.member_10;
let _e3190 = ((bitcast<i32>(_e3184) + (((_e3148 * _e3054) + _e3133) * _e3050)) + _e3118);
let _e3192 = (bitcast<i32>(_e186) - 1i);
let _e3194 = select(_e3192, _e3190, (_e3190 < _e3192));
let _e3199 = global_7.member[bitcast<u32>(select(0i, _e3194, (_e3194 > 0i)))];
let _e3200 = local_25;
let _e3203 = local_26;
let _e3204 = (_e3190 + _e3203);
let _e3206 = select(_e3192, _e3204, (_e3204 < _e3192));
let _e3211 = global_7.member[bitcast<u32>(select(0i, _e3206, (_e3206 > 0i)))];
let _e3212 = local_25;
let _e3215 = (1f - _e3152);
let _e3217 = (_e3190 + _e3171);
let _e3219 = select(_e3192, _e3217, (_e3217 < _e3192));
let _e3224 = global_7.member[bitcast<u32>(select(0i, _e3219, (_e3219 > 0i)))];
let _e3225 = local_25;
let _e3228 = local_26;
let _e3229 = (_e3217 + _e3228);
let _e3231 = select(_e3192, _e3229, (_e3229 < _e3192));
let _e3236 = global_7.member[bitcast<u32>(select(0i, _e3231, (_e3231 > 0i)))];
let _e3237 = local_25;
let _e3242 = (_e3190 + (((_e3178 - _e3148) * _e3050) * _e3054));
let _e3244 = select(_e3192, _e3242, (_e3242 < _e3192));
let _e3249 = global_7.member[bitcast<u32>(select(0i, _e3244, (_e3244 > 0i)))];
let _e3250 = local_25;
let _e3253 = local_26;
let _e3254 = (_e3242 + _e3253);
let _e3256 = select(_e3192, _e3254, (_e3254 < _e3192));
let _e3261 = global_7.member[bitcast<u32>(select(0i, _e3256, (_e3256 > 0i)))];
let _e3262 = local_25;
let _e3266 = (_e3242 + _e3171);
let _e3268 = select(_e3192, _e3266, (_e3266 < _e3192));
let _e3273 = global_7.member[bitcast<u32>(select(0i, _e3268, (_e3268 > 0i)))];
let _e3274 = local_25;
let _e3277 = local_26;
let _e3278 = (_e3266 + _e3277);
let _e3280 = select(_e3192, _e3278, (_e3278 < _e3192));
let _e3285 = global_7.member[bitcast<u32>(select(0i, _e3280, (_e3280 > 0i)))];
let _e3286 = local_25;
phi_5652_ = ((((((_e3199 * (1f - _e3200)) + (_e3211 * _e3212)) * _e3215) + (((_e3224 * (1f - _e3225)) + (_e3236 * _e3237)) * _e3152)) * (1f - _e3154)) + (((((_e3249 * (1f - _e3250)) + (_e3261 * _e3262)) * _e3215) + (((_e3273 * (1f - _e3274)) + (_e3285 * _e3286)) * _e3152)) * _e3154));
}
let _e3296 = phi_5652_;
let _e3306 = (_e1678 * ((0.34785485f * ((_e2470 * _e2208) + (_e3296 * _e3038))) + (0.65214515f * ((_e2746 * _e2488) + (_e3021 * _e2763)))));
let _e3307 = (_e2207 - _e845);
let _e3317 = global_1.member.member_10.member_2;
let _e3321 = vec3<f32>(_e3317.member, _e3317.member_1, _e3317.member_2);
let _e3324 = global_1.member.member_10.member;
let _e3325 = (_e3324 == 0u);
if _e3325 {
let _e3663 = global_1.member.member_10.member_1;
phi_6229_ = type_26(vec3<f32>(_e3663.member, _e3663.member_1, _e3663.member_2), _e3321);
} else {
let _e3328 = global_1.member.member_10.member_3;
let _e3333 = (_e2216.x - _e3328.member);
let _e3335 = (_e2216.y - _e3328.member_1);
let _e3337 = (_e2216.z - _e3328.member_2);
let _e3342 = (((_e3333 * _e3333) + (_e3335 * _e3335)) + (_e3337 * _e3337));
let _e3344 = select(1e-12f, _e3342, (_e3342 > 1e-12f));
let _e3345 = (1f / _e3344);
let _e3349 = vec3<f32>((_e3317.member * _e3345), (_e3317.member_1 * _e3345), (_e3317.member_2 * _e3345));
if (_e3324 == 2u) {
let _e3353 = global_1.member.member_10.member_1;
let _e3361 = (((_e3353.member * _e3333) + (_e3353.member_1 * _e3335)) + (_e3353.member_2 * _e3337));
let _e3364 = (1f / select(1e-20f, _e3361, (_e3361 > 1e-20f)));
let _e3368 = global_1.member.member_10.member_4.member;
let _e3377 = ((((_e3368.member * _e3333) + (_e3368.member_1 * _e3335)) + (_e3368.member_2 * _e3337)) * _e3364);
let _e3381 = global_1.member.member_10.member_4.member_1;
let _e3390 = ((((_e3381.member * _e3333) + (_e3381.member_1 * _e3335)) + (_e3381.member_2 * _e3337)) * _e3364);
let _e3394 = global_1.member.member_10.member_4.member_2;
let _e3397 = ((_e3377 * _e3377) + (_e3390 * _e3390));
let _e3405 = global_1.member.member_10.member_4.member_3;
let _e3406 = ((_e3394 - sqrt(select(0f, _e3397, (_e3397 > 0f)))) * _e3405);
let _e3408 = select(0f, _e3406, (_e3406 > 0f));
let _e3410 = select(1f, _e3408, (_e3408 < 1f));
let _e3416 = select(0f, ((_e3410 * _e3410) * (3f - (2f * _e3410))), (_e3361 > 0f));
let _e3420 = global_1.member.member_10.member_4.member_5;
if ((_e3420 > 0u) && (_e3416 > 0f)) {
let _e3425 = (0.5f / _e3394);
let _e3434 = global_1.member.member_10.member_4.member_6;
let _e3435 = bitcast<i32>(_e3434);
local_24 = bitcast<i32>(_e3420);
let _e3436 = local_24;
let _e3438 = f32((_e3436 - 1i));
let _e3440 = f32((_e3435 - 1i));
let _e3441 = local_24;
let _e3444 = (((0.5f + (_e3377 * _e3425)) * f32(_e3441)) - 0.5f);
let _e3446 = select(0f, _e3444, (_e3444 > 0f));
let _e3448 = select(_e3438, _e3446, (_e3446 < _e3438));
let _e3451 = (((0.5f - (_e3390 * _e3425)) * f32(_e3435)) - 0.5f);
let _e3453 = select(0f, _e3451, (_e3451 > 0f));
let _e3455 = select(_e3440, _e3453, (_e3453 < _e3440));
let _e3457 = select(0f, _e3448, (_e3448 > 0f));
let _e3459 = select(_e3438, _e3457, (_e3457 < _e3438));
let _e3466 = select(0i, select(select(i32(_e3459), i32(-2147483648), (_e3459 < -2147483600f)), 2147483647i, (_e3459 > 2147483500f)), (_e3459 == _e3459));
let _e3470 = (_e3466 - select(0i, 1i, (_e3459 < f32(_e3466))));
let _e3472 = select(0f, _e3455, (_e3455 > 0f));
let _e3474 = select(_e3440, _e3472, (_e3472 < _e3440));
let _e3481 = select(0i, select(select(i32(_e3474), i32(-2147483648), (_e3474 < -2147483600f)), 2147483647i, (_e3474 > 2147483500f)), (_e3474 == _e3474));
let _e3485 = (_e3481 - select(0i, 1i, (_e3474 < f32(_e3481))));
let _e3487 = (_e3448 - f32(_e3470));
let _e3489 = (_e3455 - f32(_e3485));
let _e3490 = (_e3470 + 1i);
let _e3491 = local_24;
let _e3493 = select(_e3470, _e3490, (_e3490 < _e3491));
let _e3494 = (_e3485 + 1i);
let _e3496 = select(_e3485, _e3494, (_e3494 < _e3435));
let _e3500 = global_1.member.member_10.member_4.member_4;
let _e3501 = bitcast<i32>(_e3500);
let _e3502 = local_24;
let _e3506 = (_e3501 + (3i * ((_e3485 * _e3502) + _e3470)));
let _e3508 = (bitcast<i32>(_e179) - 1i);
let _e3510 = select(_e3508, _e3506, (_e3506 < _e3508));
let _e3515 = global_3.member[bitcast<u32>(select(0i, _e3510, (_e3510 > 0i)))];
let _e3516 = (_e3506 + 1i);
let _e3518 = select(_e3508, _e3516, (_e3516 < _e3508));
let _e3523 = global_3.member[bitcast<u32>(select(0i, _e3518, (_e3518 > 0i)))];
let _e3524 = (_e3506 + 2i);
let _e3526 = select(_e3508, _e3524, (_e3524 < _e3508));
let _e3531 = global_3.member[bitcast<u32>(select(0i, _e3526, (_e3526 > 0i)))];
let _e3532 = local_24;
let _e3536 = (_e3501 + (3i * ((_e3485 * _e3532) + _e3493)));
let _e3538 = select(_e3508, _e3536, (_e3536 < _e3508));
let _e3543 = global_3.member[bitcast<u32>(select(0i, _e3538, (_e3538 > 0i)))];
let _e3544 = (_e3536 + 1i);
let _e3546 = select(_e3508, _e3544, (_e3544 < _e3508));
let _e3551 = global_3.member[bitcast<u32>(select(0i, _e3546, (_e3546 > 0i)))];
let _e3552 = (_e3536 + 2i);
let _e3554 = select(_e3508, _e3552, (_e3552 < _e3508));
let _e3559 = global_3.member[bitcast<u32>(select(0i, _e3554, (_e3554 > 0i)))];
let _e3560 = local_24;
let _e3564 = (_e3501 + (3i * ((_e3496 * _e3560) + _e3470)));
let _e3566 = select(_e3508, _e3564, (_e3564 < _e3508));
let _e3571 = global_3.member[bitcast<u32>(select(0i, _e3566, (_e3566 > 0i)))];
let _e3572 = (_e3564 + 1i);
let _e3574 = select(_e3508, _e3572, (_e3572 < _e3508));
let _e3579 = global_3.member[bitcast<u32>(select(0i, _e3574, (_e3574 > 0i)))];
let _e3580 = (_e3564 + 2i);
let _e3582 = select(_e3508, _e3580, (_e3580 < _e3508));
let _e3587 = global_3.member[bitcast<u32>(select(0i, _e3582, (_e3582 > 0i)))];
let _e3588 = local_24;
let _e3592 = (_e3501 + (3i * ((_e3496 * _e3588) + _e3493)));
let _e3594 = select(_e3508, _e3592, (_e3592 < _e3508));
let _e3599 = global_3.member[bitcast<u32>(select(0i, _e3594, (_e3594 > 0i)))];
let _e3600 = (_e3592 + 1i);
let _e3602 = select(_e3508, _e3600, (_e3600 < _e3508));
let _e3607 = global_3.member[bitcast<u32>(select(0i, _e3602, (_e3602 > 0i)))];
let _e3608 = (_e3592 + 2i);
let _e3610 = select(_e3508, _e3608, (_e3608 < _e3508));
let _e3615 = global_3.member[bitcast<u32>(select(0i, _e3610, (_e3610 > 0i)))];
let _e3622 = (_e3515 + ((_e3543 - _e3515) * _e3487));
let _e3623 = (_e3523 + ((_e3551 - _e3523) * _e3487));
let _e3624 = (_e3531 + ((_e3559 - _e3531) * _e3487));
phi_6213_ = vec3<f32>(((_e3622 + (((_e3571 + ((_e3599 - _e3571) * _e3487)) - _e3622) * _e3489)) * _e3416), ((_e3623 + (((_e3579 + ((_e3607 - _e3579) * _e3487)) - _e3623) * _e3489)) * _e3416), ((_e3624 + (((_e3587 + ((_e3615 - _e3587) * _e3487)) - _e3624) * _e3489)) * _e3416));
} else {
phi_6213_ = vec3(_e3416);
}
let _e3648 = phi_6213_;
phi_6216_ = (_e3349 * _e3648);
} else {
phi_6216_ = _e3349;
}
let _e3651 = phi_6216_;
let _e3655 = (1f / sqrt(select(0f, _e3344, (_e3344 > 0f))));
phi_6229_ = type_26(vec3<f32>((_e3333 * _e3655), (_e3335 * _e3655), (_e3337 * _e3655)), _e3651);
}
let _e3670 = phi_6229_;
let _e3674 = global_1.member.member_10.member_3;
let _e3679 = (_e3674.member - _e2216.x);
let _e3681 = (_e3674.member_1 - _e2216.y);
let _e3683 = (_e3674.member_2 - _e2216.z);
let _e3688 = (((_e3679 * _e3679) + (_e3681 * _e3681)) + (_e3683 * _e3683));
let _e3692 = select(sqrt(select(0f, _e3688, (_e3688 > 0f))), 1e30f, _e3325);
let _e3694 = -(_e3670.member.x);
let _e3696 = -(_e3670.member.y);
let _e3698 = -(_e3670.member.z);
let _e3706 = (1f / select(_e3694, select(1e-12f, -1e-12f, (_e3694 < 0f)), (bitcast<f32>((bitcast<u32>(_e3694) & 2147483647u)) < 1e-12f)));
let _e3714 = (1f / select(_e3696, select(1e-12f, -1e-12f, (_e3696 < 0f)), (bitcast<f32>((bitcast<u32>(_e3696) & 2147483647u)) < 1e-12f)));
let _e3722 = (1f / select(_e3698, select(1e-12f, -1e-12f, (_e3698 < 0f)), (bitcast<f32>((bitcast<u32>(_e3698) & 2147483647u)) < 1e-12f)));
let _e3725 = global_1.member.member_13.member_4;
let _e3731 = global_1.member.member_13.member_5;
let _e3736 = ((_e3725.member - _e2216.x) * _e3706);
let _e3738 = ((_e3731.member - _e2216.x) * _e3706);
let _e3740 = ((_e3725.member_1 - _e2216.y) * _e3714);
let _e3742 = ((_e3731.member_1 - _e2216.y) * _e3714);
let _e3744 = ((_e3725.member_2 - _e2216.z) * _e3722);
let _e3746 = ((_e3731.member_2 - _e2216.z) * _e3722);
let _e3748 = select(_e3738, _e3736, (_e3736 < _e3738));
let _e3750 = select(_e3742, _e3740, (_e3740 < _e3742));
let _e3752 = select(_e3750, _e3748, (_e3748 > _e3750));
let _e3754 = select(_e3746, _e3744, (_e3744 < _e3746));
let _e3756 = select(_e3754, _e3752, (_e3752 > _e3754));
let _e3758 = select(_e3738, _e3736, (_e3736 > _e3738));
let _e3760 = select(_e3742, _e3740, (_e3740 > _e3742));
let _e3762 = select(_e3760, _e3758, (_e3758 < _e3760));
let _e3764 = select(_e3746, _e3744, (_e3744 > _e3746));
let _e3766 = select(_e3764, _e3762, (_e3762 < _e3764));
let _e3768 = select(0f, _e3756, (_e3756 > 0f));
let _e3770 = select(_e3692, _e3766, (_e3766 < _e3692));
let _e3771 = (_e3770 > _e3768);
let _e3772 = select(0f, _e3768, _e3771);
let _e3774 = (select(0f, _e3770, _e3771) - _e3772);
if _e2220 {
phi_7144_ = _e3774;
} else {
let _e3776 = (_e3774 / f32(_e2219));
phi_6425_ = 0u;
phi_6428_ = 0f;
loop {
let _e3778 = phi_6425_;
let _e3780 = phi_6428_;
local_77 = _e3780;
let _e3783 = ((_e3778 < _e2219) && (_e3774 > 0f));
if _e3783 {
let _e3786 = (_e3772 + (_e3776 * f32(_e3778)));
let _e3787 = (_e3786 + _e3776);
let _e3789 = (0.5f * (_e3786 + _e3787));
let _e3790 = (_e3787 - _e3786);
let _e3791 = (0.28867513f * _e3790);
let _e3792 = (_e3789 - _e3791);
let _e3801 = global_1.member.member_13.member_7;
let _e3802 = bitcast<i32>(_e3801);
let _e3805 = global_1.member.member_13.member_8;
let _e3806 = bitcast<i32>(_e3805);
let _e3809 = global_1.member.member_13.member_9;
let _e3810 = bitcast<i32>(_e3809);
let _e3811 = f32(_e3802);
let _e3813 = (_e3731.member - _e3725.member);
let _e3816 = (((((_e2216.x + (_e3694 * _e3792)) - _e3725.member) / _e3813) * _e3811) - 0.5f);
let _e3817 = (_e3811 - 1f);
let _e3819 = select(0f, _e3816, (_e3816 > 0f));
let _e3821 = select(_e3817, _e3819, (_e3819 < _e3817));
let _e3822 = f32(_e3806);
let _e3824 = (_e3731.member_1 - _e3725.member_1);
let _e3827 = (((((_e2216.y + (_e3696 * _e3792)) - _e3725.member_1) / _e3824) * _e3822) - 0.5f);
let _e3828 = (_e3822 - 1f);
let _e3830 = select(0f, _e3827, (_e3827 > 0f));
let _e3832 = select(_e3828, _e3830, (_e3830 < _e3828));
let _e3833 = f32(_e3810);
let _e3835 = (_e3731.member_2 - _e3725.member_2);
let _e3838 = (((((_e2216.z + (_e3698 * _e3792)) - _e3725.member_2) / _e3835) * _e3833) - 0.5f);
let _e3839 = (_e3833 - 1f);
let _e3841 = select(0f, _e3838, (_e3838 > 0f));
let _e3843 = select(_e3839, _e3841, (_e3841 < _e3839));
let _e3845 = select(0f, _e3821, (_e3821 > 0f));
let _e3847 = select(1e6f, _e3845, (_e3845 < 1e6f));
let _e3854 = select(0i, select(select(i32(_e3847), i32(-2147483648), (_e3847 < -2147483600f)), 2147483647i, (_e3847 > 2147483500f)), (_e3847 == _e3847));
let _e3858 = (_e3854 - select(0i, 1i, (_e3847 < f32(_e3854))));
let _e3860 = select(0f, _e3832, (_e3832 > 0f));
let _e3862 = select(1e6f, _e3860, (_e3860 < 1e6f));
let _e3869 = select(0i, select(select(i32(_e3862), i32(-2147483648), (_e3862 < -2147483600f)), 2147483647i, (_e3862 > 2147483500f)), (_e3862 == _e3862));
let _e3873 = (_e3869 - select(0i, 1i, (_e3862 < f32(_e3869))));
let _e3875 = select(0f, _e3843, (_e3843 > 0f));
let _e3877 = select(1e6f, _e3875, (_e3875 < 1e6f));
let _e3884 = select(0i, select(select(i32(_e3877), i32(-2147483648), (_e3877 < -2147483600f)), 2147483647i, (_e3877 > 2147483500f)), (_e3877 == _e3877));
let _e3888 = (_e3884 - select(0i, 1i, (_e3877 < f32(_e3884))));
let _e3892 = (_e3832 - f32(_e3873));
let _e3894 = (_e3843 - f32(_e3888));
local_22 = (_e3821 - f32(_e3858));
let _e3895 = (_e3858 + 1i);
let _e3897 = select(_e3895, 0i, (_e3895 < 0i));
if (_e3897 >= _e3802) {
phi_6566_ = (_e3802 - 1i);
} else {
phi_6566_ = _e3897;
}
let _e3901 = phi_6566_;
local_23 = (_e3901 - _e3858);
let _e3903 = (_e3873 + 1i);
let _e3905 = select(_e3903, 0i, (_e3903 < 0i));
if (_e3905 >= _e3806) {
phi_6579_ = (_e3806 - 1i);
} else {
phi_6579_ = _e3905;
}
let _e3909 = phi_6579_;
let _e3911 = ((_e3909 - _e3873) * _e3802);
let _e3912 = (_e3888 + 1i);
let _e3914 = select(_e3912, 0i, (_e3912 < 0i));
if (_e3914 >= _e3810) {
phi_6593_ = (_e3810 - 1i);
} else {
phi_6593_ = _e3914;
}
let _e3918 = phi_6593_;
let _e3924 = global_1.member.member_13.member_10;
let _e3925 = bitcast<i32>(_e3924);
let _e3930 = ((_e3925 + (((_e3888 * _e3806) + _e3873) * _e3802)) + _e3858);
let _e3932 = (bitcast<i32>(_e186) - 1i);
let _e3934 = select(_e3932, _e3930, (_e3930 < _e3932));
let _e3939 = global_7.member[bitcast<u32>(select(0i, _e3934, (_e3934 > 0i)))];
let _e3940 = local_22;
let _e3943 = local_23;
let _e3944 = (_e3930 + _e3943);
let _e3946 = select(_e3932, _e3944, (_e3944 < _e3932));
let _e3951 = global_7.member[bitcast<u32>(select(0i, _e3946, (_e3946 > 0i)))];
let _e3952 = local_22;
let _e3955 = (1f - _e3892);
let _e3957 = (_e3930 + _e3911);
let _e3959 = select(_e3932, _e3957, (_e3957 < _e3932));
let _e3964 = global_7.member[bitcast<u32>(select(0i, _e3959, (_e3959 > 0i)))];
let _e3965 = local_22;
let _e3968 = local_23;
let _e3969 = (_e3957 + _e3968);
let _e3971 = select(_e3932, _e3969, (_e3969 < _e3932));
let _e3976 = global_7.member[bitcast<u32>(select(0i, _e3971, (_e3971 > 0i)))];
let _e3977 = local_22;
let _e3982 = (_e3930 + (((_e3918 - _e3888) * _e3802) * _e3806));
let _e3984 = select(_e3932, _e3982, (_e3982 < _e3932));
let _e3989 = global_7.member[bitcast<u32>(select(0i, _e3984, (_e3984 > 0i)))];
let _e3990 = local_22;
let _e3993 = local_23;
let _e3994 = (_e3982 + _e3993);
let _e3996 = select(_e3932, _e3994, (_e3994 < _e3932));
let _e4001 = global_7.member[bitcast<u32>(select(0i, _e3996, (_e3996 > 0i)))];
let _e4002 = local_22;
let _e4006 = (_e3982 + _e3911);
let _e4008 = select(_e3932, _e4006, (_e4006 < _e3932));
let _e4013 = global_7.member[bitcast<u32>(select(0i, _e4008, (_e4008 > 0i)))];
let _e4014 = local_22;
let _e4017 = local_23;
let _e4018 = (_e4006 + _e4017);
let _e4020 = select(_e3932, _e4018, (_e4018 < _e3932));
let _e4025 = global_7.member[bitcast<u32>(select(0i, _e4020, (_e4020 > 0i)))];
let _e4026 = local_22;
let _e4035 = (_e3789 + _e3791);
let _e4045 = (((((_e2216.x + (_e3694 * _e4035)) - _e3725.member) / _e3813) * _e3811) - 0.5f);
let _e4047 = select(0f, _e4045, (_e4045 > 0f));
let _e4049 = select(_e3817, _e4047, (_e4047 < _e3817));
let _e4053 = (((((_e2216.y + (_e3696 * _e4035)) - _e3725.member_1) / _e3824) * _e3822) - 0.5f);
let _e4055 = select(0f, _e4053, (_e4053 > 0f));
let _e4057 = select(_e3828, _e4055, (_e4055 < _e3828));
let _e4061 = (((((_e2216.z + (_e3698 * _e4035)) - _e3725.member_2) / _e3835) * _e3833) - 0.5f);
let _e4063 = select(0f, _e4061, (_e4061 > 0f));
let _e4065 = select(_e3839, _e4063, (_e4063 < _e3839));
let _e4067 = select(0f, _e4049, (_e4049 > 0f));
let _e4069 = select(1e6f, _e4067, (_e4067 < 1e6f));
let _e4076 = select(0i, select(select(i32(_e4069), i32(-2147483648), (_e4069 < -2147483600f)), 2147483647i, (_e4069 > 2147483500f)), (_e4069 == _e4069));
let _e4080 = (_e4076 - select(0i, 1i, (_e4069 < f32(_e4076))));
let _e4082 = select(0f, _e4057, (_e4057 > 0f));
let _e4084 = select(1e6f, _e4082, (_e4082 < 1e6f));
let _e4091 = select(0i, select(select(i32(_e4084), i32(-2147483648), (_e4084 < -2147483600f)), 2147483647i, (_e4084 > 2147483500f)), (_e4084 == _e4084));
let _e4095 = (_e4091 - select(0i, 1i, (_e4084 < f32(_e4091))));
let _e4097 = select(0f, _e4065, (_e4065 > 0f));
let _e4099 = select(1e6f, _e4097, (_e4097 < 1e6f));
let _e4106 = select(0i, select(select(i32(_e4099), i32(-2147483648), (_e4099 < -2147483600f)), 2147483647i, (_e4099 > 2147483500f)), (_e4099 == _e4099));
let _e4110 = (_e4106 - select(0i, 1i, (_e4099 < f32(_e4106))));
let _e4114 = (_e4057 - f32(_e4095));
let _e4116 = (_e4065 - f32(_e4110));
local_20 = (_e4049 - f32(_e4080));
let _e4117 = (_e4080 + 1i);
let _e4119 = select(_e4117, 0i, (_e4117 < 0i));
if (_e4119 >= _e3802) {
phi_6912_ = (_e3802 - 1i);
} else {
phi_6912_ = _e4119;
}
let _e4123 = phi_6912_;
local_21 = (_e4123 - _e4080);
let _e4125 = (_e4095 + 1i);
let _e4127 = select(_e4125, 0i, (_e4125 < 0i));
if (_e4127 >= _e3806) {
phi_6925_ = (_e3806 - 1i);
} else {
phi_6925_ = _e4127;
}
let _e4131 = phi_6925_;
let _e4133 = ((_e4131 - _e4095) * _e3802);
let _e4134 = (_e4110 + 1i);
let _e4136 = select(_e4134, 0i, (_e4134 < 0i));
if (_e4136 >= _e3810) {
phi_6939_ = (_e3810 - 1i);
} else {
phi_6939_ = _e4136;
}
let _e4140 = phi_6939_;
let _e4148 = ((_e3925 + (((_e4110 * _e3806) + _e4095) * _e3802)) + _e4080);
let _e4150 = select(_e3932, _e4148, (_e4148 < _e3932));
let _e4155 = global_7.member[bitcast<u32>(select(0i, _e4150, (_e4150 > 0i)))];
let _e4156 = local_20;
let _e4159 = local_21;
let _e4160 = (_e4148 + _e4159);
let _e4162 = select(_e3932, _e4160, (_e4160 < _e3932));
let _e4167 = global_7.member[bitcast<u32>(select(0i, _e4162, (_e4162 > 0i)))];
let _e4168 = local_20;
let _e4171 = (1f - _e4114);
let _e4173 = (_e4148 + _e4133);
let _e4175 = select(_e3932, _e4173, (_e4173 < _e3932));
let _e4180 = global_7.member[bitcast<u32>(select(0i, _e4175, (_e4175 > 0i)))];
let _e4181 = local_20;
let _e4184 = local_21;
let _e4185 = (_e4173 + _e4184);
let _e4187 = select(_e3932, _e4185, (_e4185 < _e3932));
let _e4192 = global_7.member[bitcast<u32>(select(0i, _e4187, (_e4187 > 0i)))];
let _e4193 = local_20;
let _e4198 = (_e4148 + (((_e4140 - _e4110) * _e3802) * _e3806));
let _e4200 = select(_e3932, _e4198, (_e4198 < _e3932));
let _e4205 = global_7.member[bitcast<u32>(select(0i, _e4200, (_e4200 > 0i)))];
let _e4206 = local_20;
let _e4209 = local_21;
let _e4210 = (_e4198 + _e4209);
let _e4212 = select(_e3932, _e4210, (_e4210 < _e3932));
let _e4217 = global_7.member[bitcast<u32>(select(0i, _e4212, (_e4212 > 0i)))];
let _e4218 = local_20;
let _e4222 = (_e4198 + _e4133);
let _e4224 = select(_e3932, _e4222, (_e4222 < _e3932));
let _e4229 = global_7.member[bitcast<u32>(select(0i, _e4224, (_e4224 > 0i)))];
let _e4230 = local_20;
let _e4233 = local_21;
let _e4234 = (_e4222 + _e4233);
let _e4236 = select(_e3932, _e4234, (_e4234 < _e3932));
let _e4241 = global_7.member[bitcast<u32>(select(0i, _e4236, (_e4236 > 0i)))];
let _e4242 = local_20;
phi_6426_ = (_e3778 + 1u);
phi_6429_ = (_e3780 + ((0.5f * (((((((_e3939 * (1f - _e3940)) + (_e3951 * _e3952)) * _e3955) + (((_e3964 * (1f - _e3965)) + (_e3976 * _e3977)) * _e3892)) * (1f - _e3894)) + (((((_e3989 * (1f - _e3990)) + (_e4001 * _e4002)) * _e3955) + (((_e4013 * (1f - _e4014)) + (_e4025 * _e4026)) * _e3892)) * _e3894)) + ((((((_e4155 * (1f - _e4156)) + (_e4167 * _e4168)) * _e4171) + (((_e4180 * (1f - _e4181)) + (_e4192 * _e4193)) * _e4114)) * (1f - _e4116)) + (((((_e4205 * (1f - _e4206)) + (_e4217 * _e4218)) * _e4171) + (((_e4229 * (1f - _e4230)) + (_e4241 * _e4242)) * _e4114)) * _e4116)))) * _e3790));
} else {
phi_6426_ = u32();
phi_6429_ = f32();
}
let _e4257 = phi_6426_;
let _e4259 = phi_6429_;
continue;
continuing {
phi_6425_ = _e4257;
phi_6428_ = _e4259;
break if !(_e3783);
}
}
let _e10922 = local_77;
phi_7144_ = _e10922;
}
let _e4262 = phi_7144_;
let _e4263 = (_e4262 + select((_e2180 + (_e3306 * (0.5f + (0.5f * _e2191)))), select(0f, _e3307, (_e3307 > 0f)), _e852));
let _e4266 = global_1.member.member_13.member;
let _e4271 = -((_e4266.member * _e4263));
let _e4273 = select(-87f, _e4271, (_e4271 > -87f));
let _e4275 = select(88f, _e4273, (_e4273 < 88f));
let _e4277 = ((_e4275 * 1.442695f) + 0.5f);
let _e4279 = select(-127f, _e4277, (_e4277 > -127f));
let _e4281 = select(128f, _e4279, (_e4279 < 128f));
let _e4288 = select(0i, select(select(i32(_e4281), i32(-2147483648), (_e4281 < -2147483600f)), 2147483647i, (_e4281 > 2147483500f)), (_e4281 == _e4281));
let _e4292 = (_e4288 - select(0i, 1i, (_e4281 < f32(_e4288))));
let _e4293 = f32(_e4292);
let _e4297 = ((_e4275 - (_e4293 * 0.6933594f)) - (_e4293 * -2.1219444e-4f));
let _e4319 = -((_e4266.member_1 * _e4263));
let _e4321 = select(-87f, _e4319, (_e4319 > -87f));
let _e4323 = select(88f, _e4321, (_e4321 < 88f));
let _e4325 = ((_e4323 * 1.442695f) + 0.5f);
let _e4327 = select(-127f, _e4325, (_e4325 > -127f));
let _e4329 = select(128f, _e4327, (_e4327 < 128f));
let _e4336 = select(0i, select(select(i32(_e4329), i32(-2147483648), (_e4329 < -2147483600f)), 2147483647i, (_e4329 > 2147483500f)), (_e4329 == _e4329));
let _e4340 = (_e4336 - select(0i, 1i, (_e4329 < f32(_e4336))));
let _e4341 = f32(_e4340);
let _e4345 = ((_e4323 - (_e4341 * 0.6933594f)) - (_e4341 * -2.1219444e-4f));
let _e4367 = -((_e4266.member_2 * _e4263));
let _e4369 = select(-87f, _e4367, (_e4367 > -87f));
let _e4371 = select(88f, _e4369, (_e4369 < 88f));
let _e4373 = ((_e4371 * 1.442695f) + 0.5f);
let _e4375 = select(-127f, _e4373, (_e4373 > -127f));
let _e4377 = select(128f, _e4375, (_e4375 < 128f));
let _e4384 = select(0i, select(select(i32(_e4377), i32(-2147483648), (_e4377 < -2147483600f)), 2147483647i, (_e4377 > 2147483500f)), (_e4377 == _e4377));
let _e4388 = (_e4384 - select(0i, 1i, (_e4377 < f32(_e4384))));
let _e4389 = f32(_e4388);
let _e4393 = ((_e4371 - (_e4389 * 0.6933594f)) - (_e4389 * -2.1219444e-4f));
let _e4419 = -((((_e3670.member.x * _e511) + (_e3670.member.y * _e522)) + (_e3670.member.z * _e533)));
let _e4422 = global_1.member.member_13.member_2;
let _e4423 = (_e4422 * _e4422);
let _e4424 = (1f + _e4423);
let _e4425 = (2f * _e4422);
let _e4427 = (_e4424 - (_e4425 * _e4419));
let _e4429 = select(1e-9f, _e4427, (_e4427 > 1e-9f));
let _e4430 = (1f - _e4423);
let _e4441 = global_1.member.member_13.member_3;
let _e4442 = (_e4441 == 1u);
let _e4444 = (0.25f / 3.1415927f);
let _e4448 = ((3.1415927f * (select((_e4430 / (_e4429 * sqrt(select(0f, _e4429, (_e4429 > 0f))))), (0.75f * (1f + (_e4419 * _e4419))), _e4442) * _e4444)) * (_e2208 * _e2470));
let _e4458 = global_1.member.member_13.member_1;
let _e4468 = (_e3037 - _e845);
if _e3325 {
let _e4807 = global_1.member.member_10.member_1;
phi_7959_ = type_26(vec3<f32>(_e4807.member, _e4807.member_1, _e4807.member_2), _e3321);
} else {
let _e4477 = (_e3046.x - _e3674.member);
let _e4479 = (_e3046.y - _e3674.member_1);
let _e4481 = (_e3046.z - _e3674.member_2);
let _e4486 = (((_e4477 * _e4477) + (_e4479 * _e4479)) + (_e4481 * _e4481));
let _e4488 = select(1e-12f, _e4486, (_e4486 > 1e-12f));
let _e4489 = (1f / _e4488);
let _e4493 = vec3<f32>((_e3317.member * _e4489), (_e3317.member_1 * _e4489), (_e3317.member_2 * _e4489));
if (_e3324 == 2u) {
let _e4497 = global_1.member.member_10.member_1;
let _e4505 = (((_e4497.member * _e4477) + (_e4497.member_1 * _e4479)) + (_e4497.member_2 * _e4481));
let _e4508 = (1f / select(1e-20f, _e4505, (_e4505 > 1e-20f)));
let _e4512 = global_1.member.member_10.member_4.member;
let _e4521 = ((((_e4512.member * _e4477) + (_e4512.member_1 * _e4479)) + (_e4512.member_2 * _e4481)) * _e4508);
let _e4525 = global_1.member.member_10.member_4.member_1;
let _e4534 = ((((_e4525.member * _e4477) + (_e4525.member_1 * _e4479)) + (_e4525.member_2 * _e4481)) * _e4508);
let _e4538 = global_1.member.member_10.member_4.member_2;
let _e4541 = ((_e4521 * _e4521) + (_e4534 * _e4534));
let _e4549 = global_1.member.member_10.member_4.member_3;
let _e4550 = ((_e4538 - sqrt(select(0f, _e4541, (_e4541 > 0f)))) * _e4549);
let _e4552 = select(0f, _e4550, (_e4550 > 0f));
let _e4554 = select(1f, _e4552, (_e4552 < 1f));
let _e4560 = select(0f, ((_e4554 * _e4554) * (3f - (2f * _e4554))), (_e4505 > 0f));
let _e4564 = global_1.member.member_10.member_4.member_5;
if ((_e4564 > 0u) && (_e4560 > 0f)) {
let _e4569 = (0.5f / _e4538);
let _e4578 = global_1.member.member_10.member_4.member_6;
let _e4579 = bitcast<i32>(_e4578);
local_19 = bitcast<i32>(_e4564);
let _e4580 = local_19;
let _e4582 = f32((_e4580 - 1i));
let _e4584 = f32((_e4579 - 1i));
let _e4585 = local_19;
let _e4588 = (((0.5f + (_e4521 * _e4569)) * f32(_e4585)) - 0.5f);
let _e4590 = select(0f, _e4588, (_e4588 > 0f));
let _e4592 = select(_e4582, _e4590, (_e4590 < _e4582));
let _e4595 = (((0.5f - (_e4534 * _e4569)) * f32(_e4579)) - 0.5f);
let _e4597 = select(0f, _e4595, (_e4595 > 0f));
let _e4599 = select(_e4584, _e4597, (_e4597 < _e4584));
let _e4601 = select(0f, _e4592, (_e4592 > 0f));
let _e4603 = select(_e4582, _e4601, (_e4601 < _e4582));
let _e4610 = select(0i, select(select(i32(_e4603), i32(-2147483648), (_e4603 < -2147483600f)), 2147483647i, (_e4603 > 2147483500f)), (_e4603 == _e4603));
let _e4614 = (_e4610 - select(0i, 1i, (_e4603 < f32(_e4610))));
let _e4616 = select(0f, _e4599, (_e4599 > 0f));
let _e4618 = select(_e4584, _e4616, (_e4616 < _e4584));
let _e4625 = select(0i, select(select(i32(_e4618), i32(-2147483648), (_e4618 < -2147483600f)), 2147483647i, (_e4618 > 2147483500f)), (_e4618 == _e4618));
let _e4629 = (_e4625 - select(0i, 1i, (_e4618 < f32(_e4625))));
let _e4631 = (_e4592 - f32(_e4614));
let _e4633 = (_e4599 - f32(_e4629));
let _e4634 = (_e4614 + 1i);
let _e4635 = local_19;
let _e4637 = select(_e4614, _e4634, (_e4634 < _e4635));
let _e4638 = (_e4629 + 1i);
let _e4640 = select(_e4629, _e4638, (_e4638 < _e4579));
let _e4644 = global_1.member.member_10.member_4.member_4;
let _e4645 = bitcast<i32>(_e4644);
let _e4646 = local_19;
let _e4650 = (_e4645 + (3i * ((_e4629 * _e4646) + _e4614)));
let _e4652 = (bitcast<i32>(_e179) - 1i);
let _e4654 = select(_e4652, _e4650, (_e4650 < _e4652));
let _e4659 = global_3.member[bitcast<u32>(select(0i, _e4654, (_e4654 > 0i)))];
let _e4660 = (_e4650 + 1i);
let _e4662 = select(_e4652, _e4660, (_e4660 < _e4652));
let _e4667 = global_3.member[bitcast<u32>(select(0i, _e4662, (_e4662 > 0i)))];
let _e4668 = (_e4650 + 2i);
let _e4670 = select(_e4652, _e4668, (_e4668 < _e4652));
let _e4675 = global_3.member[bitcast<u32>(select(0i, _e4670, (_e4670 > 0i)))];
let _e4676 = local_19;
let _e4680 = (_e4645 + (3i * ((_e4629 * _e4676) + _e4637)));
let _e4682 = select(_e4652, _e4680, (_e4680 < _e4652));
let _e4687 = global_3.member[bitcast<u32>(select(0i, _e4682, (_e4682 > 0i)))];
let _e4688 = (_e4680 + 1i);
let _e4690 = select(_e4652, _e4688, (_e4688 < _e4652));
let _e4695 = global_3.member[bitcast<u32>(select(0i, _e4690, (_e4690 > 0i)))];
let _e4696 = (_e4680 + 2i);
let _e4698 = select(_e4652, _e4696, (_e4696 < _e4652));
let _e4703 = global_3.member[bitcast<u32>(select(0i, _e4698, (_e4698 > 0i)))];
let _e4704 = local_19;
let _e4708 = (_e4645 + (3i * ((_e4640 * _e4704) + _e4614)));
let _e4710 = select(_e4652, _e4708, (_e4708 < _e4652));
let _e4715 = global_3.member[bitcast<u32>(select(0i, _e4710, (_e4710 > 0i)))];
let _e4716 = (_e4708 + 1i);
let _e4718 = select(_e4652, _e4716, (_e4716 < _e4652));
let _e4723 = global_3.member[bitcast<u32>(select(0i, _e4718, (_e4718 > 0i)))];
let _e4724 = (_e4708 + 2i);
let _e4726 = select(_e4652, _e4724, (_e4724 < _e4652));
let _e4731 = global_3.member[bitcast<u32>(select(0i, _e4726, (_e4726 > 0i)))];
let _e4732 = local_19;
let _e4736 = (_e4645 + (3i * ((_e4640 * _e4732) + _e4637)));
let _e4738 = select(_e4652, _e4736, (_e4736 < _e4652));
let _e4743 = global_3.member[bitcast<u32>(select(0i, _e4738, (_e4738 > 0i)))];
let _e4744 = (_e4736 + 1i);
let _e4746 = select(_e4652, _e4744, (_e4744 < _e4652));
let _e4751 = global_3.member[bitcast<u32>(select(0i, _e4746, (_e4746 > 0i)))];
let _e4752 = (_e4736 + 2i);
let _e4754 = select(_e4652, _e4752, (_e4752 < _e4652));
let _e4759 = global_3.member[bitcast<u32>(select(0i, _e4754, (_e4754 > 0i)))];
let _e4766 = (_e4659 + ((_e4687 - _e4659) * _e4631));
let _e4767 = (_e4667 + ((_e4695 - _e4667) * _e4631));
let _e4768 = (_e4675 + ((_e4703 - _e4675) * _e4631));
phi_7943_ = vec3<f32>(((_e4766 + (((_e4715 + ((_e4743 - _e4715) * _e4631)) - _e4766) * _e4633)) * _e4560), ((_e4767 + (((_e4723 + ((_e4751 - _e4723) * _e4631)) - _e4767) * _e4633)) * _e4560), ((_e4768 + (((_e4731 + ((_e4759 - _e4731) * _e4631)) - _e4768) * _e4633)) * _e4560));
} else {
phi_7943_ = vec3(_e4560);
}
let _e4792 = phi_7943_;
phi_7946_ = (_e4493 * _e4792);
} else {
phi_7946_ = _e4493;
}
let _e4795 = phi_7946_;
let _e4799 = (1f / sqrt(select(0f, _e4488, (_e4488 > 0f))));
phi_7959_ = type_26(vec3<f32>((_e4477 * _e4799), (_e4479 * _e4799), (_e4481 * _e4799)), _e4795);
}
let _e4814 = phi_7959_;
let _e4817 = (_e3674.member - _e3046.x);
let _e4819 = (_e3674.member_1 - _e3046.y);
let _e4821 = (_e3674.member_2 - _e3046.z);
let _e4826 = (((_e4817 * _e4817) + (_e4819 * _e4819)) + (_e4821 * _e4821));
let _e4830 = select(sqrt(select(0f, _e4826, (_e4826 > 0f))), 1e30f, _e3325);
let _e4832 = -(_e4814.member.x);
let _e4834 = -(_e4814.member.y);
let _e4836 = -(_e4814.member.z);
let _e4844 = (1f / select(_e4832, select(1e-12f, -1e-12f, (_e4832 < 0f)), (bitcast<f32>((bitcast<u32>(_e4832) & 2147483647u)) < 1e-12f)));
let _e4852 = (1f / select(_e4834, select(1e-12f, -1e-12f, (_e4834 < 0f)), (bitcast<f32>((bitcast<u32>(_e4834) & 2147483647u)) < 1e-12f)));
let _e4860 = (1f / select(_e4836, select(1e-12f, -1e-12f, (_e4836 < 0f)), (bitcast<f32>((bitcast<u32>(_e4836) & 2147483647u)) < 1e-12f)));
let _e4862 = ((_e3725.member - _e3046.x) * _e4844);
let _e4864 = ((_e3731.member - _e3046.x) * _e4844);
let _e4866 = ((_e3725.member_1 - _e3046.y) * _e4852);
let _e4868 = ((_e3731.member_1 - _e3046.y) * _e4852);
let _e4870 = ((_e3725.member_2 - _e3046.z) * _e4860);
let _e4872 = ((_e3731.member_2 - _e3046.z) * _e4860);
let _e4874 = select(_e4864, _e4862, (_e4862 < _e4864));
let _e4876 = select(_e4868, _e4866, (_e4866 < _e4868));
let _e4878 = select(_e4876, _e4874, (_e4874 > _e4876));
let _e4880 = select(_e4872, _e4870, (_e4870 < _e4872));
let _e4882 = select(_e4880, _e4878, (_e4878 > _e4880));
let _e4884 = select(_e4864, _e4862, (_e4862 > _e4864));
let _e4886 = select(_e4868, _e4866, (_e4866 > _e4868));
let _e4888 = select(_e4886, _e4884, (_e4884 < _e4886));
let _e4890 = select(_e4872, _e4870, (_e4870 > _e4872));
let _e4892 = select(_e4890, _e4888, (_e4888 < _e4890));
let _e4894 = select(0f, _e4882, (_e4882 > 0f));
let _e4896 = select(_e4830, _e4892, (_e4892 < _e4830));
let _e4897 = (_e4896 > _e4894);
let _e4898 = select(0f, _e4894, _e4897);
let _e4900 = (select(0f, _e4896, _e4897) - _e4898);
if _e2220 {
phi_8874_ = _e4900;
} else {
let _e4902 = (_e4900 / f32(_e2219));
phi_8155_ = 0u;
phi_8158_ = 0f;
loop {
let _e4904 = phi_8155_;
let _e4906 = phi_8158_;
local_78 = _e4906;
let _e4909 = ((_e4904 < _e2219) && (_e4900 > 0f));
if _e4909 {
let _e4912 = (_e4898 + (_e4902 * f32(_e4904)));
let _e4913 = (_e4912 + _e4902);
let _e4915 = (0.5f * (_e4912 + _e4913));
let _e4916 = (_e4913 - _e4912);
let _e4917 = (0.28867513f * _e4916);
let _e4918 = (_e4915 - _e4917);
let _e4927 = global_1.member.member_13.member_7;
let _e4928 = bitcast<i32>(_e4927);
let _e4931 = global_1.member.member_13.member_8;
let _e4932 = bitcast<i32>(_e4931);
let _e4935 = global_1.member.member_13.member_9;
let _e4936 = bitcast<i32>(_e4935);
let _e4937 = f32(_e4928);
let _e4939 = (_e3731.member - _e3725.member);
let _e4942 = (((((_e3046.x + (_e4832 * _e4918)) - _e3725.member) / _e4939) * _e4937) - 0.5f);
let _e4943 = (_e4937 - 1f);
let _e4945 = select(0f, _e4942, (_e4942 > 0f));
let _e4947 = select(_e4943, _e4945, (_e4945 < _e4943));
let _e4948 = f32(_e4932);
let _e4950 = (_e3731.member_1 - _e3725.member_1);
let _e4953 = (((((_e3046.y + (_e4834 * _e4918)) - _e3725.member_1) / _e4950) * _e4948) - 0.5f);
let _e4954 = (_e4948 - 1f);
let _e4956 = select(0f, _e4953, (_e4953 > 0f));
let _e4958 = select(_e4954, _e4956, (_e4956 < _e4954));
let _e4959 = f32(_e4936);
let _e4961 = (_e3731.member_2 - _e3725.member_2);
let _e4964 = (((((_e3046.z + (_e4836 * _e4918)) - _e3725.member_2) / _e4961) * _e4959) - 0.5f);
let _e4965 = (_e4959 - 1f);
let _e4967 = select(0f, _e4964, (_e4964 > 0f));
let _e4969 = select(_e4965, _e4967, (_e4967 < _e4965));
let _e4971 = select(0f, _e4947, (_e4947 > 0f));
let _e4973 = select(1e6f, _e4971, (_e4971 < 1e6f));
let _e4980 = select(0i, select(select(i32(_e4973), i32(-2147483648), (_e4973 < -2147483600f)), 2147483647i, (_e4973 > 2147483500f)), (_e4973 == _e4973));
let _e4984 = (_e4980 - select(0i, 1i, (_e4973 < f32(_e4980))));
let _e4986 = select(0f, _e4958, (_e4958 > 0f));
let _e4988 = select(1e6f, _e4986, (_e4986 < 1e6f));
let _e4995 = select(0i, select(select(i32(_e4988), i32(-2147483648), (_e4988 < -2147483600f)), 2147483647i, (_e4988 > 2147483500f)), (_e4988 == _e4988));
let _e4999 = (_e4995 - select(0i, 1i, (_e4988 < f32(_e4995))));
let _e5001 = select(0f, _e4969, (_e4969 > 0f));
let _e5003 = select(1e6f, _e5001, (_e5001 < 1e6f));
let _e5010 = select(0i, select(select(i32(_e5003), i32(-2147483648), (_e5003 < -2147483600f)), 2147483647i, (_e5003 > 2147483500f)), (_e5003 == _e5003));
let _e5014 = (_e5010 - select(0i, 1i, (_e5003 < f32(_e5010))));
let _e5018 = (_e4958 - f32(_e4999));
let _e5020 = (_e4969 - f32(_e5014));
local_17 = (_e4947 - f32(_e4984));
let _e5021 = (_e4984 + 1i);
let _e5023 = select(_e5021, 0i, (_e5021 < 0i));
if (_e5023 >= _e4928) {
phi_8296_ = (_e4928 - 1i);
} else {
phi_8296_ = _e5023;
}
let _e5027 = phi_8296_;
local_18 = (_e5027 - _e4984);
let _e5029 = (_e4999 + 1i);
let _e5031 = select(_e5029, 0i, (_e5029 < 0i));
if (_e5031 >= _e4932) {
phi_8309_ = (_e4932 - 1i);
} else {
phi_8309_ = _e5031;
}
let _e5035 = phi_8309_;
let _e5037 = ((_e5035 - _e4999) * _e4928);
let _e5038 = (_e5014 + 1i);
let _e5040 = select(_e5038, 0i, (_e5038 < 0i));
if (_e5040 >= _e4936) {
phi_8323_ = (_e4936 - 1i);
} else {
phi_8323_ = _e5040;
}
let _e5044 = phi_8323_;
let _e5050 = global_1.member.member_13.member_10;
let _e5051 = bitcast<i32>(_e5050);
let _e5056 = ((_e5051 + (((_e5014 * _e4932) + _e4999) * _e4928)) + _e4984);
let _e5058 = (bitcast<i32>(_e186) - 1i);
let _e5060 = select(_e5058, _e5056, (_e5056 < _e5058));
let _e5065 = global_7.member[bitcast<u32>(select(0i, _e5060, (_e5060 > 0i)))];
let _e5066 = local_17;
let _e5069 = local_18;
let _e5070 = (_e5056 + _e5069);
let _e5072 = select(_e5058, _e5070, (_e5070 < _e5058));
let _e5077 = global_7.member[bitcast<u32>(select(0i, _e5072, (_e5072 > 0i)))];
let _e5078 = local_17;
let _e5081 = (1f - _e5018);
let _e5083 = (_e5056 + _e5037);
let _e5085 = select(_e5058, _e5083, (_e5083 < _e5058));
let _e5090 = global_7.member[bitcast<u32>(select(0i, _e5085, (_e5085 > 0i)))];
let _e5091 = local_17;
let _e5094 = local_18;
let _e5095 = (_e5083 + _e5094);
let _e5097 = select(_e5058, _e5095, (_e5095 < _e5058));
let _e5102 = global_7.member[bitcast<u32>(select(0i, _e5097, (_e5097 > 0i)))];
let _e5103 = local_17;
let _e5108 = (_e5056 + (((_e5044 - _e5014) * _e4928) * _e4932));
let _e5110 = select(_e5058, _e5108, (_e5108 < _e5058));
let _e5115 = global_7.member[bitcast<u32>(select(0i, _e5110, (_e5110 > 0i)))];
let _e5116 = local_17;
let _e5119 = local_18;
let _e5120 = (_e5108 + _e5119);
let _e5122 = select(_e5058, _e5120, (_e5120 < _e5058));
let _e5127 = global_7.member[bitcast<u32>(select(0i, _e5122, (_e5122 > 0i)))];
let _e5128 = local_17;
let _e5132 = (_e5108 + _e5037);
let _e5134 = select(_e5058, _e5132, (_e5132 < _e5058));
let _e5139 = global_7.member[bitcast<u32>(select(0i, _e5134, (_e5134 > 0i)))];
let _e5140 = local_17;
let _e5143 = local_18;
let _e5144 = (_e5132 + _e5143);
let _e5146 = select(_e5058, _e5144, (_e5144 < _e5058));
let _e5151 = global_7.member[bitcast<u32>(select(0i, _e5146, (_e5146 > 0i)))];
let _e5152 = local_17;
let _e5161 = (_e4915 + _e4917);
let _e5171 = (((((_e3046.x + (_e4832 * _e5161)) - _e3725.member) / _e4939) * _e4937) - 0.5f);
let _e5173 = select(0f, _e5171, (_e5171 > 0f));
let _e5175 = select(_e4943, _e5173, (_e5173 < _e4943));
let _e5179 = (((((_e3046.y + (_e4834 * _e5161)) - _e3725.member_1) / _e4950) * _e4948) - 0.5f);
let _e5181 = select(0f, _e5179, (_e5179 > 0f));
let _e5183 = select(_e4954, _e5181, (_e5181 < _e4954));
let _e5187 = (((((_e3046.z + (_e4836 * _e5161)) - _e3725.member_2) / _e4961) * _e4959) - 0.5f);
let _e5189 = select(0f, _e5187, (_e5187 > 0f));
let _e5191 = select(_e4965, _e5189, (_e5189 < _e4965));
let _e5193 = select(0f, _e5175, (_e5175 > 0f));
let _e5195 = select(1e6f, _e5193, (_e5193 < 1e6f));
let _e5202 = select(0i, select(select(i32(_e5195), i32(-2147483648), (_e5195 < -2147483600f)), 2147483647i, (_e5195 > 2147483500f)), (_e5195 == _e5195));
let _e5206 = (_e5202 - select(0i, 1i, (_e5195 < f32(_e5202))));
let _e5208 = select(0f, _e5183, (_e5183 > 0f));
let _e5210 = select(1e6f, _e5208, (_e5208 < 1e6f));
let _e5217 = select(0i, select(select(i32(_e5210), i32(-2147483648), (_e5210 < -2147483600f)), 2147483647i, (_e5210 > 2147483500f)), (_e5210 == _e5210));
let _e5221 = (_e5217 - select(0i, 1i, (_e5210 < f32(_e5217))));
let _e5223 = select(0f, _e5191, (_e5191 > 0f));
let _e5225 = select(1e6f, _e5223, (_e5223 < 1e6f));
let _e5232 = select(0i, select(select(i32(_e5225), i32(-2147483648), (_e5225 < -2147483600f)), 2147483647i, (_e5225 > 2147483500f)), (_e5225 == _e5225));
let _e5236 = (_e5232 - select(0i, 1i, (_e5225 < f32(_e5232))));
let _e5240 = (_e5183 - f32(_e5221));
let _e5242 = (_e5191 - f32(_e5236));
local_15 = (_e5175 - f32(_e5206));
let _e5243 = (_e5206 + 1i);
let _e5245 = select(_e5243, 0i, (_e5243 < 0i));
if (_e5245 >= _e4928) {
phi_8642_ = (_e4928 - 1i);
} else {
phi_8642_ = _e5245;
}
let _e5249 = phi_8642_;
local_16 = (_e5249 - _e5206);
let _e5251 = (_e5221 + 1i);
let _e5253 = select(_e5251, 0i, (_e5251 < 0i));
if (_e5253 >= _e4932) {
phi_8655_ = (_e4932 - 1i);
} else {
phi_8655_ = _e5253;
}
let _e5257 = phi_8655_;
let _e5259 = ((_e5257 - _e5221) * _e4928);
let _e5260 = (_e5236 + 1i);
let _e5262 = select(_e5260, 0i, (_e5260 < 0i));
if (_e5262 >= _e4936) {
phi_8669_ = (_e4936 - 1i);
} else {
phi_8669_ = _e5262;
}
let _e5266 = phi_8669_;
let _e5274 = ((_e5051 + (((_e5236 * _e4932) + _e5221) * _e4928)) + _e5206);
let _e5276 = select(_e5058, _e5274, (_e5274 < _e5058));
let _e5281 = global_7.member[bitcast<u32>(select(0i, _e5276, (_e5276 > 0i)))];
let _e5282 = local_15;
let _e5285 = local_16;
let _e5286 = (_e5274 + _e5285);
let _e5288 = select(_e5058, _e5286, (_e5286 < _e5058));
let _e5293 = global_7.member[bitcast<u32>(select(0i, _e5288, (_e5288 > 0i)))];
let _e5294 = local_15;
let _e5297 = (1f - _e5240);
let _e5299 = (_e5274 + _e5259);
let _e5301 = select(_e5058, _e5299, (_e5299 < _e5058));
let _e5306 = global_7.member[bitcast<u32>(select(0i, _e5301, (_e5301 > 0i)))];
let _e5307 = local_15;
let _e5310 = local_16;
let _e5311 = (_e5299 + _e5310);
let _e5313 = select(_e5058, _e5311, (_e5311 < _e5058));
let _e5318 = global_7.member[bitcast<u32>(select(0i, _e5313, (_e5313 > 0i)))];
let _e5319 = local_15;
let _e5324 = (_e5274 + (((_e5266 - _e5236) * _e4928) * _e4932));
let _e5326 = select(_e5058, _e5324, (_e5324 < _e5058));
let _e5331 = global_7.member[bitcast<u32>(select(0i, _e5326, (_e5326 > 0i)))];
let _e5332 = local_15;
let _e5335 = local_16;
let _e5336 = (_e5324 + _e5335);
let _e5338 = select(_e5058, _e5336, (_e5336 < _e5058));
let _e5343 = global_7.member[bitcast<u32>(select(0i, _e5338, (_e5338 > 0i)))];
let _e5344 = local_15;
let _e5348 = (_e5324 + _e5259);
let _e5350 = select(_e5058, _e5348, (_e5348 < _e5058));
let _e5355 = global_7.member[bitcast<u32>(select(0i, _e5350, (_e5350 > 0i)))];
let _e5356 = local_15;
let _e5359 = local_16;
let _e5360 = (_e5348 + _e5359);
let _e5362 = select(_e5058, _e5360, (_e5360 < _e5058));
let _e5367 = global_7.member[bitcast<u32>(select(0i, _e5362, (_e5362 > 0i)))];
let _e5368 = local_15;
phi_8156_ = (_e4904 + 1u);
phi_8159_ = (_e4906 + ((0.5f * (((((((_e5065 * (1f - _e5066)) + (_e5077 * _e5078)) * _e5081) + (((_e5090 * (1f - _e5091)) + (_e5102 * _e5103)) * _e5018)) * (1f - _e5020)) + (((((_e5115 * (1f - _e5116)) + (_e5127 * _e5128)) * _e5081) + (((_e5139 * (1f - _e5140)) + (_e5151 * _e5152)) * _e5018)) * _e5020)) + ((((((_e5281 * (1f - _e5282)) + (_e5293 * _e5294)) * _e5297) + (((_e5306 * (1f - _e5307)) + (_e5318 * _e5319)) * _e5240)) * (1f - _e5242)) + (((((_e5331 * (1f - _e5332)) + (_e5343 * _e5344)) * _e5297) + (((_e5355 * (1f - _e5356)) + (_e5367 * _e5368)) * _e5240)) * _e5242)))) * _e4916));
} else {
phi_8156_ = u32();
phi_8159_ = f32();
}
let _e5383 = phi_8156_;
let _e5385 = phi_8159_;
continue;
continuing {
phi_8155_ = _e5383;
phi_8158_ = _e5385;
break if !(_e4909);
}
}
let _e10938 = local_78;
phi_8874_ = _e10938;
}
let _e5388 = phi_8874_;
let _e5389 = (_e5388 + select((_e2180 + (_e3306 * (0.5f + (0.5f * 0.8611363f)))), select(0f, _e4468, (_e4468 > 0f)), _e852));
let _e5391 = -((_e4266.member * _e5389));
let _e5393 = select(-87f, _e5391, (_e5391 > -87f));
let _e5395 = select(88f, _e5393, (_e5393 < 88f));
let _e5397 = ((_e5395 * 1.442695f) + 0.5f);
let _e5399 = select(-127f, _e5397, (_e5397 > -127f));
let _e5401 = select(128f, _e5399, (_e5399 < 128f));
let _e5408 = select(0i, select(select(i32(_e5401), i32(-2147483648), (_e5401 < -2147483600f)), 2147483647i, (_e5401 > 2147483500f)), (_e5401 == _e5401));
let _e5412 = (_e5408 - select(0i, 1i, (_e5401 < f32(_e5408))));
let _e5413 = f32(_e5412);
let _e5417 = ((_e5395 - (_e5413 * 0.6933594f)) - (_e5413 * -2.1219444e-4f));
let _e5439 = -((_e4266.member_1 * _e5389));
let _e5441 = select(-87f, _e5439, (_e5439 > -87f));
let _e5443 = select(88f, _e5441, (_e5441 < 88f));
let _e5445 = ((_e5443 * 1.442695f) + 0.5f);
let _e5447 = select(-127f, _e5445, (_e5445 > -127f));
let _e5449 = select(128f, _e5447, (_e5447 < 128f));
let _e5456 = select(0i, select(select(i32(_e5449), i32(-2147483648), (_e5449 < -2147483600f)), 2147483647i, (_e5449 > 2147483500f)), (_e5449 == _e5449));
let _e5460 = (_e5456 - select(0i, 1i, (_e5449 < f32(_e5456))));
let _e5461 = f32(_e5460);
let _e5465 = ((_e5443 - (_e5461 * 0.6933594f)) - (_e5461 * -2.1219444e-4f));
let _e5487 = -((_e4266.member_2 * _e5389));
let _e5489 = select(-87f, _e5487, (_e5487 > -87f));
let _e5491 = select(88f, _e5489, (_e5489 < 88f));
let _e5493 = ((_e5491 * 1.442695f) + 0.5f);
let _e5495 = select(-127f, _e5493, (_e5493 > -127f));
let _e5497 = select(128f, _e5495, (_e5495 < 128f));
let _e5504 = select(0i, select(select(i32(_e5497), i32(-2147483648), (_e5497 < -2147483600f)), 2147483647i, (_e5497 > 2147483500f)), (_e5497 == _e5497));
let _e5508 = (_e5504 - select(0i, 1i, (_e5497 < f32(_e5504))));
let _e5509 = f32(_e5508);
let _e5513 = ((_e5491 - (_e5509 * 0.6933594f)) - (_e5509 * -2.1219444e-4f));
let _e5539 = -((((_e4814.member.x * _e511) + (_e4814.member.y * _e522)) + (_e4814.member.z * _e533)));
let _e5541 = (_e4424 - (_e4425 * _e5539));
let _e5543 = select(1e-9f, _e5541, (_e5541 > 1e-9f));
let _e5556 = ((3.1415927f * (select((_e4430 / (_e5543 * sqrt(select(0f, _e5543, (_e5543 > 0f))))), (0.75f * (1f + (_e5539 * _e5539))), _e4442) * _e4444)) * (_e3038 * _e3296));
let _e5573 = (_e2487 - _e845);
if _e3325 {
let _e5912 = global_1.member.member_10.member_1;
phi_9693_ = type_26(vec3<f32>(_e5912.member, _e5912.member_1, _e5912.member_2), _e3321);
} else {
let _e5582 = (_e2496.x - _e3674.member);
let _e5584 = (_e2496.y - _e3674.member_1);
let _e5586 = (_e2496.z - _e3674.member_2);
let _e5591 = (((_e5582 * _e5582) + (_e5584 * _e5584)) + (_e5586 * _e5586));
let _e5593 = select(1e-12f, _e5591, (_e5591 > 1e-12f));
let _e5594 = (1f / _e5593);
let _e5598 = vec3<f32>((_e3317.member * _e5594), (_e3317.member_1 * _e5594), (_e3317.member_2 * _e5594));
if (_e3324 == 2u) {
let _e5602 = global_1.member.member_10.member_1;
let _e5610 = (((_e5602.member * _e5582) + (_e5602.member_1 * _e5584)) + (_e5602.member_2 * _e5586));
let _e5613 = (1f / select(1e-20f, _e5610, (_e5610 > 1e-20f)));
let _e5617 = global_1.member.member_10.member_4.member;
let _e5626 = ((((_e5617.member * _e5582) + (_e5617.member_1 * _e5584)) + (_e5617.member_2 * _e5586)) * _e5613);
let _e5630 = global_1.member.member_10.member_4.member_1;
let _e5639 = ((((_e5630.member * _e5582) + (_e5630.member_1 * _e5584)) + (_e5630.member_2 * _e5586)) * _e5613);
let _e5643 = global_1.member.member_10.member_4.member_2;
let _e5646 = ((_e5626 * _e5626) + (_e5639 * _e5639));
let _e5654 = global_1.member.member_10.member_4.member_3;
let _e5655 = ((_e5643 - sqrt(select(0f, _e5646, (_e5646 > 0f)))) * _e5654);
let _e5657 = select(0f, _e5655, (_e5655 > 0f));
let _e5659 = select(1f, _e5657, (_e5657 < 1f));
let _e5665 = select(0f, ((_e5659 * _e5659) * (3f - (2f * _e5659))), (_e5610 > 0f));
let _e5669 = global_1.member.member_10.member_4.member_5;
if ((_e5669 > 0u) && (_e5665 > 0f)) {
let _e5674 = (0.5f / _e5643);
let _e5683 = global_1.member.member_10.member_4.member_6;
let _e5684 = bitcast<i32>(_e5683);
local_14 = bitcast<i32>(_e5669);
let _e5685 = local_14;
let _e5687 = f32((_e5685 - 1i));
let _e5689 = f32((_e5684 - 1i));
let _e5690 = local_14;
let _e5693 = (((0.5f + (_e5626 * _e5674)) * f32(_e5690)) - 0.5f);
let _e5695 = select(0f, _e5693, (_e5693 > 0f));
let _e5697 = select(_e5687, _e5695, (_e5695 < _e5687));
let _e5700 = (((0.5f - (_e5639 * _e5674)) * f32(_e5684)) - 0.5f);
let _e5702 = select(0f, _e5700, (_e5700 > 0f));
let _e5704 = select(_e5689, _e5702, (_e5702 < _e5689));
let _e5706 = select(0f, _e5697, (_e5697 > 0f));
let _e5708 = select(_e5687, _e5706, (_e5706 < _e5687));
let _e5715 = select(0i, select(select(i32(_e5708), i32(-2147483648), (_e5708 < -2147483600f)), 2147483647i, (_e5708 > 2147483500f)), (_e5708 == _e5708));
let _e5719 = (_e5715 - select(0i, 1i, (_e5708 < f32(_e5715))));
let _e5721 = select(0f, _e5704, (_e5704 > 0f));
let _e5723 = select(_e5689, _e5721, (_e5721 < _e5689));
let _e5730 = select(0i, select(select(i32(_e5723), i32(-2147483648), (_e5723 < -2147483600f)), 2147483647i, (_e5723 > 2147483500f)), (_e5723 == _e5723));
let _e5734 = (_e5730 - select(0i, 1i, (_e5723 < f32(_e5730))));
let _e5736 = (_e5697 - f32(_e5719));
let _e5738 = (_e5704 - f32(_e5734));
let _e5739 = (_e5719 + 1i);
let _e5740 = local_14;
let _e5742 = select(_e5719, _e5739, (_e5739 < _e5740));
let _e5743 = (_e5734 + 1i);
let _e5745 = select(_e5734, _e5743, (_e5743 < _e5684));
let _e5749 = global_1.member.member_10.member_4.member_4;
let _e5750 = bitcast<i32>(_e5749);
let _e5751 = local_14;
let _e5755 = (_e5750 + (3i * ((_e5734 * _e5751) + _e5719)));
let _e5757 = (bitcast<i32>(_e179) - 1i);
let _e5759 = select(_e5757, _e5755, (_e5755 < _e5757));
let _e5764 = global_3.member[bitcast<u32>(select(0i, _e5759, (_e5759 > 0i)))];
let _e5765 = (_e5755 + 1i);
let _e5767 = select(_e5757, _e5765, (_e5765 < _e5757));
let _e5772 = global_3.member[bitcast<u32>(select(0i, _e5767, (_e5767 > 0i)))];
let _e5773 = (_e5755 + 2i);
let _e5775 = select(_e5757, _e5773, (_e5773 < _e5757));
let _e5780 = global_3.member[bitcast<u32>(select(0i, _e5775, (_e5775 > 0i)))];
let _e5781 = local_14;
let _e5785 = (_e5750 + (3i * ((_e5734 * _e5781) + _e5742)));
let _e5787 = select(_e5757, _e5785, (_e5785 < _e5757));
let _e5792 = global_3.member[bitcast<u32>(select(0i, _e5787, (_e5787 > 0i)))];
let _e5793 = (_e5785 + 1i);
let _e5795 = select(_e5757, _e5793, (_e5793 < _e5757));
let _e5800 = global_3.member[bitcast<u32>(select(0i, _e5795, (_e5795 > 0i)))];
let _e5801 = (_e5785 + 2i);
let _e5803 = select(_e5757, _e5801, (_e5801 < _e5757));
let _e5808 = global_3.member[bitcast<u32>(select(0i, _e5803, (_e5803 > 0i)))];
let _e5809 = local_14;
let _e5813 = (_e5750 + (3i * ((_e5745 * _e5809) + _e5719)));
let _e5815 = select(_e5757, _e5813, (_e5813 < _e5757));
let _e5820 = global_3.member[bitcast<u32>(select(0i, _e5815, (_e5815 > 0i)))];
let _e5821 = (_e5813 + 1i);
let _e5823 = select(_e5757, _e5821, (_e5821 < _e5757));
let _e5828 = global_3.member[bitcast<u32>(select(0i, _e5823, (_e5823 > 0i)))];
let _e5829 = (_e5813 + 2i);
let _e5831 = select(_e5757, _e5829, (_e5829 < _e5757));
let _e5836 = global_3.member[bitcast<u32>(select(0i, _e5831, (_e5831 > 0i)))];
let _e5837 = local_14;
let _e5841 = (_e5750 + (3i * ((_e5745 * _e5837) + _e5742)));
let _e5843 = select(_e5757, _e5841, (_e5841 < _e5757));
let _e5848 = global_3.member[bitcast<u32>(select(0i, _e5843, (_e5843 > 0i)))];
let _e5849 = (_e5841 + 1i);
let _e5851 = select(_e5757, _e5849, (_e5849 < _e5757));
let _e5856 = global_3.member[bitcast<u32>(select(0i, _e5851, (_e5851 > 0i)))];
let _e5857 = (_e5841 + 2i);
let _e5859 = select(_e5757, _e5857, (_e5857 < _e5757));
let _e5864 = global_3.member[bitcast<u32>(select(0i, _e5859, (_e5859 > 0i)))];
let _e5871 = (_e5764 + ((_e5792 - _e5764) * _e5736));
let _e5872 = (_e5772 + ((_e5800 - _e5772) * _e5736));
let _e5873 = (_e5780 + ((_e5808 - _e5780) * _e5736));
phi_9677_ = vec3<f32>(((_e5871 + (((_e5820 + ((_e5848 - _e5820) * _e5736)) - _e5871) * _e5738)) * _e5665), ((_e5872 + (((_e5828 + ((_e5856 - _e5828) * _e5736)) - _e5872) * _e5738)) * _e5665), ((_e5873 + (((_e5836 + ((_e5864 - _e5836) * _e5736)) - _e5873) * _e5738)) * _e5665));
} else {
phi_9677_ = vec3(_e5665);
}
let _e5897 = phi_9677_;
phi_9680_ = (_e5598 * _e5897);
} else {
phi_9680_ = _e5598;
}
let _e5900 = phi_9680_;
let _e5904 = (1f / sqrt(select(0f, _e5593, (_e5593 > 0f))));
phi_9693_ = type_26(vec3<f32>((_e5582 * _e5904), (_e5584 * _e5904), (_e5586 * _e5904)), _e5900);
}
let _e5919 = phi_9693_;
let _e5922 = (_e3674.member - _e2496.x);
let _e5924 = (_e3674.member_1 - _e2496.y);
let _e5926 = (_e3674.member_2 - _e2496.z);
let _e5931 = (((_e5922 * _e5922) + (_e5924 * _e5924)) + (_e5926 * _e5926));
let _e5935 = select(sqrt(select(0f, _e5931, (_e5931 > 0f))), 1e30f, _e3325);
let _e5937 = -(_e5919.member.x);
let _e5939 = -(_e5919.member.y);
let _e5941 = -(_e5919.member.z);
let _e5949 = (1f / select(_e5937, select(1e-12f, -1e-12f, (_e5937 < 0f)), (bitcast<f32>((bitcast<u32>(_e5937) & 2147483647u)) < 1e-12f)));
let _e5957 = (1f / select(_e5939, select(1e-12f, -1e-12f, (_e5939 < 0f)), (bitcast<f32>((bitcast<u32>(_e5939) & 2147483647u)) < 1e-12f)));
let _e5965 = (1f / select(_e5941, select(1e-12f, -1e-12f, (_e5941 < 0f)), (bitcast<f32>((bitcast<u32>(_e5941) & 2147483647u)) < 1e-12f)));
let _e5967 = ((_e3725.member - _e2496.x) * _e5949);
let _e5969 = ((_e3731.member - _e2496.x) * _e5949);
let _e5971 = ((_e3725.member_1 - _e2496.y) * _e5957);
let _e5973 = ((_e3731.member_1 - _e2496.y) * _e5957);
let _e5975 = ((_e3725.member_2 - _e2496.z) * _e5965);
let _e5977 = ((_e3731.member_2 - _e2496.z) * _e5965);
let _e5979 = select(_e5969, _e5967, (_e5967 < _e5969));
let _e5981 = select(_e5973, _e5971, (_e5971 < _e5973));
let _e5983 = select(_e5981, _e5979, (_e5979 > _e5981));
let _e5985 = select(_e5977, _e5975, (_e5975 < _e5977));
let _e5987 = select(_e5985, _e5983, (_e5983 > _e5985));
let _e5989 = select(_e5969, _e5967, (_e5967 > _e5969));
let _e5991 = select(_e5973, _e5971, (_e5971 > _e5973));
let _e5993 = select(_e5991, _e5989, (_e5989 < _e5991));
let _e5995 = select(_e5977, _e5975, (_e5975 > _e5977));
let _e5997 = select(_e5995, _e5993, (_e5993 < _e5995));
let _e5999 = select(0f, _e5987, (_e5987 > 0f));
let _e6001 = select(_e5935, _e5997, (_e5997 < _e5935));
let _e6002 = (_e6001 > _e5999);
let _e6003 = select(0f, _e5999, _e6002);
let _e6005 = (select(0f, _e6001, _e6002) - _e6003);
if _e2220 {
phi_10608_ = _e6005;
} else {
let _e6007 = (_e6005 / f32(_e2219));
phi_9889_ = 0u;
phi_9892_ = 0f;
loop {
let _e6009 = phi_9889_;
let _e6011 = phi_9892_;
local_79 = _e6011;
let _e6014 = ((_e6009 < _e2219) && (_e6005 > 0f));
if _e6014 {
let _e6017 = (_e6003 + (_e6007 * f32(_e6009)));
let _e6018 = (_e6017 + _e6007);
let _e6020 = (0.5f * (_e6017 + _e6018));
let _e6021 = (_e6018 - _e6017);
let _e6022 = (0.28867513f * _e6021);
let _e6023 = (_e6020 - _e6022);
let _e6032 = global_1.member.member_13.member_7;
let _e6033 = bitcast<i32>(_e6032);
let _e6036 = global_1.member.member_13.member_8;
let _e6037 = bitcast<i32>(_e6036);
let _e6040 = global_1.member.member_13.member_9;
let _e6041 = bitcast<i32>(_e6040);
let _e6042 = f32(_e6033);
let _e6044 = (_e3731.member - _e3725.member);
let _e6047 = (((((_e2496.x + (_e5937 * _e6023)) - _e3725.member) / _e6044) * _e6042) - 0.5f);
let _e6048 = (_e6042 - 1f);
let _e6050 = select(0f, _e6047, (_e6047 > 0f));
let _e6052 = select(_e6048, _e6050, (_e6050 < _e6048));
let _e6053 = f32(_e6037);
let _e6055 = (_e3731.member_1 - _e3725.member_1);
let _e6058 = (((((_e2496.y + (_e5939 * _e6023)) - _e3725.member_1) / _e6055) * _e6053) - 0.5f);
let _e6059 = (_e6053 - 1f);
let _e6061 = select(0f, _e6058, (_e6058 > 0f));
let _e6063 = select(_e6059, _e6061, (_e6061 < _e6059));
let _e6064 = f32(_e6041);
let _e6066 = (_e3731.member_2 - _e3725.member_2);
let _e6069 = (((((_e2496.z + (_e5941 * _e6023)) - _e3725.member_2) / _e6066) * _e6064) - 0.5f);
let _e6070 = (_e6064 - 1f);
let _e6072 = select(0f, _e6069, (_e6069 > 0f));
let _e6074 = select(_e6070, _e6072, (_e6072 < _e6070));
let _e6076 = select(0f, _e6052, (_e6052 > 0f));
let _e6078 = select(1e6f, _e6076, (_e6076 < 1e6f));
let _e6085 = select(0i, select(select(i32(_e6078), i32(-2147483648), (_e6078 < -2147483600f)), 2147483647i, (_e6078 > 2147483500f)), (_e6078 == _e6078));
let _e6089 = (_e6085 - select(0i, 1i, (_e6078 < f32(_e6085))));
let _e6091 = select(0f, _e6063, (_e6063 > 0f));
let _e6093 = select(1e6f, _e6091, (_e6091 < 1e6f));
let _e6100 = select(0i, select(select(i32(_e6093), i32(-2147483648), (_e6093 < -2147483600f)), 2147483647i, (_e6093 > 2147483500f)), (_e6093 == _e6093));
let _e6104 = (_e6100 - select(0i, 1i, (_e6093 < f32(_e6100))));
let _e6106 = select(0f, _e6074, (_e6074 > 0f));
let _e6108 = select(1e6f, _e6106, (_e6106 < 1e6f));
let _e6115 = select(0i, select(select(i32(_e6108), i32(-2147483648), (_e6108 < -2147483600f)), 2147483647i, (_e6108 > 2147483500f)), (_e6108 == _e6108));
let _e6119 = (_e6115 - select(0i, 1i, (_e6108 < f32(_e6115))));
let _e6123 = (_e6063 - f32(_e6104));
let _e6125 = (_e6074 - f32(_e6119));
local_12 = (_e6052 - f32(_e6089));
let _e6126 = (_e6089 + 1i);
let _e6128 = select(_e6126, 0i, (_e6126 < 0i));
if (_e6128 >= _e6033) {
phi_10030_ = (_e6033 - 1i);
} else {
phi_10030_ = _e6128;
}
let _e6132 = phi_10030_;
local_13 = (_e6132 - _e6089);
let _e6134 = (_e6104 + 1i);
let _e6136 = select(_e6134, 0i, (_e6134 < 0i));
if (_e6136 >= _e6037) {
phi_10043_ = (_e6037 - 1i);
} else {
phi_10043_ = _e6136;
}
let _e6140 = phi_10043_;
let _e6142 = ((_e6140 - _e6104) * _e6033);
let _e6143 = (_e6119 + 1i);
let _e6145 = select(_e6143, 0i, (_e6143 < 0i));
if (_e6145 >= _e6041) {
phi_10057_ = (_e6041 - 1i);
} else {
phi_10057_ = _e6145;
}
let _e6149 = phi_10057_;
let _e6155 = global_1.member.member_13.member_10;
let _e6156 = bitcast<i32>(_e6155);
let _e6161 = ((_e6156 + (((_e6119 * _e6037) + _e6104) * _e6033)) + _e6089);
let _e6163 = (bitcast<i32>(_e186) - 1i);
let _e6165 = select(_e6163, _e6161, (_e6161 < _e6163));
let _e6170 = global_7.member[bitcast<u32>(select(0i, _e6165, (_e6165 > 0i)))];
let _e6171 = local_12;
let _e6174 = local_13;
let _e6175 = (_e6161 + _e6174);
let _e6177 = select(_e6163, _e6175, (_e6175 < _e6163));
let _e6182 = global_7.member[bitcast<u32>(select(0i, _e6177, (_e6177 > 0i)))];
let _e6183 = local_12;
let _e6186 = (1f - _e6123);
let _e6188 = (_e6161 + _e6142);
let _e6190 = select(_e6163, _e6188, (_e6188 < _e6163));
let _e6195 = global_7.member[bitcast<u32>(select(0i, _e6190, (_e6190 > 0i)))];
let _e6196 = local_12;
let _e6199 = local_13;
let _e6200 = (_e6188 + _e6199);
let _e6202 = select(_e6163, _e6200, (_e6200 < _e6163));
let _e6207 = global_7.member[bitcast<u32>(select(0i, _e6202, (_e6202 > 0i)))];
let _e6208 = local_12;
let _e6213 = (_e6161 + (((_e6149 - _e6119) * _e6033) * _e6037));
let _e6215 = select(_e6163, _e6213, (_e6213 < _e6163));
let _e6220 = global_7.member[bitcast<u32>(select(0i, _e6215, (_e6215 > 0i)))];
let _e6221 = local_12;
let _e6224 = local_13;
let _e6225 = (_e6213 + _e6224);
let _e6227 = select(_e6163, _e6225, (_e6225 < _e6163));
let _e6232 = global_7.member[bitcast<u32>(select(0i, _e6227, (_e6227 > 0i)))];
let _e6233 = local_12;
let _e6237 = (_e6213 + _e6142);
let _e6239 = select(_e6163, _e6237, (_e6237 < _e6163));
let _e6244 = global_7.member[bitcast<u32>(select(0i, _e6239, (_e6239 > 0i)))];
let _e6245 = local_12;
let _e6248 = local_13;
let _e6249 = (_e6237 + _e6248);
let _e6251 = select(_e6163, _e6249, (_e6249 < _e6163));
let _e6256 = global_7.member[bitcast<u32>(select(0i, _e6251, (_e6251 > 0i)))];
let _e6257 = local_12;
let _e6266 = (_e6020 + _e6022);
let _e6276 = (((((_e2496.x + (_e5937 * _e6266)) - _e3725.member) / _e6044) * _e6042) - 0.5f);
let _e6278 = select(0f, _e6276, (_e6276 > 0f));
let _e6280 = select(_e6048, _e6278, (_e6278 < _e6048));
let _e6284 = (((((_e2496.y + (_e5939 * _e6266)) - _e3725.member_1) / _e6055) * _e6053) - 0.5f);
let _e6286 = select(0f, _e6284, (_e6284 > 0f));
let _e6288 = select(_e6059, _e6286, (_e6286 < _e6059));
let _e6292 = (((((_e2496.z + (_e5941 * _e6266)) - _e3725.member_2) / _e6066) * _e6064) - 0.5f);
let _e6294 = select(0f, _e6292, (_e6292 > 0f));
let _e6296 = select(_e6070, _e6294, (_e6294 < _e6070));
let _e6298 = select(0f, _e6280, (_e6280 > 0f));
let _e6300 = select(1e6f, _e6298, (_e6298 < 1e6f));
let _e6307 = select(0i, select(select(i32(_e6300), i32(-2147483648), (_e6300 < -2147483600f)), 2147483647i, (_e6300 > 2147483500f)), (_e6300 == _e6300));
let _e6311 = (_e6307 - select(0i, 1i, (_e6300 < f32(_e6307))));
let _e6313 = select(0f, _e6288, (_e6288 > 0f));
let _e6315 = select(1e6f, _e6313, (_e6313 < 1e6f));
let _e6322 = select(0i, select(select(i32(_e6315), i32(-2147483648), (_e6315 < -2147483600f)), 2147483647i, (_e6315 > 2147483500f)), (_e6315 == _e6315));
let _e6326 = (_e6322 - select(0i, 1i, (_e6315 < f32(_e6322))));
let _e6328 = select(0f, _e6296, (_e6296 > 0f));
let _e6330 = select(1e6f, _e6328, (_e6328 < 1e6f));
let _e6337 = select(0i, select(select(i32(_e6330), i32(-2147483648), (_e6330 < -2147483600f)), 2147483647i, (_e6330 > 2147483500f)), (_e6330 == _e6330));
let _e6341 = (_e6337 - select(0i, 1i, (_e6330 < f32(_e6337))));
let _e6345 = (_e6288 - f32(_e6326));
let _e6347 = (_e6296 - f32(_e6341));
local_10 = (_e6280 - f32(_e6311));
let _e6348 = (_e6311 + 1i);
let _e6350 = select(_e6348, 0i, (_e6348 < 0i));
if (_e6350 >= _e6033) {
phi_10376_ = (_e6033 - 1i);
} else {
phi_10376_ = _e6350;
}
let _e6354 = phi_10376_;
local_11 = (_e6354 - _e6311);
let _e6356 = (_e6326 + 1i);
let _e6358 = select(_e6356, 0i, (_e6356 < 0i));
if (_e6358 >= _e6037) {
phi_10389_ = (_e6037 - 1i);
} else {
phi_10389_ = _e6358;
}
let _e6362 = phi_10389_;
let _e6364 = ((_e6362 - _e6326) * _e6033);
let _e6365 = (_e6341 + 1i);
let _e6367 = select(_e6365, 0i, (_e6365 < 0i));
if (_e6367 >= _e6041) {
phi_10403_ = (_e6041 - 1i);
} else {
phi_10403_ = _e6367;
}
let _e6371 = phi_10403_;
let _e6379 = ((_e6156 + (((_e6341 * _e6037) + _e6326) * _e6033)) + _e6311);
let _e6381 = select(_e6163, _e6379, (_e6379 < _e6163));
let _e6386 = global_7.member[bitcast<u32>(select(0i, _e6381, (_e6381 > 0i)))];
let _e6387 = local_10;
let _e6390 = local_11;
let _e6391 = (_e6379 + _e6390);
let _e6393 = select(_e6163, _e6391, (_e6391 < _e6163));
let _e6398 = global_7.member[bitcast<u32>(select(0i, _e6393, (_e6393 > 0i)))];
let _e6399 = local_10;
let _e6402 = (1f - _e6345);
let _e6404 = (_e6379 + _e6364);
let _e6406 = select(_e6163, _e6404, (_e6404 < _e6163));
let _e6411 = global_7.member[bitcast<u32>(select(0i, _e6406, (_e6406 > 0i)))];
let _e6412 = local_10;
let _e6415 = local_11;
let _e6416 = (_e6404 + _e6415);
let _e6418 = select(_e6163, _e6416, (_e6416 < _e6163));
let _e6423 = global_7.member[bitcast<u32>(select(0i, _e6418, (_e6418 > 0i)))];
let _e6424 = local_10;
let _e6429 = (_e6379 + (((_e6371 - _e6341) * _e6033) * _e6037));
let _e6431 = select(_e6163, _e6429, (_e6429 < _e6163));
let _e6436 = global_7.member[bitcast<u32>(select(0i, _e6431, (_e6431 > 0i)))];
let _e6437 = local_10;
let _e6440 = local_11;
let _e6441 = (_e6429 + _e6440);
let _e6443 = select(_e6163, _e6441, (_e6441 < _e6163));
let _e6448 = global_7.member[bitcast<u32>(select(0i, _e6443, (_e6443 > 0i)))];
let _e6449 = local_10;
let _e6453 = (_e6429 + _e6364);
let _e6455 = select(_e6163, _e6453, (_e6453 < _e6163));
let _e6460 = global_7.member[bitcast<u32>(select(0i, _e6455, (_e6455 > 0i)))];
let _e6461 = local_10;
let _e6464 = local_11;
let _e6465 = (_e6453 + _e6464);
let _e6467 = select(_e6163, _e6465, (_e6465 < _e6163));
let _e6472 = global_7.member[bitcast<u32>(select(0i, _e6467, (_e6467 > 0i)))];
let _e6473 = local_10;
phi_9890_ = (_e6009 + 1u);
phi_9893_ = (_e6011 + ((0.5f * (((((((_e6170 * (1f - _e6171)) + (_e6182 * _e6183)) * _e6186) + (((_e6195 * (1f - _e6196)) + (_e6207 * _e6208)) * _e6123)) * (1f - _e6125)) + (((((_e6220 * (1f - _e6221)) + (_e6232 * _e6233)) * _e6186) + (((_e6244 * (1f - _e6245)) + (_e6256 * _e6257)) * _e6123)) * _e6125)) + ((((((_e6386 * (1f - _e6387)) + (_e6398 * _e6399)) * _e6402) + (((_e6411 * (1f - _e6412)) + (_e6423 * _e6424)) * _e6345)) * (1f - _e6347)) + (((((_e6436 * (1f - _e6437)) + (_e6448 * _e6449)) * _e6402) + (((_e6460 * (1f - _e6461)) + (_e6472 * _e6473)) * _e6345)) * _e6347)))) * _e6021));
} else {
phi_9890_ = u32();
phi_9893_ = f32();
}
let _e6488 = phi_9890_;
let _e6490 = phi_9893_;
continue;
continuing {
phi_9889_ = _e6488;
phi_9892_ = _e6490;
break if !(_e6014);
}
}
let _e10954 = local_79;
phi_10608_ = _e10954;
}
let _e6493 = phi_10608_;
let _e6494 = (_e6493 + select((_e2180 + (_e3306 * (0.5f + (0.5f * _e2471)))), select(0f, _e5573, (_e5573 > 0f)), _e852));
let _e6496 = -((_e4266.member * _e6494));
let _e6498 = select(-87f, _e6496, (_e6496 > -87f));
let _e6500 = select(88f, _e6498, (_e6498 < 88f));
let _e6502 = ((_e6500 * 1.442695f) + 0.5f);
let _e6504 = select(-127f, _e6502, (_e6502 > -127f));
let _e6506 = select(128f, _e6504, (_e6504 < 128f));
let _e6513 = select(0i, select(select(i32(_e6506), i32(-2147483648), (_e6506 < -2147483600f)), 2147483647i, (_e6506 > 2147483500f)), (_e6506 == _e6506));
let _e6517 = (_e6513 - select(0i, 1i, (_e6506 < f32(_e6513))));
let _e6518 = f32(_e6517);
let _e6522 = ((_e6500 - (_e6518 * 0.6933594f)) - (_e6518 * -2.1219444e-4f));
let _e6544 = -((_e4266.member_1 * _e6494));
let _e6546 = select(-87f, _e6544, (_e6544 > -87f));
let _e6548 = select(88f, _e6546, (_e6546 < 88f));
let _e6550 = ((_e6548 * 1.442695f) + 0.5f);
let _e6552 = select(-127f, _e6550, (_e6550 > -127f));
let _e6554 = select(128f, _e6552, (_e6552 < 128f));
let _e6561 = select(0i, select(select(i32(_e6554), i32(-2147483648), (_e6554 < -2147483600f)), 2147483647i, (_e6554 > 2147483500f)), (_e6554 == _e6554));
let _e6565 = (_e6561 - select(0i, 1i, (_e6554 < f32(_e6561))));
let _e6566 = f32(_e6565);
let _e6570 = ((_e6548 - (_e6566 * 0.6933594f)) - (_e6566 * -2.1219444e-4f));
let _e6592 = -((_e4266.member_2 * _e6494));
let _e6594 = select(-87f, _e6592, (_e6592 > -87f));
let _e6596 = select(88f, _e6594, (_e6594 < 88f));
let _e6598 = ((_e6596 * 1.442695f) + 0.5f);
let _e6600 = select(-127f, _e6598, (_e6598 > -127f));
let _e6602 = select(128f, _e6600, (_e6600 < 128f));
let _e6609 = select(0i, select(select(i32(_e6602), i32(-2147483648), (_e6602 < -2147483600f)), 2147483647i, (_e6602 > 2147483500f)), (_e6602 == _e6602));
let _e6613 = (_e6609 - select(0i, 1i, (_e6602 < f32(_e6609))));
let _e6614 = f32(_e6613);
let _e6618 = ((_e6596 - (_e6614 * 0.6933594f)) - (_e6614 * -2.1219444e-4f));
let _e6644 = -((((_e5919.member.x * _e511) + (_e5919.member.y * _e522)) + (_e5919.member.z * _e533)));
let _e6646 = (_e4424 - (_e4425 * _e6644));
let _e6648 = select(1e-9f, _e6646, (_e6646 > 1e-9f));
let _e6661 = ((3.1415927f * (select((_e4430 / (_e6648 * sqrt(select(0f, _e6648, (_e6648 > 0f))))), (0.75f * (1f + (_e6644 * _e6644))), _e4442) * _e4444)) * (_e2488 * _e2746));
let _e6675 = (_e2762 - _e845);
if _e3325 {
let _e7014 = global_1.member.member_10.member_1;
phi_11423_ = type_26(vec3<f32>(_e7014.member, _e7014.member_1, _e7014.member_2), _e3321);
} else {
let _e6684 = (_e2771.x - _e3674.member);
let _e6686 = (_e2771.y - _e3674.member_1);
let _e6688 = (_e2771.z - _e3674.member_2);
let _e6693 = (((_e6684 * _e6684) + (_e6686 * _e6686)) + (_e6688 * _e6688));
let _e6695 = select(1e-12f, _e6693, (_e6693 > 1e-12f));
let _e6696 = (1f / _e6695);
let _e6700 = vec3<f32>((_e3317.member * _e6696), (_e3317.member_1 * _e6696), (_e3317.member_2 * _e6696));
if (_e3324 == 2u) {
let _e6704 = global_1.member.member_10.member_1;
let _e6712 = (((_e6704.member * _e6684) + (_e6704.member_1 * _e6686)) + (_e6704.member_2 * _e6688));
let _e6715 = (1f / select(1e-20f, _e6712, (_e6712 > 1e-20f)));
let _e6719 = global_1.member.member_10.member_4.member;
let _e6728 = ((((_e6719.member * _e6684) + (_e6719.member_1 * _e6686)) + (_e6719.member_2 * _e6688)) * _e6715);
let _e6732 = global_1.member.member_10.member_4.member_1;
let _e6741 = ((((_e6732.member * _e6684) + (_e6732.member_1 * _e6686)) + (_e6732.member_2 * _e6688)) * _e6715);
let _e6745 = global_1.member.member_10.member_4.member_2;
let _e6748 = ((_e6728 * _e6728) + (_e6741 * _e6741));
let _e6756 = global_1.member.member_10.member_4.member_3;
let _e6757 = ((_e6745 - sqrt(select(0f, _e6748, (_e6748 > 0f)))) * _e6756);
let _e6759 = select(0f, _e6757, (_e6757 > 0f));
let _e6761 = select(1f, _e6759, (_e6759 < 1f));
let _e6767 = select(0f, ((_e6761 * _e6761) * (3f - (2f * _e6761))), (_e6712 > 0f));
let _e6771 = global_1.member.member_10.member_4.member_5;
if ((_e6771 > 0u) && (_e6767 > 0f)) {
let _e6776 = (0.5f / _e6745);
let _e6785 = global_1.member.member_10.member_4.member_6;
let _e6786 = bitcast<i32>(_e6785);
local_9 = bitcast<i32>(_e6771);
let _e6787 = local_9;
let _e6789 = f32((_e6787 - 1i));
let _e6791 = f32((_e6786 - 1i));
let _e6792 = local_9;
let _e6795 = (((0.5f + (_e6728 * _e6776)) * f32(_e6792)) - 0.5f);
let _e6797 = select(0f, _e6795, (_e6795 > 0f));
let _e6799 = select(_e6789, _e6797, (_e6797 < _e6789));
let _e6802 = (((0.5f - (_e6741 * _e6776)) * f32(_e6786)) - 0.5f);
let _e6804 = select(0f, _e6802, (_e6802 > 0f));
let _e6806 = select(_e6791, _e6804, (_e6804 < _e6791));
let _e6808 = select(0f, _e6799, (_e6799 > 0f));
let _e6810 = select(_e6789, _e6808, (_e6808 < _e6789));
let _e6817 = select(0i, select(select(i32(_e6810), i32(-2147483648), (_e6810 < -2147483600f)), 2147483647i, (_e6810 > 2147483500f)), (_e6810 == _e6810));
let _e6821 = (_e6817 - select(0i, 1i, (_e6810 < f32(_e6817))));
let _e6823 = select(0f, _e6806, (_e6806 > 0f));
let _e6825 = select(_e6791, _e6823, (_e6823 < _e6791));
let _e6832 = select(0i, select(select(i32(_e6825), i32(-2147483648), (_e6825 < -2147483600f)), 2147483647i, (_e6825 > 2147483500f)), (_e6825 == _e6825));
let _e6836 = (_e6832 - select(0i, 1i, (_e6825 < f32(_e6832))));
let _e6838 = (_e6799 - f32(_e6821));
let _e6840 = (_e6806 - f32(_e6836));
let _e6841 = (_e6821 + 1i);
let _e6842 = local_9;
let _e6844 = select(_e6821, _e6841, (_e6841 < _e6842));
let _e6845 = (_e6836 + 1i);
let _e6847 = select(_e6836, _e6845, (_e6845 < _e6786));
let _e6851 = global_1.member.member_10.member_4.member_4;
let _e6852 = bitcast<i32>(_e6851);
let _e6853 = local_9;
let _e6857 = (_e6852 + (3i * ((_e6836 * _e6853) + _e6821)));
let _e6859 = (bitcast<i32>(_e179) - 1i);
let _e6861 = select(_e6859, _e6857, (_e6857 < _e6859));
let _e6866 = global_3.member[bitcast<u32>(select(0i, _e6861, (_e6861 > 0i)))];
let _e6867 = (_e6857 + 1i);
let _e6869 = select(_e6859, _e6867, (_e6867 < _e6859));
let _e6874 = global_3.member[bitcast<u32>(select(0i, _e6869, (_e6869 > 0i)))];
let _e6875 = (_e6857 + 2i);
let _e6877 = select(_e6859, _e6875, (_e6875 < _e6859));
let _e6882 = global_3.member[bitcast<u32>(select(0i, _e6877, (_e6877 > 0i)))];
let _e6883 = local_9;
let _e6887 = (_e6852 + (3i * ((_e6836 * _e6883) + _e6844)));
let _e6889 = select(_e6859, _e6887, (_e6887 < _e6859));
let _e6894 = global_3.member[bitcast<u32>(select(0i, _e6889, (_e6889 > 0i)))];
let _e6895 = (_e6887 + 1i);
let _e6897 = select(_e6859, _e6895, (_e6895 < _e6859));
let _e6902 = global_3.member[bitcast<u32>(select(0i, _e6897, (_e6897 > 0i)))];
let _e6903 = (_e6887 + 2i);
let _e6905 = select(_e6859, _e6903, (_e6903 < _e6859));
let _e6910 = global_3.member[bitcast<u32>(select(0i, _e6905, (_e6905 > 0i)))];
let _e6911 = local_9;
let _e6915 = (_e6852 + (3i * ((_e6847 * _e6911) + _e6821)));
let _e6917 = select(_e6859, _e6915, (_e6915 < _e6859));
let _e6922 = global_3.member[bitcast<u32>(select(0i, _e6917, (_e6917 > 0i)))];
let _e6923 = (_e6915 + 1i);
let _e6925 = select(_e6859, _e6923, (_e6923 < _e6859));
let _e6930 = global_3.member[bitcast<u32>(select(0i, _e6925, (_e6925 > 0i)))];
let _e6931 = (_e6915 + 2i);
let _e6933 = select(_e6859, _e6931, (_e6931 < _e6859));
let _e6938 = global_3.member[bitcast<u32>(select(0i, _e6933, (_e6933 > 0i)))];
let _e6939 = local_9;
let _e6943 = (_e6852 + (3i * ((_e6847 * _e6939) + _e6844)));
let _e6945 = select(_e6859, _e6943, (_e6943 < _e6859));
let _e6950 = global_3.member[bitcast<u32>(select(0i, _e6945, (_e6945 > 0i)))];
let _e6951 = (_e6943 + 1i);
let _e6953 = select(_e6859, _e6951, (_e6951 < _e6859));
let _e6958 = global_3.member[bitcast<u32>(select(0i, _e6953, (_e6953 > 0i)))];
let _e6959 = (_e6943 + 2i);
let _e6961 = select(_e6859, _e6959, (_e6959 < _e6859));
let _e6966 = global_3.member[bitcast<u32>(select(0i, _e6961, (_e6961 > 0i)))];
let _e6973 = (_e6866 + ((_e6894 - _e6866) * _e6838));
let _e6974 = (_e6874 + ((_e6902 - _e6874) * _e6838));
let _e6975 = (_e6882 + ((_e6910 - _e6882) * _e6838));
phi_11407_ = vec3<f32>(((_e6973 + (((_e6922 + ((_e6950 - _e6922) * _e6838)) - _e6973) * _e6840)) * _e6767), ((_e6974 + (((_e6930 + ((_e6958 - _e6930) * _e6838)) - _e6974) * _e6840)) * _e6767), ((_e6975 + (((_e6938 + ((_e6966 - _e6938) * _e6838)) - _e6975) * _e6840)) * _e6767));
} else {
phi_11407_ = vec3(_e6767);
}
let _e6999 = phi_11407_;
phi_11410_ = (_e6700 * _e6999);
} else {
phi_11410_ = _e6700;
}
let _e7002 = phi_11410_;
let _e7006 = (1f / sqrt(select(0f, _e6695, (_e6695 > 0f))));
phi_11423_ = type_26(vec3<f32>((_e6684 * _e7006), (_e6686 * _e7006), (_e6688 * _e7006)), _e7002);
}
let _e7021 = phi_11423_;
let _e7024 = (_e3674.member - _e2771.x);
let _e7026 = (_e3674.member_1 - _e2771.y);
let _e7028 = (_e3674.member_2 - _e2771.z);
let _e7033 = (((_e7024 * _e7024) + (_e7026 * _e7026)) + (_e7028 * _e7028));
let _e7037 = select(sqrt(select(0f, _e7033, (_e7033 > 0f))), 1e30f, _e3325);
let _e7039 = -(_e7021.member.x);
let _e7041 = -(_e7021.member.y);
let _e7043 = -(_e7021.member.z);
let _e7051 = (1f / select(_e7039, select(1e-12f, -1e-12f, (_e7039 < 0f)), (bitcast<f32>((bitcast<u32>(_e7039) & 2147483647u)) < 1e-12f)));
let _e7059 = (1f / select(_e7041, select(1e-12f, -1e-12f, (_e7041 < 0f)), (bitcast<f32>((bitcast<u32>(_e7041) & 2147483647u)) < 1e-12f)));
let _e7067 = (1f / select(_e7043, select(1e-12f, -1e-12f, (_e7043 < 0f)), (bitcast<f32>((bitcast<u32>(_e7043) & 2147483647u)) < 1e-12f)));
let _e7069 = ((_e3725.member - _e2771.x) * _e7051);
let _e7071 = ((_e3731.member - _e2771.x) * _e7051);
let _e7073 = ((_e3725.member_1 - _e2771.y) * _e7059);
let _e7075 = ((_e3731.member_1 - _e2771.y) * _e7059);
let _e7077 = ((_e3725.member_2 - _e2771.z) * _e7067);
let _e7079 = ((_e3731.member_2 - _e2771.z) * _e7067);
let _e7081 = select(_e7071, _e7069, (_e7069 < _e7071));
let _e7083 = select(_e7075, _e7073, (_e7073 < _e7075));
let _e7085 = select(_e7083, _e7081, (_e7081 > _e7083));
let _e7087 = select(_e7079, _e7077, (_e7077 < _e7079));
let _e7089 = select(_e7087, _e7085, (_e7085 > _e7087));
let _e7091 = select(_e7071, _e7069, (_e7069 > _e7071));
let _e7093 = select(_e7075, _e7073, (_e7073 > _e7075));
let _e7095 = select(_e7093, _e7091, (_e7091 < _e7093));
let _e7097 = select(_e7079, _e7077, (_e7077 > _e7079));
let _e7099 = select(_e7097, _e7095, (_e7095 < _e7097));
let _e7101 = select(0f, _e7089, (_e7089 > 0f));
let _e7103 = select(_e7037, _e7099, (_e7099 < _e7037));
let _e7104 = (_e7103 > _e7101);
let _e7105 = select(0f, _e7101, _e7104);
let _e7107 = (select(0f, _e7103, _e7104) - _e7105);
if _e2220 {
phi_12338_ = _e7107;
} else {
let _e7109 = (_e7107 / f32(_e2219));
phi_11619_ = 0u;
phi_11622_ = 0f;
loop {
let _e7111 = phi_11619_;
let _e7113 = phi_11622_;
local_80 = _e7113;
let _e7116 = ((_e7111 < _e2219) && (_e7107 > 0f));
if _e7116 {
let _e7119 = (_e7105 + (_e7109 * f32(_e7111)));
let _e7120 = (_e7119 + _e7109);
let _e7122 = (0.5f * (_e7119 + _e7120));
let _e7123 = (_e7120 - _e7119);
let _e7124 = (0.28867513f * _e7123);
let _e7125 = (_e7122 - _e7124);
let _e7134 = global_1.member.member_13.member_7;
let _e7135 = bitcast<i32>(_e7134);
let _e7138 = global_1.member.member_13.member_8;
let _e7139 = bitcast<i32>(_e7138);
let _e7142 = global_1.member.member_13.member_9;
let _e7143 = bitcast<i32>(_e7142);
let _e7144 = f32(_e7135);
let _e7146 = (_e3731.member - _e3725.member);
let _e7149 = (((((_e2771.x + (_e7039 * _e7125)) - _e3725.member) / _e7146) * _e7144) - 0.5f);
let _e7150 = (_e7144 - 1f);
let _e7152 = select(0f, _e7149, (_e7149 > 0f));
let _e7154 = select(_e7150, _e7152, (_e7152 < _e7150));
let _e7155 = f32(_e7139);
let _e7157 = (_e3731.member_1 - _e3725.member_1);
let _e7160 = (((((_e2771.y + (_e7041 * _e7125)) - _e3725.member_1) / _e7157) * _e7155) - 0.5f);
let _e7161 = (_e7155 - 1f);
let _e7163 = select(0f, _e7160, (_e7160 > 0f));
let _e7165 = select(_e7161, _e7163, (_e7163 < _e7161));
let _e7166 = f32(_e7143);
let _e7168 = (_e3731.member_2 - _e3725.member_2);
let _e7171 = (((((_e2771.z + (_e7043 * _e7125)) - _e3725.member_2) / _e7168) * _e7166) - 0.5f);
let _e7172 = (_e7166 - 1f);
let _e7174 = select(0f, _e7171, (_e7171 > 0f));
let _e7176 = select(_e7172, _e7174, (_e7174 < _e7172));
let _e7178 = select(0f, _e7154, (_e7154 > 0f));
let _e7180 = select(1e6f, _e7178, (_e7178 < 1e6f));
let _e7187 = select(0i, select(select(i32(_e7180), i32(-2147483648), (_e7180 < -2147483600f)), 2147483647i, (_e7180 > 2147483500f)), (_e7180 == _e7180));
let _e7191 = (_e7187 - select(0i, 1i, (_e7180 < f32(_e7187))));
let _e7193 = select(0f, _e7165, (_e7165 > 0f));
let _e7195 = select(1e6f, _e7193, (_e7193 < 1e6f));
let _e7202 = select(0i, select(select(i32(_e7195), i32(-2147483648), (_e7195 < -2147483600f)), 2147483647i, (_e7195 > 2147483500f)), (_e7195 == _e7195));
let _e7206 = (_e7202 - select(0i, 1i, (_e7195 < f32(_e7202))));
let _e7208 = select(0f, _e7176, (_e7176 > 0f));
let _e7210 = select(1e6f, _e7208, (_e7208 < 1e6f));
let _e7217 = select(0i, select(select(i32(_e7210), i32(-2147483648), (_e7210 < -2147483600f)), 2147483647i, (_e7210 > 2147483500f)), (_e7210 == _e7210));
let _e7221 = (_e7217 - select(0i, 1i, (_e7210 < f32(_e7217))));
let _e7225 = (_e7165 - f32(_e7206));
let _e7227 = (_e7176 - f32(_e7221));
local_7 = (_e7154 - f32(_e7191));
let _e7228 = (_e7191 + 1i);
let _e7230 = select(_e7228, 0i, (_e7228 < 0i));
if (_e7230 >= _e7135) {
phi_11760_ = (_e7135 - 1i);
} else {
phi_11760_ = _e7230;
}
let _e7234 = phi_11760_;
local_8 = (_e7234 - _e7191);
let _e7236 = (_e7206 + 1i);
let _e7238 = select(_e7236, 0i, (_e7236 < 0i));
if (_e7238 >= _e7139) {
phi_11773_ = (_e7139 - 1i);
} else {
phi_11773_ = _e7238;
}
let _e7242 = phi_11773_;
let _e7244 = ((_e7242 - _e7206) * _e7135);
let _e7245 = (_e7221 + 1i);
let _e7247 = select(_e7245, 0i, (_e7245 < 0i));
if (_e7247 >= _e7143) {
phi_11787_ = (_e7143 - 1i);
} else {
phi_11787_ = _e7247;
}
let _e7251 = phi_11787_;
let _e7257 = global_1.member.member_13.member_10;
let _e7258 = bitcast<i32>(_e7257);
let _e7263 = ((_e7258 + (((_e7221 * _e7139) + _e7206) * _e7135)) + _e7191);
let _e7265 = (bitcast<i32>(_e186) - 1i);
let _e7267 = select(_e7265, _e7263, (_e7263 < _e7265));
let _e7272 = global_7.member[bitcast<u32>(select(0i, _e7267, (_e7267 > 0i)))];
let _e7273 = local_7;
let _e7276 = local_8;
let _e7277 = (_e7263 + _e7276);
let _e7279 = select(_e7265, _e7277, (_e7277 < _e7265));
let _e7284 = global_7.member[bitcast<u32>(select(0i, _e7279, (_e7279 > 0i)))];
let _e7285 = local_7;
let _e7288 = (1f - _e7225);
let _e7290 = (_e7263 + _e7244);
let _e7292 = select(_e7265, _e7290, (_e7290 < _e7265));
let _e7297 = global_7.member[bitcast<u32>(select(0i, _e7292, (_e7292 > 0i)))];
let _e7298 = local_7;
let _e7301 = local_8;
let _e7302 = (_e7290 + _e7301);
let _e7304 = select(_e7265, _e7302, (_e7302 < _e7265));
let _e7309 = global_7.member[bitcast<u32>(select(0i, _e7304, (_e7304 > 0i)))];
let _e7310 = local_7;
let _e7315 = (_e7263 + (((_e7251 - _e7221) * _e7135) * _e7139));
let _e7317 = select(_e7265, _e7315, (_e7315 < _e7265));
let _e7322 = global_7.member[bitcast<u32>(select(0i, _e7317, (_e7317 > 0i)))];
let _e7323 = local_7;
let _e7326 = local_8;
let _e7327 = (_e7315 + _e7326);
let _e7329 = select(_e7265, _e7327, (_e7327 < _e7265));
let _e7334 = global_7.member[bitcast<u32>(select(0i, _e7329, (_e7329 > 0i)))];
let _e7335 = local_7;
let _e7339 = (_e7315 + _e7244);
let _e7341 = select(_e7265, _e7339, (_e7339 < _e7265));
let _e7346 = global_7.member[bitcast<u32>(select(0i, _e7341, (_e7341 > 0i)))];
let _e7347 = local_7;
let _e7350 = local_8;
let _e7351 = (_e7339 + _e7350);
let _e7353 = select(_e7265, _e7351, (_e7351 < _e7265));
let _e7358 = global_7.member[bitcast<u32>(select(0i, _e7353, (_e7353 > 0i)))];
let _e7359 = local_7;
let _e7368 = (_e7122 + _e7124);
let _e7378 = (((((_e2771.x + (_e7039 * _e7368)) - _e3725.member) / _e7146) * _e7144) - 0.5f);
let _e7380 = select(0f, _e7378, (_e7378 > 0f));
let _e7382 = select(_e7150, _e7380, (_e7380 < _e7150));
let _e7386 = (((((_e2771.y + (_e7041 * _e7368)) - _e3725.member_1) / _e7157) * _e7155) - 0.5f);
let _e7388 = select(0f, _e7386, (_e7386 > 0f));
let _e7390 = select(_e7161, _e7388, (_e7388 < _e7161));
let _e7394 = (((((_e2771.z + (_e7043 * _e7368)) - _e3725.member_2) / _e7168) * _e7166) - 0.5f);
let _e7396 = select(0f, _e7394, (_e7394 > 0f));
let _e7398 = select(_e7172, _e7396, (_e7396 < _e7172));
let _e7400 = select(0f, _e7382, (_e7382 > 0f));
let _e7402 = select(1e6f, _e7400, (_e7400 < 1e6f));
let _e7409 = select(0i, select(select(i32(_e7402), i32(-2147483648), (_e7402 < -2147483600f)), 2147483647i, (_e7402 > 2147483500f)), (_e7402 == _e7402));
let _e7413 = (_e7409 - select(0i, 1i, (_e7402 < f32(_e7409))));
let _e7415 = select(0f, _e7390, (_e7390 > 0f));
let _e7417 = select(1e6f, _e7415, (_e7415 < 1e6f));
let _e7424 = select(0i, select(select(i32(_e7417), i32(-2147483648), (_e7417 < -2147483600f)), 2147483647i, (_e7417 > 2147483500f)), (_e7417 == _e7417));
let _e7428 = (_e7424 - select(0i, 1i, (_e7417 < f32(_e7424))));
let _e7430 = select(0f, _e7398, (_e7398 > 0f));
let _e7432 = select(1e6f, _e7430, (_e7430 < 1e6f));
let _e7439 = select(0i, select(select(i32(_e7432), i32(-2147483648), (_e7432 < -2147483600f)), 2147483647i, (_e7432 > 2147483500f)), (_e7432 == _e7432));
let _e7443 = (_e7439 - select(0i, 1i, (_e7432 < f32(_e7439))));
let _e7447 = (_e7390 - f32(_e7428));
let _e7449 = (_e7398 - f32(_e7443));
local_5 = (_e7382 - f32(_e7413));
let _e7450 = (_e7413 + 1i);
let _e7452 = select(_e7450, 0i, (_e7450 < 0i));
if (_e7452 >= _e7135) {
phi_12106_ = (_e7135 - 1i);
} else {
phi_12106_ = _e7452;
}
let _e7456 = phi_12106_;
local_6 = (_e7456 - _e7413);
let _e7458 = (_e7428 + 1i);
let _e7460 = select(_e7458, 0i, (_e7458 < 0i));
if (_e7460 >= _e7139) {
phi_12119_ = (_e7139 - 1i);
} else {
phi_12119_ = _e7460;
}
let _e7464 = phi_12119_;
let _e7466 = ((_e7464 - _e7428) * _e7135);
let _e7467 = (_e7443 + 1i);
let _e7469 = select(_e7467, 0i, (_e7467 < 0i));
if (_e7469 >= _e7143) {
phi_12133_ = (_e7143 - 1i);
} else {
phi_12133_ = _e7469;
}
let _e7473 = phi_12133_;
let _e7481 = ((_e7258 + (((_e7443 * _e7139) + _e7428) * _e7135)) + _e7413);
let _e7483 = select(_e7265, _e7481, (_e7481 < _e7265));
let _e7488 = global_7.member[bitcast<u32>(select(0i, _e7483, (_e7483 > 0i)))];
let _e7489 = local_5;
let _e7492 = local_6;
let _e7493 = (_e7481 + _e7492);
let _e7495 = select(_e7265, _e7493, (_e7493 < _e7265));
let _e7500 = global_7.member[bitcast<u32>(select(0i, _e7495, (_e7495 > 0i)))];
let _e7501 = local_5;
let _e7504 = (1f - _e7447);
let _e7506 = (_e7481 + _e7466);
let _e7508 = select(_e7265, _e7506, (_e7506 < _e7265));
let _e7513 = global_7.member[bitcast<u32>(select(0i, _e7508, (_e7508 > 0i)))];
let _e7514 = local_5;
let _e7517 = local_6;
let _e7518 = (_e7506 + _e7517);
let _e7520 = select(_e7265, _e7518, (_e7518 < _e7265));
let _e7525 = global_7.member[bitcast<u32>(select(0i, _e7520, (_e7520 > 0i)))];
let _e7526 = local_5;
let _e7531 = (_e7481 + (((_e7473 - _e7443) * _e7135) * _e7139));
let _e7533 = select(_e7265, _e7531, (_e7531 < _e7265));
let _e7538 = global_7.member[bitcast<u32>(select(0i, _e7533, (_e7533 > 0i)))];
let _e7539 = local_5;
let _e7542 = local_6;
let _e7543 = (_e7531 + _e7542);
let _e7545 = select(_e7265, _e7543, (_e7543 < _e7265));
let _e7550 = global_7.member[bitcast<u32>(select(0i, _e7545, (_e7545 > 0i)))];
let _e7551 = local_5;
let _e7555 = (_e7531 + _e7466);
let _e7557 = select(_e7265, _e7555, (_e7555 < _e7265));
let _e7562 = global_7.member[bitcast<u32>(select(0i, _e7557, (_e7557 > 0i)))];
let _e7563 = local_5;
let _e7566 = local_6;
let _e7567 = (_e7555 + _e7566);
let _e7569 = select(_e7265, _e7567, (_e7567 < _e7265));
let _e7574 = global_7.member[bitcast<u32>(select(0i, _e7569, (_e7569 > 0i)))];
let _e7575 = local_5;
phi_11620_ = (_e7111 + 1u);
phi_11623_ = (_e7113 + ((0.5f * (((((((_e7272 * (1f - _e7273)) + (_e7284 * _e7285)) * _e7288) + (((_e7297 * (1f - _e7298)) + (_e7309 * _e7310)) * _e7225)) * (1f - _e7227)) + (((((_e7322 * (1f - _e7323)) + (_e7334 * _e7335)) * _e7288) + (((_e7346 * (1f - _e7347)) + (_e7358 * _e7359)) * _e7225)) * _e7227)) + ((((((_e7488 * (1f - _e7489)) + (_e7500 * _e7501)) * _e7504) + (((_e7513 * (1f - _e7514)) + (_e7525 * _e7526)) * _e7447)) * (1f - _e7449)) + (((((_e7538 * (1f - _e7539)) + (_e7550 * _e7551)) * _e7504) + (((_e7562 * (1f - _e7563)) + (_e7574 * _e7575)) * _e7447)) * _e7449)))) * _e7123));
} else {
phi_11620_ = u32();
phi_11623_ = f32();
}
let _e7590 = phi_11620_;
let _e7592 = phi_11623_;
continue;
continuing {
phi_11619_ = _e7590;
phi_11622_ = _e7592;
break if !(_e7116);
}
}
let _e10970 = local_80;
phi_12338_ = _e10970;
}
let _e7595 = phi_12338_;
let _e7596 = (_e7595 + select((_e2180 + (_e3306 * (0.5f + (0.5f * 0.33998105f)))), select(0f, _e6675, (_e6675 > 0f)), _e852));
let _e7598 = -((_e4266.member * _e7596));
let _e7600 = select(-87f, _e7598, (_e7598 > -87f));
let _e7602 = select(88f, _e7600, (_e7600 < 88f));
let _e7604 = ((_e7602 * 1.442695f) + 0.5f);
let _e7606 = select(-127f, _e7604, (_e7604 > -127f));
let _e7608 = select(128f, _e7606, (_e7606 < 128f));
let _e7615 = select(0i, select(select(i32(_e7608), i32(-2147483648), (_e7608 < -2147483600f)), 2147483647i, (_e7608 > 2147483500f)), (_e7608 == _e7608));
let _e7619 = (_e7615 - select(0i, 1i, (_e7608 < f32(_e7615))));
let _e7620 = f32(_e7619);
let _e7624 = ((_e7602 - (_e7620 * 0.6933594f)) - (_e7620 * -2.1219444e-4f));
let _e7646 = -((_e4266.member_1 * _e7596));
let _e7648 = select(-87f, _e7646, (_e7646 > -87f));
let _e7650 = select(88f, _e7648, (_e7648 < 88f));
let _e7652 = ((_e7650 * 1.442695f) + 0.5f);
let _e7654 = select(-127f, _e7652, (_e7652 > -127f));
let _e7656 = select(128f, _e7654, (_e7654 < 128f));
let _e7663 = select(0i, select(select(i32(_e7656), i32(-2147483648), (_e7656 < -2147483600f)), 2147483647i, (_e7656 > 2147483500f)), (_e7656 == _e7656));
let _e7667 = (_e7663 - select(0i, 1i, (_e7656 < f32(_e7663))));
let _e7668 = f32(_e7667);
let _e7672 = ((_e7650 - (_e7668 * 0.6933594f)) - (_e7668 * -2.1219444e-4f));
let _e7694 = -((_e4266.member_2 * _e7596));
let _e7696 = select(-87f, _e7694, (_e7694 > -87f));
let _e7698 = select(88f, _e7696, (_e7696 < 88f));
let _e7700 = ((_e7698 * 1.442695f) + 0.5f);
let _e7702 = select(-127f, _e7700, (_e7700 > -127f));
let _e7704 = select(128f, _e7702, (_e7702 < 128f));
let _e7711 = select(0i, select(select(i32(_e7704), i32(-2147483648), (_e7704 < -2147483600f)), 2147483647i, (_e7704 > 2147483500f)), (_e7704 == _e7704));
let _e7715 = (_e7711 - select(0i, 1i, (_e7704 < f32(_e7711))));
let _e7716 = f32(_e7715);
let _e7720 = ((_e7698 - (_e7716 * 0.6933594f)) - (_e7716 * -2.1219444e-4f));
let _e7746 = -((((_e7021.member.x * _e511) + (_e7021.member.y * _e522)) + (_e7021.member.z * _e533)));
let _e7748 = (_e4424 - (_e4425 * _e7746));
let _e7750 = select(1e-9f, _e7748, (_e7748 > 1e-9f));
let _e7763 = ((3.1415927f * (select((_e4430 / (_e7750 * sqrt(select(0f, _e7750, (_e7750 > 0f))))), (0.75f * (1f + (_e7746 * _e7746))), _e4442) * _e4444)) * (_e2763 * _e3021));
let _e7780 = (_e1678 * 0.34785485f);
let _e7790 = (_e1678 * 0.65214515f);
phi_4079_ = (_e2180 + _e3306);
phi_4082_ = vec3<f32>(((_e2182.x + (((((_e3670.member_1.x * ((1f + (_e4297 * (1f + (_e4297 * (0.5f + (_e4297 * (0.16666667f + (_e4297 * (0.041666668f + (_e4297 * (0.008333334f + (_e4297 * (0.001388889f + (_e4297 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4292 + 127i)) << bitcast<u32>(23i))))) * _e4458.member) * _e4448) + (((_e4814.member_1.x * ((1f + (_e5417 * (1f + (_e5417 * (0.5f + (_e5417 * (0.16666667f + (_e5417 * (0.041666668f + (_e5417 * (0.008333334f + (_e5417 * (0.001388889f + (_e5417 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5412 + 127i)) << bitcast<u32>(23i))))) * _e4458.member) * _e5556)) * _e7780)) + (((((_e5919.member_1.x * ((1f + (_e6522 * (1f + (_e6522 * (0.5f + (_e6522 * (0.16666667f + (_e6522 * (0.041666668f + (_e6522 * (0.008333334f + (_e6522 * (0.001388889f + (_e6522 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6517 + 127i)) << bitcast<u32>(23i))))) * _e4458.member) * _e6661) + (((_e7021.member_1.x * ((1f + (_e7624 * (1f + (_e7624 * (0.5f + (_e7624 * (0.16666667f + (_e7624 * (0.041666668f + (_e7624 * (0.008333334f + (_e7624 * (0.001388889f + (_e7624 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7619 + 127i)) << bitcast<u32>(23i))))) * _e4458.member) * _e7763)) * _e7790)), ((_e2182.y + (((((_e3670.member_1.y * ((1f + (_e4345 * (1f + (_e4345 * (0.5f + (_e4345 * (0.16666667f + (_e4345 * (0.041666668f + (_e4345 * (0.008333334f + (_e4345 * (0.001388889f + (_e4345 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4340 + 127i)) << bitcast<u32>(23i))))) * _e4458.member_1) * _e4448) + (((_e4814.member_1.y * ((1f + (_e5465 * (1f + (_e5465 * (0.5f + (_e5465 * (0.16666667f + (_e5465 * (0.041666668f + (_e5465 * (0.008333334f + (_e5465 * (0.001388889f + (_e5465 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5460 + 127i)) << bitcast<u32>(23i))))) * _e4458.member_1) * _e5556)) * _e7780)) + (((((_e5919.member_1.y * ((1f + (_e6570 * (1f + (_e6570 * (0.5f + (_e6570 * (0.16666667f + (_e6570 * (0.041666668f + (_e6570 * (0.008333334f + (_e6570 * (0.001388889f + (_e6570 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6565 + 127i)) << bitcast<u32>(23i))))) * _e4458.member_1) * _e6661) + (((_e7021.member_1.y * ((1f + (_e7672 * (1f + (_e7672 * (0.5f + (_e7672 * (0.16666667f + (_e7672 * (0.041666668f + (_e7672 * (0.008333334f + (_e7672 * (0.001388889f + (_e7672 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7667 + 127i)) << bitcast<u32>(23i))))) * _e4458.member_1) * _e7763)) * _e7790)), ((_e2182.z + (((((_e3670.member_1.z * ((1f + (_e4393 * (1f + (_e4393 * (0.5f + (_e4393 * (0.16666667f + (_e4393 * (0.041666668f + (_e4393 * (0.008333334f + (_e4393 * (0.001388889f + (_e4393 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4388 + 127i)) << bitcast<u32>(23i))))) * _e4458.member_2) * _e4448) + (((_e4814.member_1.z * ((1f + (_e5513 * (1f + (_e5513 * (0.5f + (_e5513 * (0.16666667f + (_e5513 * (0.041666668f + (_e5513 * (0.008333334f + (_e5513 * (0.001388889f + (_e5513 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5508 + 127i)) << bitcast<u32>(23i))))) * _e4458.member_2) * _e5556)) * _e7780)) + (((((_e5919.member_1.z * ((1f + (_e6618 * (1f + (_e6618 * (0.5f + (_e6618 * (0.16666667f + (_e6618 * (0.041666668f + (_e6618 * (0.008333334f + (_e6618 * (0.001388889f + (_e6618 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6613 + 127i)) << bitcast<u32>(23i))))) * _e4458.member_2) * _e6661) + (((_e7021.member_1.z * ((1f + (_e7720 * (1f + (_e7720 * (0.5f + (_e7720 * (0.16666667f + (_e7720 * (0.041666668f + (_e7720 * (0.008333334f + (_e7720 * (0.001388889f + (_e7720 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7715 + 127i)) << bitcast<u32>(23i))))) * _e4458.member_2) * _e7763)) * _e7790)));
phi_4084_ = (_e2184 + 1i);
} else {
phi_4079_ = f32();
phi_4082_ = vec3<f32>();
phi_4084_ = i32();
}
let _e7801 = phi_4079_;
let _e7803 = phi_4082_;
let _e7805 = phi_4084_;
continue;
continuing {
phi_4078_ = _e7801;
phi_4081_ = _e7803;
phi_4083_ = _e7805;
break if !(_e2185);
}
}
let _e10976 = local_81;
phi_12634_ = _e10976;
} else {
phi_12634_ = vec3<f32>(0f, 0f, 0f);
}
let _e7808 = phi_12634_;
phi_12649_ = type_24(_e471.member, _e471.member_1, _e471.member_2, _e471.member_3, vec3<f32>((_e278 + (_e7808.x * _e767)), (_e289 + (_e7808.y * _e768)), (_e300 + (_e7808.z * _e769))), _e471.member_5, _e471.member_6, _e471.member_7, _e471.member_8);
} else {
phi_12649_ = _e471;
}
let _e7829 = phi_12649_;
let _e7830 = (_e672 == -1i);
let _e7831 = select(_e766, 0f, _e7830);
let _e7835 = (_e762 + (_e511 * _e7831));
let _e7836 = (_e763 + (_e522 * _e7831));
let _e7837 = (_e764 + (_e533 * _e7831));
let _e7838 = vec3<f32>(_e7835, _e7836, _e7837);
let _e7841 = (_e672 >= 0i);
if _e7841 {
let _e7886 = (_e672 * 19i);
let _e7888 = (bitcast<i32>(_e181) - 1i);
let _e7890 = select(_e7888, _e7886, (_e7886 < _e7888));
let _e7896 = global_4.member[bitcast<u32>(select(0i, _e7890, (_e7890 > 0i)))];
let _e7897 = (_e7886 + 1i);
let _e7899 = select(_e7888, _e7897, (_e7897 < _e7888));
let _e7905 = global_4.member[bitcast<u32>(select(0i, _e7899, (_e7899 > 0i)))];
let _e7906 = (_e7886 + 2i);
let _e7908 = select(_e7888, _e7906, (_e7906 < _e7888));
let _e7914 = global_4.member[bitcast<u32>(select(0i, _e7908, (_e7908 > 0i)))];
let _e7915 = (_e7886 + 3i);
let _e7917 = select(_e7888, _e7915, (_e7915 < _e7888));
let _e7923 = global_4.member[bitcast<u32>(select(0i, _e7917, (_e7917 > 0i)))];
let _e7924 = (_e7886 + 4i);
let _e7926 = select(_e7888, _e7924, (_e7924 < _e7888));
let _e7932 = global_4.member[bitcast<u32>(select(0i, _e7926, (_e7926 > 0i)))];
let _e7933 = (_e7886 + 5i);
let _e7935 = select(_e7888, _e7933, (_e7933 < _e7888));
let _e7941 = global_4.member[bitcast<u32>(select(0i, _e7935, (_e7935 > 0i)))];
let _e7942 = (_e7886 + 6i);
let _e7944 = select(_e7888, _e7942, (_e7942 < _e7888));
let _e7950 = global_4.member[bitcast<u32>(select(0i, _e7944, (_e7944 > 0i)))];
let _e7951 = (_e7886 + 7i);
let _e7953 = select(_e7888, _e7951, (_e7951 < _e7888));
let _e7959 = global_4.member[bitcast<u32>(select(0i, _e7953, (_e7953 > 0i)))];
let _e7960 = (_e7886 + 8i);
let _e7962 = select(_e7888, _e7960, (_e7960 < _e7888));
let _e7968 = global_4.member[bitcast<u32>(select(0i, _e7962, (_e7962 > 0i)))];
let _e7969 = (_e7923 - _e7896);
let _e7970 = (_e7932 - _e7905);
let _e7971 = (_e7941 - _e7914);
let _e7972 = (_e7950 - _e7896);
let _e7973 = (_e7959 - _e7905);
let _e7974 = (_e7968 - _e7914);
let _e7977 = ((_e7970 * _e7974) - (_e7971 * _e7973));
let _e7980 = ((_e7971 * _e7972) - (_e7969 * _e7974));
let _e7983 = ((_e7969 * _e7973) - (_e7970 * _e7972));
let _e7984 = (_e7923 - _e7835);
let _e7985 = (_e7932 - _e7836);
let _e7986 = (_e7941 - _e7837);
let _e7987 = (_e7950 - _e7835);
let _e7988 = (_e7959 - _e7836);
let _e7989 = (_e7968 - _e7837);
let _e8003 = (((((_e7985 * _e7989) - (_e7986 * _e7988)) * _e7977) + (((_e7986 * _e7987) - (_e7984 * _e7989)) * _e7980)) + (((_e7984 * _e7988) - (_e7985 * _e7987)) * _e7983));
let _e8005 = select(0f, _e8003, (_e8003 > 0f));
let _e8006 = (_e7896 - _e7835);
let _e8007 = (_e7905 - _e7836);
let _e8008 = (_e7914 - _e7837);
let _e8022 = (((((_e7988 * _e8008) - (_e7989 * _e8007)) * _e7977) + (((_e7989 * _e8006) - (_e7987 * _e8008)) * _e7980)) + (((_e7987 * _e8007) - (_e7988 * _e8006)) * _e7983));
let _e8024 = select(0f, _e8022, (_e8022 > 0f));
let _e8038 = (((((_e8007 * _e7986) - (_e8008 * _e7985)) * _e7977) + (((_e8008 * _e7984) - (_e8006 * _e7986)) * _e7980)) + (((_e8006 * _e7985) - (_e8007 * _e7984)) * _e7983));
let _e8040 = select(0f, _e8038, (_e8038 > 0f));
let _e8042 = ((_e8005 + _e8024) + _e8040);
let _e8044 = select(1e-30f, _e8042, (_e8042 > 1e-30f));
let _e8045 = (_e8005 / _e8044);
let _e8046 = (_e8024 / _e8044);
let _e8047 = (_e8040 / _e8044);
let _e8052 = (((_e7977 * _e7977) + (_e7980 * _e7980)) + (_e7983 * _e7983));
let _e8055 = sqrt(select(0f, _e8052, (_e8052 > 0f)));
let _e8058 = (1f / select(1e-20f, _e8055, (_e8055 > 1e-20f)));
let _e8063 = (_e7886 + 9i);
let _e8065 = select(_e7888, _e8063, (_e8063 < _e7888));
let _e8071 = global_4.member[bitcast<u32>(select(0i, _e8065, (_e8065 > 0i)))];
let _e8072 = (_e7886 + 10i);
let _e8074 = select(_e7888, _e8072, (_e8072 < _e7888));
let _e8080 = global_4.member[bitcast<u32>(select(0i, _e8074, (_e8074 > 0i)))];
let _e8081 = (_e7886 + 11i);
let _e8083 = select(_e7888, _e8081, (_e8081 < _e7888));
let _e8089 = global_4.member[bitcast<u32>(select(0i, _e8083, (_e8083 > 0i)))];
let _e8093 = (_e7886 + 12i);
let _e8095 = select(_e7888, _e8093, (_e8093 < _e7888));
let _e8101 = global_4.member[bitcast<u32>(select(0i, _e8095, (_e8095 > 0i)))];
let _e8102 = (_e7886 + 13i);
let _e8104 = select(_e7888, _e8102, (_e8102 < _e7888));
let _e8110 = global_4.member[bitcast<u32>(select(0i, _e8104, (_e8104 > 0i)))];
let _e8111 = (_e7886 + 14i);
let _e8113 = select(_e7888, _e8111, (_e8111 < _e7888));
let _e8119 = global_4.member[bitcast<u32>(select(0i, _e8113, (_e8113 > 0i)))];
let _e8126 = (_e7886 + 15i);
let _e8128 = select(_e7888, _e8126, (_e8126 < _e7888));
let _e8134 = global_4.member[bitcast<u32>(select(0i, _e8128, (_e8128 > 0i)))];
let _e8135 = (_e7886 + 16i);
let _e8137 = select(_e7888, _e8135, (_e8135 < _e7888));
let _e8143 = global_4.member[bitcast<u32>(select(0i, _e8137, (_e8137 > 0i)))];
let _e8144 = (_e7886 + 17i);
let _e8146 = select(_e7888, _e8144, (_e8144 < _e7888));
let _e8152 = global_4.member[bitcast<u32>(select(0i, _e8146, (_e8146 > 0i)))];
let _e8156 = (((_e8071 * _e8045) + (_e8101 * _e8046)) + (_e8134 * _e8047));
let _e8157 = (((_e8080 * _e8045) + (_e8110 * _e8046)) + (_e8143 * _e8047));
let _e8158 = (((_e8089 * _e8045) + (_e8119 * _e8046)) + (_e8152 * _e8047));
let _e8163 = (((_e8156 * _e8156) + (_e8157 * _e8157)) + (_e8158 * _e8158));
let _e8166 = sqrt(select(0f, _e8163, (_e8163 > 0f)));
let _e8169 = (1f / select(1e-20f, _e8166, (_e8166 > 1e-20f)));
let _e8174 = (_e7886 + 18i);
let _e8176 = select(_e7888, _e8174, (_e8174 < _e7888));
let _e8182 = global_4.member[bitcast<u32>(select(0i, _e8176, (_e8176 > 0i)))];
let _e8191 = (select(select(0i, select(select(i32(_e8182), i32(-2147483648), (_e8182 < -2147483600f)), 2147483647i, (_e8182 > 2147483500f)), (_e8182 == _e8182)), _e672, ((_e1498 & 1u) != 0u)) * 10i);
let _e8193 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e8195 = select(_e8193, _e8191, (_e8191 < _e8193));
let _e8201 = global_5.member[bitcast<u32>(select(0i, _e8195, (_e8195 > 0i)))];
let _e8202 = (_e8191 + 1i);
let _e8204 = select(_e8193, _e8202, (_e8202 < _e8193));
let _e8210 = global_5.member[bitcast<u32>(select(0i, _e8204, (_e8204 > 0i)))];
let _e8211 = (_e8191 + 2i);
let _e8213 = select(_e8193, _e8211, (_e8211 < _e8193));
let _e8219 = global_5.member[bitcast<u32>(select(0i, _e8213, (_e8213 > 0i)))];
let _e8223 = (_e8191 + 3i);
let _e8225 = select(_e8193, _e8223, (_e8223 < _e8193));
let _e8231 = global_5.member[bitcast<u32>(select(0i, _e8225, (_e8225 > 0i)))];
let _e8232 = (_e8191 + 4i);
let _e8234 = select(_e8193, _e8232, (_e8232 < _e8193));
let _e8240 = global_5.member[bitcast<u32>(select(0i, _e8234, (_e8234 > 0i)))];
let _e8241 = (_e8191 + 5i);
let _e8243 = select(_e8193, _e8241, (_e8241 < _e8193));
let _e8249 = global_5.member[bitcast<u32>(select(0i, _e8243, (_e8243 > 0i)))];
let _e8256 = (_e8191 + 6i);
let _e8258 = select(_e8193, _e8256, (_e8256 < _e8193));
let _e8264 = global_5.member[bitcast<u32>(select(0i, _e8258, (_e8258 > 0i)))];
let _e8265 = (_e8191 + 7i);
let _e8267 = select(_e8193, _e8265, (_e8265 < _e8193));
let _e8273 = global_5.member[bitcast<u32>(select(0i, _e8267, (_e8267 > 0i)))];
let _e8274 = (_e8191 + 8i);
let _e8276 = select(_e8193, _e8274, (_e8274 < _e8193));
let _e8282 = global_5.member[bitcast<u32>(select(0i, _e8276, (_e8276 > 0i)))];
let _e8290 = (_e8191 + 9i);
let _e8292 = select(_e8193, _e8290, (_e8290 < _e8193));
let _e8298 = global_5.member[bitcast<u32>(select(0i, _e8292, (_e8292 > 0i)))];
phi_13384_ = type_25(_e7838, vec3<f32>((_e7977 * _e8058), (_e7980 * _e8058), (_e7983 * _e8058)), vec3<f32>((_e8156 * _e8169), (_e8157 * _e8169), (_e8158 * _e8169)), vec3<f32>((((_e8201 * _e8045) + (_e8231 * _e8046)) + (_e8264 * _e8047)), (((_e8210 * _e8045) + (_e8240 * _e8046)) + (_e8273 * _e8047)), (((_e8219 * _e8045) + (_e8249 * _e8046)) + (_e8282 * _e8047))), _e8298, true);
} else {
let _e7842 = (_e672 == -3i);
let _e7848 = global_1.member.member_14.member_1.member.member;
let _e7853 = global_1.member.member_14.member_1.member_1;
let _e7859 = global_1.member.member_14.member.member.member;
let _e7864 = global_1.member.member_14.member.member_1;
let _e7874 = vec3<f32>(select(_e7859.member, _e7848.member, _e7842), select(_e7859.member_1, _e7848.member_1, _e7842), select(_e7859.member_2, _e7848.member_2, _e7842));
phi_13384_ = type_25(_e7838, _e7874, _e7874, vec3<f32>(select(_e7864.member, _e7853.member, _e7842), select(_e7864.member_1, _e7853.member_1, _e7842), select(_e7864.member_2, _e7853.member_2, _e7842)), 0f, false);
}
let _e8301 = phi_13384_;
let _e8304 = ((select(0i, _e672, _e7841) * 19i) + 18i);
let _e8306 = (bitcast<i32>(_e181) - 1i);
let _e8308 = select(_e8306, _e8304, (_e8304 < _e8306));
let _e8314 = global_4.member[bitcast<u32>(select(0i, _e8308, (_e8308 > 0i)))];
let _e8321 = select(0i, select(select(i32(_e8314), i32(-2147483648), (_e8314 < -2147483600f)), 2147483647i, (_e8314 > 2147483500f)), (_e8314 == _e8314));
let _e8322 = (_e8321 * 4i);
let _e8324 = (bitcast<i32>(_e186) - 1i);
let _e8326 = select(_e8324, _e8322, (_e8322 < _e8324));
let _e8332 = global_7.member[bitcast<u32>(select(0i, _e8326, (_e8326 > 0i)))];
if _e7841 {
phi_13448_ = (select(_e8332, 1f, (_e8321 == 16i)) == 0f);
} else {
phi_13448_ = (_e672 != -1i);
}
let _e8338 = phi_13448_;
if _e680 {
let _e8348 = type_24(select(_e766, 1e30f, _e7830), _e7829.member_1, _e7829.member_2, _e7829.member_3, _e7829.member_4, _e7829.member_5, _e7829.member_6, _e7829.member_7, _e7829.member_8);
let _e8359 = type_24(_e8348.member, select(_e766, _e845, (_e845 < _e766)), _e8348.member_2, _e8348.member_3, _e8348.member_4, _e8348.member_5, _e8348.member_6, _e8348.member_7, _e8348.member_8);
let _e8370 = type_24(_e8359.member, _e8359.member_1, select(_e766, _e846, (_e846 < _e766)), _e8359.member_3, _e8359.member_4, _e8359.member_5, _e8359.member_6, _e8359.member_7, _e8359.member_8);
let _e8381 = select(1f, -1f, ((((_e8301.member_1.x * _e511) + (_e8301.member_1.y * _e522)) + (_e8301.member_1.z * _e533)) > 0f));
let _e8393 = select(_e8381, -(_e8381), ((((_e8301.member_2.x * _e8301.member_1.x) + (_e8301.member_2.y * _e8301.member_1.y)) + (_e8301.member_2.z * _e8301.member_1.z)) < 0f));
let _e8394 = (_e8301.member_2.x * _e8393);
let _e8395 = (_e8301.member_2.y * _e8393);
let _e8396 = (_e8301.member_2.z * _e8393);
let _e8405 = ((((_e8394 * _e511) + (_e8395 * _e522)) + (_e8396 * _e533)) > 0f);
let _e8421 = type_24(_e8370.member, _e8370.member_1, _e8370.member_2, _e8370.member_3, _e8370.member_4, _e8370.member_5, _e8370.member_6, _e8370.member_7, vec3<f32>(select(select(_e8394, (_e8301.member_1.x * _e8381), _e8405), 0f, _e7830), select(select(_e8395, (_e8301.member_1.y * _e8381), _e8405), 0f, _e7830), select(select(_e8396, (_e8301.member_1.z * _e8381), _e8405), 0f, _e7830)));
let _e8425 = (1f - (((_e1399 + _e1447) + _e1495) * _e1503));
let _e8429 = global_1.member.member_15.member_12;
phi_13568_ = type_24(_e8421.member, _e8421.member_1, _e8421.member_2, _e8421.member_3, _e8421.member_4, _e8421.member_5, _e8421.member_6, select(1f, select(_e8425, _e8429, (_e8429 > _e8425)), _e7830), _e8421.member_8);
} else {
phi_13568_ = _e7829;
}
let _e8443 = phi_13568_;
if _e7830 {
let _e9670 = (((_e544 * _e544) + (_e555 * _e555)) + (_e566 * _e566));
let _e9673 = sqrt(select(0f, _e9670, (_e9670 > 0f)));
let _e9678 = (((_e577 * _e577) + (_e588 * _e588)) + (_e599 * _e599));
let _e9681 = sqrt(select(0f, _e9678, (_e9678 > 0f)));
let _e9683 = select(_e9681, _e9673, (_e9673 > _e9681));
let _e9687 = global_1.member.member_15.member_4;
let _e9695 = (((_e9687.member * _e511) + (_e9687.member_1 * _e522)) + (_e9687.member_2 * _e533));
let _e9699 = global_1.member.member_15.member_5;
let _e9707 = (((_e9699.member * _e511) + (_e9699.member_1 * _e522)) + (_e9699.member_2 * _e533));
let _e9711 = global_1.member.member_15.member_6;
let _e9719 = (((_e9711.member * _e511) + (_e9711.member_1 * _e522)) + (_e9711.member_2 * _e533));
let _e9723 = global_1.member.member_15.member;
let _e9727 = global_1.member.member_15.member_7;
let _e9731 = vec3<f32>(_e9727.member, _e9727.member_1, _e9727.member_2);
let _e9735 = global_1.member.member_15.member_8;
if (_e9723 == 0u) {
phi_15057_ = _e9731;
} else {
if (_e9723 == 1u) {
let _e10712 = select(-1f, _e9719, (_e9719 > -1f));
let _e10714 = select(1f, _e10712, (_e10712 < 1f));
if (_e10714 > 0f) {
phi_13672_ = _e9731;
} else {
let _e10719 = global_1.member.member_15.member_9;
phi_13672_ = vec3<f32>(_e10719.member, _e10719.member_1, _e10719.member_2);
}
let _e10725 = phi_13672_;
let _e10734 = bitcast<f32>((bitcast<u32>(_e10714) & 2147483647u));
let _e10737 = sqrt(select(0f, _e10734, (_e10734 > 0f)));
phi_15056_ = vec3<f32>((_e9735.member + ((_e10725.x - _e9735.member) * _e10737)), (_e9735.member_1 + ((_e10725.y - _e9735.member_1) * _e10737)), (_e9735.member_2 + ((_e10725.z - _e9735.member_2) * _e10737)));
} else {
if (_e9723 == 2u) {
let _e10512 = global_1.member.member_15.member_10;
let _e10513 = (_e9683 / _e10512);
let _e10515 = select(1e-4f, _e10513, (_e10513 > 1e-4f));
let _e10518 = bitcast<f32>((bitcast<u32>(_e9695) & 2147483647u));
let _e10521 = bitcast<f32>((bitcast<u32>(_e9707) & 2147483647u));
let _e10525 = select(_e10521, _e10518, (_e10518 > _e10521));
let _e10528 = (select(_e10521, _e10518, (_e10518 < _e10521)) / select(1.1754944e-38f, _e10525, (_e10525 > 1.1754944e-38f)));
let _e10529 = (_e10528 > 0.41421357f);
let _e10533 = select(_e10528, ((_e10528 - 1f) / (_e10528 + 1f)), _e10529);
let _e10534 = (_e10533 * _e10533);
let _e10549 = (select(0f, 0.7853982f, _e10529) + (_e10533 + ((_e10533 * _e10534) * (-0.33333334f + (_e10534 * (0.2f + (_e10534 * (-0.14285713f + (_e10534 * (0.11111111f + (_e10534 * (-0.09090909f + (_e10534 * 0.0585f)))))))))))));
let _e10552 = select(_e10549, (1.5707964f - _e10549), (_e10521 > _e10518));
let _e10555 = select(_e10552, (3.1415927f - _e10552), (_e9695 < 0f));
let _e10561 = (1f - (_e9719 * _e9719));
let _e10564 = sqrt(select(0f, _e10561, (_e10561 > 0f)));
let _e10567 = (_e10515 / select(1e-3f, _e10564, (_e10564 > 1e-3f)));
let _e10568 = ((select(_e10555, -(_e10555), (_e9707 < 0f)) / _e10512) * 0.5f);
let _e10570 = select(-8e6f, _e10568, (_e10568 > -8e6f));
let _e10572 = select(8e6f, _e10570, (_e10570 < 8e6f));
let _e10579 = select(0i, select(select(i32(_e10572), i32(-2147483648), (_e10572 < -2147483600f)), 2147483647i, (_e10572 > 2147483500f)), (_e10572 == _e10572));
let _e10586 = ((_e10568 - f32((_e10579 - select(0i, 1i, (_e10572 < f32(_e10579)))))) * 2f);
let _e10594 = ((select(select((_e10586 - 2f), (1f - _e10586), (_e10586 < 1.5f)), _e10586, (_e10586 < 0.5f)) * 2f) / _e10567);
let _e10596 = select(-1f, _e10594, (_e10594 > -1f));
let _e10599 = (2f - _e10567);
let _e10601 = select(0f, _e10599, (_e10599 > 0f));
let _e10606 = select(-1f, _e9719, (_e9719 > -1f));
let _e10608 = select(1f, _e10606, (_e10606 < 1f));
let _e10611 = ((1f - _e10608) * (1f + _e10608));
let _e10614 = sqrt(select(0f, _e10611, (_e10611 > 0f)));
let _e10617 = bitcast<f32>((bitcast<u32>(_e10614) & 2147483647u));
let _e10620 = bitcast<f32>((bitcast<u32>(_e10608) & 2147483647u));
let _e10624 = select(_e10620, _e10617, (_e10617 > _e10620));
let _e10627 = (select(_e10620, _e10617, (_e10617 < _e10620)) / select(1.1754944e-38f, _e10624, (_e10624 > 1.1754944e-38f)));
let _e10628 = (_e10627 > 0.41421357f);
let _e10632 = select(_e10627, ((_e10627 - 1f) / (_e10627 + 1f)), _e10628);
let _e10633 = (_e10632 * _e10632);
let _e10648 = (select(0f, 0.7853982f, _e10628) + (_e10632 + ((_e10632 * _e10633) * (-0.33333334f + (_e10633 * (0.2f + (_e10633 * (-0.14285713f + (_e10633 * (0.11111111f + (_e10633 * (-0.09090909f + (_e10633 * 0.0585f)))))))))))));
let _e10651 = select(_e10648, (1.5707964f - _e10648), (_e10620 > _e10617));
let _e10654 = select(_e10651, (3.1415927f - _e10651), (_e10614 < 0f));
let _e10659 = ((select(_e10654, -(_e10654), (_e10608 < 0f)) / _e10512) * 0.5f);
let _e10661 = select(-8e6f, _e10659, (_e10659 > -8e6f));
let _e10663 = select(8e6f, _e10661, (_e10661 < 8e6f));
let _e10670 = select(0i, select(select(i32(_e10663), i32(-2147483648), (_e10663 < -2147483600f)), 2147483647i, (_e10663 > 2147483500f)), (_e10663 == _e10663));
let _e10677 = ((_e10659 - f32((_e10670 - select(0i, 1i, (_e10663 < f32(_e10670)))))) * 2f);
let _e10685 = ((select(select((_e10677 - 2f), (1f - _e10677), (_e10677 < 1.5f)), _e10677, (_e10677 < 0.5f)) * 2f) / _e10515);
let _e10687 = select(-1f, _e10685, (_e10685 > -1f));
let _e10690 = (2f - _e10515);
let _e10692 = select(0f, _e10690, (_e10690 > 0f));
let _e10698 = (0.5f + ((0.5f * (select(1f, _e10596, (_e10596 < 1f)) * select(1f, _e10601, (_e10601 < 1f)))) * (select(1f, _e10687, (_e10687 < 1f)) * select(1f, _e10692, (_e10692 < 1f)))));
phi_15055_ = vec3<f32>((_e9727.member + ((_e9735.member - _e9727.member) * _e10698)), (_e9727.member_1 + ((_e9735.member_1 - _e9727.member_1) * _e10698)), (_e9727.member_2 + ((_e9735.member_2 - _e9727.member_2) * _e10698)));
} else {
let _e9745 = global_1.member.member_15.member_1;
let _e9746 = bitcast<i32>(_e9745);
let _e9751 = global_1.member.member_15.member_3;
let _e9753 = f32(bitcast<i32>(_e9751));
let _e9755 = (2f * 3.1415927f);
let _e9756 = ((_e9683 * f32(_e9746)) / _e9755);
let _e9758 = select(1e-6f, _e9756, (_e9756 > 1e-6f));
let _e9761 = bitcast<u32>(select(1.1754944e-38f, _e9758, (_e9758 > 1.1754944e-38f)));
let _e9762 = (_e9761 & 8388607u);
let _e9764 = select(0u, 1u, (_e9762 > 3474675u));
let _e9775 = bitcast<f32>((_e9762 | ((127u - _e9764) << bitcast<u32>(23i))));
let _e9778 = ((_e9775 - 1f) / (_e9775 + 1f));
let _e9779 = (_e9778 * _e9778);
let _e9794 = (f32(((bitcast<i32>((_e9761 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e9764))) + (((2f * _e9778) + ((_e9778 * _e9779) * (0.6666667f + (_e9779 * (0.4f + (_e9779 * (0.2857143f + (_e9779 * (0.22222222f + (_e9779 * 0.18181819f)))))))))) * 1.442695f));
let _e9795 = (_e9753 - 1f);
let _e9797 = select(0f, _e9794, (_e9794 > 0f));
let _e9799 = select(_e9795, _e9797, (_e9797 < _e9795));
let _e9800 = (_e9753 - 2f);
let _e9802 = select(0f, _e9800, (_e9800 > 0f));
let _e9804 = select(0f, _e9799, (_e9799 > 0f));
let _e9806 = select(_e9802, _e9804, (_e9804 < _e9802));
let _e9813 = select(0i, select(select(i32(_e9806), i32(-2147483648), (_e9806 < -2147483600f)), 2147483647i, (_e9806 > 2147483500f)), (_e9806 == _e9806));
let _e9817 = (_e9813 - select(0i, 1i, (_e9806 < f32(_e9813))));
let _e9820 = bitcast<f32>((bitcast<u32>(_e9707) & 2147483647u));
let _e9823 = bitcast<f32>((bitcast<u32>(_e9695) & 2147483647u));
let _e9827 = select(_e9823, _e9820, (_e9820 > _e9823));
let _e9830 = (select(_e9823, _e9820, (_e9820 < _e9823)) / select(1.1754944e-38f, _e9827, (_e9827 > 1.1754944e-38f)));
let _e9831 = (_e9830 > 0.41421357f);
let _e9835 = select(_e9830, ((_e9830 - 1f) / (_e9830 + 1f)), _e9831);
let _e9836 = (_e9835 * _e9835);
let _e9851 = (select(0f, 0.7853982f, _e9831) + (_e9835 + ((_e9835 * _e9836) * (-0.33333334f + (_e9836 * (0.2f + (_e9836 * (-0.14285713f + (_e9836 * (0.11111111f + (_e9836 * (-0.09090909f + (_e9836 * 0.0585f)))))))))))));
let _e9854 = select(_e9851, (1.5707964f - _e9851), (_e9823 > _e9820));
let _e9857 = select(_e9854, (3.1415927f - _e9854), (_e9707 < 0f));
let _e9862 = (0.5f - (select(_e9857, -(_e9857), (_e9695 < 0f)) / _e9755));
let _e9864 = select(-1f, _e9719, (_e9719 > -1f));
let _e9866 = select(1f, _e9864, (_e9864 < 1f));
let _e9869 = ((1f - _e9866) * (1f + _e9866));
let _e9872 = sqrt(select(0f, _e9869, (_e9869 > 0f)));
let _e9875 = bitcast<f32>((bitcast<u32>(_e9872) & 2147483647u));
let _e9878 = bitcast<f32>((bitcast<u32>(_e9866) & 2147483647u));
let _e9882 = select(_e9878, _e9875, (_e9875 > _e9878));
let _e9885 = (select(_e9878, _e9875, (_e9875 < _e9878)) / select(1.1754944e-38f, _e9882, (_e9882 > 1.1754944e-38f)));
let _e9886 = (_e9885 > 0.41421357f);
let _e9890 = select(_e9885, ((_e9885 - 1f) / (_e9885 + 1f)), _e9886);
let _e9891 = (_e9890 * _e9890);
let _e9906 = (select(0f, 0.7853982f, _e9886) + (_e9890 + ((_e9890 * _e9891) * (-0.33333334f + (_e9891 * (0.2f + (_e9891 * (-0.14285713f + (_e9891 * (0.11111111f + (_e9891 * (-0.09090909f + (_e9891 * 0.0585f)))))))))))));
let _e9909 = select(_e9906, (1.5707964f - _e9906), (_e9878 > _e9875));
let _e9912 = select(_e9909, (3.1415927f - _e9909), (_e9872 < 0f));
let _e9917 = (0.5f - (select(_e9912, -(_e9912), (_e9866 < 0f)) / 3.1415927f));
let _e9921 = global_1.member.member_15.member_2;
let _e9922 = bitcast<i32>(_e9921);
phi_14274_ = 0i;
phi_14277_ = 0i;
phi_14279_ = _e9922;
phi_14281_ = _e9746;
loop {
let _e9924 = phi_14274_;
let _e9926 = phi_14277_;
let _e9928 = phi_14279_;
let _e9930 = phi_14281_;
local_43 = _e9930;
local_44 = _e9928;
local_45 = _e9930;
local_46 = _e9930;
local_47 = _e9930;
local_48 = _e9930;
local_49 = _e9930;
local_50 = _e9930;
local_51 = _e9928;
local_52 = _e9928;
local_53 = _e9928;
local_54 = _e9928;
local_55 = _e9930;
local_56 = _e9926;
local_57 = _e9930;
local_58 = _e9926;
let _e9931 = (_e9924 < _e9817);
if _e9931 {
if (_e9930 > 1i) {
phi_14296_ = (_e9930 >> bitcast<u32>(1i));
} else {
phi_14296_ = 1i;
}
let _e9938 = phi_14296_;
if (_e9928 > 1i) {
phi_14302_ = (_e9928 >> bitcast<u32>(1i));
} else {
phi_14302_ = 1i;
}
let _e9943 = phi_14302_;
phi_14275_ = (_e9924 + 1i);
phi_14278_ = (_e9926 + (_e9930 * _e9928));
phi_14280_ = _e9943;
phi_14282_ = _e9938;
} else {
phi_14275_ = i32();
phi_14278_ = i32();
phi_14280_ = i32();
phi_14282_ = i32();
}
let _e9946 = phi_14275_;
let _e9948 = phi_14278_;
let _e9950 = phi_14280_;
let _e9952 = phi_14282_;
continue;
continuing {
phi_14274_ = _e9946;
phi_14277_ = _e9948;
phi_14279_ = _e9950;
phi_14281_ = _e9952;
break if !(_e9931);
}
}
let _e9955 = local_43;
let _e9956 = f32(_e9955);
let _e9958 = ((_e9862 * _e9956) - 0.5f);
let _e9960 = local_44;
let _e9961 = f32(_e9960);
let _e9963 = ((_e9917 * _e9961) - 0.5f);
let _e9965 = select(-1f, _e9958, (_e9958 > -1f));
let _e9967 = select(_e9956, _e9965, (_e9965 < _e9956));
let _e9974 = select(0i, select(select(i32(_e9967), i32(-2147483648), (_e9967 < -2147483600f)), 2147483647i, (_e9967 > 2147483500f)), (_e9967 == _e9967));
let _e9978 = (_e9974 - select(0i, 1i, (_e9967 < f32(_e9974))));
let _e9980 = select(-1f, _e9963, (_e9963 > -1f));
let _e9982 = select(_e9961, _e9980, (_e9980 < _e9961));
let _e9989 = select(0i, select(select(i32(_e9982), i32(-2147483648), (_e9982 < -2147483600f)), 2147483647i, (_e9982 > 2147483500f)), (_e9982 == _e9982));
let _e9993 = (_e9989 - select(0i, 1i, (_e9982 < f32(_e9989))));
let _e9995 = (_e9958 - f32(_e9978));
let _e9997 = (_e9963 - f32(_e9993));
let _e9999 = select(0f, _e9997, (_e9997 > 0f));
let _e10001 = select(1f, _e9999, (_e9999 < 1f));
if (_e9978 < 0i) {
let _e10004 = local_45;
phi_14377_ = (_e9978 + _e10004);
} else {
phi_14377_ = _e9978;
}
let _e10007 = phi_14377_;
let _e10009 = local_46;
if (_e10007 >= _e10009) {
let _e10012 = local_47;
phi_14383_ = (_e10007 - _e10012);
} else {
phi_14383_ = _e10007;
}
let _e10015 = phi_14383_;
let _e10016 = (_e9978 + 1i);
if (_e10016 < 0i) {
let _e10019 = local_48;
phi_14390_ = (_e10016 + _e10019);
} else {
phi_14390_ = _e10016;
}
let _e10022 = phi_14390_;
let _e10024 = local_49;
if (_e10022 >= _e10024) {
let _e10027 = local_50;
phi_14396_ = (_e10022 - _e10027);
} else {
phi_14396_ = _e10022;
}
let _e10030 = phi_14396_;
let _e10032 = select(_e9993, 0i, (_e9993 < 0i));
let _e10034 = local_51;
if (_e10032 >= _e10034) {
let _e10037 = local_52;
phi_14407_ = (_e10037 - 1i);
} else {
phi_14407_ = _e10032;
}
let _e10040 = phi_14407_;
let _e10041 = (_e9993 + 1i);
let _e10043 = select(_e10041, 0i, (_e10041 < 0i));
let _e10045 = local_53;
if (_e10043 >= _e10045) {
let _e10048 = local_54;
phi_14419_ = (_e10048 - 1i);
} else {
phi_14419_ = _e10043;
}
let _e10051 = phi_14419_;
let _e10053 = local_55;
let _e10056 = local_56;
let _e10057 = (_e10056 + (_e10040 * _e10053));
let _e10059 = local_57;
let _e10062 = local_58;
let _e10063 = (_e10062 + (_e10051 * _e10059));
let _e10065 = (3i * (_e10057 + _e10015));
let _e10067 = (bitcast<i32>(_e179) - 1i);
let _e10069 = select(_e10067, _e10065, (_e10065 < _e10067));
let _e10075 = global_3.member[bitcast<u32>(select(0i, _e10069, (_e10069 > 0i)))];
let _e10076 = (_e10065 + 1i);
let _e10078 = select(_e10067, _e10076, (_e10076 < _e10067));
let _e10084 = global_3.member[bitcast<u32>(select(0i, _e10078, (_e10078 > 0i)))];
let _e10085 = (_e10065 + 2i);
let _e10087 = select(_e10067, _e10085, (_e10085 < _e10067));
let _e10093 = global_3.member[bitcast<u32>(select(0i, _e10087, (_e10087 > 0i)))];
let _e10095 = (3i * (_e10057 + _e10030));
let _e10097 = select(_e10067, _e10095, (_e10095 < _e10067));
let _e10103 = global_3.member[bitcast<u32>(select(0i, _e10097, (_e10097 > 0i)))];
let _e10104 = (_e10095 + 1i);
let _e10106 = select(_e10067, _e10104, (_e10104 < _e10067));
let _e10112 = global_3.member[bitcast<u32>(select(0i, _e10106, (_e10106 > 0i)))];
let _e10113 = (_e10095 + 2i);
let _e10115 = select(_e10067, _e10113, (_e10113 < _e10067));
let _e10121 = global_3.member[bitcast<u32>(select(0i, _e10115, (_e10115 > 0i)))];
let _e10123 = (3i * (_e10063 + _e10015));
let _e10125 = select(_e10067, _e10123, (_e10123 < _e10067));
let _e10131 = global_3.member[bitcast<u32>(select(0i, _e10125, (_e10125 > 0i)))];
let _e10132 = (_e10123 + 1i);
let _e10134 = select(_e10067, _e10132, (_e10132 < _e10067));
let _e10140 = global_3.member[bitcast<u32>(select(0i, _e10134, (_e10134 > 0i)))];
let _e10141 = (_e10123 + 2i);
let _e10143 = select(_e10067, _e10141, (_e10141 < _e10067));
let _e10149 = global_3.member[bitcast<u32>(select(0i, _e10143, (_e10143 > 0i)))];
let _e10151 = (3i * (_e10063 + _e10030));
let _e10153 = select(_e10067, _e10151, (_e10151 < _e10067));
let _e10159 = global_3.member[bitcast<u32>(select(0i, _e10153, (_e10153 > 0i)))];
let _e10160 = (_e10151 + 1i);
let _e10162 = select(_e10067, _e10160, (_e10160 < _e10067));
let _e10168 = global_3.member[bitcast<u32>(select(0i, _e10162, (_e10162 > 0i)))];
let _e10169 = (_e10151 + 2i);
let _e10171 = select(_e10067, _e10169, (_e10169 < _e10067));
let _e10177 = global_3.member[bitcast<u32>(select(0i, _e10171, (_e10171 > 0i)))];
let _e10184 = (_e10075 + ((_e10103 - _e10075) * _e9995));
let _e10185 = (_e10084 + ((_e10112 - _e10084) * _e9995));
let _e10186 = (_e10093 + ((_e10121 - _e10093) * _e9995));
let _e10202 = (_e10184 + (((_e10131 + ((_e10159 - _e10131) * _e9995)) - _e10184) * _e10001));
let _e10203 = (_e10185 + (((_e10140 + ((_e10168 - _e10140) * _e9995)) - _e10185) * _e10001));
let _e10204 = (_e10186 + (((_e10149 + ((_e10177 - _e10149) * _e9995)) - _e10186) * _e10001));
phi_14655_ = 0i;
phi_14658_ = 0i;
phi_14660_ = _e9922;
phi_14662_ = _e9746;
loop {
let _e10207 = phi_14655_;
let _e10209 = phi_14658_;
let _e10211 = phi_14660_;
let _e10213 = phi_14662_;
local_59 = _e10213;
local_60 = _e10211;
local_61 = _e10213;
local_62 = _e10213;
local_63 = _e10213;
local_64 = _e10213;
local_65 = _e10213;
local_66 = _e10213;
local_67 = _e10211;
local_68 = _e10211;
local_69 = _e10211;
local_70 = _e10211;
local_71 = _e10213;
local_72 = _e10209;
local_73 = _e10213;
local_74 = _e10209;
let _e10214 = (_e10207 < (_e9817 + 1i));
if _e10214 {
if (_e10213 > 1i) {
phi_14677_ = (_e10213 >> bitcast<u32>(1i));
} else {
phi_14677_ = 1i;
}
let _e10221 = phi_14677_;
if (_e10211 > 1i) {
phi_14683_ = (_e10211 >> bitcast<u32>(1i));
} else {
phi_14683_ = 1i;
}
let _e10226 = phi_14683_;
phi_14656_ = (_e10207 + 1i);
phi_14659_ = (_e10209 + (_e10213 * _e10211));
phi_14661_ = _e10226;
phi_14663_ = _e10221;
} else {
phi_14656_ = i32();
phi_14659_ = i32();
phi_14661_ = i32();
phi_14663_ = i32();
}
let _e10229 = phi_14656_;
let _e10231 = phi_14659_;
let _e10233 = phi_14661_;
let _e10235 = phi_14663_;
continue;
continuing {
phi_14655_ = _e10229;
phi_14658_ = _e10231;
phi_14660_ = _e10233;
phi_14662_ = _e10235;
break if !(_e10214);
}
}
let _e10238 = local_59;
let _e10239 = f32(_e10238);
let _e10241 = ((_e9862 * _e10239) - 0.5f);
let _e10243 = local_60;
let _e10244 = f32(_e10243);
let _e10246 = ((_e9917 * _e10244) - 0.5f);
let _e10248 = select(-1f, _e10241, (_e10241 > -1f));
let _e10250 = select(_e10239, _e10248, (_e10248 < _e10239));
let _e10257 = select(0i, select(select(i32(_e10250), i32(-2147483648), (_e10250 < -2147483600f)), 2147483647i, (_e10250 > 2147483500f)), (_e10250 == _e10250));
let _e10261 = (_e10257 - select(0i, 1i, (_e10250 < f32(_e10257))));
let _e10263 = select(-1f, _e10246, (_e10246 > -1f));
let _e10265 = select(_e10244, _e10263, (_e10263 < _e10244));
let _e10272 = select(0i, select(select(i32(_e10265), i32(-2147483648), (_e10265 < -2147483600f)), 2147483647i, (_e10265 > 2147483500f)), (_e10265 == _e10265));
let _e10276 = (_e10272 - select(0i, 1i, (_e10265 < f32(_e10272))));
let _e10278 = (_e10241 - f32(_e10261));
let _e10280 = (_e10246 - f32(_e10276));
let _e10282 = select(0f, _e10280, (_e10280 > 0f));
let _e10284 = select(1f, _e10282, (_e10282 < 1f));
if (_e10261 < 0i) {
let _e10287 = local_61;
phi_14758_ = (_e10261 + _e10287);
} else {
phi_14758_ = _e10261;
}
let _e10290 = phi_14758_;
let _e10292 = local_62;
if (_e10290 >= _e10292) {
let _e10295 = local_63;
phi_14764_ = (_e10290 - _e10295);
} else {
phi_14764_ = _e10290;
}
let _e10298 = phi_14764_;
let _e10299 = (_e10261 + 1i);
if (_e10299 < 0i) {
let _e10302 = local_64;
phi_14771_ = (_e10299 + _e10302);
} else {
phi_14771_ = _e10299;
}
let _e10305 = phi_14771_;
let _e10307 = local_65;
if (_e10305 >= _e10307) {
let _e10310 = local_66;
phi_14777_ = (_e10305 - _e10310);
} else {
phi_14777_ = _e10305;
}
let _e10313 = phi_14777_;
let _e10315 = select(_e10276, 0i, (_e10276 < 0i));
let _e10317 = local_67;
if (_e10315 >= _e10317) {
let _e10320 = local_68;
phi_14788_ = (_e10320 - 1i);
} else {
phi_14788_ = _e10315;
}
let _e10323 = phi_14788_;
let _e10324 = (_e10276 + 1i);
let _e10326 = select(_e10324, 0i, (_e10324 < 0i));
let _e10328 = local_69;
if (_e10326 >= _e10328) {
let _e10331 = local_70;
phi_14800_ = (_e10331 - 1i);
} else {
phi_14800_ = _e10326;
}
let _e10334 = phi_14800_;
let _e10336 = local_71;
let _e10339 = local_72;
let _e10340 = (_e10339 + (_e10323 * _e10336));
let _e10342 = local_73;
let _e10345 = local_74;
let _e10346 = (_e10345 + (_e10334 * _e10342));
let _e10348 = (3i * (_e10340 + _e10298));
let _e10350 = select(_e10067, _e10348, (_e10348 < _e10067));
let _e10356 = global_3.member[bitcast<u32>(select(0i, _e10350, (_e10350 > 0i)))];
let _e10357 = (_e10348 + 1i);
let _e10359 = select(_e10067, _e10357, (_e10357 < _e10067));
let _e10365 = global_3.member[bitcast<u32>(select(0i, _e10359, (_e10359 > 0i)))];
let _e10366 = (_e10348 + 2i);
let _e10368 = select(_e10067, _e10366, (_e10366 < _e10067));
let _e10374 = global_3.member[bitcast<u32>(select(0i, _e10368, (_e10368 > 0i)))];
let _e10376 = (3i * (_e10340 + _e10313));
let _e10378 = select(_e10067, _e10376, (_e10376 < _e10067));
let _e10384 = global_3.member[bitcast<u32>(select(0i, _e10378, (_e10378 > 0i)))];
let _e10385 = (_e10376 + 1i);
let _e10387 = select(_e10067, _e10385, (_e10385 < _e10067));
let _e10393 = global_3.member[bitcast<u32>(select(0i, _e10387, (_e10387 > 0i)))];
let _e10394 = (_e10376 + 2i);
let _e10396 = select(_e10067, _e10394, (_e10394 < _e10067));
let _e10402 = global_3.member[bitcast<u32>(select(0i, _e10396, (_e10396 > 0i)))];
let _e10404 = (3i * (_e10346 + _e10298));
let _e10406 = select(_e10067, _e10404, (_e10404 < _e10067));
let _e10412 = global_3.member[bitcast<u32>(select(0i, _e10406, (_e10406 > 0i)))];
let _e10413 = (_e10404 + 1i);
let _e10415 = select(_e10067, _e10413, (_e10413 < _e10067));
let _e10421 = global_3.member[bitcast<u32>(select(0i, _e10415, (_e10415 > 0i)))];
let _e10422 = (_e10404 + 2i);
let _e10424 = select(_e10067, _e10422, (_e10422 < _e10067));
let _e10430 = global_3.member[bitcast<u32>(select(0i, _e10424, (_e10424 > 0i)))];
let _e10432 = (3i * (_e10346 + _e10313));
let _e10434 = select(_e10067, _e10432, (_e10432 < _e10067));
let _e10440 = global_3.member[bitcast<u32>(select(0i, _e10434, (_e10434 > 0i)))];
let _e10441 = (_e10432 + 1i);
let _e10443 = select(_e10067, _e10441, (_e10441 < _e10067));
let _e10449 = global_3.member[bitcast<u32>(select(0i, _e10443, (_e10443 > 0i)))];
let _e10450 = (_e10432 + 2i);
let _e10452 = select(_e10067, _e10450, (_e10450 < _e10067));
let _e10458 = global_3.member[bitcast<u32>(select(0i, _e10452, (_e10452 > 0i)))];
let _e10465 = (_e10356 + ((_e10384 - _e10356) * _e10278));
let _e10466 = (_e10365 + ((_e10393 - _e10365) * _e10278));
let _e10467 = (_e10374 + ((_e10402 - _e10374) * _e10278));
let _e10490 = (_e9799 - f32(_e9817));
let _e10492 = select(0f, _e10490, (_e10490 > 0f));
let _e10494 = select(1f, _e10492, (_e10492 < 1f));
let _e10504 = global_1.member.member_15.member_11;
phi_15055_ = vec3<f32>(((_e10202 + (((_e10465 + (((_e10412 + ((_e10440 - _e10412) * _e10278)) - _e10465) * _e10284)) - _e10202) * _e10494)) * _e10504), ((_e10203 + (((_e10466 + (((_e10421 + ((_e10449 - _e10421) * _e10278)) - _e10466) * _e10284)) - _e10203) * _e10494)) * _e10504), ((_e10204 + (((_e10467 + (((_e10430 + ((_e10458 - _e10430) * _e10278)) - _e10467) * _e10284)) - _e10204) * _e10494)) * _e10504));
}
let _e10710 = phi_15055_;
phi_15056_ = _e10710;
}
let _e10746 = phi_15056_;
phi_15057_ = _e10746;
}
let _e10748 = phi_15057_;
let _e10752 = global_1.member.member_15.member_12;
let _e10753 = select(1f, _e10752, _e680);
phi_16894_ = type_24(_e8443.member, _e8443.member_1, _e8443.member_2, vec3<f32>((_e8443.member_3.x + (((_e10748.x * _e1399) * _e767) * _e10753)), (_e8443.member_3.y + (((_e10748.y * _e1447) * _e768) * _e10753)), (_e8443.member_3.z + (((_e10748.z * _e1495) * _e769) * _e10753))), _e8443.member_4, _e8443.member_5, _e8443.member_6, _e8443.member_7, _e8443.member_8);
} else {
if _e8338 {
let _e8448 = global_1.member.member_10.member_2;
let _e8456 = global_1.member.member_10.member;
let _e8457 = (_e8456 == 0u);
if _e8457 {
let _e8805 = global_1.member.member_10.member_1;
phi_15613_ = type_26(vec3<f32>(_e8805.member, _e8805.member_1, _e8805.member_2), vec3<f32>(_e8448.member, _e8448.member_1, _e8448.member_2));
} else {
let _e8461 = global_1.member.member_10.member_3;
let _e8466 = (_e8301.member.x - _e8461.member);
let _e8468 = (_e8301.member.y - _e8461.member_1);
let _e8470 = (_e8301.member.z - _e8461.member_2);
let _e8475 = (((_e8466 * _e8466) + (_e8468 * _e8468)) + (_e8470 * _e8470));
let _e8477 = select(1e-12f, _e8475, (_e8475 > 1e-12f));
let _e8478 = (1f / _e8477);
let _e8482 = vec3<f32>((_e8448.member * _e8478), (_e8448.member_1 * _e8478), (_e8448.member_2 * _e8478));
if (_e8456 == 2u) {
let _e8487 = global_1.member.member_10.member_1;
let _e8495 = (((_e8487.member * _e8466) + (_e8487.member_1 * _e8468)) + (_e8487.member_2 * _e8470));
let _e8498 = (1f / select(1e-20f, _e8495, (_e8495 > 1e-20f)));
let _e8503 = global_1.member.member_10.member_4.member;
let _e8512 = ((((_e8503.member * _e8466) + (_e8503.member_1 * _e8468)) + (_e8503.member_2 * _e8470)) * _e8498);
let _e8517 = global_1.member.member_10.member_4.member_1;
let _e8526 = ((((_e8517.member * _e8466) + (_e8517.member_1 * _e8468)) + (_e8517.member_2 * _e8470)) * _e8498);
let _e8531 = global_1.member.member_10.member_4.member_2;
let _e8534 = ((_e8512 * _e8512) + (_e8526 * _e8526));
let _e8543 = global_1.member.member_10.member_4.member_3;
let _e8544 = ((_e8531 - sqrt(select(0f, _e8534, (_e8534 > 0f)))) * _e8543);
let _e8546 = select(0f, _e8544, (_e8544 > 0f));
let _e8548 = select(1f, _e8546, (_e8546 < 1f));
let _e8554 = select(0f, ((_e8548 * _e8548) * (3f - (2f * _e8548))), (_e8495 > 0f));
let _e8559 = global_1.member.member_10.member_4.member_5;
if ((_e8559 > 0u) && (_e8554 > 0f)) {
let _e8564 = (0.5f / _e8531);
let _e8574 = global_1.member.member_10.member_4.member_6;
let _e8575 = bitcast<i32>(_e8574);
local_4 = bitcast<i32>(_e8559);
let _e8576 = local_4;
let _e8578 = f32((_e8576 - 1i));
let _e8580 = f32((_e8575 - 1i));
let _e8581 = local_4;
let _e8584 = (((0.5f + (_e8512 * _e8564)) * f32(_e8581)) - 0.5f);
let _e8586 = select(0f, _e8584, (_e8584 > 0f));
let _e8588 = select(_e8578, _e8586, (_e8586 < _e8578));
let _e8591 = (((0.5f - (_e8526 * _e8564)) * f32(_e8575)) - 0.5f);
let _e8593 = select(0f, _e8591, (_e8591 > 0f));
let _e8595 = select(_e8580, _e8593, (_e8593 < _e8580));
let _e8597 = select(0f, _e8588, (_e8588 > 0f));
let _e8599 = select(_e8578, _e8597, (_e8597 < _e8578));
let _e8606 = select(0i, select(select(i32(_e8599), i32(-2147483648), (_e8599 < -2147483600f)), 2147483647i, (_e8599 > 2147483500f)), (_e8599 == _e8599));
let _e8610 = (_e8606 - select(0i, 1i, (_e8599 < f32(_e8606))));
let _e8612 = select(0f, _e8595, (_e8595 > 0f));
let _e8614 = select(_e8580, _e8612, (_e8612 < _e8580));
let _e8621 = select(0i, select(select(i32(_e8614), i32(-2147483648), (_e8614 < -2147483600f)), 2147483647i, (_e8614 > 2147483500f)), (_e8614 == _e8614));
let _e8625 = (_e8621 - select(0i, 1i, (_e8614 < f32(_e8621))));
let _e8627 = (_e8588 - f32(_e8610));
let _e8629 = (_e8595 - f32(_e8625));
let _e8630 = (_e8610 + 1i);
let _e8631 = local_4;
let _e8633 = select(_e8610, _e8630, (_e8630 < _e8631));
let _e8634 = (_e8625 + 1i);
let _e8636 = select(_e8625, _e8634, (_e8634 < _e8575));
let _e8641 = global_1.member.member_10.member_4.member_4;
let _e8642 = bitcast<i32>(_e8641);
let _e8643 = local_4;
let _e8647 = (_e8642 + (3i * ((_e8625 * _e8643) + _e8610)));
let _e8649 = (bitcast<i32>(_e179) - 1i);
let _e8651 = select(_e8649, _e8647, (_e8647 < _e8649));
let _e8656 = global_3.member[bitcast<u32>(select(0i, _e8651, (_e8651 > 0i)))];
let _e8657 = (_e8647 + 1i);
let _e8659 = select(_e8649, _e8657, (_e8657 < _e8649));
let _e8664 = global_3.member[bitcast<u32>(select(0i, _e8659, (_e8659 > 0i)))];
let _e8665 = (_e8647 + 2i);
let _e8667 = select(_e8649, _e8665, (_e8665 < _e8649));
let _e8672 = global_3.member[bitcast<u32>(select(0i, _e8667, (_e8667 > 0i)))];
let _e8673 = local_4;
let _e8677 = (_e8642 + (3i * ((_e8625 * _e8673) + _e8633)));
let _e8679 = select(_e8649, _e8677, (_e8677 < _e8649));
let _e8684 = global_3.member[bitcast<u32>(select(0i, _e8679, (_e8679 > 0i)))];
let _e8685 = (_e8677 + 1i);
let _e8687 = select(_e8649, _e8685, (_e8685 < _e8649));
let _e8692 = global_3.member[bitcast<u32>(select(0i, _e8687, (_e8687 > 0i)))];
let _e8693 = (_e8677 + 2i);
let _e8695 = select(_e8649, _e8693, (_e8693 < _e8649));
let _e8700 = global_3.member[bitcast<u32>(select(0i, _e8695, (_e8695 > 0i)))];
let _e8701 = local_4;
let _e8705 = (_e8642 + (3i * ((_e8636 * _e8701) + _e8610)));
let _e8707 = select(_e8649, _e8705, (_e8705 < _e8649));
let _e8712 = global_3.member[bitcast<u32>(select(0i, _e8707, (_e8707 > 0i)))];
let _e8713 = (_e8705 + 1i);
let _e8715 = select(_e8649, _e8713, (_e8713 < _e8649));
let _e8720 = global_3.member[bitcast<u32>(select(0i, _e8715, (_e8715 > 0i)))];
let _e8721 = (_e8705 + 2i);
let _e8723 = select(_e8649, _e8721, (_e8721 < _e8649));
let _e8728 = global_3.member[bitcast<u32>(select(0i, _e8723, (_e8723 > 0i)))];
let _e8729 = local_4;
let _e8733 = (_e8642 + (3i * ((_e8636 * _e8729) + _e8633)));
let _e8735 = select(_e8649, _e8733, (_e8733 < _e8649));
let _e8740 = global_3.member[bitcast<u32>(select(0i, _e8735, (_e8735 > 0i)))];
let _e8741 = (_e8733 + 1i);
let _e8743 = select(_e8649, _e8741, (_e8741 < _e8649));
let _e8748 = global_3.member[bitcast<u32>(select(0i, _e8743, (_e8743 > 0i)))];
let _e8749 = (_e8733 + 2i);
let _e8751 = select(_e8649, _e8749, (_e8749 < _e8649));
let _e8756 = global_3.member[bitcast<u32>(select(0i, _e8751, (_e8751 > 0i)))];
let _e8763 = (_e8656 + ((_e8684 - _e8656) * _e8627));
let _e8764 = (_e8664 + ((_e8692 - _e8664) * _e8627));
let _e8765 = (_e8672 + ((_e8700 - _e8672) * _e8627));
phi_15597_ = vec3<f32>(((_e8763 + (((_e8712 + ((_e8740 - _e8712) * _e8627)) - _e8763) * _e8629)) * _e8554), ((_e8764 + (((_e8720 + ((_e8748 - _e8720) * _e8627)) - _e8764) * _e8629)) * _e8554), ((_e8765 + (((_e8728 + ((_e8756 - _e8728) * _e8627)) - _e8765) * _e8629)) * _e8554));
} else {
phi_15597_ = vec3(_e8554);
}
let _e8789 = phi_15597_;
phi_15600_ = (_e8482 * _e8789);
} else {
phi_15600_ = _e8482;
}
let _e8792 = phi_15600_;
let _e8796 = (1f / sqrt(select(0f, _e8477, (_e8477 > 0f))));
phi_15613_ = type_26(vec3<f32>((_e8466 * _e8796), (_e8468 * _e8796), (_e8470 * _e8796)), _e8792);
}
let _e8812 = phi_15613_;
let _e8814 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e8816 = select(_e8814, _e492, (_e492 < _e8814));
let _e8822 = global_8.member[bitcast<u32>(select(0i, _e8816, (_e8816 > 0i)))];
let _e8827 = global_1.member.member_10.member_3;
let _e8832 = (_e8827.member - _e8301.member.x);
let _e8834 = (_e8827.member_1 - _e8301.member.y);
let _e8836 = (_e8827.member_2 - _e8301.member.z);
let _e8841 = (((_e8832 * _e8832) + (_e8834 * _e8834)) + (_e8836 * _e8836));
let _e8845 = select(sqrt(select(0f, _e8841, (_e8841 > 0f))), 1e30f, _e8457);
let _e8847 = -(_e8812.member.x);
let _e8849 = -(_e8812.member.y);
let _e8851 = -(_e8812.member.z);
let _e8859 = (1f / select(_e8847, select(1e-12f, -1e-12f, (_e8847 < 0f)), (bitcast<f32>((bitcast<u32>(_e8847) & 2147483647u)) < 1e-12f)));
let _e8867 = (1f / select(_e8849, select(1e-12f, -1e-12f, (_e8849 < 0f)), (bitcast<f32>((bitcast<u32>(_e8849) & 2147483647u)) < 1e-12f)));
let _e8875 = (1f / select(_e8851, select(1e-12f, -1e-12f, (_e8851 < 0f)), (bitcast<f32>((bitcast<u32>(_e8851) & 2147483647u)) < 1e-12f)));
let _e8877 = ((_e797.member - _e8301.member.x) * _e8859);
let _e8879 = ((_e804.member - _e8301.member.x) * _e8859);
let _e8881 = ((_e797.member_1 - _e8301.member.y) * _e8867);
let _e8883 = ((_e804.member_1 - _e8301.member.y) * _e8867);
let _e8885 = ((_e797.member_2 - _e8301.member.z) * _e8875);
let _e8887 = ((_e804.member_2 - _e8301.member.z) * _e8875);
let _e8889 = select(_e8879, _e8877, (_e8877 < _e8879));
let _e8891 = select(_e8883, _e8881, (_e8881 < _e8883));
let _e8893 = select(_e8891, _e8889, (_e8889 > _e8891));
let _e8895 = select(_e8887, _e8885, (_e8885 < _e8887));
let _e8897 = select(_e8895, _e8893, (_e8893 > _e8895));
let _e8899 = select(_e8879, _e8877, (_e8877 > _e8879));
let _e8901 = select(_e8883, _e8881, (_e8881 > _e8883));
let _e8903 = select(_e8901, _e8899, (_e8899 < _e8901));
let _e8905 = select(_e8887, _e8885, (_e8885 > _e8887));
let _e8907 = select(_e8905, _e8903, (_e8903 < _e8905));
let _e8909 = select(0f, _e8897, (_e8897 > 0f));
let _e8911 = select(_e8845, _e8907, (_e8907 < _e8845));
let _e8912 = (_e8911 > _e8909);
let _e8913 = select(0f, _e8909, _e8912);
let _e8915 = (select(0f, _e8911, _e8912) - _e8913);
if _e852 {
phi_16541_ = _e8915;
} else {
let _e8917 = (_e8915 / f32(_e851));
phi_15822_ = 0u;
phi_15825_ = 0f;
loop {
let _e8919 = phi_15822_;
let _e8921 = phi_15825_;
local_82 = _e8921;
let _e8924 = ((_e8919 < _e851) && (_e8915 > 0f));
if _e8924 {
let _e8927 = (_e8913 + (_e8917 * f32(_e8919)));
let _e8928 = (_e8927 + _e8917);
let _e8930 = (0.5f * (_e8927 + _e8928));
let _e8931 = (_e8928 - _e8927);
let _e8932 = (0.28867513f * _e8931);
let _e8933 = (_e8930 - _e8932);
let _e8943 = global_1.member.member_13.member_7;
let _e8944 = bitcast<i32>(_e8943);
let _e8948 = global_1.member.member_13.member_8;
let _e8949 = bitcast<i32>(_e8948);
let _e8953 = global_1.member.member_13.member_9;
let _e8954 = bitcast<i32>(_e8953);
let _e8955 = f32(_e8944);
let _e8957 = (_e804.member - _e797.member);
let _e8960 = (((((_e8301.member.x + (_e8847 * _e8933)) - _e797.member) / _e8957) * _e8955) - 0.5f);
let _e8961 = (_e8955 - 1f);
let _e8963 = select(0f, _e8960, (_e8960 > 0f));
let _e8965 = select(_e8961, _e8963, (_e8963 < _e8961));
let _e8966 = f32(_e8949);
let _e8968 = (_e804.member_1 - _e797.member_1);
let _e8971 = (((((_e8301.member.y + (_e8849 * _e8933)) - _e797.member_1) / _e8968) * _e8966) - 0.5f);
let _e8972 = (_e8966 - 1f);
let _e8974 = select(0f, _e8971, (_e8971 > 0f));
let _e8976 = select(_e8972, _e8974, (_e8974 < _e8972));
let _e8977 = f32(_e8954);
let _e8979 = (_e804.member_2 - _e797.member_2);
let _e8982 = (((((_e8301.member.z + (_e8851 * _e8933)) - _e797.member_2) / _e8979) * _e8977) - 0.5f);
let _e8983 = (_e8977 - 1f);
let _e8985 = select(0f, _e8982, (_e8982 > 0f));
let _e8987 = select(_e8983, _e8985, (_e8985 < _e8983));
let _e8989 = select(0f, _e8965, (_e8965 > 0f));
let _e8991 = select(1e6f, _e8989, (_e8989 < 1e6f));
let _e8998 = select(0i, select(select(i32(_e8991), i32(-2147483648), (_e8991 < -2147483600f)), 2147483647i, (_e8991 > 2147483500f)), (_e8991 == _e8991));
let _e9002 = (_e8998 - select(0i, 1i, (_e8991 < f32(_e8998))));
let _e9004 = select(0f, _e8976, (_e8976 > 0f));
let _e9006 = select(1e6f, _e9004, (_e9004 < 1e6f));
let _e9013 = select(0i, select(select(i32(_e9006), i32(-2147483648), (_e9006 < -2147483600f)), 2147483647i, (_e9006 > 2147483500f)), (_e9006 == _e9006));
let _e9017 = (_e9013 - select(0i, 1i, (_e9006 < f32(_e9013))));
let _e9019 = select(0f, _e8987, (_e8987 > 0f));
let _e9021 = select(1e6f, _e9019, (_e9019 < 1e6f));
let _e9028 = select(0i, select(select(i32(_e9021), i32(-2147483648), (_e9021 < -2147483600f)), 2147483647i, (_e9021 > 2147483500f)), (_e9021 == _e9021));
let _e9032 = (_e9028 - select(0i, 1i, (_e9021 < f32(_e9028))));
let _e9036 = (_e8976 - f32(_e9017));
let _e9038 = (_e8987 - f32(_e9032));
local_2 = (_e8965 - f32(_e9002));
let _e9039 = (_e9002 + 1i);
let _e9041 = select(_e9039, 0i, (_e9039 < 0i));
if (_e9041 >= _e8944) {
phi_15963_ = (_e8944 - 1i);
} else {
phi_15963_ = _e9041;
}
let _e9045 = phi_15963_;
local_3 = (_e9045 - _e9002);
let _e9047 = (_e9017 + 1i);
let _e9049 = select(_e9047, 0i, (_e9047 < 0i));
if (_e9049 >= _e8949) {
phi_15976_ = (_e8949 - 1i);
} else {
phi_15976_ = _e9049;
}
let _e9053 = phi_15976_;
let _e9055 = ((_e9053 - _e9017) * _e8944);
let _e9056 = (_e9032 + 1i);
let _e9058 = select(_e9056, 0i, (_e9056 < 0i));
if (_e9058 >= _e8954) {
phi_15990_ = (_e8954 - 1i);
} else {
phi_15990_ = _e9058;
}
let _e9062 = phi_15990_;
let _e9069 = global_1.member.member_13.member_10;
let _e9070 = bitcast<i32>(_e9069);
let _e9075 = ((_e9070 + (((_e9032 * _e8949) + _e9017) * _e8944)) + _e9002);
let _e9077 = select(_e8324, _e9075, (_e9075 < _e8324));
let _e9082 = global_7.member[bitcast<u32>(select(0i, _e9077, (_e9077 > 0i)))];
let _e9083 = local_2;
let _e9086 = local_3;
let _e9087 = (_e9075 + _e9086);
let _e9089 = select(_e8324, _e9087, (_e9087 < _e8324));
let _e9094 = global_7.member[bitcast<u32>(select(0i, _e9089, (_e9089 > 0i)))];
let _e9095 = local_2;
let _e9098 = (1f - _e9036);
let _e9100 = (_e9075 + _e9055);
let _e9102 = select(_e8324, _e9100, (_e9100 < _e8324));
let _e9107 = global_7.member[bitcast<u32>(select(0i, _e9102, (_e9102 > 0i)))];
let _e9108 = local_2;
let _e9111 = local_3;
let _e9112 = (_e9100 + _e9111);
let _e9114 = select(_e8324, _e9112, (_e9112 < _e8324));
let _e9119 = global_7.member[bitcast<u32>(select(0i, _e9114, (_e9114 > 0i)))];
let _e9120 = local_2;
let _e9125 = (_e9075 + (((_e9062 - _e9032) * _e8944) * _e8949));
let _e9127 = select(_e8324, _e9125, (_e9125 < _e8324));
let _e9132 = global_7.member[bitcast<u32>(select(0i, _e9127, (_e9127 > 0i)))];
let _e9133 = local_2;
let _e9136 = local_3;
let _e9137 = (_e9125 + _e9136);
let _e9139 = select(_e8324, _e9137, (_e9137 < _e8324));
let _e9144 = global_7.member[bitcast<u32>(select(0i, _e9139, (_e9139 > 0i)))];
let _e9145 = local_2;
let _e9149 = (_e9125 + _e9055);
let _e9151 = select(_e8324, _e9149, (_e9149 < _e8324));
let _e9156 = global_7.member[bitcast<u32>(select(0i, _e9151, (_e9151 > 0i)))];
let _e9157 = local_2;
let _e9160 = local_3;
let _e9161 = (_e9149 + _e9160);
let _e9163 = select(_e8324, _e9161, (_e9161 < _e8324));
let _e9168 = global_7.member[bitcast<u32>(select(0i, _e9163, (_e9163 > 0i)))];
let _e9169 = local_2;
let _e9178 = (_e8930 + _e8932);
let _e9188 = (((((_e8301.member.x + (_e8847 * _e9178)) - _e797.member) / _e8957) * _e8955) - 0.5f);
let _e9190 = select(0f, _e9188, (_e9188 > 0f));
let _e9192 = select(_e8961, _e9190, (_e9190 < _e8961));
let _e9196 = (((((_e8301.member.y + (_e8849 * _e9178)) - _e797.member_1) / _e8968) * _e8966) - 0.5f);
let _e9198 = select(0f, _e9196, (_e9196 > 0f));
let _e9200 = select(_e8972, _e9198, (_e9198 < _e8972));
let _e9204 = (((((_e8301.member.z + (_e8851 * _e9178)) - _e797.member_2) / _e8979) * _e8977) - 0.5f);
let _e9206 = select(0f, _e9204, (_e9204 > 0f));
let _e9208 = select(_e8983, _e9206, (_e9206 < _e8983));
let _e9210 = select(0f, _e9192, (_e9192 > 0f));
let _e9212 = select(1e6f, _e9210, (_e9210 < 1e6f));
let _e9219 = select(0i, select(select(i32(_e9212), i32(-2147483648), (_e9212 < -2147483600f)), 2147483647i, (_e9212 > 2147483500f)), (_e9212 == _e9212));
let _e9223 = (_e9219 - select(0i, 1i, (_e9212 < f32(_e9219))));
let _e9225 = select(0f, _e9200, (_e9200 > 0f));
let _e9227 = select(1e6f, _e9225, (_e9225 < 1e6f));
let _e9234 = select(0i, select(select(i32(_e9227), i32(-2147483648), (_e9227 < -2147483600f)), 2147483647i, (_e9227 > 2147483500f)), (_e9227 == _e9227));
let _e9238 = (_e9234 - select(0i, 1i, (_e9227 < f32(_e9234))));
let _e9240 = select(0f, _e9208, (_e9208 > 0f));
let _e9242 = select(1e6f, _e9240, (_e9240 < 1e6f));
let _e9249 = select(0i, select(select(i32(_e9242), i32(-2147483648), (_e9242 < -2147483600f)), 2147483647i, (_e9242 > 2147483500f)), (_e9242 == _e9242));
let _e9253 = (_e9249 - select(0i, 1i, (_e9242 < f32(_e9249))));
let _e9257 = (_e9200 - f32(_e9238));
let _e9259 = (_e9208 - f32(_e9253));
local = (_e9192 - f32(_e9223));
let _e9260 = (_e9223 + 1i);
let _e9262 = select(_e9260, 0i, (_e9260 < 0i));
if (_e9262 >= _e8944) {
phi_16309_ = (_e8944 - 1i);
} else {
phi_16309_ = _e9262;
}
let _e9266 = phi_16309_;
local_1 = (_e9266 - _e9223);
let _e9268 = (_e9238 + 1i);
let _e9270 = select(_e9268, 0i, (_e9268 < 0i));
if (_e9270 >= _e8949) {
phi_16322_ = (_e8949 - 1i);
} else {
phi_16322_ = _e9270;
}
let _e9274 = phi_16322_;
let _e9276 = ((_e9274 - _e9238) * _e8944);
let _e9277 = (_e9253 + 1i);
let _e9279 = select(_e9277, 0i, (_e9277 < 0i));
if (_e9279 >= _e8954) {
phi_16336_ = (_e8954 - 1i);
} else {
phi_16336_ = _e9279;
}
let _e9283 = phi_16336_;
let _e9291 = ((_e9070 + (((_e9253 * _e8949) + _e9238) * _e8944)) + _e9223);
let _e9293 = select(_e8324, _e9291, (_e9291 < _e8324));
let _e9298 = global_7.member[bitcast<u32>(select(0i, _e9293, (_e9293 > 0i)))];
let _e9299 = local;
let _e9302 = local_1;
let _e9303 = (_e9291 + _e9302);
let _e9305 = select(_e8324, _e9303, (_e9303 < _e8324));
let _e9310 = global_7.member[bitcast<u32>(select(0i, _e9305, (_e9305 > 0i)))];
let _e9311 = local;
let _e9314 = (1f - _e9257);
let _e9316 = (_e9291 + _e9276);
let _e9318 = select(_e8324, _e9316, (_e9316 < _e8324));
let _e9323 = global_7.member[bitcast<u32>(select(0i, _e9318, (_e9318 > 0i)))];
let _e9324 = local;
let _e9327 = local_1;
let _e9328 = (_e9316 + _e9327);
let _e9330 = select(_e8324, _e9328, (_e9328 < _e8324));
let _e9335 = global_7.member[bitcast<u32>(select(0i, _e9330, (_e9330 > 0i)))];
let _e9336 = local;
let _e9341 = (_e9291 + (((_e9283 - _e9253) * _e8944) * _e8949));
let _e9343 = select(_e8324, _e9341, (_e9341 < _e8324));
let _e9348 = global_7.member[bitcast<u32>(select(0i, _e9343, (_e9343 > 0i)))];
let _e9349 = local;
let _e9352 = local_1;
let _e9353 = (_e9341 + _e9352);
let _e9355 = select(_e8324, _e9353, (_e9353 < _e8324));
let _e9360 = global_7.member[bitcast<u32>(select(0i, _e9355, (_e9355 > 0i)))];
let _e9361 = local;
let _e9365 = (_e9341 + _e9276);
let _e9367 = select(_e8324, _e9365, (_e9365 < _e8324));
let _e9372 = global_7.member[bitcast<u32>(select(0i, _e9367, (_e9367 > 0i)))];
let _e9373 = local;
let _e9376 = local_1;
let _e9377 = (_e9365 + _e9376);
let _e9379 = select(_e8324, _e9377, (_e9377 < _e8324));
let _e9384 = global_7.member[bitcast<u32>(select(0i, _e9379, (_e9379 > 0i)))];
let _e9385 = local;
phi_15823_ = (_e8919 + 1u);
phi_15826_ = (_e8921 + ((0.5f * (((((((_e9082 * (1f - _e9083)) + (_e9094 * _e9095)) * _e9098) + (((_e9107 * (1f - _e9108)) + (_e9119 * _e9120)) * _e9036)) * (1f - _e9038)) + (((((_e9132 * (1f - _e9133)) + (_e9144 * _e9145)) * _e9098) + (((_e9156 * (1f - _e9157)) + (_e9168 * _e9169)) * _e9036)) * _e9038)) + ((((((_e9298 * (1f - _e9299)) + (_e9310 * _e9311)) * _e9314) + (((_e9323 * (1f - _e9324)) + (_e9335 * _e9336)) * _e9257)) * (1f - _e9259)) + (((((_e9348 * (1f - _e9349)) + (_e9360 * _e9361)) * _e9314) + (((_e9372 * (1f - _e9373)) + (_e9384 * _e9385)) * _e9257)) * _e9259)))) * _e8931));
} else {
phi_15823_ = u32();
phi_15826_ = f32();
}
let _e9400 = phi_15823_;
let _e9402 = phi_15826_;
continue;
continuing {
phi_15822_ = _e9400;
phi_15825_ = _e9402;
break if !(_e8924);
}
}
let _e10996 = local_82;
phi_16541_ = _e10996;
}
let _e9405 = phi_16541_;
let _e9407 = -((_e1348.member * _e9405));
let _e9409 = select(-87f, _e9407, (_e9407 > -87f));
let _e9411 = select(88f, _e9409, (_e9409 < 88f));
let _e9413 = ((_e9411 * 1.442695f) + 0.5f);
let _e9415 = select(-127f, _e9413, (_e9413 > -127f));
let _e9417 = select(128f, _e9415, (_e9415 < 128f));
let _e9424 = select(0i, select(select(i32(_e9417), i32(-2147483648), (_e9417 < -2147483600f)), 2147483647i, (_e9417 > 2147483500f)), (_e9417 == _e9417));
let _e9428 = (_e9424 - select(0i, 1i, (_e9417 < f32(_e9424))));
let _e9429 = f32(_e9428);
let _e9433 = ((_e9411 - (_e9429 * 0.6933594f)) - (_e9429 * -2.1219444e-4f));
let _e9455 = -((_e1348.member_1 * _e9405));
let _e9457 = select(-87f, _e9455, (_e9455 > -87f));
let _e9459 = select(88f, _e9457, (_e9457 < 88f));
let _e9461 = ((_e9459 * 1.442695f) + 0.5f);
let _e9463 = select(-127f, _e9461, (_e9461 > -127f));
let _e9465 = select(128f, _e9463, (_e9463 < 128f));
let _e9472 = select(0i, select(select(i32(_e9465), i32(-2147483648), (_e9465 < -2147483600f)), 2147483647i, (_e9465 > 2147483500f)), (_e9465 == _e9465));
let _e9476 = (_e9472 - select(0i, 1i, (_e9465 < f32(_e9472))));
let _e9477 = f32(_e9476);
let _e9481 = ((_e9459 - (_e9477 * 0.6933594f)) - (_e9477 * -2.1219444e-4f));
let _e9503 = -((_e1348.member_2 * _e9405));
let _e9505 = select(-87f, _e9503, (_e9503 > -87f));
let _e9507 = select(88f, _e9505, (_e9505 < 88f));
let _e9509 = ((_e9507 * 1.442695f) + 0.5f);
let _e9511 = select(-127f, _e9509, (_e9509 > -127f));
let _e9513 = select(128f, _e9511, (_e9511 < 128f));
let _e9520 = select(0i, select(select(i32(_e9513), i32(-2147483648), (_e9513 < -2147483600f)), 2147483647i, (_e9513 > 2147483500f)), (_e9513 == _e9513));
let _e9524 = (_e9520 - select(0i, 1i, (_e9513 < f32(_e9520))));
let _e9525 = f32(_e9524);
let _e9529 = ((_e9507 - (_e9525 * 0.6933594f)) - (_e9525 * -2.1219444e-4f));
let _e9550 = (1f - _e8822);
let _e9562 = (((_e8301.member_1.x * _e511) + (_e8301.member_1.y * _e522)) + (_e8301.member_1.z * _e533));
let _e9564 = select(1f, -1f, (_e9562 > 0f));
let _e9576 = select(_e9564, -(_e9564), ((((_e8301.member_2.x * _e8301.member_1.x) + (_e8301.member_2.y * _e8301.member_1.y)) + (_e8301.member_2.z * _e8301.member_1.z)) < 0f));
let _e9577 = (_e8301.member_2.x * _e9576);
let _e9578 = (_e8301.member_2.y * _e9576);
let _e9579 = (_e8301.member_2.z * _e9576);
let _e9588 = ((((_e9577 * _e511) + (_e9578 * _e522)) + (_e9579 * _e533)) > 0f);
let _e9597 = -((((select(_e9577, (_e8301.member_1.x * _e9564), _e9588) * _e8812.member.x) + (select(_e9578, (_e8301.member_1.y * _e9564), _e9588) * _e8812.member.y)) + (select(_e9579, (_e8301.member_1.z * _e9564), _e9588) * _e8812.member.z)));
let _e9607 = -(_e9597);
let _e9612 = select((select(0f, _e9607, (_e9607 > 0f)) * _e8301.member_4), select(0f, _e9597, (_e9597 > 0f)), (((((_e8301.member_1.x * _e8812.member.x) + (_e8301.member_1.y * _e8812.member.y)) + (_e8301.member_1.z * _e8812.member.z)) * _e9562) > 0f));
let _e9626 = global_1.member.member_16;
phi_16893_ = type_24(_e8443.member, _e8443.member_1, _e8443.member_2, vec3<f32>((_e8443.member_3.x + (((_e8301.member_3.x * (((_e8812.member_1.x * (((1f + (_e9433 * (1f + (_e9433 * (0.5f + (_e9433 * (0.16666667f + (_e9433 * (0.041666668f + (_e9433 * (0.008333334f + (_e9433 * (0.001388889f + (_e9433 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9428 + 127i)) << bitcast<u32>(23i)))) * _e9550)) * _e9612) + _e9626.member)) * _e1399) * _e767)), (_e8443.member_3.y + (((_e8301.member_3.y * (((_e8812.member_1.y * (((1f + (_e9481 * (1f + (_e9481 * (0.5f + (_e9481 * (0.16666667f + (_e9481 * (0.041666668f + (_e9481 * (0.008333334f + (_e9481 * (0.001388889f + (_e9481 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9476 + 127i)) << bitcast<u32>(23i)))) * _e9550)) * _e9612) + _e9626.member_1)) * _e1447) * _e768)), (_e8443.member_3.z + (((_e8301.member_3.z * (((_e8812.member_1.z * (((1f + (_e9529 * (1f + (_e9529 * (0.5f + (_e9529 * (0.16666667f + (_e9529 * (0.041666668f + (_e9529 * (0.008333334f + (_e9529 * (0.001388889f + (_e9529 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9524 + 127i)) << bitcast<u32>(23i)))) * _e9550)) * _e9612) + _e9626.member_2)) * _e1495) * _e769))), _e8443.member_4, _e8443.member_5, _e8443.member_6, _e8443.member_7, _e8443.member_8);
} else {
phi_16893_ = _e8443;
}
let _e9665 = phi_16893_;
phi_16894_ = _e9665;
}
let _e10786 = phi_16894_;
global_6.member[_e202] = _e10786.member;
global_6.member[_e214] = _e10786.member_1;
global_6.member[_e225] = _e10786.member_2;
global_6.member[_e236] = _e10786.member_3.x;
global_6.member[_e247] = _e10786.member_3.y;
global_6.member[_e258] = _e10786.member_3.z;
global_6.member[_e269] = _e10786.member_4.x;
global_6.member[_e280] = _e10786.member_4.y;
global_6.member[_e291] = _e10786.member_4.z;
global_6.member[_e302] = _e10786.member_5.x;
global_6.member[_e313] = _e10786.member_5.y;
global_6.member[_e324] = _e10786.member_5.z;
global_6.member[_e335] = _e10786.member_6.x;
global_6.member[_e346] = _e10786.member_6.y;
global_6.member[_e357] = _e10786.member_6.z;
global_6.member[_e368] = _e10786.member_7;
global_6.member[_e379] = _e10786.member_8.x;
global_6.member[_e390] = _e10786.member_8.y;
global_6.member[_e401] = _e10786.member_8.z;
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
