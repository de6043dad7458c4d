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
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_9,
member_18: type_11,
member_19: type_5,
member_20: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_21 {
member: array<u32>,
}
struct type_22 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
struct type_23 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(2)
var<storage> global_4: type_16;
@group(0) @binding(4)
var<storage> global_5: type_16;
@group(0) @binding(5)
var<storage> global_6: type_21;
@group(0) @binding(6)
var<storage> global_7: type_16;
@group(0) @binding(7)
var<storage, read_write> global_8: type_16;
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
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: i32;
var local_17: i32;
var local_18: i32;
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var local_32: i32;
var local_33: i32;
var local_34: i32;
var local_35: i32;
var local_36: i32;
var local_37: i32;
var local_38: i32;
var local_39: i32;
var local_40: i32;
var local_41: i32;
var phi_2394_: vec3<f32>;
var phi_2996_: i32;
var phi_2999_: i32;
var phi_3001_: i32;
var phi_3003_: i32;
var phi_3018_: i32;
var phi_3024_: i32;
var phi_2997_: i32;
var phi_3000_: i32;
var phi_3002_: i32;
var phi_3004_: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var phi_3099_: i32;
var local_45: i32;
var local_46: i32;
var phi_3105_: i32;
var local_47: i32;
var phi_3112_: i32;
var local_48: i32;
var local_49: i32;
var phi_3118_: i32;
var local_50: i32;
var local_51: i32;
var phi_3129_: i32;
var local_52: i32;
var local_53: i32;
var phi_3141_: i32;
var local_54: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var phi_3377_: i32;
var phi_3380_: i32;
var phi_3382_: i32;
var phi_3384_: i32;
var phi_3399_: i32;
var phi_3405_: i32;
var phi_3378_: i32;
var phi_3381_: i32;
var phi_3383_: i32;
var phi_3385_: i32;
var local_58: i32;
var local_59: i32;
var local_60: i32;
var phi_3480_: i32;
var local_61: i32;
var local_62: i32;
var phi_3486_: i32;
var local_63: i32;
var phi_3493_: i32;
var local_64: i32;
var local_65: i32;
var phi_3499_: i32;
var local_66: i32;
var local_67: i32;
var phi_3510_: i32;
var local_68: i32;
var local_69: i32;
var phi_3522_: i32;
var local_70: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var phi_3777_: vec3<f32>;
var phi_3778_: vec3<f32>;
var phi_3779_: vec3<f32>;
var phi_4616_: type_22;
var phi_5190_: vec3<f32>;
var phi_5193_: vec3<f32>;
var phi_5206_: type_23;
var phi_5662_: f32;
var phi_5665_: vec3<f32>;
var phi_5667_: i32;
var phi_5682_: i32;
var phi_5685_: f32;
var phi_5687_: vec3<f32>;
var phi_5920_: vec3<f32>;
var phi_5930_: vec3<f32>;
var phi_5683_: i32;
var phi_5686_: f32;
var phi_5688_: vec3<f32>;
var phi_5663_: f32;
var phi_5666_: vec3<f32>;
var phi_5668_: i32;
var local_74: f32;
var local_75: f32;
var local_76: vec3<f32>;
var local_77: vec3<f32>;
var local_78: vec3<f32>;
var phi_6052_: vec3<f32>;
var phi_6053_: vec3<f32>;
var phi_6054_: vec3<f32>;
var phi_6454_: vec3<f32>;
var phi_7056_: i32;
var phi_7059_: i32;
var phi_7061_: i32;
var phi_7063_: i32;
var phi_7078_: i32;
var phi_7084_: i32;
var phi_7057_: i32;
var phi_7060_: i32;
var phi_7062_: i32;
var phi_7064_: i32;
var local_79: i32;
var local_80: i32;
var local_81: i32;
var phi_7159_: i32;
var local_82: i32;
var local_83: i32;
var phi_7165_: i32;
var local_84: i32;
var phi_7172_: i32;
var local_85: i32;
var local_86: i32;
var phi_7178_: i32;
var local_87: i32;
var local_88: i32;
var phi_7189_: i32;
var local_89: i32;
var local_90: i32;
var phi_7201_: i32;
var local_91: i32;
var local_92: i32;
var local_93: i32;
var local_94: i32;
var phi_7437_: i32;
var phi_7440_: i32;
var phi_7442_: i32;
var phi_7444_: i32;
var phi_7459_: i32;
var phi_7465_: i32;
var phi_7438_: i32;
var phi_7441_: i32;
var phi_7443_: i32;
var phi_7445_: i32;
var local_95: i32;
var local_96: i32;
var local_97: i32;
var phi_7540_: i32;
var local_98: i32;
var local_99: i32;
var phi_7546_: i32;
var local_100: i32;
var phi_7553_: i32;
var local_101: i32;
var local_102: i32;
var phi_7559_: i32;
var local_103: i32;
var local_104: i32;
var phi_7570_: i32;
var local_105: i32;
var local_106: i32;
var phi_7582_: i32;
var local_107: i32;
var local_108: i32;
var local_109: i32;
var local_110: i32;
var phi_7837_: vec3<f32>;
var phi_7838_: vec3<f32>;
var phi_7839_: vec3<f32>;
var phi_8814_: type_22;
var phi_9388_: vec3<f32>;
var phi_9391_: vec3<f32>;
var phi_9404_: type_23;
var phi_9860_: f32;
var phi_9863_: vec3<f32>;
var phi_9865_: i32;
var phi_9880_: i32;
var phi_9883_: f32;
var phi_9885_: vec3<f32>;
var phi_10118_: vec3<f32>;
var phi_10128_: vec3<f32>;
var phi_9881_: i32;
var phi_9884_: f32;
var phi_9886_: vec3<f32>;
var phi_9861_: f32;
var phi_9864_: vec3<f32>;
var phi_9866_: i32;
var local_111: f32;
var local_112: f32;
var local_113: vec3<f32>;
var local_114: vec3<f32>;
var local_115: vec3<f32>;
var phi_10180_: vec3<f32>;
var phi_10181_: vec3<f32>;
var local_116: f32;
var local_117: vec3<f32>;
var local_118: f32;
var local_119: vec3<f32>;
let _e147 = global;
let _e153 = arrayLength((&global_4.member));
let _e155 = arrayLength((&global_3.member));
let _e157 = arrayLength((&global_5.member));
let _e159 = arrayLength((&global_6.member));
let _e165 = global_1.member.member;
if (_e147.x < _e165.member) {
if (_e147.y < _e165.member_1) {
let _e172 = (_e165.member * _e165.member_1);
let _e174 = ((_e147.y * _e165.member) + _e147.x);
let _e176 = bitcast<i32>(_e147.x);
let _e177 = bitcast<i32>(_e147.y);
let _e181 = global_1.member.member.member;
let _e182 = bitcast<i32>(_e181);
let _e183 = (_e177 * _e182);
let _e184 = (_e183 + _e176);
local_40 = _e184;
let _e188 = global_1.member.member.member_1;
let _e190 = bitcast<i32>((_e181 * _e188));
local_41 = _e190;
let _e191 = local_40;
local_38 = _e191;
local_39 = _e190;
let _e192 = local_39;
let _e194 = local_38;
let _e195 = ((3i * _e192) + _e194);
let _e197 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e199 = select(_e197, _e195, (_e195 < _e197));
let _e204 = global_2.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e205 = local_39;
let _e207 = local_38;
let _e208 = ((4i * _e205) + _e207);
let _e210 = select(_e197, _e208, (_e208 < _e197));
let _e215 = global_2.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e216 = local_39;
let _e218 = local_38;
let _e219 = ((5i * _e216) + _e218);
let _e221 = select(_e197, _e219, (_e219 < _e197));
let _e226 = global_2.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e227 = local_40;
local_36 = _e227;
local_37 = _e190;
let _e228 = local_37;
let _e230 = local_36;
let _e231 = ((6i * _e228) + _e230);
let _e233 = select(_e197, _e231, (_e231 < _e197));
let _e238 = global_2.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e239 = local_37;
let _e241 = local_36;
let _e242 = ((7i * _e239) + _e241);
let _e244 = select(_e197, _e242, (_e242 < _e197));
let _e249 = global_2.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e250 = local_37;
let _e252 = local_36;
let _e253 = ((8i * _e250) + _e252);
let _e255 = select(_e197, _e253, (_e253 < _e197));
let _e260 = global_2.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e261 = local_41;
let _e263 = local_40;
let _e264 = ((18i * _e261) + _e263);
let _e266 = select(_e197, _e264, (_e264 < _e197));
let _e271 = global_2.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e272 = local_41;
let _e274 = local_40;
let _e275 = ((16i * _e272) + _e274);
let _e277 = select(_e197, _e275, (_e275 < _e197));
let _e282 = global_2.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e283 = (_e165.member_2 == 1u);
let _e285 = (_e283 && (_e282 == 3f));
let _e286 = local_40;
local_34 = _e286;
local_35 = _e190;
let _e287 = local_35;
let _e289 = local_34;
let _e290 = ((9i * _e287) + _e289);
let _e292 = select(_e197, _e290, (_e290 < _e197));
let _e297 = global_2.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e298 = local_35;
let _e300 = local_34;
let _e301 = ((10i * _e298) + _e300);
let _e303 = select(_e197, _e301, (_e301 < _e197));
let _e308 = global_2.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e309 = local_35;
let _e311 = local_34;
let _e312 = ((11i * _e309) + _e311);
let _e314 = select(_e197, _e312, (_e312 < _e197));
let _e319 = global_2.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e320 = vec3<f32>(_e297, _e308, _e319);
let _e321 = (_e176 - 1i);
let _e322 = bitcast<i32>(_e188);
local_31 = _e182;
local_32 = _e322;
let _e324 = local_31;
let _e327 = (_e177 >= 0i);
let _e329 = local_32;
let _e331 = ((((_e321 >= 0i) && (_e321 < _e324)) && _e327) && (_e177 < _e329));
if _e331 {
let _e332 = local_31;
local_33 = ((_e177 * _e332) + _e321);
} else {
local_33 = 0i;
}
let _e335 = local_31;
let _e336 = local_32;
let _e339 = local_33;
let _e340 = ((18i * (_e335 * _e336)) + _e339);
let _e342 = select(_e197, _e340, (_e340 < _e197));
let _e347 = global_2.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e350 = local_31;
let _e351 = local_32;
let _e354 = local_33;
let _e355 = ((16i * (_e350 * _e351)) + _e354);
let _e357 = select(_e197, _e355, (_e355 < _e197));
let _e362 = global_2.member[bitcast<u32>(select(0i, _e357, (_e357 > 0i)))];
let _e364 = ((_e331 && (_e347 == _e271)) && (_e362 == _e282));
let _e365 = local_33;
local_29 = _e365;
local_30 = _e190;
let _e366 = local_30;
let _e368 = local_29;
let _e369 = ((3i * _e366) + _e368);
let _e371 = select(_e197, _e369, (_e369 < _e197));
let _e376 = global_2.member[bitcast<u32>(select(0i, _e371, (_e371 > 0i)))];
let _e377 = local_30;
let _e379 = local_29;
let _e380 = ((4i * _e377) + _e379);
let _e382 = select(_e197, _e380, (_e380 < _e197));
let _e387 = global_2.member[bitcast<u32>(select(0i, _e382, (_e382 > 0i)))];
let _e388 = local_30;
let _e390 = local_29;
let _e391 = ((5i * _e388) + _e390);
let _e393 = select(_e197, _e391, (_e391 < _e197));
let _e398 = global_2.member[bitcast<u32>(select(0i, _e393, (_e393 > 0i)))];
let _e399 = local_31;
let _e400 = local_32;
let _e403 = local_33;
let _e404 = ((21i * (_e399 * _e400)) + _e403);
let _e406 = select(_e197, _e404, (_e404 < _e197));
let _e411 = global_2.member[bitcast<u32>(select(0i, _e406, (_e406 > 0i)))];
let _e413 = (_e331 && (_e411 > 0f));
let _e414 = f32(_e182);
let _e415 = f32(_e322);
let _e424 = global_1.member.member_6.member;
let _e425 = (((((f32(_e321) + 0.5f) / _e414) * 2f) - 1f) * _e424);
let _e434 = global_1.member.member_6.member_1;
let _e435 = ((1f - (((f32(_e177) + 0.5f) / _e415) * 2f)) * _e434);
let _e438 = global_1.member.member_7;
let _e447 = global_1.member.member_8;
let _e451 = (_e447.member * _e435);
let _e452 = (_e447.member_1 * _e435);
let _e453 = (_e447.member_2 * _e435);
let _e460 = global_1.member.member_6.member_3;
let _e462 = select(1f, 0f, (_e460 != 0u));
let _e465 = global_1.member.member_9;
let _e472 = (_e465.member + (((_e438.member * _e425) + _e451) * _e462));
let _e473 = (_e465.member_1 + (((_e438.member_1 * _e425) + _e452) * _e462));
let _e474 = (_e465.member_2 + (((_e438.member_2 * _e425) + _e453) * _e462));
let _e479 = (((_e472 * _e472) + (_e473 * _e473)) + (_e474 * _e474));
let _e482 = sqrt(select(0f, _e479, (_e479 > 0f)));
let _e485 = (1f / select(1e-20f, _e482, (_e482 > 1e-20f)));
let _e486 = (_e472 * _e485);
let _e487 = (_e473 * _e485);
let _e488 = (_e474 * _e485);
local_27 = (_e183 + _e321);
local_28 = _e190;
let _e490 = local_28;
let _e492 = local_27;
let _e493 = ((9i * _e490) + _e492);
let _e495 = select(_e197, _e493, (_e493 < _e197));
let _e500 = global_2.member[bitcast<u32>(select(0i, _e495, (_e495 > 0i)))];
let _e501 = local_28;
let _e503 = local_27;
let _e504 = ((10i * _e501) + _e503);
let _e506 = select(_e197, _e504, (_e504 < _e197));
let _e511 = global_2.member[bitcast<u32>(select(0i, _e506, (_e506 > 0i)))];
let _e512 = local_28;
let _e514 = local_27;
let _e515 = ((11i * _e512) + _e514);
let _e517 = select(_e197, _e515, (_e515 < _e197));
let _e522 = global_2.member[bitcast<u32>(select(0i, _e517, (_e517 > 0i)))];
let _e528 = (2f * (((_e486 * _e500) + (_e487 * _e511)) + (_e488 * _e522)));
let _e532 = (_e486 - (_e500 * _e528));
let _e533 = (_e487 - (_e511 * _e528));
let _e534 = (_e488 - (_e522 * _e528));
let _e535 = (_e176 + 1i);
local_24 = _e182;
local_25 = _e322;
let _e537 = local_24;
let _e541 = local_25;
let _e543 = ((((_e535 >= 0i) && (_e535 < _e537)) && _e327) && (_e177 < _e541));
if _e543 {
let _e544 = local_24;
local_26 = ((_e177 * _e544) + _e535);
} else {
local_26 = 0i;
}
let _e547 = local_24;
let _e548 = local_25;
let _e551 = local_26;
let _e552 = ((18i * (_e547 * _e548)) + _e551);
let _e554 = select(_e197, _e552, (_e552 < _e197));
let _e559 = global_2.member[bitcast<u32>(select(0i, _e554, (_e554 > 0i)))];
let _e562 = local_24;
let _e563 = local_25;
let _e566 = local_26;
let _e567 = ((16i * (_e562 * _e563)) + _e566);
let _e569 = select(_e197, _e567, (_e567 < _e197));
let _e574 = global_2.member[bitcast<u32>(select(0i, _e569, (_e569 > 0i)))];
let _e576 = ((_e543 && (_e559 == _e271)) && (_e574 == _e282));
let _e577 = local_26;
local_22 = _e577;
local_23 = _e190;
let _e578 = local_23;
let _e580 = local_22;
let _e581 = ((3i * _e578) + _e580);
let _e583 = select(_e197, _e581, (_e581 < _e197));
let _e588 = global_2.member[bitcast<u32>(select(0i, _e583, (_e583 > 0i)))];
let _e589 = local_23;
let _e591 = local_22;
let _e592 = ((4i * _e589) + _e591);
let _e594 = select(_e197, _e592, (_e592 < _e197));
let _e599 = global_2.member[bitcast<u32>(select(0i, _e594, (_e594 > 0i)))];
let _e600 = local_23;
let _e602 = local_22;
let _e603 = ((5i * _e600) + _e602);
let _e605 = select(_e197, _e603, (_e603 < _e197));
let _e610 = global_2.member[bitcast<u32>(select(0i, _e605, (_e605 > 0i)))];
let _e611 = local_24;
let _e612 = local_25;
let _e615 = local_26;
let _e616 = ((21i * (_e611 * _e612)) + _e615);
let _e618 = select(_e197, _e616, (_e616 < _e197));
let _e623 = global_2.member[bitcast<u32>(select(0i, _e618, (_e618 > 0i)))];
let _e625 = (_e543 && (_e623 > 0f));
let _e631 = (((((f32(_e535) + 0.5f) / _e414) * 2f) - 1f) * _e424);
let _e641 = (_e465.member + (((_e438.member * _e631) + _e451) * _e462));
let _e642 = (_e465.member_1 + (((_e438.member_1 * _e631) + _e452) * _e462));
let _e643 = (_e465.member_2 + (((_e438.member_2 * _e631) + _e453) * _e462));
let _e648 = (((_e641 * _e641) + (_e642 * _e642)) + (_e643 * _e643));
let _e651 = sqrt(select(0f, _e648, (_e648 > 0f)));
let _e654 = (1f / select(1e-20f, _e651, (_e651 > 1e-20f)));
let _e655 = (_e641 * _e654);
let _e656 = (_e642 * _e654);
let _e657 = (_e643 * _e654);
local_20 = (_e183 + _e535);
local_21 = _e190;
let _e659 = local_21;
let _e661 = local_20;
let _e662 = ((9i * _e659) + _e661);
let _e664 = select(_e197, _e662, (_e662 < _e197));
let _e669 = global_2.member[bitcast<u32>(select(0i, _e664, (_e664 > 0i)))];
let _e670 = local_21;
let _e672 = local_20;
let _e673 = ((10i * _e670) + _e672);
let _e675 = select(_e197, _e673, (_e673 < _e197));
let _e680 = global_2.member[bitcast<u32>(select(0i, _e675, (_e675 > 0i)))];
let _e681 = local_21;
let _e683 = local_20;
let _e684 = ((11i * _e681) + _e683);
let _e686 = select(_e197, _e684, (_e684 < _e197));
let _e691 = global_2.member[bitcast<u32>(select(0i, _e686, (_e686 > 0i)))];
let _e697 = (2f * (((_e655 * _e669) + (_e656 * _e680)) + (_e657 * _e691)));
let _e701 = (_e655 - (_e669 * _e697));
let _e702 = (_e656 - (_e680 * _e697));
let _e703 = (_e657 - (_e691 * _e697));
let _e704 = (_e177 - 1i);
local_17 = _e182;
local_18 = _e322;
let _e705 = (_e176 >= 0i);
let _e706 = local_17;
let _e711 = local_18;
let _e713 = (((_e705 && (_e176 < _e706)) && (_e704 >= 0i)) && (_e704 < _e711));
if _e713 {
let _e714 = local_17;
local_19 = ((_e704 * _e714) + _e176);
} else {
local_19 = 0i;
}
let _e717 = local_17;
let _e718 = local_18;
let _e721 = local_19;
let _e722 = ((18i * (_e717 * _e718)) + _e721);
let _e724 = select(_e197, _e722, (_e722 < _e197));
let _e729 = global_2.member[bitcast<u32>(select(0i, _e724, (_e724 > 0i)))];
let _e732 = local_17;
let _e733 = local_18;
let _e736 = local_19;
let _e737 = ((16i * (_e732 * _e733)) + _e736);
let _e739 = select(_e197, _e737, (_e737 < _e197));
let _e744 = global_2.member[bitcast<u32>(select(0i, _e739, (_e739 > 0i)))];
let _e746 = ((_e713 && (_e729 == _e271)) && (_e744 == _e282));
let _e747 = local_19;
local_15 = _e747;
local_16 = _e190;
let _e748 = local_16;
let _e750 = local_15;
let _e751 = ((3i * _e748) + _e750);
let _e753 = select(_e197, _e751, (_e751 < _e197));
let _e758 = global_2.member[bitcast<u32>(select(0i, _e753, (_e753 > 0i)))];
let _e759 = local_16;
let _e761 = local_15;
let _e762 = ((4i * _e759) + _e761);
let _e764 = select(_e197, _e762, (_e762 < _e197));
let _e769 = global_2.member[bitcast<u32>(select(0i, _e764, (_e764 > 0i)))];
let _e770 = local_16;
let _e772 = local_15;
let _e773 = ((5i * _e770) + _e772);
let _e775 = select(_e197, _e773, (_e773 < _e197));
let _e780 = global_2.member[bitcast<u32>(select(0i, _e775, (_e775 > 0i)))];
let _e781 = local_17;
let _e782 = local_18;
let _e785 = local_19;
let _e786 = ((21i * (_e781 * _e782)) + _e785);
let _e788 = select(_e197, _e786, (_e786 < _e197));
let _e793 = global_2.member[bitcast<u32>(select(0i, _e788, (_e788 > 0i)))];
let _e795 = (_e713 && (_e793 > 0f));
let _e801 = (((((f32(_e176) + 0.5f) / _e414) * 2f) - 1f) * _e424);
let _e807 = ((1f - (((f32(_e704) + 0.5f) / _e415) * 2f)) * _e434);
let _e808 = (_e438.member * _e801);
let _e809 = (_e438.member_1 * _e801);
let _e810 = (_e438.member_2 * _e801);
let _e820 = (_e465.member + ((_e808 + (_e447.member * _e807)) * _e462));
let _e821 = (_e465.member_1 + ((_e809 + (_e447.member_1 * _e807)) * _e462));
let _e822 = (_e465.member_2 + ((_e810 + (_e447.member_2 * _e807)) * _e462));
let _e827 = (((_e820 * _e820) + (_e821 * _e821)) + (_e822 * _e822));
let _e830 = sqrt(select(0f, _e827, (_e827 > 0f)));
let _e833 = (1f / select(1e-20f, _e830, (_e830 > 1e-20f)));
let _e834 = (_e820 * _e833);
let _e835 = (_e821 * _e833);
let _e836 = (_e822 * _e833);
local_13 = ((_e704 * _e182) + _e176);
local_14 = _e190;
let _e839 = local_14;
let _e841 = local_13;
let _e842 = ((9i * _e839) + _e841);
let _e844 = select(_e197, _e842, (_e842 < _e197));
let _e849 = global_2.member[bitcast<u32>(select(0i, _e844, (_e844 > 0i)))];
let _e850 = local_14;
let _e852 = local_13;
let _e853 = ((10i * _e850) + _e852);
let _e855 = select(_e197, _e853, (_e853 < _e197));
let _e860 = global_2.member[bitcast<u32>(select(0i, _e855, (_e855 > 0i)))];
let _e861 = local_14;
let _e863 = local_13;
let _e864 = ((11i * _e861) + _e863);
let _e866 = select(_e197, _e864, (_e864 < _e197));
let _e871 = global_2.member[bitcast<u32>(select(0i, _e866, (_e866 > 0i)))];
let _e877 = (2f * (((_e834 * _e849) + (_e835 * _e860)) + (_e836 * _e871)));
let _e881 = (_e834 - (_e849 * _e877));
let _e882 = (_e835 - (_e860 * _e877));
let _e883 = (_e836 - (_e871 * _e877));
let _e884 = (_e177 + 1i);
local_10 = _e182;
local_11 = _e322;
let _e885 = local_10;
let _e890 = local_11;
let _e892 = (((_e705 && (_e176 < _e885)) && (_e884 >= 0i)) && (_e884 < _e890));
if _e892 {
let _e893 = local_10;
local_12 = ((_e884 * _e893) + _e176);
} else {
local_12 = 0i;
}
let _e896 = local_10;
let _e897 = local_11;
let _e900 = local_12;
let _e901 = ((18i * (_e896 * _e897)) + _e900);
let _e903 = select(_e197, _e901, (_e901 < _e197));
let _e908 = global_2.member[bitcast<u32>(select(0i, _e903, (_e903 > 0i)))];
let _e911 = local_10;
let _e912 = local_11;
let _e915 = local_12;
let _e916 = ((16i * (_e911 * _e912)) + _e915);
let _e918 = select(_e197, _e916, (_e916 < _e197));
let _e923 = global_2.member[bitcast<u32>(select(0i, _e918, (_e918 > 0i)))];
let _e925 = ((_e892 && (_e908 == _e271)) && (_e923 == _e282));
let _e926 = local_12;
local_8 = _e926;
local_9 = _e190;
let _e927 = local_9;
let _e929 = local_8;
let _e930 = ((3i * _e927) + _e929);
let _e932 = select(_e197, _e930, (_e930 < _e197));
let _e937 = global_2.member[bitcast<u32>(select(0i, _e932, (_e932 > 0i)))];
let _e938 = local_9;
let _e940 = local_8;
let _e941 = ((4i * _e938) + _e940);
let _e943 = select(_e197, _e941, (_e941 < _e197));
let _e948 = global_2.member[bitcast<u32>(select(0i, _e943, (_e943 > 0i)))];
let _e949 = local_9;
let _e951 = local_8;
let _e952 = ((5i * _e949) + _e951);
let _e954 = select(_e197, _e952, (_e952 < _e197));
let _e959 = global_2.member[bitcast<u32>(select(0i, _e954, (_e954 > 0i)))];
let _e960 = local_10;
let _e961 = local_11;
let _e964 = local_12;
let _e965 = ((21i * (_e960 * _e961)) + _e964);
let _e967 = select(_e197, _e965, (_e965 < _e197));
let _e972 = global_2.member[bitcast<u32>(select(0i, _e967, (_e967 > 0i)))];
let _e974 = (_e892 && (_e972 > 0f));
let _e980 = ((1f - (((f32(_e884) + 0.5f) / _e415) * 2f)) * _e434);
let _e990 = (_e465.member + ((_e808 + (_e447.member * _e980)) * _e462));
let _e991 = (_e465.member_1 + ((_e809 + (_e447.member_1 * _e980)) * _e462));
let _e992 = (_e465.member_2 + ((_e810 + (_e447.member_2 * _e980)) * _e462));
let _e997 = (((_e990 * _e990) + (_e991 * _e991)) + (_e992 * _e992));
let _e1000 = sqrt(select(0f, _e997, (_e997 > 0f)));
let _e1003 = (1f / select(1e-20f, _e1000, (_e1000 > 1e-20f)));
let _e1004 = (_e990 * _e1003);
let _e1005 = (_e991 * _e1003);
let _e1006 = (_e992 * _e1003);
local_6 = ((_e884 * _e182) + _e176);
local_7 = _e190;
let _e1009 = local_7;
let _e1011 = local_6;
let _e1012 = ((9i * _e1009) + _e1011);
let _e1014 = select(_e197, _e1012, (_e1012 < _e197));
let _e1019 = global_2.member[bitcast<u32>(select(0i, _e1014, (_e1014 > 0i)))];
let _e1020 = local_7;
let _e1022 = local_6;
let _e1023 = ((10i * _e1020) + _e1022);
let _e1025 = select(_e197, _e1023, (_e1023 < _e197));
let _e1030 = global_2.member[bitcast<u32>(select(0i, _e1025, (_e1025 > 0i)))];
let _e1031 = local_7;
let _e1033 = local_6;
let _e1034 = ((11i * _e1031) + _e1033);
let _e1036 = select(_e197, _e1034, (_e1034 < _e197));
let _e1041 = global_2.member[bitcast<u32>(select(0i, _e1036, (_e1036 > 0i)))];
let _e1047 = (2f * (((_e1004 * _e1019) + (_e1005 * _e1030)) + (_e1006 * _e1041)));
let _e1051 = (_e1004 - (_e1019 * _e1047));
let _e1052 = (_e1005 - (_e1030 * _e1047));
let _e1053 = (_e1006 - (_e1041 * _e1047));
let _e1054 = (_e808 + _e451);
let _e1055 = (_e809 + _e452);
let _e1056 = (_e810 + _e453);
let _e1060 = (_e465.member + (_e1054 * _e462));
let _e1061 = (_e465.member_1 + (_e1055 * _e462));
let _e1062 = (_e465.member_2 + (_e1056 * _e462));
let _e1067 = (((_e1060 * _e1060) + (_e1061 * _e1061)) + (_e1062 * _e1062));
let _e1070 = sqrt(select(0f, _e1067, (_e1067 > 0f)));
let _e1073 = (1f / select(1e-20f, _e1070, (_e1070 > 1e-20f)));
let _e1074 = (_e1060 * _e1073);
let _e1075 = (_e1061 * _e1073);
let _e1076 = (_e1062 * _e1073);
let _e1077 = (_e655 - _e1074);
let _e1078 = (_e656 - _e1075);
let _e1079 = (_e657 - _e1076);
let _e1084 = (((_e1077 * _e1077) + (_e1078 * _e1078)) + (_e1079 * _e1079));
let _e1087 = sqrt(select(0f, _e1084, (_e1084 > 0f)));
let _e1088 = (_e588 - _e376);
let _e1089 = (_e599 - _e387);
let _e1090 = (_e610 - _e398);
let _e1095 = (((_e1088 * _e1088) + (_e1089 * _e1089)) + (_e1090 * _e1090));
let _e1100 = (_e588 - _e204);
let _e1101 = (_e599 - _e215);
let _e1102 = (_e610 - _e226);
let _e1107 = (((_e1100 * _e1100) + (_e1101 * _e1101)) + (_e1102 * _e1102));
let _e1111 = (_e204 - _e376);
let _e1112 = (_e215 - _e387);
let _e1113 = (_e226 - _e398);
let _e1118 = (((_e1111 * _e1111) + (_e1112 * _e1112)) + (_e1113 * _e1113));
let _e1126 = select(select(_e1087, select(sqrt(select(0f, _e1118, (_e1118 > 0f))), sqrt(select(0f, _e1107, (_e1107 > 0f))), _e576), (_e364 || _e576)), (0.5f * sqrt(select(0f, _e1095, (_e1095 > 0f)))), (_e364 && _e576));
let _e1127 = (_e937 - _e758);
let _e1128 = (_e948 - _e769);
let _e1129 = (_e959 - _e780);
let _e1134 = (((_e1127 * _e1127) + (_e1128 * _e1128)) + (_e1129 * _e1129));
let _e1139 = (_e937 - _e204);
let _e1140 = (_e948 - _e215);
let _e1141 = (_e959 - _e226);
let _e1146 = (((_e1139 * _e1139) + (_e1140 * _e1140)) + (_e1141 * _e1141));
let _e1150 = (_e204 - _e758);
let _e1151 = (_e215 - _e769);
let _e1152 = (_e226 - _e780);
let _e1157 = (((_e1150 * _e1150) + (_e1151 * _e1151)) + (_e1152 * _e1152));
let _e1165 = select(select(_e1087, select(sqrt(select(0f, _e1157, (_e1157 > 0f))), sqrt(select(0f, _e1146, (_e1146 > 0f))), _e925), (_e746 || _e925)), (0.5f * sqrt(select(0f, _e1134, (_e1134 > 0f)))), (_e746 && _e925));
let _e1166 = (_e271 > 0f);
let _e1169 = select(_e1087, select(_e1165, _e1126, (_e1126 > _e1165)), _e1166);
let _e1173 = global_1.member.member_16.member_4;
let _e1181 = (((_e1173.member * _e204) + (_e1173.member_1 * _e215)) + (_e1173.member_2 * _e226));
let _e1185 = global_1.member.member_16.member_5;
let _e1193 = (((_e1185.member * _e204) + (_e1185.member_1 * _e215)) + (_e1185.member_2 * _e226));
let _e1197 = global_1.member.member_16.member_6;
let _e1205 = (((_e1197.member * _e204) + (_e1197.member_1 * _e215)) + (_e1197.member_2 * _e226));
let _e1209 = global_1.member.member_16.member;
let _e1213 = global_1.member.member_16.member_7;
let _e1217 = vec3<f32>(_e1213.member, _e1213.member_1, _e1213.member_2);
let _e1221 = global_1.member.member_16.member_8;
let _e1225 = (_e1209 == 0u);
if _e1225 {
phi_3779_ = _e1217;
} else {
if (_e1209 == 1u) {
let _e1228 = select(-1f, _e1205, (_e1205 > -1f));
let _e1230 = select(1f, _e1228, (_e1228 < 1f));
if (_e1230 > 0f) {
phi_2394_ = _e1217;
} else {
let _e1235 = global_1.member.member_16.member_9;
phi_2394_ = vec3<f32>(_e1235.member, _e1235.member_1, _e1235.member_2);
}
let _e1241 = phi_2394_;
let _e1250 = bitcast<f32>((bitcast<u32>(_e1230) & 2147483647u));
let _e1253 = sqrt(select(0f, _e1250, (_e1250 > 0f)));
phi_3778_ = vec3<f32>((_e1221.member + ((_e1241.x - _e1221.member) * _e1253)), (_e1221.member_1 + ((_e1241.y - _e1221.member_1) * _e1253)), (_e1221.member_2 + ((_e1241.z - _e1221.member_2) * _e1253)));
} else {
if (_e1209 == 2u) {
let _e1265 = global_1.member.member_16.member_10;
let _e1266 = (_e1169 / _e1265);
let _e1268 = select(1e-4f, _e1266, (_e1266 > 1e-4f));
let _e1271 = bitcast<f32>((bitcast<u32>(_e1181) & 2147483647u));
let _e1274 = bitcast<f32>((bitcast<u32>(_e1193) & 2147483647u));
let _e1278 = select(_e1274, _e1271, (_e1271 > _e1274));
let _e1281 = (select(_e1274, _e1271, (_e1271 < _e1274)) / select(1.1754944e-38f, _e1278, (_e1278 > 1.1754944e-38f)));
let _e1282 = (_e1281 > 0.41421357f);
let _e1286 = select(_e1281, ((_e1281 - 1f) / (_e1281 + 1f)), _e1282);
let _e1287 = (_e1286 * _e1286);
let _e1302 = (select(0f, 0.7853982f, _e1282) + (_e1286 + ((_e1286 * _e1287) * (-0.33333334f + (_e1287 * (0.2f + (_e1287 * (-0.14285713f + (_e1287 * (0.11111111f + (_e1287 * (-0.09090909f + (_e1287 * 0.0585f)))))))))))));
let _e1305 = select(_e1302, (1.5707964f - _e1302), (_e1274 > _e1271));
let _e1308 = select(_e1305, (3.1415927f - _e1305), (_e1181 < 0f));
let _e1314 = (1f - (_e1205 * _e1205));
let _e1317 = sqrt(select(0f, _e1314, (_e1314 > 0f)));
let _e1320 = (_e1268 / select(1e-3f, _e1317, (_e1317 > 1e-3f)));
let _e1321 = ((select(_e1308, -(_e1308), (_e1193 < 0f)) / _e1265) * 0.5f);
let _e1323 = select(-8e6f, _e1321, (_e1321 > -8e6f));
let _e1325 = select(8e6f, _e1323, (_e1323 < 8e6f));
let _e1332 = select(0i, select(select(i32(_e1325), i32(-2147483648), (_e1325 < -2147483600f)), 2147483647i, (_e1325 > 2147483500f)), (_e1325 == _e1325));
let _e1339 = ((_e1321 - f32((_e1332 - select(0i, 1i, (_e1325 < f32(_e1332)))))) * 2f);
let _e1347 = ((select(select((_e1339 - 2f), (1f - _e1339), (_e1339 < 1.5f)), _e1339, (_e1339 < 0.5f)) * 2f) / _e1320);
let _e1349 = select(-1f, _e1347, (_e1347 > -1f));
let _e1352 = (2f - _e1320);
let _e1354 = select(0f, _e1352, (_e1352 > 0f));
let _e1359 = select(-1f, _e1205, (_e1205 > -1f));
let _e1361 = select(1f, _e1359, (_e1359 < 1f));
let _e1364 = ((1f - _e1361) * (1f + _e1361));
let _e1367 = sqrt(select(0f, _e1364, (_e1364 > 0f)));
let _e1370 = bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u));
let _e1373 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
let _e1377 = select(_e1373, _e1370, (_e1370 > _e1373));
let _e1380 = (select(_e1373, _e1370, (_e1370 < _e1373)) / select(1.1754944e-38f, _e1377, (_e1377 > 1.1754944e-38f)));
let _e1381 = (_e1380 > 0.41421357f);
let _e1385 = select(_e1380, ((_e1380 - 1f) / (_e1380 + 1f)), _e1381);
let _e1386 = (_e1385 * _e1385);
let _e1401 = (select(0f, 0.7853982f, _e1381) + (_e1385 + ((_e1385 * _e1386) * (-0.33333334f + (_e1386 * (0.2f + (_e1386 * (-0.14285713f + (_e1386 * (0.11111111f + (_e1386 * (-0.09090909f + (_e1386 * 0.0585f)))))))))))));
let _e1404 = select(_e1401, (1.5707964f - _e1401), (_e1373 > _e1370));
let _e1407 = select(_e1404, (3.1415927f - _e1404), (_e1367 < 0f));
let _e1412 = ((select(_e1407, -(_e1407), (_e1361 < 0f)) / _e1265) * 0.5f);
let _e1414 = select(-8e6f, _e1412, (_e1412 > -8e6f));
let _e1416 = select(8e6f, _e1414, (_e1414 < 8e6f));
let _e1423 = select(0i, select(select(i32(_e1416), i32(-2147483648), (_e1416 < -2147483600f)), 2147483647i, (_e1416 > 2147483500f)), (_e1416 == _e1416));
let _e1430 = ((_e1412 - f32((_e1423 - select(0i, 1i, (_e1416 < f32(_e1423)))))) * 2f);
let _e1438 = ((select(select((_e1430 - 2f), (1f - _e1430), (_e1430 < 1.5f)), _e1430, (_e1430 < 0.5f)) * 2f) / _e1268);
let _e1440 = select(-1f, _e1438, (_e1438 > -1f));
let _e1443 = (2f - _e1268);
let _e1445 = select(0f, _e1443, (_e1443 > 0f));
let _e1451 = (0.5f + ((0.5f * (select(1f, _e1349, (_e1349 < 1f)) * select(1f, _e1354, (_e1354 < 1f)))) * (select(1f, _e1440, (_e1440 < 1f)) * select(1f, _e1445, (_e1445 < 1f)))));
phi_3777_ = vec3<f32>((_e1213.member + ((_e1221.member - _e1213.member) * _e1451)), (_e1213.member_1 + ((_e1221.member_1 - _e1213.member_1) * _e1451)), (_e1213.member_2 + ((_e1221.member_2 - _e1213.member_2) * _e1451)));
} else {
let _e1465 = global_1.member.member_16.member_1;
let _e1466 = bitcast<i32>(_e1465);
let _e1471 = global_1.member.member_16.member_3;
let _e1473 = f32(bitcast<i32>(_e1471));
let _e1475 = (2f * 3.1415927f);
let _e1476 = ((_e1169 * f32(_e1466)) / _e1475);
let _e1478 = select(1e-6f, _e1476, (_e1476 > 1e-6f));
let _e1481 = bitcast<u32>(select(1.1754944e-38f, _e1478, (_e1478 > 1.1754944e-38f)));
let _e1482 = (_e1481 & 8388607u);
let _e1484 = select(0u, 1u, (_e1482 > 3474675u));
let _e1495 = bitcast<f32>((_e1482 | ((127u - _e1484) << bitcast<u32>(23i))));
let _e1498 = ((_e1495 - 1f) / (_e1495 + 1f));
let _e1499 = (_e1498 * _e1498);
let _e1514 = (f32(((bitcast<i32>((_e1481 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1484))) + (((2f * _e1498) + ((_e1498 * _e1499) * (0.6666667f + (_e1499 * (0.4f + (_e1499 * (0.2857143f + (_e1499 * (0.22222222f + (_e1499 * 0.18181819f)))))))))) * 1.442695f));
let _e1515 = (_e1473 - 1f);
let _e1517 = select(0f, _e1514, (_e1514 > 0f));
let _e1519 = select(_e1515, _e1517, (_e1517 < _e1515));
let _e1520 = (_e1473 - 2f);
let _e1522 = select(0f, _e1520, (_e1520 > 0f));
let _e1524 = select(0f, _e1519, (_e1519 > 0f));
let _e1526 = select(_e1522, _e1524, (_e1524 < _e1522));
let _e1533 = select(0i, select(select(i32(_e1526), i32(-2147483648), (_e1526 < -2147483600f)), 2147483647i, (_e1526 > 2147483500f)), (_e1526 == _e1526));
let _e1537 = (_e1533 - select(0i, 1i, (_e1526 < f32(_e1533))));
let _e1540 = bitcast<f32>((bitcast<u32>(_e1193) & 2147483647u));
let _e1543 = bitcast<f32>((bitcast<u32>(_e1181) & 2147483647u));
let _e1547 = select(_e1543, _e1540, (_e1540 > _e1543));
let _e1550 = (select(_e1543, _e1540, (_e1540 < _e1543)) / select(1.1754944e-38f, _e1547, (_e1547 > 1.1754944e-38f)));
let _e1551 = (_e1550 > 0.41421357f);
let _e1555 = select(_e1550, ((_e1550 - 1f) / (_e1550 + 1f)), _e1551);
let _e1556 = (_e1555 * _e1555);
let _e1571 = (select(0f, 0.7853982f, _e1551) + (_e1555 + ((_e1555 * _e1556) * (-0.33333334f + (_e1556 * (0.2f + (_e1556 * (-0.14285713f + (_e1556 * (0.11111111f + (_e1556 * (-0.09090909f + (_e1556 * 0.0585f)))))))))))));
let _e1574 = select(_e1571, (1.5707964f - _e1571), (_e1543 > _e1540));
let _e1577 = select(_e1574, (3.1415927f - _e1574), (_e1193 < 0f));
let _e1582 = (0.5f - (select(_e1577, -(_e1577), (_e1181 < 0f)) / _e1475));
let _e1584 = select(-1f, _e1205, (_e1205 > -1f));
let _e1586 = select(1f, _e1584, (_e1584 < 1f));
let _e1589 = ((1f - _e1586) * (1f + _e1586));
let _e1592 = sqrt(select(0f, _e1589, (_e1589 > 0f)));
let _e1595 = bitcast<f32>((bitcast<u32>(_e1592) & 2147483647u));
let _e1598 = bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u));
let _e1602 = select(_e1598, _e1595, (_e1595 > _e1598));
let _e1605 = (select(_e1598, _e1595, (_e1595 < _e1598)) / select(1.1754944e-38f, _e1602, (_e1602 > 1.1754944e-38f)));
let _e1606 = (_e1605 > 0.41421357f);
let _e1610 = select(_e1605, ((_e1605 - 1f) / (_e1605 + 1f)), _e1606);
let _e1611 = (_e1610 * _e1610);
let _e1626 = (select(0f, 0.7853982f, _e1606) + (_e1610 + ((_e1610 * _e1611) * (-0.33333334f + (_e1611 * (0.2f + (_e1611 * (-0.14285713f + (_e1611 * (0.11111111f + (_e1611 * (-0.09090909f + (_e1611 * 0.0585f)))))))))))));
let _e1629 = select(_e1626, (1.5707964f - _e1626), (_e1598 > _e1595));
let _e1632 = select(_e1629, (3.1415927f - _e1629), (_e1592 < 0f));
let _e1637 = (0.5f - (select(_e1632, -(_e1632), (_e1586 < 0f)) / 3.1415927f));
let _e1641 = global_1.member.member_16.member_2;
let _e1642 = bitcast<i32>(_e1641);
phi_2996_ = 0i;
phi_2999_ = 0i;
phi_3001_ = _e1642;
phi_3003_ = _e1466;
loop {
let _e1644 = phi_2996_;
let _e1646 = phi_2999_;
let _e1648 = phi_3001_;
let _e1650 = phi_3003_;
local_42 = _e1650;
local_43 = _e1648;
local_44 = _e1650;
local_45 = _e1650;
local_46 = _e1650;
local_47 = _e1650;
local_48 = _e1650;
local_49 = _e1650;
local_50 = _e1648;
local_51 = _e1648;
local_52 = _e1648;
local_53 = _e1648;
local_54 = _e1650;
local_55 = _e1646;
local_56 = _e1650;
local_57 = _e1646;
let _e1651 = (_e1644 < _e1537);
if _e1651 {
if (_e1650 > 1i) {
phi_3018_ = (_e1650 >> bitcast<u32>(1i));
} else {
phi_3018_ = 1i;
}
let _e1658 = phi_3018_;
if (_e1648 > 1i) {
phi_3024_ = (_e1648 >> bitcast<u32>(1i));
} else {
phi_3024_ = 1i;
}
let _e1663 = phi_3024_;
phi_2997_ = (_e1644 + 1i);
phi_3000_ = (_e1646 + (_e1650 * _e1648));
phi_3002_ = _e1663;
phi_3004_ = _e1658;
} else {
phi_2997_ = i32();
phi_3000_ = i32();
phi_3002_ = i32();
phi_3004_ = i32();
}
let _e1666 = phi_2997_;
let _e1668 = phi_3000_;
let _e1670 = phi_3002_;
let _e1672 = phi_3004_;
continue;
continuing {
phi_2996_ = _e1666;
phi_2999_ = _e1668;
phi_3001_ = _e1670;
phi_3003_ = _e1672;
break if !(_e1651);
}
}
let _e1675 = local_42;
let _e1676 = f32(_e1675);
let _e1678 = ((_e1582 * _e1676) - 0.5f);
let _e1680 = local_43;
let _e1681 = f32(_e1680);
let _e1683 = ((_e1637 * _e1681) - 0.5f);
let _e1685 = select(-1f, _e1678, (_e1678 > -1f));
let _e1687 = select(_e1676, _e1685, (_e1685 < _e1676));
let _e1694 = select(0i, select(select(i32(_e1687), i32(-2147483648), (_e1687 < -2147483600f)), 2147483647i, (_e1687 > 2147483500f)), (_e1687 == _e1687));
let _e1698 = (_e1694 - select(0i, 1i, (_e1687 < f32(_e1694))));
let _e1700 = select(-1f, _e1683, (_e1683 > -1f));
let _e1702 = select(_e1681, _e1700, (_e1700 < _e1681));
let _e1709 = select(0i, select(select(i32(_e1702), i32(-2147483648), (_e1702 < -2147483600f)), 2147483647i, (_e1702 > 2147483500f)), (_e1702 == _e1702));
let _e1713 = (_e1709 - select(0i, 1i, (_e1702 < f32(_e1709))));
let _e1715 = (_e1678 - f32(_e1698));
let _e1717 = (_e1683 - f32(_e1713));
let _e1719 = select(0f, _e1717, (_e1717 > 0f));
let _e1721 = select(1f, _e1719, (_e1719 < 1f));
if (_e1698 < 0i) {
let _e1724 = local_44;
phi_3099_ = (_e1698 + _e1724);
} else {
phi_3099_ = _e1698;
}
let _e1727 = phi_3099_;
let _e1729 = local_45;
if (_e1727 >= _e1729) {
let _e1732 = local_46;
phi_3105_ = (_e1727 - _e1732);
} else {
phi_3105_ = _e1727;
}
let _e1735 = phi_3105_;
let _e1736 = (_e1698 + 1i);
if (_e1736 < 0i) {
let _e1739 = local_47;
phi_3112_ = (_e1736 + _e1739);
} else {
phi_3112_ = _e1736;
}
let _e1742 = phi_3112_;
let _e1744 = local_48;
if (_e1742 >= _e1744) {
let _e1747 = local_49;
phi_3118_ = (_e1742 - _e1747);
} else {
phi_3118_ = _e1742;
}
let _e1750 = phi_3118_;
let _e1752 = select(_e1713, 0i, (_e1713 < 0i));
let _e1754 = local_50;
if (_e1752 >= _e1754) {
let _e1757 = local_51;
phi_3129_ = (_e1757 - 1i);
} else {
phi_3129_ = _e1752;
}
let _e1760 = phi_3129_;
let _e1761 = (_e1713 + 1i);
let _e1763 = select(_e1761, 0i, (_e1761 < 0i));
let _e1765 = local_52;
if (_e1763 >= _e1765) {
let _e1768 = local_53;
phi_3141_ = (_e1768 - 1i);
} else {
phi_3141_ = _e1763;
}
let _e1771 = phi_3141_;
let _e1773 = local_54;
let _e1776 = local_55;
let _e1777 = (_e1776 + (_e1760 * _e1773));
let _e1779 = local_56;
let _e1782 = local_57;
let _e1783 = (_e1782 + (_e1771 * _e1779));
let _e1785 = (3i * (_e1777 + _e1735));
let _e1787 = (bitcast<i32>(_e153) - 1i);
let _e1789 = select(_e1787, _e1785, (_e1785 < _e1787));
let _e1795 = global_4.member[bitcast<u32>(select(0i, _e1789, (_e1789 > 0i)))];
let _e1796 = (_e1785 + 1i);
let _e1798 = select(_e1787, _e1796, (_e1796 < _e1787));
let _e1804 = global_4.member[bitcast<u32>(select(0i, _e1798, (_e1798 > 0i)))];
let _e1805 = (_e1785 + 2i);
let _e1807 = select(_e1787, _e1805, (_e1805 < _e1787));
let _e1813 = global_4.member[bitcast<u32>(select(0i, _e1807, (_e1807 > 0i)))];
let _e1815 = (3i * (_e1777 + _e1750));
let _e1817 = select(_e1787, _e1815, (_e1815 < _e1787));
let _e1823 = global_4.member[bitcast<u32>(select(0i, _e1817, (_e1817 > 0i)))];
let _e1824 = (_e1815 + 1i);
let _e1826 = select(_e1787, _e1824, (_e1824 < _e1787));
let _e1832 = global_4.member[bitcast<u32>(select(0i, _e1826, (_e1826 > 0i)))];
let _e1833 = (_e1815 + 2i);
let _e1835 = select(_e1787, _e1833, (_e1833 < _e1787));
let _e1841 = global_4.member[bitcast<u32>(select(0i, _e1835, (_e1835 > 0i)))];
let _e1843 = (3i * (_e1783 + _e1735));
let _e1845 = select(_e1787, _e1843, (_e1843 < _e1787));
let _e1851 = global_4.member[bitcast<u32>(select(0i, _e1845, (_e1845 > 0i)))];
let _e1852 = (_e1843 + 1i);
let _e1854 = select(_e1787, _e1852, (_e1852 < _e1787));
let _e1860 = global_4.member[bitcast<u32>(select(0i, _e1854, (_e1854 > 0i)))];
let _e1861 = (_e1843 + 2i);
let _e1863 = select(_e1787, _e1861, (_e1861 < _e1787));
let _e1869 = global_4.member[bitcast<u32>(select(0i, _e1863, (_e1863 > 0i)))];
let _e1871 = (3i * (_e1783 + _e1750));
let _e1873 = select(_e1787, _e1871, (_e1871 < _e1787));
let _e1879 = global_4.member[bitcast<u32>(select(0i, _e1873, (_e1873 > 0i)))];
let _e1880 = (_e1871 + 1i);
let _e1882 = select(_e1787, _e1880, (_e1880 < _e1787));
let _e1888 = global_4.member[bitcast<u32>(select(0i, _e1882, (_e1882 > 0i)))];
let _e1889 = (_e1871 + 2i);
let _e1891 = select(_e1787, _e1889, (_e1889 < _e1787));
let _e1897 = global_4.member[bitcast<u32>(select(0i, _e1891, (_e1891 > 0i)))];
let _e1904 = (_e1795 + ((_e1823 - _e1795) * _e1715));
let _e1905 = (_e1804 + ((_e1832 - _e1804) * _e1715));
let _e1906 = (_e1813 + ((_e1841 - _e1813) * _e1715));
let _e1922 = (_e1904 + (((_e1851 + ((_e1879 - _e1851) * _e1715)) - _e1904) * _e1721));
let _e1923 = (_e1905 + (((_e1860 + ((_e1888 - _e1860) * _e1715)) - _e1905) * _e1721));
let _e1924 = (_e1906 + (((_e1869 + ((_e1897 - _e1869) * _e1715)) - _e1906) * _e1721));
phi_3377_ = 0i;
phi_3380_ = 0i;
phi_3382_ = _e1642;
phi_3384_ = _e1466;
loop {
let _e1927 = phi_3377_;
let _e1929 = phi_3380_;
let _e1931 = phi_3382_;
let _e1933 = phi_3384_;
local_58 = _e1933;
local_59 = _e1931;
local_60 = _e1933;
local_61 = _e1933;
local_62 = _e1933;
local_63 = _e1933;
local_64 = _e1933;
local_65 = _e1933;
local_66 = _e1931;
local_67 = _e1931;
local_68 = _e1931;
local_69 = _e1931;
local_70 = _e1933;
local_71 = _e1929;
local_72 = _e1933;
local_73 = _e1929;
let _e1934 = (_e1927 < (_e1537 + 1i));
if _e1934 {
if (_e1933 > 1i) {
phi_3399_ = (_e1933 >> bitcast<u32>(1i));
} else {
phi_3399_ = 1i;
}
let _e1941 = phi_3399_;
if (_e1931 > 1i) {
phi_3405_ = (_e1931 >> bitcast<u32>(1i));
} else {
phi_3405_ = 1i;
}
let _e1946 = phi_3405_;
phi_3378_ = (_e1927 + 1i);
phi_3381_ = (_e1929 + (_e1933 * _e1931));
phi_3383_ = _e1946;
phi_3385_ = _e1941;
} else {
phi_3378_ = i32();
phi_3381_ = i32();
phi_3383_ = i32();
phi_3385_ = i32();
}
let _e1949 = phi_3378_;
let _e1951 = phi_3381_;
let _e1953 = phi_3383_;
let _e1955 = phi_3385_;
continue;
continuing {
phi_3377_ = _e1949;
phi_3380_ = _e1951;
phi_3382_ = _e1953;
phi_3384_ = _e1955;
break if !(_e1934);
}
}
let _e1958 = local_58;
let _e1959 = f32(_e1958);
let _e1961 = ((_e1582 * _e1959) - 0.5f);
let _e1963 = local_59;
let _e1964 = f32(_e1963);
let _e1966 = ((_e1637 * _e1964) - 0.5f);
let _e1968 = select(-1f, _e1961, (_e1961 > -1f));
let _e1970 = select(_e1959, _e1968, (_e1968 < _e1959));
let _e1977 = select(0i, select(select(i32(_e1970), i32(-2147483648), (_e1970 < -2147483600f)), 2147483647i, (_e1970 > 2147483500f)), (_e1970 == _e1970));
let _e1981 = (_e1977 - select(0i, 1i, (_e1970 < f32(_e1977))));
let _e1983 = select(-1f, _e1966, (_e1966 > -1f));
let _e1985 = select(_e1964, _e1983, (_e1983 < _e1964));
let _e1992 = select(0i, select(select(i32(_e1985), i32(-2147483648), (_e1985 < -2147483600f)), 2147483647i, (_e1985 > 2147483500f)), (_e1985 == _e1985));
let _e1996 = (_e1992 - select(0i, 1i, (_e1985 < f32(_e1992))));
let _e1998 = (_e1961 - f32(_e1981));
let _e2000 = (_e1966 - f32(_e1996));
let _e2002 = select(0f, _e2000, (_e2000 > 0f));
let _e2004 = select(1f, _e2002, (_e2002 < 1f));
if (_e1981 < 0i) {
let _e2007 = local_60;
phi_3480_ = (_e1981 + _e2007);
} else {
phi_3480_ = _e1981;
}
let _e2010 = phi_3480_;
let _e2012 = local_61;
if (_e2010 >= _e2012) {
let _e2015 = local_62;
phi_3486_ = (_e2010 - _e2015);
} else {
phi_3486_ = _e2010;
}
let _e2018 = phi_3486_;
let _e2019 = (_e1981 + 1i);
if (_e2019 < 0i) {
let _e2022 = local_63;
phi_3493_ = (_e2019 + _e2022);
} else {
phi_3493_ = _e2019;
}
let _e2025 = phi_3493_;
let _e2027 = local_64;
if (_e2025 >= _e2027) {
let _e2030 = local_65;
phi_3499_ = (_e2025 - _e2030);
} else {
phi_3499_ = _e2025;
}
let _e2033 = phi_3499_;
let _e2035 = select(_e1996, 0i, (_e1996 < 0i));
let _e2037 = local_66;
if (_e2035 >= _e2037) {
let _e2040 = local_67;
phi_3510_ = (_e2040 - 1i);
} else {
phi_3510_ = _e2035;
}
let _e2043 = phi_3510_;
let _e2044 = (_e1996 + 1i);
let _e2046 = select(_e2044, 0i, (_e2044 < 0i));
let _e2048 = local_68;
if (_e2046 >= _e2048) {
let _e2051 = local_69;
phi_3522_ = (_e2051 - 1i);
} else {
phi_3522_ = _e2046;
}
let _e2054 = phi_3522_;
let _e2056 = local_70;
let _e2059 = local_71;
let _e2060 = (_e2059 + (_e2043 * _e2056));
let _e2062 = local_72;
let _e2065 = local_73;
let _e2066 = (_e2065 + (_e2054 * _e2062));
let _e2068 = (3i * (_e2060 + _e2018));
let _e2070 = select(_e1787, _e2068, (_e2068 < _e1787));
let _e2076 = global_4.member[bitcast<u32>(select(0i, _e2070, (_e2070 > 0i)))];
let _e2077 = (_e2068 + 1i);
let _e2079 = select(_e1787, _e2077, (_e2077 < _e1787));
let _e2085 = global_4.member[bitcast<u32>(select(0i, _e2079, (_e2079 > 0i)))];
let _e2086 = (_e2068 + 2i);
let _e2088 = select(_e1787, _e2086, (_e2086 < _e1787));
let _e2094 = global_4.member[bitcast<u32>(select(0i, _e2088, (_e2088 > 0i)))];
let _e2096 = (3i * (_e2060 + _e2033));
let _e2098 = select(_e1787, _e2096, (_e2096 < _e1787));
let _e2104 = global_4.member[bitcast<u32>(select(0i, _e2098, (_e2098 > 0i)))];
let _e2105 = (_e2096 + 1i);
let _e2107 = select(_e1787, _e2105, (_e2105 < _e1787));
let _e2113 = global_4.member[bitcast<u32>(select(0i, _e2107, (_e2107 > 0i)))];
let _e2114 = (_e2096 + 2i);
let _e2116 = select(_e1787, _e2114, (_e2114 < _e1787));
let _e2122 = global_4.member[bitcast<u32>(select(0i, _e2116, (_e2116 > 0i)))];
let _e2124 = (3i * (_e2066 + _e2018));
let _e2126 = select(_e1787, _e2124, (_e2124 < _e1787));
let _e2132 = global_4.member[bitcast<u32>(select(0i, _e2126, (_e2126 > 0i)))];
let _e2133 = (_e2124 + 1i);
let _e2135 = select(_e1787, _e2133, (_e2133 < _e1787));
let _e2141 = global_4.member[bitcast<u32>(select(0i, _e2135, (_e2135 > 0i)))];
let _e2142 = (_e2124 + 2i);
let _e2144 = select(_e1787, _e2142, (_e2142 < _e1787));
let _e2150 = global_4.member[bitcast<u32>(select(0i, _e2144, (_e2144 > 0i)))];
let _e2152 = (3i * (_e2066 + _e2033));
let _e2154 = select(_e1787, _e2152, (_e2152 < _e1787));
let _e2160 = global_4.member[bitcast<u32>(select(0i, _e2154, (_e2154 > 0i)))];
let _e2161 = (_e2152 + 1i);
let _e2163 = select(_e1787, _e2161, (_e2161 < _e1787));
let _e2169 = global_4.member[bitcast<u32>(select(0i, _e2163, (_e2163 > 0i)))];
let _e2170 = (_e2152 + 2i);
let _e2172 = select(_e1787, _e2170, (_e2170 < _e1787));
let _e2178 = global_4.member[bitcast<u32>(select(0i, _e2172, (_e2172 > 0i)))];
let _e2185 = (_e2076 + ((_e2104 - _e2076) * _e1998));
let _e2186 = (_e2085 + ((_e2113 - _e2085) * _e1998));
let _e2187 = (_e2094 + ((_e2122 - _e2094) * _e1998));
let _e2210 = (_e1519 - f32(_e1537));
let _e2212 = select(0f, _e2210, (_e2210 > 0f));
let _e2214 = select(1f, _e2212, (_e2212 < 1f));
let _e2224 = global_1.member.member_16.member_11;
phi_3777_ = vec3<f32>(((_e1922 + (((_e2185 + (((_e2132 + ((_e2160 - _e2132) * _e1998)) - _e2185) * _e2004)) - _e1922) * _e2214)) * _e2224), ((_e1923 + (((_e2186 + (((_e2141 + ((_e2169 - _e2141) * _e1998)) - _e2186) * _e2004)) - _e1923) * _e2214)) * _e2224), ((_e1924 + (((_e2187 + (((_e2150 + ((_e2178 - _e2150) * _e1998)) - _e2187) * _e2004)) - _e1924) * _e2214)) * _e2224));
}
let _e2230 = phi_3777_;
phi_3778_ = _e2230;
}
let _e2232 = phi_3778_;
phi_3779_ = _e2232;
}
let _e2234 = phi_3779_;
if _e285 {
let _e2235 = local_41;
let _e2237 = local_40;
let _e2238 = ((23i * _e2235) + _e2237);
let _e2240 = select(_e197, _e2238, (_e2238 < _e197));
let _e2245 = global_2.member[bitcast<u32>(select(0i, _e2240, (_e2240 > 0i)))];
let _e2252 = select(0i, select(select(i32(_e2245), i32(-2147483648), (_e2245 < -2147483600f)), 2147483647i, (_e2245 > 2147483500f)), (_e2245 == _e2245));
let _e2253 = local_40;
local_4 = _e2253;
local_5 = _e190;
let _e2254 = local_4;
let _e2256 = select(_e197, _e2254, (_e2254 < _e197));
let _e2261 = global_2.member[bitcast<u32>(select(0i, _e2256, (_e2256 > 0i)))];
let _e2262 = local_5;
let _e2263 = local_4;
let _e2264 = (_e2262 + _e2263);
let _e2266 = select(_e197, _e2264, (_e2264 < _e197));
let _e2271 = global_2.member[bitcast<u32>(select(0i, _e2266, (_e2266 > 0i)))];
let _e2272 = local_5;
let _e2274 = local_4;
let _e2275 = ((2i * _e2272) + _e2274);
let _e2277 = select(_e197, _e2275, (_e2275 < _e197));
let _e2282 = global_2.member[bitcast<u32>(select(0i, _e2277, (_e2277 > 0i)))];
let _e2283 = vec3<f32>(_e2261, _e2271, _e2282);
if (_e2252 < 0i) {
let _e2285 = (_e2252 == -3i);
let _e2291 = global_1.member.member_17.member_1.member.member;
let _e2296 = global_1.member.member_17.member_1.member_1;
let _e2302 = global_1.member.member_17.member.member.member;
let _e2307 = global_1.member.member_17.member.member_1;
let _e2317 = vec3<f32>(select(_e2302.member, _e2291.member, _e2285), select(_e2302.member_1, _e2291.member_1, _e2285), select(_e2302.member_2, _e2291.member_2, _e2285));
phi_4616_ = type_22(_e2283, _e2317, _e2317, vec3<f32>(select(_e2307.member, _e2296.member, _e2285), select(_e2307.member_1, _e2296.member_1, _e2285), select(_e2307.member_2, _e2296.member_2, _e2285)), 0f, false);
} else {
let _e2329 = (_e2252 * 19i);
let _e2331 = (bitcast<i32>(_e155) - 1i);
let _e2333 = select(_e2331, _e2329, (_e2329 < _e2331));
let _e2339 = global_3.member[bitcast<u32>(select(0i, _e2333, (_e2333 > 0i)))];
let _e2340 = (_e2329 + 1i);
let _e2342 = select(_e2331, _e2340, (_e2340 < _e2331));
let _e2348 = global_3.member[bitcast<u32>(select(0i, _e2342, (_e2342 > 0i)))];
let _e2349 = (_e2329 + 2i);
let _e2351 = select(_e2331, _e2349, (_e2349 < _e2331));
let _e2357 = global_3.member[bitcast<u32>(select(0i, _e2351, (_e2351 > 0i)))];
let _e2358 = (_e2329 + 3i);
let _e2360 = select(_e2331, _e2358, (_e2358 < _e2331));
let _e2366 = global_3.member[bitcast<u32>(select(0i, _e2360, (_e2360 > 0i)))];
let _e2367 = (_e2329 + 4i);
let _e2369 = select(_e2331, _e2367, (_e2367 < _e2331));
let _e2375 = global_3.member[bitcast<u32>(select(0i, _e2369, (_e2369 > 0i)))];
let _e2376 = (_e2329 + 5i);
let _e2378 = select(_e2331, _e2376, (_e2376 < _e2331));
let _e2384 = global_3.member[bitcast<u32>(select(0i, _e2378, (_e2378 > 0i)))];
let _e2385 = (_e2329 + 6i);
let _e2387 = select(_e2331, _e2385, (_e2385 < _e2331));
let _e2393 = global_3.member[bitcast<u32>(select(0i, _e2387, (_e2387 > 0i)))];
let _e2394 = (_e2329 + 7i);
let _e2396 = select(_e2331, _e2394, (_e2394 < _e2331));
let _e2402 = global_3.member[bitcast<u32>(select(0i, _e2396, (_e2396 > 0i)))];
let _e2403 = (_e2329 + 8i);
let _e2405 = select(_e2331, _e2403, (_e2403 < _e2331));
let _e2411 = global_3.member[bitcast<u32>(select(0i, _e2405, (_e2405 > 0i)))];
let _e2412 = (_e2366 - _e2339);
let _e2413 = (_e2375 - _e2348);
let _e2414 = (_e2384 - _e2357);
let _e2415 = (_e2393 - _e2339);
let _e2416 = (_e2402 - _e2348);
let _e2417 = (_e2411 - _e2357);
let _e2420 = ((_e2413 * _e2417) - (_e2414 * _e2416));
let _e2423 = ((_e2414 * _e2415) - (_e2412 * _e2417));
let _e2426 = ((_e2412 * _e2416) - (_e2413 * _e2415));
let _e2427 = (_e2366 - _e2261);
let _e2428 = (_e2375 - _e2271);
let _e2429 = (_e2384 - _e2282);
let _e2430 = (_e2393 - _e2261);
let _e2431 = (_e2402 - _e2271);
let _e2432 = (_e2411 - _e2282);
let _e2446 = (((((_e2428 * _e2432) - (_e2429 * _e2431)) * _e2420) + (((_e2429 * _e2430) - (_e2427 * _e2432)) * _e2423)) + (((_e2427 * _e2431) - (_e2428 * _e2430)) * _e2426));
let _e2448 = select(0f, _e2446, (_e2446 > 0f));
let _e2449 = (_e2339 - _e2261);
let _e2450 = (_e2348 - _e2271);
let _e2451 = (_e2357 - _e2282);
let _e2465 = (((((_e2431 * _e2451) - (_e2432 * _e2450)) * _e2420) + (((_e2432 * _e2449) - (_e2430 * _e2451)) * _e2423)) + (((_e2430 * _e2450) - (_e2431 * _e2449)) * _e2426));
let _e2467 = select(0f, _e2465, (_e2465 > 0f));
let _e2481 = (((((_e2450 * _e2429) - (_e2451 * _e2428)) * _e2420) + (((_e2451 * _e2427) - (_e2449 * _e2429)) * _e2423)) + (((_e2449 * _e2428) - (_e2450 * _e2427)) * _e2426));
let _e2483 = select(0f, _e2481, (_e2481 > 0f));
let _e2485 = ((_e2448 + _e2467) + _e2483);
let _e2487 = select(1e-30f, _e2485, (_e2485 > 1e-30f));
let _e2488 = (_e2448 / _e2487);
let _e2489 = (_e2467 / _e2487);
let _e2490 = (_e2483 / _e2487);
let _e2495 = (((_e2420 * _e2420) + (_e2423 * _e2423)) + (_e2426 * _e2426));
let _e2498 = sqrt(select(0f, _e2495, (_e2495 > 0f)));
let _e2501 = (1f / select(1e-20f, _e2498, (_e2498 > 1e-20f)));
let _e2506 = (_e2329 + 9i);
let _e2508 = select(_e2331, _e2506, (_e2506 < _e2331));
let _e2514 = global_3.member[bitcast<u32>(select(0i, _e2508, (_e2508 > 0i)))];
let _e2515 = (_e2329 + 10i);
let _e2517 = select(_e2331, _e2515, (_e2515 < _e2331));
let _e2523 = global_3.member[bitcast<u32>(select(0i, _e2517, (_e2517 > 0i)))];
let _e2524 = (_e2329 + 11i);
let _e2526 = select(_e2331, _e2524, (_e2524 < _e2331));
let _e2532 = global_3.member[bitcast<u32>(select(0i, _e2526, (_e2526 > 0i)))];
let _e2536 = (_e2329 + 12i);
let _e2538 = select(_e2331, _e2536, (_e2536 < _e2331));
let _e2544 = global_3.member[bitcast<u32>(select(0i, _e2538, (_e2538 > 0i)))];
let _e2545 = (_e2329 + 13i);
let _e2547 = select(_e2331, _e2545, (_e2545 < _e2331));
let _e2553 = global_3.member[bitcast<u32>(select(0i, _e2547, (_e2547 > 0i)))];
let _e2554 = (_e2329 + 14i);
let _e2556 = select(_e2331, _e2554, (_e2554 < _e2331));
let _e2562 = global_3.member[bitcast<u32>(select(0i, _e2556, (_e2556 > 0i)))];
let _e2569 = (_e2329 + 15i);
let _e2571 = select(_e2331, _e2569, (_e2569 < _e2331));
let _e2577 = global_3.member[bitcast<u32>(select(0i, _e2571, (_e2571 > 0i)))];
let _e2578 = (_e2329 + 16i);
let _e2580 = select(_e2331, _e2578, (_e2578 < _e2331));
let _e2586 = global_3.member[bitcast<u32>(select(0i, _e2580, (_e2580 > 0i)))];
let _e2587 = (_e2329 + 17i);
let _e2589 = select(_e2331, _e2587, (_e2587 < _e2331));
let _e2595 = global_3.member[bitcast<u32>(select(0i, _e2589, (_e2589 > 0i)))];
let _e2599 = (((_e2514 * _e2488) + (_e2544 * _e2489)) + (_e2577 * _e2490));
let _e2600 = (((_e2523 * _e2488) + (_e2553 * _e2489)) + (_e2586 * _e2490));
let _e2601 = (((_e2532 * _e2488) + (_e2562 * _e2489)) + (_e2595 * _e2490));
let _e2606 = (((_e2599 * _e2599) + (_e2600 * _e2600)) + (_e2601 * _e2601));
let _e2609 = sqrt(select(0f, _e2606, (_e2606 > 0f)));
let _e2612 = (1f / select(1e-20f, _e2609, (_e2609 > 1e-20f)));
let _e2619 = global_1.member.member_1;
let _e2622 = (_e2329 + 18i);
let _e2624 = select(_e2331, _e2622, (_e2622 < _e2331));
let _e2630 = global_3.member[bitcast<u32>(select(0i, _e2624, (_e2624 > 0i)))];
let _e2639 = (select(select(0i, select(select(i32(_e2630), i32(-2147483648), (_e2630 < -2147483600f)), 2147483647i, (_e2630 > 2147483500f)), (_e2630 == _e2630)), _e2252, ((_e2619 & 4u) != 0u)) * 10i);
let _e2641 = (bitcast<i32>(_e157) - 1i);
let _e2643 = select(_e2641, _e2639, (_e2639 < _e2641));
let _e2649 = global_5.member[bitcast<u32>(select(0i, _e2643, (_e2643 > 0i)))];
let _e2650 = (_e2639 + 1i);
let _e2652 = select(_e2641, _e2650, (_e2650 < _e2641));
let _e2658 = global_5.member[bitcast<u32>(select(0i, _e2652, (_e2652 > 0i)))];
let _e2659 = (_e2639 + 2i);
let _e2661 = select(_e2641, _e2659, (_e2659 < _e2641));
let _e2667 = global_5.member[bitcast<u32>(select(0i, _e2661, (_e2661 > 0i)))];
let _e2671 = (_e2639 + 3i);
let _e2673 = select(_e2641, _e2671, (_e2671 < _e2641));
let _e2679 = global_5.member[bitcast<u32>(select(0i, _e2673, (_e2673 > 0i)))];
let _e2680 = (_e2639 + 4i);
let _e2682 = select(_e2641, _e2680, (_e2680 < _e2641));
let _e2688 = global_5.member[bitcast<u32>(select(0i, _e2682, (_e2682 > 0i)))];
let _e2689 = (_e2639 + 5i);
let _e2691 = select(_e2641, _e2689, (_e2689 < _e2641));
let _e2697 = global_5.member[bitcast<u32>(select(0i, _e2691, (_e2691 > 0i)))];
let _e2704 = (_e2639 + 6i);
let _e2706 = select(_e2641, _e2704, (_e2704 < _e2641));
let _e2712 = global_5.member[bitcast<u32>(select(0i, _e2706, (_e2706 > 0i)))];
let _e2713 = (_e2639 + 7i);
let _e2715 = select(_e2641, _e2713, (_e2713 < _e2641));
let _e2721 = global_5.member[bitcast<u32>(select(0i, _e2715, (_e2715 > 0i)))];
let _e2722 = (_e2639 + 8i);
let _e2724 = select(_e2641, _e2722, (_e2722 < _e2641));
let _e2730 = global_5.member[bitcast<u32>(select(0i, _e2724, (_e2724 > 0i)))];
let _e2738 = (_e2639 + 9i);
let _e2740 = select(_e2641, _e2738, (_e2738 < _e2641));
let _e2746 = global_5.member[bitcast<u32>(select(0i, _e2740, (_e2740 > 0i)))];
phi_4616_ = type_22(_e2283, vec3<f32>((_e2420 * _e2501), (_e2423 * _e2501), (_e2426 * _e2501)), vec3<f32>((_e2599 * _e2612), (_e2600 * _e2612), (_e2601 * _e2612)), vec3<f32>((((_e2649 * _e2488) + (_e2679 * _e2489)) + (_e2712 * _e2490)), (((_e2658 * _e2488) + (_e2688 * _e2489)) + (_e2721 * _e2490)), (((_e2667 * _e2488) + (_e2697 * _e2489)) + (_e2730 * _e2490))), _e2746, true);
}
let _e2749 = phi_4616_;
let _e2758 = (((_e2749.member_1.x * _e204) + (_e2749.member_1.y * _e215)) + (_e2749.member_1.z * _e226));
let _e2760 = select(1f, -1f, (_e2758 > 0f));
let _e2772 = select(_e2760, -(_e2760), ((((_e2749.member_2.x * _e2749.member_1.x) + (_e2749.member_2.y * _e2749.member_1.y)) + (_e2749.member_2.z * _e2749.member_1.z)) < 0f));
let _e2773 = (_e2749.member_2.x * _e2772);
let _e2774 = (_e2749.member_2.y * _e2772);
let _e2775 = (_e2749.member_2.z * _e2772);
let _e2784 = ((((_e2773 * _e204) + (_e2774 * _e215)) + (_e2775 * _e226)) > 0f);
let _e2785 = select(_e2773, (_e2749.member_1.x * _e2760), _e2784);
let _e2786 = select(_e2774, (_e2749.member_1.y * _e2760), _e2784);
let _e2787 = select(_e2775, (_e2749.member_1.z * _e2760), _e2784);
let _e2792 = global_1.member.member_18.member_2;
let _e2800 = global_1.member.member_18.member;
if (_e2800 == 0u) {
let _e2805 = global_1.member.member_18.member_1;
phi_5206_ = type_23(vec3<f32>(_e2805.member, _e2805.member_1, _e2805.member_2), vec3<f32>(_e2792.member, _e2792.member_1, _e2792.member_2));
} else {
let _e2814 = global_1.member.member_18.member_3;
let _e2819 = (_e2749.member.x - _e2814.member);
let _e2821 = (_e2749.member.y - _e2814.member_1);
let _e2823 = (_e2749.member.z - _e2814.member_2);
let _e2828 = (((_e2819 * _e2819) + (_e2821 * _e2821)) + (_e2823 * _e2823));
let _e2830 = select(1e-12f, _e2828, (_e2828 > 1e-12f));
let _e2831 = (1f / _e2830);
let _e2835 = vec3<f32>((_e2792.member * _e2831), (_e2792.member_1 * _e2831), (_e2792.member_2 * _e2831));
if (_e2800 == 2u) {
let _e2840 = global_1.member.member_18.member_1;
let _e2848 = (((_e2840.member * _e2819) + (_e2840.member_1 * _e2821)) + (_e2840.member_2 * _e2823));
let _e2851 = (1f / select(1e-20f, _e2848, (_e2848 > 1e-20f)));
let _e2856 = global_1.member.member_18.member_4.member;
let _e2865 = ((((_e2856.member * _e2819) + (_e2856.member_1 * _e2821)) + (_e2856.member_2 * _e2823)) * _e2851);
let _e2870 = global_1.member.member_18.member_4.member_1;
let _e2879 = ((((_e2870.member * _e2819) + (_e2870.member_1 * _e2821)) + (_e2870.member_2 * _e2823)) * _e2851);
let _e2884 = global_1.member.member_18.member_4.member_2;
let _e2887 = ((_e2865 * _e2865) + (_e2879 * _e2879));
let _e2896 = global_1.member.member_18.member_4.member_3;
let _e2897 = ((_e2884 - sqrt(select(0f, _e2887, (_e2887 > 0f)))) * _e2896);
let _e2899 = select(0f, _e2897, (_e2897 > 0f));
let _e2901 = select(1f, _e2899, (_e2899 < 1f));
let _e2907 = select(0f, ((_e2901 * _e2901) * (3f - (2f * _e2901))), (_e2848 > 0f));
let _e2912 = global_1.member.member_18.member_4.member_5;
if ((_e2912 > 0u) && (_e2907 > 0f)) {
let _e2916 = (0.5f / _e2884);
let _e2926 = global_1.member.member_18.member_4.member_6;
let _e2927 = bitcast<i32>(_e2926);
local_3 = bitcast<i32>(_e2912);
let _e2928 = local_3;
let _e2930 = f32((_e2928 - 1i));
let _e2932 = f32((_e2927 - 1i));
let _e2933 = local_3;
let _e2936 = (((0.5f + (_e2865 * _e2916)) * f32(_e2933)) - 0.5f);
let _e2938 = select(0f, _e2936, (_e2936 > 0f));
let _e2940 = select(_e2930, _e2938, (_e2938 < _e2930));
let _e2943 = (((0.5f - (_e2879 * _e2916)) * f32(_e2927)) - 0.5f);
let _e2945 = select(0f, _e2943, (_e2943 > 0f));
let _e2947 = select(_e2932, _e2945, (_e2945 < _e2932));
let _e2949 = select(0f, _e2940, (_e2940 > 0f));
let _e2951 = select(_e2930, _e2949, (_e2949 < _e2930));
let _e2958 = select(0i, select(select(i32(_e2951), i32(-2147483648), (_e2951 < -2147483600f)), 2147483647i, (_e2951 > 2147483500f)), (_e2951 == _e2951));
let _e2962 = (_e2958 - select(0i, 1i, (_e2951 < f32(_e2958))));
let _e2964 = select(0f, _e2947, (_e2947 > 0f));
let _e2966 = select(_e2932, _e2964, (_e2964 < _e2932));
let _e2973 = select(0i, select(select(i32(_e2966), i32(-2147483648), (_e2966 < -2147483600f)), 2147483647i, (_e2966 > 2147483500f)), (_e2966 == _e2966));
let _e2977 = (_e2973 - select(0i, 1i, (_e2966 < f32(_e2973))));
let _e2979 = (_e2940 - f32(_e2962));
let _e2981 = (_e2947 - f32(_e2977));
let _e2982 = (_e2962 + 1i);
let _e2983 = local_3;
let _e2985 = select(_e2962, _e2982, (_e2982 < _e2983));
let _e2986 = (_e2977 + 1i);
let _e2988 = select(_e2977, _e2986, (_e2986 < _e2927));
let _e2993 = global_1.member.member_18.member_4.member_4;
let _e2994 = bitcast<i32>(_e2993);
let _e2995 = local_3;
let _e2999 = (_e2994 + (3i * ((_e2977 * _e2995) + _e2962)));
let _e3001 = (bitcast<i32>(_e153) - 1i);
let _e3003 = select(_e3001, _e2999, (_e2999 < _e3001));
let _e3008 = global_4.member[bitcast<u32>(select(0i, _e3003, (_e3003 > 0i)))];
let _e3009 = (_e2999 + 1i);
let _e3011 = select(_e3001, _e3009, (_e3009 < _e3001));
let _e3016 = global_4.member[bitcast<u32>(select(0i, _e3011, (_e3011 > 0i)))];
let _e3017 = (_e2999 + 2i);
let _e3019 = select(_e3001, _e3017, (_e3017 < _e3001));
let _e3024 = global_4.member[bitcast<u32>(select(0i, _e3019, (_e3019 > 0i)))];
let _e3025 = local_3;
let _e3029 = (_e2994 + (3i * ((_e2977 * _e3025) + _e2985)));
let _e3031 = select(_e3001, _e3029, (_e3029 < _e3001));
let _e3036 = global_4.member[bitcast<u32>(select(0i, _e3031, (_e3031 > 0i)))];
let _e3037 = (_e3029 + 1i);
let _e3039 = select(_e3001, _e3037, (_e3037 < _e3001));
let _e3044 = global_4.member[bitcast<u32>(select(0i, _e3039, (_e3039 > 0i)))];
let _e3045 = (_e3029 + 2i);
let _e3047 = select(_e3001, _e3045, (_e3045 < _e3001));
let _e3052 = global_4.member[bitcast<u32>(select(0i, _e3047, (_e3047 > 0i)))];
let _e3053 = local_3;
let _e3057 = (_e2994 + (3i * ((_e2988 * _e3053) + _e2962)));
let _e3059 = select(_e3001, _e3057, (_e3057 < _e3001));
let _e3064 = global_4.member[bitcast<u32>(select(0i, _e3059, (_e3059 > 0i)))];
let _e3065 = (_e3057 + 1i);
let _e3067 = select(_e3001, _e3065, (_e3065 < _e3001));
let _e3072 = global_4.member[bitcast<u32>(select(0i, _e3067, (_e3067 > 0i)))];
let _e3073 = (_e3057 + 2i);
let _e3075 = select(_e3001, _e3073, (_e3073 < _e3001));
let _e3080 = global_4.member[bitcast<u32>(select(0i, _e3075, (_e3075 > 0i)))];
let _e3081 = local_3;
let _e3085 = (_e2994 + (3i * ((_e2988 * _e3081) + _e2985)));
let _e3087 = select(_e3001, _e3085, (_e3085 < _e3001));
let _e3092 = global_4.member[bitcast<u32>(select(0i, _e3087, (_e3087 > 0i)))];
let _e3093 = (_e3085 + 1i);
let _e3095 = select(_e3001, _e3093, (_e3093 < _e3001));
let _e3100 = global_4.member[bitcast<u32>(select(0i, _e3095, (_e3095 > 0i)))];
let _e3101 = (_e3085 + 2i);
let _e3103 = select(_e3001, _e3101, (_e3101 < _e3001));
let _e3108 = global_4.member[bitcast<u32>(select(0i, _e3103, (_e3103 > 0i)))];
let _e3115 = (_e3008 + ((_e3036 - _e3008) * _e2979));
let _e3116 = (_e3016 + ((_e3044 - _e3016) * _e2979));
let _e3117 = (_e3024 + ((_e3052 - _e3024) * _e2979));
phi_5190_ = vec3<f32>(((_e3115 + (((_e3064 + ((_e3092 - _e3064) * _e2979)) - _e3115) * _e2981)) * _e2907), ((_e3116 + (((_e3072 + ((_e3100 - _e3072) * _e2979)) - _e3116) * _e2981)) * _e2907), ((_e3117 + (((_e3080 + ((_e3108 - _e3080) * _e2979)) - _e3117) * _e2981)) * _e2907));
} else {
phi_5190_ = vec3(_e2907);
}
let _e3142 = phi_5190_;
phi_5193_ = (_e2835 * _e3142);
} else {
phi_5193_ = _e2835;
}
let _e3145 = phi_5193_;
let _e3149 = (1f / sqrt(select(0f, _e2830, (_e2830 > 0f))));
phi_5206_ = type_23(vec3<f32>((_e2819 * _e3149), (_e2821 * _e3149), (_e2823 * _e3149)), _e3145);
}
let _e3156 = phi_5206_;
let _e3167 = -((((_e2785 * _e3156.member.x) + (_e2786 * _e3156.member.y)) + (_e2787 * _e3156.member.z)));
let _e3173 = -((((_e2749.member_1.x * _e3156.member.x) + (_e2749.member_1.y * _e3156.member.y)) + (_e2749.member_1.z * _e3156.member.z)));
let _e3179 = -(_e3167);
let _e3184 = select((select(0f, _e3179, (_e3179 > 0f)) * _e2749.member_4), select(0f, _e3167, (_e3167 > 0f)), ((_e3173 * -(_e2758)) > 0f));
let _e3185 = -(_e3173);
let _e3187 = select(_e3185, _e3173, (_e3173 > _e3185));
let _e3193 = global_1.member.member_20.member_6;
let _e3207 = ((((_e3193.member.member * _e2749.member.x) + (_e3193.member.member_1 * _e2749.member.y)) + (_e3193.member.member_2 * _e2749.member.z)) + _e3193.member_1);
let _e3209 = select(1f, _e3207, (_e3207 > 1e-6f));
let _e3213 = global_1.member.member_20.member_4;
let _e3229 = global_1.member.member_20.member_5;
let _e3245 = global_1.member.member_20.member_2;
let _e3254 = -((((_e2749.member_1.x * _e3245.member) + (_e2749.member_1.y * _e3245.member_1)) + (_e2749.member_1.z * _e3245.member_2)));
let _e3255 = -(_e3254);
let _e3257 = select(_e3255, _e3254, (_e3254 > _e3255));
let _e3259 = select(1f, _e3257, (_e3257 < 1f));
let _e3261 = (1f - (_e3259 * _e3259));
let _e3268 = global_1.member.member_20.member_8;
let _e3276 = global_1.member.member_20.member_7.member;
let _e3281 = global_1.member.member_20.member_7.member_2;
let _e3283 = (_e3276 + (_e3281 * (((((_e3213.member.member * _e2749.member.x) + (_e3213.member.member_1 * _e2749.member.y)) + (_e3213.member.member_2 * _e2749.member.z)) + _e3213.member_1) / _e3209)));
let _e3288 = global_1.member.member_20.member_7.member_1;
let _e3290 = (_e3288 + (_e3281 * (((((_e3229.member.member * _e2749.member.x) + (_e3229.member.member_1 * _e2749.member.y)) + (_e3229.member.member_2 * _e2749.member.z)) + _e3229.member_1) / _e3209)));
let _e3294 = ((1f + (_e3283 * _e3283)) + (_e3290 * _e3290));
let _e3303 = global_1.member.member_20.member_9;
let _e3307 = (select(1f, -1f, (_e3173 < 0f)) * (((((1.4142135f * _e3268) * sqrt(select(0f, _e3261, (_e3261 > 0f)))) * _e3207) + (select(1f, _e3187, (_e3187 < 1f)) * sqrt(select(0f, _e3294, (_e3294 > 0f))))) * _e3303));
let _e3312 = select(0f, 1f, _e2749.member_5);
let _e3316 = (_e2749.member.x + ((_e2749.member_1.x * _e3307) * _e3312));
let _e3317 = (_e2749.member.y + ((_e2749.member_1.y * _e3307) * _e3312));
let _e3318 = (_e2749.member.z + ((_e2749.member_1.z * _e3307) * _e3312));
let _e3323 = global_1.member.member_20.member.member;
let _e3324 = bitcast<i32>(_e3323);
let _e3329 = global_1.member.member_20.member.member_1;
let _e3330 = bitcast<i32>(_e3329);
let _e3335 = global_1.member.member_20.member.member_2;
let _e3336 = bitcast<i32>(_e3335);
let _e3340 = global_1.member.member_20.member_1;
let _e3341 = bitcast<i32>(_e3340);
let _e3347 = ((((_e3193.member.member * _e3316) + (_e3193.member.member_1 * _e3317)) + (_e3193.member.member_2 * _e3318)) + _e3193.member_1);
let _e3349 = select(1f, _e3347, (_e3347 > 1e-6f));
let _e3353 = global_1.member.member_20.member_3;
let _e3364 = ((((_e3353.member.member * _e3316) + (_e3353.member.member_1 * _e3317)) + (_e3353.member.member_2 * _e3318)) + _e3353.member_1);
let _e3379 = ((((((_e3213.member.member * _e3316) + (_e3213.member.member_1 * _e3317)) + (_e3213.member.member_2 * _e3318)) + _e3213.member_1) / _e3349) - 0.5f);
let _e3380 = ((((((_e3229.member.member * _e3316) + (_e3229.member.member_1 * _e3317)) + (_e3229.member.member_2 * _e3318)) + _e3229.member_1) / _e3349) - 0.5f);
let _e3382 = f32((_e3324 - 1i));
let _e3384 = select(0f, _e3364, (_e3364 > 0f));
let _e3386 = select(_e3382, _e3384, (_e3384 < _e3382));
let _e3393 = select(0i, select(select(i32(_e3386), i32(-2147483648), (_e3386 < -2147483600f)), 2147483647i, (_e3386 > 2147483500f)), (_e3386 == _e3386));
let _e3397 = (_e3393 - select(0i, 1i, (_e3386 < f32(_e3393))));
let _e3401 = (_e3364 - f32(_e3397));
let _e3404 = select(1f, select(0f, _e3401, (_e3401 > 0f)), (_e3364 < f32(_e3324)));
let _e3405 = (_e3379 - _e3268);
let _e3406 = -(16f);
let _e3407 = f32(_e3330);
let _e3409 = select(_e3406, _e3405, (_e3405 > _e3406));
let _e3411 = select(_e3407, _e3409, (_e3409 < _e3407));
let _e3418 = select(0i, select(select(i32(_e3411), i32(-2147483648), (_e3411 < -2147483600f)), 2147483647i, (_e3411 > 2147483500f)), (_e3411 == _e3411));
let _e3424 = (_e3379 + _e3268);
let _e3427 = (f32((_e3330 - 1i)) + 16f);
let _e3429 = select(-1f, _e3424, (_e3424 > -1f));
let _e3431 = select(_e3427, _e3429, (_e3429 < _e3427));
let _e3438 = select(0i, select(select(i32(_e3431), i32(-2147483648), (_e3431 < -2147483600f)), 2147483647i, (_e3431 > 2147483500f)), (_e3431 == _e3431));
let _e3443 = (_e3380 - _e3268);
let _e3444 = f32(_e3336);
let _e3446 = select(_e3406, _e3443, (_e3443 > _e3406));
let _e3448 = select(_e3444, _e3446, (_e3446 < _e3444));
let _e3455 = select(0i, select(select(i32(_e3448), i32(-2147483648), (_e3448 < -2147483600f)), 2147483647i, (_e3448 > 2147483500f)), (_e3448 == _e3448));
let _e3461 = (_e3380 + _e3268);
let _e3464 = (f32((_e3336 - 1i)) + 16f);
let _e3466 = select(-1f, _e3461, (_e3461 > -1f));
let _e3468 = select(_e3464, _e3466, (_e3466 < _e3464));
let _e3475 = select(0i, select(select(i32(_e3468), i32(-2147483648), (_e3468 < -2147483600f)), 2147483647i, (_e3468 > 2147483500f)), (_e3468 == _e3468));
let _e3483 = bitcast<i32>(((_e3323 + 2u) >> bitcast<u32>(1i)));
let _e3485 = ((_e3330 * _e3336) * _e3483);
phi_5662_ = 0f;
phi_5665_ = vec3<f32>(0f, 0f, 0f);
phi_5667_ = ((_e3455 - select(0i, 1i, (_e3448 < f32(_e3455)))) + 1i);
loop {
let _e3487 = phi_5662_;
let _e3489 = phi_5665_;
let _e3491 = phi_5667_;
local_74 = _e3487;
local_75 = _e3487;
local_76 = _e3489;
local_77 = _e3489;
local_78 = _e3489;
let _e3492 = (_e3491 <= (_e3475 - select(0i, 1i, (_e3468 < f32(_e3475)))));
if _e3492 {
let _e3498 = (_e3268 - bitcast<f32>((bitcast<u32>((f32(_e3491) - _e3380)) & 2147483647u)));
phi_5682_ = ((_e3418 - select(0i, 1i, (_e3411 < f32(_e3418)))) + 1i);
phi_5685_ = _e3487;
phi_5687_ = _e3489;
loop {
let _e3500 = phi_5682_;
let _e3502 = phi_5685_;
let _e3504 = phi_5687_;
local_116 = _e3502;
local_117 = _e3504;
let _e3505 = (_e3500 <= (_e3438 - select(0i, 1i, (_e3431 < f32(_e3438)))));
if _e3505 {
let _e3511 = (_e3268 - bitcast<f32>((bitcast<u32>((f32(_e3500) - _e3379)) & 2147483647u)));
let _e3516 = (select(0f, _e3511, (_e3511 > 0f)) * select(0f, _e3498, (_e3498 > 0f)));
if ((((_e3500 >= 0i) && (_e3500 < _e3330)) && (_e3491 >= 0i)) && (_e3491 < _e3336)) {
let _e3526 = (((_e3491 * _e3330) + _e3500) * _e3483);
let _e3528 = (2i * _e3397);
let _e3529 = ((4i * _e3526) + _e3528);
let _e3531 = (_e3529 >> bitcast<u32>(2i));
let _e3534 = bitcast<u32>(((_e3529 & 3i) * 8i));
let _e3536 = (bitcast<i32>(_e159) - 1i);
let _e3538 = select(_e3536, _e3531, (_e3531 < _e3536));
let _e3544 = global_6.member[bitcast<u32>(select(0i, _e3538, (_e3538 > 0i)))];
let _e3548 = (_e3531 + 1i);
let _e3550 = select(_e3536, _e3548, (_e3548 < _e3536));
let _e3556 = global_6.member[bitcast<u32>(select(0i, _e3550, (_e3550 > 0i)))];
let _e3563 = ((_e3544 >> bitcast<u32>((_e3534 & 31u))) | ((_e3556 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3534) & 31u))));
let _e3566 = f32(bitcast<i32>((_e3563 & 65535u)));
let _e3574 = (1f / 65535f);
let _e3576 = (_e3516 * ((_e3566 + ((f32(bitcast<i32>((_e3563 >> bitcast<u32>(16i)))) - _e3566) * _e3404)) * _e3574));
let _e3578 = (_e3504.x + _e3576);
if (_e3341 > 1i) {
let _e3582 = ((4i * (_e3526 + _e3485)) + _e3528);
let _e3584 = (_e3582 >> bitcast<u32>(2i));
let _e3587 = bitcast<u32>(((_e3582 & 3i) * 8i));
let _e3589 = select(_e3536, _e3584, (_e3584 < _e3536));
let _e3595 = global_6.member[bitcast<u32>(select(0i, _e3589, (_e3589 > 0i)))];
let _e3599 = (_e3584 + 1i);
let _e3601 = select(_e3536, _e3599, (_e3599 < _e3536));
let _e3607 = global_6.member[bitcast<u32>(select(0i, _e3601, (_e3601 > 0i)))];
let _e3614 = ((_e3595 >> bitcast<u32>((_e3587 & 31u))) | ((_e3607 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3587) & 31u))));
let _e3617 = f32(bitcast<i32>((_e3614 & 65535u)));
let _e3632 = ((4i * (_e3526 + (2i * _e3485))) + _e3528);
let _e3634 = (_e3632 >> bitcast<u32>(2i));
let _e3637 = bitcast<u32>(((_e3632 & 3i) * 8i));
let _e3639 = select(_e3536, _e3634, (_e3634 < _e3536));
let _e3645 = global_6.member[bitcast<u32>(select(0i, _e3639, (_e3639 > 0i)))];
let _e3649 = (_e3634 + 1i);
let _e3651 = select(_e3536, _e3649, (_e3649 < _e3536));
let _e3657 = global_6.member[bitcast<u32>(select(0i, _e3651, (_e3651 > 0i)))];
let _e3664 = ((_e3645 >> bitcast<u32>((_e3637 & 31u))) | ((_e3657 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3637) & 31u))));
let _e3667 = f32(bitcast<i32>((_e3664 & 65535u)));
phi_5920_ = vec3<f32>(_e3578, (_e3504.y + (_e3516 * ((_e3617 + ((f32(bitcast<i32>((_e3614 >> bitcast<u32>(16i)))) - _e3617) * _e3404)) * _e3574))), (_e3504.z + (_e3516 * ((_e3667 + ((f32(bitcast<i32>((_e3664 >> bitcast<u32>(16i)))) - _e3667) * _e3404)) * _e3574))));
} else {
phi_5920_ = vec3<f32>(_e3578, (_e3504.y + _e3576), (_e3504.z + _e3576));
}
let _e3686 = phi_5920_;
phi_5930_ = _e3686;
} else {
phi_5930_ = vec3<f32>((_e3504.x + _e3516), (_e3504.y + _e3516), (_e3504.z + _e3516));
}
let _e3695 = phi_5930_;
phi_5683_ = (_e3500 + 1i);
phi_5686_ = (_e3502 + _e3516);
phi_5688_ = _e3695;
} else {
phi_5683_ = i32();
phi_5686_ = f32();
phi_5688_ = vec3<f32>();
}
let _e3699 = phi_5683_;
let _e3701 = phi_5686_;
let _e3703 = phi_5688_;
continue;
continuing {
phi_5682_ = _e3699;
phi_5685_ = _e3701;
phi_5687_ = _e3703;
break if !(_e3505);
}
}
let _e6730 = local_116;
phi_5663_ = _e6730;
let _e6733 = local_117;
phi_5666_ = _e6733;
phi_5668_ = (_e3491 + 1i);
} else {
phi_5663_ = f32();
phi_5666_ = vec3<f32>();
phi_5668_ = i32();
}
let _e3707 = phi_5663_;
let _e3709 = phi_5666_;
let _e3711 = phi_5668_;
continue;
continuing {
phi_5662_ = _e3707;
phi_5665_ = _e3709;
phi_5667_ = _e3711;
break if !(_e3492);
}
}
let _e3715 = local_74;
let _e3719 = (((_e3341 == 0i) || (_e3715 <= 0f)) || (_e3347 <= 1e-6f));
let _e3721 = local_75;
let _e3723 = (1f / select(_e3721, 1f, _e3719));
let _e3725 = local_76;
let _e3730 = local_77;
let _e3735 = local_78;
let _e3751 = global_1.member.member_19;
if (_e271 == 0f) {
phi_6052_ = vec3<f32>(_e2785, _e2786, _e2787);
} else {
phi_6052_ = _e320;
}
let _e3763 = phi_6052_;
phi_6053_ = _e3763;
phi_6054_ = (_e2749.member_3 * vec3<f32>(((_e3156.member_1.x * (select((_e3725.x * _e3723), 1f, _e3719) * _e3184)) + _e3751.member), ((_e3156.member_1.y * (select((_e3730.y * _e3723), 1f, _e3719) * _e3184)) + _e3751.member_1), ((_e3156.member_1.z * (select((_e3735.z * _e3723), 1f, _e3719) * _e3184)) + _e3751.member_2)));
} else {
phi_6053_ = _e320;
phi_6054_ = _e2234;
}
let _e3765 = phi_6053_;
let _e3767 = phi_6054_;
let _e3774 = local_41;
let _e3776 = local_40;
let _e3777 = ((21i * _e3774) + _e3776);
let _e3779 = select(_e197, _e3777, (_e3777 < _e197));
let _e3784 = global_2.member[bitcast<u32>(select(0i, _e3779, (_e3779 > 0i)))];
local_1 = _e184;
local_2 = _e190;
let _e3785 = local_2;
let _e3787 = local_1;
let _e3788 = ((9i * _e3785) + _e3787);
let _e3790 = select(_e197, _e3788, (_e3788 < _e197));
let _e3795 = global_2.member[bitcast<u32>(select(0i, _e3790, (_e3790 > 0i)))];
let _e3796 = local_2;
let _e3798 = local_1;
let _e3799 = ((10i * _e3796) + _e3798);
let _e3801 = select(_e197, _e3799, (_e3799 < _e197));
let _e3806 = global_2.member[bitcast<u32>(select(0i, _e3801, (_e3801 > 0i)))];
let _e3807 = local_2;
let _e3809 = local_1;
let _e3810 = ((11i * _e3807) + _e3809);
let _e3812 = select(_e197, _e3810, (_e3810 < _e197));
let _e3817 = global_2.member[bitcast<u32>(select(0i, _e3812, (_e3812 > 0i)))];
let _e3823 = (2f * (((_e1074 * _e3795) + (_e1075 * _e3806)) + (_e1076 * _e3817)));
let _e3827 = (_e1074 - (_e3795 * _e3823));
let _e3828 = (_e1075 - (_e3806 * _e3823));
let _e3829 = (_e1076 - (_e3817 * _e3823));
let _e3830 = (_e701 - _e532);
let _e3831 = (_e702 - _e533);
let _e3832 = (_e703 - _e534);
let _e3837 = (((_e3830 * _e3830) + (_e3831 * _e3831)) + (_e3832 * _e3832));
let _e3842 = (_e701 - _e3827);
let _e3843 = (_e702 - _e3828);
let _e3844 = (_e703 - _e3829);
let _e3849 = (((_e3842 * _e3842) + (_e3843 * _e3843)) + (_e3844 * _e3844));
let _e3853 = (_e3827 - _e532);
let _e3854 = (_e3828 - _e533);
let _e3855 = (_e3829 - _e534);
let _e3860 = (((_e3853 * _e3853) + (_e3854 * _e3854)) + (_e3855 * _e3855));
let _e3868 = select(select(_e1087, select(sqrt(select(0f, _e3860, (_e3860 > 0f))), sqrt(select(0f, _e3849, (_e3849 > 0f))), _e625), (_e413 || _e625)), (0.5f * sqrt(select(0f, _e3837, (_e3837 > 0f)))), (_e413 && _e625));
let _e3869 = (_e1051 - _e881);
let _e3870 = (_e1052 - _e882);
let _e3871 = (_e1053 - _e883);
let _e3876 = (((_e3869 * _e3869) + (_e3870 * _e3870)) + (_e3871 * _e3871));
let _e3881 = (_e1051 - _e3827);
let _e3882 = (_e1052 - _e3828);
let _e3883 = (_e1053 - _e3829);
let _e3888 = (((_e3881 * _e3881) + (_e3882 * _e3882)) + (_e3883 * _e3883));
let _e3892 = (_e3827 - _e881);
let _e3893 = (_e3828 - _e882);
let _e3894 = (_e3829 - _e883);
let _e3899 = (((_e3892 * _e3892) + (_e3893 * _e3893)) + (_e3894 * _e3894));
let _e3907 = select(select(_e1087, select(sqrt(select(0f, _e3899, (_e3899 > 0f))), sqrt(select(0f, _e3888, (_e3888 > 0f))), _e974), (_e795 || _e974)), (0.5f * sqrt(select(0f, _e3876, (_e3876 > 0f)))), (_e795 && _e974));
let _e3909 = select(_e3907, _e3868, (_e3868 > _e3907));
let _e3914 = (((_e1173.member * _e3827) + (_e1173.member_1 * _e3828)) + (_e1173.member_2 * _e3829));
let _e3919 = (((_e1185.member * _e3827) + (_e1185.member_1 * _e3828)) + (_e1185.member_2 * _e3829));
let _e3924 = (((_e1197.member * _e3827) + (_e1197.member_1 * _e3828)) + (_e1197.member_2 * _e3829));
if _e1225 {
phi_7839_ = _e1217;
} else {
if (_e1209 == 1u) {
let _e3927 = select(-1f, _e3924, (_e3924 > -1f));
let _e3929 = select(1f, _e3927, (_e3927 < 1f));
if (_e3929 > 0f) {
phi_6454_ = _e1217;
} else {
let _e3934 = global_1.member.member_16.member_9;
phi_6454_ = vec3<f32>(_e3934.member, _e3934.member_1, _e3934.member_2);
}
let _e3940 = phi_6454_;
let _e3949 = bitcast<f32>((bitcast<u32>(_e3929) & 2147483647u));
let _e3952 = sqrt(select(0f, _e3949, (_e3949 > 0f)));
phi_7838_ = vec3<f32>((_e1221.member + ((_e3940.x - _e1221.member) * _e3952)), (_e1221.member_1 + ((_e3940.y - _e1221.member_1) * _e3952)), (_e1221.member_2 + ((_e3940.z - _e1221.member_2) * _e3952)));
} else {
if (_e1209 == 2u) {
let _e3964 = global_1.member.member_16.member_10;
let _e3965 = (_e3909 / _e3964);
let _e3967 = select(1e-4f, _e3965, (_e3965 > 1e-4f));
let _e3970 = bitcast<f32>((bitcast<u32>(_e3914) & 2147483647u));
let _e3973 = bitcast<f32>((bitcast<u32>(_e3919) & 2147483647u));
let _e3977 = select(_e3973, _e3970, (_e3970 > _e3973));
let _e3980 = (select(_e3973, _e3970, (_e3970 < _e3973)) / select(1.1754944e-38f, _e3977, (_e3977 > 1.1754944e-38f)));
let _e3981 = (_e3980 > 0.41421357f);
let _e3985 = select(_e3980, ((_e3980 - 1f) / (_e3980 + 1f)), _e3981);
let _e3986 = (_e3985 * _e3985);
let _e4001 = (select(0f, 0.7853982f, _e3981) + (_e3985 + ((_e3985 * _e3986) * (-0.33333334f + (_e3986 * (0.2f + (_e3986 * (-0.14285713f + (_e3986 * (0.11111111f + (_e3986 * (-0.09090909f + (_e3986 * 0.0585f)))))))))))));
let _e4004 = select(_e4001, (1.5707964f - _e4001), (_e3973 > _e3970));
let _e4007 = select(_e4004, (3.1415927f - _e4004), (_e3914 < 0f));
let _e4013 = (1f - (_e3924 * _e3924));
let _e4016 = sqrt(select(0f, _e4013, (_e4013 > 0f)));
let _e4019 = (_e3967 / select(1e-3f, _e4016, (_e4016 > 1e-3f)));
let _e4020 = ((select(_e4007, -(_e4007), (_e3919 < 0f)) / _e3964) * 0.5f);
let _e4022 = select(-8e6f, _e4020, (_e4020 > -8e6f));
let _e4024 = select(8e6f, _e4022, (_e4022 < 8e6f));
let _e4031 = select(0i, select(select(i32(_e4024), i32(-2147483648), (_e4024 < -2147483600f)), 2147483647i, (_e4024 > 2147483500f)), (_e4024 == _e4024));
let _e4038 = ((_e4020 - f32((_e4031 - select(0i, 1i, (_e4024 < f32(_e4031)))))) * 2f);
let _e4046 = ((select(select((_e4038 - 2f), (1f - _e4038), (_e4038 < 1.5f)), _e4038, (_e4038 < 0.5f)) * 2f) / _e4019);
let _e4048 = select(-1f, _e4046, (_e4046 > -1f));
let _e4051 = (2f - _e4019);
let _e4053 = select(0f, _e4051, (_e4051 > 0f));
let _e4058 = select(-1f, _e3924, (_e3924 > -1f));
let _e4060 = select(1f, _e4058, (_e4058 < 1f));
let _e4063 = ((1f - _e4060) * (1f + _e4060));
let _e4066 = sqrt(select(0f, _e4063, (_e4063 > 0f)));
let _e4069 = bitcast<f32>((bitcast<u32>(_e4066) & 2147483647u));
let _e4072 = bitcast<f32>((bitcast<u32>(_e4060) & 2147483647u));
let _e4076 = select(_e4072, _e4069, (_e4069 > _e4072));
let _e4079 = (select(_e4072, _e4069, (_e4069 < _e4072)) / select(1.1754944e-38f, _e4076, (_e4076 > 1.1754944e-38f)));
let _e4080 = (_e4079 > 0.41421357f);
let _e4084 = select(_e4079, ((_e4079 - 1f) / (_e4079 + 1f)), _e4080);
let _e4085 = (_e4084 * _e4084);
let _e4100 = (select(0f, 0.7853982f, _e4080) + (_e4084 + ((_e4084 * _e4085) * (-0.33333334f + (_e4085 * (0.2f + (_e4085 * (-0.14285713f + (_e4085 * (0.11111111f + (_e4085 * (-0.09090909f + (_e4085 * 0.0585f)))))))))))));
let _e4103 = select(_e4100, (1.5707964f - _e4100), (_e4072 > _e4069));
let _e4106 = select(_e4103, (3.1415927f - _e4103), (_e4066 < 0f));
let _e4111 = ((select(_e4106, -(_e4106), (_e4060 < 0f)) / _e3964) * 0.5f);
let _e4113 = select(-8e6f, _e4111, (_e4111 > -8e6f));
let _e4115 = select(8e6f, _e4113, (_e4113 < 8e6f));
let _e4122 = select(0i, select(select(i32(_e4115), i32(-2147483648), (_e4115 < -2147483600f)), 2147483647i, (_e4115 > 2147483500f)), (_e4115 == _e4115));
let _e4129 = ((_e4111 - f32((_e4122 - select(0i, 1i, (_e4115 < f32(_e4122)))))) * 2f);
let _e4137 = ((select(select((_e4129 - 2f), (1f - _e4129), (_e4129 < 1.5f)), _e4129, (_e4129 < 0.5f)) * 2f) / _e3967);
let _e4139 = select(-1f, _e4137, (_e4137 > -1f));
let _e4142 = (2f - _e3967);
let _e4144 = select(0f, _e4142, (_e4142 > 0f));
let _e4150 = (0.5f + ((0.5f * (select(1f, _e4048, (_e4048 < 1f)) * select(1f, _e4053, (_e4053 < 1f)))) * (select(1f, _e4139, (_e4139 < 1f)) * select(1f, _e4144, (_e4144 < 1f)))));
phi_7837_ = vec3<f32>((_e1213.member + ((_e1221.member - _e1213.member) * _e4150)), (_e1213.member_1 + ((_e1221.member_1 - _e1213.member_1) * _e4150)), (_e1213.member_2 + ((_e1221.member_2 - _e1213.member_2) * _e4150)));
} else {
let _e4164 = global_1.member.member_16.member_1;
let _e4165 = bitcast<i32>(_e4164);
let _e4170 = global_1.member.member_16.member_3;
let _e4172 = f32(bitcast<i32>(_e4170));
let _e4174 = (2f * 3.1415927f);
let _e4175 = ((_e3909 * f32(_e4165)) / _e4174);
let _e4177 = select(1e-6f, _e4175, (_e4175 > 1e-6f));
let _e4180 = bitcast<u32>(select(1.1754944e-38f, _e4177, (_e4177 > 1.1754944e-38f)));
let _e4181 = (_e4180 & 8388607u);
let _e4183 = select(0u, 1u, (_e4181 > 3474675u));
let _e4194 = bitcast<f32>((_e4181 | ((127u - _e4183) << bitcast<u32>(23i))));
let _e4197 = ((_e4194 - 1f) / (_e4194 + 1f));
let _e4198 = (_e4197 * _e4197);
let _e4213 = (f32(((bitcast<i32>((_e4180 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e4183))) + (((2f * _e4197) + ((_e4197 * _e4198) * (0.6666667f + (_e4198 * (0.4f + (_e4198 * (0.2857143f + (_e4198 * (0.22222222f + (_e4198 * 0.18181819f)))))))))) * 1.442695f));
let _e4214 = (_e4172 - 1f);
let _e4216 = select(0f, _e4213, (_e4213 > 0f));
let _e4218 = select(_e4214, _e4216, (_e4216 < _e4214));
let _e4219 = (_e4172 - 2f);
let _e4221 = select(0f, _e4219, (_e4219 > 0f));
let _e4223 = select(0f, _e4218, (_e4218 > 0f));
let _e4225 = select(_e4221, _e4223, (_e4223 < _e4221));
let _e4232 = select(0i, select(select(i32(_e4225), i32(-2147483648), (_e4225 < -2147483600f)), 2147483647i, (_e4225 > 2147483500f)), (_e4225 == _e4225));
let _e4236 = (_e4232 - select(0i, 1i, (_e4225 < f32(_e4232))));
let _e4239 = bitcast<f32>((bitcast<u32>(_e3919) & 2147483647u));
let _e4242 = bitcast<f32>((bitcast<u32>(_e3914) & 2147483647u));
let _e4246 = select(_e4242, _e4239, (_e4239 > _e4242));
let _e4249 = (select(_e4242, _e4239, (_e4239 < _e4242)) / select(1.1754944e-38f, _e4246, (_e4246 > 1.1754944e-38f)));
let _e4250 = (_e4249 > 0.41421357f);
let _e4254 = select(_e4249, ((_e4249 - 1f) / (_e4249 + 1f)), _e4250);
let _e4255 = (_e4254 * _e4254);
let _e4270 = (select(0f, 0.7853982f, _e4250) + (_e4254 + ((_e4254 * _e4255) * (-0.33333334f + (_e4255 * (0.2f + (_e4255 * (-0.14285713f + (_e4255 * (0.11111111f + (_e4255 * (-0.09090909f + (_e4255 * 0.0585f)))))))))))));
let _e4273 = select(_e4270, (1.5707964f - _e4270), (_e4242 > _e4239));
let _e4276 = select(_e4273, (3.1415927f - _e4273), (_e3919 < 0f));
let _e4281 = (0.5f - (select(_e4276, -(_e4276), (_e3914 < 0f)) / _e4174));
let _e4283 = select(-1f, _e3924, (_e3924 > -1f));
let _e4285 = select(1f, _e4283, (_e4283 < 1f));
let _e4288 = ((1f - _e4285) * (1f + _e4285));
let _e4291 = sqrt(select(0f, _e4288, (_e4288 > 0f)));
let _e4294 = bitcast<f32>((bitcast<u32>(_e4291) & 2147483647u));
let _e4297 = bitcast<f32>((bitcast<u32>(_e4285) & 2147483647u));
let _e4301 = select(_e4297, _e4294, (_e4294 > _e4297));
let _e4304 = (select(_e4297, _e4294, (_e4294 < _e4297)) / select(1.1754944e-38f, _e4301, (_e4301 > 1.1754944e-38f)));
let _e4305 = (_e4304 > 0.41421357f);
let _e4309 = select(_e4304, ((_e4304 - 1f) / (_e4304 + 1f)), _e4305);
let _e4310 = (_e4309 * _e4309);
let _e4325 = (select(0f, 0.7853982f, _e4305) + (_e4309 + ((_e4309 * _e4310) * (-0.33333334f + (_e4310 * (0.2f + (_e4310 * (-0.14285713f + (_e4310 * (0.11111111f + (_e4310 * (-0.09090909f + (_e4310 * 0.0585f)))))))))))));
let _e4328 = select(_e4325, (1.5707964f - _e4325), (_e4297 > _e4294));
let _e4331 = select(_e4328, (3.1415927f - _e4328), (_e4291 < 0f));
let _e4336 = (0.5f - (select(_e4331, -(_e4331), (_e4285 < 0f)) / 3.1415927f));
let _e4340 = global_1.member.member_16.member_2;
let _e4341 = bitcast<i32>(_e4340);
phi_7056_ = 0i;
phi_7059_ = 0i;
phi_7061_ = _e4341;
phi_7063_ = _e4165;
loop {
let _e4343 = phi_7056_;
let _e4345 = phi_7059_;
let _e4347 = phi_7061_;
let _e4349 = phi_7063_;
local_79 = _e4349;
local_80 = _e4347;
local_81 = _e4349;
local_82 = _e4349;
local_83 = _e4349;
local_84 = _e4349;
local_85 = _e4349;
local_86 = _e4349;
local_87 = _e4347;
local_88 = _e4347;
local_89 = _e4347;
local_90 = _e4347;
local_91 = _e4349;
local_92 = _e4345;
local_93 = _e4349;
local_94 = _e4345;
let _e4350 = (_e4343 < _e4236);
if _e4350 {
if (_e4349 > 1i) {
phi_7078_ = (_e4349 >> bitcast<u32>(1i));
} else {
phi_7078_ = 1i;
}
let _e4357 = phi_7078_;
if (_e4347 > 1i) {
phi_7084_ = (_e4347 >> bitcast<u32>(1i));
} else {
phi_7084_ = 1i;
}
let _e4362 = phi_7084_;
phi_7057_ = (_e4343 + 1i);
phi_7060_ = (_e4345 + (_e4349 * _e4347));
phi_7062_ = _e4362;
phi_7064_ = _e4357;
} else {
phi_7057_ = i32();
phi_7060_ = i32();
phi_7062_ = i32();
phi_7064_ = i32();
}
let _e4365 = phi_7057_;
let _e4367 = phi_7060_;
let _e4369 = phi_7062_;
let _e4371 = phi_7064_;
continue;
continuing {
phi_7056_ = _e4365;
phi_7059_ = _e4367;
phi_7061_ = _e4369;
phi_7063_ = _e4371;
break if !(_e4350);
}
}
let _e4374 = local_79;
let _e4375 = f32(_e4374);
let _e4377 = ((_e4281 * _e4375) - 0.5f);
let _e4379 = local_80;
let _e4380 = f32(_e4379);
let _e4382 = ((_e4336 * _e4380) - 0.5f);
let _e4384 = select(-1f, _e4377, (_e4377 > -1f));
let _e4386 = select(_e4375, _e4384, (_e4384 < _e4375));
let _e4393 = select(0i, select(select(i32(_e4386), i32(-2147483648), (_e4386 < -2147483600f)), 2147483647i, (_e4386 > 2147483500f)), (_e4386 == _e4386));
let _e4397 = (_e4393 - select(0i, 1i, (_e4386 < f32(_e4393))));
let _e4399 = select(-1f, _e4382, (_e4382 > -1f));
let _e4401 = select(_e4380, _e4399, (_e4399 < _e4380));
let _e4408 = select(0i, select(select(i32(_e4401), i32(-2147483648), (_e4401 < -2147483600f)), 2147483647i, (_e4401 > 2147483500f)), (_e4401 == _e4401));
let _e4412 = (_e4408 - select(0i, 1i, (_e4401 < f32(_e4408))));
let _e4414 = (_e4377 - f32(_e4397));
let _e4416 = (_e4382 - f32(_e4412));
let _e4418 = select(0f, _e4416, (_e4416 > 0f));
let _e4420 = select(1f, _e4418, (_e4418 < 1f));
if (_e4397 < 0i) {
let _e4423 = local_81;
phi_7159_ = (_e4397 + _e4423);
} else {
phi_7159_ = _e4397;
}
let _e4426 = phi_7159_;
let _e4428 = local_82;
if (_e4426 >= _e4428) {
let _e4431 = local_83;
phi_7165_ = (_e4426 - _e4431);
} else {
phi_7165_ = _e4426;
}
let _e4434 = phi_7165_;
let _e4435 = (_e4397 + 1i);
if (_e4435 < 0i) {
let _e4438 = local_84;
phi_7172_ = (_e4435 + _e4438);
} else {
phi_7172_ = _e4435;
}
let _e4441 = phi_7172_;
let _e4443 = local_85;
if (_e4441 >= _e4443) {
let _e4446 = local_86;
phi_7178_ = (_e4441 - _e4446);
} else {
phi_7178_ = _e4441;
}
let _e4449 = phi_7178_;
let _e4451 = select(_e4412, 0i, (_e4412 < 0i));
let _e4453 = local_87;
if (_e4451 >= _e4453) {
let _e4456 = local_88;
phi_7189_ = (_e4456 - 1i);
} else {
phi_7189_ = _e4451;
}
let _e4459 = phi_7189_;
let _e4460 = (_e4412 + 1i);
let _e4462 = select(_e4460, 0i, (_e4460 < 0i));
let _e4464 = local_89;
if (_e4462 >= _e4464) {
let _e4467 = local_90;
phi_7201_ = (_e4467 - 1i);
} else {
phi_7201_ = _e4462;
}
let _e4470 = phi_7201_;
let _e4472 = local_91;
let _e4475 = local_92;
let _e4476 = (_e4475 + (_e4459 * _e4472));
let _e4478 = local_93;
let _e4481 = local_94;
let _e4482 = (_e4481 + (_e4470 * _e4478));
let _e4484 = (3i * (_e4476 + _e4434));
let _e4486 = (bitcast<i32>(_e153) - 1i);
let _e4488 = select(_e4486, _e4484, (_e4484 < _e4486));
let _e4494 = global_4.member[bitcast<u32>(select(0i, _e4488, (_e4488 > 0i)))];
let _e4495 = (_e4484 + 1i);
let _e4497 = select(_e4486, _e4495, (_e4495 < _e4486));
let _e4503 = global_4.member[bitcast<u32>(select(0i, _e4497, (_e4497 > 0i)))];
let _e4504 = (_e4484 + 2i);
let _e4506 = select(_e4486, _e4504, (_e4504 < _e4486));
let _e4512 = global_4.member[bitcast<u32>(select(0i, _e4506, (_e4506 > 0i)))];
let _e4514 = (3i * (_e4476 + _e4449));
let _e4516 = select(_e4486, _e4514, (_e4514 < _e4486));
let _e4522 = global_4.member[bitcast<u32>(select(0i, _e4516, (_e4516 > 0i)))];
let _e4523 = (_e4514 + 1i);
let _e4525 = select(_e4486, _e4523, (_e4523 < _e4486));
let _e4531 = global_4.member[bitcast<u32>(select(0i, _e4525, (_e4525 > 0i)))];
let _e4532 = (_e4514 + 2i);
let _e4534 = select(_e4486, _e4532, (_e4532 < _e4486));
let _e4540 = global_4.member[bitcast<u32>(select(0i, _e4534, (_e4534 > 0i)))];
let _e4542 = (3i * (_e4482 + _e4434));
let _e4544 = select(_e4486, _e4542, (_e4542 < _e4486));
let _e4550 = global_4.member[bitcast<u32>(select(0i, _e4544, (_e4544 > 0i)))];
let _e4551 = (_e4542 + 1i);
let _e4553 = select(_e4486, _e4551, (_e4551 < _e4486));
let _e4559 = global_4.member[bitcast<u32>(select(0i, _e4553, (_e4553 > 0i)))];
let _e4560 = (_e4542 + 2i);
let _e4562 = select(_e4486, _e4560, (_e4560 < _e4486));
let _e4568 = global_4.member[bitcast<u32>(select(0i, _e4562, (_e4562 > 0i)))];
let _e4570 = (3i * (_e4482 + _e4449));
let _e4572 = select(_e4486, _e4570, (_e4570 < _e4486));
let _e4578 = global_4.member[bitcast<u32>(select(0i, _e4572, (_e4572 > 0i)))];
let _e4579 = (_e4570 + 1i);
let _e4581 = select(_e4486, _e4579, (_e4579 < _e4486));
let _e4587 = global_4.member[bitcast<u32>(select(0i, _e4581, (_e4581 > 0i)))];
let _e4588 = (_e4570 + 2i);
let _e4590 = select(_e4486, _e4588, (_e4588 < _e4486));
let _e4596 = global_4.member[bitcast<u32>(select(0i, _e4590, (_e4590 > 0i)))];
let _e4603 = (_e4494 + ((_e4522 - _e4494) * _e4414));
let _e4604 = (_e4503 + ((_e4531 - _e4503) * _e4414));
let _e4605 = (_e4512 + ((_e4540 - _e4512) * _e4414));
let _e4621 = (_e4603 + (((_e4550 + ((_e4578 - _e4550) * _e4414)) - _e4603) * _e4420));
let _e4622 = (_e4604 + (((_e4559 + ((_e4587 - _e4559) * _e4414)) - _e4604) * _e4420));
let _e4623 = (_e4605 + (((_e4568 + ((_e4596 - _e4568) * _e4414)) - _e4605) * _e4420));
phi_7437_ = 0i;
phi_7440_ = 0i;
phi_7442_ = _e4341;
phi_7444_ = _e4165;
loop {
let _e4626 = phi_7437_;
let _e4628 = phi_7440_;
let _e4630 = phi_7442_;
let _e4632 = phi_7444_;
local_95 = _e4632;
local_96 = _e4630;
local_97 = _e4632;
local_98 = _e4632;
local_99 = _e4632;
local_100 = _e4632;
local_101 = _e4632;
local_102 = _e4632;
local_103 = _e4630;
local_104 = _e4630;
local_105 = _e4630;
local_106 = _e4630;
local_107 = _e4632;
local_108 = _e4628;
local_109 = _e4632;
local_110 = _e4628;
let _e4633 = (_e4626 < (_e4236 + 1i));
if _e4633 {
if (_e4632 > 1i) {
phi_7459_ = (_e4632 >> bitcast<u32>(1i));
} else {
phi_7459_ = 1i;
}
let _e4640 = phi_7459_;
if (_e4630 > 1i) {
phi_7465_ = (_e4630 >> bitcast<u32>(1i));
} else {
phi_7465_ = 1i;
}
let _e4645 = phi_7465_;
phi_7438_ = (_e4626 + 1i);
phi_7441_ = (_e4628 + (_e4632 * _e4630));
phi_7443_ = _e4645;
phi_7445_ = _e4640;
} else {
phi_7438_ = i32();
phi_7441_ = i32();
phi_7443_ = i32();
phi_7445_ = i32();
}
let _e4648 = phi_7438_;
let _e4650 = phi_7441_;
let _e4652 = phi_7443_;
let _e4654 = phi_7445_;
continue;
continuing {
phi_7437_ = _e4648;
phi_7440_ = _e4650;
phi_7442_ = _e4652;
phi_7444_ = _e4654;
break if !(_e4633);
}
}
let _e4657 = local_95;
let _e4658 = f32(_e4657);
let _e4660 = ((_e4281 * _e4658) - 0.5f);
let _e4662 = local_96;
let _e4663 = f32(_e4662);
let _e4665 = ((_e4336 * _e4663) - 0.5f);
let _e4667 = select(-1f, _e4660, (_e4660 > -1f));
let _e4669 = select(_e4658, _e4667, (_e4667 < _e4658));
let _e4676 = select(0i, select(select(i32(_e4669), i32(-2147483648), (_e4669 < -2147483600f)), 2147483647i, (_e4669 > 2147483500f)), (_e4669 == _e4669));
let _e4680 = (_e4676 - select(0i, 1i, (_e4669 < f32(_e4676))));
let _e4682 = select(-1f, _e4665, (_e4665 > -1f));
let _e4684 = select(_e4663, _e4682, (_e4682 < _e4663));
let _e4691 = select(0i, select(select(i32(_e4684), i32(-2147483648), (_e4684 < -2147483600f)), 2147483647i, (_e4684 > 2147483500f)), (_e4684 == _e4684));
let _e4695 = (_e4691 - select(0i, 1i, (_e4684 < f32(_e4691))));
let _e4697 = (_e4660 - f32(_e4680));
let _e4699 = (_e4665 - f32(_e4695));
let _e4701 = select(0f, _e4699, (_e4699 > 0f));
let _e4703 = select(1f, _e4701, (_e4701 < 1f));
if (_e4680 < 0i) {
let _e4706 = local_97;
phi_7540_ = (_e4680 + _e4706);
} else {
phi_7540_ = _e4680;
}
let _e4709 = phi_7540_;
let _e4711 = local_98;
if (_e4709 >= _e4711) {
let _e4714 = local_99;
phi_7546_ = (_e4709 - _e4714);
} else {
phi_7546_ = _e4709;
}
let _e4717 = phi_7546_;
let _e4718 = (_e4680 + 1i);
if (_e4718 < 0i) {
let _e4721 = local_100;
phi_7553_ = (_e4718 + _e4721);
} else {
phi_7553_ = _e4718;
}
let _e4724 = phi_7553_;
let _e4726 = local_101;
if (_e4724 >= _e4726) {
let _e4729 = local_102;
phi_7559_ = (_e4724 - _e4729);
} else {
phi_7559_ = _e4724;
}
let _e4732 = phi_7559_;
let _e4734 = select(_e4695, 0i, (_e4695 < 0i));
let _e4736 = local_103;
if (_e4734 >= _e4736) {
let _e4739 = local_104;
phi_7570_ = (_e4739 - 1i);
} else {
phi_7570_ = _e4734;
}
let _e4742 = phi_7570_;
let _e4743 = (_e4695 + 1i);
let _e4745 = select(_e4743, 0i, (_e4743 < 0i));
let _e4747 = local_105;
if (_e4745 >= _e4747) {
let _e4750 = local_106;
phi_7582_ = (_e4750 - 1i);
} else {
phi_7582_ = _e4745;
}
let _e4753 = phi_7582_;
let _e4755 = local_107;
let _e4758 = local_108;
let _e4759 = (_e4758 + (_e4742 * _e4755));
let _e4761 = local_109;
let _e4764 = local_110;
let _e4765 = (_e4764 + (_e4753 * _e4761));
let _e4767 = (3i * (_e4759 + _e4717));
let _e4769 = select(_e4486, _e4767, (_e4767 < _e4486));
let _e4775 = global_4.member[bitcast<u32>(select(0i, _e4769, (_e4769 > 0i)))];
let _e4776 = (_e4767 + 1i);
let _e4778 = select(_e4486, _e4776, (_e4776 < _e4486));
let _e4784 = global_4.member[bitcast<u32>(select(0i, _e4778, (_e4778 > 0i)))];
let _e4785 = (_e4767 + 2i);
let _e4787 = select(_e4486, _e4785, (_e4785 < _e4486));
let _e4793 = global_4.member[bitcast<u32>(select(0i, _e4787, (_e4787 > 0i)))];
let _e4795 = (3i * (_e4759 + _e4732));
let _e4797 = select(_e4486, _e4795, (_e4795 < _e4486));
let _e4803 = global_4.member[bitcast<u32>(select(0i, _e4797, (_e4797 > 0i)))];
let _e4804 = (_e4795 + 1i);
let _e4806 = select(_e4486, _e4804, (_e4804 < _e4486));
let _e4812 = global_4.member[bitcast<u32>(select(0i, _e4806, (_e4806 > 0i)))];
let _e4813 = (_e4795 + 2i);
let _e4815 = select(_e4486, _e4813, (_e4813 < _e4486));
let _e4821 = global_4.member[bitcast<u32>(select(0i, _e4815, (_e4815 > 0i)))];
let _e4823 = (3i * (_e4765 + _e4717));
let _e4825 = select(_e4486, _e4823, (_e4823 < _e4486));
let _e4831 = global_4.member[bitcast<u32>(select(0i, _e4825, (_e4825 > 0i)))];
let _e4832 = (_e4823 + 1i);
let _e4834 = select(_e4486, _e4832, (_e4832 < _e4486));
let _e4840 = global_4.member[bitcast<u32>(select(0i, _e4834, (_e4834 > 0i)))];
let _e4841 = (_e4823 + 2i);
let _e4843 = select(_e4486, _e4841, (_e4841 < _e4486));
let _e4849 = global_4.member[bitcast<u32>(select(0i, _e4843, (_e4843 > 0i)))];
let _e4851 = (3i * (_e4765 + _e4732));
let _e4853 = select(_e4486, _e4851, (_e4851 < _e4486));
let _e4859 = global_4.member[bitcast<u32>(select(0i, _e4853, (_e4853 > 0i)))];
let _e4860 = (_e4851 + 1i);
let _e4862 = select(_e4486, _e4860, (_e4860 < _e4486));
let _e4868 = global_4.member[bitcast<u32>(select(0i, _e4862, (_e4862 > 0i)))];
let _e4869 = (_e4851 + 2i);
let _e4871 = select(_e4486, _e4869, (_e4869 < _e4486));
let _e4877 = global_4.member[bitcast<u32>(select(0i, _e4871, (_e4871 > 0i)))];
let _e4884 = (_e4775 + ((_e4803 - _e4775) * _e4697));
let _e4885 = (_e4784 + ((_e4812 - _e4784) * _e4697));
let _e4886 = (_e4793 + ((_e4821 - _e4793) * _e4697));
let _e4909 = (_e4218 - f32(_e4236));
let _e4911 = select(0f, _e4909, (_e4909 > 0f));
let _e4913 = select(1f, _e4911, (_e4911 < 1f));
let _e4923 = global_1.member.member_16.member_11;
phi_7837_ = vec3<f32>(((_e4621 + (((_e4884 + (((_e4831 + ((_e4859 - _e4831) * _e4697)) - _e4884) * _e4703)) - _e4621) * _e4913)) * _e4923), ((_e4622 + (((_e4885 + (((_e4840 + ((_e4868 - _e4840) * _e4697)) - _e4885) * _e4703)) - _e4622) * _e4913)) * _e4923), ((_e4623 + (((_e4886 + (((_e4849 + ((_e4877 - _e4849) * _e4697)) - _e4886) * _e4703)) - _e4623) * _e4913)) * _e4923));
}
let _e4929 = phi_7837_;
phi_7838_ = _e4929;
}
let _e4931 = phi_7838_;
phi_7839_ = _e4931;
}
let _e4933 = phi_7839_;
if (_e283 && (_e3784 > 0f)) {
let _e4936 = local_41;
let _e4938 = local_40;
let _e4939 = ((2i * _e4936) + _e4938);
let _e4941 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e4943 = select(_e4941, _e4939, (_e4939 < _e4941));
let _e4948 = global_7.member[bitcast<u32>(select(0i, _e4943, (_e4943 > 0i)))];
let _e4955 = select(0i, select(select(i32(_e4948), i32(-2147483648), (_e4948 < -2147483600f)), 2147483647i, (_e4948 > 2147483500f)), (_e4948 == _e4948));
if (_e4955 != -1i) {
let _e4957 = local_41;
let _e4959 = local_40;
let _e4960 = ((20i * _e4957) + _e4959);
let _e4962 = select(_e197, _e4960, (_e4960 < _e197));
let _e4967 = global_2.member[bitcast<u32>(select(0i, _e4962, (_e4962 > 0i)))];
let _e4968 = (1f - _e462);
let _e4974 = global_1.member.member_10;
let _e4987 = local_41;
let _e4989 = local_40;
let _e4990 = ((3i * _e4987) + _e4989);
let _e4992 = select(_e4941, _e4990, (_e4990 < _e4941));
let _e4997 = global_7.member[bitcast<u32>(select(0i, _e4992, (_e4992 > 0i)))];
let _e5001 = (((_e4974.member + (_e1054 * _e4968)) + (_e1074 * _e4967)) + (_e3827 * _e4997));
let _e5002 = (((_e4974.member_1 + (_e1055 * _e4968)) + (_e1075 * _e4967)) + (_e3828 * _e4997));
let _e5003 = (((_e4974.member_2 + (_e1056 * _e4968)) + (_e1076 * _e4967)) + (_e3829 * _e4997));
let _e5004 = vec3<f32>(_e5001, _e5002, _e5003);
if (_e4955 < 0i) {
let _e5006 = (_e4955 == -3i);
let _e5012 = global_1.member.member_17.member_1.member.member;
let _e5017 = global_1.member.member_17.member_1.member_1;
let _e5023 = global_1.member.member_17.member.member.member;
let _e5028 = global_1.member.member_17.member.member_1;
let _e5038 = vec3<f32>(select(_e5023.member, _e5012.member, _e5006), select(_e5023.member_1, _e5012.member_1, _e5006), select(_e5023.member_2, _e5012.member_2, _e5006));
phi_8814_ = type_22(_e5004, _e5038, _e5038, vec3<f32>(select(_e5028.member, _e5017.member, _e5006), select(_e5028.member_1, _e5017.member_1, _e5006), select(_e5028.member_2, _e5017.member_2, _e5006)), 0f, false);
} else {
let _e5050 = (_e4955 * 19i);
let _e5052 = (bitcast<i32>(_e155) - 1i);
let _e5054 = select(_e5052, _e5050, (_e5050 < _e5052));
let _e5060 = global_3.member[bitcast<u32>(select(0i, _e5054, (_e5054 > 0i)))];
let _e5061 = (_e5050 + 1i);
let _e5063 = select(_e5052, _e5061, (_e5061 < _e5052));
let _e5069 = global_3.member[bitcast<u32>(select(0i, _e5063, (_e5063 > 0i)))];
let _e5070 = (_e5050 + 2i);
let _e5072 = select(_e5052, _e5070, (_e5070 < _e5052));
let _e5078 = global_3.member[bitcast<u32>(select(0i, _e5072, (_e5072 > 0i)))];
let _e5079 = (_e5050 + 3i);
let _e5081 = select(_e5052, _e5079, (_e5079 < _e5052));
let _e5087 = global_3.member[bitcast<u32>(select(0i, _e5081, (_e5081 > 0i)))];
let _e5088 = (_e5050 + 4i);
let _e5090 = select(_e5052, _e5088, (_e5088 < _e5052));
let _e5096 = global_3.member[bitcast<u32>(select(0i, _e5090, (_e5090 > 0i)))];
let _e5097 = (_e5050 + 5i);
let _e5099 = select(_e5052, _e5097, (_e5097 < _e5052));
let _e5105 = global_3.member[bitcast<u32>(select(0i, _e5099, (_e5099 > 0i)))];
let _e5106 = (_e5050 + 6i);
let _e5108 = select(_e5052, _e5106, (_e5106 < _e5052));
let _e5114 = global_3.member[bitcast<u32>(select(0i, _e5108, (_e5108 > 0i)))];
let _e5115 = (_e5050 + 7i);
let _e5117 = select(_e5052, _e5115, (_e5115 < _e5052));
let _e5123 = global_3.member[bitcast<u32>(select(0i, _e5117, (_e5117 > 0i)))];
let _e5124 = (_e5050 + 8i);
let _e5126 = select(_e5052, _e5124, (_e5124 < _e5052));
let _e5132 = global_3.member[bitcast<u32>(select(0i, _e5126, (_e5126 > 0i)))];
let _e5133 = (_e5087 - _e5060);
let _e5134 = (_e5096 - _e5069);
let _e5135 = (_e5105 - _e5078);
let _e5136 = (_e5114 - _e5060);
let _e5137 = (_e5123 - _e5069);
let _e5138 = (_e5132 - _e5078);
let _e5141 = ((_e5134 * _e5138) - (_e5135 * _e5137));
let _e5144 = ((_e5135 * _e5136) - (_e5133 * _e5138));
let _e5147 = ((_e5133 * _e5137) - (_e5134 * _e5136));
let _e5148 = (_e5087 - _e5001);
let _e5149 = (_e5096 - _e5002);
let _e5150 = (_e5105 - _e5003);
let _e5151 = (_e5114 - _e5001);
let _e5152 = (_e5123 - _e5002);
let _e5153 = (_e5132 - _e5003);
let _e5167 = (((((_e5149 * _e5153) - (_e5150 * _e5152)) * _e5141) + (((_e5150 * _e5151) - (_e5148 * _e5153)) * _e5144)) + (((_e5148 * _e5152) - (_e5149 * _e5151)) * _e5147));
let _e5169 = select(0f, _e5167, (_e5167 > 0f));
let _e5170 = (_e5060 - _e5001);
let _e5171 = (_e5069 - _e5002);
let _e5172 = (_e5078 - _e5003);
let _e5186 = (((((_e5152 * _e5172) - (_e5153 * _e5171)) * _e5141) + (((_e5153 * _e5170) - (_e5151 * _e5172)) * _e5144)) + (((_e5151 * _e5171) - (_e5152 * _e5170)) * _e5147));
let _e5188 = select(0f, _e5186, (_e5186 > 0f));
let _e5202 = (((((_e5171 * _e5150) - (_e5172 * _e5149)) * _e5141) + (((_e5172 * _e5148) - (_e5170 * _e5150)) * _e5144)) + (((_e5170 * _e5149) - (_e5171 * _e5148)) * _e5147));
let _e5204 = select(0f, _e5202, (_e5202 > 0f));
let _e5206 = ((_e5169 + _e5188) + _e5204);
let _e5208 = select(1e-30f, _e5206, (_e5206 > 1e-30f));
let _e5209 = (_e5169 / _e5208);
let _e5210 = (_e5188 / _e5208);
let _e5211 = (_e5204 / _e5208);
let _e5216 = (((_e5141 * _e5141) + (_e5144 * _e5144)) + (_e5147 * _e5147));
let _e5219 = sqrt(select(0f, _e5216, (_e5216 > 0f)));
let _e5222 = (1f / select(1e-20f, _e5219, (_e5219 > 1e-20f)));
let _e5227 = (_e5050 + 9i);
let _e5229 = select(_e5052, _e5227, (_e5227 < _e5052));
let _e5235 = global_3.member[bitcast<u32>(select(0i, _e5229, (_e5229 > 0i)))];
let _e5236 = (_e5050 + 10i);
let _e5238 = select(_e5052, _e5236, (_e5236 < _e5052));
let _e5244 = global_3.member[bitcast<u32>(select(0i, _e5238, (_e5238 > 0i)))];
let _e5245 = (_e5050 + 11i);
let _e5247 = select(_e5052, _e5245, (_e5245 < _e5052));
let _e5253 = global_3.member[bitcast<u32>(select(0i, _e5247, (_e5247 > 0i)))];
let _e5257 = (_e5050 + 12i);
let _e5259 = select(_e5052, _e5257, (_e5257 < _e5052));
let _e5265 = global_3.member[bitcast<u32>(select(0i, _e5259, (_e5259 > 0i)))];
let _e5266 = (_e5050 + 13i);
let _e5268 = select(_e5052, _e5266, (_e5266 < _e5052));
let _e5274 = global_3.member[bitcast<u32>(select(0i, _e5268, (_e5268 > 0i)))];
let _e5275 = (_e5050 + 14i);
let _e5277 = select(_e5052, _e5275, (_e5275 < _e5052));
let _e5283 = global_3.member[bitcast<u32>(select(0i, _e5277, (_e5277 > 0i)))];
let _e5290 = (_e5050 + 15i);
let _e5292 = select(_e5052, _e5290, (_e5290 < _e5052));
let _e5298 = global_3.member[bitcast<u32>(select(0i, _e5292, (_e5292 > 0i)))];
let _e5299 = (_e5050 + 16i);
let _e5301 = select(_e5052, _e5299, (_e5299 < _e5052));
let _e5307 = global_3.member[bitcast<u32>(select(0i, _e5301, (_e5301 > 0i)))];
let _e5308 = (_e5050 + 17i);
let _e5310 = select(_e5052, _e5308, (_e5308 < _e5052));
let _e5316 = global_3.member[bitcast<u32>(select(0i, _e5310, (_e5310 > 0i)))];
let _e5320 = (((_e5235 * _e5209) + (_e5265 * _e5210)) + (_e5298 * _e5211));
let _e5321 = (((_e5244 * _e5209) + (_e5274 * _e5210)) + (_e5307 * _e5211));
let _e5322 = (((_e5253 * _e5209) + (_e5283 * _e5210)) + (_e5316 * _e5211));
let _e5327 = (((_e5320 * _e5320) + (_e5321 * _e5321)) + (_e5322 * _e5322));
let _e5330 = sqrt(select(0f, _e5327, (_e5327 > 0f)));
let _e5333 = (1f / select(1e-20f, _e5330, (_e5330 > 1e-20f)));
let _e5340 = global_1.member.member_1;
let _e5343 = (_e5050 + 18i);
let _e5345 = select(_e5052, _e5343, (_e5343 < _e5052));
let _e5351 = global_3.member[bitcast<u32>(select(0i, _e5345, (_e5345 > 0i)))];
let _e5360 = (select(select(0i, select(select(i32(_e5351), i32(-2147483648), (_e5351 < -2147483600f)), 2147483647i, (_e5351 > 2147483500f)), (_e5351 == _e5351)), _e4955, ((_e5340 & 4u) != 0u)) * 10i);
let _e5362 = (bitcast<i32>(_e157) - 1i);
let _e5364 = select(_e5362, _e5360, (_e5360 < _e5362));
let _e5370 = global_5.member[bitcast<u32>(select(0i, _e5364, (_e5364 > 0i)))];
let _e5371 = (_e5360 + 1i);
let _e5373 = select(_e5362, _e5371, (_e5371 < _e5362));
let _e5379 = global_5.member[bitcast<u32>(select(0i, _e5373, (_e5373 > 0i)))];
let _e5380 = (_e5360 + 2i);
let _e5382 = select(_e5362, _e5380, (_e5380 < _e5362));
let _e5388 = global_5.member[bitcast<u32>(select(0i, _e5382, (_e5382 > 0i)))];
let _e5392 = (_e5360 + 3i);
let _e5394 = select(_e5362, _e5392, (_e5392 < _e5362));
let _e5400 = global_5.member[bitcast<u32>(select(0i, _e5394, (_e5394 > 0i)))];
let _e5401 = (_e5360 + 4i);
let _e5403 = select(_e5362, _e5401, (_e5401 < _e5362));
let _e5409 = global_5.member[bitcast<u32>(select(0i, _e5403, (_e5403 > 0i)))];
let _e5410 = (_e5360 + 5i);
let _e5412 = select(_e5362, _e5410, (_e5410 < _e5362));
let _e5418 = global_5.member[bitcast<u32>(select(0i, _e5412, (_e5412 > 0i)))];
let _e5425 = (_e5360 + 6i);
let _e5427 = select(_e5362, _e5425, (_e5425 < _e5362));
let _e5433 = global_5.member[bitcast<u32>(select(0i, _e5427, (_e5427 > 0i)))];
let _e5434 = (_e5360 + 7i);
let _e5436 = select(_e5362, _e5434, (_e5434 < _e5362));
let _e5442 = global_5.member[bitcast<u32>(select(0i, _e5436, (_e5436 > 0i)))];
let _e5443 = (_e5360 + 8i);
let _e5445 = select(_e5362, _e5443, (_e5443 < _e5362));
let _e5451 = global_5.member[bitcast<u32>(select(0i, _e5445, (_e5445 > 0i)))];
let _e5459 = (_e5360 + 9i);
let _e5461 = select(_e5362, _e5459, (_e5459 < _e5362));
let _e5467 = global_5.member[bitcast<u32>(select(0i, _e5461, (_e5461 > 0i)))];
phi_8814_ = type_22(_e5004, vec3<f32>((_e5141 * _e5222), (_e5144 * _e5222), (_e5147 * _e5222)), vec3<f32>((_e5320 * _e5333), (_e5321 * _e5333), (_e5322 * _e5333)), vec3<f32>((((_e5370 * _e5209) + (_e5400 * _e5210)) + (_e5433 * _e5211)), (((_e5379 * _e5209) + (_e5409 * _e5210)) + (_e5442 * _e5211)), (((_e5388 * _e5209) + (_e5418 * _e5210)) + (_e5451 * _e5211))), _e5467, true);
}
let _e5470 = phi_8814_;
let _e5479 = (((_e5470.member_1.x * _e3827) + (_e5470.member_1.y * _e3828)) + (_e5470.member_1.z * _e3829));
let _e5481 = select(1f, -1f, (_e5479 > 0f));
let _e5493 = select(_e5481, -(_e5481), ((((_e5470.member_2.x * _e5470.member_1.x) + (_e5470.member_2.y * _e5470.member_1.y)) + (_e5470.member_2.z * _e5470.member_1.z)) < 0f));
let _e5494 = (_e5470.member_2.x * _e5493);
let _e5495 = (_e5470.member_2.y * _e5493);
let _e5496 = (_e5470.member_2.z * _e5493);
let _e5505 = ((((_e5494 * _e3827) + (_e5495 * _e3828)) + (_e5496 * _e3829)) > 0f);
let _e5513 = global_1.member.member_18.member_2;
let _e5521 = global_1.member.member_18.member;
if (_e5521 == 0u) {
let _e5526 = global_1.member.member_18.member_1;
phi_9404_ = type_23(vec3<f32>(_e5526.member, _e5526.member_1, _e5526.member_2), vec3<f32>(_e5513.member, _e5513.member_1, _e5513.member_2));
} else {
let _e5535 = global_1.member.member_18.member_3;
let _e5540 = (_e5470.member.x - _e5535.member);
let _e5542 = (_e5470.member.y - _e5535.member_1);
let _e5544 = (_e5470.member.z - _e5535.member_2);
let _e5549 = (((_e5540 * _e5540) + (_e5542 * _e5542)) + (_e5544 * _e5544));
let _e5551 = select(1e-12f, _e5549, (_e5549 > 1e-12f));
let _e5552 = (1f / _e5551);
let _e5556 = vec3<f32>((_e5513.member * _e5552), (_e5513.member_1 * _e5552), (_e5513.member_2 * _e5552));
if (_e5521 == 2u) {
let _e5561 = global_1.member.member_18.member_1;
let _e5569 = (((_e5561.member * _e5540) + (_e5561.member_1 * _e5542)) + (_e5561.member_2 * _e5544));
let _e5572 = (1f / select(1e-20f, _e5569, (_e5569 > 1e-20f)));
let _e5577 = global_1.member.member_18.member_4.member;
let _e5586 = ((((_e5577.member * _e5540) + (_e5577.member_1 * _e5542)) + (_e5577.member_2 * _e5544)) * _e5572);
let _e5591 = global_1.member.member_18.member_4.member_1;
let _e5600 = ((((_e5591.member * _e5540) + (_e5591.member_1 * _e5542)) + (_e5591.member_2 * _e5544)) * _e5572);
let _e5605 = global_1.member.member_18.member_4.member_2;
let _e5608 = ((_e5586 * _e5586) + (_e5600 * _e5600));
let _e5617 = global_1.member.member_18.member_4.member_3;
let _e5618 = ((_e5605 - sqrt(select(0f, _e5608, (_e5608 > 0f)))) * _e5617);
let _e5620 = select(0f, _e5618, (_e5618 > 0f));
let _e5622 = select(1f, _e5620, (_e5620 < 1f));
let _e5628 = select(0f, ((_e5622 * _e5622) * (3f - (2f * _e5622))), (_e5569 > 0f));
let _e5633 = global_1.member.member_18.member_4.member_5;
if ((_e5633 > 0u) && (_e5628 > 0f)) {
let _e5637 = (0.5f / _e5605);
let _e5647 = global_1.member.member_18.member_4.member_6;
let _e5648 = bitcast<i32>(_e5647);
local = bitcast<i32>(_e5633);
let _e5649 = local;
let _e5651 = f32((_e5649 - 1i));
let _e5653 = f32((_e5648 - 1i));
let _e5654 = local;
let _e5657 = (((0.5f + (_e5586 * _e5637)) * f32(_e5654)) - 0.5f);
let _e5659 = select(0f, _e5657, (_e5657 > 0f));
let _e5661 = select(_e5651, _e5659, (_e5659 < _e5651));
let _e5664 = (((0.5f - (_e5600 * _e5637)) * f32(_e5648)) - 0.5f);
let _e5666 = select(0f, _e5664, (_e5664 > 0f));
let _e5668 = select(_e5653, _e5666, (_e5666 < _e5653));
let _e5670 = select(0f, _e5661, (_e5661 > 0f));
let _e5672 = select(_e5651, _e5670, (_e5670 < _e5651));
let _e5679 = select(0i, select(select(i32(_e5672), i32(-2147483648), (_e5672 < -2147483600f)), 2147483647i, (_e5672 > 2147483500f)), (_e5672 == _e5672));
let _e5683 = (_e5679 - select(0i, 1i, (_e5672 < f32(_e5679))));
let _e5685 = select(0f, _e5668, (_e5668 > 0f));
let _e5687 = select(_e5653, _e5685, (_e5685 < _e5653));
let _e5694 = select(0i, select(select(i32(_e5687), i32(-2147483648), (_e5687 < -2147483600f)), 2147483647i, (_e5687 > 2147483500f)), (_e5687 == _e5687));
let _e5698 = (_e5694 - select(0i, 1i, (_e5687 < f32(_e5694))));
let _e5700 = (_e5661 - f32(_e5683));
let _e5702 = (_e5668 - f32(_e5698));
let _e5703 = (_e5683 + 1i);
let _e5704 = local;
let _e5706 = select(_e5683, _e5703, (_e5703 < _e5704));
let _e5707 = (_e5698 + 1i);
let _e5709 = select(_e5698, _e5707, (_e5707 < _e5648));
let _e5714 = global_1.member.member_18.member_4.member_4;
let _e5715 = bitcast<i32>(_e5714);
let _e5716 = local;
let _e5720 = (_e5715 + (3i * ((_e5698 * _e5716) + _e5683)));
let _e5722 = (bitcast<i32>(_e153) - 1i);
let _e5724 = select(_e5722, _e5720, (_e5720 < _e5722));
let _e5729 = global_4.member[bitcast<u32>(select(0i, _e5724, (_e5724 > 0i)))];
let _e5730 = (_e5720 + 1i);
let _e5732 = select(_e5722, _e5730, (_e5730 < _e5722));
let _e5737 = global_4.member[bitcast<u32>(select(0i, _e5732, (_e5732 > 0i)))];
let _e5738 = (_e5720 + 2i);
let _e5740 = select(_e5722, _e5738, (_e5738 < _e5722));
let _e5745 = global_4.member[bitcast<u32>(select(0i, _e5740, (_e5740 > 0i)))];
let _e5746 = local;
let _e5750 = (_e5715 + (3i * ((_e5698 * _e5746) + _e5706)));
let _e5752 = select(_e5722, _e5750, (_e5750 < _e5722));
let _e5757 = global_4.member[bitcast<u32>(select(0i, _e5752, (_e5752 > 0i)))];
let _e5758 = (_e5750 + 1i);
let _e5760 = select(_e5722, _e5758, (_e5758 < _e5722));
let _e5765 = global_4.member[bitcast<u32>(select(0i, _e5760, (_e5760 > 0i)))];
let _e5766 = (_e5750 + 2i);
let _e5768 = select(_e5722, _e5766, (_e5766 < _e5722));
let _e5773 = global_4.member[bitcast<u32>(select(0i, _e5768, (_e5768 > 0i)))];
let _e5774 = local;
let _e5778 = (_e5715 + (3i * ((_e5709 * _e5774) + _e5683)));
let _e5780 = select(_e5722, _e5778, (_e5778 < _e5722));
let _e5785 = global_4.member[bitcast<u32>(select(0i, _e5780, (_e5780 > 0i)))];
let _e5786 = (_e5778 + 1i);
let _e5788 = select(_e5722, _e5786, (_e5786 < _e5722));
let _e5793 = global_4.member[bitcast<u32>(select(0i, _e5788, (_e5788 > 0i)))];
let _e5794 = (_e5778 + 2i);
let _e5796 = select(_e5722, _e5794, (_e5794 < _e5722));
let _e5801 = global_4.member[bitcast<u32>(select(0i, _e5796, (_e5796 > 0i)))];
let _e5802 = local;
let _e5806 = (_e5715 + (3i * ((_e5709 * _e5802) + _e5706)));
let _e5808 = select(_e5722, _e5806, (_e5806 < _e5722));
let _e5813 = global_4.member[bitcast<u32>(select(0i, _e5808, (_e5808 > 0i)))];
let _e5814 = (_e5806 + 1i);
let _e5816 = select(_e5722, _e5814, (_e5814 < _e5722));
let _e5821 = global_4.member[bitcast<u32>(select(0i, _e5816, (_e5816 > 0i)))];
let _e5822 = (_e5806 + 2i);
let _e5824 = select(_e5722, _e5822, (_e5822 < _e5722));
let _e5829 = global_4.member[bitcast<u32>(select(0i, _e5824, (_e5824 > 0i)))];
let _e5836 = (_e5729 + ((_e5757 - _e5729) * _e5700));
let _e5837 = (_e5737 + ((_e5765 - _e5737) * _e5700));
let _e5838 = (_e5745 + ((_e5773 - _e5745) * _e5700));
phi_9388_ = vec3<f32>(((_e5836 + (((_e5785 + ((_e5813 - _e5785) * _e5700)) - _e5836) * _e5702)) * _e5628), ((_e5837 + (((_e5793 + ((_e5821 - _e5793) * _e5700)) - _e5837) * _e5702)) * _e5628), ((_e5838 + (((_e5801 + ((_e5829 - _e5801) * _e5700)) - _e5838) * _e5702)) * _e5628));
} else {
phi_9388_ = vec3(_e5628);
}
let _e5863 = phi_9388_;
phi_9391_ = (_e5556 * _e5863);
} else {
phi_9391_ = _e5556;
}
let _e5866 = phi_9391_;
let _e5870 = (1f / sqrt(select(0f, _e5551, (_e5551 > 0f))));
phi_9404_ = type_23(vec3<f32>((_e5540 * _e5870), (_e5542 * _e5870), (_e5544 * _e5870)), _e5866);
}
let _e5877 = phi_9404_;
let _e5888 = -((((select(_e5494, (_e5470.member_1.x * _e5481), _e5505) * _e5877.member.x) + (select(_e5495, (_e5470.member_1.y * _e5481), _e5505) * _e5877.member.y)) + (select(_e5496, (_e5470.member_1.z * _e5481), _e5505) * _e5877.member.z)));
let _e5894 = -((((_e5470.member_1.x * _e5877.member.x) + (_e5470.member_1.y * _e5877.member.y)) + (_e5470.member_1.z * _e5877.member.z)));
let _e5900 = -(_e5888);
let _e5905 = select((select(0f, _e5900, (_e5900 > 0f)) * _e5470.member_4), select(0f, _e5888, (_e5888 > 0f)), ((_e5894 * -(_e5479)) > 0f));
let _e5906 = -(_e5894);
let _e5908 = select(_e5906, _e5894, (_e5894 > _e5906));
let _e5914 = global_1.member.member_20.member_6;
let _e5928 = ((((_e5914.member.member * _e5470.member.x) + (_e5914.member.member_1 * _e5470.member.y)) + (_e5914.member.member_2 * _e5470.member.z)) + _e5914.member_1);
let _e5930 = select(1f, _e5928, (_e5928 > 1e-6f));
let _e5934 = global_1.member.member_20.member_4;
let _e5950 = global_1.member.member_20.member_5;
let _e5966 = global_1.member.member_20.member_2;
let _e5975 = -((((_e5470.member_1.x * _e5966.member) + (_e5470.member_1.y * _e5966.member_1)) + (_e5470.member_1.z * _e5966.member_2)));
let _e5976 = -(_e5975);
let _e5978 = select(_e5976, _e5975, (_e5975 > _e5976));
let _e5980 = select(1f, _e5978, (_e5978 < 1f));
let _e5982 = (1f - (_e5980 * _e5980));
let _e5989 = global_1.member.member_20.member_8;
let _e5997 = global_1.member.member_20.member_7.member;
let _e6002 = global_1.member.member_20.member_7.member_2;
let _e6004 = (_e5997 + (_e6002 * (((((_e5934.member.member * _e5470.member.x) + (_e5934.member.member_1 * _e5470.member.y)) + (_e5934.member.member_2 * _e5470.member.z)) + _e5934.member_1) / _e5930)));
let _e6009 = global_1.member.member_20.member_7.member_1;
let _e6011 = (_e6009 + (_e6002 * (((((_e5950.member.member * _e5470.member.x) + (_e5950.member.member_1 * _e5470.member.y)) + (_e5950.member.member_2 * _e5470.member.z)) + _e5950.member_1) / _e5930)));
let _e6015 = ((1f + (_e6004 * _e6004)) + (_e6011 * _e6011));
let _e6024 = global_1.member.member_20.member_9;
let _e6028 = (select(1f, -1f, (_e5894 < 0f)) * (((((1.4142135f * _e5989) * sqrt(select(0f, _e5982, (_e5982 > 0f)))) * _e5928) + (select(1f, _e5908, (_e5908 < 1f)) * sqrt(select(0f, _e6015, (_e6015 > 0f))))) * _e6024));
let _e6033 = select(0f, 1f, _e5470.member_5);
let _e6037 = (_e5470.member.x + ((_e5470.member_1.x * _e6028) * _e6033));
let _e6038 = (_e5470.member.y + ((_e5470.member_1.y * _e6028) * _e6033));
let _e6039 = (_e5470.member.z + ((_e5470.member_1.z * _e6028) * _e6033));
let _e6044 = global_1.member.member_20.member.member;
let _e6045 = bitcast<i32>(_e6044);
let _e6050 = global_1.member.member_20.member.member_1;
let _e6051 = bitcast<i32>(_e6050);
let _e6056 = global_1.member.member_20.member.member_2;
let _e6057 = bitcast<i32>(_e6056);
let _e6061 = global_1.member.member_20.member_1;
let _e6062 = bitcast<i32>(_e6061);
let _e6068 = ((((_e5914.member.member * _e6037) + (_e5914.member.member_1 * _e6038)) + (_e5914.member.member_2 * _e6039)) + _e5914.member_1);
let _e6070 = select(1f, _e6068, (_e6068 > 1e-6f));
let _e6074 = global_1.member.member_20.member_3;
let _e6085 = ((((_e6074.member.member * _e6037) + (_e6074.member.member_1 * _e6038)) + (_e6074.member.member_2 * _e6039)) + _e6074.member_1);
let _e6100 = ((((((_e5934.member.member * _e6037) + (_e5934.member.member_1 * _e6038)) + (_e5934.member.member_2 * _e6039)) + _e5934.member_1) / _e6070) - 0.5f);
let _e6101 = ((((((_e5950.member.member * _e6037) + (_e5950.member.member_1 * _e6038)) + (_e5950.member.member_2 * _e6039)) + _e5950.member_1) / _e6070) - 0.5f);
let _e6103 = f32((_e6045 - 1i));
let _e6105 = select(0f, _e6085, (_e6085 > 0f));
let _e6107 = select(_e6103, _e6105, (_e6105 < _e6103));
let _e6114 = select(0i, select(select(i32(_e6107), i32(-2147483648), (_e6107 < -2147483600f)), 2147483647i, (_e6107 > 2147483500f)), (_e6107 == _e6107));
let _e6118 = (_e6114 - select(0i, 1i, (_e6107 < f32(_e6114))));
let _e6122 = (_e6085 - f32(_e6118));
let _e6125 = select(1f, select(0f, _e6122, (_e6122 > 0f)), (_e6085 < f32(_e6045)));
let _e6126 = (_e6100 - _e5989);
let _e6127 = -(16f);
let _e6128 = f32(_e6051);
let _e6130 = select(_e6127, _e6126, (_e6126 > _e6127));
let _e6132 = select(_e6128, _e6130, (_e6130 < _e6128));
let _e6139 = select(0i, select(select(i32(_e6132), i32(-2147483648), (_e6132 < -2147483600f)), 2147483647i, (_e6132 > 2147483500f)), (_e6132 == _e6132));
let _e6145 = (_e6100 + _e5989);
let _e6148 = (f32((_e6051 - 1i)) + 16f);
let _e6150 = select(-1f, _e6145, (_e6145 > -1f));
let _e6152 = select(_e6148, _e6150, (_e6150 < _e6148));
let _e6159 = select(0i, select(select(i32(_e6152), i32(-2147483648), (_e6152 < -2147483600f)), 2147483647i, (_e6152 > 2147483500f)), (_e6152 == _e6152));
let _e6164 = (_e6101 - _e5989);
let _e6165 = f32(_e6057);
let _e6167 = select(_e6127, _e6164, (_e6164 > _e6127));
let _e6169 = select(_e6165, _e6167, (_e6167 < _e6165));
let _e6176 = select(0i, select(select(i32(_e6169), i32(-2147483648), (_e6169 < -2147483600f)), 2147483647i, (_e6169 > 2147483500f)), (_e6169 == _e6169));
let _e6182 = (_e6101 + _e5989);
let _e6185 = (f32((_e6057 - 1i)) + 16f);
let _e6187 = select(-1f, _e6182, (_e6182 > -1f));
let _e6189 = select(_e6185, _e6187, (_e6187 < _e6185));
let _e6196 = select(0i, select(select(i32(_e6189), i32(-2147483648), (_e6189 < -2147483600f)), 2147483647i, (_e6189 > 2147483500f)), (_e6189 == _e6189));
let _e6204 = bitcast<i32>(((_e6044 + 2u) >> bitcast<u32>(1i)));
let _e6206 = ((_e6051 * _e6057) * _e6204);
phi_9860_ = 0f;
phi_9863_ = vec3<f32>(0f, 0f, 0f);
phi_9865_ = ((_e6176 - select(0i, 1i, (_e6169 < f32(_e6176)))) + 1i);
loop {
let _e6208 = phi_9860_;
let _e6210 = phi_9863_;
let _e6212 = phi_9865_;
local_111 = _e6208;
local_112 = _e6208;
local_113 = _e6210;
local_114 = _e6210;
local_115 = _e6210;
let _e6213 = (_e6212 <= (_e6196 - select(0i, 1i, (_e6189 < f32(_e6196)))));
if _e6213 {
let _e6219 = (_e5989 - bitcast<f32>((bitcast<u32>((f32(_e6212) - _e6101)) & 2147483647u)));
phi_9880_ = ((_e6139 - select(0i, 1i, (_e6132 < f32(_e6139)))) + 1i);
phi_9883_ = _e6208;
phi_9885_ = _e6210;
loop {
let _e6221 = phi_9880_;
let _e6223 = phi_9883_;
let _e6225 = phi_9885_;
local_118 = _e6223;
local_119 = _e6225;
let _e6226 = (_e6221 <= (_e6159 - select(0i, 1i, (_e6152 < f32(_e6159)))));
if _e6226 {
let _e6232 = (_e5989 - bitcast<f32>((bitcast<u32>((f32(_e6221) - _e6100)) & 2147483647u)));
let _e6237 = (select(0f, _e6232, (_e6232 > 0f)) * select(0f, _e6219, (_e6219 > 0f)));
if ((((_e6221 >= 0i) && (_e6221 < _e6051)) && (_e6212 >= 0i)) && (_e6212 < _e6057)) {
let _e6247 = (((_e6212 * _e6051) + _e6221) * _e6204);
let _e6249 = (2i * _e6118);
let _e6250 = ((4i * _e6247) + _e6249);
let _e6252 = (_e6250 >> bitcast<u32>(2i));
let _e6255 = bitcast<u32>(((_e6250 & 3i) * 8i));
let _e6257 = (bitcast<i32>(_e159) - 1i);
let _e6259 = select(_e6257, _e6252, (_e6252 < _e6257));
let _e6265 = global_6.member[bitcast<u32>(select(0i, _e6259, (_e6259 > 0i)))];
let _e6269 = (_e6252 + 1i);
let _e6271 = select(_e6257, _e6269, (_e6269 < _e6257));
let _e6277 = global_6.member[bitcast<u32>(select(0i, _e6271, (_e6271 > 0i)))];
let _e6284 = ((_e6265 >> bitcast<u32>((_e6255 & 31u))) | ((_e6277 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6255) & 31u))));
let _e6287 = f32(bitcast<i32>((_e6284 & 65535u)));
let _e6295 = (1f / 65535f);
let _e6297 = (_e6237 * ((_e6287 + ((f32(bitcast<i32>((_e6284 >> bitcast<u32>(16i)))) - _e6287) * _e6125)) * _e6295));
let _e6299 = (_e6225.x + _e6297);
if (_e6062 > 1i) {
let _e6303 = ((4i * (_e6247 + _e6206)) + _e6249);
let _e6305 = (_e6303 >> bitcast<u32>(2i));
let _e6308 = bitcast<u32>(((_e6303 & 3i) * 8i));
let _e6310 = select(_e6257, _e6305, (_e6305 < _e6257));
let _e6316 = global_6.member[bitcast<u32>(select(0i, _e6310, (_e6310 > 0i)))];
let _e6320 = (_e6305 + 1i);
let _e6322 = select(_e6257, _e6320, (_e6320 < _e6257));
let _e6328 = global_6.member[bitcast<u32>(select(0i, _e6322, (_e6322 > 0i)))];
let _e6335 = ((_e6316 >> bitcast<u32>((_e6308 & 31u))) | ((_e6328 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6308) & 31u))));
let _e6338 = f32(bitcast<i32>((_e6335 & 65535u)));
let _e6353 = ((4i * (_e6247 + (2i * _e6206))) + _e6249);
let _e6355 = (_e6353 >> bitcast<u32>(2i));
let _e6358 = bitcast<u32>(((_e6353 & 3i) * 8i));
let _e6360 = select(_e6257, _e6355, (_e6355 < _e6257));
let _e6366 = global_6.member[bitcast<u32>(select(0i, _e6360, (_e6360 > 0i)))];
let _e6370 = (_e6355 + 1i);
let _e6372 = select(_e6257, _e6370, (_e6370 < _e6257));
let _e6378 = global_6.member[bitcast<u32>(select(0i, _e6372, (_e6372 > 0i)))];
let _e6385 = ((_e6366 >> bitcast<u32>((_e6358 & 31u))) | ((_e6378 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6358) & 31u))));
let _e6388 = f32(bitcast<i32>((_e6385 & 65535u)));
phi_10118_ = vec3<f32>(_e6299, (_e6225.y + (_e6237 * ((_e6338 + ((f32(bitcast<i32>((_e6335 >> bitcast<u32>(16i)))) - _e6338) * _e6125)) * _e6295))), (_e6225.z + (_e6237 * ((_e6388 + ((f32(bitcast<i32>((_e6385 >> bitcast<u32>(16i)))) - _e6388) * _e6125)) * _e6295))));
} else {
phi_10118_ = vec3<f32>(_e6299, (_e6225.y + _e6297), (_e6225.z + _e6297));
}
let _e6407 = phi_10118_;
phi_10128_ = _e6407;
} else {
phi_10128_ = vec3<f32>((_e6225.x + _e6237), (_e6225.y + _e6237), (_e6225.z + _e6237));
}
let _e6416 = phi_10128_;
phi_9881_ = (_e6221 + 1i);
phi_9884_ = (_e6223 + _e6237);
phi_9886_ = _e6416;
} else {
phi_9881_ = i32();
phi_9884_ = f32();
phi_9886_ = vec3<f32>();
}
let _e6420 = phi_9881_;
let _e6422 = phi_9884_;
let _e6424 = phi_9886_;
continue;
continuing {
phi_9880_ = _e6420;
phi_9883_ = _e6422;
phi_9885_ = _e6424;
break if !(_e6226);
}
}
let _e6828 = local_118;
phi_9861_ = _e6828;
let _e6831 = local_119;
phi_9864_ = _e6831;
phi_9866_ = (_e6212 + 1i);
} else {
phi_9861_ = f32();
phi_9864_ = vec3<f32>();
phi_9866_ = i32();
}
let _e6428 = phi_9861_;
let _e6430 = phi_9864_;
let _e6432 = phi_9866_;
continue;
continuing {
phi_9860_ = _e6428;
phi_9863_ = _e6430;
phi_9865_ = _e6432;
break if !(_e6213);
}
}
let _e6436 = local_111;
let _e6440 = (((_e6062 == 0i) || (_e6436 <= 0f)) || (_e6068 <= 1e-6f));
let _e6442 = local_112;
let _e6444 = (1f / select(_e6442, 1f, _e6440));
let _e6446 = local_113;
let _e6451 = local_114;
let _e6456 = local_115;
let _e6472 = global_1.member.member_19;
phi_10180_ = (_e5470.member_3 * vec3<f32>(((_e5877.member_1.x * (select((_e6446.x * _e6444), 1f, _e6440) * _e5905)) + _e6472.member), ((_e5877.member_1.y * (select((_e6451.y * _e6444), 1f, _e6440) * _e5905)) + _e6472.member_1), ((_e5877.member_1.z * (select((_e6456.z * _e6444), 1f, _e6440) * _e5905)) + _e6472.member_2)));
} else {
phi_10180_ = _e4933;
}
let _e6482 = phi_10180_;
phi_10181_ = _e6482;
} else {
phi_10181_ = _e4933;
}
let _e6484 = phi_10181_;
let _e6491 = (_e1166 || _e285);
let _e6495 = global_1.member.member_16.member_12;
let _e6496 = select(_e6495, 1f, _e6491);
let _e6505 = global_1.member.member_11;
let _e6506 = local_41;
let _e6508 = local_40;
let _e6509 = ((20i * _e6506) + _e6508);
let _e6511 = select(_e197, _e6509, (_e6509 < _e197));
let _e6516 = global_2.member[bitcast<u32>(select(0i, _e6511, (_e6511 > 0i)))];
let _e6543 = local_41;
let _e6545 = local_40;
let _e6546 = ((19i * _e6543) + _e6545);
let _e6548 = select(_e197, _e6546, (_e6546 < _e197));
let _e6553 = global_2.member[bitcast<u32>(select(0i, _e6548, (_e6548 > 0i)))];
global_8.member[_e174] = (((_e3767.x * _e238) + (_e6484.x * _e3784)) * _e6496);
global_8.member[(_e172 + _e174)] = (((_e3767.y * _e249) + (_e6484.y * _e3784)) * _e6496);
global_8.member[((2u * _e172) + _e174)] = (((_e3767.z * _e260) + (_e6484.z * _e3784)) * _e6496);
global_8.member[((3u * _e172) + _e174)] = _e6496;
global_8.member[((4u * _e172) + _e174)] = (((_e438.member * _e3765.x) + (_e438.member_1 * _e3765.y)) + (_e438.member_2 * _e3765.z));
global_8.member[((5u * _e172) + _e174)] = (((_e447.member * _e3765.x) + (_e447.member_1 * _e3765.y)) + (_e447.member_2 * _e3765.z));
global_8.member[((6u * _e172) + _e174)] = -((((_e465.member * _e3765.x) + (_e465.member_1 * _e3765.y)) + (_e465.member_2 * _e3765.z)));
global_8.member[((7u * _e172) + _e174)] = _e271;
global_8.member[((8u * _e172) + _e174)] = (_e6553 * _e6505);
global_8.member[((9u * _e172) + _e174)] = select(0f, ((_e6516 * _e6505) * (((_e465.member * _e1074) + (_e465.member_1 * _e1075)) + (_e465.member_2 * _e1076))), _e6491);
global_8.member[((10u * _e172) + _e174)] = (((_e438.member * _e204) + (_e438.member_1 * _e215)) + (_e438.member_2 * _e226));
global_8.member[((11u * _e172) + _e174)] = (((_e447.member * _e204) + (_e447.member_1 * _e215)) + (_e447.member_2 * _e226));
global_8.member[((12u * _e172) + _e174)] = -((((_e465.member * _e204) + (_e465.member_1 * _e215)) + (_e465.member_2 * _e226)));
global_8.member[((13u * _e172) + _e174)] = _e238;
global_8.member[((14u * _e172) + _e174)] = _e249;
global_8.member[((15u * _e172) + _e174)] = _e260;
global_8.member[((16u * _e172) + _e174)] = _e3784;
global_8.member[((17u * _e172) + _e174)] = select(_e282, 2f, ((_e282 == 0f) || (_e282 == 4f)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
