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
}
struct type_11 {
member: type_2,
member_1: u32,
member_2: type_7,
member_3: type_7,
member_4: type_7,
member_5: f32,
member_6: f32,
}
struct type_12 {
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
member_18: type_10,
member_19: type_5,
member_20: type_11,
}
struct type_13 {
member: type_12,
}
struct type_15 {
member: array<f32>,
}
struct type_20 {
member: array<u32>,
}
struct type_21 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_13;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(2)
var<storage> global_3: type_15;
@group(0) @binding(3)
var<storage> global_4: type_15;
@group(0) @binding(4)
var<storage> global_5: type_15;
@group(0) @binding(5)
var<storage> global_6: type_20;
@group(0) @binding(6)
var<storage> global_7: type_15;
@group(0) @binding(7)
var<storage, read_write> global_8: type_15;
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
var phi_2384_: vec3<f32>;
var phi_2986_: i32;
var phi_2989_: i32;
var phi_2991_: i32;
var phi_2993_: i32;
var phi_3008_: i32;
var phi_3014_: i32;
var phi_2987_: i32;
var phi_2990_: i32;
var phi_2992_: i32;
var phi_2994_: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var phi_3089_: i32;
var local_43: i32;
var local_44: i32;
var phi_3095_: i32;
var local_45: i32;
var phi_3102_: i32;
var local_46: i32;
var local_47: i32;
var phi_3108_: i32;
var local_48: i32;
var local_49: i32;
var phi_3119_: i32;
var local_50: i32;
var local_51: i32;
var phi_3131_: i32;
var local_52: i32;
var local_53: i32;
var local_54: i32;
var local_55: i32;
var phi_3367_: i32;
var phi_3370_: i32;
var phi_3372_: i32;
var phi_3374_: i32;
var phi_3389_: i32;
var phi_3395_: i32;
var phi_3368_: i32;
var phi_3371_: i32;
var phi_3373_: i32;
var phi_3375_: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var phi_3470_: i32;
var local_59: i32;
var local_60: i32;
var phi_3476_: i32;
var local_61: i32;
var phi_3483_: i32;
var local_62: i32;
var local_63: i32;
var phi_3489_: i32;
var local_64: i32;
var local_65: i32;
var phi_3500_: i32;
var local_66: i32;
var local_67: i32;
var phi_3512_: i32;
var local_68: i32;
var local_69: i32;
var local_70: i32;
var local_71: i32;
var phi_3767_: vec3<f32>;
var phi_3768_: vec3<f32>;
var phi_3769_: vec3<f32>;
var phi_4606_: type_21;
var phi_4999_: f32;
var phi_5002_: vec3<f32>;
var phi_5004_: i32;
var phi_5019_: i32;
var phi_5022_: f32;
var phi_5024_: vec3<f32>;
var phi_5257_: vec3<f32>;
var phi_5267_: vec3<f32>;
var phi_5020_: i32;
var phi_5023_: f32;
var phi_5025_: vec3<f32>;
var phi_5000_: f32;
var phi_5003_: vec3<f32>;
var phi_5005_: i32;
var local_72: f32;
var local_73: f32;
var local_74: vec3<f32>;
var local_75: vec3<f32>;
var local_76: vec3<f32>;
var phi_5390_: vec3<f32>;
var phi_5391_: vec3<f32>;
var phi_5392_: vec3<f32>;
var phi_5792_: vec3<f32>;
var phi_6394_: i32;
var phi_6397_: i32;
var phi_6399_: i32;
var phi_6401_: i32;
var phi_6416_: i32;
var phi_6422_: i32;
var phi_6395_: i32;
var phi_6398_: i32;
var phi_6400_: i32;
var phi_6402_: i32;
var local_77: i32;
var local_78: i32;
var local_79: i32;
var phi_6497_: i32;
var local_80: i32;
var local_81: i32;
var phi_6503_: i32;
var local_82: i32;
var phi_6510_: i32;
var local_83: i32;
var local_84: i32;
var phi_6516_: i32;
var local_85: i32;
var local_86: i32;
var phi_6527_: i32;
var local_87: i32;
var local_88: i32;
var phi_6539_: i32;
var local_89: i32;
var local_90: i32;
var local_91: i32;
var local_92: i32;
var phi_6775_: i32;
var phi_6778_: i32;
var phi_6780_: i32;
var phi_6782_: i32;
var phi_6797_: i32;
var phi_6803_: i32;
var phi_6776_: i32;
var phi_6779_: i32;
var phi_6781_: i32;
var phi_6783_: i32;
var local_93: i32;
var local_94: i32;
var local_95: i32;
var phi_6878_: i32;
var local_96: i32;
var local_97: i32;
var phi_6884_: i32;
var local_98: i32;
var phi_6891_: i32;
var local_99: i32;
var local_100: i32;
var phi_6897_: i32;
var local_101: i32;
var local_102: i32;
var phi_6908_: i32;
var local_103: i32;
var local_104: i32;
var phi_6920_: i32;
var local_105: i32;
var local_106: i32;
var local_107: i32;
var local_108: i32;
var phi_7175_: vec3<f32>;
var phi_7176_: vec3<f32>;
var phi_7177_: vec3<f32>;
var phi_8152_: type_21;
var phi_8545_: f32;
var phi_8548_: vec3<f32>;
var phi_8550_: i32;
var phi_8565_: i32;
var phi_8568_: f32;
var phi_8570_: vec3<f32>;
var phi_8803_: vec3<f32>;
var phi_8813_: vec3<f32>;
var phi_8566_: i32;
var phi_8569_: f32;
var phi_8571_: vec3<f32>;
var phi_8546_: f32;
var phi_8549_: vec3<f32>;
var phi_8551_: i32;
var local_109: f32;
var local_110: f32;
var local_111: vec3<f32>;
var local_112: vec3<f32>;
var local_113: vec3<f32>;
var phi_8866_: vec3<f32>;
var phi_8867_: vec3<f32>;
var local_114: f32;
var local_115: vec3<f32>;
var local_116: f32;
var local_117: vec3<f32>;
let _e144 = global;
let _e149 = arrayLength((&global_3.member));
let _e151 = arrayLength((&global_4.member));
let _e153 = arrayLength((&global_5.member));
let _e155 = arrayLength((&global_6.member));
let _e161 = global_1.member.member;
if (_e144.x < _e161.member) {
if (_e144.y < _e161.member_1) {
let _e168 = (_e161.member * _e161.member_1);
let _e170 = ((_e144.y * _e161.member) + _e144.x);
let _e172 = bitcast<i32>(_e144.x);
let _e173 = bitcast<i32>(_e144.y);
let _e177 = global_1.member.member.member;
let _e178 = bitcast<i32>(_e177);
let _e179 = (_e173 * _e178);
let _e180 = (_e179 + _e172);
local_38 = _e180;
let _e184 = global_1.member.member.member_1;
let _e186 = bitcast<i32>((_e177 * _e184));
local_39 = _e186;
let _e187 = local_38;
local_36 = _e187;
local_37 = _e186;
let _e188 = local_37;
let _e190 = local_36;
let _e191 = ((3i * _e188) + _e190);
let _e193 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e195 = select(_e193, _e191, (_e191 < _e193));
let _e200 = global_2.member[bitcast<u32>(select(0i, _e195, (_e195 > 0i)))];
let _e201 = local_37;
let _e203 = local_36;
let _e204 = ((4i * _e201) + _e203);
let _e206 = select(_e193, _e204, (_e204 < _e193));
let _e211 = global_2.member[bitcast<u32>(select(0i, _e206, (_e206 > 0i)))];
let _e212 = local_37;
let _e214 = local_36;
let _e215 = ((5i * _e212) + _e214);
let _e217 = select(_e193, _e215, (_e215 < _e193));
let _e222 = global_2.member[bitcast<u32>(select(0i, _e217, (_e217 > 0i)))];
let _e223 = local_38;
local_34 = _e223;
local_35 = _e186;
let _e224 = local_35;
let _e226 = local_34;
let _e227 = ((6i * _e224) + _e226);
let _e229 = select(_e193, _e227, (_e227 < _e193));
let _e234 = global_2.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e235 = local_35;
let _e237 = local_34;
let _e238 = ((7i * _e235) + _e237);
let _e240 = select(_e193, _e238, (_e238 < _e193));
let _e245 = global_2.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e246 = local_35;
let _e248 = local_34;
let _e249 = ((8i * _e246) + _e248);
let _e251 = select(_e193, _e249, (_e249 < _e193));
let _e256 = global_2.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e257 = local_39;
let _e259 = local_38;
let _e260 = ((18i * _e257) + _e259);
let _e262 = select(_e193, _e260, (_e260 < _e193));
let _e267 = global_2.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e268 = local_39;
let _e270 = local_38;
let _e271 = ((16i * _e268) + _e270);
let _e273 = select(_e193, _e271, (_e271 < _e193));
let _e278 = global_2.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e279 = (_e161.member_2 == 1u);
let _e281 = (_e279 && (_e278 == 3f));
let _e282 = local_38;
local_32 = _e282;
local_33 = _e186;
let _e283 = local_33;
let _e285 = local_32;
let _e286 = ((9i * _e283) + _e285);
let _e288 = select(_e193, _e286, (_e286 < _e193));
let _e293 = global_2.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e294 = local_33;
let _e296 = local_32;
let _e297 = ((10i * _e294) + _e296);
let _e299 = select(_e193, _e297, (_e297 < _e193));
let _e304 = global_2.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e305 = local_33;
let _e307 = local_32;
let _e308 = ((11i * _e305) + _e307);
let _e310 = select(_e193, _e308, (_e308 < _e193));
let _e315 = global_2.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e316 = vec3<f32>(_e293, _e304, _e315);
let _e317 = (_e172 - 1i);
let _e318 = bitcast<i32>(_e184);
local_29 = _e178;
local_30 = _e318;
let _e320 = local_29;
let _e323 = (_e173 >= 0i);
let _e325 = local_30;
let _e327 = ((((_e317 >= 0i) && (_e317 < _e320)) && _e323) && (_e173 < _e325));
if _e327 {
let _e328 = local_29;
local_31 = ((_e173 * _e328) + _e317);
} else {
local_31 = 0i;
}
let _e331 = local_29;
let _e332 = local_30;
let _e335 = local_31;
let _e336 = ((18i * (_e331 * _e332)) + _e335);
let _e338 = select(_e193, _e336, (_e336 < _e193));
let _e343 = global_2.member[bitcast<u32>(select(0i, _e338, (_e338 > 0i)))];
let _e346 = local_29;
let _e347 = local_30;
let _e350 = local_31;
let _e351 = ((16i * (_e346 * _e347)) + _e350);
let _e353 = select(_e193, _e351, (_e351 < _e193));
let _e358 = global_2.member[bitcast<u32>(select(0i, _e353, (_e353 > 0i)))];
let _e360 = ((_e327 && (_e343 == _e267)) && (_e358 == _e278));
let _e361 = local_31;
local_27 = _e361;
local_28 = _e186;
let _e362 = local_28;
let _e364 = local_27;
let _e365 = ((3i * _e362) + _e364);
let _e367 = select(_e193, _e365, (_e365 < _e193));
let _e372 = global_2.member[bitcast<u32>(select(0i, _e367, (_e367 > 0i)))];
let _e373 = local_28;
let _e375 = local_27;
let _e376 = ((4i * _e373) + _e375);
let _e378 = select(_e193, _e376, (_e376 < _e193));
let _e383 = global_2.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e384 = local_28;
let _e386 = local_27;
let _e387 = ((5i * _e384) + _e386);
let _e389 = select(_e193, _e387, (_e387 < _e193));
let _e394 = global_2.member[bitcast<u32>(select(0i, _e389, (_e389 > 0i)))];
let _e395 = local_29;
let _e396 = local_30;
let _e399 = local_31;
let _e400 = ((21i * (_e395 * _e396)) + _e399);
let _e402 = select(_e193, _e400, (_e400 < _e193));
let _e407 = global_2.member[bitcast<u32>(select(0i, _e402, (_e402 > 0i)))];
let _e409 = (_e327 && (_e407 > 0f));
let _e410 = f32(_e178);
let _e411 = f32(_e318);
let _e420 = global_1.member.member_6.member;
let _e421 = (((((f32(_e317) + 0.5f) / _e410) * 2f) - 1f) * _e420);
let _e430 = global_1.member.member_6.member_1;
let _e431 = ((1f - (((f32(_e173) + 0.5f) / _e411) * 2f)) * _e430);
let _e434 = global_1.member.member_7;
let _e443 = global_1.member.member_8;
let _e447 = (_e443.member * _e431);
let _e448 = (_e443.member_1 * _e431);
let _e449 = (_e443.member_2 * _e431);
let _e456 = global_1.member.member_6.member_3;
let _e458 = select(1f, 0f, (_e456 != 0u));
let _e461 = global_1.member.member_9;
let _e468 = (_e461.member + (((_e434.member * _e421) + _e447) * _e458));
let _e469 = (_e461.member_1 + (((_e434.member_1 * _e421) + _e448) * _e458));
let _e470 = (_e461.member_2 + (((_e434.member_2 * _e421) + _e449) * _e458));
let _e475 = (((_e468 * _e468) + (_e469 * _e469)) + (_e470 * _e470));
let _e478 = sqrt(select(0f, _e475, (_e475 > 0f)));
let _e481 = (1f / select(1e-20f, _e478, (_e478 > 1e-20f)));
let _e482 = (_e468 * _e481);
let _e483 = (_e469 * _e481);
let _e484 = (_e470 * _e481);
local_25 = (_e179 + _e317);
local_26 = _e186;
let _e486 = local_26;
let _e488 = local_25;
let _e489 = ((9i * _e486) + _e488);
let _e491 = select(_e193, _e489, (_e489 < _e193));
let _e496 = global_2.member[bitcast<u32>(select(0i, _e491, (_e491 > 0i)))];
let _e497 = local_26;
let _e499 = local_25;
let _e500 = ((10i * _e497) + _e499);
let _e502 = select(_e193, _e500, (_e500 < _e193));
let _e507 = global_2.member[bitcast<u32>(select(0i, _e502, (_e502 > 0i)))];
let _e508 = local_26;
let _e510 = local_25;
let _e511 = ((11i * _e508) + _e510);
let _e513 = select(_e193, _e511, (_e511 < _e193));
let _e518 = global_2.member[bitcast<u32>(select(0i, _e513, (_e513 > 0i)))];
let _e524 = (2f * (((_e482 * _e496) + (_e483 * _e507)) + (_e484 * _e518)));
let _e528 = (_e482 - (_e496 * _e524));
let _e529 = (_e483 - (_e507 * _e524));
let _e530 = (_e484 - (_e518 * _e524));
let _e531 = (_e172 + 1i);
local_22 = _e178;
local_23 = _e318;
let _e533 = local_22;
let _e537 = local_23;
let _e539 = ((((_e531 >= 0i) && (_e531 < _e533)) && _e323) && (_e173 < _e537));
if _e539 {
let _e540 = local_22;
local_24 = ((_e173 * _e540) + _e531);
} else {
local_24 = 0i;
}
let _e543 = local_22;
let _e544 = local_23;
let _e547 = local_24;
let _e548 = ((18i * (_e543 * _e544)) + _e547);
let _e550 = select(_e193, _e548, (_e548 < _e193));
let _e555 = global_2.member[bitcast<u32>(select(0i, _e550, (_e550 > 0i)))];
let _e558 = local_22;
let _e559 = local_23;
let _e562 = local_24;
let _e563 = ((16i * (_e558 * _e559)) + _e562);
let _e565 = select(_e193, _e563, (_e563 < _e193));
let _e570 = global_2.member[bitcast<u32>(select(0i, _e565, (_e565 > 0i)))];
let _e572 = ((_e539 && (_e555 == _e267)) && (_e570 == _e278));
let _e573 = local_24;
local_20 = _e573;
local_21 = _e186;
let _e574 = local_21;
let _e576 = local_20;
let _e577 = ((3i * _e574) + _e576);
let _e579 = select(_e193, _e577, (_e577 < _e193));
let _e584 = global_2.member[bitcast<u32>(select(0i, _e579, (_e579 > 0i)))];
let _e585 = local_21;
let _e587 = local_20;
let _e588 = ((4i * _e585) + _e587);
let _e590 = select(_e193, _e588, (_e588 < _e193));
let _e595 = global_2.member[bitcast<u32>(select(0i, _e590, (_e590 > 0i)))];
let _e596 = local_21;
let _e598 = local_20;
let _e599 = ((5i * _e596) + _e598);
let _e601 = select(_e193, _e599, (_e599 < _e193));
let _e606 = global_2.member[bitcast<u32>(select(0i, _e601, (_e601 > 0i)))];
let _e607 = local_22;
let _e608 = local_23;
let _e611 = local_24;
let _e612 = ((21i * (_e607 * _e608)) + _e611);
let _e614 = select(_e193, _e612, (_e612 < _e193));
let _e619 = global_2.member[bitcast<u32>(select(0i, _e614, (_e614 > 0i)))];
let _e621 = (_e539 && (_e619 > 0f));
let _e627 = (((((f32(_e531) + 0.5f) / _e410) * 2f) - 1f) * _e420);
let _e637 = (_e461.member + (((_e434.member * _e627) + _e447) * _e458));
let _e638 = (_e461.member_1 + (((_e434.member_1 * _e627) + _e448) * _e458));
let _e639 = (_e461.member_2 + (((_e434.member_2 * _e627) + _e449) * _e458));
let _e644 = (((_e637 * _e637) + (_e638 * _e638)) + (_e639 * _e639));
let _e647 = sqrt(select(0f, _e644, (_e644 > 0f)));
let _e650 = (1f / select(1e-20f, _e647, (_e647 > 1e-20f)));
let _e651 = (_e637 * _e650);
let _e652 = (_e638 * _e650);
let _e653 = (_e639 * _e650);
local_18 = (_e179 + _e531);
local_19 = _e186;
let _e655 = local_19;
let _e657 = local_18;
let _e658 = ((9i * _e655) + _e657);
let _e660 = select(_e193, _e658, (_e658 < _e193));
let _e665 = global_2.member[bitcast<u32>(select(0i, _e660, (_e660 > 0i)))];
let _e666 = local_19;
let _e668 = local_18;
let _e669 = ((10i * _e666) + _e668);
let _e671 = select(_e193, _e669, (_e669 < _e193));
let _e676 = global_2.member[bitcast<u32>(select(0i, _e671, (_e671 > 0i)))];
let _e677 = local_19;
let _e679 = local_18;
let _e680 = ((11i * _e677) + _e679);
let _e682 = select(_e193, _e680, (_e680 < _e193));
let _e687 = global_2.member[bitcast<u32>(select(0i, _e682, (_e682 > 0i)))];
let _e693 = (2f * (((_e651 * _e665) + (_e652 * _e676)) + (_e653 * _e687)));
let _e697 = (_e651 - (_e665 * _e693));
let _e698 = (_e652 - (_e676 * _e693));
let _e699 = (_e653 - (_e687 * _e693));
let _e700 = (_e173 - 1i);
local_15 = _e178;
local_16 = _e318;
let _e701 = (_e172 >= 0i);
let _e702 = local_15;
let _e707 = local_16;
let _e709 = (((_e701 && (_e172 < _e702)) && (_e700 >= 0i)) && (_e700 < _e707));
if _e709 {
let _e710 = local_15;
local_17 = ((_e700 * _e710) + _e172);
} else {
local_17 = 0i;
}
let _e713 = local_15;
let _e714 = local_16;
let _e717 = local_17;
let _e718 = ((18i * (_e713 * _e714)) + _e717);
let _e720 = select(_e193, _e718, (_e718 < _e193));
let _e725 = global_2.member[bitcast<u32>(select(0i, _e720, (_e720 > 0i)))];
let _e728 = local_15;
let _e729 = local_16;
let _e732 = local_17;
let _e733 = ((16i * (_e728 * _e729)) + _e732);
let _e735 = select(_e193, _e733, (_e733 < _e193));
let _e740 = global_2.member[bitcast<u32>(select(0i, _e735, (_e735 > 0i)))];
let _e742 = ((_e709 && (_e725 == _e267)) && (_e740 == _e278));
let _e743 = local_17;
local_13 = _e743;
local_14 = _e186;
let _e744 = local_14;
let _e746 = local_13;
let _e747 = ((3i * _e744) + _e746);
let _e749 = select(_e193, _e747, (_e747 < _e193));
let _e754 = global_2.member[bitcast<u32>(select(0i, _e749, (_e749 > 0i)))];
let _e755 = local_14;
let _e757 = local_13;
let _e758 = ((4i * _e755) + _e757);
let _e760 = select(_e193, _e758, (_e758 < _e193));
let _e765 = global_2.member[bitcast<u32>(select(0i, _e760, (_e760 > 0i)))];
let _e766 = local_14;
let _e768 = local_13;
let _e769 = ((5i * _e766) + _e768);
let _e771 = select(_e193, _e769, (_e769 < _e193));
let _e776 = global_2.member[bitcast<u32>(select(0i, _e771, (_e771 > 0i)))];
let _e777 = local_15;
let _e778 = local_16;
let _e781 = local_17;
let _e782 = ((21i * (_e777 * _e778)) + _e781);
let _e784 = select(_e193, _e782, (_e782 < _e193));
let _e789 = global_2.member[bitcast<u32>(select(0i, _e784, (_e784 > 0i)))];
let _e791 = (_e709 && (_e789 > 0f));
let _e797 = (((((f32(_e172) + 0.5f) / _e410) * 2f) - 1f) * _e420);
let _e803 = ((1f - (((f32(_e700) + 0.5f) / _e411) * 2f)) * _e430);
let _e804 = (_e434.member * _e797);
let _e805 = (_e434.member_1 * _e797);
let _e806 = (_e434.member_2 * _e797);
let _e816 = (_e461.member + ((_e804 + (_e443.member * _e803)) * _e458));
let _e817 = (_e461.member_1 + ((_e805 + (_e443.member_1 * _e803)) * _e458));
let _e818 = (_e461.member_2 + ((_e806 + (_e443.member_2 * _e803)) * _e458));
let _e823 = (((_e816 * _e816) + (_e817 * _e817)) + (_e818 * _e818));
let _e826 = sqrt(select(0f, _e823, (_e823 > 0f)));
let _e829 = (1f / select(1e-20f, _e826, (_e826 > 1e-20f)));
let _e830 = (_e816 * _e829);
let _e831 = (_e817 * _e829);
let _e832 = (_e818 * _e829);
local_11 = ((_e700 * _e178) + _e172);
local_12 = _e186;
let _e835 = local_12;
let _e837 = local_11;
let _e838 = ((9i * _e835) + _e837);
let _e840 = select(_e193, _e838, (_e838 < _e193));
let _e845 = global_2.member[bitcast<u32>(select(0i, _e840, (_e840 > 0i)))];
let _e846 = local_12;
let _e848 = local_11;
let _e849 = ((10i * _e846) + _e848);
let _e851 = select(_e193, _e849, (_e849 < _e193));
let _e856 = global_2.member[bitcast<u32>(select(0i, _e851, (_e851 > 0i)))];
let _e857 = local_12;
let _e859 = local_11;
let _e860 = ((11i * _e857) + _e859);
let _e862 = select(_e193, _e860, (_e860 < _e193));
let _e867 = global_2.member[bitcast<u32>(select(0i, _e862, (_e862 > 0i)))];
let _e873 = (2f * (((_e830 * _e845) + (_e831 * _e856)) + (_e832 * _e867)));
let _e877 = (_e830 - (_e845 * _e873));
let _e878 = (_e831 - (_e856 * _e873));
let _e879 = (_e832 - (_e867 * _e873));
let _e880 = (_e173 + 1i);
local_8 = _e178;
local_9 = _e318;
let _e881 = local_8;
let _e886 = local_9;
let _e888 = (((_e701 && (_e172 < _e881)) && (_e880 >= 0i)) && (_e880 < _e886));
if _e888 {
let _e889 = local_8;
local_10 = ((_e880 * _e889) + _e172);
} else {
local_10 = 0i;
}
let _e892 = local_8;
let _e893 = local_9;
let _e896 = local_10;
let _e897 = ((18i * (_e892 * _e893)) + _e896);
let _e899 = select(_e193, _e897, (_e897 < _e193));
let _e904 = global_2.member[bitcast<u32>(select(0i, _e899, (_e899 > 0i)))];
let _e907 = local_8;
let _e908 = local_9;
let _e911 = local_10;
let _e912 = ((16i * (_e907 * _e908)) + _e911);
let _e914 = select(_e193, _e912, (_e912 < _e193));
let _e919 = global_2.member[bitcast<u32>(select(0i, _e914, (_e914 > 0i)))];
let _e921 = ((_e888 && (_e904 == _e267)) && (_e919 == _e278));
let _e922 = local_10;
local_6 = _e922;
local_7 = _e186;
let _e923 = local_7;
let _e925 = local_6;
let _e926 = ((3i * _e923) + _e925);
let _e928 = select(_e193, _e926, (_e926 < _e193));
let _e933 = global_2.member[bitcast<u32>(select(0i, _e928, (_e928 > 0i)))];
let _e934 = local_7;
let _e936 = local_6;
let _e937 = ((4i * _e934) + _e936);
let _e939 = select(_e193, _e937, (_e937 < _e193));
let _e944 = global_2.member[bitcast<u32>(select(0i, _e939, (_e939 > 0i)))];
let _e945 = local_7;
let _e947 = local_6;
let _e948 = ((5i * _e945) + _e947);
let _e950 = select(_e193, _e948, (_e948 < _e193));
let _e955 = global_2.member[bitcast<u32>(select(0i, _e950, (_e950 > 0i)))];
let _e956 = local_8;
let _e957 = local_9;
let _e960 = local_10;
let _e961 = ((21i * (_e956 * _e957)) + _e960);
let _e963 = select(_e193, _e961, (_e961 < _e193));
let _e968 = global_2.member[bitcast<u32>(select(0i, _e963, (_e963 > 0i)))];
let _e970 = (_e888 && (_e968 > 0f));
let _e976 = ((1f - (((f32(_e880) + 0.5f) / _e411) * 2f)) * _e430);
let _e986 = (_e461.member + ((_e804 + (_e443.member * _e976)) * _e458));
let _e987 = (_e461.member_1 + ((_e805 + (_e443.member_1 * _e976)) * _e458));
let _e988 = (_e461.member_2 + ((_e806 + (_e443.member_2 * _e976)) * _e458));
let _e993 = (((_e986 * _e986) + (_e987 * _e987)) + (_e988 * _e988));
let _e996 = sqrt(select(0f, _e993, (_e993 > 0f)));
let _e999 = (1f / select(1e-20f, _e996, (_e996 > 1e-20f)));
let _e1000 = (_e986 * _e999);
let _e1001 = (_e987 * _e999);
let _e1002 = (_e988 * _e999);
local_4 = ((_e880 * _e178) + _e172);
local_5 = _e186;
let _e1005 = local_5;
let _e1007 = local_4;
let _e1008 = ((9i * _e1005) + _e1007);
let _e1010 = select(_e193, _e1008, (_e1008 < _e193));
let _e1015 = global_2.member[bitcast<u32>(select(0i, _e1010, (_e1010 > 0i)))];
let _e1016 = local_5;
let _e1018 = local_4;
let _e1019 = ((10i * _e1016) + _e1018);
let _e1021 = select(_e193, _e1019, (_e1019 < _e193));
let _e1026 = global_2.member[bitcast<u32>(select(0i, _e1021, (_e1021 > 0i)))];
let _e1027 = local_5;
let _e1029 = local_4;
let _e1030 = ((11i * _e1027) + _e1029);
let _e1032 = select(_e193, _e1030, (_e1030 < _e193));
let _e1037 = global_2.member[bitcast<u32>(select(0i, _e1032, (_e1032 > 0i)))];
let _e1043 = (2f * (((_e1000 * _e1015) + (_e1001 * _e1026)) + (_e1002 * _e1037)));
let _e1047 = (_e1000 - (_e1015 * _e1043));
let _e1048 = (_e1001 - (_e1026 * _e1043));
let _e1049 = (_e1002 - (_e1037 * _e1043));
let _e1050 = (_e804 + _e447);
let _e1051 = (_e805 + _e448);
let _e1052 = (_e806 + _e449);
let _e1056 = (_e461.member + (_e1050 * _e458));
let _e1057 = (_e461.member_1 + (_e1051 * _e458));
let _e1058 = (_e461.member_2 + (_e1052 * _e458));
let _e1063 = (((_e1056 * _e1056) + (_e1057 * _e1057)) + (_e1058 * _e1058));
let _e1066 = sqrt(select(0f, _e1063, (_e1063 > 0f)));
let _e1069 = (1f / select(1e-20f, _e1066, (_e1066 > 1e-20f)));
let _e1070 = (_e1056 * _e1069);
let _e1071 = (_e1057 * _e1069);
let _e1072 = (_e1058 * _e1069);
let _e1073 = (_e651 - _e1070);
let _e1074 = (_e652 - _e1071);
let _e1075 = (_e653 - _e1072);
let _e1080 = (((_e1073 * _e1073) + (_e1074 * _e1074)) + (_e1075 * _e1075));
let _e1083 = sqrt(select(0f, _e1080, (_e1080 > 0f)));
let _e1084 = (_e584 - _e372);
let _e1085 = (_e595 - _e383);
let _e1086 = (_e606 - _e394);
let _e1091 = (((_e1084 * _e1084) + (_e1085 * _e1085)) + (_e1086 * _e1086));
let _e1096 = (_e584 - _e200);
let _e1097 = (_e595 - _e211);
let _e1098 = (_e606 - _e222);
let _e1103 = (((_e1096 * _e1096) + (_e1097 * _e1097)) + (_e1098 * _e1098));
let _e1107 = (_e200 - _e372);
let _e1108 = (_e211 - _e383);
let _e1109 = (_e222 - _e394);
let _e1114 = (((_e1107 * _e1107) + (_e1108 * _e1108)) + (_e1109 * _e1109));
let _e1122 = select(select(_e1083, select(sqrt(select(0f, _e1114, (_e1114 > 0f))), sqrt(select(0f, _e1103, (_e1103 > 0f))), _e572), (_e360 || _e572)), (0.5f * sqrt(select(0f, _e1091, (_e1091 > 0f)))), (_e360 && _e572));
let _e1123 = (_e933 - _e754);
let _e1124 = (_e944 - _e765);
let _e1125 = (_e955 - _e776);
let _e1130 = (((_e1123 * _e1123) + (_e1124 * _e1124)) + (_e1125 * _e1125));
let _e1135 = (_e933 - _e200);
let _e1136 = (_e944 - _e211);
let _e1137 = (_e955 - _e222);
let _e1142 = (((_e1135 * _e1135) + (_e1136 * _e1136)) + (_e1137 * _e1137));
let _e1146 = (_e200 - _e754);
let _e1147 = (_e211 - _e765);
let _e1148 = (_e222 - _e776);
let _e1153 = (((_e1146 * _e1146) + (_e1147 * _e1147)) + (_e1148 * _e1148));
let _e1161 = select(select(_e1083, select(sqrt(select(0f, _e1153, (_e1153 > 0f))), sqrt(select(0f, _e1142, (_e1142 > 0f))), _e921), (_e742 || _e921)), (0.5f * sqrt(select(0f, _e1130, (_e1130 > 0f)))), (_e742 && _e921));
let _e1162 = (_e267 > 0f);
let _e1165 = select(_e1083, select(_e1161, _e1122, (_e1122 > _e1161)), _e1162);
let _e1169 = global_1.member.member_16.member_4;
let _e1177 = (((_e1169.member * _e200) + (_e1169.member_1 * _e211)) + (_e1169.member_2 * _e222));
let _e1181 = global_1.member.member_16.member_5;
let _e1189 = (((_e1181.member * _e200) + (_e1181.member_1 * _e211)) + (_e1181.member_2 * _e222));
let _e1193 = global_1.member.member_16.member_6;
let _e1201 = (((_e1193.member * _e200) + (_e1193.member_1 * _e211)) + (_e1193.member_2 * _e222));
let _e1205 = global_1.member.member_16.member;
let _e1209 = global_1.member.member_16.member_7;
let _e1213 = vec3<f32>(_e1209.member, _e1209.member_1, _e1209.member_2);
let _e1217 = global_1.member.member_16.member_8;
let _e1221 = (_e1205 == 0u);
if _e1221 {
phi_3769_ = _e1213;
} else {
if (_e1205 == 1u) {
let _e1224 = select(-1f, _e1201, (_e1201 > -1f));
let _e1226 = select(1f, _e1224, (_e1224 < 1f));
if (_e1226 > 0f) {
phi_2384_ = _e1213;
} else {
let _e1231 = global_1.member.member_16.member_9;
phi_2384_ = vec3<f32>(_e1231.member, _e1231.member_1, _e1231.member_2);
}
let _e1237 = phi_2384_;
let _e1246 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
let _e1249 = sqrt(select(0f, _e1246, (_e1246 > 0f)));
phi_3768_ = vec3<f32>((_e1217.member + ((_e1237.x - _e1217.member) * _e1249)), (_e1217.member_1 + ((_e1237.y - _e1217.member_1) * _e1249)), (_e1217.member_2 + ((_e1237.z - _e1217.member_2) * _e1249)));
} else {
if (_e1205 == 2u) {
let _e1261 = global_1.member.member_16.member_10;
let _e1262 = (_e1165 / _e1261);
let _e1264 = select(1e-4f, _e1262, (_e1262 > 1e-4f));
let _e1267 = bitcast<f32>((bitcast<u32>(_e1177) & 2147483647u));
let _e1270 = bitcast<f32>((bitcast<u32>(_e1189) & 2147483647u));
let _e1274 = select(_e1270, _e1267, (_e1267 > _e1270));
let _e1277 = (select(_e1270, _e1267, (_e1267 < _e1270)) / select(1.1754944e-38f, _e1274, (_e1274 > 1.1754944e-38f)));
let _e1278 = (_e1277 > 0.41421357f);
let _e1282 = select(_e1277, ((_e1277 - 1f) / (_e1277 + 1f)), _e1278);
let _e1283 = (_e1282 * _e1282);
let _e1298 = (select(0f, 0.7853982f, _e1278) + (_e1282 + ((_e1282 * _e1283) * (-0.33333334f + (_e1283 * (0.2f + (_e1283 * (-0.14285713f + (_e1283 * (0.11111111f + (_e1283 * (-0.09090909f + (_e1283 * 0.0585f)))))))))))));
let _e1301 = select(_e1298, (1.5707964f - _e1298), (_e1270 > _e1267));
let _e1304 = select(_e1301, (3.1415927f - _e1301), (_e1177 < 0f));
let _e1310 = (1f - (_e1201 * _e1201));
let _e1313 = sqrt(select(0f, _e1310, (_e1310 > 0f)));
let _e1316 = (_e1264 / select(1e-3f, _e1313, (_e1313 > 1e-3f)));
let _e1317 = ((select(_e1304, -(_e1304), (_e1189 < 0f)) / _e1261) * 0.5f);
let _e1319 = select(-8e6f, _e1317, (_e1317 > -8e6f));
let _e1321 = select(8e6f, _e1319, (_e1319 < 8e6f));
let _e1328 = select(0i, select(select(i32(_e1321), i32(-2147483648), (_e1321 < -2147483600f)), 2147483647i, (_e1321 > 2147483500f)), (_e1321 == _e1321));
let _e1335 = ((_e1317 - f32((_e1328 - select(0i, 1i, (_e1321 < f32(_e1328)))))) * 2f);
let _e1343 = ((select(select((_e1335 - 2f), (1f - _e1335), (_e1335 < 1.5f)), _e1335, (_e1335 < 0.5f)) * 2f) / _e1316);
let _e1345 = select(-1f, _e1343, (_e1343 > -1f));
let _e1348 = (2f - _e1316);
let _e1350 = select(0f, _e1348, (_e1348 > 0f));
let _e1355 = select(-1f, _e1201, (_e1201 > -1f));
let _e1357 = select(1f, _e1355, (_e1355 < 1f));
let _e1360 = ((1f - _e1357) * (1f + _e1357));
let _e1363 = sqrt(select(0f, _e1360, (_e1360 > 0f)));
let _e1366 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
let _e1369 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
let _e1373 = select(_e1369, _e1366, (_e1366 > _e1369));
let _e1376 = (select(_e1369, _e1366, (_e1366 < _e1369)) / select(1.1754944e-38f, _e1373, (_e1373 > 1.1754944e-38f)));
let _e1377 = (_e1376 > 0.41421357f);
let _e1381 = select(_e1376, ((_e1376 - 1f) / (_e1376 + 1f)), _e1377);
let _e1382 = (_e1381 * _e1381);
let _e1397 = (select(0f, 0.7853982f, _e1377) + (_e1381 + ((_e1381 * _e1382) * (-0.33333334f + (_e1382 * (0.2f + (_e1382 * (-0.14285713f + (_e1382 * (0.11111111f + (_e1382 * (-0.09090909f + (_e1382 * 0.0585f)))))))))))));
let _e1400 = select(_e1397, (1.5707964f - _e1397), (_e1369 > _e1366));
let _e1403 = select(_e1400, (3.1415927f - _e1400), (_e1363 < 0f));
let _e1408 = ((select(_e1403, -(_e1403), (_e1357 < 0f)) / _e1261) * 0.5f);
let _e1410 = select(-8e6f, _e1408, (_e1408 > -8e6f));
let _e1412 = select(8e6f, _e1410, (_e1410 < 8e6f));
let _e1419 = select(0i, select(select(i32(_e1412), i32(-2147483648), (_e1412 < -2147483600f)), 2147483647i, (_e1412 > 2147483500f)), (_e1412 == _e1412));
let _e1426 = ((_e1408 - f32((_e1419 - select(0i, 1i, (_e1412 < f32(_e1419)))))) * 2f);
let _e1434 = ((select(select((_e1426 - 2f), (1f - _e1426), (_e1426 < 1.5f)), _e1426, (_e1426 < 0.5f)) * 2f) / _e1264);
let _e1436 = select(-1f, _e1434, (_e1434 > -1f));
let _e1439 = (2f - _e1264);
let _e1441 = select(0f, _e1439, (_e1439 > 0f));
let _e1447 = (0.5f + ((0.5f * (select(1f, _e1345, (_e1345 < 1f)) * select(1f, _e1350, (_e1350 < 1f)))) * (select(1f, _e1436, (_e1436 < 1f)) * select(1f, _e1441, (_e1441 < 1f)))));
phi_3767_ = vec3<f32>((_e1209.member + ((_e1217.member - _e1209.member) * _e1447)), (_e1209.member_1 + ((_e1217.member_1 - _e1209.member_1) * _e1447)), (_e1209.member_2 + ((_e1217.member_2 - _e1209.member_2) * _e1447)));
} else {
let _e1461 = global_1.member.member_16.member_1;
let _e1462 = bitcast<i32>(_e1461);
let _e1467 = global_1.member.member_16.member_3;
let _e1469 = f32(bitcast<i32>(_e1467));
let _e1471 = (2f * 3.1415927f);
let _e1472 = ((_e1165 * f32(_e1462)) / _e1471);
let _e1474 = select(1e-6f, _e1472, (_e1472 > 1e-6f));
let _e1477 = bitcast<u32>(select(1.1754944e-38f, _e1474, (_e1474 > 1.1754944e-38f)));
let _e1478 = (_e1477 & 8388607u);
let _e1480 = select(0u, 1u, (_e1478 > 3474675u));
let _e1491 = bitcast<f32>((_e1478 | ((127u - _e1480) << bitcast<u32>(23i))));
let _e1494 = ((_e1491 - 1f) / (_e1491 + 1f));
let _e1495 = (_e1494 * _e1494);
let _e1510 = (f32(((bitcast<i32>((_e1477 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1480))) + (((2f * _e1494) + ((_e1494 * _e1495) * (0.6666667f + (_e1495 * (0.4f + (_e1495 * (0.2857143f + (_e1495 * (0.22222222f + (_e1495 * 0.18181819f)))))))))) * 1.442695f));
let _e1511 = (_e1469 - 1f);
let _e1513 = select(0f, _e1510, (_e1510 > 0f));
let _e1515 = select(_e1511, _e1513, (_e1513 < _e1511));
let _e1516 = (_e1469 - 2f);
let _e1518 = select(0f, _e1516, (_e1516 > 0f));
let _e1520 = select(0f, _e1515, (_e1515 > 0f));
let _e1522 = select(_e1518, _e1520, (_e1520 < _e1518));
let _e1529 = select(0i, select(select(i32(_e1522), i32(-2147483648), (_e1522 < -2147483600f)), 2147483647i, (_e1522 > 2147483500f)), (_e1522 == _e1522));
let _e1533 = (_e1529 - select(0i, 1i, (_e1522 < f32(_e1529))));
let _e1536 = bitcast<f32>((bitcast<u32>(_e1189) & 2147483647u));
let _e1539 = bitcast<f32>((bitcast<u32>(_e1177) & 2147483647u));
let _e1543 = select(_e1539, _e1536, (_e1536 > _e1539));
let _e1546 = (select(_e1539, _e1536, (_e1536 < _e1539)) / select(1.1754944e-38f, _e1543, (_e1543 > 1.1754944e-38f)));
let _e1547 = (_e1546 > 0.41421357f);
let _e1551 = select(_e1546, ((_e1546 - 1f) / (_e1546 + 1f)), _e1547);
let _e1552 = (_e1551 * _e1551);
let _e1567 = (select(0f, 0.7853982f, _e1547) + (_e1551 + ((_e1551 * _e1552) * (-0.33333334f + (_e1552 * (0.2f + (_e1552 * (-0.14285713f + (_e1552 * (0.11111111f + (_e1552 * (-0.09090909f + (_e1552 * 0.0585f)))))))))))));
let _e1570 = select(_e1567, (1.5707964f - _e1567), (_e1539 > _e1536));
let _e1573 = select(_e1570, (3.1415927f - _e1570), (_e1189 < 0f));
let _e1578 = (0.5f - (select(_e1573, -(_e1573), (_e1177 < 0f)) / _e1471));
let _e1580 = select(-1f, _e1201, (_e1201 > -1f));
let _e1582 = select(1f, _e1580, (_e1580 < 1f));
let _e1585 = ((1f - _e1582) * (1f + _e1582));
let _e1588 = sqrt(select(0f, _e1585, (_e1585 > 0f)));
let _e1591 = bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u));
let _e1594 = bitcast<f32>((bitcast<u32>(_e1582) & 2147483647u));
let _e1598 = select(_e1594, _e1591, (_e1591 > _e1594));
let _e1601 = (select(_e1594, _e1591, (_e1591 < _e1594)) / select(1.1754944e-38f, _e1598, (_e1598 > 1.1754944e-38f)));
let _e1602 = (_e1601 > 0.41421357f);
let _e1606 = select(_e1601, ((_e1601 - 1f) / (_e1601 + 1f)), _e1602);
let _e1607 = (_e1606 * _e1606);
let _e1622 = (select(0f, 0.7853982f, _e1602) + (_e1606 + ((_e1606 * _e1607) * (-0.33333334f + (_e1607 * (0.2f + (_e1607 * (-0.14285713f + (_e1607 * (0.11111111f + (_e1607 * (-0.09090909f + (_e1607 * 0.0585f)))))))))))));
let _e1625 = select(_e1622, (1.5707964f - _e1622), (_e1594 > _e1591));
let _e1628 = select(_e1625, (3.1415927f - _e1625), (_e1588 < 0f));
let _e1633 = (0.5f - (select(_e1628, -(_e1628), (_e1582 < 0f)) / 3.1415927f));
let _e1637 = global_1.member.member_16.member_2;
let _e1638 = bitcast<i32>(_e1637);
phi_2986_ = 0i;
phi_2989_ = 0i;
phi_2991_ = _e1638;
phi_2993_ = _e1462;
loop {
let _e1640 = phi_2986_;
let _e1642 = phi_2989_;
let _e1644 = phi_2991_;
let _e1646 = phi_2993_;
local_40 = _e1646;
local_41 = _e1644;
local_42 = _e1646;
local_43 = _e1646;
local_44 = _e1646;
local_45 = _e1646;
local_46 = _e1646;
local_47 = _e1646;
local_48 = _e1644;
local_49 = _e1644;
local_50 = _e1644;
local_51 = _e1644;
local_52 = _e1646;
local_53 = _e1642;
local_54 = _e1646;
local_55 = _e1642;
let _e1647 = (_e1640 < _e1533);
if _e1647 {
if (_e1646 > 1i) {
phi_3008_ = (_e1646 >> bitcast<u32>(1i));
} else {
phi_3008_ = 1i;
}
let _e1654 = phi_3008_;
if (_e1644 > 1i) {
phi_3014_ = (_e1644 >> bitcast<u32>(1i));
} else {
phi_3014_ = 1i;
}
let _e1659 = phi_3014_;
phi_2987_ = (_e1640 + 1i);
phi_2990_ = (_e1642 + (_e1646 * _e1644));
phi_2992_ = _e1659;
phi_2994_ = _e1654;
} else {
phi_2987_ = i32();
phi_2990_ = i32();
phi_2992_ = i32();
phi_2994_ = i32();
}
let _e1662 = phi_2987_;
let _e1664 = phi_2990_;
let _e1666 = phi_2992_;
let _e1668 = phi_2994_;
continue;
continuing {
phi_2986_ = _e1662;
phi_2989_ = _e1664;
phi_2991_ = _e1666;
phi_2993_ = _e1668;
break if !(_e1647);
}
}
let _e1671 = local_40;
let _e1672 = f32(_e1671);
let _e1674 = ((_e1578 * _e1672) - 0.5f);
let _e1676 = local_41;
let _e1677 = f32(_e1676);
let _e1679 = ((_e1633 * _e1677) - 0.5f);
let _e1681 = select(-1f, _e1674, (_e1674 > -1f));
let _e1683 = select(_e1672, _e1681, (_e1681 < _e1672));
let _e1690 = select(0i, select(select(i32(_e1683), i32(-2147483648), (_e1683 < -2147483600f)), 2147483647i, (_e1683 > 2147483500f)), (_e1683 == _e1683));
let _e1694 = (_e1690 - select(0i, 1i, (_e1683 < f32(_e1690))));
let _e1696 = select(-1f, _e1679, (_e1679 > -1f));
let _e1698 = select(_e1677, _e1696, (_e1696 < _e1677));
let _e1705 = select(0i, select(select(i32(_e1698), i32(-2147483648), (_e1698 < -2147483600f)), 2147483647i, (_e1698 > 2147483500f)), (_e1698 == _e1698));
let _e1709 = (_e1705 - select(0i, 1i, (_e1698 < f32(_e1705))));
let _e1711 = (_e1674 - f32(_e1694));
let _e1713 = (_e1679 - f32(_e1709));
let _e1715 = select(0f, _e1713, (_e1713 > 0f));
let _e1717 = select(1f, _e1715, (_e1715 < 1f));
if (_e1694 < 0i) {
let _e1720 = local_42;
phi_3089_ = (_e1694 + _e1720);
} else {
phi_3089_ = _e1694;
}
let _e1723 = phi_3089_;
let _e1725 = local_43;
if (_e1723 >= _e1725) {
let _e1728 = local_44;
phi_3095_ = (_e1723 - _e1728);
} else {
phi_3095_ = _e1723;
}
let _e1731 = phi_3095_;
let _e1732 = (_e1694 + 1i);
if (_e1732 < 0i) {
let _e1735 = local_45;
phi_3102_ = (_e1732 + _e1735);
} else {
phi_3102_ = _e1732;
}
let _e1738 = phi_3102_;
let _e1740 = local_46;
if (_e1738 >= _e1740) {
let _e1743 = local_47;
phi_3108_ = (_e1738 - _e1743);
} else {
phi_3108_ = _e1738;
}
let _e1746 = phi_3108_;
let _e1748 = select(_e1709, 0i, (_e1709 < 0i));
let _e1750 = local_48;
if (_e1748 >= _e1750) {
let _e1753 = local_49;
phi_3119_ = (_e1753 - 1i);
} else {
phi_3119_ = _e1748;
}
let _e1756 = phi_3119_;
let _e1757 = (_e1709 + 1i);
let _e1759 = select(_e1757, 0i, (_e1757 < 0i));
let _e1761 = local_50;
if (_e1759 >= _e1761) {
let _e1764 = local_51;
phi_3131_ = (_e1764 - 1i);
} else {
phi_3131_ = _e1759;
}
let _e1767 = phi_3131_;
let _e1769 = local_52;
let _e1772 = local_53;
let _e1773 = (_e1772 + (_e1756 * _e1769));
let _e1775 = local_54;
let _e1778 = local_55;
let _e1779 = (_e1778 + (_e1767 * _e1775));
let _e1781 = (3i * (_e1773 + _e1731));
let _e1783 = (bitcast<i32>(_e149) - 1i);
let _e1785 = select(_e1783, _e1781, (_e1781 < _e1783));
let _e1791 = global_3.member[bitcast<u32>(select(0i, _e1785, (_e1785 > 0i)))];
let _e1792 = (_e1781 + 1i);
let _e1794 = select(_e1783, _e1792, (_e1792 < _e1783));
let _e1800 = global_3.member[bitcast<u32>(select(0i, _e1794, (_e1794 > 0i)))];
let _e1801 = (_e1781 + 2i);
let _e1803 = select(_e1783, _e1801, (_e1801 < _e1783));
let _e1809 = global_3.member[bitcast<u32>(select(0i, _e1803, (_e1803 > 0i)))];
let _e1811 = (3i * (_e1773 + _e1746));
let _e1813 = select(_e1783, _e1811, (_e1811 < _e1783));
let _e1819 = global_3.member[bitcast<u32>(select(0i, _e1813, (_e1813 > 0i)))];
let _e1820 = (_e1811 + 1i);
let _e1822 = select(_e1783, _e1820, (_e1820 < _e1783));
let _e1828 = global_3.member[bitcast<u32>(select(0i, _e1822, (_e1822 > 0i)))];
let _e1829 = (_e1811 + 2i);
let _e1831 = select(_e1783, _e1829, (_e1829 < _e1783));
let _e1837 = global_3.member[bitcast<u32>(select(0i, _e1831, (_e1831 > 0i)))];
let _e1839 = (3i * (_e1779 + _e1731));
let _e1841 = select(_e1783, _e1839, (_e1839 < _e1783));
let _e1847 = global_3.member[bitcast<u32>(select(0i, _e1841, (_e1841 > 0i)))];
let _e1848 = (_e1839 + 1i);
let _e1850 = select(_e1783, _e1848, (_e1848 < _e1783));
let _e1856 = global_3.member[bitcast<u32>(select(0i, _e1850, (_e1850 > 0i)))];
let _e1857 = (_e1839 + 2i);
let _e1859 = select(_e1783, _e1857, (_e1857 < _e1783));
let _e1865 = global_3.member[bitcast<u32>(select(0i, _e1859, (_e1859 > 0i)))];
let _e1867 = (3i * (_e1779 + _e1746));
let _e1869 = select(_e1783, _e1867, (_e1867 < _e1783));
let _e1875 = global_3.member[bitcast<u32>(select(0i, _e1869, (_e1869 > 0i)))];
let _e1876 = (_e1867 + 1i);
let _e1878 = select(_e1783, _e1876, (_e1876 < _e1783));
let _e1884 = global_3.member[bitcast<u32>(select(0i, _e1878, (_e1878 > 0i)))];
let _e1885 = (_e1867 + 2i);
let _e1887 = select(_e1783, _e1885, (_e1885 < _e1783));
let _e1893 = global_3.member[bitcast<u32>(select(0i, _e1887, (_e1887 > 0i)))];
let _e1900 = (_e1791 + ((_e1819 - _e1791) * _e1711));
let _e1901 = (_e1800 + ((_e1828 - _e1800) * _e1711));
let _e1902 = (_e1809 + ((_e1837 - _e1809) * _e1711));
let _e1918 = (_e1900 + (((_e1847 + ((_e1875 - _e1847) * _e1711)) - _e1900) * _e1717));
let _e1919 = (_e1901 + (((_e1856 + ((_e1884 - _e1856) * _e1711)) - _e1901) * _e1717));
let _e1920 = (_e1902 + (((_e1865 + ((_e1893 - _e1865) * _e1711)) - _e1902) * _e1717));
phi_3367_ = 0i;
phi_3370_ = 0i;
phi_3372_ = _e1638;
phi_3374_ = _e1462;
loop {
let _e1923 = phi_3367_;
let _e1925 = phi_3370_;
let _e1927 = phi_3372_;
let _e1929 = phi_3374_;
local_56 = _e1929;
local_57 = _e1927;
local_58 = _e1929;
local_59 = _e1929;
local_60 = _e1929;
local_61 = _e1929;
local_62 = _e1929;
local_63 = _e1929;
local_64 = _e1927;
local_65 = _e1927;
local_66 = _e1927;
local_67 = _e1927;
local_68 = _e1929;
local_69 = _e1925;
local_70 = _e1929;
local_71 = _e1925;
let _e1930 = (_e1923 < (_e1533 + 1i));
if _e1930 {
if (_e1929 > 1i) {
phi_3389_ = (_e1929 >> bitcast<u32>(1i));
} else {
phi_3389_ = 1i;
}
let _e1937 = phi_3389_;
if (_e1927 > 1i) {
phi_3395_ = (_e1927 >> bitcast<u32>(1i));
} else {
phi_3395_ = 1i;
}
let _e1942 = phi_3395_;
phi_3368_ = (_e1923 + 1i);
phi_3371_ = (_e1925 + (_e1929 * _e1927));
phi_3373_ = _e1942;
phi_3375_ = _e1937;
} else {
phi_3368_ = i32();
phi_3371_ = i32();
phi_3373_ = i32();
phi_3375_ = i32();
}
let _e1945 = phi_3368_;
let _e1947 = phi_3371_;
let _e1949 = phi_3373_;
let _e1951 = phi_3375_;
continue;
continuing {
phi_3367_ = _e1945;
phi_3370_ = _e1947;
phi_3372_ = _e1949;
phi_3374_ = _e1951;
break if !(_e1930);
}
}
let _e1954 = local_56;
let _e1955 = f32(_e1954);
let _e1957 = ((_e1578 * _e1955) - 0.5f);
let _e1959 = local_57;
let _e1960 = f32(_e1959);
let _e1962 = ((_e1633 * _e1960) - 0.5f);
let _e1964 = select(-1f, _e1957, (_e1957 > -1f));
let _e1966 = select(_e1955, _e1964, (_e1964 < _e1955));
let _e1973 = select(0i, select(select(i32(_e1966), i32(-2147483648), (_e1966 < -2147483600f)), 2147483647i, (_e1966 > 2147483500f)), (_e1966 == _e1966));
let _e1977 = (_e1973 - select(0i, 1i, (_e1966 < f32(_e1973))));
let _e1979 = select(-1f, _e1962, (_e1962 > -1f));
let _e1981 = select(_e1960, _e1979, (_e1979 < _e1960));
let _e1988 = select(0i, select(select(i32(_e1981), i32(-2147483648), (_e1981 < -2147483600f)), 2147483647i, (_e1981 > 2147483500f)), (_e1981 == _e1981));
let _e1992 = (_e1988 - select(0i, 1i, (_e1981 < f32(_e1988))));
let _e1994 = (_e1957 - f32(_e1977));
let _e1996 = (_e1962 - f32(_e1992));
let _e1998 = select(0f, _e1996, (_e1996 > 0f));
let _e2000 = select(1f, _e1998, (_e1998 < 1f));
if (_e1977 < 0i) {
let _e2003 = local_58;
phi_3470_ = (_e1977 + _e2003);
} else {
phi_3470_ = _e1977;
}
let _e2006 = phi_3470_;
let _e2008 = local_59;
if (_e2006 >= _e2008) {
let _e2011 = local_60;
phi_3476_ = (_e2006 - _e2011);
} else {
phi_3476_ = _e2006;
}
let _e2014 = phi_3476_;
let _e2015 = (_e1977 + 1i);
if (_e2015 < 0i) {
let _e2018 = local_61;
phi_3483_ = (_e2015 + _e2018);
} else {
phi_3483_ = _e2015;
}
let _e2021 = phi_3483_;
let _e2023 = local_62;
if (_e2021 >= _e2023) {
let _e2026 = local_63;
phi_3489_ = (_e2021 - _e2026);
} else {
phi_3489_ = _e2021;
}
let _e2029 = phi_3489_;
let _e2031 = select(_e1992, 0i, (_e1992 < 0i));
let _e2033 = local_64;
if (_e2031 >= _e2033) {
let _e2036 = local_65;
phi_3500_ = (_e2036 - 1i);
} else {
phi_3500_ = _e2031;
}
let _e2039 = phi_3500_;
let _e2040 = (_e1992 + 1i);
let _e2042 = select(_e2040, 0i, (_e2040 < 0i));
let _e2044 = local_66;
if (_e2042 >= _e2044) {
let _e2047 = local_67;
phi_3512_ = (_e2047 - 1i);
} else {
phi_3512_ = _e2042;
}
let _e2050 = phi_3512_;
let _e2052 = local_68;
let _e2055 = local_69;
let _e2056 = (_e2055 + (_e2039 * _e2052));
let _e2058 = local_70;
let _e2061 = local_71;
let _e2062 = (_e2061 + (_e2050 * _e2058));
let _e2064 = (3i * (_e2056 + _e2014));
let _e2066 = select(_e1783, _e2064, (_e2064 < _e1783));
let _e2072 = global_3.member[bitcast<u32>(select(0i, _e2066, (_e2066 > 0i)))];
let _e2073 = (_e2064 + 1i);
let _e2075 = select(_e1783, _e2073, (_e2073 < _e1783));
let _e2081 = global_3.member[bitcast<u32>(select(0i, _e2075, (_e2075 > 0i)))];
let _e2082 = (_e2064 + 2i);
let _e2084 = select(_e1783, _e2082, (_e2082 < _e1783));
let _e2090 = global_3.member[bitcast<u32>(select(0i, _e2084, (_e2084 > 0i)))];
let _e2092 = (3i * (_e2056 + _e2029));
let _e2094 = select(_e1783, _e2092, (_e2092 < _e1783));
let _e2100 = global_3.member[bitcast<u32>(select(0i, _e2094, (_e2094 > 0i)))];
let _e2101 = (_e2092 + 1i);
let _e2103 = select(_e1783, _e2101, (_e2101 < _e1783));
let _e2109 = global_3.member[bitcast<u32>(select(0i, _e2103, (_e2103 > 0i)))];
let _e2110 = (_e2092 + 2i);
let _e2112 = select(_e1783, _e2110, (_e2110 < _e1783));
let _e2118 = global_3.member[bitcast<u32>(select(0i, _e2112, (_e2112 > 0i)))];
let _e2120 = (3i * (_e2062 + _e2014));
let _e2122 = select(_e1783, _e2120, (_e2120 < _e1783));
let _e2128 = global_3.member[bitcast<u32>(select(0i, _e2122, (_e2122 > 0i)))];
let _e2129 = (_e2120 + 1i);
let _e2131 = select(_e1783, _e2129, (_e2129 < _e1783));
let _e2137 = global_3.member[bitcast<u32>(select(0i, _e2131, (_e2131 > 0i)))];
let _e2138 = (_e2120 + 2i);
let _e2140 = select(_e1783, _e2138, (_e2138 < _e1783));
let _e2146 = global_3.member[bitcast<u32>(select(0i, _e2140, (_e2140 > 0i)))];
let _e2148 = (3i * (_e2062 + _e2029));
let _e2150 = select(_e1783, _e2148, (_e2148 < _e1783));
let _e2156 = global_3.member[bitcast<u32>(select(0i, _e2150, (_e2150 > 0i)))];
let _e2157 = (_e2148 + 1i);
let _e2159 = select(_e1783, _e2157, (_e2157 < _e1783));
let _e2165 = global_3.member[bitcast<u32>(select(0i, _e2159, (_e2159 > 0i)))];
let _e2166 = (_e2148 + 2i);
let _e2168 = select(_e1783, _e2166, (_e2166 < _e1783));
let _e2174 = global_3.member[bitcast<u32>(select(0i, _e2168, (_e2168 > 0i)))];
let _e2181 = (_e2072 + ((_e2100 - _e2072) * _e1994));
let _e2182 = (_e2081 + ((_e2109 - _e2081) * _e1994));
let _e2183 = (_e2090 + ((_e2118 - _e2090) * _e1994));
let _e2206 = (_e1515 - f32(_e1533));
let _e2208 = select(0f, _e2206, (_e2206 > 0f));
let _e2210 = select(1f, _e2208, (_e2208 < 1f));
let _e2220 = global_1.member.member_16.member_11;
phi_3767_ = vec3<f32>(((_e1918 + (((_e2181 + (((_e2128 + ((_e2156 - _e2128) * _e1994)) - _e2181) * _e2000)) - _e1918) * _e2210)) * _e2220), ((_e1919 + (((_e2182 + (((_e2137 + ((_e2165 - _e2137) * _e1994)) - _e2182) * _e2000)) - _e1919) * _e2210)) * _e2220), ((_e1920 + (((_e2183 + (((_e2146 + ((_e2174 - _e2146) * _e1994)) - _e2183) * _e2000)) - _e1920) * _e2210)) * _e2220));
}
let _e2226 = phi_3767_;
phi_3768_ = _e2226;
}
let _e2228 = phi_3768_;
phi_3769_ = _e2228;
}
let _e2230 = phi_3769_;
if _e281 {
let _e2231 = local_39;
let _e2233 = local_38;
let _e2234 = ((23i * _e2231) + _e2233);
let _e2236 = select(_e193, _e2234, (_e2234 < _e193));
let _e2241 = global_2.member[bitcast<u32>(select(0i, _e2236, (_e2236 > 0i)))];
let _e2248 = select(0i, select(select(i32(_e2241), i32(-2147483648), (_e2241 < -2147483600f)), 2147483647i, (_e2241 > 2147483500f)), (_e2241 == _e2241));
let _e2249 = local_38;
local_2 = _e2249;
local_3 = _e186;
let _e2250 = local_2;
let _e2252 = select(_e193, _e2250, (_e2250 < _e193));
let _e2257 = global_2.member[bitcast<u32>(select(0i, _e2252, (_e2252 > 0i)))];
let _e2258 = local_3;
let _e2259 = local_2;
let _e2260 = (_e2258 + _e2259);
let _e2262 = select(_e193, _e2260, (_e2260 < _e193));
let _e2267 = global_2.member[bitcast<u32>(select(0i, _e2262, (_e2262 > 0i)))];
let _e2268 = local_3;
let _e2270 = local_2;
let _e2271 = ((2i * _e2268) + _e2270);
let _e2273 = select(_e193, _e2271, (_e2271 < _e193));
let _e2278 = global_2.member[bitcast<u32>(select(0i, _e2273, (_e2273 > 0i)))];
let _e2279 = vec3<f32>(_e2257, _e2267, _e2278);
if (_e2248 < 0i) {
let _e2281 = (_e2248 == -3i);
let _e2287 = global_1.member.member_17.member_1.member.member;
let _e2292 = global_1.member.member_17.member_1.member_1;
let _e2298 = global_1.member.member_17.member.member.member;
let _e2303 = global_1.member.member_17.member.member_1;
let _e2313 = vec3<f32>(select(_e2298.member, _e2287.member, _e2281), select(_e2298.member_1, _e2287.member_1, _e2281), select(_e2298.member_2, _e2287.member_2, _e2281));
phi_4606_ = type_21(_e2279, _e2313, _e2313, vec3<f32>(select(_e2303.member, _e2292.member, _e2281), select(_e2303.member_1, _e2292.member_1, _e2281), select(_e2303.member_2, _e2292.member_2, _e2281)), 0f, false);
} else {
let _e2325 = (_e2248 * 19i);
let _e2327 = (bitcast<i32>(_e151) - 1i);
let _e2329 = select(_e2327, _e2325, (_e2325 < _e2327));
let _e2335 = global_4.member[bitcast<u32>(select(0i, _e2329, (_e2329 > 0i)))];
let _e2336 = (_e2325 + 1i);
let _e2338 = select(_e2327, _e2336, (_e2336 < _e2327));
let _e2344 = global_4.member[bitcast<u32>(select(0i, _e2338, (_e2338 > 0i)))];
let _e2345 = (_e2325 + 2i);
let _e2347 = select(_e2327, _e2345, (_e2345 < _e2327));
let _e2353 = global_4.member[bitcast<u32>(select(0i, _e2347, (_e2347 > 0i)))];
let _e2354 = (_e2325 + 3i);
let _e2356 = select(_e2327, _e2354, (_e2354 < _e2327));
let _e2362 = global_4.member[bitcast<u32>(select(0i, _e2356, (_e2356 > 0i)))];
let _e2363 = (_e2325 + 4i);
let _e2365 = select(_e2327, _e2363, (_e2363 < _e2327));
let _e2371 = global_4.member[bitcast<u32>(select(0i, _e2365, (_e2365 > 0i)))];
let _e2372 = (_e2325 + 5i);
let _e2374 = select(_e2327, _e2372, (_e2372 < _e2327));
let _e2380 = global_4.member[bitcast<u32>(select(0i, _e2374, (_e2374 > 0i)))];
let _e2381 = (_e2325 + 6i);
let _e2383 = select(_e2327, _e2381, (_e2381 < _e2327));
let _e2389 = global_4.member[bitcast<u32>(select(0i, _e2383, (_e2383 > 0i)))];
let _e2390 = (_e2325 + 7i);
let _e2392 = select(_e2327, _e2390, (_e2390 < _e2327));
let _e2398 = global_4.member[bitcast<u32>(select(0i, _e2392, (_e2392 > 0i)))];
let _e2399 = (_e2325 + 8i);
let _e2401 = select(_e2327, _e2399, (_e2399 < _e2327));
let _e2407 = global_4.member[bitcast<u32>(select(0i, _e2401, (_e2401 > 0i)))];
let _e2408 = (_e2362 - _e2335);
let _e2409 = (_e2371 - _e2344);
let _e2410 = (_e2380 - _e2353);
let _e2411 = (_e2389 - _e2335);
let _e2412 = (_e2398 - _e2344);
let _e2413 = (_e2407 - _e2353);
let _e2416 = ((_e2409 * _e2413) - (_e2410 * _e2412));
let _e2419 = ((_e2410 * _e2411) - (_e2408 * _e2413));
let _e2422 = ((_e2408 * _e2412) - (_e2409 * _e2411));
let _e2423 = (_e2362 - _e2257);
let _e2424 = (_e2371 - _e2267);
let _e2425 = (_e2380 - _e2278);
let _e2426 = (_e2389 - _e2257);
let _e2427 = (_e2398 - _e2267);
let _e2428 = (_e2407 - _e2278);
let _e2442 = (((((_e2424 * _e2428) - (_e2425 * _e2427)) * _e2416) + (((_e2425 * _e2426) - (_e2423 * _e2428)) * _e2419)) + (((_e2423 * _e2427) - (_e2424 * _e2426)) * _e2422));
let _e2444 = select(0f, _e2442, (_e2442 > 0f));
let _e2445 = (_e2335 - _e2257);
let _e2446 = (_e2344 - _e2267);
let _e2447 = (_e2353 - _e2278);
let _e2461 = (((((_e2427 * _e2447) - (_e2428 * _e2446)) * _e2416) + (((_e2428 * _e2445) - (_e2426 * _e2447)) * _e2419)) + (((_e2426 * _e2446) - (_e2427 * _e2445)) * _e2422));
let _e2463 = select(0f, _e2461, (_e2461 > 0f));
let _e2477 = (((((_e2446 * _e2425) - (_e2447 * _e2424)) * _e2416) + (((_e2447 * _e2423) - (_e2445 * _e2425)) * _e2419)) + (((_e2445 * _e2424) - (_e2446 * _e2423)) * _e2422));
let _e2479 = select(0f, _e2477, (_e2477 > 0f));
let _e2481 = ((_e2444 + _e2463) + _e2479);
let _e2483 = select(1e-30f, _e2481, (_e2481 > 1e-30f));
let _e2484 = (_e2444 / _e2483);
let _e2485 = (_e2463 / _e2483);
let _e2486 = (_e2479 / _e2483);
let _e2491 = (((_e2416 * _e2416) + (_e2419 * _e2419)) + (_e2422 * _e2422));
let _e2494 = sqrt(select(0f, _e2491, (_e2491 > 0f)));
let _e2497 = (1f / select(1e-20f, _e2494, (_e2494 > 1e-20f)));
let _e2502 = (_e2325 + 9i);
let _e2504 = select(_e2327, _e2502, (_e2502 < _e2327));
let _e2510 = global_4.member[bitcast<u32>(select(0i, _e2504, (_e2504 > 0i)))];
let _e2511 = (_e2325 + 10i);
let _e2513 = select(_e2327, _e2511, (_e2511 < _e2327));
let _e2519 = global_4.member[bitcast<u32>(select(0i, _e2513, (_e2513 > 0i)))];
let _e2520 = (_e2325 + 11i);
let _e2522 = select(_e2327, _e2520, (_e2520 < _e2327));
let _e2528 = global_4.member[bitcast<u32>(select(0i, _e2522, (_e2522 > 0i)))];
let _e2532 = (_e2325 + 12i);
let _e2534 = select(_e2327, _e2532, (_e2532 < _e2327));
let _e2540 = global_4.member[bitcast<u32>(select(0i, _e2534, (_e2534 > 0i)))];
let _e2541 = (_e2325 + 13i);
let _e2543 = select(_e2327, _e2541, (_e2541 < _e2327));
let _e2549 = global_4.member[bitcast<u32>(select(0i, _e2543, (_e2543 > 0i)))];
let _e2550 = (_e2325 + 14i);
let _e2552 = select(_e2327, _e2550, (_e2550 < _e2327));
let _e2558 = global_4.member[bitcast<u32>(select(0i, _e2552, (_e2552 > 0i)))];
let _e2565 = (_e2325 + 15i);
let _e2567 = select(_e2327, _e2565, (_e2565 < _e2327));
let _e2573 = global_4.member[bitcast<u32>(select(0i, _e2567, (_e2567 > 0i)))];
let _e2574 = (_e2325 + 16i);
let _e2576 = select(_e2327, _e2574, (_e2574 < _e2327));
let _e2582 = global_4.member[bitcast<u32>(select(0i, _e2576, (_e2576 > 0i)))];
let _e2583 = (_e2325 + 17i);
let _e2585 = select(_e2327, _e2583, (_e2583 < _e2327));
let _e2591 = global_4.member[bitcast<u32>(select(0i, _e2585, (_e2585 > 0i)))];
let _e2595 = (((_e2510 * _e2484) + (_e2540 * _e2485)) + (_e2573 * _e2486));
let _e2596 = (((_e2519 * _e2484) + (_e2549 * _e2485)) + (_e2582 * _e2486));
let _e2597 = (((_e2528 * _e2484) + (_e2558 * _e2485)) + (_e2591 * _e2486));
let _e2602 = (((_e2595 * _e2595) + (_e2596 * _e2596)) + (_e2597 * _e2597));
let _e2605 = sqrt(select(0f, _e2602, (_e2602 > 0f)));
let _e2608 = (1f / select(1e-20f, _e2605, (_e2605 > 1e-20f)));
let _e2615 = global_1.member.member_1;
let _e2618 = (_e2325 + 18i);
let _e2620 = select(_e2327, _e2618, (_e2618 < _e2327));
let _e2626 = global_4.member[bitcast<u32>(select(0i, _e2620, (_e2620 > 0i)))];
let _e2635 = (select(select(0i, select(select(i32(_e2626), i32(-2147483648), (_e2626 < -2147483600f)), 2147483647i, (_e2626 > 2147483500f)), (_e2626 == _e2626)), _e2248, ((_e2615 & 4u) != 0u)) * 10i);
let _e2637 = (bitcast<i32>(_e153) - 1i);
let _e2639 = select(_e2637, _e2635, (_e2635 < _e2637));
let _e2645 = global_5.member[bitcast<u32>(select(0i, _e2639, (_e2639 > 0i)))];
let _e2646 = (_e2635 + 1i);
let _e2648 = select(_e2637, _e2646, (_e2646 < _e2637));
let _e2654 = global_5.member[bitcast<u32>(select(0i, _e2648, (_e2648 > 0i)))];
let _e2655 = (_e2635 + 2i);
let _e2657 = select(_e2637, _e2655, (_e2655 < _e2637));
let _e2663 = global_5.member[bitcast<u32>(select(0i, _e2657, (_e2657 > 0i)))];
let _e2667 = (_e2635 + 3i);
let _e2669 = select(_e2637, _e2667, (_e2667 < _e2637));
let _e2675 = global_5.member[bitcast<u32>(select(0i, _e2669, (_e2669 > 0i)))];
let _e2676 = (_e2635 + 4i);
let _e2678 = select(_e2637, _e2676, (_e2676 < _e2637));
let _e2684 = global_5.member[bitcast<u32>(select(0i, _e2678, (_e2678 > 0i)))];
let _e2685 = (_e2635 + 5i);
let _e2687 = select(_e2637, _e2685, (_e2685 < _e2637));
let _e2693 = global_5.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2700 = (_e2635 + 6i);
let _e2702 = select(_e2637, _e2700, (_e2700 < _e2637));
let _e2708 = global_5.member[bitcast<u32>(select(0i, _e2702, (_e2702 > 0i)))];
let _e2709 = (_e2635 + 7i);
let _e2711 = select(_e2637, _e2709, (_e2709 < _e2637));
let _e2717 = global_5.member[bitcast<u32>(select(0i, _e2711, (_e2711 > 0i)))];
let _e2718 = (_e2635 + 8i);
let _e2720 = select(_e2637, _e2718, (_e2718 < _e2637));
let _e2726 = global_5.member[bitcast<u32>(select(0i, _e2720, (_e2720 > 0i)))];
let _e2734 = (_e2635 + 9i);
let _e2736 = select(_e2637, _e2734, (_e2734 < _e2637));
let _e2742 = global_5.member[bitcast<u32>(select(0i, _e2736, (_e2736 > 0i)))];
phi_4606_ = type_21(_e2279, vec3<f32>((_e2416 * _e2497), (_e2419 * _e2497), (_e2422 * _e2497)), vec3<f32>((_e2595 * _e2608), (_e2596 * _e2608), (_e2597 * _e2608)), vec3<f32>((((_e2645 * _e2484) + (_e2675 * _e2485)) + (_e2708 * _e2486)), (((_e2654 * _e2484) + (_e2684 * _e2485)) + (_e2717 * _e2486)), (((_e2663 * _e2484) + (_e2693 * _e2485)) + (_e2726 * _e2486))), _e2742, true);
}
let _e2745 = phi_4606_;
let _e2754 = (((_e2745.member_1.x * _e200) + (_e2745.member_1.y * _e211)) + (_e2745.member_1.z * _e222));
let _e2756 = select(1f, -1f, (_e2754 > 0f));
let _e2768 = select(_e2756, -(_e2756), ((((_e2745.member_2.x * _e2745.member_1.x) + (_e2745.member_2.y * _e2745.member_1.y)) + (_e2745.member_2.z * _e2745.member_1.z)) < 0f));
let _e2769 = (_e2745.member_2.x * _e2768);
let _e2770 = (_e2745.member_2.y * _e2768);
let _e2771 = (_e2745.member_2.z * _e2768);
let _e2780 = ((((_e2769 * _e200) + (_e2770 * _e211)) + (_e2771 * _e222)) > 0f);
let _e2781 = select(_e2769, (_e2745.member_1.x * _e2756), _e2780);
let _e2782 = select(_e2770, (_e2745.member_1.y * _e2756), _e2780);
let _e2783 = select(_e2771, (_e2745.member_1.z * _e2756), _e2780);
let _e2787 = global_1.member.member_18.member;
let _e2796 = -((((_e2781 * _e2787.member) + (_e2782 * _e2787.member_1)) + (_e2783 * _e2787.member_2)));
let _e2802 = -((((_e2745.member_1.x * _e2787.member) + (_e2745.member_1.y * _e2787.member_1)) + (_e2745.member_1.z * _e2787.member_2)));
let _e2808 = -(_e2796);
let _e2813 = select((select(0f, _e2808, (_e2808 > 0f)) * _e2745.member_4), select(0f, _e2796, (_e2796 > 0f)), ((_e2802 * -(_e2754)) > 0f));
let _e2814 = -(_e2802);
let _e2816 = select(_e2814, _e2802, (_e2802 > _e2814));
let _e2818 = select(1f, _e2816, (_e2816 < 1f));
let _e2822 = (1f - (_e2818 * _e2818));
let _e2829 = global_1.member.member_20.member_5;
let _e2836 = global_1.member.member_20.member_6;
let _e2838 = (select(1f, -1f, (_e2802 < 0f)) * ((((1.4142135f * _e2829) * sqrt(select(0f, _e2822, (_e2822 > 0f)))) + _e2818) * _e2836));
let _e2843 = select(0f, 1f, _e2745.member_5);
let _e2849 = (_e2745.member.x + ((_e2745.member_1.x * _e2838) * _e2843));
let _e2851 = (_e2745.member.y + ((_e2745.member_1.y * _e2838) * _e2843));
let _e2853 = (_e2745.member.z + ((_e2745.member_1.z * _e2838) * _e2843));
let _e2858 = global_1.member.member_20.member.member;
let _e2859 = bitcast<i32>(_e2858);
let _e2864 = global_1.member.member_20.member.member_1;
let _e2865 = bitcast<i32>(_e2864);
let _e2870 = global_1.member.member_20.member.member_2;
let _e2871 = bitcast<i32>(_e2870);
let _e2875 = global_1.member.member_20.member_1;
let _e2876 = bitcast<i32>(_e2875);
let _e2880 = global_1.member.member_20.member_2;
let _e2891 = ((((_e2880.member.member * _e2849) + (_e2880.member.member_1 * _e2851)) + (_e2880.member.member_2 * _e2853)) + _e2880.member_1);
let _e2895 = global_1.member.member_20.member_3;
let _e2907 = (((((_e2895.member.member * _e2849) + (_e2895.member.member_1 * _e2851)) + (_e2895.member.member_2 * _e2853)) + _e2895.member_1) - 0.5f);
let _e2911 = global_1.member.member_20.member_4;
let _e2923 = (((((_e2911.member.member * _e2849) + (_e2911.member.member_1 * _e2851)) + (_e2911.member.member_2 * _e2853)) + _e2911.member_1) - 0.5f);
let _e2925 = f32((_e2859 - 1i));
let _e2927 = select(0f, _e2891, (_e2891 > 0f));
let _e2929 = select(_e2925, _e2927, (_e2927 < _e2925));
let _e2936 = select(0i, select(select(i32(_e2929), i32(-2147483648), (_e2929 < -2147483600f)), 2147483647i, (_e2929 > 2147483500f)), (_e2929 == _e2929));
let _e2940 = (_e2936 - select(0i, 1i, (_e2929 < f32(_e2936))));
let _e2944 = (_e2891 - f32(_e2940));
let _e2947 = select(1f, select(0f, _e2944, (_e2944 > 0f)), (_e2891 < f32(_e2859)));
let _e2948 = (_e2907 - _e2829);
let _e2949 = -(16f);
let _e2950 = f32(_e2865);
let _e2952 = select(_e2949, _e2948, (_e2948 > _e2949));
let _e2954 = select(_e2950, _e2952, (_e2952 < _e2950));
let _e2961 = select(0i, select(select(i32(_e2954), i32(-2147483648), (_e2954 < -2147483600f)), 2147483647i, (_e2954 > 2147483500f)), (_e2954 == _e2954));
let _e2967 = (_e2907 + _e2829);
let _e2970 = (f32((_e2865 - 1i)) + 16f);
let _e2972 = select(-1f, _e2967, (_e2967 > -1f));
let _e2974 = select(_e2970, _e2972, (_e2972 < _e2970));
let _e2981 = select(0i, select(select(i32(_e2974), i32(-2147483648), (_e2974 < -2147483600f)), 2147483647i, (_e2974 > 2147483500f)), (_e2974 == _e2974));
let _e2986 = (_e2923 - _e2829);
let _e2987 = f32(_e2871);
let _e2989 = select(_e2949, _e2986, (_e2986 > _e2949));
let _e2991 = select(_e2987, _e2989, (_e2989 < _e2987));
let _e2998 = select(0i, select(select(i32(_e2991), i32(-2147483648), (_e2991 < -2147483600f)), 2147483647i, (_e2991 > 2147483500f)), (_e2991 == _e2991));
let _e3004 = (_e2923 + _e2829);
let _e3007 = (f32((_e2871 - 1i)) + 16f);
let _e3009 = select(-1f, _e3004, (_e3004 > -1f));
let _e3011 = select(_e3007, _e3009, (_e3009 < _e3007));
let _e3018 = select(0i, select(select(i32(_e3011), i32(-2147483648), (_e3011 < -2147483600f)), 2147483647i, (_e3011 > 2147483500f)), (_e3011 == _e3011));
let _e3026 = bitcast<i32>(((_e2858 + 2u) >> bitcast<u32>(1i)));
let _e3028 = ((_e2865 * _e2871) * _e3026);
phi_4999_ = 0f;
phi_5002_ = vec3<f32>(0f, 0f, 0f);
phi_5004_ = ((_e2998 - select(0i, 1i, (_e2991 < f32(_e2998)))) + 1i);
loop {
let _e3030 = phi_4999_;
let _e3032 = phi_5002_;
let _e3034 = phi_5004_;
local_72 = _e3030;
local_73 = _e3030;
local_74 = _e3032;
local_75 = _e3032;
local_76 = _e3032;
let _e3035 = (_e3034 <= (_e3018 - select(0i, 1i, (_e3011 < f32(_e3018)))));
if _e3035 {
let _e3041 = (_e2829 - bitcast<f32>((bitcast<u32>((f32(_e3034) - _e2923)) & 2147483647u)));
phi_5019_ = ((_e2961 - select(0i, 1i, (_e2954 < f32(_e2961)))) + 1i);
phi_5022_ = _e3030;
phi_5024_ = _e3032;
loop {
let _e3043 = phi_5019_;
let _e3045 = phi_5022_;
let _e3047 = phi_5024_;
local_114 = _e3045;
local_115 = _e3047;
let _e3048 = (_e3043 <= (_e2981 - select(0i, 1i, (_e2974 < f32(_e2981)))));
if _e3048 {
let _e3054 = (_e2829 - bitcast<f32>((bitcast<u32>((f32(_e3043) - _e2907)) & 2147483647u)));
let _e3059 = (select(0f, _e3054, (_e3054 > 0f)) * select(0f, _e3041, (_e3041 > 0f)));
if ((((_e3043 >= 0i) && (_e3043 < _e2865)) && (_e3034 >= 0i)) && (_e3034 < _e2871)) {
let _e3069 = (((_e3034 * _e2865) + _e3043) * _e3026);
let _e3071 = (2i * _e2940);
let _e3072 = ((4i * _e3069) + _e3071);
let _e3074 = (_e3072 >> bitcast<u32>(2i));
let _e3077 = bitcast<u32>(((_e3072 & 3i) * 8i));
let _e3079 = (bitcast<i32>(_e155) - 1i);
let _e3081 = select(_e3079, _e3074, (_e3074 < _e3079));
let _e3087 = global_6.member[bitcast<u32>(select(0i, _e3081, (_e3081 > 0i)))];
let _e3091 = (_e3074 + 1i);
let _e3093 = select(_e3079, _e3091, (_e3091 < _e3079));
let _e3099 = global_6.member[bitcast<u32>(select(0i, _e3093, (_e3093 > 0i)))];
let _e3106 = ((_e3087 >> bitcast<u32>((_e3077 & 31u))) | ((_e3099 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3077) & 31u))));
let _e3109 = f32(bitcast<i32>((_e3106 & 65535u)));
let _e3117 = (1f / 65535f);
let _e3119 = (_e3059 * ((_e3109 + ((f32(bitcast<i32>((_e3106 >> bitcast<u32>(16i)))) - _e3109) * _e2947)) * _e3117));
let _e3121 = (_e3047.x + _e3119);
if (_e2876 > 1i) {
let _e3125 = ((4i * (_e3069 + _e3028)) + _e3071);
let _e3127 = (_e3125 >> bitcast<u32>(2i));
let _e3130 = bitcast<u32>(((_e3125 & 3i) * 8i));
let _e3132 = select(_e3079, _e3127, (_e3127 < _e3079));
let _e3138 = global_6.member[bitcast<u32>(select(0i, _e3132, (_e3132 > 0i)))];
let _e3142 = (_e3127 + 1i);
let _e3144 = select(_e3079, _e3142, (_e3142 < _e3079));
let _e3150 = global_6.member[bitcast<u32>(select(0i, _e3144, (_e3144 > 0i)))];
let _e3157 = ((_e3138 >> bitcast<u32>((_e3130 & 31u))) | ((_e3150 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3130) & 31u))));
let _e3160 = f32(bitcast<i32>((_e3157 & 65535u)));
let _e3175 = ((4i * (_e3069 + (2i * _e3028))) + _e3071);
let _e3177 = (_e3175 >> bitcast<u32>(2i));
let _e3180 = bitcast<u32>(((_e3175 & 3i) * 8i));
let _e3182 = select(_e3079, _e3177, (_e3177 < _e3079));
let _e3188 = global_6.member[bitcast<u32>(select(0i, _e3182, (_e3182 > 0i)))];
let _e3192 = (_e3177 + 1i);
let _e3194 = select(_e3079, _e3192, (_e3192 < _e3079));
let _e3200 = global_6.member[bitcast<u32>(select(0i, _e3194, (_e3194 > 0i)))];
let _e3207 = ((_e3188 >> bitcast<u32>((_e3180 & 31u))) | ((_e3200 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3180) & 31u))));
let _e3210 = f32(bitcast<i32>((_e3207 & 65535u)));
phi_5257_ = vec3<f32>(_e3121, (_e3047.y + (_e3059 * ((_e3160 + ((f32(bitcast<i32>((_e3157 >> bitcast<u32>(16i)))) - _e3160) * _e2947)) * _e3117))), (_e3047.z + (_e3059 * ((_e3210 + ((f32(bitcast<i32>((_e3207 >> bitcast<u32>(16i)))) - _e3210) * _e2947)) * _e3117))));
} else {
phi_5257_ = vec3<f32>(_e3121, (_e3047.y + _e3119), (_e3047.z + _e3119));
}
let _e3229 = phi_5257_;
phi_5267_ = _e3229;
} else {
phi_5267_ = vec3<f32>((_e3047.x + _e3059), (_e3047.y + _e3059), (_e3047.z + _e3059));
}
let _e3238 = phi_5267_;
phi_5020_ = (_e3043 + 1i);
phi_5023_ = (_e3045 + _e3059);
phi_5025_ = _e3238;
} else {
phi_5020_ = i32();
phi_5023_ = f32();
phi_5025_ = vec3<f32>();
}
let _e3242 = phi_5020_;
let _e3244 = phi_5023_;
let _e3246 = phi_5025_;
continue;
continuing {
phi_5019_ = _e3242;
phi_5022_ = _e3244;
phi_5024_ = _e3246;
break if !(_e3048);
}
}
let _e5821 = local_114;
phi_5000_ = _e5821;
let _e5824 = local_115;
phi_5003_ = _e5824;
phi_5005_ = (_e3034 + 1i);
} else {
phi_5000_ = f32();
phi_5003_ = vec3<f32>();
phi_5005_ = i32();
}
let _e3250 = phi_5000_;
let _e3252 = phi_5003_;
let _e3254 = phi_5005_;
continue;
continuing {
phi_4999_ = _e3250;
phi_5002_ = _e3252;
phi_5004_ = _e3254;
break if !(_e3035);
}
}
let _e3258 = local_72;
let _e3260 = ((_e2876 == 0i) || (_e3258 <= 0f));
let _e3262 = local_73;
let _e3264 = (1f / select(_e3262, 1f, _e3260));
let _e3266 = local_74;
let _e3271 = local_75;
let _e3276 = local_76;
let _e3287 = global_1.member.member_18.member_1;
let _e3296 = global_1.member.member_19;
if (_e267 == 0f) {
phi_5390_ = vec3<f32>(_e2781, _e2782, _e2783);
} else {
phi_5390_ = _e316;
}
let _e3308 = phi_5390_;
phi_5391_ = _e3308;
phi_5392_ = (_e2745.member_3 * vec3<f32>(((_e3287.member * (select((_e3266.x * _e3264), 1f, _e3260) * _e2813)) + _e3296.member), ((_e3287.member_1 * (select((_e3271.y * _e3264), 1f, _e3260) * _e2813)) + _e3296.member_1), ((_e3287.member_2 * (select((_e3276.z * _e3264), 1f, _e3260) * _e2813)) + _e3296.member_2)));
} else {
phi_5391_ = _e316;
phi_5392_ = _e2230;
}
let _e3310 = phi_5391_;
let _e3312 = phi_5392_;
let _e3319 = local_39;
let _e3321 = local_38;
let _e3322 = ((21i * _e3319) + _e3321);
let _e3324 = select(_e193, _e3322, (_e3322 < _e193));
let _e3329 = global_2.member[bitcast<u32>(select(0i, _e3324, (_e3324 > 0i)))];
local = _e180;
local_1 = _e186;
let _e3330 = local_1;
let _e3332 = local;
let _e3333 = ((9i * _e3330) + _e3332);
let _e3335 = select(_e193, _e3333, (_e3333 < _e193));
let _e3340 = global_2.member[bitcast<u32>(select(0i, _e3335, (_e3335 > 0i)))];
let _e3341 = local_1;
let _e3343 = local;
let _e3344 = ((10i * _e3341) + _e3343);
let _e3346 = select(_e193, _e3344, (_e3344 < _e193));
let _e3351 = global_2.member[bitcast<u32>(select(0i, _e3346, (_e3346 > 0i)))];
let _e3352 = local_1;
let _e3354 = local;
let _e3355 = ((11i * _e3352) + _e3354);
let _e3357 = select(_e193, _e3355, (_e3355 < _e193));
let _e3362 = global_2.member[bitcast<u32>(select(0i, _e3357, (_e3357 > 0i)))];
let _e3368 = (2f * (((_e1070 * _e3340) + (_e1071 * _e3351)) + (_e1072 * _e3362)));
let _e3372 = (_e1070 - (_e3340 * _e3368));
let _e3373 = (_e1071 - (_e3351 * _e3368));
let _e3374 = (_e1072 - (_e3362 * _e3368));
let _e3375 = (_e697 - _e528);
let _e3376 = (_e698 - _e529);
let _e3377 = (_e699 - _e530);
let _e3382 = (((_e3375 * _e3375) + (_e3376 * _e3376)) + (_e3377 * _e3377));
let _e3387 = (_e697 - _e3372);
let _e3388 = (_e698 - _e3373);
let _e3389 = (_e699 - _e3374);
let _e3394 = (((_e3387 * _e3387) + (_e3388 * _e3388)) + (_e3389 * _e3389));
let _e3398 = (_e3372 - _e528);
let _e3399 = (_e3373 - _e529);
let _e3400 = (_e3374 - _e530);
let _e3405 = (((_e3398 * _e3398) + (_e3399 * _e3399)) + (_e3400 * _e3400));
let _e3413 = select(select(_e1083, select(sqrt(select(0f, _e3405, (_e3405 > 0f))), sqrt(select(0f, _e3394, (_e3394 > 0f))), _e621), (_e409 || _e621)), (0.5f * sqrt(select(0f, _e3382, (_e3382 > 0f)))), (_e409 && _e621));
let _e3414 = (_e1047 - _e877);
let _e3415 = (_e1048 - _e878);
let _e3416 = (_e1049 - _e879);
let _e3421 = (((_e3414 * _e3414) + (_e3415 * _e3415)) + (_e3416 * _e3416));
let _e3426 = (_e1047 - _e3372);
let _e3427 = (_e1048 - _e3373);
let _e3428 = (_e1049 - _e3374);
let _e3433 = (((_e3426 * _e3426) + (_e3427 * _e3427)) + (_e3428 * _e3428));
let _e3437 = (_e3372 - _e877);
let _e3438 = (_e3373 - _e878);
let _e3439 = (_e3374 - _e879);
let _e3444 = (((_e3437 * _e3437) + (_e3438 * _e3438)) + (_e3439 * _e3439));
let _e3452 = select(select(_e1083, select(sqrt(select(0f, _e3444, (_e3444 > 0f))), sqrt(select(0f, _e3433, (_e3433 > 0f))), _e970), (_e791 || _e970)), (0.5f * sqrt(select(0f, _e3421, (_e3421 > 0f)))), (_e791 && _e970));
let _e3454 = select(_e3452, _e3413, (_e3413 > _e3452));
let _e3459 = (((_e1169.member * _e3372) + (_e1169.member_1 * _e3373)) + (_e1169.member_2 * _e3374));
let _e3464 = (((_e1181.member * _e3372) + (_e1181.member_1 * _e3373)) + (_e1181.member_2 * _e3374));
let _e3469 = (((_e1193.member * _e3372) + (_e1193.member_1 * _e3373)) + (_e1193.member_2 * _e3374));
if _e1221 {
phi_7177_ = _e1213;
} else {
if (_e1205 == 1u) {
let _e3472 = select(-1f, _e3469, (_e3469 > -1f));
let _e3474 = select(1f, _e3472, (_e3472 < 1f));
if (_e3474 > 0f) {
phi_5792_ = _e1213;
} else {
let _e3479 = global_1.member.member_16.member_9;
phi_5792_ = vec3<f32>(_e3479.member, _e3479.member_1, _e3479.member_2);
}
let _e3485 = phi_5792_;
let _e3494 = bitcast<f32>((bitcast<u32>(_e3474) & 2147483647u));
let _e3497 = sqrt(select(0f, _e3494, (_e3494 > 0f)));
phi_7176_ = vec3<f32>((_e1217.member + ((_e3485.x - _e1217.member) * _e3497)), (_e1217.member_1 + ((_e3485.y - _e1217.member_1) * _e3497)), (_e1217.member_2 + ((_e3485.z - _e1217.member_2) * _e3497)));
} else {
if (_e1205 == 2u) {
let _e3509 = global_1.member.member_16.member_10;
let _e3510 = (_e3454 / _e3509);
let _e3512 = select(1e-4f, _e3510, (_e3510 > 1e-4f));
let _e3515 = bitcast<f32>((bitcast<u32>(_e3459) & 2147483647u));
let _e3518 = bitcast<f32>((bitcast<u32>(_e3464) & 2147483647u));
let _e3522 = select(_e3518, _e3515, (_e3515 > _e3518));
let _e3525 = (select(_e3518, _e3515, (_e3515 < _e3518)) / select(1.1754944e-38f, _e3522, (_e3522 > 1.1754944e-38f)));
let _e3526 = (_e3525 > 0.41421357f);
let _e3530 = select(_e3525, ((_e3525 - 1f) / (_e3525 + 1f)), _e3526);
let _e3531 = (_e3530 * _e3530);
let _e3546 = (select(0f, 0.7853982f, _e3526) + (_e3530 + ((_e3530 * _e3531) * (-0.33333334f + (_e3531 * (0.2f + (_e3531 * (-0.14285713f + (_e3531 * (0.11111111f + (_e3531 * (-0.09090909f + (_e3531 * 0.0585f)))))))))))));
let _e3549 = select(_e3546, (1.5707964f - _e3546), (_e3518 > _e3515));
let _e3552 = select(_e3549, (3.1415927f - _e3549), (_e3459 < 0f));
let _e3558 = (1f - (_e3469 * _e3469));
let _e3561 = sqrt(select(0f, _e3558, (_e3558 > 0f)));
let _e3564 = (_e3512 / select(1e-3f, _e3561, (_e3561 > 1e-3f)));
let _e3565 = ((select(_e3552, -(_e3552), (_e3464 < 0f)) / _e3509) * 0.5f);
let _e3567 = select(-8e6f, _e3565, (_e3565 > -8e6f));
let _e3569 = select(8e6f, _e3567, (_e3567 < 8e6f));
let _e3576 = select(0i, select(select(i32(_e3569), i32(-2147483648), (_e3569 < -2147483600f)), 2147483647i, (_e3569 > 2147483500f)), (_e3569 == _e3569));
let _e3583 = ((_e3565 - f32((_e3576 - select(0i, 1i, (_e3569 < f32(_e3576)))))) * 2f);
let _e3591 = ((select(select((_e3583 - 2f), (1f - _e3583), (_e3583 < 1.5f)), _e3583, (_e3583 < 0.5f)) * 2f) / _e3564);
let _e3593 = select(-1f, _e3591, (_e3591 > -1f));
let _e3596 = (2f - _e3564);
let _e3598 = select(0f, _e3596, (_e3596 > 0f));
let _e3603 = select(-1f, _e3469, (_e3469 > -1f));
let _e3605 = select(1f, _e3603, (_e3603 < 1f));
let _e3608 = ((1f - _e3605) * (1f + _e3605));
let _e3611 = sqrt(select(0f, _e3608, (_e3608 > 0f)));
let _e3614 = bitcast<f32>((bitcast<u32>(_e3611) & 2147483647u));
let _e3617 = bitcast<f32>((bitcast<u32>(_e3605) & 2147483647u));
let _e3621 = select(_e3617, _e3614, (_e3614 > _e3617));
let _e3624 = (select(_e3617, _e3614, (_e3614 < _e3617)) / select(1.1754944e-38f, _e3621, (_e3621 > 1.1754944e-38f)));
let _e3625 = (_e3624 > 0.41421357f);
let _e3629 = select(_e3624, ((_e3624 - 1f) / (_e3624 + 1f)), _e3625);
let _e3630 = (_e3629 * _e3629);
let _e3645 = (select(0f, 0.7853982f, _e3625) + (_e3629 + ((_e3629 * _e3630) * (-0.33333334f + (_e3630 * (0.2f + (_e3630 * (-0.14285713f + (_e3630 * (0.11111111f + (_e3630 * (-0.09090909f + (_e3630 * 0.0585f)))))))))))));
let _e3648 = select(_e3645, (1.5707964f - _e3645), (_e3617 > _e3614));
let _e3651 = select(_e3648, (3.1415927f - _e3648), (_e3611 < 0f));
let _e3656 = ((select(_e3651, -(_e3651), (_e3605 < 0f)) / _e3509) * 0.5f);
let _e3658 = select(-8e6f, _e3656, (_e3656 > -8e6f));
let _e3660 = select(8e6f, _e3658, (_e3658 < 8e6f));
let _e3667 = select(0i, select(select(i32(_e3660), i32(-2147483648), (_e3660 < -2147483600f)), 2147483647i, (_e3660 > 2147483500f)), (_e3660 == _e3660));
let _e3674 = ((_e3656 - f32((_e3667 - select(0i, 1i, (_e3660 < f32(_e3667)))))) * 2f);
let _e3682 = ((select(select((_e3674 - 2f), (1f - _e3674), (_e3674 < 1.5f)), _e3674, (_e3674 < 0.5f)) * 2f) / _e3512);
let _e3684 = select(-1f, _e3682, (_e3682 > -1f));
let _e3687 = (2f - _e3512);
let _e3689 = select(0f, _e3687, (_e3687 > 0f));
let _e3695 = (0.5f + ((0.5f * (select(1f, _e3593, (_e3593 < 1f)) * select(1f, _e3598, (_e3598 < 1f)))) * (select(1f, _e3684, (_e3684 < 1f)) * select(1f, _e3689, (_e3689 < 1f)))));
phi_7175_ = vec3<f32>((_e1209.member + ((_e1217.member - _e1209.member) * _e3695)), (_e1209.member_1 + ((_e1217.member_1 - _e1209.member_1) * _e3695)), (_e1209.member_2 + ((_e1217.member_2 - _e1209.member_2) * _e3695)));
} else {
let _e3709 = global_1.member.member_16.member_1;
let _e3710 = bitcast<i32>(_e3709);
let _e3715 = global_1.member.member_16.member_3;
let _e3717 = f32(bitcast<i32>(_e3715));
let _e3719 = (2f * 3.1415927f);
let _e3720 = ((_e3454 * f32(_e3710)) / _e3719);
let _e3722 = select(1e-6f, _e3720, (_e3720 > 1e-6f));
let _e3725 = bitcast<u32>(select(1.1754944e-38f, _e3722, (_e3722 > 1.1754944e-38f)));
let _e3726 = (_e3725 & 8388607u);
let _e3728 = select(0u, 1u, (_e3726 > 3474675u));
let _e3739 = bitcast<f32>((_e3726 | ((127u - _e3728) << bitcast<u32>(23i))));
let _e3742 = ((_e3739 - 1f) / (_e3739 + 1f));
let _e3743 = (_e3742 * _e3742);
let _e3758 = (f32(((bitcast<i32>((_e3725 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e3728))) + (((2f * _e3742) + ((_e3742 * _e3743) * (0.6666667f + (_e3743 * (0.4f + (_e3743 * (0.2857143f + (_e3743 * (0.22222222f + (_e3743 * 0.18181819f)))))))))) * 1.442695f));
let _e3759 = (_e3717 - 1f);
let _e3761 = select(0f, _e3758, (_e3758 > 0f));
let _e3763 = select(_e3759, _e3761, (_e3761 < _e3759));
let _e3764 = (_e3717 - 2f);
let _e3766 = select(0f, _e3764, (_e3764 > 0f));
let _e3768 = select(0f, _e3763, (_e3763 > 0f));
let _e3770 = select(_e3766, _e3768, (_e3768 < _e3766));
let _e3777 = select(0i, select(select(i32(_e3770), i32(-2147483648), (_e3770 < -2147483600f)), 2147483647i, (_e3770 > 2147483500f)), (_e3770 == _e3770));
let _e3781 = (_e3777 - select(0i, 1i, (_e3770 < f32(_e3777))));
let _e3784 = bitcast<f32>((bitcast<u32>(_e3464) & 2147483647u));
let _e3787 = bitcast<f32>((bitcast<u32>(_e3459) & 2147483647u));
let _e3791 = select(_e3787, _e3784, (_e3784 > _e3787));
let _e3794 = (select(_e3787, _e3784, (_e3784 < _e3787)) / select(1.1754944e-38f, _e3791, (_e3791 > 1.1754944e-38f)));
let _e3795 = (_e3794 > 0.41421357f);
let _e3799 = select(_e3794, ((_e3794 - 1f) / (_e3794 + 1f)), _e3795);
let _e3800 = (_e3799 * _e3799);
let _e3815 = (select(0f, 0.7853982f, _e3795) + (_e3799 + ((_e3799 * _e3800) * (-0.33333334f + (_e3800 * (0.2f + (_e3800 * (-0.14285713f + (_e3800 * (0.11111111f + (_e3800 * (-0.09090909f + (_e3800 * 0.0585f)))))))))))));
let _e3818 = select(_e3815, (1.5707964f - _e3815), (_e3787 > _e3784));
let _e3821 = select(_e3818, (3.1415927f - _e3818), (_e3464 < 0f));
let _e3826 = (0.5f - (select(_e3821, -(_e3821), (_e3459 < 0f)) / _e3719));
let _e3828 = select(-1f, _e3469, (_e3469 > -1f));
let _e3830 = select(1f, _e3828, (_e3828 < 1f));
let _e3833 = ((1f - _e3830) * (1f + _e3830));
let _e3836 = sqrt(select(0f, _e3833, (_e3833 > 0f)));
let _e3839 = bitcast<f32>((bitcast<u32>(_e3836) & 2147483647u));
let _e3842 = bitcast<f32>((bitcast<u32>(_e3830) & 2147483647u));
let _e3846 = select(_e3842, _e3839, (_e3839 > _e3842));
let _e3849 = (select(_e3842, _e3839, (_e3839 < _e3842)) / select(1.1754944e-38f, _e3846, (_e3846 > 1.1754944e-38f)));
let _e3850 = (_e3849 > 0.41421357f);
let _e3854 = select(_e3849, ((_e3849 - 1f) / (_e3849 + 1f)), _e3850);
let _e3855 = (_e3854 * _e3854);
let _e3870 = (select(0f, 0.7853982f, _e3850) + (_e3854 + ((_e3854 * _e3855) * (-0.33333334f + (_e3855 * (0.2f + (_e3855 * (-0.14285713f + (_e3855 * (0.11111111f + (_e3855 * (-0.09090909f + (_e3855 * 0.0585f)))))))))))));
let _e3873 = select(_e3870, (1.5707964f - _e3870), (_e3842 > _e3839));
let _e3876 = select(_e3873, (3.1415927f - _e3873), (_e3836 < 0f));
let _e3881 = (0.5f - (select(_e3876, -(_e3876), (_e3830 < 0f)) / 3.1415927f));
let _e3885 = global_1.member.member_16.member_2;
let _e3886 = bitcast<i32>(_e3885);
phi_6394_ = 0i;
phi_6397_ = 0i;
phi_6399_ = _e3886;
phi_6401_ = _e3710;
loop {
let _e3888 = phi_6394_;
let _e3890 = phi_6397_;
let _e3892 = phi_6399_;
let _e3894 = phi_6401_;
local_77 = _e3894;
local_78 = _e3892;
local_79 = _e3894;
local_80 = _e3894;
local_81 = _e3894;
local_82 = _e3894;
local_83 = _e3894;
local_84 = _e3894;
local_85 = _e3892;
local_86 = _e3892;
local_87 = _e3892;
local_88 = _e3892;
local_89 = _e3894;
local_90 = _e3890;
local_91 = _e3894;
local_92 = _e3890;
let _e3895 = (_e3888 < _e3781);
if _e3895 {
if (_e3894 > 1i) {
phi_6416_ = (_e3894 >> bitcast<u32>(1i));
} else {
phi_6416_ = 1i;
}
let _e3902 = phi_6416_;
if (_e3892 > 1i) {
phi_6422_ = (_e3892 >> bitcast<u32>(1i));
} else {
phi_6422_ = 1i;
}
let _e3907 = phi_6422_;
phi_6395_ = (_e3888 + 1i);
phi_6398_ = (_e3890 + (_e3894 * _e3892));
phi_6400_ = _e3907;
phi_6402_ = _e3902;
} else {
phi_6395_ = i32();
phi_6398_ = i32();
phi_6400_ = i32();
phi_6402_ = i32();
}
let _e3910 = phi_6395_;
let _e3912 = phi_6398_;
let _e3914 = phi_6400_;
let _e3916 = phi_6402_;
continue;
continuing {
phi_6394_ = _e3910;
phi_6397_ = _e3912;
phi_6399_ = _e3914;
phi_6401_ = _e3916;
break if !(_e3895);
}
}
let _e3919 = local_77;
let _e3920 = f32(_e3919);
let _e3922 = ((_e3826 * _e3920) - 0.5f);
let _e3924 = local_78;
let _e3925 = f32(_e3924);
let _e3927 = ((_e3881 * _e3925) - 0.5f);
let _e3929 = select(-1f, _e3922, (_e3922 > -1f));
let _e3931 = select(_e3920, _e3929, (_e3929 < _e3920));
let _e3938 = select(0i, select(select(i32(_e3931), i32(-2147483648), (_e3931 < -2147483600f)), 2147483647i, (_e3931 > 2147483500f)), (_e3931 == _e3931));
let _e3942 = (_e3938 - select(0i, 1i, (_e3931 < f32(_e3938))));
let _e3944 = select(-1f, _e3927, (_e3927 > -1f));
let _e3946 = select(_e3925, _e3944, (_e3944 < _e3925));
let _e3953 = select(0i, select(select(i32(_e3946), i32(-2147483648), (_e3946 < -2147483600f)), 2147483647i, (_e3946 > 2147483500f)), (_e3946 == _e3946));
let _e3957 = (_e3953 - select(0i, 1i, (_e3946 < f32(_e3953))));
let _e3959 = (_e3922 - f32(_e3942));
let _e3961 = (_e3927 - f32(_e3957));
let _e3963 = select(0f, _e3961, (_e3961 > 0f));
let _e3965 = select(1f, _e3963, (_e3963 < 1f));
if (_e3942 < 0i) {
let _e3968 = local_79;
phi_6497_ = (_e3942 + _e3968);
} else {
phi_6497_ = _e3942;
}
let _e3971 = phi_6497_;
let _e3973 = local_80;
if (_e3971 >= _e3973) {
let _e3976 = local_81;
phi_6503_ = (_e3971 - _e3976);
} else {
phi_6503_ = _e3971;
}
let _e3979 = phi_6503_;
let _e3980 = (_e3942 + 1i);
if (_e3980 < 0i) {
let _e3983 = local_82;
phi_6510_ = (_e3980 + _e3983);
} else {
phi_6510_ = _e3980;
}
let _e3986 = phi_6510_;
let _e3988 = local_83;
if (_e3986 >= _e3988) {
let _e3991 = local_84;
phi_6516_ = (_e3986 - _e3991);
} else {
phi_6516_ = _e3986;
}
let _e3994 = phi_6516_;
let _e3996 = select(_e3957, 0i, (_e3957 < 0i));
let _e3998 = local_85;
if (_e3996 >= _e3998) {
let _e4001 = local_86;
phi_6527_ = (_e4001 - 1i);
} else {
phi_6527_ = _e3996;
}
let _e4004 = phi_6527_;
let _e4005 = (_e3957 + 1i);
let _e4007 = select(_e4005, 0i, (_e4005 < 0i));
let _e4009 = local_87;
if (_e4007 >= _e4009) {
let _e4012 = local_88;
phi_6539_ = (_e4012 - 1i);
} else {
phi_6539_ = _e4007;
}
let _e4015 = phi_6539_;
let _e4017 = local_89;
let _e4020 = local_90;
let _e4021 = (_e4020 + (_e4004 * _e4017));
let _e4023 = local_91;
let _e4026 = local_92;
let _e4027 = (_e4026 + (_e4015 * _e4023));
let _e4029 = (3i * (_e4021 + _e3979));
let _e4031 = (bitcast<i32>(_e149) - 1i);
let _e4033 = select(_e4031, _e4029, (_e4029 < _e4031));
let _e4039 = global_3.member[bitcast<u32>(select(0i, _e4033, (_e4033 > 0i)))];
let _e4040 = (_e4029 + 1i);
let _e4042 = select(_e4031, _e4040, (_e4040 < _e4031));
let _e4048 = global_3.member[bitcast<u32>(select(0i, _e4042, (_e4042 > 0i)))];
let _e4049 = (_e4029 + 2i);
let _e4051 = select(_e4031, _e4049, (_e4049 < _e4031));
let _e4057 = global_3.member[bitcast<u32>(select(0i, _e4051, (_e4051 > 0i)))];
let _e4059 = (3i * (_e4021 + _e3994));
let _e4061 = select(_e4031, _e4059, (_e4059 < _e4031));
let _e4067 = global_3.member[bitcast<u32>(select(0i, _e4061, (_e4061 > 0i)))];
let _e4068 = (_e4059 + 1i);
let _e4070 = select(_e4031, _e4068, (_e4068 < _e4031));
let _e4076 = global_3.member[bitcast<u32>(select(0i, _e4070, (_e4070 > 0i)))];
let _e4077 = (_e4059 + 2i);
let _e4079 = select(_e4031, _e4077, (_e4077 < _e4031));
let _e4085 = global_3.member[bitcast<u32>(select(0i, _e4079, (_e4079 > 0i)))];
let _e4087 = (3i * (_e4027 + _e3979));
let _e4089 = select(_e4031, _e4087, (_e4087 < _e4031));
let _e4095 = global_3.member[bitcast<u32>(select(0i, _e4089, (_e4089 > 0i)))];
let _e4096 = (_e4087 + 1i);
let _e4098 = select(_e4031, _e4096, (_e4096 < _e4031));
let _e4104 = global_3.member[bitcast<u32>(select(0i, _e4098, (_e4098 > 0i)))];
let _e4105 = (_e4087 + 2i);
let _e4107 = select(_e4031, _e4105, (_e4105 < _e4031));
let _e4113 = global_3.member[bitcast<u32>(select(0i, _e4107, (_e4107 > 0i)))];
let _e4115 = (3i * (_e4027 + _e3994));
let _e4117 = select(_e4031, _e4115, (_e4115 < _e4031));
let _e4123 = global_3.member[bitcast<u32>(select(0i, _e4117, (_e4117 > 0i)))];
let _e4124 = (_e4115 + 1i);
let _e4126 = select(_e4031, _e4124, (_e4124 < _e4031));
let _e4132 = global_3.member[bitcast<u32>(select(0i, _e4126, (_e4126 > 0i)))];
let _e4133 = (_e4115 + 2i);
let _e4135 = select(_e4031, _e4133, (_e4133 < _e4031));
let _e4141 = global_3.member[bitcast<u32>(select(0i, _e4135, (_e4135 > 0i)))];
let _e4148 = (_e4039 + ((_e4067 - _e4039) * _e3959));
let _e4149 = (_e4048 + ((_e4076 - _e4048) * _e3959));
let _e4150 = (_e4057 + ((_e4085 - _e4057) * _e3959));
let _e4166 = (_e4148 + (((_e4095 + ((_e4123 - _e4095) * _e3959)) - _e4148) * _e3965));
let _e4167 = (_e4149 + (((_e4104 + ((_e4132 - _e4104) * _e3959)) - _e4149) * _e3965));
let _e4168 = (_e4150 + (((_e4113 + ((_e4141 - _e4113) * _e3959)) - _e4150) * _e3965));
phi_6775_ = 0i;
phi_6778_ = 0i;
phi_6780_ = _e3886;
phi_6782_ = _e3710;
loop {
let _e4171 = phi_6775_;
let _e4173 = phi_6778_;
let _e4175 = phi_6780_;
let _e4177 = phi_6782_;
local_93 = _e4177;
local_94 = _e4175;
local_95 = _e4177;
local_96 = _e4177;
local_97 = _e4177;
local_98 = _e4177;
local_99 = _e4177;
local_100 = _e4177;
local_101 = _e4175;
local_102 = _e4175;
local_103 = _e4175;
local_104 = _e4175;
local_105 = _e4177;
local_106 = _e4173;
local_107 = _e4177;
local_108 = _e4173;
let _e4178 = (_e4171 < (_e3781 + 1i));
if _e4178 {
if (_e4177 > 1i) {
phi_6797_ = (_e4177 >> bitcast<u32>(1i));
} else {
phi_6797_ = 1i;
}
let _e4185 = phi_6797_;
if (_e4175 > 1i) {
phi_6803_ = (_e4175 >> bitcast<u32>(1i));
} else {
phi_6803_ = 1i;
}
let _e4190 = phi_6803_;
phi_6776_ = (_e4171 + 1i);
phi_6779_ = (_e4173 + (_e4177 * _e4175));
phi_6781_ = _e4190;
phi_6783_ = _e4185;
} else {
phi_6776_ = i32();
phi_6779_ = i32();
phi_6781_ = i32();
phi_6783_ = i32();
}
let _e4193 = phi_6776_;
let _e4195 = phi_6779_;
let _e4197 = phi_6781_;
let _e4199 = phi_6783_;
continue;
continuing {
phi_6775_ = _e4193;
phi_6778_ = _e4195;
phi_6780_ = _e4197;
phi_6782_ = _e4199;
break if !(_e4178);
}
}
let _e4202 = local_93;
let _e4203 = f32(_e4202);
let _e4205 = ((_e3826 * _e4203) - 0.5f);
let _e4207 = local_94;
let _e4208 = f32(_e4207);
let _e4210 = ((_e3881 * _e4208) - 0.5f);
let _e4212 = select(-1f, _e4205, (_e4205 > -1f));
let _e4214 = select(_e4203, _e4212, (_e4212 < _e4203));
let _e4221 = select(0i, select(select(i32(_e4214), i32(-2147483648), (_e4214 < -2147483600f)), 2147483647i, (_e4214 > 2147483500f)), (_e4214 == _e4214));
let _e4225 = (_e4221 - select(0i, 1i, (_e4214 < f32(_e4221))));
let _e4227 = select(-1f, _e4210, (_e4210 > -1f));
let _e4229 = select(_e4208, _e4227, (_e4227 < _e4208));
let _e4236 = select(0i, select(select(i32(_e4229), i32(-2147483648), (_e4229 < -2147483600f)), 2147483647i, (_e4229 > 2147483500f)), (_e4229 == _e4229));
let _e4240 = (_e4236 - select(0i, 1i, (_e4229 < f32(_e4236))));
let _e4242 = (_e4205 - f32(_e4225));
let _e4244 = (_e4210 - f32(_e4240));
let _e4246 = select(0f, _e4244, (_e4244 > 0f));
let _e4248 = select(1f, _e4246, (_e4246 < 1f));
if (_e4225 < 0i) {
let _e4251 = local_95;
phi_6878_ = (_e4225 + _e4251);
} else {
phi_6878_ = _e4225;
}
let _e4254 = phi_6878_;
let _e4256 = local_96;
if (_e4254 >= _e4256) {
let _e4259 = local_97;
phi_6884_ = (_e4254 - _e4259);
} else {
phi_6884_ = _e4254;
}
let _e4262 = phi_6884_;
let _e4263 = (_e4225 + 1i);
if (_e4263 < 0i) {
let _e4266 = local_98;
phi_6891_ = (_e4263 + _e4266);
} else {
phi_6891_ = _e4263;
}
let _e4269 = phi_6891_;
let _e4271 = local_99;
if (_e4269 >= _e4271) {
let _e4274 = local_100;
phi_6897_ = (_e4269 - _e4274);
} else {
phi_6897_ = _e4269;
}
let _e4277 = phi_6897_;
let _e4279 = select(_e4240, 0i, (_e4240 < 0i));
let _e4281 = local_101;
if (_e4279 >= _e4281) {
let _e4284 = local_102;
phi_6908_ = (_e4284 - 1i);
} else {
phi_6908_ = _e4279;
}
let _e4287 = phi_6908_;
let _e4288 = (_e4240 + 1i);
let _e4290 = select(_e4288, 0i, (_e4288 < 0i));
let _e4292 = local_103;
if (_e4290 >= _e4292) {
let _e4295 = local_104;
phi_6920_ = (_e4295 - 1i);
} else {
phi_6920_ = _e4290;
}
let _e4298 = phi_6920_;
let _e4300 = local_105;
let _e4303 = local_106;
let _e4304 = (_e4303 + (_e4287 * _e4300));
let _e4306 = local_107;
let _e4309 = local_108;
let _e4310 = (_e4309 + (_e4298 * _e4306));
let _e4312 = (3i * (_e4304 + _e4262));
let _e4314 = select(_e4031, _e4312, (_e4312 < _e4031));
let _e4320 = global_3.member[bitcast<u32>(select(0i, _e4314, (_e4314 > 0i)))];
let _e4321 = (_e4312 + 1i);
let _e4323 = select(_e4031, _e4321, (_e4321 < _e4031));
let _e4329 = global_3.member[bitcast<u32>(select(0i, _e4323, (_e4323 > 0i)))];
let _e4330 = (_e4312 + 2i);
let _e4332 = select(_e4031, _e4330, (_e4330 < _e4031));
let _e4338 = global_3.member[bitcast<u32>(select(0i, _e4332, (_e4332 > 0i)))];
let _e4340 = (3i * (_e4304 + _e4277));
let _e4342 = select(_e4031, _e4340, (_e4340 < _e4031));
let _e4348 = global_3.member[bitcast<u32>(select(0i, _e4342, (_e4342 > 0i)))];
let _e4349 = (_e4340 + 1i);
let _e4351 = select(_e4031, _e4349, (_e4349 < _e4031));
let _e4357 = global_3.member[bitcast<u32>(select(0i, _e4351, (_e4351 > 0i)))];
let _e4358 = (_e4340 + 2i);
let _e4360 = select(_e4031, _e4358, (_e4358 < _e4031));
let _e4366 = global_3.member[bitcast<u32>(select(0i, _e4360, (_e4360 > 0i)))];
let _e4368 = (3i * (_e4310 + _e4262));
let _e4370 = select(_e4031, _e4368, (_e4368 < _e4031));
let _e4376 = global_3.member[bitcast<u32>(select(0i, _e4370, (_e4370 > 0i)))];
let _e4377 = (_e4368 + 1i);
let _e4379 = select(_e4031, _e4377, (_e4377 < _e4031));
let _e4385 = global_3.member[bitcast<u32>(select(0i, _e4379, (_e4379 > 0i)))];
let _e4386 = (_e4368 + 2i);
let _e4388 = select(_e4031, _e4386, (_e4386 < _e4031));
let _e4394 = global_3.member[bitcast<u32>(select(0i, _e4388, (_e4388 > 0i)))];
let _e4396 = (3i * (_e4310 + _e4277));
let _e4398 = select(_e4031, _e4396, (_e4396 < _e4031));
let _e4404 = global_3.member[bitcast<u32>(select(0i, _e4398, (_e4398 > 0i)))];
let _e4405 = (_e4396 + 1i);
let _e4407 = select(_e4031, _e4405, (_e4405 < _e4031));
let _e4413 = global_3.member[bitcast<u32>(select(0i, _e4407, (_e4407 > 0i)))];
let _e4414 = (_e4396 + 2i);
let _e4416 = select(_e4031, _e4414, (_e4414 < _e4031));
let _e4422 = global_3.member[bitcast<u32>(select(0i, _e4416, (_e4416 > 0i)))];
let _e4429 = (_e4320 + ((_e4348 - _e4320) * _e4242));
let _e4430 = (_e4329 + ((_e4357 - _e4329) * _e4242));
let _e4431 = (_e4338 + ((_e4366 - _e4338) * _e4242));
let _e4454 = (_e3763 - f32(_e3781));
let _e4456 = select(0f, _e4454, (_e4454 > 0f));
let _e4458 = select(1f, _e4456, (_e4456 < 1f));
let _e4468 = global_1.member.member_16.member_11;
phi_7175_ = vec3<f32>(((_e4166 + (((_e4429 + (((_e4376 + ((_e4404 - _e4376) * _e4242)) - _e4429) * _e4248)) - _e4166) * _e4458)) * _e4468), ((_e4167 + (((_e4430 + (((_e4385 + ((_e4413 - _e4385) * _e4242)) - _e4430) * _e4248)) - _e4167) * _e4458)) * _e4468), ((_e4168 + (((_e4431 + (((_e4394 + ((_e4422 - _e4394) * _e4242)) - _e4431) * _e4248)) - _e4168) * _e4458)) * _e4468));
}
let _e4474 = phi_7175_;
phi_7176_ = _e4474;
}
let _e4476 = phi_7176_;
phi_7177_ = _e4476;
}
let _e4478 = phi_7177_;
if (_e279 && (_e3329 > 0f)) {
let _e4481 = local_39;
let _e4483 = local_38;
let _e4484 = ((2i * _e4481) + _e4483);
let _e4486 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e4488 = select(_e4486, _e4484, (_e4484 < _e4486));
let _e4493 = global_7.member[bitcast<u32>(select(0i, _e4488, (_e4488 > 0i)))];
let _e4500 = select(0i, select(select(i32(_e4493), i32(-2147483648), (_e4493 < -2147483600f)), 2147483647i, (_e4493 > 2147483500f)), (_e4493 == _e4493));
if (_e4500 != -1i) {
let _e4502 = local_39;
let _e4504 = local_38;
let _e4505 = ((20i * _e4502) + _e4504);
let _e4507 = select(_e193, _e4505, (_e4505 < _e193));
let _e4512 = global_2.member[bitcast<u32>(select(0i, _e4507, (_e4507 > 0i)))];
let _e4513 = (1f - _e458);
let _e4519 = global_1.member.member_10;
let _e4532 = local_39;
let _e4534 = local_38;
let _e4535 = ((3i * _e4532) + _e4534);
let _e4537 = select(_e4486, _e4535, (_e4535 < _e4486));
let _e4542 = global_7.member[bitcast<u32>(select(0i, _e4537, (_e4537 > 0i)))];
let _e4546 = (((_e4519.member + (_e1050 * _e4513)) + (_e1070 * _e4512)) + (_e3372 * _e4542));
let _e4547 = (((_e4519.member_1 + (_e1051 * _e4513)) + (_e1071 * _e4512)) + (_e3373 * _e4542));
let _e4548 = (((_e4519.member_2 + (_e1052 * _e4513)) + (_e1072 * _e4512)) + (_e3374 * _e4542));
let _e4549 = vec3<f32>(_e4546, _e4547, _e4548);
if (_e4500 < 0i) {
let _e4551 = (_e4500 == -3i);
let _e4557 = global_1.member.member_17.member_1.member.member;
let _e4562 = global_1.member.member_17.member_1.member_1;
let _e4568 = global_1.member.member_17.member.member.member;
let _e4573 = global_1.member.member_17.member.member_1;
let _e4583 = vec3<f32>(select(_e4568.member, _e4557.member, _e4551), select(_e4568.member_1, _e4557.member_1, _e4551), select(_e4568.member_2, _e4557.member_2, _e4551));
phi_8152_ = type_21(_e4549, _e4583, _e4583, vec3<f32>(select(_e4573.member, _e4562.member, _e4551), select(_e4573.member_1, _e4562.member_1, _e4551), select(_e4573.member_2, _e4562.member_2, _e4551)), 0f, false);
} else {
let _e4595 = (_e4500 * 19i);
let _e4597 = (bitcast<i32>(_e151) - 1i);
let _e4599 = select(_e4597, _e4595, (_e4595 < _e4597));
let _e4605 = global_4.member[bitcast<u32>(select(0i, _e4599, (_e4599 > 0i)))];
let _e4606 = (_e4595 + 1i);
let _e4608 = select(_e4597, _e4606, (_e4606 < _e4597));
let _e4614 = global_4.member[bitcast<u32>(select(0i, _e4608, (_e4608 > 0i)))];
let _e4615 = (_e4595 + 2i);
let _e4617 = select(_e4597, _e4615, (_e4615 < _e4597));
let _e4623 = global_4.member[bitcast<u32>(select(0i, _e4617, (_e4617 > 0i)))];
let _e4624 = (_e4595 + 3i);
let _e4626 = select(_e4597, _e4624, (_e4624 < _e4597));
let _e4632 = global_4.member[bitcast<u32>(select(0i, _e4626, (_e4626 > 0i)))];
let _e4633 = (_e4595 + 4i);
let _e4635 = select(_e4597, _e4633, (_e4633 < _e4597));
let _e4641 = global_4.member[bitcast<u32>(select(0i, _e4635, (_e4635 > 0i)))];
let _e4642 = (_e4595 + 5i);
let _e4644 = select(_e4597, _e4642, (_e4642 < _e4597));
let _e4650 = global_4.member[bitcast<u32>(select(0i, _e4644, (_e4644 > 0i)))];
let _e4651 = (_e4595 + 6i);
let _e4653 = select(_e4597, _e4651, (_e4651 < _e4597));
let _e4659 = global_4.member[bitcast<u32>(select(0i, _e4653, (_e4653 > 0i)))];
let _e4660 = (_e4595 + 7i);
let _e4662 = select(_e4597, _e4660, (_e4660 < _e4597));
let _e4668 = global_4.member[bitcast<u32>(select(0i, _e4662, (_e4662 > 0i)))];
let _e4669 = (_e4595 + 8i);
let _e4671 = select(_e4597, _e4669, (_e4669 < _e4597));
let _e4677 = global_4.member[bitcast<u32>(select(0i, _e4671, (_e4671 > 0i)))];
let _e4678 = (_e4632 - _e4605);
let _e4679 = (_e4641 - _e4614);
let _e4680 = (_e4650 - _e4623);
let _e4681 = (_e4659 - _e4605);
let _e4682 = (_e4668 - _e4614);
let _e4683 = (_e4677 - _e4623);
let _e4686 = ((_e4679 * _e4683) - (_e4680 * _e4682));
let _e4689 = ((_e4680 * _e4681) - (_e4678 * _e4683));
let _e4692 = ((_e4678 * _e4682) - (_e4679 * _e4681));
let _e4693 = (_e4632 - _e4546);
let _e4694 = (_e4641 - _e4547);
let _e4695 = (_e4650 - _e4548);
let _e4696 = (_e4659 - _e4546);
let _e4697 = (_e4668 - _e4547);
let _e4698 = (_e4677 - _e4548);
let _e4712 = (((((_e4694 * _e4698) - (_e4695 * _e4697)) * _e4686) + (((_e4695 * _e4696) - (_e4693 * _e4698)) * _e4689)) + (((_e4693 * _e4697) - (_e4694 * _e4696)) * _e4692));
let _e4714 = select(0f, _e4712, (_e4712 > 0f));
let _e4715 = (_e4605 - _e4546);
let _e4716 = (_e4614 - _e4547);
let _e4717 = (_e4623 - _e4548);
let _e4731 = (((((_e4697 * _e4717) - (_e4698 * _e4716)) * _e4686) + (((_e4698 * _e4715) - (_e4696 * _e4717)) * _e4689)) + (((_e4696 * _e4716) - (_e4697 * _e4715)) * _e4692));
let _e4733 = select(0f, _e4731, (_e4731 > 0f));
let _e4747 = (((((_e4716 * _e4695) - (_e4717 * _e4694)) * _e4686) + (((_e4717 * _e4693) - (_e4715 * _e4695)) * _e4689)) + (((_e4715 * _e4694) - (_e4716 * _e4693)) * _e4692));
let _e4749 = select(0f, _e4747, (_e4747 > 0f));
let _e4751 = ((_e4714 + _e4733) + _e4749);
let _e4753 = select(1e-30f, _e4751, (_e4751 > 1e-30f));
let _e4754 = (_e4714 / _e4753);
let _e4755 = (_e4733 / _e4753);
let _e4756 = (_e4749 / _e4753);
let _e4761 = (((_e4686 * _e4686) + (_e4689 * _e4689)) + (_e4692 * _e4692));
let _e4764 = sqrt(select(0f, _e4761, (_e4761 > 0f)));
let _e4767 = (1f / select(1e-20f, _e4764, (_e4764 > 1e-20f)));
let _e4772 = (_e4595 + 9i);
let _e4774 = select(_e4597, _e4772, (_e4772 < _e4597));
let _e4780 = global_4.member[bitcast<u32>(select(0i, _e4774, (_e4774 > 0i)))];
let _e4781 = (_e4595 + 10i);
let _e4783 = select(_e4597, _e4781, (_e4781 < _e4597));
let _e4789 = global_4.member[bitcast<u32>(select(0i, _e4783, (_e4783 > 0i)))];
let _e4790 = (_e4595 + 11i);
let _e4792 = select(_e4597, _e4790, (_e4790 < _e4597));
let _e4798 = global_4.member[bitcast<u32>(select(0i, _e4792, (_e4792 > 0i)))];
let _e4802 = (_e4595 + 12i);
let _e4804 = select(_e4597, _e4802, (_e4802 < _e4597));
let _e4810 = global_4.member[bitcast<u32>(select(0i, _e4804, (_e4804 > 0i)))];
let _e4811 = (_e4595 + 13i);
let _e4813 = select(_e4597, _e4811, (_e4811 < _e4597));
let _e4819 = global_4.member[bitcast<u32>(select(0i, _e4813, (_e4813 > 0i)))];
let _e4820 = (_e4595 + 14i);
let _e4822 = select(_e4597, _e4820, (_e4820 < _e4597));
let _e4828 = global_4.member[bitcast<u32>(select(0i, _e4822, (_e4822 > 0i)))];
let _e4835 = (_e4595 + 15i);
let _e4837 = select(_e4597, _e4835, (_e4835 < _e4597));
let _e4843 = global_4.member[bitcast<u32>(select(0i, _e4837, (_e4837 > 0i)))];
let _e4844 = (_e4595 + 16i);
let _e4846 = select(_e4597, _e4844, (_e4844 < _e4597));
let _e4852 = global_4.member[bitcast<u32>(select(0i, _e4846, (_e4846 > 0i)))];
let _e4853 = (_e4595 + 17i);
let _e4855 = select(_e4597, _e4853, (_e4853 < _e4597));
let _e4861 = global_4.member[bitcast<u32>(select(0i, _e4855, (_e4855 > 0i)))];
let _e4865 = (((_e4780 * _e4754) + (_e4810 * _e4755)) + (_e4843 * _e4756));
let _e4866 = (((_e4789 * _e4754) + (_e4819 * _e4755)) + (_e4852 * _e4756));
let _e4867 = (((_e4798 * _e4754) + (_e4828 * _e4755)) + (_e4861 * _e4756));
let _e4872 = (((_e4865 * _e4865) + (_e4866 * _e4866)) + (_e4867 * _e4867));
let _e4875 = sqrt(select(0f, _e4872, (_e4872 > 0f)));
let _e4878 = (1f / select(1e-20f, _e4875, (_e4875 > 1e-20f)));
let _e4885 = global_1.member.member_1;
let _e4888 = (_e4595 + 18i);
let _e4890 = select(_e4597, _e4888, (_e4888 < _e4597));
let _e4896 = global_4.member[bitcast<u32>(select(0i, _e4890, (_e4890 > 0i)))];
let _e4905 = (select(select(0i, select(select(i32(_e4896), i32(-2147483648), (_e4896 < -2147483600f)), 2147483647i, (_e4896 > 2147483500f)), (_e4896 == _e4896)), _e4500, ((_e4885 & 4u) != 0u)) * 10i);
let _e4907 = (bitcast<i32>(_e153) - 1i);
let _e4909 = select(_e4907, _e4905, (_e4905 < _e4907));
let _e4915 = global_5.member[bitcast<u32>(select(0i, _e4909, (_e4909 > 0i)))];
let _e4916 = (_e4905 + 1i);
let _e4918 = select(_e4907, _e4916, (_e4916 < _e4907));
let _e4924 = global_5.member[bitcast<u32>(select(0i, _e4918, (_e4918 > 0i)))];
let _e4925 = (_e4905 + 2i);
let _e4927 = select(_e4907, _e4925, (_e4925 < _e4907));
let _e4933 = global_5.member[bitcast<u32>(select(0i, _e4927, (_e4927 > 0i)))];
let _e4937 = (_e4905 + 3i);
let _e4939 = select(_e4907, _e4937, (_e4937 < _e4907));
let _e4945 = global_5.member[bitcast<u32>(select(0i, _e4939, (_e4939 > 0i)))];
let _e4946 = (_e4905 + 4i);
let _e4948 = select(_e4907, _e4946, (_e4946 < _e4907));
let _e4954 = global_5.member[bitcast<u32>(select(0i, _e4948, (_e4948 > 0i)))];
let _e4955 = (_e4905 + 5i);
let _e4957 = select(_e4907, _e4955, (_e4955 < _e4907));
let _e4963 = global_5.member[bitcast<u32>(select(0i, _e4957, (_e4957 > 0i)))];
let _e4970 = (_e4905 + 6i);
let _e4972 = select(_e4907, _e4970, (_e4970 < _e4907));
let _e4978 = global_5.member[bitcast<u32>(select(0i, _e4972, (_e4972 > 0i)))];
let _e4979 = (_e4905 + 7i);
let _e4981 = select(_e4907, _e4979, (_e4979 < _e4907));
let _e4987 = global_5.member[bitcast<u32>(select(0i, _e4981, (_e4981 > 0i)))];
let _e4988 = (_e4905 + 8i);
let _e4990 = select(_e4907, _e4988, (_e4988 < _e4907));
let _e4996 = global_5.member[bitcast<u32>(select(0i, _e4990, (_e4990 > 0i)))];
let _e5004 = (_e4905 + 9i);
let _e5006 = select(_e4907, _e5004, (_e5004 < _e4907));
let _e5012 = global_5.member[bitcast<u32>(select(0i, _e5006, (_e5006 > 0i)))];
phi_8152_ = type_21(_e4549, vec3<f32>((_e4686 * _e4767), (_e4689 * _e4767), (_e4692 * _e4767)), vec3<f32>((_e4865 * _e4878), (_e4866 * _e4878), (_e4867 * _e4878)), vec3<f32>((((_e4915 * _e4754) + (_e4945 * _e4755)) + (_e4978 * _e4756)), (((_e4924 * _e4754) + (_e4954 * _e4755)) + (_e4987 * _e4756)), (((_e4933 * _e4754) + (_e4963 * _e4755)) + (_e4996 * _e4756))), _e5012, true);
}
let _e5015 = phi_8152_;
let _e5024 = (((_e5015.member_1.x * _e3372) + (_e5015.member_1.y * _e3373)) + (_e5015.member_1.z * _e3374));
let _e5026 = select(1f, -1f, (_e5024 > 0f));
let _e5038 = select(_e5026, -(_e5026), ((((_e5015.member_2.x * _e5015.member_1.x) + (_e5015.member_2.y * _e5015.member_1.y)) + (_e5015.member_2.z * _e5015.member_1.z)) < 0f));
let _e5039 = (_e5015.member_2.x * _e5038);
let _e5040 = (_e5015.member_2.y * _e5038);
let _e5041 = (_e5015.member_2.z * _e5038);
let _e5050 = ((((_e5039 * _e3372) + (_e5040 * _e3373)) + (_e5041 * _e3374)) > 0f);
let _e5057 = global_1.member.member_18.member;
let _e5066 = -((((select(_e5039, (_e5015.member_1.x * _e5026), _e5050) * _e5057.member) + (select(_e5040, (_e5015.member_1.y * _e5026), _e5050) * _e5057.member_1)) + (select(_e5041, (_e5015.member_1.z * _e5026), _e5050) * _e5057.member_2)));
let _e5072 = -((((_e5015.member_1.x * _e5057.member) + (_e5015.member_1.y * _e5057.member_1)) + (_e5015.member_1.z * _e5057.member_2)));
let _e5078 = -(_e5066);
let _e5083 = select((select(0f, _e5078, (_e5078 > 0f)) * _e5015.member_4), select(0f, _e5066, (_e5066 > 0f)), ((_e5072 * -(_e5024)) > 0f));
let _e5084 = -(_e5072);
let _e5086 = select(_e5084, _e5072, (_e5072 > _e5084));
let _e5088 = select(1f, _e5086, (_e5086 < 1f));
let _e5092 = (1f - (_e5088 * _e5088));
let _e5099 = global_1.member.member_20.member_5;
let _e5106 = global_1.member.member_20.member_6;
let _e5108 = (select(1f, -1f, (_e5072 < 0f)) * ((((1.4142135f * _e5099) * sqrt(select(0f, _e5092, (_e5092 > 0f)))) + _e5088) * _e5106));
let _e5113 = select(0f, 1f, _e5015.member_5);
let _e5119 = (_e5015.member.x + ((_e5015.member_1.x * _e5108) * _e5113));
let _e5121 = (_e5015.member.y + ((_e5015.member_1.y * _e5108) * _e5113));
let _e5123 = (_e5015.member.z + ((_e5015.member_1.z * _e5108) * _e5113));
let _e5128 = global_1.member.member_20.member.member;
let _e5129 = bitcast<i32>(_e5128);
let _e5134 = global_1.member.member_20.member.member_1;
let _e5135 = bitcast<i32>(_e5134);
let _e5140 = global_1.member.member_20.member.member_2;
let _e5141 = bitcast<i32>(_e5140);
let _e5145 = global_1.member.member_20.member_1;
let _e5146 = bitcast<i32>(_e5145);
let _e5150 = global_1.member.member_20.member_2;
let _e5161 = ((((_e5150.member.member * _e5119) + (_e5150.member.member_1 * _e5121)) + (_e5150.member.member_2 * _e5123)) + _e5150.member_1);
let _e5165 = global_1.member.member_20.member_3;
let _e5177 = (((((_e5165.member.member * _e5119) + (_e5165.member.member_1 * _e5121)) + (_e5165.member.member_2 * _e5123)) + _e5165.member_1) - 0.5f);
let _e5181 = global_1.member.member_20.member_4;
let _e5193 = (((((_e5181.member.member * _e5119) + (_e5181.member.member_1 * _e5121)) + (_e5181.member.member_2 * _e5123)) + _e5181.member_1) - 0.5f);
let _e5195 = f32((_e5129 - 1i));
let _e5197 = select(0f, _e5161, (_e5161 > 0f));
let _e5199 = select(_e5195, _e5197, (_e5197 < _e5195));
let _e5206 = select(0i, select(select(i32(_e5199), i32(-2147483648), (_e5199 < -2147483600f)), 2147483647i, (_e5199 > 2147483500f)), (_e5199 == _e5199));
let _e5210 = (_e5206 - select(0i, 1i, (_e5199 < f32(_e5206))));
let _e5214 = (_e5161 - f32(_e5210));
let _e5217 = select(1f, select(0f, _e5214, (_e5214 > 0f)), (_e5161 < f32(_e5129)));
let _e5218 = (_e5177 - _e5099);
let _e5219 = -(16f);
let _e5220 = f32(_e5135);
let _e5222 = select(_e5219, _e5218, (_e5218 > _e5219));
let _e5224 = select(_e5220, _e5222, (_e5222 < _e5220));
let _e5231 = select(0i, select(select(i32(_e5224), i32(-2147483648), (_e5224 < -2147483600f)), 2147483647i, (_e5224 > 2147483500f)), (_e5224 == _e5224));
let _e5237 = (_e5177 + _e5099);
let _e5240 = (f32((_e5135 - 1i)) + 16f);
let _e5242 = select(-1f, _e5237, (_e5237 > -1f));
let _e5244 = select(_e5240, _e5242, (_e5242 < _e5240));
let _e5251 = select(0i, select(select(i32(_e5244), i32(-2147483648), (_e5244 < -2147483600f)), 2147483647i, (_e5244 > 2147483500f)), (_e5244 == _e5244));
let _e5256 = (_e5193 - _e5099);
let _e5257 = f32(_e5141);
let _e5259 = select(_e5219, _e5256, (_e5256 > _e5219));
let _e5261 = select(_e5257, _e5259, (_e5259 < _e5257));
let _e5268 = select(0i, select(select(i32(_e5261), i32(-2147483648), (_e5261 < -2147483600f)), 2147483647i, (_e5261 > 2147483500f)), (_e5261 == _e5261));
let _e5274 = (_e5193 + _e5099);
let _e5277 = (f32((_e5141 - 1i)) + 16f);
let _e5279 = select(-1f, _e5274, (_e5274 > -1f));
let _e5281 = select(_e5277, _e5279, (_e5279 < _e5277));
let _e5288 = select(0i, select(select(i32(_e5281), i32(-2147483648), (_e5281 < -2147483600f)), 2147483647i, (_e5281 > 2147483500f)), (_e5281 == _e5281));
let _e5296 = bitcast<i32>(((_e5128 + 2u) >> bitcast<u32>(1i)));
let _e5298 = ((_e5135 * _e5141) * _e5296);
phi_8545_ = 0f;
phi_8548_ = vec3<f32>(0f, 0f, 0f);
phi_8550_ = ((_e5268 - select(0i, 1i, (_e5261 < f32(_e5268)))) + 1i);
loop {
let _e5300 = phi_8545_;
let _e5302 = phi_8548_;
let _e5304 = phi_8550_;
local_109 = _e5300;
local_110 = _e5300;
local_111 = _e5302;
local_112 = _e5302;
local_113 = _e5302;
let _e5305 = (_e5304 <= (_e5288 - select(0i, 1i, (_e5281 < f32(_e5288)))));
if _e5305 {
let _e5311 = (_e5099 - bitcast<f32>((bitcast<u32>((f32(_e5304) - _e5193)) & 2147483647u)));
phi_8565_ = ((_e5231 - select(0i, 1i, (_e5224 < f32(_e5231)))) + 1i);
phi_8568_ = _e5300;
phi_8570_ = _e5302;
loop {
let _e5313 = phi_8565_;
let _e5315 = phi_8568_;
let _e5317 = phi_8570_;
local_116 = _e5315;
local_117 = _e5317;
let _e5318 = (_e5313 <= (_e5251 - select(0i, 1i, (_e5244 < f32(_e5251)))));
if _e5318 {
let _e5324 = (_e5099 - bitcast<f32>((bitcast<u32>((f32(_e5313) - _e5177)) & 2147483647u)));
let _e5329 = (select(0f, _e5324, (_e5324 > 0f)) * select(0f, _e5311, (_e5311 > 0f)));
if ((((_e5313 >= 0i) && (_e5313 < _e5135)) && (_e5304 >= 0i)) && (_e5304 < _e5141)) {
let _e5339 = (((_e5304 * _e5135) + _e5313) * _e5296);
let _e5341 = (2i * _e5210);
let _e5342 = ((4i * _e5339) + _e5341);
let _e5344 = (_e5342 >> bitcast<u32>(2i));
let _e5347 = bitcast<u32>(((_e5342 & 3i) * 8i));
let _e5349 = (bitcast<i32>(_e155) - 1i);
let _e5351 = select(_e5349, _e5344, (_e5344 < _e5349));
let _e5357 = global_6.member[bitcast<u32>(select(0i, _e5351, (_e5351 > 0i)))];
let _e5361 = (_e5344 + 1i);
let _e5363 = select(_e5349, _e5361, (_e5361 < _e5349));
let _e5369 = global_6.member[bitcast<u32>(select(0i, _e5363, (_e5363 > 0i)))];
let _e5376 = ((_e5357 >> bitcast<u32>((_e5347 & 31u))) | ((_e5369 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5347) & 31u))));
let _e5379 = f32(bitcast<i32>((_e5376 & 65535u)));
let _e5387 = (1f / 65535f);
let _e5389 = (_e5329 * ((_e5379 + ((f32(bitcast<i32>((_e5376 >> bitcast<u32>(16i)))) - _e5379) * _e5217)) * _e5387));
let _e5391 = (_e5317.x + _e5389);
if (_e5146 > 1i) {
let _e5395 = ((4i * (_e5339 + _e5298)) + _e5341);
let _e5397 = (_e5395 >> bitcast<u32>(2i));
let _e5400 = bitcast<u32>(((_e5395 & 3i) * 8i));
let _e5402 = select(_e5349, _e5397, (_e5397 < _e5349));
let _e5408 = global_6.member[bitcast<u32>(select(0i, _e5402, (_e5402 > 0i)))];
let _e5412 = (_e5397 + 1i);
let _e5414 = select(_e5349, _e5412, (_e5412 < _e5349));
let _e5420 = global_6.member[bitcast<u32>(select(0i, _e5414, (_e5414 > 0i)))];
let _e5427 = ((_e5408 >> bitcast<u32>((_e5400 & 31u))) | ((_e5420 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5400) & 31u))));
let _e5430 = f32(bitcast<i32>((_e5427 & 65535u)));
let _e5445 = ((4i * (_e5339 + (2i * _e5298))) + _e5341);
let _e5447 = (_e5445 >> bitcast<u32>(2i));
let _e5450 = bitcast<u32>(((_e5445 & 3i) * 8i));
let _e5452 = select(_e5349, _e5447, (_e5447 < _e5349));
let _e5458 = global_6.member[bitcast<u32>(select(0i, _e5452, (_e5452 > 0i)))];
let _e5462 = (_e5447 + 1i);
let _e5464 = select(_e5349, _e5462, (_e5462 < _e5349));
let _e5470 = global_6.member[bitcast<u32>(select(0i, _e5464, (_e5464 > 0i)))];
let _e5477 = ((_e5458 >> bitcast<u32>((_e5450 & 31u))) | ((_e5470 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5450) & 31u))));
let _e5480 = f32(bitcast<i32>((_e5477 & 65535u)));
phi_8803_ = vec3<f32>(_e5391, (_e5317.y + (_e5329 * ((_e5430 + ((f32(bitcast<i32>((_e5427 >> bitcast<u32>(16i)))) - _e5430) * _e5217)) * _e5387))), (_e5317.z + (_e5329 * ((_e5480 + ((f32(bitcast<i32>((_e5477 >> bitcast<u32>(16i)))) - _e5480) * _e5217)) * _e5387))));
} else {
phi_8803_ = vec3<f32>(_e5391, (_e5317.y + _e5389), (_e5317.z + _e5389));
}
let _e5499 = phi_8803_;
phi_8813_ = _e5499;
} else {
phi_8813_ = vec3<f32>((_e5317.x + _e5329), (_e5317.y + _e5329), (_e5317.z + _e5329));
}
let _e5508 = phi_8813_;
phi_8566_ = (_e5313 + 1i);
phi_8569_ = (_e5315 + _e5329);
phi_8571_ = _e5508;
} else {
phi_8566_ = i32();
phi_8569_ = f32();
phi_8571_ = vec3<f32>();
}
let _e5512 = phi_8566_;
let _e5514 = phi_8569_;
let _e5516 = phi_8571_;
continue;
continuing {
phi_8565_ = _e5512;
phi_8568_ = _e5514;
phi_8570_ = _e5516;
break if !(_e5318);
}
}
let _e5916 = local_116;
phi_8546_ = _e5916;
let _e5919 = local_117;
phi_8549_ = _e5919;
phi_8551_ = (_e5304 + 1i);
} else {
phi_8546_ = f32();
phi_8549_ = vec3<f32>();
phi_8551_ = i32();
}
let _e5520 = phi_8546_;
let _e5522 = phi_8549_;
let _e5524 = phi_8551_;
continue;
continuing {
phi_8545_ = _e5520;
phi_8548_ = _e5522;
phi_8550_ = _e5524;
break if !(_e5305);
}
}
let _e5528 = local_109;
let _e5530 = ((_e5146 == 0i) || (_e5528 <= 0f));
let _e5532 = local_110;
let _e5534 = (1f / select(_e5532, 1f, _e5530));
let _e5536 = local_111;
let _e5541 = local_112;
let _e5546 = local_113;
let _e5557 = global_1.member.member_18.member_1;
let _e5566 = global_1.member.member_19;
phi_8866_ = (_e5015.member_3 * vec3<f32>(((_e5557.member * (select((_e5536.x * _e5534), 1f, _e5530) * _e5083)) + _e5566.member), ((_e5557.member_1 * (select((_e5541.y * _e5534), 1f, _e5530) * _e5083)) + _e5566.member_1), ((_e5557.member_2 * (select((_e5546.z * _e5534), 1f, _e5530) * _e5083)) + _e5566.member_2)));
} else {
phi_8866_ = _e4478;
}
let _e5576 = phi_8866_;
phi_8867_ = _e5576;
} else {
phi_8867_ = _e4478;
}
let _e5578 = phi_8867_;
let _e5585 = (_e1162 || _e281);
let _e5589 = global_1.member.member_16.member_12;
let _e5590 = select(_e5589, 1f, _e5585);
let _e5599 = global_1.member.member_11;
let _e5600 = local_39;
let _e5602 = local_38;
let _e5603 = ((20i * _e5600) + _e5602);
let _e5605 = select(_e193, _e5603, (_e5603 < _e193));
let _e5610 = global_2.member[bitcast<u32>(select(0i, _e5605, (_e5605 > 0i)))];
let _e5637 = local_39;
let _e5639 = local_38;
let _e5640 = ((19i * _e5637) + _e5639);
let _e5642 = select(_e193, _e5640, (_e5640 < _e193));
let _e5647 = global_2.member[bitcast<u32>(select(0i, _e5642, (_e5642 > 0i)))];
global_8.member[_e170] = (((_e3312.x * _e234) + (_e5578.x * _e3329)) * _e5590);
global_8.member[(_e168 + _e170)] = (((_e3312.y * _e245) + (_e5578.y * _e3329)) * _e5590);
global_8.member[((2u * _e168) + _e170)] = (((_e3312.z * _e256) + (_e5578.z * _e3329)) * _e5590);
global_8.member[((3u * _e168) + _e170)] = _e5590;
global_8.member[((4u * _e168) + _e170)] = (((_e434.member * _e3310.x) + (_e434.member_1 * _e3310.y)) + (_e434.member_2 * _e3310.z));
global_8.member[((5u * _e168) + _e170)] = (((_e443.member * _e3310.x) + (_e443.member_1 * _e3310.y)) + (_e443.member_2 * _e3310.z));
global_8.member[((6u * _e168) + _e170)] = -((((_e461.member * _e3310.x) + (_e461.member_1 * _e3310.y)) + (_e461.member_2 * _e3310.z)));
global_8.member[((7u * _e168) + _e170)] = _e267;
global_8.member[((8u * _e168) + _e170)] = (_e5647 * _e5599);
global_8.member[((9u * _e168) + _e170)] = select(0f, ((_e5610 * _e5599) * (((_e461.member * _e1070) + (_e461.member_1 * _e1071)) + (_e461.member_2 * _e1072))), _e5585);
global_8.member[((10u * _e168) + _e170)] = (((_e434.member * _e200) + (_e434.member_1 * _e211)) + (_e434.member_2 * _e222));
global_8.member[((11u * _e168) + _e170)] = (((_e443.member * _e200) + (_e443.member_1 * _e211)) + (_e443.member_2 * _e222));
global_8.member[((12u * _e168) + _e170)] = -((((_e461.member * _e200) + (_e461.member_1 * _e211)) + (_e461.member_2 * _e222)));
global_8.member[((13u * _e168) + _e170)] = _e234;
global_8.member[((14u * _e168) + _e170)] = _e245;
global_8.member[((15u * _e168) + _e170)] = _e256;
global_8.member[((16u * _e168) + _e170)] = _e3329;
global_8.member[((17u * _e168) + _e170)] = select(_e278, 2f, ((_e278 == 0f) || (_e278 == 4f)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
