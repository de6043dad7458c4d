struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_5 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: type_4,
member_4: type_4,
member_5: type_4,
member_6: type_4,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: vec4<u32>,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: vec4<u32>,
member_25: type_4,
member_26: type_4,
member_27: type_4,
member_28: type_4,
}
struct type_6 {
member: type_5,
}
struct type_8 {
member: array<f32>,
}
struct type_13 {
member: array<u32>,
}
struct type_14 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_6;
@group(0) @binding(1)
var<storage> global_2: type_8;
@group(0) @binding(2)
var<storage> global_3: type_8;
@group(0) @binding(3)
var<storage> global_4: type_8;
@group(0) @binding(4)
var<storage> global_5: type_8;
@group(0) @binding(5)
var<storage> global_6: type_13;
@group(0) @binding(6)
var<storage> global_7: type_8;
@group(0) @binding(7)
var<storage, read_write> global_8: type_8;
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
var phi_2377_: vec3<f32>;
var phi_2974_: i32;
var phi_2977_: i32;
var phi_2979_: i32;
var phi_2981_: i32;
var phi_2996_: i32;
var phi_3002_: i32;
var phi_2975_: i32;
var phi_2978_: i32;
var phi_2980_: i32;
var phi_2982_: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var phi_3077_: i32;
var local_43: i32;
var local_44: i32;
var phi_3083_: i32;
var local_45: i32;
var phi_3090_: i32;
var local_46: i32;
var local_47: i32;
var phi_3096_: i32;
var local_48: i32;
var local_49: i32;
var phi_3107_: i32;
var local_50: i32;
var local_51: i32;
var phi_3119_: i32;
var local_52: i32;
var local_53: i32;
var local_54: i32;
var local_55: i32;
var phi_3353_: i32;
var phi_3356_: i32;
var phi_3358_: i32;
var phi_3360_: i32;
var phi_3375_: i32;
var phi_3381_: i32;
var phi_3354_: i32;
var phi_3357_: i32;
var phi_3359_: i32;
var phi_3361_: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var phi_3456_: i32;
var local_59: i32;
var local_60: i32;
var phi_3462_: i32;
var local_61: i32;
var phi_3469_: i32;
var local_62: i32;
var local_63: i32;
var phi_3475_: i32;
var local_64: i32;
var local_65: i32;
var phi_3486_: i32;
var local_66: i32;
var local_67: i32;
var phi_3498_: i32;
var local_68: i32;
var local_69: i32;
var local_70: i32;
var local_71: i32;
var phi_3752_: vec3<f32>;
var phi_3753_: vec3<f32>;
var phi_3754_: vec3<f32>;
var phi_4583_: type_14;
var phi_4975_: f32;
var phi_4978_: vec3<f32>;
var phi_4980_: i32;
var phi_4995_: i32;
var phi_4998_: f32;
var phi_5000_: vec3<f32>;
var phi_5233_: vec3<f32>;
var phi_5243_: vec3<f32>;
var phi_4996_: i32;
var phi_4999_: f32;
var phi_5001_: vec3<f32>;
var phi_4976_: f32;
var phi_4979_: vec3<f32>;
var phi_4981_: i32;
var local_72: f32;
var local_73: f32;
var local_74: vec3<f32>;
var local_75: vec3<f32>;
var local_76: vec3<f32>;
var phi_5373_: vec3<f32>;
var phi_5374_: vec3<f32>;
var phi_5375_: vec3<f32>;
var phi_5775_: vec3<f32>;
var phi_6372_: i32;
var phi_6375_: i32;
var phi_6377_: i32;
var phi_6379_: i32;
var phi_6394_: i32;
var phi_6400_: i32;
var phi_6373_: i32;
var phi_6376_: i32;
var phi_6378_: i32;
var phi_6380_: i32;
var local_77: i32;
var local_78: i32;
var local_79: i32;
var phi_6475_: i32;
var local_80: i32;
var local_81: i32;
var phi_6481_: i32;
var local_82: i32;
var phi_6488_: i32;
var local_83: i32;
var local_84: i32;
var phi_6494_: i32;
var local_85: i32;
var local_86: i32;
var phi_6505_: i32;
var local_87: i32;
var local_88: i32;
var phi_6517_: i32;
var local_89: i32;
var local_90: i32;
var local_91: i32;
var local_92: i32;
var phi_6751_: i32;
var phi_6754_: i32;
var phi_6756_: i32;
var phi_6758_: i32;
var phi_6773_: i32;
var phi_6779_: i32;
var phi_6752_: i32;
var phi_6755_: i32;
var phi_6757_: i32;
var phi_6759_: i32;
var local_93: i32;
var local_94: i32;
var local_95: i32;
var phi_6854_: i32;
var local_96: i32;
var local_97: i32;
var phi_6860_: i32;
var local_98: i32;
var phi_6867_: i32;
var local_99: i32;
var local_100: i32;
var phi_6873_: i32;
var local_101: i32;
var local_102: i32;
var phi_6884_: i32;
var local_103: i32;
var local_104: i32;
var phi_6896_: i32;
var local_105: i32;
var local_106: i32;
var local_107: i32;
var local_108: i32;
var phi_7150_: vec3<f32>;
var phi_7151_: vec3<f32>;
var phi_7152_: vec3<f32>;
var phi_8123_: type_14;
var phi_8515_: f32;
var phi_8518_: vec3<f32>;
var phi_8520_: i32;
var phi_8535_: i32;
var phi_8538_: f32;
var phi_8540_: vec3<f32>;
var phi_8773_: vec3<f32>;
var phi_8783_: vec3<f32>;
var phi_8536_: i32;
var phi_8539_: f32;
var phi_8541_: vec3<f32>;
var phi_8516_: f32;
var phi_8519_: vec3<f32>;
var phi_8521_: i32;
var local_109: f32;
var local_110: f32;
var local_111: vec3<f32>;
var local_112: vec3<f32>;
var local_113: vec3<f32>;
var phi_8843_: vec3<f32>;
var phi_8844_: vec3<f32>;
var local_114: f32;
var local_115: vec3<f32>;
var local_116: f32;
var local_117: vec3<f32>;
let _e144 = global;
let _e149 = arrayLength((&global_3.member));
let _e151 = arrayLength((&global_4.member));
let _e153 = arrayLength((&global_5.member));
let _e155 = arrayLength((&global_6.member));
let _e162 = global_1.member.member[0u];
let _e166 = global_1.member.member[1u];
if (_e144.x < _e162) {
if (_e144.y < _e166) {
let _e171 = (_e162 * _e166);
let _e173 = ((_e144.y * _e162) + _e144.x);
let _e177 = global_1.member.member[2u];
let _e178 = bitcast<i32>(_e144.x);
let _e179 = bitcast<i32>(_e144.y);
let _e180 = bitcast<i32>(_e162);
let _e181 = (_e179 * _e180);
let _e182 = (_e181 + _e178);
local_38 = _e182;
let _e183 = bitcast<i32>(_e171);
local_39 = _e183;
let _e184 = local_38;
local_36 = _e184;
local_37 = _e183;
let _e185 = local_37;
let _e187 = local_36;
let _e188 = ((3i * _e185) + _e187);
let _e190 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e192 = select(_e190, _e188, (_e188 < _e190));
let _e197 = global_2.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e198 = local_37;
let _e200 = local_36;
let _e201 = ((4i * _e198) + _e200);
let _e203 = select(_e190, _e201, (_e201 < _e190));
let _e208 = global_2.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e209 = local_37;
let _e211 = local_36;
let _e212 = ((5i * _e209) + _e211);
let _e214 = select(_e190, _e212, (_e212 < _e190));
let _e219 = global_2.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e220 = local_38;
local_34 = _e220;
local_35 = _e183;
let _e221 = local_35;
let _e223 = local_34;
let _e224 = ((6i * _e221) + _e223);
let _e226 = select(_e190, _e224, (_e224 < _e190));
let _e231 = global_2.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e232 = local_35;
let _e234 = local_34;
let _e235 = ((7i * _e232) + _e234);
let _e237 = select(_e190, _e235, (_e235 < _e190));
let _e242 = global_2.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e243 = local_35;
let _e245 = local_34;
let _e246 = ((8i * _e243) + _e245);
let _e248 = select(_e190, _e246, (_e246 < _e190));
let _e253 = global_2.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e254 = local_39;
let _e256 = local_38;
let _e257 = ((18i * _e254) + _e256);
let _e259 = select(_e190, _e257, (_e257 < _e190));
let _e264 = global_2.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e265 = local_39;
let _e267 = local_38;
let _e268 = ((16i * _e265) + _e267);
let _e270 = select(_e190, _e268, (_e268 < _e190));
let _e275 = global_2.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e276 = (_e177 == 1u);
let _e278 = (_e276 && (_e275 == 3f));
let _e279 = local_38;
local_32 = _e279;
local_33 = _e183;
let _e280 = local_33;
let _e282 = local_32;
let _e283 = ((9i * _e280) + _e282);
let _e285 = select(_e190, _e283, (_e283 < _e190));
let _e290 = global_2.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e291 = local_33;
let _e293 = local_32;
let _e294 = ((10i * _e291) + _e293);
let _e296 = select(_e190, _e294, (_e294 < _e190));
let _e301 = global_2.member[bitcast<u32>(select(0i, _e296, (_e296 > 0i)))];
let _e302 = local_33;
let _e304 = local_32;
let _e305 = ((11i * _e302) + _e304);
let _e307 = select(_e190, _e305, (_e305 < _e190));
let _e312 = global_2.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e313 = vec3<f32>(_e290, _e301, _e312);
let _e314 = (_e178 - 1i);
let _e315 = bitcast<i32>(_e166);
local_29 = _e180;
local_30 = _e315;
let _e317 = local_29;
let _e320 = (_e179 >= 0i);
let _e322 = local_30;
let _e324 = ((((_e314 >= 0i) && (_e314 < _e317)) && _e320) && (_e179 < _e322));
if _e324 {
let _e325 = local_29;
local_31 = ((_e179 * _e325) + _e314);
} else {
local_31 = 0i;
}
let _e328 = local_29;
let _e329 = local_30;
let _e332 = local_31;
let _e333 = ((18i * (_e328 * _e329)) + _e332);
let _e335 = select(_e190, _e333, (_e333 < _e190));
let _e340 = global_2.member[bitcast<u32>(select(0i, _e335, (_e335 > 0i)))];
let _e343 = local_29;
let _e344 = local_30;
let _e347 = local_31;
let _e348 = ((16i * (_e343 * _e344)) + _e347);
let _e350 = select(_e190, _e348, (_e348 < _e190));
let _e355 = global_2.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
let _e357 = ((_e324 && (_e340 == _e264)) && (_e355 == _e275));
let _e358 = local_31;
local_27 = _e358;
local_28 = _e183;
let _e359 = local_28;
let _e361 = local_27;
let _e362 = ((3i * _e359) + _e361);
let _e364 = select(_e190, _e362, (_e362 < _e190));
let _e369 = global_2.member[bitcast<u32>(select(0i, _e364, (_e364 > 0i)))];
let _e370 = local_28;
let _e372 = local_27;
let _e373 = ((4i * _e370) + _e372);
let _e375 = select(_e190, _e373, (_e373 < _e190));
let _e380 = global_2.member[bitcast<u32>(select(0i, _e375, (_e375 > 0i)))];
let _e381 = local_28;
let _e383 = local_27;
let _e384 = ((5i * _e381) + _e383);
let _e386 = select(_e190, _e384, (_e384 < _e190));
let _e391 = global_2.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e392 = local_29;
let _e393 = local_30;
let _e396 = local_31;
let _e397 = ((21i * (_e392 * _e393)) + _e396);
let _e399 = select(_e190, _e397, (_e397 < _e190));
let _e404 = global_2.member[bitcast<u32>(select(0i, _e399, (_e399 > 0i)))];
let _e406 = (_e324 && (_e404 > 0f));
let _e407 = f32(_e180);
let _e408 = f32(_e315);
let _e417 = global_1.member.member_3.member;
let _e418 = (((((f32(_e314) + 0.5f) / _e407) * 2f) - 1f) * _e417);
let _e427 = global_1.member.member_3.member_1;
let _e428 = ((1f - (((f32(_e179) + 0.5f) / _e408) * 2f)) * _e427);
let _e431 = global_1.member.member_4;
let _e440 = global_1.member.member_5;
let _e444 = (_e440.member * _e428);
let _e445 = (_e440.member_1 * _e428);
let _e446 = (_e440.member_2 * _e428);
let _e453 = global_1.member.member_3.member_3;
let _e455 = select(1f, 0f, (_e453 > 0.5f));
let _e458 = global_1.member.member_6;
let _e465 = (_e458.member + (((_e431.member * _e418) + _e444) * _e455));
let _e466 = (_e458.member_1 + (((_e431.member_1 * _e418) + _e445) * _e455));
let _e467 = (_e458.member_2 + (((_e431.member_2 * _e418) + _e446) * _e455));
let _e472 = (((_e465 * _e465) + (_e466 * _e466)) + (_e467 * _e467));
let _e475 = sqrt(select(0f, _e472, (_e472 > 0f)));
let _e478 = (1f / select(1e-20f, _e475, (_e475 > 1e-20f)));
let _e479 = (_e465 * _e478);
let _e480 = (_e466 * _e478);
let _e481 = (_e467 * _e478);
local_25 = (_e181 + _e314);
local_26 = _e183;
let _e483 = local_26;
let _e485 = local_25;
let _e486 = ((9i * _e483) + _e485);
let _e488 = select(_e190, _e486, (_e486 < _e190));
let _e493 = global_2.member[bitcast<u32>(select(0i, _e488, (_e488 > 0i)))];
let _e494 = local_26;
let _e496 = local_25;
let _e497 = ((10i * _e494) + _e496);
let _e499 = select(_e190, _e497, (_e497 < _e190));
let _e504 = global_2.member[bitcast<u32>(select(0i, _e499, (_e499 > 0i)))];
let _e505 = local_26;
let _e507 = local_25;
let _e508 = ((11i * _e505) + _e507);
let _e510 = select(_e190, _e508, (_e508 < _e190));
let _e515 = global_2.member[bitcast<u32>(select(0i, _e510, (_e510 > 0i)))];
let _e521 = (2f * (((_e479 * _e493) + (_e480 * _e504)) + (_e481 * _e515)));
let _e525 = (_e479 - (_e493 * _e521));
let _e526 = (_e480 - (_e504 * _e521));
let _e527 = (_e481 - (_e515 * _e521));
let _e528 = (_e178 + 1i);
local_22 = _e180;
local_23 = _e315;
let _e530 = local_22;
let _e534 = local_23;
let _e536 = ((((_e528 >= 0i) && (_e528 < _e530)) && _e320) && (_e179 < _e534));
if _e536 {
let _e537 = local_22;
local_24 = ((_e179 * _e537) + _e528);
} else {
local_24 = 0i;
}
let _e540 = local_22;
let _e541 = local_23;
let _e544 = local_24;
let _e545 = ((18i * (_e540 * _e541)) + _e544);
let _e547 = select(_e190, _e545, (_e545 < _e190));
let _e552 = global_2.member[bitcast<u32>(select(0i, _e547, (_e547 > 0i)))];
let _e555 = local_22;
let _e556 = local_23;
let _e559 = local_24;
let _e560 = ((16i * (_e555 * _e556)) + _e559);
let _e562 = select(_e190, _e560, (_e560 < _e190));
let _e567 = global_2.member[bitcast<u32>(select(0i, _e562, (_e562 > 0i)))];
let _e569 = ((_e536 && (_e552 == _e264)) && (_e567 == _e275));
let _e570 = local_24;
local_20 = _e570;
local_21 = _e183;
let _e571 = local_21;
let _e573 = local_20;
let _e574 = ((3i * _e571) + _e573);
let _e576 = select(_e190, _e574, (_e574 < _e190));
let _e581 = global_2.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e582 = local_21;
let _e584 = local_20;
let _e585 = ((4i * _e582) + _e584);
let _e587 = select(_e190, _e585, (_e585 < _e190));
let _e592 = global_2.member[bitcast<u32>(select(0i, _e587, (_e587 > 0i)))];
let _e593 = local_21;
let _e595 = local_20;
let _e596 = ((5i * _e593) + _e595);
let _e598 = select(_e190, _e596, (_e596 < _e190));
let _e603 = global_2.member[bitcast<u32>(select(0i, _e598, (_e598 > 0i)))];
let _e604 = local_22;
let _e605 = local_23;
let _e608 = local_24;
let _e609 = ((21i * (_e604 * _e605)) + _e608);
let _e611 = select(_e190, _e609, (_e609 < _e190));
let _e616 = global_2.member[bitcast<u32>(select(0i, _e611, (_e611 > 0i)))];
let _e618 = (_e536 && (_e616 > 0f));
let _e624 = (((((f32(_e528) + 0.5f) / _e407) * 2f) - 1f) * _e417);
let _e634 = (_e458.member + (((_e431.member * _e624) + _e444) * _e455));
let _e635 = (_e458.member_1 + (((_e431.member_1 * _e624) + _e445) * _e455));
let _e636 = (_e458.member_2 + (((_e431.member_2 * _e624) + _e446) * _e455));
let _e641 = (((_e634 * _e634) + (_e635 * _e635)) + (_e636 * _e636));
let _e644 = sqrt(select(0f, _e641, (_e641 > 0f)));
let _e647 = (1f / select(1e-20f, _e644, (_e644 > 1e-20f)));
let _e648 = (_e634 * _e647);
let _e649 = (_e635 * _e647);
let _e650 = (_e636 * _e647);
local_18 = (_e181 + _e528);
local_19 = _e183;
let _e652 = local_19;
let _e654 = local_18;
let _e655 = ((9i * _e652) + _e654);
let _e657 = select(_e190, _e655, (_e655 < _e190));
let _e662 = global_2.member[bitcast<u32>(select(0i, _e657, (_e657 > 0i)))];
let _e663 = local_19;
let _e665 = local_18;
let _e666 = ((10i * _e663) + _e665);
let _e668 = select(_e190, _e666, (_e666 < _e190));
let _e673 = global_2.member[bitcast<u32>(select(0i, _e668, (_e668 > 0i)))];
let _e674 = local_19;
let _e676 = local_18;
let _e677 = ((11i * _e674) + _e676);
let _e679 = select(_e190, _e677, (_e677 < _e190));
let _e684 = global_2.member[bitcast<u32>(select(0i, _e679, (_e679 > 0i)))];
let _e690 = (2f * (((_e648 * _e662) + (_e649 * _e673)) + (_e650 * _e684)));
let _e694 = (_e648 - (_e662 * _e690));
let _e695 = (_e649 - (_e673 * _e690));
let _e696 = (_e650 - (_e684 * _e690));
let _e697 = (_e179 - 1i);
local_15 = _e180;
local_16 = _e315;
let _e698 = (_e178 >= 0i);
let _e699 = local_15;
let _e704 = local_16;
let _e706 = (((_e698 && (_e178 < _e699)) && (_e697 >= 0i)) && (_e697 < _e704));
if _e706 {
let _e707 = local_15;
local_17 = ((_e697 * _e707) + _e178);
} else {
local_17 = 0i;
}
let _e710 = local_15;
let _e711 = local_16;
let _e714 = local_17;
let _e715 = ((18i * (_e710 * _e711)) + _e714);
let _e717 = select(_e190, _e715, (_e715 < _e190));
let _e722 = global_2.member[bitcast<u32>(select(0i, _e717, (_e717 > 0i)))];
let _e725 = local_15;
let _e726 = local_16;
let _e729 = local_17;
let _e730 = ((16i * (_e725 * _e726)) + _e729);
let _e732 = select(_e190, _e730, (_e730 < _e190));
let _e737 = global_2.member[bitcast<u32>(select(0i, _e732, (_e732 > 0i)))];
let _e739 = ((_e706 && (_e722 == _e264)) && (_e737 == _e275));
let _e740 = local_17;
local_13 = _e740;
local_14 = _e183;
let _e741 = local_14;
let _e743 = local_13;
let _e744 = ((3i * _e741) + _e743);
let _e746 = select(_e190, _e744, (_e744 < _e190));
let _e751 = global_2.member[bitcast<u32>(select(0i, _e746, (_e746 > 0i)))];
let _e752 = local_14;
let _e754 = local_13;
let _e755 = ((4i * _e752) + _e754);
let _e757 = select(_e190, _e755, (_e755 < _e190));
let _e762 = global_2.member[bitcast<u32>(select(0i, _e757, (_e757 > 0i)))];
let _e763 = local_14;
let _e765 = local_13;
let _e766 = ((5i * _e763) + _e765);
let _e768 = select(_e190, _e766, (_e766 < _e190));
let _e773 = global_2.member[bitcast<u32>(select(0i, _e768, (_e768 > 0i)))];
let _e774 = local_15;
let _e775 = local_16;
let _e778 = local_17;
let _e779 = ((21i * (_e774 * _e775)) + _e778);
let _e781 = select(_e190, _e779, (_e779 < _e190));
let _e786 = global_2.member[bitcast<u32>(select(0i, _e781, (_e781 > 0i)))];
let _e788 = (_e706 && (_e786 > 0f));
let _e794 = (((((f32(_e178) + 0.5f) / _e407) * 2f) - 1f) * _e417);
let _e800 = ((1f - (((f32(_e697) + 0.5f) / _e408) * 2f)) * _e427);
let _e801 = (_e431.member * _e794);
let _e802 = (_e431.member_1 * _e794);
let _e803 = (_e431.member_2 * _e794);
let _e813 = (_e458.member + ((_e801 + (_e440.member * _e800)) * _e455));
let _e814 = (_e458.member_1 + ((_e802 + (_e440.member_1 * _e800)) * _e455));
let _e815 = (_e458.member_2 + ((_e803 + (_e440.member_2 * _e800)) * _e455));
let _e820 = (((_e813 * _e813) + (_e814 * _e814)) + (_e815 * _e815));
let _e823 = sqrt(select(0f, _e820, (_e820 > 0f)));
let _e826 = (1f / select(1e-20f, _e823, (_e823 > 1e-20f)));
let _e827 = (_e813 * _e826);
let _e828 = (_e814 * _e826);
let _e829 = (_e815 * _e826);
local_11 = ((_e697 * _e180) + _e178);
local_12 = _e183;
let _e832 = local_12;
let _e834 = local_11;
let _e835 = ((9i * _e832) + _e834);
let _e837 = select(_e190, _e835, (_e835 < _e190));
let _e842 = global_2.member[bitcast<u32>(select(0i, _e837, (_e837 > 0i)))];
let _e843 = local_12;
let _e845 = local_11;
let _e846 = ((10i * _e843) + _e845);
let _e848 = select(_e190, _e846, (_e846 < _e190));
let _e853 = global_2.member[bitcast<u32>(select(0i, _e848, (_e848 > 0i)))];
let _e854 = local_12;
let _e856 = local_11;
let _e857 = ((11i * _e854) + _e856);
let _e859 = select(_e190, _e857, (_e857 < _e190));
let _e864 = global_2.member[bitcast<u32>(select(0i, _e859, (_e859 > 0i)))];
let _e870 = (2f * (((_e827 * _e842) + (_e828 * _e853)) + (_e829 * _e864)));
let _e874 = (_e827 - (_e842 * _e870));
let _e875 = (_e828 - (_e853 * _e870));
let _e876 = (_e829 - (_e864 * _e870));
let _e877 = (_e179 + 1i);
local_8 = _e180;
local_9 = _e315;
let _e878 = local_8;
let _e883 = local_9;
let _e885 = (((_e698 && (_e178 < _e878)) && (_e877 >= 0i)) && (_e877 < _e883));
if _e885 {
let _e886 = local_8;
local_10 = ((_e877 * _e886) + _e178);
} else {
local_10 = 0i;
}
let _e889 = local_8;
let _e890 = local_9;
let _e893 = local_10;
let _e894 = ((18i * (_e889 * _e890)) + _e893);
let _e896 = select(_e190, _e894, (_e894 < _e190));
let _e901 = global_2.member[bitcast<u32>(select(0i, _e896, (_e896 > 0i)))];
let _e904 = local_8;
let _e905 = local_9;
let _e908 = local_10;
let _e909 = ((16i * (_e904 * _e905)) + _e908);
let _e911 = select(_e190, _e909, (_e909 < _e190));
let _e916 = global_2.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e918 = ((_e885 && (_e901 == _e264)) && (_e916 == _e275));
let _e919 = local_10;
local_6 = _e919;
local_7 = _e183;
let _e920 = local_7;
let _e922 = local_6;
let _e923 = ((3i * _e920) + _e922);
let _e925 = select(_e190, _e923, (_e923 < _e190));
let _e930 = global_2.member[bitcast<u32>(select(0i, _e925, (_e925 > 0i)))];
let _e931 = local_7;
let _e933 = local_6;
let _e934 = ((4i * _e931) + _e933);
let _e936 = select(_e190, _e934, (_e934 < _e190));
let _e941 = global_2.member[bitcast<u32>(select(0i, _e936, (_e936 > 0i)))];
let _e942 = local_7;
let _e944 = local_6;
let _e945 = ((5i * _e942) + _e944);
let _e947 = select(_e190, _e945, (_e945 < _e190));
let _e952 = global_2.member[bitcast<u32>(select(0i, _e947, (_e947 > 0i)))];
let _e953 = local_8;
let _e954 = local_9;
let _e957 = local_10;
let _e958 = ((21i * (_e953 * _e954)) + _e957);
let _e960 = select(_e190, _e958, (_e958 < _e190));
let _e965 = global_2.member[bitcast<u32>(select(0i, _e960, (_e960 > 0i)))];
let _e967 = (_e885 && (_e965 > 0f));
let _e973 = ((1f - (((f32(_e877) + 0.5f) / _e408) * 2f)) * _e427);
let _e983 = (_e458.member + ((_e801 + (_e440.member * _e973)) * _e455));
let _e984 = (_e458.member_1 + ((_e802 + (_e440.member_1 * _e973)) * _e455));
let _e985 = (_e458.member_2 + ((_e803 + (_e440.member_2 * _e973)) * _e455));
let _e990 = (((_e983 * _e983) + (_e984 * _e984)) + (_e985 * _e985));
let _e993 = sqrt(select(0f, _e990, (_e990 > 0f)));
let _e996 = (1f / select(1e-20f, _e993, (_e993 > 1e-20f)));
let _e997 = (_e983 * _e996);
let _e998 = (_e984 * _e996);
let _e999 = (_e985 * _e996);
local_4 = ((_e877 * _e180) + _e178);
local_5 = _e183;
let _e1002 = local_5;
let _e1004 = local_4;
let _e1005 = ((9i * _e1002) + _e1004);
let _e1007 = select(_e190, _e1005, (_e1005 < _e190));
let _e1012 = global_2.member[bitcast<u32>(select(0i, _e1007, (_e1007 > 0i)))];
let _e1013 = local_5;
let _e1015 = local_4;
let _e1016 = ((10i * _e1013) + _e1015);
let _e1018 = select(_e190, _e1016, (_e1016 < _e190));
let _e1023 = global_2.member[bitcast<u32>(select(0i, _e1018, (_e1018 > 0i)))];
let _e1024 = local_5;
let _e1026 = local_4;
let _e1027 = ((11i * _e1024) + _e1026);
let _e1029 = select(_e190, _e1027, (_e1027 < _e190));
let _e1034 = global_2.member[bitcast<u32>(select(0i, _e1029, (_e1029 > 0i)))];
let _e1040 = (2f * (((_e997 * _e1012) + (_e998 * _e1023)) + (_e999 * _e1034)));
let _e1044 = (_e997 - (_e1012 * _e1040));
let _e1045 = (_e998 - (_e1023 * _e1040));
let _e1046 = (_e999 - (_e1034 * _e1040));
let _e1047 = (_e801 + _e444);
let _e1048 = (_e802 + _e445);
let _e1049 = (_e803 + _e446);
let _e1053 = (_e458.member + (_e1047 * _e455));
let _e1054 = (_e458.member_1 + (_e1048 * _e455));
let _e1055 = (_e458.member_2 + (_e1049 * _e455));
let _e1060 = (((_e1053 * _e1053) + (_e1054 * _e1054)) + (_e1055 * _e1055));
let _e1063 = sqrt(select(0f, _e1060, (_e1060 > 0f)));
let _e1066 = (1f / select(1e-20f, _e1063, (_e1063 > 1e-20f)));
let _e1067 = (_e1053 * _e1066);
let _e1068 = (_e1054 * _e1066);
let _e1069 = (_e1055 * _e1066);
let _e1070 = (_e648 - _e1067);
let _e1071 = (_e649 - _e1068);
let _e1072 = (_e650 - _e1069);
let _e1077 = (((_e1070 * _e1070) + (_e1071 * _e1071)) + (_e1072 * _e1072));
let _e1080 = sqrt(select(0f, _e1077, (_e1077 > 0f)));
let _e1081 = (_e581 - _e369);
let _e1082 = (_e592 - _e380);
let _e1083 = (_e603 - _e391);
let _e1088 = (((_e1081 * _e1081) + (_e1082 * _e1082)) + (_e1083 * _e1083));
let _e1093 = (_e581 - _e197);
let _e1094 = (_e592 - _e208);
let _e1095 = (_e603 - _e219);
let _e1100 = (((_e1093 * _e1093) + (_e1094 * _e1094)) + (_e1095 * _e1095));
let _e1104 = (_e197 - _e369);
let _e1105 = (_e208 - _e380);
let _e1106 = (_e219 - _e391);
let _e1111 = (((_e1104 * _e1104) + (_e1105 * _e1105)) + (_e1106 * _e1106));
let _e1119 = select(select(_e1080, select(sqrt(select(0f, _e1111, (_e1111 > 0f))), sqrt(select(0f, _e1100, (_e1100 > 0f))), _e569), (_e357 || _e569)), (0.5f * sqrt(select(0f, _e1088, (_e1088 > 0f)))), (_e357 && _e569));
let _e1120 = (_e930 - _e751);
let _e1121 = (_e941 - _e762);
let _e1122 = (_e952 - _e773);
let _e1127 = (((_e1120 * _e1120) + (_e1121 * _e1121)) + (_e1122 * _e1122));
let _e1132 = (_e930 - _e197);
let _e1133 = (_e941 - _e208);
let _e1134 = (_e952 - _e219);
let _e1139 = (((_e1132 * _e1132) + (_e1133 * _e1133)) + (_e1134 * _e1134));
let _e1143 = (_e197 - _e751);
let _e1144 = (_e208 - _e762);
let _e1145 = (_e219 - _e773);
let _e1150 = (((_e1143 * _e1143) + (_e1144 * _e1144)) + (_e1145 * _e1145));
let _e1158 = select(select(_e1080, select(sqrt(select(0f, _e1150, (_e1150 > 0f))), sqrt(select(0f, _e1139, (_e1139 > 0f))), _e918), (_e739 || _e918)), (0.5f * sqrt(select(0f, _e1127, (_e1127 > 0f)))), (_e739 && _e918));
let _e1159 = (_e264 > 0f);
let _e1162 = select(_e1080, select(_e1158, _e1119, (_e1119 > _e1158)), _e1159);
let _e1165 = global_1.member.member_10;
let _e1168 = global_1.member.member_14;
let _e1171 = global_1.member.member_15;
let _e1174 = global_1.member.member_16;
let _e1177 = global_1.member.member_11;
let _e1185 = (((_e1177.member * _e197) + (_e1177.member_1 * _e208)) + (_e1177.member_2 * _e219));
let _e1188 = global_1.member.member_12;
let _e1196 = (((_e1188.member * _e197) + (_e1188.member_1 * _e208)) + (_e1188.member_2 * _e219));
let _e1199 = global_1.member.member_13;
let _e1207 = (((_e1199.member * _e197) + (_e1199.member_1 * _e208)) + (_e1199.member_2 * _e219));
let _e1212 = vec3<f32>(_e1168.member, _e1168.member_1, _e1168.member_2);
let _e1216 = (_e1165.x == 0u);
if _e1216 {
phi_3754_ = _e1212;
} else {
if (_e1165.x == 1u) {
let _e1219 = select(-1f, _e1207, (_e1207 > -1f));
let _e1221 = select(1f, _e1219, (_e1219 < 1f));
if (_e1221 > 0f) {
phi_2377_ = _e1212;
} else {
phi_2377_ = vec3<f32>(_e1174.member, _e1174.member_1, _e1174.member_2);
}
let _e1228 = phi_2377_;
let _e1237 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
let _e1240 = sqrt(select(0f, _e1237, (_e1237 > 0f)));
phi_3753_ = vec3<f32>((_e1171.member + ((_e1228.x - _e1171.member) * _e1240)), (_e1171.member_1 + ((_e1228.y - _e1171.member_1) * _e1240)), (_e1171.member_2 + ((_e1228.z - _e1171.member_2) * _e1240)));
} else {
if (_e1165.x == 2u) {
let _e1250 = (_e1162 / _e1168.member_3);
let _e1252 = select(1e-4f, _e1250, (_e1250 > 1e-4f));
let _e1255 = bitcast<f32>((bitcast<u32>(_e1185) & 2147483647u));
let _e1258 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
let _e1262 = select(_e1258, _e1255, (_e1255 > _e1258));
let _e1265 = (select(_e1258, _e1255, (_e1255 < _e1258)) / select(1.1754944e-38f, _e1262, (_e1262 > 1.1754944e-38f)));
let _e1266 = (_e1265 > 0.41421357f);
let _e1270 = select(_e1265, ((_e1265 - 1f) / (_e1265 + 1f)), _e1266);
let _e1271 = (_e1270 * _e1270);
let _e1286 = (select(0f, 0.7853982f, _e1266) + (_e1270 + ((_e1270 * _e1271) * (-0.33333334f + (_e1271 * (0.2f + (_e1271 * (-0.14285713f + (_e1271 * (0.11111111f + (_e1271 * (-0.09090909f + (_e1271 * 0.0585f)))))))))))));
let _e1289 = select(_e1286, (1.5707964f - _e1286), (_e1258 > _e1255));
let _e1292 = select(_e1289, (3.1415927f - _e1289), (_e1185 < 0f));
let _e1298 = (1f - (_e1207 * _e1207));
let _e1301 = sqrt(select(0f, _e1298, (_e1298 > 0f)));
let _e1304 = (_e1252 / select(1e-3f, _e1301, (_e1301 > 1e-3f)));
let _e1305 = ((select(_e1292, -(_e1292), (_e1196 < 0f)) / _e1168.member_3) * 0.5f);
let _e1307 = select(-8e6f, _e1305, (_e1305 > -8e6f));
let _e1309 = select(8e6f, _e1307, (_e1307 < 8e6f));
let _e1316 = select(0i, select(select(i32(_e1309), i32(-2147483648), (_e1309 < -2147483600f)), 2147483647i, (_e1309 > 2147483500f)), (_e1309 == _e1309));
let _e1323 = ((_e1305 - f32((_e1316 - select(0i, 1i, (_e1309 < f32(_e1316)))))) * 2f);
let _e1331 = ((select(select((_e1323 - 2f), (1f - _e1323), (_e1323 < 1.5f)), _e1323, (_e1323 < 0.5f)) * 2f) / _e1304);
let _e1333 = select(-1f, _e1331, (_e1331 > -1f));
let _e1336 = (2f - _e1304);
let _e1338 = select(0f, _e1336, (_e1336 > 0f));
let _e1343 = select(-1f, _e1207, (_e1207 > -1f));
let _e1345 = select(1f, _e1343, (_e1343 < 1f));
let _e1348 = ((1f - _e1345) * (1f + _e1345));
let _e1351 = sqrt(select(0f, _e1348, (_e1348 > 0f)));
let _e1354 = bitcast<f32>((bitcast<u32>(_e1351) & 2147483647u));
let _e1357 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
let _e1361 = select(_e1357, _e1354, (_e1354 > _e1357));
let _e1364 = (select(_e1357, _e1354, (_e1354 < _e1357)) / select(1.1754944e-38f, _e1361, (_e1361 > 1.1754944e-38f)));
let _e1365 = (_e1364 > 0.41421357f);
let _e1369 = select(_e1364, ((_e1364 - 1f) / (_e1364 + 1f)), _e1365);
let _e1370 = (_e1369 * _e1369);
let _e1385 = (select(0f, 0.7853982f, _e1365) + (_e1369 + ((_e1369 * _e1370) * (-0.33333334f + (_e1370 * (0.2f + (_e1370 * (-0.14285713f + (_e1370 * (0.11111111f + (_e1370 * (-0.09090909f + (_e1370 * 0.0585f)))))))))))));
let _e1388 = select(_e1385, (1.5707964f - _e1385), (_e1357 > _e1354));
let _e1391 = select(_e1388, (3.1415927f - _e1388), (_e1351 < 0f));
let _e1396 = ((select(_e1391, -(_e1391), (_e1345 < 0f)) / _e1168.member_3) * 0.5f);
let _e1398 = select(-8e6f, _e1396, (_e1396 > -8e6f));
let _e1400 = select(8e6f, _e1398, (_e1398 < 8e6f));
let _e1407 = select(0i, select(select(i32(_e1400), i32(-2147483648), (_e1400 < -2147483600f)), 2147483647i, (_e1400 > 2147483500f)), (_e1400 == _e1400));
let _e1414 = ((_e1396 - f32((_e1407 - select(0i, 1i, (_e1400 < f32(_e1407)))))) * 2f);
let _e1422 = ((select(select((_e1414 - 2f), (1f - _e1414), (_e1414 < 1.5f)), _e1414, (_e1414 < 0.5f)) * 2f) / _e1252);
let _e1424 = select(-1f, _e1422, (_e1422 > -1f));
let _e1427 = (2f - _e1252);
let _e1429 = select(0f, _e1427, (_e1427 > 0f));
let _e1435 = (0.5f + ((0.5f * (select(1f, _e1333, (_e1333 < 1f)) * select(1f, _e1338, (_e1338 < 1f)))) * (select(1f, _e1424, (_e1424 < 1f)) * select(1f, _e1429, (_e1429 < 1f)))));
phi_3752_ = vec3<f32>((_e1168.member + ((_e1171.member - _e1168.member) * _e1435)), (_e1168.member_1 + ((_e1171.member_1 - _e1168.member_1) * _e1435)), (_e1168.member_2 + ((_e1171.member_2 - _e1168.member_2) * _e1435)));
} else {
let _e1447 = bitcast<i32>(_e1165.y);
let _e1451 = f32(bitcast<i32>(_e1165.w));
let _e1453 = (2f * 3.1415927f);
let _e1454 = ((_e1162 * f32(_e1447)) / _e1453);
let _e1456 = select(1e-6f, _e1454, (_e1454 > 1e-6f));
let _e1459 = bitcast<u32>(select(1.1754944e-38f, _e1456, (_e1456 > 1.1754944e-38f)));
let _e1460 = (_e1459 & 8388607u);
let _e1462 = select(0u, 1u, (_e1460 > 3474675u));
let _e1473 = bitcast<f32>((_e1460 | ((127u - _e1462) << bitcast<u32>(23i))));
let _e1476 = ((_e1473 - 1f) / (_e1473 + 1f));
let _e1477 = (_e1476 * _e1476);
let _e1492 = (f32(((bitcast<i32>((_e1459 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1462))) + (((2f * _e1476) + ((_e1476 * _e1477) * (0.6666667f + (_e1477 * (0.4f + (_e1477 * (0.2857143f + (_e1477 * (0.22222222f + (_e1477 * 0.18181819f)))))))))) * 1.442695f));
let _e1493 = (_e1451 - 1f);
let _e1495 = select(0f, _e1492, (_e1492 > 0f));
let _e1497 = select(_e1493, _e1495, (_e1495 < _e1493));
let _e1498 = (_e1451 - 2f);
let _e1500 = select(0f, _e1498, (_e1498 > 0f));
let _e1502 = select(0f, _e1497, (_e1497 > 0f));
let _e1504 = select(_e1500, _e1502, (_e1502 < _e1500));
let _e1511 = select(0i, select(select(i32(_e1504), i32(-2147483648), (_e1504 < -2147483600f)), 2147483647i, (_e1504 > 2147483500f)), (_e1504 == _e1504));
let _e1515 = (_e1511 - select(0i, 1i, (_e1504 < f32(_e1511))));
let _e1518 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
let _e1521 = bitcast<f32>((bitcast<u32>(_e1185) & 2147483647u));
let _e1525 = select(_e1521, _e1518, (_e1518 > _e1521));
let _e1528 = (select(_e1521, _e1518, (_e1518 < _e1521)) / select(1.1754944e-38f, _e1525, (_e1525 > 1.1754944e-38f)));
let _e1529 = (_e1528 > 0.41421357f);
let _e1533 = select(_e1528, ((_e1528 - 1f) / (_e1528 + 1f)), _e1529);
let _e1534 = (_e1533 * _e1533);
let _e1549 = (select(0f, 0.7853982f, _e1529) + (_e1533 + ((_e1533 * _e1534) * (-0.33333334f + (_e1534 * (0.2f + (_e1534 * (-0.14285713f + (_e1534 * (0.11111111f + (_e1534 * (-0.09090909f + (_e1534 * 0.0585f)))))))))))));
let _e1552 = select(_e1549, (1.5707964f - _e1549), (_e1521 > _e1518));
let _e1555 = select(_e1552, (3.1415927f - _e1552), (_e1196 < 0f));
let _e1560 = (0.5f - (select(_e1555, -(_e1555), (_e1185 < 0f)) / _e1453));
let _e1562 = select(-1f, _e1207, (_e1207 > -1f));
let _e1564 = select(1f, _e1562, (_e1562 < 1f));
let _e1567 = ((1f - _e1564) * (1f + _e1564));
let _e1570 = sqrt(select(0f, _e1567, (_e1567 > 0f)));
let _e1573 = bitcast<f32>((bitcast<u32>(_e1570) & 2147483647u));
let _e1576 = bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u));
let _e1580 = select(_e1576, _e1573, (_e1573 > _e1576));
let _e1583 = (select(_e1576, _e1573, (_e1573 < _e1576)) / select(1.1754944e-38f, _e1580, (_e1580 > 1.1754944e-38f)));
let _e1584 = (_e1583 > 0.41421357f);
let _e1588 = select(_e1583, ((_e1583 - 1f) / (_e1583 + 1f)), _e1584);
let _e1589 = (_e1588 * _e1588);
let _e1604 = (select(0f, 0.7853982f, _e1584) + (_e1588 + ((_e1588 * _e1589) * (-0.33333334f + (_e1589 * (0.2f + (_e1589 * (-0.14285713f + (_e1589 * (0.11111111f + (_e1589 * (-0.09090909f + (_e1589 * 0.0585f)))))))))))));
let _e1607 = select(_e1604, (1.5707964f - _e1604), (_e1576 > _e1573));
let _e1610 = select(_e1607, (3.1415927f - _e1607), (_e1570 < 0f));
let _e1615 = (0.5f - (select(_e1610, -(_e1610), (_e1564 < 0f)) / 3.1415927f));
let _e1617 = bitcast<i32>(_e1165.z);
phi_2974_ = 0i;
phi_2977_ = 0i;
phi_2979_ = _e1617;
phi_2981_ = _e1447;
loop {
let _e1619 = phi_2974_;
let _e1621 = phi_2977_;
let _e1623 = phi_2979_;
let _e1625 = phi_2981_;
local_40 = _e1625;
local_41 = _e1623;
local_42 = _e1625;
local_43 = _e1625;
local_44 = _e1625;
local_45 = _e1625;
local_46 = _e1625;
local_47 = _e1625;
local_48 = _e1623;
local_49 = _e1623;
local_50 = _e1623;
local_51 = _e1623;
local_52 = _e1625;
local_53 = _e1621;
local_54 = _e1625;
local_55 = _e1621;
let _e1626 = (_e1619 < _e1515);
if _e1626 {
if (_e1625 > 1i) {
phi_2996_ = (_e1625 >> bitcast<u32>(1i));
} else {
phi_2996_ = 1i;
}
let _e1633 = phi_2996_;
if (_e1623 > 1i) {
phi_3002_ = (_e1623 >> bitcast<u32>(1i));
} else {
phi_3002_ = 1i;
}
let _e1638 = phi_3002_;
phi_2975_ = (_e1619 + 1i);
phi_2978_ = (_e1621 + (_e1625 * _e1623));
phi_2980_ = _e1638;
phi_2982_ = _e1633;
} else {
phi_2975_ = i32();
phi_2978_ = i32();
phi_2980_ = i32();
phi_2982_ = i32();
}
let _e1641 = phi_2975_;
let _e1643 = phi_2978_;
let _e1645 = phi_2980_;
let _e1647 = phi_2982_;
continue;
continuing {
phi_2974_ = _e1641;
phi_2977_ = _e1643;
phi_2979_ = _e1645;
phi_2981_ = _e1647;
break if !(_e1626);
}
}
let _e1650 = local_40;
let _e1651 = f32(_e1650);
let _e1653 = ((_e1560 * _e1651) - 0.5f);
let _e1655 = local_41;
let _e1656 = f32(_e1655);
let _e1658 = ((_e1615 * _e1656) - 0.5f);
let _e1660 = select(-1f, _e1653, (_e1653 > -1f));
let _e1662 = select(_e1651, _e1660, (_e1660 < _e1651));
let _e1669 = select(0i, select(select(i32(_e1662), i32(-2147483648), (_e1662 < -2147483600f)), 2147483647i, (_e1662 > 2147483500f)), (_e1662 == _e1662));
let _e1673 = (_e1669 - select(0i, 1i, (_e1662 < f32(_e1669))));
let _e1675 = select(-1f, _e1658, (_e1658 > -1f));
let _e1677 = select(_e1656, _e1675, (_e1675 < _e1656));
let _e1684 = select(0i, select(select(i32(_e1677), i32(-2147483648), (_e1677 < -2147483600f)), 2147483647i, (_e1677 > 2147483500f)), (_e1677 == _e1677));
let _e1688 = (_e1684 - select(0i, 1i, (_e1677 < f32(_e1684))));
let _e1690 = (_e1653 - f32(_e1673));
let _e1692 = (_e1658 - f32(_e1688));
let _e1694 = select(0f, _e1692, (_e1692 > 0f));
let _e1696 = select(1f, _e1694, (_e1694 < 1f));
if (_e1673 < 0i) {
let _e1699 = local_42;
phi_3077_ = (_e1673 + _e1699);
} else {
phi_3077_ = _e1673;
}
let _e1702 = phi_3077_;
let _e1704 = local_43;
if (_e1702 >= _e1704) {
let _e1707 = local_44;
phi_3083_ = (_e1702 - _e1707);
} else {
phi_3083_ = _e1702;
}
let _e1710 = phi_3083_;
let _e1711 = (_e1673 + 1i);
if (_e1711 < 0i) {
let _e1714 = local_45;
phi_3090_ = (_e1711 + _e1714);
} else {
phi_3090_ = _e1711;
}
let _e1717 = phi_3090_;
let _e1719 = local_46;
if (_e1717 >= _e1719) {
let _e1722 = local_47;
phi_3096_ = (_e1717 - _e1722);
} else {
phi_3096_ = _e1717;
}
let _e1725 = phi_3096_;
let _e1727 = select(_e1688, 0i, (_e1688 < 0i));
let _e1729 = local_48;
if (_e1727 >= _e1729) {
let _e1732 = local_49;
phi_3107_ = (_e1732 - 1i);
} else {
phi_3107_ = _e1727;
}
let _e1735 = phi_3107_;
let _e1736 = (_e1688 + 1i);
let _e1738 = select(_e1736, 0i, (_e1736 < 0i));
let _e1740 = local_50;
if (_e1738 >= _e1740) {
let _e1743 = local_51;
phi_3119_ = (_e1743 - 1i);
} else {
phi_3119_ = _e1738;
}
let _e1746 = phi_3119_;
let _e1748 = local_52;
let _e1751 = local_53;
let _e1752 = (_e1751 + (_e1735 * _e1748));
let _e1754 = local_54;
let _e1757 = local_55;
let _e1758 = (_e1757 + (_e1746 * _e1754));
let _e1760 = (3i * (_e1752 + _e1710));
let _e1762 = (bitcast<i32>(_e149) - 1i);
let _e1764 = select(_e1762, _e1760, (_e1760 < _e1762));
let _e1770 = global_3.member[bitcast<u32>(select(0i, _e1764, (_e1764 > 0i)))];
let _e1771 = (_e1760 + 1i);
let _e1773 = select(_e1762, _e1771, (_e1771 < _e1762));
let _e1779 = global_3.member[bitcast<u32>(select(0i, _e1773, (_e1773 > 0i)))];
let _e1780 = (_e1760 + 2i);
let _e1782 = select(_e1762, _e1780, (_e1780 < _e1762));
let _e1788 = global_3.member[bitcast<u32>(select(0i, _e1782, (_e1782 > 0i)))];
let _e1790 = (3i * (_e1752 + _e1725));
let _e1792 = select(_e1762, _e1790, (_e1790 < _e1762));
let _e1798 = global_3.member[bitcast<u32>(select(0i, _e1792, (_e1792 > 0i)))];
let _e1799 = (_e1790 + 1i);
let _e1801 = select(_e1762, _e1799, (_e1799 < _e1762));
let _e1807 = global_3.member[bitcast<u32>(select(0i, _e1801, (_e1801 > 0i)))];
let _e1808 = (_e1790 + 2i);
let _e1810 = select(_e1762, _e1808, (_e1808 < _e1762));
let _e1816 = global_3.member[bitcast<u32>(select(0i, _e1810, (_e1810 > 0i)))];
let _e1818 = (3i * (_e1758 + _e1710));
let _e1820 = select(_e1762, _e1818, (_e1818 < _e1762));
let _e1826 = global_3.member[bitcast<u32>(select(0i, _e1820, (_e1820 > 0i)))];
let _e1827 = (_e1818 + 1i);
let _e1829 = select(_e1762, _e1827, (_e1827 < _e1762));
let _e1835 = global_3.member[bitcast<u32>(select(0i, _e1829, (_e1829 > 0i)))];
let _e1836 = (_e1818 + 2i);
let _e1838 = select(_e1762, _e1836, (_e1836 < _e1762));
let _e1844 = global_3.member[bitcast<u32>(select(0i, _e1838, (_e1838 > 0i)))];
let _e1846 = (3i * (_e1758 + _e1725));
let _e1848 = select(_e1762, _e1846, (_e1846 < _e1762));
let _e1854 = global_3.member[bitcast<u32>(select(0i, _e1848, (_e1848 > 0i)))];
let _e1855 = (_e1846 + 1i);
let _e1857 = select(_e1762, _e1855, (_e1855 < _e1762));
let _e1863 = global_3.member[bitcast<u32>(select(0i, _e1857, (_e1857 > 0i)))];
let _e1864 = (_e1846 + 2i);
let _e1866 = select(_e1762, _e1864, (_e1864 < _e1762));
let _e1872 = global_3.member[bitcast<u32>(select(0i, _e1866, (_e1866 > 0i)))];
let _e1879 = (_e1770 + ((_e1798 - _e1770) * _e1690));
let _e1880 = (_e1779 + ((_e1807 - _e1779) * _e1690));
let _e1881 = (_e1788 + ((_e1816 - _e1788) * _e1690));
let _e1897 = (_e1879 + (((_e1826 + ((_e1854 - _e1826) * _e1690)) - _e1879) * _e1696));
let _e1898 = (_e1880 + (((_e1835 + ((_e1863 - _e1835) * _e1690)) - _e1880) * _e1696));
let _e1899 = (_e1881 + (((_e1844 + ((_e1872 - _e1844) * _e1690)) - _e1881) * _e1696));
phi_3353_ = 0i;
phi_3356_ = 0i;
phi_3358_ = _e1617;
phi_3360_ = _e1447;
loop {
let _e1902 = phi_3353_;
let _e1904 = phi_3356_;
let _e1906 = phi_3358_;
let _e1908 = phi_3360_;
local_56 = _e1908;
local_57 = _e1906;
local_58 = _e1908;
local_59 = _e1908;
local_60 = _e1908;
local_61 = _e1908;
local_62 = _e1908;
local_63 = _e1908;
local_64 = _e1906;
local_65 = _e1906;
local_66 = _e1906;
local_67 = _e1906;
local_68 = _e1908;
local_69 = _e1904;
local_70 = _e1908;
local_71 = _e1904;
let _e1909 = (_e1902 < (_e1515 + 1i));
if _e1909 {
if (_e1908 > 1i) {
phi_3375_ = (_e1908 >> bitcast<u32>(1i));
} else {
phi_3375_ = 1i;
}
let _e1916 = phi_3375_;
if (_e1906 > 1i) {
phi_3381_ = (_e1906 >> bitcast<u32>(1i));
} else {
phi_3381_ = 1i;
}
let _e1921 = phi_3381_;
phi_3354_ = (_e1902 + 1i);
phi_3357_ = (_e1904 + (_e1908 * _e1906));
phi_3359_ = _e1921;
phi_3361_ = _e1916;
} else {
phi_3354_ = i32();
phi_3357_ = i32();
phi_3359_ = i32();
phi_3361_ = i32();
}
let _e1924 = phi_3354_;
let _e1926 = phi_3357_;
let _e1928 = phi_3359_;
let _e1930 = phi_3361_;
continue;
continuing {
phi_3353_ = _e1924;
phi_3356_ = _e1926;
phi_3358_ = _e1928;
phi_3360_ = _e1930;
break if !(_e1909);
}
}
let _e1933 = local_56;
let _e1934 = f32(_e1933);
let _e1936 = ((_e1560 * _e1934) - 0.5f);
let _e1938 = local_57;
let _e1939 = f32(_e1938);
let _e1941 = ((_e1615 * _e1939) - 0.5f);
let _e1943 = select(-1f, _e1936, (_e1936 > -1f));
let _e1945 = select(_e1934, _e1943, (_e1943 < _e1934));
let _e1952 = select(0i, select(select(i32(_e1945), i32(-2147483648), (_e1945 < -2147483600f)), 2147483647i, (_e1945 > 2147483500f)), (_e1945 == _e1945));
let _e1956 = (_e1952 - select(0i, 1i, (_e1945 < f32(_e1952))));
let _e1958 = select(-1f, _e1941, (_e1941 > -1f));
let _e1960 = select(_e1939, _e1958, (_e1958 < _e1939));
let _e1967 = select(0i, select(select(i32(_e1960), i32(-2147483648), (_e1960 < -2147483600f)), 2147483647i, (_e1960 > 2147483500f)), (_e1960 == _e1960));
let _e1971 = (_e1967 - select(0i, 1i, (_e1960 < f32(_e1967))));
let _e1973 = (_e1936 - f32(_e1956));
let _e1975 = (_e1941 - f32(_e1971));
let _e1977 = select(0f, _e1975, (_e1975 > 0f));
let _e1979 = select(1f, _e1977, (_e1977 < 1f));
if (_e1956 < 0i) {
let _e1982 = local_58;
phi_3456_ = (_e1956 + _e1982);
} else {
phi_3456_ = _e1956;
}
let _e1985 = phi_3456_;
let _e1987 = local_59;
if (_e1985 >= _e1987) {
let _e1990 = local_60;
phi_3462_ = (_e1985 - _e1990);
} else {
phi_3462_ = _e1985;
}
let _e1993 = phi_3462_;
let _e1994 = (_e1956 + 1i);
if (_e1994 < 0i) {
let _e1997 = local_61;
phi_3469_ = (_e1994 + _e1997);
} else {
phi_3469_ = _e1994;
}
let _e2000 = phi_3469_;
let _e2002 = local_62;
if (_e2000 >= _e2002) {
let _e2005 = local_63;
phi_3475_ = (_e2000 - _e2005);
} else {
phi_3475_ = _e2000;
}
let _e2008 = phi_3475_;
let _e2010 = select(_e1971, 0i, (_e1971 < 0i));
let _e2012 = local_64;
if (_e2010 >= _e2012) {
let _e2015 = local_65;
phi_3486_ = (_e2015 - 1i);
} else {
phi_3486_ = _e2010;
}
let _e2018 = phi_3486_;
let _e2019 = (_e1971 + 1i);
let _e2021 = select(_e2019, 0i, (_e2019 < 0i));
let _e2023 = local_66;
if (_e2021 >= _e2023) {
let _e2026 = local_67;
phi_3498_ = (_e2026 - 1i);
} else {
phi_3498_ = _e2021;
}
let _e2029 = phi_3498_;
let _e2031 = local_68;
let _e2034 = local_69;
let _e2035 = (_e2034 + (_e2018 * _e2031));
let _e2037 = local_70;
let _e2040 = local_71;
let _e2041 = (_e2040 + (_e2029 * _e2037));
let _e2043 = (3i * (_e2035 + _e1993));
let _e2045 = select(_e1762, _e2043, (_e2043 < _e1762));
let _e2051 = global_3.member[bitcast<u32>(select(0i, _e2045, (_e2045 > 0i)))];
let _e2052 = (_e2043 + 1i);
let _e2054 = select(_e1762, _e2052, (_e2052 < _e1762));
let _e2060 = global_3.member[bitcast<u32>(select(0i, _e2054, (_e2054 > 0i)))];
let _e2061 = (_e2043 + 2i);
let _e2063 = select(_e1762, _e2061, (_e2061 < _e1762));
let _e2069 = global_3.member[bitcast<u32>(select(0i, _e2063, (_e2063 > 0i)))];
let _e2071 = (3i * (_e2035 + _e2008));
let _e2073 = select(_e1762, _e2071, (_e2071 < _e1762));
let _e2079 = global_3.member[bitcast<u32>(select(0i, _e2073, (_e2073 > 0i)))];
let _e2080 = (_e2071 + 1i);
let _e2082 = select(_e1762, _e2080, (_e2080 < _e1762));
let _e2088 = global_3.member[bitcast<u32>(select(0i, _e2082, (_e2082 > 0i)))];
let _e2089 = (_e2071 + 2i);
let _e2091 = select(_e1762, _e2089, (_e2089 < _e1762));
let _e2097 = global_3.member[bitcast<u32>(select(0i, _e2091, (_e2091 > 0i)))];
let _e2099 = (3i * (_e2041 + _e1993));
let _e2101 = select(_e1762, _e2099, (_e2099 < _e1762));
let _e2107 = global_3.member[bitcast<u32>(select(0i, _e2101, (_e2101 > 0i)))];
let _e2108 = (_e2099 + 1i);
let _e2110 = select(_e1762, _e2108, (_e2108 < _e1762));
let _e2116 = global_3.member[bitcast<u32>(select(0i, _e2110, (_e2110 > 0i)))];
let _e2117 = (_e2099 + 2i);
let _e2119 = select(_e1762, _e2117, (_e2117 < _e1762));
let _e2125 = global_3.member[bitcast<u32>(select(0i, _e2119, (_e2119 > 0i)))];
let _e2127 = (3i * (_e2041 + _e2008));
let _e2129 = select(_e1762, _e2127, (_e2127 < _e1762));
let _e2135 = global_3.member[bitcast<u32>(select(0i, _e2129, (_e2129 > 0i)))];
let _e2136 = (_e2127 + 1i);
let _e2138 = select(_e1762, _e2136, (_e2136 < _e1762));
let _e2144 = global_3.member[bitcast<u32>(select(0i, _e2138, (_e2138 > 0i)))];
let _e2145 = (_e2127 + 2i);
let _e2147 = select(_e1762, _e2145, (_e2145 < _e1762));
let _e2153 = global_3.member[bitcast<u32>(select(0i, _e2147, (_e2147 > 0i)))];
let _e2160 = (_e2051 + ((_e2079 - _e2051) * _e1973));
let _e2161 = (_e2060 + ((_e2088 - _e2060) * _e1973));
let _e2162 = (_e2069 + ((_e2097 - _e2069) * _e1973));
let _e2185 = (_e1497 - f32(_e1515));
let _e2187 = select(0f, _e2185, (_e2185 > 0f));
let _e2189 = select(1f, _e2187, (_e2187 < 1f));
phi_3752_ = vec3<f32>(((_e1897 + (((_e2160 + (((_e2107 + ((_e2135 - _e2107) * _e1973)) - _e2160) * _e1979)) - _e1897) * _e2189)) * _e1171.member_3), ((_e1898 + (((_e2161 + (((_e2116 + ((_e2144 - _e2116) * _e1973)) - _e2161) * _e1979)) - _e1898) * _e2189)) * _e1171.member_3), ((_e1899 + (((_e2162 + (((_e2125 + ((_e2153 - _e2125) * _e1973)) - _e2162) * _e1979)) - _e1899) * _e2189)) * _e1171.member_3));
}
let _e2202 = phi_3752_;
phi_3753_ = _e2202;
}
let _e2204 = phi_3753_;
phi_3754_ = _e2204;
}
let _e2206 = phi_3754_;
if _e278 {
let _e2207 = local_39;
let _e2209 = local_38;
let _e2210 = ((23i * _e2207) + _e2209);
let _e2212 = select(_e190, _e2210, (_e2210 < _e190));
let _e2217 = global_2.member[bitcast<u32>(select(0i, _e2212, (_e2212 > 0i)))];
let _e2224 = select(0i, select(select(i32(_e2217), i32(-2147483648), (_e2217 < -2147483600f)), 2147483647i, (_e2217 > 2147483500f)), (_e2217 == _e2217));
let _e2225 = local_38;
local_2 = _e2225;
local_3 = _e183;
let _e2226 = local_2;
let _e2228 = select(_e190, _e2226, (_e2226 < _e190));
let _e2233 = global_2.member[bitcast<u32>(select(0i, _e2228, (_e2228 > 0i)))];
let _e2234 = local_3;
let _e2235 = local_2;
let _e2236 = (_e2234 + _e2235);
let _e2238 = select(_e190, _e2236, (_e2236 < _e190));
let _e2243 = global_2.member[bitcast<u32>(select(0i, _e2238, (_e2238 > 0i)))];
let _e2244 = local_3;
let _e2246 = local_2;
let _e2247 = ((2i * _e2244) + _e2246);
let _e2249 = select(_e190, _e2247, (_e2247 < _e190));
let _e2254 = global_2.member[bitcast<u32>(select(0i, _e2249, (_e2249 > 0i)))];
let _e2255 = vec3<f32>(_e2233, _e2243, _e2254);
if (_e2224 < 0i) {
let _e2257 = (_e2224 == -3i);
let _e2260 = global_1.member.member_19;
let _e2266 = global_1.member.member_17;
let _e2273 = vec3<f32>(select(_e2266.member, _e2260.member, _e2257), select(_e2266.member_1, _e2260.member_1, _e2257), select(_e2266.member_2, _e2260.member_2, _e2257));
let _e2276 = global_1.member.member_20;
let _e2282 = global_1.member.member_18;
phi_4583_ = type_14(_e2255, _e2273, _e2273, vec3<f32>(select(_e2282.member, _e2276.member, _e2257), select(_e2282.member_1, _e2276.member_1, _e2257), select(_e2282.member_2, _e2276.member_2, _e2257)), 0f, false);
} else {
let _e2291 = (_e2224 * 19i);
let _e2293 = (bitcast<i32>(_e151) - 1i);
let _e2295 = select(_e2293, _e2291, (_e2291 < _e2293));
let _e2301 = global_4.member[bitcast<u32>(select(0i, _e2295, (_e2295 > 0i)))];
let _e2302 = (_e2291 + 1i);
let _e2304 = select(_e2293, _e2302, (_e2302 < _e2293));
let _e2310 = global_4.member[bitcast<u32>(select(0i, _e2304, (_e2304 > 0i)))];
let _e2311 = (_e2291 + 2i);
let _e2313 = select(_e2293, _e2311, (_e2311 < _e2293));
let _e2319 = global_4.member[bitcast<u32>(select(0i, _e2313, (_e2313 > 0i)))];
let _e2320 = (_e2291 + 3i);
let _e2322 = select(_e2293, _e2320, (_e2320 < _e2293));
let _e2328 = global_4.member[bitcast<u32>(select(0i, _e2322, (_e2322 > 0i)))];
let _e2329 = (_e2291 + 4i);
let _e2331 = select(_e2293, _e2329, (_e2329 < _e2293));
let _e2337 = global_4.member[bitcast<u32>(select(0i, _e2331, (_e2331 > 0i)))];
let _e2338 = (_e2291 + 5i);
let _e2340 = select(_e2293, _e2338, (_e2338 < _e2293));
let _e2346 = global_4.member[bitcast<u32>(select(0i, _e2340, (_e2340 > 0i)))];
let _e2347 = (_e2291 + 6i);
let _e2349 = select(_e2293, _e2347, (_e2347 < _e2293));
let _e2355 = global_4.member[bitcast<u32>(select(0i, _e2349, (_e2349 > 0i)))];
let _e2356 = (_e2291 + 7i);
let _e2358 = select(_e2293, _e2356, (_e2356 < _e2293));
let _e2364 = global_4.member[bitcast<u32>(select(0i, _e2358, (_e2358 > 0i)))];
let _e2365 = (_e2291 + 8i);
let _e2367 = select(_e2293, _e2365, (_e2365 < _e2293));
let _e2373 = global_4.member[bitcast<u32>(select(0i, _e2367, (_e2367 > 0i)))];
let _e2374 = (_e2328 - _e2301);
let _e2375 = (_e2337 - _e2310);
let _e2376 = (_e2346 - _e2319);
let _e2377 = (_e2355 - _e2301);
let _e2378 = (_e2364 - _e2310);
let _e2379 = (_e2373 - _e2319);
let _e2382 = ((_e2375 * _e2379) - (_e2376 * _e2378));
let _e2385 = ((_e2376 * _e2377) - (_e2374 * _e2379));
let _e2388 = ((_e2374 * _e2378) - (_e2375 * _e2377));
let _e2389 = (_e2328 - _e2233);
let _e2390 = (_e2337 - _e2243);
let _e2391 = (_e2346 - _e2254);
let _e2392 = (_e2355 - _e2233);
let _e2393 = (_e2364 - _e2243);
let _e2394 = (_e2373 - _e2254);
let _e2408 = (((((_e2390 * _e2394) - (_e2391 * _e2393)) * _e2382) + (((_e2391 * _e2392) - (_e2389 * _e2394)) * _e2385)) + (((_e2389 * _e2393) - (_e2390 * _e2392)) * _e2388));
let _e2410 = select(0f, _e2408, (_e2408 > 0f));
let _e2411 = (_e2301 - _e2233);
let _e2412 = (_e2310 - _e2243);
let _e2413 = (_e2319 - _e2254);
let _e2427 = (((((_e2393 * _e2413) - (_e2394 * _e2412)) * _e2382) + (((_e2394 * _e2411) - (_e2392 * _e2413)) * _e2385)) + (((_e2392 * _e2412) - (_e2393 * _e2411)) * _e2388));
let _e2429 = select(0f, _e2427, (_e2427 > 0f));
let _e2443 = (((((_e2412 * _e2391) - (_e2413 * _e2390)) * _e2382) + (((_e2413 * _e2389) - (_e2411 * _e2391)) * _e2385)) + (((_e2411 * _e2390) - (_e2412 * _e2389)) * _e2388));
let _e2445 = select(0f, _e2443, (_e2443 > 0f));
let _e2447 = ((_e2410 + _e2429) + _e2445);
let _e2449 = select(1e-30f, _e2447, (_e2447 > 1e-30f));
let _e2450 = (_e2410 / _e2449);
let _e2451 = (_e2429 / _e2449);
let _e2452 = (_e2445 / _e2449);
let _e2457 = (((_e2382 * _e2382) + (_e2385 * _e2385)) + (_e2388 * _e2388));
let _e2460 = sqrt(select(0f, _e2457, (_e2457 > 0f)));
let _e2463 = (1f / select(1e-20f, _e2460, (_e2460 > 1e-20f)));
let _e2468 = (_e2291 + 9i);
let _e2470 = select(_e2293, _e2468, (_e2468 < _e2293));
let _e2476 = global_4.member[bitcast<u32>(select(0i, _e2470, (_e2470 > 0i)))];
let _e2477 = (_e2291 + 10i);
let _e2479 = select(_e2293, _e2477, (_e2477 < _e2293));
let _e2485 = global_4.member[bitcast<u32>(select(0i, _e2479, (_e2479 > 0i)))];
let _e2486 = (_e2291 + 11i);
let _e2488 = select(_e2293, _e2486, (_e2486 < _e2293));
let _e2494 = global_4.member[bitcast<u32>(select(0i, _e2488, (_e2488 > 0i)))];
let _e2498 = (_e2291 + 12i);
let _e2500 = select(_e2293, _e2498, (_e2498 < _e2293));
let _e2506 = global_4.member[bitcast<u32>(select(0i, _e2500, (_e2500 > 0i)))];
let _e2507 = (_e2291 + 13i);
let _e2509 = select(_e2293, _e2507, (_e2507 < _e2293));
let _e2515 = global_4.member[bitcast<u32>(select(0i, _e2509, (_e2509 > 0i)))];
let _e2516 = (_e2291 + 14i);
let _e2518 = select(_e2293, _e2516, (_e2516 < _e2293));
let _e2524 = global_4.member[bitcast<u32>(select(0i, _e2518, (_e2518 > 0i)))];
let _e2531 = (_e2291 + 15i);
let _e2533 = select(_e2293, _e2531, (_e2531 < _e2293));
let _e2539 = global_4.member[bitcast<u32>(select(0i, _e2533, (_e2533 > 0i)))];
let _e2540 = (_e2291 + 16i);
let _e2542 = select(_e2293, _e2540, (_e2540 < _e2293));
let _e2548 = global_4.member[bitcast<u32>(select(0i, _e2542, (_e2542 > 0i)))];
let _e2549 = (_e2291 + 17i);
let _e2551 = select(_e2293, _e2549, (_e2549 < _e2293));
let _e2557 = global_4.member[bitcast<u32>(select(0i, _e2551, (_e2551 > 0i)))];
let _e2561 = (((_e2476 * _e2450) + (_e2506 * _e2451)) + (_e2539 * _e2452));
let _e2562 = (((_e2485 * _e2450) + (_e2515 * _e2451)) + (_e2548 * _e2452));
let _e2563 = (((_e2494 * _e2450) + (_e2524 * _e2451)) + (_e2557 * _e2452));
let _e2568 = (((_e2561 * _e2561) + (_e2562 * _e2562)) + (_e2563 * _e2563));
let _e2571 = sqrt(select(0f, _e2568, (_e2568 > 0f)));
let _e2574 = (1f / select(1e-20f, _e2571, (_e2571 > 1e-20f)));
let _e2582 = global_1.member.member[3u];
let _e2585 = (_e2291 + 18i);
let _e2587 = select(_e2293, _e2585, (_e2585 < _e2293));
let _e2593 = global_4.member[bitcast<u32>(select(0i, _e2587, (_e2587 > 0i)))];
let _e2602 = (select(select(0i, select(select(i32(_e2593), i32(-2147483648), (_e2593 < -2147483600f)), 2147483647i, (_e2593 > 2147483500f)), (_e2593 == _e2593)), _e2224, ((_e2582 & 4u) != 0u)) * 10i);
let _e2604 = (bitcast<i32>(_e153) - 1i);
let _e2606 = select(_e2604, _e2602, (_e2602 < _e2604));
let _e2612 = global_5.member[bitcast<u32>(select(0i, _e2606, (_e2606 > 0i)))];
let _e2613 = (_e2602 + 1i);
let _e2615 = select(_e2604, _e2613, (_e2613 < _e2604));
let _e2621 = global_5.member[bitcast<u32>(select(0i, _e2615, (_e2615 > 0i)))];
let _e2622 = (_e2602 + 2i);
let _e2624 = select(_e2604, _e2622, (_e2622 < _e2604));
let _e2630 = global_5.member[bitcast<u32>(select(0i, _e2624, (_e2624 > 0i)))];
let _e2634 = (_e2602 + 3i);
let _e2636 = select(_e2604, _e2634, (_e2634 < _e2604));
let _e2642 = global_5.member[bitcast<u32>(select(0i, _e2636, (_e2636 > 0i)))];
let _e2643 = (_e2602 + 4i);
let _e2645 = select(_e2604, _e2643, (_e2643 < _e2604));
let _e2651 = global_5.member[bitcast<u32>(select(0i, _e2645, (_e2645 > 0i)))];
let _e2652 = (_e2602 + 5i);
let _e2654 = select(_e2604, _e2652, (_e2652 < _e2604));
let _e2660 = global_5.member[bitcast<u32>(select(0i, _e2654, (_e2654 > 0i)))];
let _e2667 = (_e2602 + 6i);
let _e2669 = select(_e2604, _e2667, (_e2667 < _e2604));
let _e2675 = global_5.member[bitcast<u32>(select(0i, _e2669, (_e2669 > 0i)))];
let _e2676 = (_e2602 + 7i);
let _e2678 = select(_e2604, _e2676, (_e2676 < _e2604));
let _e2684 = global_5.member[bitcast<u32>(select(0i, _e2678, (_e2678 > 0i)))];
let _e2685 = (_e2602 + 8i);
let _e2687 = select(_e2604, _e2685, (_e2685 < _e2604));
let _e2693 = global_5.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2701 = (_e2602 + 9i);
let _e2703 = select(_e2604, _e2701, (_e2701 < _e2604));
let _e2709 = global_5.member[bitcast<u32>(select(0i, _e2703, (_e2703 > 0i)))];
phi_4583_ = type_14(_e2255, vec3<f32>((_e2382 * _e2463), (_e2385 * _e2463), (_e2388 * _e2463)), vec3<f32>((_e2561 * _e2574), (_e2562 * _e2574), (_e2563 * _e2574)), vec3<f32>((((_e2612 * _e2450) + (_e2642 * _e2451)) + (_e2675 * _e2452)), (((_e2621 * _e2450) + (_e2651 * _e2451)) + (_e2684 * _e2452)), (((_e2630 * _e2450) + (_e2660 * _e2451)) + (_e2693 * _e2452))), _e2709, true);
}
let _e2712 = phi_4583_;
let _e2721 = (((_e2712.member_1.x * _e197) + (_e2712.member_1.y * _e208)) + (_e2712.member_1.z * _e219));
let _e2723 = select(1f, -1f, (_e2721 > 0f));
let _e2735 = select(_e2723, -(_e2723), ((((_e2712.member_2.x * _e2712.member_1.x) + (_e2712.member_2.y * _e2712.member_1.y)) + (_e2712.member_2.z * _e2712.member_1.z)) < 0f));
let _e2736 = (_e2712.member_2.x * _e2735);
let _e2737 = (_e2712.member_2.y * _e2735);
let _e2738 = (_e2712.member_2.z * _e2735);
let _e2747 = ((((_e2736 * _e197) + (_e2737 * _e208)) + (_e2738 * _e219)) > 0f);
let _e2748 = select(_e2736, (_e2712.member_1.x * _e2723), _e2747);
let _e2749 = select(_e2737, (_e2712.member_1.y * _e2723), _e2747);
let _e2750 = select(_e2738, (_e2712.member_1.z * _e2723), _e2747);
let _e2753 = global_1.member.member_21;
let _e2762 = -((((_e2748 * _e2753.member) + (_e2749 * _e2753.member_1)) + (_e2750 * _e2753.member_2)));
let _e2768 = -((((_e2712.member_1.x * _e2753.member) + (_e2712.member_1.y * _e2753.member_1)) + (_e2712.member_1.z * _e2753.member_2)));
let _e2774 = -(_e2762);
let _e2779 = select((select(0f, _e2774, (_e2774 > 0f)) * _e2712.member_4), select(0f, _e2762, (_e2762 > 0f)), ((_e2768 * -(_e2721)) > 0f));
let _e2780 = -(_e2768);
let _e2782 = select(_e2780, _e2768, (_e2768 > _e2780));
let _e2784 = select(1f, _e2782, (_e2782 < 1f));
let _e2788 = (1f - (_e2784 * _e2784));
let _e2795 = global_1.member.member_28.member;
let _e2802 = global_1.member.member_28.member_1;
let _e2804 = (select(1f, -1f, (_e2768 < 0f)) * ((((1.4142135f * _e2795) * sqrt(select(0f, _e2788, (_e2788 > 0f)))) + _e2784) * _e2802));
let _e2809 = select(0f, 1f, _e2712.member_5);
let _e2815 = (_e2712.member.x + ((_e2712.member_1.x * _e2804) * _e2809));
let _e2817 = (_e2712.member.y + ((_e2712.member_1.y * _e2804) * _e2809));
let _e2819 = (_e2712.member.z + ((_e2712.member_1.z * _e2804) * _e2809));
let _e2823 = global_1.member.member_24[0u];
let _e2824 = bitcast<i32>(_e2823);
let _e2828 = global_1.member.member_24[1u];
let _e2829 = bitcast<i32>(_e2828);
let _e2833 = global_1.member.member_24[2u];
let _e2834 = bitcast<i32>(_e2833);
let _e2838 = global_1.member.member_24[3u];
let _e2839 = bitcast<i32>(_e2838);
let _e2842 = global_1.member.member_25;
let _e2854 = global_1.member.member_25.member_3;
let _e2855 = ((((_e2842.member * _e2815) + (_e2842.member_1 * _e2817)) + (_e2842.member_2 * _e2819)) + _e2854);
let _e2858 = global_1.member.member_26;
let _e2870 = global_1.member.member_26.member_3;
let _e2872 = (((((_e2858.member * _e2815) + (_e2858.member_1 * _e2817)) + (_e2858.member_2 * _e2819)) + _e2870) - 0.5f);
let _e2875 = global_1.member.member_27;
let _e2887 = global_1.member.member_27.member_3;
let _e2889 = (((((_e2875.member * _e2815) + (_e2875.member_1 * _e2817)) + (_e2875.member_2 * _e2819)) + _e2887) - 0.5f);
let _e2891 = f32((_e2824 - 1i));
let _e2893 = select(0f, _e2855, (_e2855 > 0f));
let _e2895 = select(_e2891, _e2893, (_e2893 < _e2891));
let _e2902 = select(0i, select(select(i32(_e2895), i32(-2147483648), (_e2895 < -2147483600f)), 2147483647i, (_e2895 > 2147483500f)), (_e2895 == _e2895));
let _e2906 = (_e2902 - select(0i, 1i, (_e2895 < f32(_e2902))));
let _e2910 = (_e2855 - f32(_e2906));
let _e2913 = select(1f, select(0f, _e2910, (_e2910 > 0f)), (_e2855 < f32(_e2824)));
let _e2914 = (_e2872 - _e2795);
let _e2915 = -(16f);
let _e2916 = f32(_e2829);
let _e2918 = select(_e2915, _e2914, (_e2914 > _e2915));
let _e2920 = select(_e2916, _e2918, (_e2918 < _e2916));
let _e2927 = select(0i, select(select(i32(_e2920), i32(-2147483648), (_e2920 < -2147483600f)), 2147483647i, (_e2920 > 2147483500f)), (_e2920 == _e2920));
let _e2933 = (_e2872 + _e2795);
let _e2936 = (f32((_e2829 - 1i)) + 16f);
let _e2938 = select(-1f, _e2933, (_e2933 > -1f));
let _e2940 = select(_e2936, _e2938, (_e2938 < _e2936));
let _e2947 = select(0i, select(select(i32(_e2940), i32(-2147483648), (_e2940 < -2147483600f)), 2147483647i, (_e2940 > 2147483500f)), (_e2940 == _e2940));
let _e2952 = (_e2889 - _e2795);
let _e2953 = f32(_e2834);
let _e2955 = select(_e2915, _e2952, (_e2952 > _e2915));
let _e2957 = select(_e2953, _e2955, (_e2955 < _e2953));
let _e2964 = select(0i, select(select(i32(_e2957), i32(-2147483648), (_e2957 < -2147483600f)), 2147483647i, (_e2957 > 2147483500f)), (_e2957 == _e2957));
let _e2970 = (_e2889 + _e2795);
let _e2973 = (f32((_e2834 - 1i)) + 16f);
let _e2975 = select(-1f, _e2970, (_e2970 > -1f));
let _e2977 = select(_e2973, _e2975, (_e2975 < _e2973));
let _e2984 = select(0i, select(select(i32(_e2977), i32(-2147483648), (_e2977 < -2147483600f)), 2147483647i, (_e2977 > 2147483500f)), (_e2977 == _e2977));
let _e2992 = bitcast<i32>(((_e2823 + 2u) >> bitcast<u32>(1i)));
let _e2994 = ((_e2829 * _e2834) * _e2992);
phi_4975_ = 0f;
phi_4978_ = vec3<f32>(0f, 0f, 0f);
phi_4980_ = ((_e2964 - select(0i, 1i, (_e2957 < f32(_e2964)))) + 1i);
loop {
let _e2996 = phi_4975_;
let _e2998 = phi_4978_;
let _e3000 = phi_4980_;
local_72 = _e2996;
local_73 = _e2996;
local_74 = _e2998;
local_75 = _e2998;
local_76 = _e2998;
let _e3001 = (_e3000 <= (_e2984 - select(0i, 1i, (_e2977 < f32(_e2984)))));
if _e3001 {
let _e3007 = (_e2795 - bitcast<f32>((bitcast<u32>((f32(_e3000) - _e2889)) & 2147483647u)));
phi_4995_ = ((_e2927 - select(0i, 1i, (_e2920 < f32(_e2927)))) + 1i);
phi_4998_ = _e2996;
phi_5000_ = _e2998;
loop {
let _e3009 = phi_4995_;
let _e3011 = phi_4998_;
let _e3013 = phi_5000_;
local_114 = _e3011;
local_115 = _e3013;
let _e3014 = (_e3009 <= (_e2947 - select(0i, 1i, (_e2940 < f32(_e2947)))));
if _e3014 {
let _e3020 = (_e2795 - bitcast<f32>((bitcast<u32>((f32(_e3009) - _e2872)) & 2147483647u)));
let _e3025 = (select(0f, _e3020, (_e3020 > 0f)) * select(0f, _e3007, (_e3007 > 0f)));
if ((((_e3009 >= 0i) && (_e3009 < _e2829)) && (_e3000 >= 0i)) && (_e3000 < _e2834)) {
let _e3035 = (((_e3000 * _e2829) + _e3009) * _e2992);
let _e3037 = (2i * _e2906);
let _e3038 = ((4i * _e3035) + _e3037);
let _e3040 = (_e3038 >> bitcast<u32>(2i));
let _e3043 = bitcast<u32>(((_e3038 & 3i) * 8i));
let _e3045 = (bitcast<i32>(_e155) - 1i);
let _e3047 = select(_e3045, _e3040, (_e3040 < _e3045));
let _e3053 = global_6.member[bitcast<u32>(select(0i, _e3047, (_e3047 > 0i)))];
let _e3057 = (_e3040 + 1i);
let _e3059 = select(_e3045, _e3057, (_e3057 < _e3045));
let _e3065 = global_6.member[bitcast<u32>(select(0i, _e3059, (_e3059 > 0i)))];
let _e3072 = ((_e3053 >> bitcast<u32>((_e3043 & 31u))) | ((_e3065 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3043) & 31u))));
let _e3075 = f32(bitcast<i32>((_e3072 & 65535u)));
let _e3083 = (1f / 65535f);
let _e3085 = (_e3025 * ((_e3075 + ((f32(bitcast<i32>((_e3072 >> bitcast<u32>(16i)))) - _e3075) * _e2913)) * _e3083));
let _e3087 = (_e3013.x + _e3085);
if (_e2839 > 1i) {
let _e3091 = ((4i * (_e3035 + _e2994)) + _e3037);
let _e3093 = (_e3091 >> bitcast<u32>(2i));
let _e3096 = bitcast<u32>(((_e3091 & 3i) * 8i));
let _e3098 = select(_e3045, _e3093, (_e3093 < _e3045));
let _e3104 = global_6.member[bitcast<u32>(select(0i, _e3098, (_e3098 > 0i)))];
let _e3108 = (_e3093 + 1i);
let _e3110 = select(_e3045, _e3108, (_e3108 < _e3045));
let _e3116 = global_6.member[bitcast<u32>(select(0i, _e3110, (_e3110 > 0i)))];
let _e3123 = ((_e3104 >> bitcast<u32>((_e3096 & 31u))) | ((_e3116 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3096) & 31u))));
let _e3126 = f32(bitcast<i32>((_e3123 & 65535u)));
let _e3141 = ((4i * (_e3035 + (2i * _e2994))) + _e3037);
let _e3143 = (_e3141 >> bitcast<u32>(2i));
let _e3146 = bitcast<u32>(((_e3141 & 3i) * 8i));
let _e3148 = select(_e3045, _e3143, (_e3143 < _e3045));
let _e3154 = global_6.member[bitcast<u32>(select(0i, _e3148, (_e3148 > 0i)))];
let _e3158 = (_e3143 + 1i);
let _e3160 = select(_e3045, _e3158, (_e3158 < _e3045));
let _e3166 = global_6.member[bitcast<u32>(select(0i, _e3160, (_e3160 > 0i)))];
let _e3173 = ((_e3154 >> bitcast<u32>((_e3146 & 31u))) | ((_e3166 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3146) & 31u))));
let _e3176 = f32(bitcast<i32>((_e3173 & 65535u)));
phi_5233_ = vec3<f32>(_e3087, (_e3013.y + (_e3025 * ((_e3126 + ((f32(bitcast<i32>((_e3123 >> bitcast<u32>(16i)))) - _e3126) * _e2913)) * _e3083))), (_e3013.z + (_e3025 * ((_e3176 + ((f32(bitcast<i32>((_e3173 >> bitcast<u32>(16i)))) - _e3176) * _e2913)) * _e3083))));
} else {
phi_5233_ = vec3<f32>(_e3087, (_e3013.y + _e3085), (_e3013.z + _e3085));
}
let _e3195 = phi_5233_;
phi_5243_ = _e3195;
} else {
phi_5243_ = vec3<f32>((_e3013.x + _e3025), (_e3013.y + _e3025), (_e3013.z + _e3025));
}
let _e3204 = phi_5243_;
phi_4996_ = (_e3009 + 1i);
phi_4999_ = (_e3011 + _e3025);
phi_5001_ = _e3204;
} else {
phi_4996_ = i32();
phi_4999_ = f32();
phi_5001_ = vec3<f32>();
}
let _e3208 = phi_4996_;
let _e3210 = phi_4999_;
let _e3212 = phi_5001_;
continue;
continuing {
phi_4995_ = _e3208;
phi_4998_ = _e3210;
phi_5000_ = _e3212;
break if !(_e3014);
}
}
let _e5789 = local_114;
phi_4976_ = _e5789;
let _e5792 = local_115;
phi_4979_ = _e5792;
phi_4981_ = (_e3000 + 1i);
} else {
phi_4976_ = f32();
phi_4979_ = vec3<f32>();
phi_4981_ = i32();
}
let _e3216 = phi_4976_;
let _e3218 = phi_4979_;
let _e3220 = phi_4981_;
continue;
continuing {
phi_4975_ = _e3216;
phi_4978_ = _e3218;
phi_4980_ = _e3220;
break if !(_e3001);
}
}
let _e3224 = local_72;
let _e3226 = ((_e2839 == 0i) || (_e3224 <= 0f));
let _e3228 = local_73;
let _e3230 = (1f / select(_e3228, 1f, _e3226));
let _e3232 = local_74;
let _e3237 = local_75;
let _e3242 = local_76;
let _e3252 = global_1.member.member_22.member;
let _e3257 = global_1.member.member_22.member_1;
let _e3262 = global_1.member.member_22.member_2;
let _e3266 = global_1.member.member_23;
if (_e264 == 0f) {
phi_5373_ = vec3<f32>(_e2748, _e2749, _e2750);
} else {
phi_5373_ = _e313;
}
let _e3286 = phi_5373_;
phi_5374_ = _e3286;
phi_5375_ = vec3<f32>((_e2712.member_3.x * ((_e3252 * (select((_e3232.x * _e3230), 1f, _e3226) * _e2779)) + _e3266.member)), (_e2712.member_3.y * ((_e3257 * (select((_e3237.y * _e3230), 1f, _e3226) * _e2779)) + _e3266.member_1)), (_e2712.member_3.z * ((_e3262 * (select((_e3242.z * _e3230), 1f, _e3226) * _e2779)) + _e3266.member_2)));
} else {
phi_5374_ = _e313;
phi_5375_ = _e2206;
}
let _e3288 = phi_5374_;
let _e3290 = phi_5375_;
let _e3297 = local_39;
let _e3299 = local_38;
let _e3300 = ((21i * _e3297) + _e3299);
let _e3302 = select(_e190, _e3300, (_e3300 < _e190));
let _e3307 = global_2.member[bitcast<u32>(select(0i, _e3302, (_e3302 > 0i)))];
local = _e182;
local_1 = _e183;
let _e3308 = local_1;
let _e3310 = local;
let _e3311 = ((9i * _e3308) + _e3310);
let _e3313 = select(_e190, _e3311, (_e3311 < _e190));
let _e3318 = global_2.member[bitcast<u32>(select(0i, _e3313, (_e3313 > 0i)))];
let _e3319 = local_1;
let _e3321 = local;
let _e3322 = ((10i * _e3319) + _e3321);
let _e3324 = select(_e190, _e3322, (_e3322 < _e190));
let _e3329 = global_2.member[bitcast<u32>(select(0i, _e3324, (_e3324 > 0i)))];
let _e3330 = local_1;
let _e3332 = local;
let _e3333 = ((11i * _e3330) + _e3332);
let _e3335 = select(_e190, _e3333, (_e3333 < _e190));
let _e3340 = global_2.member[bitcast<u32>(select(0i, _e3335, (_e3335 > 0i)))];
let _e3346 = (2f * (((_e1067 * _e3318) + (_e1068 * _e3329)) + (_e1069 * _e3340)));
let _e3350 = (_e1067 - (_e3318 * _e3346));
let _e3351 = (_e1068 - (_e3329 * _e3346));
let _e3352 = (_e1069 - (_e3340 * _e3346));
let _e3353 = (_e694 - _e525);
let _e3354 = (_e695 - _e526);
let _e3355 = (_e696 - _e527);
let _e3360 = (((_e3353 * _e3353) + (_e3354 * _e3354)) + (_e3355 * _e3355));
let _e3365 = (_e694 - _e3350);
let _e3366 = (_e695 - _e3351);
let _e3367 = (_e696 - _e3352);
let _e3372 = (((_e3365 * _e3365) + (_e3366 * _e3366)) + (_e3367 * _e3367));
let _e3376 = (_e3350 - _e525);
let _e3377 = (_e3351 - _e526);
let _e3378 = (_e3352 - _e527);
let _e3383 = (((_e3376 * _e3376) + (_e3377 * _e3377)) + (_e3378 * _e3378));
let _e3391 = select(select(_e1080, select(sqrt(select(0f, _e3383, (_e3383 > 0f))), sqrt(select(0f, _e3372, (_e3372 > 0f))), _e618), (_e406 || _e618)), (0.5f * sqrt(select(0f, _e3360, (_e3360 > 0f)))), (_e406 && _e618));
let _e3392 = (_e1044 - _e874);
let _e3393 = (_e1045 - _e875);
let _e3394 = (_e1046 - _e876);
let _e3399 = (((_e3392 * _e3392) + (_e3393 * _e3393)) + (_e3394 * _e3394));
let _e3404 = (_e1044 - _e3350);
let _e3405 = (_e1045 - _e3351);
let _e3406 = (_e1046 - _e3352);
let _e3411 = (((_e3404 * _e3404) + (_e3405 * _e3405)) + (_e3406 * _e3406));
let _e3415 = (_e3350 - _e874);
let _e3416 = (_e3351 - _e875);
let _e3417 = (_e3352 - _e876);
let _e3422 = (((_e3415 * _e3415) + (_e3416 * _e3416)) + (_e3417 * _e3417));
let _e3430 = select(select(_e1080, select(sqrt(select(0f, _e3422, (_e3422 > 0f))), sqrt(select(0f, _e3411, (_e3411 > 0f))), _e967), (_e788 || _e967)), (0.5f * sqrt(select(0f, _e3399, (_e3399 > 0f)))), (_e788 && _e967));
let _e3432 = select(_e3430, _e3391, (_e3391 > _e3430));
let _e3437 = (((_e1177.member * _e3350) + (_e1177.member_1 * _e3351)) + (_e1177.member_2 * _e3352));
let _e3442 = (((_e1188.member * _e3350) + (_e1188.member_1 * _e3351)) + (_e1188.member_2 * _e3352));
let _e3447 = (((_e1199.member * _e3350) + (_e1199.member_1 * _e3351)) + (_e1199.member_2 * _e3352));
if _e1216 {
phi_7152_ = _e1212;
} else {
if (_e1165.x == 1u) {
let _e3450 = select(-1f, _e3447, (_e3447 > -1f));
let _e3452 = select(1f, _e3450, (_e3450 < 1f));
if (_e3452 > 0f) {
phi_5775_ = _e1212;
} else {
phi_5775_ = vec3<f32>(_e1174.member, _e1174.member_1, _e1174.member_2);
}
let _e3459 = phi_5775_;
let _e3468 = bitcast<f32>((bitcast<u32>(_e3452) & 2147483647u));
let _e3471 = sqrt(select(0f, _e3468, (_e3468 > 0f)));
phi_7151_ = vec3<f32>((_e1171.member + ((_e3459.x - _e1171.member) * _e3471)), (_e1171.member_1 + ((_e3459.y - _e1171.member_1) * _e3471)), (_e1171.member_2 + ((_e3459.z - _e1171.member_2) * _e3471)));
} else {
if (_e1165.x == 2u) {
let _e3481 = (_e3432 / _e1168.member_3);
let _e3483 = select(1e-4f, _e3481, (_e3481 > 1e-4f));
let _e3486 = bitcast<f32>((bitcast<u32>(_e3437) & 2147483647u));
let _e3489 = bitcast<f32>((bitcast<u32>(_e3442) & 2147483647u));
let _e3493 = select(_e3489, _e3486, (_e3486 > _e3489));
let _e3496 = (select(_e3489, _e3486, (_e3486 < _e3489)) / select(1.1754944e-38f, _e3493, (_e3493 > 1.1754944e-38f)));
let _e3497 = (_e3496 > 0.41421357f);
let _e3501 = select(_e3496, ((_e3496 - 1f) / (_e3496 + 1f)), _e3497);
let _e3502 = (_e3501 * _e3501);
let _e3517 = (select(0f, 0.7853982f, _e3497) + (_e3501 + ((_e3501 * _e3502) * (-0.33333334f + (_e3502 * (0.2f + (_e3502 * (-0.14285713f + (_e3502 * (0.11111111f + (_e3502 * (-0.09090909f + (_e3502 * 0.0585f)))))))))))));
let _e3520 = select(_e3517, (1.5707964f - _e3517), (_e3489 > _e3486));
let _e3523 = select(_e3520, (3.1415927f - _e3520), (_e3437 < 0f));
let _e3529 = (1f - (_e3447 * _e3447));
let _e3532 = sqrt(select(0f, _e3529, (_e3529 > 0f)));
let _e3535 = (_e3483 / select(1e-3f, _e3532, (_e3532 > 1e-3f)));
let _e3536 = ((select(_e3523, -(_e3523), (_e3442 < 0f)) / _e1168.member_3) * 0.5f);
let _e3538 = select(-8e6f, _e3536, (_e3536 > -8e6f));
let _e3540 = select(8e6f, _e3538, (_e3538 < 8e6f));
let _e3547 = select(0i, select(select(i32(_e3540), i32(-2147483648), (_e3540 < -2147483600f)), 2147483647i, (_e3540 > 2147483500f)), (_e3540 == _e3540));
let _e3554 = ((_e3536 - f32((_e3547 - select(0i, 1i, (_e3540 < f32(_e3547)))))) * 2f);
let _e3562 = ((select(select((_e3554 - 2f), (1f - _e3554), (_e3554 < 1.5f)), _e3554, (_e3554 < 0.5f)) * 2f) / _e3535);
let _e3564 = select(-1f, _e3562, (_e3562 > -1f));
let _e3567 = (2f - _e3535);
let _e3569 = select(0f, _e3567, (_e3567 > 0f));
let _e3574 = select(-1f, _e3447, (_e3447 > -1f));
let _e3576 = select(1f, _e3574, (_e3574 < 1f));
let _e3579 = ((1f - _e3576) * (1f + _e3576));
let _e3582 = sqrt(select(0f, _e3579, (_e3579 > 0f)));
let _e3585 = bitcast<f32>((bitcast<u32>(_e3582) & 2147483647u));
let _e3588 = bitcast<f32>((bitcast<u32>(_e3576) & 2147483647u));
let _e3592 = select(_e3588, _e3585, (_e3585 > _e3588));
let _e3595 = (select(_e3588, _e3585, (_e3585 < _e3588)) / select(1.1754944e-38f, _e3592, (_e3592 > 1.1754944e-38f)));
let _e3596 = (_e3595 > 0.41421357f);
let _e3600 = select(_e3595, ((_e3595 - 1f) / (_e3595 + 1f)), _e3596);
let _e3601 = (_e3600 * _e3600);
let _e3616 = (select(0f, 0.7853982f, _e3596) + (_e3600 + ((_e3600 * _e3601) * (-0.33333334f + (_e3601 * (0.2f + (_e3601 * (-0.14285713f + (_e3601 * (0.11111111f + (_e3601 * (-0.09090909f + (_e3601 * 0.0585f)))))))))))));
let _e3619 = select(_e3616, (1.5707964f - _e3616), (_e3588 > _e3585));
let _e3622 = select(_e3619, (3.1415927f - _e3619), (_e3582 < 0f));
let _e3627 = ((select(_e3622, -(_e3622), (_e3576 < 0f)) / _e1168.member_3) * 0.5f);
let _e3629 = select(-8e6f, _e3627, (_e3627 > -8e6f));
let _e3631 = select(8e6f, _e3629, (_e3629 < 8e6f));
let _e3638 = select(0i, select(select(i32(_e3631), i32(-2147483648), (_e3631 < -2147483600f)), 2147483647i, (_e3631 > 2147483500f)), (_e3631 == _e3631));
let _e3645 = ((_e3627 - f32((_e3638 - select(0i, 1i, (_e3631 < f32(_e3638)))))) * 2f);
let _e3653 = ((select(select((_e3645 - 2f), (1f - _e3645), (_e3645 < 1.5f)), _e3645, (_e3645 < 0.5f)) * 2f) / _e3483);
let _e3655 = select(-1f, _e3653, (_e3653 > -1f));
let _e3658 = (2f - _e3483);
let _e3660 = select(0f, _e3658, (_e3658 > 0f));
let _e3666 = (0.5f + ((0.5f * (select(1f, _e3564, (_e3564 < 1f)) * select(1f, _e3569, (_e3569 < 1f)))) * (select(1f, _e3655, (_e3655 < 1f)) * select(1f, _e3660, (_e3660 < 1f)))));
phi_7150_ = vec3<f32>((_e1168.member + ((_e1171.member - _e1168.member) * _e3666)), (_e1168.member_1 + ((_e1171.member_1 - _e1168.member_1) * _e3666)), (_e1168.member_2 + ((_e1171.member_2 - _e1168.member_2) * _e3666)));
} else {
let _e3678 = bitcast<i32>(_e1165.y);
let _e3682 = f32(bitcast<i32>(_e1165.w));
let _e3684 = (2f * 3.1415927f);
let _e3685 = ((_e3432 * f32(_e3678)) / _e3684);
let _e3687 = select(1e-6f, _e3685, (_e3685 > 1e-6f));
let _e3690 = bitcast<u32>(select(1.1754944e-38f, _e3687, (_e3687 > 1.1754944e-38f)));
let _e3691 = (_e3690 & 8388607u);
let _e3693 = select(0u, 1u, (_e3691 > 3474675u));
let _e3704 = bitcast<f32>((_e3691 | ((127u - _e3693) << bitcast<u32>(23i))));
let _e3707 = ((_e3704 - 1f) / (_e3704 + 1f));
let _e3708 = (_e3707 * _e3707);
let _e3723 = (f32(((bitcast<i32>((_e3690 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e3693))) + (((2f * _e3707) + ((_e3707 * _e3708) * (0.6666667f + (_e3708 * (0.4f + (_e3708 * (0.2857143f + (_e3708 * (0.22222222f + (_e3708 * 0.18181819f)))))))))) * 1.442695f));
let _e3724 = (_e3682 - 1f);
let _e3726 = select(0f, _e3723, (_e3723 > 0f));
let _e3728 = select(_e3724, _e3726, (_e3726 < _e3724));
let _e3729 = (_e3682 - 2f);
let _e3731 = select(0f, _e3729, (_e3729 > 0f));
let _e3733 = select(0f, _e3728, (_e3728 > 0f));
let _e3735 = select(_e3731, _e3733, (_e3733 < _e3731));
let _e3742 = select(0i, select(select(i32(_e3735), i32(-2147483648), (_e3735 < -2147483600f)), 2147483647i, (_e3735 > 2147483500f)), (_e3735 == _e3735));
let _e3746 = (_e3742 - select(0i, 1i, (_e3735 < f32(_e3742))));
let _e3749 = bitcast<f32>((bitcast<u32>(_e3442) & 2147483647u));
let _e3752 = bitcast<f32>((bitcast<u32>(_e3437) & 2147483647u));
let _e3756 = select(_e3752, _e3749, (_e3749 > _e3752));
let _e3759 = (select(_e3752, _e3749, (_e3749 < _e3752)) / select(1.1754944e-38f, _e3756, (_e3756 > 1.1754944e-38f)));
let _e3760 = (_e3759 > 0.41421357f);
let _e3764 = select(_e3759, ((_e3759 - 1f) / (_e3759 + 1f)), _e3760);
let _e3765 = (_e3764 * _e3764);
let _e3780 = (select(0f, 0.7853982f, _e3760) + (_e3764 + ((_e3764 * _e3765) * (-0.33333334f + (_e3765 * (0.2f + (_e3765 * (-0.14285713f + (_e3765 * (0.11111111f + (_e3765 * (-0.09090909f + (_e3765 * 0.0585f)))))))))))));
let _e3783 = select(_e3780, (1.5707964f - _e3780), (_e3752 > _e3749));
let _e3786 = select(_e3783, (3.1415927f - _e3783), (_e3442 < 0f));
let _e3791 = (0.5f - (select(_e3786, -(_e3786), (_e3437 < 0f)) / _e3684));
let _e3793 = select(-1f, _e3447, (_e3447 > -1f));
let _e3795 = select(1f, _e3793, (_e3793 < 1f));
let _e3798 = ((1f - _e3795) * (1f + _e3795));
let _e3801 = sqrt(select(0f, _e3798, (_e3798 > 0f)));
let _e3804 = bitcast<f32>((bitcast<u32>(_e3801) & 2147483647u));
let _e3807 = bitcast<f32>((bitcast<u32>(_e3795) & 2147483647u));
let _e3811 = select(_e3807, _e3804, (_e3804 > _e3807));
let _e3814 = (select(_e3807, _e3804, (_e3804 < _e3807)) / select(1.1754944e-38f, _e3811, (_e3811 > 1.1754944e-38f)));
let _e3815 = (_e3814 > 0.41421357f);
let _e3819 = select(_e3814, ((_e3814 - 1f) / (_e3814 + 1f)), _e3815);
let _e3820 = (_e3819 * _e3819);
let _e3835 = (select(0f, 0.7853982f, _e3815) + (_e3819 + ((_e3819 * _e3820) * (-0.33333334f + (_e3820 * (0.2f + (_e3820 * (-0.14285713f + (_e3820 * (0.11111111f + (_e3820 * (-0.09090909f + (_e3820 * 0.0585f)))))))))))));
let _e3838 = select(_e3835, (1.5707964f - _e3835), (_e3807 > _e3804));
let _e3841 = select(_e3838, (3.1415927f - _e3838), (_e3801 < 0f));
let _e3846 = (0.5f - (select(_e3841, -(_e3841), (_e3795 < 0f)) / 3.1415927f));
let _e3848 = bitcast<i32>(_e1165.z);
phi_6372_ = 0i;
phi_6375_ = 0i;
phi_6377_ = _e3848;
phi_6379_ = _e3678;
loop {
let _e3850 = phi_6372_;
let _e3852 = phi_6375_;
let _e3854 = phi_6377_;
let _e3856 = phi_6379_;
local_77 = _e3856;
local_78 = _e3854;
local_79 = _e3856;
local_80 = _e3856;
local_81 = _e3856;
local_82 = _e3856;
local_83 = _e3856;
local_84 = _e3856;
local_85 = _e3854;
local_86 = _e3854;
local_87 = _e3854;
local_88 = _e3854;
local_89 = _e3856;
local_90 = _e3852;
local_91 = _e3856;
local_92 = _e3852;
let _e3857 = (_e3850 < _e3746);
if _e3857 {
if (_e3856 > 1i) {
phi_6394_ = (_e3856 >> bitcast<u32>(1i));
} else {
phi_6394_ = 1i;
}
let _e3864 = phi_6394_;
if (_e3854 > 1i) {
phi_6400_ = (_e3854 >> bitcast<u32>(1i));
} else {
phi_6400_ = 1i;
}
let _e3869 = phi_6400_;
phi_6373_ = (_e3850 + 1i);
phi_6376_ = (_e3852 + (_e3856 * _e3854));
phi_6378_ = _e3869;
phi_6380_ = _e3864;
} else {
phi_6373_ = i32();
phi_6376_ = i32();
phi_6378_ = i32();
phi_6380_ = i32();
}
let _e3872 = phi_6373_;
let _e3874 = phi_6376_;
let _e3876 = phi_6378_;
let _e3878 = phi_6380_;
continue;
continuing {
phi_6372_ = _e3872;
phi_6375_ = _e3874;
phi_6377_ = _e3876;
phi_6379_ = _e3878;
break if !(_e3857);
}
}
let _e3881 = local_77;
let _e3882 = f32(_e3881);
let _e3884 = ((_e3791 * _e3882) - 0.5f);
let _e3886 = local_78;
let _e3887 = f32(_e3886);
let _e3889 = ((_e3846 * _e3887) - 0.5f);
let _e3891 = select(-1f, _e3884, (_e3884 > -1f));
let _e3893 = select(_e3882, _e3891, (_e3891 < _e3882));
let _e3900 = select(0i, select(select(i32(_e3893), i32(-2147483648), (_e3893 < -2147483600f)), 2147483647i, (_e3893 > 2147483500f)), (_e3893 == _e3893));
let _e3904 = (_e3900 - select(0i, 1i, (_e3893 < f32(_e3900))));
let _e3906 = select(-1f, _e3889, (_e3889 > -1f));
let _e3908 = select(_e3887, _e3906, (_e3906 < _e3887));
let _e3915 = select(0i, select(select(i32(_e3908), i32(-2147483648), (_e3908 < -2147483600f)), 2147483647i, (_e3908 > 2147483500f)), (_e3908 == _e3908));
let _e3919 = (_e3915 - select(0i, 1i, (_e3908 < f32(_e3915))));
let _e3921 = (_e3884 - f32(_e3904));
let _e3923 = (_e3889 - f32(_e3919));
let _e3925 = select(0f, _e3923, (_e3923 > 0f));
let _e3927 = select(1f, _e3925, (_e3925 < 1f));
if (_e3904 < 0i) {
let _e3930 = local_79;
phi_6475_ = (_e3904 + _e3930);
} else {
phi_6475_ = _e3904;
}
let _e3933 = phi_6475_;
let _e3935 = local_80;
if (_e3933 >= _e3935) {
let _e3938 = local_81;
phi_6481_ = (_e3933 - _e3938);
} else {
phi_6481_ = _e3933;
}
let _e3941 = phi_6481_;
let _e3942 = (_e3904 + 1i);
if (_e3942 < 0i) {
let _e3945 = local_82;
phi_6488_ = (_e3942 + _e3945);
} else {
phi_6488_ = _e3942;
}
let _e3948 = phi_6488_;
let _e3950 = local_83;
if (_e3948 >= _e3950) {
let _e3953 = local_84;
phi_6494_ = (_e3948 - _e3953);
} else {
phi_6494_ = _e3948;
}
let _e3956 = phi_6494_;
let _e3958 = select(_e3919, 0i, (_e3919 < 0i));
let _e3960 = local_85;
if (_e3958 >= _e3960) {
let _e3963 = local_86;
phi_6505_ = (_e3963 - 1i);
} else {
phi_6505_ = _e3958;
}
let _e3966 = phi_6505_;
let _e3967 = (_e3919 + 1i);
let _e3969 = select(_e3967, 0i, (_e3967 < 0i));
let _e3971 = local_87;
if (_e3969 >= _e3971) {
let _e3974 = local_88;
phi_6517_ = (_e3974 - 1i);
} else {
phi_6517_ = _e3969;
}
let _e3977 = phi_6517_;
let _e3979 = local_89;
let _e3982 = local_90;
let _e3983 = (_e3982 + (_e3966 * _e3979));
let _e3985 = local_91;
let _e3988 = local_92;
let _e3989 = (_e3988 + (_e3977 * _e3985));
let _e3991 = (3i * (_e3983 + _e3941));
let _e3993 = (bitcast<i32>(_e149) - 1i);
let _e3995 = select(_e3993, _e3991, (_e3991 < _e3993));
let _e4001 = global_3.member[bitcast<u32>(select(0i, _e3995, (_e3995 > 0i)))];
let _e4002 = (_e3991 + 1i);
let _e4004 = select(_e3993, _e4002, (_e4002 < _e3993));
let _e4010 = global_3.member[bitcast<u32>(select(0i, _e4004, (_e4004 > 0i)))];
let _e4011 = (_e3991 + 2i);
let _e4013 = select(_e3993, _e4011, (_e4011 < _e3993));
let _e4019 = global_3.member[bitcast<u32>(select(0i, _e4013, (_e4013 > 0i)))];
let _e4021 = (3i * (_e3983 + _e3956));
let _e4023 = select(_e3993, _e4021, (_e4021 < _e3993));
let _e4029 = global_3.member[bitcast<u32>(select(0i, _e4023, (_e4023 > 0i)))];
let _e4030 = (_e4021 + 1i);
let _e4032 = select(_e3993, _e4030, (_e4030 < _e3993));
let _e4038 = global_3.member[bitcast<u32>(select(0i, _e4032, (_e4032 > 0i)))];
let _e4039 = (_e4021 + 2i);
let _e4041 = select(_e3993, _e4039, (_e4039 < _e3993));
let _e4047 = global_3.member[bitcast<u32>(select(0i, _e4041, (_e4041 > 0i)))];
let _e4049 = (3i * (_e3989 + _e3941));
let _e4051 = select(_e3993, _e4049, (_e4049 < _e3993));
let _e4057 = global_3.member[bitcast<u32>(select(0i, _e4051, (_e4051 > 0i)))];
let _e4058 = (_e4049 + 1i);
let _e4060 = select(_e3993, _e4058, (_e4058 < _e3993));
let _e4066 = global_3.member[bitcast<u32>(select(0i, _e4060, (_e4060 > 0i)))];
let _e4067 = (_e4049 + 2i);
let _e4069 = select(_e3993, _e4067, (_e4067 < _e3993));
let _e4075 = global_3.member[bitcast<u32>(select(0i, _e4069, (_e4069 > 0i)))];
let _e4077 = (3i * (_e3989 + _e3956));
let _e4079 = select(_e3993, _e4077, (_e4077 < _e3993));
let _e4085 = global_3.member[bitcast<u32>(select(0i, _e4079, (_e4079 > 0i)))];
let _e4086 = (_e4077 + 1i);
let _e4088 = select(_e3993, _e4086, (_e4086 < _e3993));
let _e4094 = global_3.member[bitcast<u32>(select(0i, _e4088, (_e4088 > 0i)))];
let _e4095 = (_e4077 + 2i);
let _e4097 = select(_e3993, _e4095, (_e4095 < _e3993));
let _e4103 = global_3.member[bitcast<u32>(select(0i, _e4097, (_e4097 > 0i)))];
let _e4110 = (_e4001 + ((_e4029 - _e4001) * _e3921));
let _e4111 = (_e4010 + ((_e4038 - _e4010) * _e3921));
let _e4112 = (_e4019 + ((_e4047 - _e4019) * _e3921));
let _e4128 = (_e4110 + (((_e4057 + ((_e4085 - _e4057) * _e3921)) - _e4110) * _e3927));
let _e4129 = (_e4111 + (((_e4066 + ((_e4094 - _e4066) * _e3921)) - _e4111) * _e3927));
let _e4130 = (_e4112 + (((_e4075 + ((_e4103 - _e4075) * _e3921)) - _e4112) * _e3927));
phi_6751_ = 0i;
phi_6754_ = 0i;
phi_6756_ = _e3848;
phi_6758_ = _e3678;
loop {
let _e4133 = phi_6751_;
let _e4135 = phi_6754_;
let _e4137 = phi_6756_;
let _e4139 = phi_6758_;
local_93 = _e4139;
local_94 = _e4137;
local_95 = _e4139;
local_96 = _e4139;
local_97 = _e4139;
local_98 = _e4139;
local_99 = _e4139;
local_100 = _e4139;
local_101 = _e4137;
local_102 = _e4137;
local_103 = _e4137;
local_104 = _e4137;
local_105 = _e4139;
local_106 = _e4135;
local_107 = _e4139;
local_108 = _e4135;
let _e4140 = (_e4133 < (_e3746 + 1i));
if _e4140 {
if (_e4139 > 1i) {
phi_6773_ = (_e4139 >> bitcast<u32>(1i));
} else {
phi_6773_ = 1i;
}
let _e4147 = phi_6773_;
if (_e4137 > 1i) {
phi_6779_ = (_e4137 >> bitcast<u32>(1i));
} else {
phi_6779_ = 1i;
}
let _e4152 = phi_6779_;
phi_6752_ = (_e4133 + 1i);
phi_6755_ = (_e4135 + (_e4139 * _e4137));
phi_6757_ = _e4152;
phi_6759_ = _e4147;
} else {
phi_6752_ = i32();
phi_6755_ = i32();
phi_6757_ = i32();
phi_6759_ = i32();
}
let _e4155 = phi_6752_;
let _e4157 = phi_6755_;
let _e4159 = phi_6757_;
let _e4161 = phi_6759_;
continue;
continuing {
phi_6751_ = _e4155;
phi_6754_ = _e4157;
phi_6756_ = _e4159;
phi_6758_ = _e4161;
break if !(_e4140);
}
}
let _e4164 = local_93;
let _e4165 = f32(_e4164);
let _e4167 = ((_e3791 * _e4165) - 0.5f);
let _e4169 = local_94;
let _e4170 = f32(_e4169);
let _e4172 = ((_e3846 * _e4170) - 0.5f);
let _e4174 = select(-1f, _e4167, (_e4167 > -1f));
let _e4176 = select(_e4165, _e4174, (_e4174 < _e4165));
let _e4183 = select(0i, select(select(i32(_e4176), i32(-2147483648), (_e4176 < -2147483600f)), 2147483647i, (_e4176 > 2147483500f)), (_e4176 == _e4176));
let _e4187 = (_e4183 - select(0i, 1i, (_e4176 < f32(_e4183))));
let _e4189 = select(-1f, _e4172, (_e4172 > -1f));
let _e4191 = select(_e4170, _e4189, (_e4189 < _e4170));
let _e4198 = select(0i, select(select(i32(_e4191), i32(-2147483648), (_e4191 < -2147483600f)), 2147483647i, (_e4191 > 2147483500f)), (_e4191 == _e4191));
let _e4202 = (_e4198 - select(0i, 1i, (_e4191 < f32(_e4198))));
let _e4204 = (_e4167 - f32(_e4187));
let _e4206 = (_e4172 - f32(_e4202));
let _e4208 = select(0f, _e4206, (_e4206 > 0f));
let _e4210 = select(1f, _e4208, (_e4208 < 1f));
if (_e4187 < 0i) {
let _e4213 = local_95;
phi_6854_ = (_e4187 + _e4213);
} else {
phi_6854_ = _e4187;
}
let _e4216 = phi_6854_;
let _e4218 = local_96;
if (_e4216 >= _e4218) {
let _e4221 = local_97;
phi_6860_ = (_e4216 - _e4221);
} else {
phi_6860_ = _e4216;
}
let _e4224 = phi_6860_;
let _e4225 = (_e4187 + 1i);
if (_e4225 < 0i) {
let _e4228 = local_98;
phi_6867_ = (_e4225 + _e4228);
} else {
phi_6867_ = _e4225;
}
let _e4231 = phi_6867_;
let _e4233 = local_99;
if (_e4231 >= _e4233) {
let _e4236 = local_100;
phi_6873_ = (_e4231 - _e4236);
} else {
phi_6873_ = _e4231;
}
let _e4239 = phi_6873_;
let _e4241 = select(_e4202, 0i, (_e4202 < 0i));
let _e4243 = local_101;
if (_e4241 >= _e4243) {
let _e4246 = local_102;
phi_6884_ = (_e4246 - 1i);
} else {
phi_6884_ = _e4241;
}
let _e4249 = phi_6884_;
let _e4250 = (_e4202 + 1i);
let _e4252 = select(_e4250, 0i, (_e4250 < 0i));
let _e4254 = local_103;
if (_e4252 >= _e4254) {
let _e4257 = local_104;
phi_6896_ = (_e4257 - 1i);
} else {
phi_6896_ = _e4252;
}
let _e4260 = phi_6896_;
let _e4262 = local_105;
let _e4265 = local_106;
let _e4266 = (_e4265 + (_e4249 * _e4262));
let _e4268 = local_107;
let _e4271 = local_108;
let _e4272 = (_e4271 + (_e4260 * _e4268));
let _e4274 = (3i * (_e4266 + _e4224));
let _e4276 = select(_e3993, _e4274, (_e4274 < _e3993));
let _e4282 = global_3.member[bitcast<u32>(select(0i, _e4276, (_e4276 > 0i)))];
let _e4283 = (_e4274 + 1i);
let _e4285 = select(_e3993, _e4283, (_e4283 < _e3993));
let _e4291 = global_3.member[bitcast<u32>(select(0i, _e4285, (_e4285 > 0i)))];
let _e4292 = (_e4274 + 2i);
let _e4294 = select(_e3993, _e4292, (_e4292 < _e3993));
let _e4300 = global_3.member[bitcast<u32>(select(0i, _e4294, (_e4294 > 0i)))];
let _e4302 = (3i * (_e4266 + _e4239));
let _e4304 = select(_e3993, _e4302, (_e4302 < _e3993));
let _e4310 = global_3.member[bitcast<u32>(select(0i, _e4304, (_e4304 > 0i)))];
let _e4311 = (_e4302 + 1i);
let _e4313 = select(_e3993, _e4311, (_e4311 < _e3993));
let _e4319 = global_3.member[bitcast<u32>(select(0i, _e4313, (_e4313 > 0i)))];
let _e4320 = (_e4302 + 2i);
let _e4322 = select(_e3993, _e4320, (_e4320 < _e3993));
let _e4328 = global_3.member[bitcast<u32>(select(0i, _e4322, (_e4322 > 0i)))];
let _e4330 = (3i * (_e4272 + _e4224));
let _e4332 = select(_e3993, _e4330, (_e4330 < _e3993));
let _e4338 = global_3.member[bitcast<u32>(select(0i, _e4332, (_e4332 > 0i)))];
let _e4339 = (_e4330 + 1i);
let _e4341 = select(_e3993, _e4339, (_e4339 < _e3993));
let _e4347 = global_3.member[bitcast<u32>(select(0i, _e4341, (_e4341 > 0i)))];
let _e4348 = (_e4330 + 2i);
let _e4350 = select(_e3993, _e4348, (_e4348 < _e3993));
let _e4356 = global_3.member[bitcast<u32>(select(0i, _e4350, (_e4350 > 0i)))];
let _e4358 = (3i * (_e4272 + _e4239));
let _e4360 = select(_e3993, _e4358, (_e4358 < _e3993));
let _e4366 = global_3.member[bitcast<u32>(select(0i, _e4360, (_e4360 > 0i)))];
let _e4367 = (_e4358 + 1i);
let _e4369 = select(_e3993, _e4367, (_e4367 < _e3993));
let _e4375 = global_3.member[bitcast<u32>(select(0i, _e4369, (_e4369 > 0i)))];
let _e4376 = (_e4358 + 2i);
let _e4378 = select(_e3993, _e4376, (_e4376 < _e3993));
let _e4384 = global_3.member[bitcast<u32>(select(0i, _e4378, (_e4378 > 0i)))];
let _e4391 = (_e4282 + ((_e4310 - _e4282) * _e4204));
let _e4392 = (_e4291 + ((_e4319 - _e4291) * _e4204));
let _e4393 = (_e4300 + ((_e4328 - _e4300) * _e4204));
let _e4416 = (_e3728 - f32(_e3746));
let _e4418 = select(0f, _e4416, (_e4416 > 0f));
let _e4420 = select(1f, _e4418, (_e4418 < 1f));
phi_7150_ = vec3<f32>(((_e4128 + (((_e4391 + (((_e4338 + ((_e4366 - _e4338) * _e4204)) - _e4391) * _e4210)) - _e4128) * _e4420)) * _e1171.member_3), ((_e4129 + (((_e4392 + (((_e4347 + ((_e4375 - _e4347) * _e4204)) - _e4392) * _e4210)) - _e4129) * _e4420)) * _e1171.member_3), ((_e4130 + (((_e4393 + (((_e4356 + ((_e4384 - _e4356) * _e4204)) - _e4393) * _e4210)) - _e4130) * _e4420)) * _e1171.member_3));
}
let _e4433 = phi_7150_;
phi_7151_ = _e4433;
}
let _e4435 = phi_7151_;
phi_7152_ = _e4435;
}
let _e4437 = phi_7152_;
if (_e276 && (_e3307 > 0f)) {
let _e4440 = local_39;
let _e4442 = local_38;
let _e4443 = ((2i * _e4440) + _e4442);
let _e4445 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e4447 = select(_e4445, _e4443, (_e4443 < _e4445));
let _e4452 = global_7.member[bitcast<u32>(select(0i, _e4447, (_e4447 > 0i)))];
let _e4459 = select(0i, select(select(i32(_e4452), i32(-2147483648), (_e4452 < -2147483600f)), 2147483647i, (_e4452 > 2147483500f)), (_e4452 == _e4452));
if (_e4459 != -1i) {
let _e4461 = local_39;
let _e4463 = local_38;
let _e4464 = ((20i * _e4461) + _e4463);
let _e4466 = select(_e190, _e4464, (_e4464 < _e190));
let _e4471 = global_2.member[bitcast<u32>(select(0i, _e4466, (_e4466 > 0i)))];
let _e4472 = (1f - _e455);
let _e4479 = global_1.member.member_4.member_3;
let _e4483 = global_1.member.member_5.member_3;
let _e4487 = global_1.member.member_6.member_3;
let _e4497 = local_39;
let _e4499 = local_38;
let _e4500 = ((3i * _e4497) + _e4499);
let _e4502 = select(_e4445, _e4500, (_e4500 < _e4445));
let _e4507 = global_7.member[bitcast<u32>(select(0i, _e4502, (_e4502 > 0i)))];
let _e4511 = (((_e4479 + (_e1047 * _e4472)) + (_e1067 * _e4471)) + (_e3350 * _e4507));
let _e4512 = (((_e4483 + (_e1048 * _e4472)) + (_e1068 * _e4471)) + (_e3351 * _e4507));
let _e4513 = (((_e4487 + (_e1049 * _e4472)) + (_e1069 * _e4471)) + (_e3352 * _e4507));
let _e4514 = vec3<f32>(_e4511, _e4512, _e4513);
if (_e4459 < 0i) {
let _e4516 = (_e4459 == -3i);
let _e4519 = global_1.member.member_19;
let _e4525 = global_1.member.member_17;
let _e4532 = vec3<f32>(select(_e4525.member, _e4519.member, _e4516), select(_e4525.member_1, _e4519.member_1, _e4516), select(_e4525.member_2, _e4519.member_2, _e4516));
let _e4535 = global_1.member.member_20;
let _e4541 = global_1.member.member_18;
phi_8123_ = type_14(_e4514, _e4532, _e4532, vec3<f32>(select(_e4541.member, _e4535.member, _e4516), select(_e4541.member_1, _e4535.member_1, _e4516), select(_e4541.member_2, _e4535.member_2, _e4516)), 0f, false);
} else {
let _e4550 = (_e4459 * 19i);
let _e4552 = (bitcast<i32>(_e151) - 1i);
let _e4554 = select(_e4552, _e4550, (_e4550 < _e4552));
let _e4560 = global_4.member[bitcast<u32>(select(0i, _e4554, (_e4554 > 0i)))];
let _e4561 = (_e4550 + 1i);
let _e4563 = select(_e4552, _e4561, (_e4561 < _e4552));
let _e4569 = global_4.member[bitcast<u32>(select(0i, _e4563, (_e4563 > 0i)))];
let _e4570 = (_e4550 + 2i);
let _e4572 = select(_e4552, _e4570, (_e4570 < _e4552));
let _e4578 = global_4.member[bitcast<u32>(select(0i, _e4572, (_e4572 > 0i)))];
let _e4579 = (_e4550 + 3i);
let _e4581 = select(_e4552, _e4579, (_e4579 < _e4552));
let _e4587 = global_4.member[bitcast<u32>(select(0i, _e4581, (_e4581 > 0i)))];
let _e4588 = (_e4550 + 4i);
let _e4590 = select(_e4552, _e4588, (_e4588 < _e4552));
let _e4596 = global_4.member[bitcast<u32>(select(0i, _e4590, (_e4590 > 0i)))];
let _e4597 = (_e4550 + 5i);
let _e4599 = select(_e4552, _e4597, (_e4597 < _e4552));
let _e4605 = global_4.member[bitcast<u32>(select(0i, _e4599, (_e4599 > 0i)))];
let _e4606 = (_e4550 + 6i);
let _e4608 = select(_e4552, _e4606, (_e4606 < _e4552));
let _e4614 = global_4.member[bitcast<u32>(select(0i, _e4608, (_e4608 > 0i)))];
let _e4615 = (_e4550 + 7i);
let _e4617 = select(_e4552, _e4615, (_e4615 < _e4552));
let _e4623 = global_4.member[bitcast<u32>(select(0i, _e4617, (_e4617 > 0i)))];
let _e4624 = (_e4550 + 8i);
let _e4626 = select(_e4552, _e4624, (_e4624 < _e4552));
let _e4632 = global_4.member[bitcast<u32>(select(0i, _e4626, (_e4626 > 0i)))];
let _e4633 = (_e4587 - _e4560);
let _e4634 = (_e4596 - _e4569);
let _e4635 = (_e4605 - _e4578);
let _e4636 = (_e4614 - _e4560);
let _e4637 = (_e4623 - _e4569);
let _e4638 = (_e4632 - _e4578);
let _e4641 = ((_e4634 * _e4638) - (_e4635 * _e4637));
let _e4644 = ((_e4635 * _e4636) - (_e4633 * _e4638));
let _e4647 = ((_e4633 * _e4637) - (_e4634 * _e4636));
let _e4648 = (_e4587 - _e4511);
let _e4649 = (_e4596 - _e4512);
let _e4650 = (_e4605 - _e4513);
let _e4651 = (_e4614 - _e4511);
let _e4652 = (_e4623 - _e4512);
let _e4653 = (_e4632 - _e4513);
let _e4667 = (((((_e4649 * _e4653) - (_e4650 * _e4652)) * _e4641) + (((_e4650 * _e4651) - (_e4648 * _e4653)) * _e4644)) + (((_e4648 * _e4652) - (_e4649 * _e4651)) * _e4647));
let _e4669 = select(0f, _e4667, (_e4667 > 0f));
let _e4670 = (_e4560 - _e4511);
let _e4671 = (_e4569 - _e4512);
let _e4672 = (_e4578 - _e4513);
let _e4686 = (((((_e4652 * _e4672) - (_e4653 * _e4671)) * _e4641) + (((_e4653 * _e4670) - (_e4651 * _e4672)) * _e4644)) + (((_e4651 * _e4671) - (_e4652 * _e4670)) * _e4647));
let _e4688 = select(0f, _e4686, (_e4686 > 0f));
let _e4702 = (((((_e4671 * _e4650) - (_e4672 * _e4649)) * _e4641) + (((_e4672 * _e4648) - (_e4670 * _e4650)) * _e4644)) + (((_e4670 * _e4649) - (_e4671 * _e4648)) * _e4647));
let _e4704 = select(0f, _e4702, (_e4702 > 0f));
let _e4706 = ((_e4669 + _e4688) + _e4704);
let _e4708 = select(1e-30f, _e4706, (_e4706 > 1e-30f));
let _e4709 = (_e4669 / _e4708);
let _e4710 = (_e4688 / _e4708);
let _e4711 = (_e4704 / _e4708);
let _e4716 = (((_e4641 * _e4641) + (_e4644 * _e4644)) + (_e4647 * _e4647));
let _e4719 = sqrt(select(0f, _e4716, (_e4716 > 0f)));
let _e4722 = (1f / select(1e-20f, _e4719, (_e4719 > 1e-20f)));
let _e4727 = (_e4550 + 9i);
let _e4729 = select(_e4552, _e4727, (_e4727 < _e4552));
let _e4735 = global_4.member[bitcast<u32>(select(0i, _e4729, (_e4729 > 0i)))];
let _e4736 = (_e4550 + 10i);
let _e4738 = select(_e4552, _e4736, (_e4736 < _e4552));
let _e4744 = global_4.member[bitcast<u32>(select(0i, _e4738, (_e4738 > 0i)))];
let _e4745 = (_e4550 + 11i);
let _e4747 = select(_e4552, _e4745, (_e4745 < _e4552));
let _e4753 = global_4.member[bitcast<u32>(select(0i, _e4747, (_e4747 > 0i)))];
let _e4757 = (_e4550 + 12i);
let _e4759 = select(_e4552, _e4757, (_e4757 < _e4552));
let _e4765 = global_4.member[bitcast<u32>(select(0i, _e4759, (_e4759 > 0i)))];
let _e4766 = (_e4550 + 13i);
let _e4768 = select(_e4552, _e4766, (_e4766 < _e4552));
let _e4774 = global_4.member[bitcast<u32>(select(0i, _e4768, (_e4768 > 0i)))];
let _e4775 = (_e4550 + 14i);
let _e4777 = select(_e4552, _e4775, (_e4775 < _e4552));
let _e4783 = global_4.member[bitcast<u32>(select(0i, _e4777, (_e4777 > 0i)))];
let _e4790 = (_e4550 + 15i);
let _e4792 = select(_e4552, _e4790, (_e4790 < _e4552));
let _e4798 = global_4.member[bitcast<u32>(select(0i, _e4792, (_e4792 > 0i)))];
let _e4799 = (_e4550 + 16i);
let _e4801 = select(_e4552, _e4799, (_e4799 < _e4552));
let _e4807 = global_4.member[bitcast<u32>(select(0i, _e4801, (_e4801 > 0i)))];
let _e4808 = (_e4550 + 17i);
let _e4810 = select(_e4552, _e4808, (_e4808 < _e4552));
let _e4816 = global_4.member[bitcast<u32>(select(0i, _e4810, (_e4810 > 0i)))];
let _e4820 = (((_e4735 * _e4709) + (_e4765 * _e4710)) + (_e4798 * _e4711));
let _e4821 = (((_e4744 * _e4709) + (_e4774 * _e4710)) + (_e4807 * _e4711));
let _e4822 = (((_e4753 * _e4709) + (_e4783 * _e4710)) + (_e4816 * _e4711));
let _e4827 = (((_e4820 * _e4820) + (_e4821 * _e4821)) + (_e4822 * _e4822));
let _e4830 = sqrt(select(0f, _e4827, (_e4827 > 0f)));
let _e4833 = (1f / select(1e-20f, _e4830, (_e4830 > 1e-20f)));
let _e4841 = global_1.member.member[3u];
let _e4844 = (_e4550 + 18i);
let _e4846 = select(_e4552, _e4844, (_e4844 < _e4552));
let _e4852 = global_4.member[bitcast<u32>(select(0i, _e4846, (_e4846 > 0i)))];
let _e4861 = (select(select(0i, select(select(i32(_e4852), i32(-2147483648), (_e4852 < -2147483600f)), 2147483647i, (_e4852 > 2147483500f)), (_e4852 == _e4852)), _e4459, ((_e4841 & 4u) != 0u)) * 10i);
let _e4863 = (bitcast<i32>(_e153) - 1i);
let _e4865 = select(_e4863, _e4861, (_e4861 < _e4863));
let _e4871 = global_5.member[bitcast<u32>(select(0i, _e4865, (_e4865 > 0i)))];
let _e4872 = (_e4861 + 1i);
let _e4874 = select(_e4863, _e4872, (_e4872 < _e4863));
let _e4880 = global_5.member[bitcast<u32>(select(0i, _e4874, (_e4874 > 0i)))];
let _e4881 = (_e4861 + 2i);
let _e4883 = select(_e4863, _e4881, (_e4881 < _e4863));
let _e4889 = global_5.member[bitcast<u32>(select(0i, _e4883, (_e4883 > 0i)))];
let _e4893 = (_e4861 + 3i);
let _e4895 = select(_e4863, _e4893, (_e4893 < _e4863));
let _e4901 = global_5.member[bitcast<u32>(select(0i, _e4895, (_e4895 > 0i)))];
let _e4902 = (_e4861 + 4i);
let _e4904 = select(_e4863, _e4902, (_e4902 < _e4863));
let _e4910 = global_5.member[bitcast<u32>(select(0i, _e4904, (_e4904 > 0i)))];
let _e4911 = (_e4861 + 5i);
let _e4913 = select(_e4863, _e4911, (_e4911 < _e4863));
let _e4919 = global_5.member[bitcast<u32>(select(0i, _e4913, (_e4913 > 0i)))];
let _e4926 = (_e4861 + 6i);
let _e4928 = select(_e4863, _e4926, (_e4926 < _e4863));
let _e4934 = global_5.member[bitcast<u32>(select(0i, _e4928, (_e4928 > 0i)))];
let _e4935 = (_e4861 + 7i);
let _e4937 = select(_e4863, _e4935, (_e4935 < _e4863));
let _e4943 = global_5.member[bitcast<u32>(select(0i, _e4937, (_e4937 > 0i)))];
let _e4944 = (_e4861 + 8i);
let _e4946 = select(_e4863, _e4944, (_e4944 < _e4863));
let _e4952 = global_5.member[bitcast<u32>(select(0i, _e4946, (_e4946 > 0i)))];
let _e4960 = (_e4861 + 9i);
let _e4962 = select(_e4863, _e4960, (_e4960 < _e4863));
let _e4968 = global_5.member[bitcast<u32>(select(0i, _e4962, (_e4962 > 0i)))];
phi_8123_ = type_14(_e4514, vec3<f32>((_e4641 * _e4722), (_e4644 * _e4722), (_e4647 * _e4722)), vec3<f32>((_e4820 * _e4833), (_e4821 * _e4833), (_e4822 * _e4833)), vec3<f32>((((_e4871 * _e4709) + (_e4901 * _e4710)) + (_e4934 * _e4711)), (((_e4880 * _e4709) + (_e4910 * _e4710)) + (_e4943 * _e4711)), (((_e4889 * _e4709) + (_e4919 * _e4710)) + (_e4952 * _e4711))), _e4968, true);
}
let _e4971 = phi_8123_;
let _e4980 = (((_e4971.member_1.x * _e3350) + (_e4971.member_1.y * _e3351)) + (_e4971.member_1.z * _e3352));
let _e4982 = select(1f, -1f, (_e4980 > 0f));
let _e4994 = select(_e4982, -(_e4982), ((((_e4971.member_2.x * _e4971.member_1.x) + (_e4971.member_2.y * _e4971.member_1.y)) + (_e4971.member_2.z * _e4971.member_1.z)) < 0f));
let _e4995 = (_e4971.member_2.x * _e4994);
let _e4996 = (_e4971.member_2.y * _e4994);
let _e4997 = (_e4971.member_2.z * _e4994);
let _e5006 = ((((_e4995 * _e3350) + (_e4996 * _e3351)) + (_e4997 * _e3352)) > 0f);
let _e5012 = global_1.member.member_21;
let _e5021 = -((((select(_e4995, (_e4971.member_1.x * _e4982), _e5006) * _e5012.member) + (select(_e4996, (_e4971.member_1.y * _e4982), _e5006) * _e5012.member_1)) + (select(_e4997, (_e4971.member_1.z * _e4982), _e5006) * _e5012.member_2)));
let _e5027 = -((((_e4971.member_1.x * _e5012.member) + (_e4971.member_1.y * _e5012.member_1)) + (_e4971.member_1.z * _e5012.member_2)));
let _e5033 = -(_e5021);
let _e5038 = select((select(0f, _e5033, (_e5033 > 0f)) * _e4971.member_4), select(0f, _e5021, (_e5021 > 0f)), ((_e5027 * -(_e4980)) > 0f));
let _e5039 = -(_e5027);
let _e5041 = select(_e5039, _e5027, (_e5027 > _e5039));
let _e5043 = select(1f, _e5041, (_e5041 < 1f));
let _e5047 = (1f - (_e5043 * _e5043));
let _e5054 = global_1.member.member_28.member;
let _e5061 = global_1.member.member_28.member_1;
let _e5063 = (select(1f, -1f, (_e5027 < 0f)) * ((((1.4142135f * _e5054) * sqrt(select(0f, _e5047, (_e5047 > 0f)))) + _e5043) * _e5061));
let _e5068 = select(0f, 1f, _e4971.member_5);
let _e5074 = (_e4971.member.x + ((_e4971.member_1.x * _e5063) * _e5068));
let _e5076 = (_e4971.member.y + ((_e4971.member_1.y * _e5063) * _e5068));
let _e5078 = (_e4971.member.z + ((_e4971.member_1.z * _e5063) * _e5068));
let _e5082 = global_1.member.member_24[0u];
let _e5083 = bitcast<i32>(_e5082);
let _e5087 = global_1.member.member_24[1u];
let _e5088 = bitcast<i32>(_e5087);
let _e5092 = global_1.member.member_24[2u];
let _e5093 = bitcast<i32>(_e5092);
let _e5097 = global_1.member.member_24[3u];
let _e5098 = bitcast<i32>(_e5097);
let _e5101 = global_1.member.member_25;
let _e5113 = global_1.member.member_25.member_3;
let _e5114 = ((((_e5101.member * _e5074) + (_e5101.member_1 * _e5076)) + (_e5101.member_2 * _e5078)) + _e5113);
let _e5117 = global_1.member.member_26;
let _e5129 = global_1.member.member_26.member_3;
let _e5131 = (((((_e5117.member * _e5074) + (_e5117.member_1 * _e5076)) + (_e5117.member_2 * _e5078)) + _e5129) - 0.5f);
let _e5134 = global_1.member.member_27;
let _e5146 = global_1.member.member_27.member_3;
let _e5148 = (((((_e5134.member * _e5074) + (_e5134.member_1 * _e5076)) + (_e5134.member_2 * _e5078)) + _e5146) - 0.5f);
let _e5150 = f32((_e5083 - 1i));
let _e5152 = select(0f, _e5114, (_e5114 > 0f));
let _e5154 = select(_e5150, _e5152, (_e5152 < _e5150));
let _e5161 = select(0i, select(select(i32(_e5154), i32(-2147483648), (_e5154 < -2147483600f)), 2147483647i, (_e5154 > 2147483500f)), (_e5154 == _e5154));
let _e5165 = (_e5161 - select(0i, 1i, (_e5154 < f32(_e5161))));
let _e5169 = (_e5114 - f32(_e5165));
let _e5172 = select(1f, select(0f, _e5169, (_e5169 > 0f)), (_e5114 < f32(_e5083)));
let _e5173 = (_e5131 - _e5054);
let _e5174 = -(16f);
let _e5175 = f32(_e5088);
let _e5177 = select(_e5174, _e5173, (_e5173 > _e5174));
let _e5179 = select(_e5175, _e5177, (_e5177 < _e5175));
let _e5186 = select(0i, select(select(i32(_e5179), i32(-2147483648), (_e5179 < -2147483600f)), 2147483647i, (_e5179 > 2147483500f)), (_e5179 == _e5179));
let _e5192 = (_e5131 + _e5054);
let _e5195 = (f32((_e5088 - 1i)) + 16f);
let _e5197 = select(-1f, _e5192, (_e5192 > -1f));
let _e5199 = select(_e5195, _e5197, (_e5197 < _e5195));
let _e5206 = select(0i, select(select(i32(_e5199), i32(-2147483648), (_e5199 < -2147483600f)), 2147483647i, (_e5199 > 2147483500f)), (_e5199 == _e5199));
let _e5211 = (_e5148 - _e5054);
let _e5212 = f32(_e5093);
let _e5214 = select(_e5174, _e5211, (_e5211 > _e5174));
let _e5216 = select(_e5212, _e5214, (_e5214 < _e5212));
let _e5223 = select(0i, select(select(i32(_e5216), i32(-2147483648), (_e5216 < -2147483600f)), 2147483647i, (_e5216 > 2147483500f)), (_e5216 == _e5216));
let _e5229 = (_e5148 + _e5054);
let _e5232 = (f32((_e5093 - 1i)) + 16f);
let _e5234 = select(-1f, _e5229, (_e5229 > -1f));
let _e5236 = select(_e5232, _e5234, (_e5234 < _e5232));
let _e5243 = select(0i, select(select(i32(_e5236), i32(-2147483648), (_e5236 < -2147483600f)), 2147483647i, (_e5236 > 2147483500f)), (_e5236 == _e5236));
let _e5251 = bitcast<i32>(((_e5082 + 2u) >> bitcast<u32>(1i)));
let _e5253 = ((_e5088 * _e5093) * _e5251);
phi_8515_ = 0f;
phi_8518_ = vec3<f32>(0f, 0f, 0f);
phi_8520_ = ((_e5223 - select(0i, 1i, (_e5216 < f32(_e5223)))) + 1i);
loop {
let _e5255 = phi_8515_;
let _e5257 = phi_8518_;
let _e5259 = phi_8520_;
local_109 = _e5255;
local_110 = _e5255;
local_111 = _e5257;
local_112 = _e5257;
local_113 = _e5257;
let _e5260 = (_e5259 <= (_e5243 - select(0i, 1i, (_e5236 < f32(_e5243)))));
if _e5260 {
let _e5266 = (_e5054 - bitcast<f32>((bitcast<u32>((f32(_e5259) - _e5148)) & 2147483647u)));
phi_8535_ = ((_e5186 - select(0i, 1i, (_e5179 < f32(_e5186)))) + 1i);
phi_8538_ = _e5255;
phi_8540_ = _e5257;
loop {
let _e5268 = phi_8535_;
let _e5270 = phi_8538_;
let _e5272 = phi_8540_;
local_116 = _e5270;
local_117 = _e5272;
let _e5273 = (_e5268 <= (_e5206 - select(0i, 1i, (_e5199 < f32(_e5206)))));
if _e5273 {
let _e5279 = (_e5054 - bitcast<f32>((bitcast<u32>((f32(_e5268) - _e5131)) & 2147483647u)));
let _e5284 = (select(0f, _e5279, (_e5279 > 0f)) * select(0f, _e5266, (_e5266 > 0f)));
if ((((_e5268 >= 0i) && (_e5268 < _e5088)) && (_e5259 >= 0i)) && (_e5259 < _e5093)) {
let _e5294 = (((_e5259 * _e5088) + _e5268) * _e5251);
let _e5296 = (2i * _e5165);
let _e5297 = ((4i * _e5294) + _e5296);
let _e5299 = (_e5297 >> bitcast<u32>(2i));
let _e5302 = bitcast<u32>(((_e5297 & 3i) * 8i));
let _e5304 = (bitcast<i32>(_e155) - 1i);
let _e5306 = select(_e5304, _e5299, (_e5299 < _e5304));
let _e5312 = global_6.member[bitcast<u32>(select(0i, _e5306, (_e5306 > 0i)))];
let _e5316 = (_e5299 + 1i);
let _e5318 = select(_e5304, _e5316, (_e5316 < _e5304));
let _e5324 = global_6.member[bitcast<u32>(select(0i, _e5318, (_e5318 > 0i)))];
let _e5331 = ((_e5312 >> bitcast<u32>((_e5302 & 31u))) | ((_e5324 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5302) & 31u))));
let _e5334 = f32(bitcast<i32>((_e5331 & 65535u)));
let _e5342 = (1f / 65535f);
let _e5344 = (_e5284 * ((_e5334 + ((f32(bitcast<i32>((_e5331 >> bitcast<u32>(16i)))) - _e5334) * _e5172)) * _e5342));
let _e5346 = (_e5272.x + _e5344);
if (_e5098 > 1i) {
let _e5350 = ((4i * (_e5294 + _e5253)) + _e5296);
let _e5352 = (_e5350 >> bitcast<u32>(2i));
let _e5355 = bitcast<u32>(((_e5350 & 3i) * 8i));
let _e5357 = select(_e5304, _e5352, (_e5352 < _e5304));
let _e5363 = global_6.member[bitcast<u32>(select(0i, _e5357, (_e5357 > 0i)))];
let _e5367 = (_e5352 + 1i);
let _e5369 = select(_e5304, _e5367, (_e5367 < _e5304));
let _e5375 = global_6.member[bitcast<u32>(select(0i, _e5369, (_e5369 > 0i)))];
let _e5382 = ((_e5363 >> bitcast<u32>((_e5355 & 31u))) | ((_e5375 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5355) & 31u))));
let _e5385 = f32(bitcast<i32>((_e5382 & 65535u)));
let _e5400 = ((4i * (_e5294 + (2i * _e5253))) + _e5296);
let _e5402 = (_e5400 >> bitcast<u32>(2i));
let _e5405 = bitcast<u32>(((_e5400 & 3i) * 8i));
let _e5407 = select(_e5304, _e5402, (_e5402 < _e5304));
let _e5413 = global_6.member[bitcast<u32>(select(0i, _e5407, (_e5407 > 0i)))];
let _e5417 = (_e5402 + 1i);
let _e5419 = select(_e5304, _e5417, (_e5417 < _e5304));
let _e5425 = global_6.member[bitcast<u32>(select(0i, _e5419, (_e5419 > 0i)))];
let _e5432 = ((_e5413 >> bitcast<u32>((_e5405 & 31u))) | ((_e5425 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5405) & 31u))));
let _e5435 = f32(bitcast<i32>((_e5432 & 65535u)));
phi_8773_ = vec3<f32>(_e5346, (_e5272.y + (_e5284 * ((_e5385 + ((f32(bitcast<i32>((_e5382 >> bitcast<u32>(16i)))) - _e5385) * _e5172)) * _e5342))), (_e5272.z + (_e5284 * ((_e5435 + ((f32(bitcast<i32>((_e5432 >> bitcast<u32>(16i)))) - _e5435) * _e5172)) * _e5342))));
} else {
phi_8773_ = vec3<f32>(_e5346, (_e5272.y + _e5344), (_e5272.z + _e5344));
}
let _e5454 = phi_8773_;
phi_8783_ = _e5454;
} else {
phi_8783_ = vec3<f32>((_e5272.x + _e5284), (_e5272.y + _e5284), (_e5272.z + _e5284));
}
let _e5463 = phi_8783_;
phi_8536_ = (_e5268 + 1i);
phi_8539_ = (_e5270 + _e5284);
phi_8541_ = _e5463;
} else {
phi_8536_ = i32();
phi_8539_ = f32();
phi_8541_ = vec3<f32>();
}
let _e5467 = phi_8536_;
let _e5469 = phi_8539_;
let _e5471 = phi_8541_;
continue;
continuing {
phi_8535_ = _e5467;
phi_8538_ = _e5469;
phi_8540_ = _e5471;
break if !(_e5273);
}
}
let _e5884 = local_116;
phi_8516_ = _e5884;
let _e5887 = local_117;
phi_8519_ = _e5887;
phi_8521_ = (_e5259 + 1i);
} else {
phi_8516_ = f32();
phi_8519_ = vec3<f32>();
phi_8521_ = i32();
}
let _e5475 = phi_8516_;
let _e5477 = phi_8519_;
let _e5479 = phi_8521_;
continue;
continuing {
phi_8515_ = _e5475;
phi_8518_ = _e5477;
phi_8520_ = _e5479;
break if !(_e5260);
}
}
let _e5483 = local_109;
let _e5485 = ((_e5098 == 0i) || (_e5483 <= 0f));
let _e5487 = local_110;
let _e5489 = (1f / select(_e5487, 1f, _e5485));
let _e5491 = local_111;
let _e5496 = local_112;
let _e5501 = local_113;
let _e5511 = global_1.member.member_22.member;
let _e5516 = global_1.member.member_22.member_1;
let _e5521 = global_1.member.member_22.member_2;
let _e5525 = global_1.member.member_23;
phi_8843_ = vec3<f32>((_e4971.member_3.x * ((_e5511 * (select((_e5491.x * _e5489), 1f, _e5485) * _e5038)) + _e5525.member)), (_e4971.member_3.y * ((_e5516 * (select((_e5496.y * _e5489), 1f, _e5485) * _e5038)) + _e5525.member_1)), (_e4971.member_3.z * ((_e5521 * (select((_e5501.z * _e5489), 1f, _e5485) * _e5038)) + _e5525.member_2)));
} else {
phi_8843_ = _e4437;
}
let _e5543 = phi_8843_;
phi_8844_ = _e5543;
} else {
phi_8844_ = _e4437;
}
let _e5545 = phi_8844_;
let _e5552 = (_e1159 || _e278);
let _e5556 = global_1.member.member_16.member_3;
let _e5557 = select(_e5556, 1f, _e5552);
let _e5602 = global_1.member.member_7.member;
let _e5603 = local_39;
let _e5605 = local_38;
let _e5606 = ((20i * _e5603) + _e5605);
let _e5608 = select(_e190, _e5606, (_e5606 < _e190));
let _e5613 = global_2.member[bitcast<u32>(select(0i, _e5608, (_e5608 > 0i)))];
let _e5621 = local_39;
let _e5623 = local_38;
let _e5624 = ((19i * _e5621) + _e5623);
let _e5626 = select(_e190, _e5624, (_e5624 < _e190));
let _e5631 = global_2.member[bitcast<u32>(select(0i, _e5626, (_e5626 > 0i)))];
global_8.member[_e173] = (((_e3290.x * _e231) + (_e5545.x * _e3307)) * _e5557);
global_8.member[(_e171 + _e173)] = (((_e3290.y * _e242) + (_e5545.y * _e3307)) * _e5557);
global_8.member[((2u * _e171) + _e173)] = (((_e3290.z * _e253) + (_e5545.z * _e3307)) * _e5557);
global_8.member[((3u * _e171) + _e173)] = _e5557;
global_8.member[((4u * _e171) + _e173)] = (((_e431.member * _e3288.x) + (_e431.member_1 * _e3288.y)) + (_e431.member_2 * _e3288.z));
global_8.member[((5u * _e171) + _e173)] = (((_e440.member * _e3288.x) + (_e440.member_1 * _e3288.y)) + (_e440.member_2 * _e3288.z));
global_8.member[((6u * _e171) + _e173)] = -((((_e458.member * _e3288.x) + (_e458.member_1 * _e3288.y)) + (_e458.member_2 * _e3288.z)));
global_8.member[((7u * _e171) + _e173)] = _e264;
global_8.member[((8u * _e171) + _e173)] = (_e5631 * _e5602);
global_8.member[((9u * _e171) + _e173)] = select(0f, ((_e5613 * _e5602) * (((_e458.member * _e1067) + (_e458.member_1 * _e1068)) + (_e458.member_2 * _e1069))), _e5552);
global_8.member[((10u * _e171) + _e173)] = (((_e431.member * _e197) + (_e431.member_1 * _e208)) + (_e431.member_2 * _e219));
global_8.member[((11u * _e171) + _e173)] = (((_e440.member * _e197) + (_e440.member_1 * _e208)) + (_e440.member_2 * _e219));
global_8.member[((12u * _e171) + _e173)] = -((((_e458.member * _e197) + (_e458.member_1 * _e208)) + (_e458.member_2 * _e219)));
global_8.member[((13u * _e171) + _e173)] = _e231;
global_8.member[((14u * _e171) + _e173)] = _e242;
global_8.member[((15u * _e171) + _e173)] = _e253;
global_8.member[((16u * _e171) + _e173)] = _e3307;
global_8.member[((17u * _e171) + _e173)] = select(_e275, 2f, ((_e275 == 0f) || (_e275 == 4f)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
