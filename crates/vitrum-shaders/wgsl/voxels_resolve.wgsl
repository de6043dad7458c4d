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
member_10: f32,
member_11: u32,
member_12: u32,
member_13: u32,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_15 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_16 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_17 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
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
member_17: type_14,
member_18: type_15,
member_19: type_5,
member_20: type_16,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_18 {
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
member_20: type_12,
member_21: type_13,
member_22: type_17,
}
struct type_19 {
member: type_18,
}
struct type_21 {
member: array<f32>,
}
struct type_26 {
member: array<u32>,
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
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_19;
@group(0) @binding(1)
var<storage> global_2: type_21;
@group(0) @binding(2)
var<storage> global_3: type_21;
@group(0) @binding(3)
var<storage> global_4: type_21;
@group(0) @binding(4)
var<storage> global_5: type_21;
@group(0) @binding(5)
var<storage> global_6: type_26;
@group(0) @binding(6)
var<storage> global_7: type_21;
@group(0) @binding(7)
var<storage, read_write> global_8: type_21;
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
var phi_2684_: vec3<f32>;
var phi_3286_: i32;
var phi_3289_: i32;
var phi_3291_: i32;
var phi_3293_: i32;
var phi_3308_: i32;
var phi_3314_: i32;
var phi_3287_: i32;
var phi_3290_: i32;
var phi_3292_: i32;
var phi_3294_: i32;
var local_50: i32;
var local_51: i32;
var local_52: i32;
var phi_3389_: i32;
var local_53: i32;
var local_54: i32;
var phi_3395_: i32;
var local_55: i32;
var phi_3402_: i32;
var local_56: i32;
var local_57: i32;
var phi_3408_: i32;
var local_58: i32;
var local_59: i32;
var phi_3419_: i32;
var local_60: i32;
var local_61: i32;
var phi_3431_: i32;
var local_62: i32;
var local_63: i32;
var local_64: i32;
var local_65: i32;
var phi_3667_: i32;
var phi_3670_: i32;
var phi_3672_: i32;
var phi_3674_: i32;
var phi_3689_: i32;
var phi_3695_: i32;
var phi_3668_: i32;
var phi_3671_: i32;
var phi_3673_: i32;
var phi_3675_: i32;
var local_66: i32;
var local_67: i32;
var local_68: i32;
var phi_3770_: i32;
var local_69: i32;
var local_70: i32;
var phi_3776_: i32;
var local_71: i32;
var phi_3783_: i32;
var local_72: i32;
var local_73: i32;
var phi_3789_: i32;
var local_74: i32;
var local_75: i32;
var phi_3800_: i32;
var local_76: i32;
var local_77: i32;
var phi_3812_: i32;
var local_78: i32;
var local_79: i32;
var local_80: i32;
var local_81: i32;
var phi_4067_: vec3<f32>;
var phi_4068_: vec3<f32>;
var phi_4069_: vec3<f32>;
var phi_4932_: type_28;
var phi_5506_: vec3<f32>;
var phi_5509_: vec3<f32>;
var phi_5522_: type_27;
var phi_5865_: i32;
var phi_5868_: i32;
var phi_5870_: f32;
var phi_5872_: f32;
var phi_5948_: i32;
var phi_6097_: i32;
var phi_6100_: f32;
var phi_6102_: f32;
var phi_6098_: i32;
var phi_6101_: f32;
var phi_6103_: f32;
var local_82: f32;
var phi_6223_: f32;
var phi_6224_: f32;
var phi_6230_: i32;
var phi_5866_: i32;
var phi_5869_: i32;
var phi_5871_: f32;
var phi_5873_: f32;
var local_83: f32;
var local_84: f32;
var local_85: f32;
var local_86: f32;
var phi_6274_: f32;
var phi_6392_: f32;
var phi_6395_: vec3<f32>;
var phi_6397_: i32;
var phi_6412_: i32;
var phi_6415_: f32;
var phi_6417_: vec3<f32>;
var phi_6806_: vec3<f32>;
var phi_6816_: vec3<f32>;
var phi_6413_: i32;
var phi_6416_: f32;
var phi_6418_: vec3<f32>;
var phi_6393_: f32;
var phi_6396_: vec3<f32>;
var phi_6398_: i32;
var local_87: f32;
var local_88: f32;
var local_89: vec3<f32>;
var local_90: vec3<f32>;
var local_91: vec3<f32>;
var phi_7177_: u32;
var phi_7513_: f32;
var phi_7545_: vec3<f32>;
var phi_7717_: i32;
var phi_7720_: i32;
var phi_7722_: f32;
var phi_7724_: f32;
var phi_7800_: i32;
var phi_7949_: i32;
var phi_7952_: f32;
var phi_7954_: f32;
var phi_7950_: i32;
var phi_7953_: f32;
var phi_7955_: f32;
var local_92: f32;
var phi_8075_: f32;
var phi_8076_: f32;
var phi_8082_: i32;
var phi_7718_: i32;
var phi_7721_: i32;
var phi_7723_: f32;
var phi_7725_: f32;
var local_93: f32;
var local_94: f32;
var local_95: f32;
var local_96: f32;
var phi_8126_: f32;
var phi_8244_: f32;
var phi_8247_: vec3<f32>;
var phi_8249_: i32;
var phi_8264_: i32;
var phi_8267_: f32;
var phi_8269_: vec3<f32>;
var phi_8658_: vec3<f32>;
var phi_8668_: vec3<f32>;
var phi_8265_: i32;
var phi_8268_: f32;
var phi_8270_: vec3<f32>;
var phi_8245_: f32;
var phi_8248_: vec3<f32>;
var phi_8250_: i32;
var local_97: f32;
var local_98: f32;
var local_99: vec3<f32>;
var local_100: vec3<f32>;
var local_101: vec3<f32>;
var phi_8719_: vec3<f32>;
var phi_8952_: vec3<f32>;
var phi_8953_: vec3<f32>;
var phi_9638_: vec3<f32>;
var phi_10240_: i32;
var phi_10243_: i32;
var phi_10245_: i32;
var phi_10247_: i32;
var phi_10262_: i32;
var phi_10268_: i32;
var phi_10241_: i32;
var phi_10244_: i32;
var phi_10246_: i32;
var phi_10248_: i32;
var local_102: i32;
var local_103: i32;
var local_104: i32;
var phi_10343_: i32;
var local_105: i32;
var local_106: i32;
var phi_10349_: i32;
var local_107: i32;
var phi_10356_: i32;
var local_108: i32;
var local_109: i32;
var phi_10362_: i32;
var local_110: i32;
var local_111: i32;
var phi_10373_: i32;
var local_112: i32;
var local_113: i32;
var phi_10385_: i32;
var local_114: i32;
var local_115: i32;
var local_116: i32;
var local_117: i32;
var phi_10621_: i32;
var phi_10624_: i32;
var phi_10626_: i32;
var phi_10628_: i32;
var phi_10643_: i32;
var phi_10649_: i32;
var phi_10622_: i32;
var phi_10625_: i32;
var phi_10627_: i32;
var phi_10629_: i32;
var local_118: i32;
var local_119: i32;
var local_120: i32;
var phi_10724_: i32;
var local_121: i32;
var local_122: i32;
var phi_10730_: i32;
var local_123: i32;
var phi_10737_: i32;
var local_124: i32;
var local_125: i32;
var phi_10743_: i32;
var local_126: i32;
var local_127: i32;
var phi_10754_: i32;
var local_128: i32;
var local_129: i32;
var phi_10766_: i32;
var local_130: i32;
var local_131: i32;
var local_132: i32;
var local_133: i32;
var phi_11021_: vec3<f32>;
var phi_11022_: vec3<f32>;
var phi_11023_: vec3<f32>;
var phi_11998_: type_28;
var phi_12572_: vec3<f32>;
var phi_12575_: vec3<f32>;
var phi_12588_: type_27;
var phi_12931_: i32;
var phi_12934_: i32;
var phi_12936_: f32;
var phi_12938_: f32;
var phi_13014_: i32;
var phi_13163_: i32;
var phi_13166_: f32;
var phi_13168_: f32;
var phi_13164_: i32;
var phi_13167_: f32;
var phi_13169_: f32;
var local_134: f32;
var phi_13289_: f32;
var phi_13290_: f32;
var phi_13296_: i32;
var phi_12932_: i32;
var phi_12935_: i32;
var phi_12937_: f32;
var phi_12939_: f32;
var local_135: f32;
var local_136: f32;
var local_137: f32;
var local_138: f32;
var phi_13340_: f32;
var phi_13458_: f32;
var phi_13461_: vec3<f32>;
var phi_13463_: i32;
var phi_13478_: i32;
var phi_13481_: f32;
var phi_13483_: vec3<f32>;
var phi_13872_: vec3<f32>;
var phi_13882_: vec3<f32>;
var phi_13479_: i32;
var phi_13482_: f32;
var phi_13484_: vec3<f32>;
var phi_13459_: f32;
var phi_13462_: vec3<f32>;
var phi_13464_: i32;
var local_139: f32;
var local_140: f32;
var local_141: vec3<f32>;
var local_142: vec3<f32>;
var local_143: vec3<f32>;
var phi_14243_: u32;
var phi_14579_: f32;
var phi_14611_: vec3<f32>;
var phi_14783_: i32;
var phi_14786_: i32;
var phi_14788_: f32;
var phi_14790_: f32;
var phi_14866_: i32;
var phi_15015_: i32;
var phi_15018_: f32;
var phi_15020_: f32;
var phi_15016_: i32;
var phi_15019_: f32;
var phi_15021_: f32;
var local_144: f32;
var phi_15141_: f32;
var phi_15142_: f32;
var phi_15148_: i32;
var phi_14784_: i32;
var phi_14787_: i32;
var phi_14789_: f32;
var phi_14791_: f32;
var local_145: f32;
var local_146: f32;
var local_147: f32;
var local_148: f32;
var phi_15192_: f32;
var phi_15310_: f32;
var phi_15313_: vec3<f32>;
var phi_15315_: i32;
var phi_15330_: i32;
var phi_15333_: f32;
var phi_15335_: vec3<f32>;
var phi_15724_: vec3<f32>;
var phi_15734_: vec3<f32>;
var phi_15331_: i32;
var phi_15334_: f32;
var phi_15336_: vec3<f32>;
var phi_15311_: f32;
var phi_15314_: vec3<f32>;
var phi_15316_: i32;
var local_149: f32;
var local_150: f32;
var local_151: vec3<f32>;
var local_152: vec3<f32>;
var local_153: vec3<f32>;
var phi_15785_: vec3<f32>;
var phi_15952_: vec3<f32>;
var phi_15953_: vec3<f32>;
var local_154: f32;
var local_155: vec3<f32>;
var local_156: f32;
var local_157: vec3<f32>;
var local_158: f32;
var local_159: vec3<f32>;
var local_160: f32;
var local_161: vec3<f32>;
let _e159 = global;
let _e165 = arrayLength((&global_3.member));
let _e167 = arrayLength((&global_4.member));
let _e169 = arrayLength((&global_5.member));
let _e171 = arrayLength((&global_6.member));
let _e177 = global_1.member.member;
if (_e159.x < _e177.member) {
if (_e159.y < _e177.member_1) {
let _e184 = (_e177.member * _e177.member_1);
let _e186 = ((_e159.y * _e177.member) + _e159.x);
let _e188 = bitcast<i32>(_e159.x);
let _e189 = bitcast<i32>(_e159.y);
let _e193 = global_1.member.member.member;
let _e194 = bitcast<i32>(_e193);
let _e195 = (_e189 * _e194);
let _e196 = (_e195 + _e188);
local_48 = _e196;
let _e200 = global_1.member.member.member_1;
let _e202 = bitcast<i32>((_e193 * _e200));
local_49 = _e202;
let _e203 = local_48;
local_46 = _e203;
local_47 = _e202;
let _e204 = local_47;
let _e206 = local_46;
let _e207 = ((3i * _e204) + _e206);
let _e209 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e211 = select(_e209, _e207, (_e207 < _e209));
let _e216 = global_2.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e217 = local_47;
let _e219 = local_46;
let _e220 = ((4i * _e217) + _e219);
let _e222 = select(_e209, _e220, (_e220 < _e209));
let _e227 = global_2.member[bitcast<u32>(select(0i, _e222, (_e222 > 0i)))];
let _e228 = local_47;
let _e230 = local_46;
let _e231 = ((5i * _e228) + _e230);
let _e233 = select(_e209, _e231, (_e231 < _e209));
let _e238 = global_2.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e239 = local_48;
local_44 = _e239;
local_45 = _e202;
let _e240 = local_45;
let _e242 = local_44;
let _e243 = ((6i * _e240) + _e242);
let _e245 = select(_e209, _e243, (_e243 < _e209));
let _e250 = global_2.member[bitcast<u32>(select(0i, _e245, (_e245 > 0i)))];
let _e251 = local_45;
let _e253 = local_44;
let _e254 = ((7i * _e251) + _e253);
let _e256 = select(_e209, _e254, (_e254 < _e209));
let _e261 = global_2.member[bitcast<u32>(select(0i, _e256, (_e256 > 0i)))];
let _e262 = local_45;
let _e264 = local_44;
let _e265 = ((8i * _e262) + _e264);
let _e267 = select(_e209, _e265, (_e265 < _e209));
let _e272 = global_2.member[bitcast<u32>(select(0i, _e267, (_e267 > 0i)))];
let _e273 = local_49;
let _e275 = local_48;
let _e276 = ((18i * _e273) + _e275);
let _e278 = select(_e209, _e276, (_e276 < _e209));
let _e283 = global_2.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e284 = local_49;
let _e286 = local_48;
let _e287 = ((16i * _e284) + _e286);
let _e289 = select(_e209, _e287, (_e287 < _e209));
let _e294 = global_2.member[bitcast<u32>(select(0i, _e289, (_e289 > 0i)))];
let _e295 = (_e177.member_2 == 1u);
let _e297 = (_e295 && (_e294 == 3f));
let _e298 = (_e188 - 1i);
let _e299 = bitcast<i32>(_e200);
local_41 = _e194;
local_42 = _e299;
let _e301 = local_41;
let _e304 = (_e189 >= 0i);
let _e306 = local_42;
let _e308 = ((((_e298 >= 0i) && (_e298 < _e301)) && _e304) && (_e189 < _e306));
if _e308 {
let _e309 = local_41;
local_43 = ((_e189 * _e309) + _e298);
} else {
local_43 = 0i;
}
let _e312 = local_41;
let _e313 = local_42;
let _e316 = local_43;
let _e317 = ((18i * (_e312 * _e313)) + _e316);
let _e319 = select(_e209, _e317, (_e317 < _e209));
let _e324 = global_2.member[bitcast<u32>(select(0i, _e319, (_e319 > 0i)))];
let _e327 = local_41;
let _e328 = local_42;
let _e331 = local_43;
let _e332 = ((16i * (_e327 * _e328)) + _e331);
let _e334 = select(_e209, _e332, (_e332 < _e209));
let _e339 = global_2.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e341 = ((_e308 && (_e324 == _e283)) && (_e339 == _e294));
let _e342 = local_41;
let _e343 = local_42;
let _e346 = local_43;
let _e347 = ((18i * (_e342 * _e343)) + _e346);
let _e349 = select(_e209, _e347, (_e347 < _e209));
let _e354 = global_2.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e357 = local_41;
let _e358 = local_42;
let _e361 = local_43;
let _e362 = ((16i * (_e357 * _e358)) + _e361);
let _e364 = select(_e209, _e362, (_e362 < _e209));
let _e369 = global_2.member[bitcast<u32>(select(0i, _e364, (_e364 > 0i)))];
let _e372 = local_43;
local_39 = _e372;
local_40 = _e202;
let _e373 = local_40;
let _e375 = local_39;
let _e376 = ((3i * _e373) + _e375);
let _e378 = select(_e209, _e376, (_e376 < _e209));
let _e383 = global_2.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e384 = local_40;
let _e386 = local_39;
let _e387 = ((4i * _e384) + _e386);
let _e389 = select(_e209, _e387, (_e387 < _e209));
let _e394 = global_2.member[bitcast<u32>(select(0i, _e389, (_e389 > 0i)))];
let _e395 = local_40;
let _e397 = local_39;
let _e398 = ((5i * _e395) + _e397);
let _e400 = select(_e209, _e398, (_e398 < _e209));
let _e405 = global_2.member[bitcast<u32>(select(0i, _e400, (_e400 > 0i)))];
let _e406 = local_41;
let _e407 = local_42;
let _e410 = local_43;
let _e411 = ((21i * (_e406 * _e407)) + _e410);
let _e413 = select(_e209, _e411, (_e411 < _e209));
let _e418 = global_2.member[bitcast<u32>(select(0i, _e413, (_e413 > 0i)))];
let _e420 = (_e308 && (_e418 > 0f));
let _e421 = f32(_e194);
let _e422 = f32(_e299);
let _e431 = global_1.member.member_6.member;
let _e432 = (((((f32(_e298) + 0.5f) / _e421) * 2f) - 1f) * _e431);
let _e441 = global_1.member.member_6.member_1;
let _e442 = ((1f - (((f32(_e189) + 0.5f) / _e422) * 2f)) * _e441);
let _e445 = global_1.member.member_7;
let _e454 = global_1.member.member_8;
let _e458 = (_e454.member * _e442);
let _e459 = (_e454.member_1 * _e442);
let _e460 = (_e454.member_2 * _e442);
let _e467 = global_1.member.member_6.member_3;
let _e469 = select(1f, 0f, (_e467 != 0u));
let _e472 = global_1.member.member_9;
let _e479 = (_e472.member + (((_e445.member * _e432) + _e458) * _e469));
let _e480 = (_e472.member_1 + (((_e445.member_1 * _e432) + _e459) * _e469));
let _e481 = (_e472.member_2 + (((_e445.member_2 * _e432) + _e460) * _e469));
let _e486 = (((_e479 * _e479) + (_e480 * _e480)) + (_e481 * _e481));
let _e489 = sqrt(select(0f, _e486, (_e486 > 0f)));
let _e492 = (1f / select(1e-20f, _e489, (_e489 > 1e-20f)));
let _e493 = (_e479 * _e492);
let _e494 = (_e480 * _e492);
let _e495 = (_e481 * _e492);
local_37 = (_e195 + _e298);
local_38 = _e202;
let _e497 = local_38;
let _e499 = local_37;
let _e500 = ((9i * _e497) + _e499);
let _e502 = select(_e209, _e500, (_e500 < _e209));
let _e507 = global_2.member[bitcast<u32>(select(0i, _e502, (_e502 > 0i)))];
let _e508 = local_38;
let _e510 = local_37;
let _e511 = ((10i * _e508) + _e510);
let _e513 = select(_e209, _e511, (_e511 < _e209));
let _e518 = global_2.member[bitcast<u32>(select(0i, _e513, (_e513 > 0i)))];
let _e519 = local_38;
let _e521 = local_37;
let _e522 = ((11i * _e519) + _e521);
let _e524 = select(_e209, _e522, (_e522 < _e209));
let _e529 = global_2.member[bitcast<u32>(select(0i, _e524, (_e524 > 0i)))];
let _e535 = (2f * (((_e493 * _e507) + (_e494 * _e518)) + (_e495 * _e529)));
let _e542 = (_e188 + 1i);
local_34 = _e194;
local_35 = _e299;
let _e544 = local_34;
let _e548 = local_35;
let _e550 = ((((_e542 >= 0i) && (_e542 < _e544)) && _e304) && (_e189 < _e548));
if _e550 {
let _e551 = local_34;
local_36 = ((_e189 * _e551) + _e542);
} else {
local_36 = 0i;
}
let _e554 = local_34;
let _e555 = local_35;
let _e558 = local_36;
let _e559 = ((18i * (_e554 * _e555)) + _e558);
let _e561 = select(_e209, _e559, (_e559 < _e209));
let _e566 = global_2.member[bitcast<u32>(select(0i, _e561, (_e561 > 0i)))];
let _e569 = local_34;
let _e570 = local_35;
let _e573 = local_36;
let _e574 = ((16i * (_e569 * _e570)) + _e573);
let _e576 = select(_e209, _e574, (_e574 < _e209));
let _e581 = global_2.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e583 = ((_e550 && (_e566 == _e283)) && (_e581 == _e294));
let _e584 = local_34;
let _e585 = local_35;
let _e588 = local_36;
let _e589 = ((18i * (_e584 * _e585)) + _e588);
let _e591 = select(_e209, _e589, (_e589 < _e209));
let _e596 = global_2.member[bitcast<u32>(select(0i, _e591, (_e591 > 0i)))];
let _e599 = local_34;
let _e600 = local_35;
let _e603 = local_36;
let _e604 = ((16i * (_e599 * _e600)) + _e603);
let _e606 = select(_e209, _e604, (_e604 < _e209));
let _e611 = global_2.member[bitcast<u32>(select(0i, _e606, (_e606 > 0i)))];
let _e614 = local_36;
local_32 = _e614;
local_33 = _e202;
let _e615 = local_33;
let _e617 = local_32;
let _e618 = ((3i * _e615) + _e617);
let _e620 = select(_e209, _e618, (_e618 < _e209));
let _e625 = global_2.member[bitcast<u32>(select(0i, _e620, (_e620 > 0i)))];
let _e626 = local_33;
let _e628 = local_32;
let _e629 = ((4i * _e626) + _e628);
let _e631 = select(_e209, _e629, (_e629 < _e209));
let _e636 = global_2.member[bitcast<u32>(select(0i, _e631, (_e631 > 0i)))];
let _e637 = local_33;
let _e639 = local_32;
let _e640 = ((5i * _e637) + _e639);
let _e642 = select(_e209, _e640, (_e640 < _e209));
let _e647 = global_2.member[bitcast<u32>(select(0i, _e642, (_e642 > 0i)))];
let _e648 = local_34;
let _e649 = local_35;
let _e652 = local_36;
let _e653 = ((21i * (_e648 * _e649)) + _e652);
let _e655 = select(_e209, _e653, (_e653 < _e209));
let _e660 = global_2.member[bitcast<u32>(select(0i, _e655, (_e655 > 0i)))];
let _e662 = (_e550 && (_e660 > 0f));
let _e668 = (((((f32(_e542) + 0.5f) / _e421) * 2f) - 1f) * _e431);
let _e678 = (_e472.member + (((_e445.member * _e668) + _e458) * _e469));
let _e679 = (_e472.member_1 + (((_e445.member_1 * _e668) + _e459) * _e469));
let _e680 = (_e472.member_2 + (((_e445.member_2 * _e668) + _e460) * _e469));
let _e685 = (((_e678 * _e678) + (_e679 * _e679)) + (_e680 * _e680));
let _e688 = sqrt(select(0f, _e685, (_e685 > 0f)));
let _e691 = (1f / select(1e-20f, _e688, (_e688 > 1e-20f)));
let _e692 = (_e678 * _e691);
let _e693 = (_e679 * _e691);
let _e694 = (_e680 * _e691);
local_30 = (_e195 + _e542);
local_31 = _e202;
let _e696 = local_31;
let _e698 = local_30;
let _e699 = ((9i * _e696) + _e698);
let _e701 = select(_e209, _e699, (_e699 < _e209));
let _e706 = global_2.member[bitcast<u32>(select(0i, _e701, (_e701 > 0i)))];
let _e707 = local_31;
let _e709 = local_30;
let _e710 = ((10i * _e707) + _e709);
let _e712 = select(_e209, _e710, (_e710 < _e209));
let _e717 = global_2.member[bitcast<u32>(select(0i, _e712, (_e712 > 0i)))];
let _e718 = local_31;
let _e720 = local_30;
let _e721 = ((11i * _e718) + _e720);
let _e723 = select(_e209, _e721, (_e721 < _e209));
let _e728 = global_2.member[bitcast<u32>(select(0i, _e723, (_e723 > 0i)))];
let _e734 = (2f * (((_e692 * _e706) + (_e693 * _e717)) + (_e694 * _e728)));
let _e741 = (_e189 - 1i);
local_27 = _e194;
local_28 = _e299;
let _e742 = (_e188 >= 0i);
let _e743 = local_27;
let _e748 = local_28;
let _e750 = (((_e742 && (_e188 < _e743)) && (_e741 >= 0i)) && (_e741 < _e748));
if _e750 {
let _e751 = local_27;
local_29 = ((_e741 * _e751) + _e188);
} else {
local_29 = 0i;
}
let _e754 = local_27;
let _e755 = local_28;
let _e758 = local_29;
let _e759 = ((18i * (_e754 * _e755)) + _e758);
let _e761 = select(_e209, _e759, (_e759 < _e209));
let _e766 = global_2.member[bitcast<u32>(select(0i, _e761, (_e761 > 0i)))];
let _e769 = local_27;
let _e770 = local_28;
let _e773 = local_29;
let _e774 = ((16i * (_e769 * _e770)) + _e773);
let _e776 = select(_e209, _e774, (_e774 < _e209));
let _e781 = global_2.member[bitcast<u32>(select(0i, _e776, (_e776 > 0i)))];
let _e783 = ((_e750 && (_e766 == _e283)) && (_e781 == _e294));
let _e784 = local_27;
let _e785 = local_28;
let _e788 = local_29;
let _e789 = ((18i * (_e784 * _e785)) + _e788);
let _e791 = select(_e209, _e789, (_e789 < _e209));
let _e796 = global_2.member[bitcast<u32>(select(0i, _e791, (_e791 > 0i)))];
let _e799 = local_27;
let _e800 = local_28;
let _e803 = local_29;
let _e804 = ((16i * (_e799 * _e800)) + _e803);
let _e806 = select(_e209, _e804, (_e804 < _e209));
let _e811 = global_2.member[bitcast<u32>(select(0i, _e806, (_e806 > 0i)))];
let _e814 = local_29;
local_25 = _e814;
local_26 = _e202;
let _e815 = local_26;
let _e817 = local_25;
let _e818 = ((3i * _e815) + _e817);
let _e820 = select(_e209, _e818, (_e818 < _e209));
let _e825 = global_2.member[bitcast<u32>(select(0i, _e820, (_e820 > 0i)))];
let _e826 = local_26;
let _e828 = local_25;
let _e829 = ((4i * _e826) + _e828);
let _e831 = select(_e209, _e829, (_e829 < _e209));
let _e836 = global_2.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e837 = local_26;
let _e839 = local_25;
let _e840 = ((5i * _e837) + _e839);
let _e842 = select(_e209, _e840, (_e840 < _e209));
let _e847 = global_2.member[bitcast<u32>(select(0i, _e842, (_e842 > 0i)))];
let _e848 = local_27;
let _e849 = local_28;
let _e852 = local_29;
let _e853 = ((21i * (_e848 * _e849)) + _e852);
let _e855 = select(_e209, _e853, (_e853 < _e209));
let _e860 = global_2.member[bitcast<u32>(select(0i, _e855, (_e855 > 0i)))];
let _e862 = (_e750 && (_e860 > 0f));
let _e868 = (((((f32(_e188) + 0.5f) / _e421) * 2f) - 1f) * _e431);
let _e874 = ((1f - (((f32(_e741) + 0.5f) / _e422) * 2f)) * _e441);
let _e875 = (_e445.member * _e868);
let _e876 = (_e445.member_1 * _e868);
let _e877 = (_e445.member_2 * _e868);
let _e887 = (_e472.member + ((_e875 + (_e454.member * _e874)) * _e469));
let _e888 = (_e472.member_1 + ((_e876 + (_e454.member_1 * _e874)) * _e469));
let _e889 = (_e472.member_2 + ((_e877 + (_e454.member_2 * _e874)) * _e469));
let _e894 = (((_e887 * _e887) + (_e888 * _e888)) + (_e889 * _e889));
let _e897 = sqrt(select(0f, _e894, (_e894 > 0f)));
let _e900 = (1f / select(1e-20f, _e897, (_e897 > 1e-20f)));
let _e901 = (_e887 * _e900);
let _e902 = (_e888 * _e900);
let _e903 = (_e889 * _e900);
local_23 = ((_e741 * _e194) + _e188);
local_24 = _e202;
let _e906 = local_24;
let _e908 = local_23;
let _e909 = ((9i * _e906) + _e908);
let _e911 = select(_e209, _e909, (_e909 < _e209));
let _e916 = global_2.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e917 = local_24;
let _e919 = local_23;
let _e920 = ((10i * _e917) + _e919);
let _e922 = select(_e209, _e920, (_e920 < _e209));
let _e927 = global_2.member[bitcast<u32>(select(0i, _e922, (_e922 > 0i)))];
let _e928 = local_24;
let _e930 = local_23;
let _e931 = ((11i * _e928) + _e930);
let _e933 = select(_e209, _e931, (_e931 < _e209));
let _e938 = global_2.member[bitcast<u32>(select(0i, _e933, (_e933 > 0i)))];
let _e944 = (2f * (((_e901 * _e916) + (_e902 * _e927)) + (_e903 * _e938)));
let _e951 = (_e189 + 1i);
local_20 = _e194;
local_21 = _e299;
let _e952 = local_20;
let _e957 = local_21;
let _e959 = (((_e742 && (_e188 < _e952)) && (_e951 >= 0i)) && (_e951 < _e957));
if _e959 {
let _e960 = local_20;
local_22 = ((_e951 * _e960) + _e188);
} else {
local_22 = 0i;
}
let _e963 = local_20;
let _e964 = local_21;
let _e967 = local_22;
let _e968 = ((18i * (_e963 * _e964)) + _e967);
let _e970 = select(_e209, _e968, (_e968 < _e209));
let _e975 = global_2.member[bitcast<u32>(select(0i, _e970, (_e970 > 0i)))];
let _e978 = local_20;
let _e979 = local_21;
let _e982 = local_22;
let _e983 = ((16i * (_e978 * _e979)) + _e982);
let _e985 = select(_e209, _e983, (_e983 < _e209));
let _e990 = global_2.member[bitcast<u32>(select(0i, _e985, (_e985 > 0i)))];
let _e992 = ((_e959 && (_e975 == _e283)) && (_e990 == _e294));
let _e993 = local_20;
let _e994 = local_21;
let _e997 = local_22;
let _e998 = ((18i * (_e993 * _e994)) + _e997);
let _e1000 = select(_e209, _e998, (_e998 < _e209));
let _e1005 = global_2.member[bitcast<u32>(select(0i, _e1000, (_e1000 > 0i)))];
let _e1008 = local_20;
let _e1009 = local_21;
let _e1012 = local_22;
let _e1013 = ((16i * (_e1008 * _e1009)) + _e1012);
let _e1015 = select(_e209, _e1013, (_e1013 < _e209));
let _e1020 = global_2.member[bitcast<u32>(select(0i, _e1015, (_e1015 > 0i)))];
let _e1023 = local_22;
local_18 = _e1023;
local_19 = _e202;
let _e1024 = local_19;
let _e1026 = local_18;
let _e1027 = ((3i * _e1024) + _e1026);
let _e1029 = select(_e209, _e1027, (_e1027 < _e209));
let _e1034 = global_2.member[bitcast<u32>(select(0i, _e1029, (_e1029 > 0i)))];
let _e1035 = local_19;
let _e1037 = local_18;
let _e1038 = ((4i * _e1035) + _e1037);
let _e1040 = select(_e209, _e1038, (_e1038 < _e209));
let _e1045 = global_2.member[bitcast<u32>(select(0i, _e1040, (_e1040 > 0i)))];
let _e1046 = local_19;
let _e1048 = local_18;
let _e1049 = ((5i * _e1046) + _e1048);
let _e1051 = select(_e209, _e1049, (_e1049 < _e209));
let _e1056 = global_2.member[bitcast<u32>(select(0i, _e1051, (_e1051 > 0i)))];
let _e1057 = local_20;
let _e1058 = local_21;
let _e1061 = local_22;
let _e1062 = ((21i * (_e1057 * _e1058)) + _e1061);
let _e1064 = select(_e209, _e1062, (_e1062 < _e209));
let _e1069 = global_2.member[bitcast<u32>(select(0i, _e1064, (_e1064 > 0i)))];
let _e1071 = (_e959 && (_e1069 > 0f));
let _e1077 = ((1f - (((f32(_e951) + 0.5f) / _e422) * 2f)) * _e441);
let _e1087 = (_e472.member + ((_e875 + (_e454.member * _e1077)) * _e469));
let _e1088 = (_e472.member_1 + ((_e876 + (_e454.member_1 * _e1077)) * _e469));
let _e1089 = (_e472.member_2 + ((_e877 + (_e454.member_2 * _e1077)) * _e469));
let _e1094 = (((_e1087 * _e1087) + (_e1088 * _e1088)) + (_e1089 * _e1089));
let _e1097 = sqrt(select(0f, _e1094, (_e1094 > 0f)));
let _e1100 = (1f / select(1e-20f, _e1097, (_e1097 > 1e-20f)));
let _e1101 = (_e1087 * _e1100);
let _e1102 = (_e1088 * _e1100);
let _e1103 = (_e1089 * _e1100);
local_16 = ((_e951 * _e194) + _e188);
local_17 = _e202;
let _e1106 = local_17;
let _e1108 = local_16;
let _e1109 = ((9i * _e1106) + _e1108);
let _e1111 = select(_e209, _e1109, (_e1109 < _e209));
let _e1116 = global_2.member[bitcast<u32>(select(0i, _e1111, (_e1111 > 0i)))];
let _e1117 = local_17;
let _e1119 = local_16;
let _e1120 = ((10i * _e1117) + _e1119);
let _e1122 = select(_e209, _e1120, (_e1120 < _e209));
let _e1127 = global_2.member[bitcast<u32>(select(0i, _e1122, (_e1122 > 0i)))];
let _e1128 = local_17;
let _e1130 = local_16;
let _e1131 = ((11i * _e1128) + _e1130);
let _e1133 = select(_e209, _e1131, (_e1131 < _e209));
let _e1138 = global_2.member[bitcast<u32>(select(0i, _e1133, (_e1133 > 0i)))];
let _e1144 = (2f * (((_e1101 * _e1116) + (_e1102 * _e1127)) + (_e1103 * _e1138)));
let _e1151 = (_e875 + _e458);
let _e1152 = (_e876 + _e459);
let _e1153 = (_e877 + _e460);
let _e1157 = (_e472.member + (_e1151 * _e469));
let _e1158 = (_e472.member_1 + (_e1152 * _e469));
let _e1159 = (_e472.member_2 + (_e1153 * _e469));
let _e1164 = (((_e1157 * _e1157) + (_e1158 * _e1158)) + (_e1159 * _e1159));
let _e1167 = sqrt(select(0f, _e1164, (_e1164 > 0f)));
let _e1170 = (1f / select(1e-20f, _e1167, (_e1167 > 1e-20f)));
let _e1171 = (_e1157 * _e1170);
let _e1172 = (_e1158 * _e1170);
let _e1173 = (_e1159 * _e1170);
let _e1174 = (_e692 - _e1171);
let _e1175 = (_e693 - _e1172);
let _e1176 = (_e694 - _e1173);
let _e1181 = (((_e1174 * _e1174) + (_e1175 * _e1175)) + (_e1176 * _e1176));
let _e1184 = sqrt(select(0f, _e1181, (_e1181 > 0f)));
let _e1185 = local_48;
local_12 = _e1185;
local_13 = _e202;
let _e1186 = local_12;
local_14 = _e1186;
local_15 = _e202;
let _e1187 = local_15;
let _e1189 = local_14;
let _e1190 = ((3i * _e1187) + _e1189);
let _e1192 = select(_e209, _e1190, (_e1190 < _e209));
let _e1197 = global_2.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1198 = local_15;
let _e1200 = local_14;
let _e1201 = ((4i * _e1198) + _e1200);
let _e1203 = select(_e209, _e1201, (_e1201 < _e209));
let _e1208 = global_2.member[bitcast<u32>(select(0i, _e1203, (_e1203 > 0i)))];
let _e1209 = local_15;
let _e1211 = local_14;
let _e1212 = ((5i * _e1209) + _e1211);
let _e1214 = select(_e209, _e1212, (_e1212 < _e209));
let _e1219 = global_2.member[bitcast<u32>(select(0i, _e1214, (_e1214 > 0i)))];
let _e1220 = local_13;
let _e1222 = local_12;
let _e1223 = ((18i * _e1220) + _e1222);
let _e1225 = select(_e209, _e1223, (_e1223 < _e209));
let _e1230 = global_2.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1232 = (_e1197 - _e383);
let _e1233 = (_e1208 - _e394);
let _e1234 = (_e1219 - _e405);
let _e1239 = (((_e1232 * _e1232) + (_e1233 * _e1233)) + (_e1234 * _e1234));
let _e1242 = sqrt(select(0f, _e1239, (_e1239 > 0f)));
let _e1243 = (_e625 - _e1197);
let _e1244 = (_e636 - _e1208);
let _e1245 = (_e647 - _e1219);
let _e1250 = (((_e1243 * _e1243) + (_e1244 * _e1244)) + (_e1245 * _e1245));
let _e1253 = sqrt(select(0f, _e1250, (_e1250 > 0f)));
let _e1259 = ((select(0f, _e1242, _e341) + select(0f, _e1253, _e583)) * select(1f, 0.5f, (_e341 && _e583)));
let _e1261 = select(4f, _e1242, ((_e308 && (_e354 > 0f)) && (_e369 == 1f)));
let _e1262 = select(4f, _e1253, ((_e550 && (_e596 > 0f)) && (_e611 == 1f)));
let _e1264 = select(_e1262, _e1261, (_e1261 < _e1262));
let _e1265 = (_e1197 - _e825);
let _e1266 = (_e1208 - _e836);
let _e1267 = (_e1219 - _e847);
let _e1272 = (((_e1265 * _e1265) + (_e1266 * _e1266)) + (_e1267 * _e1267));
let _e1275 = sqrt(select(0f, _e1272, (_e1272 > 0f)));
let _e1276 = (_e1034 - _e1197);
let _e1277 = (_e1045 - _e1208);
let _e1278 = (_e1056 - _e1219);
let _e1283 = (((_e1276 * _e1276) + (_e1277 * _e1277)) + (_e1278 * _e1278));
let _e1286 = sqrt(select(0f, _e1283, (_e1283 > 0f)));
let _e1292 = ((select(0f, _e1275, _e783) + select(0f, _e1286, _e992)) * select(1f, 0.5f, (_e783 && _e992)));
let _e1294 = select(4f, _e1275, ((_e750 && (_e796 > 0f)) && (_e811 == 1f)));
let _e1295 = select(4f, _e1286, ((_e959 && (_e1005 > 0f)) && (_e1020 == 1f)));
let _e1297 = select(_e1295, _e1294, (_e1294 < _e1295));
let _e1301 = select(_e1297, _e1264, (_e1264 < _e1297));
let _e1308 = select(_e1184, select(select(_e1184, select(_e1184, _e1301, (_e1301 > _e1184)), (_e1301 < 4f)), select(_e1292, _e1259, (_e1259 > _e1292)), ((_e341 || _e583) || (_e783 || _e992))), (_e1230 > 0f));
let _e1312 = global_1.member.member_16.member_4;
let _e1320 = (((_e1312.member * _e1197) + (_e1312.member_1 * _e1208)) + (_e1312.member_2 * _e1219));
let _e1324 = global_1.member.member_16.member_5;
let _e1332 = (((_e1324.member * _e1197) + (_e1324.member_1 * _e1208)) + (_e1324.member_2 * _e1219));
let _e1336 = global_1.member.member_16.member_6;
let _e1344 = (((_e1336.member * _e1197) + (_e1336.member_1 * _e1208)) + (_e1336.member_2 * _e1219));
let _e1348 = global_1.member.member_16.member;
let _e1352 = global_1.member.member_16.member_7;
let _e1356 = vec3<f32>(_e1352.member, _e1352.member_1, _e1352.member_2);
let _e1360 = global_1.member.member_16.member_8;
let _e1364 = (_e1348 == 0u);
if _e1364 {
phi_4069_ = _e1356;
} else {
if (_e1348 == 1u) {
let _e1367 = select(-1f, _e1344, (_e1344 > -1f));
let _e1369 = select(1f, _e1367, (_e1367 < 1f));
if (_e1369 > 0f) {
phi_2684_ = _e1356;
} else {
let _e1374 = global_1.member.member_16.member_9;
phi_2684_ = vec3<f32>(_e1374.member, _e1374.member_1, _e1374.member_2);
}
let _e1380 = phi_2684_;
let _e1389 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
let _e1392 = sqrt(select(0f, _e1389, (_e1389 > 0f)));
phi_4068_ = vec3<f32>((_e1360.member + ((_e1380.x - _e1360.member) * _e1392)), (_e1360.member_1 + ((_e1380.y - _e1360.member_1) * _e1392)), (_e1360.member_2 + ((_e1380.z - _e1360.member_2) * _e1392)));
} else {
if (_e1348 == 2u) {
let _e1404 = global_1.member.member_16.member_10;
let _e1405 = (_e1308 / _e1404);
let _e1407 = select(1e-4f, _e1405, (_e1405 > 1e-4f));
let _e1410 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
let _e1413 = bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u));
let _e1417 = select(_e1413, _e1410, (_e1410 > _e1413));
let _e1420 = (select(_e1413, _e1410, (_e1410 < _e1413)) / select(1.1754944e-38f, _e1417, (_e1417 > 1.1754944e-38f)));
let _e1421 = (_e1420 > 0.41421357f);
let _e1425 = select(_e1420, ((_e1420 - 1f) / (_e1420 + 1f)), _e1421);
let _e1426 = (_e1425 * _e1425);
let _e1441 = (select(0f, 0.7853982f, _e1421) + (_e1425 + ((_e1425 * _e1426) * (-0.33333334f + (_e1426 * (0.2f + (_e1426 * (-0.14285713f + (_e1426 * (0.11111111f + (_e1426 * (-0.09090909f + (_e1426 * 0.0585f)))))))))))));
let _e1444 = select(_e1441, (1.5707964f - _e1441), (_e1413 > _e1410));
let _e1447 = select(_e1444, (3.1415927f - _e1444), (_e1320 < 0f));
let _e1453 = (1f - (_e1344 * _e1344));
let _e1456 = sqrt(select(0f, _e1453, (_e1453 > 0f)));
let _e1459 = (_e1407 / select(1e-3f, _e1456, (_e1456 > 1e-3f)));
let _e1460 = ((select(_e1447, -(_e1447), (_e1332 < 0f)) / _e1404) * 0.5f);
let _e1462 = select(-8e6f, _e1460, (_e1460 > -8e6f));
let _e1464 = select(8e6f, _e1462, (_e1462 < 8e6f));
let _e1471 = select(0i, select(select(i32(_e1464), i32(-2147483648), (_e1464 < -2147483600f)), 2147483647i, (_e1464 > 2147483500f)), (_e1464 == _e1464));
let _e1478 = ((_e1460 - f32((_e1471 - select(0i, 1i, (_e1464 < f32(_e1471)))))) * 2f);
let _e1486 = ((select(select((_e1478 - 2f), (1f - _e1478), (_e1478 < 1.5f)), _e1478, (_e1478 < 0.5f)) * 2f) / _e1459);
let _e1488 = select(-1f, _e1486, (_e1486 > -1f));
let _e1491 = (2f - _e1459);
let _e1493 = select(0f, _e1491, (_e1491 > 0f));
let _e1498 = select(-1f, _e1344, (_e1344 > -1f));
let _e1500 = select(1f, _e1498, (_e1498 < 1f));
let _e1503 = ((1f - _e1500) * (1f + _e1500));
let _e1506 = sqrt(select(0f, _e1503, (_e1503 > 0f)));
let _e1509 = bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u));
let _e1512 = bitcast<f32>((bitcast<u32>(_e1500) & 2147483647u));
let _e1516 = select(_e1512, _e1509, (_e1509 > _e1512));
let _e1519 = (select(_e1512, _e1509, (_e1509 < _e1512)) / select(1.1754944e-38f, _e1516, (_e1516 > 1.1754944e-38f)));
let _e1520 = (_e1519 > 0.41421357f);
let _e1524 = select(_e1519, ((_e1519 - 1f) / (_e1519 + 1f)), _e1520);
let _e1525 = (_e1524 * _e1524);
let _e1540 = (select(0f, 0.7853982f, _e1520) + (_e1524 + ((_e1524 * _e1525) * (-0.33333334f + (_e1525 * (0.2f + (_e1525 * (-0.14285713f + (_e1525 * (0.11111111f + (_e1525 * (-0.09090909f + (_e1525 * 0.0585f)))))))))))));
let _e1543 = select(_e1540, (1.5707964f - _e1540), (_e1512 > _e1509));
let _e1546 = select(_e1543, (3.1415927f - _e1543), (_e1506 < 0f));
let _e1551 = ((select(_e1546, -(_e1546), (_e1500 < 0f)) / _e1404) * 0.5f);
let _e1553 = select(-8e6f, _e1551, (_e1551 > -8e6f));
let _e1555 = select(8e6f, _e1553, (_e1553 < 8e6f));
let _e1562 = select(0i, select(select(i32(_e1555), i32(-2147483648), (_e1555 < -2147483600f)), 2147483647i, (_e1555 > 2147483500f)), (_e1555 == _e1555));
let _e1569 = ((_e1551 - f32((_e1562 - select(0i, 1i, (_e1555 < f32(_e1562)))))) * 2f);
let _e1577 = ((select(select((_e1569 - 2f), (1f - _e1569), (_e1569 < 1.5f)), _e1569, (_e1569 < 0.5f)) * 2f) / _e1407);
let _e1579 = select(-1f, _e1577, (_e1577 > -1f));
let _e1582 = (2f - _e1407);
let _e1584 = select(0f, _e1582, (_e1582 > 0f));
let _e1590 = (0.5f + ((0.5f * (select(1f, _e1488, (_e1488 < 1f)) * select(1f, _e1493, (_e1493 < 1f)))) * (select(1f, _e1579, (_e1579 < 1f)) * select(1f, _e1584, (_e1584 < 1f)))));
phi_4067_ = vec3<f32>((_e1352.member + ((_e1360.member - _e1352.member) * _e1590)), (_e1352.member_1 + ((_e1360.member_1 - _e1352.member_1) * _e1590)), (_e1352.member_2 + ((_e1360.member_2 - _e1352.member_2) * _e1590)));
} else {
let _e1604 = global_1.member.member_16.member_1;
let _e1605 = bitcast<i32>(_e1604);
let _e1610 = global_1.member.member_16.member_3;
let _e1612 = f32(bitcast<i32>(_e1610));
let _e1614 = (2f * 3.1415927f);
let _e1615 = ((_e1308 * f32(_e1605)) / _e1614);
let _e1617 = select(1e-6f, _e1615, (_e1615 > 1e-6f));
let _e1620 = bitcast<u32>(select(1.1754944e-38f, _e1617, (_e1617 > 1.1754944e-38f)));
let _e1621 = (_e1620 & 8388607u);
let _e1623 = select(0u, 1u, (_e1621 > 3474675u));
let _e1634 = bitcast<f32>((_e1621 | ((127u - _e1623) << bitcast<u32>(23i))));
let _e1637 = ((_e1634 - 1f) / (_e1634 + 1f));
let _e1638 = (_e1637 * _e1637);
let _e1653 = (f32(((bitcast<i32>((_e1620 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1623))) + (((2f * _e1637) + ((_e1637 * _e1638) * (0.6666667f + (_e1638 * (0.4f + (_e1638 * (0.2857143f + (_e1638 * (0.22222222f + (_e1638 * 0.18181819f)))))))))) * 1.442695f));
let _e1654 = (_e1612 - 1f);
let _e1656 = select(0f, _e1653, (_e1653 > 0f));
let _e1658 = select(_e1654, _e1656, (_e1656 < _e1654));
let _e1659 = (_e1612 - 2f);
let _e1661 = select(0f, _e1659, (_e1659 > 0f));
let _e1663 = select(0f, _e1658, (_e1658 > 0f));
let _e1665 = select(_e1661, _e1663, (_e1663 < _e1661));
let _e1672 = select(0i, select(select(i32(_e1665), i32(-2147483648), (_e1665 < -2147483600f)), 2147483647i, (_e1665 > 2147483500f)), (_e1665 == _e1665));
let _e1676 = (_e1672 - select(0i, 1i, (_e1665 < f32(_e1672))));
let _e1679 = bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u));
let _e1682 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
let _e1686 = select(_e1682, _e1679, (_e1679 > _e1682));
let _e1689 = (select(_e1682, _e1679, (_e1679 < _e1682)) / select(1.1754944e-38f, _e1686, (_e1686 > 1.1754944e-38f)));
let _e1690 = (_e1689 > 0.41421357f);
let _e1694 = select(_e1689, ((_e1689 - 1f) / (_e1689 + 1f)), _e1690);
let _e1695 = (_e1694 * _e1694);
let _e1710 = (select(0f, 0.7853982f, _e1690) + (_e1694 + ((_e1694 * _e1695) * (-0.33333334f + (_e1695 * (0.2f + (_e1695 * (-0.14285713f + (_e1695 * (0.11111111f + (_e1695 * (-0.09090909f + (_e1695 * 0.0585f)))))))))))));
let _e1713 = select(_e1710, (1.5707964f - _e1710), (_e1682 > _e1679));
let _e1716 = select(_e1713, (3.1415927f - _e1713), (_e1332 < 0f));
let _e1721 = (0.5f - (select(_e1716, -(_e1716), (_e1320 < 0f)) / _e1614));
let _e1723 = select(-1f, _e1344, (_e1344 > -1f));
let _e1725 = select(1f, _e1723, (_e1723 < 1f));
let _e1728 = ((1f - _e1725) * (1f + _e1725));
let _e1731 = sqrt(select(0f, _e1728, (_e1728 > 0f)));
let _e1734 = bitcast<f32>((bitcast<u32>(_e1731) & 2147483647u));
let _e1737 = bitcast<f32>((bitcast<u32>(_e1725) & 2147483647u));
let _e1741 = select(_e1737, _e1734, (_e1734 > _e1737));
let _e1744 = (select(_e1737, _e1734, (_e1734 < _e1737)) / select(1.1754944e-38f, _e1741, (_e1741 > 1.1754944e-38f)));
let _e1745 = (_e1744 > 0.41421357f);
let _e1749 = select(_e1744, ((_e1744 - 1f) / (_e1744 + 1f)), _e1745);
let _e1750 = (_e1749 * _e1749);
let _e1765 = (select(0f, 0.7853982f, _e1745) + (_e1749 + ((_e1749 * _e1750) * (-0.33333334f + (_e1750 * (0.2f + (_e1750 * (-0.14285713f + (_e1750 * (0.11111111f + (_e1750 * (-0.09090909f + (_e1750 * 0.0585f)))))))))))));
let _e1768 = select(_e1765, (1.5707964f - _e1765), (_e1737 > _e1734));
let _e1771 = select(_e1768, (3.1415927f - _e1768), (_e1731 < 0f));
let _e1776 = (0.5f - (select(_e1771, -(_e1771), (_e1725 < 0f)) / 3.1415927f));
let _e1780 = global_1.member.member_16.member_2;
let _e1781 = bitcast<i32>(_e1780);
phi_3286_ = 0i;
phi_3289_ = 0i;
phi_3291_ = _e1781;
phi_3293_ = _e1605;
loop {
let _e1783 = phi_3286_;
let _e1785 = phi_3289_;
let _e1787 = phi_3291_;
let _e1789 = phi_3293_;
local_50 = _e1789;
local_51 = _e1787;
local_52 = _e1789;
local_53 = _e1789;
local_54 = _e1789;
local_55 = _e1789;
local_56 = _e1789;
local_57 = _e1789;
local_58 = _e1787;
local_59 = _e1787;
local_60 = _e1787;
local_61 = _e1787;
local_62 = _e1789;
local_63 = _e1785;
local_64 = _e1789;
local_65 = _e1785;
let _e1790 = (_e1783 < _e1676);
if _e1790 {
if (_e1789 > 1i) {
phi_3308_ = (_e1789 >> bitcast<u32>(1i));
} else {
phi_3308_ = 1i;
}
let _e1797 = phi_3308_;
if (_e1787 > 1i) {
phi_3314_ = (_e1787 >> bitcast<u32>(1i));
} else {
phi_3314_ = 1i;
}
let _e1802 = phi_3314_;
phi_3287_ = (_e1783 + 1i);
phi_3290_ = (_e1785 + (_e1789 * _e1787));
phi_3292_ = _e1802;
phi_3294_ = _e1797;
} else {
phi_3287_ = i32();
phi_3290_ = i32();
phi_3292_ = i32();
phi_3294_ = i32();
}
let _e1805 = phi_3287_;
let _e1807 = phi_3290_;
let _e1809 = phi_3292_;
let _e1811 = phi_3294_;
continue;
continuing {
phi_3286_ = _e1805;
phi_3289_ = _e1807;
phi_3291_ = _e1809;
phi_3293_ = _e1811;
break if !(_e1790);
}
}
let _e1814 = local_50;
let _e1815 = f32(_e1814);
let _e1817 = ((_e1721 * _e1815) - 0.5f);
let _e1819 = local_51;
let _e1820 = f32(_e1819);
let _e1822 = ((_e1776 * _e1820) - 0.5f);
let _e1824 = select(-1f, _e1817, (_e1817 > -1f));
let _e1826 = select(_e1815, _e1824, (_e1824 < _e1815));
let _e1833 = select(0i, select(select(i32(_e1826), i32(-2147483648), (_e1826 < -2147483600f)), 2147483647i, (_e1826 > 2147483500f)), (_e1826 == _e1826));
let _e1837 = (_e1833 - select(0i, 1i, (_e1826 < f32(_e1833))));
let _e1839 = select(-1f, _e1822, (_e1822 > -1f));
let _e1841 = select(_e1820, _e1839, (_e1839 < _e1820));
let _e1848 = select(0i, select(select(i32(_e1841), i32(-2147483648), (_e1841 < -2147483600f)), 2147483647i, (_e1841 > 2147483500f)), (_e1841 == _e1841));
let _e1852 = (_e1848 - select(0i, 1i, (_e1841 < f32(_e1848))));
let _e1854 = (_e1817 - f32(_e1837));
let _e1856 = (_e1822 - f32(_e1852));
let _e1858 = select(0f, _e1856, (_e1856 > 0f));
let _e1860 = select(1f, _e1858, (_e1858 < 1f));
if (_e1837 < 0i) {
let _e1863 = local_52;
phi_3389_ = (_e1837 + _e1863);
} else {
phi_3389_ = _e1837;
}
let _e1866 = phi_3389_;
let _e1868 = local_53;
if (_e1866 >= _e1868) {
let _e1871 = local_54;
phi_3395_ = (_e1866 - _e1871);
} else {
phi_3395_ = _e1866;
}
let _e1874 = phi_3395_;
let _e1875 = (_e1837 + 1i);
if (_e1875 < 0i) {
let _e1878 = local_55;
phi_3402_ = (_e1875 + _e1878);
} else {
phi_3402_ = _e1875;
}
let _e1881 = phi_3402_;
let _e1883 = local_56;
if (_e1881 >= _e1883) {
let _e1886 = local_57;
phi_3408_ = (_e1881 - _e1886);
} else {
phi_3408_ = _e1881;
}
let _e1889 = phi_3408_;
let _e1891 = select(_e1852, 0i, (_e1852 < 0i));
let _e1893 = local_58;
if (_e1891 >= _e1893) {
let _e1896 = local_59;
phi_3419_ = (_e1896 - 1i);
} else {
phi_3419_ = _e1891;
}
let _e1899 = phi_3419_;
let _e1900 = (_e1852 + 1i);
let _e1902 = select(_e1900, 0i, (_e1900 < 0i));
let _e1904 = local_60;
if (_e1902 >= _e1904) {
let _e1907 = local_61;
phi_3431_ = (_e1907 - 1i);
} else {
phi_3431_ = _e1902;
}
let _e1910 = phi_3431_;
let _e1912 = local_62;
let _e1915 = local_63;
let _e1916 = (_e1915 + (_e1899 * _e1912));
let _e1918 = local_64;
let _e1921 = local_65;
let _e1922 = (_e1921 + (_e1910 * _e1918));
let _e1924 = (3i * (_e1916 + _e1874));
let _e1926 = (bitcast<i32>(_e165) - 1i);
let _e1928 = select(_e1926, _e1924, (_e1924 < _e1926));
let _e1934 = global_3.member[bitcast<u32>(select(0i, _e1928, (_e1928 > 0i)))];
let _e1935 = (_e1924 + 1i);
let _e1937 = select(_e1926, _e1935, (_e1935 < _e1926));
let _e1943 = global_3.member[bitcast<u32>(select(0i, _e1937, (_e1937 > 0i)))];
let _e1944 = (_e1924 + 2i);
let _e1946 = select(_e1926, _e1944, (_e1944 < _e1926));
let _e1952 = global_3.member[bitcast<u32>(select(0i, _e1946, (_e1946 > 0i)))];
let _e1954 = (3i * (_e1916 + _e1889));
let _e1956 = select(_e1926, _e1954, (_e1954 < _e1926));
let _e1962 = global_3.member[bitcast<u32>(select(0i, _e1956, (_e1956 > 0i)))];
let _e1963 = (_e1954 + 1i);
let _e1965 = select(_e1926, _e1963, (_e1963 < _e1926));
let _e1971 = global_3.member[bitcast<u32>(select(0i, _e1965, (_e1965 > 0i)))];
let _e1972 = (_e1954 + 2i);
let _e1974 = select(_e1926, _e1972, (_e1972 < _e1926));
let _e1980 = global_3.member[bitcast<u32>(select(0i, _e1974, (_e1974 > 0i)))];
let _e1982 = (3i * (_e1922 + _e1874));
let _e1984 = select(_e1926, _e1982, (_e1982 < _e1926));
let _e1990 = global_3.member[bitcast<u32>(select(0i, _e1984, (_e1984 > 0i)))];
let _e1991 = (_e1982 + 1i);
let _e1993 = select(_e1926, _e1991, (_e1991 < _e1926));
let _e1999 = global_3.member[bitcast<u32>(select(0i, _e1993, (_e1993 > 0i)))];
let _e2000 = (_e1982 + 2i);
let _e2002 = select(_e1926, _e2000, (_e2000 < _e1926));
let _e2008 = global_3.member[bitcast<u32>(select(0i, _e2002, (_e2002 > 0i)))];
let _e2010 = (3i * (_e1922 + _e1889));
let _e2012 = select(_e1926, _e2010, (_e2010 < _e1926));
let _e2018 = global_3.member[bitcast<u32>(select(0i, _e2012, (_e2012 > 0i)))];
let _e2019 = (_e2010 + 1i);
let _e2021 = select(_e1926, _e2019, (_e2019 < _e1926));
let _e2027 = global_3.member[bitcast<u32>(select(0i, _e2021, (_e2021 > 0i)))];
let _e2028 = (_e2010 + 2i);
let _e2030 = select(_e1926, _e2028, (_e2028 < _e1926));
let _e2036 = global_3.member[bitcast<u32>(select(0i, _e2030, (_e2030 > 0i)))];
let _e2043 = (_e1934 + ((_e1962 - _e1934) * _e1854));
let _e2044 = (_e1943 + ((_e1971 - _e1943) * _e1854));
let _e2045 = (_e1952 + ((_e1980 - _e1952) * _e1854));
let _e2061 = (_e2043 + (((_e1990 + ((_e2018 - _e1990) * _e1854)) - _e2043) * _e1860));
let _e2062 = (_e2044 + (((_e1999 + ((_e2027 - _e1999) * _e1854)) - _e2044) * _e1860));
let _e2063 = (_e2045 + (((_e2008 + ((_e2036 - _e2008) * _e1854)) - _e2045) * _e1860));
phi_3667_ = 0i;
phi_3670_ = 0i;
phi_3672_ = _e1781;
phi_3674_ = _e1605;
loop {
let _e2066 = phi_3667_;
let _e2068 = phi_3670_;
let _e2070 = phi_3672_;
let _e2072 = phi_3674_;
local_66 = _e2072;
local_67 = _e2070;
local_68 = _e2072;
local_69 = _e2072;
local_70 = _e2072;
local_71 = _e2072;
local_72 = _e2072;
local_73 = _e2072;
local_74 = _e2070;
local_75 = _e2070;
local_76 = _e2070;
local_77 = _e2070;
local_78 = _e2072;
local_79 = _e2068;
local_80 = _e2072;
local_81 = _e2068;
let _e2073 = (_e2066 < (_e1676 + 1i));
if _e2073 {
if (_e2072 > 1i) {
phi_3689_ = (_e2072 >> bitcast<u32>(1i));
} else {
phi_3689_ = 1i;
}
let _e2080 = phi_3689_;
if (_e2070 > 1i) {
phi_3695_ = (_e2070 >> bitcast<u32>(1i));
} else {
phi_3695_ = 1i;
}
let _e2085 = phi_3695_;
phi_3668_ = (_e2066 + 1i);
phi_3671_ = (_e2068 + (_e2072 * _e2070));
phi_3673_ = _e2085;
phi_3675_ = _e2080;
} else {
phi_3668_ = i32();
phi_3671_ = i32();
phi_3673_ = i32();
phi_3675_ = i32();
}
let _e2088 = phi_3668_;
let _e2090 = phi_3671_;
let _e2092 = phi_3673_;
let _e2094 = phi_3675_;
continue;
continuing {
phi_3667_ = _e2088;
phi_3670_ = _e2090;
phi_3672_ = _e2092;
phi_3674_ = _e2094;
break if !(_e2073);
}
}
let _e2097 = local_66;
let _e2098 = f32(_e2097);
let _e2100 = ((_e1721 * _e2098) - 0.5f);
let _e2102 = local_67;
let _e2103 = f32(_e2102);
let _e2105 = ((_e1776 * _e2103) - 0.5f);
let _e2107 = select(-1f, _e2100, (_e2100 > -1f));
let _e2109 = select(_e2098, _e2107, (_e2107 < _e2098));
let _e2116 = select(0i, select(select(i32(_e2109), i32(-2147483648), (_e2109 < -2147483600f)), 2147483647i, (_e2109 > 2147483500f)), (_e2109 == _e2109));
let _e2120 = (_e2116 - select(0i, 1i, (_e2109 < f32(_e2116))));
let _e2122 = select(-1f, _e2105, (_e2105 > -1f));
let _e2124 = select(_e2103, _e2122, (_e2122 < _e2103));
let _e2131 = select(0i, select(select(i32(_e2124), i32(-2147483648), (_e2124 < -2147483600f)), 2147483647i, (_e2124 > 2147483500f)), (_e2124 == _e2124));
let _e2135 = (_e2131 - select(0i, 1i, (_e2124 < f32(_e2131))));
let _e2137 = (_e2100 - f32(_e2120));
let _e2139 = (_e2105 - f32(_e2135));
let _e2141 = select(0f, _e2139, (_e2139 > 0f));
let _e2143 = select(1f, _e2141, (_e2141 < 1f));
if (_e2120 < 0i) {
let _e2146 = local_68;
phi_3770_ = (_e2120 + _e2146);
} else {
phi_3770_ = _e2120;
}
let _e2149 = phi_3770_;
let _e2151 = local_69;
if (_e2149 >= _e2151) {
let _e2154 = local_70;
phi_3776_ = (_e2149 - _e2154);
} else {
phi_3776_ = _e2149;
}
let _e2157 = phi_3776_;
let _e2158 = (_e2120 + 1i);
if (_e2158 < 0i) {
let _e2161 = local_71;
phi_3783_ = (_e2158 + _e2161);
} else {
phi_3783_ = _e2158;
}
let _e2164 = phi_3783_;
let _e2166 = local_72;
if (_e2164 >= _e2166) {
let _e2169 = local_73;
phi_3789_ = (_e2164 - _e2169);
} else {
phi_3789_ = _e2164;
}
let _e2172 = phi_3789_;
let _e2174 = select(_e2135, 0i, (_e2135 < 0i));
let _e2176 = local_74;
if (_e2174 >= _e2176) {
let _e2179 = local_75;
phi_3800_ = (_e2179 - 1i);
} else {
phi_3800_ = _e2174;
}
let _e2182 = phi_3800_;
let _e2183 = (_e2135 + 1i);
let _e2185 = select(_e2183, 0i, (_e2183 < 0i));
let _e2187 = local_76;
if (_e2185 >= _e2187) {
let _e2190 = local_77;
phi_3812_ = (_e2190 - 1i);
} else {
phi_3812_ = _e2185;
}
let _e2193 = phi_3812_;
let _e2195 = local_78;
let _e2198 = local_79;
let _e2199 = (_e2198 + (_e2182 * _e2195));
let _e2201 = local_80;
let _e2204 = local_81;
let _e2205 = (_e2204 + (_e2193 * _e2201));
let _e2207 = (3i * (_e2199 + _e2157));
let _e2209 = select(_e1926, _e2207, (_e2207 < _e1926));
let _e2215 = global_3.member[bitcast<u32>(select(0i, _e2209, (_e2209 > 0i)))];
let _e2216 = (_e2207 + 1i);
let _e2218 = select(_e1926, _e2216, (_e2216 < _e1926));
let _e2224 = global_3.member[bitcast<u32>(select(0i, _e2218, (_e2218 > 0i)))];
let _e2225 = (_e2207 + 2i);
let _e2227 = select(_e1926, _e2225, (_e2225 < _e1926));
let _e2233 = global_3.member[bitcast<u32>(select(0i, _e2227, (_e2227 > 0i)))];
let _e2235 = (3i * (_e2199 + _e2172));
let _e2237 = select(_e1926, _e2235, (_e2235 < _e1926));
let _e2243 = global_3.member[bitcast<u32>(select(0i, _e2237, (_e2237 > 0i)))];
let _e2244 = (_e2235 + 1i);
let _e2246 = select(_e1926, _e2244, (_e2244 < _e1926));
let _e2252 = global_3.member[bitcast<u32>(select(0i, _e2246, (_e2246 > 0i)))];
let _e2253 = (_e2235 + 2i);
let _e2255 = select(_e1926, _e2253, (_e2253 < _e1926));
let _e2261 = global_3.member[bitcast<u32>(select(0i, _e2255, (_e2255 > 0i)))];
let _e2263 = (3i * (_e2205 + _e2157));
let _e2265 = select(_e1926, _e2263, (_e2263 < _e1926));
let _e2271 = global_3.member[bitcast<u32>(select(0i, _e2265, (_e2265 > 0i)))];
let _e2272 = (_e2263 + 1i);
let _e2274 = select(_e1926, _e2272, (_e2272 < _e1926));
let _e2280 = global_3.member[bitcast<u32>(select(0i, _e2274, (_e2274 > 0i)))];
let _e2281 = (_e2263 + 2i);
let _e2283 = select(_e1926, _e2281, (_e2281 < _e1926));
let _e2289 = global_3.member[bitcast<u32>(select(0i, _e2283, (_e2283 > 0i)))];
let _e2291 = (3i * (_e2205 + _e2172));
let _e2293 = select(_e1926, _e2291, (_e2291 < _e1926));
let _e2299 = global_3.member[bitcast<u32>(select(0i, _e2293, (_e2293 > 0i)))];
let _e2300 = (_e2291 + 1i);
let _e2302 = select(_e1926, _e2300, (_e2300 < _e1926));
let _e2308 = global_3.member[bitcast<u32>(select(0i, _e2302, (_e2302 > 0i)))];
let _e2309 = (_e2291 + 2i);
let _e2311 = select(_e1926, _e2309, (_e2309 < _e1926));
let _e2317 = global_3.member[bitcast<u32>(select(0i, _e2311, (_e2311 > 0i)))];
let _e2324 = (_e2215 + ((_e2243 - _e2215) * _e2137));
let _e2325 = (_e2224 + ((_e2252 - _e2224) * _e2137));
let _e2326 = (_e2233 + ((_e2261 - _e2233) * _e2137));
let _e2349 = (_e1658 - f32(_e1676));
let _e2351 = select(0f, _e2349, (_e2349 > 0f));
let _e2353 = select(1f, _e2351, (_e2351 < 1f));
let _e2363 = global_1.member.member_16.member_11;
phi_4067_ = vec3<f32>(((_e2061 + (((_e2324 + (((_e2271 + ((_e2299 - _e2271) * _e2137)) - _e2324) * _e2143)) - _e2061) * _e2353)) * _e2363), ((_e2062 + (((_e2325 + (((_e2280 + ((_e2308 - _e2280) * _e2137)) - _e2325) * _e2143)) - _e2062) * _e2353)) * _e2363), ((_e2063 + (((_e2326 + (((_e2289 + ((_e2317 - _e2289) * _e2137)) - _e2326) * _e2143)) - _e2063) * _e2353)) * _e2363));
}
let _e2369 = phi_4067_;
phi_4068_ = _e2369;
}
let _e2371 = phi_4068_;
phi_4069_ = _e2371;
}
let _e2373 = phi_4069_;
let _e2374 = local_13;
let _e2376 = local_12;
let _e2377 = ((16i * _e2374) + _e2376);
let _e2379 = select(_e209, _e2377, (_e2377 < _e209));
let _e2384 = global_2.member[bitcast<u32>(select(0i, _e2379, (_e2379 > 0i)))];
if (_e295 && (_e2384 == 3f)) {
let _e2387 = local_13;
let _e2389 = local_12;
let _e2390 = ((30i * _e2387) + _e2389);
let _e2392 = select(_e209, _e2390, (_e2390 < _e209));
let _e2397 = global_2.member[bitcast<u32>(select(0i, _e2392, (_e2392 > 0i)))];
let _e2404 = select(0i, select(select(i32(_e2397), i32(-2147483648), (_e2397 < -2147483600f)), 2147483647i, (_e2397 > 2147483500f)), (_e2397 == _e2397));
let _e2405 = local_12;
local_10 = _e2405;
local_11 = _e202;
let _e2406 = local_10;
let _e2408 = select(_e209, _e2406, (_e2406 < _e209));
let _e2413 = global_2.member[bitcast<u32>(select(0i, _e2408, (_e2408 > 0i)))];
let _e2414 = local_11;
let _e2415 = local_10;
let _e2416 = (_e2414 + _e2415);
let _e2418 = select(_e209, _e2416, (_e2416 < _e209));
let _e2423 = global_2.member[bitcast<u32>(select(0i, _e2418, (_e2418 > 0i)))];
let _e2424 = local_11;
let _e2426 = local_10;
let _e2427 = ((2i * _e2424) + _e2426);
let _e2429 = select(_e209, _e2427, (_e2427 < _e209));
let _e2434 = global_2.member[bitcast<u32>(select(0i, _e2429, (_e2429 > 0i)))];
let _e2435 = vec3<f32>(_e2413, _e2423, _e2434);
if (_e2404 < 0i) {
let _e2437 = (_e2404 == -3i);
let _e2443 = global_1.member.member_18.member_1.member.member;
let _e2448 = global_1.member.member_18.member_1.member_1;
let _e2454 = global_1.member.member_18.member.member.member;
let _e2459 = global_1.member.member_18.member.member_1;
let _e2469 = vec3<f32>(select(_e2454.member, _e2443.member, _e2437), select(_e2454.member_1, _e2443.member_1, _e2437), select(_e2454.member_2, _e2443.member_2, _e2437));
phi_4932_ = type_28(_e2435, _e2469, _e2469, vec3<f32>(select(_e2459.member, _e2448.member, _e2437), select(_e2459.member_1, _e2448.member_1, _e2437), select(_e2459.member_2, _e2448.member_2, _e2437)), 0f, false, _e2437);
} else {
let _e2483 = global_1.member.member_1;
let _e2486 = (_e2404 * 19i);
let _e2488 = (bitcast<i32>(_e167) - 1i);
let _e2490 = select(_e2488, _e2486, (_e2486 < _e2488));
let _e2496 = global_4.member[bitcast<u32>(select(0i, _e2490, (_e2490 > 0i)))];
let _e2497 = (_e2486 + 1i);
let _e2499 = select(_e2488, _e2497, (_e2497 < _e2488));
let _e2505 = global_4.member[bitcast<u32>(select(0i, _e2499, (_e2499 > 0i)))];
let _e2506 = (_e2486 + 2i);
let _e2508 = select(_e2488, _e2506, (_e2506 < _e2488));
let _e2514 = global_4.member[bitcast<u32>(select(0i, _e2508, (_e2508 > 0i)))];
let _e2515 = (_e2486 + 3i);
let _e2517 = select(_e2488, _e2515, (_e2515 < _e2488));
let _e2523 = global_4.member[bitcast<u32>(select(0i, _e2517, (_e2517 > 0i)))];
let _e2524 = (_e2486 + 4i);
let _e2526 = select(_e2488, _e2524, (_e2524 < _e2488));
let _e2532 = global_4.member[bitcast<u32>(select(0i, _e2526, (_e2526 > 0i)))];
let _e2533 = (_e2486 + 5i);
let _e2535 = select(_e2488, _e2533, (_e2533 < _e2488));
let _e2541 = global_4.member[bitcast<u32>(select(0i, _e2535, (_e2535 > 0i)))];
let _e2542 = (_e2486 + 6i);
let _e2544 = select(_e2488, _e2542, (_e2542 < _e2488));
let _e2550 = global_4.member[bitcast<u32>(select(0i, _e2544, (_e2544 > 0i)))];
let _e2551 = (_e2486 + 7i);
let _e2553 = select(_e2488, _e2551, (_e2551 < _e2488));
let _e2559 = global_4.member[bitcast<u32>(select(0i, _e2553, (_e2553 > 0i)))];
let _e2560 = (_e2486 + 8i);
let _e2562 = select(_e2488, _e2560, (_e2560 < _e2488));
let _e2568 = global_4.member[bitcast<u32>(select(0i, _e2562, (_e2562 > 0i)))];
let _e2569 = (_e2523 - _e2496);
let _e2570 = (_e2532 - _e2505);
let _e2571 = (_e2541 - _e2514);
let _e2572 = (_e2550 - _e2496);
let _e2573 = (_e2559 - _e2505);
let _e2574 = (_e2568 - _e2514);
let _e2577 = ((_e2570 * _e2574) - (_e2571 * _e2573));
let _e2580 = ((_e2571 * _e2572) - (_e2569 * _e2574));
let _e2583 = ((_e2569 * _e2573) - (_e2570 * _e2572));
let _e2584 = (_e2523 - _e2413);
let _e2585 = (_e2532 - _e2423);
let _e2586 = (_e2541 - _e2434);
let _e2587 = (_e2550 - _e2413);
let _e2588 = (_e2559 - _e2423);
let _e2589 = (_e2568 - _e2434);
let _e2603 = (((((_e2585 * _e2589) - (_e2586 * _e2588)) * _e2577) + (((_e2586 * _e2587) - (_e2584 * _e2589)) * _e2580)) + (((_e2584 * _e2588) - (_e2585 * _e2587)) * _e2583));
let _e2605 = select(0f, _e2603, (_e2603 > 0f));
let _e2606 = (_e2496 - _e2413);
let _e2607 = (_e2505 - _e2423);
let _e2608 = (_e2514 - _e2434);
let _e2622 = (((((_e2588 * _e2608) - (_e2589 * _e2607)) * _e2577) + (((_e2589 * _e2606) - (_e2587 * _e2608)) * _e2580)) + (((_e2587 * _e2607) - (_e2588 * _e2606)) * _e2583));
let _e2624 = select(0f, _e2622, (_e2622 > 0f));
let _e2638 = (((((_e2607 * _e2586) - (_e2608 * _e2585)) * _e2577) + (((_e2608 * _e2584) - (_e2606 * _e2586)) * _e2580)) + (((_e2606 * _e2585) - (_e2607 * _e2584)) * _e2583));
let _e2640 = select(0f, _e2638, (_e2638 > 0f));
let _e2642 = ((_e2605 + _e2624) + _e2640);
let _e2644 = select(1e-30f, _e2642, (_e2642 > 1e-30f));
let _e2645 = (_e2605 / _e2644);
let _e2646 = (_e2624 / _e2644);
let _e2647 = (_e2640 / _e2644);
let _e2652 = (((_e2577 * _e2577) + (_e2580 * _e2580)) + (_e2583 * _e2583));
let _e2655 = sqrt(select(0f, _e2652, (_e2652 > 0f)));
let _e2658 = (1f / select(1e-20f, _e2655, (_e2655 > 1e-20f)));
let _e2663 = (_e2486 + 9i);
let _e2665 = select(_e2488, _e2663, (_e2663 < _e2488));
let _e2671 = global_4.member[bitcast<u32>(select(0i, _e2665, (_e2665 > 0i)))];
let _e2672 = (_e2486 + 10i);
let _e2674 = select(_e2488, _e2672, (_e2672 < _e2488));
let _e2680 = global_4.member[bitcast<u32>(select(0i, _e2674, (_e2674 > 0i)))];
let _e2681 = (_e2486 + 11i);
let _e2683 = select(_e2488, _e2681, (_e2681 < _e2488));
let _e2689 = global_4.member[bitcast<u32>(select(0i, _e2683, (_e2683 > 0i)))];
let _e2693 = (_e2486 + 12i);
let _e2695 = select(_e2488, _e2693, (_e2693 < _e2488));
let _e2701 = global_4.member[bitcast<u32>(select(0i, _e2695, (_e2695 > 0i)))];
let _e2702 = (_e2486 + 13i);
let _e2704 = select(_e2488, _e2702, (_e2702 < _e2488));
let _e2710 = global_4.member[bitcast<u32>(select(0i, _e2704, (_e2704 > 0i)))];
let _e2711 = (_e2486 + 14i);
let _e2713 = select(_e2488, _e2711, (_e2711 < _e2488));
let _e2719 = global_4.member[bitcast<u32>(select(0i, _e2713, (_e2713 > 0i)))];
let _e2726 = (_e2486 + 15i);
let _e2728 = select(_e2488, _e2726, (_e2726 < _e2488));
let _e2734 = global_4.member[bitcast<u32>(select(0i, _e2728, (_e2728 > 0i)))];
let _e2735 = (_e2486 + 16i);
let _e2737 = select(_e2488, _e2735, (_e2735 < _e2488));
let _e2743 = global_4.member[bitcast<u32>(select(0i, _e2737, (_e2737 > 0i)))];
let _e2744 = (_e2486 + 17i);
let _e2746 = select(_e2488, _e2744, (_e2744 < _e2488));
let _e2752 = global_4.member[bitcast<u32>(select(0i, _e2746, (_e2746 > 0i)))];
let _e2756 = (((_e2671 * _e2645) + (_e2701 * _e2646)) + (_e2734 * _e2647));
let _e2757 = (((_e2680 * _e2645) + (_e2710 * _e2646)) + (_e2743 * _e2647));
let _e2758 = (((_e2689 * _e2645) + (_e2719 * _e2646)) + (_e2752 * _e2647));
let _e2763 = (((_e2756 * _e2756) + (_e2757 * _e2757)) + (_e2758 * _e2758));
let _e2766 = sqrt(select(0f, _e2763, (_e2763 > 0f)));
let _e2769 = (1f / select(1e-20f, _e2766, (_e2766 > 1e-20f)));
let _e2774 = (_e2486 + 18i);
let _e2776 = select(_e2488, _e2774, (_e2774 < _e2488));
let _e2782 = global_4.member[bitcast<u32>(select(0i, _e2776, (_e2776 > 0i)))];
let _e2791 = (select(select(0i, select(select(i32(_e2782), i32(-2147483648), (_e2782 < -2147483600f)), 2147483647i, (_e2782 > 2147483500f)), (_e2782 == _e2782)), _e2404, ((_e2483 & 4u) != 0u)) * 10i);
let _e2793 = (bitcast<i32>(_e169) - 1i);
let _e2795 = select(_e2793, _e2791, (_e2791 < _e2793));
let _e2801 = global_5.member[bitcast<u32>(select(0i, _e2795, (_e2795 > 0i)))];
let _e2802 = (_e2791 + 1i);
let _e2804 = select(_e2793, _e2802, (_e2802 < _e2793));
let _e2810 = global_5.member[bitcast<u32>(select(0i, _e2804, (_e2804 > 0i)))];
let _e2811 = (_e2791 + 2i);
let _e2813 = select(_e2793, _e2811, (_e2811 < _e2793));
let _e2819 = global_5.member[bitcast<u32>(select(0i, _e2813, (_e2813 > 0i)))];
let _e2823 = (_e2791 + 3i);
let _e2825 = select(_e2793, _e2823, (_e2823 < _e2793));
let _e2831 = global_5.member[bitcast<u32>(select(0i, _e2825, (_e2825 > 0i)))];
let _e2832 = (_e2791 + 4i);
let _e2834 = select(_e2793, _e2832, (_e2832 < _e2793));
let _e2840 = global_5.member[bitcast<u32>(select(0i, _e2834, (_e2834 > 0i)))];
let _e2841 = (_e2791 + 5i);
let _e2843 = select(_e2793, _e2841, (_e2841 < _e2793));
let _e2849 = global_5.member[bitcast<u32>(select(0i, _e2843, (_e2843 > 0i)))];
let _e2856 = (_e2791 + 6i);
let _e2858 = select(_e2793, _e2856, (_e2856 < _e2793));
let _e2864 = global_5.member[bitcast<u32>(select(0i, _e2858, (_e2858 > 0i)))];
let _e2865 = (_e2791 + 7i);
let _e2867 = select(_e2793, _e2865, (_e2865 < _e2793));
let _e2873 = global_5.member[bitcast<u32>(select(0i, _e2867, (_e2867 > 0i)))];
let _e2874 = (_e2791 + 8i);
let _e2876 = select(_e2793, _e2874, (_e2874 < _e2793));
let _e2882 = global_5.member[bitcast<u32>(select(0i, _e2876, (_e2876 > 0i)))];
let _e2890 = (_e2791 + 9i);
let _e2892 = select(_e2793, _e2890, (_e2890 < _e2793));
let _e2898 = global_5.member[bitcast<u32>(select(0i, _e2892, (_e2892 > 0i)))];
phi_4932_ = type_28(_e2435, vec3<f32>((_e2577 * _e2658), (_e2580 * _e2658), (_e2583 * _e2658)), vec3<f32>((_e2756 * _e2769), (_e2757 * _e2769), (_e2758 * _e2769)), vec3<f32>((((_e2801 * _e2645) + (_e2831 * _e2646)) + (_e2864 * _e2647)), (((_e2810 * _e2645) + (_e2840 * _e2646)) + (_e2873 * _e2647)), (((_e2819 * _e2645) + (_e2849 * _e2646)) + (_e2882 * _e2647))), _e2898, true, false);
}
let _e2901 = phi_4932_;
let _e2910 = (((_e2901.member_1.x * _e1197) + (_e2901.member_1.y * _e1208)) + (_e2901.member_1.z * _e1219));
let _e2912 = select(1f, -1f, (_e2910 > 0f));
let _e2924 = select(_e2912, -(_e2912), ((((_e2901.member_2.x * _e2901.member_1.x) + (_e2901.member_2.y * _e2901.member_1.y)) + (_e2901.member_2.z * _e2901.member_1.z)) < 0f));
let _e2925 = (_e2901.member_2.x * _e2924);
let _e2926 = (_e2901.member_2.y * _e2924);
let _e2927 = (_e2901.member_2.z * _e2924);
let _e2936 = ((((_e2925 * _e1197) + (_e2926 * _e1208)) + (_e2927 * _e1219)) > 0f);
let _e2937 = select(_e2925, (_e2901.member_1.x * _e2912), _e2936);
let _e2938 = select(_e2926, (_e2901.member_1.y * _e2912), _e2936);
let _e2939 = select(_e2927, (_e2901.member_1.z * _e2912), _e2936);
let _e2944 = global_1.member.member_19.member_2;
let _e2952 = global_1.member.member_19.member;
let _e2953 = (_e2952 == 0u);
if _e2953 {
let _e2957 = global_1.member.member_19.member_1;
phi_5522_ = type_27(vec3<f32>(_e2957.member, _e2957.member_1, _e2957.member_2), vec3<f32>(_e2944.member, _e2944.member_1, _e2944.member_2));
} else {
let _e2966 = global_1.member.member_19.member_3;
let _e2971 = (_e2901.member.x - _e2966.member);
let _e2973 = (_e2901.member.y - _e2966.member_1);
let _e2975 = (_e2901.member.z - _e2966.member_2);
let _e2980 = (((_e2971 * _e2971) + (_e2973 * _e2973)) + (_e2975 * _e2975));
let _e2982 = select(1e-12f, _e2980, (_e2980 > 1e-12f));
let _e2983 = (1f / _e2982);
let _e2987 = vec3<f32>((_e2944.member * _e2983), (_e2944.member_1 * _e2983), (_e2944.member_2 * _e2983));
if (_e2952 == 2u) {
let _e2992 = global_1.member.member_19.member_1;
let _e3000 = (((_e2992.member * _e2971) + (_e2992.member_1 * _e2973)) + (_e2992.member_2 * _e2975));
let _e3003 = (1f / select(1e-20f, _e3000, (_e3000 > 1e-20f)));
let _e3008 = global_1.member.member_19.member_4.member;
let _e3017 = ((((_e3008.member * _e2971) + (_e3008.member_1 * _e2973)) + (_e3008.member_2 * _e2975)) * _e3003);
let _e3022 = global_1.member.member_19.member_4.member_1;
let _e3031 = ((((_e3022.member * _e2971) + (_e3022.member_1 * _e2973)) + (_e3022.member_2 * _e2975)) * _e3003);
let _e3036 = global_1.member.member_19.member_4.member_2;
let _e3039 = ((_e3017 * _e3017) + (_e3031 * _e3031));
let _e3048 = global_1.member.member_19.member_4.member_3;
let _e3049 = ((_e3036 - sqrt(select(0f, _e3039, (_e3039 > 0f)))) * _e3048);
let _e3051 = select(0f, _e3049, (_e3049 > 0f));
let _e3053 = select(1f, _e3051, (_e3051 < 1f));
let _e3059 = select(0f, ((_e3053 * _e3053) * (3f - (2f * _e3053))), (_e3000 > 0f));
let _e3064 = global_1.member.member_19.member_4.member_5;
if ((_e3064 > 0u) && (_e3059 > 0f)) {
let _e3068 = (0.5f / _e3036);
let _e3078 = global_1.member.member_19.member_4.member_6;
let _e3079 = bitcast<i32>(_e3078);
local_9 = bitcast<i32>(_e3064);
let _e3080 = local_9;
let _e3082 = f32((_e3080 - 1i));
let _e3084 = f32((_e3079 - 1i));
let _e3085 = local_9;
let _e3088 = (((0.5f + (_e3017 * _e3068)) * f32(_e3085)) - 0.5f);
let _e3090 = select(0f, _e3088, (_e3088 > 0f));
let _e3092 = select(_e3082, _e3090, (_e3090 < _e3082));
let _e3095 = (((0.5f - (_e3031 * _e3068)) * f32(_e3079)) - 0.5f);
let _e3097 = select(0f, _e3095, (_e3095 > 0f));
let _e3099 = select(_e3084, _e3097, (_e3097 < _e3084));
let _e3101 = select(0f, _e3092, (_e3092 > 0f));
let _e3103 = select(_e3082, _e3101, (_e3101 < _e3082));
let _e3110 = select(0i, select(select(i32(_e3103), i32(-2147483648), (_e3103 < -2147483600f)), 2147483647i, (_e3103 > 2147483500f)), (_e3103 == _e3103));
let _e3114 = (_e3110 - select(0i, 1i, (_e3103 < f32(_e3110))));
let _e3116 = select(0f, _e3099, (_e3099 > 0f));
let _e3118 = select(_e3084, _e3116, (_e3116 < _e3084));
let _e3125 = select(0i, select(select(i32(_e3118), i32(-2147483648), (_e3118 < -2147483600f)), 2147483647i, (_e3118 > 2147483500f)), (_e3118 == _e3118));
let _e3129 = (_e3125 - select(0i, 1i, (_e3118 < f32(_e3125))));
let _e3131 = (_e3092 - f32(_e3114));
let _e3133 = (_e3099 - f32(_e3129));
let _e3134 = (_e3114 + 1i);
let _e3135 = local_9;
let _e3137 = select(_e3114, _e3134, (_e3134 < _e3135));
let _e3138 = (_e3129 + 1i);
let _e3140 = select(_e3129, _e3138, (_e3138 < _e3079));
let _e3145 = global_1.member.member_19.member_4.member_4;
let _e3146 = bitcast<i32>(_e3145);
let _e3147 = local_9;
let _e3151 = (_e3146 + (3i * ((_e3129 * _e3147) + _e3114)));
let _e3153 = (bitcast<i32>(_e165) - 1i);
let _e3155 = select(_e3153, _e3151, (_e3151 < _e3153));
let _e3160 = global_3.member[bitcast<u32>(select(0i, _e3155, (_e3155 > 0i)))];
let _e3161 = (_e3151 + 1i);
let _e3163 = select(_e3153, _e3161, (_e3161 < _e3153));
let _e3168 = global_3.member[bitcast<u32>(select(0i, _e3163, (_e3163 > 0i)))];
let _e3169 = (_e3151 + 2i);
let _e3171 = select(_e3153, _e3169, (_e3169 < _e3153));
let _e3176 = global_3.member[bitcast<u32>(select(0i, _e3171, (_e3171 > 0i)))];
let _e3177 = local_9;
let _e3181 = (_e3146 + (3i * ((_e3129 * _e3177) + _e3137)));
let _e3183 = select(_e3153, _e3181, (_e3181 < _e3153));
let _e3188 = global_3.member[bitcast<u32>(select(0i, _e3183, (_e3183 > 0i)))];
let _e3189 = (_e3181 + 1i);
let _e3191 = select(_e3153, _e3189, (_e3189 < _e3153));
let _e3196 = global_3.member[bitcast<u32>(select(0i, _e3191, (_e3191 > 0i)))];
let _e3197 = (_e3181 + 2i);
let _e3199 = select(_e3153, _e3197, (_e3197 < _e3153));
let _e3204 = global_3.member[bitcast<u32>(select(0i, _e3199, (_e3199 > 0i)))];
let _e3205 = local_9;
let _e3209 = (_e3146 + (3i * ((_e3140 * _e3205) + _e3114)));
let _e3211 = select(_e3153, _e3209, (_e3209 < _e3153));
let _e3216 = global_3.member[bitcast<u32>(select(0i, _e3211, (_e3211 > 0i)))];
let _e3217 = (_e3209 + 1i);
let _e3219 = select(_e3153, _e3217, (_e3217 < _e3153));
let _e3224 = global_3.member[bitcast<u32>(select(0i, _e3219, (_e3219 > 0i)))];
let _e3225 = (_e3209 + 2i);
let _e3227 = select(_e3153, _e3225, (_e3225 < _e3153));
let _e3232 = global_3.member[bitcast<u32>(select(0i, _e3227, (_e3227 > 0i)))];
let _e3233 = local_9;
let _e3237 = (_e3146 + (3i * ((_e3140 * _e3233) + _e3137)));
let _e3239 = select(_e3153, _e3237, (_e3237 < _e3153));
let _e3244 = global_3.member[bitcast<u32>(select(0i, _e3239, (_e3239 > 0i)))];
let _e3245 = (_e3237 + 1i);
let _e3247 = select(_e3153, _e3245, (_e3245 < _e3153));
let _e3252 = global_3.member[bitcast<u32>(select(0i, _e3247, (_e3247 > 0i)))];
let _e3253 = (_e3237 + 2i);
let _e3255 = select(_e3153, _e3253, (_e3253 < _e3153));
let _e3260 = global_3.member[bitcast<u32>(select(0i, _e3255, (_e3255 > 0i)))];
let _e3267 = (_e3160 + ((_e3188 - _e3160) * _e3131));
let _e3268 = (_e3168 + ((_e3196 - _e3168) * _e3131));
let _e3269 = (_e3176 + ((_e3204 - _e3176) * _e3131));
phi_5506_ = vec3<f32>(((_e3267 + (((_e3216 + ((_e3244 - _e3216) * _e3131)) - _e3267) * _e3133)) * _e3059), ((_e3268 + (((_e3224 + ((_e3252 - _e3224) * _e3131)) - _e3268) * _e3133)) * _e3059), ((_e3269 + (((_e3232 + ((_e3260 - _e3232) * _e3131)) - _e3269) * _e3133)) * _e3059));
} else {
phi_5506_ = vec3(_e3059);
}
let _e3294 = phi_5506_;
phi_5509_ = (_e2987 * _e3294);
} else {
phi_5509_ = _e2987;
}
let _e3297 = phi_5509_;
let _e3301 = (1f / sqrt(select(0f, _e2982, (_e2982 > 0f))));
phi_5522_ = type_27(vec3<f32>((_e2971 * _e3301), (_e2973 * _e3301), (_e2975 * _e3301)), _e3297);
}
let _e3308 = phi_5522_;
let _e3319 = -((((_e2937 * _e3308.member.x) + (_e2938 * _e3308.member.y)) + (_e2939 * _e3308.member.z)));
let _e3324 = (((_e2901.member_1.x * _e3308.member.x) + (_e2901.member_1.y * _e3308.member.y)) + (_e2901.member_1.z * _e3308.member.z));
let _e3329 = -(_e3319);
let _e3334 = select((select(0f, _e3329, (_e3329 > 0f)) * _e2901.member_4), select(0f, _e3319, (_e3319 > 0f)), ((_e3324 * _e2910) > 0f));
let _e3335 = -(_e3324);
let _e3336 = -(_e3335);
let _e3338 = select(_e3336, _e3335, (_e3335 > _e3336));
let _e3344 = global_1.member.member_21.member_6;
let _e3358 = ((((_e3344.member.member * _e2901.member.x) + (_e3344.member.member_1 * _e2901.member.y)) + (_e3344.member.member_2 * _e2901.member.z)) + _e3344.member_1);
let _e3360 = select(1f, _e3358, (_e3358 > 1e-6f));
let _e3364 = global_1.member.member_21.member_4;
let _e3376 = (((((_e3364.member.member * _e2901.member.x) + (_e3364.member.member_1 * _e2901.member.y)) + (_e3364.member.member_2 * _e2901.member.z)) + _e3364.member_1) / _e3360);
let _e3380 = global_1.member.member_21.member_5;
let _e3392 = (((((_e3380.member.member * _e2901.member.x) + (_e3380.member.member_1 * _e2901.member.y)) + (_e3380.member.member_2 * _e2901.member.z)) + _e3380.member_1) / _e3360);
let _e3396 = global_1.member.member_21.member_2;
let _e3405 = -((((_e2901.member_1.x * _e3396.member) + (_e2901.member_1.y * _e3396.member_1)) + (_e2901.member_1.z * _e3396.member_2)));
let _e3406 = -(_e3405);
let _e3408 = select(_e3406, _e3405, (_e3405 > _e3406));
let _e3410 = select(1f, _e3408, (_e3408 < 1f));
let _e3412 = (1f - (_e3410 * _e3410));
let _e3419 = global_1.member.member_21.member_8;
let _e3420 = (1.4142135f * _e3419);
let _e3427 = global_1.member.member_21.member_7.member;
let _e3432 = global_1.member.member_21.member_7.member_2;
let _e3434 = (_e3427 + (_e3432 * _e3376));
let _e3439 = global_1.member.member_21.member_7.member_1;
let _e3441 = (_e3439 + (_e3432 * _e3392));
let _e3445 = ((1f + (_e3434 * _e3434)) + (_e3441 * _e3441));
let _e3454 = global_1.member.member_21.member_9;
let _e3458 = (select(1f, -1f, (_e3335 < 0f)) * ((((_e3420 * sqrt(select(0f, _e3412, (_e3412 > 0f)))) * _e3358) + (select(1f, _e3338, (_e3338 < 1f)) * sqrt(select(0f, _e3445, (_e3445 > 0f))))) * _e3454));
let _e3463 = select(0f, 1f, _e2901.member_5);
let _e3467 = (_e2901.member.x + ((_e2901.member_1.x * _e3458) * _e3463));
let _e3468 = (_e2901.member.y + ((_e2901.member_1.y * _e3458) * _e3463));
let _e3469 = (_e2901.member.z + ((_e2901.member_1.z * _e3458) * _e3463));
let _e3473 = global_1.member.member_21.member_11;
let _e3474 = bitcast<i32>(_e3473);
let _e3478 = global_1.member.member_21.member_1;
let _e3479 = bitcast<i32>(_e3478);
let _e3484 = global_1.member.member_21.member.member_1;
let _e3485 = bitcast<i32>(_e3484);
let _e3490 = global_1.member.member_21.member.member_2;
let _e3491 = bitcast<i32>(_e3490);
let _e3497 = ((((_e3344.member.member * _e3467) + (_e3344.member.member_1 * _e3468)) + (_e3344.member.member_2 * _e3469)) + _e3344.member_1);
let _e3499 = select(1f, _e3497, (_e3497 > 1e-6f));
let _e3503 = global_1.member.member_21.member_3;
let _e3514 = ((((_e3503.member.member * _e3467) + (_e3503.member.member_1 * _e3468)) + (_e3503.member.member_2 * _e3469)) + _e3503.member_1);
let _e3529 = ((((((_e3364.member.member * _e3467) + (_e3364.member.member_1 * _e3468)) + (_e3364.member.member_2 * _e3469)) + _e3364.member_1) / _e3499) - 0.5f);
let _e3530 = ((((((_e3380.member.member * _e3467) + (_e3380.member.member_1 * _e3468)) + (_e3380.member.member_2 * _e3469)) + _e3380.member_1) / _e3499) - 0.5f);
let _e3534 = global_1.member.member_21.member_10;
let _e3535 = (_e3534 > 0f);
if (_e3535 && (_e3479 > 0i)) {
let _e3542 = global_1.member.member_21.member.member;
let _e3549 = (_e3534 * select(0f, _e3514, (_e3514 > 0f)));
let _e3550 = (16f - 1f);
let _e3554 = (select(_e3550, _e3549, (_e3549 < _e3550)) * (1f / 3f));
phi_5865_ = -3i;
phi_5868_ = -3i;
phi_5870_ = 0f;
phi_5872_ = 0f;
loop {
let _e3556 = phi_5865_;
let _e3558 = phi_5868_;
let _e3560 = phi_5870_;
let _e3562 = phi_5872_;
local_83 = _e3562;
local_84 = _e3562;
local_85 = _e3562;
local_86 = _e3560;
let _e3563 = (_e3556 <= 3i);
if _e3563 {
let _e3565 = (f32(_e3558) * _e3554);
let _e3567 = (f32(_e3556) * _e3554);
let _e3569 = ((_e3529 + _e3565) + 0.5f);
let _e3570 = f32(_e3485);
let _e3572 = select(-1f, _e3569, (_e3569 > -1f));
let _e3574 = select(_e3570, _e3572, (_e3572 < _e3570));
let _e3581 = select(0i, select(select(i32(_e3574), i32(-2147483648), (_e3574 < -2147483600f)), 2147483647i, (_e3574 > 2147483500f)), (_e3574 == _e3574));
let _e3585 = (_e3581 - select(0i, 1i, (_e3574 < f32(_e3581))));
let _e3587 = ((_e3530 + _e3567) + 0.5f);
let _e3588 = f32(_e3491);
let _e3590 = select(-1f, _e3587, (_e3587 > -1f));
let _e3592 = select(_e3588, _e3590, (_e3590 < _e3588));
let _e3599 = select(0i, select(select(i32(_e3592), i32(-2147483648), (_e3592 < -2147483600f)), 2147483647i, (_e3592 > 2147483500f)), (_e3592 == _e3592));
let _e3603 = (_e3599 - select(0i, 1i, (_e3592 < f32(_e3599))));
let _e3610 = ((((_e3585 >= 0i) && (_e3585 < _e3485)) && (_e3603 >= 0i)) && (_e3603 < _e3491));
if _e3610 {
phi_5948_ = ((_e3603 * _e3485) + _e3585);
} else {
phi_5948_ = 0i;
}
let _e3614 = phi_5948_;
let _e3619 = ((_e3565 * _e3565) + (_e3567 * _e3567));
let _e3623 = (sqrt(select(0f, _e3619, (_e3619 > 0f))) - _e3420);
let _e3626 = (1.2247449f * _e3534);
let _e3631 = (_e3514 - select(0f, (select(0f, _e3623, (_e3623 > 0f)) / select(1e-6f, _e3626, (_e3626 > 1e-6f))), _e3535));
let _e3633 = f32(bitcast<i32>(_e3542));
let _e3634 = (_e3633 - 1f);
let _e3636 = select(0f, _e3631, (_e3631 > 0f));
let _e3638 = select(_e3634, _e3636, (_e3636 < _e3634));
let _e3645 = select(0i, select(select(i32(_e3638), i32(-2147483648), (_e3638 < -2147483600f)), 2147483647i, (_e3638 > 2147483500f)), (_e3638 == _e3638));
let _e3649 = (_e3645 - select(0i, 1i, (_e3638 < f32(_e3645))));
let _e3652 = (_e3631 - f32(_e3649));
let _e3656 = (4i * (_e3474 + (_e3614 * bitcast<i32>(((_e3542 + 2u) >> bitcast<u32>(1i))))));
let _e3658 = (_e3656 + (2i * _e3649));
let _e3660 = (_e3658 >> bitcast<u32>(2i));
let _e3663 = bitcast<u32>(((_e3658 & 3i) * 8i));
let _e3665 = (bitcast<i32>(_e171) - 1i);
let _e3667 = select(_e3665, _e3660, (_e3660 < _e3665));
let _e3673 = global_6.member[bitcast<u32>(select(0i, _e3667, (_e3667 > 0i)))];
let _e3677 = (_e3660 + 1i);
let _e3679 = select(_e3665, _e3677, (_e3677 < _e3665));
let _e3685 = global_6.member[bitcast<u32>(select(0i, _e3679, (_e3679 > 0i)))];
let _e3692 = ((_e3673 >> bitcast<u32>((_e3663 & 31u))) | ((_e3685 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3663) & 31u))));
let _e3695 = f32(bitcast<i32>((_e3692 & 65535u)));
let _e3703 = (1f / 65535f);
let _e3706 = select(0f, (1f - ((_e3695 + ((f32(bitcast<i32>((_e3692 >> bitcast<u32>(16i)))) - _e3695) * select(1f, select(0f, _e3652, (_e3652 > 0f)), (_e3631 < _e3633)))) * _e3703)), _e3610);
if (_e3706 > 1e-4f) {
phi_6097_ = 0i;
phi_6100_ = _e3636;
phi_6102_ = 0f;
loop {
let _e3709 = phi_6097_;
let _e3711 = phi_6100_;
let _e3713 = phi_6102_;
local_82 = _e3711;
let _e3714 = (_e3709 < 10i);
if _e3714 {
let _e3716 = (0.5f * (_e3713 + _e3711));
let _e3718 = select(0f, _e3716, (_e3716 > 0f));
let _e3720 = select(_e3634, _e3718, (_e3718 < _e3634));
let _e3727 = select(0i, select(select(i32(_e3720), i32(-2147483648), (_e3720 < -2147483600f)), 2147483647i, (_e3720 > 2147483500f)), (_e3720 == _e3720));
let _e3731 = (_e3727 - select(0i, 1i, (_e3720 < f32(_e3727))));
let _e3734 = (_e3716 - f32(_e3731));
let _e3739 = (_e3656 + (2i * _e3731));
let _e3741 = (_e3739 >> bitcast<u32>(2i));
let _e3744 = bitcast<u32>(((_e3739 & 3i) * 8i));
let _e3746 = select(_e3665, _e3741, (_e3741 < _e3665));
let _e3752 = global_6.member[bitcast<u32>(select(0i, _e3746, (_e3746 > 0i)))];
let _e3756 = (_e3741 + 1i);
let _e3758 = select(_e3665, _e3756, (_e3756 < _e3665));
let _e3764 = global_6.member[bitcast<u32>(select(0i, _e3758, (_e3758 > 0i)))];
let _e3771 = ((_e3752 >> bitcast<u32>((_e3744 & 31u))) | ((_e3764 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3744) & 31u))));
let _e3774 = f32(bitcast<i32>((_e3771 & 65535u)));
let _e3785 = (((_e3774 + ((f32(bitcast<i32>((_e3771 >> bitcast<u32>(16i)))) - _e3774) * select(1f, select(0f, _e3734, (_e3734 > 0f)), (_e3716 < _e3633)))) * _e3703) > (1f - (0.5f * _e3706)));
phi_6098_ = (_e3709 + 1i);
phi_6101_ = select(_e3716, _e3711, _e3785);
phi_6103_ = select(_e3713, _e3716, _e3785);
} else {
phi_6098_ = i32();
phi_6101_ = f32();
phi_6103_ = f32();
}
let _e3790 = phi_6098_;
let _e3792 = phi_6101_;
let _e3794 = phi_6103_;
continue;
continuing {
phi_6097_ = _e3790;
phi_6100_ = _e3792;
phi_6102_ = _e3794;
break if !(_e3714);
}
}
let _e3798 = local_82;
phi_6223_ = (_e3560 + (_e3706 * _e3798));
phi_6224_ = (_e3562 + _e3706);
} else {
phi_6223_ = _e3560;
phi_6224_ = _e3562;
}
let _e3802 = phi_6223_;
let _e3804 = phi_6224_;
let _e3805 = (_e3558 == 3i);
if _e3805 {
phi_6230_ = -3i;
} else {
phi_6230_ = (_e3558 + 1i);
}
let _e3808 = phi_6230_;
phi_5866_ = (_e3556 + select(0i, 1i, _e3805));
phi_5869_ = _e3808;
phi_5871_ = _e3802;
phi_5873_ = _e3804;
} else {
phi_5866_ = i32();
phi_5869_ = i32();
phi_5871_ = f32();
phi_5873_ = f32();
}
let _e3812 = phi_5866_;
let _e3814 = phi_5869_;
let _e3816 = phi_5871_;
let _e3818 = phi_5873_;
continue;
continuing {
phi_5865_ = _e3812;
phi_5868_ = _e3814;
phi_5870_ = _e3816;
phi_5872_ = _e3818;
break if !(_e3563);
}
}
let _e3821 = local_83;
let _e3824 = local_84;
let _e3827 = local_85;
let _e3830 = local_86;
let _e3832 = (_e3514 - (_e3830 / select(1e-4f, _e3827, (_e3824 > 1e-4f))));
let _e3837 = ((1.2247449f * _e3534) * select(0f, select(0f, _e3832, (_e3832 > 0f)), (_e3821 > 0f)));
let _e3840 = ((_e3419 * _e3419) + (_e3837 * _e3837));
let _e3843 = sqrt(select(0f, _e3840, (_e3840 > 0f)));
phi_6274_ = select(16f, _e3843, (_e3843 < 16f));
} else {
phi_6274_ = _e3419;
}
let _e3847 = phi_6274_;
let _e3848 = (_e3529 - _e3847);
let _e3849 = -(16f);
let _e3850 = f32(_e3485);
let _e3852 = select(_e3849, _e3848, (_e3848 > _e3849));
let _e3854 = select(_e3850, _e3852, (_e3852 < _e3850));
let _e3861 = select(0i, select(select(i32(_e3854), i32(-2147483648), (_e3854 < -2147483600f)), 2147483647i, (_e3854 > 2147483500f)), (_e3854 == _e3854));
let _e3867 = (_e3529 + _e3847);
let _e3870 = (f32((_e3485 - 1i)) + 16f);
let _e3872 = select(-1f, _e3867, (_e3867 > -1f));
let _e3874 = select(_e3870, _e3872, (_e3872 < _e3870));
let _e3881 = select(0i, select(select(i32(_e3874), i32(-2147483648), (_e3874 < -2147483600f)), 2147483647i, (_e3874 > 2147483500f)), (_e3874 == _e3874));
let _e3886 = (_e3530 - _e3847);
let _e3887 = f32(_e3491);
let _e3889 = select(_e3849, _e3886, (_e3886 > _e3849));
let _e3891 = select(_e3887, _e3889, (_e3889 < _e3887));
let _e3898 = select(0i, select(select(i32(_e3891), i32(-2147483648), (_e3891 < -2147483600f)), 2147483647i, (_e3891 > 2147483500f)), (_e3891 == _e3891));
let _e3904 = (_e3530 + _e3847);
let _e3907 = (f32((_e3491 - 1i)) + 16f);
let _e3909 = select(-1f, _e3904, (_e3904 > -1f));
let _e3911 = select(_e3907, _e3909, (_e3909 < _e3907));
let _e3918 = select(0i, select(select(i32(_e3911), i32(-2147483648), (_e3911 < -2147483600f)), 2147483647i, (_e3911 > 2147483500f)), (_e3911 == _e3911));
let _e3927 = global_1.member.member_21.member.member;
let _e3931 = bitcast<i32>(((_e3927 + 2u) >> bitcast<u32>(1i)));
let _e3933 = ((_e3485 * _e3491) * _e3931);
phi_6392_ = 0f;
phi_6395_ = vec3<f32>(0f, 0f, 0f);
phi_6397_ = ((_e3898 - select(0i, 1i, (_e3891 < f32(_e3898)))) + 1i);
loop {
let _e3935 = phi_6392_;
let _e3937 = phi_6395_;
let _e3939 = phi_6397_;
local_87 = _e3935;
local_88 = _e3935;
local_89 = _e3937;
local_90 = _e3937;
local_91 = _e3937;
let _e3940 = (_e3939 <= (_e3918 - select(0i, 1i, (_e3911 < f32(_e3918)))));
if _e3940 {
let _e3942 = (f32(_e3939) - _e3530);
let _e3946 = (_e3847 - bitcast<f32>((bitcast<u32>(_e3942) & 2147483647u)));
phi_6412_ = ((_e3861 - select(0i, 1i, (_e3854 < f32(_e3861)))) + 1i);
phi_6415_ = _e3935;
phi_6417_ = _e3937;
loop {
let _e3948 = phi_6412_;
let _e3950 = phi_6415_;
let _e3952 = phi_6417_;
local_154 = _e3950;
local_155 = _e3952;
let _e3953 = (_e3948 <= (_e3881 - select(0i, 1i, (_e3874 < f32(_e3881)))));
if _e3953 {
let _e3955 = (f32(_e3948) - _e3529);
let _e3959 = (_e3847 - bitcast<f32>((bitcast<u32>(_e3955) & 2147483647u)));
let _e3964 = (select(0f, _e3959, (_e3959 > 0f)) * select(0f, _e3946, (_e3946 > 0f)));
if ((((_e3948 >= 0i) && (_e3948 < _e3485)) && (_e3939 >= 0i)) && (_e3939 < _e3491)) {
let _e3975 = (_e3474 + (((_e3939 * _e3485) + _e3948) * _e3931));
let _e3978 = ((_e3955 * _e3955) + (_e3942 * _e3942));
let _e3982 = (sqrt(select(0f, _e3978, (_e3978 > 0f))) - _e3420);
let _e3985 = (1.2247449f * _e3534);
let _e3990 = (_e3514 - select(0f, (select(0f, _e3982, (_e3982 > 0f)) / select(1e-6f, _e3985, (_e3985 > 1e-6f))), _e3535));
let _e3992 = f32(bitcast<i32>(_e3927));
let _e3993 = (_e3992 - 1f);
let _e3995 = select(0f, _e3990, (_e3990 > 0f));
let _e3997 = select(_e3993, _e3995, (_e3995 < _e3993));
let _e4004 = select(0i, select(select(i32(_e3997), i32(-2147483648), (_e3997 < -2147483600f)), 2147483647i, (_e3997 > 2147483500f)), (_e3997 == _e3997));
let _e4008 = (_e4004 - select(0i, 1i, (_e3997 < f32(_e4004))));
let _e4011 = (_e3990 - f32(_e4008));
let _e4014 = select(1f, select(0f, _e4011, (_e4011 > 0f)), (_e3990 < _e3992));
let _e4016 = (2i * _e4008);
let _e4017 = ((4i * _e3975) + _e4016);
let _e4019 = (_e4017 >> bitcast<u32>(2i));
let _e4022 = bitcast<u32>(((_e4017 & 3i) * 8i));
let _e4024 = (bitcast<i32>(_e171) - 1i);
let _e4026 = select(_e4024, _e4019, (_e4019 < _e4024));
let _e4032 = global_6.member[bitcast<u32>(select(0i, _e4026, (_e4026 > 0i)))];
let _e4036 = (_e4019 + 1i);
let _e4038 = select(_e4024, _e4036, (_e4036 < _e4024));
let _e4044 = global_6.member[bitcast<u32>(select(0i, _e4038, (_e4038 > 0i)))];
let _e4051 = ((_e4032 >> bitcast<u32>((_e4022 & 31u))) | ((_e4044 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4022) & 31u))));
let _e4054 = f32(bitcast<i32>((_e4051 & 65535u)));
let _e4062 = (1f / 65535f);
let _e4064 = (_e3964 * ((_e4054 + ((f32(bitcast<i32>((_e4051 >> bitcast<u32>(16i)))) - _e4054) * _e4014)) * _e4062));
let _e4066 = (_e3952.x + _e4064);
if (_e3479 > 1i) {
let _e4070 = ((4i * (_e3975 + _e3933)) + _e4016);
let _e4072 = (_e4070 >> bitcast<u32>(2i));
let _e4075 = bitcast<u32>(((_e4070 & 3i) * 8i));
let _e4077 = select(_e4024, _e4072, (_e4072 < _e4024));
let _e4083 = global_6.member[bitcast<u32>(select(0i, _e4077, (_e4077 > 0i)))];
let _e4087 = (_e4072 + 1i);
let _e4089 = select(_e4024, _e4087, (_e4087 < _e4024));
let _e4095 = global_6.member[bitcast<u32>(select(0i, _e4089, (_e4089 > 0i)))];
let _e4102 = ((_e4083 >> bitcast<u32>((_e4075 & 31u))) | ((_e4095 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4075) & 31u))));
let _e4105 = f32(bitcast<i32>((_e4102 & 65535u)));
let _e4120 = ((4i * (_e3975 + (2i * _e3933))) + _e4016);
let _e4122 = (_e4120 >> bitcast<u32>(2i));
let _e4125 = bitcast<u32>(((_e4120 & 3i) * 8i));
let _e4127 = select(_e4024, _e4122, (_e4122 < _e4024));
let _e4133 = global_6.member[bitcast<u32>(select(0i, _e4127, (_e4127 > 0i)))];
let _e4137 = (_e4122 + 1i);
let _e4139 = select(_e4024, _e4137, (_e4137 < _e4024));
let _e4145 = global_6.member[bitcast<u32>(select(0i, _e4139, (_e4139 > 0i)))];
let _e4152 = ((_e4133 >> bitcast<u32>((_e4125 & 31u))) | ((_e4145 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4125) & 31u))));
let _e4155 = f32(bitcast<i32>((_e4152 & 65535u)));
phi_6806_ = vec3<f32>(_e4066, (_e3952.y + (_e3964 * ((_e4105 + ((f32(bitcast<i32>((_e4102 >> bitcast<u32>(16i)))) - _e4105) * _e4014)) * _e4062))), (_e3952.z + (_e3964 * ((_e4155 + ((f32(bitcast<i32>((_e4152 >> bitcast<u32>(16i)))) - _e4155) * _e4014)) * _e4062))));
} else {
phi_6806_ = vec3<f32>(_e4066, (_e3952.y + _e4064), (_e3952.z + _e4064));
}
let _e4174 = phi_6806_;
phi_6816_ = _e4174;
} else {
phi_6816_ = vec3<f32>((_e3952.x + _e3964), (_e3952.y + _e3964), (_e3952.z + _e3964));
}
let _e4183 = phi_6816_;
phi_6413_ = (_e3948 + 1i);
phi_6416_ = (_e3950 + _e3964);
phi_6418_ = _e4183;
} else {
phi_6413_ = i32();
phi_6416_ = f32();
phi_6418_ = vec3<f32>();
}
let _e4187 = phi_6413_;
let _e4189 = phi_6416_;
let _e4191 = phi_6418_;
continue;
continuing {
phi_6412_ = _e4187;
phi_6415_ = _e4189;
phi_6417_ = _e4191;
break if !(_e3953);
}
}
let _e10371 = local_154;
phi_6393_ = _e10371;
let _e10374 = local_155;
phi_6396_ = _e10374;
phi_6398_ = (_e3939 + 1i);
} else {
phi_6393_ = f32();
phi_6396_ = vec3<f32>();
phi_6398_ = i32();
}
let _e4195 = phi_6393_;
let _e4197 = phi_6396_;
let _e4199 = phi_6398_;
continue;
continuing {
phi_6392_ = _e4195;
phi_6395_ = _e4197;
phi_6397_ = _e4199;
break if !(_e3940);
}
}
let _e4203 = local_87;
let _e4207 = (((_e3479 == 0i) || (_e4203 <= 0f)) || (_e3497 <= 1e-6f));
let _e4209 = local_88;
let _e4211 = (1f / select(_e4209, 1f, _e4207));
let _e4213 = local_89;
let _e4218 = local_90;
let _e4223 = local_91;
let _e4227 = (select((_e4213.x * _e4211), 1f, _e4207) * _e3334);
let _e4228 = (select((_e4218.y * _e4211), 1f, _e4207) * _e3334);
let _e4229 = (select((_e4223.z * _e4211), 1f, _e4207) * _e3334);
let _e4240 = global_1.member.member_1;
if ((_e4240 & 16u) == 0u) {
phi_8719_ = (_e3308.member_1 * vec3<f32>(_e4227, _e4228, _e4229));
} else {
let _e4246 = global_1.member.member_22.member;
let _e4257 = ((((_e4246.member.member * _e2901.member.x) + (_e4246.member.member_1 * _e2901.member.y)) + (_e4246.member.member_2 * _e2901.member.z)) + _e4246.member_1);
let _e4261 = global_1.member.member_22.member_1;
let _e4272 = ((((_e4261.member.member * _e2901.member.x) + (_e4261.member.member_1 * _e2901.member.y)) + (_e4261.member.member_2 * _e2901.member.z)) + _e4261.member_1);
let _e4276 = global_1.member.member_22.member_2;
let _e4287 = ((((_e4276.member.member * _e2901.member.x) + (_e4276.member.member_1 * _e2901.member.y)) + (_e4276.member.member_2 * _e2901.member.z)) + _e4276.member_1);
let _e4294 = global_1.member.member_22.member_18.member.member;
let _e4295 = bitcast<i32>(_e4294);
let _e4301 = global_1.member.member_22.member_18.member.member_1;
let _e4302 = bitcast<i32>(_e4301);
let _e4306 = global_1.member.member_22.member_3;
let _e4315 = global_1.member.member_22.member_19.member_2;
let _e4317 = select(1f, (_e4287 - _e4315), (_e4306 != 0u));
let _e4320 = (1f / select(1e-12f, _e4317, (_e4317 > 1e-12f)));
let _e4325 = global_1.member.member_22.member_5;
let _e4330 = global_1.member.member_22.member_8;
let _e4331 = (((_e4257 * _e4320) - _e4325) * _e4330);
let _e4336 = global_1.member.member_22.member_6;
let _e4338 = (((_e4272 * _e4320) - _e4336) * _e4330);
let _e4343 = global_1.member.member_22.member_4.member;
let _e4345 = f32(bitcast<i32>(_e4343));
let _e4347 = select(0f, _e4331, (_e4331 > 0f));
let _e4354 = global_1.member.member_22.member_18.member_1;
let _e4357 = ((_e4331 - _e4345) * _e4354);
let _e4362 = global_1.member.member_22.member_18.member_2;
let _e4364 = select(0f, _e4357, (_e4357 > 0f));
let _e4366 = (_e4362 + _e4364);
let _e4371 = (-(_e4331) * _e4354);
let _e4373 = select(0f, _e4371, (_e4371 > 0f));
let _e4375 = (_e4362 + _e4373);
let _e4382 = (((_e4362 + (select(_e4345, _e4347, (_e4347 < _e4345)) * _e4354)) + (((_e4364 * _e4362) / select(1e-12f, _e4366, (_e4366 > 1e-12f))) - ((_e4373 * _e4362) / select(1e-12f, _e4375, (_e4375 > 1e-12f))))) - 0.5f);
let _e4387 = global_1.member.member_22.member_4.member_1;
let _e4389 = f32(bitcast<i32>(_e4387));
let _e4391 = select(0f, _e4338, (_e4338 > 0f));
let _e4396 = ((_e4338 - _e4389) * _e4354);
let _e4398 = select(0f, _e4396, (_e4396 > 0f));
let _e4400 = (_e4362 + _e4398);
let _e4405 = (-(_e4338) * _e4354);
let _e4407 = select(0f, _e4405, (_e4405 > 0f));
let _e4409 = (_e4362 + _e4407);
let _e4416 = (((_e4362 + (select(_e4389, _e4391, (_e4391 < _e4389)) * _e4354)) + (((_e4398 * _e4362) / select(1e-12f, _e4400, (_e4400 > 1e-12f))) - ((_e4407 * _e4362) / select(1e-12f, _e4409, (_e4409 > 1e-12f))))) - 0.5f);
let _e4418 = f32((_e4295 - 2i));
let _e4420 = select(0f, _e4382, (_e4382 > 0f));
let _e4422 = select(_e4418, _e4420, (_e4420 < _e4418));
let _e4429 = select(0i, select(select(i32(_e4422), i32(-2147483648), (_e4422 < -2147483600f)), 2147483647i, (_e4422 > 2147483500f)), (_e4422 == _e4422));
let _e4433 = (_e4429 - select(0i, 1i, (_e4422 < f32(_e4429))));
let _e4435 = f32((_e4302 - 2i));
let _e4437 = select(0f, _e4416, (_e4416 > 0f));
let _e4439 = select(_e4435, _e4437, (_e4437 < _e4435));
let _e4446 = select(0i, select(select(i32(_e4439), i32(-2147483648), (_e4439 < -2147483600f)), 2147483647i, (_e4439 > 2147483500f)), (_e4439 == _e4439));
let _e4450 = (_e4446 - select(0i, 1i, (_e4439 < f32(_e4446))));
let _e4452 = (_e4382 - f32(_e4433));
let _e4454 = select(0f, _e4452, (_e4452 > 0f));
let _e4456 = select(1f, _e4454, (_e4454 < 1f));
let _e4458 = (_e4416 - f32(_e4450));
let _e4460 = select(0f, _e4458, (_e4458 > 0f));
let _e4462 = select(1f, _e4460, (_e4460 < 1f));
if _e2901.member_6 {
let _e4467 = global_1.member.member_22.member_18.member_4;
phi_7177_ = _e4467;
} else {
let _e4472 = global_1.member.member_22.member_18.member_3;
phi_7177_ = _e4472;
}
let _e4474 = phi_7177_;
let _e4478 = ((bitcast<i32>(_e4474) + (_e4450 * _e4295)) + _e4433);
let _e4479 = (_e4295 * _e4302);
let _e4481 = (bitcast<i32>(_e171) - 1i);
let _e4483 = select(_e4481, _e4478, (_e4478 < _e4481));
let _e4489 = global_6.member[bitcast<u32>(select(0i, _e4483, (_e4483 > 0i)))];
let _e4490 = bitcast<f32>(_e4489);
let _e4491 = (_e4478 + 1i);
let _e4493 = select(_e4481, _e4491, (_e4491 < _e4481));
let _e4499 = global_6.member[bitcast<u32>(select(0i, _e4493, (_e4493 > 0i)))];
let _e4503 = (_e4490 + ((bitcast<f32>(_e4499) - _e4490) * _e4456));
let _e4504 = (_e4478 + _e4295);
let _e4506 = select(_e4481, _e4504, (_e4504 < _e4481));
let _e4512 = global_6.member[bitcast<u32>(select(0i, _e4506, (_e4506 > 0i)))];
let _e4513 = bitcast<f32>(_e4512);
let _e4514 = (_e4504 + 1i);
let _e4516 = select(_e4481, _e4514, (_e4514 < _e4481));
let _e4522 = global_6.member[bitcast<u32>(select(0i, _e4516, (_e4516 > 0i)))];
let _e4529 = (_e4503 + (((_e4513 + ((bitcast<f32>(_e4522) - _e4513) * _e4456)) - _e4503) * _e4462));
let _e4530 = (_e4478 + _e4479);
let _e4532 = select(_e4481, _e4530, (_e4530 < _e4481));
let _e4538 = global_6.member[bitcast<u32>(select(0i, _e4532, (_e4532 > 0i)))];
let _e4539 = bitcast<f32>(_e4538);
let _e4540 = (_e4530 + 1i);
let _e4542 = select(_e4481, _e4540, (_e4540 < _e4481));
let _e4548 = global_6.member[bitcast<u32>(select(0i, _e4542, (_e4542 > 0i)))];
let _e4552 = (_e4539 + ((bitcast<f32>(_e4548) - _e4539) * _e4456));
let _e4553 = (_e4530 + _e4295);
let _e4555 = select(_e4481, _e4553, (_e4553 < _e4481));
let _e4561 = global_6.member[bitcast<u32>(select(0i, _e4555, (_e4555 > 0i)))];
let _e4562 = bitcast<f32>(_e4561);
let _e4563 = (_e4553 + 1i);
let _e4565 = select(_e4481, _e4563, (_e4563 < _e4481));
let _e4571 = global_6.member[bitcast<u32>(select(0i, _e4565, (_e4565 > 0i)))];
let _e4578 = (_e4552 + (((_e4562 + ((bitcast<f32>(_e4571) - _e4562) * _e4456)) - _e4552) * _e4462));
let _e4580 = (_e4478 + (2i * _e4479));
let _e4582 = select(_e4481, _e4580, (_e4580 < _e4481));
let _e4588 = global_6.member[bitcast<u32>(select(0i, _e4582, (_e4582 > 0i)))];
let _e4589 = bitcast<f32>(_e4588);
let _e4590 = (_e4580 + 1i);
let _e4592 = select(_e4481, _e4590, (_e4590 < _e4481));
let _e4598 = global_6.member[bitcast<u32>(select(0i, _e4592, (_e4592 > 0i)))];
let _e4602 = (_e4589 + ((bitcast<f32>(_e4598) - _e4589) * _e4456));
let _e4603 = (_e4580 + _e4295);
let _e4605 = select(_e4481, _e4603, (_e4603 < _e4481));
let _e4611 = global_6.member[bitcast<u32>(select(0i, _e4605, (_e4605 > 0i)))];
let _e4612 = bitcast<f32>(_e4611);
let _e4613 = (_e4603 + 1i);
let _e4615 = select(_e4481, _e4613, (_e4613 < _e4481));
let _e4621 = global_6.member[bitcast<u32>(select(0i, _e4615, (_e4615 > 0i)))];
let _e4628 = (_e4602 + (((_e4612 + ((bitcast<f32>(_e4621) - _e4612) * _e4456)) - _e4602) * _e4462));
let _e4630 = (_e4306 == 0u);
if _e4630 {
phi_7545_ = vec3<f32>(_e4529, _e4578, _e4628);
} else {
if _e4630 {
phi_7513_ = 1f;
} else {
let _e4631 = global_1.member.member_22.member_19;
let _e4635 = (_e4257 - _e4631.member);
let _e4636 = (_e4272 - _e4631.member_1);
let _e4637 = (_e4287 - _e4631.member_2);
let _e4642 = global_1.member.member_22.member_20.member;
let _e4650 = (((_e4642.member * _e4635) + (_e4642.member_1 * _e4636)) + (_e4642.member_2 * _e4637));
let _e4654 = (_e4635 - (_e4642.member * _e4650));
let _e4655 = (_e4636 - (_e4642.member_1 * _e4650));
let _e4656 = (_e4637 - (_e4642.member_2 * _e4650));
let _e4661 = (((_e4654 * _e4654) + (_e4655 * _e4655)) + (_e4656 * _e4656));
let _e4672 = global_1.member.member_22.member_20.member_1;
let _e4678 = global_1.member.member_22.member_20.member_2;
let _e4679 = ((_e4672 - (sqrt(select(0f, _e4661, (_e4661 > 0f))) / select(1e-20f, _e4650, (_e4650 > 1e-20f)))) * _e4678);
let _e4681 = select(0f, _e4679, (_e4679 > 0f));
let _e4683 = select(1f, _e4681, (_e4681 < 1f));
phi_7513_ = select(1f, select(0f, ((_e4683 * _e4683) * (3f - (2f * _e4683))), (_e4650 > 0f)), (_e4678 > 0f));
}
let _e4693 = phi_7513_;
let _e4694 = global_1.member.member_22.member_19;
let _e4698 = select(0f, 1f, ((_e4287 - _e4694.member_2) > 0f));
let _e4702 = ((_e4529 * _e4698) + _e4693);
let _e4703 = ((_e4578 * _e4698) + _e4693);
let _e4704 = ((_e4628 * _e4698) + _e4693);
phi_7545_ = vec3<f32>(select(0f, _e4702, (_e4702 > 0f)), select(0f, _e4703, (_e4703 > 0f)), select(0f, _e4704, (_e4704 > 0f)));
}
let _e4713 = phi_7545_;
let _e4717 = global_1.member.member_19.member_3;
let _e4721 = (_e2901.member.x - _e4717.member);
let _e4722 = (_e2901.member.y - _e4717.member_1);
let _e4723 = (_e2901.member.z - _e4717.member_2);
let _e4728 = (((_e4721 * _e4721) + (_e4722 * _e4722)) + (_e4723 * _e4723));
let _e4732 = select((1f / select(1e-12f, _e4728, (_e4728 > 1e-12f))), 1f, _e2953);
let _e4745 = global_1.member.member_21.member_12;
let _e4746 = bitcast<i32>(_e4745);
let _e4750 = global_1.member.member_21.member_13;
let _e4751 = bitcast<i32>(_e4750);
let _e4757 = ((((_e3503.member.member * _e2901.member.x) + (_e3503.member.member_1 * _e2901.member.y)) + (_e3503.member.member_2 * _e2901.member.z)) + _e3503.member_1);
let _e4758 = (_e3376 - 0.5f);
let _e4759 = (_e3392 - 0.5f);
if (_e3535 && (_e4751 > 0i)) {
let _e4764 = (_e3534 * select(0f, _e4757, (_e4757 > 0f)));
let _e4765 = (16f - 1f);
let _e4769 = (select(_e4765, _e4764, (_e4764 < _e4765)) * (1f / 3f));
phi_7717_ = -3i;
phi_7720_ = -3i;
phi_7722_ = 0f;
phi_7724_ = 0f;
loop {
let _e4771 = phi_7717_;
let _e4773 = phi_7720_;
let _e4775 = phi_7722_;
let _e4777 = phi_7724_;
local_93 = _e4777;
local_94 = _e4777;
local_95 = _e4777;
local_96 = _e4775;
let _e4778 = (_e4771 <= 3i);
if _e4778 {
let _e4780 = (f32(_e4773) * _e4769);
let _e4782 = (f32(_e4771) * _e4769);
let _e4784 = ((_e4758 + _e4780) + 0.5f);
let _e4786 = select(-1f, _e4784, (_e4784 > -1f));
let _e4788 = select(_e3850, _e4786, (_e4786 < _e3850));
let _e4795 = select(0i, select(select(i32(_e4788), i32(-2147483648), (_e4788 < -2147483600f)), 2147483647i, (_e4788 > 2147483500f)), (_e4788 == _e4788));
let _e4799 = (_e4795 - select(0i, 1i, (_e4788 < f32(_e4795))));
let _e4801 = ((_e4759 + _e4782) + 0.5f);
let _e4803 = select(-1f, _e4801, (_e4801 > -1f));
let _e4805 = select(_e3887, _e4803, (_e4803 < _e3887));
let _e4812 = select(0i, select(select(i32(_e4805), i32(-2147483648), (_e4805 < -2147483600f)), 2147483647i, (_e4805 > 2147483500f)), (_e4805 == _e4805));
let _e4816 = (_e4812 - select(0i, 1i, (_e4805 < f32(_e4812))));
let _e4823 = ((((_e4799 >= 0i) && (_e4799 < _e3485)) && (_e4816 >= 0i)) && (_e4816 < _e3491));
if _e4823 {
phi_7800_ = ((_e4816 * _e3485) + _e4799);
} else {
phi_7800_ = 0i;
}
let _e4827 = phi_7800_;
let _e4832 = ((_e4780 * _e4780) + (_e4782 * _e4782));
let _e4836 = (sqrt(select(0f, _e4832, (_e4832 > 0f))) - _e3420);
let _e4839 = (1.2247449f * _e3534);
let _e4844 = (_e4757 - select(0f, (select(0f, _e4836, (_e4836 > 0f)) / select(1e-6f, _e4839, (_e4839 > 1e-6f))), _e3535));
let _e4846 = f32(bitcast<i32>(_e3927));
let _e4847 = (_e4846 - 1f);
let _e4849 = select(0f, _e4844, (_e4844 > 0f));
let _e4851 = select(_e4847, _e4849, (_e4849 < _e4847));
let _e4858 = select(0i, select(select(i32(_e4851), i32(-2147483648), (_e4851 < -2147483600f)), 2147483647i, (_e4851 > 2147483500f)), (_e4851 == _e4851));
let _e4862 = (_e4858 - select(0i, 1i, (_e4851 < f32(_e4858))));
let _e4865 = (_e4844 - f32(_e4862));
let _e4869 = (4i * (_e4746 + (_e4827 * _e3931)));
let _e4871 = (_e4869 + (2i * _e4862));
let _e4873 = (_e4871 >> bitcast<u32>(2i));
let _e4876 = bitcast<u32>(((_e4871 & 3i) * 8i));
let _e4878 = select(_e4481, _e4873, (_e4873 < _e4481));
let _e4884 = global_6.member[bitcast<u32>(select(0i, _e4878, (_e4878 > 0i)))];
let _e4888 = (_e4873 + 1i);
let _e4890 = select(_e4481, _e4888, (_e4888 < _e4481));
let _e4896 = global_6.member[bitcast<u32>(select(0i, _e4890, (_e4890 > 0i)))];
let _e4903 = ((_e4884 >> bitcast<u32>((_e4876 & 31u))) | ((_e4896 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4876) & 31u))));
let _e4906 = f32(bitcast<i32>((_e4903 & 65535u)));
let _e4914 = (1f / 65535f);
let _e4917 = select(0f, (1f - ((_e4906 + ((f32(bitcast<i32>((_e4903 >> bitcast<u32>(16i)))) - _e4906) * select(1f, select(0f, _e4865, (_e4865 > 0f)), (_e4844 < _e4846)))) * _e4914)), _e4823);
if (_e4917 > 1e-4f) {
phi_7949_ = 0i;
phi_7952_ = _e4849;
phi_7954_ = 0f;
loop {
let _e4920 = phi_7949_;
let _e4922 = phi_7952_;
let _e4924 = phi_7954_;
local_92 = _e4922;
let _e4925 = (_e4920 < 10i);
if _e4925 {
let _e4927 = (0.5f * (_e4924 + _e4922));
let _e4929 = select(0f, _e4927, (_e4927 > 0f));
let _e4931 = select(_e4847, _e4929, (_e4929 < _e4847));
let _e4938 = select(0i, select(select(i32(_e4931), i32(-2147483648), (_e4931 < -2147483600f)), 2147483647i, (_e4931 > 2147483500f)), (_e4931 == _e4931));
let _e4942 = (_e4938 - select(0i, 1i, (_e4931 < f32(_e4938))));
let _e4945 = (_e4927 - f32(_e4942));
let _e4950 = (_e4869 + (2i * _e4942));
let _e4952 = (_e4950 >> bitcast<u32>(2i));
let _e4955 = bitcast<u32>(((_e4950 & 3i) * 8i));
let _e4957 = select(_e4481, _e4952, (_e4952 < _e4481));
let _e4963 = global_6.member[bitcast<u32>(select(0i, _e4957, (_e4957 > 0i)))];
let _e4967 = (_e4952 + 1i);
let _e4969 = select(_e4481, _e4967, (_e4967 < _e4481));
let _e4975 = global_6.member[bitcast<u32>(select(0i, _e4969, (_e4969 > 0i)))];
let _e4982 = ((_e4963 >> bitcast<u32>((_e4955 & 31u))) | ((_e4975 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4955) & 31u))));
let _e4985 = f32(bitcast<i32>((_e4982 & 65535u)));
let _e4996 = (((_e4985 + ((f32(bitcast<i32>((_e4982 >> bitcast<u32>(16i)))) - _e4985) * select(1f, select(0f, _e4945, (_e4945 > 0f)), (_e4927 < _e4846)))) * _e4914) > (1f - (0.5f * _e4917)));
phi_7950_ = (_e4920 + 1i);
phi_7953_ = select(_e4927, _e4922, _e4996);
phi_7955_ = select(_e4924, _e4927, _e4996);
} else {
phi_7950_ = i32();
phi_7953_ = f32();
phi_7955_ = f32();
}
let _e5001 = phi_7950_;
let _e5003 = phi_7953_;
let _e5005 = phi_7955_;
continue;
continuing {
phi_7949_ = _e5001;
phi_7952_ = _e5003;
phi_7954_ = _e5005;
break if !(_e4925);
}
}
let _e5009 = local_92;
phi_8075_ = (_e4775 + (_e4917 * _e5009));
phi_8076_ = (_e4777 + _e4917);
} else {
phi_8075_ = _e4775;
phi_8076_ = _e4777;
}
let _e5013 = phi_8075_;
let _e5015 = phi_8076_;
let _e5016 = (_e4773 == 3i);
if _e5016 {
phi_8082_ = -3i;
} else {
phi_8082_ = (_e4773 + 1i);
}
let _e5019 = phi_8082_;
phi_7718_ = (_e4771 + select(0i, 1i, _e5016));
phi_7721_ = _e5019;
phi_7723_ = _e5013;
phi_7725_ = _e5015;
} else {
phi_7718_ = i32();
phi_7721_ = i32();
phi_7723_ = f32();
phi_7725_ = f32();
}
let _e5023 = phi_7718_;
let _e5025 = phi_7721_;
let _e5027 = phi_7723_;
let _e5029 = phi_7725_;
continue;
continuing {
phi_7717_ = _e5023;
phi_7720_ = _e5025;
phi_7722_ = _e5027;
phi_7724_ = _e5029;
break if !(_e4778);
}
}
let _e5032 = local_93;
let _e5035 = local_94;
let _e5038 = local_95;
let _e5041 = local_96;
let _e5043 = (_e4757 - (_e5041 / select(1e-4f, _e5038, (_e5035 > 1e-4f))));
let _e5048 = ((1.2247449f * _e3534) * select(0f, select(0f, _e5043, (_e5043 > 0f)), (_e5032 > 0f)));
let _e5051 = ((_e3419 * _e3419) + (_e5048 * _e5048));
let _e5054 = sqrt(select(0f, _e5051, (_e5051 > 0f)));
phi_8126_ = select(16f, _e5054, (_e5054 < 16f));
} else {
phi_8126_ = _e3419;
}
let _e5058 = phi_8126_;
let _e5059 = (_e4758 - _e5058);
let _e5061 = select(_e3849, _e5059, (_e5059 > _e3849));
let _e5063 = select(_e3850, _e5061, (_e5061 < _e3850));
let _e5070 = select(0i, select(select(i32(_e5063), i32(-2147483648), (_e5063 < -2147483600f)), 2147483647i, (_e5063 > 2147483500f)), (_e5063 == _e5063));
let _e5076 = (_e4758 + _e5058);
let _e5078 = select(-1f, _e5076, (_e5076 > -1f));
let _e5080 = select(_e3870, _e5078, (_e5078 < _e3870));
let _e5087 = select(0i, select(select(i32(_e5080), i32(-2147483648), (_e5080 < -2147483600f)), 2147483647i, (_e5080 > 2147483500f)), (_e5080 == _e5080));
let _e5092 = (_e4759 - _e5058);
let _e5094 = select(_e3849, _e5092, (_e5092 > _e3849));
let _e5096 = select(_e3887, _e5094, (_e5094 < _e3887));
let _e5103 = select(0i, select(select(i32(_e5096), i32(-2147483648), (_e5096 < -2147483600f)), 2147483647i, (_e5096 > 2147483500f)), (_e5096 == _e5096));
let _e5109 = (_e4759 + _e5058);
let _e5111 = select(-1f, _e5109, (_e5109 > -1f));
let _e5113 = select(_e3907, _e5111, (_e5111 < _e3907));
let _e5120 = select(0i, select(select(i32(_e5113), i32(-2147483648), (_e5113 < -2147483600f)), 2147483647i, (_e5113 > 2147483500f)), (_e5113 == _e5113));
phi_8244_ = 0f;
phi_8247_ = vec3<f32>(0f, 0f, 0f);
phi_8249_ = ((_e5103 - select(0i, 1i, (_e5096 < f32(_e5103)))) + 1i);
loop {
let _e5126 = phi_8244_;
let _e5128 = phi_8247_;
let _e5130 = phi_8249_;
local_97 = _e5126;
local_98 = _e5126;
local_99 = _e5128;
local_100 = _e5128;
local_101 = _e5128;
let _e5131 = (_e5130 <= (_e5120 - select(0i, 1i, (_e5113 < f32(_e5120)))));
if _e5131 {
let _e5133 = (f32(_e5130) - _e4759);
let _e5137 = (_e5058 - bitcast<f32>((bitcast<u32>(_e5133) & 2147483647u)));
phi_8264_ = ((_e5070 - select(0i, 1i, (_e5063 < f32(_e5070)))) + 1i);
phi_8267_ = _e5126;
phi_8269_ = _e5128;
loop {
let _e5139 = phi_8264_;
let _e5141 = phi_8267_;
let _e5143 = phi_8269_;
local_156 = _e5141;
local_157 = _e5143;
let _e5144 = (_e5139 <= (_e5087 - select(0i, 1i, (_e5080 < f32(_e5087)))));
if _e5144 {
let _e5146 = (f32(_e5139) - _e4758);
let _e5150 = (_e5058 - bitcast<f32>((bitcast<u32>(_e5146) & 2147483647u)));
let _e5155 = (select(0f, _e5150, (_e5150 > 0f)) * select(0f, _e5137, (_e5137 > 0f)));
if ((((_e5139 >= 0i) && (_e5139 < _e3485)) && (_e5130 >= 0i)) && (_e5130 < _e3491)) {
let _e5166 = (_e4746 + (((_e5130 * _e3485) + _e5139) * _e3931));
let _e5169 = ((_e5146 * _e5146) + (_e5133 * _e5133));
let _e5173 = (sqrt(select(0f, _e5169, (_e5169 > 0f))) - _e3420);
let _e5176 = (1.2247449f * _e3534);
let _e5181 = (_e4757 - select(0f, (select(0f, _e5173, (_e5173 > 0f)) / select(1e-6f, _e5176, (_e5176 > 1e-6f))), _e3535));
let _e5183 = f32(bitcast<i32>(_e3927));
let _e5184 = (_e5183 - 1f);
let _e5186 = select(0f, _e5181, (_e5181 > 0f));
let _e5188 = select(_e5184, _e5186, (_e5186 < _e5184));
let _e5195 = select(0i, select(select(i32(_e5188), i32(-2147483648), (_e5188 < -2147483600f)), 2147483647i, (_e5188 > 2147483500f)), (_e5188 == _e5188));
let _e5199 = (_e5195 - select(0i, 1i, (_e5188 < f32(_e5195))));
let _e5202 = (_e5181 - f32(_e5199));
let _e5205 = select(1f, select(0f, _e5202, (_e5202 > 0f)), (_e5181 < _e5183));
let _e5207 = (2i * _e5199);
let _e5208 = ((4i * _e5166) + _e5207);
let _e5210 = (_e5208 >> bitcast<u32>(2i));
let _e5213 = bitcast<u32>(((_e5208 & 3i) * 8i));
let _e5215 = select(_e4481, _e5210, (_e5210 < _e4481));
let _e5221 = global_6.member[bitcast<u32>(select(0i, _e5215, (_e5215 > 0i)))];
let _e5225 = (_e5210 + 1i);
let _e5227 = select(_e4481, _e5225, (_e5225 < _e4481));
let _e5233 = global_6.member[bitcast<u32>(select(0i, _e5227, (_e5227 > 0i)))];
let _e5240 = ((_e5221 >> bitcast<u32>((_e5213 & 31u))) | ((_e5233 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5213) & 31u))));
let _e5243 = f32(bitcast<i32>((_e5240 & 65535u)));
let _e5251 = (1f / 65535f);
let _e5253 = (_e5155 * ((_e5243 + ((f32(bitcast<i32>((_e5240 >> bitcast<u32>(16i)))) - _e5243) * _e5205)) * _e5251));
let _e5255 = (_e5143.x + _e5253);
if (_e4751 > 1i) {
let _e5259 = ((4i * (_e5166 + _e3933)) + _e5207);
let _e5261 = (_e5259 >> bitcast<u32>(2i));
let _e5264 = bitcast<u32>(((_e5259 & 3i) * 8i));
let _e5266 = select(_e4481, _e5261, (_e5261 < _e4481));
let _e5272 = global_6.member[bitcast<u32>(select(0i, _e5266, (_e5266 > 0i)))];
let _e5276 = (_e5261 + 1i);
let _e5278 = select(_e4481, _e5276, (_e5276 < _e4481));
let _e5284 = global_6.member[bitcast<u32>(select(0i, _e5278, (_e5278 > 0i)))];
let _e5291 = ((_e5272 >> bitcast<u32>((_e5264 & 31u))) | ((_e5284 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5264) & 31u))));
let _e5294 = f32(bitcast<i32>((_e5291 & 65535u)));
let _e5309 = ((4i * (_e5166 + (2i * _e3933))) + _e5207);
let _e5311 = (_e5309 >> bitcast<u32>(2i));
let _e5314 = bitcast<u32>(((_e5309 & 3i) * 8i));
let _e5316 = select(_e4481, _e5311, (_e5311 < _e4481));
let _e5322 = global_6.member[bitcast<u32>(select(0i, _e5316, (_e5316 > 0i)))];
let _e5326 = (_e5311 + 1i);
let _e5328 = select(_e4481, _e5326, (_e5326 < _e4481));
let _e5334 = global_6.member[bitcast<u32>(select(0i, _e5328, (_e5328 > 0i)))];
let _e5341 = ((_e5322 >> bitcast<u32>((_e5314 & 31u))) | ((_e5334 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5314) & 31u))));
let _e5344 = f32(bitcast<i32>((_e5341 & 65535u)));
phi_8658_ = vec3<f32>(_e5255, (_e5143.y + (_e5155 * ((_e5294 + ((f32(bitcast<i32>((_e5291 >> bitcast<u32>(16i)))) - _e5294) * _e5205)) * _e5251))), (_e5143.z + (_e5155 * ((_e5344 + ((f32(bitcast<i32>((_e5341 >> bitcast<u32>(16i)))) - _e5344) * _e5205)) * _e5251))));
} else {
phi_8658_ = vec3<f32>(_e5255, (_e5143.y + _e5253), (_e5143.z + _e5253));
}
let _e5363 = phi_8658_;
phi_8668_ = _e5363;
} else {
phi_8668_ = vec3<f32>((_e5143.x + _e5155), (_e5143.y + _e5155), (_e5143.z + _e5155));
}
let _e5372 = phi_8668_;
phi_8265_ = (_e5139 + 1i);
phi_8268_ = (_e5141 + _e5155);
phi_8270_ = _e5372;
} else {
phi_8265_ = i32();
phi_8268_ = f32();
phi_8270_ = vec3<f32>();
}
let _e5376 = phi_8265_;
let _e5378 = phi_8268_;
let _e5380 = phi_8270_;
continue;
continuing {
phi_8264_ = _e5376;
phi_8267_ = _e5378;
phi_8269_ = _e5380;
break if !(_e5144);
}
}
let _e10421 = local_156;
phi_8245_ = _e10421;
let _e10424 = local_157;
phi_8248_ = _e10424;
phi_8250_ = (_e5130 + 1i);
} else {
phi_8245_ = f32();
phi_8248_ = vec3<f32>();
phi_8250_ = i32();
}
let _e5384 = phi_8245_;
let _e5386 = phi_8248_;
let _e5388 = phi_8250_;
continue;
continuing {
phi_8244_ = _e5384;
phi_8247_ = _e5386;
phi_8249_ = _e5388;
break if !(_e5131);
}
}
let _e5392 = local_97;
let _e5396 = (((_e4751 == 0i) || (_e5392 <= 0f)) || (_e3358 <= 1e-6f));
let _e5398 = local_98;
let _e5400 = (1f / select(_e5398, 1f, _e5396));
let _e5402 = local_99;
let _e5407 = local_100;
let _e5412 = local_101;
phi_8719_ = vec3<f32>(select((((_e4713.x * (_e2944.member * _e4732)) * select((_e5402.x * _e5400), 1f, _e5396)) * _e3334), (_e3308.member_1.x * _e4227), _e2901.member_5), select((((_e4713.y * (_e2944.member_1 * _e4732)) * select((_e5407.y * _e5400), 1f, _e5396)) * _e3334), (_e3308.member_1.y * _e4228), _e2901.member_5), select((((_e4713.z * (_e2944.member_2 * _e4732)) * select((_e5412.z * _e5400), 1f, _e5396)) * _e3334), (_e3308.member_1.z * _e4229), _e2901.member_5));
}
let _e5427 = phi_8719_;
let _e5433 = (((_e1312.member * _e2937) + (_e1312.member_1 * _e2938)) + (_e1312.member_2 * _e2939));
let _e5438 = (((_e1324.member * _e2937) + (_e1324.member_1 * _e2938)) + (_e1324.member_2 * _e2939));
let _e5443 = (((_e1336.member * _e2937) + (_e1336.member_1 * _e2938)) + (_e1336.member_2 * _e2939));
let _e5447 = global_1.member.member_20.member_1;
let _e5457 = global_1.member.member_20.member_2;
let _e5470 = global_1.member.member_20.member_3;
let _e5483 = global_1.member.member_20.member_4;
let _e5487 = (_e5433 * _e5433);
let _e5494 = global_1.member.member_20.member_5;
let _e5498 = (_e5438 * _e5438);
let _e5508 = global_1.member.member_20.member_6;
let _e5512 = (_e5443 * _e5443);
let _e5522 = global_1.member.member_20.member_7;
let _e5526 = (_e5433 * _e5438);
let _e5533 = global_1.member.member_20.member_8;
let _e5537 = (_e5433 * _e5443);
let _e5547 = global_1.member.member_20.member_9;
let _e5551 = (_e5438 * _e5443);
let _e5561 = global_1.member.member_20.member;
let _e5571 = ((_e5561.member + (((_e5447.member * _e5433) + (_e5457.member * _e5438)) + (_e5470.member * _e5443))) + ((((_e5483.member * _e5487) + (_e5494.member * _e5498)) + (_e5508.member * _e5512)) + (((_e5522.member * _e5526) + (_e5533.member * _e5537)) + (_e5547.member * _e5551))));
let _e5572 = ((_e5561.member_1 + (((_e5447.member_1 * _e5433) + (_e5457.member_1 * _e5438)) + (_e5470.member_1 * _e5443))) + ((((_e5483.member_1 * _e5487) + (_e5494.member_1 * _e5498)) + (_e5508.member_1 * _e5512)) + (((_e5522.member_1 * _e5526) + (_e5533.member_1 * _e5537)) + (_e5547.member_1 * _e5551))));
let _e5573 = ((_e5561.member_2 + (((_e5447.member_2 * _e5433) + (_e5457.member_2 * _e5438)) + (_e5470.member_2 * _e5443))) + ((((_e5483.member_2 * _e5487) + (_e5494.member_2 * _e5498)) + (_e5508.member_2 * _e5512)) + (((_e5522.member_2 * _e5526) + (_e5533.member_2 * _e5537)) + (_e5547.member_2 * _e5551))));
phi_8952_ = vec3<f32>(_e2937, _e2938, _e2939);
phi_8953_ = (_e2901.member_3 * vec3<f32>((_e5427.x + select(0f, _e5571, (_e5571 > 0f))), (_e5427.y + select(0f, _e5572, (_e5572 > 0f))), (_e5427.z + select(0f, _e5573, (_e5573 > 0f)))));
} else {
phi_8952_ = vec3<f32>(0f, 0f, 0f);
phi_8953_ = _e2373;
}
let _e5590 = phi_8952_;
let _e5592 = phi_8953_;
let _e5593 = local_12;
local_7 = _e5593;
local_8 = _e202;
let _e5594 = local_8;
let _e5596 = local_7;
let _e5597 = ((22i * _e5594) + _e5596);
let _e5599 = select(_e209, _e5597, (_e5597 < _e209));
let _e5604 = global_2.member[bitcast<u32>(select(0i, _e5599, (_e5599 > 0i)))];
let _e5605 = local_8;
let _e5607 = local_7;
let _e5608 = ((23i * _e5605) + _e5607);
let _e5610 = select(_e209, _e5608, (_e5608 < _e209));
let _e5615 = global_2.member[bitcast<u32>(select(0i, _e5610, (_e5610 > 0i)))];
let _e5616 = local_8;
let _e5618 = local_7;
let _e5619 = ((24i * _e5616) + _e5618);
let _e5621 = select(_e209, _e5619, (_e5619 < _e209));
let _e5626 = global_2.member[bitcast<u32>(select(0i, _e5621, (_e5621 > 0i)))];
let _e5629 = global_1.member.member_17;
let _e5636 = local_12;
local_5 = _e5636;
local_6 = _e202;
let _e5637 = local_6;
let _e5639 = local_5;
let _e5640 = ((6i * _e5637) + _e5639);
let _e5642 = select(_e209, _e5640, (_e5640 < _e209));
let _e5647 = global_2.member[bitcast<u32>(select(0i, _e5642, (_e5642 > 0i)))];
let _e5648 = local_6;
let _e5650 = local_5;
let _e5651 = ((7i * _e5648) + _e5650);
let _e5653 = select(_e209, _e5651, (_e5651 < _e209));
let _e5658 = global_2.member[bitcast<u32>(select(0i, _e5653, (_e5653 > 0i)))];
let _e5659 = local_6;
let _e5661 = local_5;
let _e5662 = ((8i * _e5659) + _e5661);
let _e5664 = select(_e209, _e5662, (_e5662 < _e209));
let _e5669 = global_2.member[bitcast<u32>(select(0i, _e5664, (_e5664 > 0i)))];
let _e5679 = local_48;
local_3 = _e5679;
local_4 = _e202;
let _e5680 = local_4;
let _e5682 = local_3;
let _e5683 = ((9i * _e5680) + _e5682);
let _e5685 = select(_e209, _e5683, (_e5683 < _e209));
let _e5690 = global_2.member[bitcast<u32>(select(0i, _e5685, (_e5685 > 0i)))];
let _e5691 = local_4;
let _e5693 = local_3;
let _e5694 = ((10i * _e5691) + _e5693);
let _e5696 = select(_e209, _e5694, (_e5694 < _e209));
let _e5701 = global_2.member[bitcast<u32>(select(0i, _e5696, (_e5696 > 0i)))];
let _e5702 = local_4;
let _e5704 = local_3;
let _e5705 = ((11i * _e5702) + _e5704);
let _e5707 = select(_e209, _e5705, (_e5705 < _e209));
let _e5712 = global_2.member[bitcast<u32>(select(0i, _e5707, (_e5707 > 0i)))];
let _e5714 = (_e297 && (_e283 == 0f));
let _e5716 = select(_e5690, _e5590.x, _e5714);
let _e5718 = select(_e5701, _e5590.y, _e5714);
let _e5720 = select(_e5712, _e5590.z, _e5714);
let _e5721 = local_49;
let _e5723 = local_48;
let _e5724 = ((21i * _e5721) + _e5723);
let _e5726 = select(_e209, _e5724, (_e5724 < _e209));
let _e5731 = global_2.member[bitcast<u32>(select(0i, _e5726, (_e5726 > 0i)))];
local_1 = _e196;
local_2 = _e202;
let _e5732 = local_2;
let _e5734 = local_1;
let _e5735 = ((9i * _e5732) + _e5734);
let _e5737 = select(_e209, _e5735, (_e5735 < _e209));
let _e5742 = global_2.member[bitcast<u32>(select(0i, _e5737, (_e5737 > 0i)))];
let _e5743 = local_2;
let _e5745 = local_1;
let _e5746 = ((10i * _e5743) + _e5745);
let _e5748 = select(_e209, _e5746, (_e5746 < _e209));
let _e5753 = global_2.member[bitcast<u32>(select(0i, _e5748, (_e5748 > 0i)))];
let _e5754 = local_2;
let _e5756 = local_1;
let _e5757 = ((11i * _e5754) + _e5756);
let _e5759 = select(_e209, _e5757, (_e5757 < _e209));
let _e5764 = global_2.member[bitcast<u32>(select(0i, _e5759, (_e5759 > 0i)))];
let _e5770 = (2f * (((_e1171 * _e5742) + (_e1172 * _e5753)) + (_e1173 * _e5764)));
let _e5774 = (_e1171 - (_e5742 * _e5770));
let _e5775 = (_e1172 - (_e5753 * _e5770));
let _e5776 = (_e1173 - (_e5764 * _e5770));
let _e5777 = (_e5774 - (_e493 - (_e507 * _e535)));
let _e5778 = (_e5775 - (_e494 - (_e518 * _e535)));
let _e5779 = (_e5776 - (_e495 - (_e529 * _e535)));
let _e5784 = (((_e5777 * _e5777) + (_e5778 * _e5778)) + (_e5779 * _e5779));
let _e5787 = sqrt(select(0f, _e5784, (_e5784 > 0f)));
let _e5788 = ((_e692 - (_e706 * _e734)) - _e5774);
let _e5789 = ((_e693 - (_e717 * _e734)) - _e5775);
let _e5790 = ((_e694 - (_e728 * _e734)) - _e5776);
let _e5795 = (((_e5788 * _e5788) + (_e5789 * _e5789)) + (_e5790 * _e5790));
let _e5798 = sqrt(select(0f, _e5795, (_e5795 > 0f)));
let _e5804 = ((select(0f, _e5787, _e420) + select(0f, _e5798, _e662)) * select(1f, 0.5f, (_e420 && _e662)));
let _e5806 = select(4f, _e5787, _e420);
let _e5807 = select(4f, _e5798, _e662);
let _e5809 = select(_e5807, _e5806, (_e5806 < _e5807));
let _e5810 = (_e5774 - (_e901 - (_e916 * _e944)));
let _e5811 = (_e5775 - (_e902 - (_e927 * _e944)));
let _e5812 = (_e5776 - (_e903 - (_e938 * _e944)));
let _e5817 = (((_e5810 * _e5810) + (_e5811 * _e5811)) + (_e5812 * _e5812));
let _e5820 = sqrt(select(0f, _e5817, (_e5817 > 0f)));
let _e5821 = ((_e1101 - (_e1116 * _e1144)) - _e5774);
let _e5822 = ((_e1102 - (_e1127 * _e1144)) - _e5775);
let _e5823 = ((_e1103 - (_e1138 * _e1144)) - _e5776);
let _e5828 = (((_e5821 * _e5821) + (_e5822 * _e5822)) + (_e5823 * _e5823));
let _e5831 = sqrt(select(0f, _e5828, (_e5828 > 0f)));
let _e5837 = ((select(0f, _e5820, _e862) + select(0f, _e5831, _e1071)) * select(1f, 0.5f, (_e862 && _e1071)));
let _e5839 = select(4f, _e5820, _e862);
let _e5840 = select(4f, _e5831, _e1071);
let _e5842 = select(_e5840, _e5839, (_e5839 < _e5840));
let _e5846 = select(_e5842, _e5809, (_e5809 < _e5842));
let _e5852 = select(select(_e1184, select(_e1184, _e5846, (_e5846 > _e1184)), (_e5846 < 4f)), select(_e5837, _e5804, (_e5804 > _e5837)), ((_e420 || _e662) || (_e862 || _e1071)));
let _e5857 = (((_e1312.member * _e5774) + (_e1312.member_1 * _e5775)) + (_e1312.member_2 * _e5776));
let _e5862 = (((_e1324.member * _e5774) + (_e1324.member_1 * _e5775)) + (_e1324.member_2 * _e5776));
let _e5867 = (((_e1336.member * _e5774) + (_e1336.member_1 * _e5775)) + (_e1336.member_2 * _e5776));
if _e1364 {
phi_11023_ = _e1356;
} else {
if (_e1348 == 1u) {
let _e5870 = select(-1f, _e5867, (_e5867 > -1f));
let _e5872 = select(1f, _e5870, (_e5870 < 1f));
if (_e5872 > 0f) {
phi_9638_ = _e1356;
} else {
let _e5877 = global_1.member.member_16.member_9;
phi_9638_ = vec3<f32>(_e5877.member, _e5877.member_1, _e5877.member_2);
}
let _e5883 = phi_9638_;
let _e5892 = bitcast<f32>((bitcast<u32>(_e5872) & 2147483647u));
let _e5895 = sqrt(select(0f, _e5892, (_e5892 > 0f)));
phi_11022_ = vec3<f32>((_e1360.member + ((_e5883.x - _e1360.member) * _e5895)), (_e1360.member_1 + ((_e5883.y - _e1360.member_1) * _e5895)), (_e1360.member_2 + ((_e5883.z - _e1360.member_2) * _e5895)));
} else {
if (_e1348 == 2u) {
let _e5907 = global_1.member.member_16.member_10;
let _e5908 = (_e5852 / _e5907);
let _e5910 = select(1e-4f, _e5908, (_e5908 > 1e-4f));
let _e5913 = bitcast<f32>((bitcast<u32>(_e5857) & 2147483647u));
let _e5916 = bitcast<f32>((bitcast<u32>(_e5862) & 2147483647u));
let _e5920 = select(_e5916, _e5913, (_e5913 > _e5916));
let _e5923 = (select(_e5916, _e5913, (_e5913 < _e5916)) / select(1.1754944e-38f, _e5920, (_e5920 > 1.1754944e-38f)));
let _e5924 = (_e5923 > 0.41421357f);
let _e5928 = select(_e5923, ((_e5923 - 1f) / (_e5923 + 1f)), _e5924);
let _e5929 = (_e5928 * _e5928);
let _e5944 = (select(0f, 0.7853982f, _e5924) + (_e5928 + ((_e5928 * _e5929) * (-0.33333334f + (_e5929 * (0.2f + (_e5929 * (-0.14285713f + (_e5929 * (0.11111111f + (_e5929 * (-0.09090909f + (_e5929 * 0.0585f)))))))))))));
let _e5947 = select(_e5944, (1.5707964f - _e5944), (_e5916 > _e5913));
let _e5950 = select(_e5947, (3.1415927f - _e5947), (_e5857 < 0f));
let _e5956 = (1f - (_e5867 * _e5867));
let _e5959 = sqrt(select(0f, _e5956, (_e5956 > 0f)));
let _e5962 = (_e5910 / select(1e-3f, _e5959, (_e5959 > 1e-3f)));
let _e5963 = ((select(_e5950, -(_e5950), (_e5862 < 0f)) / _e5907) * 0.5f);
let _e5965 = select(-8e6f, _e5963, (_e5963 > -8e6f));
let _e5967 = select(8e6f, _e5965, (_e5965 < 8e6f));
let _e5974 = select(0i, select(select(i32(_e5967), i32(-2147483648), (_e5967 < -2147483600f)), 2147483647i, (_e5967 > 2147483500f)), (_e5967 == _e5967));
let _e5981 = ((_e5963 - f32((_e5974 - select(0i, 1i, (_e5967 < f32(_e5974)))))) * 2f);
let _e5989 = ((select(select((_e5981 - 2f), (1f - _e5981), (_e5981 < 1.5f)), _e5981, (_e5981 < 0.5f)) * 2f) / _e5962);
let _e5991 = select(-1f, _e5989, (_e5989 > -1f));
let _e5994 = (2f - _e5962);
let _e5996 = select(0f, _e5994, (_e5994 > 0f));
let _e6001 = select(-1f, _e5867, (_e5867 > -1f));
let _e6003 = select(1f, _e6001, (_e6001 < 1f));
let _e6006 = ((1f - _e6003) * (1f + _e6003));
let _e6009 = sqrt(select(0f, _e6006, (_e6006 > 0f)));
let _e6012 = bitcast<f32>((bitcast<u32>(_e6009) & 2147483647u));
let _e6015 = bitcast<f32>((bitcast<u32>(_e6003) & 2147483647u));
let _e6019 = select(_e6015, _e6012, (_e6012 > _e6015));
let _e6022 = (select(_e6015, _e6012, (_e6012 < _e6015)) / select(1.1754944e-38f, _e6019, (_e6019 > 1.1754944e-38f)));
let _e6023 = (_e6022 > 0.41421357f);
let _e6027 = select(_e6022, ((_e6022 - 1f) / (_e6022 + 1f)), _e6023);
let _e6028 = (_e6027 * _e6027);
let _e6043 = (select(0f, 0.7853982f, _e6023) + (_e6027 + ((_e6027 * _e6028) * (-0.33333334f + (_e6028 * (0.2f + (_e6028 * (-0.14285713f + (_e6028 * (0.11111111f + (_e6028 * (-0.09090909f + (_e6028 * 0.0585f)))))))))))));
let _e6046 = select(_e6043, (1.5707964f - _e6043), (_e6015 > _e6012));
let _e6049 = select(_e6046, (3.1415927f - _e6046), (_e6009 < 0f));
let _e6054 = ((select(_e6049, -(_e6049), (_e6003 < 0f)) / _e5907) * 0.5f);
let _e6056 = select(-8e6f, _e6054, (_e6054 > -8e6f));
let _e6058 = select(8e6f, _e6056, (_e6056 < 8e6f));
let _e6065 = select(0i, select(select(i32(_e6058), i32(-2147483648), (_e6058 < -2147483600f)), 2147483647i, (_e6058 > 2147483500f)), (_e6058 == _e6058));
let _e6072 = ((_e6054 - f32((_e6065 - select(0i, 1i, (_e6058 < f32(_e6065)))))) * 2f);
let _e6080 = ((select(select((_e6072 - 2f), (1f - _e6072), (_e6072 < 1.5f)), _e6072, (_e6072 < 0.5f)) * 2f) / _e5910);
let _e6082 = select(-1f, _e6080, (_e6080 > -1f));
let _e6085 = (2f - _e5910);
let _e6087 = select(0f, _e6085, (_e6085 > 0f));
let _e6093 = (0.5f + ((0.5f * (select(1f, _e5991, (_e5991 < 1f)) * select(1f, _e5996, (_e5996 < 1f)))) * (select(1f, _e6082, (_e6082 < 1f)) * select(1f, _e6087, (_e6087 < 1f)))));
phi_11021_ = vec3<f32>((_e1352.member + ((_e1360.member - _e1352.member) * _e6093)), (_e1352.member_1 + ((_e1360.member_1 - _e1352.member_1) * _e6093)), (_e1352.member_2 + ((_e1360.member_2 - _e1352.member_2) * _e6093)));
} else {
let _e6107 = global_1.member.member_16.member_1;
let _e6108 = bitcast<i32>(_e6107);
let _e6113 = global_1.member.member_16.member_3;
let _e6115 = f32(bitcast<i32>(_e6113));
let _e6117 = (2f * 3.1415927f);
let _e6118 = ((_e5852 * f32(_e6108)) / _e6117);
let _e6120 = select(1e-6f, _e6118, (_e6118 > 1e-6f));
let _e6123 = bitcast<u32>(select(1.1754944e-38f, _e6120, (_e6120 > 1.1754944e-38f)));
let _e6124 = (_e6123 & 8388607u);
let _e6126 = select(0u, 1u, (_e6124 > 3474675u));
let _e6137 = bitcast<f32>((_e6124 | ((127u - _e6126) << bitcast<u32>(23i))));
let _e6140 = ((_e6137 - 1f) / (_e6137 + 1f));
let _e6141 = (_e6140 * _e6140);
let _e6156 = (f32(((bitcast<i32>((_e6123 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e6126))) + (((2f * _e6140) + ((_e6140 * _e6141) * (0.6666667f + (_e6141 * (0.4f + (_e6141 * (0.2857143f + (_e6141 * (0.22222222f + (_e6141 * 0.18181819f)))))))))) * 1.442695f));
let _e6157 = (_e6115 - 1f);
let _e6159 = select(0f, _e6156, (_e6156 > 0f));
let _e6161 = select(_e6157, _e6159, (_e6159 < _e6157));
let _e6162 = (_e6115 - 2f);
let _e6164 = select(0f, _e6162, (_e6162 > 0f));
let _e6166 = select(0f, _e6161, (_e6161 > 0f));
let _e6168 = select(_e6164, _e6166, (_e6166 < _e6164));
let _e6175 = select(0i, select(select(i32(_e6168), i32(-2147483648), (_e6168 < -2147483600f)), 2147483647i, (_e6168 > 2147483500f)), (_e6168 == _e6168));
let _e6179 = (_e6175 - select(0i, 1i, (_e6168 < f32(_e6175))));
let _e6182 = bitcast<f32>((bitcast<u32>(_e5862) & 2147483647u));
let _e6185 = bitcast<f32>((bitcast<u32>(_e5857) & 2147483647u));
let _e6189 = select(_e6185, _e6182, (_e6182 > _e6185));
let _e6192 = (select(_e6185, _e6182, (_e6182 < _e6185)) / select(1.1754944e-38f, _e6189, (_e6189 > 1.1754944e-38f)));
let _e6193 = (_e6192 > 0.41421357f);
let _e6197 = select(_e6192, ((_e6192 - 1f) / (_e6192 + 1f)), _e6193);
let _e6198 = (_e6197 * _e6197);
let _e6213 = (select(0f, 0.7853982f, _e6193) + (_e6197 + ((_e6197 * _e6198) * (-0.33333334f + (_e6198 * (0.2f + (_e6198 * (-0.14285713f + (_e6198 * (0.11111111f + (_e6198 * (-0.09090909f + (_e6198 * 0.0585f)))))))))))));
let _e6216 = select(_e6213, (1.5707964f - _e6213), (_e6185 > _e6182));
let _e6219 = select(_e6216, (3.1415927f - _e6216), (_e5862 < 0f));
let _e6224 = (0.5f - (select(_e6219, -(_e6219), (_e5857 < 0f)) / _e6117));
let _e6226 = select(-1f, _e5867, (_e5867 > -1f));
let _e6228 = select(1f, _e6226, (_e6226 < 1f));
let _e6231 = ((1f - _e6228) * (1f + _e6228));
let _e6234 = sqrt(select(0f, _e6231, (_e6231 > 0f)));
let _e6237 = bitcast<f32>((bitcast<u32>(_e6234) & 2147483647u));
let _e6240 = bitcast<f32>((bitcast<u32>(_e6228) & 2147483647u));
let _e6244 = select(_e6240, _e6237, (_e6237 > _e6240));
let _e6247 = (select(_e6240, _e6237, (_e6237 < _e6240)) / select(1.1754944e-38f, _e6244, (_e6244 > 1.1754944e-38f)));
let _e6248 = (_e6247 > 0.41421357f);
let _e6252 = select(_e6247, ((_e6247 - 1f) / (_e6247 + 1f)), _e6248);
let _e6253 = (_e6252 * _e6252);
let _e6268 = (select(0f, 0.7853982f, _e6248) + (_e6252 + ((_e6252 * _e6253) * (-0.33333334f + (_e6253 * (0.2f + (_e6253 * (-0.14285713f + (_e6253 * (0.11111111f + (_e6253 * (-0.09090909f + (_e6253 * 0.0585f)))))))))))));
let _e6271 = select(_e6268, (1.5707964f - _e6268), (_e6240 > _e6237));
let _e6274 = select(_e6271, (3.1415927f - _e6271), (_e6234 < 0f));
let _e6279 = (0.5f - (select(_e6274, -(_e6274), (_e6228 < 0f)) / 3.1415927f));
let _e6283 = global_1.member.member_16.member_2;
let _e6284 = bitcast<i32>(_e6283);
phi_10240_ = 0i;
phi_10243_ = 0i;
phi_10245_ = _e6284;
phi_10247_ = _e6108;
loop {
let _e6286 = phi_10240_;
let _e6288 = phi_10243_;
let _e6290 = phi_10245_;
let _e6292 = phi_10247_;
local_102 = _e6292;
local_103 = _e6290;
local_104 = _e6292;
local_105 = _e6292;
local_106 = _e6292;
local_107 = _e6292;
local_108 = _e6292;
local_109 = _e6292;
local_110 = _e6290;
local_111 = _e6290;
local_112 = _e6290;
local_113 = _e6290;
local_114 = _e6292;
local_115 = _e6288;
local_116 = _e6292;
local_117 = _e6288;
let _e6293 = (_e6286 < _e6179);
if _e6293 {
if (_e6292 > 1i) {
phi_10262_ = (_e6292 >> bitcast<u32>(1i));
} else {
phi_10262_ = 1i;
}
let _e6300 = phi_10262_;
if (_e6290 > 1i) {
phi_10268_ = (_e6290 >> bitcast<u32>(1i));
} else {
phi_10268_ = 1i;
}
let _e6305 = phi_10268_;
phi_10241_ = (_e6286 + 1i);
phi_10244_ = (_e6288 + (_e6292 * _e6290));
phi_10246_ = _e6305;
phi_10248_ = _e6300;
} else {
phi_10241_ = i32();
phi_10244_ = i32();
phi_10246_ = i32();
phi_10248_ = i32();
}
let _e6308 = phi_10241_;
let _e6310 = phi_10244_;
let _e6312 = phi_10246_;
let _e6314 = phi_10248_;
continue;
continuing {
phi_10240_ = _e6308;
phi_10243_ = _e6310;
phi_10245_ = _e6312;
phi_10247_ = _e6314;
break if !(_e6293);
}
}
let _e6317 = local_102;
let _e6318 = f32(_e6317);
let _e6320 = ((_e6224 * _e6318) - 0.5f);
let _e6322 = local_103;
let _e6323 = f32(_e6322);
let _e6325 = ((_e6279 * _e6323) - 0.5f);
let _e6327 = select(-1f, _e6320, (_e6320 > -1f));
let _e6329 = select(_e6318, _e6327, (_e6327 < _e6318));
let _e6336 = select(0i, select(select(i32(_e6329), i32(-2147483648), (_e6329 < -2147483600f)), 2147483647i, (_e6329 > 2147483500f)), (_e6329 == _e6329));
let _e6340 = (_e6336 - select(0i, 1i, (_e6329 < f32(_e6336))));
let _e6342 = select(-1f, _e6325, (_e6325 > -1f));
let _e6344 = select(_e6323, _e6342, (_e6342 < _e6323));
let _e6351 = select(0i, select(select(i32(_e6344), i32(-2147483648), (_e6344 < -2147483600f)), 2147483647i, (_e6344 > 2147483500f)), (_e6344 == _e6344));
let _e6355 = (_e6351 - select(0i, 1i, (_e6344 < f32(_e6351))));
let _e6357 = (_e6320 - f32(_e6340));
let _e6359 = (_e6325 - f32(_e6355));
let _e6361 = select(0f, _e6359, (_e6359 > 0f));
let _e6363 = select(1f, _e6361, (_e6361 < 1f));
if (_e6340 < 0i) {
let _e6366 = local_104;
phi_10343_ = (_e6340 + _e6366);
} else {
phi_10343_ = _e6340;
}
let _e6369 = phi_10343_;
let _e6371 = local_105;
if (_e6369 >= _e6371) {
let _e6374 = local_106;
phi_10349_ = (_e6369 - _e6374);
} else {
phi_10349_ = _e6369;
}
let _e6377 = phi_10349_;
let _e6378 = (_e6340 + 1i);
if (_e6378 < 0i) {
let _e6381 = local_107;
phi_10356_ = (_e6378 + _e6381);
} else {
phi_10356_ = _e6378;
}
let _e6384 = phi_10356_;
let _e6386 = local_108;
if (_e6384 >= _e6386) {
let _e6389 = local_109;
phi_10362_ = (_e6384 - _e6389);
} else {
phi_10362_ = _e6384;
}
let _e6392 = phi_10362_;
let _e6394 = select(_e6355, 0i, (_e6355 < 0i));
let _e6396 = local_110;
if (_e6394 >= _e6396) {
let _e6399 = local_111;
phi_10373_ = (_e6399 - 1i);
} else {
phi_10373_ = _e6394;
}
let _e6402 = phi_10373_;
let _e6403 = (_e6355 + 1i);
let _e6405 = select(_e6403, 0i, (_e6403 < 0i));
let _e6407 = local_112;
if (_e6405 >= _e6407) {
let _e6410 = local_113;
phi_10385_ = (_e6410 - 1i);
} else {
phi_10385_ = _e6405;
}
let _e6413 = phi_10385_;
let _e6415 = local_114;
let _e6418 = local_115;
let _e6419 = (_e6418 + (_e6402 * _e6415));
let _e6421 = local_116;
let _e6424 = local_117;
let _e6425 = (_e6424 + (_e6413 * _e6421));
let _e6427 = (3i * (_e6419 + _e6377));
let _e6429 = (bitcast<i32>(_e165) - 1i);
let _e6431 = select(_e6429, _e6427, (_e6427 < _e6429));
let _e6437 = global_3.member[bitcast<u32>(select(0i, _e6431, (_e6431 > 0i)))];
let _e6438 = (_e6427 + 1i);
let _e6440 = select(_e6429, _e6438, (_e6438 < _e6429));
let _e6446 = global_3.member[bitcast<u32>(select(0i, _e6440, (_e6440 > 0i)))];
let _e6447 = (_e6427 + 2i);
let _e6449 = select(_e6429, _e6447, (_e6447 < _e6429));
let _e6455 = global_3.member[bitcast<u32>(select(0i, _e6449, (_e6449 > 0i)))];
let _e6457 = (3i * (_e6419 + _e6392));
let _e6459 = select(_e6429, _e6457, (_e6457 < _e6429));
let _e6465 = global_3.member[bitcast<u32>(select(0i, _e6459, (_e6459 > 0i)))];
let _e6466 = (_e6457 + 1i);
let _e6468 = select(_e6429, _e6466, (_e6466 < _e6429));
let _e6474 = global_3.member[bitcast<u32>(select(0i, _e6468, (_e6468 > 0i)))];
let _e6475 = (_e6457 + 2i);
let _e6477 = select(_e6429, _e6475, (_e6475 < _e6429));
let _e6483 = global_3.member[bitcast<u32>(select(0i, _e6477, (_e6477 > 0i)))];
let _e6485 = (3i * (_e6425 + _e6377));
let _e6487 = select(_e6429, _e6485, (_e6485 < _e6429));
let _e6493 = global_3.member[bitcast<u32>(select(0i, _e6487, (_e6487 > 0i)))];
let _e6494 = (_e6485 + 1i);
let _e6496 = select(_e6429, _e6494, (_e6494 < _e6429));
let _e6502 = global_3.member[bitcast<u32>(select(0i, _e6496, (_e6496 > 0i)))];
let _e6503 = (_e6485 + 2i);
let _e6505 = select(_e6429, _e6503, (_e6503 < _e6429));
let _e6511 = global_3.member[bitcast<u32>(select(0i, _e6505, (_e6505 > 0i)))];
let _e6513 = (3i * (_e6425 + _e6392));
let _e6515 = select(_e6429, _e6513, (_e6513 < _e6429));
let _e6521 = global_3.member[bitcast<u32>(select(0i, _e6515, (_e6515 > 0i)))];
let _e6522 = (_e6513 + 1i);
let _e6524 = select(_e6429, _e6522, (_e6522 < _e6429));
let _e6530 = global_3.member[bitcast<u32>(select(0i, _e6524, (_e6524 > 0i)))];
let _e6531 = (_e6513 + 2i);
let _e6533 = select(_e6429, _e6531, (_e6531 < _e6429));
let _e6539 = global_3.member[bitcast<u32>(select(0i, _e6533, (_e6533 > 0i)))];
let _e6546 = (_e6437 + ((_e6465 - _e6437) * _e6357));
let _e6547 = (_e6446 + ((_e6474 - _e6446) * _e6357));
let _e6548 = (_e6455 + ((_e6483 - _e6455) * _e6357));
let _e6564 = (_e6546 + (((_e6493 + ((_e6521 - _e6493) * _e6357)) - _e6546) * _e6363));
let _e6565 = (_e6547 + (((_e6502 + ((_e6530 - _e6502) * _e6357)) - _e6547) * _e6363));
let _e6566 = (_e6548 + (((_e6511 + ((_e6539 - _e6511) * _e6357)) - _e6548) * _e6363));
phi_10621_ = 0i;
phi_10624_ = 0i;
phi_10626_ = _e6284;
phi_10628_ = _e6108;
loop {
let _e6569 = phi_10621_;
let _e6571 = phi_10624_;
let _e6573 = phi_10626_;
let _e6575 = phi_10628_;
local_118 = _e6575;
local_119 = _e6573;
local_120 = _e6575;
local_121 = _e6575;
local_122 = _e6575;
local_123 = _e6575;
local_124 = _e6575;
local_125 = _e6575;
local_126 = _e6573;
local_127 = _e6573;
local_128 = _e6573;
local_129 = _e6573;
local_130 = _e6575;
local_131 = _e6571;
local_132 = _e6575;
local_133 = _e6571;
let _e6576 = (_e6569 < (_e6179 + 1i));
if _e6576 {
if (_e6575 > 1i) {
phi_10643_ = (_e6575 >> bitcast<u32>(1i));
} else {
phi_10643_ = 1i;
}
let _e6583 = phi_10643_;
if (_e6573 > 1i) {
phi_10649_ = (_e6573 >> bitcast<u32>(1i));
} else {
phi_10649_ = 1i;
}
let _e6588 = phi_10649_;
phi_10622_ = (_e6569 + 1i);
phi_10625_ = (_e6571 + (_e6575 * _e6573));
phi_10627_ = _e6588;
phi_10629_ = _e6583;
} else {
phi_10622_ = i32();
phi_10625_ = i32();
phi_10627_ = i32();
phi_10629_ = i32();
}
let _e6591 = phi_10622_;
let _e6593 = phi_10625_;
let _e6595 = phi_10627_;
let _e6597 = phi_10629_;
continue;
continuing {
phi_10621_ = _e6591;
phi_10624_ = _e6593;
phi_10626_ = _e6595;
phi_10628_ = _e6597;
break if !(_e6576);
}
}
let _e6600 = local_118;
let _e6601 = f32(_e6600);
let _e6603 = ((_e6224 * _e6601) - 0.5f);
let _e6605 = local_119;
let _e6606 = f32(_e6605);
let _e6608 = ((_e6279 * _e6606) - 0.5f);
let _e6610 = select(-1f, _e6603, (_e6603 > -1f));
let _e6612 = select(_e6601, _e6610, (_e6610 < _e6601));
let _e6619 = select(0i, select(select(i32(_e6612), i32(-2147483648), (_e6612 < -2147483600f)), 2147483647i, (_e6612 > 2147483500f)), (_e6612 == _e6612));
let _e6623 = (_e6619 - select(0i, 1i, (_e6612 < f32(_e6619))));
let _e6625 = select(-1f, _e6608, (_e6608 > -1f));
let _e6627 = select(_e6606, _e6625, (_e6625 < _e6606));
let _e6634 = select(0i, select(select(i32(_e6627), i32(-2147483648), (_e6627 < -2147483600f)), 2147483647i, (_e6627 > 2147483500f)), (_e6627 == _e6627));
let _e6638 = (_e6634 - select(0i, 1i, (_e6627 < f32(_e6634))));
let _e6640 = (_e6603 - f32(_e6623));
let _e6642 = (_e6608 - f32(_e6638));
let _e6644 = select(0f, _e6642, (_e6642 > 0f));
let _e6646 = select(1f, _e6644, (_e6644 < 1f));
if (_e6623 < 0i) {
let _e6649 = local_120;
phi_10724_ = (_e6623 + _e6649);
} else {
phi_10724_ = _e6623;
}
let _e6652 = phi_10724_;
let _e6654 = local_121;
if (_e6652 >= _e6654) {
let _e6657 = local_122;
phi_10730_ = (_e6652 - _e6657);
} else {
phi_10730_ = _e6652;
}
let _e6660 = phi_10730_;
let _e6661 = (_e6623 + 1i);
if (_e6661 < 0i) {
let _e6664 = local_123;
phi_10737_ = (_e6661 + _e6664);
} else {
phi_10737_ = _e6661;
}
let _e6667 = phi_10737_;
let _e6669 = local_124;
if (_e6667 >= _e6669) {
let _e6672 = local_125;
phi_10743_ = (_e6667 - _e6672);
} else {
phi_10743_ = _e6667;
}
let _e6675 = phi_10743_;
let _e6677 = select(_e6638, 0i, (_e6638 < 0i));
let _e6679 = local_126;
if (_e6677 >= _e6679) {
let _e6682 = local_127;
phi_10754_ = (_e6682 - 1i);
} else {
phi_10754_ = _e6677;
}
let _e6685 = phi_10754_;
let _e6686 = (_e6638 + 1i);
let _e6688 = select(_e6686, 0i, (_e6686 < 0i));
let _e6690 = local_128;
if (_e6688 >= _e6690) {
let _e6693 = local_129;
phi_10766_ = (_e6693 - 1i);
} else {
phi_10766_ = _e6688;
}
let _e6696 = phi_10766_;
let _e6698 = local_130;
let _e6701 = local_131;
let _e6702 = (_e6701 + (_e6685 * _e6698));
let _e6704 = local_132;
let _e6707 = local_133;
let _e6708 = (_e6707 + (_e6696 * _e6704));
let _e6710 = (3i * (_e6702 + _e6660));
let _e6712 = select(_e6429, _e6710, (_e6710 < _e6429));
let _e6718 = global_3.member[bitcast<u32>(select(0i, _e6712, (_e6712 > 0i)))];
let _e6719 = (_e6710 + 1i);
let _e6721 = select(_e6429, _e6719, (_e6719 < _e6429));
let _e6727 = global_3.member[bitcast<u32>(select(0i, _e6721, (_e6721 > 0i)))];
let _e6728 = (_e6710 + 2i);
let _e6730 = select(_e6429, _e6728, (_e6728 < _e6429));
let _e6736 = global_3.member[bitcast<u32>(select(0i, _e6730, (_e6730 > 0i)))];
let _e6738 = (3i * (_e6702 + _e6675));
let _e6740 = select(_e6429, _e6738, (_e6738 < _e6429));
let _e6746 = global_3.member[bitcast<u32>(select(0i, _e6740, (_e6740 > 0i)))];
let _e6747 = (_e6738 + 1i);
let _e6749 = select(_e6429, _e6747, (_e6747 < _e6429));
let _e6755 = global_3.member[bitcast<u32>(select(0i, _e6749, (_e6749 > 0i)))];
let _e6756 = (_e6738 + 2i);
let _e6758 = select(_e6429, _e6756, (_e6756 < _e6429));
let _e6764 = global_3.member[bitcast<u32>(select(0i, _e6758, (_e6758 > 0i)))];
let _e6766 = (3i * (_e6708 + _e6660));
let _e6768 = select(_e6429, _e6766, (_e6766 < _e6429));
let _e6774 = global_3.member[bitcast<u32>(select(0i, _e6768, (_e6768 > 0i)))];
let _e6775 = (_e6766 + 1i);
let _e6777 = select(_e6429, _e6775, (_e6775 < _e6429));
let _e6783 = global_3.member[bitcast<u32>(select(0i, _e6777, (_e6777 > 0i)))];
let _e6784 = (_e6766 + 2i);
let _e6786 = select(_e6429, _e6784, (_e6784 < _e6429));
let _e6792 = global_3.member[bitcast<u32>(select(0i, _e6786, (_e6786 > 0i)))];
let _e6794 = (3i * (_e6708 + _e6675));
let _e6796 = select(_e6429, _e6794, (_e6794 < _e6429));
let _e6802 = global_3.member[bitcast<u32>(select(0i, _e6796, (_e6796 > 0i)))];
let _e6803 = (_e6794 + 1i);
let _e6805 = select(_e6429, _e6803, (_e6803 < _e6429));
let _e6811 = global_3.member[bitcast<u32>(select(0i, _e6805, (_e6805 > 0i)))];
let _e6812 = (_e6794 + 2i);
let _e6814 = select(_e6429, _e6812, (_e6812 < _e6429));
let _e6820 = global_3.member[bitcast<u32>(select(0i, _e6814, (_e6814 > 0i)))];
let _e6827 = (_e6718 + ((_e6746 - _e6718) * _e6640));
let _e6828 = (_e6727 + ((_e6755 - _e6727) * _e6640));
let _e6829 = (_e6736 + ((_e6764 - _e6736) * _e6640));
let _e6852 = (_e6161 - f32(_e6179));
let _e6854 = select(0f, _e6852, (_e6852 > 0f));
let _e6856 = select(1f, _e6854, (_e6854 < 1f));
let _e6866 = global_1.member.member_16.member_11;
phi_11021_ = vec3<f32>(((_e6564 + (((_e6827 + (((_e6774 + ((_e6802 - _e6774) * _e6640)) - _e6827) * _e6646)) - _e6564) * _e6856)) * _e6866), ((_e6565 + (((_e6828 + (((_e6783 + ((_e6811 - _e6783) * _e6640)) - _e6828) * _e6646)) - _e6565) * _e6856)) * _e6866), ((_e6566 + (((_e6829 + (((_e6792 + ((_e6820 - _e6792) * _e6640)) - _e6829) * _e6646)) - _e6566) * _e6856)) * _e6866));
}
let _e6872 = phi_11021_;
phi_11022_ = _e6872;
}
let _e6874 = phi_11022_;
phi_11023_ = _e6874;
}
let _e6876 = phi_11023_;
if (_e295 && (_e5731 > 0f)) {
let _e6879 = local_49;
let _e6881 = local_48;
let _e6882 = ((2i * _e6879) + _e6881);
let _e6884 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e6886 = select(_e6884, _e6882, (_e6882 < _e6884));
let _e6891 = global_7.member[bitcast<u32>(select(0i, _e6886, (_e6886 > 0i)))];
let _e6898 = select(0i, select(select(i32(_e6891), i32(-2147483648), (_e6891 < -2147483600f)), 2147483647i, (_e6891 > 2147483500f)), (_e6891 == _e6891));
if (_e6898 != -1i) {
let _e6900 = local_49;
let _e6902 = local_48;
let _e6903 = ((20i * _e6900) + _e6902);
let _e6905 = select(_e209, _e6903, (_e6903 < _e209));
let _e6910 = global_2.member[bitcast<u32>(select(0i, _e6905, (_e6905 > 0i)))];
let _e6911 = (1f - _e469);
let _e6917 = global_1.member.member_10;
let _e6930 = local_49;
let _e6932 = local_48;
let _e6933 = ((3i * _e6930) + _e6932);
let _e6935 = select(_e6884, _e6933, (_e6933 < _e6884));
let _e6940 = global_7.member[bitcast<u32>(select(0i, _e6935, (_e6935 > 0i)))];
let _e6944 = (((_e6917.member + (_e1151 * _e6911)) + (_e1171 * _e6910)) + (_e5774 * _e6940));
let _e6945 = (((_e6917.member_1 + (_e1152 * _e6911)) + (_e1172 * _e6910)) + (_e5775 * _e6940));
let _e6946 = (((_e6917.member_2 + (_e1153 * _e6911)) + (_e1173 * _e6910)) + (_e5776 * _e6940));
let _e6947 = vec3<f32>(_e6944, _e6945, _e6946);
if (_e6898 < 0i) {
let _e6949 = (_e6898 == -3i);
let _e6955 = global_1.member.member_18.member_1.member.member;
let _e6960 = global_1.member.member_18.member_1.member_1;
let _e6966 = global_1.member.member_18.member.member.member;
let _e6971 = global_1.member.member_18.member.member_1;
let _e6981 = vec3<f32>(select(_e6966.member, _e6955.member, _e6949), select(_e6966.member_1, _e6955.member_1, _e6949), select(_e6966.member_2, _e6955.member_2, _e6949));
phi_11998_ = type_28(_e6947, _e6981, _e6981, vec3<f32>(select(_e6971.member, _e6960.member, _e6949), select(_e6971.member_1, _e6960.member_1, _e6949), select(_e6971.member_2, _e6960.member_2, _e6949)), 0f, false, _e6949);
} else {
let _e6995 = global_1.member.member_1;
let _e6998 = (_e6898 * 19i);
let _e7000 = (bitcast<i32>(_e167) - 1i);
let _e7002 = select(_e7000, _e6998, (_e6998 < _e7000));
let _e7008 = global_4.member[bitcast<u32>(select(0i, _e7002, (_e7002 > 0i)))];
let _e7009 = (_e6998 + 1i);
let _e7011 = select(_e7000, _e7009, (_e7009 < _e7000));
let _e7017 = global_4.member[bitcast<u32>(select(0i, _e7011, (_e7011 > 0i)))];
let _e7018 = (_e6998 + 2i);
let _e7020 = select(_e7000, _e7018, (_e7018 < _e7000));
let _e7026 = global_4.member[bitcast<u32>(select(0i, _e7020, (_e7020 > 0i)))];
let _e7027 = (_e6998 + 3i);
let _e7029 = select(_e7000, _e7027, (_e7027 < _e7000));
let _e7035 = global_4.member[bitcast<u32>(select(0i, _e7029, (_e7029 > 0i)))];
let _e7036 = (_e6998 + 4i);
let _e7038 = select(_e7000, _e7036, (_e7036 < _e7000));
let _e7044 = global_4.member[bitcast<u32>(select(0i, _e7038, (_e7038 > 0i)))];
let _e7045 = (_e6998 + 5i);
let _e7047 = select(_e7000, _e7045, (_e7045 < _e7000));
let _e7053 = global_4.member[bitcast<u32>(select(0i, _e7047, (_e7047 > 0i)))];
let _e7054 = (_e6998 + 6i);
let _e7056 = select(_e7000, _e7054, (_e7054 < _e7000));
let _e7062 = global_4.member[bitcast<u32>(select(0i, _e7056, (_e7056 > 0i)))];
let _e7063 = (_e6998 + 7i);
let _e7065 = select(_e7000, _e7063, (_e7063 < _e7000));
let _e7071 = global_4.member[bitcast<u32>(select(0i, _e7065, (_e7065 > 0i)))];
let _e7072 = (_e6998 + 8i);
let _e7074 = select(_e7000, _e7072, (_e7072 < _e7000));
let _e7080 = global_4.member[bitcast<u32>(select(0i, _e7074, (_e7074 > 0i)))];
let _e7081 = (_e7035 - _e7008);
let _e7082 = (_e7044 - _e7017);
let _e7083 = (_e7053 - _e7026);
let _e7084 = (_e7062 - _e7008);
let _e7085 = (_e7071 - _e7017);
let _e7086 = (_e7080 - _e7026);
let _e7089 = ((_e7082 * _e7086) - (_e7083 * _e7085));
let _e7092 = ((_e7083 * _e7084) - (_e7081 * _e7086));
let _e7095 = ((_e7081 * _e7085) - (_e7082 * _e7084));
let _e7096 = (_e7035 - _e6944);
let _e7097 = (_e7044 - _e6945);
let _e7098 = (_e7053 - _e6946);
let _e7099 = (_e7062 - _e6944);
let _e7100 = (_e7071 - _e6945);
let _e7101 = (_e7080 - _e6946);
let _e7115 = (((((_e7097 * _e7101) - (_e7098 * _e7100)) * _e7089) + (((_e7098 * _e7099) - (_e7096 * _e7101)) * _e7092)) + (((_e7096 * _e7100) - (_e7097 * _e7099)) * _e7095));
let _e7117 = select(0f, _e7115, (_e7115 > 0f));
let _e7118 = (_e7008 - _e6944);
let _e7119 = (_e7017 - _e6945);
let _e7120 = (_e7026 - _e6946);
let _e7134 = (((((_e7100 * _e7120) - (_e7101 * _e7119)) * _e7089) + (((_e7101 * _e7118) - (_e7099 * _e7120)) * _e7092)) + (((_e7099 * _e7119) - (_e7100 * _e7118)) * _e7095));
let _e7136 = select(0f, _e7134, (_e7134 > 0f));
let _e7150 = (((((_e7119 * _e7098) - (_e7120 * _e7097)) * _e7089) + (((_e7120 * _e7096) - (_e7118 * _e7098)) * _e7092)) + (((_e7118 * _e7097) - (_e7119 * _e7096)) * _e7095));
let _e7152 = select(0f, _e7150, (_e7150 > 0f));
let _e7154 = ((_e7117 + _e7136) + _e7152);
let _e7156 = select(1e-30f, _e7154, (_e7154 > 1e-30f));
let _e7157 = (_e7117 / _e7156);
let _e7158 = (_e7136 / _e7156);
let _e7159 = (_e7152 / _e7156);
let _e7164 = (((_e7089 * _e7089) + (_e7092 * _e7092)) + (_e7095 * _e7095));
let _e7167 = sqrt(select(0f, _e7164, (_e7164 > 0f)));
let _e7170 = (1f / select(1e-20f, _e7167, (_e7167 > 1e-20f)));
let _e7175 = (_e6998 + 9i);
let _e7177 = select(_e7000, _e7175, (_e7175 < _e7000));
let _e7183 = global_4.member[bitcast<u32>(select(0i, _e7177, (_e7177 > 0i)))];
let _e7184 = (_e6998 + 10i);
let _e7186 = select(_e7000, _e7184, (_e7184 < _e7000));
let _e7192 = global_4.member[bitcast<u32>(select(0i, _e7186, (_e7186 > 0i)))];
let _e7193 = (_e6998 + 11i);
let _e7195 = select(_e7000, _e7193, (_e7193 < _e7000));
let _e7201 = global_4.member[bitcast<u32>(select(0i, _e7195, (_e7195 > 0i)))];
let _e7205 = (_e6998 + 12i);
let _e7207 = select(_e7000, _e7205, (_e7205 < _e7000));
let _e7213 = global_4.member[bitcast<u32>(select(0i, _e7207, (_e7207 > 0i)))];
let _e7214 = (_e6998 + 13i);
let _e7216 = select(_e7000, _e7214, (_e7214 < _e7000));
let _e7222 = global_4.member[bitcast<u32>(select(0i, _e7216, (_e7216 > 0i)))];
let _e7223 = (_e6998 + 14i);
let _e7225 = select(_e7000, _e7223, (_e7223 < _e7000));
let _e7231 = global_4.member[bitcast<u32>(select(0i, _e7225, (_e7225 > 0i)))];
let _e7238 = (_e6998 + 15i);
let _e7240 = select(_e7000, _e7238, (_e7238 < _e7000));
let _e7246 = global_4.member[bitcast<u32>(select(0i, _e7240, (_e7240 > 0i)))];
let _e7247 = (_e6998 + 16i);
let _e7249 = select(_e7000, _e7247, (_e7247 < _e7000));
let _e7255 = global_4.member[bitcast<u32>(select(0i, _e7249, (_e7249 > 0i)))];
let _e7256 = (_e6998 + 17i);
let _e7258 = select(_e7000, _e7256, (_e7256 < _e7000));
let _e7264 = global_4.member[bitcast<u32>(select(0i, _e7258, (_e7258 > 0i)))];
let _e7268 = (((_e7183 * _e7157) + (_e7213 * _e7158)) + (_e7246 * _e7159));
let _e7269 = (((_e7192 * _e7157) + (_e7222 * _e7158)) + (_e7255 * _e7159));
let _e7270 = (((_e7201 * _e7157) + (_e7231 * _e7158)) + (_e7264 * _e7159));
let _e7275 = (((_e7268 * _e7268) + (_e7269 * _e7269)) + (_e7270 * _e7270));
let _e7278 = sqrt(select(0f, _e7275, (_e7275 > 0f)));
let _e7281 = (1f / select(1e-20f, _e7278, (_e7278 > 1e-20f)));
let _e7286 = (_e6998 + 18i);
let _e7288 = select(_e7000, _e7286, (_e7286 < _e7000));
let _e7294 = global_4.member[bitcast<u32>(select(0i, _e7288, (_e7288 > 0i)))];
let _e7303 = (select(select(0i, select(select(i32(_e7294), i32(-2147483648), (_e7294 < -2147483600f)), 2147483647i, (_e7294 > 2147483500f)), (_e7294 == _e7294)), _e6898, ((_e6995 & 4u) != 0u)) * 10i);
let _e7305 = (bitcast<i32>(_e169) - 1i);
let _e7307 = select(_e7305, _e7303, (_e7303 < _e7305));
let _e7313 = global_5.member[bitcast<u32>(select(0i, _e7307, (_e7307 > 0i)))];
let _e7314 = (_e7303 + 1i);
let _e7316 = select(_e7305, _e7314, (_e7314 < _e7305));
let _e7322 = global_5.member[bitcast<u32>(select(0i, _e7316, (_e7316 > 0i)))];
let _e7323 = (_e7303 + 2i);
let _e7325 = select(_e7305, _e7323, (_e7323 < _e7305));
let _e7331 = global_5.member[bitcast<u32>(select(0i, _e7325, (_e7325 > 0i)))];
let _e7335 = (_e7303 + 3i);
let _e7337 = select(_e7305, _e7335, (_e7335 < _e7305));
let _e7343 = global_5.member[bitcast<u32>(select(0i, _e7337, (_e7337 > 0i)))];
let _e7344 = (_e7303 + 4i);
let _e7346 = select(_e7305, _e7344, (_e7344 < _e7305));
let _e7352 = global_5.member[bitcast<u32>(select(0i, _e7346, (_e7346 > 0i)))];
let _e7353 = (_e7303 + 5i);
let _e7355 = select(_e7305, _e7353, (_e7353 < _e7305));
let _e7361 = global_5.member[bitcast<u32>(select(0i, _e7355, (_e7355 > 0i)))];
let _e7368 = (_e7303 + 6i);
let _e7370 = select(_e7305, _e7368, (_e7368 < _e7305));
let _e7376 = global_5.member[bitcast<u32>(select(0i, _e7370, (_e7370 > 0i)))];
let _e7377 = (_e7303 + 7i);
let _e7379 = select(_e7305, _e7377, (_e7377 < _e7305));
let _e7385 = global_5.member[bitcast<u32>(select(0i, _e7379, (_e7379 > 0i)))];
let _e7386 = (_e7303 + 8i);
let _e7388 = select(_e7305, _e7386, (_e7386 < _e7305));
let _e7394 = global_5.member[bitcast<u32>(select(0i, _e7388, (_e7388 > 0i)))];
let _e7402 = (_e7303 + 9i);
let _e7404 = select(_e7305, _e7402, (_e7402 < _e7305));
let _e7410 = global_5.member[bitcast<u32>(select(0i, _e7404, (_e7404 > 0i)))];
phi_11998_ = type_28(_e6947, vec3<f32>((_e7089 * _e7170), (_e7092 * _e7170), (_e7095 * _e7170)), vec3<f32>((_e7268 * _e7281), (_e7269 * _e7281), (_e7270 * _e7281)), vec3<f32>((((_e7313 * _e7157) + (_e7343 * _e7158)) + (_e7376 * _e7159)), (((_e7322 * _e7157) + (_e7352 * _e7158)) + (_e7385 * _e7159)), (((_e7331 * _e7157) + (_e7361 * _e7158)) + (_e7394 * _e7159))), _e7410, true, false);
}
let _e7413 = phi_11998_;
let _e7422 = (((_e7413.member_1.x * _e5774) + (_e7413.member_1.y * _e5775)) + (_e7413.member_1.z * _e5776));
let _e7424 = select(1f, -1f, (_e7422 > 0f));
let _e7436 = select(_e7424, -(_e7424), ((((_e7413.member_2.x * _e7413.member_1.x) + (_e7413.member_2.y * _e7413.member_1.y)) + (_e7413.member_2.z * _e7413.member_1.z)) < 0f));
let _e7437 = (_e7413.member_2.x * _e7436);
let _e7438 = (_e7413.member_2.y * _e7436);
let _e7439 = (_e7413.member_2.z * _e7436);
let _e7448 = ((((_e7437 * _e5774) + (_e7438 * _e5775)) + (_e7439 * _e5776)) > 0f);
let _e7449 = select(_e7437, (_e7413.member_1.x * _e7424), _e7448);
let _e7450 = select(_e7438, (_e7413.member_1.y * _e7424), _e7448);
let _e7451 = select(_e7439, (_e7413.member_1.z * _e7424), _e7448);
let _e7456 = global_1.member.member_19.member_2;
let _e7464 = global_1.member.member_19.member;
let _e7465 = (_e7464 == 0u);
if _e7465 {
let _e7469 = global_1.member.member_19.member_1;
phi_12588_ = type_27(vec3<f32>(_e7469.member, _e7469.member_1, _e7469.member_2), vec3<f32>(_e7456.member, _e7456.member_1, _e7456.member_2));
} else {
let _e7478 = global_1.member.member_19.member_3;
let _e7483 = (_e7413.member.x - _e7478.member);
let _e7485 = (_e7413.member.y - _e7478.member_1);
let _e7487 = (_e7413.member.z - _e7478.member_2);
let _e7492 = (((_e7483 * _e7483) + (_e7485 * _e7485)) + (_e7487 * _e7487));
let _e7494 = select(1e-12f, _e7492, (_e7492 > 1e-12f));
let _e7495 = (1f / _e7494);
let _e7499 = vec3<f32>((_e7456.member * _e7495), (_e7456.member_1 * _e7495), (_e7456.member_2 * _e7495));
if (_e7464 == 2u) {
let _e7504 = global_1.member.member_19.member_1;
let _e7512 = (((_e7504.member * _e7483) + (_e7504.member_1 * _e7485)) + (_e7504.member_2 * _e7487));
let _e7515 = (1f / select(1e-20f, _e7512, (_e7512 > 1e-20f)));
let _e7520 = global_1.member.member_19.member_4.member;
let _e7529 = ((((_e7520.member * _e7483) + (_e7520.member_1 * _e7485)) + (_e7520.member_2 * _e7487)) * _e7515);
let _e7534 = global_1.member.member_19.member_4.member_1;
let _e7543 = ((((_e7534.member * _e7483) + (_e7534.member_1 * _e7485)) + (_e7534.member_2 * _e7487)) * _e7515);
let _e7548 = global_1.member.member_19.member_4.member_2;
let _e7551 = ((_e7529 * _e7529) + (_e7543 * _e7543));
let _e7560 = global_1.member.member_19.member_4.member_3;
let _e7561 = ((_e7548 - sqrt(select(0f, _e7551, (_e7551 > 0f)))) * _e7560);
let _e7563 = select(0f, _e7561, (_e7561 > 0f));
let _e7565 = select(1f, _e7563, (_e7563 < 1f));
let _e7571 = select(0f, ((_e7565 * _e7565) * (3f - (2f * _e7565))), (_e7512 > 0f));
let _e7576 = global_1.member.member_19.member_4.member_5;
if ((_e7576 > 0u) && (_e7571 > 0f)) {
let _e7580 = (0.5f / _e7548);
let _e7590 = global_1.member.member_19.member_4.member_6;
let _e7591 = bitcast<i32>(_e7590);
local = bitcast<i32>(_e7576);
let _e7592 = local;
let _e7594 = f32((_e7592 - 1i));
let _e7596 = f32((_e7591 - 1i));
let _e7597 = local;
let _e7600 = (((0.5f + (_e7529 * _e7580)) * f32(_e7597)) - 0.5f);
let _e7602 = select(0f, _e7600, (_e7600 > 0f));
let _e7604 = select(_e7594, _e7602, (_e7602 < _e7594));
let _e7607 = (((0.5f - (_e7543 * _e7580)) * f32(_e7591)) - 0.5f);
let _e7609 = select(0f, _e7607, (_e7607 > 0f));
let _e7611 = select(_e7596, _e7609, (_e7609 < _e7596));
let _e7613 = select(0f, _e7604, (_e7604 > 0f));
let _e7615 = select(_e7594, _e7613, (_e7613 < _e7594));
let _e7622 = select(0i, select(select(i32(_e7615), i32(-2147483648), (_e7615 < -2147483600f)), 2147483647i, (_e7615 > 2147483500f)), (_e7615 == _e7615));
let _e7626 = (_e7622 - select(0i, 1i, (_e7615 < f32(_e7622))));
let _e7628 = select(0f, _e7611, (_e7611 > 0f));
let _e7630 = select(_e7596, _e7628, (_e7628 < _e7596));
let _e7637 = select(0i, select(select(i32(_e7630), i32(-2147483648), (_e7630 < -2147483600f)), 2147483647i, (_e7630 > 2147483500f)), (_e7630 == _e7630));
let _e7641 = (_e7637 - select(0i, 1i, (_e7630 < f32(_e7637))));
let _e7643 = (_e7604 - f32(_e7626));
let _e7645 = (_e7611 - f32(_e7641));
let _e7646 = (_e7626 + 1i);
let _e7647 = local;
let _e7649 = select(_e7626, _e7646, (_e7646 < _e7647));
let _e7650 = (_e7641 + 1i);
let _e7652 = select(_e7641, _e7650, (_e7650 < _e7591));
let _e7657 = global_1.member.member_19.member_4.member_4;
let _e7658 = bitcast<i32>(_e7657);
let _e7659 = local;
let _e7663 = (_e7658 + (3i * ((_e7641 * _e7659) + _e7626)));
let _e7665 = (bitcast<i32>(_e165) - 1i);
let _e7667 = select(_e7665, _e7663, (_e7663 < _e7665));
let _e7672 = global_3.member[bitcast<u32>(select(0i, _e7667, (_e7667 > 0i)))];
let _e7673 = (_e7663 + 1i);
let _e7675 = select(_e7665, _e7673, (_e7673 < _e7665));
let _e7680 = global_3.member[bitcast<u32>(select(0i, _e7675, (_e7675 > 0i)))];
let _e7681 = (_e7663 + 2i);
let _e7683 = select(_e7665, _e7681, (_e7681 < _e7665));
let _e7688 = global_3.member[bitcast<u32>(select(0i, _e7683, (_e7683 > 0i)))];
let _e7689 = local;
let _e7693 = (_e7658 + (3i * ((_e7641 * _e7689) + _e7649)));
let _e7695 = select(_e7665, _e7693, (_e7693 < _e7665));
let _e7700 = global_3.member[bitcast<u32>(select(0i, _e7695, (_e7695 > 0i)))];
let _e7701 = (_e7693 + 1i);
let _e7703 = select(_e7665, _e7701, (_e7701 < _e7665));
let _e7708 = global_3.member[bitcast<u32>(select(0i, _e7703, (_e7703 > 0i)))];
let _e7709 = (_e7693 + 2i);
let _e7711 = select(_e7665, _e7709, (_e7709 < _e7665));
let _e7716 = global_3.member[bitcast<u32>(select(0i, _e7711, (_e7711 > 0i)))];
let _e7717 = local;
let _e7721 = (_e7658 + (3i * ((_e7652 * _e7717) + _e7626)));
let _e7723 = select(_e7665, _e7721, (_e7721 < _e7665));
let _e7728 = global_3.member[bitcast<u32>(select(0i, _e7723, (_e7723 > 0i)))];
let _e7729 = (_e7721 + 1i);
let _e7731 = select(_e7665, _e7729, (_e7729 < _e7665));
let _e7736 = global_3.member[bitcast<u32>(select(0i, _e7731, (_e7731 > 0i)))];
let _e7737 = (_e7721 + 2i);
let _e7739 = select(_e7665, _e7737, (_e7737 < _e7665));
let _e7744 = global_3.member[bitcast<u32>(select(0i, _e7739, (_e7739 > 0i)))];
let _e7745 = local;
let _e7749 = (_e7658 + (3i * ((_e7652 * _e7745) + _e7649)));
let _e7751 = select(_e7665, _e7749, (_e7749 < _e7665));
let _e7756 = global_3.member[bitcast<u32>(select(0i, _e7751, (_e7751 > 0i)))];
let _e7757 = (_e7749 + 1i);
let _e7759 = select(_e7665, _e7757, (_e7757 < _e7665));
let _e7764 = global_3.member[bitcast<u32>(select(0i, _e7759, (_e7759 > 0i)))];
let _e7765 = (_e7749 + 2i);
let _e7767 = select(_e7665, _e7765, (_e7765 < _e7665));
let _e7772 = global_3.member[bitcast<u32>(select(0i, _e7767, (_e7767 > 0i)))];
let _e7779 = (_e7672 + ((_e7700 - _e7672) * _e7643));
let _e7780 = (_e7680 + ((_e7708 - _e7680) * _e7643));
let _e7781 = (_e7688 + ((_e7716 - _e7688) * _e7643));
phi_12572_ = vec3<f32>(((_e7779 + (((_e7728 + ((_e7756 - _e7728) * _e7643)) - _e7779) * _e7645)) * _e7571), ((_e7780 + (((_e7736 + ((_e7764 - _e7736) * _e7643)) - _e7780) * _e7645)) * _e7571), ((_e7781 + (((_e7744 + ((_e7772 - _e7744) * _e7643)) - _e7781) * _e7645)) * _e7571));
} else {
phi_12572_ = vec3(_e7571);
}
let _e7806 = phi_12572_;
phi_12575_ = (_e7499 * _e7806);
} else {
phi_12575_ = _e7499;
}
let _e7809 = phi_12575_;
let _e7813 = (1f / sqrt(select(0f, _e7494, (_e7494 > 0f))));
phi_12588_ = type_27(vec3<f32>((_e7483 * _e7813), (_e7485 * _e7813), (_e7487 * _e7813)), _e7809);
}
let _e7820 = phi_12588_;
let _e7831 = -((((_e7449 * _e7820.member.x) + (_e7450 * _e7820.member.y)) + (_e7451 * _e7820.member.z)));
let _e7836 = (((_e7413.member_1.x * _e7820.member.x) + (_e7413.member_1.y * _e7820.member.y)) + (_e7413.member_1.z * _e7820.member.z));
let _e7841 = -(_e7831);
let _e7846 = select((select(0f, _e7841, (_e7841 > 0f)) * _e7413.member_4), select(0f, _e7831, (_e7831 > 0f)), ((_e7836 * _e7422) > 0f));
let _e7847 = -(_e7836);
let _e7848 = -(_e7847);
let _e7850 = select(_e7848, _e7847, (_e7847 > _e7848));
let _e7856 = global_1.member.member_21.member_6;
let _e7870 = ((((_e7856.member.member * _e7413.member.x) + (_e7856.member.member_1 * _e7413.member.y)) + (_e7856.member.member_2 * _e7413.member.z)) + _e7856.member_1);
let _e7872 = select(1f, _e7870, (_e7870 > 1e-6f));
let _e7876 = global_1.member.member_21.member_4;
let _e7888 = (((((_e7876.member.member * _e7413.member.x) + (_e7876.member.member_1 * _e7413.member.y)) + (_e7876.member.member_2 * _e7413.member.z)) + _e7876.member_1) / _e7872);
let _e7892 = global_1.member.member_21.member_5;
let _e7904 = (((((_e7892.member.member * _e7413.member.x) + (_e7892.member.member_1 * _e7413.member.y)) + (_e7892.member.member_2 * _e7413.member.z)) + _e7892.member_1) / _e7872);
let _e7908 = global_1.member.member_21.member_2;
let _e7917 = -((((_e7413.member_1.x * _e7908.member) + (_e7413.member_1.y * _e7908.member_1)) + (_e7413.member_1.z * _e7908.member_2)));
let _e7918 = -(_e7917);
let _e7920 = select(_e7918, _e7917, (_e7917 > _e7918));
let _e7922 = select(1f, _e7920, (_e7920 < 1f));
let _e7924 = (1f - (_e7922 * _e7922));
let _e7931 = global_1.member.member_21.member_8;
let _e7932 = (1.4142135f * _e7931);
let _e7939 = global_1.member.member_21.member_7.member;
let _e7944 = global_1.member.member_21.member_7.member_2;
let _e7946 = (_e7939 + (_e7944 * _e7888));
let _e7951 = global_1.member.member_21.member_7.member_1;
let _e7953 = (_e7951 + (_e7944 * _e7904));
let _e7957 = ((1f + (_e7946 * _e7946)) + (_e7953 * _e7953));
let _e7966 = global_1.member.member_21.member_9;
let _e7970 = (select(1f, -1f, (_e7847 < 0f)) * ((((_e7932 * sqrt(select(0f, _e7924, (_e7924 > 0f)))) * _e7870) + (select(1f, _e7850, (_e7850 < 1f)) * sqrt(select(0f, _e7957, (_e7957 > 0f))))) * _e7966));
let _e7975 = select(0f, 1f, _e7413.member_5);
let _e7979 = (_e7413.member.x + ((_e7413.member_1.x * _e7970) * _e7975));
let _e7980 = (_e7413.member.y + ((_e7413.member_1.y * _e7970) * _e7975));
let _e7981 = (_e7413.member.z + ((_e7413.member_1.z * _e7970) * _e7975));
let _e7985 = global_1.member.member_21.member_11;
let _e7986 = bitcast<i32>(_e7985);
let _e7990 = global_1.member.member_21.member_1;
let _e7991 = bitcast<i32>(_e7990);
let _e7996 = global_1.member.member_21.member.member_1;
let _e7997 = bitcast<i32>(_e7996);
let _e8002 = global_1.member.member_21.member.member_2;
let _e8003 = bitcast<i32>(_e8002);
let _e8009 = ((((_e7856.member.member * _e7979) + (_e7856.member.member_1 * _e7980)) + (_e7856.member.member_2 * _e7981)) + _e7856.member_1);
let _e8011 = select(1f, _e8009, (_e8009 > 1e-6f));
let _e8015 = global_1.member.member_21.member_3;
let _e8026 = ((((_e8015.member.member * _e7979) + (_e8015.member.member_1 * _e7980)) + (_e8015.member.member_2 * _e7981)) + _e8015.member_1);
let _e8041 = ((((((_e7876.member.member * _e7979) + (_e7876.member.member_1 * _e7980)) + (_e7876.member.member_2 * _e7981)) + _e7876.member_1) / _e8011) - 0.5f);
let _e8042 = ((((((_e7892.member.member * _e7979) + (_e7892.member.member_1 * _e7980)) + (_e7892.member.member_2 * _e7981)) + _e7892.member_1) / _e8011) - 0.5f);
let _e8046 = global_1.member.member_21.member_10;
let _e8047 = (_e8046 > 0f);
if (_e8047 && (_e7991 > 0i)) {
let _e8054 = global_1.member.member_21.member.member;
let _e8061 = (_e8046 * select(0f, _e8026, (_e8026 > 0f)));
let _e8062 = (16f - 1f);
let _e8066 = (select(_e8062, _e8061, (_e8061 < _e8062)) * (1f / 3f));
phi_12931_ = -3i;
phi_12934_ = -3i;
phi_12936_ = 0f;
phi_12938_ = 0f;
loop {
let _e8068 = phi_12931_;
let _e8070 = phi_12934_;
let _e8072 = phi_12936_;
let _e8074 = phi_12938_;
local_135 = _e8074;
local_136 = _e8074;
local_137 = _e8074;
local_138 = _e8072;
let _e8075 = (_e8068 <= 3i);
if _e8075 {
let _e8077 = (f32(_e8070) * _e8066);
let _e8079 = (f32(_e8068) * _e8066);
let _e8081 = ((_e8041 + _e8077) + 0.5f);
let _e8082 = f32(_e7997);
let _e8084 = select(-1f, _e8081, (_e8081 > -1f));
let _e8086 = select(_e8082, _e8084, (_e8084 < _e8082));
let _e8093 = select(0i, select(select(i32(_e8086), i32(-2147483648), (_e8086 < -2147483600f)), 2147483647i, (_e8086 > 2147483500f)), (_e8086 == _e8086));
let _e8097 = (_e8093 - select(0i, 1i, (_e8086 < f32(_e8093))));
let _e8099 = ((_e8042 + _e8079) + 0.5f);
let _e8100 = f32(_e8003);
let _e8102 = select(-1f, _e8099, (_e8099 > -1f));
let _e8104 = select(_e8100, _e8102, (_e8102 < _e8100));
let _e8111 = select(0i, select(select(i32(_e8104), i32(-2147483648), (_e8104 < -2147483600f)), 2147483647i, (_e8104 > 2147483500f)), (_e8104 == _e8104));
let _e8115 = (_e8111 - select(0i, 1i, (_e8104 < f32(_e8111))));
let _e8122 = ((((_e8097 >= 0i) && (_e8097 < _e7997)) && (_e8115 >= 0i)) && (_e8115 < _e8003));
if _e8122 {
phi_13014_ = ((_e8115 * _e7997) + _e8097);
} else {
phi_13014_ = 0i;
}
let _e8126 = phi_13014_;
let _e8131 = ((_e8077 * _e8077) + (_e8079 * _e8079));
let _e8135 = (sqrt(select(0f, _e8131, (_e8131 > 0f))) - _e7932);
let _e8138 = (1.2247449f * _e8046);
let _e8143 = (_e8026 - select(0f, (select(0f, _e8135, (_e8135 > 0f)) / select(1e-6f, _e8138, (_e8138 > 1e-6f))), _e8047));
let _e8145 = f32(bitcast<i32>(_e8054));
let _e8146 = (_e8145 - 1f);
let _e8148 = select(0f, _e8143, (_e8143 > 0f));
let _e8150 = select(_e8146, _e8148, (_e8148 < _e8146));
let _e8157 = select(0i, select(select(i32(_e8150), i32(-2147483648), (_e8150 < -2147483600f)), 2147483647i, (_e8150 > 2147483500f)), (_e8150 == _e8150));
let _e8161 = (_e8157 - select(0i, 1i, (_e8150 < f32(_e8157))));
let _e8164 = (_e8143 - f32(_e8161));
let _e8168 = (4i * (_e7986 + (_e8126 * bitcast<i32>(((_e8054 + 2u) >> bitcast<u32>(1i))))));
let _e8170 = (_e8168 + (2i * _e8161));
let _e8172 = (_e8170 >> bitcast<u32>(2i));
let _e8175 = bitcast<u32>(((_e8170 & 3i) * 8i));
let _e8177 = (bitcast<i32>(_e171) - 1i);
let _e8179 = select(_e8177, _e8172, (_e8172 < _e8177));
let _e8185 = global_6.member[bitcast<u32>(select(0i, _e8179, (_e8179 > 0i)))];
let _e8189 = (_e8172 + 1i);
let _e8191 = select(_e8177, _e8189, (_e8189 < _e8177));
let _e8197 = global_6.member[bitcast<u32>(select(0i, _e8191, (_e8191 > 0i)))];
let _e8204 = ((_e8185 >> bitcast<u32>((_e8175 & 31u))) | ((_e8197 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8175) & 31u))));
let _e8207 = f32(bitcast<i32>((_e8204 & 65535u)));
let _e8215 = (1f / 65535f);
let _e8218 = select(0f, (1f - ((_e8207 + ((f32(bitcast<i32>((_e8204 >> bitcast<u32>(16i)))) - _e8207) * select(1f, select(0f, _e8164, (_e8164 > 0f)), (_e8143 < _e8145)))) * _e8215)), _e8122);
if (_e8218 > 1e-4f) {
phi_13163_ = 0i;
phi_13166_ = _e8148;
phi_13168_ = 0f;
loop {
let _e8221 = phi_13163_;
let _e8223 = phi_13166_;
let _e8225 = phi_13168_;
local_134 = _e8223;
let _e8226 = (_e8221 < 10i);
if _e8226 {
let _e8228 = (0.5f * (_e8225 + _e8223));
let _e8230 = select(0f, _e8228, (_e8228 > 0f));
let _e8232 = select(_e8146, _e8230, (_e8230 < _e8146));
let _e8239 = select(0i, select(select(i32(_e8232), i32(-2147483648), (_e8232 < -2147483600f)), 2147483647i, (_e8232 > 2147483500f)), (_e8232 == _e8232));
let _e8243 = (_e8239 - select(0i, 1i, (_e8232 < f32(_e8239))));
let _e8246 = (_e8228 - f32(_e8243));
let _e8251 = (_e8168 + (2i * _e8243));
let _e8253 = (_e8251 >> bitcast<u32>(2i));
let _e8256 = bitcast<u32>(((_e8251 & 3i) * 8i));
let _e8258 = select(_e8177, _e8253, (_e8253 < _e8177));
let _e8264 = global_6.member[bitcast<u32>(select(0i, _e8258, (_e8258 > 0i)))];
let _e8268 = (_e8253 + 1i);
let _e8270 = select(_e8177, _e8268, (_e8268 < _e8177));
let _e8276 = global_6.member[bitcast<u32>(select(0i, _e8270, (_e8270 > 0i)))];
let _e8283 = ((_e8264 >> bitcast<u32>((_e8256 & 31u))) | ((_e8276 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8256) & 31u))));
let _e8286 = f32(bitcast<i32>((_e8283 & 65535u)));
let _e8297 = (((_e8286 + ((f32(bitcast<i32>((_e8283 >> bitcast<u32>(16i)))) - _e8286) * select(1f, select(0f, _e8246, (_e8246 > 0f)), (_e8228 < _e8145)))) * _e8215) > (1f - (0.5f * _e8218)));
phi_13164_ = (_e8221 + 1i);
phi_13167_ = select(_e8228, _e8223, _e8297);
phi_13169_ = select(_e8225, _e8228, _e8297);
} else {
phi_13164_ = i32();
phi_13167_ = f32();
phi_13169_ = f32();
}
let _e8302 = phi_13164_;
let _e8304 = phi_13167_;
let _e8306 = phi_13169_;
continue;
continuing {
phi_13163_ = _e8302;
phi_13166_ = _e8304;
phi_13168_ = _e8306;
break if !(_e8226);
}
}
let _e8310 = local_134;
phi_13289_ = (_e8072 + (_e8218 * _e8310));
phi_13290_ = (_e8074 + _e8218);
} else {
phi_13289_ = _e8072;
phi_13290_ = _e8074;
}
let _e8314 = phi_13289_;
let _e8316 = phi_13290_;
let _e8317 = (_e8070 == 3i);
if _e8317 {
phi_13296_ = -3i;
} else {
phi_13296_ = (_e8070 + 1i);
}
let _e8320 = phi_13296_;
phi_12932_ = (_e8068 + select(0i, 1i, _e8317));
phi_12935_ = _e8320;
phi_12937_ = _e8314;
phi_12939_ = _e8316;
} else {
phi_12932_ = i32();
phi_12935_ = i32();
phi_12937_ = f32();
phi_12939_ = f32();
}
let _e8324 = phi_12932_;
let _e8326 = phi_12935_;
let _e8328 = phi_12937_;
let _e8330 = phi_12939_;
continue;
continuing {
phi_12931_ = _e8324;
phi_12934_ = _e8326;
phi_12936_ = _e8328;
phi_12938_ = _e8330;
break if !(_e8075);
}
}
let _e8333 = local_135;
let _e8336 = local_136;
let _e8339 = local_137;
let _e8342 = local_138;
let _e8344 = (_e8026 - (_e8342 / select(1e-4f, _e8339, (_e8336 > 1e-4f))));
let _e8349 = ((1.2247449f * _e8046) * select(0f, select(0f, _e8344, (_e8344 > 0f)), (_e8333 > 0f)));
let _e8352 = ((_e7931 * _e7931) + (_e8349 * _e8349));
let _e8355 = sqrt(select(0f, _e8352, (_e8352 > 0f)));
phi_13340_ = select(16f, _e8355, (_e8355 < 16f));
} else {
phi_13340_ = _e7931;
}
let _e8359 = phi_13340_;
let _e8360 = (_e8041 - _e8359);
let _e8361 = -(16f);
let _e8362 = f32(_e7997);
let _e8364 = select(_e8361, _e8360, (_e8360 > _e8361));
let _e8366 = select(_e8362, _e8364, (_e8364 < _e8362));
let _e8373 = select(0i, select(select(i32(_e8366), i32(-2147483648), (_e8366 < -2147483600f)), 2147483647i, (_e8366 > 2147483500f)), (_e8366 == _e8366));
let _e8379 = (_e8041 + _e8359);
let _e8382 = (f32((_e7997 - 1i)) + 16f);
let _e8384 = select(-1f, _e8379, (_e8379 > -1f));
let _e8386 = select(_e8382, _e8384, (_e8384 < _e8382));
let _e8393 = select(0i, select(select(i32(_e8386), i32(-2147483648), (_e8386 < -2147483600f)), 2147483647i, (_e8386 > 2147483500f)), (_e8386 == _e8386));
let _e8398 = (_e8042 - _e8359);
let _e8399 = f32(_e8003);
let _e8401 = select(_e8361, _e8398, (_e8398 > _e8361));
let _e8403 = select(_e8399, _e8401, (_e8401 < _e8399));
let _e8410 = select(0i, select(select(i32(_e8403), i32(-2147483648), (_e8403 < -2147483600f)), 2147483647i, (_e8403 > 2147483500f)), (_e8403 == _e8403));
let _e8416 = (_e8042 + _e8359);
let _e8419 = (f32((_e8003 - 1i)) + 16f);
let _e8421 = select(-1f, _e8416, (_e8416 > -1f));
let _e8423 = select(_e8419, _e8421, (_e8421 < _e8419));
let _e8430 = select(0i, select(select(i32(_e8423), i32(-2147483648), (_e8423 < -2147483600f)), 2147483647i, (_e8423 > 2147483500f)), (_e8423 == _e8423));
let _e8439 = global_1.member.member_21.member.member;
let _e8443 = bitcast<i32>(((_e8439 + 2u) >> bitcast<u32>(1i)));
let _e8445 = ((_e7997 * _e8003) * _e8443);
phi_13458_ = 0f;
phi_13461_ = vec3<f32>(0f, 0f, 0f);
phi_13463_ = ((_e8410 - select(0i, 1i, (_e8403 < f32(_e8410)))) + 1i);
loop {
let _e8447 = phi_13458_;
let _e8449 = phi_13461_;
let _e8451 = phi_13463_;
local_139 = _e8447;
local_140 = _e8447;
local_141 = _e8449;
local_142 = _e8449;
local_143 = _e8449;
let _e8452 = (_e8451 <= (_e8430 - select(0i, 1i, (_e8423 < f32(_e8430)))));
if _e8452 {
let _e8454 = (f32(_e8451) - _e8042);
let _e8458 = (_e8359 - bitcast<f32>((bitcast<u32>(_e8454) & 2147483647u)));
phi_13478_ = ((_e8373 - select(0i, 1i, (_e8366 < f32(_e8373)))) + 1i);
phi_13481_ = _e8447;
phi_13483_ = _e8449;
loop {
let _e8460 = phi_13478_;
let _e8462 = phi_13481_;
let _e8464 = phi_13483_;
local_158 = _e8462;
local_159 = _e8464;
let _e8465 = (_e8460 <= (_e8393 - select(0i, 1i, (_e8386 < f32(_e8393)))));
if _e8465 {
let _e8467 = (f32(_e8460) - _e8041);
let _e8471 = (_e8359 - bitcast<f32>((bitcast<u32>(_e8467) & 2147483647u)));
let _e8476 = (select(0f, _e8471, (_e8471 > 0f)) * select(0f, _e8458, (_e8458 > 0f)));
if ((((_e8460 >= 0i) && (_e8460 < _e7997)) && (_e8451 >= 0i)) && (_e8451 < _e8003)) {
let _e8487 = (_e7986 + (((_e8451 * _e7997) + _e8460) * _e8443));
let _e8490 = ((_e8467 * _e8467) + (_e8454 * _e8454));
let _e8494 = (sqrt(select(0f, _e8490, (_e8490 > 0f))) - _e7932);
let _e8497 = (1.2247449f * _e8046);
let _e8502 = (_e8026 - select(0f, (select(0f, _e8494, (_e8494 > 0f)) / select(1e-6f, _e8497, (_e8497 > 1e-6f))), _e8047));
let _e8504 = f32(bitcast<i32>(_e8439));
let _e8505 = (_e8504 - 1f);
let _e8507 = select(0f, _e8502, (_e8502 > 0f));
let _e8509 = select(_e8505, _e8507, (_e8507 < _e8505));
let _e8516 = select(0i, select(select(i32(_e8509), i32(-2147483648), (_e8509 < -2147483600f)), 2147483647i, (_e8509 > 2147483500f)), (_e8509 == _e8509));
let _e8520 = (_e8516 - select(0i, 1i, (_e8509 < f32(_e8516))));
let _e8523 = (_e8502 - f32(_e8520));
let _e8526 = select(1f, select(0f, _e8523, (_e8523 > 0f)), (_e8502 < _e8504));
let _e8528 = (2i * _e8520);
let _e8529 = ((4i * _e8487) + _e8528);
let _e8531 = (_e8529 >> bitcast<u32>(2i));
let _e8534 = bitcast<u32>(((_e8529 & 3i) * 8i));
let _e8536 = (bitcast<i32>(_e171) - 1i);
let _e8538 = select(_e8536, _e8531, (_e8531 < _e8536));
let _e8544 = global_6.member[bitcast<u32>(select(0i, _e8538, (_e8538 > 0i)))];
let _e8548 = (_e8531 + 1i);
let _e8550 = select(_e8536, _e8548, (_e8548 < _e8536));
let _e8556 = global_6.member[bitcast<u32>(select(0i, _e8550, (_e8550 > 0i)))];
let _e8563 = ((_e8544 >> bitcast<u32>((_e8534 & 31u))) | ((_e8556 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8534) & 31u))));
let _e8566 = f32(bitcast<i32>((_e8563 & 65535u)));
let _e8574 = (1f / 65535f);
let _e8576 = (_e8476 * ((_e8566 + ((f32(bitcast<i32>((_e8563 >> bitcast<u32>(16i)))) - _e8566) * _e8526)) * _e8574));
let _e8578 = (_e8464.x + _e8576);
if (_e7991 > 1i) {
let _e8582 = ((4i * (_e8487 + _e8445)) + _e8528);
let _e8584 = (_e8582 >> bitcast<u32>(2i));
let _e8587 = bitcast<u32>(((_e8582 & 3i) * 8i));
let _e8589 = select(_e8536, _e8584, (_e8584 < _e8536));
let _e8595 = global_6.member[bitcast<u32>(select(0i, _e8589, (_e8589 > 0i)))];
let _e8599 = (_e8584 + 1i);
let _e8601 = select(_e8536, _e8599, (_e8599 < _e8536));
let _e8607 = global_6.member[bitcast<u32>(select(0i, _e8601, (_e8601 > 0i)))];
let _e8614 = ((_e8595 >> bitcast<u32>((_e8587 & 31u))) | ((_e8607 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8587) & 31u))));
let _e8617 = f32(bitcast<i32>((_e8614 & 65535u)));
let _e8632 = ((4i * (_e8487 + (2i * _e8445))) + _e8528);
let _e8634 = (_e8632 >> bitcast<u32>(2i));
let _e8637 = bitcast<u32>(((_e8632 & 3i) * 8i));
let _e8639 = select(_e8536, _e8634, (_e8634 < _e8536));
let _e8645 = global_6.member[bitcast<u32>(select(0i, _e8639, (_e8639 > 0i)))];
let _e8649 = (_e8634 + 1i);
let _e8651 = select(_e8536, _e8649, (_e8649 < _e8536));
let _e8657 = global_6.member[bitcast<u32>(select(0i, _e8651, (_e8651 > 0i)))];
let _e8664 = ((_e8645 >> bitcast<u32>((_e8637 & 31u))) | ((_e8657 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8637) & 31u))));
let _e8667 = f32(bitcast<i32>((_e8664 & 65535u)));
phi_13872_ = vec3<f32>(_e8578, (_e8464.y + (_e8476 * ((_e8617 + ((f32(bitcast<i32>((_e8614 >> bitcast<u32>(16i)))) - _e8617) * _e8526)) * _e8574))), (_e8464.z + (_e8476 * ((_e8667 + ((f32(bitcast<i32>((_e8664 >> bitcast<u32>(16i)))) - _e8667) * _e8526)) * _e8574))));
} else {
phi_13872_ = vec3<f32>(_e8578, (_e8464.y + _e8576), (_e8464.z + _e8576));
}
let _e8686 = phi_13872_;
phi_13882_ = _e8686;
} else {
phi_13882_ = vec3<f32>((_e8464.x + _e8476), (_e8464.y + _e8476), (_e8464.z + _e8476));
}
let _e8695 = phi_13882_;
phi_13479_ = (_e8460 + 1i);
phi_13482_ = (_e8462 + _e8476);
phi_13484_ = _e8695;
} else {
phi_13479_ = i32();
phi_13482_ = f32();
phi_13484_ = vec3<f32>();
}
let _e8699 = phi_13479_;
let _e8701 = phi_13482_;
let _e8703 = phi_13484_;
continue;
continuing {
phi_13478_ = _e8699;
phi_13481_ = _e8701;
phi_13483_ = _e8703;
break if !(_e8465);
}
}
let _e10543 = local_158;
phi_13459_ = _e10543;
let _e10546 = local_159;
phi_13462_ = _e10546;
phi_13464_ = (_e8451 + 1i);
} else {
phi_13459_ = f32();
phi_13462_ = vec3<f32>();
phi_13464_ = i32();
}
let _e8707 = phi_13459_;
let _e8709 = phi_13462_;
let _e8711 = phi_13464_;
continue;
continuing {
phi_13458_ = _e8707;
phi_13461_ = _e8709;
phi_13463_ = _e8711;
break if !(_e8452);
}
}
let _e8715 = local_139;
let _e8719 = (((_e7991 == 0i) || (_e8715 <= 0f)) || (_e8009 <= 1e-6f));
let _e8721 = local_140;
let _e8723 = (1f / select(_e8721, 1f, _e8719));
let _e8725 = local_141;
let _e8730 = local_142;
let _e8735 = local_143;
let _e8739 = (select((_e8725.x * _e8723), 1f, _e8719) * _e7846);
let _e8740 = (select((_e8730.y * _e8723), 1f, _e8719) * _e7846);
let _e8741 = (select((_e8735.z * _e8723), 1f, _e8719) * _e7846);
let _e8752 = global_1.member.member_1;
if ((_e8752 & 16u) == 0u) {
phi_15785_ = (_e7820.member_1 * vec3<f32>(_e8739, _e8740, _e8741));
} else {
let _e8758 = global_1.member.member_22.member;
let _e8769 = ((((_e8758.member.member * _e7413.member.x) + (_e8758.member.member_1 * _e7413.member.y)) + (_e8758.member.member_2 * _e7413.member.z)) + _e8758.member_1);
let _e8773 = global_1.member.member_22.member_1;
let _e8784 = ((((_e8773.member.member * _e7413.member.x) + (_e8773.member.member_1 * _e7413.member.y)) + (_e8773.member.member_2 * _e7413.member.z)) + _e8773.member_1);
let _e8788 = global_1.member.member_22.member_2;
let _e8799 = ((((_e8788.member.member * _e7413.member.x) + (_e8788.member.member_1 * _e7413.member.y)) + (_e8788.member.member_2 * _e7413.member.z)) + _e8788.member_1);
let _e8806 = global_1.member.member_22.member_18.member.member;
let _e8807 = bitcast<i32>(_e8806);
let _e8813 = global_1.member.member_22.member_18.member.member_1;
let _e8814 = bitcast<i32>(_e8813);
let _e8818 = global_1.member.member_22.member_3;
let _e8827 = global_1.member.member_22.member_19.member_2;
let _e8829 = select(1f, (_e8799 - _e8827), (_e8818 != 0u));
let _e8832 = (1f / select(1e-12f, _e8829, (_e8829 > 1e-12f)));
let _e8837 = global_1.member.member_22.member_5;
let _e8842 = global_1.member.member_22.member_8;
let _e8843 = (((_e8769 * _e8832) - _e8837) * _e8842);
let _e8848 = global_1.member.member_22.member_6;
let _e8850 = (((_e8784 * _e8832) - _e8848) * _e8842);
let _e8855 = global_1.member.member_22.member_4.member;
let _e8857 = f32(bitcast<i32>(_e8855));
let _e8859 = select(0f, _e8843, (_e8843 > 0f));
let _e8866 = global_1.member.member_22.member_18.member_1;
let _e8869 = ((_e8843 - _e8857) * _e8866);
let _e8874 = global_1.member.member_22.member_18.member_2;
let _e8876 = select(0f, _e8869, (_e8869 > 0f));
let _e8878 = (_e8874 + _e8876);
let _e8883 = (-(_e8843) * _e8866);
let _e8885 = select(0f, _e8883, (_e8883 > 0f));
let _e8887 = (_e8874 + _e8885);
let _e8894 = (((_e8874 + (select(_e8857, _e8859, (_e8859 < _e8857)) * _e8866)) + (((_e8876 * _e8874) / select(1e-12f, _e8878, (_e8878 > 1e-12f))) - ((_e8885 * _e8874) / select(1e-12f, _e8887, (_e8887 > 1e-12f))))) - 0.5f);
let _e8899 = global_1.member.member_22.member_4.member_1;
let _e8901 = f32(bitcast<i32>(_e8899));
let _e8903 = select(0f, _e8850, (_e8850 > 0f));
let _e8908 = ((_e8850 - _e8901) * _e8866);
let _e8910 = select(0f, _e8908, (_e8908 > 0f));
let _e8912 = (_e8874 + _e8910);
let _e8917 = (-(_e8850) * _e8866);
let _e8919 = select(0f, _e8917, (_e8917 > 0f));
let _e8921 = (_e8874 + _e8919);
let _e8928 = (((_e8874 + (select(_e8901, _e8903, (_e8903 < _e8901)) * _e8866)) + (((_e8910 * _e8874) / select(1e-12f, _e8912, (_e8912 > 1e-12f))) - ((_e8919 * _e8874) / select(1e-12f, _e8921, (_e8921 > 1e-12f))))) - 0.5f);
let _e8930 = f32((_e8807 - 2i));
let _e8932 = select(0f, _e8894, (_e8894 > 0f));
let _e8934 = select(_e8930, _e8932, (_e8932 < _e8930));
let _e8941 = select(0i, select(select(i32(_e8934), i32(-2147483648), (_e8934 < -2147483600f)), 2147483647i, (_e8934 > 2147483500f)), (_e8934 == _e8934));
let _e8945 = (_e8941 - select(0i, 1i, (_e8934 < f32(_e8941))));
let _e8947 = f32((_e8814 - 2i));
let _e8949 = select(0f, _e8928, (_e8928 > 0f));
let _e8951 = select(_e8947, _e8949, (_e8949 < _e8947));
let _e8958 = select(0i, select(select(i32(_e8951), i32(-2147483648), (_e8951 < -2147483600f)), 2147483647i, (_e8951 > 2147483500f)), (_e8951 == _e8951));
let _e8962 = (_e8958 - select(0i, 1i, (_e8951 < f32(_e8958))));
let _e8964 = (_e8894 - f32(_e8945));
let _e8966 = select(0f, _e8964, (_e8964 > 0f));
let _e8968 = select(1f, _e8966, (_e8966 < 1f));
let _e8970 = (_e8928 - f32(_e8962));
let _e8972 = select(0f, _e8970, (_e8970 > 0f));
let _e8974 = select(1f, _e8972, (_e8972 < 1f));
if _e7413.member_6 {
let _e8979 = global_1.member.member_22.member_18.member_4;
phi_14243_ = _e8979;
} else {
let _e8984 = global_1.member.member_22.member_18.member_3;
phi_14243_ = _e8984;
}
let _e8986 = phi_14243_;
let _e8990 = ((bitcast<i32>(_e8986) + (_e8962 * _e8807)) + _e8945);
let _e8991 = (_e8807 * _e8814);
let _e8993 = (bitcast<i32>(_e171) - 1i);
let _e8995 = select(_e8993, _e8990, (_e8990 < _e8993));
let _e9001 = global_6.member[bitcast<u32>(select(0i, _e8995, (_e8995 > 0i)))];
let _e9002 = bitcast<f32>(_e9001);
let _e9003 = (_e8990 + 1i);
let _e9005 = select(_e8993, _e9003, (_e9003 < _e8993));
let _e9011 = global_6.member[bitcast<u32>(select(0i, _e9005, (_e9005 > 0i)))];
let _e9015 = (_e9002 + ((bitcast<f32>(_e9011) - _e9002) * _e8968));
let _e9016 = (_e8990 + _e8807);
let _e9018 = select(_e8993, _e9016, (_e9016 < _e8993));
let _e9024 = global_6.member[bitcast<u32>(select(0i, _e9018, (_e9018 > 0i)))];
let _e9025 = bitcast<f32>(_e9024);
let _e9026 = (_e9016 + 1i);
let _e9028 = select(_e8993, _e9026, (_e9026 < _e8993));
let _e9034 = global_6.member[bitcast<u32>(select(0i, _e9028, (_e9028 > 0i)))];
let _e9041 = (_e9015 + (((_e9025 + ((bitcast<f32>(_e9034) - _e9025) * _e8968)) - _e9015) * _e8974));
let _e9042 = (_e8990 + _e8991);
let _e9044 = select(_e8993, _e9042, (_e9042 < _e8993));
let _e9050 = global_6.member[bitcast<u32>(select(0i, _e9044, (_e9044 > 0i)))];
let _e9051 = bitcast<f32>(_e9050);
let _e9052 = (_e9042 + 1i);
let _e9054 = select(_e8993, _e9052, (_e9052 < _e8993));
let _e9060 = global_6.member[bitcast<u32>(select(0i, _e9054, (_e9054 > 0i)))];
let _e9064 = (_e9051 + ((bitcast<f32>(_e9060) - _e9051) * _e8968));
let _e9065 = (_e9042 + _e8807);
let _e9067 = select(_e8993, _e9065, (_e9065 < _e8993));
let _e9073 = global_6.member[bitcast<u32>(select(0i, _e9067, (_e9067 > 0i)))];
let _e9074 = bitcast<f32>(_e9073);
let _e9075 = (_e9065 + 1i);
let _e9077 = select(_e8993, _e9075, (_e9075 < _e8993));
let _e9083 = global_6.member[bitcast<u32>(select(0i, _e9077, (_e9077 > 0i)))];
let _e9090 = (_e9064 + (((_e9074 + ((bitcast<f32>(_e9083) - _e9074) * _e8968)) - _e9064) * _e8974));
let _e9092 = (_e8990 + (2i * _e8991));
let _e9094 = select(_e8993, _e9092, (_e9092 < _e8993));
let _e9100 = global_6.member[bitcast<u32>(select(0i, _e9094, (_e9094 > 0i)))];
let _e9101 = bitcast<f32>(_e9100);
let _e9102 = (_e9092 + 1i);
let _e9104 = select(_e8993, _e9102, (_e9102 < _e8993));
let _e9110 = global_6.member[bitcast<u32>(select(0i, _e9104, (_e9104 > 0i)))];
let _e9114 = (_e9101 + ((bitcast<f32>(_e9110) - _e9101) * _e8968));
let _e9115 = (_e9092 + _e8807);
let _e9117 = select(_e8993, _e9115, (_e9115 < _e8993));
let _e9123 = global_6.member[bitcast<u32>(select(0i, _e9117, (_e9117 > 0i)))];
let _e9124 = bitcast<f32>(_e9123);
let _e9125 = (_e9115 + 1i);
let _e9127 = select(_e8993, _e9125, (_e9125 < _e8993));
let _e9133 = global_6.member[bitcast<u32>(select(0i, _e9127, (_e9127 > 0i)))];
let _e9140 = (_e9114 + (((_e9124 + ((bitcast<f32>(_e9133) - _e9124) * _e8968)) - _e9114) * _e8974));
let _e9142 = (_e8818 == 0u);
if _e9142 {
phi_14611_ = vec3<f32>(_e9041, _e9090, _e9140);
} else {
if _e9142 {
phi_14579_ = 1f;
} else {
let _e9143 = global_1.member.member_22.member_19;
let _e9147 = (_e8769 - _e9143.member);
let _e9148 = (_e8784 - _e9143.member_1);
let _e9149 = (_e8799 - _e9143.member_2);
let _e9154 = global_1.member.member_22.member_20.member;
let _e9162 = (((_e9154.member * _e9147) + (_e9154.member_1 * _e9148)) + (_e9154.member_2 * _e9149));
let _e9166 = (_e9147 - (_e9154.member * _e9162));
let _e9167 = (_e9148 - (_e9154.member_1 * _e9162));
let _e9168 = (_e9149 - (_e9154.member_2 * _e9162));
let _e9173 = (((_e9166 * _e9166) + (_e9167 * _e9167)) + (_e9168 * _e9168));
let _e9184 = global_1.member.member_22.member_20.member_1;
let _e9190 = global_1.member.member_22.member_20.member_2;
let _e9191 = ((_e9184 - (sqrt(select(0f, _e9173, (_e9173 > 0f))) / select(1e-20f, _e9162, (_e9162 > 1e-20f)))) * _e9190);
let _e9193 = select(0f, _e9191, (_e9191 > 0f));
let _e9195 = select(1f, _e9193, (_e9193 < 1f));
phi_14579_ = select(1f, select(0f, ((_e9195 * _e9195) * (3f - (2f * _e9195))), (_e9162 > 0f)), (_e9190 > 0f));
}
let _e9205 = phi_14579_;
let _e9206 = global_1.member.member_22.member_19;
let _e9210 = select(0f, 1f, ((_e8799 - _e9206.member_2) > 0f));
let _e9214 = ((_e9041 * _e9210) + _e9205);
let _e9215 = ((_e9090 * _e9210) + _e9205);
let _e9216 = ((_e9140 * _e9210) + _e9205);
phi_14611_ = vec3<f32>(select(0f, _e9214, (_e9214 > 0f)), select(0f, _e9215, (_e9215 > 0f)), select(0f, _e9216, (_e9216 > 0f)));
}
let _e9225 = phi_14611_;
let _e9229 = global_1.member.member_19.member_3;
let _e9233 = (_e7413.member.x - _e9229.member);
let _e9234 = (_e7413.member.y - _e9229.member_1);
let _e9235 = (_e7413.member.z - _e9229.member_2);
let _e9240 = (((_e9233 * _e9233) + (_e9234 * _e9234)) + (_e9235 * _e9235));
let _e9244 = select((1f / select(1e-12f, _e9240, (_e9240 > 1e-12f))), 1f, _e7465);
let _e9257 = global_1.member.member_21.member_12;
let _e9258 = bitcast<i32>(_e9257);
let _e9262 = global_1.member.member_21.member_13;
let _e9263 = bitcast<i32>(_e9262);
let _e9269 = ((((_e8015.member.member * _e7413.member.x) + (_e8015.member.member_1 * _e7413.member.y)) + (_e8015.member.member_2 * _e7413.member.z)) + _e8015.member_1);
let _e9270 = (_e7888 - 0.5f);
let _e9271 = (_e7904 - 0.5f);
if (_e8047 && (_e9263 > 0i)) {
let _e9276 = (_e8046 * select(0f, _e9269, (_e9269 > 0f)));
let _e9277 = (16f - 1f);
let _e9281 = (select(_e9277, _e9276, (_e9276 < _e9277)) * (1f / 3f));
phi_14783_ = -3i;
phi_14786_ = -3i;
phi_14788_ = 0f;
phi_14790_ = 0f;
loop {
let _e9283 = phi_14783_;
let _e9285 = phi_14786_;
let _e9287 = phi_14788_;
let _e9289 = phi_14790_;
local_145 = _e9289;
local_146 = _e9289;
local_147 = _e9289;
local_148 = _e9287;
let _e9290 = (_e9283 <= 3i);
if _e9290 {
let _e9292 = (f32(_e9285) * _e9281);
let _e9294 = (f32(_e9283) * _e9281);
let _e9296 = ((_e9270 + _e9292) + 0.5f);
let _e9298 = select(-1f, _e9296, (_e9296 > -1f));
let _e9300 = select(_e8362, _e9298, (_e9298 < _e8362));
let _e9307 = select(0i, select(select(i32(_e9300), i32(-2147483648), (_e9300 < -2147483600f)), 2147483647i, (_e9300 > 2147483500f)), (_e9300 == _e9300));
let _e9311 = (_e9307 - select(0i, 1i, (_e9300 < f32(_e9307))));
let _e9313 = ((_e9271 + _e9294) + 0.5f);
let _e9315 = select(-1f, _e9313, (_e9313 > -1f));
let _e9317 = select(_e8399, _e9315, (_e9315 < _e8399));
let _e9324 = select(0i, select(select(i32(_e9317), i32(-2147483648), (_e9317 < -2147483600f)), 2147483647i, (_e9317 > 2147483500f)), (_e9317 == _e9317));
let _e9328 = (_e9324 - select(0i, 1i, (_e9317 < f32(_e9324))));
let _e9335 = ((((_e9311 >= 0i) && (_e9311 < _e7997)) && (_e9328 >= 0i)) && (_e9328 < _e8003));
if _e9335 {
phi_14866_ = ((_e9328 * _e7997) + _e9311);
} else {
phi_14866_ = 0i;
}
let _e9339 = phi_14866_;
let _e9344 = ((_e9292 * _e9292) + (_e9294 * _e9294));
let _e9348 = (sqrt(select(0f, _e9344, (_e9344 > 0f))) - _e7932);
let _e9351 = (1.2247449f * _e8046);
let _e9356 = (_e9269 - select(0f, (select(0f, _e9348, (_e9348 > 0f)) / select(1e-6f, _e9351, (_e9351 > 1e-6f))), _e8047));
let _e9358 = f32(bitcast<i32>(_e8439));
let _e9359 = (_e9358 - 1f);
let _e9361 = select(0f, _e9356, (_e9356 > 0f));
let _e9363 = select(_e9359, _e9361, (_e9361 < _e9359));
let _e9370 = select(0i, select(select(i32(_e9363), i32(-2147483648), (_e9363 < -2147483600f)), 2147483647i, (_e9363 > 2147483500f)), (_e9363 == _e9363));
let _e9374 = (_e9370 - select(0i, 1i, (_e9363 < f32(_e9370))));
let _e9377 = (_e9356 - f32(_e9374));
let _e9381 = (4i * (_e9258 + (_e9339 * _e8443)));
let _e9383 = (_e9381 + (2i * _e9374));
let _e9385 = (_e9383 >> bitcast<u32>(2i));
let _e9388 = bitcast<u32>(((_e9383 & 3i) * 8i));
let _e9390 = select(_e8993, _e9385, (_e9385 < _e8993));
let _e9396 = global_6.member[bitcast<u32>(select(0i, _e9390, (_e9390 > 0i)))];
let _e9400 = (_e9385 + 1i);
let _e9402 = select(_e8993, _e9400, (_e9400 < _e8993));
let _e9408 = global_6.member[bitcast<u32>(select(0i, _e9402, (_e9402 > 0i)))];
let _e9415 = ((_e9396 >> bitcast<u32>((_e9388 & 31u))) | ((_e9408 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e9388) & 31u))));
let _e9418 = f32(bitcast<i32>((_e9415 & 65535u)));
let _e9426 = (1f / 65535f);
let _e9429 = select(0f, (1f - ((_e9418 + ((f32(bitcast<i32>((_e9415 >> bitcast<u32>(16i)))) - _e9418) * select(1f, select(0f, _e9377, (_e9377 > 0f)), (_e9356 < _e9358)))) * _e9426)), _e9335);
if (_e9429 > 1e-4f) {
phi_15015_ = 0i;
phi_15018_ = _e9361;
phi_15020_ = 0f;
loop {
let _e9432 = phi_15015_;
let _e9434 = phi_15018_;
let _e9436 = phi_15020_;
local_144 = _e9434;
let _e9437 = (_e9432 < 10i);
if _e9437 {
let _e9439 = (0.5f * (_e9436 + _e9434));
let _e9441 = select(0f, _e9439, (_e9439 > 0f));
let _e9443 = select(_e9359, _e9441, (_e9441 < _e9359));
let _e9450 = select(0i, select(select(i32(_e9443), i32(-2147483648), (_e9443 < -2147483600f)), 2147483647i, (_e9443 > 2147483500f)), (_e9443 == _e9443));
let _e9454 = (_e9450 - select(0i, 1i, (_e9443 < f32(_e9450))));
let _e9457 = (_e9439 - f32(_e9454));
let _e9462 = (_e9381 + (2i * _e9454));
let _e9464 = (_e9462 >> bitcast<u32>(2i));
let _e9467 = bitcast<u32>(((_e9462 & 3i) * 8i));
let _e9469 = select(_e8993, _e9464, (_e9464 < _e8993));
let _e9475 = global_6.member[bitcast<u32>(select(0i, _e9469, (_e9469 > 0i)))];
let _e9479 = (_e9464 + 1i);
let _e9481 = select(_e8993, _e9479, (_e9479 < _e8993));
let _e9487 = global_6.member[bitcast<u32>(select(0i, _e9481, (_e9481 > 0i)))];
let _e9494 = ((_e9475 >> bitcast<u32>((_e9467 & 31u))) | ((_e9487 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e9467) & 31u))));
let _e9497 = f32(bitcast<i32>((_e9494 & 65535u)));
let _e9508 = (((_e9497 + ((f32(bitcast<i32>((_e9494 >> bitcast<u32>(16i)))) - _e9497) * select(1f, select(0f, _e9457, (_e9457 > 0f)), (_e9439 < _e9358)))) * _e9426) > (1f - (0.5f * _e9429)));
phi_15016_ = (_e9432 + 1i);
phi_15019_ = select(_e9439, _e9434, _e9508);
phi_15021_ = select(_e9436, _e9439, _e9508);
} else {
phi_15016_ = i32();
phi_15019_ = f32();
phi_15021_ = f32();
}
let _e9513 = phi_15016_;
let _e9515 = phi_15019_;
let _e9517 = phi_15021_;
continue;
continuing {
phi_15015_ = _e9513;
phi_15018_ = _e9515;
phi_15020_ = _e9517;
break if !(_e9437);
}
}
let _e9521 = local_144;
phi_15141_ = (_e9287 + (_e9429 * _e9521));
phi_15142_ = (_e9289 + _e9429);
} else {
phi_15141_ = _e9287;
phi_15142_ = _e9289;
}
let _e9525 = phi_15141_;
let _e9527 = phi_15142_;
let _e9528 = (_e9285 == 3i);
if _e9528 {
phi_15148_ = -3i;
} else {
phi_15148_ = (_e9285 + 1i);
}
let _e9531 = phi_15148_;
phi_14784_ = (_e9283 + select(0i, 1i, _e9528));
phi_14787_ = _e9531;
phi_14789_ = _e9525;
phi_14791_ = _e9527;
} else {
phi_14784_ = i32();
phi_14787_ = i32();
phi_14789_ = f32();
phi_14791_ = f32();
}
let _e9535 = phi_14784_;
let _e9537 = phi_14787_;
let _e9539 = phi_14789_;
let _e9541 = phi_14791_;
continue;
continuing {
phi_14783_ = _e9535;
phi_14786_ = _e9537;
phi_14788_ = _e9539;
phi_14790_ = _e9541;
break if !(_e9290);
}
}
let _e9544 = local_145;
let _e9547 = local_146;
let _e9550 = local_147;
let _e9553 = local_148;
let _e9555 = (_e9269 - (_e9553 / select(1e-4f, _e9550, (_e9547 > 1e-4f))));
let _e9560 = ((1.2247449f * _e8046) * select(0f, select(0f, _e9555, (_e9555 > 0f)), (_e9544 > 0f)));
let _e9563 = ((_e7931 * _e7931) + (_e9560 * _e9560));
let _e9566 = sqrt(select(0f, _e9563, (_e9563 > 0f)));
phi_15192_ = select(16f, _e9566, (_e9566 < 16f));
} else {
phi_15192_ = _e7931;
}
let _e9570 = phi_15192_;
let _e9571 = (_e9270 - _e9570);
let _e9573 = select(_e8361, _e9571, (_e9571 > _e8361));
let _e9575 = select(_e8362, _e9573, (_e9573 < _e8362));
let _e9582 = select(0i, select(select(i32(_e9575), i32(-2147483648), (_e9575 < -2147483600f)), 2147483647i, (_e9575 > 2147483500f)), (_e9575 == _e9575));
let _e9588 = (_e9270 + _e9570);
let _e9590 = select(-1f, _e9588, (_e9588 > -1f));
let _e9592 = select(_e8382, _e9590, (_e9590 < _e8382));
let _e9599 = select(0i, select(select(i32(_e9592), i32(-2147483648), (_e9592 < -2147483600f)), 2147483647i, (_e9592 > 2147483500f)), (_e9592 == _e9592));
let _e9604 = (_e9271 - _e9570);
let _e9606 = select(_e8361, _e9604, (_e9604 > _e8361));
let _e9608 = select(_e8399, _e9606, (_e9606 < _e8399));
let _e9615 = select(0i, select(select(i32(_e9608), i32(-2147483648), (_e9608 < -2147483600f)), 2147483647i, (_e9608 > 2147483500f)), (_e9608 == _e9608));
let _e9621 = (_e9271 + _e9570);
let _e9623 = select(-1f, _e9621, (_e9621 > -1f));
let _e9625 = select(_e8419, _e9623, (_e9623 < _e8419));
let _e9632 = select(0i, select(select(i32(_e9625), i32(-2147483648), (_e9625 < -2147483600f)), 2147483647i, (_e9625 > 2147483500f)), (_e9625 == _e9625));
phi_15310_ = 0f;
phi_15313_ = vec3<f32>(0f, 0f, 0f);
phi_15315_ = ((_e9615 - select(0i, 1i, (_e9608 < f32(_e9615)))) + 1i);
loop {
let _e9638 = phi_15310_;
let _e9640 = phi_15313_;
let _e9642 = phi_15315_;
local_149 = _e9638;
local_150 = _e9638;
local_151 = _e9640;
local_152 = _e9640;
local_153 = _e9640;
let _e9643 = (_e9642 <= (_e9632 - select(0i, 1i, (_e9625 < f32(_e9632)))));
if _e9643 {
let _e9645 = (f32(_e9642) - _e9271);
let _e9649 = (_e9570 - bitcast<f32>((bitcast<u32>(_e9645) & 2147483647u)));
phi_15330_ = ((_e9582 - select(0i, 1i, (_e9575 < f32(_e9582)))) + 1i);
phi_15333_ = _e9638;
phi_15335_ = _e9640;
loop {
let _e9651 = phi_15330_;
let _e9653 = phi_15333_;
let _e9655 = phi_15335_;
local_160 = _e9653;
local_161 = _e9655;
let _e9656 = (_e9651 <= (_e9599 - select(0i, 1i, (_e9592 < f32(_e9599)))));
if _e9656 {
let _e9658 = (f32(_e9651) - _e9270);
let _e9662 = (_e9570 - bitcast<f32>((bitcast<u32>(_e9658) & 2147483647u)));
let _e9667 = (select(0f, _e9662, (_e9662 > 0f)) * select(0f, _e9649, (_e9649 > 0f)));
if ((((_e9651 >= 0i) && (_e9651 < _e7997)) && (_e9642 >= 0i)) && (_e9642 < _e8003)) {
let _e9678 = (_e9258 + (((_e9642 * _e7997) + _e9651) * _e8443));
let _e9681 = ((_e9658 * _e9658) + (_e9645 * _e9645));
let _e9685 = (sqrt(select(0f, _e9681, (_e9681 > 0f))) - _e7932);
let _e9688 = (1.2247449f * _e8046);
let _e9693 = (_e9269 - select(0f, (select(0f, _e9685, (_e9685 > 0f)) / select(1e-6f, _e9688, (_e9688 > 1e-6f))), _e8047));
let _e9695 = f32(bitcast<i32>(_e8439));
let _e9696 = (_e9695 - 1f);
let _e9698 = select(0f, _e9693, (_e9693 > 0f));
let _e9700 = select(_e9696, _e9698, (_e9698 < _e9696));
let _e9707 = select(0i, select(select(i32(_e9700), i32(-2147483648), (_e9700 < -2147483600f)), 2147483647i, (_e9700 > 2147483500f)), (_e9700 == _e9700));
let _e9711 = (_e9707 - select(0i, 1i, (_e9700 < f32(_e9707))));
let _e9714 = (_e9693 - f32(_e9711));
let _e9717 = select(1f, select(0f, _e9714, (_e9714 > 0f)), (_e9693 < _e9695));
let _e9719 = (2i * _e9711);
let _e9720 = ((4i * _e9678) + _e9719);
let _e9722 = (_e9720 >> bitcast<u32>(2i));
let _e9725 = bitcast<u32>(((_e9720 & 3i) * 8i));
let _e9727 = select(_e8993, _e9722, (_e9722 < _e8993));
let _e9733 = global_6.member[bitcast<u32>(select(0i, _e9727, (_e9727 > 0i)))];
let _e9737 = (_e9722 + 1i);
let _e9739 = select(_e8993, _e9737, (_e9737 < _e8993));
let _e9745 = global_6.member[bitcast<u32>(select(0i, _e9739, (_e9739 > 0i)))];
let _e9752 = ((_e9733 >> bitcast<u32>((_e9725 & 31u))) | ((_e9745 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e9725) & 31u))));
let _e9755 = f32(bitcast<i32>((_e9752 & 65535u)));
let _e9763 = (1f / 65535f);
let _e9765 = (_e9667 * ((_e9755 + ((f32(bitcast<i32>((_e9752 >> bitcast<u32>(16i)))) - _e9755) * _e9717)) * _e9763));
let _e9767 = (_e9655.x + _e9765);
if (_e9263 > 1i) {
let _e9771 = ((4i * (_e9678 + _e8445)) + _e9719);
let _e9773 = (_e9771 >> bitcast<u32>(2i));
let _e9776 = bitcast<u32>(((_e9771 & 3i) * 8i));
let _e9778 = select(_e8993, _e9773, (_e9773 < _e8993));
let _e9784 = global_6.member[bitcast<u32>(select(0i, _e9778, (_e9778 > 0i)))];
let _e9788 = (_e9773 + 1i);
let _e9790 = select(_e8993, _e9788, (_e9788 < _e8993));
let _e9796 = global_6.member[bitcast<u32>(select(0i, _e9790, (_e9790 > 0i)))];
let _e9803 = ((_e9784 >> bitcast<u32>((_e9776 & 31u))) | ((_e9796 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e9776) & 31u))));
let _e9806 = f32(bitcast<i32>((_e9803 & 65535u)));
let _e9821 = ((4i * (_e9678 + (2i * _e8445))) + _e9719);
let _e9823 = (_e9821 >> bitcast<u32>(2i));
let _e9826 = bitcast<u32>(((_e9821 & 3i) * 8i));
let _e9828 = select(_e8993, _e9823, (_e9823 < _e8993));
let _e9834 = global_6.member[bitcast<u32>(select(0i, _e9828, (_e9828 > 0i)))];
let _e9838 = (_e9823 + 1i);
let _e9840 = select(_e8993, _e9838, (_e9838 < _e8993));
let _e9846 = global_6.member[bitcast<u32>(select(0i, _e9840, (_e9840 > 0i)))];
let _e9853 = ((_e9834 >> bitcast<u32>((_e9826 & 31u))) | ((_e9846 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e9826) & 31u))));
let _e9856 = f32(bitcast<i32>((_e9853 & 65535u)));
phi_15724_ = vec3<f32>(_e9767, (_e9655.y + (_e9667 * ((_e9806 + ((f32(bitcast<i32>((_e9803 >> bitcast<u32>(16i)))) - _e9806) * _e9717)) * _e9763))), (_e9655.z + (_e9667 * ((_e9856 + ((f32(bitcast<i32>((_e9853 >> bitcast<u32>(16i)))) - _e9856) * _e9717)) * _e9763))));
} else {
phi_15724_ = vec3<f32>(_e9767, (_e9655.y + _e9765), (_e9655.z + _e9765));
}
let _e9875 = phi_15724_;
phi_15734_ = _e9875;
} else {
phi_15734_ = vec3<f32>((_e9655.x + _e9667), (_e9655.y + _e9667), (_e9655.z + _e9667));
}
let _e9884 = phi_15734_;
phi_15331_ = (_e9651 + 1i);
phi_15334_ = (_e9653 + _e9667);
phi_15336_ = _e9884;
} else {
phi_15331_ = i32();
phi_15334_ = f32();
phi_15336_ = vec3<f32>();
}
let _e9888 = phi_15331_;
let _e9890 = phi_15334_;
let _e9892 = phi_15336_;
continue;
continuing {
phi_15330_ = _e9888;
phi_15333_ = _e9890;
phi_15335_ = _e9892;
break if !(_e9656);
}
}
let _e10593 = local_160;
phi_15311_ = _e10593;
let _e10596 = local_161;
phi_15314_ = _e10596;
phi_15316_ = (_e9642 + 1i);
} else {
phi_15311_ = f32();
phi_15314_ = vec3<f32>();
phi_15316_ = i32();
}
let _e9896 = phi_15311_;
let _e9898 = phi_15314_;
let _e9900 = phi_15316_;
continue;
continuing {
phi_15310_ = _e9896;
phi_15313_ = _e9898;
phi_15315_ = _e9900;
break if !(_e9643);
}
}
let _e9904 = local_149;
let _e9908 = (((_e9263 == 0i) || (_e9904 <= 0f)) || (_e7870 <= 1e-6f));
let _e9910 = local_150;
let _e9912 = (1f / select(_e9910, 1f, _e9908));
let _e9914 = local_151;
let _e9919 = local_152;
let _e9924 = local_153;
phi_15785_ = vec3<f32>(select((((_e9225.x * (_e7456.member * _e9244)) * select((_e9914.x * _e9912), 1f, _e9908)) * _e7846), (_e7820.member_1.x * _e8739), _e7413.member_5), select((((_e9225.y * (_e7456.member_1 * _e9244)) * select((_e9919.y * _e9912), 1f, _e9908)) * _e7846), (_e7820.member_1.y * _e8740), _e7413.member_5), select((((_e9225.z * (_e7456.member_2 * _e9244)) * select((_e9924.z * _e9912), 1f, _e9908)) * _e7846), (_e7820.member_1.z * _e8741), _e7413.member_5));
}
let _e9939 = phi_15785_;
let _e9945 = (((_e1312.member * _e7449) + (_e1312.member_1 * _e7450)) + (_e1312.member_2 * _e7451));
let _e9950 = (((_e1324.member * _e7449) + (_e1324.member_1 * _e7450)) + (_e1324.member_2 * _e7451));
let _e9955 = (((_e1336.member * _e7449) + (_e1336.member_1 * _e7450)) + (_e1336.member_2 * _e7451));
let _e9959 = global_1.member.member_20.member_1;
let _e9969 = global_1.member.member_20.member_2;
let _e9982 = global_1.member.member_20.member_3;
let _e9995 = global_1.member.member_20.member_4;
let _e9999 = (_e9945 * _e9945);
let _e10006 = global_1.member.member_20.member_5;
let _e10010 = (_e9950 * _e9950);
let _e10020 = global_1.member.member_20.member_6;
let _e10024 = (_e9955 * _e9955);
let _e10034 = global_1.member.member_20.member_7;
let _e10038 = (_e9945 * _e9950);
let _e10045 = global_1.member.member_20.member_8;
let _e10049 = (_e9945 * _e9955);
let _e10059 = global_1.member.member_20.member_9;
let _e10063 = (_e9950 * _e9955);
let _e10073 = global_1.member.member_20.member;
let _e10083 = ((_e10073.member + (((_e9959.member * _e9945) + (_e9969.member * _e9950)) + (_e9982.member * _e9955))) + ((((_e9995.member * _e9999) + (_e10006.member * _e10010)) + (_e10020.member * _e10024)) + (((_e10034.member * _e10038) + (_e10045.member * _e10049)) + (_e10059.member * _e10063))));
let _e10084 = ((_e10073.member_1 + (((_e9959.member_1 * _e9945) + (_e9969.member_1 * _e9950)) + (_e9982.member_1 * _e9955))) + ((((_e9995.member_1 * _e9999) + (_e10006.member_1 * _e10010)) + (_e10020.member_1 * _e10024)) + (((_e10034.member_1 * _e10038) + (_e10045.member_1 * _e10049)) + (_e10059.member_1 * _e10063))));
let _e10085 = ((_e10073.member_2 + (((_e9959.member_2 * _e9945) + (_e9969.member_2 * _e9950)) + (_e9982.member_2 * _e9955))) + ((((_e9995.member_2 * _e9999) + (_e10006.member_2 * _e10010)) + (_e10020.member_2 * _e10024)) + (((_e10034.member_2 * _e10038) + (_e10045.member_2 * _e10049)) + (_e10059.member_2 * _e10063))));
phi_15952_ = (_e7413.member_3 * vec3<f32>((_e9939.x + select(0f, _e10083, (_e10083 > 0f))), (_e9939.y + select(0f, _e10084, (_e10084 > 0f))), (_e9939.z + select(0f, _e10085, (_e10085 > 0f)))));
} else {
phi_15952_ = _e6876;
}
let _e10101 = phi_15952_;
phi_15953_ = _e10101;
} else {
phi_15953_ = _e6876;
}
let _e10103 = phi_15953_;
let _e10111 = ((_e283 > 0f) || _e297);
let _e10115 = global_1.member.member_16.member_12;
let _e10116 = select(_e10115, 1f, _e10111);
let _e10125 = global_1.member.member_11;
let _e10126 = local_49;
let _e10128 = local_48;
let _e10129 = ((20i * _e10126) + _e10128);
let _e10131 = select(_e209, _e10129, (_e10129 < _e209));
let _e10136 = global_2.member[bitcast<u32>(select(0i, _e10131, (_e10131 > 0i)))];
let _e10160 = local_49;
let _e10162 = local_48;
let _e10163 = ((19i * _e10160) + _e10162);
let _e10165 = select(_e209, _e10163, (_e10163 < _e209));
let _e10170 = global_2.member[bitcast<u32>(select(0i, _e10165, (_e10165 > 0i)))];
global_8.member[_e186] = ((((_e5592.x * _e5647) + (_e5604 * _e5629.member)) + (_e10103.x * _e5731)) * _e10116);
global_8.member[(_e184 + _e186)] = ((((_e5592.y * _e5658) + (_e5615 * _e5629.member_1)) + (_e10103.y * _e5731)) * _e10116);
global_8.member[((2u * _e184) + _e186)] = ((((_e5592.z * _e5669) + (_e5626 * _e5629.member_2)) + (_e10103.z * _e5731)) * _e10116);
global_8.member[((3u * _e184) + _e186)] = _e10116;
global_8.member[((4u * _e184) + _e186)] = (((_e445.member * _e5716) + (_e445.member_1 * _e5718)) + (_e445.member_2 * _e5720));
global_8.member[((5u * _e184) + _e186)] = (((_e454.member * _e5716) + (_e454.member_1 * _e5718)) + (_e454.member_2 * _e5720));
global_8.member[((6u * _e184) + _e186)] = -((((_e472.member * _e5716) + (_e472.member_1 * _e5718)) + (_e472.member_2 * _e5720)));
global_8.member[((7u * _e184) + _e186)] = _e283;
global_8.member[((8u * _e184) + _e186)] = (_e10170 * _e10125);
global_8.member[((9u * _e184) + _e186)] = select(0f, ((_e10136 * _e10125) * (((_e472.member * _e1171) + (_e472.member_1 * _e1172)) + (_e472.member_2 * _e1173))), _e10111);
global_8.member[((10u * _e184) + _e186)] = (((_e445.member * _e216) + (_e445.member_1 * _e227)) + (_e445.member_2 * _e238));
global_8.member[((11u * _e184) + _e186)] = (((_e454.member * _e216) + (_e454.member_1 * _e227)) + (_e454.member_2 * _e238));
global_8.member[((12u * _e184) + _e186)] = -((((_e472.member * _e216) + (_e472.member_1 * _e227)) + (_e472.member_2 * _e238)));
global_8.member[((13u * _e184) + _e186)] = _e250;
global_8.member[((14u * _e184) + _e186)] = _e261;
global_8.member[((15u * _e184) + _e186)] = _e272;
global_8.member[((16u * _e184) + _e186)] = _e5731;
global_8.member[((17u * _e184) + _e186)] = select(_e294, 2f, ((_e294 == 0f) || (_e294 == 4f)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
