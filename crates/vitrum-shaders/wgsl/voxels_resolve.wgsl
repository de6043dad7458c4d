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
var phi_4688_: type_22;
var phi_5262_: vec3<f32>;
var phi_5265_: vec3<f32>;
var phi_5278_: type_23;
var phi_5734_: f32;
var phi_5737_: vec3<f32>;
var phi_5739_: i32;
var phi_5754_: i32;
var phi_5757_: f32;
var phi_5759_: vec3<f32>;
var phi_5992_: vec3<f32>;
var phi_6002_: vec3<f32>;
var phi_5755_: i32;
var phi_5758_: f32;
var phi_5760_: vec3<f32>;
var phi_5735_: f32;
var phi_5738_: vec3<f32>;
var phi_5740_: i32;
var local_82: f32;
var local_83: f32;
var local_84: vec3<f32>;
var local_85: vec3<f32>;
var local_86: vec3<f32>;
var phi_6120_: vec3<f32>;
var phi_6121_: vec3<f32>;
var phi_6786_: vec3<f32>;
var phi_7388_: i32;
var phi_7391_: i32;
var phi_7393_: i32;
var phi_7395_: i32;
var phi_7410_: i32;
var phi_7416_: i32;
var phi_7389_: i32;
var phi_7392_: i32;
var phi_7394_: i32;
var phi_7396_: i32;
var local_87: i32;
var local_88: i32;
var local_89: i32;
var phi_7491_: i32;
var local_90: i32;
var local_91: i32;
var phi_7497_: i32;
var local_92: i32;
var phi_7504_: i32;
var local_93: i32;
var local_94: i32;
var phi_7510_: i32;
var local_95: i32;
var local_96: i32;
var phi_7521_: i32;
var local_97: i32;
var local_98: i32;
var phi_7533_: i32;
var local_99: i32;
var local_100: i32;
var local_101: i32;
var local_102: i32;
var phi_7769_: i32;
var phi_7772_: i32;
var phi_7774_: i32;
var phi_7776_: i32;
var phi_7791_: i32;
var phi_7797_: i32;
var phi_7770_: i32;
var phi_7773_: i32;
var phi_7775_: i32;
var phi_7777_: i32;
var local_103: i32;
var local_104: i32;
var local_105: i32;
var phi_7872_: i32;
var local_106: i32;
var local_107: i32;
var phi_7878_: i32;
var local_108: i32;
var phi_7885_: i32;
var local_109: i32;
var local_110: i32;
var phi_7891_: i32;
var local_111: i32;
var local_112: i32;
var phi_7902_: i32;
var local_113: i32;
var local_114: i32;
var phi_7914_: i32;
var local_115: i32;
var local_116: i32;
var local_117: i32;
var local_118: i32;
var phi_8169_: vec3<f32>;
var phi_8170_: vec3<f32>;
var phi_8171_: vec3<f32>;
var phi_9146_: type_22;
var phi_9720_: vec3<f32>;
var phi_9723_: vec3<f32>;
var phi_9736_: type_23;
var phi_10192_: f32;
var phi_10195_: vec3<f32>;
var phi_10197_: i32;
var phi_10212_: i32;
var phi_10215_: f32;
var phi_10217_: vec3<f32>;
var phi_10450_: vec3<f32>;
var phi_10460_: vec3<f32>;
var phi_10213_: i32;
var phi_10216_: f32;
var phi_10218_: vec3<f32>;
var phi_10193_: f32;
var phi_10196_: vec3<f32>;
var phi_10198_: i32;
var local_119: f32;
var local_120: f32;
var local_121: vec3<f32>;
var local_122: vec3<f32>;
var local_123: vec3<f32>;
var phi_10512_: vec3<f32>;
var phi_10513_: vec3<f32>;
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
phi_4688_ = type_22(_e2318, _e2352, _e2352, vec3<f32>(select(_e2342.member, _e2331.member, _e2320), select(_e2342.member_1, _e2331.member_1, _e2320), select(_e2342.member_2, _e2331.member_2, _e2320)), 0f, false);
} else {
let _e2364 = (_e2287 * 19i);
let _e2366 = (bitcast<i32>(_e166) - 1i);
let _e2368 = select(_e2366, _e2364, (_e2364 < _e2366));
let _e2374 = global_4.member[bitcast<u32>(select(0i, _e2368, (_e2368 > 0i)))];
let _e2375 = (_e2364 + 1i);
let _e2377 = select(_e2366, _e2375, (_e2375 < _e2366));
let _e2383 = global_4.member[bitcast<u32>(select(0i, _e2377, (_e2377 > 0i)))];
let _e2384 = (_e2364 + 2i);
let _e2386 = select(_e2366, _e2384, (_e2384 < _e2366));
let _e2392 = global_4.member[bitcast<u32>(select(0i, _e2386, (_e2386 > 0i)))];
let _e2393 = (_e2364 + 3i);
let _e2395 = select(_e2366, _e2393, (_e2393 < _e2366));
let _e2401 = global_4.member[bitcast<u32>(select(0i, _e2395, (_e2395 > 0i)))];
let _e2402 = (_e2364 + 4i);
let _e2404 = select(_e2366, _e2402, (_e2402 < _e2366));
let _e2410 = global_4.member[bitcast<u32>(select(0i, _e2404, (_e2404 > 0i)))];
let _e2411 = (_e2364 + 5i);
let _e2413 = select(_e2366, _e2411, (_e2411 < _e2366));
let _e2419 = global_4.member[bitcast<u32>(select(0i, _e2413, (_e2413 > 0i)))];
let _e2420 = (_e2364 + 6i);
let _e2422 = select(_e2366, _e2420, (_e2420 < _e2366));
let _e2428 = global_4.member[bitcast<u32>(select(0i, _e2422, (_e2422 > 0i)))];
let _e2429 = (_e2364 + 7i);
let _e2431 = select(_e2366, _e2429, (_e2429 < _e2366));
let _e2437 = global_4.member[bitcast<u32>(select(0i, _e2431, (_e2431 > 0i)))];
let _e2438 = (_e2364 + 8i);
let _e2440 = select(_e2366, _e2438, (_e2438 < _e2366));
let _e2446 = global_4.member[bitcast<u32>(select(0i, _e2440, (_e2440 > 0i)))];
let _e2447 = (_e2401 - _e2374);
let _e2448 = (_e2410 - _e2383);
let _e2449 = (_e2419 - _e2392);
let _e2450 = (_e2428 - _e2374);
let _e2451 = (_e2437 - _e2383);
let _e2452 = (_e2446 - _e2392);
let _e2455 = ((_e2448 * _e2452) - (_e2449 * _e2451));
let _e2458 = ((_e2449 * _e2450) - (_e2447 * _e2452));
let _e2461 = ((_e2447 * _e2451) - (_e2448 * _e2450));
let _e2462 = (_e2401 - _e2296);
let _e2463 = (_e2410 - _e2306);
let _e2464 = (_e2419 - _e2317);
let _e2465 = (_e2428 - _e2296);
let _e2466 = (_e2437 - _e2306);
let _e2467 = (_e2446 - _e2317);
let _e2481 = (((((_e2463 * _e2467) - (_e2464 * _e2466)) * _e2455) + (((_e2464 * _e2465) - (_e2462 * _e2467)) * _e2458)) + (((_e2462 * _e2466) - (_e2463 * _e2465)) * _e2461));
let _e2483 = select(0f, _e2481, (_e2481 > 0f));
let _e2484 = (_e2374 - _e2296);
let _e2485 = (_e2383 - _e2306);
let _e2486 = (_e2392 - _e2317);
let _e2500 = (((((_e2466 * _e2486) - (_e2467 * _e2485)) * _e2455) + (((_e2467 * _e2484) - (_e2465 * _e2486)) * _e2458)) + (((_e2465 * _e2485) - (_e2466 * _e2484)) * _e2461));
let _e2502 = select(0f, _e2500, (_e2500 > 0f));
let _e2516 = (((((_e2485 * _e2464) - (_e2486 * _e2463)) * _e2455) + (((_e2486 * _e2462) - (_e2484 * _e2464)) * _e2458)) + (((_e2484 * _e2463) - (_e2485 * _e2462)) * _e2461));
let _e2518 = select(0f, _e2516, (_e2516 > 0f));
let _e2520 = ((_e2483 + _e2502) + _e2518);
let _e2522 = select(1e-30f, _e2520, (_e2520 > 1e-30f));
let _e2523 = (_e2483 / _e2522);
let _e2524 = (_e2502 / _e2522);
let _e2525 = (_e2518 / _e2522);
let _e2530 = (((_e2455 * _e2455) + (_e2458 * _e2458)) + (_e2461 * _e2461));
let _e2533 = sqrt(select(0f, _e2530, (_e2530 > 0f)));
let _e2536 = (1f / select(1e-20f, _e2533, (_e2533 > 1e-20f)));
let _e2541 = (_e2364 + 9i);
let _e2543 = select(_e2366, _e2541, (_e2541 < _e2366));
let _e2549 = global_4.member[bitcast<u32>(select(0i, _e2543, (_e2543 > 0i)))];
let _e2550 = (_e2364 + 10i);
let _e2552 = select(_e2366, _e2550, (_e2550 < _e2366));
let _e2558 = global_4.member[bitcast<u32>(select(0i, _e2552, (_e2552 > 0i)))];
let _e2559 = (_e2364 + 11i);
let _e2561 = select(_e2366, _e2559, (_e2559 < _e2366));
let _e2567 = global_4.member[bitcast<u32>(select(0i, _e2561, (_e2561 > 0i)))];
let _e2571 = (_e2364 + 12i);
let _e2573 = select(_e2366, _e2571, (_e2571 < _e2366));
let _e2579 = global_4.member[bitcast<u32>(select(0i, _e2573, (_e2573 > 0i)))];
let _e2580 = (_e2364 + 13i);
let _e2582 = select(_e2366, _e2580, (_e2580 < _e2366));
let _e2588 = global_4.member[bitcast<u32>(select(0i, _e2582, (_e2582 > 0i)))];
let _e2589 = (_e2364 + 14i);
let _e2591 = select(_e2366, _e2589, (_e2589 < _e2366));
let _e2597 = global_4.member[bitcast<u32>(select(0i, _e2591, (_e2591 > 0i)))];
let _e2604 = (_e2364 + 15i);
let _e2606 = select(_e2366, _e2604, (_e2604 < _e2366));
let _e2612 = global_4.member[bitcast<u32>(select(0i, _e2606, (_e2606 > 0i)))];
let _e2613 = (_e2364 + 16i);
let _e2615 = select(_e2366, _e2613, (_e2613 < _e2366));
let _e2621 = global_4.member[bitcast<u32>(select(0i, _e2615, (_e2615 > 0i)))];
let _e2622 = (_e2364 + 17i);
let _e2624 = select(_e2366, _e2622, (_e2622 < _e2366));
let _e2630 = global_4.member[bitcast<u32>(select(0i, _e2624, (_e2624 > 0i)))];
let _e2634 = (((_e2549 * _e2523) + (_e2579 * _e2524)) + (_e2612 * _e2525));
let _e2635 = (((_e2558 * _e2523) + (_e2588 * _e2524)) + (_e2621 * _e2525));
let _e2636 = (((_e2567 * _e2523) + (_e2597 * _e2524)) + (_e2630 * _e2525));
let _e2641 = (((_e2634 * _e2634) + (_e2635 * _e2635)) + (_e2636 * _e2636));
let _e2644 = sqrt(select(0f, _e2641, (_e2641 > 0f)));
let _e2647 = (1f / select(1e-20f, _e2644, (_e2644 > 1e-20f)));
let _e2654 = global_1.member.member_1;
let _e2657 = (_e2364 + 18i);
let _e2659 = select(_e2366, _e2657, (_e2657 < _e2366));
let _e2665 = global_4.member[bitcast<u32>(select(0i, _e2659, (_e2659 > 0i)))];
let _e2674 = (select(select(0i, select(select(i32(_e2665), i32(-2147483648), (_e2665 < -2147483600f)), 2147483647i, (_e2665 > 2147483500f)), (_e2665 == _e2665)), _e2287, ((_e2654 & 4u) != 0u)) * 10i);
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
phi_4688_ = type_22(_e2318, vec3<f32>((_e2455 * _e2536), (_e2458 * _e2536), (_e2461 * _e2536)), vec3<f32>((_e2634 * _e2647), (_e2635 * _e2647), (_e2636 * _e2647)), vec3<f32>((((_e2684 * _e2523) + (_e2714 * _e2524)) + (_e2747 * _e2525)), (((_e2693 * _e2523) + (_e2723 * _e2524)) + (_e2756 * _e2525)), (((_e2702 * _e2523) + (_e2732 * _e2524)) + (_e2765 * _e2525))), _e2781, true);
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
phi_5278_ = type_23(vec3<f32>(_e2840.member, _e2840.member_1, _e2840.member_2), vec3<f32>(_e2827.member, _e2827.member_1, _e2827.member_2));
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
phi_5278_ = type_23(vec3<f32>((_e2854 * _e3184), (_e2856 * _e3184), (_e2858 * _e3184)), _e3180);
}
let _e3191 = phi_5278_;
let _e3202 = -((((_e2820 * _e3191.member.x) + (_e2821 * _e3191.member.y)) + (_e2822 * _e3191.member.z)));
let _e3208 = -((((_e2784.member_1.x * _e3191.member.x) + (_e2784.member_1.y * _e3191.member.y)) + (_e2784.member_1.z * _e3191.member.z)));
let _e3214 = -(_e3202);
let _e3219 = select((select(0f, _e3214, (_e3214 > 0f)) * _e2784.member_4), select(0f, _e3202, (_e3202 > 0f)), ((_e3208 * -(_e2793)) > 0f));
let _e3220 = -(_e3208);
let _e3222 = select(_e3220, _e3208, (_e3208 > _e3220));
let _e3228 = global_1.member.member_21.member_6;
let _e3242 = ((((_e3228.member.member * _e2784.member.x) + (_e3228.member.member_1 * _e2784.member.y)) + (_e3228.member.member_2 * _e2784.member.z)) + _e3228.member_1);
let _e3244 = select(1f, _e3242, (_e3242 > 1e-6f));
let _e3248 = global_1.member.member_21.member_4;
let _e3264 = global_1.member.member_21.member_5;
let _e3280 = global_1.member.member_21.member_2;
let _e3289 = -((((_e2784.member_1.x * _e3280.member) + (_e2784.member_1.y * _e3280.member_1)) + (_e2784.member_1.z * _e3280.member_2)));
let _e3290 = -(_e3289);
let _e3292 = select(_e3290, _e3289, (_e3289 > _e3290));
let _e3294 = select(1f, _e3292, (_e3292 < 1f));
let _e3296 = (1f - (_e3294 * _e3294));
let _e3303 = global_1.member.member_21.member_8;
let _e3311 = global_1.member.member_21.member_7.member;
let _e3316 = global_1.member.member_21.member_7.member_2;
let _e3318 = (_e3311 + (_e3316 * (((((_e3248.member.member * _e2784.member.x) + (_e3248.member.member_1 * _e2784.member.y)) + (_e3248.member.member_2 * _e2784.member.z)) + _e3248.member_1) / _e3244)));
let _e3323 = global_1.member.member_21.member_7.member_1;
let _e3325 = (_e3323 + (_e3316 * (((((_e3264.member.member * _e2784.member.x) + (_e3264.member.member_1 * _e2784.member.y)) + (_e3264.member.member_2 * _e2784.member.z)) + _e3264.member_1) / _e3244)));
let _e3329 = ((1f + (_e3318 * _e3318)) + (_e3325 * _e3325));
let _e3338 = global_1.member.member_21.member_9;
let _e3342 = (select(1f, -1f, (_e3208 < 0f)) * (((((1.4142135f * _e3303) * sqrt(select(0f, _e3296, (_e3296 > 0f)))) * _e3242) + (select(1f, _e3222, (_e3222 < 1f)) * sqrt(select(0f, _e3329, (_e3329 > 0f))))) * _e3338));
let _e3347 = select(0f, 1f, _e2784.member_5);
let _e3351 = (_e2784.member.x + ((_e2784.member_1.x * _e3342) * _e3347));
let _e3352 = (_e2784.member.y + ((_e2784.member_1.y * _e3342) * _e3347));
let _e3353 = (_e2784.member.z + ((_e2784.member_1.z * _e3342) * _e3347));
let _e3358 = global_1.member.member_21.member.member;
let _e3359 = bitcast<i32>(_e3358);
let _e3364 = global_1.member.member_21.member.member_1;
let _e3365 = bitcast<i32>(_e3364);
let _e3370 = global_1.member.member_21.member.member_2;
let _e3371 = bitcast<i32>(_e3370);
let _e3375 = global_1.member.member_21.member_1;
let _e3376 = bitcast<i32>(_e3375);
let _e3382 = ((((_e3228.member.member * _e3351) + (_e3228.member.member_1 * _e3352)) + (_e3228.member.member_2 * _e3353)) + _e3228.member_1);
let _e3384 = select(1f, _e3382, (_e3382 > 1e-6f));
let _e3388 = global_1.member.member_21.member_3;
let _e3399 = ((((_e3388.member.member * _e3351) + (_e3388.member.member_1 * _e3352)) + (_e3388.member.member_2 * _e3353)) + _e3388.member_1);
let _e3414 = ((((((_e3248.member.member * _e3351) + (_e3248.member.member_1 * _e3352)) + (_e3248.member.member_2 * _e3353)) + _e3248.member_1) / _e3384) - 0.5f);
let _e3415 = ((((((_e3264.member.member * _e3351) + (_e3264.member.member_1 * _e3352)) + (_e3264.member.member_2 * _e3353)) + _e3264.member_1) / _e3384) - 0.5f);
let _e3417 = f32((_e3359 - 1i));
let _e3419 = select(0f, _e3399, (_e3399 > 0f));
let _e3421 = select(_e3417, _e3419, (_e3419 < _e3417));
let _e3428 = select(0i, select(select(i32(_e3421), i32(-2147483648), (_e3421 < -2147483600f)), 2147483647i, (_e3421 > 2147483500f)), (_e3421 == _e3421));
let _e3432 = (_e3428 - select(0i, 1i, (_e3421 < f32(_e3428))));
let _e3436 = (_e3399 - f32(_e3432));
let _e3439 = select(1f, select(0f, _e3436, (_e3436 > 0f)), (_e3399 < f32(_e3359)));
let _e3440 = (_e3414 - _e3303);
let _e3441 = -(16f);
let _e3442 = f32(_e3365);
let _e3444 = select(_e3441, _e3440, (_e3440 > _e3441));
let _e3446 = select(_e3442, _e3444, (_e3444 < _e3442));
let _e3453 = select(0i, select(select(i32(_e3446), i32(-2147483648), (_e3446 < -2147483600f)), 2147483647i, (_e3446 > 2147483500f)), (_e3446 == _e3446));
let _e3459 = (_e3414 + _e3303);
let _e3462 = (f32((_e3365 - 1i)) + 16f);
let _e3464 = select(-1f, _e3459, (_e3459 > -1f));
let _e3466 = select(_e3462, _e3464, (_e3464 < _e3462));
let _e3473 = select(0i, select(select(i32(_e3466), i32(-2147483648), (_e3466 < -2147483600f)), 2147483647i, (_e3466 > 2147483500f)), (_e3466 == _e3466));
let _e3478 = (_e3415 - _e3303);
let _e3479 = f32(_e3371);
let _e3481 = select(_e3441, _e3478, (_e3478 > _e3441));
let _e3483 = select(_e3479, _e3481, (_e3481 < _e3479));
let _e3490 = select(0i, select(select(i32(_e3483), i32(-2147483648), (_e3483 < -2147483600f)), 2147483647i, (_e3483 > 2147483500f)), (_e3483 == _e3483));
let _e3496 = (_e3415 + _e3303);
let _e3499 = (f32((_e3371 - 1i)) + 16f);
let _e3501 = select(-1f, _e3496, (_e3496 > -1f));
let _e3503 = select(_e3499, _e3501, (_e3501 < _e3499));
let _e3510 = select(0i, select(select(i32(_e3503), i32(-2147483648), (_e3503 < -2147483600f)), 2147483647i, (_e3503 > 2147483500f)), (_e3503 == _e3503));
let _e3518 = bitcast<i32>(((_e3358 + 2u) >> bitcast<u32>(1i)));
let _e3520 = ((_e3365 * _e3371) * _e3518);
phi_5734_ = 0f;
phi_5737_ = vec3<f32>(0f, 0f, 0f);
phi_5739_ = ((_e3490 - select(0i, 1i, (_e3483 < f32(_e3490)))) + 1i);
loop {
let _e3522 = phi_5734_;
let _e3524 = phi_5737_;
let _e3526 = phi_5739_;
local_82 = _e3522;
local_83 = _e3522;
local_84 = _e3524;
local_85 = _e3524;
local_86 = _e3524;
let _e3527 = (_e3526 <= (_e3510 - select(0i, 1i, (_e3503 < f32(_e3510)))));
if _e3527 {
let _e3533 = (_e3303 - bitcast<f32>((bitcast<u32>((f32(_e3526) - _e3415)) & 2147483647u)));
phi_5754_ = ((_e3453 - select(0i, 1i, (_e3446 < f32(_e3453)))) + 1i);
phi_5757_ = _e3522;
phi_5759_ = _e3524;
loop {
let _e3535 = phi_5754_;
let _e3537 = phi_5757_;
let _e3539 = phi_5759_;
local_124 = _e3537;
local_125 = _e3539;
let _e3540 = (_e3535 <= (_e3473 - select(0i, 1i, (_e3466 < f32(_e3473)))));
if _e3540 {
let _e3546 = (_e3303 - bitcast<f32>((bitcast<u32>((f32(_e3535) - _e3414)) & 2147483647u)));
let _e3551 = (select(0f, _e3546, (_e3546 > 0f)) * select(0f, _e3533, (_e3533 > 0f)));
if ((((_e3535 >= 0i) && (_e3535 < _e3365)) && (_e3526 >= 0i)) && (_e3526 < _e3371)) {
let _e3561 = (((_e3526 * _e3365) + _e3535) * _e3518);
let _e3563 = (2i * _e3432);
let _e3564 = ((4i * _e3561) + _e3563);
let _e3566 = (_e3564 >> bitcast<u32>(2i));
let _e3569 = bitcast<u32>(((_e3564 & 3i) * 8i));
let _e3571 = (bitcast<i32>(_e170) - 1i);
let _e3573 = select(_e3571, _e3566, (_e3566 < _e3571));
let _e3579 = global_6.member[bitcast<u32>(select(0i, _e3573, (_e3573 > 0i)))];
let _e3583 = (_e3566 + 1i);
let _e3585 = select(_e3571, _e3583, (_e3583 < _e3571));
let _e3591 = global_6.member[bitcast<u32>(select(0i, _e3585, (_e3585 > 0i)))];
let _e3598 = ((_e3579 >> bitcast<u32>((_e3569 & 31u))) | ((_e3591 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3569) & 31u))));
let _e3601 = f32(bitcast<i32>((_e3598 & 65535u)));
let _e3609 = (1f / 65535f);
let _e3611 = (_e3551 * ((_e3601 + ((f32(bitcast<i32>((_e3598 >> bitcast<u32>(16i)))) - _e3601) * _e3439)) * _e3609));
let _e3613 = (_e3539.x + _e3611);
if (_e3376 > 1i) {
let _e3617 = ((4i * (_e3561 + _e3520)) + _e3563);
let _e3619 = (_e3617 >> bitcast<u32>(2i));
let _e3622 = bitcast<u32>(((_e3617 & 3i) * 8i));
let _e3624 = select(_e3571, _e3619, (_e3619 < _e3571));
let _e3630 = global_6.member[bitcast<u32>(select(0i, _e3624, (_e3624 > 0i)))];
let _e3634 = (_e3619 + 1i);
let _e3636 = select(_e3571, _e3634, (_e3634 < _e3571));
let _e3642 = global_6.member[bitcast<u32>(select(0i, _e3636, (_e3636 > 0i)))];
let _e3649 = ((_e3630 >> bitcast<u32>((_e3622 & 31u))) | ((_e3642 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3622) & 31u))));
let _e3652 = f32(bitcast<i32>((_e3649 & 65535u)));
let _e3667 = ((4i * (_e3561 + (2i * _e3520))) + _e3563);
let _e3669 = (_e3667 >> bitcast<u32>(2i));
let _e3672 = bitcast<u32>(((_e3667 & 3i) * 8i));
let _e3674 = select(_e3571, _e3669, (_e3669 < _e3571));
let _e3680 = global_6.member[bitcast<u32>(select(0i, _e3674, (_e3674 > 0i)))];
let _e3684 = (_e3669 + 1i);
let _e3686 = select(_e3571, _e3684, (_e3684 < _e3571));
let _e3692 = global_6.member[bitcast<u32>(select(0i, _e3686, (_e3686 > 0i)))];
let _e3699 = ((_e3680 >> bitcast<u32>((_e3672 & 31u))) | ((_e3692 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3672) & 31u))));
let _e3702 = f32(bitcast<i32>((_e3699 & 65535u)));
phi_5992_ = vec3<f32>(_e3613, (_e3539.y + (_e3551 * ((_e3652 + ((f32(bitcast<i32>((_e3649 >> bitcast<u32>(16i)))) - _e3652) * _e3439)) * _e3609))), (_e3539.z + (_e3551 * ((_e3702 + ((f32(bitcast<i32>((_e3699 >> bitcast<u32>(16i)))) - _e3702) * _e3439)) * _e3609))));
} else {
phi_5992_ = vec3<f32>(_e3613, (_e3539.y + _e3611), (_e3539.z + _e3611));
}
let _e3721 = phi_5992_;
phi_6002_ = _e3721;
} else {
phi_6002_ = vec3<f32>((_e3539.x + _e3551), (_e3539.y + _e3551), (_e3539.z + _e3551));
}
let _e3730 = phi_6002_;
phi_5755_ = (_e3535 + 1i);
phi_5758_ = (_e3537 + _e3551);
phi_5760_ = _e3730;
} else {
phi_5755_ = i32();
phi_5758_ = f32();
phi_5760_ = vec3<f32>();
}
let _e3734 = phi_5755_;
let _e3736 = phi_5758_;
let _e3738 = phi_5760_;
continue;
continuing {
phi_5754_ = _e3734;
phi_5757_ = _e3736;
phi_5759_ = _e3738;
break if !(_e3540);
}
}
let _e6882 = local_124;
phi_5735_ = _e6882;
let _e6885 = local_125;
phi_5738_ = _e6885;
phi_5740_ = (_e3526 + 1i);
} else {
phi_5735_ = f32();
phi_5738_ = vec3<f32>();
phi_5740_ = i32();
}
let _e3742 = phi_5735_;
let _e3744 = phi_5738_;
let _e3746 = phi_5740_;
continue;
continuing {
phi_5734_ = _e3742;
phi_5737_ = _e3744;
phi_5739_ = _e3746;
break if !(_e3527);
}
}
let _e3750 = local_82;
let _e3754 = (((_e3376 == 0i) || (_e3750 <= 0f)) || (_e3382 <= 1e-6f));
let _e3756 = local_83;
let _e3758 = (1f / select(_e3756, 1f, _e3754));
let _e3760 = local_84;
let _e3765 = local_85;
let _e3770 = local_86;
let _e3786 = global_1.member.member_20;
phi_6120_ = vec3<f32>(_e2820, _e2821, _e2822);
phi_6121_ = (_e2784.member_3 * vec3<f32>(((_e3191.member_1.x * (select((_e3760.x * _e3758), 1f, _e3754) * _e3219)) + _e3786.member), ((_e3191.member_1.y * (select((_e3765.y * _e3758), 1f, _e3754) * _e3219)) + _e3786.member_1), ((_e3191.member_1.z * (select((_e3770.z * _e3758), 1f, _e3754) * _e3219)) + _e3786.member_2)));
} else {
phi_6120_ = vec3<f32>(0f, 0f, 0f);
phi_6121_ = _e2256;
}
let _e3797 = phi_6120_;
let _e3799 = phi_6121_;
let _e3800 = local_12;
local_7 = _e3800;
local_8 = _e201;
let _e3801 = local_8;
let _e3803 = local_7;
let _e3804 = ((22i * _e3801) + _e3803);
let _e3806 = select(_e208, _e3804, (_e3804 < _e208));
let _e3811 = global_2.member[bitcast<u32>(select(0i, _e3806, (_e3806 > 0i)))];
let _e3812 = local_8;
let _e3814 = local_7;
let _e3815 = ((23i * _e3812) + _e3814);
let _e3817 = select(_e208, _e3815, (_e3815 < _e208));
let _e3822 = global_2.member[bitcast<u32>(select(0i, _e3817, (_e3817 > 0i)))];
let _e3823 = local_8;
let _e3825 = local_7;
let _e3826 = ((24i * _e3823) + _e3825);
let _e3828 = select(_e208, _e3826, (_e3826 < _e208));
let _e3833 = global_2.member[bitcast<u32>(select(0i, _e3828, (_e3828 > 0i)))];
let _e3836 = global_1.member.member_17;
let _e3843 = local_12;
local_5 = _e3843;
local_6 = _e201;
let _e3844 = local_6;
let _e3846 = local_5;
let _e3847 = ((6i * _e3844) + _e3846);
let _e3849 = select(_e208, _e3847, (_e3847 < _e208));
let _e3854 = global_2.member[bitcast<u32>(select(0i, _e3849, (_e3849 > 0i)))];
let _e3855 = local_6;
let _e3857 = local_5;
let _e3858 = ((7i * _e3855) + _e3857);
let _e3860 = select(_e208, _e3858, (_e3858 < _e208));
let _e3865 = global_2.member[bitcast<u32>(select(0i, _e3860, (_e3860 > 0i)))];
let _e3866 = local_6;
let _e3868 = local_5;
let _e3869 = ((8i * _e3866) + _e3868);
let _e3871 = select(_e208, _e3869, (_e3869 < _e208));
let _e3876 = global_2.member[bitcast<u32>(select(0i, _e3871, (_e3871 > 0i)))];
let _e3886 = local_48;
local_3 = _e3886;
local_4 = _e201;
let _e3887 = local_4;
let _e3889 = local_3;
let _e3890 = ((9i * _e3887) + _e3889);
let _e3892 = select(_e208, _e3890, (_e3890 < _e208));
let _e3897 = global_2.member[bitcast<u32>(select(0i, _e3892, (_e3892 > 0i)))];
let _e3898 = local_4;
let _e3900 = local_3;
let _e3901 = ((10i * _e3898) + _e3900);
let _e3903 = select(_e208, _e3901, (_e3901 < _e208));
let _e3908 = global_2.member[bitcast<u32>(select(0i, _e3903, (_e3903 > 0i)))];
let _e3909 = local_4;
let _e3911 = local_3;
let _e3912 = ((11i * _e3909) + _e3911);
let _e3914 = select(_e208, _e3912, (_e3912 < _e208));
let _e3919 = global_2.member[bitcast<u32>(select(0i, _e3914, (_e3914 > 0i)))];
let _e3921 = (_e296 && (_e282 == 0f));
let _e3923 = select(_e3897, _e3797.x, _e3921);
let _e3925 = select(_e3908, _e3797.y, _e3921);
let _e3927 = select(_e3919, _e3797.z, _e3921);
let _e3928 = local_49;
let _e3930 = local_48;
let _e3931 = ((21i * _e3928) + _e3930);
let _e3933 = select(_e208, _e3931, (_e3931 < _e208));
let _e3938 = global_2.member[bitcast<u32>(select(0i, _e3933, (_e3933 > 0i)))];
local_1 = _e195;
local_2 = _e201;
let _e3939 = local_2;
let _e3941 = local_1;
let _e3942 = ((9i * _e3939) + _e3941);
let _e3944 = select(_e208, _e3942, (_e3942 < _e208));
let _e3949 = global_2.member[bitcast<u32>(select(0i, _e3944, (_e3944 > 0i)))];
let _e3950 = local_2;
let _e3952 = local_1;
let _e3953 = ((10i * _e3950) + _e3952);
let _e3955 = select(_e208, _e3953, (_e3953 < _e208));
let _e3960 = global_2.member[bitcast<u32>(select(0i, _e3955, (_e3955 > 0i)))];
let _e3961 = local_2;
let _e3963 = local_1;
let _e3964 = ((11i * _e3961) + _e3963);
let _e3966 = select(_e208, _e3964, (_e3964 < _e208));
let _e3971 = global_2.member[bitcast<u32>(select(0i, _e3966, (_e3966 > 0i)))];
let _e3977 = (2f * (((_e1050 * _e3949) + (_e1051 * _e3960)) + (_e1052 * _e3971)));
let _e3981 = (_e1050 - (_e3949 * _e3977));
let _e3982 = (_e1051 - (_e3960 * _e3977));
let _e3983 = (_e1052 - (_e3971 * _e3977));
let _e3984 = (_e677 - _e508);
let _e3985 = (_e678 - _e509);
let _e3986 = (_e679 - _e510);
let _e3991 = (((_e3984 * _e3984) + (_e3985 * _e3985)) + (_e3986 * _e3986));
let _e3996 = (_e677 - _e3981);
let _e3997 = (_e678 - _e3982);
let _e3998 = (_e679 - _e3983);
let _e4003 = (((_e3996 * _e3996) + (_e3997 * _e3997)) + (_e3998 * _e3998));
let _e4007 = (_e3981 - _e508);
let _e4008 = (_e3982 - _e509);
let _e4009 = (_e3983 - _e510);
let _e4014 = (((_e4007 * _e4007) + (_e4008 * _e4008)) + (_e4009 * _e4009));
let _e4022 = select(select(_e1063, select(sqrt(select(0f, _e4014, (_e4014 > 0f))), sqrt(select(0f, _e4003, (_e4003 > 0f))), _e601), (_e389 || _e601)), (0.5f * sqrt(select(0f, _e3991, (_e3991 > 0f)))), (_e389 && _e601));
let _e4023 = (_e1027 - _e857);
let _e4024 = (_e1028 - _e858);
let _e4025 = (_e1029 - _e859);
let _e4030 = (((_e4023 * _e4023) + (_e4024 * _e4024)) + (_e4025 * _e4025));
let _e4035 = (_e1027 - _e3981);
let _e4036 = (_e1028 - _e3982);
let _e4037 = (_e1029 - _e3983);
let _e4042 = (((_e4035 * _e4035) + (_e4036 * _e4036)) + (_e4037 * _e4037));
let _e4046 = (_e3981 - _e857);
let _e4047 = (_e3982 - _e858);
let _e4048 = (_e3983 - _e859);
let _e4053 = (((_e4046 * _e4046) + (_e4047 * _e4047)) + (_e4048 * _e4048));
let _e4061 = select(select(_e1063, select(sqrt(select(0f, _e4053, (_e4053 > 0f))), sqrt(select(0f, _e4042, (_e4042 > 0f))), _e950), (_e771 || _e950)), (0.5f * sqrt(select(0f, _e4030, (_e4030 > 0f)))), (_e771 && _e950));
let _e4063 = select(_e4061, _e4022, (_e4022 > _e4061));
let _e4068 = (((_e1195.member * _e3981) + (_e1195.member_1 * _e3982)) + (_e1195.member_2 * _e3983));
let _e4073 = (((_e1207.member * _e3981) + (_e1207.member_1 * _e3982)) + (_e1207.member_2 * _e3983));
let _e4078 = (((_e1219.member * _e3981) + (_e1219.member_1 * _e3982)) + (_e1219.member_2 * _e3983));
if _e1247 {
phi_8171_ = _e1239;
} else {
if (_e1231 == 1u) {
let _e4081 = select(-1f, _e4078, (_e4078 > -1f));
let _e4083 = select(1f, _e4081, (_e4081 < 1f));
if (_e4083 > 0f) {
phi_6786_ = _e1239;
} else {
let _e4088 = global_1.member.member_16.member_9;
phi_6786_ = vec3<f32>(_e4088.member, _e4088.member_1, _e4088.member_2);
}
let _e4094 = phi_6786_;
let _e4103 = bitcast<f32>((bitcast<u32>(_e4083) & 2147483647u));
let _e4106 = sqrt(select(0f, _e4103, (_e4103 > 0f)));
phi_8170_ = vec3<f32>((_e1243.member + ((_e4094.x - _e1243.member) * _e4106)), (_e1243.member_1 + ((_e4094.y - _e1243.member_1) * _e4106)), (_e1243.member_2 + ((_e4094.z - _e1243.member_2) * _e4106)));
} else {
if (_e1231 == 2u) {
let _e4118 = global_1.member.member_16.member_10;
let _e4119 = (_e4063 / _e4118);
let _e4121 = select(1e-4f, _e4119, (_e4119 > 1e-4f));
let _e4124 = bitcast<f32>((bitcast<u32>(_e4068) & 2147483647u));
let _e4127 = bitcast<f32>((bitcast<u32>(_e4073) & 2147483647u));
let _e4131 = select(_e4127, _e4124, (_e4124 > _e4127));
let _e4134 = (select(_e4127, _e4124, (_e4124 < _e4127)) / select(1.1754944e-38f, _e4131, (_e4131 > 1.1754944e-38f)));
let _e4135 = (_e4134 > 0.41421357f);
let _e4139 = select(_e4134, ((_e4134 - 1f) / (_e4134 + 1f)), _e4135);
let _e4140 = (_e4139 * _e4139);
let _e4155 = (select(0f, 0.7853982f, _e4135) + (_e4139 + ((_e4139 * _e4140) * (-0.33333334f + (_e4140 * (0.2f + (_e4140 * (-0.14285713f + (_e4140 * (0.11111111f + (_e4140 * (-0.09090909f + (_e4140 * 0.0585f)))))))))))));
let _e4158 = select(_e4155, (1.5707964f - _e4155), (_e4127 > _e4124));
let _e4161 = select(_e4158, (3.1415927f - _e4158), (_e4068 < 0f));
let _e4167 = (1f - (_e4078 * _e4078));
let _e4170 = sqrt(select(0f, _e4167, (_e4167 > 0f)));
let _e4173 = (_e4121 / select(1e-3f, _e4170, (_e4170 > 1e-3f)));
let _e4174 = ((select(_e4161, -(_e4161), (_e4073 < 0f)) / _e4118) * 0.5f);
let _e4176 = select(-8e6f, _e4174, (_e4174 > -8e6f));
let _e4178 = select(8e6f, _e4176, (_e4176 < 8e6f));
let _e4185 = select(0i, select(select(i32(_e4178), i32(-2147483648), (_e4178 < -2147483600f)), 2147483647i, (_e4178 > 2147483500f)), (_e4178 == _e4178));
let _e4192 = ((_e4174 - f32((_e4185 - select(0i, 1i, (_e4178 < f32(_e4185)))))) * 2f);
let _e4200 = ((select(select((_e4192 - 2f), (1f - _e4192), (_e4192 < 1.5f)), _e4192, (_e4192 < 0.5f)) * 2f) / _e4173);
let _e4202 = select(-1f, _e4200, (_e4200 > -1f));
let _e4205 = (2f - _e4173);
let _e4207 = select(0f, _e4205, (_e4205 > 0f));
let _e4212 = select(-1f, _e4078, (_e4078 > -1f));
let _e4214 = select(1f, _e4212, (_e4212 < 1f));
let _e4217 = ((1f - _e4214) * (1f + _e4214));
let _e4220 = sqrt(select(0f, _e4217, (_e4217 > 0f)));
let _e4223 = bitcast<f32>((bitcast<u32>(_e4220) & 2147483647u));
let _e4226 = bitcast<f32>((bitcast<u32>(_e4214) & 2147483647u));
let _e4230 = select(_e4226, _e4223, (_e4223 > _e4226));
let _e4233 = (select(_e4226, _e4223, (_e4223 < _e4226)) / select(1.1754944e-38f, _e4230, (_e4230 > 1.1754944e-38f)));
let _e4234 = (_e4233 > 0.41421357f);
let _e4238 = select(_e4233, ((_e4233 - 1f) / (_e4233 + 1f)), _e4234);
let _e4239 = (_e4238 * _e4238);
let _e4254 = (select(0f, 0.7853982f, _e4234) + (_e4238 + ((_e4238 * _e4239) * (-0.33333334f + (_e4239 * (0.2f + (_e4239 * (-0.14285713f + (_e4239 * (0.11111111f + (_e4239 * (-0.09090909f + (_e4239 * 0.0585f)))))))))))));
let _e4257 = select(_e4254, (1.5707964f - _e4254), (_e4226 > _e4223));
let _e4260 = select(_e4257, (3.1415927f - _e4257), (_e4220 < 0f));
let _e4265 = ((select(_e4260, -(_e4260), (_e4214 < 0f)) / _e4118) * 0.5f);
let _e4267 = select(-8e6f, _e4265, (_e4265 > -8e6f));
let _e4269 = select(8e6f, _e4267, (_e4267 < 8e6f));
let _e4276 = select(0i, select(select(i32(_e4269), i32(-2147483648), (_e4269 < -2147483600f)), 2147483647i, (_e4269 > 2147483500f)), (_e4269 == _e4269));
let _e4283 = ((_e4265 - f32((_e4276 - select(0i, 1i, (_e4269 < f32(_e4276)))))) * 2f);
let _e4291 = ((select(select((_e4283 - 2f), (1f - _e4283), (_e4283 < 1.5f)), _e4283, (_e4283 < 0.5f)) * 2f) / _e4121);
let _e4293 = select(-1f, _e4291, (_e4291 > -1f));
let _e4296 = (2f - _e4121);
let _e4298 = select(0f, _e4296, (_e4296 > 0f));
let _e4304 = (0.5f + ((0.5f * (select(1f, _e4202, (_e4202 < 1f)) * select(1f, _e4207, (_e4207 < 1f)))) * (select(1f, _e4293, (_e4293 < 1f)) * select(1f, _e4298, (_e4298 < 1f)))));
phi_8169_ = vec3<f32>((_e1235.member + ((_e1243.member - _e1235.member) * _e4304)), (_e1235.member_1 + ((_e1243.member_1 - _e1235.member_1) * _e4304)), (_e1235.member_2 + ((_e1243.member_2 - _e1235.member_2) * _e4304)));
} else {
let _e4318 = global_1.member.member_16.member_1;
let _e4319 = bitcast<i32>(_e4318);
let _e4324 = global_1.member.member_16.member_3;
let _e4326 = f32(bitcast<i32>(_e4324));
let _e4328 = (2f * 3.1415927f);
let _e4329 = ((_e4063 * f32(_e4319)) / _e4328);
let _e4331 = select(1e-6f, _e4329, (_e4329 > 1e-6f));
let _e4334 = bitcast<u32>(select(1.1754944e-38f, _e4331, (_e4331 > 1.1754944e-38f)));
let _e4335 = (_e4334 & 8388607u);
let _e4337 = select(0u, 1u, (_e4335 > 3474675u));
let _e4348 = bitcast<f32>((_e4335 | ((127u - _e4337) << bitcast<u32>(23i))));
let _e4351 = ((_e4348 - 1f) / (_e4348 + 1f));
let _e4352 = (_e4351 * _e4351);
let _e4367 = (f32(((bitcast<i32>((_e4334 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e4337))) + (((2f * _e4351) + ((_e4351 * _e4352) * (0.6666667f + (_e4352 * (0.4f + (_e4352 * (0.2857143f + (_e4352 * (0.22222222f + (_e4352 * 0.18181819f)))))))))) * 1.442695f));
let _e4368 = (_e4326 - 1f);
let _e4370 = select(0f, _e4367, (_e4367 > 0f));
let _e4372 = select(_e4368, _e4370, (_e4370 < _e4368));
let _e4373 = (_e4326 - 2f);
let _e4375 = select(0f, _e4373, (_e4373 > 0f));
let _e4377 = select(0f, _e4372, (_e4372 > 0f));
let _e4379 = select(_e4375, _e4377, (_e4377 < _e4375));
let _e4386 = select(0i, select(select(i32(_e4379), i32(-2147483648), (_e4379 < -2147483600f)), 2147483647i, (_e4379 > 2147483500f)), (_e4379 == _e4379));
let _e4390 = (_e4386 - select(0i, 1i, (_e4379 < f32(_e4386))));
let _e4393 = bitcast<f32>((bitcast<u32>(_e4073) & 2147483647u));
let _e4396 = bitcast<f32>((bitcast<u32>(_e4068) & 2147483647u));
let _e4400 = select(_e4396, _e4393, (_e4393 > _e4396));
let _e4403 = (select(_e4396, _e4393, (_e4393 < _e4396)) / select(1.1754944e-38f, _e4400, (_e4400 > 1.1754944e-38f)));
let _e4404 = (_e4403 > 0.41421357f);
let _e4408 = select(_e4403, ((_e4403 - 1f) / (_e4403 + 1f)), _e4404);
let _e4409 = (_e4408 * _e4408);
let _e4424 = (select(0f, 0.7853982f, _e4404) + (_e4408 + ((_e4408 * _e4409) * (-0.33333334f + (_e4409 * (0.2f + (_e4409 * (-0.14285713f + (_e4409 * (0.11111111f + (_e4409 * (-0.09090909f + (_e4409 * 0.0585f)))))))))))));
let _e4427 = select(_e4424, (1.5707964f - _e4424), (_e4396 > _e4393));
let _e4430 = select(_e4427, (3.1415927f - _e4427), (_e4073 < 0f));
let _e4435 = (0.5f - (select(_e4430, -(_e4430), (_e4068 < 0f)) / _e4328));
let _e4437 = select(-1f, _e4078, (_e4078 > -1f));
let _e4439 = select(1f, _e4437, (_e4437 < 1f));
let _e4442 = ((1f - _e4439) * (1f + _e4439));
let _e4445 = sqrt(select(0f, _e4442, (_e4442 > 0f)));
let _e4448 = bitcast<f32>((bitcast<u32>(_e4445) & 2147483647u));
let _e4451 = bitcast<f32>((bitcast<u32>(_e4439) & 2147483647u));
let _e4455 = select(_e4451, _e4448, (_e4448 > _e4451));
let _e4458 = (select(_e4451, _e4448, (_e4448 < _e4451)) / select(1.1754944e-38f, _e4455, (_e4455 > 1.1754944e-38f)));
let _e4459 = (_e4458 > 0.41421357f);
let _e4463 = select(_e4458, ((_e4458 - 1f) / (_e4458 + 1f)), _e4459);
let _e4464 = (_e4463 * _e4463);
let _e4479 = (select(0f, 0.7853982f, _e4459) + (_e4463 + ((_e4463 * _e4464) * (-0.33333334f + (_e4464 * (0.2f + (_e4464 * (-0.14285713f + (_e4464 * (0.11111111f + (_e4464 * (-0.09090909f + (_e4464 * 0.0585f)))))))))))));
let _e4482 = select(_e4479, (1.5707964f - _e4479), (_e4451 > _e4448));
let _e4485 = select(_e4482, (3.1415927f - _e4482), (_e4445 < 0f));
let _e4490 = (0.5f - (select(_e4485, -(_e4485), (_e4439 < 0f)) / 3.1415927f));
let _e4494 = global_1.member.member_16.member_2;
let _e4495 = bitcast<i32>(_e4494);
phi_7388_ = 0i;
phi_7391_ = 0i;
phi_7393_ = _e4495;
phi_7395_ = _e4319;
loop {
let _e4497 = phi_7388_;
let _e4499 = phi_7391_;
let _e4501 = phi_7393_;
let _e4503 = phi_7395_;
local_87 = _e4503;
local_88 = _e4501;
local_89 = _e4503;
local_90 = _e4503;
local_91 = _e4503;
local_92 = _e4503;
local_93 = _e4503;
local_94 = _e4503;
local_95 = _e4501;
local_96 = _e4501;
local_97 = _e4501;
local_98 = _e4501;
local_99 = _e4503;
local_100 = _e4499;
local_101 = _e4503;
local_102 = _e4499;
let _e4504 = (_e4497 < _e4390);
if _e4504 {
if (_e4503 > 1i) {
phi_7410_ = (_e4503 >> bitcast<u32>(1i));
} else {
phi_7410_ = 1i;
}
let _e4511 = phi_7410_;
if (_e4501 > 1i) {
phi_7416_ = (_e4501 >> bitcast<u32>(1i));
} else {
phi_7416_ = 1i;
}
let _e4516 = phi_7416_;
phi_7389_ = (_e4497 + 1i);
phi_7392_ = (_e4499 + (_e4503 * _e4501));
phi_7394_ = _e4516;
phi_7396_ = _e4511;
} else {
phi_7389_ = i32();
phi_7392_ = i32();
phi_7394_ = i32();
phi_7396_ = i32();
}
let _e4519 = phi_7389_;
let _e4521 = phi_7392_;
let _e4523 = phi_7394_;
let _e4525 = phi_7396_;
continue;
continuing {
phi_7388_ = _e4519;
phi_7391_ = _e4521;
phi_7393_ = _e4523;
phi_7395_ = _e4525;
break if !(_e4504);
}
}
let _e4528 = local_87;
let _e4529 = f32(_e4528);
let _e4531 = ((_e4435 * _e4529) - 0.5f);
let _e4533 = local_88;
let _e4534 = f32(_e4533);
let _e4536 = ((_e4490 * _e4534) - 0.5f);
let _e4538 = select(-1f, _e4531, (_e4531 > -1f));
let _e4540 = select(_e4529, _e4538, (_e4538 < _e4529));
let _e4547 = select(0i, select(select(i32(_e4540), i32(-2147483648), (_e4540 < -2147483600f)), 2147483647i, (_e4540 > 2147483500f)), (_e4540 == _e4540));
let _e4551 = (_e4547 - select(0i, 1i, (_e4540 < f32(_e4547))));
let _e4553 = select(-1f, _e4536, (_e4536 > -1f));
let _e4555 = select(_e4534, _e4553, (_e4553 < _e4534));
let _e4562 = select(0i, select(select(i32(_e4555), i32(-2147483648), (_e4555 < -2147483600f)), 2147483647i, (_e4555 > 2147483500f)), (_e4555 == _e4555));
let _e4566 = (_e4562 - select(0i, 1i, (_e4555 < f32(_e4562))));
let _e4568 = (_e4531 - f32(_e4551));
let _e4570 = (_e4536 - f32(_e4566));
let _e4572 = select(0f, _e4570, (_e4570 > 0f));
let _e4574 = select(1f, _e4572, (_e4572 < 1f));
if (_e4551 < 0i) {
let _e4577 = local_89;
phi_7491_ = (_e4551 + _e4577);
} else {
phi_7491_ = _e4551;
}
let _e4580 = phi_7491_;
let _e4582 = local_90;
if (_e4580 >= _e4582) {
let _e4585 = local_91;
phi_7497_ = (_e4580 - _e4585);
} else {
phi_7497_ = _e4580;
}
let _e4588 = phi_7497_;
let _e4589 = (_e4551 + 1i);
if (_e4589 < 0i) {
let _e4592 = local_92;
phi_7504_ = (_e4589 + _e4592);
} else {
phi_7504_ = _e4589;
}
let _e4595 = phi_7504_;
let _e4597 = local_93;
if (_e4595 >= _e4597) {
let _e4600 = local_94;
phi_7510_ = (_e4595 - _e4600);
} else {
phi_7510_ = _e4595;
}
let _e4603 = phi_7510_;
let _e4605 = select(_e4566, 0i, (_e4566 < 0i));
let _e4607 = local_95;
if (_e4605 >= _e4607) {
let _e4610 = local_96;
phi_7521_ = (_e4610 - 1i);
} else {
phi_7521_ = _e4605;
}
let _e4613 = phi_7521_;
let _e4614 = (_e4566 + 1i);
let _e4616 = select(_e4614, 0i, (_e4614 < 0i));
let _e4618 = local_97;
if (_e4616 >= _e4618) {
let _e4621 = local_98;
phi_7533_ = (_e4621 - 1i);
} else {
phi_7533_ = _e4616;
}
let _e4624 = phi_7533_;
let _e4626 = local_99;
let _e4629 = local_100;
let _e4630 = (_e4629 + (_e4613 * _e4626));
let _e4632 = local_101;
let _e4635 = local_102;
let _e4636 = (_e4635 + (_e4624 * _e4632));
let _e4638 = (3i * (_e4630 + _e4588));
let _e4640 = (bitcast<i32>(_e164) - 1i);
let _e4642 = select(_e4640, _e4638, (_e4638 < _e4640));
let _e4648 = global_3.member[bitcast<u32>(select(0i, _e4642, (_e4642 > 0i)))];
let _e4649 = (_e4638 + 1i);
let _e4651 = select(_e4640, _e4649, (_e4649 < _e4640));
let _e4657 = global_3.member[bitcast<u32>(select(0i, _e4651, (_e4651 > 0i)))];
let _e4658 = (_e4638 + 2i);
let _e4660 = select(_e4640, _e4658, (_e4658 < _e4640));
let _e4666 = global_3.member[bitcast<u32>(select(0i, _e4660, (_e4660 > 0i)))];
let _e4668 = (3i * (_e4630 + _e4603));
let _e4670 = select(_e4640, _e4668, (_e4668 < _e4640));
let _e4676 = global_3.member[bitcast<u32>(select(0i, _e4670, (_e4670 > 0i)))];
let _e4677 = (_e4668 + 1i);
let _e4679 = select(_e4640, _e4677, (_e4677 < _e4640));
let _e4685 = global_3.member[bitcast<u32>(select(0i, _e4679, (_e4679 > 0i)))];
let _e4686 = (_e4668 + 2i);
let _e4688 = select(_e4640, _e4686, (_e4686 < _e4640));
let _e4694 = global_3.member[bitcast<u32>(select(0i, _e4688, (_e4688 > 0i)))];
let _e4696 = (3i * (_e4636 + _e4588));
let _e4698 = select(_e4640, _e4696, (_e4696 < _e4640));
let _e4704 = global_3.member[bitcast<u32>(select(0i, _e4698, (_e4698 > 0i)))];
let _e4705 = (_e4696 + 1i);
let _e4707 = select(_e4640, _e4705, (_e4705 < _e4640));
let _e4713 = global_3.member[bitcast<u32>(select(0i, _e4707, (_e4707 > 0i)))];
let _e4714 = (_e4696 + 2i);
let _e4716 = select(_e4640, _e4714, (_e4714 < _e4640));
let _e4722 = global_3.member[bitcast<u32>(select(0i, _e4716, (_e4716 > 0i)))];
let _e4724 = (3i * (_e4636 + _e4603));
let _e4726 = select(_e4640, _e4724, (_e4724 < _e4640));
let _e4732 = global_3.member[bitcast<u32>(select(0i, _e4726, (_e4726 > 0i)))];
let _e4733 = (_e4724 + 1i);
let _e4735 = select(_e4640, _e4733, (_e4733 < _e4640));
let _e4741 = global_3.member[bitcast<u32>(select(0i, _e4735, (_e4735 > 0i)))];
let _e4742 = (_e4724 + 2i);
let _e4744 = select(_e4640, _e4742, (_e4742 < _e4640));
let _e4750 = global_3.member[bitcast<u32>(select(0i, _e4744, (_e4744 > 0i)))];
let _e4757 = (_e4648 + ((_e4676 - _e4648) * _e4568));
let _e4758 = (_e4657 + ((_e4685 - _e4657) * _e4568));
let _e4759 = (_e4666 + ((_e4694 - _e4666) * _e4568));
let _e4775 = (_e4757 + (((_e4704 + ((_e4732 - _e4704) * _e4568)) - _e4757) * _e4574));
let _e4776 = (_e4758 + (((_e4713 + ((_e4741 - _e4713) * _e4568)) - _e4758) * _e4574));
let _e4777 = (_e4759 + (((_e4722 + ((_e4750 - _e4722) * _e4568)) - _e4759) * _e4574));
phi_7769_ = 0i;
phi_7772_ = 0i;
phi_7774_ = _e4495;
phi_7776_ = _e4319;
loop {
let _e4780 = phi_7769_;
let _e4782 = phi_7772_;
let _e4784 = phi_7774_;
let _e4786 = phi_7776_;
local_103 = _e4786;
local_104 = _e4784;
local_105 = _e4786;
local_106 = _e4786;
local_107 = _e4786;
local_108 = _e4786;
local_109 = _e4786;
local_110 = _e4786;
local_111 = _e4784;
local_112 = _e4784;
local_113 = _e4784;
local_114 = _e4784;
local_115 = _e4786;
local_116 = _e4782;
local_117 = _e4786;
local_118 = _e4782;
let _e4787 = (_e4780 < (_e4390 + 1i));
if _e4787 {
if (_e4786 > 1i) {
phi_7791_ = (_e4786 >> bitcast<u32>(1i));
} else {
phi_7791_ = 1i;
}
let _e4794 = phi_7791_;
if (_e4784 > 1i) {
phi_7797_ = (_e4784 >> bitcast<u32>(1i));
} else {
phi_7797_ = 1i;
}
let _e4799 = phi_7797_;
phi_7770_ = (_e4780 + 1i);
phi_7773_ = (_e4782 + (_e4786 * _e4784));
phi_7775_ = _e4799;
phi_7777_ = _e4794;
} else {
phi_7770_ = i32();
phi_7773_ = i32();
phi_7775_ = i32();
phi_7777_ = i32();
}
let _e4802 = phi_7770_;
let _e4804 = phi_7773_;
let _e4806 = phi_7775_;
let _e4808 = phi_7777_;
continue;
continuing {
phi_7769_ = _e4802;
phi_7772_ = _e4804;
phi_7774_ = _e4806;
phi_7776_ = _e4808;
break if !(_e4787);
}
}
let _e4811 = local_103;
let _e4812 = f32(_e4811);
let _e4814 = ((_e4435 * _e4812) - 0.5f);
let _e4816 = local_104;
let _e4817 = f32(_e4816);
let _e4819 = ((_e4490 * _e4817) - 0.5f);
let _e4821 = select(-1f, _e4814, (_e4814 > -1f));
let _e4823 = select(_e4812, _e4821, (_e4821 < _e4812));
let _e4830 = select(0i, select(select(i32(_e4823), i32(-2147483648), (_e4823 < -2147483600f)), 2147483647i, (_e4823 > 2147483500f)), (_e4823 == _e4823));
let _e4834 = (_e4830 - select(0i, 1i, (_e4823 < f32(_e4830))));
let _e4836 = select(-1f, _e4819, (_e4819 > -1f));
let _e4838 = select(_e4817, _e4836, (_e4836 < _e4817));
let _e4845 = select(0i, select(select(i32(_e4838), i32(-2147483648), (_e4838 < -2147483600f)), 2147483647i, (_e4838 > 2147483500f)), (_e4838 == _e4838));
let _e4849 = (_e4845 - select(0i, 1i, (_e4838 < f32(_e4845))));
let _e4851 = (_e4814 - f32(_e4834));
let _e4853 = (_e4819 - f32(_e4849));
let _e4855 = select(0f, _e4853, (_e4853 > 0f));
let _e4857 = select(1f, _e4855, (_e4855 < 1f));
if (_e4834 < 0i) {
let _e4860 = local_105;
phi_7872_ = (_e4834 + _e4860);
} else {
phi_7872_ = _e4834;
}
let _e4863 = phi_7872_;
let _e4865 = local_106;
if (_e4863 >= _e4865) {
let _e4868 = local_107;
phi_7878_ = (_e4863 - _e4868);
} else {
phi_7878_ = _e4863;
}
let _e4871 = phi_7878_;
let _e4872 = (_e4834 + 1i);
if (_e4872 < 0i) {
let _e4875 = local_108;
phi_7885_ = (_e4872 + _e4875);
} else {
phi_7885_ = _e4872;
}
let _e4878 = phi_7885_;
let _e4880 = local_109;
if (_e4878 >= _e4880) {
let _e4883 = local_110;
phi_7891_ = (_e4878 - _e4883);
} else {
phi_7891_ = _e4878;
}
let _e4886 = phi_7891_;
let _e4888 = select(_e4849, 0i, (_e4849 < 0i));
let _e4890 = local_111;
if (_e4888 >= _e4890) {
let _e4893 = local_112;
phi_7902_ = (_e4893 - 1i);
} else {
phi_7902_ = _e4888;
}
let _e4896 = phi_7902_;
let _e4897 = (_e4849 + 1i);
let _e4899 = select(_e4897, 0i, (_e4897 < 0i));
let _e4901 = local_113;
if (_e4899 >= _e4901) {
let _e4904 = local_114;
phi_7914_ = (_e4904 - 1i);
} else {
phi_7914_ = _e4899;
}
let _e4907 = phi_7914_;
let _e4909 = local_115;
let _e4912 = local_116;
let _e4913 = (_e4912 + (_e4896 * _e4909));
let _e4915 = local_117;
let _e4918 = local_118;
let _e4919 = (_e4918 + (_e4907 * _e4915));
let _e4921 = (3i * (_e4913 + _e4871));
let _e4923 = select(_e4640, _e4921, (_e4921 < _e4640));
let _e4929 = global_3.member[bitcast<u32>(select(0i, _e4923, (_e4923 > 0i)))];
let _e4930 = (_e4921 + 1i);
let _e4932 = select(_e4640, _e4930, (_e4930 < _e4640));
let _e4938 = global_3.member[bitcast<u32>(select(0i, _e4932, (_e4932 > 0i)))];
let _e4939 = (_e4921 + 2i);
let _e4941 = select(_e4640, _e4939, (_e4939 < _e4640));
let _e4947 = global_3.member[bitcast<u32>(select(0i, _e4941, (_e4941 > 0i)))];
let _e4949 = (3i * (_e4913 + _e4886));
let _e4951 = select(_e4640, _e4949, (_e4949 < _e4640));
let _e4957 = global_3.member[bitcast<u32>(select(0i, _e4951, (_e4951 > 0i)))];
let _e4958 = (_e4949 + 1i);
let _e4960 = select(_e4640, _e4958, (_e4958 < _e4640));
let _e4966 = global_3.member[bitcast<u32>(select(0i, _e4960, (_e4960 > 0i)))];
let _e4967 = (_e4949 + 2i);
let _e4969 = select(_e4640, _e4967, (_e4967 < _e4640));
let _e4975 = global_3.member[bitcast<u32>(select(0i, _e4969, (_e4969 > 0i)))];
let _e4977 = (3i * (_e4919 + _e4871));
let _e4979 = select(_e4640, _e4977, (_e4977 < _e4640));
let _e4985 = global_3.member[bitcast<u32>(select(0i, _e4979, (_e4979 > 0i)))];
let _e4986 = (_e4977 + 1i);
let _e4988 = select(_e4640, _e4986, (_e4986 < _e4640));
let _e4994 = global_3.member[bitcast<u32>(select(0i, _e4988, (_e4988 > 0i)))];
let _e4995 = (_e4977 + 2i);
let _e4997 = select(_e4640, _e4995, (_e4995 < _e4640));
let _e5003 = global_3.member[bitcast<u32>(select(0i, _e4997, (_e4997 > 0i)))];
let _e5005 = (3i * (_e4919 + _e4886));
let _e5007 = select(_e4640, _e5005, (_e5005 < _e4640));
let _e5013 = global_3.member[bitcast<u32>(select(0i, _e5007, (_e5007 > 0i)))];
let _e5014 = (_e5005 + 1i);
let _e5016 = select(_e4640, _e5014, (_e5014 < _e4640));
let _e5022 = global_3.member[bitcast<u32>(select(0i, _e5016, (_e5016 > 0i)))];
let _e5023 = (_e5005 + 2i);
let _e5025 = select(_e4640, _e5023, (_e5023 < _e4640));
let _e5031 = global_3.member[bitcast<u32>(select(0i, _e5025, (_e5025 > 0i)))];
let _e5038 = (_e4929 + ((_e4957 - _e4929) * _e4851));
let _e5039 = (_e4938 + ((_e4966 - _e4938) * _e4851));
let _e5040 = (_e4947 + ((_e4975 - _e4947) * _e4851));
let _e5063 = (_e4372 - f32(_e4390));
let _e5065 = select(0f, _e5063, (_e5063 > 0f));
let _e5067 = select(1f, _e5065, (_e5065 < 1f));
let _e5077 = global_1.member.member_16.member_11;
phi_8169_ = vec3<f32>(((_e4775 + (((_e5038 + (((_e4985 + ((_e5013 - _e4985) * _e4851)) - _e5038) * _e4857)) - _e4775) * _e5067)) * _e5077), ((_e4776 + (((_e5039 + (((_e4994 + ((_e5022 - _e4994) * _e4851)) - _e5039) * _e4857)) - _e4776) * _e5067)) * _e5077), ((_e4777 + (((_e5040 + (((_e5003 + ((_e5031 - _e5003) * _e4851)) - _e5040) * _e4857)) - _e4777) * _e5067)) * _e5077));
}
let _e5083 = phi_8169_;
phi_8170_ = _e5083;
}
let _e5085 = phi_8170_;
phi_8171_ = _e5085;
}
let _e5087 = phi_8171_;
if (_e294 && (_e3938 > 0f)) {
let _e5090 = local_49;
let _e5092 = local_48;
let _e5093 = ((2i * _e5090) + _e5092);
let _e5095 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e5097 = select(_e5095, _e5093, (_e5093 < _e5095));
let _e5102 = global_7.member[bitcast<u32>(select(0i, _e5097, (_e5097 > 0i)))];
let _e5109 = select(0i, select(select(i32(_e5102), i32(-2147483648), (_e5102 < -2147483600f)), 2147483647i, (_e5102 > 2147483500f)), (_e5102 == _e5102));
if (_e5109 != -1i) {
let _e5111 = local_49;
let _e5113 = local_48;
let _e5114 = ((20i * _e5111) + _e5113);
let _e5116 = select(_e208, _e5114, (_e5114 < _e208));
let _e5121 = global_2.member[bitcast<u32>(select(0i, _e5116, (_e5116 > 0i)))];
let _e5122 = (1f - _e438);
let _e5128 = global_1.member.member_10;
let _e5141 = local_49;
let _e5143 = local_48;
let _e5144 = ((3i * _e5141) + _e5143);
let _e5146 = select(_e5095, _e5144, (_e5144 < _e5095));
let _e5151 = global_7.member[bitcast<u32>(select(0i, _e5146, (_e5146 > 0i)))];
let _e5155 = (((_e5128.member + (_e1030 * _e5122)) + (_e1050 * _e5121)) + (_e3981 * _e5151));
let _e5156 = (((_e5128.member_1 + (_e1031 * _e5122)) + (_e1051 * _e5121)) + (_e3982 * _e5151));
let _e5157 = (((_e5128.member_2 + (_e1032 * _e5122)) + (_e1052 * _e5121)) + (_e3983 * _e5151));
let _e5158 = vec3<f32>(_e5155, _e5156, _e5157);
if (_e5109 < 0i) {
let _e5160 = (_e5109 == -3i);
let _e5166 = global_1.member.member_18.member_1.member.member;
let _e5171 = global_1.member.member_18.member_1.member_1;
let _e5177 = global_1.member.member_18.member.member.member;
let _e5182 = global_1.member.member_18.member.member_1;
let _e5192 = vec3<f32>(select(_e5177.member, _e5166.member, _e5160), select(_e5177.member_1, _e5166.member_1, _e5160), select(_e5177.member_2, _e5166.member_2, _e5160));
phi_9146_ = type_22(_e5158, _e5192, _e5192, vec3<f32>(select(_e5182.member, _e5171.member, _e5160), select(_e5182.member_1, _e5171.member_1, _e5160), select(_e5182.member_2, _e5171.member_2, _e5160)), 0f, false);
} else {
let _e5204 = (_e5109 * 19i);
let _e5206 = (bitcast<i32>(_e166) - 1i);
let _e5208 = select(_e5206, _e5204, (_e5204 < _e5206));
let _e5214 = global_4.member[bitcast<u32>(select(0i, _e5208, (_e5208 > 0i)))];
let _e5215 = (_e5204 + 1i);
let _e5217 = select(_e5206, _e5215, (_e5215 < _e5206));
let _e5223 = global_4.member[bitcast<u32>(select(0i, _e5217, (_e5217 > 0i)))];
let _e5224 = (_e5204 + 2i);
let _e5226 = select(_e5206, _e5224, (_e5224 < _e5206));
let _e5232 = global_4.member[bitcast<u32>(select(0i, _e5226, (_e5226 > 0i)))];
let _e5233 = (_e5204 + 3i);
let _e5235 = select(_e5206, _e5233, (_e5233 < _e5206));
let _e5241 = global_4.member[bitcast<u32>(select(0i, _e5235, (_e5235 > 0i)))];
let _e5242 = (_e5204 + 4i);
let _e5244 = select(_e5206, _e5242, (_e5242 < _e5206));
let _e5250 = global_4.member[bitcast<u32>(select(0i, _e5244, (_e5244 > 0i)))];
let _e5251 = (_e5204 + 5i);
let _e5253 = select(_e5206, _e5251, (_e5251 < _e5206));
let _e5259 = global_4.member[bitcast<u32>(select(0i, _e5253, (_e5253 > 0i)))];
let _e5260 = (_e5204 + 6i);
let _e5262 = select(_e5206, _e5260, (_e5260 < _e5206));
let _e5268 = global_4.member[bitcast<u32>(select(0i, _e5262, (_e5262 > 0i)))];
let _e5269 = (_e5204 + 7i);
let _e5271 = select(_e5206, _e5269, (_e5269 < _e5206));
let _e5277 = global_4.member[bitcast<u32>(select(0i, _e5271, (_e5271 > 0i)))];
let _e5278 = (_e5204 + 8i);
let _e5280 = select(_e5206, _e5278, (_e5278 < _e5206));
let _e5286 = global_4.member[bitcast<u32>(select(0i, _e5280, (_e5280 > 0i)))];
let _e5287 = (_e5241 - _e5214);
let _e5288 = (_e5250 - _e5223);
let _e5289 = (_e5259 - _e5232);
let _e5290 = (_e5268 - _e5214);
let _e5291 = (_e5277 - _e5223);
let _e5292 = (_e5286 - _e5232);
let _e5295 = ((_e5288 * _e5292) - (_e5289 * _e5291));
let _e5298 = ((_e5289 * _e5290) - (_e5287 * _e5292));
let _e5301 = ((_e5287 * _e5291) - (_e5288 * _e5290));
let _e5302 = (_e5241 - _e5155);
let _e5303 = (_e5250 - _e5156);
let _e5304 = (_e5259 - _e5157);
let _e5305 = (_e5268 - _e5155);
let _e5306 = (_e5277 - _e5156);
let _e5307 = (_e5286 - _e5157);
let _e5321 = (((((_e5303 * _e5307) - (_e5304 * _e5306)) * _e5295) + (((_e5304 * _e5305) - (_e5302 * _e5307)) * _e5298)) + (((_e5302 * _e5306) - (_e5303 * _e5305)) * _e5301));
let _e5323 = select(0f, _e5321, (_e5321 > 0f));
let _e5324 = (_e5214 - _e5155);
let _e5325 = (_e5223 - _e5156);
let _e5326 = (_e5232 - _e5157);
let _e5340 = (((((_e5306 * _e5326) - (_e5307 * _e5325)) * _e5295) + (((_e5307 * _e5324) - (_e5305 * _e5326)) * _e5298)) + (((_e5305 * _e5325) - (_e5306 * _e5324)) * _e5301));
let _e5342 = select(0f, _e5340, (_e5340 > 0f));
let _e5356 = (((((_e5325 * _e5304) - (_e5326 * _e5303)) * _e5295) + (((_e5326 * _e5302) - (_e5324 * _e5304)) * _e5298)) + (((_e5324 * _e5303) - (_e5325 * _e5302)) * _e5301));
let _e5358 = select(0f, _e5356, (_e5356 > 0f));
let _e5360 = ((_e5323 + _e5342) + _e5358);
let _e5362 = select(1e-30f, _e5360, (_e5360 > 1e-30f));
let _e5363 = (_e5323 / _e5362);
let _e5364 = (_e5342 / _e5362);
let _e5365 = (_e5358 / _e5362);
let _e5370 = (((_e5295 * _e5295) + (_e5298 * _e5298)) + (_e5301 * _e5301));
let _e5373 = sqrt(select(0f, _e5370, (_e5370 > 0f)));
let _e5376 = (1f / select(1e-20f, _e5373, (_e5373 > 1e-20f)));
let _e5381 = (_e5204 + 9i);
let _e5383 = select(_e5206, _e5381, (_e5381 < _e5206));
let _e5389 = global_4.member[bitcast<u32>(select(0i, _e5383, (_e5383 > 0i)))];
let _e5390 = (_e5204 + 10i);
let _e5392 = select(_e5206, _e5390, (_e5390 < _e5206));
let _e5398 = global_4.member[bitcast<u32>(select(0i, _e5392, (_e5392 > 0i)))];
let _e5399 = (_e5204 + 11i);
let _e5401 = select(_e5206, _e5399, (_e5399 < _e5206));
let _e5407 = global_4.member[bitcast<u32>(select(0i, _e5401, (_e5401 > 0i)))];
let _e5411 = (_e5204 + 12i);
let _e5413 = select(_e5206, _e5411, (_e5411 < _e5206));
let _e5419 = global_4.member[bitcast<u32>(select(0i, _e5413, (_e5413 > 0i)))];
let _e5420 = (_e5204 + 13i);
let _e5422 = select(_e5206, _e5420, (_e5420 < _e5206));
let _e5428 = global_4.member[bitcast<u32>(select(0i, _e5422, (_e5422 > 0i)))];
let _e5429 = (_e5204 + 14i);
let _e5431 = select(_e5206, _e5429, (_e5429 < _e5206));
let _e5437 = global_4.member[bitcast<u32>(select(0i, _e5431, (_e5431 > 0i)))];
let _e5444 = (_e5204 + 15i);
let _e5446 = select(_e5206, _e5444, (_e5444 < _e5206));
let _e5452 = global_4.member[bitcast<u32>(select(0i, _e5446, (_e5446 > 0i)))];
let _e5453 = (_e5204 + 16i);
let _e5455 = select(_e5206, _e5453, (_e5453 < _e5206));
let _e5461 = global_4.member[bitcast<u32>(select(0i, _e5455, (_e5455 > 0i)))];
let _e5462 = (_e5204 + 17i);
let _e5464 = select(_e5206, _e5462, (_e5462 < _e5206));
let _e5470 = global_4.member[bitcast<u32>(select(0i, _e5464, (_e5464 > 0i)))];
let _e5474 = (((_e5389 * _e5363) + (_e5419 * _e5364)) + (_e5452 * _e5365));
let _e5475 = (((_e5398 * _e5363) + (_e5428 * _e5364)) + (_e5461 * _e5365));
let _e5476 = (((_e5407 * _e5363) + (_e5437 * _e5364)) + (_e5470 * _e5365));
let _e5481 = (((_e5474 * _e5474) + (_e5475 * _e5475)) + (_e5476 * _e5476));
let _e5484 = sqrt(select(0f, _e5481, (_e5481 > 0f)));
let _e5487 = (1f / select(1e-20f, _e5484, (_e5484 > 1e-20f)));
let _e5494 = global_1.member.member_1;
let _e5497 = (_e5204 + 18i);
let _e5499 = select(_e5206, _e5497, (_e5497 < _e5206));
let _e5505 = global_4.member[bitcast<u32>(select(0i, _e5499, (_e5499 > 0i)))];
let _e5514 = (select(select(0i, select(select(i32(_e5505), i32(-2147483648), (_e5505 < -2147483600f)), 2147483647i, (_e5505 > 2147483500f)), (_e5505 == _e5505)), _e5109, ((_e5494 & 4u) != 0u)) * 10i);
let _e5516 = (bitcast<i32>(_e168) - 1i);
let _e5518 = select(_e5516, _e5514, (_e5514 < _e5516));
let _e5524 = global_5.member[bitcast<u32>(select(0i, _e5518, (_e5518 > 0i)))];
let _e5525 = (_e5514 + 1i);
let _e5527 = select(_e5516, _e5525, (_e5525 < _e5516));
let _e5533 = global_5.member[bitcast<u32>(select(0i, _e5527, (_e5527 > 0i)))];
let _e5534 = (_e5514 + 2i);
let _e5536 = select(_e5516, _e5534, (_e5534 < _e5516));
let _e5542 = global_5.member[bitcast<u32>(select(0i, _e5536, (_e5536 > 0i)))];
let _e5546 = (_e5514 + 3i);
let _e5548 = select(_e5516, _e5546, (_e5546 < _e5516));
let _e5554 = global_5.member[bitcast<u32>(select(0i, _e5548, (_e5548 > 0i)))];
let _e5555 = (_e5514 + 4i);
let _e5557 = select(_e5516, _e5555, (_e5555 < _e5516));
let _e5563 = global_5.member[bitcast<u32>(select(0i, _e5557, (_e5557 > 0i)))];
let _e5564 = (_e5514 + 5i);
let _e5566 = select(_e5516, _e5564, (_e5564 < _e5516));
let _e5572 = global_5.member[bitcast<u32>(select(0i, _e5566, (_e5566 > 0i)))];
let _e5579 = (_e5514 + 6i);
let _e5581 = select(_e5516, _e5579, (_e5579 < _e5516));
let _e5587 = global_5.member[bitcast<u32>(select(0i, _e5581, (_e5581 > 0i)))];
let _e5588 = (_e5514 + 7i);
let _e5590 = select(_e5516, _e5588, (_e5588 < _e5516));
let _e5596 = global_5.member[bitcast<u32>(select(0i, _e5590, (_e5590 > 0i)))];
let _e5597 = (_e5514 + 8i);
let _e5599 = select(_e5516, _e5597, (_e5597 < _e5516));
let _e5605 = global_5.member[bitcast<u32>(select(0i, _e5599, (_e5599 > 0i)))];
let _e5613 = (_e5514 + 9i);
let _e5615 = select(_e5516, _e5613, (_e5613 < _e5516));
let _e5621 = global_5.member[bitcast<u32>(select(0i, _e5615, (_e5615 > 0i)))];
phi_9146_ = type_22(_e5158, vec3<f32>((_e5295 * _e5376), (_e5298 * _e5376), (_e5301 * _e5376)), vec3<f32>((_e5474 * _e5487), (_e5475 * _e5487), (_e5476 * _e5487)), vec3<f32>((((_e5524 * _e5363) + (_e5554 * _e5364)) + (_e5587 * _e5365)), (((_e5533 * _e5363) + (_e5563 * _e5364)) + (_e5596 * _e5365)), (((_e5542 * _e5363) + (_e5572 * _e5364)) + (_e5605 * _e5365))), _e5621, true);
}
let _e5624 = phi_9146_;
let _e5633 = (((_e5624.member_1.x * _e3981) + (_e5624.member_1.y * _e3982)) + (_e5624.member_1.z * _e3983));
let _e5635 = select(1f, -1f, (_e5633 > 0f));
let _e5647 = select(_e5635, -(_e5635), ((((_e5624.member_2.x * _e5624.member_1.x) + (_e5624.member_2.y * _e5624.member_1.y)) + (_e5624.member_2.z * _e5624.member_1.z)) < 0f));
let _e5648 = (_e5624.member_2.x * _e5647);
let _e5649 = (_e5624.member_2.y * _e5647);
let _e5650 = (_e5624.member_2.z * _e5647);
let _e5659 = ((((_e5648 * _e3981) + (_e5649 * _e3982)) + (_e5650 * _e3983)) > 0f);
let _e5667 = global_1.member.member_19.member_2;
let _e5675 = global_1.member.member_19.member;
if (_e5675 == 0u) {
let _e5680 = global_1.member.member_19.member_1;
phi_9736_ = type_23(vec3<f32>(_e5680.member, _e5680.member_1, _e5680.member_2), vec3<f32>(_e5667.member, _e5667.member_1, _e5667.member_2));
} else {
let _e5689 = global_1.member.member_19.member_3;
let _e5694 = (_e5624.member.x - _e5689.member);
let _e5696 = (_e5624.member.y - _e5689.member_1);
let _e5698 = (_e5624.member.z - _e5689.member_2);
let _e5703 = (((_e5694 * _e5694) + (_e5696 * _e5696)) + (_e5698 * _e5698));
let _e5705 = select(1e-12f, _e5703, (_e5703 > 1e-12f));
let _e5706 = (1f / _e5705);
let _e5710 = vec3<f32>((_e5667.member * _e5706), (_e5667.member_1 * _e5706), (_e5667.member_2 * _e5706));
if (_e5675 == 2u) {
let _e5715 = global_1.member.member_19.member_1;
let _e5723 = (((_e5715.member * _e5694) + (_e5715.member_1 * _e5696)) + (_e5715.member_2 * _e5698));
let _e5726 = (1f / select(1e-20f, _e5723, (_e5723 > 1e-20f)));
let _e5731 = global_1.member.member_19.member_4.member;
let _e5740 = ((((_e5731.member * _e5694) + (_e5731.member_1 * _e5696)) + (_e5731.member_2 * _e5698)) * _e5726);
let _e5745 = global_1.member.member_19.member_4.member_1;
let _e5754 = ((((_e5745.member * _e5694) + (_e5745.member_1 * _e5696)) + (_e5745.member_2 * _e5698)) * _e5726);
let _e5759 = global_1.member.member_19.member_4.member_2;
let _e5762 = ((_e5740 * _e5740) + (_e5754 * _e5754));
let _e5771 = global_1.member.member_19.member_4.member_3;
let _e5772 = ((_e5759 - sqrt(select(0f, _e5762, (_e5762 > 0f)))) * _e5771);
let _e5774 = select(0f, _e5772, (_e5772 > 0f));
let _e5776 = select(1f, _e5774, (_e5774 < 1f));
let _e5782 = select(0f, ((_e5776 * _e5776) * (3f - (2f * _e5776))), (_e5723 > 0f));
let _e5787 = global_1.member.member_19.member_4.member_5;
if ((_e5787 > 0u) && (_e5782 > 0f)) {
let _e5791 = (0.5f / _e5759);
let _e5801 = global_1.member.member_19.member_4.member_6;
let _e5802 = bitcast<i32>(_e5801);
local = bitcast<i32>(_e5787);
let _e5803 = local;
let _e5805 = f32((_e5803 - 1i));
let _e5807 = f32((_e5802 - 1i));
let _e5808 = local;
let _e5811 = (((0.5f + (_e5740 * _e5791)) * f32(_e5808)) - 0.5f);
let _e5813 = select(0f, _e5811, (_e5811 > 0f));
let _e5815 = select(_e5805, _e5813, (_e5813 < _e5805));
let _e5818 = (((0.5f - (_e5754 * _e5791)) * f32(_e5802)) - 0.5f);
let _e5820 = select(0f, _e5818, (_e5818 > 0f));
let _e5822 = select(_e5807, _e5820, (_e5820 < _e5807));
let _e5824 = select(0f, _e5815, (_e5815 > 0f));
let _e5826 = select(_e5805, _e5824, (_e5824 < _e5805));
let _e5833 = select(0i, select(select(i32(_e5826), i32(-2147483648), (_e5826 < -2147483600f)), 2147483647i, (_e5826 > 2147483500f)), (_e5826 == _e5826));
let _e5837 = (_e5833 - select(0i, 1i, (_e5826 < f32(_e5833))));
let _e5839 = select(0f, _e5822, (_e5822 > 0f));
let _e5841 = select(_e5807, _e5839, (_e5839 < _e5807));
let _e5848 = select(0i, select(select(i32(_e5841), i32(-2147483648), (_e5841 < -2147483600f)), 2147483647i, (_e5841 > 2147483500f)), (_e5841 == _e5841));
let _e5852 = (_e5848 - select(0i, 1i, (_e5841 < f32(_e5848))));
let _e5854 = (_e5815 - f32(_e5837));
let _e5856 = (_e5822 - f32(_e5852));
let _e5857 = (_e5837 + 1i);
let _e5858 = local;
let _e5860 = select(_e5837, _e5857, (_e5857 < _e5858));
let _e5861 = (_e5852 + 1i);
let _e5863 = select(_e5852, _e5861, (_e5861 < _e5802));
let _e5868 = global_1.member.member_19.member_4.member_4;
let _e5869 = bitcast<i32>(_e5868);
let _e5870 = local;
let _e5874 = (_e5869 + (3i * ((_e5852 * _e5870) + _e5837)));
let _e5876 = (bitcast<i32>(_e164) - 1i);
let _e5878 = select(_e5876, _e5874, (_e5874 < _e5876));
let _e5883 = global_3.member[bitcast<u32>(select(0i, _e5878, (_e5878 > 0i)))];
let _e5884 = (_e5874 + 1i);
let _e5886 = select(_e5876, _e5884, (_e5884 < _e5876));
let _e5891 = global_3.member[bitcast<u32>(select(0i, _e5886, (_e5886 > 0i)))];
let _e5892 = (_e5874 + 2i);
let _e5894 = select(_e5876, _e5892, (_e5892 < _e5876));
let _e5899 = global_3.member[bitcast<u32>(select(0i, _e5894, (_e5894 > 0i)))];
let _e5900 = local;
let _e5904 = (_e5869 + (3i * ((_e5852 * _e5900) + _e5860)));
let _e5906 = select(_e5876, _e5904, (_e5904 < _e5876));
let _e5911 = global_3.member[bitcast<u32>(select(0i, _e5906, (_e5906 > 0i)))];
let _e5912 = (_e5904 + 1i);
let _e5914 = select(_e5876, _e5912, (_e5912 < _e5876));
let _e5919 = global_3.member[bitcast<u32>(select(0i, _e5914, (_e5914 > 0i)))];
let _e5920 = (_e5904 + 2i);
let _e5922 = select(_e5876, _e5920, (_e5920 < _e5876));
let _e5927 = global_3.member[bitcast<u32>(select(0i, _e5922, (_e5922 > 0i)))];
let _e5928 = local;
let _e5932 = (_e5869 + (3i * ((_e5863 * _e5928) + _e5837)));
let _e5934 = select(_e5876, _e5932, (_e5932 < _e5876));
let _e5939 = global_3.member[bitcast<u32>(select(0i, _e5934, (_e5934 > 0i)))];
let _e5940 = (_e5932 + 1i);
let _e5942 = select(_e5876, _e5940, (_e5940 < _e5876));
let _e5947 = global_3.member[bitcast<u32>(select(0i, _e5942, (_e5942 > 0i)))];
let _e5948 = (_e5932 + 2i);
let _e5950 = select(_e5876, _e5948, (_e5948 < _e5876));
let _e5955 = global_3.member[bitcast<u32>(select(0i, _e5950, (_e5950 > 0i)))];
let _e5956 = local;
let _e5960 = (_e5869 + (3i * ((_e5863 * _e5956) + _e5860)));
let _e5962 = select(_e5876, _e5960, (_e5960 < _e5876));
let _e5967 = global_3.member[bitcast<u32>(select(0i, _e5962, (_e5962 > 0i)))];
let _e5968 = (_e5960 + 1i);
let _e5970 = select(_e5876, _e5968, (_e5968 < _e5876));
let _e5975 = global_3.member[bitcast<u32>(select(0i, _e5970, (_e5970 > 0i)))];
let _e5976 = (_e5960 + 2i);
let _e5978 = select(_e5876, _e5976, (_e5976 < _e5876));
let _e5983 = global_3.member[bitcast<u32>(select(0i, _e5978, (_e5978 > 0i)))];
let _e5990 = (_e5883 + ((_e5911 - _e5883) * _e5854));
let _e5991 = (_e5891 + ((_e5919 - _e5891) * _e5854));
let _e5992 = (_e5899 + ((_e5927 - _e5899) * _e5854));
phi_9720_ = vec3<f32>(((_e5990 + (((_e5939 + ((_e5967 - _e5939) * _e5854)) - _e5990) * _e5856)) * _e5782), ((_e5991 + (((_e5947 + ((_e5975 - _e5947) * _e5854)) - _e5991) * _e5856)) * _e5782), ((_e5992 + (((_e5955 + ((_e5983 - _e5955) * _e5854)) - _e5992) * _e5856)) * _e5782));
} else {
phi_9720_ = vec3(_e5782);
}
let _e6017 = phi_9720_;
phi_9723_ = (_e5710 * _e6017);
} else {
phi_9723_ = _e5710;
}
let _e6020 = phi_9723_;
let _e6024 = (1f / sqrt(select(0f, _e5705, (_e5705 > 0f))));
phi_9736_ = type_23(vec3<f32>((_e5694 * _e6024), (_e5696 * _e6024), (_e5698 * _e6024)), _e6020);
}
let _e6031 = phi_9736_;
let _e6042 = -((((select(_e5648, (_e5624.member_1.x * _e5635), _e5659) * _e6031.member.x) + (select(_e5649, (_e5624.member_1.y * _e5635), _e5659) * _e6031.member.y)) + (select(_e5650, (_e5624.member_1.z * _e5635), _e5659) * _e6031.member.z)));
let _e6048 = -((((_e5624.member_1.x * _e6031.member.x) + (_e5624.member_1.y * _e6031.member.y)) + (_e5624.member_1.z * _e6031.member.z)));
let _e6054 = -(_e6042);
let _e6059 = select((select(0f, _e6054, (_e6054 > 0f)) * _e5624.member_4), select(0f, _e6042, (_e6042 > 0f)), ((_e6048 * -(_e5633)) > 0f));
let _e6060 = -(_e6048);
let _e6062 = select(_e6060, _e6048, (_e6048 > _e6060));
let _e6068 = global_1.member.member_21.member_6;
let _e6082 = ((((_e6068.member.member * _e5624.member.x) + (_e6068.member.member_1 * _e5624.member.y)) + (_e6068.member.member_2 * _e5624.member.z)) + _e6068.member_1);
let _e6084 = select(1f, _e6082, (_e6082 > 1e-6f));
let _e6088 = global_1.member.member_21.member_4;
let _e6104 = global_1.member.member_21.member_5;
let _e6120 = global_1.member.member_21.member_2;
let _e6129 = -((((_e5624.member_1.x * _e6120.member) + (_e5624.member_1.y * _e6120.member_1)) + (_e5624.member_1.z * _e6120.member_2)));
let _e6130 = -(_e6129);
let _e6132 = select(_e6130, _e6129, (_e6129 > _e6130));
let _e6134 = select(1f, _e6132, (_e6132 < 1f));
let _e6136 = (1f - (_e6134 * _e6134));
let _e6143 = global_1.member.member_21.member_8;
let _e6151 = global_1.member.member_21.member_7.member;
let _e6156 = global_1.member.member_21.member_7.member_2;
let _e6158 = (_e6151 + (_e6156 * (((((_e6088.member.member * _e5624.member.x) + (_e6088.member.member_1 * _e5624.member.y)) + (_e6088.member.member_2 * _e5624.member.z)) + _e6088.member_1) / _e6084)));
let _e6163 = global_1.member.member_21.member_7.member_1;
let _e6165 = (_e6163 + (_e6156 * (((((_e6104.member.member * _e5624.member.x) + (_e6104.member.member_1 * _e5624.member.y)) + (_e6104.member.member_2 * _e5624.member.z)) + _e6104.member_1) / _e6084)));
let _e6169 = ((1f + (_e6158 * _e6158)) + (_e6165 * _e6165));
let _e6178 = global_1.member.member_21.member_9;
let _e6182 = (select(1f, -1f, (_e6048 < 0f)) * (((((1.4142135f * _e6143) * sqrt(select(0f, _e6136, (_e6136 > 0f)))) * _e6082) + (select(1f, _e6062, (_e6062 < 1f)) * sqrt(select(0f, _e6169, (_e6169 > 0f))))) * _e6178));
let _e6187 = select(0f, 1f, _e5624.member_5);
let _e6191 = (_e5624.member.x + ((_e5624.member_1.x * _e6182) * _e6187));
let _e6192 = (_e5624.member.y + ((_e5624.member_1.y * _e6182) * _e6187));
let _e6193 = (_e5624.member.z + ((_e5624.member_1.z * _e6182) * _e6187));
let _e6198 = global_1.member.member_21.member.member;
let _e6199 = bitcast<i32>(_e6198);
let _e6204 = global_1.member.member_21.member.member_1;
let _e6205 = bitcast<i32>(_e6204);
let _e6210 = global_1.member.member_21.member.member_2;
let _e6211 = bitcast<i32>(_e6210);
let _e6215 = global_1.member.member_21.member_1;
let _e6216 = bitcast<i32>(_e6215);
let _e6222 = ((((_e6068.member.member * _e6191) + (_e6068.member.member_1 * _e6192)) + (_e6068.member.member_2 * _e6193)) + _e6068.member_1);
let _e6224 = select(1f, _e6222, (_e6222 > 1e-6f));
let _e6228 = global_1.member.member_21.member_3;
let _e6239 = ((((_e6228.member.member * _e6191) + (_e6228.member.member_1 * _e6192)) + (_e6228.member.member_2 * _e6193)) + _e6228.member_1);
let _e6254 = ((((((_e6088.member.member * _e6191) + (_e6088.member.member_1 * _e6192)) + (_e6088.member.member_2 * _e6193)) + _e6088.member_1) / _e6224) - 0.5f);
let _e6255 = ((((((_e6104.member.member * _e6191) + (_e6104.member.member_1 * _e6192)) + (_e6104.member.member_2 * _e6193)) + _e6104.member_1) / _e6224) - 0.5f);
let _e6257 = f32((_e6199 - 1i));
let _e6259 = select(0f, _e6239, (_e6239 > 0f));
let _e6261 = select(_e6257, _e6259, (_e6259 < _e6257));
let _e6268 = select(0i, select(select(i32(_e6261), i32(-2147483648), (_e6261 < -2147483600f)), 2147483647i, (_e6261 > 2147483500f)), (_e6261 == _e6261));
let _e6272 = (_e6268 - select(0i, 1i, (_e6261 < f32(_e6268))));
let _e6276 = (_e6239 - f32(_e6272));
let _e6279 = select(1f, select(0f, _e6276, (_e6276 > 0f)), (_e6239 < f32(_e6199)));
let _e6280 = (_e6254 - _e6143);
let _e6281 = -(16f);
let _e6282 = f32(_e6205);
let _e6284 = select(_e6281, _e6280, (_e6280 > _e6281));
let _e6286 = select(_e6282, _e6284, (_e6284 < _e6282));
let _e6293 = select(0i, select(select(i32(_e6286), i32(-2147483648), (_e6286 < -2147483600f)), 2147483647i, (_e6286 > 2147483500f)), (_e6286 == _e6286));
let _e6299 = (_e6254 + _e6143);
let _e6302 = (f32((_e6205 - 1i)) + 16f);
let _e6304 = select(-1f, _e6299, (_e6299 > -1f));
let _e6306 = select(_e6302, _e6304, (_e6304 < _e6302));
let _e6313 = select(0i, select(select(i32(_e6306), i32(-2147483648), (_e6306 < -2147483600f)), 2147483647i, (_e6306 > 2147483500f)), (_e6306 == _e6306));
let _e6318 = (_e6255 - _e6143);
let _e6319 = f32(_e6211);
let _e6321 = select(_e6281, _e6318, (_e6318 > _e6281));
let _e6323 = select(_e6319, _e6321, (_e6321 < _e6319));
let _e6330 = select(0i, select(select(i32(_e6323), i32(-2147483648), (_e6323 < -2147483600f)), 2147483647i, (_e6323 > 2147483500f)), (_e6323 == _e6323));
let _e6336 = (_e6255 + _e6143);
let _e6339 = (f32((_e6211 - 1i)) + 16f);
let _e6341 = select(-1f, _e6336, (_e6336 > -1f));
let _e6343 = select(_e6339, _e6341, (_e6341 < _e6339));
let _e6350 = select(0i, select(select(i32(_e6343), i32(-2147483648), (_e6343 < -2147483600f)), 2147483647i, (_e6343 > 2147483500f)), (_e6343 == _e6343));
let _e6358 = bitcast<i32>(((_e6198 + 2u) >> bitcast<u32>(1i)));
let _e6360 = ((_e6205 * _e6211) * _e6358);
phi_10192_ = 0f;
phi_10195_ = vec3<f32>(0f, 0f, 0f);
phi_10197_ = ((_e6330 - select(0i, 1i, (_e6323 < f32(_e6330)))) + 1i);
loop {
let _e6362 = phi_10192_;
let _e6364 = phi_10195_;
let _e6366 = phi_10197_;
local_119 = _e6362;
local_120 = _e6362;
local_121 = _e6364;
local_122 = _e6364;
local_123 = _e6364;
let _e6367 = (_e6366 <= (_e6350 - select(0i, 1i, (_e6343 < f32(_e6350)))));
if _e6367 {
let _e6373 = (_e6143 - bitcast<f32>((bitcast<u32>((f32(_e6366) - _e6255)) & 2147483647u)));
phi_10212_ = ((_e6293 - select(0i, 1i, (_e6286 < f32(_e6293)))) + 1i);
phi_10215_ = _e6362;
phi_10217_ = _e6364;
loop {
let _e6375 = phi_10212_;
let _e6377 = phi_10215_;
let _e6379 = phi_10217_;
local_126 = _e6377;
local_127 = _e6379;
let _e6380 = (_e6375 <= (_e6313 - select(0i, 1i, (_e6306 < f32(_e6313)))));
if _e6380 {
let _e6386 = (_e6143 - bitcast<f32>((bitcast<u32>((f32(_e6375) - _e6254)) & 2147483647u)));
let _e6391 = (select(0f, _e6386, (_e6386 > 0f)) * select(0f, _e6373, (_e6373 > 0f)));
if ((((_e6375 >= 0i) && (_e6375 < _e6205)) && (_e6366 >= 0i)) && (_e6366 < _e6211)) {
let _e6401 = (((_e6366 * _e6205) + _e6375) * _e6358);
let _e6403 = (2i * _e6272);
let _e6404 = ((4i * _e6401) + _e6403);
let _e6406 = (_e6404 >> bitcast<u32>(2i));
let _e6409 = bitcast<u32>(((_e6404 & 3i) * 8i));
let _e6411 = (bitcast<i32>(_e170) - 1i);
let _e6413 = select(_e6411, _e6406, (_e6406 < _e6411));
let _e6419 = global_6.member[bitcast<u32>(select(0i, _e6413, (_e6413 > 0i)))];
let _e6423 = (_e6406 + 1i);
let _e6425 = select(_e6411, _e6423, (_e6423 < _e6411));
let _e6431 = global_6.member[bitcast<u32>(select(0i, _e6425, (_e6425 > 0i)))];
let _e6438 = ((_e6419 >> bitcast<u32>((_e6409 & 31u))) | ((_e6431 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6409) & 31u))));
let _e6441 = f32(bitcast<i32>((_e6438 & 65535u)));
let _e6449 = (1f / 65535f);
let _e6451 = (_e6391 * ((_e6441 + ((f32(bitcast<i32>((_e6438 >> bitcast<u32>(16i)))) - _e6441) * _e6279)) * _e6449));
let _e6453 = (_e6379.x + _e6451);
if (_e6216 > 1i) {
let _e6457 = ((4i * (_e6401 + _e6360)) + _e6403);
let _e6459 = (_e6457 >> bitcast<u32>(2i));
let _e6462 = bitcast<u32>(((_e6457 & 3i) * 8i));
let _e6464 = select(_e6411, _e6459, (_e6459 < _e6411));
let _e6470 = global_6.member[bitcast<u32>(select(0i, _e6464, (_e6464 > 0i)))];
let _e6474 = (_e6459 + 1i);
let _e6476 = select(_e6411, _e6474, (_e6474 < _e6411));
let _e6482 = global_6.member[bitcast<u32>(select(0i, _e6476, (_e6476 > 0i)))];
let _e6489 = ((_e6470 >> bitcast<u32>((_e6462 & 31u))) | ((_e6482 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6462) & 31u))));
let _e6492 = f32(bitcast<i32>((_e6489 & 65535u)));
let _e6507 = ((4i * (_e6401 + (2i * _e6360))) + _e6403);
let _e6509 = (_e6507 >> bitcast<u32>(2i));
let _e6512 = bitcast<u32>(((_e6507 & 3i) * 8i));
let _e6514 = select(_e6411, _e6509, (_e6509 < _e6411));
let _e6520 = global_6.member[bitcast<u32>(select(0i, _e6514, (_e6514 > 0i)))];
let _e6524 = (_e6509 + 1i);
let _e6526 = select(_e6411, _e6524, (_e6524 < _e6411));
let _e6532 = global_6.member[bitcast<u32>(select(0i, _e6526, (_e6526 > 0i)))];
let _e6539 = ((_e6520 >> bitcast<u32>((_e6512 & 31u))) | ((_e6532 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6512) & 31u))));
let _e6542 = f32(bitcast<i32>((_e6539 & 65535u)));
phi_10450_ = vec3<f32>(_e6453, (_e6379.y + (_e6391 * ((_e6492 + ((f32(bitcast<i32>((_e6489 >> bitcast<u32>(16i)))) - _e6492) * _e6279)) * _e6449))), (_e6379.z + (_e6391 * ((_e6542 + ((f32(bitcast<i32>((_e6539 >> bitcast<u32>(16i)))) - _e6542) * _e6279)) * _e6449))));
} else {
phi_10450_ = vec3<f32>(_e6453, (_e6379.y + _e6451), (_e6379.z + _e6451));
}
let _e6561 = phi_10450_;
phi_10460_ = _e6561;
} else {
phi_10460_ = vec3<f32>((_e6379.x + _e6391), (_e6379.y + _e6391), (_e6379.z + _e6391));
}
let _e6570 = phi_10460_;
phi_10213_ = (_e6375 + 1i);
phi_10216_ = (_e6377 + _e6391);
phi_10218_ = _e6570;
} else {
phi_10213_ = i32();
phi_10216_ = f32();
phi_10218_ = vec3<f32>();
}
let _e6574 = phi_10213_;
let _e6576 = phi_10216_;
let _e6578 = phi_10218_;
continue;
continuing {
phi_10212_ = _e6574;
phi_10215_ = _e6576;
phi_10217_ = _e6578;
break if !(_e6380);
}
}
let _e6979 = local_126;
phi_10193_ = _e6979;
let _e6982 = local_127;
phi_10196_ = _e6982;
phi_10198_ = (_e6366 + 1i);
} else {
phi_10193_ = f32();
phi_10196_ = vec3<f32>();
phi_10198_ = i32();
}
let _e6582 = phi_10193_;
let _e6584 = phi_10196_;
let _e6586 = phi_10198_;
continue;
continuing {
phi_10192_ = _e6582;
phi_10195_ = _e6584;
phi_10197_ = _e6586;
break if !(_e6367);
}
}
let _e6590 = local_119;
let _e6594 = (((_e6216 == 0i) || (_e6590 <= 0f)) || (_e6222 <= 1e-6f));
let _e6596 = local_120;
let _e6598 = (1f / select(_e6596, 1f, _e6594));
let _e6600 = local_121;
let _e6605 = local_122;
let _e6610 = local_123;
let _e6626 = global_1.member.member_20;
phi_10512_ = (_e5624.member_3 * vec3<f32>(((_e6031.member_1.x * (select((_e6600.x * _e6598), 1f, _e6594) * _e6059)) + _e6626.member), ((_e6031.member_1.y * (select((_e6605.y * _e6598), 1f, _e6594) * _e6059)) + _e6626.member_1), ((_e6031.member_1.z * (select((_e6610.z * _e6598), 1f, _e6594) * _e6059)) + _e6626.member_2)));
} else {
phi_10512_ = _e5087;
}
let _e6636 = phi_10512_;
phi_10513_ = _e6636;
} else {
phi_10513_ = _e5087;
}
let _e6638 = phi_10513_;
let _e6646 = ((_e282 > 0f) || _e296);
let _e6650 = global_1.member.member_16.member_12;
let _e6651 = select(_e6650, 1f, _e6646);
let _e6660 = global_1.member.member_11;
let _e6661 = local_49;
let _e6663 = local_48;
let _e6664 = ((20i * _e6661) + _e6663);
let _e6666 = select(_e208, _e6664, (_e6664 < _e208));
let _e6671 = global_2.member[bitcast<u32>(select(0i, _e6666, (_e6666 > 0i)))];
let _e6695 = local_49;
let _e6697 = local_48;
let _e6698 = ((19i * _e6695) + _e6697);
let _e6700 = select(_e208, _e6698, (_e6698 < _e208));
let _e6705 = global_2.member[bitcast<u32>(select(0i, _e6700, (_e6700 > 0i)))];
global_8.member[_e185] = ((((_e3799.x * _e3854) + (_e3811 * _e3836.member)) + (_e6638.x * _e3938)) * _e6651);
global_8.member[(_e183 + _e185)] = ((((_e3799.y * _e3865) + (_e3822 * _e3836.member_1)) + (_e6638.y * _e3938)) * _e6651);
global_8.member[((2u * _e183) + _e185)] = ((((_e3799.z * _e3876) + (_e3833 * _e3836.member_2)) + (_e6638.z * _e3938)) * _e6651);
global_8.member[((3u * _e183) + _e185)] = _e6651;
global_8.member[((4u * _e183) + _e185)] = (((_e414.member * _e3923) + (_e414.member_1 * _e3925)) + (_e414.member_2 * _e3927));
global_8.member[((5u * _e183) + _e185)] = (((_e423.member * _e3923) + (_e423.member_1 * _e3925)) + (_e423.member_2 * _e3927));
global_8.member[((6u * _e183) + _e185)] = -((((_e441.member * _e3923) + (_e441.member_1 * _e3925)) + (_e441.member_2 * _e3927)));
global_8.member[((7u * _e183) + _e185)] = _e282;
global_8.member[((8u * _e183) + _e185)] = (_e6705 * _e6660);
global_8.member[((9u * _e183) + _e185)] = select(0f, ((_e6671 * _e6660) * (((_e441.member * _e1050) + (_e441.member_1 * _e1051)) + (_e441.member_2 * _e1052))), _e6646);
global_8.member[((10u * _e183) + _e185)] = (((_e414.member * _e215) + (_e414.member_1 * _e226)) + (_e414.member_2 * _e237));
global_8.member[((11u * _e183) + _e185)] = (((_e423.member * _e215) + (_e423.member_1 * _e226)) + (_e423.member_2 * _e237));
global_8.member[((12u * _e183) + _e185)] = -((((_e441.member * _e215) + (_e441.member_1 * _e226)) + (_e441.member_2 * _e237)));
global_8.member[((13u * _e183) + _e185)] = _e249;
global_8.member[((14u * _e183) + _e185)] = _e260;
global_8.member[((15u * _e183) + _e185)] = _e271;
global_8.member[((16u * _e183) + _e185)] = _e3938;
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
