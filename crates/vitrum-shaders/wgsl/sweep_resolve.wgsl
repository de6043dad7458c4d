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
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: array<u32>,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_22 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_23 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_24 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_25 {
member: type_5,
member_1: type_5,
}
struct type_26 {
member: type_7,
member_1: u32,
}
struct type_27 {
member: type_2,
member_1: u32,
member_2: type_21,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_22,
member_8: type_23,
member_9: type_23,
member_10: type_24,
member_11: type_25,
member_12: type_14,
member_13: type_22,
member_14: type_4,
member_15: type_9,
member_16: type_26,
member_17: type_26,
member_18: type_26,
member_19: type_26,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_28 {
member: type_27,
}
struct type_29 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_16;
@group(0) @binding(0)
var<storage> global_2: type_28;
@group(0) @binding(1)
var<storage> global_3: type_16;
@group(0) @binding(2)
var<storage> global_4: type_16;
@group(0) @binding(3)
var<storage> global_5: type_20;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: u32;
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
var local_19: u32;
var local_20: i32;
var local_21: i32;
var local_22: u32;
var local_23: u32;
var local_24: i32;
var local_25: i32;
var phi_274_: u32;
var phi_1201_: u32;
var phi_1537_: f32;
var phi_1569_: vec3<f32>;
var phi_1595_: f32;
var phi_1706_: f32;
var phi_1790_: f32;
var phi_1862_: type_29;
var phi_1863_: type_29;
var phi_2335_: i32;
var phi_2355_: i32;
var phi_2361_: i32;
var phi_2371_: i32;
var phi_2391_: i32;
var phi_2397_: i32;
var phi_2444_: u32;
var phi_2595_: u32;
var phi_2822_: u32;
var phi_2973_: u32;
var phi_3204_: vec3<f32>;
var phi_3806_: i32;
var phi_3809_: i32;
var phi_3811_: i32;
var phi_3813_: i32;
var phi_3828_: i32;
var phi_3834_: i32;
var phi_3807_: i32;
var phi_3810_: i32;
var phi_3812_: i32;
var phi_3814_: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var phi_3909_: i32;
var local_29: i32;
var local_30: i32;
var phi_3915_: i32;
var local_31: i32;
var phi_3922_: i32;
var local_32: i32;
var local_33: i32;
var phi_3928_: i32;
var local_34: i32;
var local_35: i32;
var phi_3939_: i32;
var local_36: i32;
var local_37: i32;
var phi_3951_: i32;
var local_38: i32;
var local_39: i32;
var local_40: i32;
var local_41: i32;
var phi_4187_: i32;
var phi_4190_: i32;
var phi_4192_: i32;
var phi_4194_: i32;
var phi_4209_: i32;
var phi_4215_: i32;
var phi_4188_: i32;
var phi_4191_: i32;
var phi_4193_: i32;
var phi_4195_: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var phi_4290_: i32;
var local_45: i32;
var local_46: i32;
var phi_4296_: i32;
var local_47: i32;
var phi_4303_: i32;
var local_48: i32;
var local_49: i32;
var phi_4309_: i32;
var local_50: i32;
var local_51: i32;
var phi_4320_: i32;
var local_52: i32;
var local_53: i32;
var phi_4332_: i32;
var local_54: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var phi_4587_: vec3<f32>;
var phi_4588_: vec3<f32>;
var phi_4589_: vec3<f32>;
var phi_4766_: i32;
var phi_4786_: i32;
var phi_4792_: i32;
var phi_4802_: i32;
var phi_4822_: i32;
var phi_4828_: i32;
var phi_4875_: u32;
var phi_5026_: u32;
var phi_5253_: u32;
var phi_5404_: u32;
var phi_5669_: vec3<f32>;
var phi_6271_: i32;
var phi_6274_: i32;
var phi_6276_: i32;
var phi_6278_: i32;
var phi_6293_: i32;
var phi_6299_: i32;
var phi_6272_: i32;
var phi_6275_: i32;
var phi_6277_: i32;
var phi_6279_: i32;
var local_58: i32;
var local_59: i32;
var local_60: i32;
var phi_6374_: i32;
var local_61: i32;
var local_62: i32;
var phi_6380_: i32;
var local_63: i32;
var phi_6387_: i32;
var local_64: i32;
var local_65: i32;
var phi_6393_: i32;
var local_66: i32;
var local_67: i32;
var phi_6404_: i32;
var local_68: i32;
var local_69: i32;
var phi_6416_: i32;
var local_70: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var phi_6652_: i32;
var phi_6655_: i32;
var phi_6657_: i32;
var phi_6659_: i32;
var phi_6674_: i32;
var phi_6680_: i32;
var phi_6653_: i32;
var phi_6656_: i32;
var phi_6658_: i32;
var phi_6660_: i32;
var local_74: i32;
var local_75: i32;
var local_76: i32;
var phi_6755_: i32;
var local_77: i32;
var local_78: i32;
var phi_6761_: i32;
var local_79: i32;
var phi_6768_: i32;
var local_80: i32;
var local_81: i32;
var phi_6774_: i32;
var local_82: i32;
var local_83: i32;
var phi_6785_: i32;
var local_84: i32;
var local_85: i32;
var phi_6797_: i32;
var local_86: i32;
var local_87: i32;
var local_88: i32;
var local_89: i32;
var phi_7052_: vec3<f32>;
var phi_7053_: vec3<f32>;
var phi_7054_: vec3<f32>;
var phi_7065_: vec3<f32>;
switch bitcast<i32>(0u) {
default: {
let _e119 = global;
let _e125 = arrayLength((&global_4.member));
let _e130 = global_2.member.member_2;
let _e133 = global_2.member.member;
let _e141 = (_e119.x + _e130.member);
let _e143 = (_e119.y + _e130.member_1);
if (_e141 < _e130.member_2) {
if (_e143 < _e130.member_3) {
let _e146 = (_e133.member * _e133.member_1);
let _e148 = ((_e143 * _e133.member) + _e141);
local_22 = _e141;
local_23 = _e143;
let _e153 = global_2.member.member_3.member;
let _e157 = global_2.member.member_3.member_1;
let _e158 = local_22;
let _e159 = local_23;
let _e160 = (_e158 % 16u);
let _e161 = (_e159 % 4u);
if ((_e158 < (_e153 - (_e153 % 16u))) && (_e159 < (_e157 - (_e157 % 4u)))) {
phi_274_ = ((((_e159 - _e161) + (_e160 / 4u)) * _e153) + (((_e158 - _e160) + (_e161 * 4u)) + (_e160 % 4u)));
} else {
phi_274_ = ((_e159 * _e153) + _e158);
}
let _e182 = phi_274_;
local_24 = bitcast<i32>(_e182);
let _e185 = bitcast<i32>((_e153 * _e157));
local_25 = _e185;
let _e186 = local_25;
let _e188 = local_24;
let _e189 = ((7i * _e186) + _e188);
let _e191 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e193 = select(_e191, _e189, (_e189 < _e191));
let _e198 = global_3.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e199 = local_25;
let _e201 = local_24;
let _e202 = ((9i * _e199) + _e201);
let _e204 = select(_e191, _e202, (_e202 < _e191));
let _e209 = global_3.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e210 = local_25;
let _e212 = local_24;
let _e213 = ((10i * _e210) + _e212);
let _e215 = select(_e191, _e213, (_e213 < _e191));
let _e220 = global_3.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e221 = local_25;
let _e223 = local_24;
let _e224 = ((11i * _e221) + _e223);
let _e226 = select(_e191, _e224, (_e224 < _e191));
let _e231 = global_3.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e232 = local_25;
let _e234 = local_24;
let _e235 = ((12i * _e232) + _e234);
let _e237 = select(_e191, _e235, (_e235 < _e191));
let _e242 = global_3.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e243 = local_25;
let _e245 = local_24;
let _e246 = ((8i * _e243) + _e245);
let _e248 = select(_e191, _e246, (_e246 < _e191));
let _e253 = global_3.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e254 = local_25;
let _e256 = local_24;
let _e257 = ((13i * _e254) + _e256);
let _e259 = select(_e191, _e257, (_e257 < _e191));
let _e264 = global_3.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e265 = local_25;
let _e267 = local_24;
let _e268 = ((14i * _e265) + _e267);
let _e270 = select(_e191, _e268, (_e268 < _e191));
let _e275 = global_3.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e276 = local_25;
let _e278 = local_24;
let _e279 = ((15i * _e276) + _e278);
let _e281 = select(_e191, _e279, (_e279 < _e191));
let _e286 = global_3.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e287 = local_25;
let _e289 = local_24;
let _e290 = ((3i * _e287) + _e289);
let _e292 = select(_e191, _e290, (_e290 < _e191));
let _e297 = global_3.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e298 = local_25;
let _e300 = local_24;
let _e301 = ((4i * _e298) + _e300);
let _e303 = select(_e191, _e301, (_e301 < _e191));
let _e308 = global_3.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e309 = local_25;
let _e311 = local_24;
let _e312 = ((5i * _e309) + _e311);
let _e314 = select(_e191, _e312, (_e312 < _e191));
let _e319 = global_3.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e324 = (((_e297 * _e297) + (_e308 * _e308)) + (_e319 * _e319));
let _e327 = sqrt(select(0f, _e324, (_e324 > 0f)));
let _e330 = (1f / select(1e-20f, _e327, (_e327 > 1e-20f)));
let _e331 = (_e297 * _e330);
let _e332 = (_e308 * _e330);
let _e333 = (_e319 * _e330);
let _e334 = (_e198 == 0f);
let _e335 = local_24;
let _e337 = select(_e191, _e335, (_e335 < _e191));
let _e342 = global_3.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e343 = local_25;
let _e344 = local_24;
let _e345 = (_e343 + _e344);
let _e347 = select(_e191, _e345, (_e345 < _e191));
let _e352 = global_3.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e353 = local_25;
let _e355 = local_24;
let _e356 = ((2i * _e353) + _e355);
let _e358 = select(_e191, _e356, (_e356 < _e191));
let _e363 = global_3.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e367 = global_2.member.member_7.member_1;
let _e370 = select(0f, ((_e367 - _e363) / _e319), _e334);
let _e374 = (_e342 + (_e297 * _e370));
let _e375 = (_e352 + (_e308 * _e370));
let _e376 = (_e363 + (_e319 * _e370));
let _e381 = global_2.member.member_15.member.member;
let _e392 = ((((_e381.member.member * _e374) + (_e381.member.member_1 * _e375)) + (_e381.member.member_2 * _e376)) + _e381.member_1);
let _e398 = -((((_e381.member.member * _e331) + (_e381.member.member_1 * _e332)) + (_e381.member.member_2 * _e333)));
let _e400 = (_e398 > 1e-9f);
let _e404 = ((_e392 / select(1e-9f, _e398, _e400)) - 0f);
let _e407 = select(1e30f, select(0f, _e404, (_e404 > 0f)), ((_e392 > 0f) && _e400));
let _e412 = global_2.member.member_15.member_1.member;
let _e423 = ((((_e412.member.member * _e374) + (_e412.member.member_1 * _e375)) + (_e412.member.member_2 * _e376)) + _e412.member_1);
let _e429 = -((((_e412.member.member * _e331) + (_e412.member.member_1 * _e332)) + (_e412.member.member_2 * _e333)));
let _e431 = (_e429 > 1e-9f);
let _e435 = ((_e423 / select(1e-9f, _e429, _e431)) - 0f);
let _e438 = select(1e30f, select(0f, _e435, (_e435 > 0f)), ((_e423 > 0f) && _e431));
let _e442 = (_e438 < _e407);
let _e444 = select(select(-2i, -3i, _e442), -1i, ((_e407 >= 1e30f) && (_e438 >= 1e30f)));
let _e445 = select(_e407, _e438, _e442);
let _e446 = (_e444 == -3i);
let _e452 = global_2.member.member_15.member_1.member.member;
let _e457 = global_2.member.member_15.member_1.member_1;
let _e463 = global_2.member.member_15.member.member.member;
let _e468 = global_2.member.member_15.member.member_1;
let _e475 = select(_e463.member, _e452.member, _e446);
let _e476 = select(_e463.member_1, _e452.member_1, _e446);
let _e477 = select(_e463.member_2, _e452.member_2, _e446);
let _e488 = select(_e445, 0f, (_e444 == -1i));
let _e492 = (_e374 + (_e331 * _e488));
let _e493 = (_e375 + (_e332 * _e488));
let _e494 = (_e376 + (_e333 * _e488));
let _e498 = global_2.member.member_12.member;
let _e509 = ((((_e498.member.member * _e492) + (_e498.member.member_1 * _e493)) + (_e498.member.member_2 * _e494)) + _e498.member_1);
let _e513 = global_2.member.member_12.member_1;
let _e524 = ((((_e513.member.member * _e492) + (_e513.member.member_1 * _e493)) + (_e513.member.member_2 * _e494)) + _e513.member_1);
let _e528 = global_2.member.member_12.member_2;
let _e539 = ((((_e528.member.member * _e492) + (_e528.member.member_1 * _e493)) + (_e528.member.member_2 * _e494)) + _e528.member_1);
let _e543 = global_2.member.member_12.member_3;
let _e544 = (_e543 != 0u);
let _e548 = global_2.member.member_12.member_19;
let _e552 = (_e509 - _e548.member);
let _e553 = (_e524 - _e548.member_1);
let _e554 = (_e539 - _e548.member_2);
let _e559 = (((_e552 * _e552) + (_e553 * _e553)) + (_e554 * _e554));
let _e562 = sqrt(select(0f, _e559, (_e559 > 0f)));
let _e565 = (1f / select(1e-20f, _e562, (_e562 > 1e-20f)));
let _e569 = select(0f, (_e552 * _e565), _e544);
let _e570 = select(0f, (_e553 * _e565), _e544);
let _e571 = select(1f, (_e554 * _e565), _e544);
let _e576 = global_2.member.member_12.member.member;
let _e587 = global_2.member.member_12.member_1.member;
let _e601 = global_2.member.member_12.member_2.member;
let _e610 = (vec3<f32>(((_e576.member * _e569) + (_e587.member * _e570)), ((_e576.member_1 * _e569) + (_e587.member_1 * _e570)), ((_e576.member_2 * _e569) + (_e587.member_2 * _e570))) + vec3<f32>((_e601.member * _e571), (_e601.member_1 * _e571), (_e601.member_2 * _e571)));
let _e613 = global_2.member.member_1;
if ((_e613 & 256u) != 0u) {
let _e621 = global_2.member.member_12.member_18.member.member;
let _e622 = bitcast<i32>(_e621);
let _e628 = global_2.member.member_12.member_18.member.member_1;
let _e629 = bitcast<i32>(_e628);
let _e634 = global_2.member.member_12.member_19.member_2;
let _e636 = select(1f, (_e539 - _e634), _e544);
let _e639 = (1f / select(1e-12f, _e636, (_e636 > 1e-12f)));
let _e644 = global_2.member.member_12.member_5;
let _e649 = global_2.member.member_12.member_8;
let _e650 = (((_e509 * _e639) - _e644) * _e649);
let _e655 = global_2.member.member_12.member_6;
let _e657 = (((_e524 * _e639) - _e655) * _e649);
let _e662 = global_2.member.member_12.member_4.member;
let _e664 = f32(bitcast<i32>(_e662));
let _e666 = select(0f, _e650, (_e650 > 0f));
let _e673 = global_2.member.member_12.member_18.member_1;
let _e676 = ((_e650 - _e664) * _e673);
let _e681 = global_2.member.member_12.member_18.member_2;
let _e683 = select(0f, _e676, (_e676 > 0f));
let _e685 = (_e681 + _e683);
let _e690 = (-(_e650) * _e673);
let _e692 = select(0f, _e690, (_e690 > 0f));
let _e694 = (_e681 + _e692);
let _e701 = (((_e681 + (select(_e664, _e666, (_e666 < _e664)) * _e673)) + (((_e683 * _e681) / select(1e-12f, _e685, (_e685 > 1e-12f))) - ((_e692 * _e681) / select(1e-12f, _e694, (_e694 > 1e-12f))))) - 0.5f);
let _e706 = global_2.member.member_12.member_4.member_1;
let _e708 = f32(bitcast<i32>(_e706));
let _e710 = select(0f, _e657, (_e657 > 0f));
let _e715 = ((_e657 - _e708) * _e673);
let _e717 = select(0f, _e715, (_e715 > 0f));
let _e719 = (_e681 + _e717);
let _e724 = (-(_e657) * _e673);
let _e726 = select(0f, _e724, (_e724 > 0f));
let _e728 = (_e681 + _e726);
let _e735 = (((_e681 + (select(_e708, _e710, (_e710 < _e708)) * _e673)) + (((_e717 * _e681) / select(1e-12f, _e719, (_e719 > 1e-12f))) - ((_e726 * _e681) / select(1e-12f, _e728, (_e728 > 1e-12f))))) - 0.5f);
let _e737 = f32((_e622 - 2i));
let _e739 = select(0f, _e701, (_e701 > 0f));
let _e741 = select(_e737, _e739, (_e739 < _e737));
let _e748 = select(0i, select(select(i32(_e741), i32(-2147483648), (_e741 < -2147483600f)), 2147483647i, (_e741 > 2147483500f)), (_e741 == _e741));
let _e752 = (_e748 - select(0i, 1i, (_e741 < f32(_e748))));
let _e754 = f32((_e629 - 2i));
let _e756 = select(0f, _e735, (_e735 > 0f));
let _e758 = select(_e754, _e756, (_e756 < _e754));
let _e765 = select(0i, select(select(i32(_e758), i32(-2147483648), (_e758 < -2147483600f)), 2147483647i, (_e758 > 2147483500f)), (_e758 == _e758));
let _e769 = (_e765 - select(0i, 1i, (_e758 < f32(_e765))));
let _e771 = (_e701 - f32(_e752));
let _e773 = select(0f, _e771, (_e771 > 0f));
let _e775 = select(1f, _e773, (_e773 < 1f));
let _e777 = (_e735 - f32(_e769));
let _e779 = select(0f, _e777, (_e777 > 0f));
let _e781 = select(1f, _e779, (_e779 < 1f));
if _e446 {
let _e786 = global_2.member.member_12.member_18.member_4;
phi_1201_ = _e786;
} else {
let _e791 = global_2.member.member_12.member_18.member_3;
phi_1201_ = _e791;
}
let _e793 = phi_1201_;
let _e797 = ((bitcast<i32>(_e793) + (_e769 * _e622)) + _e752);
let _e798 = (_e622 * _e629);
let _e800 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e802 = select(_e800, _e797, (_e797 < _e800));
let _e808 = global_5.member[bitcast<u32>(select(0i, _e802, (_e802 > 0i)))];
let _e809 = bitcast<f32>(_e808);
let _e810 = (_e797 + 1i);
let _e812 = select(_e800, _e810, (_e810 < _e800));
let _e818 = global_5.member[bitcast<u32>(select(0i, _e812, (_e812 > 0i)))];
let _e822 = (_e809 + ((bitcast<f32>(_e818) - _e809) * _e775));
let _e823 = (_e797 + _e622);
let _e825 = select(_e800, _e823, (_e823 < _e800));
let _e831 = global_5.member[bitcast<u32>(select(0i, _e825, (_e825 > 0i)))];
let _e832 = bitcast<f32>(_e831);
let _e833 = (_e823 + 1i);
let _e835 = select(_e800, _e833, (_e833 < _e800));
let _e841 = global_5.member[bitcast<u32>(select(0i, _e835, (_e835 > 0i)))];
let _e848 = (_e822 + (((_e832 + ((bitcast<f32>(_e841) - _e832) * _e775)) - _e822) * _e781));
let _e849 = (_e797 + _e798);
let _e851 = select(_e800, _e849, (_e849 < _e800));
let _e857 = global_5.member[bitcast<u32>(select(0i, _e851, (_e851 > 0i)))];
let _e858 = bitcast<f32>(_e857);
let _e859 = (_e849 + 1i);
let _e861 = select(_e800, _e859, (_e859 < _e800));
let _e867 = global_5.member[bitcast<u32>(select(0i, _e861, (_e861 > 0i)))];
let _e871 = (_e858 + ((bitcast<f32>(_e867) - _e858) * _e775));
let _e872 = (_e849 + _e622);
let _e874 = select(_e800, _e872, (_e872 < _e800));
let _e880 = global_5.member[bitcast<u32>(select(0i, _e874, (_e874 > 0i)))];
let _e881 = bitcast<f32>(_e880);
let _e882 = (_e872 + 1i);
let _e884 = select(_e800, _e882, (_e882 < _e800));
let _e890 = global_5.member[bitcast<u32>(select(0i, _e884, (_e884 > 0i)))];
let _e897 = (_e871 + (((_e881 + ((bitcast<f32>(_e890) - _e881) * _e775)) - _e871) * _e781));
let _e899 = (_e797 + (2i * _e798));
let _e901 = select(_e800, _e899, (_e899 < _e800));
let _e907 = global_5.member[bitcast<u32>(select(0i, _e901, (_e901 > 0i)))];
let _e908 = bitcast<f32>(_e907);
let _e909 = (_e899 + 1i);
let _e911 = select(_e800, _e909, (_e909 < _e800));
let _e917 = global_5.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e921 = (_e908 + ((bitcast<f32>(_e917) - _e908) * _e775));
let _e922 = (_e899 + _e622);
let _e924 = select(_e800, _e922, (_e922 < _e800));
let _e930 = global_5.member[bitcast<u32>(select(0i, _e924, (_e924 > 0i)))];
let _e931 = bitcast<f32>(_e930);
let _e932 = (_e922 + 1i);
let _e934 = select(_e800, _e932, (_e932 < _e800));
let _e940 = global_5.member[bitcast<u32>(select(0i, _e934, (_e934 > 0i)))];
let _e947 = (_e921 + (((_e931 + ((bitcast<f32>(_e940) - _e931) * _e775)) - _e921) * _e781));
let _e949 = (_e543 == 0u);
if _e949 {
phi_1569_ = vec3<f32>(_e848, _e897, _e947);
} else {
if _e949 {
phi_1537_ = 1f;
} else {
let _e954 = global_2.member.member_12.member_20.member;
let _e962 = (((_e954.member * _e552) + (_e954.member_1 * _e553)) + (_e954.member_2 * _e554));
let _e966 = (_e552 - (_e954.member * _e962));
let _e967 = (_e553 - (_e954.member_1 * _e962));
let _e968 = (_e554 - (_e954.member_2 * _e962));
let _e973 = (((_e966 * _e966) + (_e967 * _e967)) + (_e968 * _e968));
let _e984 = global_2.member.member_12.member_20.member_1;
let _e990 = global_2.member.member_12.member_20.member_2;
let _e991 = ((_e984 - (sqrt(select(0f, _e973, (_e973 > 0f))) / select(1e-20f, _e962, (_e962 > 1e-20f)))) * _e990);
let _e993 = select(0f, _e991, (_e991 > 0f));
let _e995 = select(1f, _e993, (_e993 < 1f));
phi_1537_ = select(1f, select(0f, ((_e995 * _e995) * (3f - (2f * _e995))), (_e962 > 0f)), (_e990 > 0f));
}
let _e1005 = phi_1537_;
let _e1007 = select(0f, 1f, (_e554 > 0f));
let _e1011 = ((_e848 * _e1007) + _e1005);
let _e1012 = ((_e897 * _e1007) + _e1005);
let _e1013 = ((_e947 * _e1007) + _e1005);
phi_1569_ = vec3<f32>(select(0f, _e1011, (_e1011 > 0f)), select(0f, _e1012, (_e1012 > 0f)), select(0f, _e1013, (_e1013 > 0f)));
}
let _e1022 = phi_1569_;
if _e949 {
phi_1595_ = 1f;
} else {
phi_1595_ = (1f / select(1e-12f, _e559, (_e559 > 1e-12f)));
}
let _e1027 = phi_1595_;
let _e1037 = global_2.member.member_11.member_1;
phi_1863_ = type_29(vec3<f32>((_e1037.member * (_e1022.x * _e1027)), (_e1037.member_1 * (_e1022.y * _e1027)), (_e1037.member_2 * (_e1022.z * _e1027))), _e610);
} else {
let _e1046 = (_e543 == 0u);
if _e1046 {
let _e1050 = global_2.member.member_11.member_1;
let _e1058 = global_2.member.member_11.member;
phi_1862_ = type_29(vec3<f32>(_e1050.member, _e1050.member_1, _e1050.member_2), vec3<f32>(_e1058.member, _e1058.member_1, _e1058.member_2));
} else {
let _e1067 = global_2.member.member_11.member_1;
if _e1046 {
phi_1706_ = 1f;
} else {
phi_1706_ = (1f / select(1e-12f, _e559, (_e559 > 1e-12f)));
}
let _e1075 = phi_1706_;
if _e1046 {
phi_1790_ = 1f;
} else {
let _e1080 = global_2.member.member_12.member_20.member;
let _e1088 = (((_e1080.member * _e552) + (_e1080.member_1 * _e553)) + (_e1080.member_2 * _e554));
let _e1092 = (_e552 - (_e1080.member * _e1088));
let _e1093 = (_e553 - (_e1080.member_1 * _e1088));
let _e1094 = (_e554 - (_e1080.member_2 * _e1088));
let _e1099 = (((_e1092 * _e1092) + (_e1093 * _e1093)) + (_e1094 * _e1094));
let _e1110 = global_2.member.member_12.member_20.member_1;
let _e1116 = global_2.member.member_12.member_20.member_2;
let _e1117 = ((_e1110 - (sqrt(select(0f, _e1099, (_e1099 > 0f))) / select(1e-20f, _e1088, (_e1088 > 1e-20f)))) * _e1116);
let _e1119 = select(0f, _e1117, (_e1117 > 0f));
let _e1121 = select(1f, _e1119, (_e1119 < 1f));
phi_1790_ = select(1f, select(0f, ((_e1121 * _e1121) * (3f - (2f * _e1121))), (_e1088 > 0f)), (_e1116 > 0f));
}
let _e1131 = phi_1790_;
let _e1132 = (_e1075 * _e1131);
phi_1862_ = type_29(vec3<f32>((_e1067.member * _e1132), (_e1067.member_1 * _e1132), (_e1067.member_2 * _e1132)), _e610);
}
let _e1139 = phi_1862_;
phi_1863_ = _e1139;
}
let _e1141 = phi_1863_;
let _e1145 = global_2.member.member_23.member_4;
let _e1153 = (((_e1145.member * _e475) + (_e1145.member_1 * _e476)) + (_e1145.member_2 * _e477));
let _e1157 = global_2.member.member_23.member_5;
let _e1165 = (((_e1157.member * _e475) + (_e1157.member_1 * _e476)) + (_e1157.member_2 * _e477));
let _e1169 = global_2.member.member_23.member_6;
let _e1177 = (((_e1169.member * _e475) + (_e1169.member_1 * _e476)) + (_e1169.member_2 * _e477));
let _e1181 = global_2.member.member_20.member_1;
let _e1191 = global_2.member.member_20.member_2;
let _e1204 = global_2.member.member_20.member_3;
let _e1217 = global_2.member.member_20.member_4;
let _e1221 = (_e1153 * _e1153);
let _e1228 = global_2.member.member_20.member_5;
let _e1232 = (_e1165 * _e1165);
let _e1242 = global_2.member.member_20.member_6;
let _e1246 = (_e1177 * _e1177);
let _e1256 = global_2.member.member_20.member_7;
let _e1260 = (_e1153 * _e1165);
let _e1267 = global_2.member.member_20.member_8;
let _e1271 = (_e1153 * _e1177);
let _e1281 = global_2.member.member_20.member_9;
let _e1285 = (_e1165 * _e1177);
let _e1295 = global_2.member.member_20.member;
let _e1305 = ((_e1295.member + (((_e1181.member * _e1153) + (_e1191.member * _e1165)) + (_e1204.member * _e1177))) + ((((_e1217.member * _e1221) + (_e1228.member * _e1232)) + (_e1242.member * _e1246)) + (((_e1256.member * _e1260) + (_e1267.member * _e1271)) + (_e1281.member * _e1285))));
let _e1306 = ((_e1295.member_1 + (((_e1181.member_1 * _e1153) + (_e1191.member_1 * _e1165)) + (_e1204.member_1 * _e1177))) + ((((_e1217.member_1 * _e1221) + (_e1228.member_1 * _e1232)) + (_e1242.member_1 * _e1246)) + (((_e1256.member_1 * _e1260) + (_e1267.member_1 * _e1271)) + (_e1281.member_1 * _e1285))));
let _e1307 = ((_e1295.member_2 + (((_e1181.member_2 * _e1153) + (_e1191.member_2 * _e1165)) + (_e1204.member_2 * _e1177))) + ((((_e1217.member_2 * _e1221) + (_e1228.member_2 * _e1232)) + (_e1242.member_2 * _e1246)) + (((_e1256.member_2 * _e1260) + (_e1267.member_2 * _e1271)) + (_e1281.member_2 * _e1285))));
let _e1322 = (((_e1141.member_1.x * _e1141.member_1.x) + (_e1141.member_1.y * _e1141.member_1.y)) + (_e1141.member_1.z * _e1141.member_1.z));
let _e1325 = sqrt(select(0f, _e1322, (_e1322 > 0f)));
let _e1331 = (1e-6f * _e1325);
let _e1335 = select((_e1325 / select(_e1331, _e1141.member_1.z, (_e1141.member_1.z > _e1331))), 1f, ((_e613 & 8u) != 0u));
let _e1350 = (-((((_e475 * _e1141.member_1.x) + (_e476 * _e1141.member_1.y)) + (_e477 * _e1141.member_1.z))) / select(1e-20f, _e1325, (_e1325 > 1e-20f)));
let _e1355 = bitcast<f32>((bitcast<u32>(select(0f, _e1350, (_e1350 > 0f))) & 2147483647u));
let _e1368 = ((_e334 || (_e198 == 3f)) && (_e444 != -1i));
let _e1373 = select(0f, (1f - _e242), _e1368);
let _e1374 = local_25;
let _e1376 = local_24;
let _e1377 = ((19i * _e1374) + _e1376);
let _e1379 = select(_e191, _e1377, (_e1377 < _e191));
let _e1384 = global_3.member[bitcast<u32>(select(0i, _e1379, (_e1379 > 0i)))];
let _e1385 = (1f - _e1384);
let _e1389 = (_e1373 * _e1385);
let _e1396 = (_e242 + _e1373);
let _e1402 = ((1f - _e1396) * _e1385);
let _e1403 = local_24;
local_20 = _e1403;
local_21 = _e185;
let _e1404 = local_21;
let _e1406 = local_20;
let _e1407 = ((3i * _e1404) + _e1406);
let _e1409 = select(_e191, _e1407, (_e1407 < _e191));
let _e1414 = global_3.member[bitcast<u32>(select(0i, _e1409, (_e1409 > 0i)))];
let _e1415 = local_21;
let _e1417 = local_20;
let _e1418 = ((4i * _e1415) + _e1417);
let _e1420 = select(_e191, _e1418, (_e1418 < _e191));
let _e1425 = global_3.member[bitcast<u32>(select(0i, _e1420, (_e1420 > 0i)))];
let _e1426 = local_21;
let _e1428 = local_20;
let _e1429 = ((5i * _e1426) + _e1428);
let _e1431 = select(_e191, _e1429, (_e1429 < _e191));
let _e1436 = global_3.member[bitcast<u32>(select(0i, _e1431, (_e1431 > 0i)))];
let _e1441 = (((_e1145.member * _e1414) + (_e1145.member_1 * _e1425)) + (_e1145.member_2 * _e1436));
let _e1446 = (((_e1157.member * _e1414) + (_e1157.member_1 * _e1425)) + (_e1157.member_2 * _e1436));
let _e1451 = (((_e1169.member * _e1414) + (_e1169.member_1 * _e1425)) + (_e1169.member_2 * _e1436));
let _e1456 = (((_e1441 * _e1441) + (_e1446 * _e1446)) + (_e1451 * _e1451));
let _e1459 = sqrt(select(0f, _e1456, (_e1456 > 0f)));
let _e1462 = (1f / select(1e-20f, _e1459, (_e1459 > 1e-20f)));
let _e1463 = (_e1441 * _e1462);
let _e1464 = (_e1446 * _e1462);
let _e1465 = (_e1451 * _e1462);
let _e1466 = local_22;
let _e1467 = bitcast<i32>(_e1466);
let _e1468 = local_23;
let _e1469 = bitcast<i32>(_e1468);
local_19 = 3u;
let _e1472 = global_2.member.member_3.member;
let _e1473 = bitcast<i32>(_e1472);
let _e1476 = global_2.member.member_3.member_1;
let _e1477 = bitcast<i32>(_e1476);
let _e1479 = global_2.member.member_5;
let _e1480 = (_e1479 == 0u);
if _e1480 {
phi_2335_ = _e1473;
} else {
phi_2335_ = bitcast<i32>(_e1479);
}
let _e1483 = phi_2335_;
if (_e1483 == 0i) {
break;
}
if ((_e1483 == -1i) && (_e1467 == i32(-2147483648))) {
break;
}
let _e1489 = (_e1467 - (_e1467 % _e1483));
let _e1491 = ((_e1489 + _e1483) - 1i);
if (_e1467 > _e1489) {
phi_2355_ = (_e1467 - 1i);
} else {
phi_2355_ = _e1489;
}
let _e1495 = phi_2355_;
if (_e1467 < _e1491) {
phi_2361_ = (_e1467 + 1i);
} else {
phi_2361_ = _e1491;
}
let _e1499 = phi_2361_;
if _e1480 {
phi_2371_ = _e1477;
} else {
phi_2371_ = bitcast<i32>(_e1479);
}
let _e1502 = phi_2371_;
if (_e1502 == 0i) {
break;
}
if ((_e1502 == -1i) && (_e1469 == i32(-2147483648))) {
break;
}
let _e1508 = (_e1469 - (_e1469 % _e1502));
let _e1510 = ((_e1508 + _e1502) - 1i);
if (_e1469 > _e1508) {
phi_2391_ = (_e1469 - 1i);
} else {
phi_2391_ = _e1508;
}
let _e1514 = phi_2391_;
if (_e1469 < _e1510) {
phi_2397_ = (_e1469 + 1i);
} else {
phi_2397_ = _e1510;
}
let _e1518 = phi_2397_;
let _e1520 = bitcast<u32>(_e1495);
let _e1521 = bitcast<u32>(_e1469);
let _e1522 = (_e1520 % 16u);
let _e1523 = (_e1521 % 4u);
let _e1525 = (_e1472 - (_e1472 % 16u));
let _e1528 = (_e1476 - (_e1476 % 4u));
let _e1529 = (_e1521 < _e1528);
if ((_e1520 < _e1525) && _e1529) {
phi_2444_ = ((((_e1521 - _e1523) + (_e1522 / 4u)) * _e1472) + (((_e1520 - _e1522) + (_e1523 * 4u)) + (_e1522 % 4u)));
} else {
phi_2444_ = ((_e1521 * _e1472) + _e1520);
}
let _e1544 = phi_2444_;
let _e1546 = local_19;
local_17 = bitcast<i32>(_e1544);
let _e1548 = bitcast<i32>((_e1472 * _e1476));
local_18 = _e1548;
let _e1550 = local_18;
let _e1552 = local_17;
let _e1553 = ((bitcast<i32>(_e1546) * _e1550) + _e1552);
let _e1555 = select(_e191, _e1553, (_e1553 < _e191));
let _e1560 = global_3.member[bitcast<u32>(select(0i, _e1555, (_e1555 > 0i)))];
let _e1563 = local_18;
let _e1565 = local_17;
let _e1566 = ((bitcast<i32>((_e1546 + 1u)) * _e1563) + _e1565);
let _e1568 = select(_e191, _e1566, (_e1566 < _e191));
let _e1573 = global_3.member[bitcast<u32>(select(0i, _e1568, (_e1568 > 0i)))];
let _e1576 = local_18;
let _e1578 = local_17;
let _e1579 = ((bitcast<i32>((_e1546 + 2u)) * _e1576) + _e1578);
let _e1581 = select(_e191, _e1579, (_e1579 < _e191));
let _e1586 = global_3.member[bitcast<u32>(select(0i, _e1581, (_e1581 > 0i)))];
let _e1589 = global_2.member.member_23.member_4;
let _e1597 = (((_e1589.member * _e1560) + (_e1589.member_1 * _e1573)) + (_e1589.member_2 * _e1586));
let _e1600 = global_2.member.member_23.member_5;
let _e1608 = (((_e1600.member * _e1560) + (_e1600.member_1 * _e1573)) + (_e1600.member_2 * _e1586));
let _e1611 = global_2.member.member_23.member_6;
let _e1619 = (((_e1611.member * _e1560) + (_e1611.member_1 * _e1573)) + (_e1611.member_2 * _e1586));
let _e1620 = bitcast<u32>(_e1499);
let _e1621 = (_e1620 % 16u);
if ((_e1620 < _e1525) && _e1529) {
phi_2595_ = ((((_e1521 - _e1523) + (_e1621 / 4u)) * _e1472) + (((_e1620 - _e1621) + (_e1523 * 4u)) + (_e1621 % 4u)));
} else {
phi_2595_ = ((_e1521 * _e1472) + _e1620);
}
let _e1637 = phi_2595_;
let _e1639 = local_19;
local_15 = bitcast<i32>(_e1637);
local_16 = _e1548;
let _e1641 = local_16;
let _e1643 = local_15;
let _e1644 = ((bitcast<i32>(_e1639) * _e1641) + _e1643);
let _e1646 = select(_e191, _e1644, (_e1644 < _e191));
let _e1651 = global_3.member[bitcast<u32>(select(0i, _e1646, (_e1646 > 0i)))];
let _e1654 = local_16;
let _e1656 = local_15;
let _e1657 = ((bitcast<i32>((_e1639 + 1u)) * _e1654) + _e1656);
let _e1659 = select(_e191, _e1657, (_e1657 < _e191));
let _e1664 = global_3.member[bitcast<u32>(select(0i, _e1659, (_e1659 > 0i)))];
let _e1667 = local_16;
let _e1669 = local_15;
let _e1670 = ((bitcast<i32>((_e1639 + 2u)) * _e1667) + _e1669);
let _e1672 = select(_e191, _e1670, (_e1670 < _e191));
let _e1677 = global_3.member[bitcast<u32>(select(0i, _e1672, (_e1672 > 0i)))];
let _e1682 = (((_e1589.member * _e1651) + (_e1589.member_1 * _e1664)) + (_e1589.member_2 * _e1677));
let _e1687 = (((_e1600.member * _e1651) + (_e1600.member_1 * _e1664)) + (_e1600.member_2 * _e1677));
let _e1692 = (((_e1611.member * _e1651) + (_e1611.member_1 * _e1664)) + (_e1611.member_2 * _e1677));
let _e1697 = (((_e1597 * _e1597) + (_e1608 * _e1608)) + (_e1619 * _e1619));
let _e1700 = sqrt(select(0f, _e1697, (_e1697 > 0f)));
let _e1705 = (((_e1682 * _e1682) + (_e1687 * _e1687)) + (_e1692 * _e1692));
let _e1708 = sqrt(select(0f, _e1705, (_e1705 > 0f)));
let _e1709 = (_e1708 > 1e-9f);
let _e1711 = (1f / select(1e-9f, _e1708, _e1709));
let _e1715 = (_e1700 > 1e-9f);
let _e1717 = (1f / select(1e-9f, _e1700, _e1715));
let _e1721 = ((_e1682 * _e1711) - (_e1597 * _e1717));
let _e1722 = ((_e1687 * _e1711) - (_e1608 * _e1717));
let _e1723 = ((_e1692 * _e1711) - (_e1619 * _e1717));
let _e1728 = (((_e1721 * _e1721) + (_e1722 * _e1722)) + (_e1723 * _e1723));
let _e1733 = f32((_e1499 - _e1495));
let _e1737 = select(0f, (sqrt(select(0f, _e1728, (_e1728 > 0f))) / select(1f, _e1733, (_e1733 > 1f))), (_e1715 && _e1709));
let _e1739 = bitcast<u32>(_e1467);
let _e1740 = bitcast<u32>(_e1514);
let _e1741 = (_e1739 % 16u);
let _e1742 = (_e1740 % 4u);
let _e1743 = (_e1739 < _e1525);
if (_e1743 && (_e1740 < _e1528)) {
phi_2822_ = ((((_e1740 - _e1742) + (_e1741 / 4u)) * _e1472) + (((_e1739 - _e1741) + (_e1742 * 4u)) + (_e1741 % 4u)));
} else {
phi_2822_ = ((_e1740 * _e1472) + _e1739);
}
let _e1759 = phi_2822_;
let _e1761 = local_19;
local_13 = bitcast<i32>(_e1759);
local_14 = _e1548;
let _e1763 = local_14;
let _e1765 = local_13;
let _e1766 = ((bitcast<i32>(_e1761) * _e1763) + _e1765);
let _e1768 = select(_e191, _e1766, (_e1766 < _e191));
let _e1773 = global_3.member[bitcast<u32>(select(0i, _e1768, (_e1768 > 0i)))];
let _e1776 = local_14;
let _e1778 = local_13;
let _e1779 = ((bitcast<i32>((_e1761 + 1u)) * _e1776) + _e1778);
let _e1781 = select(_e191, _e1779, (_e1779 < _e191));
let _e1786 = global_3.member[bitcast<u32>(select(0i, _e1781, (_e1781 > 0i)))];
let _e1789 = local_14;
let _e1791 = local_13;
let _e1792 = ((bitcast<i32>((_e1761 + 2u)) * _e1789) + _e1791);
let _e1794 = select(_e191, _e1792, (_e1792 < _e191));
let _e1799 = global_3.member[bitcast<u32>(select(0i, _e1794, (_e1794 > 0i)))];
let _e1804 = (((_e1589.member * _e1773) + (_e1589.member_1 * _e1786)) + (_e1589.member_2 * _e1799));
let _e1809 = (((_e1600.member * _e1773) + (_e1600.member_1 * _e1786)) + (_e1600.member_2 * _e1799));
let _e1814 = (((_e1611.member * _e1773) + (_e1611.member_1 * _e1786)) + (_e1611.member_2 * _e1799));
let _e1815 = bitcast<u32>(_e1518);
let _e1816 = (_e1815 % 4u);
if (_e1743 && (_e1815 < _e1528)) {
phi_2973_ = ((((_e1815 - _e1816) + (_e1741 / 4u)) * _e1472) + (((_e1739 - _e1741) + (_e1816 * 4u)) + (_e1741 % 4u)));
} else {
phi_2973_ = ((_e1815 * _e1472) + _e1739);
}
let _e1832 = phi_2973_;
let _e1834 = local_19;
local_11 = bitcast<i32>(_e1832);
local_12 = _e1548;
let _e1836 = local_12;
let _e1838 = local_11;
let _e1839 = ((bitcast<i32>(_e1834) * _e1836) + _e1838);
let _e1841 = select(_e191, _e1839, (_e1839 < _e191));
let _e1846 = global_3.member[bitcast<u32>(select(0i, _e1841, (_e1841 > 0i)))];
let _e1849 = local_12;
let _e1851 = local_11;
let _e1852 = ((bitcast<i32>((_e1834 + 1u)) * _e1849) + _e1851);
let _e1854 = select(_e191, _e1852, (_e1852 < _e191));
let _e1859 = global_3.member[bitcast<u32>(select(0i, _e1854, (_e1854 > 0i)))];
let _e1862 = local_12;
let _e1864 = local_11;
let _e1865 = ((bitcast<i32>((_e1834 + 2u)) * _e1862) + _e1864);
let _e1867 = select(_e191, _e1865, (_e1865 < _e191));
let _e1872 = global_3.member[bitcast<u32>(select(0i, _e1867, (_e1867 > 0i)))];
let _e1877 = (((_e1589.member * _e1846) + (_e1589.member_1 * _e1859)) + (_e1589.member_2 * _e1872));
let _e1882 = (((_e1600.member * _e1846) + (_e1600.member_1 * _e1859)) + (_e1600.member_2 * _e1872));
let _e1887 = (((_e1611.member * _e1846) + (_e1611.member_1 * _e1859)) + (_e1611.member_2 * _e1872));
let _e1892 = (((_e1804 * _e1804) + (_e1809 * _e1809)) + (_e1814 * _e1814));
let _e1895 = sqrt(select(0f, _e1892, (_e1892 > 0f)));
let _e1900 = (((_e1877 * _e1877) + (_e1882 * _e1882)) + (_e1887 * _e1887));
let _e1903 = sqrt(select(0f, _e1900, (_e1900 > 0f)));
let _e1904 = (_e1903 > 1e-9f);
let _e1906 = (1f / select(1e-9f, _e1903, _e1904));
let _e1910 = (_e1895 > 1e-9f);
let _e1912 = (1f / select(1e-9f, _e1895, _e1910));
let _e1916 = ((_e1877 * _e1906) - (_e1804 * _e1912));
let _e1917 = ((_e1882 * _e1906) - (_e1809 * _e1912));
let _e1918 = ((_e1887 * _e1906) - (_e1814 * _e1912));
let _e1923 = (((_e1916 * _e1916) + (_e1917 * _e1917)) + (_e1918 * _e1918));
let _e1928 = f32((_e1518 - _e1514));
let _e1932 = select(0f, (sqrt(select(0f, _e1923, (_e1923 > 0f))) / select(1f, _e1928, (_e1928 > 1f))), (_e1910 && _e1904));
let _e1934 = select(_e1932, _e1737, (_e1737 > _e1932));
let _e1938 = global_2.member.member_23.member;
let _e1942 = global_2.member.member_23.member_7;
let _e1946 = vec3<f32>(_e1942.member, _e1942.member_1, _e1942.member_2);
let _e1950 = global_2.member.member_23.member_8;
let _e1954 = (_e1938 == 0u);
if _e1954 {
phi_4589_ = _e1946;
} else {
if (_e1938 == 1u) {
let _e1957 = select(-1f, _e1465, (_e1465 > -1f));
let _e1959 = select(1f, _e1957, (_e1957 < 1f));
if (_e1959 > 0f) {
phi_3204_ = _e1946;
} else {
let _e1964 = global_2.member.member_23.member_9;
phi_3204_ = vec3<f32>(_e1964.member, _e1964.member_1, _e1964.member_2);
}
let _e1970 = phi_3204_;
let _e1979 = bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u));
let _e1982 = sqrt(select(0f, _e1979, (_e1979 > 0f)));
phi_4588_ = vec3<f32>((_e1950.member + ((_e1970.x - _e1950.member) * _e1982)), (_e1950.member_1 + ((_e1970.y - _e1950.member_1) * _e1982)), (_e1950.member_2 + ((_e1970.z - _e1950.member_2) * _e1982)));
} else {
if (_e1938 == 2u) {
let _e1994 = global_2.member.member_23.member_10;
let _e1995 = (_e1934 / _e1994);
let _e1997 = select(1e-4f, _e1995, (_e1995 > 1e-4f));
let _e2000 = bitcast<f32>((bitcast<u32>(_e1463) & 2147483647u));
let _e2003 = bitcast<f32>((bitcast<u32>(_e1464) & 2147483647u));
let _e2007 = select(_e2003, _e2000, (_e2000 > _e2003));
let _e2010 = (select(_e2003, _e2000, (_e2000 < _e2003)) / select(1.1754944e-38f, _e2007, (_e2007 > 1.1754944e-38f)));
let _e2011 = (_e2010 > 0.41421357f);
let _e2015 = select(_e2010, ((_e2010 - 1f) / (_e2010 + 1f)), _e2011);
let _e2016 = (_e2015 * _e2015);
let _e2031 = (select(0f, 0.7853982f, _e2011) + (_e2015 + ((_e2015 * _e2016) * (-0.33333334f + (_e2016 * (0.2f + (_e2016 * (-0.14285713f + (_e2016 * (0.11111111f + (_e2016 * (-0.09090909f + (_e2016 * 0.0585f)))))))))))));
let _e2034 = select(_e2031, (1.5707964f - _e2031), (_e2003 > _e2000));
let _e2037 = select(_e2034, (3.1415927f - _e2034), (_e1463 < 0f));
let _e2043 = (1f - (_e1465 * _e1465));
let _e2046 = sqrt(select(0f, _e2043, (_e2043 > 0f)));
let _e2049 = (_e1997 / select(1e-3f, _e2046, (_e2046 > 1e-3f)));
let _e2050 = ((select(_e2037, -(_e2037), (_e1464 < 0f)) / _e1994) * 0.5f);
let _e2052 = select(-8e6f, _e2050, (_e2050 > -8e6f));
let _e2054 = select(8e6f, _e2052, (_e2052 < 8e6f));
let _e2061 = select(0i, select(select(i32(_e2054), i32(-2147483648), (_e2054 < -2147483600f)), 2147483647i, (_e2054 > 2147483500f)), (_e2054 == _e2054));
let _e2068 = ((_e2050 - f32((_e2061 - select(0i, 1i, (_e2054 < f32(_e2061)))))) * 2f);
let _e2076 = ((select(select((_e2068 - 2f), (1f - _e2068), (_e2068 < 1.5f)), _e2068, (_e2068 < 0.5f)) * 2f) / _e2049);
let _e2078 = select(-1f, _e2076, (_e2076 > -1f));
let _e2081 = (2f - _e2049);
let _e2083 = select(0f, _e2081, (_e2081 > 0f));
let _e2088 = select(-1f, _e1465, (_e1465 > -1f));
let _e2090 = select(1f, _e2088, (_e2088 < 1f));
let _e2093 = ((1f - _e2090) * (1f + _e2090));
let _e2096 = sqrt(select(0f, _e2093, (_e2093 > 0f)));
let _e2099 = bitcast<f32>((bitcast<u32>(_e2096) & 2147483647u));
let _e2102 = bitcast<f32>((bitcast<u32>(_e2090) & 2147483647u));
let _e2106 = select(_e2102, _e2099, (_e2099 > _e2102));
let _e2109 = (select(_e2102, _e2099, (_e2099 < _e2102)) / select(1.1754944e-38f, _e2106, (_e2106 > 1.1754944e-38f)));
let _e2110 = (_e2109 > 0.41421357f);
let _e2114 = select(_e2109, ((_e2109 - 1f) / (_e2109 + 1f)), _e2110);
let _e2115 = (_e2114 * _e2114);
let _e2130 = (select(0f, 0.7853982f, _e2110) + (_e2114 + ((_e2114 * _e2115) * (-0.33333334f + (_e2115 * (0.2f + (_e2115 * (-0.14285713f + (_e2115 * (0.11111111f + (_e2115 * (-0.09090909f + (_e2115 * 0.0585f)))))))))))));
let _e2133 = select(_e2130, (1.5707964f - _e2130), (_e2102 > _e2099));
let _e2136 = select(_e2133, (3.1415927f - _e2133), (_e2096 < 0f));
let _e2141 = ((select(_e2136, -(_e2136), (_e2090 < 0f)) / _e1994) * 0.5f);
let _e2143 = select(-8e6f, _e2141, (_e2141 > -8e6f));
let _e2145 = select(8e6f, _e2143, (_e2143 < 8e6f));
let _e2152 = select(0i, select(select(i32(_e2145), i32(-2147483648), (_e2145 < -2147483600f)), 2147483647i, (_e2145 > 2147483500f)), (_e2145 == _e2145));
let _e2159 = ((_e2141 - f32((_e2152 - select(0i, 1i, (_e2145 < f32(_e2152)))))) * 2f);
let _e2167 = ((select(select((_e2159 - 2f), (1f - _e2159), (_e2159 < 1.5f)), _e2159, (_e2159 < 0.5f)) * 2f) / _e1997);
let _e2169 = select(-1f, _e2167, (_e2167 > -1f));
let _e2172 = (2f - _e1997);
let _e2174 = select(0f, _e2172, (_e2172 > 0f));
let _e2180 = (0.5f + ((0.5f * (select(1f, _e2078, (_e2078 < 1f)) * select(1f, _e2083, (_e2083 < 1f)))) * (select(1f, _e2169, (_e2169 < 1f)) * select(1f, _e2174, (_e2174 < 1f)))));
phi_4587_ = vec3<f32>((_e1942.member + ((_e1950.member - _e1942.member) * _e2180)), (_e1942.member_1 + ((_e1950.member_1 - _e1942.member_1) * _e2180)), (_e1942.member_2 + ((_e1950.member_2 - _e1942.member_2) * _e2180)));
} else {
let _e2194 = global_2.member.member_23.member_1;
let _e2195 = bitcast<i32>(_e2194);
let _e2200 = global_2.member.member_23.member_3;
let _e2202 = f32(bitcast<i32>(_e2200));
let _e2204 = (2f * 3.1415927f);
let _e2205 = ((_e1934 * f32(_e2195)) / _e2204);
let _e2207 = select(1e-6f, _e2205, (_e2205 > 1e-6f));
let _e2210 = bitcast<u32>(select(1.1754944e-38f, _e2207, (_e2207 > 1.1754944e-38f)));
let _e2211 = (_e2210 & 8388607u);
let _e2213 = select(0u, 1u, (_e2211 > 3474675u));
let _e2224 = bitcast<f32>((_e2211 | ((127u - _e2213) << bitcast<u32>(23i))));
let _e2227 = ((_e2224 - 1f) / (_e2224 + 1f));
let _e2228 = (_e2227 * _e2227);
let _e2243 = (f32(((bitcast<i32>((_e2210 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e2213))) + (((2f * _e2227) + ((_e2227 * _e2228) * (0.6666667f + (_e2228 * (0.4f + (_e2228 * (0.2857143f + (_e2228 * (0.22222222f + (_e2228 * 0.18181819f)))))))))) * 1.442695f));
let _e2244 = (_e2202 - 1f);
let _e2246 = select(0f, _e2243, (_e2243 > 0f));
let _e2248 = select(_e2244, _e2246, (_e2246 < _e2244));
let _e2249 = (_e2202 - 2f);
let _e2251 = select(0f, _e2249, (_e2249 > 0f));
let _e2253 = select(0f, _e2248, (_e2248 > 0f));
let _e2255 = select(_e2251, _e2253, (_e2253 < _e2251));
let _e2262 = select(0i, select(select(i32(_e2255), i32(-2147483648), (_e2255 < -2147483600f)), 2147483647i, (_e2255 > 2147483500f)), (_e2255 == _e2255));
let _e2266 = (_e2262 - select(0i, 1i, (_e2255 < f32(_e2262))));
let _e2269 = bitcast<f32>((bitcast<u32>(_e1464) & 2147483647u));
let _e2272 = bitcast<f32>((bitcast<u32>(_e1463) & 2147483647u));
let _e2276 = select(_e2272, _e2269, (_e2269 > _e2272));
let _e2279 = (select(_e2272, _e2269, (_e2269 < _e2272)) / select(1.1754944e-38f, _e2276, (_e2276 > 1.1754944e-38f)));
let _e2280 = (_e2279 > 0.41421357f);
let _e2284 = select(_e2279, ((_e2279 - 1f) / (_e2279 + 1f)), _e2280);
let _e2285 = (_e2284 * _e2284);
let _e2300 = (select(0f, 0.7853982f, _e2280) + (_e2284 + ((_e2284 * _e2285) * (-0.33333334f + (_e2285 * (0.2f + (_e2285 * (-0.14285713f + (_e2285 * (0.11111111f + (_e2285 * (-0.09090909f + (_e2285 * 0.0585f)))))))))))));
let _e2303 = select(_e2300, (1.5707964f - _e2300), (_e2272 > _e2269));
let _e2306 = select(_e2303, (3.1415927f - _e2303), (_e1464 < 0f));
let _e2311 = (0.5f - (select(_e2306, -(_e2306), (_e1463 < 0f)) / _e2204));
let _e2313 = select(-1f, _e1465, (_e1465 > -1f));
let _e2315 = select(1f, _e2313, (_e2313 < 1f));
let _e2318 = ((1f - _e2315) * (1f + _e2315));
let _e2321 = sqrt(select(0f, _e2318, (_e2318 > 0f)));
let _e2324 = bitcast<f32>((bitcast<u32>(_e2321) & 2147483647u));
let _e2327 = bitcast<f32>((bitcast<u32>(_e2315) & 2147483647u));
let _e2331 = select(_e2327, _e2324, (_e2324 > _e2327));
let _e2334 = (select(_e2327, _e2324, (_e2324 < _e2327)) / select(1.1754944e-38f, _e2331, (_e2331 > 1.1754944e-38f)));
let _e2335 = (_e2334 > 0.41421357f);
let _e2339 = select(_e2334, ((_e2334 - 1f) / (_e2334 + 1f)), _e2335);
let _e2340 = (_e2339 * _e2339);
let _e2355 = (select(0f, 0.7853982f, _e2335) + (_e2339 + ((_e2339 * _e2340) * (-0.33333334f + (_e2340 * (0.2f + (_e2340 * (-0.14285713f + (_e2340 * (0.11111111f + (_e2340 * (-0.09090909f + (_e2340 * 0.0585f)))))))))))));
let _e2358 = select(_e2355, (1.5707964f - _e2355), (_e2327 > _e2324));
let _e2361 = select(_e2358, (3.1415927f - _e2358), (_e2321 < 0f));
let _e2366 = (0.5f - (select(_e2361, -(_e2361), (_e2315 < 0f)) / 3.1415927f));
let _e2370 = global_2.member.member_23.member_2;
let _e2371 = bitcast<i32>(_e2370);
phi_3806_ = 0i;
phi_3809_ = 0i;
phi_3811_ = _e2371;
phi_3813_ = _e2195;
loop {
let _e2373 = phi_3806_;
let _e2375 = phi_3809_;
let _e2377 = phi_3811_;
let _e2379 = phi_3813_;
local_26 = _e2379;
local_27 = _e2377;
local_28 = _e2379;
local_29 = _e2379;
local_30 = _e2379;
local_31 = _e2379;
local_32 = _e2379;
local_33 = _e2379;
local_34 = _e2377;
local_35 = _e2377;
local_36 = _e2377;
local_37 = _e2377;
local_38 = _e2379;
local_39 = _e2375;
local_40 = _e2379;
local_41 = _e2375;
let _e2380 = (_e2373 < _e2266);
if _e2380 {
if (_e2379 > 1i) {
phi_3828_ = (_e2379 >> bitcast<u32>(1i));
} else {
phi_3828_ = 1i;
}
let _e2387 = phi_3828_;
if (_e2377 > 1i) {
phi_3834_ = (_e2377 >> bitcast<u32>(1i));
} else {
phi_3834_ = 1i;
}
let _e2392 = phi_3834_;
phi_3807_ = (_e2373 + 1i);
phi_3810_ = (_e2375 + (_e2379 * _e2377));
phi_3812_ = _e2392;
phi_3814_ = _e2387;
} else {
phi_3807_ = i32();
phi_3810_ = i32();
phi_3812_ = i32();
phi_3814_ = i32();
}
let _e2395 = phi_3807_;
let _e2397 = phi_3810_;
let _e2399 = phi_3812_;
let _e2401 = phi_3814_;
continue;
continuing {
phi_3806_ = _e2395;
phi_3809_ = _e2397;
phi_3811_ = _e2399;
phi_3813_ = _e2401;
break if !(_e2380);
}
}
let _e2404 = local_26;
let _e2405 = f32(_e2404);
let _e2407 = ((_e2311 * _e2405) - 0.5f);
let _e2409 = local_27;
let _e2410 = f32(_e2409);
let _e2412 = ((_e2366 * _e2410) - 0.5f);
let _e2414 = select(-1f, _e2407, (_e2407 > -1f));
let _e2416 = select(_e2405, _e2414, (_e2414 < _e2405));
let _e2423 = select(0i, select(select(i32(_e2416), i32(-2147483648), (_e2416 < -2147483600f)), 2147483647i, (_e2416 > 2147483500f)), (_e2416 == _e2416));
let _e2427 = (_e2423 - select(0i, 1i, (_e2416 < f32(_e2423))));
let _e2429 = select(-1f, _e2412, (_e2412 > -1f));
let _e2431 = select(_e2410, _e2429, (_e2429 < _e2410));
let _e2438 = select(0i, select(select(i32(_e2431), i32(-2147483648), (_e2431 < -2147483600f)), 2147483647i, (_e2431 > 2147483500f)), (_e2431 == _e2431));
let _e2442 = (_e2438 - select(0i, 1i, (_e2431 < f32(_e2438))));
let _e2444 = (_e2407 - f32(_e2427));
let _e2446 = (_e2412 - f32(_e2442));
let _e2448 = select(0f, _e2446, (_e2446 > 0f));
let _e2450 = select(1f, _e2448, (_e2448 < 1f));
if (_e2427 < 0i) {
let _e2453 = local_28;
phi_3909_ = (_e2427 + _e2453);
} else {
phi_3909_ = _e2427;
}
let _e2456 = phi_3909_;
let _e2458 = local_29;
if (_e2456 >= _e2458) {
let _e2461 = local_30;
phi_3915_ = (_e2456 - _e2461);
} else {
phi_3915_ = _e2456;
}
let _e2464 = phi_3915_;
let _e2465 = (_e2427 + 1i);
if (_e2465 < 0i) {
let _e2468 = local_31;
phi_3922_ = (_e2465 + _e2468);
} else {
phi_3922_ = _e2465;
}
let _e2471 = phi_3922_;
let _e2473 = local_32;
if (_e2471 >= _e2473) {
let _e2476 = local_33;
phi_3928_ = (_e2471 - _e2476);
} else {
phi_3928_ = _e2471;
}
let _e2479 = phi_3928_;
let _e2481 = select(_e2442, 0i, (_e2442 < 0i));
let _e2483 = local_34;
if (_e2481 >= _e2483) {
let _e2486 = local_35;
phi_3939_ = (_e2486 - 1i);
} else {
phi_3939_ = _e2481;
}
let _e2489 = phi_3939_;
let _e2490 = (_e2442 + 1i);
let _e2492 = select(_e2490, 0i, (_e2490 < 0i));
let _e2494 = local_36;
if (_e2492 >= _e2494) {
let _e2497 = local_37;
phi_3951_ = (_e2497 - 1i);
} else {
phi_3951_ = _e2492;
}
let _e2500 = phi_3951_;
let _e2502 = local_38;
let _e2505 = local_39;
let _e2506 = (_e2505 + (_e2489 * _e2502));
let _e2508 = local_40;
let _e2511 = local_41;
let _e2512 = (_e2511 + (_e2500 * _e2508));
let _e2514 = (3i * (_e2506 + _e2464));
let _e2516 = (bitcast<i32>(_e125) - 1i);
let _e2518 = select(_e2516, _e2514, (_e2514 < _e2516));
let _e2524 = global_4.member[bitcast<u32>(select(0i, _e2518, (_e2518 > 0i)))];
let _e2525 = (_e2514 + 1i);
let _e2527 = select(_e2516, _e2525, (_e2525 < _e2516));
let _e2533 = global_4.member[bitcast<u32>(select(0i, _e2527, (_e2527 > 0i)))];
let _e2534 = (_e2514 + 2i);
let _e2536 = select(_e2516, _e2534, (_e2534 < _e2516));
let _e2542 = global_4.member[bitcast<u32>(select(0i, _e2536, (_e2536 > 0i)))];
let _e2544 = (3i * (_e2506 + _e2479));
let _e2546 = select(_e2516, _e2544, (_e2544 < _e2516));
let _e2552 = global_4.member[bitcast<u32>(select(0i, _e2546, (_e2546 > 0i)))];
let _e2553 = (_e2544 + 1i);
let _e2555 = select(_e2516, _e2553, (_e2553 < _e2516));
let _e2561 = global_4.member[bitcast<u32>(select(0i, _e2555, (_e2555 > 0i)))];
let _e2562 = (_e2544 + 2i);
let _e2564 = select(_e2516, _e2562, (_e2562 < _e2516));
let _e2570 = global_4.member[bitcast<u32>(select(0i, _e2564, (_e2564 > 0i)))];
let _e2572 = (3i * (_e2512 + _e2464));
let _e2574 = select(_e2516, _e2572, (_e2572 < _e2516));
let _e2580 = global_4.member[bitcast<u32>(select(0i, _e2574, (_e2574 > 0i)))];
let _e2581 = (_e2572 + 1i);
let _e2583 = select(_e2516, _e2581, (_e2581 < _e2516));
let _e2589 = global_4.member[bitcast<u32>(select(0i, _e2583, (_e2583 > 0i)))];
let _e2590 = (_e2572 + 2i);
let _e2592 = select(_e2516, _e2590, (_e2590 < _e2516));
let _e2598 = global_4.member[bitcast<u32>(select(0i, _e2592, (_e2592 > 0i)))];
let _e2600 = (3i * (_e2512 + _e2479));
let _e2602 = select(_e2516, _e2600, (_e2600 < _e2516));
let _e2608 = global_4.member[bitcast<u32>(select(0i, _e2602, (_e2602 > 0i)))];
let _e2609 = (_e2600 + 1i);
let _e2611 = select(_e2516, _e2609, (_e2609 < _e2516));
let _e2617 = global_4.member[bitcast<u32>(select(0i, _e2611, (_e2611 > 0i)))];
let _e2618 = (_e2600 + 2i);
let _e2620 = select(_e2516, _e2618, (_e2618 < _e2516));
let _e2626 = global_4.member[bitcast<u32>(select(0i, _e2620, (_e2620 > 0i)))];
let _e2633 = (_e2524 + ((_e2552 - _e2524) * _e2444));
let _e2634 = (_e2533 + ((_e2561 - _e2533) * _e2444));
let _e2635 = (_e2542 + ((_e2570 - _e2542) * _e2444));
let _e2651 = (_e2633 + (((_e2580 + ((_e2608 - _e2580) * _e2444)) - _e2633) * _e2450));
let _e2652 = (_e2634 + (((_e2589 + ((_e2617 - _e2589) * _e2444)) - _e2634) * _e2450));
let _e2653 = (_e2635 + (((_e2598 + ((_e2626 - _e2598) * _e2444)) - _e2635) * _e2450));
phi_4187_ = 0i;
phi_4190_ = 0i;
phi_4192_ = _e2371;
phi_4194_ = _e2195;
loop {
let _e2656 = phi_4187_;
let _e2658 = phi_4190_;
let _e2660 = phi_4192_;
let _e2662 = phi_4194_;
local_42 = _e2662;
local_43 = _e2660;
local_44 = _e2662;
local_45 = _e2662;
local_46 = _e2662;
local_47 = _e2662;
local_48 = _e2662;
local_49 = _e2662;
local_50 = _e2660;
local_51 = _e2660;
local_52 = _e2660;
local_53 = _e2660;
local_54 = _e2662;
local_55 = _e2658;
local_56 = _e2662;
local_57 = _e2658;
let _e2663 = (_e2656 < (_e2266 + 1i));
if _e2663 {
if (_e2662 > 1i) {
phi_4209_ = (_e2662 >> bitcast<u32>(1i));
} else {
phi_4209_ = 1i;
}
let _e2670 = phi_4209_;
if (_e2660 > 1i) {
phi_4215_ = (_e2660 >> bitcast<u32>(1i));
} else {
phi_4215_ = 1i;
}
let _e2675 = phi_4215_;
phi_4188_ = (_e2656 + 1i);
phi_4191_ = (_e2658 + (_e2662 * _e2660));
phi_4193_ = _e2675;
phi_4195_ = _e2670;
} else {
phi_4188_ = i32();
phi_4191_ = i32();
phi_4193_ = i32();
phi_4195_ = i32();
}
let _e2678 = phi_4188_;
let _e2680 = phi_4191_;
let _e2682 = phi_4193_;
let _e2684 = phi_4195_;
continue;
continuing {
phi_4187_ = _e2678;
phi_4190_ = _e2680;
phi_4192_ = _e2682;
phi_4194_ = _e2684;
break if !(_e2663);
}
}
let _e2687 = local_42;
let _e2688 = f32(_e2687);
let _e2690 = ((_e2311 * _e2688) - 0.5f);
let _e2692 = local_43;
let _e2693 = f32(_e2692);
let _e2695 = ((_e2366 * _e2693) - 0.5f);
let _e2697 = select(-1f, _e2690, (_e2690 > -1f));
let _e2699 = select(_e2688, _e2697, (_e2697 < _e2688));
let _e2706 = select(0i, select(select(i32(_e2699), i32(-2147483648), (_e2699 < -2147483600f)), 2147483647i, (_e2699 > 2147483500f)), (_e2699 == _e2699));
let _e2710 = (_e2706 - select(0i, 1i, (_e2699 < f32(_e2706))));
let _e2712 = select(-1f, _e2695, (_e2695 > -1f));
let _e2714 = select(_e2693, _e2712, (_e2712 < _e2693));
let _e2721 = select(0i, select(select(i32(_e2714), i32(-2147483648), (_e2714 < -2147483600f)), 2147483647i, (_e2714 > 2147483500f)), (_e2714 == _e2714));
let _e2725 = (_e2721 - select(0i, 1i, (_e2714 < f32(_e2721))));
let _e2727 = (_e2690 - f32(_e2710));
let _e2729 = (_e2695 - f32(_e2725));
let _e2731 = select(0f, _e2729, (_e2729 > 0f));
let _e2733 = select(1f, _e2731, (_e2731 < 1f));
if (_e2710 < 0i) {
let _e2736 = local_44;
phi_4290_ = (_e2710 + _e2736);
} else {
phi_4290_ = _e2710;
}
let _e2739 = phi_4290_;
let _e2741 = local_45;
if (_e2739 >= _e2741) {
let _e2744 = local_46;
phi_4296_ = (_e2739 - _e2744);
} else {
phi_4296_ = _e2739;
}
let _e2747 = phi_4296_;
let _e2748 = (_e2710 + 1i);
if (_e2748 < 0i) {
let _e2751 = local_47;
phi_4303_ = (_e2748 + _e2751);
} else {
phi_4303_ = _e2748;
}
let _e2754 = phi_4303_;
let _e2756 = local_48;
if (_e2754 >= _e2756) {
let _e2759 = local_49;
phi_4309_ = (_e2754 - _e2759);
} else {
phi_4309_ = _e2754;
}
let _e2762 = phi_4309_;
let _e2764 = select(_e2725, 0i, (_e2725 < 0i));
let _e2766 = local_50;
if (_e2764 >= _e2766) {
let _e2769 = local_51;
phi_4320_ = (_e2769 - 1i);
} else {
phi_4320_ = _e2764;
}
let _e2772 = phi_4320_;
let _e2773 = (_e2725 + 1i);
let _e2775 = select(_e2773, 0i, (_e2773 < 0i));
let _e2777 = local_52;
if (_e2775 >= _e2777) {
let _e2780 = local_53;
phi_4332_ = (_e2780 - 1i);
} else {
phi_4332_ = _e2775;
}
let _e2783 = phi_4332_;
let _e2785 = local_54;
let _e2788 = local_55;
let _e2789 = (_e2788 + (_e2772 * _e2785));
let _e2791 = local_56;
let _e2794 = local_57;
let _e2795 = (_e2794 + (_e2783 * _e2791));
let _e2797 = (3i * (_e2789 + _e2747));
let _e2799 = select(_e2516, _e2797, (_e2797 < _e2516));
let _e2805 = global_4.member[bitcast<u32>(select(0i, _e2799, (_e2799 > 0i)))];
let _e2806 = (_e2797 + 1i);
let _e2808 = select(_e2516, _e2806, (_e2806 < _e2516));
let _e2814 = global_4.member[bitcast<u32>(select(0i, _e2808, (_e2808 > 0i)))];
let _e2815 = (_e2797 + 2i);
let _e2817 = select(_e2516, _e2815, (_e2815 < _e2516));
let _e2823 = global_4.member[bitcast<u32>(select(0i, _e2817, (_e2817 > 0i)))];
let _e2825 = (3i * (_e2789 + _e2762));
let _e2827 = select(_e2516, _e2825, (_e2825 < _e2516));
let _e2833 = global_4.member[bitcast<u32>(select(0i, _e2827, (_e2827 > 0i)))];
let _e2834 = (_e2825 + 1i);
let _e2836 = select(_e2516, _e2834, (_e2834 < _e2516));
let _e2842 = global_4.member[bitcast<u32>(select(0i, _e2836, (_e2836 > 0i)))];
let _e2843 = (_e2825 + 2i);
let _e2845 = select(_e2516, _e2843, (_e2843 < _e2516));
let _e2851 = global_4.member[bitcast<u32>(select(0i, _e2845, (_e2845 > 0i)))];
let _e2853 = (3i * (_e2795 + _e2747));
let _e2855 = select(_e2516, _e2853, (_e2853 < _e2516));
let _e2861 = global_4.member[bitcast<u32>(select(0i, _e2855, (_e2855 > 0i)))];
let _e2862 = (_e2853 + 1i);
let _e2864 = select(_e2516, _e2862, (_e2862 < _e2516));
let _e2870 = global_4.member[bitcast<u32>(select(0i, _e2864, (_e2864 > 0i)))];
let _e2871 = (_e2853 + 2i);
let _e2873 = select(_e2516, _e2871, (_e2871 < _e2516));
let _e2879 = global_4.member[bitcast<u32>(select(0i, _e2873, (_e2873 > 0i)))];
let _e2881 = (3i * (_e2795 + _e2762));
let _e2883 = select(_e2516, _e2881, (_e2881 < _e2516));
let _e2889 = global_4.member[bitcast<u32>(select(0i, _e2883, (_e2883 > 0i)))];
let _e2890 = (_e2881 + 1i);
let _e2892 = select(_e2516, _e2890, (_e2890 < _e2516));
let _e2898 = global_4.member[bitcast<u32>(select(0i, _e2892, (_e2892 > 0i)))];
let _e2899 = (_e2881 + 2i);
let _e2901 = select(_e2516, _e2899, (_e2899 < _e2516));
let _e2907 = global_4.member[bitcast<u32>(select(0i, _e2901, (_e2901 > 0i)))];
let _e2914 = (_e2805 + ((_e2833 - _e2805) * _e2727));
let _e2915 = (_e2814 + ((_e2842 - _e2814) * _e2727));
let _e2916 = (_e2823 + ((_e2851 - _e2823) * _e2727));
let _e2939 = (_e2248 - f32(_e2266));
let _e2941 = select(0f, _e2939, (_e2939 > 0f));
let _e2943 = select(1f, _e2941, (_e2941 < 1f));
let _e2953 = global_2.member.member_23.member_11;
phi_4587_ = vec3<f32>(((_e2651 + (((_e2914 + (((_e2861 + ((_e2889 - _e2861) * _e2727)) - _e2914) * _e2733)) - _e2651) * _e2943)) * _e2953), ((_e2652 + (((_e2915 + (((_e2870 + ((_e2898 - _e2870) * _e2727)) - _e2915) * _e2733)) - _e2652) * _e2943)) * _e2953), ((_e2653 + (((_e2916 + (((_e2879 + ((_e2907 - _e2879) * _e2727)) - _e2916) * _e2733)) - _e2653) * _e2943)) * _e2953));
}
let _e2959 = phi_4587_;
phi_4588_ = _e2959;
}
let _e2961 = phi_4588_;
phi_4589_ = _e2961;
}
let _e2963 = phi_4589_;
let _e2967 = global_2.member.member_23.member_12;
let _e2974 = (_e1402 * _e2967);
let _e2978 = ((_e209 + ((_e264 * (select(_e468.member, _e457.member, _e446) * (((_e1141.member.x * _e1335) * _e1355) + select(0f, _e1305, (_e1305 > 0f))))) * _e1389)) + ((_e264 * _e2963.x) * _e2974));
let _e2979 = ((_e220 + ((_e275 * (select(_e468.member_1, _e457.member_1, _e446) * (((_e1141.member.y * _e1335) * _e1355) + select(0f, _e1306, (_e1306 > 0f))))) * _e1389)) + ((_e275 * _e2963.y) * _e2974));
let _e2980 = ((_e231 + ((_e286 * (select(_e468.member_2, _e457.member_2, _e446) * (((_e1141.member.z * _e1335) * _e1355) + select(0f, _e1307, (_e1307 > 0f))))) * _e1389)) + ((_e286 * _e2963.z) * _e2974));
if ((((_e133.member_2 == 1u) || (_e133.member_2 == 5u)) || (_e133.member_2 == 6u)) || ((_e133.member_2 == 2u) || (_e133.member_2 == 7u))) {
let _e2991 = local_24;
local_9 = _e2991;
local_10 = _e185;
let _e2992 = local_10;
let _e2994 = local_9;
let _e2995 = ((20i * _e2992) + _e2994);
let _e2997 = select(_e191, _e2995, (_e2995 < _e191));
let _e3002 = global_3.member[bitcast<u32>(select(0i, _e2997, (_e2997 > 0i)))];
let _e3003 = local_10;
let _e3005 = local_9;
let _e3006 = ((21i * _e3003) + _e3005);
let _e3008 = select(_e191, _e3006, (_e3006 < _e191));
let _e3013 = global_3.member[bitcast<u32>(select(0i, _e3008, (_e3008 > 0i)))];
let _e3014 = local_10;
let _e3016 = local_9;
let _e3017 = ((22i * _e3014) + _e3016);
let _e3019 = select(_e191, _e3017, (_e3017 < _e191));
let _e3024 = global_3.member[bitcast<u32>(select(0i, _e3019, (_e3019 > 0i)))];
let _e3029 = (((_e1145.member * _e3002) + (_e1145.member_1 * _e3013)) + (_e1145.member_2 * _e3024));
let _e3034 = (((_e1157.member * _e3002) + (_e1157.member_1 * _e3013)) + (_e1157.member_2 * _e3024));
let _e3039 = (((_e1169.member * _e3002) + (_e1169.member_1 * _e3013)) + (_e1169.member_2 * _e3024));
let _e3044 = (((_e3029 * _e3029) + (_e3034 * _e3034)) + (_e3039 * _e3039));
let _e3047 = sqrt(select(0f, _e3044, (_e3044 > 0f)));
let _e3048 = local_22;
let _e3049 = bitcast<i32>(_e3048);
let _e3050 = local_23;
let _e3051 = bitcast<i32>(_e3050);
local_8 = 20u;
if _e1480 {
phi_4766_ = _e1473;
} else {
phi_4766_ = bitcast<i32>(_e1479);
}
let _e3054 = phi_4766_;
if (_e3054 == 0i) {
break;
}
if ((_e3054 == -1i) && (_e3049 == i32(-2147483648))) {
break;
}
let _e3060 = (_e3049 - (_e3049 % _e3054));
let _e3062 = ((_e3060 + _e3054) - 1i);
if (_e3049 > _e3060) {
phi_4786_ = (_e3049 - 1i);
} else {
phi_4786_ = _e3060;
}
let _e3066 = phi_4786_;
if (_e3049 < _e3062) {
phi_4792_ = (_e3049 + 1i);
} else {
phi_4792_ = _e3062;
}
let _e3070 = phi_4792_;
if _e1480 {
phi_4802_ = _e1477;
} else {
phi_4802_ = bitcast<i32>(_e1479);
}
let _e3073 = phi_4802_;
if (_e3073 == 0i) {
break;
}
if ((_e3073 == -1i) && (_e3051 == i32(-2147483648))) {
break;
}
let _e3079 = (_e3051 - (_e3051 % _e3073));
let _e3081 = ((_e3079 + _e3073) - 1i);
if (_e3051 > _e3079) {
phi_4822_ = (_e3051 - 1i);
} else {
phi_4822_ = _e3079;
}
let _e3085 = phi_4822_;
if (_e3051 < _e3081) {
phi_4828_ = (_e3051 + 1i);
} else {
phi_4828_ = _e3081;
}
let _e3089 = phi_4828_;
let _e3091 = bitcast<u32>(_e3066);
let _e3092 = bitcast<u32>(_e3051);
let _e3093 = (_e3091 % 16u);
let _e3094 = (_e3092 % 4u);
let _e3096 = (_e3092 < _e1528);
if ((_e3091 < _e1525) && _e3096) {
phi_4875_ = ((((_e3092 - _e3094) + (_e3093 / 4u)) * _e1472) + (((_e3091 - _e3093) + (_e3094 * 4u)) + (_e3093 % 4u)));
} else {
phi_4875_ = ((_e3092 * _e1472) + _e3091);
}
let _e3111 = phi_4875_;
let _e3113 = local_8;
local_6 = bitcast<i32>(_e3111);
local_7 = _e1548;
let _e3115 = local_7;
let _e3117 = local_6;
let _e3118 = ((bitcast<i32>(_e3113) * _e3115) + _e3117);
let _e3120 = select(_e191, _e3118, (_e3118 < _e191));
let _e3125 = global_3.member[bitcast<u32>(select(0i, _e3120, (_e3120 > 0i)))];
let _e3128 = local_7;
let _e3130 = local_6;
let _e3131 = ((bitcast<i32>((_e3113 + 1u)) * _e3128) + _e3130);
let _e3133 = select(_e191, _e3131, (_e3131 < _e191));
let _e3138 = global_3.member[bitcast<u32>(select(0i, _e3133, (_e3133 > 0i)))];
let _e3141 = local_7;
let _e3143 = local_6;
let _e3144 = ((bitcast<i32>((_e3113 + 2u)) * _e3141) + _e3143);
let _e3146 = select(_e191, _e3144, (_e3144 < _e191));
let _e3151 = global_3.member[bitcast<u32>(select(0i, _e3146, (_e3146 > 0i)))];
let _e3156 = (((_e1589.member * _e3125) + (_e1589.member_1 * _e3138)) + (_e1589.member_2 * _e3151));
let _e3161 = (((_e1600.member * _e3125) + (_e1600.member_1 * _e3138)) + (_e1600.member_2 * _e3151));
let _e3166 = (((_e1611.member * _e3125) + (_e1611.member_1 * _e3138)) + (_e1611.member_2 * _e3151));
let _e3167 = bitcast<u32>(_e3070);
let _e3168 = (_e3167 % 16u);
if ((_e3167 < _e1525) && _e3096) {
phi_5026_ = ((((_e3092 - _e3094) + (_e3168 / 4u)) * _e1472) + (((_e3167 - _e3168) + (_e3094 * 4u)) + (_e3168 % 4u)));
} else {
phi_5026_ = ((_e3092 * _e1472) + _e3167);
}
let _e3184 = phi_5026_;
let _e3186 = local_8;
local_4 = bitcast<i32>(_e3184);
local_5 = _e1548;
let _e3188 = local_5;
let _e3190 = local_4;
let _e3191 = ((bitcast<i32>(_e3186) * _e3188) + _e3190);
let _e3193 = select(_e191, _e3191, (_e3191 < _e191));
let _e3198 = global_3.member[bitcast<u32>(select(0i, _e3193, (_e3193 > 0i)))];
let _e3201 = local_5;
let _e3203 = local_4;
let _e3204 = ((bitcast<i32>((_e3186 + 1u)) * _e3201) + _e3203);
let _e3206 = select(_e191, _e3204, (_e3204 < _e191));
let _e3211 = global_3.member[bitcast<u32>(select(0i, _e3206, (_e3206 > 0i)))];
let _e3214 = local_5;
let _e3216 = local_4;
let _e3217 = ((bitcast<i32>((_e3186 + 2u)) * _e3214) + _e3216);
let _e3219 = select(_e191, _e3217, (_e3217 < _e191));
let _e3224 = global_3.member[bitcast<u32>(select(0i, _e3219, (_e3219 > 0i)))];
let _e3229 = (((_e1589.member * _e3198) + (_e1589.member_1 * _e3211)) + (_e1589.member_2 * _e3224));
let _e3234 = (((_e1600.member * _e3198) + (_e1600.member_1 * _e3211)) + (_e1600.member_2 * _e3224));
let _e3239 = (((_e1611.member * _e3198) + (_e1611.member_1 * _e3211)) + (_e1611.member_2 * _e3224));
let _e3244 = (((_e3156 * _e3156) + (_e3161 * _e3161)) + (_e3166 * _e3166));
let _e3247 = sqrt(select(0f, _e3244, (_e3244 > 0f)));
let _e3252 = (((_e3229 * _e3229) + (_e3234 * _e3234)) + (_e3239 * _e3239));
let _e3255 = sqrt(select(0f, _e3252, (_e3252 > 0f)));
let _e3256 = (_e3255 > 1e-9f);
let _e3258 = (1f / select(1e-9f, _e3255, _e3256));
let _e3262 = (_e3247 > 1e-9f);
let _e3264 = (1f / select(1e-9f, _e3247, _e3262));
let _e3268 = ((_e3229 * _e3258) - (_e3156 * _e3264));
let _e3269 = ((_e3234 * _e3258) - (_e3161 * _e3264));
let _e3270 = ((_e3239 * _e3258) - (_e3166 * _e3264));
let _e3275 = (((_e3268 * _e3268) + (_e3269 * _e3269)) + (_e3270 * _e3270));
let _e3280 = f32((_e3070 - _e3066));
let _e3284 = select(0f, (sqrt(select(0f, _e3275, (_e3275 > 0f))) / select(1f, _e3280, (_e3280 > 1f))), (_e3262 && _e3256));
let _e3286 = bitcast<u32>(_e3049);
let _e3287 = bitcast<u32>(_e3085);
let _e3288 = (_e3286 % 16u);
let _e3289 = (_e3287 % 4u);
let _e3290 = (_e3286 < _e1525);
if (_e3290 && (_e3287 < _e1528)) {
phi_5253_ = ((((_e3287 - _e3289) + (_e3288 / 4u)) * _e1472) + (((_e3286 - _e3288) + (_e3289 * 4u)) + (_e3288 % 4u)));
} else {
phi_5253_ = ((_e3287 * _e1472) + _e3286);
}
let _e3306 = phi_5253_;
let _e3308 = local_8;
local_2 = bitcast<i32>(_e3306);
local_3 = _e1548;
let _e3310 = local_3;
let _e3312 = local_2;
let _e3313 = ((bitcast<i32>(_e3308) * _e3310) + _e3312);
let _e3315 = select(_e191, _e3313, (_e3313 < _e191));
let _e3320 = global_3.member[bitcast<u32>(select(0i, _e3315, (_e3315 > 0i)))];
let _e3323 = local_3;
let _e3325 = local_2;
let _e3326 = ((bitcast<i32>((_e3308 + 1u)) * _e3323) + _e3325);
let _e3328 = select(_e191, _e3326, (_e3326 < _e191));
let _e3333 = global_3.member[bitcast<u32>(select(0i, _e3328, (_e3328 > 0i)))];
let _e3336 = local_3;
let _e3338 = local_2;
let _e3339 = ((bitcast<i32>((_e3308 + 2u)) * _e3336) + _e3338);
let _e3341 = select(_e191, _e3339, (_e3339 < _e191));
let _e3346 = global_3.member[bitcast<u32>(select(0i, _e3341, (_e3341 > 0i)))];
let _e3351 = (((_e1589.member * _e3320) + (_e1589.member_1 * _e3333)) + (_e1589.member_2 * _e3346));
let _e3356 = (((_e1600.member * _e3320) + (_e1600.member_1 * _e3333)) + (_e1600.member_2 * _e3346));
let _e3361 = (((_e1611.member * _e3320) + (_e1611.member_1 * _e3333)) + (_e1611.member_2 * _e3346));
let _e3362 = bitcast<u32>(_e3089);
let _e3363 = (_e3362 % 4u);
if (_e3290 && (_e3362 < _e1528)) {
phi_5404_ = ((((_e3362 - _e3363) + (_e3288 / 4u)) * _e1472) + (((_e3286 - _e3288) + (_e3363 * 4u)) + (_e3288 % 4u)));
} else {
phi_5404_ = ((_e3362 * _e1472) + _e3286);
}
let _e3379 = phi_5404_;
let _e3381 = local_8;
local = bitcast<i32>(_e3379);
local_1 = _e1548;
let _e3383 = local_1;
let _e3385 = local;
let _e3386 = ((bitcast<i32>(_e3381) * _e3383) + _e3385);
let _e3388 = select(_e191, _e3386, (_e3386 < _e191));
let _e3393 = global_3.member[bitcast<u32>(select(0i, _e3388, (_e3388 > 0i)))];
let _e3396 = local_1;
let _e3398 = local;
let _e3399 = ((bitcast<i32>((_e3381 + 1u)) * _e3396) + _e3398);
let _e3401 = select(_e191, _e3399, (_e3399 < _e191));
let _e3406 = global_3.member[bitcast<u32>(select(0i, _e3401, (_e3401 > 0i)))];
let _e3409 = local_1;
let _e3411 = local;
let _e3412 = ((bitcast<i32>((_e3381 + 2u)) * _e3409) + _e3411);
let _e3414 = select(_e191, _e3412, (_e3412 < _e191));
let _e3419 = global_3.member[bitcast<u32>(select(0i, _e3414, (_e3414 > 0i)))];
let _e3424 = (((_e1589.member * _e3393) + (_e1589.member_1 * _e3406)) + (_e1589.member_2 * _e3419));
let _e3429 = (((_e1600.member * _e3393) + (_e1600.member_1 * _e3406)) + (_e1600.member_2 * _e3419));
let _e3434 = (((_e1611.member * _e3393) + (_e1611.member_1 * _e3406)) + (_e1611.member_2 * _e3419));
let _e3439 = (((_e3351 * _e3351) + (_e3356 * _e3356)) + (_e3361 * _e3361));
let _e3442 = sqrt(select(0f, _e3439, (_e3439 > 0f)));
let _e3447 = (((_e3424 * _e3424) + (_e3429 * _e3429)) + (_e3434 * _e3434));
let _e3450 = sqrt(select(0f, _e3447, (_e3447 > 0f)));
let _e3451 = (_e3450 > 1e-9f);
let _e3453 = (1f / select(1e-9f, _e3450, _e3451));
let _e3457 = (_e3442 > 1e-9f);
let _e3459 = (1f / select(1e-9f, _e3442, _e3457));
let _e3463 = ((_e3424 * _e3453) - (_e3351 * _e3459));
let _e3464 = ((_e3429 * _e3453) - (_e3356 * _e3459));
let _e3465 = ((_e3434 * _e3453) - (_e3361 * _e3459));
let _e3470 = (((_e3463 * _e3463) + (_e3464 * _e3464)) + (_e3465 * _e3465));
let _e3475 = f32((_e3089 - _e3085));
let _e3479 = select(0f, (sqrt(select(0f, _e3470, (_e3470 > 0f))) / select(1f, _e3475, (_e3475 > 1f))), (_e3457 && _e3451));
let _e3481 = select(_e3479, _e3284, (_e3284 > _e3479));
let _e3484 = global_2.member.member_21;
let _e3486 = (2f * (_e3484 * _e3484));
let _e3488 = select(_e3486, _e3481, (_e3481 > _e3486));
let _e3489 = (_e3047 > 0f);
let _e3492 = (1f / select(1e-20f, _e3047, (_e3047 > 1e-20f)));
let _e3496 = select(0f, (_e3029 * _e3492), _e3489);
let _e3497 = select(0f, (_e3034 * _e3492), _e3489);
let _e3498 = select(1f, (_e3039 * _e3492), _e3489);
if _e1954 {
phi_7054_ = _e1946;
} else {
if (_e1938 == 1u) {
let _e3501 = select(-1f, _e3498, (_e3498 > -1f));
let _e3503 = select(1f, _e3501, (_e3501 < 1f));
if (_e3503 > 0f) {
phi_5669_ = _e1946;
} else {
let _e3508 = global_2.member.member_23.member_9;
phi_5669_ = vec3<f32>(_e3508.member, _e3508.member_1, _e3508.member_2);
}
let _e3514 = phi_5669_;
let _e3523 = bitcast<f32>((bitcast<u32>(_e3503) & 2147483647u));
let _e3526 = sqrt(select(0f, _e3523, (_e3523 > 0f)));
phi_7053_ = vec3<f32>((_e1950.member + ((_e3514.x - _e1950.member) * _e3526)), (_e1950.member_1 + ((_e3514.y - _e1950.member_1) * _e3526)), (_e1950.member_2 + ((_e3514.z - _e1950.member_2) * _e3526)));
} else {
if (_e1938 == 2u) {
let _e3538 = global_2.member.member_23.member_10;
let _e3539 = (_e3488 / _e3538);
let _e3541 = select(1e-4f, _e3539, (_e3539 > 1e-4f));
let _e3544 = bitcast<f32>((bitcast<u32>(_e3496) & 2147483647u));
let _e3547 = bitcast<f32>((bitcast<u32>(_e3497) & 2147483647u));
let _e3551 = select(_e3547, _e3544, (_e3544 > _e3547));
let _e3554 = (select(_e3547, _e3544, (_e3544 < _e3547)) / select(1.1754944e-38f, _e3551, (_e3551 > 1.1754944e-38f)));
let _e3555 = (_e3554 > 0.41421357f);
let _e3559 = select(_e3554, ((_e3554 - 1f) / (_e3554 + 1f)), _e3555);
let _e3560 = (_e3559 * _e3559);
let _e3575 = (select(0f, 0.7853982f, _e3555) + (_e3559 + ((_e3559 * _e3560) * (-0.33333334f + (_e3560 * (0.2f + (_e3560 * (-0.14285713f + (_e3560 * (0.11111111f + (_e3560 * (-0.09090909f + (_e3560 * 0.0585f)))))))))))));
let _e3578 = select(_e3575, (1.5707964f - _e3575), (_e3547 > _e3544));
let _e3581 = select(_e3578, (3.1415927f - _e3578), (_e3496 < 0f));
let _e3587 = (1f - (_e3498 * _e3498));
let _e3590 = sqrt(select(0f, _e3587, (_e3587 > 0f)));
let _e3593 = (_e3541 / select(1e-3f, _e3590, (_e3590 > 1e-3f)));
let _e3594 = ((select(_e3581, -(_e3581), (_e3497 < 0f)) / _e3538) * 0.5f);
let _e3596 = select(-8e6f, _e3594, (_e3594 > -8e6f));
let _e3598 = select(8e6f, _e3596, (_e3596 < 8e6f));
let _e3605 = select(0i, select(select(i32(_e3598), i32(-2147483648), (_e3598 < -2147483600f)), 2147483647i, (_e3598 > 2147483500f)), (_e3598 == _e3598));
let _e3612 = ((_e3594 - f32((_e3605 - select(0i, 1i, (_e3598 < f32(_e3605)))))) * 2f);
let _e3620 = ((select(select((_e3612 - 2f), (1f - _e3612), (_e3612 < 1.5f)), _e3612, (_e3612 < 0.5f)) * 2f) / _e3593);
let _e3622 = select(-1f, _e3620, (_e3620 > -1f));
let _e3625 = (2f - _e3593);
let _e3627 = select(0f, _e3625, (_e3625 > 0f));
let _e3632 = select(-1f, _e3498, (_e3498 > -1f));
let _e3634 = select(1f, _e3632, (_e3632 < 1f));
let _e3637 = ((1f - _e3634) * (1f + _e3634));
let _e3640 = sqrt(select(0f, _e3637, (_e3637 > 0f)));
let _e3643 = bitcast<f32>((bitcast<u32>(_e3640) & 2147483647u));
let _e3646 = bitcast<f32>((bitcast<u32>(_e3634) & 2147483647u));
let _e3650 = select(_e3646, _e3643, (_e3643 > _e3646));
let _e3653 = (select(_e3646, _e3643, (_e3643 < _e3646)) / select(1.1754944e-38f, _e3650, (_e3650 > 1.1754944e-38f)));
let _e3654 = (_e3653 > 0.41421357f);
let _e3658 = select(_e3653, ((_e3653 - 1f) / (_e3653 + 1f)), _e3654);
let _e3659 = (_e3658 * _e3658);
let _e3674 = (select(0f, 0.7853982f, _e3654) + (_e3658 + ((_e3658 * _e3659) * (-0.33333334f + (_e3659 * (0.2f + (_e3659 * (-0.14285713f + (_e3659 * (0.11111111f + (_e3659 * (-0.09090909f + (_e3659 * 0.0585f)))))))))))));
let _e3677 = select(_e3674, (1.5707964f - _e3674), (_e3646 > _e3643));
let _e3680 = select(_e3677, (3.1415927f - _e3677), (_e3640 < 0f));
let _e3685 = ((select(_e3680, -(_e3680), (_e3634 < 0f)) / _e3538) * 0.5f);
let _e3687 = select(-8e6f, _e3685, (_e3685 > -8e6f));
let _e3689 = select(8e6f, _e3687, (_e3687 < 8e6f));
let _e3696 = select(0i, select(select(i32(_e3689), i32(-2147483648), (_e3689 < -2147483600f)), 2147483647i, (_e3689 > 2147483500f)), (_e3689 == _e3689));
let _e3703 = ((_e3685 - f32((_e3696 - select(0i, 1i, (_e3689 < f32(_e3696)))))) * 2f);
let _e3711 = ((select(select((_e3703 - 2f), (1f - _e3703), (_e3703 < 1.5f)), _e3703, (_e3703 < 0.5f)) * 2f) / _e3541);
let _e3713 = select(-1f, _e3711, (_e3711 > -1f));
let _e3716 = (2f - _e3541);
let _e3718 = select(0f, _e3716, (_e3716 > 0f));
let _e3724 = (0.5f + ((0.5f * (select(1f, _e3622, (_e3622 < 1f)) * select(1f, _e3627, (_e3627 < 1f)))) * (select(1f, _e3713, (_e3713 < 1f)) * select(1f, _e3718, (_e3718 < 1f)))));
phi_7052_ = vec3<f32>((_e1942.member + ((_e1950.member - _e1942.member) * _e3724)), (_e1942.member_1 + ((_e1950.member_1 - _e1942.member_1) * _e3724)), (_e1942.member_2 + ((_e1950.member_2 - _e1942.member_2) * _e3724)));
} else {
let _e3738 = global_2.member.member_23.member_1;
let _e3739 = bitcast<i32>(_e3738);
let _e3744 = global_2.member.member_23.member_3;
let _e3746 = f32(bitcast<i32>(_e3744));
let _e3748 = (2f * 3.1415927f);
let _e3749 = ((_e3488 * f32(_e3739)) / _e3748);
let _e3751 = select(1e-6f, _e3749, (_e3749 > 1e-6f));
let _e3754 = bitcast<u32>(select(1.1754944e-38f, _e3751, (_e3751 > 1.1754944e-38f)));
let _e3755 = (_e3754 & 8388607u);
let _e3757 = select(0u, 1u, (_e3755 > 3474675u));
let _e3768 = bitcast<f32>((_e3755 | ((127u - _e3757) << bitcast<u32>(23i))));
let _e3771 = ((_e3768 - 1f) / (_e3768 + 1f));
let _e3772 = (_e3771 * _e3771);
let _e3787 = (f32(((bitcast<i32>((_e3754 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e3757))) + (((2f * _e3771) + ((_e3771 * _e3772) * (0.6666667f + (_e3772 * (0.4f + (_e3772 * (0.2857143f + (_e3772 * (0.22222222f + (_e3772 * 0.18181819f)))))))))) * 1.442695f));
let _e3788 = (_e3746 - 1f);
let _e3790 = select(0f, _e3787, (_e3787 > 0f));
let _e3792 = select(_e3788, _e3790, (_e3790 < _e3788));
let _e3793 = (_e3746 - 2f);
let _e3795 = select(0f, _e3793, (_e3793 > 0f));
let _e3797 = select(0f, _e3792, (_e3792 > 0f));
let _e3799 = select(_e3795, _e3797, (_e3797 < _e3795));
let _e3806 = select(0i, select(select(i32(_e3799), i32(-2147483648), (_e3799 < -2147483600f)), 2147483647i, (_e3799 > 2147483500f)), (_e3799 == _e3799));
let _e3810 = (_e3806 - select(0i, 1i, (_e3799 < f32(_e3806))));
let _e3813 = bitcast<f32>((bitcast<u32>(_e3497) & 2147483647u));
let _e3816 = bitcast<f32>((bitcast<u32>(_e3496) & 2147483647u));
let _e3820 = select(_e3816, _e3813, (_e3813 > _e3816));
let _e3823 = (select(_e3816, _e3813, (_e3813 < _e3816)) / select(1.1754944e-38f, _e3820, (_e3820 > 1.1754944e-38f)));
let _e3824 = (_e3823 > 0.41421357f);
let _e3828 = select(_e3823, ((_e3823 - 1f) / (_e3823 + 1f)), _e3824);
let _e3829 = (_e3828 * _e3828);
let _e3844 = (select(0f, 0.7853982f, _e3824) + (_e3828 + ((_e3828 * _e3829) * (-0.33333334f + (_e3829 * (0.2f + (_e3829 * (-0.14285713f + (_e3829 * (0.11111111f + (_e3829 * (-0.09090909f + (_e3829 * 0.0585f)))))))))))));
let _e3847 = select(_e3844, (1.5707964f - _e3844), (_e3816 > _e3813));
let _e3850 = select(_e3847, (3.1415927f - _e3847), (_e3497 < 0f));
let _e3855 = (0.5f - (select(_e3850, -(_e3850), (_e3496 < 0f)) / _e3748));
let _e3857 = select(-1f, _e3498, (_e3498 > -1f));
let _e3859 = select(1f, _e3857, (_e3857 < 1f));
let _e3862 = ((1f - _e3859) * (1f + _e3859));
let _e3865 = sqrt(select(0f, _e3862, (_e3862 > 0f)));
let _e3868 = bitcast<f32>((bitcast<u32>(_e3865) & 2147483647u));
let _e3871 = bitcast<f32>((bitcast<u32>(_e3859) & 2147483647u));
let _e3875 = select(_e3871, _e3868, (_e3868 > _e3871));
let _e3878 = (select(_e3871, _e3868, (_e3868 < _e3871)) / select(1.1754944e-38f, _e3875, (_e3875 > 1.1754944e-38f)));
let _e3879 = (_e3878 > 0.41421357f);
let _e3883 = select(_e3878, ((_e3878 - 1f) / (_e3878 + 1f)), _e3879);
let _e3884 = (_e3883 * _e3883);
let _e3899 = (select(0f, 0.7853982f, _e3879) + (_e3883 + ((_e3883 * _e3884) * (-0.33333334f + (_e3884 * (0.2f + (_e3884 * (-0.14285713f + (_e3884 * (0.11111111f + (_e3884 * (-0.09090909f + (_e3884 * 0.0585f)))))))))))));
let _e3902 = select(_e3899, (1.5707964f - _e3899), (_e3871 > _e3868));
let _e3905 = select(_e3902, (3.1415927f - _e3902), (_e3865 < 0f));
let _e3910 = (0.5f - (select(_e3905, -(_e3905), (_e3859 < 0f)) / 3.1415927f));
let _e3914 = global_2.member.member_23.member_2;
let _e3915 = bitcast<i32>(_e3914);
phi_6271_ = 0i;
phi_6274_ = 0i;
phi_6276_ = _e3915;
phi_6278_ = _e3739;
loop {
let _e3917 = phi_6271_;
let _e3919 = phi_6274_;
let _e3921 = phi_6276_;
let _e3923 = phi_6278_;
local_58 = _e3923;
local_59 = _e3921;
local_60 = _e3923;
local_61 = _e3923;
local_62 = _e3923;
local_63 = _e3923;
local_64 = _e3923;
local_65 = _e3923;
local_66 = _e3921;
local_67 = _e3921;
local_68 = _e3921;
local_69 = _e3921;
local_70 = _e3923;
local_71 = _e3919;
local_72 = _e3923;
local_73 = _e3919;
let _e3924 = (_e3917 < _e3810);
if _e3924 {
if (_e3923 > 1i) {
phi_6293_ = (_e3923 >> bitcast<u32>(1i));
} else {
phi_6293_ = 1i;
}
let _e3931 = phi_6293_;
if (_e3921 > 1i) {
phi_6299_ = (_e3921 >> bitcast<u32>(1i));
} else {
phi_6299_ = 1i;
}
let _e3936 = phi_6299_;
phi_6272_ = (_e3917 + 1i);
phi_6275_ = (_e3919 + (_e3923 * _e3921));
phi_6277_ = _e3936;
phi_6279_ = _e3931;
} else {
phi_6272_ = i32();
phi_6275_ = i32();
phi_6277_ = i32();
phi_6279_ = i32();
}
let _e3939 = phi_6272_;
let _e3941 = phi_6275_;
let _e3943 = phi_6277_;
let _e3945 = phi_6279_;
continue;
continuing {
phi_6271_ = _e3939;
phi_6274_ = _e3941;
phi_6276_ = _e3943;
phi_6278_ = _e3945;
break if !(_e3924);
}
}
let _e3948 = local_58;
let _e3949 = f32(_e3948);
let _e3951 = ((_e3855 * _e3949) - 0.5f);
let _e3953 = local_59;
let _e3954 = f32(_e3953);
let _e3956 = ((_e3910 * _e3954) - 0.5f);
let _e3958 = select(-1f, _e3951, (_e3951 > -1f));
let _e3960 = select(_e3949, _e3958, (_e3958 < _e3949));
let _e3967 = select(0i, select(select(i32(_e3960), i32(-2147483648), (_e3960 < -2147483600f)), 2147483647i, (_e3960 > 2147483500f)), (_e3960 == _e3960));
let _e3971 = (_e3967 - select(0i, 1i, (_e3960 < f32(_e3967))));
let _e3973 = select(-1f, _e3956, (_e3956 > -1f));
let _e3975 = select(_e3954, _e3973, (_e3973 < _e3954));
let _e3982 = select(0i, select(select(i32(_e3975), i32(-2147483648), (_e3975 < -2147483600f)), 2147483647i, (_e3975 > 2147483500f)), (_e3975 == _e3975));
let _e3986 = (_e3982 - select(0i, 1i, (_e3975 < f32(_e3982))));
let _e3988 = (_e3951 - f32(_e3971));
let _e3990 = (_e3956 - f32(_e3986));
let _e3992 = select(0f, _e3990, (_e3990 > 0f));
let _e3994 = select(1f, _e3992, (_e3992 < 1f));
if (_e3971 < 0i) {
let _e3997 = local_60;
phi_6374_ = (_e3971 + _e3997);
} else {
phi_6374_ = _e3971;
}
let _e4000 = phi_6374_;
let _e4002 = local_61;
if (_e4000 >= _e4002) {
let _e4005 = local_62;
phi_6380_ = (_e4000 - _e4005);
} else {
phi_6380_ = _e4000;
}
let _e4008 = phi_6380_;
let _e4009 = (_e3971 + 1i);
if (_e4009 < 0i) {
let _e4012 = local_63;
phi_6387_ = (_e4009 + _e4012);
} else {
phi_6387_ = _e4009;
}
let _e4015 = phi_6387_;
let _e4017 = local_64;
if (_e4015 >= _e4017) {
let _e4020 = local_65;
phi_6393_ = (_e4015 - _e4020);
} else {
phi_6393_ = _e4015;
}
let _e4023 = phi_6393_;
let _e4025 = select(_e3986, 0i, (_e3986 < 0i));
let _e4027 = local_66;
if (_e4025 >= _e4027) {
let _e4030 = local_67;
phi_6404_ = (_e4030 - 1i);
} else {
phi_6404_ = _e4025;
}
let _e4033 = phi_6404_;
let _e4034 = (_e3986 + 1i);
let _e4036 = select(_e4034, 0i, (_e4034 < 0i));
let _e4038 = local_68;
if (_e4036 >= _e4038) {
let _e4041 = local_69;
phi_6416_ = (_e4041 - 1i);
} else {
phi_6416_ = _e4036;
}
let _e4044 = phi_6416_;
let _e4046 = local_70;
let _e4049 = local_71;
let _e4050 = (_e4049 + (_e4033 * _e4046));
let _e4052 = local_72;
let _e4055 = local_73;
let _e4056 = (_e4055 + (_e4044 * _e4052));
let _e4058 = (3i * (_e4050 + _e4008));
let _e4060 = (bitcast<i32>(_e125) - 1i);
let _e4062 = select(_e4060, _e4058, (_e4058 < _e4060));
let _e4068 = global_4.member[bitcast<u32>(select(0i, _e4062, (_e4062 > 0i)))];
let _e4069 = (_e4058 + 1i);
let _e4071 = select(_e4060, _e4069, (_e4069 < _e4060));
let _e4077 = global_4.member[bitcast<u32>(select(0i, _e4071, (_e4071 > 0i)))];
let _e4078 = (_e4058 + 2i);
let _e4080 = select(_e4060, _e4078, (_e4078 < _e4060));
let _e4086 = global_4.member[bitcast<u32>(select(0i, _e4080, (_e4080 > 0i)))];
let _e4088 = (3i * (_e4050 + _e4023));
let _e4090 = select(_e4060, _e4088, (_e4088 < _e4060));
let _e4096 = global_4.member[bitcast<u32>(select(0i, _e4090, (_e4090 > 0i)))];
let _e4097 = (_e4088 + 1i);
let _e4099 = select(_e4060, _e4097, (_e4097 < _e4060));
let _e4105 = global_4.member[bitcast<u32>(select(0i, _e4099, (_e4099 > 0i)))];
let _e4106 = (_e4088 + 2i);
let _e4108 = select(_e4060, _e4106, (_e4106 < _e4060));
let _e4114 = global_4.member[bitcast<u32>(select(0i, _e4108, (_e4108 > 0i)))];
let _e4116 = (3i * (_e4056 + _e4008));
let _e4118 = select(_e4060, _e4116, (_e4116 < _e4060));
let _e4124 = global_4.member[bitcast<u32>(select(0i, _e4118, (_e4118 > 0i)))];
let _e4125 = (_e4116 + 1i);
let _e4127 = select(_e4060, _e4125, (_e4125 < _e4060));
let _e4133 = global_4.member[bitcast<u32>(select(0i, _e4127, (_e4127 > 0i)))];
let _e4134 = (_e4116 + 2i);
let _e4136 = select(_e4060, _e4134, (_e4134 < _e4060));
let _e4142 = global_4.member[bitcast<u32>(select(0i, _e4136, (_e4136 > 0i)))];
let _e4144 = (3i * (_e4056 + _e4023));
let _e4146 = select(_e4060, _e4144, (_e4144 < _e4060));
let _e4152 = global_4.member[bitcast<u32>(select(0i, _e4146, (_e4146 > 0i)))];
let _e4153 = (_e4144 + 1i);
let _e4155 = select(_e4060, _e4153, (_e4153 < _e4060));
let _e4161 = global_4.member[bitcast<u32>(select(0i, _e4155, (_e4155 > 0i)))];
let _e4162 = (_e4144 + 2i);
let _e4164 = select(_e4060, _e4162, (_e4162 < _e4060));
let _e4170 = global_4.member[bitcast<u32>(select(0i, _e4164, (_e4164 > 0i)))];
let _e4177 = (_e4068 + ((_e4096 - _e4068) * _e3988));
let _e4178 = (_e4077 + ((_e4105 - _e4077) * _e3988));
let _e4179 = (_e4086 + ((_e4114 - _e4086) * _e3988));
let _e4195 = (_e4177 + (((_e4124 + ((_e4152 - _e4124) * _e3988)) - _e4177) * _e3994));
let _e4196 = (_e4178 + (((_e4133 + ((_e4161 - _e4133) * _e3988)) - _e4178) * _e3994));
let _e4197 = (_e4179 + (((_e4142 + ((_e4170 - _e4142) * _e3988)) - _e4179) * _e3994));
phi_6652_ = 0i;
phi_6655_ = 0i;
phi_6657_ = _e3915;
phi_6659_ = _e3739;
loop {
let _e4200 = phi_6652_;
let _e4202 = phi_6655_;
let _e4204 = phi_6657_;
let _e4206 = phi_6659_;
local_74 = _e4206;
local_75 = _e4204;
local_76 = _e4206;
local_77 = _e4206;
local_78 = _e4206;
local_79 = _e4206;
local_80 = _e4206;
local_81 = _e4206;
local_82 = _e4204;
local_83 = _e4204;
local_84 = _e4204;
local_85 = _e4204;
local_86 = _e4206;
local_87 = _e4202;
local_88 = _e4206;
local_89 = _e4202;
let _e4207 = (_e4200 < (_e3810 + 1i));
if _e4207 {
if (_e4206 > 1i) {
phi_6674_ = (_e4206 >> bitcast<u32>(1i));
} else {
phi_6674_ = 1i;
}
let _e4214 = phi_6674_;
if (_e4204 > 1i) {
phi_6680_ = (_e4204 >> bitcast<u32>(1i));
} else {
phi_6680_ = 1i;
}
let _e4219 = phi_6680_;
phi_6653_ = (_e4200 + 1i);
phi_6656_ = (_e4202 + (_e4206 * _e4204));
phi_6658_ = _e4219;
phi_6660_ = _e4214;
} else {
phi_6653_ = i32();
phi_6656_ = i32();
phi_6658_ = i32();
phi_6660_ = i32();
}
let _e4222 = phi_6653_;
let _e4224 = phi_6656_;
let _e4226 = phi_6658_;
let _e4228 = phi_6660_;
continue;
continuing {
phi_6652_ = _e4222;
phi_6655_ = _e4224;
phi_6657_ = _e4226;
phi_6659_ = _e4228;
break if !(_e4207);
}
}
let _e4231 = local_74;
let _e4232 = f32(_e4231);
let _e4234 = ((_e3855 * _e4232) - 0.5f);
let _e4236 = local_75;
let _e4237 = f32(_e4236);
let _e4239 = ((_e3910 * _e4237) - 0.5f);
let _e4241 = select(-1f, _e4234, (_e4234 > -1f));
let _e4243 = select(_e4232, _e4241, (_e4241 < _e4232));
let _e4250 = select(0i, select(select(i32(_e4243), i32(-2147483648), (_e4243 < -2147483600f)), 2147483647i, (_e4243 > 2147483500f)), (_e4243 == _e4243));
let _e4254 = (_e4250 - select(0i, 1i, (_e4243 < f32(_e4250))));
let _e4256 = select(-1f, _e4239, (_e4239 > -1f));
let _e4258 = select(_e4237, _e4256, (_e4256 < _e4237));
let _e4265 = select(0i, select(select(i32(_e4258), i32(-2147483648), (_e4258 < -2147483600f)), 2147483647i, (_e4258 > 2147483500f)), (_e4258 == _e4258));
let _e4269 = (_e4265 - select(0i, 1i, (_e4258 < f32(_e4265))));
let _e4271 = (_e4234 - f32(_e4254));
let _e4273 = (_e4239 - f32(_e4269));
let _e4275 = select(0f, _e4273, (_e4273 > 0f));
let _e4277 = select(1f, _e4275, (_e4275 < 1f));
if (_e4254 < 0i) {
let _e4280 = local_76;
phi_6755_ = (_e4254 + _e4280);
} else {
phi_6755_ = _e4254;
}
let _e4283 = phi_6755_;
let _e4285 = local_77;
if (_e4283 >= _e4285) {
let _e4288 = local_78;
phi_6761_ = (_e4283 - _e4288);
} else {
phi_6761_ = _e4283;
}
let _e4291 = phi_6761_;
let _e4292 = (_e4254 + 1i);
if (_e4292 < 0i) {
let _e4295 = local_79;
phi_6768_ = (_e4292 + _e4295);
} else {
phi_6768_ = _e4292;
}
let _e4298 = phi_6768_;
let _e4300 = local_80;
if (_e4298 >= _e4300) {
let _e4303 = local_81;
phi_6774_ = (_e4298 - _e4303);
} else {
phi_6774_ = _e4298;
}
let _e4306 = phi_6774_;
let _e4308 = select(_e4269, 0i, (_e4269 < 0i));
let _e4310 = local_82;
if (_e4308 >= _e4310) {
let _e4313 = local_83;
phi_6785_ = (_e4313 - 1i);
} else {
phi_6785_ = _e4308;
}
let _e4316 = phi_6785_;
let _e4317 = (_e4269 + 1i);
let _e4319 = select(_e4317, 0i, (_e4317 < 0i));
let _e4321 = local_84;
if (_e4319 >= _e4321) {
let _e4324 = local_85;
phi_6797_ = (_e4324 - 1i);
} else {
phi_6797_ = _e4319;
}
let _e4327 = phi_6797_;
let _e4329 = local_86;
let _e4332 = local_87;
let _e4333 = (_e4332 + (_e4316 * _e4329));
let _e4335 = local_88;
let _e4338 = local_89;
let _e4339 = (_e4338 + (_e4327 * _e4335));
let _e4341 = (3i * (_e4333 + _e4291));
let _e4343 = select(_e4060, _e4341, (_e4341 < _e4060));
let _e4349 = global_4.member[bitcast<u32>(select(0i, _e4343, (_e4343 > 0i)))];
let _e4350 = (_e4341 + 1i);
let _e4352 = select(_e4060, _e4350, (_e4350 < _e4060));
let _e4358 = global_4.member[bitcast<u32>(select(0i, _e4352, (_e4352 > 0i)))];
let _e4359 = (_e4341 + 2i);
let _e4361 = select(_e4060, _e4359, (_e4359 < _e4060));
let _e4367 = global_4.member[bitcast<u32>(select(0i, _e4361, (_e4361 > 0i)))];
let _e4369 = (3i * (_e4333 + _e4306));
let _e4371 = select(_e4060, _e4369, (_e4369 < _e4060));
let _e4377 = global_4.member[bitcast<u32>(select(0i, _e4371, (_e4371 > 0i)))];
let _e4378 = (_e4369 + 1i);
let _e4380 = select(_e4060, _e4378, (_e4378 < _e4060));
let _e4386 = global_4.member[bitcast<u32>(select(0i, _e4380, (_e4380 > 0i)))];
let _e4387 = (_e4369 + 2i);
let _e4389 = select(_e4060, _e4387, (_e4387 < _e4060));
let _e4395 = global_4.member[bitcast<u32>(select(0i, _e4389, (_e4389 > 0i)))];
let _e4397 = (3i * (_e4339 + _e4291));
let _e4399 = select(_e4060, _e4397, (_e4397 < _e4060));
let _e4405 = global_4.member[bitcast<u32>(select(0i, _e4399, (_e4399 > 0i)))];
let _e4406 = (_e4397 + 1i);
let _e4408 = select(_e4060, _e4406, (_e4406 < _e4060));
let _e4414 = global_4.member[bitcast<u32>(select(0i, _e4408, (_e4408 > 0i)))];
let _e4415 = (_e4397 + 2i);
let _e4417 = select(_e4060, _e4415, (_e4415 < _e4060));
let _e4423 = global_4.member[bitcast<u32>(select(0i, _e4417, (_e4417 > 0i)))];
let _e4425 = (3i * (_e4339 + _e4306));
let _e4427 = select(_e4060, _e4425, (_e4425 < _e4060));
let _e4433 = global_4.member[bitcast<u32>(select(0i, _e4427, (_e4427 > 0i)))];
let _e4434 = (_e4425 + 1i);
let _e4436 = select(_e4060, _e4434, (_e4434 < _e4060));
let _e4442 = global_4.member[bitcast<u32>(select(0i, _e4436, (_e4436 > 0i)))];
let _e4443 = (_e4425 + 2i);
let _e4445 = select(_e4060, _e4443, (_e4443 < _e4060));
let _e4451 = global_4.member[bitcast<u32>(select(0i, _e4445, (_e4445 > 0i)))];
let _e4458 = (_e4349 + ((_e4377 - _e4349) * _e4271));
let _e4459 = (_e4358 + ((_e4386 - _e4358) * _e4271));
let _e4460 = (_e4367 + ((_e4395 - _e4367) * _e4271));
let _e4483 = (_e3792 - f32(_e3810));
let _e4485 = select(0f, _e4483, (_e4483 > 0f));
let _e4487 = select(1f, _e4485, (_e4485 < 1f));
let _e4497 = global_2.member.member_23.member_11;
phi_7052_ = vec3<f32>(((_e4195 + (((_e4458 + (((_e4405 + ((_e4433 - _e4405) * _e4271)) - _e4458) * _e4277)) - _e4195) * _e4487)) * _e4497), ((_e4196 + (((_e4459 + (((_e4414 + ((_e4442 - _e4414) * _e4271)) - _e4459) * _e4277)) - _e4196) * _e4487)) * _e4497), ((_e4197 + (((_e4460 + (((_e4423 + ((_e4451 - _e4423) * _e4271)) - _e4460) * _e4277)) - _e4197) * _e4487)) * _e4497));
}
let _e4503 = phi_7052_;
phi_7053_ = _e4503;
}
let _e4505 = phi_7053_;
phi_7054_ = _e4505;
}
let _e4507 = phi_7054_;
phi_7065_ = vec3<f32>((_e2978 + (_e4507.x * _e3047)), (_e2979 + (_e4507.y * _e3047)), (_e2980 + (_e4507.z * _e3047)));
} else {
phi_7065_ = vec3<f32>(_e2978, _e2979, _e2980);
}
let _e4519 = phi_7065_;
let _e4525 = (1f - ((_e1402 * ((_e264 + _e275) + _e286)) * (1f / 3f)));
global_1.member[_e148] = _e4519.x;
global_1.member[(_e146 + _e148)] = _e4519.y;
global_1.member[((2u * _e146) + _e148)] = _e4519.z;
global_1.member[((3u * _e146) + _e148)] = (_e4525 + ((1f - _e4525) * _e2967));
global_1.member[((4u * _e146) + _e148)] = _e1396;
global_1.member[((5u * _e146) + _e148)] = _e264;
global_1.member[((6u * _e146) + _e148)] = _e275;
global_1.member[((7u * _e146) + _e148)] = _e286;
global_1.member[((8u * _e146) + _e148)] = ((_e253 + (_e1373 * (_e376 + (_e333 * _e445)))) / select(1e-12f, _e1396, (_e1396 > 1e-12f)));
global_1.member[((9u * _e146) + _e148)] = _e331;
global_1.member[((10u * _e146) + _e148)] = _e332;
global_1.member[((11u * _e146) + _e148)] = -(_e333);
global_1.member[((12u * _e146) + _e148)] = select(_e374, _e492, _e1368);
global_1.member[((13u * _e146) + _e148)] = select(_e375, _e493, _e1368);
global_1.member[((14u * _e146) + _e148)] = -(select(_e376, _e494, _e1368));
global_1.member[((15u * _e146) + _e148)] = select(select(_e198, 2f, (_e198 == 4f)), 1f, _e1368);
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
