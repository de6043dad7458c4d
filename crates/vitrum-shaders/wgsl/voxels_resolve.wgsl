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
}
struct type_23 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(3)
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
var local_44: i32;
var local_45: i32;
var local_46: i32;
var local_47: i32;
var local_48: i32;
var local_49: i32;
var phi_2440_: vec3<f32>;
var phi_3042_: i32;
var phi_3045_: i32;
var phi_3047_: i32;
var phi_3049_: i32;
var phi_3064_: i32;
var phi_3070_: i32;
var phi_3043_: i32;
var phi_3046_: i32;
var phi_3048_: i32;
var phi_3050_: i32;
var local_50: i32;
var local_51: i32;
var local_52: i32;
var phi_3145_: i32;
var local_53: i32;
var local_54: i32;
var phi_3151_: i32;
var local_55: i32;
var phi_3158_: i32;
var local_56: i32;
var local_57: i32;
var phi_3164_: i32;
var local_58: i32;
var local_59: i32;
var phi_3175_: i32;
var local_60: i32;
var local_61: i32;
var phi_3187_: i32;
var local_62: i32;
var local_63: i32;
var local_64: i32;
var local_65: i32;
var phi_3423_: i32;
var phi_3426_: i32;
var phi_3428_: i32;
var phi_3430_: i32;
var phi_3445_: i32;
var phi_3451_: i32;
var phi_3424_: i32;
var phi_3427_: i32;
var phi_3429_: i32;
var phi_3431_: i32;
var local_66: i32;
var local_67: i32;
var local_68: i32;
var phi_3526_: i32;
var local_69: i32;
var local_70: i32;
var phi_3532_: i32;
var local_71: i32;
var phi_3539_: i32;
var local_72: i32;
var local_73: i32;
var phi_3545_: i32;
var local_74: i32;
var local_75: i32;
var phi_3556_: i32;
var local_76: i32;
var local_77: i32;
var phi_3568_: i32;
var local_78: i32;
var local_79: i32;
var local_80: i32;
var local_81: i32;
var phi_3823_: vec3<f32>;
var phi_3824_: vec3<f32>;
var phi_3825_: vec3<f32>;
var phi_4688_: type_23;
var phi_5262_: vec3<f32>;
var phi_5265_: vec3<f32>;
var phi_5278_: type_22;
var phi_5745_: f32;
var phi_5748_: vec3<f32>;
var phi_5750_: i32;
var phi_5765_: i32;
var phi_5768_: f32;
var phi_5770_: vec3<f32>;
var phi_6003_: vec3<f32>;
var phi_6013_: vec3<f32>;
var phi_5766_: i32;
var phi_5769_: f32;
var phi_5771_: vec3<f32>;
var phi_5746_: f32;
var phi_5749_: vec3<f32>;
var phi_5751_: i32;
var local_82: f32;
var local_83: f32;
var local_84: vec3<f32>;
var local_85: vec3<f32>;
var local_86: vec3<f32>;
var phi_6131_: vec3<f32>;
var phi_6132_: vec3<f32>;
var phi_6797_: vec3<f32>;
var phi_7399_: i32;
var phi_7402_: i32;
var phi_7404_: i32;
var phi_7406_: i32;
var phi_7421_: i32;
var phi_7427_: i32;
var phi_7400_: i32;
var phi_7403_: i32;
var phi_7405_: i32;
var phi_7407_: i32;
var local_87: i32;
var local_88: i32;
var local_89: i32;
var phi_7502_: i32;
var local_90: i32;
var local_91: i32;
var phi_7508_: i32;
var local_92: i32;
var phi_7515_: i32;
var local_93: i32;
var local_94: i32;
var phi_7521_: i32;
var local_95: i32;
var local_96: i32;
var phi_7532_: i32;
var local_97: i32;
var local_98: i32;
var phi_7544_: i32;
var local_99: i32;
var local_100: i32;
var local_101: i32;
var local_102: i32;
var phi_7780_: i32;
var phi_7783_: i32;
var phi_7785_: i32;
var phi_7787_: i32;
var phi_7802_: i32;
var phi_7808_: i32;
var phi_7781_: i32;
var phi_7784_: i32;
var phi_7786_: i32;
var phi_7788_: i32;
var local_103: i32;
var local_104: i32;
var local_105: i32;
var phi_7883_: i32;
var local_106: i32;
var local_107: i32;
var phi_7889_: i32;
var local_108: i32;
var phi_7896_: i32;
var local_109: i32;
var local_110: i32;
var phi_7902_: i32;
var local_111: i32;
var local_112: i32;
var phi_7913_: i32;
var local_113: i32;
var local_114: i32;
var phi_7925_: i32;
var local_115: i32;
var local_116: i32;
var local_117: i32;
var local_118: i32;
var phi_8180_: vec3<f32>;
var phi_8181_: vec3<f32>;
var phi_8182_: vec3<f32>;
var phi_9157_: type_23;
var phi_9731_: vec3<f32>;
var phi_9734_: vec3<f32>;
var phi_9747_: type_22;
var phi_10214_: f32;
var phi_10217_: vec3<f32>;
var phi_10219_: i32;
var phi_10234_: i32;
var phi_10237_: f32;
var phi_10239_: vec3<f32>;
var phi_10472_: vec3<f32>;
var phi_10482_: vec3<f32>;
var phi_10235_: i32;
var phi_10238_: f32;
var phi_10240_: vec3<f32>;
var phi_10215_: f32;
var phi_10218_: vec3<f32>;
var phi_10220_: i32;
var local_119: f32;
var local_120: f32;
var local_121: vec3<f32>;
var local_122: vec3<f32>;
var local_123: vec3<f32>;
var phi_10534_: vec3<f32>;
var phi_10535_: vec3<f32>;
var local_124: f32;
var local_125: vec3<f32>;
var local_126: f32;
var local_127: vec3<f32>;
let _e158 = global;
let _e164 = arrayLength((&global_3.member));
let _e166 = arrayLength((&global_4.member));
let _e168 = arrayLength((&global_5.member));
let _e170 = arrayLength((&global_6.member));
let _e176 = global_1.member.member;
if (_e158.x < _e176.member) {
if (_e158.y < _e176.member_1) {
let _e183 = (_e176.member * _e176.member_1);
let _e185 = ((_e158.y * _e176.member) + _e158.x);
let _e187 = bitcast<i32>(_e158.x);
let _e188 = bitcast<i32>(_e158.y);
let _e192 = global_1.member.member.member;
let _e193 = bitcast<i32>(_e192);
let _e194 = (_e188 * _e193);
let _e195 = (_e194 + _e187);
local_48 = _e195;
let _e199 = global_1.member.member.member_1;
let _e201 = bitcast<i32>((_e192 * _e199));
local_49 = _e201;
let _e202 = local_48;
local_46 = _e202;
local_47 = _e201;
let _e203 = local_47;
let _e205 = local_46;
let _e206 = ((3i * _e203) + _e205);
let _e208 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e210 = select(_e208, _e206, (_e206 < _e208));
let _e215 = global_2.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e216 = local_47;
let _e218 = local_46;
let _e219 = ((4i * _e216) + _e218);
let _e221 = select(_e208, _e219, (_e219 < _e208));
let _e226 = global_2.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e227 = local_47;
let _e229 = local_46;
let _e230 = ((5i * _e227) + _e229);
let _e232 = select(_e208, _e230, (_e230 < _e208));
let _e237 = global_2.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e238 = local_48;
local_44 = _e238;
local_45 = _e201;
let _e239 = local_45;
let _e241 = local_44;
let _e242 = ((6i * _e239) + _e241);
let _e244 = select(_e208, _e242, (_e242 < _e208));
let _e249 = global_2.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e250 = local_45;
let _e252 = local_44;
let _e253 = ((7i * _e250) + _e252);
let _e255 = select(_e208, _e253, (_e253 < _e208));
let _e260 = global_2.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e261 = local_45;
let _e263 = local_44;
let _e264 = ((8i * _e261) + _e263);
let _e266 = select(_e208, _e264, (_e264 < _e208));
let _e271 = global_2.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e272 = local_49;
let _e274 = local_48;
let _e275 = ((18i * _e272) + _e274);
let _e277 = select(_e208, _e275, (_e275 < _e208));
let _e282 = global_2.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e283 = local_49;
let _e285 = local_48;
let _e286 = ((16i * _e283) + _e285);
let _e288 = select(_e208, _e286, (_e286 < _e208));
let _e293 = global_2.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e294 = (_e176.member_2 == 1u);
let _e296 = (_e294 && (_e293 == 3f));
let _e297 = (_e187 - 1i);
let _e298 = bitcast<i32>(_e199);
local_41 = _e193;
local_42 = _e298;
let _e300 = local_41;
let _e303 = (_e188 >= 0i);
let _e305 = local_42;
let _e307 = ((((_e297 >= 0i) && (_e297 < _e300)) && _e303) && (_e188 < _e305));
if _e307 {
let _e308 = local_41;
local_43 = ((_e188 * _e308) + _e297);
} else {
local_43 = 0i;
}
let _e311 = local_41;
let _e312 = local_42;
let _e315 = local_43;
let _e316 = ((18i * (_e311 * _e312)) + _e315);
let _e318 = select(_e208, _e316, (_e316 < _e208));
let _e323 = global_2.member[bitcast<u32>(select(0i, _e318, (_e318 > 0i)))];
let _e326 = local_41;
let _e327 = local_42;
let _e330 = local_43;
let _e331 = ((16i * (_e326 * _e327)) + _e330);
let _e333 = select(_e208, _e331, (_e331 < _e208));
let _e338 = global_2.member[bitcast<u32>(select(0i, _e333, (_e333 > 0i)))];
let _e340 = ((_e307 && (_e323 == _e282)) && (_e338 == _e293));
let _e341 = local_43;
local_39 = _e341;
local_40 = _e201;
let _e342 = local_40;
let _e344 = local_39;
let _e345 = ((3i * _e342) + _e344);
let _e347 = select(_e208, _e345, (_e345 < _e208));
let _e352 = global_2.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e353 = local_40;
let _e355 = local_39;
let _e356 = ((4i * _e353) + _e355);
let _e358 = select(_e208, _e356, (_e356 < _e208));
let _e363 = global_2.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e364 = local_40;
let _e366 = local_39;
let _e367 = ((5i * _e364) + _e366);
let _e369 = select(_e208, _e367, (_e367 < _e208));
let _e374 = global_2.member[bitcast<u32>(select(0i, _e369, (_e369 > 0i)))];
let _e375 = local_41;
let _e376 = local_42;
let _e379 = local_43;
let _e380 = ((21i * (_e375 * _e376)) + _e379);
let _e382 = select(_e208, _e380, (_e380 < _e208));
let _e387 = global_2.member[bitcast<u32>(select(0i, _e382, (_e382 > 0i)))];
let _e389 = (_e307 && (_e387 > 0f));
let _e390 = f32(_e193);
let _e391 = f32(_e298);
let _e400 = global_1.member.member_6.member;
let _e401 = (((((f32(_e297) + 0.5f) / _e390) * 2f) - 1f) * _e400);
let _e410 = global_1.member.member_6.member_1;
let _e411 = ((1f - (((f32(_e188) + 0.5f) / _e391) * 2f)) * _e410);
let _e414 = global_1.member.member_7;
let _e423 = global_1.member.member_8;
let _e427 = (_e423.member * _e411);
let _e428 = (_e423.member_1 * _e411);
let _e429 = (_e423.member_2 * _e411);
let _e436 = global_1.member.member_6.member_3;
let _e438 = select(1f, 0f, (_e436 != 0u));
let _e441 = global_1.member.member_9;
let _e448 = (_e441.member + (((_e414.member * _e401) + _e427) * _e438));
let _e449 = (_e441.member_1 + (((_e414.member_1 * _e401) + _e428) * _e438));
let _e450 = (_e441.member_2 + (((_e414.member_2 * _e401) + _e429) * _e438));
let _e455 = (((_e448 * _e448) + (_e449 * _e449)) + (_e450 * _e450));
let _e458 = sqrt(select(0f, _e455, (_e455 > 0f)));
let _e461 = (1f / select(1e-20f, _e458, (_e458 > 1e-20f)));
let _e462 = (_e448 * _e461);
let _e463 = (_e449 * _e461);
let _e464 = (_e450 * _e461);
local_37 = (_e194 + _e297);
local_38 = _e201;
let _e466 = local_38;
let _e468 = local_37;
let _e469 = ((9i * _e466) + _e468);
let _e471 = select(_e208, _e469, (_e469 < _e208));
let _e476 = global_2.member[bitcast<u32>(select(0i, _e471, (_e471 > 0i)))];
let _e477 = local_38;
let _e479 = local_37;
let _e480 = ((10i * _e477) + _e479);
let _e482 = select(_e208, _e480, (_e480 < _e208));
let _e487 = global_2.member[bitcast<u32>(select(0i, _e482, (_e482 > 0i)))];
let _e488 = local_38;
let _e490 = local_37;
let _e491 = ((11i * _e488) + _e490);
let _e493 = select(_e208, _e491, (_e491 < _e208));
let _e498 = global_2.member[bitcast<u32>(select(0i, _e493, (_e493 > 0i)))];
let _e504 = (2f * (((_e462 * _e476) + (_e463 * _e487)) + (_e464 * _e498)));
let _e508 = (_e462 - (_e476 * _e504));
let _e509 = (_e463 - (_e487 * _e504));
let _e510 = (_e464 - (_e498 * _e504));
let _e511 = (_e187 + 1i);
local_34 = _e193;
local_35 = _e298;
let _e513 = local_34;
let _e517 = local_35;
let _e519 = ((((_e511 >= 0i) && (_e511 < _e513)) && _e303) && (_e188 < _e517));
if _e519 {
let _e520 = local_34;
local_36 = ((_e188 * _e520) + _e511);
} else {
local_36 = 0i;
}
let _e523 = local_34;
let _e524 = local_35;
let _e527 = local_36;
let _e528 = ((18i * (_e523 * _e524)) + _e527);
let _e530 = select(_e208, _e528, (_e528 < _e208));
let _e535 = global_2.member[bitcast<u32>(select(0i, _e530, (_e530 > 0i)))];
let _e538 = local_34;
let _e539 = local_35;
let _e542 = local_36;
let _e543 = ((16i * (_e538 * _e539)) + _e542);
let _e545 = select(_e208, _e543, (_e543 < _e208));
let _e550 = global_2.member[bitcast<u32>(select(0i, _e545, (_e545 > 0i)))];
let _e552 = ((_e519 && (_e535 == _e282)) && (_e550 == _e293));
let _e553 = local_36;
local_32 = _e553;
local_33 = _e201;
let _e554 = local_33;
let _e556 = local_32;
let _e557 = ((3i * _e554) + _e556);
let _e559 = select(_e208, _e557, (_e557 < _e208));
let _e564 = global_2.member[bitcast<u32>(select(0i, _e559, (_e559 > 0i)))];
let _e565 = local_33;
let _e567 = local_32;
let _e568 = ((4i * _e565) + _e567);
let _e570 = select(_e208, _e568, (_e568 < _e208));
let _e575 = global_2.member[bitcast<u32>(select(0i, _e570, (_e570 > 0i)))];
let _e576 = local_33;
let _e578 = local_32;
let _e579 = ((5i * _e576) + _e578);
let _e581 = select(_e208, _e579, (_e579 < _e208));
let _e586 = global_2.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e587 = local_34;
let _e588 = local_35;
let _e591 = local_36;
let _e592 = ((21i * (_e587 * _e588)) + _e591);
let _e594 = select(_e208, _e592, (_e592 < _e208));
let _e599 = global_2.member[bitcast<u32>(select(0i, _e594, (_e594 > 0i)))];
let _e601 = (_e519 && (_e599 > 0f));
let _e607 = (((((f32(_e511) + 0.5f) / _e390) * 2f) - 1f) * _e400);
let _e617 = (_e441.member + (((_e414.member * _e607) + _e427) * _e438));
let _e618 = (_e441.member_1 + (((_e414.member_1 * _e607) + _e428) * _e438));
let _e619 = (_e441.member_2 + (((_e414.member_2 * _e607) + _e429) * _e438));
let _e624 = (((_e617 * _e617) + (_e618 * _e618)) + (_e619 * _e619));
let _e627 = sqrt(select(0f, _e624, (_e624 > 0f)));
let _e630 = (1f / select(1e-20f, _e627, (_e627 > 1e-20f)));
let _e631 = (_e617 * _e630);
let _e632 = (_e618 * _e630);
let _e633 = (_e619 * _e630);
local_30 = (_e194 + _e511);
local_31 = _e201;
let _e635 = local_31;
let _e637 = local_30;
let _e638 = ((9i * _e635) + _e637);
let _e640 = select(_e208, _e638, (_e638 < _e208));
let _e645 = global_2.member[bitcast<u32>(select(0i, _e640, (_e640 > 0i)))];
let _e646 = local_31;
let _e648 = local_30;
let _e649 = ((10i * _e646) + _e648);
let _e651 = select(_e208, _e649, (_e649 < _e208));
let _e656 = global_2.member[bitcast<u32>(select(0i, _e651, (_e651 > 0i)))];
let _e657 = local_31;
let _e659 = local_30;
let _e660 = ((11i * _e657) + _e659);
let _e662 = select(_e208, _e660, (_e660 < _e208));
let _e667 = global_2.member[bitcast<u32>(select(0i, _e662, (_e662 > 0i)))];
let _e673 = (2f * (((_e631 * _e645) + (_e632 * _e656)) + (_e633 * _e667)));
let _e677 = (_e631 - (_e645 * _e673));
let _e678 = (_e632 - (_e656 * _e673));
let _e679 = (_e633 - (_e667 * _e673));
let _e680 = (_e188 - 1i);
local_27 = _e193;
local_28 = _e298;
let _e681 = (_e187 >= 0i);
let _e682 = local_27;
let _e687 = local_28;
let _e689 = (((_e681 && (_e187 < _e682)) && (_e680 >= 0i)) && (_e680 < _e687));
if _e689 {
let _e690 = local_27;
local_29 = ((_e680 * _e690) + _e187);
} else {
local_29 = 0i;
}
let _e693 = local_27;
let _e694 = local_28;
let _e697 = local_29;
let _e698 = ((18i * (_e693 * _e694)) + _e697);
let _e700 = select(_e208, _e698, (_e698 < _e208));
let _e705 = global_2.member[bitcast<u32>(select(0i, _e700, (_e700 > 0i)))];
let _e708 = local_27;
let _e709 = local_28;
let _e712 = local_29;
let _e713 = ((16i * (_e708 * _e709)) + _e712);
let _e715 = select(_e208, _e713, (_e713 < _e208));
let _e720 = global_2.member[bitcast<u32>(select(0i, _e715, (_e715 > 0i)))];
let _e722 = ((_e689 && (_e705 == _e282)) && (_e720 == _e293));
let _e723 = local_29;
local_25 = _e723;
local_26 = _e201;
let _e724 = local_26;
let _e726 = local_25;
let _e727 = ((3i * _e724) + _e726);
let _e729 = select(_e208, _e727, (_e727 < _e208));
let _e734 = global_2.member[bitcast<u32>(select(0i, _e729, (_e729 > 0i)))];
let _e735 = local_26;
let _e737 = local_25;
let _e738 = ((4i * _e735) + _e737);
let _e740 = select(_e208, _e738, (_e738 < _e208));
let _e745 = global_2.member[bitcast<u32>(select(0i, _e740, (_e740 > 0i)))];
let _e746 = local_26;
let _e748 = local_25;
let _e749 = ((5i * _e746) + _e748);
let _e751 = select(_e208, _e749, (_e749 < _e208));
let _e756 = global_2.member[bitcast<u32>(select(0i, _e751, (_e751 > 0i)))];
let _e757 = local_27;
let _e758 = local_28;
let _e761 = local_29;
let _e762 = ((21i * (_e757 * _e758)) + _e761);
let _e764 = select(_e208, _e762, (_e762 < _e208));
let _e769 = global_2.member[bitcast<u32>(select(0i, _e764, (_e764 > 0i)))];
let _e771 = (_e689 && (_e769 > 0f));
let _e777 = (((((f32(_e187) + 0.5f) / _e390) * 2f) - 1f) * _e400);
let _e783 = ((1f - (((f32(_e680) + 0.5f) / _e391) * 2f)) * _e410);
let _e784 = (_e414.member * _e777);
let _e785 = (_e414.member_1 * _e777);
let _e786 = (_e414.member_2 * _e777);
let _e796 = (_e441.member + ((_e784 + (_e423.member * _e783)) * _e438));
let _e797 = (_e441.member_1 + ((_e785 + (_e423.member_1 * _e783)) * _e438));
let _e798 = (_e441.member_2 + ((_e786 + (_e423.member_2 * _e783)) * _e438));
let _e803 = (((_e796 * _e796) + (_e797 * _e797)) + (_e798 * _e798));
let _e806 = sqrt(select(0f, _e803, (_e803 > 0f)));
let _e809 = (1f / select(1e-20f, _e806, (_e806 > 1e-20f)));
let _e810 = (_e796 * _e809);
let _e811 = (_e797 * _e809);
let _e812 = (_e798 * _e809);
local_23 = ((_e680 * _e193) + _e187);
local_24 = _e201;
let _e815 = local_24;
let _e817 = local_23;
let _e818 = ((9i * _e815) + _e817);
let _e820 = select(_e208, _e818, (_e818 < _e208));
let _e825 = global_2.member[bitcast<u32>(select(0i, _e820, (_e820 > 0i)))];
let _e826 = local_24;
let _e828 = local_23;
let _e829 = ((10i * _e826) + _e828);
let _e831 = select(_e208, _e829, (_e829 < _e208));
let _e836 = global_2.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e837 = local_24;
let _e839 = local_23;
let _e840 = ((11i * _e837) + _e839);
let _e842 = select(_e208, _e840, (_e840 < _e208));
let _e847 = global_2.member[bitcast<u32>(select(0i, _e842, (_e842 > 0i)))];
let _e853 = (2f * (((_e810 * _e825) + (_e811 * _e836)) + (_e812 * _e847)));
let _e857 = (_e810 - (_e825 * _e853));
let _e858 = (_e811 - (_e836 * _e853));
let _e859 = (_e812 - (_e847 * _e853));
let _e860 = (_e188 + 1i);
local_20 = _e193;
local_21 = _e298;
let _e861 = local_20;
let _e866 = local_21;
let _e868 = (((_e681 && (_e187 < _e861)) && (_e860 >= 0i)) && (_e860 < _e866));
if _e868 {
let _e869 = local_20;
local_22 = ((_e860 * _e869) + _e187);
} else {
local_22 = 0i;
}
let _e872 = local_20;
let _e873 = local_21;
let _e876 = local_22;
let _e877 = ((18i * (_e872 * _e873)) + _e876);
let _e879 = select(_e208, _e877, (_e877 < _e208));
let _e884 = global_2.member[bitcast<u32>(select(0i, _e879, (_e879 > 0i)))];
let _e887 = local_20;
let _e888 = local_21;
let _e891 = local_22;
let _e892 = ((16i * (_e887 * _e888)) + _e891);
let _e894 = select(_e208, _e892, (_e892 < _e208));
let _e899 = global_2.member[bitcast<u32>(select(0i, _e894, (_e894 > 0i)))];
let _e901 = ((_e868 && (_e884 == _e282)) && (_e899 == _e293));
let _e902 = local_22;
local_18 = _e902;
local_19 = _e201;
let _e903 = local_19;
let _e905 = local_18;
let _e906 = ((3i * _e903) + _e905);
let _e908 = select(_e208, _e906, (_e906 < _e208));
let _e913 = global_2.member[bitcast<u32>(select(0i, _e908, (_e908 > 0i)))];
let _e914 = local_19;
let _e916 = local_18;
let _e917 = ((4i * _e914) + _e916);
let _e919 = select(_e208, _e917, (_e917 < _e208));
let _e924 = global_2.member[bitcast<u32>(select(0i, _e919, (_e919 > 0i)))];
let _e925 = local_19;
let _e927 = local_18;
let _e928 = ((5i * _e925) + _e927);
let _e930 = select(_e208, _e928, (_e928 < _e208));
let _e935 = global_2.member[bitcast<u32>(select(0i, _e930, (_e930 > 0i)))];
let _e936 = local_20;
let _e937 = local_21;
let _e940 = local_22;
let _e941 = ((21i * (_e936 * _e937)) + _e940);
let _e943 = select(_e208, _e941, (_e941 < _e208));
let _e948 = global_2.member[bitcast<u32>(select(0i, _e943, (_e943 > 0i)))];
let _e950 = (_e868 && (_e948 > 0f));
let _e956 = ((1f - (((f32(_e860) + 0.5f) / _e391) * 2f)) * _e410);
let _e966 = (_e441.member + ((_e784 + (_e423.member * _e956)) * _e438));
let _e967 = (_e441.member_1 + ((_e785 + (_e423.member_1 * _e956)) * _e438));
let _e968 = (_e441.member_2 + ((_e786 + (_e423.member_2 * _e956)) * _e438));
let _e973 = (((_e966 * _e966) + (_e967 * _e967)) + (_e968 * _e968));
let _e976 = sqrt(select(0f, _e973, (_e973 > 0f)));
let _e979 = (1f / select(1e-20f, _e976, (_e976 > 1e-20f)));
let _e980 = (_e966 * _e979);
let _e981 = (_e967 * _e979);
let _e982 = (_e968 * _e979);
local_16 = ((_e860 * _e193) + _e187);
local_17 = _e201;
let _e985 = local_17;
let _e987 = local_16;
let _e988 = ((9i * _e985) + _e987);
let _e990 = select(_e208, _e988, (_e988 < _e208));
let _e995 = global_2.member[bitcast<u32>(select(0i, _e990, (_e990 > 0i)))];
let _e996 = local_17;
let _e998 = local_16;
let _e999 = ((10i * _e996) + _e998);
let _e1001 = select(_e208, _e999, (_e999 < _e208));
let _e1006 = global_2.member[bitcast<u32>(select(0i, _e1001, (_e1001 > 0i)))];
let _e1007 = local_17;
let _e1009 = local_16;
let _e1010 = ((11i * _e1007) + _e1009);
let _e1012 = select(_e208, _e1010, (_e1010 < _e208));
let _e1017 = global_2.member[bitcast<u32>(select(0i, _e1012, (_e1012 > 0i)))];
let _e1023 = (2f * (((_e980 * _e995) + (_e981 * _e1006)) + (_e982 * _e1017)));
let _e1027 = (_e980 - (_e995 * _e1023));
let _e1028 = (_e981 - (_e1006 * _e1023));
let _e1029 = (_e982 - (_e1017 * _e1023));
let _e1030 = (_e784 + _e427);
let _e1031 = (_e785 + _e428);
let _e1032 = (_e786 + _e429);
let _e1036 = (_e441.member + (_e1030 * _e438));
let _e1037 = (_e441.member_1 + (_e1031 * _e438));
let _e1038 = (_e441.member_2 + (_e1032 * _e438));
let _e1043 = (((_e1036 * _e1036) + (_e1037 * _e1037)) + (_e1038 * _e1038));
let _e1046 = sqrt(select(0f, _e1043, (_e1043 > 0f)));
let _e1049 = (1f / select(1e-20f, _e1046, (_e1046 > 1e-20f)));
let _e1050 = (_e1036 * _e1049);
let _e1051 = (_e1037 * _e1049);
let _e1052 = (_e1038 * _e1049);
let _e1053 = (_e631 - _e1050);
let _e1054 = (_e632 - _e1051);
let _e1055 = (_e633 - _e1052);
let _e1060 = (((_e1053 * _e1053) + (_e1054 * _e1054)) + (_e1055 * _e1055));
let _e1063 = sqrt(select(0f, _e1060, (_e1060 > 0f)));
let _e1064 = local_48;
local_12 = _e1064;
local_13 = _e201;
let _e1065 = local_12;
local_14 = _e1065;
local_15 = _e201;
let _e1066 = local_15;
let _e1068 = local_14;
let _e1069 = ((3i * _e1066) + _e1068);
let _e1071 = select(_e208, _e1069, (_e1069 < _e208));
let _e1076 = global_2.member[bitcast<u32>(select(0i, _e1071, (_e1071 > 0i)))];
let _e1077 = local_15;
let _e1079 = local_14;
let _e1080 = ((4i * _e1077) + _e1079);
let _e1082 = select(_e208, _e1080, (_e1080 < _e208));
let _e1087 = global_2.member[bitcast<u32>(select(0i, _e1082, (_e1082 > 0i)))];
let _e1088 = local_15;
let _e1090 = local_14;
let _e1091 = ((5i * _e1088) + _e1090);
let _e1093 = select(_e208, _e1091, (_e1091 < _e208));
let _e1098 = global_2.member[bitcast<u32>(select(0i, _e1093, (_e1093 > 0i)))];
let _e1099 = local_13;
let _e1101 = local_12;
let _e1102 = ((18i * _e1099) + _e1101);
let _e1104 = select(_e208, _e1102, (_e1102 < _e208));
let _e1109 = global_2.member[bitcast<u32>(select(0i, _e1104, (_e1104 > 0i)))];
let _e1111 = (_e564 - _e352);
let _e1112 = (_e575 - _e363);
let _e1113 = (_e586 - _e374);
let _e1118 = (((_e1111 * _e1111) + (_e1112 * _e1112)) + (_e1113 * _e1113));
let _e1123 = (_e564 - _e1076);
let _e1124 = (_e575 - _e1087);
let _e1125 = (_e586 - _e1098);
let _e1130 = (((_e1123 * _e1123) + (_e1124 * _e1124)) + (_e1125 * _e1125));
let _e1134 = (_e1076 - _e352);
let _e1135 = (_e1087 - _e363);
let _e1136 = (_e1098 - _e374);
let _e1141 = (((_e1134 * _e1134) + (_e1135 * _e1135)) + (_e1136 * _e1136));
let _e1149 = select(select(_e1063, select(sqrt(select(0f, _e1141, (_e1141 > 0f))), sqrt(select(0f, _e1130, (_e1130 > 0f))), _e552), (_e340 || _e552)), (0.5f * sqrt(select(0f, _e1118, (_e1118 > 0f)))), (_e340 && _e552));
let _e1150 = (_e913 - _e734);
let _e1151 = (_e924 - _e745);
let _e1152 = (_e935 - _e756);
let _e1157 = (((_e1150 * _e1150) + (_e1151 * _e1151)) + (_e1152 * _e1152));
let _e1162 = (_e913 - _e1076);
let _e1163 = (_e924 - _e1087);
let _e1164 = (_e935 - _e1098);
let _e1169 = (((_e1162 * _e1162) + (_e1163 * _e1163)) + (_e1164 * _e1164));
let _e1173 = (_e1076 - _e734);
let _e1174 = (_e1087 - _e745);
let _e1175 = (_e1098 - _e756);
let _e1180 = (((_e1173 * _e1173) + (_e1174 * _e1174)) + (_e1175 * _e1175));
let _e1188 = select(select(_e1063, select(sqrt(select(0f, _e1180, (_e1180 > 0f))), sqrt(select(0f, _e1169, (_e1169 > 0f))), _e901), (_e722 || _e901)), (0.5f * sqrt(select(0f, _e1157, (_e1157 > 0f)))), (_e722 && _e901));
let _e1191 = select(_e1063, select(_e1188, _e1149, (_e1149 > _e1188)), (_e1109 > 0f));
let _e1195 = global_1.member.member_16.member_4;
let _e1203 = (((_e1195.member * _e1076) + (_e1195.member_1 * _e1087)) + (_e1195.member_2 * _e1098));
let _e1207 = global_1.member.member_16.member_5;
let _e1215 = (((_e1207.member * _e1076) + (_e1207.member_1 * _e1087)) + (_e1207.member_2 * _e1098));
let _e1219 = global_1.member.member_16.member_6;
let _e1227 = (((_e1219.member * _e1076) + (_e1219.member_1 * _e1087)) + (_e1219.member_2 * _e1098));
let _e1231 = global_1.member.member_16.member;
let _e1235 = global_1.member.member_16.member_7;
let _e1239 = vec3<f32>(_e1235.member, _e1235.member_1, _e1235.member_2);
let _e1243 = global_1.member.member_16.member_8;
let _e1247 = (_e1231 == 0u);
if _e1247 {
phi_3825_ = _e1239;
} else {
if (_e1231 == 1u) {
let _e1250 = select(-1f, _e1227, (_e1227 > -1f));
let _e1252 = select(1f, _e1250, (_e1250 < 1f));
if (_e1252 > 0f) {
phi_2440_ = _e1239;
} else {
let _e1257 = global_1.member.member_16.member_9;
phi_2440_ = vec3<f32>(_e1257.member, _e1257.member_1, _e1257.member_2);
}
let _e1263 = phi_2440_;
let _e1272 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
let _e1275 = sqrt(select(0f, _e1272, (_e1272 > 0f)));
phi_3824_ = vec3<f32>((_e1243.member + ((_e1263.x - _e1243.member) * _e1275)), (_e1243.member_1 + ((_e1263.y - _e1243.member_1) * _e1275)), (_e1243.member_2 + ((_e1263.z - _e1243.member_2) * _e1275)));
} else {
if (_e1231 == 2u) {
let _e1287 = global_1.member.member_16.member_10;
let _e1288 = (_e1191 / _e1287);
let _e1290 = select(1e-4f, _e1288, (_e1288 > 1e-4f));
let _e1293 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
let _e1296 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
let _e1300 = select(_e1296, _e1293, (_e1293 > _e1296));
let _e1303 = (select(_e1296, _e1293, (_e1293 < _e1296)) / select(1.1754944e-38f, _e1300, (_e1300 > 1.1754944e-38f)));
let _e1304 = (_e1303 > 0.41421357f);
let _e1308 = select(_e1303, ((_e1303 - 1f) / (_e1303 + 1f)), _e1304);
let _e1309 = (_e1308 * _e1308);
let _e1324 = (select(0f, 0.7853982f, _e1304) + (_e1308 + ((_e1308 * _e1309) * (-0.33333334f + (_e1309 * (0.2f + (_e1309 * (-0.14285713f + (_e1309 * (0.11111111f + (_e1309 * (-0.09090909f + (_e1309 * 0.0585f)))))))))))));
let _e1327 = select(_e1324, (1.5707964f - _e1324), (_e1296 > _e1293));
let _e1330 = select(_e1327, (3.1415927f - _e1327), (_e1203 < 0f));
let _e1336 = (1f - (_e1227 * _e1227));
let _e1339 = sqrt(select(0f, _e1336, (_e1336 > 0f)));
let _e1342 = (_e1290 / select(1e-3f, _e1339, (_e1339 > 1e-3f)));
let _e1343 = ((select(_e1330, -(_e1330), (_e1215 < 0f)) / _e1287) * 0.5f);
let _e1345 = select(-8e6f, _e1343, (_e1343 > -8e6f));
let _e1347 = select(8e6f, _e1345, (_e1345 < 8e6f));
let _e1354 = select(0i, select(select(i32(_e1347), i32(-2147483648), (_e1347 < -2147483600f)), 2147483647i, (_e1347 > 2147483500f)), (_e1347 == _e1347));
let _e1361 = ((_e1343 - f32((_e1354 - select(0i, 1i, (_e1347 < f32(_e1354)))))) * 2f);
let _e1369 = ((select(select((_e1361 - 2f), (1f - _e1361), (_e1361 < 1.5f)), _e1361, (_e1361 < 0.5f)) * 2f) / _e1342);
let _e1371 = select(-1f, _e1369, (_e1369 > -1f));
let _e1374 = (2f - _e1342);
let _e1376 = select(0f, _e1374, (_e1374 > 0f));
let _e1381 = select(-1f, _e1227, (_e1227 > -1f));
let _e1383 = select(1f, _e1381, (_e1381 < 1f));
let _e1386 = ((1f - _e1383) * (1f + _e1383));
let _e1389 = sqrt(select(0f, _e1386, (_e1386 > 0f)));
let _e1392 = bitcast<f32>((bitcast<u32>(_e1389) & 2147483647u));
let _e1395 = bitcast<f32>((bitcast<u32>(_e1383) & 2147483647u));
let _e1399 = select(_e1395, _e1392, (_e1392 > _e1395));
let _e1402 = (select(_e1395, _e1392, (_e1392 < _e1395)) / select(1.1754944e-38f, _e1399, (_e1399 > 1.1754944e-38f)));
let _e1403 = (_e1402 > 0.41421357f);
let _e1407 = select(_e1402, ((_e1402 - 1f) / (_e1402 + 1f)), _e1403);
let _e1408 = (_e1407 * _e1407);
let _e1423 = (select(0f, 0.7853982f, _e1403) + (_e1407 + ((_e1407 * _e1408) * (-0.33333334f + (_e1408 * (0.2f + (_e1408 * (-0.14285713f + (_e1408 * (0.11111111f + (_e1408 * (-0.09090909f + (_e1408 * 0.0585f)))))))))))));
let _e1426 = select(_e1423, (1.5707964f - _e1423), (_e1395 > _e1392));
let _e1429 = select(_e1426, (3.1415927f - _e1426), (_e1389 < 0f));
let _e1434 = ((select(_e1429, -(_e1429), (_e1383 < 0f)) / _e1287) * 0.5f);
let _e1436 = select(-8e6f, _e1434, (_e1434 > -8e6f));
let _e1438 = select(8e6f, _e1436, (_e1436 < 8e6f));
let _e1445 = select(0i, select(select(i32(_e1438), i32(-2147483648), (_e1438 < -2147483600f)), 2147483647i, (_e1438 > 2147483500f)), (_e1438 == _e1438));
let _e1452 = ((_e1434 - f32((_e1445 - select(0i, 1i, (_e1438 < f32(_e1445)))))) * 2f);
let _e1460 = ((select(select((_e1452 - 2f), (1f - _e1452), (_e1452 < 1.5f)), _e1452, (_e1452 < 0.5f)) * 2f) / _e1290);
let _e1462 = select(-1f, _e1460, (_e1460 > -1f));
let _e1465 = (2f - _e1290);
let _e1467 = select(0f, _e1465, (_e1465 > 0f));
let _e1473 = (0.5f + ((0.5f * (select(1f, _e1371, (_e1371 < 1f)) * select(1f, _e1376, (_e1376 < 1f)))) * (select(1f, _e1462, (_e1462 < 1f)) * select(1f, _e1467, (_e1467 < 1f)))));
phi_3823_ = vec3<f32>((_e1235.member + ((_e1243.member - _e1235.member) * _e1473)), (_e1235.member_1 + ((_e1243.member_1 - _e1235.member_1) * _e1473)), (_e1235.member_2 + ((_e1243.member_2 - _e1235.member_2) * _e1473)));
} else {
let _e1487 = global_1.member.member_16.member_1;
let _e1488 = bitcast<i32>(_e1487);
let _e1493 = global_1.member.member_16.member_3;
let _e1495 = f32(bitcast<i32>(_e1493));
let _e1497 = (2f * 3.1415927f);
let _e1498 = ((_e1191 * f32(_e1488)) / _e1497);
let _e1500 = select(1e-6f, _e1498, (_e1498 > 1e-6f));
let _e1503 = bitcast<u32>(select(1.1754944e-38f, _e1500, (_e1500 > 1.1754944e-38f)));
let _e1504 = (_e1503 & 8388607u);
let _e1506 = select(0u, 1u, (_e1504 > 3474675u));
let _e1517 = bitcast<f32>((_e1504 | ((127u - _e1506) << bitcast<u32>(23i))));
let _e1520 = ((_e1517 - 1f) / (_e1517 + 1f));
let _e1521 = (_e1520 * _e1520);
let _e1536 = (f32(((bitcast<i32>((_e1503 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1506))) + (((2f * _e1520) + ((_e1520 * _e1521) * (0.6666667f + (_e1521 * (0.4f + (_e1521 * (0.2857143f + (_e1521 * (0.22222222f + (_e1521 * 0.18181819f)))))))))) * 1.442695f));
let _e1537 = (_e1495 - 1f);
let _e1539 = select(0f, _e1536, (_e1536 > 0f));
let _e1541 = select(_e1537, _e1539, (_e1539 < _e1537));
let _e1542 = (_e1495 - 2f);
let _e1544 = select(0f, _e1542, (_e1542 > 0f));
let _e1546 = select(0f, _e1541, (_e1541 > 0f));
let _e1548 = select(_e1544, _e1546, (_e1546 < _e1544));
let _e1555 = select(0i, select(select(i32(_e1548), i32(-2147483648), (_e1548 < -2147483600f)), 2147483647i, (_e1548 > 2147483500f)), (_e1548 == _e1548));
let _e1559 = (_e1555 - select(0i, 1i, (_e1548 < f32(_e1555))));
let _e1562 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
let _e1565 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
let _e1569 = select(_e1565, _e1562, (_e1562 > _e1565));
let _e1572 = (select(_e1565, _e1562, (_e1562 < _e1565)) / select(1.1754944e-38f, _e1569, (_e1569 > 1.1754944e-38f)));
let _e1573 = (_e1572 > 0.41421357f);
let _e1577 = select(_e1572, ((_e1572 - 1f) / (_e1572 + 1f)), _e1573);
let _e1578 = (_e1577 * _e1577);
let _e1593 = (select(0f, 0.7853982f, _e1573) + (_e1577 + ((_e1577 * _e1578) * (-0.33333334f + (_e1578 * (0.2f + (_e1578 * (-0.14285713f + (_e1578 * (0.11111111f + (_e1578 * (-0.09090909f + (_e1578 * 0.0585f)))))))))))));
let _e1596 = select(_e1593, (1.5707964f - _e1593), (_e1565 > _e1562));
let _e1599 = select(_e1596, (3.1415927f - _e1596), (_e1215 < 0f));
let _e1604 = (0.5f - (select(_e1599, -(_e1599), (_e1203 < 0f)) / _e1497));
let _e1606 = select(-1f, _e1227, (_e1227 > -1f));
let _e1608 = select(1f, _e1606, (_e1606 < 1f));
let _e1611 = ((1f - _e1608) * (1f + _e1608));
let _e1614 = sqrt(select(0f, _e1611, (_e1611 > 0f)));
let _e1617 = bitcast<f32>((bitcast<u32>(_e1614) & 2147483647u));
let _e1620 = bitcast<f32>((bitcast<u32>(_e1608) & 2147483647u));
let _e1624 = select(_e1620, _e1617, (_e1617 > _e1620));
let _e1627 = (select(_e1620, _e1617, (_e1617 < _e1620)) / select(1.1754944e-38f, _e1624, (_e1624 > 1.1754944e-38f)));
let _e1628 = (_e1627 > 0.41421357f);
let _e1632 = select(_e1627, ((_e1627 - 1f) / (_e1627 + 1f)), _e1628);
let _e1633 = (_e1632 * _e1632);
let _e1648 = (select(0f, 0.7853982f, _e1628) + (_e1632 + ((_e1632 * _e1633) * (-0.33333334f + (_e1633 * (0.2f + (_e1633 * (-0.14285713f + (_e1633 * (0.11111111f + (_e1633 * (-0.09090909f + (_e1633 * 0.0585f)))))))))))));
let _e1651 = select(_e1648, (1.5707964f - _e1648), (_e1620 > _e1617));
let _e1654 = select(_e1651, (3.1415927f - _e1651), (_e1614 < 0f));
let _e1659 = (0.5f - (select(_e1654, -(_e1654), (_e1608 < 0f)) / 3.1415927f));
let _e1663 = global_1.member.member_16.member_2;
let _e1664 = bitcast<i32>(_e1663);
phi_3042_ = 0i;
phi_3045_ = 0i;
phi_3047_ = _e1664;
phi_3049_ = _e1488;
loop {
let _e1666 = phi_3042_;
let _e1668 = phi_3045_;
let _e1670 = phi_3047_;
let _e1672 = phi_3049_;
local_50 = _e1672;
local_51 = _e1670;
local_52 = _e1672;
local_53 = _e1672;
local_54 = _e1672;
local_55 = _e1672;
local_56 = _e1672;
local_57 = _e1672;
local_58 = _e1670;
local_59 = _e1670;
local_60 = _e1670;
local_61 = _e1670;
local_62 = _e1672;
local_63 = _e1668;
local_64 = _e1672;
local_65 = _e1668;
let _e1673 = (_e1666 < _e1559);
if _e1673 {
if (_e1672 > 1i) {
phi_3064_ = (_e1672 >> bitcast<u32>(1i));
} else {
phi_3064_ = 1i;
}
let _e1680 = phi_3064_;
if (_e1670 > 1i) {
phi_3070_ = (_e1670 >> bitcast<u32>(1i));
} else {
phi_3070_ = 1i;
}
let _e1685 = phi_3070_;
phi_3043_ = (_e1666 + 1i);
phi_3046_ = (_e1668 + (_e1672 * _e1670));
phi_3048_ = _e1685;
phi_3050_ = _e1680;
} else {
phi_3043_ = i32();
phi_3046_ = i32();
phi_3048_ = i32();
phi_3050_ = i32();
}
let _e1688 = phi_3043_;
let _e1690 = phi_3046_;
let _e1692 = phi_3048_;
let _e1694 = phi_3050_;
continue;
continuing {
phi_3042_ = _e1688;
phi_3045_ = _e1690;
phi_3047_ = _e1692;
phi_3049_ = _e1694;
break if !(_e1673);
}
}
let _e1697 = local_50;
let _e1698 = f32(_e1697);
let _e1700 = ((_e1604 * _e1698) - 0.5f);
let _e1702 = local_51;
let _e1703 = f32(_e1702);
let _e1705 = ((_e1659 * _e1703) - 0.5f);
let _e1707 = select(-1f, _e1700, (_e1700 > -1f));
let _e1709 = select(_e1698, _e1707, (_e1707 < _e1698));
let _e1716 = select(0i, select(select(i32(_e1709), i32(-2147483648), (_e1709 < -2147483600f)), 2147483647i, (_e1709 > 2147483500f)), (_e1709 == _e1709));
let _e1720 = (_e1716 - select(0i, 1i, (_e1709 < f32(_e1716))));
let _e1722 = select(-1f, _e1705, (_e1705 > -1f));
let _e1724 = select(_e1703, _e1722, (_e1722 < _e1703));
let _e1731 = select(0i, select(select(i32(_e1724), i32(-2147483648), (_e1724 < -2147483600f)), 2147483647i, (_e1724 > 2147483500f)), (_e1724 == _e1724));
let _e1735 = (_e1731 - select(0i, 1i, (_e1724 < f32(_e1731))));
let _e1737 = (_e1700 - f32(_e1720));
let _e1739 = (_e1705 - f32(_e1735));
let _e1741 = select(0f, _e1739, (_e1739 > 0f));
let _e1743 = select(1f, _e1741, (_e1741 < 1f));
if (_e1720 < 0i) {
let _e1746 = local_52;
phi_3145_ = (_e1720 + _e1746);
} else {
phi_3145_ = _e1720;
}
let _e1749 = phi_3145_;
let _e1751 = local_53;
if (_e1749 >= _e1751) {
let _e1754 = local_54;
phi_3151_ = (_e1749 - _e1754);
} else {
phi_3151_ = _e1749;
}
let _e1757 = phi_3151_;
let _e1758 = (_e1720 + 1i);
if (_e1758 < 0i) {
let _e1761 = local_55;
phi_3158_ = (_e1758 + _e1761);
} else {
phi_3158_ = _e1758;
}
let _e1764 = phi_3158_;
let _e1766 = local_56;
if (_e1764 >= _e1766) {
let _e1769 = local_57;
phi_3164_ = (_e1764 - _e1769);
} else {
phi_3164_ = _e1764;
}
let _e1772 = phi_3164_;
let _e1774 = select(_e1735, 0i, (_e1735 < 0i));
let _e1776 = local_58;
if (_e1774 >= _e1776) {
let _e1779 = local_59;
phi_3175_ = (_e1779 - 1i);
} else {
phi_3175_ = _e1774;
}
let _e1782 = phi_3175_;
let _e1783 = (_e1735 + 1i);
let _e1785 = select(_e1783, 0i, (_e1783 < 0i));
let _e1787 = local_60;
if (_e1785 >= _e1787) {
let _e1790 = local_61;
phi_3187_ = (_e1790 - 1i);
} else {
phi_3187_ = _e1785;
}
let _e1793 = phi_3187_;
let _e1795 = local_62;
let _e1798 = local_63;
let _e1799 = (_e1798 + (_e1782 * _e1795));
let _e1801 = local_64;
let _e1804 = local_65;
let _e1805 = (_e1804 + (_e1793 * _e1801));
let _e1807 = (3i * (_e1799 + _e1757));
let _e1809 = (bitcast<i32>(_e164) - 1i);
let _e1811 = select(_e1809, _e1807, (_e1807 < _e1809));
let _e1817 = global_3.member[bitcast<u32>(select(0i, _e1811, (_e1811 > 0i)))];
let _e1818 = (_e1807 + 1i);
let _e1820 = select(_e1809, _e1818, (_e1818 < _e1809));
let _e1826 = global_3.member[bitcast<u32>(select(0i, _e1820, (_e1820 > 0i)))];
let _e1827 = (_e1807 + 2i);
let _e1829 = select(_e1809, _e1827, (_e1827 < _e1809));
let _e1835 = global_3.member[bitcast<u32>(select(0i, _e1829, (_e1829 > 0i)))];
let _e1837 = (3i * (_e1799 + _e1772));
let _e1839 = select(_e1809, _e1837, (_e1837 < _e1809));
let _e1845 = global_3.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
let _e1846 = (_e1837 + 1i);
let _e1848 = select(_e1809, _e1846, (_e1846 < _e1809));
let _e1854 = global_3.member[bitcast<u32>(select(0i, _e1848, (_e1848 > 0i)))];
let _e1855 = (_e1837 + 2i);
let _e1857 = select(_e1809, _e1855, (_e1855 < _e1809));
let _e1863 = global_3.member[bitcast<u32>(select(0i, _e1857, (_e1857 > 0i)))];
let _e1865 = (3i * (_e1805 + _e1757));
let _e1867 = select(_e1809, _e1865, (_e1865 < _e1809));
let _e1873 = global_3.member[bitcast<u32>(select(0i, _e1867, (_e1867 > 0i)))];
let _e1874 = (_e1865 + 1i);
let _e1876 = select(_e1809, _e1874, (_e1874 < _e1809));
let _e1882 = global_3.member[bitcast<u32>(select(0i, _e1876, (_e1876 > 0i)))];
let _e1883 = (_e1865 + 2i);
let _e1885 = select(_e1809, _e1883, (_e1883 < _e1809));
let _e1891 = global_3.member[bitcast<u32>(select(0i, _e1885, (_e1885 > 0i)))];
let _e1893 = (3i * (_e1805 + _e1772));
let _e1895 = select(_e1809, _e1893, (_e1893 < _e1809));
let _e1901 = global_3.member[bitcast<u32>(select(0i, _e1895, (_e1895 > 0i)))];
let _e1902 = (_e1893 + 1i);
let _e1904 = select(_e1809, _e1902, (_e1902 < _e1809));
let _e1910 = global_3.member[bitcast<u32>(select(0i, _e1904, (_e1904 > 0i)))];
let _e1911 = (_e1893 + 2i);
let _e1913 = select(_e1809, _e1911, (_e1911 < _e1809));
let _e1919 = global_3.member[bitcast<u32>(select(0i, _e1913, (_e1913 > 0i)))];
let _e1926 = (_e1817 + ((_e1845 - _e1817) * _e1737));
let _e1927 = (_e1826 + ((_e1854 - _e1826) * _e1737));
let _e1928 = (_e1835 + ((_e1863 - _e1835) * _e1737));
let _e1944 = (_e1926 + (((_e1873 + ((_e1901 - _e1873) * _e1737)) - _e1926) * _e1743));
let _e1945 = (_e1927 + (((_e1882 + ((_e1910 - _e1882) * _e1737)) - _e1927) * _e1743));
let _e1946 = (_e1928 + (((_e1891 + ((_e1919 - _e1891) * _e1737)) - _e1928) * _e1743));
phi_3423_ = 0i;
phi_3426_ = 0i;
phi_3428_ = _e1664;
phi_3430_ = _e1488;
loop {
let _e1949 = phi_3423_;
let _e1951 = phi_3426_;
let _e1953 = phi_3428_;
let _e1955 = phi_3430_;
local_66 = _e1955;
local_67 = _e1953;
local_68 = _e1955;
local_69 = _e1955;
local_70 = _e1955;
local_71 = _e1955;
local_72 = _e1955;
local_73 = _e1955;
local_74 = _e1953;
local_75 = _e1953;
local_76 = _e1953;
local_77 = _e1953;
local_78 = _e1955;
local_79 = _e1951;
local_80 = _e1955;
local_81 = _e1951;
let _e1956 = (_e1949 < (_e1559 + 1i));
if _e1956 {
if (_e1955 > 1i) {
phi_3445_ = (_e1955 >> bitcast<u32>(1i));
} else {
phi_3445_ = 1i;
}
let _e1963 = phi_3445_;
if (_e1953 > 1i) {
phi_3451_ = (_e1953 >> bitcast<u32>(1i));
} else {
phi_3451_ = 1i;
}
let _e1968 = phi_3451_;
phi_3424_ = (_e1949 + 1i);
phi_3427_ = (_e1951 + (_e1955 * _e1953));
phi_3429_ = _e1968;
phi_3431_ = _e1963;
} else {
phi_3424_ = i32();
phi_3427_ = i32();
phi_3429_ = i32();
phi_3431_ = i32();
}
let _e1971 = phi_3424_;
let _e1973 = phi_3427_;
let _e1975 = phi_3429_;
let _e1977 = phi_3431_;
continue;
continuing {
phi_3423_ = _e1971;
phi_3426_ = _e1973;
phi_3428_ = _e1975;
phi_3430_ = _e1977;
break if !(_e1956);
}
}
let _e1980 = local_66;
let _e1981 = f32(_e1980);
let _e1983 = ((_e1604 * _e1981) - 0.5f);
let _e1985 = local_67;
let _e1986 = f32(_e1985);
let _e1988 = ((_e1659 * _e1986) - 0.5f);
let _e1990 = select(-1f, _e1983, (_e1983 > -1f));
let _e1992 = select(_e1981, _e1990, (_e1990 < _e1981));
let _e1999 = select(0i, select(select(i32(_e1992), i32(-2147483648), (_e1992 < -2147483600f)), 2147483647i, (_e1992 > 2147483500f)), (_e1992 == _e1992));
let _e2003 = (_e1999 - select(0i, 1i, (_e1992 < f32(_e1999))));
let _e2005 = select(-1f, _e1988, (_e1988 > -1f));
let _e2007 = select(_e1986, _e2005, (_e2005 < _e1986));
let _e2014 = select(0i, select(select(i32(_e2007), i32(-2147483648), (_e2007 < -2147483600f)), 2147483647i, (_e2007 > 2147483500f)), (_e2007 == _e2007));
let _e2018 = (_e2014 - select(0i, 1i, (_e2007 < f32(_e2014))));
let _e2020 = (_e1983 - f32(_e2003));
let _e2022 = (_e1988 - f32(_e2018));
let _e2024 = select(0f, _e2022, (_e2022 > 0f));
let _e2026 = select(1f, _e2024, (_e2024 < 1f));
if (_e2003 < 0i) {
let _e2029 = local_68;
phi_3526_ = (_e2003 + _e2029);
} else {
phi_3526_ = _e2003;
}
let _e2032 = phi_3526_;
let _e2034 = local_69;
if (_e2032 >= _e2034) {
let _e2037 = local_70;
phi_3532_ = (_e2032 - _e2037);
} else {
phi_3532_ = _e2032;
}
let _e2040 = phi_3532_;
let _e2041 = (_e2003 + 1i);
if (_e2041 < 0i) {
let _e2044 = local_71;
phi_3539_ = (_e2041 + _e2044);
} else {
phi_3539_ = _e2041;
}
let _e2047 = phi_3539_;
let _e2049 = local_72;
if (_e2047 >= _e2049) {
let _e2052 = local_73;
phi_3545_ = (_e2047 - _e2052);
} else {
phi_3545_ = _e2047;
}
let _e2055 = phi_3545_;
let _e2057 = select(_e2018, 0i, (_e2018 < 0i));
let _e2059 = local_74;
if (_e2057 >= _e2059) {
let _e2062 = local_75;
phi_3556_ = (_e2062 - 1i);
} else {
phi_3556_ = _e2057;
}
let _e2065 = phi_3556_;
let _e2066 = (_e2018 + 1i);
let _e2068 = select(_e2066, 0i, (_e2066 < 0i));
let _e2070 = local_76;
if (_e2068 >= _e2070) {
let _e2073 = local_77;
phi_3568_ = (_e2073 - 1i);
} else {
phi_3568_ = _e2068;
}
let _e2076 = phi_3568_;
let _e2078 = local_78;
let _e2081 = local_79;
let _e2082 = (_e2081 + (_e2065 * _e2078));
let _e2084 = local_80;
let _e2087 = local_81;
let _e2088 = (_e2087 + (_e2076 * _e2084));
let _e2090 = (3i * (_e2082 + _e2040));
let _e2092 = select(_e1809, _e2090, (_e2090 < _e1809));
let _e2098 = global_3.member[bitcast<u32>(select(0i, _e2092, (_e2092 > 0i)))];
let _e2099 = (_e2090 + 1i);
let _e2101 = select(_e1809, _e2099, (_e2099 < _e1809));
let _e2107 = global_3.member[bitcast<u32>(select(0i, _e2101, (_e2101 > 0i)))];
let _e2108 = (_e2090 + 2i);
let _e2110 = select(_e1809, _e2108, (_e2108 < _e1809));
let _e2116 = global_3.member[bitcast<u32>(select(0i, _e2110, (_e2110 > 0i)))];
let _e2118 = (3i * (_e2082 + _e2055));
let _e2120 = select(_e1809, _e2118, (_e2118 < _e1809));
let _e2126 = global_3.member[bitcast<u32>(select(0i, _e2120, (_e2120 > 0i)))];
let _e2127 = (_e2118 + 1i);
let _e2129 = select(_e1809, _e2127, (_e2127 < _e1809));
let _e2135 = global_3.member[bitcast<u32>(select(0i, _e2129, (_e2129 > 0i)))];
let _e2136 = (_e2118 + 2i);
let _e2138 = select(_e1809, _e2136, (_e2136 < _e1809));
let _e2144 = global_3.member[bitcast<u32>(select(0i, _e2138, (_e2138 > 0i)))];
let _e2146 = (3i * (_e2088 + _e2040));
let _e2148 = select(_e1809, _e2146, (_e2146 < _e1809));
let _e2154 = global_3.member[bitcast<u32>(select(0i, _e2148, (_e2148 > 0i)))];
let _e2155 = (_e2146 + 1i);
let _e2157 = select(_e1809, _e2155, (_e2155 < _e1809));
let _e2163 = global_3.member[bitcast<u32>(select(0i, _e2157, (_e2157 > 0i)))];
let _e2164 = (_e2146 + 2i);
let _e2166 = select(_e1809, _e2164, (_e2164 < _e1809));
let _e2172 = global_3.member[bitcast<u32>(select(0i, _e2166, (_e2166 > 0i)))];
let _e2174 = (3i * (_e2088 + _e2055));
let _e2176 = select(_e1809, _e2174, (_e2174 < _e1809));
let _e2182 = global_3.member[bitcast<u32>(select(0i, _e2176, (_e2176 > 0i)))];
let _e2183 = (_e2174 + 1i);
let _e2185 = select(_e1809, _e2183, (_e2183 < _e1809));
let _e2191 = global_3.member[bitcast<u32>(select(0i, _e2185, (_e2185 > 0i)))];
let _e2192 = (_e2174 + 2i);
let _e2194 = select(_e1809, _e2192, (_e2192 < _e1809));
let _e2200 = global_3.member[bitcast<u32>(select(0i, _e2194, (_e2194 > 0i)))];
let _e2207 = (_e2098 + ((_e2126 - _e2098) * _e2020));
let _e2208 = (_e2107 + ((_e2135 - _e2107) * _e2020));
let _e2209 = (_e2116 + ((_e2144 - _e2116) * _e2020));
let _e2232 = (_e1541 - f32(_e1559));
let _e2234 = select(0f, _e2232, (_e2232 > 0f));
let _e2236 = select(1f, _e2234, (_e2234 < 1f));
let _e2246 = global_1.member.member_16.member_11;
phi_3823_ = vec3<f32>(((_e1944 + (((_e2207 + (((_e2154 + ((_e2182 - _e2154) * _e2020)) - _e2207) * _e2026)) - _e1944) * _e2236)) * _e2246), ((_e1945 + (((_e2208 + (((_e2163 + ((_e2191 - _e2163) * _e2020)) - _e2208) * _e2026)) - _e1945) * _e2236)) * _e2246), ((_e1946 + (((_e2209 + (((_e2172 + ((_e2200 - _e2172) * _e2020)) - _e2209) * _e2026)) - _e1946) * _e2236)) * _e2246));
}
let _e2252 = phi_3823_;
phi_3824_ = _e2252;
}
let _e2254 = phi_3824_;
phi_3825_ = _e2254;
}
let _e2256 = phi_3825_;
let _e2257 = local_13;
let _e2259 = local_12;
let _e2260 = ((16i * _e2257) + _e2259);
let _e2262 = select(_e208, _e2260, (_e2260 < _e208));
let _e2267 = global_2.member[bitcast<u32>(select(0i, _e2262, (_e2262 > 0i)))];
if (_e294 && (_e2267 == 3f)) {
let _e2270 = local_13;
let _e2272 = local_12;
let _e2273 = ((30i * _e2270) + _e2272);
let _e2275 = select(_e208, _e2273, (_e2273 < _e208));
let _e2280 = global_2.member[bitcast<u32>(select(0i, _e2275, (_e2275 > 0i)))];
let _e2287 = select(0i, select(select(i32(_e2280), i32(-2147483648), (_e2280 < -2147483600f)), 2147483647i, (_e2280 > 2147483500f)), (_e2280 == _e2280));
let _e2288 = local_12;
local_10 = _e2288;
local_11 = _e201;
let _e2289 = local_10;
let _e2291 = select(_e208, _e2289, (_e2289 < _e208));
let _e2296 = global_2.member[bitcast<u32>(select(0i, _e2291, (_e2291 > 0i)))];
let _e2297 = local_11;
let _e2298 = local_10;
let _e2299 = (_e2297 + _e2298);
let _e2301 = select(_e208, _e2299, (_e2299 < _e208));
let _e2306 = global_2.member[bitcast<u32>(select(0i, _e2301, (_e2301 > 0i)))];
let _e2307 = local_11;
let _e2309 = local_10;
let _e2310 = ((2i * _e2307) + _e2309);
let _e2312 = select(_e208, _e2310, (_e2310 < _e208));
let _e2317 = global_2.member[bitcast<u32>(select(0i, _e2312, (_e2312 > 0i)))];
let _e2318 = vec3<f32>(_e2296, _e2306, _e2317);
if (_e2287 < 0i) {
let _e2320 = (_e2287 == -3i);
let _e2326 = global_1.member.member_18.member_1.member.member;
let _e2331 = global_1.member.member_18.member_1.member_1;
let _e2337 = global_1.member.member_18.member.member.member;
let _e2342 = global_1.member.member_18.member.member_1;
let _e2352 = vec3<f32>(select(_e2337.member, _e2326.member, _e2320), select(_e2337.member_1, _e2326.member_1, _e2320), select(_e2337.member_2, _e2326.member_2, _e2320));
phi_4688_ = type_23(_e2318, _e2352, _e2352, vec3<f32>(select(_e2342.member, _e2331.member, _e2320), select(_e2342.member_1, _e2331.member_1, _e2320), select(_e2342.member_2, _e2331.member_2, _e2320)), 0f, false);
} else {
let _e2366 = global_1.member.member_1;
let _e2369 = (_e2287 * 19i);
let _e2371 = (bitcast<i32>(_e166) - 1i);
let _e2373 = select(_e2371, _e2369, (_e2369 < _e2371));
let _e2379 = global_4.member[bitcast<u32>(select(0i, _e2373, (_e2373 > 0i)))];
let _e2380 = (_e2369 + 1i);
let _e2382 = select(_e2371, _e2380, (_e2380 < _e2371));
let _e2388 = global_4.member[bitcast<u32>(select(0i, _e2382, (_e2382 > 0i)))];
let _e2389 = (_e2369 + 2i);
let _e2391 = select(_e2371, _e2389, (_e2389 < _e2371));
let _e2397 = global_4.member[bitcast<u32>(select(0i, _e2391, (_e2391 > 0i)))];
let _e2398 = (_e2369 + 3i);
let _e2400 = select(_e2371, _e2398, (_e2398 < _e2371));
let _e2406 = global_4.member[bitcast<u32>(select(0i, _e2400, (_e2400 > 0i)))];
let _e2407 = (_e2369 + 4i);
let _e2409 = select(_e2371, _e2407, (_e2407 < _e2371));
let _e2415 = global_4.member[bitcast<u32>(select(0i, _e2409, (_e2409 > 0i)))];
let _e2416 = (_e2369 + 5i);
let _e2418 = select(_e2371, _e2416, (_e2416 < _e2371));
let _e2424 = global_4.member[bitcast<u32>(select(0i, _e2418, (_e2418 > 0i)))];
let _e2425 = (_e2369 + 6i);
let _e2427 = select(_e2371, _e2425, (_e2425 < _e2371));
let _e2433 = global_4.member[bitcast<u32>(select(0i, _e2427, (_e2427 > 0i)))];
let _e2434 = (_e2369 + 7i);
let _e2436 = select(_e2371, _e2434, (_e2434 < _e2371));
let _e2442 = global_4.member[bitcast<u32>(select(0i, _e2436, (_e2436 > 0i)))];
let _e2443 = (_e2369 + 8i);
let _e2445 = select(_e2371, _e2443, (_e2443 < _e2371));
let _e2451 = global_4.member[bitcast<u32>(select(0i, _e2445, (_e2445 > 0i)))];
let _e2452 = (_e2406 - _e2379);
let _e2453 = (_e2415 - _e2388);
let _e2454 = (_e2424 - _e2397);
let _e2455 = (_e2433 - _e2379);
let _e2456 = (_e2442 - _e2388);
let _e2457 = (_e2451 - _e2397);
let _e2460 = ((_e2453 * _e2457) - (_e2454 * _e2456));
let _e2463 = ((_e2454 * _e2455) - (_e2452 * _e2457));
let _e2466 = ((_e2452 * _e2456) - (_e2453 * _e2455));
let _e2467 = (_e2406 - _e2296);
let _e2468 = (_e2415 - _e2306);
let _e2469 = (_e2424 - _e2317);
let _e2470 = (_e2433 - _e2296);
let _e2471 = (_e2442 - _e2306);
let _e2472 = (_e2451 - _e2317);
let _e2486 = (((((_e2468 * _e2472) - (_e2469 * _e2471)) * _e2460) + (((_e2469 * _e2470) - (_e2467 * _e2472)) * _e2463)) + (((_e2467 * _e2471) - (_e2468 * _e2470)) * _e2466));
let _e2488 = select(0f, _e2486, (_e2486 > 0f));
let _e2489 = (_e2379 - _e2296);
let _e2490 = (_e2388 - _e2306);
let _e2491 = (_e2397 - _e2317);
let _e2505 = (((((_e2471 * _e2491) - (_e2472 * _e2490)) * _e2460) + (((_e2472 * _e2489) - (_e2470 * _e2491)) * _e2463)) + (((_e2470 * _e2490) - (_e2471 * _e2489)) * _e2466));
let _e2507 = select(0f, _e2505, (_e2505 > 0f));
let _e2521 = (((((_e2490 * _e2469) - (_e2491 * _e2468)) * _e2460) + (((_e2491 * _e2467) - (_e2489 * _e2469)) * _e2463)) + (((_e2489 * _e2468) - (_e2490 * _e2467)) * _e2466));
let _e2523 = select(0f, _e2521, (_e2521 > 0f));
let _e2525 = ((_e2488 + _e2507) + _e2523);
let _e2527 = select(1e-30f, _e2525, (_e2525 > 1e-30f));
let _e2528 = (_e2488 / _e2527);
let _e2529 = (_e2507 / _e2527);
let _e2530 = (_e2523 / _e2527);
let _e2535 = (((_e2460 * _e2460) + (_e2463 * _e2463)) + (_e2466 * _e2466));
let _e2538 = sqrt(select(0f, _e2535, (_e2535 > 0f)));
let _e2541 = (1f / select(1e-20f, _e2538, (_e2538 > 1e-20f)));
let _e2546 = (_e2369 + 9i);
let _e2548 = select(_e2371, _e2546, (_e2546 < _e2371));
let _e2554 = global_4.member[bitcast<u32>(select(0i, _e2548, (_e2548 > 0i)))];
let _e2555 = (_e2369 + 10i);
let _e2557 = select(_e2371, _e2555, (_e2555 < _e2371));
let _e2563 = global_4.member[bitcast<u32>(select(0i, _e2557, (_e2557 > 0i)))];
let _e2564 = (_e2369 + 11i);
let _e2566 = select(_e2371, _e2564, (_e2564 < _e2371));
let _e2572 = global_4.member[bitcast<u32>(select(0i, _e2566, (_e2566 > 0i)))];
let _e2576 = (_e2369 + 12i);
let _e2578 = select(_e2371, _e2576, (_e2576 < _e2371));
let _e2584 = global_4.member[bitcast<u32>(select(0i, _e2578, (_e2578 > 0i)))];
let _e2585 = (_e2369 + 13i);
let _e2587 = select(_e2371, _e2585, (_e2585 < _e2371));
let _e2593 = global_4.member[bitcast<u32>(select(0i, _e2587, (_e2587 > 0i)))];
let _e2594 = (_e2369 + 14i);
let _e2596 = select(_e2371, _e2594, (_e2594 < _e2371));
let _e2602 = global_4.member[bitcast<u32>(select(0i, _e2596, (_e2596 > 0i)))];
let _e2609 = (_e2369 + 15i);
let _e2611 = select(_e2371, _e2609, (_e2609 < _e2371));
let _e2617 = global_4.member[bitcast<u32>(select(0i, _e2611, (_e2611 > 0i)))];
let _e2618 = (_e2369 + 16i);
let _e2620 = select(_e2371, _e2618, (_e2618 < _e2371));
let _e2626 = global_4.member[bitcast<u32>(select(0i, _e2620, (_e2620 > 0i)))];
let _e2627 = (_e2369 + 17i);
let _e2629 = select(_e2371, _e2627, (_e2627 < _e2371));
let _e2635 = global_4.member[bitcast<u32>(select(0i, _e2629, (_e2629 > 0i)))];
let _e2639 = (((_e2554 * _e2528) + (_e2584 * _e2529)) + (_e2617 * _e2530));
let _e2640 = (((_e2563 * _e2528) + (_e2593 * _e2529)) + (_e2626 * _e2530));
let _e2641 = (((_e2572 * _e2528) + (_e2602 * _e2529)) + (_e2635 * _e2530));
let _e2646 = (((_e2639 * _e2639) + (_e2640 * _e2640)) + (_e2641 * _e2641));
let _e2649 = sqrt(select(0f, _e2646, (_e2646 > 0f)));
let _e2652 = (1f / select(1e-20f, _e2649, (_e2649 > 1e-20f)));
let _e2657 = (_e2369 + 18i);
let _e2659 = select(_e2371, _e2657, (_e2657 < _e2371));
let _e2665 = global_4.member[bitcast<u32>(select(0i, _e2659, (_e2659 > 0i)))];
let _e2674 = (select(select(0i, select(select(i32(_e2665), i32(-2147483648), (_e2665 < -2147483600f)), 2147483647i, (_e2665 > 2147483500f)), (_e2665 == _e2665)), _e2287, ((_e2366 & 4u) != 0u)) * 10i);
let _e2676 = (bitcast<i32>(_e168) - 1i);
let _e2678 = select(_e2676, _e2674, (_e2674 < _e2676));
let _e2684 = global_5.member[bitcast<u32>(select(0i, _e2678, (_e2678 > 0i)))];
let _e2685 = (_e2674 + 1i);
let _e2687 = select(_e2676, _e2685, (_e2685 < _e2676));
let _e2693 = global_5.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2694 = (_e2674 + 2i);
let _e2696 = select(_e2676, _e2694, (_e2694 < _e2676));
let _e2702 = global_5.member[bitcast<u32>(select(0i, _e2696, (_e2696 > 0i)))];
let _e2706 = (_e2674 + 3i);
let _e2708 = select(_e2676, _e2706, (_e2706 < _e2676));
let _e2714 = global_5.member[bitcast<u32>(select(0i, _e2708, (_e2708 > 0i)))];
let _e2715 = (_e2674 + 4i);
let _e2717 = select(_e2676, _e2715, (_e2715 < _e2676));
let _e2723 = global_5.member[bitcast<u32>(select(0i, _e2717, (_e2717 > 0i)))];
let _e2724 = (_e2674 + 5i);
let _e2726 = select(_e2676, _e2724, (_e2724 < _e2676));
let _e2732 = global_5.member[bitcast<u32>(select(0i, _e2726, (_e2726 > 0i)))];
let _e2739 = (_e2674 + 6i);
let _e2741 = select(_e2676, _e2739, (_e2739 < _e2676));
let _e2747 = global_5.member[bitcast<u32>(select(0i, _e2741, (_e2741 > 0i)))];
let _e2748 = (_e2674 + 7i);
let _e2750 = select(_e2676, _e2748, (_e2748 < _e2676));
let _e2756 = global_5.member[bitcast<u32>(select(0i, _e2750, (_e2750 > 0i)))];
let _e2757 = (_e2674 + 8i);
let _e2759 = select(_e2676, _e2757, (_e2757 < _e2676));
let _e2765 = global_5.member[bitcast<u32>(select(0i, _e2759, (_e2759 > 0i)))];
let _e2773 = (_e2674 + 9i);
let _e2775 = select(_e2676, _e2773, (_e2773 < _e2676));
let _e2781 = global_5.member[bitcast<u32>(select(0i, _e2775, (_e2775 > 0i)))];
phi_4688_ = type_23(_e2318, vec3<f32>((_e2460 * _e2541), (_e2463 * _e2541), (_e2466 * _e2541)), vec3<f32>((_e2639 * _e2652), (_e2640 * _e2652), (_e2641 * _e2652)), vec3<f32>((((_e2684 * _e2528) + (_e2714 * _e2529)) + (_e2747 * _e2530)), (((_e2693 * _e2528) + (_e2723 * _e2529)) + (_e2756 * _e2530)), (((_e2702 * _e2528) + (_e2732 * _e2529)) + (_e2765 * _e2530))), _e2781, true);
}
let _e2784 = phi_4688_;
let _e2793 = (((_e2784.member_1.x * _e1076) + (_e2784.member_1.y * _e1087)) + (_e2784.member_1.z * _e1098));
let _e2795 = select(1f, -1f, (_e2793 > 0f));
let _e2807 = select(_e2795, -(_e2795), ((((_e2784.member_2.x * _e2784.member_1.x) + (_e2784.member_2.y * _e2784.member_1.y)) + (_e2784.member_2.z * _e2784.member_1.z)) < 0f));
let _e2808 = (_e2784.member_2.x * _e2807);
let _e2809 = (_e2784.member_2.y * _e2807);
let _e2810 = (_e2784.member_2.z * _e2807);
let _e2819 = ((((_e2808 * _e1076) + (_e2809 * _e1087)) + (_e2810 * _e1098)) > 0f);
let _e2820 = select(_e2808, (_e2784.member_1.x * _e2795), _e2819);
let _e2821 = select(_e2809, (_e2784.member_1.y * _e2795), _e2819);
let _e2822 = select(_e2810, (_e2784.member_1.z * _e2795), _e2819);
let _e2827 = global_1.member.member_19.member_2;
let _e2835 = global_1.member.member_19.member;
if (_e2835 == 0u) {
let _e2840 = global_1.member.member_19.member_1;
phi_5278_ = type_22(vec3<f32>(_e2840.member, _e2840.member_1, _e2840.member_2), vec3<f32>(_e2827.member, _e2827.member_1, _e2827.member_2));
} else {
let _e2849 = global_1.member.member_19.member_3;
let _e2854 = (_e2784.member.x - _e2849.member);
let _e2856 = (_e2784.member.y - _e2849.member_1);
let _e2858 = (_e2784.member.z - _e2849.member_2);
let _e2863 = (((_e2854 * _e2854) + (_e2856 * _e2856)) + (_e2858 * _e2858));
let _e2865 = select(1e-12f, _e2863, (_e2863 > 1e-12f));
let _e2866 = (1f / _e2865);
let _e2870 = vec3<f32>((_e2827.member * _e2866), (_e2827.member_1 * _e2866), (_e2827.member_2 * _e2866));
if (_e2835 == 2u) {
let _e2875 = global_1.member.member_19.member_1;
let _e2883 = (((_e2875.member * _e2854) + (_e2875.member_1 * _e2856)) + (_e2875.member_2 * _e2858));
let _e2886 = (1f / select(1e-20f, _e2883, (_e2883 > 1e-20f)));
let _e2891 = global_1.member.member_19.member_4.member;
let _e2900 = ((((_e2891.member * _e2854) + (_e2891.member_1 * _e2856)) + (_e2891.member_2 * _e2858)) * _e2886);
let _e2905 = global_1.member.member_19.member_4.member_1;
let _e2914 = ((((_e2905.member * _e2854) + (_e2905.member_1 * _e2856)) + (_e2905.member_2 * _e2858)) * _e2886);
let _e2919 = global_1.member.member_19.member_4.member_2;
let _e2922 = ((_e2900 * _e2900) + (_e2914 * _e2914));
let _e2931 = global_1.member.member_19.member_4.member_3;
let _e2932 = ((_e2919 - sqrt(select(0f, _e2922, (_e2922 > 0f)))) * _e2931);
let _e2934 = select(0f, _e2932, (_e2932 > 0f));
let _e2936 = select(1f, _e2934, (_e2934 < 1f));
let _e2942 = select(0f, ((_e2936 * _e2936) * (3f - (2f * _e2936))), (_e2883 > 0f));
let _e2947 = global_1.member.member_19.member_4.member_5;
if ((_e2947 > 0u) && (_e2942 > 0f)) {
let _e2951 = (0.5f / _e2919);
let _e2961 = global_1.member.member_19.member_4.member_6;
let _e2962 = bitcast<i32>(_e2961);
local_9 = bitcast<i32>(_e2947);
let _e2963 = local_9;
let _e2965 = f32((_e2963 - 1i));
let _e2967 = f32((_e2962 - 1i));
let _e2968 = local_9;
let _e2971 = (((0.5f + (_e2900 * _e2951)) * f32(_e2968)) - 0.5f);
let _e2973 = select(0f, _e2971, (_e2971 > 0f));
let _e2975 = select(_e2965, _e2973, (_e2973 < _e2965));
let _e2978 = (((0.5f - (_e2914 * _e2951)) * f32(_e2962)) - 0.5f);
let _e2980 = select(0f, _e2978, (_e2978 > 0f));
let _e2982 = select(_e2967, _e2980, (_e2980 < _e2967));
let _e2984 = select(0f, _e2975, (_e2975 > 0f));
let _e2986 = select(_e2965, _e2984, (_e2984 < _e2965));
let _e2993 = select(0i, select(select(i32(_e2986), i32(-2147483648), (_e2986 < -2147483600f)), 2147483647i, (_e2986 > 2147483500f)), (_e2986 == _e2986));
let _e2997 = (_e2993 - select(0i, 1i, (_e2986 < f32(_e2993))));
let _e2999 = select(0f, _e2982, (_e2982 > 0f));
let _e3001 = select(_e2967, _e2999, (_e2999 < _e2967));
let _e3008 = select(0i, select(select(i32(_e3001), i32(-2147483648), (_e3001 < -2147483600f)), 2147483647i, (_e3001 > 2147483500f)), (_e3001 == _e3001));
let _e3012 = (_e3008 - select(0i, 1i, (_e3001 < f32(_e3008))));
let _e3014 = (_e2975 - f32(_e2997));
let _e3016 = (_e2982 - f32(_e3012));
let _e3017 = (_e2997 + 1i);
let _e3018 = local_9;
let _e3020 = select(_e2997, _e3017, (_e3017 < _e3018));
let _e3021 = (_e3012 + 1i);
let _e3023 = select(_e3012, _e3021, (_e3021 < _e2962));
let _e3028 = global_1.member.member_19.member_4.member_4;
let _e3029 = bitcast<i32>(_e3028);
let _e3030 = local_9;
let _e3034 = (_e3029 + (3i * ((_e3012 * _e3030) + _e2997)));
let _e3036 = (bitcast<i32>(_e164) - 1i);
let _e3038 = select(_e3036, _e3034, (_e3034 < _e3036));
let _e3043 = global_3.member[bitcast<u32>(select(0i, _e3038, (_e3038 > 0i)))];
let _e3044 = (_e3034 + 1i);
let _e3046 = select(_e3036, _e3044, (_e3044 < _e3036));
let _e3051 = global_3.member[bitcast<u32>(select(0i, _e3046, (_e3046 > 0i)))];
let _e3052 = (_e3034 + 2i);
let _e3054 = select(_e3036, _e3052, (_e3052 < _e3036));
let _e3059 = global_3.member[bitcast<u32>(select(0i, _e3054, (_e3054 > 0i)))];
let _e3060 = local_9;
let _e3064 = (_e3029 + (3i * ((_e3012 * _e3060) + _e3020)));
let _e3066 = select(_e3036, _e3064, (_e3064 < _e3036));
let _e3071 = global_3.member[bitcast<u32>(select(0i, _e3066, (_e3066 > 0i)))];
let _e3072 = (_e3064 + 1i);
let _e3074 = select(_e3036, _e3072, (_e3072 < _e3036));
let _e3079 = global_3.member[bitcast<u32>(select(0i, _e3074, (_e3074 > 0i)))];
let _e3080 = (_e3064 + 2i);
let _e3082 = select(_e3036, _e3080, (_e3080 < _e3036));
let _e3087 = global_3.member[bitcast<u32>(select(0i, _e3082, (_e3082 > 0i)))];
let _e3088 = local_9;
let _e3092 = (_e3029 + (3i * ((_e3023 * _e3088) + _e2997)));
let _e3094 = select(_e3036, _e3092, (_e3092 < _e3036));
let _e3099 = global_3.member[bitcast<u32>(select(0i, _e3094, (_e3094 > 0i)))];
let _e3100 = (_e3092 + 1i);
let _e3102 = select(_e3036, _e3100, (_e3100 < _e3036));
let _e3107 = global_3.member[bitcast<u32>(select(0i, _e3102, (_e3102 > 0i)))];
let _e3108 = (_e3092 + 2i);
let _e3110 = select(_e3036, _e3108, (_e3108 < _e3036));
let _e3115 = global_3.member[bitcast<u32>(select(0i, _e3110, (_e3110 > 0i)))];
let _e3116 = local_9;
let _e3120 = (_e3029 + (3i * ((_e3023 * _e3116) + _e3020)));
let _e3122 = select(_e3036, _e3120, (_e3120 < _e3036));
let _e3127 = global_3.member[bitcast<u32>(select(0i, _e3122, (_e3122 > 0i)))];
let _e3128 = (_e3120 + 1i);
let _e3130 = select(_e3036, _e3128, (_e3128 < _e3036));
let _e3135 = global_3.member[bitcast<u32>(select(0i, _e3130, (_e3130 > 0i)))];
let _e3136 = (_e3120 + 2i);
let _e3138 = select(_e3036, _e3136, (_e3136 < _e3036));
let _e3143 = global_3.member[bitcast<u32>(select(0i, _e3138, (_e3138 > 0i)))];
let _e3150 = (_e3043 + ((_e3071 - _e3043) * _e3014));
let _e3151 = (_e3051 + ((_e3079 - _e3051) * _e3014));
let _e3152 = (_e3059 + ((_e3087 - _e3059) * _e3014));
phi_5262_ = vec3<f32>(((_e3150 + (((_e3099 + ((_e3127 - _e3099) * _e3014)) - _e3150) * _e3016)) * _e2942), ((_e3151 + (((_e3107 + ((_e3135 - _e3107) * _e3014)) - _e3151) * _e3016)) * _e2942), ((_e3152 + (((_e3115 + ((_e3143 - _e3115) * _e3014)) - _e3152) * _e3016)) * _e2942));
} else {
phi_5262_ = vec3(_e2942);
}
let _e3177 = phi_5262_;
phi_5265_ = (_e2870 * _e3177);
} else {
phi_5265_ = _e2870;
}
let _e3180 = phi_5265_;
let _e3184 = (1f / sqrt(select(0f, _e2865, (_e2865 > 0f))));
phi_5278_ = type_22(vec3<f32>((_e2854 * _e3184), (_e2856 * _e3184), (_e2858 * _e3184)), _e3180);
}
let _e3191 = phi_5278_;
let _e3202 = -((((_e2820 * _e3191.member.x) + (_e2821 * _e3191.member.y)) + (_e2822 * _e3191.member.z)));
let _e3207 = (((_e2784.member_1.x * _e3191.member.x) + (_e2784.member_1.y * _e3191.member.y)) + (_e2784.member_1.z * _e3191.member.z));
let _e3212 = -(_e3202);
let _e3217 = select((select(0f, _e3212, (_e3212 > 0f)) * _e2784.member_4), select(0f, _e3202, (_e3202 > 0f)), ((_e3207 * _e2793) > 0f));
let _e3218 = -(_e3207);
let _e3219 = -(_e3218);
let _e3221 = select(_e3219, _e3218, (_e3218 > _e3219));
let _e3227 = global_1.member.member_21.member_6;
let _e3241 = ((((_e3227.member.member * _e2784.member.x) + (_e3227.member.member_1 * _e2784.member.y)) + (_e3227.member.member_2 * _e2784.member.z)) + _e3227.member_1);
let _e3243 = select(1f, _e3241, (_e3241 > 1e-6f));
let _e3247 = global_1.member.member_21.member_4;
let _e3263 = global_1.member.member_21.member_5;
let _e3279 = global_1.member.member_21.member_2;
let _e3288 = -((((_e2784.member_1.x * _e3279.member) + (_e2784.member_1.y * _e3279.member_1)) + (_e2784.member_1.z * _e3279.member_2)));
let _e3289 = -(_e3288);
let _e3291 = select(_e3289, _e3288, (_e3288 > _e3289));
let _e3293 = select(1f, _e3291, (_e3291 < 1f));
let _e3295 = (1f - (_e3293 * _e3293));
let _e3302 = global_1.member.member_21.member_8;
let _e3310 = global_1.member.member_21.member_7.member;
let _e3315 = global_1.member.member_21.member_7.member_2;
let _e3317 = (_e3310 + (_e3315 * (((((_e3247.member.member * _e2784.member.x) + (_e3247.member.member_1 * _e2784.member.y)) + (_e3247.member.member_2 * _e2784.member.z)) + _e3247.member_1) / _e3243)));
let _e3322 = global_1.member.member_21.member_7.member_1;
let _e3324 = (_e3322 + (_e3315 * (((((_e3263.member.member * _e2784.member.x) + (_e3263.member.member_1 * _e2784.member.y)) + (_e3263.member.member_2 * _e2784.member.z)) + _e3263.member_1) / _e3243)));
let _e3328 = ((1f + (_e3317 * _e3317)) + (_e3324 * _e3324));
let _e3337 = global_1.member.member_21.member_9;
let _e3341 = (select(1f, -1f, (_e3218 < 0f)) * (((((1.4142135f * _e3302) * sqrt(select(0f, _e3295, (_e3295 > 0f)))) * _e3241) + (select(1f, _e3221, (_e3221 < 1f)) * sqrt(select(0f, _e3328, (_e3328 > 0f))))) * _e3337));
let _e3346 = select(0f, 1f, _e2784.member_5);
let _e3350 = (_e2784.member.x + ((_e2784.member_1.x * _e3341) * _e3346));
let _e3351 = (_e2784.member.y + ((_e2784.member_1.y * _e3341) * _e3346));
let _e3352 = (_e2784.member.z + ((_e2784.member_1.z * _e3341) * _e3346));
let _e3357 = global_1.member.member_21.member.member;
let _e3358 = bitcast<i32>(_e3357);
let _e3363 = global_1.member.member_21.member.member_1;
let _e3364 = bitcast<i32>(_e3363);
let _e3369 = global_1.member.member_21.member.member_2;
let _e3370 = bitcast<i32>(_e3369);
let _e3374 = global_1.member.member_21.member_1;
let _e3375 = bitcast<i32>(_e3374);
let _e3381 = ((((_e3227.member.member * _e3350) + (_e3227.member.member_1 * _e3351)) + (_e3227.member.member_2 * _e3352)) + _e3227.member_1);
let _e3383 = select(1f, _e3381, (_e3381 > 1e-6f));
let _e3387 = global_1.member.member_21.member_3;
let _e3398 = ((((_e3387.member.member * _e3350) + (_e3387.member.member_1 * _e3351)) + (_e3387.member.member_2 * _e3352)) + _e3387.member_1);
let _e3413 = ((((((_e3247.member.member * _e3350) + (_e3247.member.member_1 * _e3351)) + (_e3247.member.member_2 * _e3352)) + _e3247.member_1) / _e3383) - 0.5f);
let _e3414 = ((((((_e3263.member.member * _e3350) + (_e3263.member.member_1 * _e3351)) + (_e3263.member.member_2 * _e3352)) + _e3263.member_1) / _e3383) - 0.5f);
let _e3416 = f32((_e3358 - 1i));
let _e3418 = select(0f, _e3398, (_e3398 > 0f));
let _e3420 = select(_e3416, _e3418, (_e3418 < _e3416));
let _e3427 = select(0i, select(select(i32(_e3420), i32(-2147483648), (_e3420 < -2147483600f)), 2147483647i, (_e3420 > 2147483500f)), (_e3420 == _e3420));
let _e3431 = (_e3427 - select(0i, 1i, (_e3420 < f32(_e3427))));
let _e3435 = (_e3398 - f32(_e3431));
let _e3438 = select(1f, select(0f, _e3435, (_e3435 > 0f)), (_e3398 < f32(_e3358)));
let _e3439 = (_e3413 - _e3302);
let _e3440 = -(16f);
let _e3441 = f32(_e3364);
let _e3443 = select(_e3440, _e3439, (_e3439 > _e3440));
let _e3445 = select(_e3441, _e3443, (_e3443 < _e3441));
let _e3452 = select(0i, select(select(i32(_e3445), i32(-2147483648), (_e3445 < -2147483600f)), 2147483647i, (_e3445 > 2147483500f)), (_e3445 == _e3445));
let _e3458 = (_e3413 + _e3302);
let _e3461 = (f32((_e3364 - 1i)) + 16f);
let _e3463 = select(-1f, _e3458, (_e3458 > -1f));
let _e3465 = select(_e3461, _e3463, (_e3463 < _e3461));
let _e3472 = select(0i, select(select(i32(_e3465), i32(-2147483648), (_e3465 < -2147483600f)), 2147483647i, (_e3465 > 2147483500f)), (_e3465 == _e3465));
let _e3477 = (_e3414 - _e3302);
let _e3478 = f32(_e3370);
let _e3480 = select(_e3440, _e3477, (_e3477 > _e3440));
let _e3482 = select(_e3478, _e3480, (_e3480 < _e3478));
let _e3489 = select(0i, select(select(i32(_e3482), i32(-2147483648), (_e3482 < -2147483600f)), 2147483647i, (_e3482 > 2147483500f)), (_e3482 == _e3482));
let _e3495 = (_e3414 + _e3302);
let _e3498 = (f32((_e3370 - 1i)) + 16f);
let _e3500 = select(-1f, _e3495, (_e3495 > -1f));
let _e3502 = select(_e3498, _e3500, (_e3500 < _e3498));
let _e3509 = select(0i, select(select(i32(_e3502), i32(-2147483648), (_e3502 < -2147483600f)), 2147483647i, (_e3502 > 2147483500f)), (_e3502 == _e3502));
let _e3517 = bitcast<i32>(((_e3357 + 2u) >> bitcast<u32>(1i)));
let _e3519 = ((_e3364 * _e3370) * _e3517);
phi_5745_ = 0f;
phi_5748_ = vec3<f32>(0f, 0f, 0f);
phi_5750_ = ((_e3489 - select(0i, 1i, (_e3482 < f32(_e3489)))) + 1i);
loop {
let _e3521 = phi_5745_;
let _e3523 = phi_5748_;
let _e3525 = phi_5750_;
local_82 = _e3521;
local_83 = _e3521;
local_84 = _e3523;
local_85 = _e3523;
local_86 = _e3523;
let _e3526 = (_e3525 <= (_e3509 - select(0i, 1i, (_e3502 < f32(_e3509)))));
if _e3526 {
let _e3532 = (_e3302 - bitcast<f32>((bitcast<u32>((f32(_e3525) - _e3414)) & 2147483647u)));
phi_5765_ = ((_e3452 - select(0i, 1i, (_e3445 < f32(_e3452)))) + 1i);
phi_5768_ = _e3521;
phi_5770_ = _e3523;
loop {
let _e3534 = phi_5765_;
let _e3536 = phi_5768_;
let _e3538 = phi_5770_;
local_124 = _e3536;
local_125 = _e3538;
let _e3539 = (_e3534 <= (_e3472 - select(0i, 1i, (_e3465 < f32(_e3472)))));
if _e3539 {
let _e3545 = (_e3302 - bitcast<f32>((bitcast<u32>((f32(_e3534) - _e3413)) & 2147483647u)));
let _e3550 = (select(0f, _e3545, (_e3545 > 0f)) * select(0f, _e3532, (_e3532 > 0f)));
if ((((_e3534 >= 0i) && (_e3534 < _e3364)) && (_e3525 >= 0i)) && (_e3525 < _e3370)) {
let _e3560 = (((_e3525 * _e3364) + _e3534) * _e3517);
let _e3562 = (2i * _e3431);
let _e3563 = ((4i * _e3560) + _e3562);
let _e3565 = (_e3563 >> bitcast<u32>(2i));
let _e3568 = bitcast<u32>(((_e3563 & 3i) * 8i));
let _e3570 = (bitcast<i32>(_e170) - 1i);
let _e3572 = select(_e3570, _e3565, (_e3565 < _e3570));
let _e3578 = global_6.member[bitcast<u32>(select(0i, _e3572, (_e3572 > 0i)))];
let _e3582 = (_e3565 + 1i);
let _e3584 = select(_e3570, _e3582, (_e3582 < _e3570));
let _e3590 = global_6.member[bitcast<u32>(select(0i, _e3584, (_e3584 > 0i)))];
let _e3597 = ((_e3578 >> bitcast<u32>((_e3568 & 31u))) | ((_e3590 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3568) & 31u))));
let _e3600 = f32(bitcast<i32>((_e3597 & 65535u)));
let _e3608 = (1f / 65535f);
let _e3610 = (_e3550 * ((_e3600 + ((f32(bitcast<i32>((_e3597 >> bitcast<u32>(16i)))) - _e3600) * _e3438)) * _e3608));
let _e3612 = (_e3538.x + _e3610);
if (_e3375 > 1i) {
let _e3616 = ((4i * (_e3560 + _e3519)) + _e3562);
let _e3618 = (_e3616 >> bitcast<u32>(2i));
let _e3621 = bitcast<u32>(((_e3616 & 3i) * 8i));
let _e3623 = select(_e3570, _e3618, (_e3618 < _e3570));
let _e3629 = global_6.member[bitcast<u32>(select(0i, _e3623, (_e3623 > 0i)))];
let _e3633 = (_e3618 + 1i);
let _e3635 = select(_e3570, _e3633, (_e3633 < _e3570));
let _e3641 = global_6.member[bitcast<u32>(select(0i, _e3635, (_e3635 > 0i)))];
let _e3648 = ((_e3629 >> bitcast<u32>((_e3621 & 31u))) | ((_e3641 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3621) & 31u))));
let _e3651 = f32(bitcast<i32>((_e3648 & 65535u)));
let _e3666 = ((4i * (_e3560 + (2i * _e3519))) + _e3562);
let _e3668 = (_e3666 >> bitcast<u32>(2i));
let _e3671 = bitcast<u32>(((_e3666 & 3i) * 8i));
let _e3673 = select(_e3570, _e3668, (_e3668 < _e3570));
let _e3679 = global_6.member[bitcast<u32>(select(0i, _e3673, (_e3673 > 0i)))];
let _e3683 = (_e3668 + 1i);
let _e3685 = select(_e3570, _e3683, (_e3683 < _e3570));
let _e3691 = global_6.member[bitcast<u32>(select(0i, _e3685, (_e3685 > 0i)))];
let _e3698 = ((_e3679 >> bitcast<u32>((_e3671 & 31u))) | ((_e3691 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3671) & 31u))));
let _e3701 = f32(bitcast<i32>((_e3698 & 65535u)));
phi_6003_ = vec3<f32>(_e3612, (_e3538.y + (_e3550 * ((_e3651 + ((f32(bitcast<i32>((_e3648 >> bitcast<u32>(16i)))) - _e3651) * _e3438)) * _e3608))), (_e3538.z + (_e3550 * ((_e3701 + ((f32(bitcast<i32>((_e3698 >> bitcast<u32>(16i)))) - _e3701) * _e3438)) * _e3608))));
} else {
phi_6003_ = vec3<f32>(_e3612, (_e3538.y + _e3610), (_e3538.z + _e3610));
}
let _e3720 = phi_6003_;
phi_6013_ = _e3720;
} else {
phi_6013_ = vec3<f32>((_e3538.x + _e3550), (_e3538.y + _e3550), (_e3538.z + _e3550));
}
let _e3729 = phi_6013_;
phi_5766_ = (_e3534 + 1i);
phi_5769_ = (_e3536 + _e3550);
phi_5771_ = _e3729;
} else {
phi_5766_ = i32();
phi_5769_ = f32();
phi_5771_ = vec3<f32>();
}
let _e3733 = phi_5766_;
let _e3735 = phi_5769_;
let _e3737 = phi_5771_;
continue;
continuing {
phi_5765_ = _e3733;
phi_5768_ = _e3735;
phi_5770_ = _e3737;
break if !(_e3539);
}
}
let _e6880 = local_124;
phi_5746_ = _e6880;
let _e6883 = local_125;
phi_5749_ = _e6883;
phi_5751_ = (_e3525 + 1i);
} else {
phi_5746_ = f32();
phi_5749_ = vec3<f32>();
phi_5751_ = i32();
}
let _e3741 = phi_5746_;
let _e3743 = phi_5749_;
let _e3745 = phi_5751_;
continue;
continuing {
phi_5745_ = _e3741;
phi_5748_ = _e3743;
phi_5750_ = _e3745;
break if !(_e3526);
}
}
let _e3749 = local_82;
let _e3753 = (((_e3375 == 0i) || (_e3749 <= 0f)) || (_e3381 <= 1e-6f));
let _e3755 = local_83;
let _e3757 = (1f / select(_e3755, 1f, _e3753));
let _e3759 = local_84;
let _e3764 = local_85;
let _e3769 = local_86;
let _e3785 = global_1.member.member_20;
phi_6131_ = vec3<f32>(_e2820, _e2821, _e2822);
phi_6132_ = (_e2784.member_3 * vec3<f32>(((_e3191.member_1.x * (select((_e3759.x * _e3757), 1f, _e3753) * _e3217)) + _e3785.member), ((_e3191.member_1.y * (select((_e3764.y * _e3757), 1f, _e3753) * _e3217)) + _e3785.member_1), ((_e3191.member_1.z * (select((_e3769.z * _e3757), 1f, _e3753) * _e3217)) + _e3785.member_2)));
} else {
phi_6131_ = vec3<f32>(0f, 0f, 0f);
phi_6132_ = _e2256;
}
let _e3796 = phi_6131_;
let _e3798 = phi_6132_;
let _e3799 = local_12;
local_7 = _e3799;
local_8 = _e201;
let _e3800 = local_8;
let _e3802 = local_7;
let _e3803 = ((22i * _e3800) + _e3802);
let _e3805 = select(_e208, _e3803, (_e3803 < _e208));
let _e3810 = global_2.member[bitcast<u32>(select(0i, _e3805, (_e3805 > 0i)))];
let _e3811 = local_8;
let _e3813 = local_7;
let _e3814 = ((23i * _e3811) + _e3813);
let _e3816 = select(_e208, _e3814, (_e3814 < _e208));
let _e3821 = global_2.member[bitcast<u32>(select(0i, _e3816, (_e3816 > 0i)))];
let _e3822 = local_8;
let _e3824 = local_7;
let _e3825 = ((24i * _e3822) + _e3824);
let _e3827 = select(_e208, _e3825, (_e3825 < _e208));
let _e3832 = global_2.member[bitcast<u32>(select(0i, _e3827, (_e3827 > 0i)))];
let _e3835 = global_1.member.member_17;
let _e3842 = local_12;
local_5 = _e3842;
local_6 = _e201;
let _e3843 = local_6;
let _e3845 = local_5;
let _e3846 = ((6i * _e3843) + _e3845);
let _e3848 = select(_e208, _e3846, (_e3846 < _e208));
let _e3853 = global_2.member[bitcast<u32>(select(0i, _e3848, (_e3848 > 0i)))];
let _e3854 = local_6;
let _e3856 = local_5;
let _e3857 = ((7i * _e3854) + _e3856);
let _e3859 = select(_e208, _e3857, (_e3857 < _e208));
let _e3864 = global_2.member[bitcast<u32>(select(0i, _e3859, (_e3859 > 0i)))];
let _e3865 = local_6;
let _e3867 = local_5;
let _e3868 = ((8i * _e3865) + _e3867);
let _e3870 = select(_e208, _e3868, (_e3868 < _e208));
let _e3875 = global_2.member[bitcast<u32>(select(0i, _e3870, (_e3870 > 0i)))];
let _e3885 = local_48;
local_3 = _e3885;
local_4 = _e201;
let _e3886 = local_4;
let _e3888 = local_3;
let _e3889 = ((9i * _e3886) + _e3888);
let _e3891 = select(_e208, _e3889, (_e3889 < _e208));
let _e3896 = global_2.member[bitcast<u32>(select(0i, _e3891, (_e3891 > 0i)))];
let _e3897 = local_4;
let _e3899 = local_3;
let _e3900 = ((10i * _e3897) + _e3899);
let _e3902 = select(_e208, _e3900, (_e3900 < _e208));
let _e3907 = global_2.member[bitcast<u32>(select(0i, _e3902, (_e3902 > 0i)))];
let _e3908 = local_4;
let _e3910 = local_3;
let _e3911 = ((11i * _e3908) + _e3910);
let _e3913 = select(_e208, _e3911, (_e3911 < _e208));
let _e3918 = global_2.member[bitcast<u32>(select(0i, _e3913, (_e3913 > 0i)))];
let _e3920 = (_e296 && (_e282 == 0f));
let _e3922 = select(_e3896, _e3796.x, _e3920);
let _e3924 = select(_e3907, _e3796.y, _e3920);
let _e3926 = select(_e3918, _e3796.z, _e3920);
let _e3927 = local_49;
let _e3929 = local_48;
let _e3930 = ((21i * _e3927) + _e3929);
let _e3932 = select(_e208, _e3930, (_e3930 < _e208));
let _e3937 = global_2.member[bitcast<u32>(select(0i, _e3932, (_e3932 > 0i)))];
local_1 = _e195;
local_2 = _e201;
let _e3938 = local_2;
let _e3940 = local_1;
let _e3941 = ((9i * _e3938) + _e3940);
let _e3943 = select(_e208, _e3941, (_e3941 < _e208));
let _e3948 = global_2.member[bitcast<u32>(select(0i, _e3943, (_e3943 > 0i)))];
let _e3949 = local_2;
let _e3951 = local_1;
let _e3952 = ((10i * _e3949) + _e3951);
let _e3954 = select(_e208, _e3952, (_e3952 < _e208));
let _e3959 = global_2.member[bitcast<u32>(select(0i, _e3954, (_e3954 > 0i)))];
let _e3960 = local_2;
let _e3962 = local_1;
let _e3963 = ((11i * _e3960) + _e3962);
let _e3965 = select(_e208, _e3963, (_e3963 < _e208));
let _e3970 = global_2.member[bitcast<u32>(select(0i, _e3965, (_e3965 > 0i)))];
let _e3976 = (2f * (((_e1050 * _e3948) + (_e1051 * _e3959)) + (_e1052 * _e3970)));
let _e3980 = (_e1050 - (_e3948 * _e3976));
let _e3981 = (_e1051 - (_e3959 * _e3976));
let _e3982 = (_e1052 - (_e3970 * _e3976));
let _e3983 = (_e677 - _e508);
let _e3984 = (_e678 - _e509);
let _e3985 = (_e679 - _e510);
let _e3990 = (((_e3983 * _e3983) + (_e3984 * _e3984)) + (_e3985 * _e3985));
let _e3995 = (_e677 - _e3980);
let _e3996 = (_e678 - _e3981);
let _e3997 = (_e679 - _e3982);
let _e4002 = (((_e3995 * _e3995) + (_e3996 * _e3996)) + (_e3997 * _e3997));
let _e4006 = (_e3980 - _e508);
let _e4007 = (_e3981 - _e509);
let _e4008 = (_e3982 - _e510);
let _e4013 = (((_e4006 * _e4006) + (_e4007 * _e4007)) + (_e4008 * _e4008));
let _e4021 = select(select(_e1063, select(sqrt(select(0f, _e4013, (_e4013 > 0f))), sqrt(select(0f, _e4002, (_e4002 > 0f))), _e601), (_e389 || _e601)), (0.5f * sqrt(select(0f, _e3990, (_e3990 > 0f)))), (_e389 && _e601));
let _e4022 = (_e1027 - _e857);
let _e4023 = (_e1028 - _e858);
let _e4024 = (_e1029 - _e859);
let _e4029 = (((_e4022 * _e4022) + (_e4023 * _e4023)) + (_e4024 * _e4024));
let _e4034 = (_e1027 - _e3980);
let _e4035 = (_e1028 - _e3981);
let _e4036 = (_e1029 - _e3982);
let _e4041 = (((_e4034 * _e4034) + (_e4035 * _e4035)) + (_e4036 * _e4036));
let _e4045 = (_e3980 - _e857);
let _e4046 = (_e3981 - _e858);
let _e4047 = (_e3982 - _e859);
let _e4052 = (((_e4045 * _e4045) + (_e4046 * _e4046)) + (_e4047 * _e4047));
let _e4060 = select(select(_e1063, select(sqrt(select(0f, _e4052, (_e4052 > 0f))), sqrt(select(0f, _e4041, (_e4041 > 0f))), _e950), (_e771 || _e950)), (0.5f * sqrt(select(0f, _e4029, (_e4029 > 0f)))), (_e771 && _e950));
let _e4062 = select(_e4060, _e4021, (_e4021 > _e4060));
let _e4067 = (((_e1195.member * _e3980) + (_e1195.member_1 * _e3981)) + (_e1195.member_2 * _e3982));
let _e4072 = (((_e1207.member * _e3980) + (_e1207.member_1 * _e3981)) + (_e1207.member_2 * _e3982));
let _e4077 = (((_e1219.member * _e3980) + (_e1219.member_1 * _e3981)) + (_e1219.member_2 * _e3982));
if _e1247 {
phi_8182_ = _e1239;
} else {
if (_e1231 == 1u) {
let _e4080 = select(-1f, _e4077, (_e4077 > -1f));
let _e4082 = select(1f, _e4080, (_e4080 < 1f));
if (_e4082 > 0f) {
phi_6797_ = _e1239;
} else {
let _e4087 = global_1.member.member_16.member_9;
phi_6797_ = vec3<f32>(_e4087.member, _e4087.member_1, _e4087.member_2);
}
let _e4093 = phi_6797_;
let _e4102 = bitcast<f32>((bitcast<u32>(_e4082) & 2147483647u));
let _e4105 = sqrt(select(0f, _e4102, (_e4102 > 0f)));
phi_8181_ = vec3<f32>((_e1243.member + ((_e4093.x - _e1243.member) * _e4105)), (_e1243.member_1 + ((_e4093.y - _e1243.member_1) * _e4105)), (_e1243.member_2 + ((_e4093.z - _e1243.member_2) * _e4105)));
} else {
if (_e1231 == 2u) {
let _e4117 = global_1.member.member_16.member_10;
let _e4118 = (_e4062 / _e4117);
let _e4120 = select(1e-4f, _e4118, (_e4118 > 1e-4f));
let _e4123 = bitcast<f32>((bitcast<u32>(_e4067) & 2147483647u));
let _e4126 = bitcast<f32>((bitcast<u32>(_e4072) & 2147483647u));
let _e4130 = select(_e4126, _e4123, (_e4123 > _e4126));
let _e4133 = (select(_e4126, _e4123, (_e4123 < _e4126)) / select(1.1754944e-38f, _e4130, (_e4130 > 1.1754944e-38f)));
let _e4134 = (_e4133 > 0.41421357f);
let _e4138 = select(_e4133, ((_e4133 - 1f) / (_e4133 + 1f)), _e4134);
let _e4139 = (_e4138 * _e4138);
let _e4154 = (select(0f, 0.7853982f, _e4134) + (_e4138 + ((_e4138 * _e4139) * (-0.33333334f + (_e4139 * (0.2f + (_e4139 * (-0.14285713f + (_e4139 * (0.11111111f + (_e4139 * (-0.09090909f + (_e4139 * 0.0585f)))))))))))));
let _e4157 = select(_e4154, (1.5707964f - _e4154), (_e4126 > _e4123));
let _e4160 = select(_e4157, (3.1415927f - _e4157), (_e4067 < 0f));
let _e4166 = (1f - (_e4077 * _e4077));
let _e4169 = sqrt(select(0f, _e4166, (_e4166 > 0f)));
let _e4172 = (_e4120 / select(1e-3f, _e4169, (_e4169 > 1e-3f)));
let _e4173 = ((select(_e4160, -(_e4160), (_e4072 < 0f)) / _e4117) * 0.5f);
let _e4175 = select(-8e6f, _e4173, (_e4173 > -8e6f));
let _e4177 = select(8e6f, _e4175, (_e4175 < 8e6f));
let _e4184 = select(0i, select(select(i32(_e4177), i32(-2147483648), (_e4177 < -2147483600f)), 2147483647i, (_e4177 > 2147483500f)), (_e4177 == _e4177));
let _e4191 = ((_e4173 - f32((_e4184 - select(0i, 1i, (_e4177 < f32(_e4184)))))) * 2f);
let _e4199 = ((select(select((_e4191 - 2f), (1f - _e4191), (_e4191 < 1.5f)), _e4191, (_e4191 < 0.5f)) * 2f) / _e4172);
let _e4201 = select(-1f, _e4199, (_e4199 > -1f));
let _e4204 = (2f - _e4172);
let _e4206 = select(0f, _e4204, (_e4204 > 0f));
let _e4211 = select(-1f, _e4077, (_e4077 > -1f));
let _e4213 = select(1f, _e4211, (_e4211 < 1f));
let _e4216 = ((1f - _e4213) * (1f + _e4213));
let _e4219 = sqrt(select(0f, _e4216, (_e4216 > 0f)));
let _e4222 = bitcast<f32>((bitcast<u32>(_e4219) & 2147483647u));
let _e4225 = bitcast<f32>((bitcast<u32>(_e4213) & 2147483647u));
let _e4229 = select(_e4225, _e4222, (_e4222 > _e4225));
let _e4232 = (select(_e4225, _e4222, (_e4222 < _e4225)) / select(1.1754944e-38f, _e4229, (_e4229 > 1.1754944e-38f)));
let _e4233 = (_e4232 > 0.41421357f);
let _e4237 = select(_e4232, ((_e4232 - 1f) / (_e4232 + 1f)), _e4233);
let _e4238 = (_e4237 * _e4237);
let _e4253 = (select(0f, 0.7853982f, _e4233) + (_e4237 + ((_e4237 * _e4238) * (-0.33333334f + (_e4238 * (0.2f + (_e4238 * (-0.14285713f + (_e4238 * (0.11111111f + (_e4238 * (-0.09090909f + (_e4238 * 0.0585f)))))))))))));
let _e4256 = select(_e4253, (1.5707964f - _e4253), (_e4225 > _e4222));
let _e4259 = select(_e4256, (3.1415927f - _e4256), (_e4219 < 0f));
let _e4264 = ((select(_e4259, -(_e4259), (_e4213 < 0f)) / _e4117) * 0.5f);
let _e4266 = select(-8e6f, _e4264, (_e4264 > -8e6f));
let _e4268 = select(8e6f, _e4266, (_e4266 < 8e6f));
let _e4275 = select(0i, select(select(i32(_e4268), i32(-2147483648), (_e4268 < -2147483600f)), 2147483647i, (_e4268 > 2147483500f)), (_e4268 == _e4268));
let _e4282 = ((_e4264 - f32((_e4275 - select(0i, 1i, (_e4268 < f32(_e4275)))))) * 2f);
let _e4290 = ((select(select((_e4282 - 2f), (1f - _e4282), (_e4282 < 1.5f)), _e4282, (_e4282 < 0.5f)) * 2f) / _e4120);
let _e4292 = select(-1f, _e4290, (_e4290 > -1f));
let _e4295 = (2f - _e4120);
let _e4297 = select(0f, _e4295, (_e4295 > 0f));
let _e4303 = (0.5f + ((0.5f * (select(1f, _e4201, (_e4201 < 1f)) * select(1f, _e4206, (_e4206 < 1f)))) * (select(1f, _e4292, (_e4292 < 1f)) * select(1f, _e4297, (_e4297 < 1f)))));
phi_8180_ = vec3<f32>((_e1235.member + ((_e1243.member - _e1235.member) * _e4303)), (_e1235.member_1 + ((_e1243.member_1 - _e1235.member_1) * _e4303)), (_e1235.member_2 + ((_e1243.member_2 - _e1235.member_2) * _e4303)));
} else {
let _e4317 = global_1.member.member_16.member_1;
let _e4318 = bitcast<i32>(_e4317);
let _e4323 = global_1.member.member_16.member_3;
let _e4325 = f32(bitcast<i32>(_e4323));
let _e4327 = (2f * 3.1415927f);
let _e4328 = ((_e4062 * f32(_e4318)) / _e4327);
let _e4330 = select(1e-6f, _e4328, (_e4328 > 1e-6f));
let _e4333 = bitcast<u32>(select(1.1754944e-38f, _e4330, (_e4330 > 1.1754944e-38f)));
let _e4334 = (_e4333 & 8388607u);
let _e4336 = select(0u, 1u, (_e4334 > 3474675u));
let _e4347 = bitcast<f32>((_e4334 | ((127u - _e4336) << bitcast<u32>(23i))));
let _e4350 = ((_e4347 - 1f) / (_e4347 + 1f));
let _e4351 = (_e4350 * _e4350);
let _e4366 = (f32(((bitcast<i32>((_e4333 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e4336))) + (((2f * _e4350) + ((_e4350 * _e4351) * (0.6666667f + (_e4351 * (0.4f + (_e4351 * (0.2857143f + (_e4351 * (0.22222222f + (_e4351 * 0.18181819f)))))))))) * 1.442695f));
let _e4367 = (_e4325 - 1f);
let _e4369 = select(0f, _e4366, (_e4366 > 0f));
let _e4371 = select(_e4367, _e4369, (_e4369 < _e4367));
let _e4372 = (_e4325 - 2f);
let _e4374 = select(0f, _e4372, (_e4372 > 0f));
let _e4376 = select(0f, _e4371, (_e4371 > 0f));
let _e4378 = select(_e4374, _e4376, (_e4376 < _e4374));
let _e4385 = select(0i, select(select(i32(_e4378), i32(-2147483648), (_e4378 < -2147483600f)), 2147483647i, (_e4378 > 2147483500f)), (_e4378 == _e4378));
let _e4389 = (_e4385 - select(0i, 1i, (_e4378 < f32(_e4385))));
let _e4392 = bitcast<f32>((bitcast<u32>(_e4072) & 2147483647u));
let _e4395 = bitcast<f32>((bitcast<u32>(_e4067) & 2147483647u));
let _e4399 = select(_e4395, _e4392, (_e4392 > _e4395));
let _e4402 = (select(_e4395, _e4392, (_e4392 < _e4395)) / select(1.1754944e-38f, _e4399, (_e4399 > 1.1754944e-38f)));
let _e4403 = (_e4402 > 0.41421357f);
let _e4407 = select(_e4402, ((_e4402 - 1f) / (_e4402 + 1f)), _e4403);
let _e4408 = (_e4407 * _e4407);
let _e4423 = (select(0f, 0.7853982f, _e4403) + (_e4407 + ((_e4407 * _e4408) * (-0.33333334f + (_e4408 * (0.2f + (_e4408 * (-0.14285713f + (_e4408 * (0.11111111f + (_e4408 * (-0.09090909f + (_e4408 * 0.0585f)))))))))))));
let _e4426 = select(_e4423, (1.5707964f - _e4423), (_e4395 > _e4392));
let _e4429 = select(_e4426, (3.1415927f - _e4426), (_e4072 < 0f));
let _e4434 = (0.5f - (select(_e4429, -(_e4429), (_e4067 < 0f)) / _e4327));
let _e4436 = select(-1f, _e4077, (_e4077 > -1f));
let _e4438 = select(1f, _e4436, (_e4436 < 1f));
let _e4441 = ((1f - _e4438) * (1f + _e4438));
let _e4444 = sqrt(select(0f, _e4441, (_e4441 > 0f)));
let _e4447 = bitcast<f32>((bitcast<u32>(_e4444) & 2147483647u));
let _e4450 = bitcast<f32>((bitcast<u32>(_e4438) & 2147483647u));
let _e4454 = select(_e4450, _e4447, (_e4447 > _e4450));
let _e4457 = (select(_e4450, _e4447, (_e4447 < _e4450)) / select(1.1754944e-38f, _e4454, (_e4454 > 1.1754944e-38f)));
let _e4458 = (_e4457 > 0.41421357f);
let _e4462 = select(_e4457, ((_e4457 - 1f) / (_e4457 + 1f)), _e4458);
let _e4463 = (_e4462 * _e4462);
let _e4478 = (select(0f, 0.7853982f, _e4458) + (_e4462 + ((_e4462 * _e4463) * (-0.33333334f + (_e4463 * (0.2f + (_e4463 * (-0.14285713f + (_e4463 * (0.11111111f + (_e4463 * (-0.09090909f + (_e4463 * 0.0585f)))))))))))));
let _e4481 = select(_e4478, (1.5707964f - _e4478), (_e4450 > _e4447));
let _e4484 = select(_e4481, (3.1415927f - _e4481), (_e4444 < 0f));
let _e4489 = (0.5f - (select(_e4484, -(_e4484), (_e4438 < 0f)) / 3.1415927f));
let _e4493 = global_1.member.member_16.member_2;
let _e4494 = bitcast<i32>(_e4493);
phi_7399_ = 0i;
phi_7402_ = 0i;
phi_7404_ = _e4494;
phi_7406_ = _e4318;
loop {
let _e4496 = phi_7399_;
let _e4498 = phi_7402_;
let _e4500 = phi_7404_;
let _e4502 = phi_7406_;
local_87 = _e4502;
local_88 = _e4500;
local_89 = _e4502;
local_90 = _e4502;
local_91 = _e4502;
local_92 = _e4502;
local_93 = _e4502;
local_94 = _e4502;
local_95 = _e4500;
local_96 = _e4500;
local_97 = _e4500;
local_98 = _e4500;
local_99 = _e4502;
local_100 = _e4498;
local_101 = _e4502;
local_102 = _e4498;
let _e4503 = (_e4496 < _e4389);
if _e4503 {
if (_e4502 > 1i) {
phi_7421_ = (_e4502 >> bitcast<u32>(1i));
} else {
phi_7421_ = 1i;
}
let _e4510 = phi_7421_;
if (_e4500 > 1i) {
phi_7427_ = (_e4500 >> bitcast<u32>(1i));
} else {
phi_7427_ = 1i;
}
let _e4515 = phi_7427_;
phi_7400_ = (_e4496 + 1i);
phi_7403_ = (_e4498 + (_e4502 * _e4500));
phi_7405_ = _e4515;
phi_7407_ = _e4510;
} else {
phi_7400_ = i32();
phi_7403_ = i32();
phi_7405_ = i32();
phi_7407_ = i32();
}
let _e4518 = phi_7400_;
let _e4520 = phi_7403_;
let _e4522 = phi_7405_;
let _e4524 = phi_7407_;
continue;
continuing {
phi_7399_ = _e4518;
phi_7402_ = _e4520;
phi_7404_ = _e4522;
phi_7406_ = _e4524;
break if !(_e4503);
}
}
let _e4527 = local_87;
let _e4528 = f32(_e4527);
let _e4530 = ((_e4434 * _e4528) - 0.5f);
let _e4532 = local_88;
let _e4533 = f32(_e4532);
let _e4535 = ((_e4489 * _e4533) - 0.5f);
let _e4537 = select(-1f, _e4530, (_e4530 > -1f));
let _e4539 = select(_e4528, _e4537, (_e4537 < _e4528));
let _e4546 = select(0i, select(select(i32(_e4539), i32(-2147483648), (_e4539 < -2147483600f)), 2147483647i, (_e4539 > 2147483500f)), (_e4539 == _e4539));
let _e4550 = (_e4546 - select(0i, 1i, (_e4539 < f32(_e4546))));
let _e4552 = select(-1f, _e4535, (_e4535 > -1f));
let _e4554 = select(_e4533, _e4552, (_e4552 < _e4533));
let _e4561 = select(0i, select(select(i32(_e4554), i32(-2147483648), (_e4554 < -2147483600f)), 2147483647i, (_e4554 > 2147483500f)), (_e4554 == _e4554));
let _e4565 = (_e4561 - select(0i, 1i, (_e4554 < f32(_e4561))));
let _e4567 = (_e4530 - f32(_e4550));
let _e4569 = (_e4535 - f32(_e4565));
let _e4571 = select(0f, _e4569, (_e4569 > 0f));
let _e4573 = select(1f, _e4571, (_e4571 < 1f));
if (_e4550 < 0i) {
let _e4576 = local_89;
phi_7502_ = (_e4550 + _e4576);
} else {
phi_7502_ = _e4550;
}
let _e4579 = phi_7502_;
let _e4581 = local_90;
if (_e4579 >= _e4581) {
let _e4584 = local_91;
phi_7508_ = (_e4579 - _e4584);
} else {
phi_7508_ = _e4579;
}
let _e4587 = phi_7508_;
let _e4588 = (_e4550 + 1i);
if (_e4588 < 0i) {
let _e4591 = local_92;
phi_7515_ = (_e4588 + _e4591);
} else {
phi_7515_ = _e4588;
}
let _e4594 = phi_7515_;
let _e4596 = local_93;
if (_e4594 >= _e4596) {
let _e4599 = local_94;
phi_7521_ = (_e4594 - _e4599);
} else {
phi_7521_ = _e4594;
}
let _e4602 = phi_7521_;
let _e4604 = select(_e4565, 0i, (_e4565 < 0i));
let _e4606 = local_95;
if (_e4604 >= _e4606) {
let _e4609 = local_96;
phi_7532_ = (_e4609 - 1i);
} else {
phi_7532_ = _e4604;
}
let _e4612 = phi_7532_;
let _e4613 = (_e4565 + 1i);
let _e4615 = select(_e4613, 0i, (_e4613 < 0i));
let _e4617 = local_97;
if (_e4615 >= _e4617) {
let _e4620 = local_98;
phi_7544_ = (_e4620 - 1i);
} else {
phi_7544_ = _e4615;
}
let _e4623 = phi_7544_;
let _e4625 = local_99;
let _e4628 = local_100;
let _e4629 = (_e4628 + (_e4612 * _e4625));
let _e4631 = local_101;
let _e4634 = local_102;
let _e4635 = (_e4634 + (_e4623 * _e4631));
let _e4637 = (3i * (_e4629 + _e4587));
let _e4639 = (bitcast<i32>(_e164) - 1i);
let _e4641 = select(_e4639, _e4637, (_e4637 < _e4639));
let _e4647 = global_3.member[bitcast<u32>(select(0i, _e4641, (_e4641 > 0i)))];
let _e4648 = (_e4637 + 1i);
let _e4650 = select(_e4639, _e4648, (_e4648 < _e4639));
let _e4656 = global_3.member[bitcast<u32>(select(0i, _e4650, (_e4650 > 0i)))];
let _e4657 = (_e4637 + 2i);
let _e4659 = select(_e4639, _e4657, (_e4657 < _e4639));
let _e4665 = global_3.member[bitcast<u32>(select(0i, _e4659, (_e4659 > 0i)))];
let _e4667 = (3i * (_e4629 + _e4602));
let _e4669 = select(_e4639, _e4667, (_e4667 < _e4639));
let _e4675 = global_3.member[bitcast<u32>(select(0i, _e4669, (_e4669 > 0i)))];
let _e4676 = (_e4667 + 1i);
let _e4678 = select(_e4639, _e4676, (_e4676 < _e4639));
let _e4684 = global_3.member[bitcast<u32>(select(0i, _e4678, (_e4678 > 0i)))];
let _e4685 = (_e4667 + 2i);
let _e4687 = select(_e4639, _e4685, (_e4685 < _e4639));
let _e4693 = global_3.member[bitcast<u32>(select(0i, _e4687, (_e4687 > 0i)))];
let _e4695 = (3i * (_e4635 + _e4587));
let _e4697 = select(_e4639, _e4695, (_e4695 < _e4639));
let _e4703 = global_3.member[bitcast<u32>(select(0i, _e4697, (_e4697 > 0i)))];
let _e4704 = (_e4695 + 1i);
let _e4706 = select(_e4639, _e4704, (_e4704 < _e4639));
let _e4712 = global_3.member[bitcast<u32>(select(0i, _e4706, (_e4706 > 0i)))];
let _e4713 = (_e4695 + 2i);
let _e4715 = select(_e4639, _e4713, (_e4713 < _e4639));
let _e4721 = global_3.member[bitcast<u32>(select(0i, _e4715, (_e4715 > 0i)))];
let _e4723 = (3i * (_e4635 + _e4602));
let _e4725 = select(_e4639, _e4723, (_e4723 < _e4639));
let _e4731 = global_3.member[bitcast<u32>(select(0i, _e4725, (_e4725 > 0i)))];
let _e4732 = (_e4723 + 1i);
let _e4734 = select(_e4639, _e4732, (_e4732 < _e4639));
let _e4740 = global_3.member[bitcast<u32>(select(0i, _e4734, (_e4734 > 0i)))];
let _e4741 = (_e4723 + 2i);
let _e4743 = select(_e4639, _e4741, (_e4741 < _e4639));
let _e4749 = global_3.member[bitcast<u32>(select(0i, _e4743, (_e4743 > 0i)))];
let _e4756 = (_e4647 + ((_e4675 - _e4647) * _e4567));
let _e4757 = (_e4656 + ((_e4684 - _e4656) * _e4567));
let _e4758 = (_e4665 + ((_e4693 - _e4665) * _e4567));
let _e4774 = (_e4756 + (((_e4703 + ((_e4731 - _e4703) * _e4567)) - _e4756) * _e4573));
let _e4775 = (_e4757 + (((_e4712 + ((_e4740 - _e4712) * _e4567)) - _e4757) * _e4573));
let _e4776 = (_e4758 + (((_e4721 + ((_e4749 - _e4721) * _e4567)) - _e4758) * _e4573));
phi_7780_ = 0i;
phi_7783_ = 0i;
phi_7785_ = _e4494;
phi_7787_ = _e4318;
loop {
let _e4779 = phi_7780_;
let _e4781 = phi_7783_;
let _e4783 = phi_7785_;
let _e4785 = phi_7787_;
local_103 = _e4785;
local_104 = _e4783;
local_105 = _e4785;
local_106 = _e4785;
local_107 = _e4785;
local_108 = _e4785;
local_109 = _e4785;
local_110 = _e4785;
local_111 = _e4783;
local_112 = _e4783;
local_113 = _e4783;
local_114 = _e4783;
local_115 = _e4785;
local_116 = _e4781;
local_117 = _e4785;
local_118 = _e4781;
let _e4786 = (_e4779 < (_e4389 + 1i));
if _e4786 {
if (_e4785 > 1i) {
phi_7802_ = (_e4785 >> bitcast<u32>(1i));
} else {
phi_7802_ = 1i;
}
let _e4793 = phi_7802_;
if (_e4783 > 1i) {
phi_7808_ = (_e4783 >> bitcast<u32>(1i));
} else {
phi_7808_ = 1i;
}
let _e4798 = phi_7808_;
phi_7781_ = (_e4779 + 1i);
phi_7784_ = (_e4781 + (_e4785 * _e4783));
phi_7786_ = _e4798;
phi_7788_ = _e4793;
} else {
phi_7781_ = i32();
phi_7784_ = i32();
phi_7786_ = i32();
phi_7788_ = i32();
}
let _e4801 = phi_7781_;
let _e4803 = phi_7784_;
let _e4805 = phi_7786_;
let _e4807 = phi_7788_;
continue;
continuing {
phi_7780_ = _e4801;
phi_7783_ = _e4803;
phi_7785_ = _e4805;
phi_7787_ = _e4807;
break if !(_e4786);
}
}
let _e4810 = local_103;
let _e4811 = f32(_e4810);
let _e4813 = ((_e4434 * _e4811) - 0.5f);
let _e4815 = local_104;
let _e4816 = f32(_e4815);
let _e4818 = ((_e4489 * _e4816) - 0.5f);
let _e4820 = select(-1f, _e4813, (_e4813 > -1f));
let _e4822 = select(_e4811, _e4820, (_e4820 < _e4811));
let _e4829 = select(0i, select(select(i32(_e4822), i32(-2147483648), (_e4822 < -2147483600f)), 2147483647i, (_e4822 > 2147483500f)), (_e4822 == _e4822));
let _e4833 = (_e4829 - select(0i, 1i, (_e4822 < f32(_e4829))));
let _e4835 = select(-1f, _e4818, (_e4818 > -1f));
let _e4837 = select(_e4816, _e4835, (_e4835 < _e4816));
let _e4844 = select(0i, select(select(i32(_e4837), i32(-2147483648), (_e4837 < -2147483600f)), 2147483647i, (_e4837 > 2147483500f)), (_e4837 == _e4837));
let _e4848 = (_e4844 - select(0i, 1i, (_e4837 < f32(_e4844))));
let _e4850 = (_e4813 - f32(_e4833));
let _e4852 = (_e4818 - f32(_e4848));
let _e4854 = select(0f, _e4852, (_e4852 > 0f));
let _e4856 = select(1f, _e4854, (_e4854 < 1f));
if (_e4833 < 0i) {
let _e4859 = local_105;
phi_7883_ = (_e4833 + _e4859);
} else {
phi_7883_ = _e4833;
}
let _e4862 = phi_7883_;
let _e4864 = local_106;
if (_e4862 >= _e4864) {
let _e4867 = local_107;
phi_7889_ = (_e4862 - _e4867);
} else {
phi_7889_ = _e4862;
}
let _e4870 = phi_7889_;
let _e4871 = (_e4833 + 1i);
if (_e4871 < 0i) {
let _e4874 = local_108;
phi_7896_ = (_e4871 + _e4874);
} else {
phi_7896_ = _e4871;
}
let _e4877 = phi_7896_;
let _e4879 = local_109;
if (_e4877 >= _e4879) {
let _e4882 = local_110;
phi_7902_ = (_e4877 - _e4882);
} else {
phi_7902_ = _e4877;
}
let _e4885 = phi_7902_;
let _e4887 = select(_e4848, 0i, (_e4848 < 0i));
let _e4889 = local_111;
if (_e4887 >= _e4889) {
let _e4892 = local_112;
phi_7913_ = (_e4892 - 1i);
} else {
phi_7913_ = _e4887;
}
let _e4895 = phi_7913_;
let _e4896 = (_e4848 + 1i);
let _e4898 = select(_e4896, 0i, (_e4896 < 0i));
let _e4900 = local_113;
if (_e4898 >= _e4900) {
let _e4903 = local_114;
phi_7925_ = (_e4903 - 1i);
} else {
phi_7925_ = _e4898;
}
let _e4906 = phi_7925_;
let _e4908 = local_115;
let _e4911 = local_116;
let _e4912 = (_e4911 + (_e4895 * _e4908));
let _e4914 = local_117;
let _e4917 = local_118;
let _e4918 = (_e4917 + (_e4906 * _e4914));
let _e4920 = (3i * (_e4912 + _e4870));
let _e4922 = select(_e4639, _e4920, (_e4920 < _e4639));
let _e4928 = global_3.member[bitcast<u32>(select(0i, _e4922, (_e4922 > 0i)))];
let _e4929 = (_e4920 + 1i);
let _e4931 = select(_e4639, _e4929, (_e4929 < _e4639));
let _e4937 = global_3.member[bitcast<u32>(select(0i, _e4931, (_e4931 > 0i)))];
let _e4938 = (_e4920 + 2i);
let _e4940 = select(_e4639, _e4938, (_e4938 < _e4639));
let _e4946 = global_3.member[bitcast<u32>(select(0i, _e4940, (_e4940 > 0i)))];
let _e4948 = (3i * (_e4912 + _e4885));
let _e4950 = select(_e4639, _e4948, (_e4948 < _e4639));
let _e4956 = global_3.member[bitcast<u32>(select(0i, _e4950, (_e4950 > 0i)))];
let _e4957 = (_e4948 + 1i);
let _e4959 = select(_e4639, _e4957, (_e4957 < _e4639));
let _e4965 = global_3.member[bitcast<u32>(select(0i, _e4959, (_e4959 > 0i)))];
let _e4966 = (_e4948 + 2i);
let _e4968 = select(_e4639, _e4966, (_e4966 < _e4639));
let _e4974 = global_3.member[bitcast<u32>(select(0i, _e4968, (_e4968 > 0i)))];
let _e4976 = (3i * (_e4918 + _e4870));
let _e4978 = select(_e4639, _e4976, (_e4976 < _e4639));
let _e4984 = global_3.member[bitcast<u32>(select(0i, _e4978, (_e4978 > 0i)))];
let _e4985 = (_e4976 + 1i);
let _e4987 = select(_e4639, _e4985, (_e4985 < _e4639));
let _e4993 = global_3.member[bitcast<u32>(select(0i, _e4987, (_e4987 > 0i)))];
let _e4994 = (_e4976 + 2i);
let _e4996 = select(_e4639, _e4994, (_e4994 < _e4639));
let _e5002 = global_3.member[bitcast<u32>(select(0i, _e4996, (_e4996 > 0i)))];
let _e5004 = (3i * (_e4918 + _e4885));
let _e5006 = select(_e4639, _e5004, (_e5004 < _e4639));
let _e5012 = global_3.member[bitcast<u32>(select(0i, _e5006, (_e5006 > 0i)))];
let _e5013 = (_e5004 + 1i);
let _e5015 = select(_e4639, _e5013, (_e5013 < _e4639));
let _e5021 = global_3.member[bitcast<u32>(select(0i, _e5015, (_e5015 > 0i)))];
let _e5022 = (_e5004 + 2i);
let _e5024 = select(_e4639, _e5022, (_e5022 < _e4639));
let _e5030 = global_3.member[bitcast<u32>(select(0i, _e5024, (_e5024 > 0i)))];
let _e5037 = (_e4928 + ((_e4956 - _e4928) * _e4850));
let _e5038 = (_e4937 + ((_e4965 - _e4937) * _e4850));
let _e5039 = (_e4946 + ((_e4974 - _e4946) * _e4850));
let _e5062 = (_e4371 - f32(_e4389));
let _e5064 = select(0f, _e5062, (_e5062 > 0f));
let _e5066 = select(1f, _e5064, (_e5064 < 1f));
let _e5076 = global_1.member.member_16.member_11;
phi_8180_ = vec3<f32>(((_e4774 + (((_e5037 + (((_e4984 + ((_e5012 - _e4984) * _e4850)) - _e5037) * _e4856)) - _e4774) * _e5066)) * _e5076), ((_e4775 + (((_e5038 + (((_e4993 + ((_e5021 - _e4993) * _e4850)) - _e5038) * _e4856)) - _e4775) * _e5066)) * _e5076), ((_e4776 + (((_e5039 + (((_e5002 + ((_e5030 - _e5002) * _e4850)) - _e5039) * _e4856)) - _e4776) * _e5066)) * _e5076));
}
let _e5082 = phi_8180_;
phi_8181_ = _e5082;
}
let _e5084 = phi_8181_;
phi_8182_ = _e5084;
}
let _e5086 = phi_8182_;
if (_e294 && (_e3937 > 0f)) {
let _e5089 = local_49;
let _e5091 = local_48;
let _e5092 = ((2i * _e5089) + _e5091);
let _e5094 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e5096 = select(_e5094, _e5092, (_e5092 < _e5094));
let _e5101 = global_7.member[bitcast<u32>(select(0i, _e5096, (_e5096 > 0i)))];
let _e5108 = select(0i, select(select(i32(_e5101), i32(-2147483648), (_e5101 < -2147483600f)), 2147483647i, (_e5101 > 2147483500f)), (_e5101 == _e5101));
if (_e5108 != -1i) {
let _e5110 = local_49;
let _e5112 = local_48;
let _e5113 = ((20i * _e5110) + _e5112);
let _e5115 = select(_e208, _e5113, (_e5113 < _e208));
let _e5120 = global_2.member[bitcast<u32>(select(0i, _e5115, (_e5115 > 0i)))];
let _e5121 = (1f - _e438);
let _e5127 = global_1.member.member_10;
let _e5140 = local_49;
let _e5142 = local_48;
let _e5143 = ((3i * _e5140) + _e5142);
let _e5145 = select(_e5094, _e5143, (_e5143 < _e5094));
let _e5150 = global_7.member[bitcast<u32>(select(0i, _e5145, (_e5145 > 0i)))];
let _e5154 = (((_e5127.member + (_e1030 * _e5121)) + (_e1050 * _e5120)) + (_e3980 * _e5150));
let _e5155 = (((_e5127.member_1 + (_e1031 * _e5121)) + (_e1051 * _e5120)) + (_e3981 * _e5150));
let _e5156 = (((_e5127.member_2 + (_e1032 * _e5121)) + (_e1052 * _e5120)) + (_e3982 * _e5150));
let _e5157 = vec3<f32>(_e5154, _e5155, _e5156);
if (_e5108 < 0i) {
let _e5159 = (_e5108 == -3i);
let _e5165 = global_1.member.member_18.member_1.member.member;
let _e5170 = global_1.member.member_18.member_1.member_1;
let _e5176 = global_1.member.member_18.member.member.member;
let _e5181 = global_1.member.member_18.member.member_1;
let _e5191 = vec3<f32>(select(_e5176.member, _e5165.member, _e5159), select(_e5176.member_1, _e5165.member_1, _e5159), select(_e5176.member_2, _e5165.member_2, _e5159));
phi_9157_ = type_23(_e5157, _e5191, _e5191, vec3<f32>(select(_e5181.member, _e5170.member, _e5159), select(_e5181.member_1, _e5170.member_1, _e5159), select(_e5181.member_2, _e5170.member_2, _e5159)), 0f, false);
} else {
let _e5205 = global_1.member.member_1;
let _e5208 = (_e5108 * 19i);
let _e5210 = (bitcast<i32>(_e166) - 1i);
let _e5212 = select(_e5210, _e5208, (_e5208 < _e5210));
let _e5218 = global_4.member[bitcast<u32>(select(0i, _e5212, (_e5212 > 0i)))];
let _e5219 = (_e5208 + 1i);
let _e5221 = select(_e5210, _e5219, (_e5219 < _e5210));
let _e5227 = global_4.member[bitcast<u32>(select(0i, _e5221, (_e5221 > 0i)))];
let _e5228 = (_e5208 + 2i);
let _e5230 = select(_e5210, _e5228, (_e5228 < _e5210));
let _e5236 = global_4.member[bitcast<u32>(select(0i, _e5230, (_e5230 > 0i)))];
let _e5237 = (_e5208 + 3i);
let _e5239 = select(_e5210, _e5237, (_e5237 < _e5210));
let _e5245 = global_4.member[bitcast<u32>(select(0i, _e5239, (_e5239 > 0i)))];
let _e5246 = (_e5208 + 4i);
let _e5248 = select(_e5210, _e5246, (_e5246 < _e5210));
let _e5254 = global_4.member[bitcast<u32>(select(0i, _e5248, (_e5248 > 0i)))];
let _e5255 = (_e5208 + 5i);
let _e5257 = select(_e5210, _e5255, (_e5255 < _e5210));
let _e5263 = global_4.member[bitcast<u32>(select(0i, _e5257, (_e5257 > 0i)))];
let _e5264 = (_e5208 + 6i);
let _e5266 = select(_e5210, _e5264, (_e5264 < _e5210));
let _e5272 = global_4.member[bitcast<u32>(select(0i, _e5266, (_e5266 > 0i)))];
let _e5273 = (_e5208 + 7i);
let _e5275 = select(_e5210, _e5273, (_e5273 < _e5210));
let _e5281 = global_4.member[bitcast<u32>(select(0i, _e5275, (_e5275 > 0i)))];
let _e5282 = (_e5208 + 8i);
let _e5284 = select(_e5210, _e5282, (_e5282 < _e5210));
let _e5290 = global_4.member[bitcast<u32>(select(0i, _e5284, (_e5284 > 0i)))];
let _e5291 = (_e5245 - _e5218);
let _e5292 = (_e5254 - _e5227);
let _e5293 = (_e5263 - _e5236);
let _e5294 = (_e5272 - _e5218);
let _e5295 = (_e5281 - _e5227);
let _e5296 = (_e5290 - _e5236);
let _e5299 = ((_e5292 * _e5296) - (_e5293 * _e5295));
let _e5302 = ((_e5293 * _e5294) - (_e5291 * _e5296));
let _e5305 = ((_e5291 * _e5295) - (_e5292 * _e5294));
let _e5306 = (_e5245 - _e5154);
let _e5307 = (_e5254 - _e5155);
let _e5308 = (_e5263 - _e5156);
let _e5309 = (_e5272 - _e5154);
let _e5310 = (_e5281 - _e5155);
let _e5311 = (_e5290 - _e5156);
let _e5325 = (((((_e5307 * _e5311) - (_e5308 * _e5310)) * _e5299) + (((_e5308 * _e5309) - (_e5306 * _e5311)) * _e5302)) + (((_e5306 * _e5310) - (_e5307 * _e5309)) * _e5305));
let _e5327 = select(0f, _e5325, (_e5325 > 0f));
let _e5328 = (_e5218 - _e5154);
let _e5329 = (_e5227 - _e5155);
let _e5330 = (_e5236 - _e5156);
let _e5344 = (((((_e5310 * _e5330) - (_e5311 * _e5329)) * _e5299) + (((_e5311 * _e5328) - (_e5309 * _e5330)) * _e5302)) + (((_e5309 * _e5329) - (_e5310 * _e5328)) * _e5305));
let _e5346 = select(0f, _e5344, (_e5344 > 0f));
let _e5360 = (((((_e5329 * _e5308) - (_e5330 * _e5307)) * _e5299) + (((_e5330 * _e5306) - (_e5328 * _e5308)) * _e5302)) + (((_e5328 * _e5307) - (_e5329 * _e5306)) * _e5305));
let _e5362 = select(0f, _e5360, (_e5360 > 0f));
let _e5364 = ((_e5327 + _e5346) + _e5362);
let _e5366 = select(1e-30f, _e5364, (_e5364 > 1e-30f));
let _e5367 = (_e5327 / _e5366);
let _e5368 = (_e5346 / _e5366);
let _e5369 = (_e5362 / _e5366);
let _e5374 = (((_e5299 * _e5299) + (_e5302 * _e5302)) + (_e5305 * _e5305));
let _e5377 = sqrt(select(0f, _e5374, (_e5374 > 0f)));
let _e5380 = (1f / select(1e-20f, _e5377, (_e5377 > 1e-20f)));
let _e5385 = (_e5208 + 9i);
let _e5387 = select(_e5210, _e5385, (_e5385 < _e5210));
let _e5393 = global_4.member[bitcast<u32>(select(0i, _e5387, (_e5387 > 0i)))];
let _e5394 = (_e5208 + 10i);
let _e5396 = select(_e5210, _e5394, (_e5394 < _e5210));
let _e5402 = global_4.member[bitcast<u32>(select(0i, _e5396, (_e5396 > 0i)))];
let _e5403 = (_e5208 + 11i);
let _e5405 = select(_e5210, _e5403, (_e5403 < _e5210));
let _e5411 = global_4.member[bitcast<u32>(select(0i, _e5405, (_e5405 > 0i)))];
let _e5415 = (_e5208 + 12i);
let _e5417 = select(_e5210, _e5415, (_e5415 < _e5210));
let _e5423 = global_4.member[bitcast<u32>(select(0i, _e5417, (_e5417 > 0i)))];
let _e5424 = (_e5208 + 13i);
let _e5426 = select(_e5210, _e5424, (_e5424 < _e5210));
let _e5432 = global_4.member[bitcast<u32>(select(0i, _e5426, (_e5426 > 0i)))];
let _e5433 = (_e5208 + 14i);
let _e5435 = select(_e5210, _e5433, (_e5433 < _e5210));
let _e5441 = global_4.member[bitcast<u32>(select(0i, _e5435, (_e5435 > 0i)))];
let _e5448 = (_e5208 + 15i);
let _e5450 = select(_e5210, _e5448, (_e5448 < _e5210));
let _e5456 = global_4.member[bitcast<u32>(select(0i, _e5450, (_e5450 > 0i)))];
let _e5457 = (_e5208 + 16i);
let _e5459 = select(_e5210, _e5457, (_e5457 < _e5210));
let _e5465 = global_4.member[bitcast<u32>(select(0i, _e5459, (_e5459 > 0i)))];
let _e5466 = (_e5208 + 17i);
let _e5468 = select(_e5210, _e5466, (_e5466 < _e5210));
let _e5474 = global_4.member[bitcast<u32>(select(0i, _e5468, (_e5468 > 0i)))];
let _e5478 = (((_e5393 * _e5367) + (_e5423 * _e5368)) + (_e5456 * _e5369));
let _e5479 = (((_e5402 * _e5367) + (_e5432 * _e5368)) + (_e5465 * _e5369));
let _e5480 = (((_e5411 * _e5367) + (_e5441 * _e5368)) + (_e5474 * _e5369));
let _e5485 = (((_e5478 * _e5478) + (_e5479 * _e5479)) + (_e5480 * _e5480));
let _e5488 = sqrt(select(0f, _e5485, (_e5485 > 0f)));
let _e5491 = (1f / select(1e-20f, _e5488, (_e5488 > 1e-20f)));
let _e5496 = (_e5208 + 18i);
let _e5498 = select(_e5210, _e5496, (_e5496 < _e5210));
let _e5504 = global_4.member[bitcast<u32>(select(0i, _e5498, (_e5498 > 0i)))];
let _e5513 = (select(select(0i, select(select(i32(_e5504), i32(-2147483648), (_e5504 < -2147483600f)), 2147483647i, (_e5504 > 2147483500f)), (_e5504 == _e5504)), _e5108, ((_e5205 & 4u) != 0u)) * 10i);
let _e5515 = (bitcast<i32>(_e168) - 1i);
let _e5517 = select(_e5515, _e5513, (_e5513 < _e5515));
let _e5523 = global_5.member[bitcast<u32>(select(0i, _e5517, (_e5517 > 0i)))];
let _e5524 = (_e5513 + 1i);
let _e5526 = select(_e5515, _e5524, (_e5524 < _e5515));
let _e5532 = global_5.member[bitcast<u32>(select(0i, _e5526, (_e5526 > 0i)))];
let _e5533 = (_e5513 + 2i);
let _e5535 = select(_e5515, _e5533, (_e5533 < _e5515));
let _e5541 = global_5.member[bitcast<u32>(select(0i, _e5535, (_e5535 > 0i)))];
let _e5545 = (_e5513 + 3i);
let _e5547 = select(_e5515, _e5545, (_e5545 < _e5515));
let _e5553 = global_5.member[bitcast<u32>(select(0i, _e5547, (_e5547 > 0i)))];
let _e5554 = (_e5513 + 4i);
let _e5556 = select(_e5515, _e5554, (_e5554 < _e5515));
let _e5562 = global_5.member[bitcast<u32>(select(0i, _e5556, (_e5556 > 0i)))];
let _e5563 = (_e5513 + 5i);
let _e5565 = select(_e5515, _e5563, (_e5563 < _e5515));
let _e5571 = global_5.member[bitcast<u32>(select(0i, _e5565, (_e5565 > 0i)))];
let _e5578 = (_e5513 + 6i);
let _e5580 = select(_e5515, _e5578, (_e5578 < _e5515));
let _e5586 = global_5.member[bitcast<u32>(select(0i, _e5580, (_e5580 > 0i)))];
let _e5587 = (_e5513 + 7i);
let _e5589 = select(_e5515, _e5587, (_e5587 < _e5515));
let _e5595 = global_5.member[bitcast<u32>(select(0i, _e5589, (_e5589 > 0i)))];
let _e5596 = (_e5513 + 8i);
let _e5598 = select(_e5515, _e5596, (_e5596 < _e5515));
let _e5604 = global_5.member[bitcast<u32>(select(0i, _e5598, (_e5598 > 0i)))];
let _e5612 = (_e5513 + 9i);
let _e5614 = select(_e5515, _e5612, (_e5612 < _e5515));
let _e5620 = global_5.member[bitcast<u32>(select(0i, _e5614, (_e5614 > 0i)))];
phi_9157_ = type_23(_e5157, vec3<f32>((_e5299 * _e5380), (_e5302 * _e5380), (_e5305 * _e5380)), vec3<f32>((_e5478 * _e5491), (_e5479 * _e5491), (_e5480 * _e5491)), vec3<f32>((((_e5523 * _e5367) + (_e5553 * _e5368)) + (_e5586 * _e5369)), (((_e5532 * _e5367) + (_e5562 * _e5368)) + (_e5595 * _e5369)), (((_e5541 * _e5367) + (_e5571 * _e5368)) + (_e5604 * _e5369))), _e5620, true);
}
let _e5623 = phi_9157_;
let _e5632 = (((_e5623.member_1.x * _e3980) + (_e5623.member_1.y * _e3981)) + (_e5623.member_1.z * _e3982));
let _e5634 = select(1f, -1f, (_e5632 > 0f));
let _e5646 = select(_e5634, -(_e5634), ((((_e5623.member_2.x * _e5623.member_1.x) + (_e5623.member_2.y * _e5623.member_1.y)) + (_e5623.member_2.z * _e5623.member_1.z)) < 0f));
let _e5647 = (_e5623.member_2.x * _e5646);
let _e5648 = (_e5623.member_2.y * _e5646);
let _e5649 = (_e5623.member_2.z * _e5646);
let _e5658 = ((((_e5647 * _e3980) + (_e5648 * _e3981)) + (_e5649 * _e3982)) > 0f);
let _e5666 = global_1.member.member_19.member_2;
let _e5674 = global_1.member.member_19.member;
if (_e5674 == 0u) {
let _e5679 = global_1.member.member_19.member_1;
phi_9747_ = type_22(vec3<f32>(_e5679.member, _e5679.member_1, _e5679.member_2), vec3<f32>(_e5666.member, _e5666.member_1, _e5666.member_2));
} else {
let _e5688 = global_1.member.member_19.member_3;
let _e5693 = (_e5623.member.x - _e5688.member);
let _e5695 = (_e5623.member.y - _e5688.member_1);
let _e5697 = (_e5623.member.z - _e5688.member_2);
let _e5702 = (((_e5693 * _e5693) + (_e5695 * _e5695)) + (_e5697 * _e5697));
let _e5704 = select(1e-12f, _e5702, (_e5702 > 1e-12f));
let _e5705 = (1f / _e5704);
let _e5709 = vec3<f32>((_e5666.member * _e5705), (_e5666.member_1 * _e5705), (_e5666.member_2 * _e5705));
if (_e5674 == 2u) {
let _e5714 = global_1.member.member_19.member_1;
let _e5722 = (((_e5714.member * _e5693) + (_e5714.member_1 * _e5695)) + (_e5714.member_2 * _e5697));
let _e5725 = (1f / select(1e-20f, _e5722, (_e5722 > 1e-20f)));
let _e5730 = global_1.member.member_19.member_4.member;
let _e5739 = ((((_e5730.member * _e5693) + (_e5730.member_1 * _e5695)) + (_e5730.member_2 * _e5697)) * _e5725);
let _e5744 = global_1.member.member_19.member_4.member_1;
let _e5753 = ((((_e5744.member * _e5693) + (_e5744.member_1 * _e5695)) + (_e5744.member_2 * _e5697)) * _e5725);
let _e5758 = global_1.member.member_19.member_4.member_2;
let _e5761 = ((_e5739 * _e5739) + (_e5753 * _e5753));
let _e5770 = global_1.member.member_19.member_4.member_3;
let _e5771 = ((_e5758 - sqrt(select(0f, _e5761, (_e5761 > 0f)))) * _e5770);
let _e5773 = select(0f, _e5771, (_e5771 > 0f));
let _e5775 = select(1f, _e5773, (_e5773 < 1f));
let _e5781 = select(0f, ((_e5775 * _e5775) * (3f - (2f * _e5775))), (_e5722 > 0f));
let _e5786 = global_1.member.member_19.member_4.member_5;
if ((_e5786 > 0u) && (_e5781 > 0f)) {
let _e5790 = (0.5f / _e5758);
let _e5800 = global_1.member.member_19.member_4.member_6;
let _e5801 = bitcast<i32>(_e5800);
local = bitcast<i32>(_e5786);
let _e5802 = local;
let _e5804 = f32((_e5802 - 1i));
let _e5806 = f32((_e5801 - 1i));
let _e5807 = local;
let _e5810 = (((0.5f + (_e5739 * _e5790)) * f32(_e5807)) - 0.5f);
let _e5812 = select(0f, _e5810, (_e5810 > 0f));
let _e5814 = select(_e5804, _e5812, (_e5812 < _e5804));
let _e5817 = (((0.5f - (_e5753 * _e5790)) * f32(_e5801)) - 0.5f);
let _e5819 = select(0f, _e5817, (_e5817 > 0f));
let _e5821 = select(_e5806, _e5819, (_e5819 < _e5806));
let _e5823 = select(0f, _e5814, (_e5814 > 0f));
let _e5825 = select(_e5804, _e5823, (_e5823 < _e5804));
let _e5832 = select(0i, select(select(i32(_e5825), i32(-2147483648), (_e5825 < -2147483600f)), 2147483647i, (_e5825 > 2147483500f)), (_e5825 == _e5825));
let _e5836 = (_e5832 - select(0i, 1i, (_e5825 < f32(_e5832))));
let _e5838 = select(0f, _e5821, (_e5821 > 0f));
let _e5840 = select(_e5806, _e5838, (_e5838 < _e5806));
let _e5847 = select(0i, select(select(i32(_e5840), i32(-2147483648), (_e5840 < -2147483600f)), 2147483647i, (_e5840 > 2147483500f)), (_e5840 == _e5840));
let _e5851 = (_e5847 - select(0i, 1i, (_e5840 < f32(_e5847))));
let _e5853 = (_e5814 - f32(_e5836));
let _e5855 = (_e5821 - f32(_e5851));
let _e5856 = (_e5836 + 1i);
let _e5857 = local;
let _e5859 = select(_e5836, _e5856, (_e5856 < _e5857));
let _e5860 = (_e5851 + 1i);
let _e5862 = select(_e5851, _e5860, (_e5860 < _e5801));
let _e5867 = global_1.member.member_19.member_4.member_4;
let _e5868 = bitcast<i32>(_e5867);
let _e5869 = local;
let _e5873 = (_e5868 + (3i * ((_e5851 * _e5869) + _e5836)));
let _e5875 = (bitcast<i32>(_e164) - 1i);
let _e5877 = select(_e5875, _e5873, (_e5873 < _e5875));
let _e5882 = global_3.member[bitcast<u32>(select(0i, _e5877, (_e5877 > 0i)))];
let _e5883 = (_e5873 + 1i);
let _e5885 = select(_e5875, _e5883, (_e5883 < _e5875));
let _e5890 = global_3.member[bitcast<u32>(select(0i, _e5885, (_e5885 > 0i)))];
let _e5891 = (_e5873 + 2i);
let _e5893 = select(_e5875, _e5891, (_e5891 < _e5875));
let _e5898 = global_3.member[bitcast<u32>(select(0i, _e5893, (_e5893 > 0i)))];
let _e5899 = local;
let _e5903 = (_e5868 + (3i * ((_e5851 * _e5899) + _e5859)));
let _e5905 = select(_e5875, _e5903, (_e5903 < _e5875));
let _e5910 = global_3.member[bitcast<u32>(select(0i, _e5905, (_e5905 > 0i)))];
let _e5911 = (_e5903 + 1i);
let _e5913 = select(_e5875, _e5911, (_e5911 < _e5875));
let _e5918 = global_3.member[bitcast<u32>(select(0i, _e5913, (_e5913 > 0i)))];
let _e5919 = (_e5903 + 2i);
let _e5921 = select(_e5875, _e5919, (_e5919 < _e5875));
let _e5926 = global_3.member[bitcast<u32>(select(0i, _e5921, (_e5921 > 0i)))];
let _e5927 = local;
let _e5931 = (_e5868 + (3i * ((_e5862 * _e5927) + _e5836)));
let _e5933 = select(_e5875, _e5931, (_e5931 < _e5875));
let _e5938 = global_3.member[bitcast<u32>(select(0i, _e5933, (_e5933 > 0i)))];
let _e5939 = (_e5931 + 1i);
let _e5941 = select(_e5875, _e5939, (_e5939 < _e5875));
let _e5946 = global_3.member[bitcast<u32>(select(0i, _e5941, (_e5941 > 0i)))];
let _e5947 = (_e5931 + 2i);
let _e5949 = select(_e5875, _e5947, (_e5947 < _e5875));
let _e5954 = global_3.member[bitcast<u32>(select(0i, _e5949, (_e5949 > 0i)))];
let _e5955 = local;
let _e5959 = (_e5868 + (3i * ((_e5862 * _e5955) + _e5859)));
let _e5961 = select(_e5875, _e5959, (_e5959 < _e5875));
let _e5966 = global_3.member[bitcast<u32>(select(0i, _e5961, (_e5961 > 0i)))];
let _e5967 = (_e5959 + 1i);
let _e5969 = select(_e5875, _e5967, (_e5967 < _e5875));
let _e5974 = global_3.member[bitcast<u32>(select(0i, _e5969, (_e5969 > 0i)))];
let _e5975 = (_e5959 + 2i);
let _e5977 = select(_e5875, _e5975, (_e5975 < _e5875));
let _e5982 = global_3.member[bitcast<u32>(select(0i, _e5977, (_e5977 > 0i)))];
let _e5989 = (_e5882 + ((_e5910 - _e5882) * _e5853));
let _e5990 = (_e5890 + ((_e5918 - _e5890) * _e5853));
let _e5991 = (_e5898 + ((_e5926 - _e5898) * _e5853));
phi_9731_ = vec3<f32>(((_e5989 + (((_e5938 + ((_e5966 - _e5938) * _e5853)) - _e5989) * _e5855)) * _e5781), ((_e5990 + (((_e5946 + ((_e5974 - _e5946) * _e5853)) - _e5990) * _e5855)) * _e5781), ((_e5991 + (((_e5954 + ((_e5982 - _e5954) * _e5853)) - _e5991) * _e5855)) * _e5781));
} else {
phi_9731_ = vec3(_e5781);
}
let _e6016 = phi_9731_;
phi_9734_ = (_e5709 * _e6016);
} else {
phi_9734_ = _e5709;
}
let _e6019 = phi_9734_;
let _e6023 = (1f / sqrt(select(0f, _e5704, (_e5704 > 0f))));
phi_9747_ = type_22(vec3<f32>((_e5693 * _e6023), (_e5695 * _e6023), (_e5697 * _e6023)), _e6019);
}
let _e6030 = phi_9747_;
let _e6041 = -((((select(_e5647, (_e5623.member_1.x * _e5634), _e5658) * _e6030.member.x) + (select(_e5648, (_e5623.member_1.y * _e5634), _e5658) * _e6030.member.y)) + (select(_e5649, (_e5623.member_1.z * _e5634), _e5658) * _e6030.member.z)));
let _e6046 = (((_e5623.member_1.x * _e6030.member.x) + (_e5623.member_1.y * _e6030.member.y)) + (_e5623.member_1.z * _e6030.member.z));
let _e6051 = -(_e6041);
let _e6056 = select((select(0f, _e6051, (_e6051 > 0f)) * _e5623.member_4), select(0f, _e6041, (_e6041 > 0f)), ((_e6046 * _e5632) > 0f));
let _e6057 = -(_e6046);
let _e6058 = -(_e6057);
let _e6060 = select(_e6058, _e6057, (_e6057 > _e6058));
let _e6066 = global_1.member.member_21.member_6;
let _e6080 = ((((_e6066.member.member * _e5623.member.x) + (_e6066.member.member_1 * _e5623.member.y)) + (_e6066.member.member_2 * _e5623.member.z)) + _e6066.member_1);
let _e6082 = select(1f, _e6080, (_e6080 > 1e-6f));
let _e6086 = global_1.member.member_21.member_4;
let _e6102 = global_1.member.member_21.member_5;
let _e6118 = global_1.member.member_21.member_2;
let _e6127 = -((((_e5623.member_1.x * _e6118.member) + (_e5623.member_1.y * _e6118.member_1)) + (_e5623.member_1.z * _e6118.member_2)));
let _e6128 = -(_e6127);
let _e6130 = select(_e6128, _e6127, (_e6127 > _e6128));
let _e6132 = select(1f, _e6130, (_e6130 < 1f));
let _e6134 = (1f - (_e6132 * _e6132));
let _e6141 = global_1.member.member_21.member_8;
let _e6149 = global_1.member.member_21.member_7.member;
let _e6154 = global_1.member.member_21.member_7.member_2;
let _e6156 = (_e6149 + (_e6154 * (((((_e6086.member.member * _e5623.member.x) + (_e6086.member.member_1 * _e5623.member.y)) + (_e6086.member.member_2 * _e5623.member.z)) + _e6086.member_1) / _e6082)));
let _e6161 = global_1.member.member_21.member_7.member_1;
let _e6163 = (_e6161 + (_e6154 * (((((_e6102.member.member * _e5623.member.x) + (_e6102.member.member_1 * _e5623.member.y)) + (_e6102.member.member_2 * _e5623.member.z)) + _e6102.member_1) / _e6082)));
let _e6167 = ((1f + (_e6156 * _e6156)) + (_e6163 * _e6163));
let _e6176 = global_1.member.member_21.member_9;
let _e6180 = (select(1f, -1f, (_e6057 < 0f)) * (((((1.4142135f * _e6141) * sqrt(select(0f, _e6134, (_e6134 > 0f)))) * _e6080) + (select(1f, _e6060, (_e6060 < 1f)) * sqrt(select(0f, _e6167, (_e6167 > 0f))))) * _e6176));
let _e6185 = select(0f, 1f, _e5623.member_5);
let _e6189 = (_e5623.member.x + ((_e5623.member_1.x * _e6180) * _e6185));
let _e6190 = (_e5623.member.y + ((_e5623.member_1.y * _e6180) * _e6185));
let _e6191 = (_e5623.member.z + ((_e5623.member_1.z * _e6180) * _e6185));
let _e6196 = global_1.member.member_21.member.member;
let _e6197 = bitcast<i32>(_e6196);
let _e6202 = global_1.member.member_21.member.member_1;
let _e6203 = bitcast<i32>(_e6202);
let _e6208 = global_1.member.member_21.member.member_2;
let _e6209 = bitcast<i32>(_e6208);
let _e6213 = global_1.member.member_21.member_1;
let _e6214 = bitcast<i32>(_e6213);
let _e6220 = ((((_e6066.member.member * _e6189) + (_e6066.member.member_1 * _e6190)) + (_e6066.member.member_2 * _e6191)) + _e6066.member_1);
let _e6222 = select(1f, _e6220, (_e6220 > 1e-6f));
let _e6226 = global_1.member.member_21.member_3;
let _e6237 = ((((_e6226.member.member * _e6189) + (_e6226.member.member_1 * _e6190)) + (_e6226.member.member_2 * _e6191)) + _e6226.member_1);
let _e6252 = ((((((_e6086.member.member * _e6189) + (_e6086.member.member_1 * _e6190)) + (_e6086.member.member_2 * _e6191)) + _e6086.member_1) / _e6222) - 0.5f);
let _e6253 = ((((((_e6102.member.member * _e6189) + (_e6102.member.member_1 * _e6190)) + (_e6102.member.member_2 * _e6191)) + _e6102.member_1) / _e6222) - 0.5f);
let _e6255 = f32((_e6197 - 1i));
let _e6257 = select(0f, _e6237, (_e6237 > 0f));
let _e6259 = select(_e6255, _e6257, (_e6257 < _e6255));
let _e6266 = select(0i, select(select(i32(_e6259), i32(-2147483648), (_e6259 < -2147483600f)), 2147483647i, (_e6259 > 2147483500f)), (_e6259 == _e6259));
let _e6270 = (_e6266 - select(0i, 1i, (_e6259 < f32(_e6266))));
let _e6274 = (_e6237 - f32(_e6270));
let _e6277 = select(1f, select(0f, _e6274, (_e6274 > 0f)), (_e6237 < f32(_e6197)));
let _e6278 = (_e6252 - _e6141);
let _e6279 = -(16f);
let _e6280 = f32(_e6203);
let _e6282 = select(_e6279, _e6278, (_e6278 > _e6279));
let _e6284 = select(_e6280, _e6282, (_e6282 < _e6280));
let _e6291 = select(0i, select(select(i32(_e6284), i32(-2147483648), (_e6284 < -2147483600f)), 2147483647i, (_e6284 > 2147483500f)), (_e6284 == _e6284));
let _e6297 = (_e6252 + _e6141);
let _e6300 = (f32((_e6203 - 1i)) + 16f);
let _e6302 = select(-1f, _e6297, (_e6297 > -1f));
let _e6304 = select(_e6300, _e6302, (_e6302 < _e6300));
let _e6311 = select(0i, select(select(i32(_e6304), i32(-2147483648), (_e6304 < -2147483600f)), 2147483647i, (_e6304 > 2147483500f)), (_e6304 == _e6304));
let _e6316 = (_e6253 - _e6141);
let _e6317 = f32(_e6209);
let _e6319 = select(_e6279, _e6316, (_e6316 > _e6279));
let _e6321 = select(_e6317, _e6319, (_e6319 < _e6317));
let _e6328 = select(0i, select(select(i32(_e6321), i32(-2147483648), (_e6321 < -2147483600f)), 2147483647i, (_e6321 > 2147483500f)), (_e6321 == _e6321));
let _e6334 = (_e6253 + _e6141);
let _e6337 = (f32((_e6209 - 1i)) + 16f);
let _e6339 = select(-1f, _e6334, (_e6334 > -1f));
let _e6341 = select(_e6337, _e6339, (_e6339 < _e6337));
let _e6348 = select(0i, select(select(i32(_e6341), i32(-2147483648), (_e6341 < -2147483600f)), 2147483647i, (_e6341 > 2147483500f)), (_e6341 == _e6341));
let _e6356 = bitcast<i32>(((_e6196 + 2u) >> bitcast<u32>(1i)));
let _e6358 = ((_e6203 * _e6209) * _e6356);
phi_10214_ = 0f;
phi_10217_ = vec3<f32>(0f, 0f, 0f);
phi_10219_ = ((_e6328 - select(0i, 1i, (_e6321 < f32(_e6328)))) + 1i);
loop {
let _e6360 = phi_10214_;
let _e6362 = phi_10217_;
let _e6364 = phi_10219_;
local_119 = _e6360;
local_120 = _e6360;
local_121 = _e6362;
local_122 = _e6362;
local_123 = _e6362;
let _e6365 = (_e6364 <= (_e6348 - select(0i, 1i, (_e6341 < f32(_e6348)))));
if _e6365 {
let _e6371 = (_e6141 - bitcast<f32>((bitcast<u32>((f32(_e6364) - _e6253)) & 2147483647u)));
phi_10234_ = ((_e6291 - select(0i, 1i, (_e6284 < f32(_e6291)))) + 1i);
phi_10237_ = _e6360;
phi_10239_ = _e6362;
loop {
let _e6373 = phi_10234_;
let _e6375 = phi_10237_;
let _e6377 = phi_10239_;
local_126 = _e6375;
local_127 = _e6377;
let _e6378 = (_e6373 <= (_e6311 - select(0i, 1i, (_e6304 < f32(_e6311)))));
if _e6378 {
let _e6384 = (_e6141 - bitcast<f32>((bitcast<u32>((f32(_e6373) - _e6252)) & 2147483647u)));
let _e6389 = (select(0f, _e6384, (_e6384 > 0f)) * select(0f, _e6371, (_e6371 > 0f)));
if ((((_e6373 >= 0i) && (_e6373 < _e6203)) && (_e6364 >= 0i)) && (_e6364 < _e6209)) {
let _e6399 = (((_e6364 * _e6203) + _e6373) * _e6356);
let _e6401 = (2i * _e6270);
let _e6402 = ((4i * _e6399) + _e6401);
let _e6404 = (_e6402 >> bitcast<u32>(2i));
let _e6407 = bitcast<u32>(((_e6402 & 3i) * 8i));
let _e6409 = (bitcast<i32>(_e170) - 1i);
let _e6411 = select(_e6409, _e6404, (_e6404 < _e6409));
let _e6417 = global_6.member[bitcast<u32>(select(0i, _e6411, (_e6411 > 0i)))];
let _e6421 = (_e6404 + 1i);
let _e6423 = select(_e6409, _e6421, (_e6421 < _e6409));
let _e6429 = global_6.member[bitcast<u32>(select(0i, _e6423, (_e6423 > 0i)))];
let _e6436 = ((_e6417 >> bitcast<u32>((_e6407 & 31u))) | ((_e6429 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6407) & 31u))));
let _e6439 = f32(bitcast<i32>((_e6436 & 65535u)));
let _e6447 = (1f / 65535f);
let _e6449 = (_e6389 * ((_e6439 + ((f32(bitcast<i32>((_e6436 >> bitcast<u32>(16i)))) - _e6439) * _e6277)) * _e6447));
let _e6451 = (_e6377.x + _e6449);
if (_e6214 > 1i) {
let _e6455 = ((4i * (_e6399 + _e6358)) + _e6401);
let _e6457 = (_e6455 >> bitcast<u32>(2i));
let _e6460 = bitcast<u32>(((_e6455 & 3i) * 8i));
let _e6462 = select(_e6409, _e6457, (_e6457 < _e6409));
let _e6468 = global_6.member[bitcast<u32>(select(0i, _e6462, (_e6462 > 0i)))];
let _e6472 = (_e6457 + 1i);
let _e6474 = select(_e6409, _e6472, (_e6472 < _e6409));
let _e6480 = global_6.member[bitcast<u32>(select(0i, _e6474, (_e6474 > 0i)))];
let _e6487 = ((_e6468 >> bitcast<u32>((_e6460 & 31u))) | ((_e6480 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6460) & 31u))));
let _e6490 = f32(bitcast<i32>((_e6487 & 65535u)));
let _e6505 = ((4i * (_e6399 + (2i * _e6358))) + _e6401);
let _e6507 = (_e6505 >> bitcast<u32>(2i));
let _e6510 = bitcast<u32>(((_e6505 & 3i) * 8i));
let _e6512 = select(_e6409, _e6507, (_e6507 < _e6409));
let _e6518 = global_6.member[bitcast<u32>(select(0i, _e6512, (_e6512 > 0i)))];
let _e6522 = (_e6507 + 1i);
let _e6524 = select(_e6409, _e6522, (_e6522 < _e6409));
let _e6530 = global_6.member[bitcast<u32>(select(0i, _e6524, (_e6524 > 0i)))];
let _e6537 = ((_e6518 >> bitcast<u32>((_e6510 & 31u))) | ((_e6530 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6510) & 31u))));
let _e6540 = f32(bitcast<i32>((_e6537 & 65535u)));
phi_10472_ = vec3<f32>(_e6451, (_e6377.y + (_e6389 * ((_e6490 + ((f32(bitcast<i32>((_e6487 >> bitcast<u32>(16i)))) - _e6490) * _e6277)) * _e6447))), (_e6377.z + (_e6389 * ((_e6540 + ((f32(bitcast<i32>((_e6537 >> bitcast<u32>(16i)))) - _e6540) * _e6277)) * _e6447))));
} else {
phi_10472_ = vec3<f32>(_e6451, (_e6377.y + _e6449), (_e6377.z + _e6449));
}
let _e6559 = phi_10472_;
phi_10482_ = _e6559;
} else {
phi_10482_ = vec3<f32>((_e6377.x + _e6389), (_e6377.y + _e6389), (_e6377.z + _e6389));
}
let _e6568 = phi_10482_;
phi_10235_ = (_e6373 + 1i);
phi_10238_ = (_e6375 + _e6389);
phi_10240_ = _e6568;
} else {
phi_10235_ = i32();
phi_10238_ = f32();
phi_10240_ = vec3<f32>();
}
let _e6572 = phi_10235_;
let _e6574 = phi_10238_;
let _e6576 = phi_10240_;
continue;
continuing {
phi_10234_ = _e6572;
phi_10237_ = _e6574;
phi_10239_ = _e6576;
break if !(_e6378);
}
}
let _e6977 = local_126;
phi_10215_ = _e6977;
let _e6980 = local_127;
phi_10218_ = _e6980;
phi_10220_ = (_e6364 + 1i);
} else {
phi_10215_ = f32();
phi_10218_ = vec3<f32>();
phi_10220_ = i32();
}
let _e6580 = phi_10215_;
let _e6582 = phi_10218_;
let _e6584 = phi_10220_;
continue;
continuing {
phi_10214_ = _e6580;
phi_10217_ = _e6582;
phi_10219_ = _e6584;
break if !(_e6365);
}
}
let _e6588 = local_119;
let _e6592 = (((_e6214 == 0i) || (_e6588 <= 0f)) || (_e6220 <= 1e-6f));
let _e6594 = local_120;
let _e6596 = (1f / select(_e6594, 1f, _e6592));
let _e6598 = local_121;
let _e6603 = local_122;
let _e6608 = local_123;
let _e6624 = global_1.member.member_20;
phi_10534_ = (_e5623.member_3 * vec3<f32>(((_e6030.member_1.x * (select((_e6598.x * _e6596), 1f, _e6592) * _e6056)) + _e6624.member), ((_e6030.member_1.y * (select((_e6603.y * _e6596), 1f, _e6592) * _e6056)) + _e6624.member_1), ((_e6030.member_1.z * (select((_e6608.z * _e6596), 1f, _e6592) * _e6056)) + _e6624.member_2)));
} else {
phi_10534_ = _e5086;
}
let _e6634 = phi_10534_;
phi_10535_ = _e6634;
} else {
phi_10535_ = _e5086;
}
let _e6636 = phi_10535_;
let _e6644 = ((_e282 > 0f) || _e296);
let _e6648 = global_1.member.member_16.member_12;
let _e6649 = select(_e6648, 1f, _e6644);
let _e6658 = global_1.member.member_11;
let _e6659 = local_49;
let _e6661 = local_48;
let _e6662 = ((20i * _e6659) + _e6661);
let _e6664 = select(_e208, _e6662, (_e6662 < _e208));
let _e6669 = global_2.member[bitcast<u32>(select(0i, _e6664, (_e6664 > 0i)))];
let _e6693 = local_49;
let _e6695 = local_48;
let _e6696 = ((19i * _e6693) + _e6695);
let _e6698 = select(_e208, _e6696, (_e6696 < _e208));
let _e6703 = global_2.member[bitcast<u32>(select(0i, _e6698, (_e6698 > 0i)))];
global_8.member[_e185] = ((((_e3798.x * _e3853) + (_e3810 * _e3835.member)) + (_e6636.x * _e3937)) * _e6649);
global_8.member[(_e183 + _e185)] = ((((_e3798.y * _e3864) + (_e3821 * _e3835.member_1)) + (_e6636.y * _e3937)) * _e6649);
global_8.member[((2u * _e183) + _e185)] = ((((_e3798.z * _e3875) + (_e3832 * _e3835.member_2)) + (_e6636.z * _e3937)) * _e6649);
global_8.member[((3u * _e183) + _e185)] = _e6649;
global_8.member[((4u * _e183) + _e185)] = (((_e414.member * _e3922) + (_e414.member_1 * _e3924)) + (_e414.member_2 * _e3926));
global_8.member[((5u * _e183) + _e185)] = (((_e423.member * _e3922) + (_e423.member_1 * _e3924)) + (_e423.member_2 * _e3926));
global_8.member[((6u * _e183) + _e185)] = -((((_e441.member * _e3922) + (_e441.member_1 * _e3924)) + (_e441.member_2 * _e3926)));
global_8.member[((7u * _e183) + _e185)] = _e282;
global_8.member[((8u * _e183) + _e185)] = (_e6703 * _e6658);
global_8.member[((9u * _e183) + _e185)] = select(0f, ((_e6669 * _e6658) * (((_e441.member * _e1050) + (_e441.member_1 * _e1051)) + (_e441.member_2 * _e1052))), _e6644);
global_8.member[((10u * _e183) + _e185)] = (((_e414.member * _e215) + (_e414.member_1 * _e226)) + (_e414.member_2 * _e237));
global_8.member[((11u * _e183) + _e185)] = (((_e423.member * _e215) + (_e423.member_1 * _e226)) + (_e423.member_2 * _e237));
global_8.member[((12u * _e183) + _e185)] = -((((_e441.member * _e215) + (_e441.member_1 * _e226)) + (_e441.member_2 * _e237)));
global_8.member[((13u * _e183) + _e185)] = _e249;
global_8.member[((14u * _e183) + _e185)] = _e260;
global_8.member[((15u * _e183) + _e185)] = _e271;
global_8.member[((16u * _e183) + _e185)] = _e3937;
global_8.member[((17u * _e183) + _e185)] = select(_e293, 2f, ((_e293 == 0f) || (_e293 == 4f)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
