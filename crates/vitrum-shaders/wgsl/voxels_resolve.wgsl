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
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_5,
member_21: type_12,
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
var local_42: i32;
var local_43: i32;
var phi_2397_: vec3<f32>;
var phi_2999_: i32;
var phi_3002_: i32;
var phi_3004_: i32;
var phi_3006_: i32;
var phi_3021_: i32;
var phi_3027_: i32;
var phi_3000_: i32;
var phi_3003_: i32;
var phi_3005_: i32;
var phi_3007_: i32;
var local_44: i32;
var local_45: i32;
var local_46: i32;
var phi_3102_: i32;
var local_47: i32;
var local_48: i32;
var phi_3108_: i32;
var local_49: i32;
var phi_3115_: i32;
var local_50: i32;
var local_51: i32;
var phi_3121_: i32;
var local_52: i32;
var local_53: i32;
var phi_3132_: i32;
var local_54: i32;
var local_55: i32;
var phi_3144_: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var local_59: i32;
var phi_3380_: i32;
var phi_3383_: i32;
var phi_3385_: i32;
var phi_3387_: i32;
var phi_3402_: i32;
var phi_3408_: i32;
var phi_3381_: i32;
var phi_3384_: i32;
var phi_3386_: i32;
var phi_3388_: i32;
var local_60: i32;
var local_61: i32;
var local_62: i32;
var phi_3483_: i32;
var local_63: i32;
var local_64: i32;
var phi_3489_: i32;
var local_65: i32;
var phi_3496_: i32;
var local_66: i32;
var local_67: i32;
var phi_3502_: i32;
var local_68: i32;
var local_69: i32;
var phi_3513_: i32;
var local_70: i32;
var local_71: i32;
var phi_3525_: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var local_75: i32;
var phi_3780_: vec3<f32>;
var phi_3781_: vec3<f32>;
var phi_3782_: vec3<f32>;
var phi_4619_: type_22;
var phi_5193_: vec3<f32>;
var phi_5196_: vec3<f32>;
var phi_5209_: type_23;
var phi_5665_: f32;
var phi_5668_: vec3<f32>;
var phi_5670_: i32;
var phi_5685_: i32;
var phi_5688_: f32;
var phi_5690_: vec3<f32>;
var phi_5923_: vec3<f32>;
var phi_5933_: vec3<f32>;
var phi_5686_: i32;
var phi_5689_: f32;
var phi_5691_: vec3<f32>;
var phi_5666_: f32;
var phi_5669_: vec3<f32>;
var phi_5671_: i32;
var local_76: f32;
var local_77: f32;
var local_78: vec3<f32>;
var local_79: vec3<f32>;
var local_80: vec3<f32>;
var phi_6055_: vec3<f32>;
var phi_6056_: vec3<f32>;
var phi_6057_: vec3<f32>;
var phi_6457_: vec3<f32>;
var phi_7059_: i32;
var phi_7062_: i32;
var phi_7064_: i32;
var phi_7066_: i32;
var phi_7081_: i32;
var phi_7087_: i32;
var phi_7060_: i32;
var phi_7063_: i32;
var phi_7065_: i32;
var phi_7067_: i32;
var local_81: i32;
var local_82: i32;
var local_83: i32;
var phi_7162_: i32;
var local_84: i32;
var local_85: i32;
var phi_7168_: i32;
var local_86: i32;
var phi_7175_: i32;
var local_87: i32;
var local_88: i32;
var phi_7181_: i32;
var local_89: i32;
var local_90: i32;
var phi_7192_: i32;
var local_91: i32;
var local_92: i32;
var phi_7204_: i32;
var local_93: i32;
var local_94: i32;
var local_95: i32;
var local_96: i32;
var phi_7440_: i32;
var phi_7443_: i32;
var phi_7445_: i32;
var phi_7447_: i32;
var phi_7462_: i32;
var phi_7468_: i32;
var phi_7441_: i32;
var phi_7444_: i32;
var phi_7446_: i32;
var phi_7448_: i32;
var local_97: i32;
var local_98: i32;
var local_99: i32;
var phi_7543_: i32;
var local_100: i32;
var local_101: i32;
var phi_7549_: i32;
var local_102: i32;
var phi_7556_: i32;
var local_103: i32;
var local_104: i32;
var phi_7562_: i32;
var local_105: i32;
var local_106: i32;
var phi_7573_: i32;
var local_107: i32;
var local_108: i32;
var phi_7585_: i32;
var local_109: i32;
var local_110: i32;
var local_111: i32;
var local_112: i32;
var phi_7840_: vec3<f32>;
var phi_7841_: vec3<f32>;
var phi_7842_: vec3<f32>;
var phi_8817_: type_22;
var phi_9391_: vec3<f32>;
var phi_9394_: vec3<f32>;
var phi_9407_: type_23;
var phi_9863_: f32;
var phi_9866_: vec3<f32>;
var phi_9868_: i32;
var phi_9883_: i32;
var phi_9886_: f32;
var phi_9888_: vec3<f32>;
var phi_10121_: vec3<f32>;
var phi_10131_: vec3<f32>;
var phi_9884_: i32;
var phi_9887_: f32;
var phi_9889_: vec3<f32>;
var phi_9864_: f32;
var phi_9867_: vec3<f32>;
var phi_9869_: i32;
var local_113: f32;
var local_114: f32;
var local_115: vec3<f32>;
var local_116: vec3<f32>;
var local_117: vec3<f32>;
var phi_10183_: vec3<f32>;
var phi_10184_: vec3<f32>;
var local_118: f32;
var local_119: vec3<f32>;
var local_120: f32;
var local_121: vec3<f32>;
let _e152 = global;
let _e158 = arrayLength((&global_4.member));
let _e160 = arrayLength((&global_3.member));
let _e162 = arrayLength((&global_5.member));
let _e164 = arrayLength((&global_6.member));
let _e170 = global_1.member.member;
if (_e152.x < _e170.member) {
if (_e152.y < _e170.member_1) {
let _e177 = (_e170.member * _e170.member_1);
let _e179 = ((_e152.y * _e170.member) + _e152.x);
let _e181 = bitcast<i32>(_e152.x);
let _e182 = bitcast<i32>(_e152.y);
let _e186 = global_1.member.member.member;
let _e187 = bitcast<i32>(_e186);
let _e188 = (_e182 * _e187);
let _e189 = (_e188 + _e181);
local_42 = _e189;
let _e193 = global_1.member.member.member_1;
let _e195 = bitcast<i32>((_e186 * _e193));
local_43 = _e195;
let _e196 = local_42;
local_40 = _e196;
local_41 = _e195;
let _e197 = local_41;
let _e199 = local_40;
let _e200 = ((3i * _e197) + _e199);
let _e202 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e204 = select(_e202, _e200, (_e200 < _e202));
let _e209 = global_2.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e210 = local_41;
let _e212 = local_40;
let _e213 = ((4i * _e210) + _e212);
let _e215 = select(_e202, _e213, (_e213 < _e202));
let _e220 = global_2.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e221 = local_41;
let _e223 = local_40;
let _e224 = ((5i * _e221) + _e223);
let _e226 = select(_e202, _e224, (_e224 < _e202));
let _e231 = global_2.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e232 = local_42;
local_38 = _e232;
local_39 = _e195;
let _e233 = local_39;
let _e235 = local_38;
let _e236 = ((6i * _e233) + _e235);
let _e238 = select(_e202, _e236, (_e236 < _e202));
let _e243 = global_2.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e244 = local_39;
let _e246 = local_38;
let _e247 = ((7i * _e244) + _e246);
let _e249 = select(_e202, _e247, (_e247 < _e202));
let _e254 = global_2.member[bitcast<u32>(select(0i, _e249, (_e249 > 0i)))];
let _e255 = local_39;
let _e257 = local_38;
let _e258 = ((8i * _e255) + _e257);
let _e260 = select(_e202, _e258, (_e258 < _e202));
let _e265 = global_2.member[bitcast<u32>(select(0i, _e260, (_e260 > 0i)))];
let _e266 = local_43;
let _e268 = local_42;
let _e269 = ((18i * _e266) + _e268);
let _e271 = select(_e202, _e269, (_e269 < _e202));
let _e276 = global_2.member[bitcast<u32>(select(0i, _e271, (_e271 > 0i)))];
let _e277 = local_43;
let _e279 = local_42;
let _e280 = ((16i * _e277) + _e279);
let _e282 = select(_e202, _e280, (_e280 < _e202));
let _e287 = global_2.member[bitcast<u32>(select(0i, _e282, (_e282 > 0i)))];
let _e288 = (_e170.member_2 == 1u);
let _e290 = (_e288 && (_e287 == 3f));
let _e291 = local_42;
local_36 = _e291;
local_37 = _e195;
let _e292 = local_37;
let _e294 = local_36;
let _e295 = ((9i * _e292) + _e294);
let _e297 = select(_e202, _e295, (_e295 < _e202));
let _e302 = global_2.member[bitcast<u32>(select(0i, _e297, (_e297 > 0i)))];
let _e303 = local_37;
let _e305 = local_36;
let _e306 = ((10i * _e303) + _e305);
let _e308 = select(_e202, _e306, (_e306 < _e202));
let _e313 = global_2.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e314 = local_37;
let _e316 = local_36;
let _e317 = ((11i * _e314) + _e316);
let _e319 = select(_e202, _e317, (_e317 < _e202));
let _e324 = global_2.member[bitcast<u32>(select(0i, _e319, (_e319 > 0i)))];
let _e325 = vec3<f32>(_e302, _e313, _e324);
let _e326 = (_e181 - 1i);
let _e327 = bitcast<i32>(_e193);
local_33 = _e187;
local_34 = _e327;
let _e329 = local_33;
let _e332 = (_e182 >= 0i);
let _e334 = local_34;
let _e336 = ((((_e326 >= 0i) && (_e326 < _e329)) && _e332) && (_e182 < _e334));
if _e336 {
let _e337 = local_33;
local_35 = ((_e182 * _e337) + _e326);
} else {
local_35 = 0i;
}
let _e340 = local_33;
let _e341 = local_34;
let _e344 = local_35;
let _e345 = ((18i * (_e340 * _e341)) + _e344);
let _e347 = select(_e202, _e345, (_e345 < _e202));
let _e352 = global_2.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e355 = local_33;
let _e356 = local_34;
let _e359 = local_35;
let _e360 = ((16i * (_e355 * _e356)) + _e359);
let _e362 = select(_e202, _e360, (_e360 < _e202));
let _e367 = global_2.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
let _e369 = ((_e336 && (_e352 == _e276)) && (_e367 == _e287));
let _e370 = local_35;
local_31 = _e370;
local_32 = _e195;
let _e371 = local_32;
let _e373 = local_31;
let _e374 = ((3i * _e371) + _e373);
let _e376 = select(_e202, _e374, (_e374 < _e202));
let _e381 = global_2.member[bitcast<u32>(select(0i, _e376, (_e376 > 0i)))];
let _e382 = local_32;
let _e384 = local_31;
let _e385 = ((4i * _e382) + _e384);
let _e387 = select(_e202, _e385, (_e385 < _e202));
let _e392 = global_2.member[bitcast<u32>(select(0i, _e387, (_e387 > 0i)))];
let _e393 = local_32;
let _e395 = local_31;
let _e396 = ((5i * _e393) + _e395);
let _e398 = select(_e202, _e396, (_e396 < _e202));
let _e403 = global_2.member[bitcast<u32>(select(0i, _e398, (_e398 > 0i)))];
let _e404 = local_33;
let _e405 = local_34;
let _e408 = local_35;
let _e409 = ((21i * (_e404 * _e405)) + _e408);
let _e411 = select(_e202, _e409, (_e409 < _e202));
let _e416 = global_2.member[bitcast<u32>(select(0i, _e411, (_e411 > 0i)))];
let _e418 = (_e336 && (_e416 > 0f));
let _e419 = f32(_e187);
let _e420 = f32(_e327);
let _e429 = global_1.member.member_6.member;
let _e430 = (((((f32(_e326) + 0.5f) / _e419) * 2f) - 1f) * _e429);
let _e439 = global_1.member.member_6.member_1;
let _e440 = ((1f - (((f32(_e182) + 0.5f) / _e420) * 2f)) * _e439);
let _e443 = global_1.member.member_7;
let _e452 = global_1.member.member_8;
let _e456 = (_e452.member * _e440);
let _e457 = (_e452.member_1 * _e440);
let _e458 = (_e452.member_2 * _e440);
let _e465 = global_1.member.member_6.member_3;
let _e467 = select(1f, 0f, (_e465 != 0u));
let _e470 = global_1.member.member_9;
let _e477 = (_e470.member + (((_e443.member * _e430) + _e456) * _e467));
let _e478 = (_e470.member_1 + (((_e443.member_1 * _e430) + _e457) * _e467));
let _e479 = (_e470.member_2 + (((_e443.member_2 * _e430) + _e458) * _e467));
let _e484 = (((_e477 * _e477) + (_e478 * _e478)) + (_e479 * _e479));
let _e487 = sqrt(select(0f, _e484, (_e484 > 0f)));
let _e490 = (1f / select(1e-20f, _e487, (_e487 > 1e-20f)));
let _e491 = (_e477 * _e490);
let _e492 = (_e478 * _e490);
let _e493 = (_e479 * _e490);
local_29 = (_e188 + _e326);
local_30 = _e195;
let _e495 = local_30;
let _e497 = local_29;
let _e498 = ((9i * _e495) + _e497);
let _e500 = select(_e202, _e498, (_e498 < _e202));
let _e505 = global_2.member[bitcast<u32>(select(0i, _e500, (_e500 > 0i)))];
let _e506 = local_30;
let _e508 = local_29;
let _e509 = ((10i * _e506) + _e508);
let _e511 = select(_e202, _e509, (_e509 < _e202));
let _e516 = global_2.member[bitcast<u32>(select(0i, _e511, (_e511 > 0i)))];
let _e517 = local_30;
let _e519 = local_29;
let _e520 = ((11i * _e517) + _e519);
let _e522 = select(_e202, _e520, (_e520 < _e202));
let _e527 = global_2.member[bitcast<u32>(select(0i, _e522, (_e522 > 0i)))];
let _e533 = (2f * (((_e491 * _e505) + (_e492 * _e516)) + (_e493 * _e527)));
let _e537 = (_e491 - (_e505 * _e533));
let _e538 = (_e492 - (_e516 * _e533));
let _e539 = (_e493 - (_e527 * _e533));
let _e540 = (_e181 + 1i);
local_26 = _e187;
local_27 = _e327;
let _e542 = local_26;
let _e546 = local_27;
let _e548 = ((((_e540 >= 0i) && (_e540 < _e542)) && _e332) && (_e182 < _e546));
if _e548 {
let _e549 = local_26;
local_28 = ((_e182 * _e549) + _e540);
} else {
local_28 = 0i;
}
let _e552 = local_26;
let _e553 = local_27;
let _e556 = local_28;
let _e557 = ((18i * (_e552 * _e553)) + _e556);
let _e559 = select(_e202, _e557, (_e557 < _e202));
let _e564 = global_2.member[bitcast<u32>(select(0i, _e559, (_e559 > 0i)))];
let _e567 = local_26;
let _e568 = local_27;
let _e571 = local_28;
let _e572 = ((16i * (_e567 * _e568)) + _e571);
let _e574 = select(_e202, _e572, (_e572 < _e202));
let _e579 = global_2.member[bitcast<u32>(select(0i, _e574, (_e574 > 0i)))];
let _e581 = ((_e548 && (_e564 == _e276)) && (_e579 == _e287));
let _e582 = local_28;
local_24 = _e582;
local_25 = _e195;
let _e583 = local_25;
let _e585 = local_24;
let _e586 = ((3i * _e583) + _e585);
let _e588 = select(_e202, _e586, (_e586 < _e202));
let _e593 = global_2.member[bitcast<u32>(select(0i, _e588, (_e588 > 0i)))];
let _e594 = local_25;
let _e596 = local_24;
let _e597 = ((4i * _e594) + _e596);
let _e599 = select(_e202, _e597, (_e597 < _e202));
let _e604 = global_2.member[bitcast<u32>(select(0i, _e599, (_e599 > 0i)))];
let _e605 = local_25;
let _e607 = local_24;
let _e608 = ((5i * _e605) + _e607);
let _e610 = select(_e202, _e608, (_e608 < _e202));
let _e615 = global_2.member[bitcast<u32>(select(0i, _e610, (_e610 > 0i)))];
let _e616 = local_26;
let _e617 = local_27;
let _e620 = local_28;
let _e621 = ((21i * (_e616 * _e617)) + _e620);
let _e623 = select(_e202, _e621, (_e621 < _e202));
let _e628 = global_2.member[bitcast<u32>(select(0i, _e623, (_e623 > 0i)))];
let _e630 = (_e548 && (_e628 > 0f));
let _e636 = (((((f32(_e540) + 0.5f) / _e419) * 2f) - 1f) * _e429);
let _e646 = (_e470.member + (((_e443.member * _e636) + _e456) * _e467));
let _e647 = (_e470.member_1 + (((_e443.member_1 * _e636) + _e457) * _e467));
let _e648 = (_e470.member_2 + (((_e443.member_2 * _e636) + _e458) * _e467));
let _e653 = (((_e646 * _e646) + (_e647 * _e647)) + (_e648 * _e648));
let _e656 = sqrt(select(0f, _e653, (_e653 > 0f)));
let _e659 = (1f / select(1e-20f, _e656, (_e656 > 1e-20f)));
let _e660 = (_e646 * _e659);
let _e661 = (_e647 * _e659);
let _e662 = (_e648 * _e659);
local_22 = (_e188 + _e540);
local_23 = _e195;
let _e664 = local_23;
let _e666 = local_22;
let _e667 = ((9i * _e664) + _e666);
let _e669 = select(_e202, _e667, (_e667 < _e202));
let _e674 = global_2.member[bitcast<u32>(select(0i, _e669, (_e669 > 0i)))];
let _e675 = local_23;
let _e677 = local_22;
let _e678 = ((10i * _e675) + _e677);
let _e680 = select(_e202, _e678, (_e678 < _e202));
let _e685 = global_2.member[bitcast<u32>(select(0i, _e680, (_e680 > 0i)))];
let _e686 = local_23;
let _e688 = local_22;
let _e689 = ((11i * _e686) + _e688);
let _e691 = select(_e202, _e689, (_e689 < _e202));
let _e696 = global_2.member[bitcast<u32>(select(0i, _e691, (_e691 > 0i)))];
let _e702 = (2f * (((_e660 * _e674) + (_e661 * _e685)) + (_e662 * _e696)));
let _e706 = (_e660 - (_e674 * _e702));
let _e707 = (_e661 - (_e685 * _e702));
let _e708 = (_e662 - (_e696 * _e702));
let _e709 = (_e182 - 1i);
local_19 = _e187;
local_20 = _e327;
let _e710 = (_e181 >= 0i);
let _e711 = local_19;
let _e716 = local_20;
let _e718 = (((_e710 && (_e181 < _e711)) && (_e709 >= 0i)) && (_e709 < _e716));
if _e718 {
let _e719 = local_19;
local_21 = ((_e709 * _e719) + _e181);
} else {
local_21 = 0i;
}
let _e722 = local_19;
let _e723 = local_20;
let _e726 = local_21;
let _e727 = ((18i * (_e722 * _e723)) + _e726);
let _e729 = select(_e202, _e727, (_e727 < _e202));
let _e734 = global_2.member[bitcast<u32>(select(0i, _e729, (_e729 > 0i)))];
let _e737 = local_19;
let _e738 = local_20;
let _e741 = local_21;
let _e742 = ((16i * (_e737 * _e738)) + _e741);
let _e744 = select(_e202, _e742, (_e742 < _e202));
let _e749 = global_2.member[bitcast<u32>(select(0i, _e744, (_e744 > 0i)))];
let _e751 = ((_e718 && (_e734 == _e276)) && (_e749 == _e287));
let _e752 = local_21;
local_17 = _e752;
local_18 = _e195;
let _e753 = local_18;
let _e755 = local_17;
let _e756 = ((3i * _e753) + _e755);
let _e758 = select(_e202, _e756, (_e756 < _e202));
let _e763 = global_2.member[bitcast<u32>(select(0i, _e758, (_e758 > 0i)))];
let _e764 = local_18;
let _e766 = local_17;
let _e767 = ((4i * _e764) + _e766);
let _e769 = select(_e202, _e767, (_e767 < _e202));
let _e774 = global_2.member[bitcast<u32>(select(0i, _e769, (_e769 > 0i)))];
let _e775 = local_18;
let _e777 = local_17;
let _e778 = ((5i * _e775) + _e777);
let _e780 = select(_e202, _e778, (_e778 < _e202));
let _e785 = global_2.member[bitcast<u32>(select(0i, _e780, (_e780 > 0i)))];
let _e786 = local_19;
let _e787 = local_20;
let _e790 = local_21;
let _e791 = ((21i * (_e786 * _e787)) + _e790);
let _e793 = select(_e202, _e791, (_e791 < _e202));
let _e798 = global_2.member[bitcast<u32>(select(0i, _e793, (_e793 > 0i)))];
let _e800 = (_e718 && (_e798 > 0f));
let _e806 = (((((f32(_e181) + 0.5f) / _e419) * 2f) - 1f) * _e429);
let _e812 = ((1f - (((f32(_e709) + 0.5f) / _e420) * 2f)) * _e439);
let _e813 = (_e443.member * _e806);
let _e814 = (_e443.member_1 * _e806);
let _e815 = (_e443.member_2 * _e806);
let _e825 = (_e470.member + ((_e813 + (_e452.member * _e812)) * _e467));
let _e826 = (_e470.member_1 + ((_e814 + (_e452.member_1 * _e812)) * _e467));
let _e827 = (_e470.member_2 + ((_e815 + (_e452.member_2 * _e812)) * _e467));
let _e832 = (((_e825 * _e825) + (_e826 * _e826)) + (_e827 * _e827));
let _e835 = sqrt(select(0f, _e832, (_e832 > 0f)));
let _e838 = (1f / select(1e-20f, _e835, (_e835 > 1e-20f)));
let _e839 = (_e825 * _e838);
let _e840 = (_e826 * _e838);
let _e841 = (_e827 * _e838);
local_15 = ((_e709 * _e187) + _e181);
local_16 = _e195;
let _e844 = local_16;
let _e846 = local_15;
let _e847 = ((9i * _e844) + _e846);
let _e849 = select(_e202, _e847, (_e847 < _e202));
let _e854 = global_2.member[bitcast<u32>(select(0i, _e849, (_e849 > 0i)))];
let _e855 = local_16;
let _e857 = local_15;
let _e858 = ((10i * _e855) + _e857);
let _e860 = select(_e202, _e858, (_e858 < _e202));
let _e865 = global_2.member[bitcast<u32>(select(0i, _e860, (_e860 > 0i)))];
let _e866 = local_16;
let _e868 = local_15;
let _e869 = ((11i * _e866) + _e868);
let _e871 = select(_e202, _e869, (_e869 < _e202));
let _e876 = global_2.member[bitcast<u32>(select(0i, _e871, (_e871 > 0i)))];
let _e882 = (2f * (((_e839 * _e854) + (_e840 * _e865)) + (_e841 * _e876)));
let _e886 = (_e839 - (_e854 * _e882));
let _e887 = (_e840 - (_e865 * _e882));
let _e888 = (_e841 - (_e876 * _e882));
let _e889 = (_e182 + 1i);
local_12 = _e187;
local_13 = _e327;
let _e890 = local_12;
let _e895 = local_13;
let _e897 = (((_e710 && (_e181 < _e890)) && (_e889 >= 0i)) && (_e889 < _e895));
if _e897 {
let _e898 = local_12;
local_14 = ((_e889 * _e898) + _e181);
} else {
local_14 = 0i;
}
let _e901 = local_12;
let _e902 = local_13;
let _e905 = local_14;
let _e906 = ((18i * (_e901 * _e902)) + _e905);
let _e908 = select(_e202, _e906, (_e906 < _e202));
let _e913 = global_2.member[bitcast<u32>(select(0i, _e908, (_e908 > 0i)))];
let _e916 = local_12;
let _e917 = local_13;
let _e920 = local_14;
let _e921 = ((16i * (_e916 * _e917)) + _e920);
let _e923 = select(_e202, _e921, (_e921 < _e202));
let _e928 = global_2.member[bitcast<u32>(select(0i, _e923, (_e923 > 0i)))];
let _e930 = ((_e897 && (_e913 == _e276)) && (_e928 == _e287));
let _e931 = local_14;
local_10 = _e931;
local_11 = _e195;
let _e932 = local_11;
let _e934 = local_10;
let _e935 = ((3i * _e932) + _e934);
let _e937 = select(_e202, _e935, (_e935 < _e202));
let _e942 = global_2.member[bitcast<u32>(select(0i, _e937, (_e937 > 0i)))];
let _e943 = local_11;
let _e945 = local_10;
let _e946 = ((4i * _e943) + _e945);
let _e948 = select(_e202, _e946, (_e946 < _e202));
let _e953 = global_2.member[bitcast<u32>(select(0i, _e948, (_e948 > 0i)))];
let _e954 = local_11;
let _e956 = local_10;
let _e957 = ((5i * _e954) + _e956);
let _e959 = select(_e202, _e957, (_e957 < _e202));
let _e964 = global_2.member[bitcast<u32>(select(0i, _e959, (_e959 > 0i)))];
let _e965 = local_12;
let _e966 = local_13;
let _e969 = local_14;
let _e970 = ((21i * (_e965 * _e966)) + _e969);
let _e972 = select(_e202, _e970, (_e970 < _e202));
let _e977 = global_2.member[bitcast<u32>(select(0i, _e972, (_e972 > 0i)))];
let _e979 = (_e897 && (_e977 > 0f));
let _e985 = ((1f - (((f32(_e889) + 0.5f) / _e420) * 2f)) * _e439);
let _e995 = (_e470.member + ((_e813 + (_e452.member * _e985)) * _e467));
let _e996 = (_e470.member_1 + ((_e814 + (_e452.member_1 * _e985)) * _e467));
let _e997 = (_e470.member_2 + ((_e815 + (_e452.member_2 * _e985)) * _e467));
let _e1002 = (((_e995 * _e995) + (_e996 * _e996)) + (_e997 * _e997));
let _e1005 = sqrt(select(0f, _e1002, (_e1002 > 0f)));
let _e1008 = (1f / select(1e-20f, _e1005, (_e1005 > 1e-20f)));
let _e1009 = (_e995 * _e1008);
let _e1010 = (_e996 * _e1008);
let _e1011 = (_e997 * _e1008);
local_8 = ((_e889 * _e187) + _e181);
local_9 = _e195;
let _e1014 = local_9;
let _e1016 = local_8;
let _e1017 = ((9i * _e1014) + _e1016);
let _e1019 = select(_e202, _e1017, (_e1017 < _e202));
let _e1024 = global_2.member[bitcast<u32>(select(0i, _e1019, (_e1019 > 0i)))];
let _e1025 = local_9;
let _e1027 = local_8;
let _e1028 = ((10i * _e1025) + _e1027);
let _e1030 = select(_e202, _e1028, (_e1028 < _e202));
let _e1035 = global_2.member[bitcast<u32>(select(0i, _e1030, (_e1030 > 0i)))];
let _e1036 = local_9;
let _e1038 = local_8;
let _e1039 = ((11i * _e1036) + _e1038);
let _e1041 = select(_e202, _e1039, (_e1039 < _e202));
let _e1046 = global_2.member[bitcast<u32>(select(0i, _e1041, (_e1041 > 0i)))];
let _e1052 = (2f * (((_e1009 * _e1024) + (_e1010 * _e1035)) + (_e1011 * _e1046)));
let _e1056 = (_e1009 - (_e1024 * _e1052));
let _e1057 = (_e1010 - (_e1035 * _e1052));
let _e1058 = (_e1011 - (_e1046 * _e1052));
let _e1059 = (_e813 + _e456);
let _e1060 = (_e814 + _e457);
let _e1061 = (_e815 + _e458);
let _e1065 = (_e470.member + (_e1059 * _e467));
let _e1066 = (_e470.member_1 + (_e1060 * _e467));
let _e1067 = (_e470.member_2 + (_e1061 * _e467));
let _e1072 = (((_e1065 * _e1065) + (_e1066 * _e1066)) + (_e1067 * _e1067));
let _e1075 = sqrt(select(0f, _e1072, (_e1072 > 0f)));
let _e1078 = (1f / select(1e-20f, _e1075, (_e1075 > 1e-20f)));
let _e1079 = (_e1065 * _e1078);
let _e1080 = (_e1066 * _e1078);
let _e1081 = (_e1067 * _e1078);
let _e1082 = (_e660 - _e1079);
let _e1083 = (_e661 - _e1080);
let _e1084 = (_e662 - _e1081);
let _e1089 = (((_e1082 * _e1082) + (_e1083 * _e1083)) + (_e1084 * _e1084));
let _e1092 = sqrt(select(0f, _e1089, (_e1089 > 0f)));
let _e1093 = (_e593 - _e381);
let _e1094 = (_e604 - _e392);
let _e1095 = (_e615 - _e403);
let _e1100 = (((_e1093 * _e1093) + (_e1094 * _e1094)) + (_e1095 * _e1095));
let _e1105 = (_e593 - _e209);
let _e1106 = (_e604 - _e220);
let _e1107 = (_e615 - _e231);
let _e1112 = (((_e1105 * _e1105) + (_e1106 * _e1106)) + (_e1107 * _e1107));
let _e1116 = (_e209 - _e381);
let _e1117 = (_e220 - _e392);
let _e1118 = (_e231 - _e403);
let _e1123 = (((_e1116 * _e1116) + (_e1117 * _e1117)) + (_e1118 * _e1118));
let _e1131 = select(select(_e1092, select(sqrt(select(0f, _e1123, (_e1123 > 0f))), sqrt(select(0f, _e1112, (_e1112 > 0f))), _e581), (_e369 || _e581)), (0.5f * sqrt(select(0f, _e1100, (_e1100 > 0f)))), (_e369 && _e581));
let _e1132 = (_e942 - _e763);
let _e1133 = (_e953 - _e774);
let _e1134 = (_e964 - _e785);
let _e1139 = (((_e1132 * _e1132) + (_e1133 * _e1133)) + (_e1134 * _e1134));
let _e1144 = (_e942 - _e209);
let _e1145 = (_e953 - _e220);
let _e1146 = (_e964 - _e231);
let _e1151 = (((_e1144 * _e1144) + (_e1145 * _e1145)) + (_e1146 * _e1146));
let _e1155 = (_e209 - _e763);
let _e1156 = (_e220 - _e774);
let _e1157 = (_e231 - _e785);
let _e1162 = (((_e1155 * _e1155) + (_e1156 * _e1156)) + (_e1157 * _e1157));
let _e1170 = select(select(_e1092, select(sqrt(select(0f, _e1162, (_e1162 > 0f))), sqrt(select(0f, _e1151, (_e1151 > 0f))), _e930), (_e751 || _e930)), (0.5f * sqrt(select(0f, _e1139, (_e1139 > 0f)))), (_e751 && _e930));
let _e1171 = (_e276 > 0f);
let _e1174 = select(_e1092, select(_e1170, _e1131, (_e1131 > _e1170)), _e1171);
let _e1178 = global_1.member.member_16.member_4;
let _e1186 = (((_e1178.member * _e209) + (_e1178.member_1 * _e220)) + (_e1178.member_2 * _e231));
let _e1190 = global_1.member.member_16.member_5;
let _e1198 = (((_e1190.member * _e209) + (_e1190.member_1 * _e220)) + (_e1190.member_2 * _e231));
let _e1202 = global_1.member.member_16.member_6;
let _e1210 = (((_e1202.member * _e209) + (_e1202.member_1 * _e220)) + (_e1202.member_2 * _e231));
let _e1214 = global_1.member.member_16.member;
let _e1218 = global_1.member.member_16.member_7;
let _e1222 = vec3<f32>(_e1218.member, _e1218.member_1, _e1218.member_2);
let _e1226 = global_1.member.member_16.member_8;
let _e1230 = (_e1214 == 0u);
if _e1230 {
phi_3782_ = _e1222;
} else {
if (_e1214 == 1u) {
let _e1233 = select(-1f, _e1210, (_e1210 > -1f));
let _e1235 = select(1f, _e1233, (_e1233 < 1f));
if (_e1235 > 0f) {
phi_2397_ = _e1222;
} else {
let _e1240 = global_1.member.member_16.member_9;
phi_2397_ = vec3<f32>(_e1240.member, _e1240.member_1, _e1240.member_2);
}
let _e1246 = phi_2397_;
let _e1255 = bitcast<f32>((bitcast<u32>(_e1235) & 2147483647u));
let _e1258 = sqrt(select(0f, _e1255, (_e1255 > 0f)));
phi_3781_ = vec3<f32>((_e1226.member + ((_e1246.x - _e1226.member) * _e1258)), (_e1226.member_1 + ((_e1246.y - _e1226.member_1) * _e1258)), (_e1226.member_2 + ((_e1246.z - _e1226.member_2) * _e1258)));
} else {
if (_e1214 == 2u) {
let _e1270 = global_1.member.member_16.member_10;
let _e1271 = (_e1174 / _e1270);
let _e1273 = select(1e-4f, _e1271, (_e1271 > 1e-4f));
let _e1276 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
let _e1279 = bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u));
let _e1283 = select(_e1279, _e1276, (_e1276 > _e1279));
let _e1286 = (select(_e1279, _e1276, (_e1276 < _e1279)) / select(1.1754944e-38f, _e1283, (_e1283 > 1.1754944e-38f)));
let _e1287 = (_e1286 > 0.41421357f);
let _e1291 = select(_e1286, ((_e1286 - 1f) / (_e1286 + 1f)), _e1287);
let _e1292 = (_e1291 * _e1291);
let _e1307 = (select(0f, 0.7853982f, _e1287) + (_e1291 + ((_e1291 * _e1292) * (-0.33333334f + (_e1292 * (0.2f + (_e1292 * (-0.14285713f + (_e1292 * (0.11111111f + (_e1292 * (-0.09090909f + (_e1292 * 0.0585f)))))))))))));
let _e1310 = select(_e1307, (1.5707964f - _e1307), (_e1279 > _e1276));
let _e1313 = select(_e1310, (3.1415927f - _e1310), (_e1186 < 0f));
let _e1319 = (1f - (_e1210 * _e1210));
let _e1322 = sqrt(select(0f, _e1319, (_e1319 > 0f)));
let _e1325 = (_e1273 / select(1e-3f, _e1322, (_e1322 > 1e-3f)));
let _e1326 = ((select(_e1313, -(_e1313), (_e1198 < 0f)) / _e1270) * 0.5f);
let _e1328 = select(-8e6f, _e1326, (_e1326 > -8e6f));
let _e1330 = select(8e6f, _e1328, (_e1328 < 8e6f));
let _e1337 = select(0i, select(select(i32(_e1330), i32(-2147483648), (_e1330 < -2147483600f)), 2147483647i, (_e1330 > 2147483500f)), (_e1330 == _e1330));
let _e1344 = ((_e1326 - f32((_e1337 - select(0i, 1i, (_e1330 < f32(_e1337)))))) * 2f);
let _e1352 = ((select(select((_e1344 - 2f), (1f - _e1344), (_e1344 < 1.5f)), _e1344, (_e1344 < 0.5f)) * 2f) / _e1325);
let _e1354 = select(-1f, _e1352, (_e1352 > -1f));
let _e1357 = (2f - _e1325);
let _e1359 = select(0f, _e1357, (_e1357 > 0f));
let _e1364 = select(-1f, _e1210, (_e1210 > -1f));
let _e1366 = select(1f, _e1364, (_e1364 < 1f));
let _e1369 = ((1f - _e1366) * (1f + _e1366));
let _e1372 = sqrt(select(0f, _e1369, (_e1369 > 0f)));
let _e1375 = bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u));
let _e1378 = bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u));
let _e1382 = select(_e1378, _e1375, (_e1375 > _e1378));
let _e1385 = (select(_e1378, _e1375, (_e1375 < _e1378)) / select(1.1754944e-38f, _e1382, (_e1382 > 1.1754944e-38f)));
let _e1386 = (_e1385 > 0.41421357f);
let _e1390 = select(_e1385, ((_e1385 - 1f) / (_e1385 + 1f)), _e1386);
let _e1391 = (_e1390 * _e1390);
let _e1406 = (select(0f, 0.7853982f, _e1386) + (_e1390 + ((_e1390 * _e1391) * (-0.33333334f + (_e1391 * (0.2f + (_e1391 * (-0.14285713f + (_e1391 * (0.11111111f + (_e1391 * (-0.09090909f + (_e1391 * 0.0585f)))))))))))));
let _e1409 = select(_e1406, (1.5707964f - _e1406), (_e1378 > _e1375));
let _e1412 = select(_e1409, (3.1415927f - _e1409), (_e1372 < 0f));
let _e1417 = ((select(_e1412, -(_e1412), (_e1366 < 0f)) / _e1270) * 0.5f);
let _e1419 = select(-8e6f, _e1417, (_e1417 > -8e6f));
let _e1421 = select(8e6f, _e1419, (_e1419 < 8e6f));
let _e1428 = select(0i, select(select(i32(_e1421), i32(-2147483648), (_e1421 < -2147483600f)), 2147483647i, (_e1421 > 2147483500f)), (_e1421 == _e1421));
let _e1435 = ((_e1417 - f32((_e1428 - select(0i, 1i, (_e1421 < f32(_e1428)))))) * 2f);
let _e1443 = ((select(select((_e1435 - 2f), (1f - _e1435), (_e1435 < 1.5f)), _e1435, (_e1435 < 0.5f)) * 2f) / _e1273);
let _e1445 = select(-1f, _e1443, (_e1443 > -1f));
let _e1448 = (2f - _e1273);
let _e1450 = select(0f, _e1448, (_e1448 > 0f));
let _e1456 = (0.5f + ((0.5f * (select(1f, _e1354, (_e1354 < 1f)) * select(1f, _e1359, (_e1359 < 1f)))) * (select(1f, _e1445, (_e1445 < 1f)) * select(1f, _e1450, (_e1450 < 1f)))));
phi_3780_ = vec3<f32>((_e1218.member + ((_e1226.member - _e1218.member) * _e1456)), (_e1218.member_1 + ((_e1226.member_1 - _e1218.member_1) * _e1456)), (_e1218.member_2 + ((_e1226.member_2 - _e1218.member_2) * _e1456)));
} else {
let _e1470 = global_1.member.member_16.member_1;
let _e1471 = bitcast<i32>(_e1470);
let _e1476 = global_1.member.member_16.member_3;
let _e1478 = f32(bitcast<i32>(_e1476));
let _e1480 = (2f * 3.1415927f);
let _e1481 = ((_e1174 * f32(_e1471)) / _e1480);
let _e1483 = select(1e-6f, _e1481, (_e1481 > 1e-6f));
let _e1486 = bitcast<u32>(select(1.1754944e-38f, _e1483, (_e1483 > 1.1754944e-38f)));
let _e1487 = (_e1486 & 8388607u);
let _e1489 = select(0u, 1u, (_e1487 > 3474675u));
let _e1500 = bitcast<f32>((_e1487 | ((127u - _e1489) << bitcast<u32>(23i))));
let _e1503 = ((_e1500 - 1f) / (_e1500 + 1f));
let _e1504 = (_e1503 * _e1503);
let _e1519 = (f32(((bitcast<i32>((_e1486 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1489))) + (((2f * _e1503) + ((_e1503 * _e1504) * (0.6666667f + (_e1504 * (0.4f + (_e1504 * (0.2857143f + (_e1504 * (0.22222222f + (_e1504 * 0.18181819f)))))))))) * 1.442695f));
let _e1520 = (_e1478 - 1f);
let _e1522 = select(0f, _e1519, (_e1519 > 0f));
let _e1524 = select(_e1520, _e1522, (_e1522 < _e1520));
let _e1525 = (_e1478 - 2f);
let _e1527 = select(0f, _e1525, (_e1525 > 0f));
let _e1529 = select(0f, _e1524, (_e1524 > 0f));
let _e1531 = select(_e1527, _e1529, (_e1529 < _e1527));
let _e1538 = select(0i, select(select(i32(_e1531), i32(-2147483648), (_e1531 < -2147483600f)), 2147483647i, (_e1531 > 2147483500f)), (_e1531 == _e1531));
let _e1542 = (_e1538 - select(0i, 1i, (_e1531 < f32(_e1538))));
let _e1545 = bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u));
let _e1548 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
let _e1552 = select(_e1548, _e1545, (_e1545 > _e1548));
let _e1555 = (select(_e1548, _e1545, (_e1545 < _e1548)) / select(1.1754944e-38f, _e1552, (_e1552 > 1.1754944e-38f)));
let _e1556 = (_e1555 > 0.41421357f);
let _e1560 = select(_e1555, ((_e1555 - 1f) / (_e1555 + 1f)), _e1556);
let _e1561 = (_e1560 * _e1560);
let _e1576 = (select(0f, 0.7853982f, _e1556) + (_e1560 + ((_e1560 * _e1561) * (-0.33333334f + (_e1561 * (0.2f + (_e1561 * (-0.14285713f + (_e1561 * (0.11111111f + (_e1561 * (-0.09090909f + (_e1561 * 0.0585f)))))))))))));
let _e1579 = select(_e1576, (1.5707964f - _e1576), (_e1548 > _e1545));
let _e1582 = select(_e1579, (3.1415927f - _e1579), (_e1198 < 0f));
let _e1587 = (0.5f - (select(_e1582, -(_e1582), (_e1186 < 0f)) / _e1480));
let _e1589 = select(-1f, _e1210, (_e1210 > -1f));
let _e1591 = select(1f, _e1589, (_e1589 < 1f));
let _e1594 = ((1f - _e1591) * (1f + _e1591));
let _e1597 = sqrt(select(0f, _e1594, (_e1594 > 0f)));
let _e1600 = bitcast<f32>((bitcast<u32>(_e1597) & 2147483647u));
let _e1603 = bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u));
let _e1607 = select(_e1603, _e1600, (_e1600 > _e1603));
let _e1610 = (select(_e1603, _e1600, (_e1600 < _e1603)) / select(1.1754944e-38f, _e1607, (_e1607 > 1.1754944e-38f)));
let _e1611 = (_e1610 > 0.41421357f);
let _e1615 = select(_e1610, ((_e1610 - 1f) / (_e1610 + 1f)), _e1611);
let _e1616 = (_e1615 * _e1615);
let _e1631 = (select(0f, 0.7853982f, _e1611) + (_e1615 + ((_e1615 * _e1616) * (-0.33333334f + (_e1616 * (0.2f + (_e1616 * (-0.14285713f + (_e1616 * (0.11111111f + (_e1616 * (-0.09090909f + (_e1616 * 0.0585f)))))))))))));
let _e1634 = select(_e1631, (1.5707964f - _e1631), (_e1603 > _e1600));
let _e1637 = select(_e1634, (3.1415927f - _e1634), (_e1597 < 0f));
let _e1642 = (0.5f - (select(_e1637, -(_e1637), (_e1591 < 0f)) / 3.1415927f));
let _e1646 = global_1.member.member_16.member_2;
let _e1647 = bitcast<i32>(_e1646);
phi_2999_ = 0i;
phi_3002_ = 0i;
phi_3004_ = _e1647;
phi_3006_ = _e1471;
loop {
let _e1649 = phi_2999_;
let _e1651 = phi_3002_;
let _e1653 = phi_3004_;
let _e1655 = phi_3006_;
local_44 = _e1655;
local_45 = _e1653;
local_46 = _e1655;
local_47 = _e1655;
local_48 = _e1655;
local_49 = _e1655;
local_50 = _e1655;
local_51 = _e1655;
local_52 = _e1653;
local_53 = _e1653;
local_54 = _e1653;
local_55 = _e1653;
local_56 = _e1655;
local_57 = _e1651;
local_58 = _e1655;
local_59 = _e1651;
let _e1656 = (_e1649 < _e1542);
if _e1656 {
if (_e1655 > 1i) {
phi_3021_ = (_e1655 >> bitcast<u32>(1i));
} else {
phi_3021_ = 1i;
}
let _e1663 = phi_3021_;
if (_e1653 > 1i) {
phi_3027_ = (_e1653 >> bitcast<u32>(1i));
} else {
phi_3027_ = 1i;
}
let _e1668 = phi_3027_;
phi_3000_ = (_e1649 + 1i);
phi_3003_ = (_e1651 + (_e1655 * _e1653));
phi_3005_ = _e1668;
phi_3007_ = _e1663;
} else {
phi_3000_ = i32();
phi_3003_ = i32();
phi_3005_ = i32();
phi_3007_ = i32();
}
let _e1671 = phi_3000_;
let _e1673 = phi_3003_;
let _e1675 = phi_3005_;
let _e1677 = phi_3007_;
continue;
continuing {
phi_2999_ = _e1671;
phi_3002_ = _e1673;
phi_3004_ = _e1675;
phi_3006_ = _e1677;
break if !(_e1656);
}
}
let _e1680 = local_44;
let _e1681 = f32(_e1680);
let _e1683 = ((_e1587 * _e1681) - 0.5f);
let _e1685 = local_45;
let _e1686 = f32(_e1685);
let _e1688 = ((_e1642 * _e1686) - 0.5f);
let _e1690 = select(-1f, _e1683, (_e1683 > -1f));
let _e1692 = select(_e1681, _e1690, (_e1690 < _e1681));
let _e1699 = select(0i, select(select(i32(_e1692), i32(-2147483648), (_e1692 < -2147483600f)), 2147483647i, (_e1692 > 2147483500f)), (_e1692 == _e1692));
let _e1703 = (_e1699 - select(0i, 1i, (_e1692 < f32(_e1699))));
let _e1705 = select(-1f, _e1688, (_e1688 > -1f));
let _e1707 = select(_e1686, _e1705, (_e1705 < _e1686));
let _e1714 = select(0i, select(select(i32(_e1707), i32(-2147483648), (_e1707 < -2147483600f)), 2147483647i, (_e1707 > 2147483500f)), (_e1707 == _e1707));
let _e1718 = (_e1714 - select(0i, 1i, (_e1707 < f32(_e1714))));
let _e1720 = (_e1683 - f32(_e1703));
let _e1722 = (_e1688 - f32(_e1718));
let _e1724 = select(0f, _e1722, (_e1722 > 0f));
let _e1726 = select(1f, _e1724, (_e1724 < 1f));
if (_e1703 < 0i) {
let _e1729 = local_46;
phi_3102_ = (_e1703 + _e1729);
} else {
phi_3102_ = _e1703;
}
let _e1732 = phi_3102_;
let _e1734 = local_47;
if (_e1732 >= _e1734) {
let _e1737 = local_48;
phi_3108_ = (_e1732 - _e1737);
} else {
phi_3108_ = _e1732;
}
let _e1740 = phi_3108_;
let _e1741 = (_e1703 + 1i);
if (_e1741 < 0i) {
let _e1744 = local_49;
phi_3115_ = (_e1741 + _e1744);
} else {
phi_3115_ = _e1741;
}
let _e1747 = phi_3115_;
let _e1749 = local_50;
if (_e1747 >= _e1749) {
let _e1752 = local_51;
phi_3121_ = (_e1747 - _e1752);
} else {
phi_3121_ = _e1747;
}
let _e1755 = phi_3121_;
let _e1757 = select(_e1718, 0i, (_e1718 < 0i));
let _e1759 = local_52;
if (_e1757 >= _e1759) {
let _e1762 = local_53;
phi_3132_ = (_e1762 - 1i);
} else {
phi_3132_ = _e1757;
}
let _e1765 = phi_3132_;
let _e1766 = (_e1718 + 1i);
let _e1768 = select(_e1766, 0i, (_e1766 < 0i));
let _e1770 = local_54;
if (_e1768 >= _e1770) {
let _e1773 = local_55;
phi_3144_ = (_e1773 - 1i);
} else {
phi_3144_ = _e1768;
}
let _e1776 = phi_3144_;
let _e1778 = local_56;
let _e1781 = local_57;
let _e1782 = (_e1781 + (_e1765 * _e1778));
let _e1784 = local_58;
let _e1787 = local_59;
let _e1788 = (_e1787 + (_e1776 * _e1784));
let _e1790 = (3i * (_e1782 + _e1740));
let _e1792 = (bitcast<i32>(_e158) - 1i);
let _e1794 = select(_e1792, _e1790, (_e1790 < _e1792));
let _e1800 = global_4.member[bitcast<u32>(select(0i, _e1794, (_e1794 > 0i)))];
let _e1801 = (_e1790 + 1i);
let _e1803 = select(_e1792, _e1801, (_e1801 < _e1792));
let _e1809 = global_4.member[bitcast<u32>(select(0i, _e1803, (_e1803 > 0i)))];
let _e1810 = (_e1790 + 2i);
let _e1812 = select(_e1792, _e1810, (_e1810 < _e1792));
let _e1818 = global_4.member[bitcast<u32>(select(0i, _e1812, (_e1812 > 0i)))];
let _e1820 = (3i * (_e1782 + _e1755));
let _e1822 = select(_e1792, _e1820, (_e1820 < _e1792));
let _e1828 = global_4.member[bitcast<u32>(select(0i, _e1822, (_e1822 > 0i)))];
let _e1829 = (_e1820 + 1i);
let _e1831 = select(_e1792, _e1829, (_e1829 < _e1792));
let _e1837 = global_4.member[bitcast<u32>(select(0i, _e1831, (_e1831 > 0i)))];
let _e1838 = (_e1820 + 2i);
let _e1840 = select(_e1792, _e1838, (_e1838 < _e1792));
let _e1846 = global_4.member[bitcast<u32>(select(0i, _e1840, (_e1840 > 0i)))];
let _e1848 = (3i * (_e1788 + _e1740));
let _e1850 = select(_e1792, _e1848, (_e1848 < _e1792));
let _e1856 = global_4.member[bitcast<u32>(select(0i, _e1850, (_e1850 > 0i)))];
let _e1857 = (_e1848 + 1i);
let _e1859 = select(_e1792, _e1857, (_e1857 < _e1792));
let _e1865 = global_4.member[bitcast<u32>(select(0i, _e1859, (_e1859 > 0i)))];
let _e1866 = (_e1848 + 2i);
let _e1868 = select(_e1792, _e1866, (_e1866 < _e1792));
let _e1874 = global_4.member[bitcast<u32>(select(0i, _e1868, (_e1868 > 0i)))];
let _e1876 = (3i * (_e1788 + _e1755));
let _e1878 = select(_e1792, _e1876, (_e1876 < _e1792));
let _e1884 = global_4.member[bitcast<u32>(select(0i, _e1878, (_e1878 > 0i)))];
let _e1885 = (_e1876 + 1i);
let _e1887 = select(_e1792, _e1885, (_e1885 < _e1792));
let _e1893 = global_4.member[bitcast<u32>(select(0i, _e1887, (_e1887 > 0i)))];
let _e1894 = (_e1876 + 2i);
let _e1896 = select(_e1792, _e1894, (_e1894 < _e1792));
let _e1902 = global_4.member[bitcast<u32>(select(0i, _e1896, (_e1896 > 0i)))];
let _e1909 = (_e1800 + ((_e1828 - _e1800) * _e1720));
let _e1910 = (_e1809 + ((_e1837 - _e1809) * _e1720));
let _e1911 = (_e1818 + ((_e1846 - _e1818) * _e1720));
let _e1927 = (_e1909 + (((_e1856 + ((_e1884 - _e1856) * _e1720)) - _e1909) * _e1726));
let _e1928 = (_e1910 + (((_e1865 + ((_e1893 - _e1865) * _e1720)) - _e1910) * _e1726));
let _e1929 = (_e1911 + (((_e1874 + ((_e1902 - _e1874) * _e1720)) - _e1911) * _e1726));
phi_3380_ = 0i;
phi_3383_ = 0i;
phi_3385_ = _e1647;
phi_3387_ = _e1471;
loop {
let _e1932 = phi_3380_;
let _e1934 = phi_3383_;
let _e1936 = phi_3385_;
let _e1938 = phi_3387_;
local_60 = _e1938;
local_61 = _e1936;
local_62 = _e1938;
local_63 = _e1938;
local_64 = _e1938;
local_65 = _e1938;
local_66 = _e1938;
local_67 = _e1938;
local_68 = _e1936;
local_69 = _e1936;
local_70 = _e1936;
local_71 = _e1936;
local_72 = _e1938;
local_73 = _e1934;
local_74 = _e1938;
local_75 = _e1934;
let _e1939 = (_e1932 < (_e1542 + 1i));
if _e1939 {
if (_e1938 > 1i) {
phi_3402_ = (_e1938 >> bitcast<u32>(1i));
} else {
phi_3402_ = 1i;
}
let _e1946 = phi_3402_;
if (_e1936 > 1i) {
phi_3408_ = (_e1936 >> bitcast<u32>(1i));
} else {
phi_3408_ = 1i;
}
let _e1951 = phi_3408_;
phi_3381_ = (_e1932 + 1i);
phi_3384_ = (_e1934 + (_e1938 * _e1936));
phi_3386_ = _e1951;
phi_3388_ = _e1946;
} else {
phi_3381_ = i32();
phi_3384_ = i32();
phi_3386_ = i32();
phi_3388_ = i32();
}
let _e1954 = phi_3381_;
let _e1956 = phi_3384_;
let _e1958 = phi_3386_;
let _e1960 = phi_3388_;
continue;
continuing {
phi_3380_ = _e1954;
phi_3383_ = _e1956;
phi_3385_ = _e1958;
phi_3387_ = _e1960;
break if !(_e1939);
}
}
let _e1963 = local_60;
let _e1964 = f32(_e1963);
let _e1966 = ((_e1587 * _e1964) - 0.5f);
let _e1968 = local_61;
let _e1969 = f32(_e1968);
let _e1971 = ((_e1642 * _e1969) - 0.5f);
let _e1973 = select(-1f, _e1966, (_e1966 > -1f));
let _e1975 = select(_e1964, _e1973, (_e1973 < _e1964));
let _e1982 = select(0i, select(select(i32(_e1975), i32(-2147483648), (_e1975 < -2147483600f)), 2147483647i, (_e1975 > 2147483500f)), (_e1975 == _e1975));
let _e1986 = (_e1982 - select(0i, 1i, (_e1975 < f32(_e1982))));
let _e1988 = select(-1f, _e1971, (_e1971 > -1f));
let _e1990 = select(_e1969, _e1988, (_e1988 < _e1969));
let _e1997 = select(0i, select(select(i32(_e1990), i32(-2147483648), (_e1990 < -2147483600f)), 2147483647i, (_e1990 > 2147483500f)), (_e1990 == _e1990));
let _e2001 = (_e1997 - select(0i, 1i, (_e1990 < f32(_e1997))));
let _e2003 = (_e1966 - f32(_e1986));
let _e2005 = (_e1971 - f32(_e2001));
let _e2007 = select(0f, _e2005, (_e2005 > 0f));
let _e2009 = select(1f, _e2007, (_e2007 < 1f));
if (_e1986 < 0i) {
let _e2012 = local_62;
phi_3483_ = (_e1986 + _e2012);
} else {
phi_3483_ = _e1986;
}
let _e2015 = phi_3483_;
let _e2017 = local_63;
if (_e2015 >= _e2017) {
let _e2020 = local_64;
phi_3489_ = (_e2015 - _e2020);
} else {
phi_3489_ = _e2015;
}
let _e2023 = phi_3489_;
let _e2024 = (_e1986 + 1i);
if (_e2024 < 0i) {
let _e2027 = local_65;
phi_3496_ = (_e2024 + _e2027);
} else {
phi_3496_ = _e2024;
}
let _e2030 = phi_3496_;
let _e2032 = local_66;
if (_e2030 >= _e2032) {
let _e2035 = local_67;
phi_3502_ = (_e2030 - _e2035);
} else {
phi_3502_ = _e2030;
}
let _e2038 = phi_3502_;
let _e2040 = select(_e2001, 0i, (_e2001 < 0i));
let _e2042 = local_68;
if (_e2040 >= _e2042) {
let _e2045 = local_69;
phi_3513_ = (_e2045 - 1i);
} else {
phi_3513_ = _e2040;
}
let _e2048 = phi_3513_;
let _e2049 = (_e2001 + 1i);
let _e2051 = select(_e2049, 0i, (_e2049 < 0i));
let _e2053 = local_70;
if (_e2051 >= _e2053) {
let _e2056 = local_71;
phi_3525_ = (_e2056 - 1i);
} else {
phi_3525_ = _e2051;
}
let _e2059 = phi_3525_;
let _e2061 = local_72;
let _e2064 = local_73;
let _e2065 = (_e2064 + (_e2048 * _e2061));
let _e2067 = local_74;
let _e2070 = local_75;
let _e2071 = (_e2070 + (_e2059 * _e2067));
let _e2073 = (3i * (_e2065 + _e2023));
let _e2075 = select(_e1792, _e2073, (_e2073 < _e1792));
let _e2081 = global_4.member[bitcast<u32>(select(0i, _e2075, (_e2075 > 0i)))];
let _e2082 = (_e2073 + 1i);
let _e2084 = select(_e1792, _e2082, (_e2082 < _e1792));
let _e2090 = global_4.member[bitcast<u32>(select(0i, _e2084, (_e2084 > 0i)))];
let _e2091 = (_e2073 + 2i);
let _e2093 = select(_e1792, _e2091, (_e2091 < _e1792));
let _e2099 = global_4.member[bitcast<u32>(select(0i, _e2093, (_e2093 > 0i)))];
let _e2101 = (3i * (_e2065 + _e2038));
let _e2103 = select(_e1792, _e2101, (_e2101 < _e1792));
let _e2109 = global_4.member[bitcast<u32>(select(0i, _e2103, (_e2103 > 0i)))];
let _e2110 = (_e2101 + 1i);
let _e2112 = select(_e1792, _e2110, (_e2110 < _e1792));
let _e2118 = global_4.member[bitcast<u32>(select(0i, _e2112, (_e2112 > 0i)))];
let _e2119 = (_e2101 + 2i);
let _e2121 = select(_e1792, _e2119, (_e2119 < _e1792));
let _e2127 = global_4.member[bitcast<u32>(select(0i, _e2121, (_e2121 > 0i)))];
let _e2129 = (3i * (_e2071 + _e2023));
let _e2131 = select(_e1792, _e2129, (_e2129 < _e1792));
let _e2137 = global_4.member[bitcast<u32>(select(0i, _e2131, (_e2131 > 0i)))];
let _e2138 = (_e2129 + 1i);
let _e2140 = select(_e1792, _e2138, (_e2138 < _e1792));
let _e2146 = global_4.member[bitcast<u32>(select(0i, _e2140, (_e2140 > 0i)))];
let _e2147 = (_e2129 + 2i);
let _e2149 = select(_e1792, _e2147, (_e2147 < _e1792));
let _e2155 = global_4.member[bitcast<u32>(select(0i, _e2149, (_e2149 > 0i)))];
let _e2157 = (3i * (_e2071 + _e2038));
let _e2159 = select(_e1792, _e2157, (_e2157 < _e1792));
let _e2165 = global_4.member[bitcast<u32>(select(0i, _e2159, (_e2159 > 0i)))];
let _e2166 = (_e2157 + 1i);
let _e2168 = select(_e1792, _e2166, (_e2166 < _e1792));
let _e2174 = global_4.member[bitcast<u32>(select(0i, _e2168, (_e2168 > 0i)))];
let _e2175 = (_e2157 + 2i);
let _e2177 = select(_e1792, _e2175, (_e2175 < _e1792));
let _e2183 = global_4.member[bitcast<u32>(select(0i, _e2177, (_e2177 > 0i)))];
let _e2190 = (_e2081 + ((_e2109 - _e2081) * _e2003));
let _e2191 = (_e2090 + ((_e2118 - _e2090) * _e2003));
let _e2192 = (_e2099 + ((_e2127 - _e2099) * _e2003));
let _e2215 = (_e1524 - f32(_e1542));
let _e2217 = select(0f, _e2215, (_e2215 > 0f));
let _e2219 = select(1f, _e2217, (_e2217 < 1f));
let _e2229 = global_1.member.member_16.member_11;
phi_3780_ = vec3<f32>(((_e1927 + (((_e2190 + (((_e2137 + ((_e2165 - _e2137) * _e2003)) - _e2190) * _e2009)) - _e1927) * _e2219)) * _e2229), ((_e1928 + (((_e2191 + (((_e2146 + ((_e2174 - _e2146) * _e2003)) - _e2191) * _e2009)) - _e1928) * _e2219)) * _e2229), ((_e1929 + (((_e2192 + (((_e2155 + ((_e2183 - _e2155) * _e2003)) - _e2192) * _e2009)) - _e1929) * _e2219)) * _e2229));
}
let _e2235 = phi_3780_;
phi_3781_ = _e2235;
}
let _e2237 = phi_3781_;
phi_3782_ = _e2237;
}
let _e2239 = phi_3782_;
if _e290 {
let _e2240 = local_43;
let _e2242 = local_42;
let _e2243 = ((26i * _e2240) + _e2242);
let _e2245 = select(_e202, _e2243, (_e2243 < _e202));
let _e2250 = global_2.member[bitcast<u32>(select(0i, _e2245, (_e2245 > 0i)))];
let _e2257 = select(0i, select(select(i32(_e2250), i32(-2147483648), (_e2250 < -2147483600f)), 2147483647i, (_e2250 > 2147483500f)), (_e2250 == _e2250));
let _e2258 = local_42;
local_6 = _e2258;
local_7 = _e195;
let _e2259 = local_6;
let _e2261 = select(_e202, _e2259, (_e2259 < _e202));
let _e2266 = global_2.member[bitcast<u32>(select(0i, _e2261, (_e2261 > 0i)))];
let _e2267 = local_7;
let _e2268 = local_6;
let _e2269 = (_e2267 + _e2268);
let _e2271 = select(_e202, _e2269, (_e2269 < _e202));
let _e2276 = global_2.member[bitcast<u32>(select(0i, _e2271, (_e2271 > 0i)))];
let _e2277 = local_7;
let _e2279 = local_6;
let _e2280 = ((2i * _e2277) + _e2279);
let _e2282 = select(_e202, _e2280, (_e2280 < _e202));
let _e2287 = global_2.member[bitcast<u32>(select(0i, _e2282, (_e2282 > 0i)))];
let _e2288 = vec3<f32>(_e2266, _e2276, _e2287);
if (_e2257 < 0i) {
let _e2290 = (_e2257 == -3i);
let _e2296 = global_1.member.member_18.member_1.member.member;
let _e2301 = global_1.member.member_18.member_1.member_1;
let _e2307 = global_1.member.member_18.member.member.member;
let _e2312 = global_1.member.member_18.member.member_1;
let _e2322 = vec3<f32>(select(_e2307.member, _e2296.member, _e2290), select(_e2307.member_1, _e2296.member_1, _e2290), select(_e2307.member_2, _e2296.member_2, _e2290));
phi_4619_ = type_22(_e2288, _e2322, _e2322, vec3<f32>(select(_e2312.member, _e2301.member, _e2290), select(_e2312.member_1, _e2301.member_1, _e2290), select(_e2312.member_2, _e2301.member_2, _e2290)), 0f, false);
} else {
let _e2334 = (_e2257 * 19i);
let _e2336 = (bitcast<i32>(_e160) - 1i);
let _e2338 = select(_e2336, _e2334, (_e2334 < _e2336));
let _e2344 = global_3.member[bitcast<u32>(select(0i, _e2338, (_e2338 > 0i)))];
let _e2345 = (_e2334 + 1i);
let _e2347 = select(_e2336, _e2345, (_e2345 < _e2336));
let _e2353 = global_3.member[bitcast<u32>(select(0i, _e2347, (_e2347 > 0i)))];
let _e2354 = (_e2334 + 2i);
let _e2356 = select(_e2336, _e2354, (_e2354 < _e2336));
let _e2362 = global_3.member[bitcast<u32>(select(0i, _e2356, (_e2356 > 0i)))];
let _e2363 = (_e2334 + 3i);
let _e2365 = select(_e2336, _e2363, (_e2363 < _e2336));
let _e2371 = global_3.member[bitcast<u32>(select(0i, _e2365, (_e2365 > 0i)))];
let _e2372 = (_e2334 + 4i);
let _e2374 = select(_e2336, _e2372, (_e2372 < _e2336));
let _e2380 = global_3.member[bitcast<u32>(select(0i, _e2374, (_e2374 > 0i)))];
let _e2381 = (_e2334 + 5i);
let _e2383 = select(_e2336, _e2381, (_e2381 < _e2336));
let _e2389 = global_3.member[bitcast<u32>(select(0i, _e2383, (_e2383 > 0i)))];
let _e2390 = (_e2334 + 6i);
let _e2392 = select(_e2336, _e2390, (_e2390 < _e2336));
let _e2398 = global_3.member[bitcast<u32>(select(0i, _e2392, (_e2392 > 0i)))];
let _e2399 = (_e2334 + 7i);
let _e2401 = select(_e2336, _e2399, (_e2399 < _e2336));
let _e2407 = global_3.member[bitcast<u32>(select(0i, _e2401, (_e2401 > 0i)))];
let _e2408 = (_e2334 + 8i);
let _e2410 = select(_e2336, _e2408, (_e2408 < _e2336));
let _e2416 = global_3.member[bitcast<u32>(select(0i, _e2410, (_e2410 > 0i)))];
let _e2417 = (_e2371 - _e2344);
let _e2418 = (_e2380 - _e2353);
let _e2419 = (_e2389 - _e2362);
let _e2420 = (_e2398 - _e2344);
let _e2421 = (_e2407 - _e2353);
let _e2422 = (_e2416 - _e2362);
let _e2425 = ((_e2418 * _e2422) - (_e2419 * _e2421));
let _e2428 = ((_e2419 * _e2420) - (_e2417 * _e2422));
let _e2431 = ((_e2417 * _e2421) - (_e2418 * _e2420));
let _e2432 = (_e2371 - _e2266);
let _e2433 = (_e2380 - _e2276);
let _e2434 = (_e2389 - _e2287);
let _e2435 = (_e2398 - _e2266);
let _e2436 = (_e2407 - _e2276);
let _e2437 = (_e2416 - _e2287);
let _e2451 = (((((_e2433 * _e2437) - (_e2434 * _e2436)) * _e2425) + (((_e2434 * _e2435) - (_e2432 * _e2437)) * _e2428)) + (((_e2432 * _e2436) - (_e2433 * _e2435)) * _e2431));
let _e2453 = select(0f, _e2451, (_e2451 > 0f));
let _e2454 = (_e2344 - _e2266);
let _e2455 = (_e2353 - _e2276);
let _e2456 = (_e2362 - _e2287);
let _e2470 = (((((_e2436 * _e2456) - (_e2437 * _e2455)) * _e2425) + (((_e2437 * _e2454) - (_e2435 * _e2456)) * _e2428)) + (((_e2435 * _e2455) - (_e2436 * _e2454)) * _e2431));
let _e2472 = select(0f, _e2470, (_e2470 > 0f));
let _e2486 = (((((_e2455 * _e2434) - (_e2456 * _e2433)) * _e2425) + (((_e2456 * _e2432) - (_e2454 * _e2434)) * _e2428)) + (((_e2454 * _e2433) - (_e2455 * _e2432)) * _e2431));
let _e2488 = select(0f, _e2486, (_e2486 > 0f));
let _e2490 = ((_e2453 + _e2472) + _e2488);
let _e2492 = select(1e-30f, _e2490, (_e2490 > 1e-30f));
let _e2493 = (_e2453 / _e2492);
let _e2494 = (_e2472 / _e2492);
let _e2495 = (_e2488 / _e2492);
let _e2500 = (((_e2425 * _e2425) + (_e2428 * _e2428)) + (_e2431 * _e2431));
let _e2503 = sqrt(select(0f, _e2500, (_e2500 > 0f)));
let _e2506 = (1f / select(1e-20f, _e2503, (_e2503 > 1e-20f)));
let _e2511 = (_e2334 + 9i);
let _e2513 = select(_e2336, _e2511, (_e2511 < _e2336));
let _e2519 = global_3.member[bitcast<u32>(select(0i, _e2513, (_e2513 > 0i)))];
let _e2520 = (_e2334 + 10i);
let _e2522 = select(_e2336, _e2520, (_e2520 < _e2336));
let _e2528 = global_3.member[bitcast<u32>(select(0i, _e2522, (_e2522 > 0i)))];
let _e2529 = (_e2334 + 11i);
let _e2531 = select(_e2336, _e2529, (_e2529 < _e2336));
let _e2537 = global_3.member[bitcast<u32>(select(0i, _e2531, (_e2531 > 0i)))];
let _e2541 = (_e2334 + 12i);
let _e2543 = select(_e2336, _e2541, (_e2541 < _e2336));
let _e2549 = global_3.member[bitcast<u32>(select(0i, _e2543, (_e2543 > 0i)))];
let _e2550 = (_e2334 + 13i);
let _e2552 = select(_e2336, _e2550, (_e2550 < _e2336));
let _e2558 = global_3.member[bitcast<u32>(select(0i, _e2552, (_e2552 > 0i)))];
let _e2559 = (_e2334 + 14i);
let _e2561 = select(_e2336, _e2559, (_e2559 < _e2336));
let _e2567 = global_3.member[bitcast<u32>(select(0i, _e2561, (_e2561 > 0i)))];
let _e2574 = (_e2334 + 15i);
let _e2576 = select(_e2336, _e2574, (_e2574 < _e2336));
let _e2582 = global_3.member[bitcast<u32>(select(0i, _e2576, (_e2576 > 0i)))];
let _e2583 = (_e2334 + 16i);
let _e2585 = select(_e2336, _e2583, (_e2583 < _e2336));
let _e2591 = global_3.member[bitcast<u32>(select(0i, _e2585, (_e2585 > 0i)))];
let _e2592 = (_e2334 + 17i);
let _e2594 = select(_e2336, _e2592, (_e2592 < _e2336));
let _e2600 = global_3.member[bitcast<u32>(select(0i, _e2594, (_e2594 > 0i)))];
let _e2604 = (((_e2519 * _e2493) + (_e2549 * _e2494)) + (_e2582 * _e2495));
let _e2605 = (((_e2528 * _e2493) + (_e2558 * _e2494)) + (_e2591 * _e2495));
let _e2606 = (((_e2537 * _e2493) + (_e2567 * _e2494)) + (_e2600 * _e2495));
let _e2611 = (((_e2604 * _e2604) + (_e2605 * _e2605)) + (_e2606 * _e2606));
let _e2614 = sqrt(select(0f, _e2611, (_e2611 > 0f)));
let _e2617 = (1f / select(1e-20f, _e2614, (_e2614 > 1e-20f)));
let _e2624 = global_1.member.member_1;
let _e2627 = (_e2334 + 18i);
let _e2629 = select(_e2336, _e2627, (_e2627 < _e2336));
let _e2635 = global_3.member[bitcast<u32>(select(0i, _e2629, (_e2629 > 0i)))];
let _e2644 = (select(select(0i, select(select(i32(_e2635), i32(-2147483648), (_e2635 < -2147483600f)), 2147483647i, (_e2635 > 2147483500f)), (_e2635 == _e2635)), _e2257, ((_e2624 & 4u) != 0u)) * 10i);
let _e2646 = (bitcast<i32>(_e162) - 1i);
let _e2648 = select(_e2646, _e2644, (_e2644 < _e2646));
let _e2654 = global_5.member[bitcast<u32>(select(0i, _e2648, (_e2648 > 0i)))];
let _e2655 = (_e2644 + 1i);
let _e2657 = select(_e2646, _e2655, (_e2655 < _e2646));
let _e2663 = global_5.member[bitcast<u32>(select(0i, _e2657, (_e2657 > 0i)))];
let _e2664 = (_e2644 + 2i);
let _e2666 = select(_e2646, _e2664, (_e2664 < _e2646));
let _e2672 = global_5.member[bitcast<u32>(select(0i, _e2666, (_e2666 > 0i)))];
let _e2676 = (_e2644 + 3i);
let _e2678 = select(_e2646, _e2676, (_e2676 < _e2646));
let _e2684 = global_5.member[bitcast<u32>(select(0i, _e2678, (_e2678 > 0i)))];
let _e2685 = (_e2644 + 4i);
let _e2687 = select(_e2646, _e2685, (_e2685 < _e2646));
let _e2693 = global_5.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2694 = (_e2644 + 5i);
let _e2696 = select(_e2646, _e2694, (_e2694 < _e2646));
let _e2702 = global_5.member[bitcast<u32>(select(0i, _e2696, (_e2696 > 0i)))];
let _e2709 = (_e2644 + 6i);
let _e2711 = select(_e2646, _e2709, (_e2709 < _e2646));
let _e2717 = global_5.member[bitcast<u32>(select(0i, _e2711, (_e2711 > 0i)))];
let _e2718 = (_e2644 + 7i);
let _e2720 = select(_e2646, _e2718, (_e2718 < _e2646));
let _e2726 = global_5.member[bitcast<u32>(select(0i, _e2720, (_e2720 > 0i)))];
let _e2727 = (_e2644 + 8i);
let _e2729 = select(_e2646, _e2727, (_e2727 < _e2646));
let _e2735 = global_5.member[bitcast<u32>(select(0i, _e2729, (_e2729 > 0i)))];
let _e2743 = (_e2644 + 9i);
let _e2745 = select(_e2646, _e2743, (_e2743 < _e2646));
let _e2751 = global_5.member[bitcast<u32>(select(0i, _e2745, (_e2745 > 0i)))];
phi_4619_ = type_22(_e2288, vec3<f32>((_e2425 * _e2506), (_e2428 * _e2506), (_e2431 * _e2506)), vec3<f32>((_e2604 * _e2617), (_e2605 * _e2617), (_e2606 * _e2617)), vec3<f32>((((_e2654 * _e2493) + (_e2684 * _e2494)) + (_e2717 * _e2495)), (((_e2663 * _e2493) + (_e2693 * _e2494)) + (_e2726 * _e2495)), (((_e2672 * _e2493) + (_e2702 * _e2494)) + (_e2735 * _e2495))), _e2751, true);
}
let _e2754 = phi_4619_;
let _e2763 = (((_e2754.member_1.x * _e209) + (_e2754.member_1.y * _e220)) + (_e2754.member_1.z * _e231));
let _e2765 = select(1f, -1f, (_e2763 > 0f));
let _e2777 = select(_e2765, -(_e2765), ((((_e2754.member_2.x * _e2754.member_1.x) + (_e2754.member_2.y * _e2754.member_1.y)) + (_e2754.member_2.z * _e2754.member_1.z)) < 0f));
let _e2778 = (_e2754.member_2.x * _e2777);
let _e2779 = (_e2754.member_2.y * _e2777);
let _e2780 = (_e2754.member_2.z * _e2777);
let _e2789 = ((((_e2778 * _e209) + (_e2779 * _e220)) + (_e2780 * _e231)) > 0f);
let _e2790 = select(_e2778, (_e2754.member_1.x * _e2765), _e2789);
let _e2791 = select(_e2779, (_e2754.member_1.y * _e2765), _e2789);
let _e2792 = select(_e2780, (_e2754.member_1.z * _e2765), _e2789);
let _e2797 = global_1.member.member_19.member_2;
let _e2805 = global_1.member.member_19.member;
if (_e2805 == 0u) {
let _e2810 = global_1.member.member_19.member_1;
phi_5209_ = type_23(vec3<f32>(_e2810.member, _e2810.member_1, _e2810.member_2), vec3<f32>(_e2797.member, _e2797.member_1, _e2797.member_2));
} else {
let _e2819 = global_1.member.member_19.member_3;
let _e2824 = (_e2754.member.x - _e2819.member);
let _e2826 = (_e2754.member.y - _e2819.member_1);
let _e2828 = (_e2754.member.z - _e2819.member_2);
let _e2833 = (((_e2824 * _e2824) + (_e2826 * _e2826)) + (_e2828 * _e2828));
let _e2835 = select(1e-12f, _e2833, (_e2833 > 1e-12f));
let _e2836 = (1f / _e2835);
let _e2840 = vec3<f32>((_e2797.member * _e2836), (_e2797.member_1 * _e2836), (_e2797.member_2 * _e2836));
if (_e2805 == 2u) {
let _e2845 = global_1.member.member_19.member_1;
let _e2853 = (((_e2845.member * _e2824) + (_e2845.member_1 * _e2826)) + (_e2845.member_2 * _e2828));
let _e2856 = (1f / select(1e-20f, _e2853, (_e2853 > 1e-20f)));
let _e2861 = global_1.member.member_19.member_4.member;
let _e2870 = ((((_e2861.member * _e2824) + (_e2861.member_1 * _e2826)) + (_e2861.member_2 * _e2828)) * _e2856);
let _e2875 = global_1.member.member_19.member_4.member_1;
let _e2884 = ((((_e2875.member * _e2824) + (_e2875.member_1 * _e2826)) + (_e2875.member_2 * _e2828)) * _e2856);
let _e2889 = global_1.member.member_19.member_4.member_2;
let _e2892 = ((_e2870 * _e2870) + (_e2884 * _e2884));
let _e2901 = global_1.member.member_19.member_4.member_3;
let _e2902 = ((_e2889 - sqrt(select(0f, _e2892, (_e2892 > 0f)))) * _e2901);
let _e2904 = select(0f, _e2902, (_e2902 > 0f));
let _e2906 = select(1f, _e2904, (_e2904 < 1f));
let _e2912 = select(0f, ((_e2906 * _e2906) * (3f - (2f * _e2906))), (_e2853 > 0f));
let _e2917 = global_1.member.member_19.member_4.member_5;
if ((_e2917 > 0u) && (_e2912 > 0f)) {
let _e2921 = (0.5f / _e2889);
let _e2931 = global_1.member.member_19.member_4.member_6;
let _e2932 = bitcast<i32>(_e2931);
local_5 = bitcast<i32>(_e2917);
let _e2933 = local_5;
let _e2935 = f32((_e2933 - 1i));
let _e2937 = f32((_e2932 - 1i));
let _e2938 = local_5;
let _e2941 = (((0.5f + (_e2870 * _e2921)) * f32(_e2938)) - 0.5f);
let _e2943 = select(0f, _e2941, (_e2941 > 0f));
let _e2945 = select(_e2935, _e2943, (_e2943 < _e2935));
let _e2948 = (((0.5f - (_e2884 * _e2921)) * f32(_e2932)) - 0.5f);
let _e2950 = select(0f, _e2948, (_e2948 > 0f));
let _e2952 = select(_e2937, _e2950, (_e2950 < _e2937));
let _e2954 = select(0f, _e2945, (_e2945 > 0f));
let _e2956 = select(_e2935, _e2954, (_e2954 < _e2935));
let _e2963 = select(0i, select(select(i32(_e2956), i32(-2147483648), (_e2956 < -2147483600f)), 2147483647i, (_e2956 > 2147483500f)), (_e2956 == _e2956));
let _e2967 = (_e2963 - select(0i, 1i, (_e2956 < f32(_e2963))));
let _e2969 = select(0f, _e2952, (_e2952 > 0f));
let _e2971 = select(_e2937, _e2969, (_e2969 < _e2937));
let _e2978 = select(0i, select(select(i32(_e2971), i32(-2147483648), (_e2971 < -2147483600f)), 2147483647i, (_e2971 > 2147483500f)), (_e2971 == _e2971));
let _e2982 = (_e2978 - select(0i, 1i, (_e2971 < f32(_e2978))));
let _e2984 = (_e2945 - f32(_e2967));
let _e2986 = (_e2952 - f32(_e2982));
let _e2987 = (_e2967 + 1i);
let _e2988 = local_5;
let _e2990 = select(_e2967, _e2987, (_e2987 < _e2988));
let _e2991 = (_e2982 + 1i);
let _e2993 = select(_e2982, _e2991, (_e2991 < _e2932));
let _e2998 = global_1.member.member_19.member_4.member_4;
let _e2999 = bitcast<i32>(_e2998);
let _e3000 = local_5;
let _e3004 = (_e2999 + (3i * ((_e2982 * _e3000) + _e2967)));
let _e3006 = (bitcast<i32>(_e158) - 1i);
let _e3008 = select(_e3006, _e3004, (_e3004 < _e3006));
let _e3013 = global_4.member[bitcast<u32>(select(0i, _e3008, (_e3008 > 0i)))];
let _e3014 = (_e3004 + 1i);
let _e3016 = select(_e3006, _e3014, (_e3014 < _e3006));
let _e3021 = global_4.member[bitcast<u32>(select(0i, _e3016, (_e3016 > 0i)))];
let _e3022 = (_e3004 + 2i);
let _e3024 = select(_e3006, _e3022, (_e3022 < _e3006));
let _e3029 = global_4.member[bitcast<u32>(select(0i, _e3024, (_e3024 > 0i)))];
let _e3030 = local_5;
let _e3034 = (_e2999 + (3i * ((_e2982 * _e3030) + _e2990)));
let _e3036 = select(_e3006, _e3034, (_e3034 < _e3006));
let _e3041 = global_4.member[bitcast<u32>(select(0i, _e3036, (_e3036 > 0i)))];
let _e3042 = (_e3034 + 1i);
let _e3044 = select(_e3006, _e3042, (_e3042 < _e3006));
let _e3049 = global_4.member[bitcast<u32>(select(0i, _e3044, (_e3044 > 0i)))];
let _e3050 = (_e3034 + 2i);
let _e3052 = select(_e3006, _e3050, (_e3050 < _e3006));
let _e3057 = global_4.member[bitcast<u32>(select(0i, _e3052, (_e3052 > 0i)))];
let _e3058 = local_5;
let _e3062 = (_e2999 + (3i * ((_e2993 * _e3058) + _e2967)));
let _e3064 = select(_e3006, _e3062, (_e3062 < _e3006));
let _e3069 = global_4.member[bitcast<u32>(select(0i, _e3064, (_e3064 > 0i)))];
let _e3070 = (_e3062 + 1i);
let _e3072 = select(_e3006, _e3070, (_e3070 < _e3006));
let _e3077 = global_4.member[bitcast<u32>(select(0i, _e3072, (_e3072 > 0i)))];
let _e3078 = (_e3062 + 2i);
let _e3080 = select(_e3006, _e3078, (_e3078 < _e3006));
let _e3085 = global_4.member[bitcast<u32>(select(0i, _e3080, (_e3080 > 0i)))];
let _e3086 = local_5;
let _e3090 = (_e2999 + (3i * ((_e2993 * _e3086) + _e2990)));
let _e3092 = select(_e3006, _e3090, (_e3090 < _e3006));
let _e3097 = global_4.member[bitcast<u32>(select(0i, _e3092, (_e3092 > 0i)))];
let _e3098 = (_e3090 + 1i);
let _e3100 = select(_e3006, _e3098, (_e3098 < _e3006));
let _e3105 = global_4.member[bitcast<u32>(select(0i, _e3100, (_e3100 > 0i)))];
let _e3106 = (_e3090 + 2i);
let _e3108 = select(_e3006, _e3106, (_e3106 < _e3006));
let _e3113 = global_4.member[bitcast<u32>(select(0i, _e3108, (_e3108 > 0i)))];
let _e3120 = (_e3013 + ((_e3041 - _e3013) * _e2984));
let _e3121 = (_e3021 + ((_e3049 - _e3021) * _e2984));
let _e3122 = (_e3029 + ((_e3057 - _e3029) * _e2984));
phi_5193_ = vec3<f32>(((_e3120 + (((_e3069 + ((_e3097 - _e3069) * _e2984)) - _e3120) * _e2986)) * _e2912), ((_e3121 + (((_e3077 + ((_e3105 - _e3077) * _e2984)) - _e3121) * _e2986)) * _e2912), ((_e3122 + (((_e3085 + ((_e3113 - _e3085) * _e2984)) - _e3122) * _e2986)) * _e2912));
} else {
phi_5193_ = vec3(_e2912);
}
let _e3147 = phi_5193_;
phi_5196_ = (_e2840 * _e3147);
} else {
phi_5196_ = _e2840;
}
let _e3150 = phi_5196_;
let _e3154 = (1f / sqrt(select(0f, _e2835, (_e2835 > 0f))));
phi_5209_ = type_23(vec3<f32>((_e2824 * _e3154), (_e2826 * _e3154), (_e2828 * _e3154)), _e3150);
}
let _e3161 = phi_5209_;
let _e3172 = -((((_e2790 * _e3161.member.x) + (_e2791 * _e3161.member.y)) + (_e2792 * _e3161.member.z)));
let _e3178 = -((((_e2754.member_1.x * _e3161.member.x) + (_e2754.member_1.y * _e3161.member.y)) + (_e2754.member_1.z * _e3161.member.z)));
let _e3184 = -(_e3172);
let _e3189 = select((select(0f, _e3184, (_e3184 > 0f)) * _e2754.member_4), select(0f, _e3172, (_e3172 > 0f)), ((_e3178 * -(_e2763)) > 0f));
let _e3190 = -(_e3178);
let _e3192 = select(_e3190, _e3178, (_e3178 > _e3190));
let _e3198 = global_1.member.member_21.member_6;
let _e3212 = ((((_e3198.member.member * _e2754.member.x) + (_e3198.member.member_1 * _e2754.member.y)) + (_e3198.member.member_2 * _e2754.member.z)) + _e3198.member_1);
let _e3214 = select(1f, _e3212, (_e3212 > 1e-6f));
let _e3218 = global_1.member.member_21.member_4;
let _e3234 = global_1.member.member_21.member_5;
let _e3250 = global_1.member.member_21.member_2;
let _e3259 = -((((_e2754.member_1.x * _e3250.member) + (_e2754.member_1.y * _e3250.member_1)) + (_e2754.member_1.z * _e3250.member_2)));
let _e3260 = -(_e3259);
let _e3262 = select(_e3260, _e3259, (_e3259 > _e3260));
let _e3264 = select(1f, _e3262, (_e3262 < 1f));
let _e3266 = (1f - (_e3264 * _e3264));
let _e3273 = global_1.member.member_21.member_8;
let _e3281 = global_1.member.member_21.member_7.member;
let _e3286 = global_1.member.member_21.member_7.member_2;
let _e3288 = (_e3281 + (_e3286 * (((((_e3218.member.member * _e2754.member.x) + (_e3218.member.member_1 * _e2754.member.y)) + (_e3218.member.member_2 * _e2754.member.z)) + _e3218.member_1) / _e3214)));
let _e3293 = global_1.member.member_21.member_7.member_1;
let _e3295 = (_e3293 + (_e3286 * (((((_e3234.member.member * _e2754.member.x) + (_e3234.member.member_1 * _e2754.member.y)) + (_e3234.member.member_2 * _e2754.member.z)) + _e3234.member_1) / _e3214)));
let _e3299 = ((1f + (_e3288 * _e3288)) + (_e3295 * _e3295));
let _e3308 = global_1.member.member_21.member_9;
let _e3312 = (select(1f, -1f, (_e3178 < 0f)) * (((((1.4142135f * _e3273) * sqrt(select(0f, _e3266, (_e3266 > 0f)))) * _e3212) + (select(1f, _e3192, (_e3192 < 1f)) * sqrt(select(0f, _e3299, (_e3299 > 0f))))) * _e3308));
let _e3317 = select(0f, 1f, _e2754.member_5);
let _e3321 = (_e2754.member.x + ((_e2754.member_1.x * _e3312) * _e3317));
let _e3322 = (_e2754.member.y + ((_e2754.member_1.y * _e3312) * _e3317));
let _e3323 = (_e2754.member.z + ((_e2754.member_1.z * _e3312) * _e3317));
let _e3328 = global_1.member.member_21.member.member;
let _e3329 = bitcast<i32>(_e3328);
let _e3334 = global_1.member.member_21.member.member_1;
let _e3335 = bitcast<i32>(_e3334);
let _e3340 = global_1.member.member_21.member.member_2;
let _e3341 = bitcast<i32>(_e3340);
let _e3345 = global_1.member.member_21.member_1;
let _e3346 = bitcast<i32>(_e3345);
let _e3352 = ((((_e3198.member.member * _e3321) + (_e3198.member.member_1 * _e3322)) + (_e3198.member.member_2 * _e3323)) + _e3198.member_1);
let _e3354 = select(1f, _e3352, (_e3352 > 1e-6f));
let _e3358 = global_1.member.member_21.member_3;
let _e3369 = ((((_e3358.member.member * _e3321) + (_e3358.member.member_1 * _e3322)) + (_e3358.member.member_2 * _e3323)) + _e3358.member_1);
let _e3384 = ((((((_e3218.member.member * _e3321) + (_e3218.member.member_1 * _e3322)) + (_e3218.member.member_2 * _e3323)) + _e3218.member_1) / _e3354) - 0.5f);
let _e3385 = ((((((_e3234.member.member * _e3321) + (_e3234.member.member_1 * _e3322)) + (_e3234.member.member_2 * _e3323)) + _e3234.member_1) / _e3354) - 0.5f);
let _e3387 = f32((_e3329 - 1i));
let _e3389 = select(0f, _e3369, (_e3369 > 0f));
let _e3391 = select(_e3387, _e3389, (_e3389 < _e3387));
let _e3398 = select(0i, select(select(i32(_e3391), i32(-2147483648), (_e3391 < -2147483600f)), 2147483647i, (_e3391 > 2147483500f)), (_e3391 == _e3391));
let _e3402 = (_e3398 - select(0i, 1i, (_e3391 < f32(_e3398))));
let _e3406 = (_e3369 - f32(_e3402));
let _e3409 = select(1f, select(0f, _e3406, (_e3406 > 0f)), (_e3369 < f32(_e3329)));
let _e3410 = (_e3384 - _e3273);
let _e3411 = -(16f);
let _e3412 = f32(_e3335);
let _e3414 = select(_e3411, _e3410, (_e3410 > _e3411));
let _e3416 = select(_e3412, _e3414, (_e3414 < _e3412));
let _e3423 = select(0i, select(select(i32(_e3416), i32(-2147483648), (_e3416 < -2147483600f)), 2147483647i, (_e3416 > 2147483500f)), (_e3416 == _e3416));
let _e3429 = (_e3384 + _e3273);
let _e3432 = (f32((_e3335 - 1i)) + 16f);
let _e3434 = select(-1f, _e3429, (_e3429 > -1f));
let _e3436 = select(_e3432, _e3434, (_e3434 < _e3432));
let _e3443 = select(0i, select(select(i32(_e3436), i32(-2147483648), (_e3436 < -2147483600f)), 2147483647i, (_e3436 > 2147483500f)), (_e3436 == _e3436));
let _e3448 = (_e3385 - _e3273);
let _e3449 = f32(_e3341);
let _e3451 = select(_e3411, _e3448, (_e3448 > _e3411));
let _e3453 = select(_e3449, _e3451, (_e3451 < _e3449));
let _e3460 = select(0i, select(select(i32(_e3453), i32(-2147483648), (_e3453 < -2147483600f)), 2147483647i, (_e3453 > 2147483500f)), (_e3453 == _e3453));
let _e3466 = (_e3385 + _e3273);
let _e3469 = (f32((_e3341 - 1i)) + 16f);
let _e3471 = select(-1f, _e3466, (_e3466 > -1f));
let _e3473 = select(_e3469, _e3471, (_e3471 < _e3469));
let _e3480 = select(0i, select(select(i32(_e3473), i32(-2147483648), (_e3473 < -2147483600f)), 2147483647i, (_e3473 > 2147483500f)), (_e3473 == _e3473));
let _e3488 = bitcast<i32>(((_e3328 + 2u) >> bitcast<u32>(1i)));
let _e3490 = ((_e3335 * _e3341) * _e3488);
phi_5665_ = 0f;
phi_5668_ = vec3<f32>(0f, 0f, 0f);
phi_5670_ = ((_e3460 - select(0i, 1i, (_e3453 < f32(_e3460)))) + 1i);
loop {
let _e3492 = phi_5665_;
let _e3494 = phi_5668_;
let _e3496 = phi_5670_;
local_76 = _e3492;
local_77 = _e3492;
local_78 = _e3494;
local_79 = _e3494;
local_80 = _e3494;
let _e3497 = (_e3496 <= (_e3480 - select(0i, 1i, (_e3473 < f32(_e3480)))));
if _e3497 {
let _e3503 = (_e3273 - bitcast<f32>((bitcast<u32>((f32(_e3496) - _e3385)) & 2147483647u)));
phi_5685_ = ((_e3423 - select(0i, 1i, (_e3416 < f32(_e3423)))) + 1i);
phi_5688_ = _e3492;
phi_5690_ = _e3494;
loop {
let _e3505 = phi_5685_;
let _e3507 = phi_5688_;
let _e3509 = phi_5690_;
local_118 = _e3507;
local_119 = _e3509;
let _e3510 = (_e3505 <= (_e3443 - select(0i, 1i, (_e3436 < f32(_e3443)))));
if _e3510 {
let _e3516 = (_e3273 - bitcast<f32>((bitcast<u32>((f32(_e3505) - _e3384)) & 2147483647u)));
let _e3521 = (select(0f, _e3516, (_e3516 > 0f)) * select(0f, _e3503, (_e3503 > 0f)));
if ((((_e3505 >= 0i) && (_e3505 < _e3335)) && (_e3496 >= 0i)) && (_e3496 < _e3341)) {
let _e3531 = (((_e3496 * _e3335) + _e3505) * _e3488);
let _e3533 = (2i * _e3402);
let _e3534 = ((4i * _e3531) + _e3533);
let _e3536 = (_e3534 >> bitcast<u32>(2i));
let _e3539 = bitcast<u32>(((_e3534 & 3i) * 8i));
let _e3541 = (bitcast<i32>(_e164) - 1i);
let _e3543 = select(_e3541, _e3536, (_e3536 < _e3541));
let _e3549 = global_6.member[bitcast<u32>(select(0i, _e3543, (_e3543 > 0i)))];
let _e3553 = (_e3536 + 1i);
let _e3555 = select(_e3541, _e3553, (_e3553 < _e3541));
let _e3561 = global_6.member[bitcast<u32>(select(0i, _e3555, (_e3555 > 0i)))];
let _e3568 = ((_e3549 >> bitcast<u32>((_e3539 & 31u))) | ((_e3561 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3539) & 31u))));
let _e3571 = f32(bitcast<i32>((_e3568 & 65535u)));
let _e3579 = (1f / 65535f);
let _e3581 = (_e3521 * ((_e3571 + ((f32(bitcast<i32>((_e3568 >> bitcast<u32>(16i)))) - _e3571) * _e3409)) * _e3579));
let _e3583 = (_e3509.x + _e3581);
if (_e3346 > 1i) {
let _e3587 = ((4i * (_e3531 + _e3490)) + _e3533);
let _e3589 = (_e3587 >> bitcast<u32>(2i));
let _e3592 = bitcast<u32>(((_e3587 & 3i) * 8i));
let _e3594 = select(_e3541, _e3589, (_e3589 < _e3541));
let _e3600 = global_6.member[bitcast<u32>(select(0i, _e3594, (_e3594 > 0i)))];
let _e3604 = (_e3589 + 1i);
let _e3606 = select(_e3541, _e3604, (_e3604 < _e3541));
let _e3612 = global_6.member[bitcast<u32>(select(0i, _e3606, (_e3606 > 0i)))];
let _e3619 = ((_e3600 >> bitcast<u32>((_e3592 & 31u))) | ((_e3612 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3592) & 31u))));
let _e3622 = f32(bitcast<i32>((_e3619 & 65535u)));
let _e3637 = ((4i * (_e3531 + (2i * _e3490))) + _e3533);
let _e3639 = (_e3637 >> bitcast<u32>(2i));
let _e3642 = bitcast<u32>(((_e3637 & 3i) * 8i));
let _e3644 = select(_e3541, _e3639, (_e3639 < _e3541));
let _e3650 = global_6.member[bitcast<u32>(select(0i, _e3644, (_e3644 > 0i)))];
let _e3654 = (_e3639 + 1i);
let _e3656 = select(_e3541, _e3654, (_e3654 < _e3541));
let _e3662 = global_6.member[bitcast<u32>(select(0i, _e3656, (_e3656 > 0i)))];
let _e3669 = ((_e3650 >> bitcast<u32>((_e3642 & 31u))) | ((_e3662 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3642) & 31u))));
let _e3672 = f32(bitcast<i32>((_e3669 & 65535u)));
phi_5923_ = vec3<f32>(_e3583, (_e3509.y + (_e3521 * ((_e3622 + ((f32(bitcast<i32>((_e3619 >> bitcast<u32>(16i)))) - _e3622) * _e3409)) * _e3579))), (_e3509.z + (_e3521 * ((_e3672 + ((f32(bitcast<i32>((_e3669 >> bitcast<u32>(16i)))) - _e3672) * _e3409)) * _e3579))));
} else {
phi_5923_ = vec3<f32>(_e3583, (_e3509.y + _e3581), (_e3509.z + _e3581));
}
let _e3691 = phi_5923_;
phi_5933_ = _e3691;
} else {
phi_5933_ = vec3<f32>((_e3509.x + _e3521), (_e3509.y + _e3521), (_e3509.z + _e3521));
}
let _e3700 = phi_5933_;
phi_5686_ = (_e3505 + 1i);
phi_5689_ = (_e3507 + _e3521);
phi_5691_ = _e3700;
} else {
phi_5686_ = i32();
phi_5689_ = f32();
phi_5691_ = vec3<f32>();
}
let _e3704 = phi_5686_;
let _e3706 = phi_5689_;
let _e3708 = phi_5691_;
continue;
continuing {
phi_5685_ = _e3704;
phi_5688_ = _e3706;
phi_5690_ = _e3708;
break if !(_e3510);
}
}
let _e6781 = local_118;
phi_5666_ = _e6781;
let _e6784 = local_119;
phi_5669_ = _e6784;
phi_5671_ = (_e3496 + 1i);
} else {
phi_5666_ = f32();
phi_5669_ = vec3<f32>();
phi_5671_ = i32();
}
let _e3712 = phi_5666_;
let _e3714 = phi_5669_;
let _e3716 = phi_5671_;
continue;
continuing {
phi_5665_ = _e3712;
phi_5668_ = _e3714;
phi_5670_ = _e3716;
break if !(_e3497);
}
}
let _e3720 = local_76;
let _e3724 = (((_e3346 == 0i) || (_e3720 <= 0f)) || (_e3352 <= 1e-6f));
let _e3726 = local_77;
let _e3728 = (1f / select(_e3726, 1f, _e3724));
let _e3730 = local_78;
let _e3735 = local_79;
let _e3740 = local_80;
let _e3756 = global_1.member.member_20;
if (_e276 == 0f) {
phi_6055_ = vec3<f32>(_e2790, _e2791, _e2792);
} else {
phi_6055_ = _e325;
}
let _e3768 = phi_6055_;
phi_6056_ = _e3768;
phi_6057_ = (_e2754.member_3 * vec3<f32>(((_e3161.member_1.x * (select((_e3730.x * _e3728), 1f, _e3724) * _e3189)) + _e3756.member), ((_e3161.member_1.y * (select((_e3735.y * _e3728), 1f, _e3724) * _e3189)) + _e3756.member_1), ((_e3161.member_1.z * (select((_e3740.z * _e3728), 1f, _e3724) * _e3189)) + _e3756.member_2)));
} else {
phi_6056_ = _e325;
phi_6057_ = _e2239;
}
let _e3770 = phi_6056_;
let _e3772 = phi_6057_;
let _e3779 = local_43;
let _e3781 = local_42;
let _e3782 = ((21i * _e3779) + _e3781);
let _e3784 = select(_e202, _e3782, (_e3782 < _e202));
let _e3789 = global_2.member[bitcast<u32>(select(0i, _e3784, (_e3784 > 0i)))];
local_3 = _e189;
local_4 = _e195;
let _e3790 = local_4;
let _e3792 = local_3;
let _e3793 = ((9i * _e3790) + _e3792);
let _e3795 = select(_e202, _e3793, (_e3793 < _e202));
let _e3800 = global_2.member[bitcast<u32>(select(0i, _e3795, (_e3795 > 0i)))];
let _e3801 = local_4;
let _e3803 = local_3;
let _e3804 = ((10i * _e3801) + _e3803);
let _e3806 = select(_e202, _e3804, (_e3804 < _e202));
let _e3811 = global_2.member[bitcast<u32>(select(0i, _e3806, (_e3806 > 0i)))];
let _e3812 = local_4;
let _e3814 = local_3;
let _e3815 = ((11i * _e3812) + _e3814);
let _e3817 = select(_e202, _e3815, (_e3815 < _e202));
let _e3822 = global_2.member[bitcast<u32>(select(0i, _e3817, (_e3817 > 0i)))];
let _e3828 = (2f * (((_e1079 * _e3800) + (_e1080 * _e3811)) + (_e1081 * _e3822)));
let _e3832 = (_e1079 - (_e3800 * _e3828));
let _e3833 = (_e1080 - (_e3811 * _e3828));
let _e3834 = (_e1081 - (_e3822 * _e3828));
let _e3835 = (_e706 - _e537);
let _e3836 = (_e707 - _e538);
let _e3837 = (_e708 - _e539);
let _e3842 = (((_e3835 * _e3835) + (_e3836 * _e3836)) + (_e3837 * _e3837));
let _e3847 = (_e706 - _e3832);
let _e3848 = (_e707 - _e3833);
let _e3849 = (_e708 - _e3834);
let _e3854 = (((_e3847 * _e3847) + (_e3848 * _e3848)) + (_e3849 * _e3849));
let _e3858 = (_e3832 - _e537);
let _e3859 = (_e3833 - _e538);
let _e3860 = (_e3834 - _e539);
let _e3865 = (((_e3858 * _e3858) + (_e3859 * _e3859)) + (_e3860 * _e3860));
let _e3873 = select(select(_e1092, select(sqrt(select(0f, _e3865, (_e3865 > 0f))), sqrt(select(0f, _e3854, (_e3854 > 0f))), _e630), (_e418 || _e630)), (0.5f * sqrt(select(0f, _e3842, (_e3842 > 0f)))), (_e418 && _e630));
let _e3874 = (_e1056 - _e886);
let _e3875 = (_e1057 - _e887);
let _e3876 = (_e1058 - _e888);
let _e3881 = (((_e3874 * _e3874) + (_e3875 * _e3875)) + (_e3876 * _e3876));
let _e3886 = (_e1056 - _e3832);
let _e3887 = (_e1057 - _e3833);
let _e3888 = (_e1058 - _e3834);
let _e3893 = (((_e3886 * _e3886) + (_e3887 * _e3887)) + (_e3888 * _e3888));
let _e3897 = (_e3832 - _e886);
let _e3898 = (_e3833 - _e887);
let _e3899 = (_e3834 - _e888);
let _e3904 = (((_e3897 * _e3897) + (_e3898 * _e3898)) + (_e3899 * _e3899));
let _e3912 = select(select(_e1092, select(sqrt(select(0f, _e3904, (_e3904 > 0f))), sqrt(select(0f, _e3893, (_e3893 > 0f))), _e979), (_e800 || _e979)), (0.5f * sqrt(select(0f, _e3881, (_e3881 > 0f)))), (_e800 && _e979));
let _e3914 = select(_e3912, _e3873, (_e3873 > _e3912));
let _e3919 = (((_e1178.member * _e3832) + (_e1178.member_1 * _e3833)) + (_e1178.member_2 * _e3834));
let _e3924 = (((_e1190.member * _e3832) + (_e1190.member_1 * _e3833)) + (_e1190.member_2 * _e3834));
let _e3929 = (((_e1202.member * _e3832) + (_e1202.member_1 * _e3833)) + (_e1202.member_2 * _e3834));
if _e1230 {
phi_7842_ = _e1222;
} else {
if (_e1214 == 1u) {
let _e3932 = select(-1f, _e3929, (_e3929 > -1f));
let _e3934 = select(1f, _e3932, (_e3932 < 1f));
if (_e3934 > 0f) {
phi_6457_ = _e1222;
} else {
let _e3939 = global_1.member.member_16.member_9;
phi_6457_ = vec3<f32>(_e3939.member, _e3939.member_1, _e3939.member_2);
}
let _e3945 = phi_6457_;
let _e3954 = bitcast<f32>((bitcast<u32>(_e3934) & 2147483647u));
let _e3957 = sqrt(select(0f, _e3954, (_e3954 > 0f)));
phi_7841_ = vec3<f32>((_e1226.member + ((_e3945.x - _e1226.member) * _e3957)), (_e1226.member_1 + ((_e3945.y - _e1226.member_1) * _e3957)), (_e1226.member_2 + ((_e3945.z - _e1226.member_2) * _e3957)));
} else {
if (_e1214 == 2u) {
let _e3969 = global_1.member.member_16.member_10;
let _e3970 = (_e3914 / _e3969);
let _e3972 = select(1e-4f, _e3970, (_e3970 > 1e-4f));
let _e3975 = bitcast<f32>((bitcast<u32>(_e3919) & 2147483647u));
let _e3978 = bitcast<f32>((bitcast<u32>(_e3924) & 2147483647u));
let _e3982 = select(_e3978, _e3975, (_e3975 > _e3978));
let _e3985 = (select(_e3978, _e3975, (_e3975 < _e3978)) / select(1.1754944e-38f, _e3982, (_e3982 > 1.1754944e-38f)));
let _e3986 = (_e3985 > 0.41421357f);
let _e3990 = select(_e3985, ((_e3985 - 1f) / (_e3985 + 1f)), _e3986);
let _e3991 = (_e3990 * _e3990);
let _e4006 = (select(0f, 0.7853982f, _e3986) + (_e3990 + ((_e3990 * _e3991) * (-0.33333334f + (_e3991 * (0.2f + (_e3991 * (-0.14285713f + (_e3991 * (0.11111111f + (_e3991 * (-0.09090909f + (_e3991 * 0.0585f)))))))))))));
let _e4009 = select(_e4006, (1.5707964f - _e4006), (_e3978 > _e3975));
let _e4012 = select(_e4009, (3.1415927f - _e4009), (_e3919 < 0f));
let _e4018 = (1f - (_e3929 * _e3929));
let _e4021 = sqrt(select(0f, _e4018, (_e4018 > 0f)));
let _e4024 = (_e3972 / select(1e-3f, _e4021, (_e4021 > 1e-3f)));
let _e4025 = ((select(_e4012, -(_e4012), (_e3924 < 0f)) / _e3969) * 0.5f);
let _e4027 = select(-8e6f, _e4025, (_e4025 > -8e6f));
let _e4029 = select(8e6f, _e4027, (_e4027 < 8e6f));
let _e4036 = select(0i, select(select(i32(_e4029), i32(-2147483648), (_e4029 < -2147483600f)), 2147483647i, (_e4029 > 2147483500f)), (_e4029 == _e4029));
let _e4043 = ((_e4025 - f32((_e4036 - select(0i, 1i, (_e4029 < f32(_e4036)))))) * 2f);
let _e4051 = ((select(select((_e4043 - 2f), (1f - _e4043), (_e4043 < 1.5f)), _e4043, (_e4043 < 0.5f)) * 2f) / _e4024);
let _e4053 = select(-1f, _e4051, (_e4051 > -1f));
let _e4056 = (2f - _e4024);
let _e4058 = select(0f, _e4056, (_e4056 > 0f));
let _e4063 = select(-1f, _e3929, (_e3929 > -1f));
let _e4065 = select(1f, _e4063, (_e4063 < 1f));
let _e4068 = ((1f - _e4065) * (1f + _e4065));
let _e4071 = sqrt(select(0f, _e4068, (_e4068 > 0f)));
let _e4074 = bitcast<f32>((bitcast<u32>(_e4071) & 2147483647u));
let _e4077 = bitcast<f32>((bitcast<u32>(_e4065) & 2147483647u));
let _e4081 = select(_e4077, _e4074, (_e4074 > _e4077));
let _e4084 = (select(_e4077, _e4074, (_e4074 < _e4077)) / select(1.1754944e-38f, _e4081, (_e4081 > 1.1754944e-38f)));
let _e4085 = (_e4084 > 0.41421357f);
let _e4089 = select(_e4084, ((_e4084 - 1f) / (_e4084 + 1f)), _e4085);
let _e4090 = (_e4089 * _e4089);
let _e4105 = (select(0f, 0.7853982f, _e4085) + (_e4089 + ((_e4089 * _e4090) * (-0.33333334f + (_e4090 * (0.2f + (_e4090 * (-0.14285713f + (_e4090 * (0.11111111f + (_e4090 * (-0.09090909f + (_e4090 * 0.0585f)))))))))))));
let _e4108 = select(_e4105, (1.5707964f - _e4105), (_e4077 > _e4074));
let _e4111 = select(_e4108, (3.1415927f - _e4108), (_e4071 < 0f));
let _e4116 = ((select(_e4111, -(_e4111), (_e4065 < 0f)) / _e3969) * 0.5f);
let _e4118 = select(-8e6f, _e4116, (_e4116 > -8e6f));
let _e4120 = select(8e6f, _e4118, (_e4118 < 8e6f));
let _e4127 = select(0i, select(select(i32(_e4120), i32(-2147483648), (_e4120 < -2147483600f)), 2147483647i, (_e4120 > 2147483500f)), (_e4120 == _e4120));
let _e4134 = ((_e4116 - f32((_e4127 - select(0i, 1i, (_e4120 < f32(_e4127)))))) * 2f);
let _e4142 = ((select(select((_e4134 - 2f), (1f - _e4134), (_e4134 < 1.5f)), _e4134, (_e4134 < 0.5f)) * 2f) / _e3972);
let _e4144 = select(-1f, _e4142, (_e4142 > -1f));
let _e4147 = (2f - _e3972);
let _e4149 = select(0f, _e4147, (_e4147 > 0f));
let _e4155 = (0.5f + ((0.5f * (select(1f, _e4053, (_e4053 < 1f)) * select(1f, _e4058, (_e4058 < 1f)))) * (select(1f, _e4144, (_e4144 < 1f)) * select(1f, _e4149, (_e4149 < 1f)))));
phi_7840_ = vec3<f32>((_e1218.member + ((_e1226.member - _e1218.member) * _e4155)), (_e1218.member_1 + ((_e1226.member_1 - _e1218.member_1) * _e4155)), (_e1218.member_2 + ((_e1226.member_2 - _e1218.member_2) * _e4155)));
} else {
let _e4169 = global_1.member.member_16.member_1;
let _e4170 = bitcast<i32>(_e4169);
let _e4175 = global_1.member.member_16.member_3;
let _e4177 = f32(bitcast<i32>(_e4175));
let _e4179 = (2f * 3.1415927f);
let _e4180 = ((_e3914 * f32(_e4170)) / _e4179);
let _e4182 = select(1e-6f, _e4180, (_e4180 > 1e-6f));
let _e4185 = bitcast<u32>(select(1.1754944e-38f, _e4182, (_e4182 > 1.1754944e-38f)));
let _e4186 = (_e4185 & 8388607u);
let _e4188 = select(0u, 1u, (_e4186 > 3474675u));
let _e4199 = bitcast<f32>((_e4186 | ((127u - _e4188) << bitcast<u32>(23i))));
let _e4202 = ((_e4199 - 1f) / (_e4199 + 1f));
let _e4203 = (_e4202 * _e4202);
let _e4218 = (f32(((bitcast<i32>((_e4185 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e4188))) + (((2f * _e4202) + ((_e4202 * _e4203) * (0.6666667f + (_e4203 * (0.4f + (_e4203 * (0.2857143f + (_e4203 * (0.22222222f + (_e4203 * 0.18181819f)))))))))) * 1.442695f));
let _e4219 = (_e4177 - 1f);
let _e4221 = select(0f, _e4218, (_e4218 > 0f));
let _e4223 = select(_e4219, _e4221, (_e4221 < _e4219));
let _e4224 = (_e4177 - 2f);
let _e4226 = select(0f, _e4224, (_e4224 > 0f));
let _e4228 = select(0f, _e4223, (_e4223 > 0f));
let _e4230 = select(_e4226, _e4228, (_e4228 < _e4226));
let _e4237 = select(0i, select(select(i32(_e4230), i32(-2147483648), (_e4230 < -2147483600f)), 2147483647i, (_e4230 > 2147483500f)), (_e4230 == _e4230));
let _e4241 = (_e4237 - select(0i, 1i, (_e4230 < f32(_e4237))));
let _e4244 = bitcast<f32>((bitcast<u32>(_e3924) & 2147483647u));
let _e4247 = bitcast<f32>((bitcast<u32>(_e3919) & 2147483647u));
let _e4251 = select(_e4247, _e4244, (_e4244 > _e4247));
let _e4254 = (select(_e4247, _e4244, (_e4244 < _e4247)) / select(1.1754944e-38f, _e4251, (_e4251 > 1.1754944e-38f)));
let _e4255 = (_e4254 > 0.41421357f);
let _e4259 = select(_e4254, ((_e4254 - 1f) / (_e4254 + 1f)), _e4255);
let _e4260 = (_e4259 * _e4259);
let _e4275 = (select(0f, 0.7853982f, _e4255) + (_e4259 + ((_e4259 * _e4260) * (-0.33333334f + (_e4260 * (0.2f + (_e4260 * (-0.14285713f + (_e4260 * (0.11111111f + (_e4260 * (-0.09090909f + (_e4260 * 0.0585f)))))))))))));
let _e4278 = select(_e4275, (1.5707964f - _e4275), (_e4247 > _e4244));
let _e4281 = select(_e4278, (3.1415927f - _e4278), (_e3924 < 0f));
let _e4286 = (0.5f - (select(_e4281, -(_e4281), (_e3919 < 0f)) / _e4179));
let _e4288 = select(-1f, _e3929, (_e3929 > -1f));
let _e4290 = select(1f, _e4288, (_e4288 < 1f));
let _e4293 = ((1f - _e4290) * (1f + _e4290));
let _e4296 = sqrt(select(0f, _e4293, (_e4293 > 0f)));
let _e4299 = bitcast<f32>((bitcast<u32>(_e4296) & 2147483647u));
let _e4302 = bitcast<f32>((bitcast<u32>(_e4290) & 2147483647u));
let _e4306 = select(_e4302, _e4299, (_e4299 > _e4302));
let _e4309 = (select(_e4302, _e4299, (_e4299 < _e4302)) / select(1.1754944e-38f, _e4306, (_e4306 > 1.1754944e-38f)));
let _e4310 = (_e4309 > 0.41421357f);
let _e4314 = select(_e4309, ((_e4309 - 1f) / (_e4309 + 1f)), _e4310);
let _e4315 = (_e4314 * _e4314);
let _e4330 = (select(0f, 0.7853982f, _e4310) + (_e4314 + ((_e4314 * _e4315) * (-0.33333334f + (_e4315 * (0.2f + (_e4315 * (-0.14285713f + (_e4315 * (0.11111111f + (_e4315 * (-0.09090909f + (_e4315 * 0.0585f)))))))))))));
let _e4333 = select(_e4330, (1.5707964f - _e4330), (_e4302 > _e4299));
let _e4336 = select(_e4333, (3.1415927f - _e4333), (_e4296 < 0f));
let _e4341 = (0.5f - (select(_e4336, -(_e4336), (_e4290 < 0f)) / 3.1415927f));
let _e4345 = global_1.member.member_16.member_2;
let _e4346 = bitcast<i32>(_e4345);
phi_7059_ = 0i;
phi_7062_ = 0i;
phi_7064_ = _e4346;
phi_7066_ = _e4170;
loop {
let _e4348 = phi_7059_;
let _e4350 = phi_7062_;
let _e4352 = phi_7064_;
let _e4354 = phi_7066_;
local_81 = _e4354;
local_82 = _e4352;
local_83 = _e4354;
local_84 = _e4354;
local_85 = _e4354;
local_86 = _e4354;
local_87 = _e4354;
local_88 = _e4354;
local_89 = _e4352;
local_90 = _e4352;
local_91 = _e4352;
local_92 = _e4352;
local_93 = _e4354;
local_94 = _e4350;
local_95 = _e4354;
local_96 = _e4350;
let _e4355 = (_e4348 < _e4241);
if _e4355 {
if (_e4354 > 1i) {
phi_7081_ = (_e4354 >> bitcast<u32>(1i));
} else {
phi_7081_ = 1i;
}
let _e4362 = phi_7081_;
if (_e4352 > 1i) {
phi_7087_ = (_e4352 >> bitcast<u32>(1i));
} else {
phi_7087_ = 1i;
}
let _e4367 = phi_7087_;
phi_7060_ = (_e4348 + 1i);
phi_7063_ = (_e4350 + (_e4354 * _e4352));
phi_7065_ = _e4367;
phi_7067_ = _e4362;
} else {
phi_7060_ = i32();
phi_7063_ = i32();
phi_7065_ = i32();
phi_7067_ = i32();
}
let _e4370 = phi_7060_;
let _e4372 = phi_7063_;
let _e4374 = phi_7065_;
let _e4376 = phi_7067_;
continue;
continuing {
phi_7059_ = _e4370;
phi_7062_ = _e4372;
phi_7064_ = _e4374;
phi_7066_ = _e4376;
break if !(_e4355);
}
}
let _e4379 = local_81;
let _e4380 = f32(_e4379);
let _e4382 = ((_e4286 * _e4380) - 0.5f);
let _e4384 = local_82;
let _e4385 = f32(_e4384);
let _e4387 = ((_e4341 * _e4385) - 0.5f);
let _e4389 = select(-1f, _e4382, (_e4382 > -1f));
let _e4391 = select(_e4380, _e4389, (_e4389 < _e4380));
let _e4398 = select(0i, select(select(i32(_e4391), i32(-2147483648), (_e4391 < -2147483600f)), 2147483647i, (_e4391 > 2147483500f)), (_e4391 == _e4391));
let _e4402 = (_e4398 - select(0i, 1i, (_e4391 < f32(_e4398))));
let _e4404 = select(-1f, _e4387, (_e4387 > -1f));
let _e4406 = select(_e4385, _e4404, (_e4404 < _e4385));
let _e4413 = select(0i, select(select(i32(_e4406), i32(-2147483648), (_e4406 < -2147483600f)), 2147483647i, (_e4406 > 2147483500f)), (_e4406 == _e4406));
let _e4417 = (_e4413 - select(0i, 1i, (_e4406 < f32(_e4413))));
let _e4419 = (_e4382 - f32(_e4402));
let _e4421 = (_e4387 - f32(_e4417));
let _e4423 = select(0f, _e4421, (_e4421 > 0f));
let _e4425 = select(1f, _e4423, (_e4423 < 1f));
if (_e4402 < 0i) {
let _e4428 = local_83;
phi_7162_ = (_e4402 + _e4428);
} else {
phi_7162_ = _e4402;
}
let _e4431 = phi_7162_;
let _e4433 = local_84;
if (_e4431 >= _e4433) {
let _e4436 = local_85;
phi_7168_ = (_e4431 - _e4436);
} else {
phi_7168_ = _e4431;
}
let _e4439 = phi_7168_;
let _e4440 = (_e4402 + 1i);
if (_e4440 < 0i) {
let _e4443 = local_86;
phi_7175_ = (_e4440 + _e4443);
} else {
phi_7175_ = _e4440;
}
let _e4446 = phi_7175_;
let _e4448 = local_87;
if (_e4446 >= _e4448) {
let _e4451 = local_88;
phi_7181_ = (_e4446 - _e4451);
} else {
phi_7181_ = _e4446;
}
let _e4454 = phi_7181_;
let _e4456 = select(_e4417, 0i, (_e4417 < 0i));
let _e4458 = local_89;
if (_e4456 >= _e4458) {
let _e4461 = local_90;
phi_7192_ = (_e4461 - 1i);
} else {
phi_7192_ = _e4456;
}
let _e4464 = phi_7192_;
let _e4465 = (_e4417 + 1i);
let _e4467 = select(_e4465, 0i, (_e4465 < 0i));
let _e4469 = local_91;
if (_e4467 >= _e4469) {
let _e4472 = local_92;
phi_7204_ = (_e4472 - 1i);
} else {
phi_7204_ = _e4467;
}
let _e4475 = phi_7204_;
let _e4477 = local_93;
let _e4480 = local_94;
let _e4481 = (_e4480 + (_e4464 * _e4477));
let _e4483 = local_95;
let _e4486 = local_96;
let _e4487 = (_e4486 + (_e4475 * _e4483));
let _e4489 = (3i * (_e4481 + _e4439));
let _e4491 = (bitcast<i32>(_e158) - 1i);
let _e4493 = select(_e4491, _e4489, (_e4489 < _e4491));
let _e4499 = global_4.member[bitcast<u32>(select(0i, _e4493, (_e4493 > 0i)))];
let _e4500 = (_e4489 + 1i);
let _e4502 = select(_e4491, _e4500, (_e4500 < _e4491));
let _e4508 = global_4.member[bitcast<u32>(select(0i, _e4502, (_e4502 > 0i)))];
let _e4509 = (_e4489 + 2i);
let _e4511 = select(_e4491, _e4509, (_e4509 < _e4491));
let _e4517 = global_4.member[bitcast<u32>(select(0i, _e4511, (_e4511 > 0i)))];
let _e4519 = (3i * (_e4481 + _e4454));
let _e4521 = select(_e4491, _e4519, (_e4519 < _e4491));
let _e4527 = global_4.member[bitcast<u32>(select(0i, _e4521, (_e4521 > 0i)))];
let _e4528 = (_e4519 + 1i);
let _e4530 = select(_e4491, _e4528, (_e4528 < _e4491));
let _e4536 = global_4.member[bitcast<u32>(select(0i, _e4530, (_e4530 > 0i)))];
let _e4537 = (_e4519 + 2i);
let _e4539 = select(_e4491, _e4537, (_e4537 < _e4491));
let _e4545 = global_4.member[bitcast<u32>(select(0i, _e4539, (_e4539 > 0i)))];
let _e4547 = (3i * (_e4487 + _e4439));
let _e4549 = select(_e4491, _e4547, (_e4547 < _e4491));
let _e4555 = global_4.member[bitcast<u32>(select(0i, _e4549, (_e4549 > 0i)))];
let _e4556 = (_e4547 + 1i);
let _e4558 = select(_e4491, _e4556, (_e4556 < _e4491));
let _e4564 = global_4.member[bitcast<u32>(select(0i, _e4558, (_e4558 > 0i)))];
let _e4565 = (_e4547 + 2i);
let _e4567 = select(_e4491, _e4565, (_e4565 < _e4491));
let _e4573 = global_4.member[bitcast<u32>(select(0i, _e4567, (_e4567 > 0i)))];
let _e4575 = (3i * (_e4487 + _e4454));
let _e4577 = select(_e4491, _e4575, (_e4575 < _e4491));
let _e4583 = global_4.member[bitcast<u32>(select(0i, _e4577, (_e4577 > 0i)))];
let _e4584 = (_e4575 + 1i);
let _e4586 = select(_e4491, _e4584, (_e4584 < _e4491));
let _e4592 = global_4.member[bitcast<u32>(select(0i, _e4586, (_e4586 > 0i)))];
let _e4593 = (_e4575 + 2i);
let _e4595 = select(_e4491, _e4593, (_e4593 < _e4491));
let _e4601 = global_4.member[bitcast<u32>(select(0i, _e4595, (_e4595 > 0i)))];
let _e4608 = (_e4499 + ((_e4527 - _e4499) * _e4419));
let _e4609 = (_e4508 + ((_e4536 - _e4508) * _e4419));
let _e4610 = (_e4517 + ((_e4545 - _e4517) * _e4419));
let _e4626 = (_e4608 + (((_e4555 + ((_e4583 - _e4555) * _e4419)) - _e4608) * _e4425));
let _e4627 = (_e4609 + (((_e4564 + ((_e4592 - _e4564) * _e4419)) - _e4609) * _e4425));
let _e4628 = (_e4610 + (((_e4573 + ((_e4601 - _e4573) * _e4419)) - _e4610) * _e4425));
phi_7440_ = 0i;
phi_7443_ = 0i;
phi_7445_ = _e4346;
phi_7447_ = _e4170;
loop {
let _e4631 = phi_7440_;
let _e4633 = phi_7443_;
let _e4635 = phi_7445_;
let _e4637 = phi_7447_;
local_97 = _e4637;
local_98 = _e4635;
local_99 = _e4637;
local_100 = _e4637;
local_101 = _e4637;
local_102 = _e4637;
local_103 = _e4637;
local_104 = _e4637;
local_105 = _e4635;
local_106 = _e4635;
local_107 = _e4635;
local_108 = _e4635;
local_109 = _e4637;
local_110 = _e4633;
local_111 = _e4637;
local_112 = _e4633;
let _e4638 = (_e4631 < (_e4241 + 1i));
if _e4638 {
if (_e4637 > 1i) {
phi_7462_ = (_e4637 >> bitcast<u32>(1i));
} else {
phi_7462_ = 1i;
}
let _e4645 = phi_7462_;
if (_e4635 > 1i) {
phi_7468_ = (_e4635 >> bitcast<u32>(1i));
} else {
phi_7468_ = 1i;
}
let _e4650 = phi_7468_;
phi_7441_ = (_e4631 + 1i);
phi_7444_ = (_e4633 + (_e4637 * _e4635));
phi_7446_ = _e4650;
phi_7448_ = _e4645;
} else {
phi_7441_ = i32();
phi_7444_ = i32();
phi_7446_ = i32();
phi_7448_ = i32();
}
let _e4653 = phi_7441_;
let _e4655 = phi_7444_;
let _e4657 = phi_7446_;
let _e4659 = phi_7448_;
continue;
continuing {
phi_7440_ = _e4653;
phi_7443_ = _e4655;
phi_7445_ = _e4657;
phi_7447_ = _e4659;
break if !(_e4638);
}
}
let _e4662 = local_97;
let _e4663 = f32(_e4662);
let _e4665 = ((_e4286 * _e4663) - 0.5f);
let _e4667 = local_98;
let _e4668 = f32(_e4667);
let _e4670 = ((_e4341 * _e4668) - 0.5f);
let _e4672 = select(-1f, _e4665, (_e4665 > -1f));
let _e4674 = select(_e4663, _e4672, (_e4672 < _e4663));
let _e4681 = select(0i, select(select(i32(_e4674), i32(-2147483648), (_e4674 < -2147483600f)), 2147483647i, (_e4674 > 2147483500f)), (_e4674 == _e4674));
let _e4685 = (_e4681 - select(0i, 1i, (_e4674 < f32(_e4681))));
let _e4687 = select(-1f, _e4670, (_e4670 > -1f));
let _e4689 = select(_e4668, _e4687, (_e4687 < _e4668));
let _e4696 = select(0i, select(select(i32(_e4689), i32(-2147483648), (_e4689 < -2147483600f)), 2147483647i, (_e4689 > 2147483500f)), (_e4689 == _e4689));
let _e4700 = (_e4696 - select(0i, 1i, (_e4689 < f32(_e4696))));
let _e4702 = (_e4665 - f32(_e4685));
let _e4704 = (_e4670 - f32(_e4700));
let _e4706 = select(0f, _e4704, (_e4704 > 0f));
let _e4708 = select(1f, _e4706, (_e4706 < 1f));
if (_e4685 < 0i) {
let _e4711 = local_99;
phi_7543_ = (_e4685 + _e4711);
} else {
phi_7543_ = _e4685;
}
let _e4714 = phi_7543_;
let _e4716 = local_100;
if (_e4714 >= _e4716) {
let _e4719 = local_101;
phi_7549_ = (_e4714 - _e4719);
} else {
phi_7549_ = _e4714;
}
let _e4722 = phi_7549_;
let _e4723 = (_e4685 + 1i);
if (_e4723 < 0i) {
let _e4726 = local_102;
phi_7556_ = (_e4723 + _e4726);
} else {
phi_7556_ = _e4723;
}
let _e4729 = phi_7556_;
let _e4731 = local_103;
if (_e4729 >= _e4731) {
let _e4734 = local_104;
phi_7562_ = (_e4729 - _e4734);
} else {
phi_7562_ = _e4729;
}
let _e4737 = phi_7562_;
let _e4739 = select(_e4700, 0i, (_e4700 < 0i));
let _e4741 = local_105;
if (_e4739 >= _e4741) {
let _e4744 = local_106;
phi_7573_ = (_e4744 - 1i);
} else {
phi_7573_ = _e4739;
}
let _e4747 = phi_7573_;
let _e4748 = (_e4700 + 1i);
let _e4750 = select(_e4748, 0i, (_e4748 < 0i));
let _e4752 = local_107;
if (_e4750 >= _e4752) {
let _e4755 = local_108;
phi_7585_ = (_e4755 - 1i);
} else {
phi_7585_ = _e4750;
}
let _e4758 = phi_7585_;
let _e4760 = local_109;
let _e4763 = local_110;
let _e4764 = (_e4763 + (_e4747 * _e4760));
let _e4766 = local_111;
let _e4769 = local_112;
let _e4770 = (_e4769 + (_e4758 * _e4766));
let _e4772 = (3i * (_e4764 + _e4722));
let _e4774 = select(_e4491, _e4772, (_e4772 < _e4491));
let _e4780 = global_4.member[bitcast<u32>(select(0i, _e4774, (_e4774 > 0i)))];
let _e4781 = (_e4772 + 1i);
let _e4783 = select(_e4491, _e4781, (_e4781 < _e4491));
let _e4789 = global_4.member[bitcast<u32>(select(0i, _e4783, (_e4783 > 0i)))];
let _e4790 = (_e4772 + 2i);
let _e4792 = select(_e4491, _e4790, (_e4790 < _e4491));
let _e4798 = global_4.member[bitcast<u32>(select(0i, _e4792, (_e4792 > 0i)))];
let _e4800 = (3i * (_e4764 + _e4737));
let _e4802 = select(_e4491, _e4800, (_e4800 < _e4491));
let _e4808 = global_4.member[bitcast<u32>(select(0i, _e4802, (_e4802 > 0i)))];
let _e4809 = (_e4800 + 1i);
let _e4811 = select(_e4491, _e4809, (_e4809 < _e4491));
let _e4817 = global_4.member[bitcast<u32>(select(0i, _e4811, (_e4811 > 0i)))];
let _e4818 = (_e4800 + 2i);
let _e4820 = select(_e4491, _e4818, (_e4818 < _e4491));
let _e4826 = global_4.member[bitcast<u32>(select(0i, _e4820, (_e4820 > 0i)))];
let _e4828 = (3i * (_e4770 + _e4722));
let _e4830 = select(_e4491, _e4828, (_e4828 < _e4491));
let _e4836 = global_4.member[bitcast<u32>(select(0i, _e4830, (_e4830 > 0i)))];
let _e4837 = (_e4828 + 1i);
let _e4839 = select(_e4491, _e4837, (_e4837 < _e4491));
let _e4845 = global_4.member[bitcast<u32>(select(0i, _e4839, (_e4839 > 0i)))];
let _e4846 = (_e4828 + 2i);
let _e4848 = select(_e4491, _e4846, (_e4846 < _e4491));
let _e4854 = global_4.member[bitcast<u32>(select(0i, _e4848, (_e4848 > 0i)))];
let _e4856 = (3i * (_e4770 + _e4737));
let _e4858 = select(_e4491, _e4856, (_e4856 < _e4491));
let _e4864 = global_4.member[bitcast<u32>(select(0i, _e4858, (_e4858 > 0i)))];
let _e4865 = (_e4856 + 1i);
let _e4867 = select(_e4491, _e4865, (_e4865 < _e4491));
let _e4873 = global_4.member[bitcast<u32>(select(0i, _e4867, (_e4867 > 0i)))];
let _e4874 = (_e4856 + 2i);
let _e4876 = select(_e4491, _e4874, (_e4874 < _e4491));
let _e4882 = global_4.member[bitcast<u32>(select(0i, _e4876, (_e4876 > 0i)))];
let _e4889 = (_e4780 + ((_e4808 - _e4780) * _e4702));
let _e4890 = (_e4789 + ((_e4817 - _e4789) * _e4702));
let _e4891 = (_e4798 + ((_e4826 - _e4798) * _e4702));
let _e4914 = (_e4223 - f32(_e4241));
let _e4916 = select(0f, _e4914, (_e4914 > 0f));
let _e4918 = select(1f, _e4916, (_e4916 < 1f));
let _e4928 = global_1.member.member_16.member_11;
phi_7840_ = vec3<f32>(((_e4626 + (((_e4889 + (((_e4836 + ((_e4864 - _e4836) * _e4702)) - _e4889) * _e4708)) - _e4626) * _e4918)) * _e4928), ((_e4627 + (((_e4890 + (((_e4845 + ((_e4873 - _e4845) * _e4702)) - _e4890) * _e4708)) - _e4627) * _e4918)) * _e4928), ((_e4628 + (((_e4891 + (((_e4854 + ((_e4882 - _e4854) * _e4702)) - _e4891) * _e4708)) - _e4628) * _e4918)) * _e4928));
}
let _e4934 = phi_7840_;
phi_7841_ = _e4934;
}
let _e4936 = phi_7841_;
phi_7842_ = _e4936;
}
let _e4938 = phi_7842_;
if (_e288 && (_e3789 > 0f)) {
let _e4941 = local_43;
let _e4943 = local_42;
let _e4944 = ((2i * _e4941) + _e4943);
let _e4946 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e4948 = select(_e4946, _e4944, (_e4944 < _e4946));
let _e4953 = global_7.member[bitcast<u32>(select(0i, _e4948, (_e4948 > 0i)))];
let _e4960 = select(0i, select(select(i32(_e4953), i32(-2147483648), (_e4953 < -2147483600f)), 2147483647i, (_e4953 > 2147483500f)), (_e4953 == _e4953));
if (_e4960 != -1i) {
let _e4962 = local_43;
let _e4964 = local_42;
let _e4965 = ((20i * _e4962) + _e4964);
let _e4967 = select(_e202, _e4965, (_e4965 < _e202));
let _e4972 = global_2.member[bitcast<u32>(select(0i, _e4967, (_e4967 > 0i)))];
let _e4973 = (1f - _e467);
let _e4979 = global_1.member.member_10;
let _e4992 = local_43;
let _e4994 = local_42;
let _e4995 = ((3i * _e4992) + _e4994);
let _e4997 = select(_e4946, _e4995, (_e4995 < _e4946));
let _e5002 = global_7.member[bitcast<u32>(select(0i, _e4997, (_e4997 > 0i)))];
let _e5006 = (((_e4979.member + (_e1059 * _e4973)) + (_e1079 * _e4972)) + (_e3832 * _e5002));
let _e5007 = (((_e4979.member_1 + (_e1060 * _e4973)) + (_e1080 * _e4972)) + (_e3833 * _e5002));
let _e5008 = (((_e4979.member_2 + (_e1061 * _e4973)) + (_e1081 * _e4972)) + (_e3834 * _e5002));
let _e5009 = vec3<f32>(_e5006, _e5007, _e5008);
if (_e4960 < 0i) {
let _e5011 = (_e4960 == -3i);
let _e5017 = global_1.member.member_18.member_1.member.member;
let _e5022 = global_1.member.member_18.member_1.member_1;
let _e5028 = global_1.member.member_18.member.member.member;
let _e5033 = global_1.member.member_18.member.member_1;
let _e5043 = vec3<f32>(select(_e5028.member, _e5017.member, _e5011), select(_e5028.member_1, _e5017.member_1, _e5011), select(_e5028.member_2, _e5017.member_2, _e5011));
phi_8817_ = type_22(_e5009, _e5043, _e5043, vec3<f32>(select(_e5033.member, _e5022.member, _e5011), select(_e5033.member_1, _e5022.member_1, _e5011), select(_e5033.member_2, _e5022.member_2, _e5011)), 0f, false);
} else {
let _e5055 = (_e4960 * 19i);
let _e5057 = (bitcast<i32>(_e160) - 1i);
let _e5059 = select(_e5057, _e5055, (_e5055 < _e5057));
let _e5065 = global_3.member[bitcast<u32>(select(0i, _e5059, (_e5059 > 0i)))];
let _e5066 = (_e5055 + 1i);
let _e5068 = select(_e5057, _e5066, (_e5066 < _e5057));
let _e5074 = global_3.member[bitcast<u32>(select(0i, _e5068, (_e5068 > 0i)))];
let _e5075 = (_e5055 + 2i);
let _e5077 = select(_e5057, _e5075, (_e5075 < _e5057));
let _e5083 = global_3.member[bitcast<u32>(select(0i, _e5077, (_e5077 > 0i)))];
let _e5084 = (_e5055 + 3i);
let _e5086 = select(_e5057, _e5084, (_e5084 < _e5057));
let _e5092 = global_3.member[bitcast<u32>(select(0i, _e5086, (_e5086 > 0i)))];
let _e5093 = (_e5055 + 4i);
let _e5095 = select(_e5057, _e5093, (_e5093 < _e5057));
let _e5101 = global_3.member[bitcast<u32>(select(0i, _e5095, (_e5095 > 0i)))];
let _e5102 = (_e5055 + 5i);
let _e5104 = select(_e5057, _e5102, (_e5102 < _e5057));
let _e5110 = global_3.member[bitcast<u32>(select(0i, _e5104, (_e5104 > 0i)))];
let _e5111 = (_e5055 + 6i);
let _e5113 = select(_e5057, _e5111, (_e5111 < _e5057));
let _e5119 = global_3.member[bitcast<u32>(select(0i, _e5113, (_e5113 > 0i)))];
let _e5120 = (_e5055 + 7i);
let _e5122 = select(_e5057, _e5120, (_e5120 < _e5057));
let _e5128 = global_3.member[bitcast<u32>(select(0i, _e5122, (_e5122 > 0i)))];
let _e5129 = (_e5055 + 8i);
let _e5131 = select(_e5057, _e5129, (_e5129 < _e5057));
let _e5137 = global_3.member[bitcast<u32>(select(0i, _e5131, (_e5131 > 0i)))];
let _e5138 = (_e5092 - _e5065);
let _e5139 = (_e5101 - _e5074);
let _e5140 = (_e5110 - _e5083);
let _e5141 = (_e5119 - _e5065);
let _e5142 = (_e5128 - _e5074);
let _e5143 = (_e5137 - _e5083);
let _e5146 = ((_e5139 * _e5143) - (_e5140 * _e5142));
let _e5149 = ((_e5140 * _e5141) - (_e5138 * _e5143));
let _e5152 = ((_e5138 * _e5142) - (_e5139 * _e5141));
let _e5153 = (_e5092 - _e5006);
let _e5154 = (_e5101 - _e5007);
let _e5155 = (_e5110 - _e5008);
let _e5156 = (_e5119 - _e5006);
let _e5157 = (_e5128 - _e5007);
let _e5158 = (_e5137 - _e5008);
let _e5172 = (((((_e5154 * _e5158) - (_e5155 * _e5157)) * _e5146) + (((_e5155 * _e5156) - (_e5153 * _e5158)) * _e5149)) + (((_e5153 * _e5157) - (_e5154 * _e5156)) * _e5152));
let _e5174 = select(0f, _e5172, (_e5172 > 0f));
let _e5175 = (_e5065 - _e5006);
let _e5176 = (_e5074 - _e5007);
let _e5177 = (_e5083 - _e5008);
let _e5191 = (((((_e5157 * _e5177) - (_e5158 * _e5176)) * _e5146) + (((_e5158 * _e5175) - (_e5156 * _e5177)) * _e5149)) + (((_e5156 * _e5176) - (_e5157 * _e5175)) * _e5152));
let _e5193 = select(0f, _e5191, (_e5191 > 0f));
let _e5207 = (((((_e5176 * _e5155) - (_e5177 * _e5154)) * _e5146) + (((_e5177 * _e5153) - (_e5175 * _e5155)) * _e5149)) + (((_e5175 * _e5154) - (_e5176 * _e5153)) * _e5152));
let _e5209 = select(0f, _e5207, (_e5207 > 0f));
let _e5211 = ((_e5174 + _e5193) + _e5209);
let _e5213 = select(1e-30f, _e5211, (_e5211 > 1e-30f));
let _e5214 = (_e5174 / _e5213);
let _e5215 = (_e5193 / _e5213);
let _e5216 = (_e5209 / _e5213);
let _e5221 = (((_e5146 * _e5146) + (_e5149 * _e5149)) + (_e5152 * _e5152));
let _e5224 = sqrt(select(0f, _e5221, (_e5221 > 0f)));
let _e5227 = (1f / select(1e-20f, _e5224, (_e5224 > 1e-20f)));
let _e5232 = (_e5055 + 9i);
let _e5234 = select(_e5057, _e5232, (_e5232 < _e5057));
let _e5240 = global_3.member[bitcast<u32>(select(0i, _e5234, (_e5234 > 0i)))];
let _e5241 = (_e5055 + 10i);
let _e5243 = select(_e5057, _e5241, (_e5241 < _e5057));
let _e5249 = global_3.member[bitcast<u32>(select(0i, _e5243, (_e5243 > 0i)))];
let _e5250 = (_e5055 + 11i);
let _e5252 = select(_e5057, _e5250, (_e5250 < _e5057));
let _e5258 = global_3.member[bitcast<u32>(select(0i, _e5252, (_e5252 > 0i)))];
let _e5262 = (_e5055 + 12i);
let _e5264 = select(_e5057, _e5262, (_e5262 < _e5057));
let _e5270 = global_3.member[bitcast<u32>(select(0i, _e5264, (_e5264 > 0i)))];
let _e5271 = (_e5055 + 13i);
let _e5273 = select(_e5057, _e5271, (_e5271 < _e5057));
let _e5279 = global_3.member[bitcast<u32>(select(0i, _e5273, (_e5273 > 0i)))];
let _e5280 = (_e5055 + 14i);
let _e5282 = select(_e5057, _e5280, (_e5280 < _e5057));
let _e5288 = global_3.member[bitcast<u32>(select(0i, _e5282, (_e5282 > 0i)))];
let _e5295 = (_e5055 + 15i);
let _e5297 = select(_e5057, _e5295, (_e5295 < _e5057));
let _e5303 = global_3.member[bitcast<u32>(select(0i, _e5297, (_e5297 > 0i)))];
let _e5304 = (_e5055 + 16i);
let _e5306 = select(_e5057, _e5304, (_e5304 < _e5057));
let _e5312 = global_3.member[bitcast<u32>(select(0i, _e5306, (_e5306 > 0i)))];
let _e5313 = (_e5055 + 17i);
let _e5315 = select(_e5057, _e5313, (_e5313 < _e5057));
let _e5321 = global_3.member[bitcast<u32>(select(0i, _e5315, (_e5315 > 0i)))];
let _e5325 = (((_e5240 * _e5214) + (_e5270 * _e5215)) + (_e5303 * _e5216));
let _e5326 = (((_e5249 * _e5214) + (_e5279 * _e5215)) + (_e5312 * _e5216));
let _e5327 = (((_e5258 * _e5214) + (_e5288 * _e5215)) + (_e5321 * _e5216));
let _e5332 = (((_e5325 * _e5325) + (_e5326 * _e5326)) + (_e5327 * _e5327));
let _e5335 = sqrt(select(0f, _e5332, (_e5332 > 0f)));
let _e5338 = (1f / select(1e-20f, _e5335, (_e5335 > 1e-20f)));
let _e5345 = global_1.member.member_1;
let _e5348 = (_e5055 + 18i);
let _e5350 = select(_e5057, _e5348, (_e5348 < _e5057));
let _e5356 = global_3.member[bitcast<u32>(select(0i, _e5350, (_e5350 > 0i)))];
let _e5365 = (select(select(0i, select(select(i32(_e5356), i32(-2147483648), (_e5356 < -2147483600f)), 2147483647i, (_e5356 > 2147483500f)), (_e5356 == _e5356)), _e4960, ((_e5345 & 4u) != 0u)) * 10i);
let _e5367 = (bitcast<i32>(_e162) - 1i);
let _e5369 = select(_e5367, _e5365, (_e5365 < _e5367));
let _e5375 = global_5.member[bitcast<u32>(select(0i, _e5369, (_e5369 > 0i)))];
let _e5376 = (_e5365 + 1i);
let _e5378 = select(_e5367, _e5376, (_e5376 < _e5367));
let _e5384 = global_5.member[bitcast<u32>(select(0i, _e5378, (_e5378 > 0i)))];
let _e5385 = (_e5365 + 2i);
let _e5387 = select(_e5367, _e5385, (_e5385 < _e5367));
let _e5393 = global_5.member[bitcast<u32>(select(0i, _e5387, (_e5387 > 0i)))];
let _e5397 = (_e5365 + 3i);
let _e5399 = select(_e5367, _e5397, (_e5397 < _e5367));
let _e5405 = global_5.member[bitcast<u32>(select(0i, _e5399, (_e5399 > 0i)))];
let _e5406 = (_e5365 + 4i);
let _e5408 = select(_e5367, _e5406, (_e5406 < _e5367));
let _e5414 = global_5.member[bitcast<u32>(select(0i, _e5408, (_e5408 > 0i)))];
let _e5415 = (_e5365 + 5i);
let _e5417 = select(_e5367, _e5415, (_e5415 < _e5367));
let _e5423 = global_5.member[bitcast<u32>(select(0i, _e5417, (_e5417 > 0i)))];
let _e5430 = (_e5365 + 6i);
let _e5432 = select(_e5367, _e5430, (_e5430 < _e5367));
let _e5438 = global_5.member[bitcast<u32>(select(0i, _e5432, (_e5432 > 0i)))];
let _e5439 = (_e5365 + 7i);
let _e5441 = select(_e5367, _e5439, (_e5439 < _e5367));
let _e5447 = global_5.member[bitcast<u32>(select(0i, _e5441, (_e5441 > 0i)))];
let _e5448 = (_e5365 + 8i);
let _e5450 = select(_e5367, _e5448, (_e5448 < _e5367));
let _e5456 = global_5.member[bitcast<u32>(select(0i, _e5450, (_e5450 > 0i)))];
let _e5464 = (_e5365 + 9i);
let _e5466 = select(_e5367, _e5464, (_e5464 < _e5367));
let _e5472 = global_5.member[bitcast<u32>(select(0i, _e5466, (_e5466 > 0i)))];
phi_8817_ = type_22(_e5009, vec3<f32>((_e5146 * _e5227), (_e5149 * _e5227), (_e5152 * _e5227)), vec3<f32>((_e5325 * _e5338), (_e5326 * _e5338), (_e5327 * _e5338)), vec3<f32>((((_e5375 * _e5214) + (_e5405 * _e5215)) + (_e5438 * _e5216)), (((_e5384 * _e5214) + (_e5414 * _e5215)) + (_e5447 * _e5216)), (((_e5393 * _e5214) + (_e5423 * _e5215)) + (_e5456 * _e5216))), _e5472, true);
}
let _e5475 = phi_8817_;
let _e5484 = (((_e5475.member_1.x * _e3832) + (_e5475.member_1.y * _e3833)) + (_e5475.member_1.z * _e3834));
let _e5486 = select(1f, -1f, (_e5484 > 0f));
let _e5498 = select(_e5486, -(_e5486), ((((_e5475.member_2.x * _e5475.member_1.x) + (_e5475.member_2.y * _e5475.member_1.y)) + (_e5475.member_2.z * _e5475.member_1.z)) < 0f));
let _e5499 = (_e5475.member_2.x * _e5498);
let _e5500 = (_e5475.member_2.y * _e5498);
let _e5501 = (_e5475.member_2.z * _e5498);
let _e5510 = ((((_e5499 * _e3832) + (_e5500 * _e3833)) + (_e5501 * _e3834)) > 0f);
let _e5518 = global_1.member.member_19.member_2;
let _e5526 = global_1.member.member_19.member;
if (_e5526 == 0u) {
let _e5531 = global_1.member.member_19.member_1;
phi_9407_ = type_23(vec3<f32>(_e5531.member, _e5531.member_1, _e5531.member_2), vec3<f32>(_e5518.member, _e5518.member_1, _e5518.member_2));
} else {
let _e5540 = global_1.member.member_19.member_3;
let _e5545 = (_e5475.member.x - _e5540.member);
let _e5547 = (_e5475.member.y - _e5540.member_1);
let _e5549 = (_e5475.member.z - _e5540.member_2);
let _e5554 = (((_e5545 * _e5545) + (_e5547 * _e5547)) + (_e5549 * _e5549));
let _e5556 = select(1e-12f, _e5554, (_e5554 > 1e-12f));
let _e5557 = (1f / _e5556);
let _e5561 = vec3<f32>((_e5518.member * _e5557), (_e5518.member_1 * _e5557), (_e5518.member_2 * _e5557));
if (_e5526 == 2u) {
let _e5566 = global_1.member.member_19.member_1;
let _e5574 = (((_e5566.member * _e5545) + (_e5566.member_1 * _e5547)) + (_e5566.member_2 * _e5549));
let _e5577 = (1f / select(1e-20f, _e5574, (_e5574 > 1e-20f)));
let _e5582 = global_1.member.member_19.member_4.member;
let _e5591 = ((((_e5582.member * _e5545) + (_e5582.member_1 * _e5547)) + (_e5582.member_2 * _e5549)) * _e5577);
let _e5596 = global_1.member.member_19.member_4.member_1;
let _e5605 = ((((_e5596.member * _e5545) + (_e5596.member_1 * _e5547)) + (_e5596.member_2 * _e5549)) * _e5577);
let _e5610 = global_1.member.member_19.member_4.member_2;
let _e5613 = ((_e5591 * _e5591) + (_e5605 * _e5605));
let _e5622 = global_1.member.member_19.member_4.member_3;
let _e5623 = ((_e5610 - sqrt(select(0f, _e5613, (_e5613 > 0f)))) * _e5622);
let _e5625 = select(0f, _e5623, (_e5623 > 0f));
let _e5627 = select(1f, _e5625, (_e5625 < 1f));
let _e5633 = select(0f, ((_e5627 * _e5627) * (3f - (2f * _e5627))), (_e5574 > 0f));
let _e5638 = global_1.member.member_19.member_4.member_5;
if ((_e5638 > 0u) && (_e5633 > 0f)) {
let _e5642 = (0.5f / _e5610);
let _e5652 = global_1.member.member_19.member_4.member_6;
let _e5653 = bitcast<i32>(_e5652);
local_2 = bitcast<i32>(_e5638);
let _e5654 = local_2;
let _e5656 = f32((_e5654 - 1i));
let _e5658 = f32((_e5653 - 1i));
let _e5659 = local_2;
let _e5662 = (((0.5f + (_e5591 * _e5642)) * f32(_e5659)) - 0.5f);
let _e5664 = select(0f, _e5662, (_e5662 > 0f));
let _e5666 = select(_e5656, _e5664, (_e5664 < _e5656));
let _e5669 = (((0.5f - (_e5605 * _e5642)) * f32(_e5653)) - 0.5f);
let _e5671 = select(0f, _e5669, (_e5669 > 0f));
let _e5673 = select(_e5658, _e5671, (_e5671 < _e5658));
let _e5675 = select(0f, _e5666, (_e5666 > 0f));
let _e5677 = select(_e5656, _e5675, (_e5675 < _e5656));
let _e5684 = select(0i, select(select(i32(_e5677), i32(-2147483648), (_e5677 < -2147483600f)), 2147483647i, (_e5677 > 2147483500f)), (_e5677 == _e5677));
let _e5688 = (_e5684 - select(0i, 1i, (_e5677 < f32(_e5684))));
let _e5690 = select(0f, _e5673, (_e5673 > 0f));
let _e5692 = select(_e5658, _e5690, (_e5690 < _e5658));
let _e5699 = select(0i, select(select(i32(_e5692), i32(-2147483648), (_e5692 < -2147483600f)), 2147483647i, (_e5692 > 2147483500f)), (_e5692 == _e5692));
let _e5703 = (_e5699 - select(0i, 1i, (_e5692 < f32(_e5699))));
let _e5705 = (_e5666 - f32(_e5688));
let _e5707 = (_e5673 - f32(_e5703));
let _e5708 = (_e5688 + 1i);
let _e5709 = local_2;
let _e5711 = select(_e5688, _e5708, (_e5708 < _e5709));
let _e5712 = (_e5703 + 1i);
let _e5714 = select(_e5703, _e5712, (_e5712 < _e5653));
let _e5719 = global_1.member.member_19.member_4.member_4;
let _e5720 = bitcast<i32>(_e5719);
let _e5721 = local_2;
let _e5725 = (_e5720 + (3i * ((_e5703 * _e5721) + _e5688)));
let _e5727 = (bitcast<i32>(_e158) - 1i);
let _e5729 = select(_e5727, _e5725, (_e5725 < _e5727));
let _e5734 = global_4.member[bitcast<u32>(select(0i, _e5729, (_e5729 > 0i)))];
let _e5735 = (_e5725 + 1i);
let _e5737 = select(_e5727, _e5735, (_e5735 < _e5727));
let _e5742 = global_4.member[bitcast<u32>(select(0i, _e5737, (_e5737 > 0i)))];
let _e5743 = (_e5725 + 2i);
let _e5745 = select(_e5727, _e5743, (_e5743 < _e5727));
let _e5750 = global_4.member[bitcast<u32>(select(0i, _e5745, (_e5745 > 0i)))];
let _e5751 = local_2;
let _e5755 = (_e5720 + (3i * ((_e5703 * _e5751) + _e5711)));
let _e5757 = select(_e5727, _e5755, (_e5755 < _e5727));
let _e5762 = global_4.member[bitcast<u32>(select(0i, _e5757, (_e5757 > 0i)))];
let _e5763 = (_e5755 + 1i);
let _e5765 = select(_e5727, _e5763, (_e5763 < _e5727));
let _e5770 = global_4.member[bitcast<u32>(select(0i, _e5765, (_e5765 > 0i)))];
let _e5771 = (_e5755 + 2i);
let _e5773 = select(_e5727, _e5771, (_e5771 < _e5727));
let _e5778 = global_4.member[bitcast<u32>(select(0i, _e5773, (_e5773 > 0i)))];
let _e5779 = local_2;
let _e5783 = (_e5720 + (3i * ((_e5714 * _e5779) + _e5688)));
let _e5785 = select(_e5727, _e5783, (_e5783 < _e5727));
let _e5790 = global_4.member[bitcast<u32>(select(0i, _e5785, (_e5785 > 0i)))];
let _e5791 = (_e5783 + 1i);
let _e5793 = select(_e5727, _e5791, (_e5791 < _e5727));
let _e5798 = global_4.member[bitcast<u32>(select(0i, _e5793, (_e5793 > 0i)))];
let _e5799 = (_e5783 + 2i);
let _e5801 = select(_e5727, _e5799, (_e5799 < _e5727));
let _e5806 = global_4.member[bitcast<u32>(select(0i, _e5801, (_e5801 > 0i)))];
let _e5807 = local_2;
let _e5811 = (_e5720 + (3i * ((_e5714 * _e5807) + _e5711)));
let _e5813 = select(_e5727, _e5811, (_e5811 < _e5727));
let _e5818 = global_4.member[bitcast<u32>(select(0i, _e5813, (_e5813 > 0i)))];
let _e5819 = (_e5811 + 1i);
let _e5821 = select(_e5727, _e5819, (_e5819 < _e5727));
let _e5826 = global_4.member[bitcast<u32>(select(0i, _e5821, (_e5821 > 0i)))];
let _e5827 = (_e5811 + 2i);
let _e5829 = select(_e5727, _e5827, (_e5827 < _e5727));
let _e5834 = global_4.member[bitcast<u32>(select(0i, _e5829, (_e5829 > 0i)))];
let _e5841 = (_e5734 + ((_e5762 - _e5734) * _e5705));
let _e5842 = (_e5742 + ((_e5770 - _e5742) * _e5705));
let _e5843 = (_e5750 + ((_e5778 - _e5750) * _e5705));
phi_9391_ = vec3<f32>(((_e5841 + (((_e5790 + ((_e5818 - _e5790) * _e5705)) - _e5841) * _e5707)) * _e5633), ((_e5842 + (((_e5798 + ((_e5826 - _e5798) * _e5705)) - _e5842) * _e5707)) * _e5633), ((_e5843 + (((_e5806 + ((_e5834 - _e5806) * _e5705)) - _e5843) * _e5707)) * _e5633));
} else {
phi_9391_ = vec3(_e5633);
}
let _e5868 = phi_9391_;
phi_9394_ = (_e5561 * _e5868);
} else {
phi_9394_ = _e5561;
}
let _e5871 = phi_9394_;
let _e5875 = (1f / sqrt(select(0f, _e5556, (_e5556 > 0f))));
phi_9407_ = type_23(vec3<f32>((_e5545 * _e5875), (_e5547 * _e5875), (_e5549 * _e5875)), _e5871);
}
let _e5882 = phi_9407_;
let _e5893 = -((((select(_e5499, (_e5475.member_1.x * _e5486), _e5510) * _e5882.member.x) + (select(_e5500, (_e5475.member_1.y * _e5486), _e5510) * _e5882.member.y)) + (select(_e5501, (_e5475.member_1.z * _e5486), _e5510) * _e5882.member.z)));
let _e5899 = -((((_e5475.member_1.x * _e5882.member.x) + (_e5475.member_1.y * _e5882.member.y)) + (_e5475.member_1.z * _e5882.member.z)));
let _e5905 = -(_e5893);
let _e5910 = select((select(0f, _e5905, (_e5905 > 0f)) * _e5475.member_4), select(0f, _e5893, (_e5893 > 0f)), ((_e5899 * -(_e5484)) > 0f));
let _e5911 = -(_e5899);
let _e5913 = select(_e5911, _e5899, (_e5899 > _e5911));
let _e5919 = global_1.member.member_21.member_6;
let _e5933 = ((((_e5919.member.member * _e5475.member.x) + (_e5919.member.member_1 * _e5475.member.y)) + (_e5919.member.member_2 * _e5475.member.z)) + _e5919.member_1);
let _e5935 = select(1f, _e5933, (_e5933 > 1e-6f));
let _e5939 = global_1.member.member_21.member_4;
let _e5955 = global_1.member.member_21.member_5;
let _e5971 = global_1.member.member_21.member_2;
let _e5980 = -((((_e5475.member_1.x * _e5971.member) + (_e5475.member_1.y * _e5971.member_1)) + (_e5475.member_1.z * _e5971.member_2)));
let _e5981 = -(_e5980);
let _e5983 = select(_e5981, _e5980, (_e5980 > _e5981));
let _e5985 = select(1f, _e5983, (_e5983 < 1f));
let _e5987 = (1f - (_e5985 * _e5985));
let _e5994 = global_1.member.member_21.member_8;
let _e6002 = global_1.member.member_21.member_7.member;
let _e6007 = global_1.member.member_21.member_7.member_2;
let _e6009 = (_e6002 + (_e6007 * (((((_e5939.member.member * _e5475.member.x) + (_e5939.member.member_1 * _e5475.member.y)) + (_e5939.member.member_2 * _e5475.member.z)) + _e5939.member_1) / _e5935)));
let _e6014 = global_1.member.member_21.member_7.member_1;
let _e6016 = (_e6014 + (_e6007 * (((((_e5955.member.member * _e5475.member.x) + (_e5955.member.member_1 * _e5475.member.y)) + (_e5955.member.member_2 * _e5475.member.z)) + _e5955.member_1) / _e5935)));
let _e6020 = ((1f + (_e6009 * _e6009)) + (_e6016 * _e6016));
let _e6029 = global_1.member.member_21.member_9;
let _e6033 = (select(1f, -1f, (_e5899 < 0f)) * (((((1.4142135f * _e5994) * sqrt(select(0f, _e5987, (_e5987 > 0f)))) * _e5933) + (select(1f, _e5913, (_e5913 < 1f)) * sqrt(select(0f, _e6020, (_e6020 > 0f))))) * _e6029));
let _e6038 = select(0f, 1f, _e5475.member_5);
let _e6042 = (_e5475.member.x + ((_e5475.member_1.x * _e6033) * _e6038));
let _e6043 = (_e5475.member.y + ((_e5475.member_1.y * _e6033) * _e6038));
let _e6044 = (_e5475.member.z + ((_e5475.member_1.z * _e6033) * _e6038));
let _e6049 = global_1.member.member_21.member.member;
let _e6050 = bitcast<i32>(_e6049);
let _e6055 = global_1.member.member_21.member.member_1;
let _e6056 = bitcast<i32>(_e6055);
let _e6061 = global_1.member.member_21.member.member_2;
let _e6062 = bitcast<i32>(_e6061);
let _e6066 = global_1.member.member_21.member_1;
let _e6067 = bitcast<i32>(_e6066);
let _e6073 = ((((_e5919.member.member * _e6042) + (_e5919.member.member_1 * _e6043)) + (_e5919.member.member_2 * _e6044)) + _e5919.member_1);
let _e6075 = select(1f, _e6073, (_e6073 > 1e-6f));
let _e6079 = global_1.member.member_21.member_3;
let _e6090 = ((((_e6079.member.member * _e6042) + (_e6079.member.member_1 * _e6043)) + (_e6079.member.member_2 * _e6044)) + _e6079.member_1);
let _e6105 = ((((((_e5939.member.member * _e6042) + (_e5939.member.member_1 * _e6043)) + (_e5939.member.member_2 * _e6044)) + _e5939.member_1) / _e6075) - 0.5f);
let _e6106 = ((((((_e5955.member.member * _e6042) + (_e5955.member.member_1 * _e6043)) + (_e5955.member.member_2 * _e6044)) + _e5955.member_1) / _e6075) - 0.5f);
let _e6108 = f32((_e6050 - 1i));
let _e6110 = select(0f, _e6090, (_e6090 > 0f));
let _e6112 = select(_e6108, _e6110, (_e6110 < _e6108));
let _e6119 = select(0i, select(select(i32(_e6112), i32(-2147483648), (_e6112 < -2147483600f)), 2147483647i, (_e6112 > 2147483500f)), (_e6112 == _e6112));
let _e6123 = (_e6119 - select(0i, 1i, (_e6112 < f32(_e6119))));
let _e6127 = (_e6090 - f32(_e6123));
let _e6130 = select(1f, select(0f, _e6127, (_e6127 > 0f)), (_e6090 < f32(_e6050)));
let _e6131 = (_e6105 - _e5994);
let _e6132 = -(16f);
let _e6133 = f32(_e6056);
let _e6135 = select(_e6132, _e6131, (_e6131 > _e6132));
let _e6137 = select(_e6133, _e6135, (_e6135 < _e6133));
let _e6144 = select(0i, select(select(i32(_e6137), i32(-2147483648), (_e6137 < -2147483600f)), 2147483647i, (_e6137 > 2147483500f)), (_e6137 == _e6137));
let _e6150 = (_e6105 + _e5994);
let _e6153 = (f32((_e6056 - 1i)) + 16f);
let _e6155 = select(-1f, _e6150, (_e6150 > -1f));
let _e6157 = select(_e6153, _e6155, (_e6155 < _e6153));
let _e6164 = select(0i, select(select(i32(_e6157), i32(-2147483648), (_e6157 < -2147483600f)), 2147483647i, (_e6157 > 2147483500f)), (_e6157 == _e6157));
let _e6169 = (_e6106 - _e5994);
let _e6170 = f32(_e6062);
let _e6172 = select(_e6132, _e6169, (_e6169 > _e6132));
let _e6174 = select(_e6170, _e6172, (_e6172 < _e6170));
let _e6181 = select(0i, select(select(i32(_e6174), i32(-2147483648), (_e6174 < -2147483600f)), 2147483647i, (_e6174 > 2147483500f)), (_e6174 == _e6174));
let _e6187 = (_e6106 + _e5994);
let _e6190 = (f32((_e6062 - 1i)) + 16f);
let _e6192 = select(-1f, _e6187, (_e6187 > -1f));
let _e6194 = select(_e6190, _e6192, (_e6192 < _e6190));
let _e6201 = select(0i, select(select(i32(_e6194), i32(-2147483648), (_e6194 < -2147483600f)), 2147483647i, (_e6194 > 2147483500f)), (_e6194 == _e6194));
let _e6209 = bitcast<i32>(((_e6049 + 2u) >> bitcast<u32>(1i)));
let _e6211 = ((_e6056 * _e6062) * _e6209);
phi_9863_ = 0f;
phi_9866_ = vec3<f32>(0f, 0f, 0f);
phi_9868_ = ((_e6181 - select(0i, 1i, (_e6174 < f32(_e6181)))) + 1i);
loop {
let _e6213 = phi_9863_;
let _e6215 = phi_9866_;
let _e6217 = phi_9868_;
local_113 = _e6213;
local_114 = _e6213;
local_115 = _e6215;
local_116 = _e6215;
local_117 = _e6215;
let _e6218 = (_e6217 <= (_e6201 - select(0i, 1i, (_e6194 < f32(_e6201)))));
if _e6218 {
let _e6224 = (_e5994 - bitcast<f32>((bitcast<u32>((f32(_e6217) - _e6106)) & 2147483647u)));
phi_9883_ = ((_e6144 - select(0i, 1i, (_e6137 < f32(_e6144)))) + 1i);
phi_9886_ = _e6213;
phi_9888_ = _e6215;
loop {
let _e6226 = phi_9883_;
let _e6228 = phi_9886_;
let _e6230 = phi_9888_;
local_120 = _e6228;
local_121 = _e6230;
let _e6231 = (_e6226 <= (_e6164 - select(0i, 1i, (_e6157 < f32(_e6164)))));
if _e6231 {
let _e6237 = (_e5994 - bitcast<f32>((bitcast<u32>((f32(_e6226) - _e6105)) & 2147483647u)));
let _e6242 = (select(0f, _e6237, (_e6237 > 0f)) * select(0f, _e6224, (_e6224 > 0f)));
if ((((_e6226 >= 0i) && (_e6226 < _e6056)) && (_e6217 >= 0i)) && (_e6217 < _e6062)) {
let _e6252 = (((_e6217 * _e6056) + _e6226) * _e6209);
let _e6254 = (2i * _e6123);
let _e6255 = ((4i * _e6252) + _e6254);
let _e6257 = (_e6255 >> bitcast<u32>(2i));
let _e6260 = bitcast<u32>(((_e6255 & 3i) * 8i));
let _e6262 = (bitcast<i32>(_e164) - 1i);
let _e6264 = select(_e6262, _e6257, (_e6257 < _e6262));
let _e6270 = global_6.member[bitcast<u32>(select(0i, _e6264, (_e6264 > 0i)))];
let _e6274 = (_e6257 + 1i);
let _e6276 = select(_e6262, _e6274, (_e6274 < _e6262));
let _e6282 = global_6.member[bitcast<u32>(select(0i, _e6276, (_e6276 > 0i)))];
let _e6289 = ((_e6270 >> bitcast<u32>((_e6260 & 31u))) | ((_e6282 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6260) & 31u))));
let _e6292 = f32(bitcast<i32>((_e6289 & 65535u)));
let _e6300 = (1f / 65535f);
let _e6302 = (_e6242 * ((_e6292 + ((f32(bitcast<i32>((_e6289 >> bitcast<u32>(16i)))) - _e6292) * _e6130)) * _e6300));
let _e6304 = (_e6230.x + _e6302);
if (_e6067 > 1i) {
let _e6308 = ((4i * (_e6252 + _e6211)) + _e6254);
let _e6310 = (_e6308 >> bitcast<u32>(2i));
let _e6313 = bitcast<u32>(((_e6308 & 3i) * 8i));
let _e6315 = select(_e6262, _e6310, (_e6310 < _e6262));
let _e6321 = global_6.member[bitcast<u32>(select(0i, _e6315, (_e6315 > 0i)))];
let _e6325 = (_e6310 + 1i);
let _e6327 = select(_e6262, _e6325, (_e6325 < _e6262));
let _e6333 = global_6.member[bitcast<u32>(select(0i, _e6327, (_e6327 > 0i)))];
let _e6340 = ((_e6321 >> bitcast<u32>((_e6313 & 31u))) | ((_e6333 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6313) & 31u))));
let _e6343 = f32(bitcast<i32>((_e6340 & 65535u)));
let _e6358 = ((4i * (_e6252 + (2i * _e6211))) + _e6254);
let _e6360 = (_e6358 >> bitcast<u32>(2i));
let _e6363 = bitcast<u32>(((_e6358 & 3i) * 8i));
let _e6365 = select(_e6262, _e6360, (_e6360 < _e6262));
let _e6371 = global_6.member[bitcast<u32>(select(0i, _e6365, (_e6365 > 0i)))];
let _e6375 = (_e6360 + 1i);
let _e6377 = select(_e6262, _e6375, (_e6375 < _e6262));
let _e6383 = global_6.member[bitcast<u32>(select(0i, _e6377, (_e6377 > 0i)))];
let _e6390 = ((_e6371 >> bitcast<u32>((_e6363 & 31u))) | ((_e6383 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6363) & 31u))));
let _e6393 = f32(bitcast<i32>((_e6390 & 65535u)));
phi_10121_ = vec3<f32>(_e6304, (_e6230.y + (_e6242 * ((_e6343 + ((f32(bitcast<i32>((_e6340 >> bitcast<u32>(16i)))) - _e6343) * _e6130)) * _e6300))), (_e6230.z + (_e6242 * ((_e6393 + ((f32(bitcast<i32>((_e6390 >> bitcast<u32>(16i)))) - _e6393) * _e6130)) * _e6300))));
} else {
phi_10121_ = vec3<f32>(_e6304, (_e6230.y + _e6302), (_e6230.z + _e6302));
}
let _e6412 = phi_10121_;
phi_10131_ = _e6412;
} else {
phi_10131_ = vec3<f32>((_e6230.x + _e6242), (_e6230.y + _e6242), (_e6230.z + _e6242));
}
let _e6421 = phi_10131_;
phi_9884_ = (_e6226 + 1i);
phi_9887_ = (_e6228 + _e6242);
phi_9889_ = _e6421;
} else {
phi_9884_ = i32();
phi_9887_ = f32();
phi_9889_ = vec3<f32>();
}
let _e6425 = phi_9884_;
let _e6427 = phi_9887_;
let _e6429 = phi_9889_;
continue;
continuing {
phi_9883_ = _e6425;
phi_9886_ = _e6427;
phi_9888_ = _e6429;
break if !(_e6231);
}
}
let _e6879 = local_120;
phi_9864_ = _e6879;
let _e6882 = local_121;
phi_9867_ = _e6882;
phi_9869_ = (_e6217 + 1i);
} else {
phi_9864_ = f32();
phi_9867_ = vec3<f32>();
phi_9869_ = i32();
}
let _e6433 = phi_9864_;
let _e6435 = phi_9867_;
let _e6437 = phi_9869_;
continue;
continuing {
phi_9863_ = _e6433;
phi_9866_ = _e6435;
phi_9868_ = _e6437;
break if !(_e6218);
}
}
let _e6441 = local_113;
let _e6445 = (((_e6067 == 0i) || (_e6441 <= 0f)) || (_e6073 <= 1e-6f));
let _e6447 = local_114;
let _e6449 = (1f / select(_e6447, 1f, _e6445));
let _e6451 = local_115;
let _e6456 = local_116;
let _e6461 = local_117;
let _e6477 = global_1.member.member_20;
phi_10183_ = (_e5475.member_3 * vec3<f32>(((_e5882.member_1.x * (select((_e6451.x * _e6449), 1f, _e6445) * _e5910)) + _e6477.member), ((_e5882.member_1.y * (select((_e6456.y * _e6449), 1f, _e6445) * _e5910)) + _e6477.member_1), ((_e5882.member_1.z * (select((_e6461.z * _e6449), 1f, _e6445) * _e5910)) + _e6477.member_2)));
} else {
phi_10183_ = _e4938;
}
let _e6487 = phi_10183_;
phi_10184_ = _e6487;
} else {
phi_10184_ = _e4938;
}
let _e6489 = phi_10184_;
let _e6496 = (_e1171 || _e290);
let _e6500 = global_1.member.member_16.member_12;
let _e6501 = select(_e6500, 1f, _e6496);
let _e6502 = local_42;
local = _e6502;
local_1 = _e195;
let _e6503 = local_1;
let _e6505 = local;
let _e6506 = ((22i * _e6503) + _e6505);
let _e6508 = select(_e202, _e6506, (_e6506 < _e202));
let _e6513 = global_2.member[bitcast<u32>(select(0i, _e6508, (_e6508 > 0i)))];
let _e6514 = local_1;
let _e6516 = local;
let _e6517 = ((23i * _e6514) + _e6516);
let _e6519 = select(_e202, _e6517, (_e6517 < _e202));
let _e6524 = global_2.member[bitcast<u32>(select(0i, _e6519, (_e6519 > 0i)))];
let _e6525 = local_1;
let _e6527 = local;
let _e6528 = ((24i * _e6525) + _e6527);
let _e6530 = select(_e202, _e6528, (_e6528 < _e202));
let _e6535 = global_2.member[bitcast<u32>(select(0i, _e6530, (_e6530 > 0i)))];
let _e6538 = global_1.member.member_17;
let _e6556 = global_1.member.member_11;
let _e6557 = local_43;
let _e6559 = local_42;
let _e6560 = ((20i * _e6557) + _e6559);
let _e6562 = select(_e202, _e6560, (_e6560 < _e202));
let _e6567 = global_2.member[bitcast<u32>(select(0i, _e6562, (_e6562 > 0i)))];
let _e6594 = local_43;
let _e6596 = local_42;
let _e6597 = ((19i * _e6594) + _e6596);
let _e6599 = select(_e202, _e6597, (_e6597 < _e202));
let _e6604 = global_2.member[bitcast<u32>(select(0i, _e6599, (_e6599 > 0i)))];
global_8.member[_e179] = ((((_e3772.x * _e243) + (_e6489.x * _e3789)) + (_e6513 * _e6538.member)) * _e6501);
global_8.member[(_e177 + _e179)] = ((((_e3772.y * _e254) + (_e6489.y * _e3789)) + (_e6524 * _e6538.member_1)) * _e6501);
global_8.member[((2u * _e177) + _e179)] = ((((_e3772.z * _e265) + (_e6489.z * _e3789)) + (_e6535 * _e6538.member_2)) * _e6501);
global_8.member[((3u * _e177) + _e179)] = _e6501;
global_8.member[((4u * _e177) + _e179)] = (((_e443.member * _e3770.x) + (_e443.member_1 * _e3770.y)) + (_e443.member_2 * _e3770.z));
global_8.member[((5u * _e177) + _e179)] = (((_e452.member * _e3770.x) + (_e452.member_1 * _e3770.y)) + (_e452.member_2 * _e3770.z));
global_8.member[((6u * _e177) + _e179)] = -((((_e470.member * _e3770.x) + (_e470.member_1 * _e3770.y)) + (_e470.member_2 * _e3770.z)));
global_8.member[((7u * _e177) + _e179)] = _e276;
global_8.member[((8u * _e177) + _e179)] = (_e6604 * _e6556);
global_8.member[((9u * _e177) + _e179)] = select(0f, ((_e6567 * _e6556) * (((_e470.member * _e1079) + (_e470.member_1 * _e1080)) + (_e470.member_2 * _e1081))), _e6496);
global_8.member[((10u * _e177) + _e179)] = (((_e443.member * _e209) + (_e443.member_1 * _e220)) + (_e443.member_2 * _e231));
global_8.member[((11u * _e177) + _e179)] = (((_e452.member * _e209) + (_e452.member_1 * _e220)) + (_e452.member_2 * _e231));
global_8.member[((12u * _e177) + _e179)] = -((((_e470.member * _e209) + (_e470.member_1 * _e220)) + (_e470.member_2 * _e231)));
global_8.member[((13u * _e177) + _e179)] = _e243;
global_8.member[((14u * _e177) + _e179)] = _e254;
global_8.member[((15u * _e177) + _e179)] = _e265;
global_8.member[((16u * _e177) + _e179)] = _e3789;
global_8.member[((17u * _e177) + _e179)] = select(_e287, 2f, ((_e287 == 0f) || (_e287 == 4f)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
